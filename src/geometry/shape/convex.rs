//! Whether a list of vertices is a convex polygon, decided exactly, and which of its vertices count.
//!
//! Walking round, every turn must go the same way (the sign of `orient2d`, exact: Shewchuk, *Adaptive
//! Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*, 1997), and the walk must go
//! round only once: its steps change their direction along x, then y, just twice. Without the second test a
//! pentagram would pass. Which way is right is told by the lowest of the leftmost vertices, which no dent can
//! be.
//!
//! Where the hull of the vertices is asked for instead, it is found by the same predicate (Andrew, *Another
//! Efficient Algorithm for Convex Hulls in Two Dimensions*, 1979).

use std::fmt::Write as _;

use glam::DVec2;
use robust::{Coord, orient2d};

use super::ShapeError;
use crate::geometry::sorted;
use crate::geometry::taming_power;

/// Indices of the strictly convex vertices, counter-clockwise, starting from the first of them in the file.
pub(super) fn convex_core(vertices: &[DVec2]) -> Result<Vec<usize>, ShapeError> {
    let scale = tamer(vertices);
    let mut distinct: Vec<usize> = Vec::with_capacity(vertices.len());
    for i in 0..vertices.len() {
        if distinct.last().is_none_or(|&last| vertices[last] != vertices[i]) {
            distinct.push(i);
        }
    }
    while distinct.len() > 1 && vertices[distinct[0]] == vertices[distinct[distinct.len() - 1]] {
        distinct.pop();
    }
    enough(distinct.len())?;
    let around = |k: usize| neighbours(vertices, &distinct, k);
    let turn = |k: usize| {
        let [p, q, r] = around(k).map(|v| v * scale);
        orientation(p, q, r)
    };
    let turns: Vec<f64> = (0..distinct.len()).map(turn).collect();
    if turns.iter().all(|&t| t == 0.0) {
        return Err(on_one_line());
    }
    let winding = winding(vertices, &distinct, &turns);
    for (k, &t) in turns.iter().enumerate() {
        if t * winding < 0.0 {
            return Err(not_convex(distinct[k], Some(around(k))));
        }
        if t == 0.0 && goes_back(around(k)) {
            return Err(not_convex(distinct[k], None));
        }
    }
    if reversals(vertices, &distinct) != 2 {
        return Err(not_convex(distinct[0], None));
    }
    let mut core: Vec<usize> =
        distinct.iter().zip(&turns).filter(|(_, t)| **t != 0.0).map(|(&i, _)| i).collect();
    if winding < 0.0 {
        core.reverse();
    }
    Ok(core)
}

/// Indices of the vertices of the convex hull, counter-clockwise, starting from the first of them in the
/// file; of equal vertices the first, none on an edge.
pub(super) fn hull_core(vertices: &[DVec2]) -> Result<Vec<usize>, ShapeError> {
    let scale = tamer(vertices);
    // −0 is 0 here.
    let key = |i: usize| vertices[i] + DVec2::ZERO;
    let mut order = sorted(vertices.len(), &|i, j| {
        let (p, q) = (key(i), key(j));
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(i.cmp(&j))
    });
    order.dedup_by(|i, j| vertices[*i] == vertices[*j]);
    enough(order.len())?;
    let mut core: Vec<usize> = Vec::with_capacity(order.len());
    // Below from left to right, then above from right to left; each chain's last vertex is the other's first.
    for forward in [true, false] {
        let start = core.len();
        for k in 0..order.len() {
            let i = order[if forward { k } else { order.len() - 1 - k }];
            while let [.., p, q] = core[start..]
                && orientation(vertices[p] * scale, vertices[q] * scale, vertices[i] * scale) <= 0.0
            {
                core.pop();
            }
            core.push(i);
        }
        core.pop();
    }
    if core.len() < 3 {
        return Err(on_one_line());
    }
    let first = core.iter().enumerate().min_by_key(|(_, i)| **i).map_or(0, |(k, _)| k);
    core.rotate_left(first);
    Ok(core)
}

