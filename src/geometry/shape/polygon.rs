//! A convex polygon, in either winding, with sharp or rounded vertices.

use super::convex::convex_core;
use super::{
    Field, FieldType, FieldValue, Hull, Kind, Shape, ShapeError, optional_radius, points_value, value,
};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "polygon",
    about: "a convex polygon, either winding; duplicate and collinear corners may be there",
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

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let vertices = points_value("vertices", value(values, 0))?;
    let radius = optional_radius(value(values, 1))?;
    let core = convex_core(&vertices)?;
    let hull = Hull::new(core.iter().map(|&i| vertices[i]).collect());
    Ok(Shape { kind: "polygon", vertices, radius, half_extents: None, core, hull })
}
