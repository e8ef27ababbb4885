//! The distance of a proved feature in one pass of double-doubles: nothing is searched here any more.
//!
//! A vertex of B ⊖ A is a sum of exact products; only the upper halves take part in the next sum, and
//! everything that they leave out meets once, at the end:
//!
//! ```text
//! d = c + R q − v                        in A's frame, for an edge of A and for two vertices
//! d = Rᵀ (c − v) + q                     in B's frame, for an edge of B, whose normal then needs no turning
//! gap = n · d        |d| = ρ + (d · d − ρ²) / 2ρ        ρ = the double next to |d|
//! ```
//!
//! With ρ within 1.5ε of |d|, the root's next term is below ε² |d|.

use crate::collision::certified::distance::pair::Pair;
use crate::collision::feature::DifferenceEdge;
use crate::geometry::{
    DVec2, Dd, Rotation, Side, UnitVector, combined, fast_two_sum, perp, two_product, two_sum,
};

/// A distance of cores, its direction and what the turning of an edge adds to the pair's placing error.
pub(crate) struct Measured {
    /// Along the normal, or between the vertices.
    pub(crate) core: Dd,
    /// Unit vector from A to B, in A's frame.
    pub(crate) normal: UnitVector,
    /// Bound on the error besides [`Pair::placing_error`] and
    /// [`crate::collision::certified::rounding::LAST_ERROR`].
    pub(crate) turning: f64,
}

/// The gap along an edge's normal, which the vertex is known to support.
#[inline]
pub(crate) fn along_edge(pair: &Pair, DifferenceEdge { source, edge, vertex }: DifferenceEdge) -> Measured {
    let hull = pair.hull(source);
    let (hi, lo) = (hull.normals[edge], hull.tails[edge]);
    let [x, y] = [Dd { hi: hi.x, lo: lo.x }, Dd { hi: hi.y, lo: lo.y }];
    match source {
        Side::A => {
            let d = between(pair, [edge, vertex]);
            Measured { core: combined(x, d[0], y, d[1]), normal: hi, turning: 0.0 }
        }
        Side::B => {
            let (d, size) = apart_seen_from_b(pair, [vertex, edge]);
            let d = if pair.is_multiplied() { with_tails_seen_from_b(pair, [vertex, edge], d) } else { d };
            let d = d.components();
            let core = -combined(x, d[0], y, d[1]);
            Measured {
                core,
                normal: -hi.turned(pair.b_rotation.rounded()),
                turning: 2.0 * pair.turn_error * size,
            }
        }
    }
}

/// The distance of two vertices; None where they are so near that their direction means nothing.
#[inline]
pub(crate) fn between_vertices(pair: &Pair, vertices: [usize; 2]) -> Option<Measured> {
    let [x, y] = between(pair, vertices);
    let rough = (x.hi * x.hi + y.hi * y.hi).sqrt();
    if rough <= pair.gap_error() {
        return None;
    }
    let ((p, e), (q, f)) = (two_product(x.hi, x.hi), two_product(y.hi, y.hi));
    let (r, g) = two_product(rough, rough);
    let (s, h) = two_sum(p, q);
    // s − r is exact: they are within a few ε of each other.
    let rest = (s - r) + ((h + ((e + f) - g)) + 2.0 * (x.hi * x.lo + y.hi * y.lo));
    let (hi, lo) = fast_two_sum(rough, rest * (0.5 / rough));
    Some(Measured {
        core: Dd { hi, lo },
        normal: UnitVector::normalized(DVec2::new(x.hi / hi, y.hi / hi)),
        turning: 0.0,
    })
}

/// A vector in double-doubles, upper and lower halves apart.
#[derive(Clone, Copy)]
struct Long {
    /// The upper halves.
    hi: DVec2,
    /// The lower halves.
    lo: DVec2,
}

impl Long {
    /// Its components.
    #[inline]
    fn components(self) -> [Dd; 2] {
        [Dd { hi: self.hi.x, lo: self.lo.x }, Dd { hi: self.hi.y, lo: self.lo.y }]
    }
}

/// Vertex j of B less vertex i of A in A's frame, within the pair's placing error.
#[inline]
pub(crate) fn between(pair: &Pair, vertices: [usize; 2]) -> [Dd; 2] {
    let apart = apart(pair, vertices);
    let apart = if pair.is_multiplied() { with_tails(pair, vertices, apart) } else { apart };
    apart.components()
}

