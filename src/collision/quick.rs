//! The quick proof: a guessed feature, its conditions checked in doubles, its distance in one pass of double-doubles.
//!
//! A guess is right if the other body's supporting corner is the one that it names and if the foot of the origin lies
//! inside the feature. Both are signs of dot products; here they must be clear of a bound on all rounding. Then the gap
//! along the side's normal (or the distance of two corners) is the separation of the cores, and only its last digits are
//! left to compute (a side of the other body may be parallel, if that is exact):
//!
//! ```text
//! gap = n · (c + R q_j − v_i)          error ≤ |error of c and R q_j| + |error of n| |c + R q_j − v_i| + 64 ε² M
//! ```
//!
//! Where any condition is not clear, or the error is more than [`TIGHT`] of the separation, there is no quick proof.

use super::certify::Hint;
use super::gaps::{Facing, every_gap};
use super::guess::{Guess, guess};
use super::pair::{Pair, turned};
use super::place::{Carrier, Proved};
use crate::geometry::{DVec2, Dd, Enclosure, Side, combined};

/// Largest error of a quick proof relative to the separation: with 1 ulp on either side of it the bounds are 18 ε wide
/// at most, far below the 450 ε (1e-13) that are promised, and the error is below 45 ε (1e-14).
const TIGHT: f64 = 8.0 * f64::EPSILON;

/// Error of a dot product of two vectors of the first stage, relative to the product of their 1-norms: corners,
/// sides and normals are within 4ε of theirs, the product adds 1.5ε.
const DOT_ERROR: f64 = 8.0 * f64::EPSILON;

/// Rounding of the last dot product and sum, as a multiple of the magnitude M: the normal is within 16 ε² √2, the
/// product 6 ε² √2, two sums.
pub(super) const LAST_ERROR: f64 = 64.0 * f64::EPSILON * f64::EPSILON;

/// A separation that can be proved with little work.
#[inline]
pub(crate) fn proved(pair: &Pair) -> Option<Proved> {
    if !pair.is_tame() {
        return None;
    }
    let found = match guess(pair) {
        Guess::Apart(hint) => apart(pair, hint),
        Guess::Overlapping => deepest(pair),
        Guess::Unclear => None,
    }?;
    if let Some(proved) = measured(pair, found) {
        return Some(proved);
    }
    measured(&pair.refined(), found)
}

/// A feature whose conditions hold.
#[derive(Clone, Copy)]
enum Feature {
    Edge(Facing),
    /// The other body's side is exactly parallel.
    Faces(Facing, usize),
    Corners([usize; 2]),
}

/// How the corner of an edge of B ⊖ A supports it.
#[derive(Clone, Copy)]
pub(super) enum Support {
    /// Clearly alone.
    Corner,
    /// With the whole of this side.
    Face(usize),
    /// Rounding hides it.
    Unclear,
}

/// The largest gap of all, if it is clearly negative and clearly the largest but for a parallel side's.
fn deepest(pair: &Pair) -> Option<Feature> {
    let error = pair.gap_error();
    let [mut top, mut second, mut third] = [f64::NEG_INFINITY; 3];
    let (mut best, mut next) = (None, None);
    every_gap(pair, |facing, gap| {
        if gap > top {
            (third, second, top) = (second, top, gap);
            (next, best) = (best, Some(facing));
        } else if gap > second {
            (third, second) = (second, gap);
            next = Some(facing);
        } else if gap > third {
            third = gap;
        }
    });
    let facing = best?;
    let floor = top - 2.0 * error;
    if top >= -error || third >= floor {
        return None;
    }
    match support(pair, facing) {
        Support::Corner if second < floor => Some(Feature::Edge(facing)),
        Support::Face(partner) => {
            let same = next.is_some_and(|next| next.source != facing.source && next.edge == partner);
            (second < floor || same).then_some(Feature::Faces(facing, partner))
        }
        _ => None,
    }
}

