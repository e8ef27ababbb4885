//! First stage of the ray against B ⊖ A: doubles choose and prove the feature, double-doubles only say when.
//!
//! A ray enters a convex set once. So a feature that the ray meets from outside, at a point that is on the boundary of
//! B ⊖ A grown by ρ, is the one that it enters through, and no other has to be looked at. On the boundary means:
//!
//! - for an edge: the other body's corner supports it, and the origin, moved to t v, is over the edge;
//! - for the disc at a corner p: both bodies' corners are the lowest along p − t v.
//!
//! These are signs of dot products, which must be clear of a bound on all rounding. A line passes B ⊖ A if the support
//! square to it is clearly farther than ρ. The quotient t is then computed to about twice the precision, and is good
//! if its error does not reach a double: its bounds are the two doubles next to it. Turned bodies take the finer cosines
//! and sines for that, which the contact needs as well. Whatever is not clear (t that is a
//! double, parallel sides, grazes) is left to the balls of [`super::ray_cast`].

use super::gaps::{Facing, lowest, pass};
use super::pair::{Pair, turned};
use super::quick::{self, LAST_ERROR, Support};
use super::ray_cast::Piece;
use crate::geometry::{Ball, DVec2, Dd, Enclosure, Side};

/// What is proved of the ray's line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Met {
    /// It passes B ⊖ A.
    Nothing,
    /// It enters here: between neighbouring doubles, or somewhere below 0 or above 1.
    At(Piece, Enclosure),
}

/// Error of a dot product of a side and a point at t v, as a multiple of ε, the side's 1-norm and M + t |v|₁: the point is
/// within 5ε (its corners 4ε, the product and the difference), the side when turned 2ε of twice as much, products and sum
/// 2.5ε, the side's square 12ε: 24ε, √2 for norms; rounded up. The error of t itself comes on top.
const OVER_ERROR: f64 = 64.0 * f64::EPSILON;

/// Error of a support square to the ray, as a multiple of ε, |v|₁ and M + ρ: center 2.5ε, v and its turn 4ε, products
/// and sums 6ε, ρ |v| 4ε; √2 for norms. Rounded up.
const PASS_ERROR: f64 = 64.0 * f64::EPSILON;

/// Farthest that the ray may have run, in M, for [`super::quick::is_lowest`] to know the error of p − t v: p is within
/// 4ε M, t v within 1.5ε of 4 M, the difference within 2.5ε M, and t itself may add 4ε M: 17ε M, of the 32ε M of
/// [`Pair::gap_error`].
const FAR: f64 = 4.0;

/// The ray in A's frame.
struct Line<'p, 's> {
    pair: &'p Pair<'s>,
    /// v.
    v: [Dd; 2],
    /// v in doubles.
    direction: DVec2,
    /// |v|₁.
    speed: f64,
    /// Bound on the error of v, as a vector.
    error: f64,
}

/// What the ray's line meets first, if that can be proved with little work. A pair whose contact will be asked for is
/// left refined.
pub(super) fn met(pair: &mut Pair) -> Option<Met> {
    if !pair.is_tame() {
        return None;
    }
    let line = Line::new(pair)?;
    let found = match last_line(pair, line.direction) {
        Some(facing) => line.edge(facing),
        None => line.disc([0, 0]),
    }?;
    let Found::At(piece, time, error) = found else { return Some(Met::Nothing) };
    // Where nothing happens before t = 1, or all happened before 0, it does not matter when.
    let (lo, hi) = ((time.hi - error).next_down().next_down(), (time.hi + error).next_up().next_up());
    if lo >= 1.0 || hi < 0.0 {
        return Some(Met::At(piece, Enclosure { lo, hi }));
    }
    if pair.is_exactly_turned() {
        return Some(Met::At(piece, neighbours(time, error)?));
    }
    let refined = pair.refined();
    let line = Line::new(&refined)?;
    let (time, error) = match piece {
        Piece::Edge(facing) => line.time(facing)?,
        Piece::Disc(corners) => line.disc_time(corners)?,
    };
    let bounds = neighbours(time, error)?;
    *pair = refined;
    Some(Met::At(piece, bounds))
}

