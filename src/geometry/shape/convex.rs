//! Whether a list of vertices is a convex polygon, decided exactly, and which of its vertices count.
//!
//! Walking round, every turn must go the same way (the sign of `orient2d`, exact: Shewchuk, *Adaptive
//! Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*, 1997), and the walk must go
//! round only once: its steps change their direction along x, then y, just twice. Without the second test a
//! pentagram would pass.

use glam::DVec2;
use robust::{Coord, orient2d};

use super::ShapeError;
use crate::geometry::taming_power;

/// Indices of the strictly convex vertices, counter-clockwise, starting from the first of them in the file.
pub(super) fn convex_core(vertices: &[DVec2]) -> Result<Vec<usize>, ShapeError> {
    let scale = tamer(vertices);
    let point = |i: usize| vertices[i] * scale;
    let mut distinct: Vec<usize> = Vec::with_capacity(vertices.len());
    for i in 0..vertices.len() {
        if distinct.last().is_none_or(|&last| vertices[last] != vertices[i]) {
            distinct.push(i);
        }
    }
    while distinct.len() > 1 && vertices[distinct[0]] == vertices[distinct[distinct.len() - 1]] {
        distinct.pop();
    }
    if distinct.len() < 3 {
        let message = format!("expected three distinct corners or more, got {}", distinct.len());
        return Err(ShapeError::new("too-few-corners", "vertices", message));
    }
    let count = distinct.len();
    let turn = |k: usize| {
        let (p, q, r) = (distinct[(k + count - 1) % count], distinct[k], distinct[(k + 1) % count]);
        orientation(point(p), point(q), point(r))
    };
    let turns: Vec<f64> = (0..count).map(turn).collect();
    if turns.iter().all(|&t| t == 0.0) {
        let message = "expected corners that span an area, got corners on one line".to_owned();
        return Err(ShapeError::new("degenerate", "vertices", message));
    }
    let winding = turns.iter().find(|t| **t != 0.0).map_or(1.0, |t| t.signum());
    for (k, &t) in turns.iter().enumerate() {
        let back = t == 0.0 && goes_back(vertices, &distinct, k);
        if t * winding < 0.0 || back {
            return Err(not_convex(distinct[k]));
        }
    }
    if reversals(vertices, &distinct) != 2 {
        return Err(not_convex(distinct[0]));
    }
    let mut core: Vec<usize> =
        distinct.iter().zip(&turns).filter(|(_, t)| **t != 0.0).map(|(&i, _)| i).collect();
    if winding < 0.0 {
        core.reverse();
    }
    Ok(core)
}

/// The error of a vertex at which the polygon is not convex.
fn not_convex(vertex: usize) -> ShapeError {
    ShapeError::at(
        "not-convex",
        "vertices",
        vertex,
        format!("expected a convex polygon, got one that is not at vertex {vertex}"),
    )
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

/// Whether the walk comes back on its own line at vertex `k` of three collinear ones.
fn goes_back(vertices: &[DVec2], distinct: &[usize], k: usize) -> bool {
    let count = distinct.len();
    let (p, q, r) = (
        vertices[distinct[(k + count - 1) % count]],
        vertices[distinct[k]],
        vertices[distinct[(k + 1) % count]],
    );
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
