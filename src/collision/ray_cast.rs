//! Linear sweep, directly: one ray against the edges of B ⊖ A that face it.
//!
//! Seen from A, B moves by −v, v = v_A − v_B; so A meets B when the ray r(t) = t v from the origin enters B ⊖ A. Let an edge
//! of B ⊖ A run from P to Q, e = Q − P, with outward normal N = (e_y, −e_x), and ρ = r_A + r_B. Then
//!
//! ```text
//! N·v < 0                          the edge faces the ray; the others are skipped
//! cross(v, P) ≥ 0 ≥ cross(v, Q)    the ray's line passes between P and Q
//! t = (N·P + ρ |N|) / (N·v)        where the ray meets the edge, moved out by ρ
//! t = c / (b + √(ρ² |v|² − cross(v, P)²)),  b = v·P,  c = P·P − ρ²        where it meets the disc at P
//! ```
//!
//! cross(v, ·) falls along the edges that face the ray, so that exactly one edge or disc is met first. Doubles find it;
//! balls then decide every sign, so that a graze is a hit exactly if the signs say so, and enclose t.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section Continuous; the root without cancellation is
//! Press et al., *Numerical Recipes*, 2007, section 5.6.

use super::contact;
use super::difference::{self, Pairing, walk};
use super::moving_pair::{MovingPair, Seen};
use super::pair::Pair;
use super::relative::{Relative, Turn};
use super::{Answer, Impact, Outcome, Query, Reason, Separation};
use crate::geometry::{Ball, Body, DVec2, Enclosure, Feature, Side};
use crate::trace::{Culling, Event, Tracer};

/// Its word in a scene file.
pub(crate) const NAME: &str = "ray-cast";

/// Answers a linear sweep.
pub(crate) fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let (a, b) = (query.a, query.b.unwrap_or(query.a));
    let pair = Relative::at(a, b, 0.0);
    tracer.record(|| Event::Started { algorithm: NAME, at: pair.at });
    difference::record(&pair, tracer);
    let ray = Ray::new(&pair);
    let outcome = cast(&ray, a, b);
    if tracer.listens() {
        ray.tell(&outcome, tracer);
    }
    tracer.record(|| Event::Finished { outcome: outcome.word() });
    Answer::Impact(Impact { outcome, tolerance: 0.0, iterations: 1 })
}

/// First contact of two bodies of which neither turns.
pub(super) fn first_contact(a: &Body, b: &Body) -> Outcome {
    cast(&Ray::new(&Relative::at(a, b, 0.0)), a, b)
}

/// First contact along a ray.
fn cast(ray: &Ray, a: &Body, b: &Body) -> Outcome {
    let start = Pair::at(a, b, 0.0).separation();
    if start.bounds.hi <= 0.0 || start.separation <= 0.0 {
        return Outcome::Overlapping { contact: start };
    }
    if ray.v == DVec2::ZERO {
        return if start.bounds.lo > 0.0 { Outcome::Miss } else { contact::at_start(&start) };
    }
    let unsure = |free_until| Outcome::Unresolved { reason: Reason::WithinRounding, free_until };
    match ray.meets() {
        Meeting::Misses => Outcome::Miss,
        Meeting::Unsure => unsure(0.0),
        Meeting::At(first, last) => match within_motion(first, last) {
            Within::Before | Within::After => Outcome::Miss,
            Within::During(time) => Outcome::Hit { time, contact: contact_at(a, b, time.lo) },
            Within::Unsure(free_until) => unsure(free_until),
        },
    }
}

fn contact_at(a: &Body, b: &Body, t: f64) -> Separation {
    Pair::at(a, b, t).separation()
}

/// A quotient that says when, kept apart so that equality with a double can be decided.
#[derive(Clone, Copy, Debug)]
struct Moment {
    numerator: Ball,
    denominator: Ball,
}

