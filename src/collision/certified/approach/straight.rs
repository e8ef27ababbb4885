//! The closest approach of two bodies of which neither turns, exact like a separation at one moment.
//!
//! Seen from A, B moves along a straight line and B ⊖ A keeps its shape. The gap g along a fixed direction n
//! is then linear in time, and so nowhere below the lesser of its values at t = 0 and t = 1; the separation
//! is the greatest of all gaps, and so convex. Three cases:
//!
//! ```text
//! v·n ≤ 0 at t = 0        they part from the start: closest at t = 0, along the normal n there
//! v·n > 0 at t = 1        they close in to the end: closest at t = 1, along the normal there
//! else                    they pass: closest along n square to v, at the vertex p of B ⊖ A lowest along n,
//!                         t = v·p / |v|²
//! ```
//!
//! v is the closing velocity `v_A` − `v_B`. In the last case g does not change with time at all. Of moments
//! that tie, since an edge is parallel to v, the first is taken. The signs and t are guesses in doubles or
//! balls: whatever they are, the gap along the direction that they lead to is a proof.

use crate::collision::answer::Separation;
use crate::collision::certified::distance::balls::{BallPair, cross, dot, reversed, rounded};
use crate::collision::certified::distance::witnesses::{self, Carrier, Proved};
use crate::collision::certified::distance::{Pair, proved};
use crate::geometry::{Ball, Body, DVec2, Side};

/// When the bodies are closest, how they stand then, and a lower bound of their separation at any time in
/// [0, 1]; lengths in world units.
pub(crate) fn closest(a: &Body, b: &Body) -> (f64, Separation, f64) {
    let start = Standing::at(a, b, 0.0);
    if !start.closing().is_positive() {
        return start.answer(f64::NEG_INFINITY);
    }
    let end = Standing::at(a, b, 1.0);
    if end.closing().is_positive() {
        return end.answer(start.least());
    }
    let pass = Passing::of(&start);
    let least = pass.least.max(start.least()).max(end.least());
    let upper = |standing: &Standing| standing.proved.bounds.hi;
    let nearer_end = if upper(&end) < upper(&start) { &end } else { &start };
    match pass.time.map(|t| Standing::at(a, b, t)) {
        // At an end of the motion they may be as close, but for rounding.
        Some(nearest) if upper(&nearest) <= upper(nearer_end) + start.rounding() => nearest.answer(least),
        _ => nearer_end.answer(least),
    }
}

/// The bodies at a moment, with their separation.
struct Standing<'s> {
    /// The bodies then.
    pair: Pair<'s>,
    /// How far apart they are then.
    proved: Proved,
}

impl<'s> Standing<'s> {
    fn at(a: &'s Body, b: &'s Body, t: f64) -> Self {
        let pair = Pair::refined_at(a, b, t);
        Self { pair, proved: proved(&pair, None) }
    }

    /// How fast the gap along the exact normal closes, world units per unit of time.
    fn closing(&self) -> Ball {
        let balls = BallPair::new(&self.pair);
        let (n, length) = match self.proved.carrier {
            Carrier::Edge(facing) | Carrier::ParallelEdges(facing, _) => {
                (balls.normal(facing.source, facing.edge), Ball::ONE)
            }
            Carrier::Vertex([i, j]) => {
                let p = balls.between(i, j);
                (p, dot(&p, &p).sqrt())
            }
        };
        let closing = dot(&n, &self.pair.closing_in_balls()).over(length);
        let Ball { value, radius } = closing;
        // A power of two, and its quotient is one.
        let unscale = self.pair.unscale();
        Ball::within(value.scale_by_power_of_two(unscale), radius * unscale)
    }

    /// Differences of separations that rounding makes, world units.
    fn rounding(&self) -> f64 {
        self.pair.gap_error() * self.pair.unscale()
    }

    /// The gap along this moment's normal at the other end of the motion, or here: a lower bound of the
    /// separation at any time in [0, 1], world units.
    fn least(&self) -> f64 {
        let (t, closing) = (self.pair.time, self.closing());
        let falls = (closing.enclosure().hi * (1.0 - t)).max(-closing.enclosure().lo * t).max(0.0);
        if falls == 0.0 {
            self.proved.bounds.lo
        } else {
            (self.proved.bounds.lo - falls.next_up()).next_down()
        }
    }

    /// This moment as the closest; `least` is a lower bound found otherwise.
    fn answer(&self, least: f64) -> (f64, Separation, f64) {
        let separation = witnesses::answer(&self.pair, &self.proved);
        (self.pair.time, separation, self.least().max(least))
    }
}

/// The bodies as one passes the other: along the direction square to their relative velocity.
struct Passing {
    /// When the vertex of B ⊖ A that is lowest along it is closest; None where doubles do not say.
    time: Option<f64>,
    /// Lower bound of the gap along it, which is the same at all times; world units.
    least: f64,
}

impl Passing {
    /// What the pair at t = 0 says of it.
    fn of(start: &Standing) -> Self {
        let pair = &start.pair;
        let (balls, v) = (BallPair::new(pair), pair.closing_in_balls());
        let [i, j] = match start.proved.carrier {
            Carrier::Edge(facing) | Carrier::ParallelEdges(facing, _) => facing.start(),
            Carrier::Vertex(vertices) => vertices,
        };
        let across = [-v[1], v[0]];
        let is_left = cross(&v, &balls.between(i, j)).value.hi > 0.0;
        let n = if is_left { across } else { reversed(&across) };
        let [i, j] = first_of_lowest(pair, rounded(&n), rounded(&v));
        let p = balls.between(i, j);
        let drop = balls.drop_below(Side::B, j, &n) + balls.drop_below(Side::A, i, &reversed(&n));
        let squared = dot(&v, &v);
        let gap = (dot(&n, &p) - Ball::new(drop)).over(squared.sqrt()) - Ball::exact(pair.radius);
        let time = dot(&v, &p).over(squared).value.to_f64().clamp(0.0, 1.0);
        Self { time: (!time.is_nan()).then_some(time), least: gap.enclosure_scaled(pair.unscale()).lo }
    }
}

/// The vertex [i, j] of B ⊖ A that is lowest along `n`; of several, as far as doubles tell, the one that a
/// ray along `v` comes to first. Both directions are in A's frame.
fn first_of_lowest(pair: &Pair, n: DVec2, v: DVec2) -> [usize; 2] {
    let level = pair.gap_error() * n.length();
    let level = if level.is_finite() { level } else { 0.0 };
    let pick = |side: Side, n: DVec2, v: DVec2| {
        let vertices = &pair.hull(side).vertices;
        let height = |q: &DVec2| n.dot(*q * pair.scale);
        let least = vertices.iter().map(height).fold(f64::INFINITY, f64::min);
        let low = vertices.iter().enumerate().filter(|(_, q)| height(q) <= least + level);
        low.min_by(|(_, p), (_, q)| v.dot(**p).total_cmp(&v.dot(**q))).map_or(0, |(k, _)| k)
    };
    [pick(Side::A, -n, -v), pick(Side::B, pair.vector_to_b(n), pair.vector_to_b(v))]
}