/// `w_j − v_i` as two vectors, upper and lower halves, so that x and y share SIMD lanes.
///
/// Not inlined: where it is, LLVM computes one component after the other.
///
/// Of the lower halves, together below 2.6 ε M in each component, eight sums lose 4.1 ε² M.
#[inline(never)]
fn apart(pair: &Pair, [i, j]: [usize; 2]) -> Long {
    let (v, q) = (pair.hull(Side::A).vertices[i], pair.hull(Side::B).vertices[j]);
    let (Rotation { cos, sin }, [x, y]) = (pair.b_rotation, pair.center_tailed);
    let across = perp(q);
    let (p, e) = two_product(q, DVec2::splat(cos.hi));
    let (r, f) = two_product(across, DVec2::splat(sin.hi));
    let (s, g) = two_sum(p, r);
    let (t, h) = two_sum(DVec2::new(x.hi, y.hi), -v);
    let (u, k) = two_sum(s, t);
    let low = ((e + f) + (q * cos.lo + across * sin.lo)) + ((g + h) + (k + DVec2::new(x.lo, y.lo)));
    let (hi, lo) = two_sum(u, low);
    Long { hi, lo }
}

/// `w_j − v_i` in A's frame with what the doubles of both vertices leave out.
#[cold]
fn with_tails(pair: &Pair, [i, j]: [usize; 2], apart: Long) -> Long {
    let (a, b) = (pair.hull(Side::A).vertex_tail(i), pair.hull(Side::B).vertex_tail(j));
    let (hi, lo) = two_sum(apart.hi, apart.lo + (pair.vector_from_b(b) - a));
    Long { hi, lo }
}

/// `w_j − v_i` in B's frame with what the doubles of both vertices leave out.
#[cold]
fn with_tails_seen_from_b(pair: &Pair, [i, j]: [usize; 2], apart: Long) -> Long {
    let (a, b) = (pair.hull(Side::A).vertex_tail(i), pair.hull(Side::B).vertex_tail(j));
    let (hi, lo) = two_sum(apart.hi, apart.lo + (b - pair.vector_to_b(a)));
    Long { hi, lo }
}

/// `w_j − v_i` in B's frame, and the 1-norm of what was turned.
#[inline(never)]
fn apart_seen_from_b(pair: &Pair, [i, j]: [usize; 2]) -> (Long, f64) {
    let (v, q) = (pair.hull(Side::A).vertices[i], pair.hull(Side::B).vertices[j]);
    let (Rotation { cos, sin }, [x, y]) = (pair.b_rotation, pair.center_tailed);
    let (s, g) = two_sum(DVec2::new(x.hi, y.hi), -v);
    let (from, low) = two_sum(s, g + DVec2::new(x.lo, y.lo));
    let (across, across_low) = (-perp(from), -perp(low));
    let (p, e) = two_product(from, DVec2::splat(cos.hi));
    let (r, f) = two_product(across, DVec2::splat(sin.hi));
    let (s, g) = two_sum(p, r);
    let (u, k) = two_sum(s, q);
    let lower = (low * cos.hi + from * cos.lo) + (across_low * sin.hi + across * sin.lo);
    let (hi, lo) = two_sum(u, ((e + f) + lower) + (g + k));
    (Long { hi, lo }, from.x.abs() + from.y.abs())
}

/// An edge's normal from A to B in A's frame, and the gap along it of vertices `d` apart.
#[inline]
pub(crate) fn along_normal(pair: &Pair, facing: DifferenceEdge, d: [Dd; 2]) -> (UnitVector, Dd) {
    let hull = pair.hull(facing.source);
    let (hi, lo) = (hull.normals[facing.edge], hull.tails[facing.edge]);
    let local = [Dd { hi: hi.x, lo: lo.x }, Dd { hi: hi.y, lo: lo.y }];
    let n = match facing.source {
        Side::A => local,
        Side::B => pair.b_rotation.apply(local).map(|x| -x),
    };
    (UnitVector::normalized(DVec2::new(n[0].hi, n[1].hi)), combined(n[0], d[0], n[1], d[1]))
}