/// Whether and when the ray's line enters B ⊖ A.
enum Meeting {
    /// Never.
    Misses,
    /// Not before the first moment, and not after the second; they may be negative or above 1.
    At(Moment, Moment),
    /// The signs are not certain.
    Unsure,
}

/// A moment against [0, 1].
enum Within {
    Before,
    During(Enclosure),
    After,
    /// Around 0 or 1; free until the time given.
    Unsure(f64),
}

/// Doubles around an entry in (0, 1]: the last surely before `first`, and the first surely not before `last`.
fn within_motion(first: Moment, last: Moment) -> Within {
    let (lo, hi) = (first.doubles().0, last.doubles().1);
    if lo >= 1.0 {
        Within::After
    } else if hi <= 0.0 {
        Within::Before
    } else if hi <= 1.0 && lo >= 0.0 {
        Within::During(Enclosure { lo, hi })
    } else {
        Within::Unsure(lo.max(0.0))
    }
}

/// What the ray meets first, by the guess in doubles.
#[derive(Clone, Copy, Debug)]
enum Piece {
    /// An edge, moved out by ρ, with its neighbours that face the ray too.
    Edge { edge: Pairing, before: Option<Pairing>, after: Option<Pairing> },
    /// The disc at the vertex made of A's and B's.
    Disc(usize, usize),
}

/// The ray against B ⊖ A: doubles in A's frame, balls in the frame and units of `moving`.
struct Ray<'p, 's> {
    pair: &'p Relative<'s>,
    moving: MovingPair<'s>,
    /// v.
    v: DVec2,
    /// v in balls.
    v_fine: [Ball; 2],
    /// B's frame to A's, in balls.
    seen: Seen<Ball>,
}

impl<'p, 's> Ray<'p, 's> {
    fn new(pair: &'p Relative<'s>) -> Self {
        let moving = MovingPair::new(pair.a, pair.b);
        let v_fine = moving.closing_fine();
        let v = pair.local_vector(pair.a.velocity - pair.b.velocity);
        let seen = moving.seen_fine(Side::A, 0.0);
        Self { pair, moving, v, v_fine, seen }
    }

    /// Walks the edges that face the ray, from the left of the ray to its right: those of both bodies merged by
    /// direction. Ends early when `visit` says so; returns the vertex of B ⊖ A where it ended.
    fn walk_facing(&self, mut visit: impl FnMut(Pairing) -> bool) -> (usize, usize) {
        let pair = self.pair;
        let (mut a, mut b) = (self.extreme(Side::A, -1.0), self.extreme(Side::B, 1.0));
        for _ in 0..pair.edges(Side::A) + pair.edges(Side::B) {
            let faces = |side: Side, k: usize| {
                pair.edges(side) > 0 && self.v.perp_dot(pair.difference_edge(side, k)) < 0.0
            };
            let from_b = match (faces(Side::A, a), faces(Side::B, b)) {
                (false, false) => break,
                (false, true) => true,
                (true, false) => false,
                (true, true) => matches!(pair.turn_of(Side::A, a, b), Turn::Right | Turn::Along),
            };
            let pairing = if from_b {
                Pairing { source: Side::B, edge: b, vertex: a }
            } else {
                Pairing { source: Side::A, edge: a, vertex: b }
            };
            if !visit(pairing) {
                break;
            }
            if from_b { b = pair.next(Side::B, b) } else { a = pair.next(Side::A, a) }
        }
        (a, b)
    }

    /// The core vertex with the greatest `sign` · cross(v, x): of several the one that B ⊖ A turns to last.
    fn extreme(&self, side: Side, sign: f64) -> usize {
        let mut best = (0, f64::NEG_INFINITY, f64::NEG_INFINITY);
        for k in 0..self.pair.count(side) {
            let x = self.pair.vertex(side, k);
            let (across, along) = (sign * self.v.perp_dot(x), -sign * self.v.dot(x));
            if across > best.1 || (across == best.1 && along > best.2) {
                best = (k, across, along);
            }
        }
        best.0
    }

