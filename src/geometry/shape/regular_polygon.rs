//! A regular polygon: vertices evenly around a circle, the lowest edge level, as a stranger draws a hexagon.
//!
//! ```text
//! vertex k = R (sin φ, −cos φ)      φ = (2k − 1) · 180°/n from straight down, counter-clockwise
//! ```
//!
//! So edge 0 is the lowest, from left to right, and vertex 0 its left end, as of a box. Most of these numbers
//! are no doubles: each coordinate is the double nearest to it (sines and products to twice the precision,
//! rounded once), so that what mirrors does so exactly, and halves are halves. What is certified is so of the
//! polygon of these doubles.

use glam::DVec2;

use super::convex::convex_core;
use super::{
    Field, FieldType, FieldValue, Hull, Kind, SWEEPING_RADIUS, Shape, ShapeError, VertexKey, finite,
    optional_radius, unusable, value,
};
use crate::geometry::{Turn, taming_power};

/// The most edges: as many as a polygon of a scene may have vertices.
const MOST: usize = 4096;

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "regular-polygon",
    about: "its lowest edge is level; vertices are numbered counter-clockwise from the left end of that",
    in_words: [
        "a regular polygon",
        "ein regelmäßiges Vieleck",
        "un polygone régulier",
        "un polígono regular",
    ],
    fields: &[
        Field {
            name: "edges",
            holds: FieldType::Count { min: 3, max: MOST },
            required: true,
            about: "how many edges, which is how many vertices",
        },
        Field {
            name: "circumradius",
            holds: FieldType::Length,
            required: true,
            about: "from the middle to each vertex, world units, more than 0",
        },
        SWEEPING_RADIUS,
    ],
    build,
    turns: true,
    vertices: VertexKey::None,
};

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let count = edges_value(value(values, 0))?;
    let circumradius = circumradius_value(value(values, 1))?;
    let radius = optional_radius(value(values, 2))?;
    let vertices: Vec<DVec2> = (0..count).map(|k| vertex(k, count, circumradius)).collect();
    let core = convex_core(&vertices).ok().filter(|core| core.len() == vertices.len());
    let core = core.ok_or_else(|| {
        let message = format!("expected a circle on which {count} vertices lie apart, got {circumradius:e}");
        ShapeError::new("degenerate", "circumradius", message)
    })?;
    let hull = Hull::new(core.iter().map(|&i| vertices[i]).collect());
    Ok(Shape {
        radius,
        core,
        hull,
        circumradius: Some(circumradius),
        ..Shape::bare("regular-polygon", vertices)
    })
}

/// How many edges: from 3 to [`MOST`].
fn edges_value(found: Option<&FieldValue>) -> Result<u16, ShapeError> {
    let Some(&FieldValue::Count(count)) = found else {
        return Err(unusable("edges", found, "a whole number"));
    };
    let code = if count < 3 { "too-few-corners" } else { "wrong-count" };
    let fits = u16::try_from(count).ok().filter(|_| (3..=MOST).contains(&count));
    fits.ok_or_else(|| ShapeError::new(code, "edges", format!("expected 3 to {MOST} edges, got {count}")))
}

/// The distance of the vertices from the middle: finite and above 0.
fn circumradius_value(found: Option<&FieldValue>) -> Result<f64, ShapeError> {
    let Some(FieldValue::Number(size)) = found else {
        return Err(unusable("circumradius", found, "a number"));
    };
    let size = finite("circumradius", None, *size)?;
    if size > 0.0 {
        return Ok(size);
    }
    let code = if size < 0.0 { "negative-radius" } else { "degenerate" };
    Err(ShapeError::new(code, "circumradius", format!("expected more than 0, got {size}")))
}

/// Vertex k of n on the circle of a radius.
fn vertex(k: u16, n: u16, radius: f64) -> DVec2 {
    let around = Turn::ratio(180 * (2 * i64::from(k) - 1), i64::from(n)).rotation_in_balls();
    let power = taming_power(radius);
    let times = |x: crate::geometry::Ball| x.value.scale(radius * power).to_f64() / power;
    // −0 is 0.
    DVec2::new(times(around.sin) + 0.0, 0.0 - times(around.cos))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tracefig_reference::scene::Scene;

    fn regular(edges: usize, circumradius: f64) -> Result<Shape, ShapeError> {
        let fields =
            [("edges", FieldValue::Count(edges)), ("circumradius", FieldValue::Number(circumradius))];
        Shape::of_kind(KIND.name, &fields)
    }

    #[test]
    fn every_coordinate_is_the_double_nearest_to_the_exact_one() {
        for n in (3..=48).chain([360, 999, 4096]) {
            for radius in [1.0, 0.1, 1.7, 3e-300, 7e299] {
                let line = format!(
                    "{{\"shapes\": {{\"A\": {{\"kind\": \"regular-polygon\", \"edges\": {n}, \
                     \"circumradius\": {radius:e}}}}}, \"query\": {{\"kind\": \"bounds\", \"of\": \"A\"}}}}"
                );
                let exact = &Scene::parse(&line).unwrap().bodies[0].vertices;
                let ours = regular(n, radius).unwrap().vertices;
                assert_eq!(ours.len(), n);
                for (k, (p, q)) in ours.iter().zip(exact).enumerate() {
                    assert_eq!([p.x, p.y], *q, "vertex {k} of {n}, {radius:e}");
                }
            }
        }
    }

    #[test]
    fn the_lowest_edge_is_level_and_a_mirror_image_is_exact() {
        for n in 3..=40 {
            let v = regular(n, 1.3).unwrap().vertices;
            assert!(v[0].x < 0.0 && v[0].y == v[1].y && v.iter().all(|p| p.y >= v[0].y), "{n}");
            for k in 0..n {
                let image = v[(n + 1 - k) % n];
                assert_eq!(v[k], DVec2::new(-image.x, image.y), "{k} of {n}");
            }
        }
        let hexagon = regular(6, 2.0).unwrap().vertices;
        assert_eq!((hexagon[0].x, hexagon[2]), (-1.0, DVec2::new(2.0, 0.0)));
    }

    #[test]
    fn a_square_is_the_box_of_the_same_size() {
        let square = regular(4, 2.0_f64.sqrt()).unwrap();
        let half = FieldValue::Point(DVec2::ONE);
        let same = Shape::of_kind("box", &[("half_extents", half)]).unwrap();
        assert_eq!(square.core, same.core);
        assert!(
            square.vertices.iter().zip(&same.vertices).all(|(p, q)| p.distance(*q) <= 2.0 * f64::EPSILON)
        );
    }

    #[test]
    fn what_is_no_regular_polygon_is_refused() {
        let code = |n, radius| regular(n, radius).unwrap_err().code;
        assert_eq!([code(2, 1.0), code(4097, 1.0)], ["too-few-corners", "wrong-count"]);
        assert_eq!(
            [code(5, 0.0), code(5, -1.0), code(5, f64::NAN)],
            ["degenerate", "negative-radius", "not-finite"]
        );
        // Denormals are too coarse for a circle.
        let error = regular(100, 5e-324).unwrap_err();
        assert_eq!((error.code, error.field), ("degenerate", "circumradius"));
    }
}