/// A feature that is proved, when, and the bound on the error of that.
enum Found {
    Nothing,
    At(Piece, Dd, f64),
}

impl<'p, 's> Line<'p, 's> {
    fn new(pair: &'p Pair<'s>) -> Option<Self> {
        let (v, error) = pair.closing_tailed()?;
        let direction = DVec2::new(v[0].hi, v[1].hi);
        Some(Self { pair, v, direction, speed: direction.x.abs() + direction.y.abs(), error })
    }

    /// When the ray meets the line of an edge, moved out by ρ, and the error; None where it hardly closes.
    fn time(&self, facing: Facing) -> Option<(Dd, f64)> {
        let (pair, source) = (self.pair, facing.source);
        let d = quick::between(pair, corner_of(facing, facing.edge));
        let gap = quick::along_normal(pair, facing, d).1 - pair.radius;
        let closing = quick::along_normal(pair, facing, self.v).1;
        // A side of B: its normal is turned as well.
        let turning = if source == Side::B { 2.0 * pair.turn_error } else { 0.0 };
        let far = d[0].hi.abs() + d[1].hi.abs();
        let gap_error = pair.placing_error + turning * far + LAST_ERROR * (pair.magnitude + pair.radius.hi);
        let closing_error = self.error + (turning + LAST_ERROR) * self.speed;
        let least = closing.hi * (1.0 - f64::EPSILON) - closing_error;
        if least <= 0.5 * closing.hi {
            return None;
        }
        let time = gap.div(closing);
        let t = time.hi.abs();
        Some((time, (gap_error + t * closing_error) / least + Dd::ROUNDING * t))
    }

    /// The line of an edge, and what is behind its ends.
    fn edge(&self, facing: Facing) -> Option<Found> {
        let Support::Corner = quick::support(self.pair, facing) else { return None };
        let (time, error) = self.time(facing)?;
        let (pair, Facing { source, edge, .. }) = (self.pair, facing);
        let hull = pair.hull(source);
        let side = hull.sides[edge];
        let along = if source == Side::A { side } else { -turned(pair.b_turn, side) };
        let from = (self.apart(corner_of(facing, edge)) - self.direction * time.hi).dot(along);
        let to = side.dot(side) - from;
        let t = time.hi.abs();
        let reach = pair.magnitude + pair.radius.hi + t * self.speed;
        let slack = (OVER_ERROR * reach + error * self.speed) * (side.x.abs() + side.y.abs());
        if from > slack && to > slack {
            Some(Found::At(Piece::Edge(facing), time, error))
        } else if from < -slack {
            self.disc(corner_of(facing, edge))
        } else if to < -slack {
            self.disc(corner_of(facing, hull.next(edge)))
        } else {
            None
        }
    }

    /// A corner of B ⊖ A in doubles.
    fn apart(&self, [i, j]: [usize; 2]) -> DVec2 {
        let pair = self.pair;
        pair.center + turned(pair.b_turn, pair.hull(Side::B).corners[j]) - pair.hull(Side::A).corners[i]
    }

    /// When the ray enters the disc at a corner, and the error; None where it may not.
    fn disc_time(&self, corners: [usize; 2]) -> Option<(Dd, f64)> {
        let pair = self.pair;
        let p = quick::between(pair, corners).map(|x| Ball::within(x, pair.placing_error));
        let v = self.v.map(|x| Ball::within(x, self.error));
        let dot = |x: &[Ball; 2], y: &[Ball; 2]| x[0] * y[0] + x[1] * y[1];
        let (across, radius) = (v[0] * p[1] - v[1] * p[0], Ball::exact(pair.radius));
        let squared = radius * radius;
        let discriminant = squared * dot(&v, &v) - across * across;
        if !discriminant.is_positive() {
            return None;
        }
        let time = (dot(&p, &p) - squared).over(dot(&v, &p) + discriminant.sqrt());
        time.radius.is_finite().then_some((time.value, time.radius))
    }

