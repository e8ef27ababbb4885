//! A convex polygon, in either winding, with sharp or rounded vertices.

use glam::DVec2;

use super::convex::convex_core;
use super::{
    Field, FieldType, FieldValue, Hull, Kind, Shape, ShapeError, optional_radius, points_value, value,
};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "polygon",
    about: "a convex polygon, either winding; duplicate and collinear corners may be there",
    in_words: "a convex polygon",
    fields: &[
        Field { name: "vertices", holds: FieldType::Points, required: true, about: "three corners or more" },
        Field {
            name: "radius",
            holds: FieldType::Number,
            required: false,
            about: "radius of the disc that sweeps the core, world units; 0",
        },
    ],
    build,
    turns: true,
};

impl Shape {
    /// A convex polygon with these corners, in either winding, in its body's frame and world units.
    ///
    /// # Errors
    /// A [`ShapeError`] as of a scene file: fewer than three corners, not convex, not finite.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Shape};
    /// let triangle = Shape::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::Y])?;
    /// assert_eq!(triangle.core.len(), 3);
    /// assert_eq!(Shape::polygon(vec![DVec2::ZERO, DVec2::X]).unwrap_err().code, "too-few-corners");
    /// # Ok::<(), tracefig::geometry::shape::ShapeError>(())
    /// ```
    pub fn polygon(vertices: Vec<DVec2>) -> Result<Self, ShapeError> {
        build(&[Some(FieldValue::Points(vertices)), None])
    }
}

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let vertices = points_value("vertices", value(values, 0))?;
    let radius = optional_radius(value(values, 1))?;
    let core = convex_core(&vertices)?;
    let hull = Hull::new(core.iter().map(|&i| vertices[i]).collect());
    Ok(Shape { kind: "polygon", vertices, radius, half_extents: None, core, hull })
}
