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
use crate::collision::certified::distance::balls::{BallPair, Vec2, cross, dot, reversed, rounded};
use crate::collision::certified::distance::witnesses::{self, Carrier, Proved};
use crate::collision::certified::distance::{Pair, proved};
use crate::geometry::{Ball, Body, DVec2, Hull, Side};

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
    let [first, lowest] = pass.times.map(|t| Standing::at(a, b, t));
    let all = [&first, &lowest, &start, &end];
    let nearest = all.iter().map(|standing| standing.proved.bounds.hi).fold(f64::INFINITY, f64::min);
    // The first of those that are not certainly farther apart than another.
    let closest = all.into_iter().find(|standing| standing.proved.bounds.lo <= nearest);
    closest.unwrap_or(&first).answer(least)
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
        // A power of two, and its quotient is one; below all normal doubles it rounds both halves and the
        // radius.
        let unscale = self.pair.unscale();
        let rounded = if unscale < 1.0 { f64::from_bits(3) } else { 0.0 };
        Ball::within(value.scale_by_power_of_two(unscale), radius * unscale + rounded)
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
    /// Two moments at which they are closest: when the first vertex of B ⊖ A is passed that may be the lowest
    /// along it, as far as doubles tell, and when the one is that 106 bits tell.
    times: [f64; 2],
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
        let [lowest, first, last] = Lowest::along(pair, rounded(&n), rounded(&v)).vertices();
        let squared = dot(&v, &v);
        let passed = |[i, j]: [usize; 2]| dot(&v, &balls.between(i, j)).over(squared).value.to_f64();
        let (mut begins, ends) = (passed(first), passed(last));
        // An edge that is passed: its end is passed for certain a double later.
        if first != last && begins.next_up() < ends {
            begins = begins.next_up();
        }
        let away = reversed(&n);
        let [i, j] = [
            settled(&balls, pair.hull(Side::A), (Side::A, lowest[0]), &away),
            settled(&balls, pair.hull(Side::B), (Side::B, lowest[1]), &n),
        ];
        let drop = balls.drop_below(Side::B, j, &n) + balls.drop_below(Side::A, i, &away);
        let gap =
            (dot(&n, &balls.between(i, j)) - Ball::new(drop)).over(squared.sqrt()) - Ball::exact(pair.radius);
        let in_motion = |t: f64| if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) };
        Self {
            times: [begins, passed([i, j])].map(in_motion),
            least: gap.enclosure_scaled(pair.unscale()).lo,
        }
    }
}

/// The vertex of a core that is lowest along `down`, as far as 106 bits tell, from one that is nearly.
fn settled(balls: &BallPair, hull: &Hull, (side, mut k): (Side, usize), down: &Vec2) -> usize {
    // Each step goes strictly down: at most once round.
    for _ in 0..hull.edges.len() {
        let back = hull.previous(k);
        if dot(down, &balls.edge(side, k)).is_negative() {
            k = hull.next(k);
        } else if dot(down, &balls.edge(side, back)).is_positive() {
            k = back;
        } else {
            break;
        }
    }
    k
}

/// The vertices of A and of B that make those of B ⊖ A which are lowest along a direction: of each body the
/// one that is lowest in doubles, and of those that rounding can't tell from it the first and the last that a
/// ray comes to.
struct Lowest([[usize; 3]; 2]);

impl Lowest {
    /// The lowest along `n` to a ray along `v`, both in A's frame.
    fn along(pair: &Pair, n: DVec2, v: DVec2) -> Self {
        let level = pair.gap_error() * n.length();
        let level = if level.is_finite() { level } else { 0.0 };
        let of = |side: Side, n: DVec2, v: DVec2| {
            let vertices = || pair.hull(side).vertices.iter().map(|q| *q * pair.scale).enumerate();
            let by = |(k, x): (usize, f64), (l, y): (usize, f64)| if y < x { (l, y) } else { (k, x) };
            let least = |along: DVec2, highest: f64| {
                let low = vertices().filter(|(_, q)| n.dot(*q) <= highest);
                low.map(|(k, q)| (k, along.dot(q))).reduce(by).unwrap_or((0, 0.0))
            };
            let (lowest, height) = least(n, f64::INFINITY);
            let [first, last] = [v, -v].map(|along| least(along, height + level).0);
            [lowest, first, last]
        };
        Self([of(Side::A, -n, -v), of(Side::B, pair.vector_to_b(n), pair.vector_to_b(v))])
    }

    /// The vertices [i, j] of B ⊖ A: the lowest, the first and the last.
    fn vertices(&self) -> [[usize; 2]; 3] {
        let Self([a, b]) = self;
        [0, 1, 2].map(|k| [a[k], b[k]])
    }
}