    /// The disc at a corner of B ⊖ A.
    fn disc(&self, corners: [usize; 2]) -> Option<Found> {
        let pair = self.pair;
        let at = self.apart(corners);
        let (radius, across) = (pair.radius.hi, at.perp_dot(self.direction));
        if radius * radius * self.direction.dot(self.direction) <= across * across {
            return self.passes(at);
        }
        let (time, error) = self.disc_time(corners)?;
        let n = at - self.direction * time.hi;
        let known = time.hi.abs() * self.speed <= FAR * pair.magnitude
            && error * self.speed <= 4.0 * f64::EPSILON * pair.magnitude;
        let proved = known
            && quick::is_lowest(pair, Side::B, corners[1], n)
            && quick::is_lowest(pair, Side::A, corners[0], -n);
        proved.then_some(Found::At(Piece::Disc(corners), time, error))
    }

    /// Whether the line clearly passes B ⊖ A, of which a point near it is `at`.
    fn passes(&self, at: DVec2) -> Option<Found> {
        let pair = self.pair;
        let left = DVec2::new(-self.direction.y, self.direction.x);
        let away = if left.dot(at) > 0.0 { left } else { -left };
        let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
        let [cos, sin] = pair.b_turn;
        let seen = DVec2::new(cos.hi * away.x + sin.hi * away.y, cos.hi * away.y - sin.hi * away.x);
        let (highest, nearest) = (a.corners[lowest(a, -away)], b.corners[lowest(b, seen)]);
        let support = away.dot(pair.center) + seen.dot(nearest) - away.dot(highest);
        let length = self.direction.dot(self.direction).sqrt();
        let slack = PASS_ERROR * (pair.magnitude + pair.radius.hi) * self.speed;
        (support - pair.radius.hi * length > slack).then_some(Found::Nothing)
    }
}

/// The facing edge whose line the ray meets last, in doubles.
pub(super) fn last_line(pair: &Pair, v: DVec2) -> Option<Facing> {
    let Pair { center, b_turn, .. } = *pair;
    let radius = pair.radius.hi;
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let scale = pair.scale;
    let mut last: Option<(Facing, f64)> = None;
    let mut visit = |facing: Facing, gap: f64, closing: f64| {
        // Compared as fractions with positive denominators would overflow sooner than as quotients.
        let time = (gap * scale - radius) / closing;
        if closing > 0.0 && last.is_none_or(|(_, latest)| time > latest) {
            last = Some((facing, time));
        }
    };
    let c = center / scale;
    let (cos, sin) = (b_turn[0].hi, b_turn[1].hi);
    pass(a, b, c, (cos, sin), |edge, corner, gap| {
        visit(Facing { source: Side::A, edge, corner }, gap, a.normals[edge].dot(v));
    });
    let back = DVec2::new(-cos * c.x - sin * c.y, sin * c.x - cos * c.y);
    let seen = DVec2::new(-cos * v.x - sin * v.y, sin * v.x - cos * v.y);
    pass(b, a, back, (cos, -sin), |edge, corner, gap| {
        visit(Facing { source: Side::B, edge, corner }, gap, b.normals[edge].dot(seen));
    });
    last.map(|(facing, _)| facing)
}

/// The corner of B ⊖ A that a corner of an edge's own body makes: [i, j].
fn corner_of(facing: Facing, end: usize) -> [usize; 2] {
    match facing.source {
        Side::A => [end, facing.corner],
        Side::B => [facing.corner, end],
    }
}

/// The doubles next to a number that is known within `error`, if it is certainly between them.
fn neighbours(x: Dd, error: f64) -> Option<Enclosure> {
    // Past the roundings of the bound itself. The tail is half an ulp at most: with an error below it, less than one.
    let error = error * (1.0 + 16.0 * f64::EPSILON);
    if x.lo > error {
        Some(Enclosure { lo: x.hi, hi: x.hi.next_up() })
    } else if x.lo < -error {
        Some(Enclosure { lo: x.hi.next_down(), hi: x.hi })
    } else {
        None
    }
}