/// The guessed feature, if it is clearly the closest.
#[inline]
fn apart(pair: &Pair, hint: Hint) -> Option<Feature> {
    match hint {
        Hint::Edge(facing) => match support(pair, facing) {
            Support::Corner => spans(pair, facing, None).then_some(Feature::Edge(facing)),
            Support::Face(partner) => {
                spans(pair, facing, Some(partner)).then_some(Feature::Faces(facing, partner))
            }
            Support::Unclear => None,
        },
        Hint::Corners([i, j]) => {
            let d = corner_b(pair, j) - pair.hull(Side::A).corners[i];
            let clear = is_lowest(pair, Side::B, j, d) && is_lowest(pair, Side::A, i, -d);
            clear.then_some(Feature::Corners([i, j]))
        }
    }
}

/// B's corner in A's frame.
#[inline]
fn corner_b(pair: &Pair, j: usize) -> DVec2 {
    pair.center + turned(pair.b_turn, pair.hull(Side::B).corners[j])
}

/// The normal of a side from A to B, in A's frame.
#[inline]
fn normal(pair: &Pair, facing: Facing) -> DVec2 {
    let outward = pair.hull(facing.source).normals[facing.edge];
    match facing.source {
        Side::A => outward,
        Side::B => -turned(pair.b_turn, outward),
    }
}

/// The 1-norm.
#[inline]
fn size(v: DVec2) -> f64 {
    v.x.abs() + v.y.abs()
}

/// Whether corner k of a body is clearly the lowest along `down` (A's frame); `down` may be off by [`Pair::gap_error`]
/// where it is a difference of corners.
#[inline]
pub(super) fn is_lowest(pair: &Pair, side: Side, k: usize, down: DVec2) -> bool {
    let hull = pair.hull(side);
    if hull.sides.is_empty() {
        return true;
    }
    let down = match side {
        Side::A => down,
        Side::B => {
            let [cos, sin] = pair.b_turn;
            DVec2::new(cos.hi * down.x + sin.hi * down.y, cos.hi * down.y - sin.hi * down.x)
        }
    };
    let (ahead, behind) = (hull.sides[k], hull.sides[hull.previous(k)]);
    // A normal has a 1-norm of 1 at least, a difference of corners is off by the gap error.
    let slack = DOT_ERROR * size(down) + pair.gap_error();
    ahead.dot(down) > slack * size(ahead) && behind.dot(down) < -slack * size(behind)
}

/// How the corner of an edge of B ⊖ A supports it.
#[inline]
pub(super) fn support(pair: &Pair, facing: Facing) -> Support {
    let other = facing.source.other();
    let n = normal(pair, facing);
    let hull = pair.hull(other);
    if hull.sides.is_empty() {
        return Support::Corner;
    }
    let down = match other {
        Side::A => -n,
        Side::B => {
            let [cos, sin] = pair.b_turn;
            DVec2::new(cos.hi * n.x + sin.hi * n.y, cos.hi * n.y - sin.hi * n.x)
        }
    };
    let back = hull.previous(facing.corner);
    let (ahead, behind) = (hull.sides[facing.corner], hull.sides[back]);
    let (rise, fall) = (ahead.dot(down), behind.dot(down));
    let (rises, falls) = (rise > 2.0 * DOT_ERROR * size(ahead), fall < -2.0 * DOT_ERROR * size(behind));
    // With a direction along an axis, and no turn or quarter turns only, the dot product is a coordinate's difference:
    // its 0 is exact.
    let exact = pair.turn_error == 0.0 && (down.x == 0.0 || down.y == 0.0);
    if rises && falls {
        Support::Corner
    } else if exact && rise == 0.0 && falls {
        Support::Face(facing.corner)
    } else if exact && fall == 0.0 && rises {
        Support::Face(back)
    } else {
        Support::Unclear
    }
}