/// Whether so many distinct vertices may span an area.
fn enough(distinct: usize) -> Result<(), ShapeError> {
    if distinct >= 3 {
        return Ok(());
    }
    let message = format!("expected three distinct vertices or more, got {distinct}");
    Err(ShapeError::new("too-few-corners", "vertices", message))
}

/// The error of vertices that span no area.
fn on_one_line() -> ShapeError {
    let message = "expected vertices that span an area, got vertices on one line".to_owned();
    ShapeError::new("degenerate", "vertices", message)
}

/// The vertex before one, it, and the vertex after it.
fn neighbours(vertices: &[DVec2], distinct: &[usize], k: usize) -> [DVec2; 3] {
    let count = distinct.len();
    [(k + count - 1) % count, k, (k + 1) % count].map(|k| vertices[distinct[k]])
}

/// Positive where the vertices run counter-clockwise: the turn at the lowest of the leftmost ones, or, where
/// the walk comes back on its own line there, the first turn.
fn winding(vertices: &[DVec2], distinct: &[usize], turns: &[f64]) -> f64 {
    let place = |k: usize| vertices[distinct[k]];
    let outermost = (0..distinct.len())
        .min_by(|&k, &l| place(k).x.total_cmp(&place(l).x).then(place(k).y.total_cmp(&place(l).y)));
    let turn = outermost.map(|k| turns[k]).filter(|&turn| turn != 0.0);
    turn.or(turns.iter().copied().find(|&turn| turn != 0.0)).map_or(1.0, f64::signum)
}

/// The share of a polygon's size below which a dent may be what computing in single precision left.
const ROUNDING: f64 = 1e-5;

/// The error of a vertex at which the polygon is not convex: that of a dent says how deep it is.
fn not_convex(vertex: usize, dent: Option<[DVec2; 3]>) -> ShapeError {
    let mut message = format!("expected a convex polygon, got one that is not at vertex {vertex}");
    if let Some(around) = dent {
        let (depth, size) = depth(around);
        let _ = write!(message, ", which lies {depth:.1e} inside the line of its neighbours");
        // Of a plain dent nobody asks how much more than rounding it is.
        if depth < ROUNDING * size {
            let _ = write!(message, " ({:.1e} ε of the size)", depth / (size * f64::EPSILON));
        }
    }
    message.push_str("; with `hull = true` the polygon is the convex hull of its vertices");
    ShapeError::at("not-convex", "vertices", vertex, message)
}

/// How far the middle one of three points is off the line of the others, in their units, and the largest
/// coordinate.
fn depth([p, q, r]: [DVec2; 3]) -> (f64, f64) {
    let size = [p, q, r].iter().fold(0.0, |size: f64, v| size.max(v.x.abs()).max(v.y.abs()));
    let scale = taming_power(size);
    let [p, q, r] = [p, q, r].map(|v| v * scale);
    let along = (r - p).length();
    let depth = if along > 0.0 { orientation(p, q, r).abs() / along } else { (q - p).length() };
    (depth / scale, size)
}

/// A power of two that brings the vertices near 1, so that the exact predicate neither overflows nor
/// underflows.
pub(super) fn tamer(vertices: &[DVec2]) -> f64 {
    let largest = vertices.iter().fold(0.0, |m: f64, v| m.max(v.x.abs()).max(v.y.abs()));
    if (1e-100..1e100).contains(&largest) { 1.0 } else { taming_power(largest) }
}

/// Positive where p, q, r turn counter-clockwise; the sign is exact.
pub(super) fn orientation(p: DVec2, q: DVec2, r: DVec2) -> f64 {
    let coord = |v: DVec2| Coord { x: v.x, y: v.y };
    orient2d(coord(p), coord(q), coord(r))
}

/// Whether the walk comes back on its own line at the middle one of three collinear vertices.
fn goes_back([p, q, r]: [DVec2; 3]) -> bool {
    let between = |a: f64, b: f64, c: f64| (a <= b && b <= c) || (a >= b && b >= c);
    !(between(p.x, q.x, r.x) && between(p.y, q.y, r.y))
}

