//! A box whose sides stay parallel to the axes: the article's AABB.

use super::{
    Field, FieldType, FieldValue, Kind, Shape, ShapeError, VertexKey, box_of, half_extents_value, value,
};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "aabb",
    about: "a box with sides parallel to the axes; it does not turn",
    in_words: [
        "an axis-aligned box",
        "ein achsenparalleles Rechteck",
        "un rectangle aligné sur les axes",
        "un rectángulo alineado con los ejes",
    ],
    fields: &[Field {
        name: "half_extents",
        holds: FieldType::Extents,
        required: true,
        about: "half the width and height, world units, more than 0",
    }],
    build,
    turns: false,
    vertices: VertexKey::Half("half_extents"),
};

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    Ok(box_of("aabb", half_extents_value(value(values, 0))?, 0.0))
}