/// Whether the corner (or with `partner` the parallel side) that faces a side is clearly outside its line, with its foot
/// (or a part of its span) clearly inside the side.
#[inline]
fn spans(pair: &Pair, Facing { source, edge, corner }: Facing, partner: Option<usize>) -> bool {
    let (hull, other) = (pair.hull(source), pair.hull(source.other()));
    let seen = |k: usize| match source {
        Side::A => corner_b(pair, k),
        Side::B => pair.local_to_b(pair.hull(Side::A).corners[k]),
    };
    let (along, n) = (hull.sides[edge], hull.normals[edge]);
    let (start, end) = (hull.corners[edge], hull.corners[hull.next(edge)]);
    let error = pair.gap_error();
    let slack = error * size(along);
    let point = seen(corner);
    if n.dot(point - start) <= error {
        return false;
    }
    // How far inside each end of the side the point is, in units of the side's length.
    let inside = |point: DVec2| ((point - start).dot(along), (end - point).dot(along));
    let (mut from, mut to) = inside(point);
    if let Some(k) = partner {
        let (f, t) = inside(seen(if k == corner { other.next(k) } else { k }));
        (from, to) = (from.max(f), to.max(t));
    }
    from > slack && to > slack
}

/// The feature's distance to twice the precision, if that is tight enough.
#[inline]
fn measured(pair: &Pair, feature: Feature) -> Option<Proved> {
    let [i, j] = match feature {
        Feature::Corners(corners) => corners,
        Feature::Edge(Facing { source, edge, corner })
        | Feature::Faces(Facing { source, edge, corner }, _) => match source {
            Side::A => [edge, corner],
            Side::B => [corner, edge],
        },
    };
    let d = between(pair, [i, j]);
    let (core, normal, carrier) = match feature {
        Feature::Edge(facing) => {
            let (n, gap) = along_normal(pair, facing, d);
            (gap, n, Carrier::Edge(facing))
        }
        Feature::Faces(facing, partner) => {
            let (n, gap) = along_normal(pair, facing, d);
            (gap, n, Carrier::Faces(facing, partner))
        }
        Feature::Corners(corners) => {
            let length = combined(d[0], d[0], d[1], d[1]).sqrt();
            let n = DVec2::new(d[0].hi / length.hi, d[1].hi / length.hi);
            (length, n, Carrier::Corners(corners))
        }
    };
    let separation = core - pair.radius;
    // A side of B: its normal is turned as well.
    let turning = match feature {
        Feature::Edge(Facing { source: Side::B, .. }) => {
            2.0 * pair.turn_error * (d[0].hi.abs() + d[1].hi.abs())
        }
        _ => 0.0,
    };
    let error = pair.placing_error + turning + LAST_ERROR * (pair.magnitude + pair.radius.hi);
    let value = separation.hi;
    // Corners must be apart for their direction to mean anything.
    let hangs = matches!(carrier, Carrier::Corners(_)) && core.hi <= pair.gap_error();
    if hangs || error > TIGHT * value.abs() {
        return None;
    }
    let bounds = Enclosure {
        lo: (value + (separation.lo - error)).next_down(),
        hi: (value + (separation.lo + error)).next_up(),
    };
    Some(Proved { carrier, normal: Some(normal), core: core.hi, separation: value, bounds, ties: 1 })
}

/// Corner j of B less corner i of A, within the pair's placing error.
#[inline]
pub(super) fn between(pair: &Pair, [i, j]: [usize; 2]) -> [Dd; 2] {
    let (v, q) = (pair.hull(Side::A).corners[i], pair.hull(Side::B).corners[j]);
    let [cos, sin] = pair.b_turn;
    let (qx, qy) = (Dd::new(q.x), Dd::new(q.y));
    [
        (combined(cos, qx, -sin, qy) + pair.fine_center[0]).add_f64(-v.x),
        (combined(sin, qx, cos, qy) + pair.fine_center[1]).add_f64(-v.y),
    ]
}

/// A side's normal from A to B and the gap along it.
#[inline]
pub(super) fn along_normal(pair: &Pair, facing: Facing, d: [Dd; 2]) -> (DVec2, Dd) {
    let hull = pair.hull(facing.source);
    let (hi, lo) = (hull.normals[facing.edge], hull.tails[facing.edge]);
    let local = [Dd { hi: hi.x, lo: lo.x }, Dd { hi: hi.y, lo: lo.y }];
    let n = match facing.source {
        Side::A => local,
        Side::B => {
            let [cos, sin] = pair.b_turn;
            [combined(sin, local[1], -cos, local[0]), -combined(sin, local[0], cos, local[1])]
        }
    };
    (DVec2::new(n[0].hi, n[1].hi), combined(n[0], d[0], n[1], d[1]))
}