    /// Finds, in doubles, the edge or disc that the ray's line enters by.
    fn piece(&self) -> Piece {
        let radius = self.pair.radius();
        let (mut before, mut found, mut after) = (None, None, None);
        let mut corner = None;
        let end = self.walk_facing(|p| {
            if found.is_some() {
                after = Some(p);
                return false;
            }
            let [from, to] = p.ends(self.pair);
            let e = to - from;
            let shift = -radius * self.v.dot(e) / difference::length(e);
            if self.v.perp_dot(from) + shift < 0.0 {
                corner = Some(self.start(p));
                return false;
            }
            if self.v.perp_dot(to) + shift <= 0.0 {
                found = Some(p);
            } else {
                before = Some(p);
            }
            true
        });
        match (corner, found) {
            (Some((i, j)), _) => Piece::Disc(i, j),
            (None, Some(edge)) => Piece::Edge { edge, before, after },
            (None, None) => Piece::Disc(end.0, end.1),
        }
    }

    /// The vertex of B ⊖ A where an edge starts.
    fn start(&self, p: Pairing) -> (usize, usize) {
        match p.source {
            Side::A => (p.edge, p.vertex),
            Side::B => (p.vertex, p.edge),
        }
    }

    /// Whether and when the ray's line enters B ⊖ A, certainly.
    fn meets(&self) -> Meeting {
        match self.piece() {
            Piece::Disc(i, j) => self.meets_disc(i, j),
            Piece::Edge { edge, before, after } => self.meets_edge(edge, before, after),
        }
    }

    /// Where the ray meets an edge.
    fn meets_edge(&self, edge: Pairing, before: Option<Pairing>, after: Option<Pairing>) -> Meeting {
        let line = self.line(edge);
        let (left, right) = (line.start.sign(), line.end.sign());
        match (left, right) {
            (Some(0 | 1), Some(0 | -1)) => Meeting::At(line.moment, line.moment),
            // Around a corner: of the two edges that meet there, the later one is entered.
            (None, Some(-1)) => self.around(&line, before),
            (Some(1), None) => self.around(&line, after),
            _ => Meeting::Unsure,
        }
    }

    /// The ray passes so close to the corner between two edges that either may be met.
    fn around(&self, line: &Line, neighbor: Option<Pairing>) -> Meeting {
        let Some(other) = neighbor.map(|p| self.line(p)) else {
            return Meeting::Unsure;
        };
        let (s, t) = (line.moment.value(), other.moment.value());
        let greater = if (s.value - t.value).hi >= 0.0 { s.value } else { t.value };
        let greater = Ball::within(greater, s.radius.max(t.radius));
        let moment = Moment { numerator: greater, denominator: Ball::ONE };
        Meeting::At(moment, moment)
    }

    /// An edge of B ⊖ A in balls.
    fn line(&self, p: Pairing) -> Line {
        let e = self.edge_fine(p);
        let outward = [e[1], -e[0]];
        // The vertex that supports the edge, of neighbours that doubles can't tell apart.
        let other = p.source.other();
        let vertex = match other {
            Side::A => self.climb(other, p.vertex, [-outward[0], -outward[1]]),
            Side::B => self.climb(other, p.vertex, outward),
        };
        let next = self.pair.next(p.source, p.edge);
        let (own_from, own_to, vertex) =
            (self.point(p.source, p.edge), self.point(p.source, next), self.point(other, vertex));
        let between = |own: [Ball; 2]| match p.source {
            Side::A => [vertex[0] - own[0], vertex[1] - own[1]],
            Side::B => [own[0] - vertex[0], own[1] - vertex[1]],
        };
        let (from, to) = (between(own_from), between(own_to));
        let radius = Ball::exact(self.moving.radius);
        let length = dot(e, e).sqrt();
        let shift = (radius * dot(self.v_fine, e)).over(length);
        let (start, end) = (cross(self.v_fine, from), cross(self.v_fine, to));
        let sharp = self.moving.radius.hi == 0.0;
        let (start, end) = if sharp { (start, end) } else { (start - shift, end - shift) };
        let moment = Moment {
            numerator: -(dot(outward, from) + radius * length),
            denominator: -dot(outward, self.v_fine),
        };
        Line { start, end, moment }
    }

