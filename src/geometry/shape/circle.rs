//! A circle: one core vertex and a radius. Radius 0 is a point.

use glam::DVec2;

use super::{
    Field, FieldType, FieldValue, Kind, Shape, ShapeError, VertexKey, finite_point, radius_value, unusable,
    value,
};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "circle",
    about: "a disc, or with radius 0 a point",
    in_words: ["a circle", "ein Kreis", "un cercle", "un círculo"],
    fields: &[
        Field {
            name: "radius",
            holds: FieldType::Length,
            required: true,
            about: "radius, world units, 0 or more",
        },
        Field {
            name: "center",
            holds: FieldType::Point,
            required: false,
            about: "centre in the body's frame; [0, 0]",
        },
    ],
    build,
    turns: true,
    vertices: VertexKey::None,
};

impl Shape {
    /// A circle around its body's origin, of a radius in world units; 0 is a point.
    ///
    /// # Errors
    /// A [`ShapeError`] where the radius is below 0, beyond 1e300 or no number.
    ///
    /// ```
    /// use tracefig::geometry::Shape;
    /// assert_eq!(Shape::circle(2.0)?.radius, 2.0);
    /// assert_eq!(Shape::circle(-1.0).unwrap_err().code, "negative-radius");
    /// # Ok::<(), tracefig::geometry::shape::ShapeError>(())
    /// ```
    pub fn circle(radius: f64) -> Result<Self, ShapeError> {
        build(&[Some(FieldValue::Number(radius)), None])
    }
}

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let radius = radius_value(value(values, 0))?;
    let center = match value(values, 1) {
        None => DVec2::ZERO,
        Some(FieldValue::Point(center)) => finite_point("center", None, *center)?,
        other => return Err(unusable("center", other, "a pair of numbers")),
    };
    Ok(Shape::convex("circle", vec![center], radius))
}
