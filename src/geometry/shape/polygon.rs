//! A convex polygon, in either winding, with sharp or rounded vertices.

use glam::DVec2;

use super::convex::{convex_core, hull_core};
use super::{
    Edges, Field, FieldType, FieldValue, Hull, Kind, SWEEPING_RADIUS, Shape, ShapeError, VertexKey,
    optional_radius, points_value, switch_value, value,
};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "polygon",
    about: "a convex polygon, either winding; duplicate and collinear vertices may be there",
    in_words: ["a convex polygon", "ein konvexes Vieleck", "un polygone convexe", "un polígono convexo"],
    fields: &[
        Field {
            name: "vertices",
            holds: FieldType::Points { min: 3 },
            required: true,
            about: "three vertices or more",
        },
        SWEEPING_RADIUS,
        Field {
            name: "hull",
            holds: FieldType::Switch,
            required: false,
            about: "true: the convex hull of the vertices, which need not be convex nor in order; false",
        },
    ],
    build,
    turns: true,
    vertices: VertexKey::Each("vertices"),
};

impl Shape {
    /// A convex polygon with these vertices, in either winding, in its body's frame and world units.
    ///
    /// # Errors
    /// A [`ShapeError`] as of a scene file: fewer than three vertices, not convex, not finite.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Shape};
    /// let triangle = Shape::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::Y])?;
    /// assert_eq!(triangle.core.len(), 3);
    /// assert_eq!(Shape::polygon(vec![DVec2::ZERO, DVec2::X]).unwrap_err().code, "too-few-corners");
    /// # Ok::<(), tracefig::geometry::shape::ShapeError>(())
    /// ```
    pub fn polygon(vertices: Vec<DVec2>) -> Result<Self, ShapeError> {
        build(&[Some(FieldValue::Points(vertices)), None, None])
    }
}

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let vertices = points_value("vertices", value(values, 0))?;
    let radius = optional_radius(value(values, 1))?;
    let (core, edges) = if switch_value("hull", value(values, 2))? {
        (hull_core(&vertices)?, Edges::OfHull)
    } else {
        (convex_core(&vertices)?, Edges::OfFile)
    };
    let hull = Hull::new(core.iter().map(|&i| vertices[i]).collect());
    Ok(Shape { radius, core, hull, edges, ..Shape::bare("polygon", vertices) })
}