    /// Where the ray meets the disc at a vertex.
    fn meets_disc(&self, i: usize, j: usize) -> Meeting {
        let (a, b) = (self.point(Side::A, i), self.point(Side::B, j));
        let p = [b[0] - a[0], b[1] - a[1]];
        let v = self.v_fine;
        let (across, along, speed_squared) = (cross(v, p), dot(v, p), dot(v, v));
        let radius = Ball::exact(self.moving.radius);
        if self.moving.radius.hi == 0.0 {
            return match across.sign() {
                Some(0) => {
                    let moment = Moment { numerator: along, denominator: speed_squared };
                    Meeting::At(moment, moment)
                }
                Some(sign) => self.passes(sign),
                None => Meeting::Unsure,
            };
        }
        let discriminant = radius * radius * speed_squared - across * across;
        match discriminant.sign() {
            Some(0 | 1) => {
                let c = dot(p, p) - radius * radius;
                let root = discriminant.sqrt();
                let last = Moment { numerator: c, denominator: along + root };
                // The tangent at the point of contact bounds the time from below, whatever else there is.
                let t = last.value().value.hi;
                let n = DVec2::new(p[0].value.hi - t * v[0].value.hi, p[1].value.hi - t * v[1].value.hi);
                let first = self.tangent(i, j, n).unwrap_or(last);
                if discriminant.sign() == Some(0) {
                    Meeting::At(last, last)
                } else {
                    Meeting::At(first, last)
                }
            }
            Some(_) => self.passes(across.sign().unwrap_or(0)),
            None => Meeting::Unsure,
        }
    }

    /// The time before which the axis along `n` (A to B) separates.
    fn tangent(&self, i: usize, j: usize, n: DVec2) -> Option<Moment> {
        let n = n / difference::length(n);
        if !n.is_finite() {
            return None;
        }
        let n = [Ball::new(n.x), Ball::new(n.y)];
        let (i, j) = (self.climb(Side::A, i, n), self.climb(Side::B, j, [-n[0], -n[1]]));
        let (a, b) = (self.point(Side::A, i), self.point(Side::B, j));
        let gap = dot(n, b) - dot(n, a) - Ball::exact(self.moving.radius) * dot(n, n).sqrt();
        let closing = dot(n, self.v_fine);
        closing.is_positive().then_some(Moment { numerator: gap, denominator: closing })
    }

    /// Whether the line certainly passes B ⊖ A, which lies on the side of the given sign.
    fn passes(&self, side: i8) -> Meeting {
        let v = self.v_fine;
        let left = [-v[1], v[0]];
        let right = [v[1], -v[0]];
        // B ⊖ A is left of the line: its rightmost point decides, made of B's rightmost and A's leftmost.
        let (toward, away, sign) = if side > 0 { (right, left, -1.0) } else { (left, right, 1.0) };
        let i = self.climb(Side::A, self.extreme(Side::A, -sign), away);
        let j = self.climb(Side::B, self.extreme(Side::B, sign), toward);
        let (a, b) = (self.point(Side::A, i), self.point(Side::B, j));
        let reach = dot(toward, b) - dot(toward, a) + Ball::exact(self.moving.radius) * dot(v, v).sqrt();
        if reach.is_negative() { Meeting::Misses } else { Meeting::Unsure }
    }

