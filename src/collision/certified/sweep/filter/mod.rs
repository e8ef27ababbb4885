//! Filter of the ray against B ⊖ A: doubles choose and prove the feature, double-doubles only say when.
//!
//! A ray enters a convex set once. So a feature that the ray meets from outside, at a point that is on the
//! boundary of B ⊖ A grown by ρ, is the one that it enters through, and no other has to be looked at. On the
//! boundary means:
//!
//! - for an edge: the other body's vertex supports it, and its ends are on either side of the ray's line;
//! - for the disc at a vertex p: both bodies' vertices are the lowest along p − t v.
//!
//! These are signs of dot products, which must be clear of a bound on all rounding. A line passes B ⊖ A if
//! the support square to it is clearly farther than ρ. Then, with q a quotient in doubles, what is left over
//! at q says both when and how near the bodies are just before:
//!
//! ```text
//! g = n·p − ρ,   k = n·v,   q ≈ g / k,   r = g − q k        in double-doubles
//! t = q + r / k                                              s(t₀) = r − (t₀ − q) k
//! ```
//!
//! t is good if its error does not reach a double: its bounds are the two doubles next to it, and s at the
//! first of them is the contact's. That takes cosines and sines to twice the precision as well. Whatever is
//! not clear (t that is a double, parallel edges, grazes) is left to the balls.

pub(crate) mod crossed_edge;

use crate::collision::certified::distance::Pair;
use crate::collision::certified::distance::conditions::is_lowest;
use crate::collision::certified::distance::refine::between;
use crate::collision::certified::distance::witnesses::{Carrier, Proved};
use crate::collision::certified::rounding::{LAST_ERROR, OFFSET_ERROR, REST_ERROR};
use crate::collision::certified::sweep::filter::crossed_edge::{Crossed, crossed};
use crate::collision::certified::sweep::heading::Heading;
use crate::collision::certified::sweep::ray::Entry;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{
    Ball, DVec2, Dd, Enclosure, Rotation, Side, UnitVector, combined, two_product, two_sum,
};

/// Farthest that the ray may have run, in M, for
/// [`crate::collision::certified::distance::conditions::is_lowest`] to know the error of p − t v.
///
/// p is within 3.4 ε M, v in doubles and its product with t within ε of 4 M, the difference within 2.5 ε M,
/// and t itself may add 4 ε M: 13.9 ε M, of the 16 ε M of [`Pair::gap_error`].
const FAR: f64 = 4.0;

/// Part of a closing speed that must be certain; where less is, the ray all but grazes. From a twentieth to
/// 999 thousandths the same rays are decided: all of 3,000 random ones and 292 of the 426 hard ones.
const CERTAIN: f64 = 0.5;

/// Where the ray's line enters B ⊖ A, if that can be proved with little work.
#[inline]
pub(crate) fn entry(pair: &Pair, heading: &Heading) -> Option<Entry> {
    let line = Line { pair, heading };
    match crossed(pair, heading.direction()) {
        Crossed::Passed(past) => (past > line.slack()).then_some(Entry::Misses),
        Crossed::Edge(edge) => {
            (edge.is_supported && edge.inside > line.slack()).then(|| line.edge(edge.edge)).flatten()
        }
        Crossed::Vertex(vertices) => line.disc(vertices),
    }
}

/// The ray's line in A's frame.
#[derive(Clone, Copy)]
pub(crate) struct Line<'p, 's> {
    /// Both bodies at t = 0.
    pub(crate) pair: &'p Pair<'s>,
    /// Where the ray goes.
    pub(crate) heading: &'p Heading,
}

/// A gap that a ray closes, at the time q that doubles give for its end.
pub(crate) struct Rest {
    /// The edge's unit normal, from A to B in A's frame.
    normal: UnitVector,
    /// The time at which the gap ends, in doubles: q ≈ g / k.
    pub(crate) q: f64,
    /// The closing speed along the normal, k, in a double.
    closing: f64,
    /// Lower bound of the closing speed.
    least: f64,
    /// Bound on the error of that double.
    closing_error: f64,
    /// What is left of the gap at q: g − q k.
    pub(crate) left: f64,
    /// Bound on the error of what is left.
    error: f64,
}

impl Line<'_, '_> {
    /// Bound on the error of an offset from the line, in units of |v|.
    #[inline]
    fn slack(&self) -> f64 {
        OFFSET_ERROR * (self.pair.magnitude + self.pair.radius.hi) * self.heading.speed
    }

