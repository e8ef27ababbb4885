//! A capsule: a segment swept by a disc. Radius 0 is a segment; two equal points are a circle.

use super::{
    Field, FieldType, FieldValue, Hull, Kind, Shape, ShapeError, VertexKey, points_value, radius_value, value,
};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "capsule",
    about: "a segment with a radius; with radius 0 a segment",
    in_words: ["a capsule", "eine Kapsel", "une capsule", "una cápsula"],
    fields: &[
        Field {
            name: "points",
            holds: FieldType::Points { min: 2 },
            required: true,
            about: "the two ends of the segment",
        },
        Field {
            name: "radius",
            holds: FieldType::Length,
            required: true,
            about: "radius, world units, 0 or more",
        },
    ],
    build,
    turns: true,
    vertices: VertexKey::Each("points"),
};

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let points = points_value("points", value(values, 0))?;
    let radius = radius_value(value(values, 1))?;
    if points.len() != 2 {
        let message = format!("expected two points, got {}", points.len());
        return Err(ShapeError::new("wrong-count", "points", message));
    }
    if points[0] == points[1] {
        let hull = Hull::new(vec![points[0]]);
        return Ok(Shape { radius, core: vec![0], hull, ..Shape::bare("capsule", points) });
    }
    Ok(Shape::convex("capsule", points, radius))
}