    /// The core vertex farthest along a direction, climbing from one that is nearly so.
    fn climb(&self, side: Side, start: usize, direction: [Ball; 2]) -> usize {
        let mut at = start;
        for _ in 0..self.pair.count(side) {
            let reach = dot(direction, self.point(side, at));
            let higher = [self.pair.next(side, at), self.pair.previous(side, at)]
                .into_iter()
                .find(|&k| (dot(direction, self.point(side, k)) - reach).is_positive());
            match higher {
                Some(k) => at = k,
                None => break,
            }
        }
        at
    }

    /// A core vertex in A's frame.
    fn point(&self, side: Side, k: usize) -> [Ball; 2] {
        let q = self.moving.vertex(side, k);
        let q = [Ball::new(q.x), Ball::new(q.y)];
        match side {
            Side::A => q,
            Side::B => self.seen.point(q),
        }
    }

    /// An edge as it runs in B ⊖ A.
    fn edge_fine(&self, p: Pairing) -> [Ball; 2] {
        let (from, to) = (
            self.moving.vertex(p.source, p.edge),
            self.moving.vertex(p.source, self.pair.next(p.source, p.edge)),
        );
        let e = [Ball::difference(to.x, from.x), Ball::difference(to.y, from.y)];
        match p.source {
            Side::A => [-e[0], -e[1]],
            Side::B => self.seen.vector(e),
        }
    }

    /// Records what became of each edge.
    fn tell(&self, outcome: &Outcome, tracer: &mut impl Tracer) {
        let met = matches!(outcome, Outcome::Hit { .. }).then(|| self.piece());
        let radius = self.pair.radius();
        walk(self.pair, |p| {
            let [from, to] = p.ends(self.pair);
            let out = p.outward(self.pair) * radius;
            let facing = self.v.perp_dot(to - from) < 0.0;
            let hit = matches!(met, Some(Piece::Edge { edge, .. }) if edge == p);
            let culling = match (facing, hit) {
                (false, _) => Culling::BackFacing,
                (true, true) => Culling::Hit,
                (true, false) => Culling::Missed,
            };
            let outward = p.outward(self.pair);
            let time = facing.then(|| (outward.dot(from) + radius) / outward.dot(self.v));
            tracer.record(|| Event::RayClipped {
                source: (p.source, Feature::Edge(self.pair.file_edge(p.source, p.edge))),
                from: self.pair.world_vector(from + out),
                to: self.pair.world_vector(to + out),
                outcome: culling,
                time,
            });
        });
        if let (Some(Piece::Disc(i, j)), Outcome::Hit { time, .. }) = (met, outcome) {
            let center = self.pair.vertex(Side::B, j) - self.pair.vertex(Side::A, i);
            let center = self.pair.world_vector(center);
            let source = (Side::B, Feature::Vertex(self.pair.file_vertex(Side::B, j)));
            let time = Some(time.lo);
            tracer.record(|| Event::RayClipped {
                source,
                from: center,
                to: center,
                outcome: Culling::Hit,
                time,
            });
        }
    }
}

/// An edge of B ⊖ A, moved out by ρ, against the ray's line.
struct Line {
    /// cross(v, start).
    start: Ball,
    /// cross(v, end).
    end: Ball,
    /// When the ray meets it.
    moment: Moment,
}

impl Moment {
    /// The last double surely before it, and the first surely not before it.
    fn doubles(self) -> (f64, f64) {
        let value = self.value();
        let nearest = value.value.to_f64();
        // Exactly at a double?
        if (self.numerator - self.denominator.scale(nearest)).sign() == Some(0) {
            return (nearest.next_down(), nearest);
        }
        let Enclosure { lo, hi } = value.enclosure();
        (lo, hi)
    }

    fn value(self) -> Ball {
        self.numerator.over(self.denominator)
    }
}

fn dot(a: [Ball; 2], b: [Ball; 2]) -> Ball {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [Ball; 2], b: [Ball; 2]) -> Ball {
    a[0] * b[1] - a[1] * b[0]
}