    /// What a ray that enters through an edge leaves of the gap there; None where it hardly closes.
    #[inline]
    pub(crate) fn rest(&self, facing: DifferenceEdge) -> Option<Rest> {
        let (pair, Heading { v, speed, error }) = (self.pair, *self.heading);
        let d = vertex(pair, facing);
        let n = normal(pair, facing);
        let mut gap = along(n, d);
        if pair.radius.hi > 0.0 {
            gap = gap - pair.radius;
        }
        let closing = along(n, v);
        // An edge of B: its normal is turned as well.
        let turning = if facing.source == Side::B { 2.0 * pair.turn_error } else { 0.0 };
        let far = d[0].hi.abs() + d[1].hi.abs();
        let gap_error = pair.placing_error + turning * far + REST_ERROR * (pair.magnitude + pair.radius.hi);
        let closing_error = error + (turning + REST_ERROR) * speed;
        // Of a ray all but along the edge little is left in the high half, and the low one, which the step
        // from q lacks, is no longer small beside it.
        let rounded_error = closing_error + closing.lo.abs();
        let least = closing.hi * (1.0 - 4.0 * f64::EPSILON) - rounded_error;
        if least <= CERTAIN * closing.hi {
            return None;
        }
        let q = gap.hi / closing.hi;
        let (run, tail) = two_product(closing.hi, q);
        // The first difference is exact: the two are within a few ulp of each other.
        let rest = (gap.hi - run) + ((gap.lo - q * closing.lo) - tail);
        let error = (gap_error + q.abs() * closing_error) * (1.0 + 16.0 * f64::EPSILON);
        let normal = UnitVector::normalized(DVec2::new(n[0].hi, n[1].hi));
        Some(Rest { normal, q, closing: closing.hi, least, closing_error: rounded_error, left: rest, error })
    }

    /// When the ray enters through an edge, and the pair just before; None where it hardly closes.
    #[inline]
    fn edge(&self, facing: DifferenceEdge) -> Option<Entry> {
        let Rest { normal, q, closing, least, closing_error, left, error } = self.rest(facing)?;
        let step = left / closing;
        let hi = q + step;
        // Roundings of the step, and of k, which it is a quotient by.
        let step_error = step.abs() * (closing_error / least + 8.0 * f64::EPSILON);
        let time = Dd { hi, lo: step - (hi - q) };
        let time = neighbours(time, error / least + step_error)?;
        let feature = DifferenceFeature::Edge(facing);
        if time.lo >= 1.0 || time.hi < 0.0 {
            return Some(Entry::At { feature, time, contact: None });
        }
        let back = time.lo - q;
        let separation = left - back * closing;
        let error = error + back.abs() * closing_error + 8.0 * f64::EPSILON * left.abs();
        let proved = Proved {
            carrier: Carrier::Edge(facing),
            normal: Some(normal),
            core: separation + self.pair.radius.hi,
            separation,
            bounds: around(separation, error),
            ties: 1,
        };
        Some(Entry::At { feature, time, contact: Some(proved) })
    }

    /// A vertex of B ⊖ A in doubles.
    fn apart(&self, [i, j]: [usize; 2]) -> DVec2 {
        let pair = self.pair;
        pair.center + pair.vector_from_b(pair.hull(Side::B).vertices[j]) - pair.hull(Side::A).vertices[i]
    }

    /// When the ray enters the disc at a vertex; None where it may not.
    fn time_of_disc(&self, vertices: [usize; 2]) -> Option<Ball> {
        let pair = self.pair;
        let p = between(pair, vertices).map(|x| Ball::within(x, pair.placing_error));
        let v = self.heading.v.map(|x| Ball::within(x, self.heading.error));
        let dot = |x: &[Ball; 2], y: &[Ball; 2]| x[0] * y[0] + x[1] * y[1];
        let (across, radius) = (v[0] * p[1] - v[1] * p[0], Ball::exact(pair.radius));
        let squared = radius * radius;
        let discriminant = squared * dot(&v, &v) - across * across;
        if !discriminant.is_positive() {
            return None;
        }
        let time = (dot(&p, &p) - squared).over(dot(&v, &p) + discriminant.sqrt());
        time.radius.is_finite().then_some(time)
    }

    /// Whether the boundary of B ⊖ A grown by ρ clearly has that disc where the ray enters it.
    fn is_met(&self, vertices: [usize; 2], time: Ball) -> bool {
        let (pair, speed, t) = (self.pair, self.heading.speed, time.value.hi);
        let n = self.apart(vertices) - self.heading.direction() * t;
        t.abs() * speed <= FAR * pair.magnitude
            && time.radius * speed <= 4.0 * f64::EPSILON * pair.magnitude
            && is_lowest(pair, Side::B, vertices[1], n)
            && is_lowest(pair, Side::A, vertices[0], -n)
    }