/// How often the steps round change between going up the (x, then y) order and going down it.
fn reversals(vertices: &[DVec2], distinct: &[usize]) -> usize {
    let count = distinct.len();
    let rises = |k: usize| {
        let (p, q) = (vertices[distinct[k % count]], vertices[distinct[(k + 1) % count]]);
        (p.x, p.y) < (q.x, q.y)
    };
    (0..count).filter(|&k| rises(k) != rises(k + 1)).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::shape::FieldValue;
    use crate::geometry::{Feature, Shape};
    use tracefig_reference::placement::convex_core as exact_hull;
    use tracefig_reference::random::Random;

    fn polygon(points: &[[f64; 2]], hull: bool) -> Result<Shape, ShapeError> {
        let points = points.iter().copied().map(DVec2::from).collect();
        let fields = [("vertices", FieldValue::Points(points)), ("hull", FieldValue::Switch(hull))];
        Shape::of_kind("polygon", &fields)
    }

    #[test]
    fn a_dent_says_how_deep_it_is_and_names_the_way_out() {
        // Vertex 0 itself is the dent: the other turns must not be taken for wrong.
        let dented = [[1.0, 1e-9], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]];
        let error = polygon(&dented, false).unwrap_err();
        assert_eq!((error.code, error.element), ("not-convex", Some(0)));
        assert!(error.message.contains("vertex 0, which lies 1.0e-9 inside the line"), "{}", error.message);
        assert!(error.message.contains("(2.3e6 ε of the size)"), "{}", error.message);
        assert!(error.message.contains("`hull = true`"), "{}", error.message);
        assert_eq!(polygon(&dented, true).unwrap().core, [1, 2, 3, 4]);
    }

    #[test]
    fn the_depth_of_a_dent_has_the_units_of_the_file() {
        for scale in [1e-200, 1.0, 1e250] {
            let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 2.5], [0.0, 3.0]];
            let error = polygon(&points.map(|p| p.map(|x| x * scale)), false).unwrap_err();
            let depth = format!("which lies {:.1e} inside", 0.5 * scale);
            assert!(error.message.contains(&depth), "{}", error.message);
        }
    }

    #[test]
    fn hulls_are_those_of_exact_arithmetic() {
        let mut random = Random::new(8);
        for round in 0..2_000 {
            let count = 3 + random.below(9);
            let lattice = random.once_in(2);
            let points: Vec<[f64; 2]> = (0..count)
                .map(|_| {
                    [0, 1].map(|_| {
                        let x = random.between(-3.0, 3.0);
                        if lattice { x.round() * 1.1 } else { x }
                    })
                })
                .collect();
            let exact = exact_hull(&points);
            match polygon(&points, true) {
                Ok(shape) => {
                    let first = exact.iter().position(|&i| i == shape.core[0]).unwrap();
                    let turned: Vec<usize> =
                        (0..exact.len()).map(|k| exact[(first + k) % exact.len()]).collect();
                    assert_eq!(shape.core, turned, "{round}: {points:?}");
                }
                Err(error) => assert!(exact.len() < 3, "{round}: {error:?} {points:?}"),
            }
        }
    }

    #[test]
    fn edges_of_a_hull_are_numbered_by_the_vertex_they_start_at() {
        let mut points = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.5], [2.0, 2.0], [0.0, 2.0]];
        let right = |shape: &Shape| shape.hull.normals.iter().position(|n| n.x == 1.0).unwrap();
        let shape = polygon(&points, true).unwrap();
        assert_eq!(shape.edge_feature(right(&shape), DVec2::new(2.0, 1.0)), Feature::Edge(1));
        assert_eq!((shape.edge_ends(1), shape.edge_ends(2)), (Some([1, 3]), None));
        points.reverse();
        let shape = polygon(&points, true).unwrap();
        assert_eq!(shape.edge_feature(right(&shape), DVec2::new(2.0, 1.0)), Feature::Edge(1));
        assert_eq!(shape.edge_ends(1), Some([1, 3]));
    }

    #[test]
    fn a_hull_needs_three_vertices_that_span_an_area() {
        let code = |points: &[[f64; 2]]| polygon(points, true).unwrap_err().code;
        assert_eq!(code(&[[0.0, 0.0], [1.0, 0.0], [-0.0, 0.0]]), "too-few-corners");
        assert_eq!(code(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), "degenerate");
    }
}
