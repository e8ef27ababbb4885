//! A box that may be turned, with sharp or rounded vertices.

use glam::DVec2;

use super::{
    Field, FieldType, FieldValue, Kind, SWEEPING_RADIUS, Shape, ShapeError, VertexKey, box_of,
    half_extents_value, optional_radius, value,
};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "box",
    about: "a box that may be turned; vertices are numbered counter-clockwise from (−, −)",
    in_words: ["a box", "ein Rechteck", "un rectangle", "un rectángulo"],
    fields: &[
        Field {
            name: "half_extents",
            holds: FieldType::Extents,
            required: true,
            about: "half the width and height of the core, world units, more than 0",
        },
        SWEEPING_RADIUS,
    ],
    build,
    turns: true,
    vertices: VertexKey::Half("half_extents"),
};

impl Shape {
    /// A box around its body's origin, by its half-extents in world units.
    ///
    /// # Errors
    /// A [`ShapeError`] where one is 0 or less, beyond 1e300 or no number.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Shape};
    /// let plank = Shape::rectangle(DVec2::new(2.0, 0.25))?;
    /// assert_eq!((plank.kind, plank.vertices[0]), ("box", DVec2::new(-2.0, -0.25)));
    /// assert_eq!(Shape::rectangle(DVec2::X).unwrap_err().code, "degenerate");
    /// # Ok::<(), tracefig::geometry::shape::ShapeError>(())
    /// ```
    pub fn rectangle(half_extents: DVec2) -> Result<Self, ShapeError> {
        build(&[Some(FieldValue::Point(half_extents)), None])
    }
}

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let h = half_extents_value(value(values, 0))?;
    Ok(box_of("box", h, optional_radius(value(values, 1))?))
}