    /// When the ray enters through the disc at a vertex, and the pair just before.
    fn disc(&self, vertices: [usize; 2]) -> Option<Entry> {
        let (pair, Heading { v, speed, error }) = (self.pair, *self.heading);
        let time = self.time_of_disc(vertices).filter(|&time| self.is_met(vertices, time))?;
        let time = neighbours(time.value, time.radius)?;
        let feature = DifferenceFeature::Vertex(vertices);
        if time.lo >= 1.0 || time.hi < 0.0 {
            return Some(Entry::At { feature, time, contact: None });
        }
        let p = between(pair, vertices);
        let at = [p[0] - v[0].scale(time.lo), p[1] - v[1].scale(time.lo)];
        let core = combined(at[0], at[0], at[1], at[1]).sqrt();
        let separation = (core - pair.radius).to_f64();
        let size = pair.magnitude + pair.radius.hi + time.lo * speed;
        let proved = Proved {
            carrier: Carrier::Vertex(vertices),
            normal: Some(UnitVector::normalized(DVec2::new(at[0].hi, at[1].hi) / core.hi)),
            core: core.hi,
            separation,
            bounds: around(separation, pair.placing_error + time.lo * error + LAST_ERROR * size),
            ties: 1,
        };
        Some(Entry::At { feature, time, contact: Some(proved) })
    }
}

/// Bounds of a separation just before contact, which is above 0. The bound on its error is widened past its
/// own roundings, and past that of the separation.
#[inline]
fn around(separation: f64, error: f64) -> Enclosure {
    let error = error * (1.0 + 16.0 * f64::EPSILON) + 8.0 * f64::EPSILON * separation.abs();
    Enclosure { lo: (separation - error).max(0.0), hi: separation + error }
}

/// The vertex of B ⊖ A where an edge starts, with low halves that are not rounded off the high ones: no sum
/// of them needs it.
#[inline]
fn vertex(pair: &Pair, facing: DifferenceEdge) -> [Dd; 2] {
    let [i, j] = facing.start();
    let (v, q) = (pair.hull(Side::A).vertices[i], pair.hull(Side::B).vertices[j]);
    let (Rotation { cos, sin }, c) = (pair.b_rotation, pair.center_tailed);
    let (cx, cy) = (two_product(cos.hi, q.x), two_product(cos.hi, q.y));
    let (sx, sy) = (two_product(sin.hi, q.x), two_product(sin.hi, q.y));
    let sum = |(p, e): (f64, f64), (r, f): (f64, f64), c: Dd, v: f64, low: f64| {
        let (s, g) = two_sum(p, r);
        let (s, h) = two_sum(s, c.hi);
        let (hi, k) = two_sum(s, -v);
        Dd { hi, lo: ((e + f) + (g + h)) + ((k + c.lo) + low) }
    };
    let apart = [
        sum(cx, (-sy.0, -sy.1), c[0], v.x, cos.lo * q.x - sin.lo * q.y),
        sum(sx, cy, c[1], v.y, sin.lo * q.x + cos.lo * q.y),
    ];
    if pair.is_multiplied() { with_tails(pair, [i, j], apart) } else { apart }
}

/// A vertex of B ⊖ A with what the doubles of its vertices leave out.
#[cold]
fn with_tails(pair: &Pair, [i, j]: [usize; 2], [x, y]: [Dd; 2]) -> [Dd; 2] {
    let (a, b) = (pair.hull(Side::A).vertex_tail(i), pair.hull(Side::B).vertex_tail(j));
    let tail = pair.vector_from_b(b) - a;
    [Dd { lo: x.lo + tail.x, ..x }, Dd { lo: y.lo + tail.y, ..y }]
}

/// The dot product n · x, with a low half that is not rounded off the high one.
#[inline]
fn along(n: [Dd; 2], x: [Dd; 2]) -> Dd {
    let (p, e) = two_product(n[0].hi, x[0].hi);
    let (q, f) = two_product(n[1].hi, x[1].hi);
    let (hi, g) = two_sum(p, q);
    let low = (n[0].hi * x[0].lo + n[0].lo * x[0].hi) + (n[1].hi * x[1].lo + n[1].lo * x[1].hi);
    Dd { hi, lo: ((e + f) + g) + low }
}

/// The unit normal of an edge, from A to B, in A's frame.
#[inline]
fn normal(pair: &Pair, facing: DifferenceEdge) -> [Dd; 2] {
    let hull = pair.hull(facing.source);
    let (hi, lo) = (hull.normals[facing.edge], hull.tails[facing.edge]);
    let local = [Dd { hi: hi.x, lo: lo.x }, Dd { hi: hi.y, lo: lo.y }];
    match facing.source {
        Side::A => local,
        Side::B => pair.b_rotation.apply(local).map(|x| -x),
    }
}

/// The doubles next to a number that is known within `error`, if it is certainly between them.
#[inline]
fn neighbours(x: Dd, error: f64) -> Option<Enclosure> {
    // Past the roundings of the bound itself. The tail is half an ulp at most: with an error below it, less
    // than one.
    let error = error * (1.0 + 16.0 * f64::EPSILON);
    if x.lo > error {
        Some(Enclosure { lo: x.hi, hi: x.hi.next_up() })
    } else if x.lo < -error {
        Some(Enclosure { lo: x.hi.next_down(), hi: x.hi })
    } else {
        None
    }
}

#[cfg(test)]
mod tests;
