//! First stage of the time of impact of turning bodies: doubles find the contact first, and prove afterwards that it is
//! one, and the first.
//!
//! From the closest features at a moment comes an axis; where its gap is used up, a few steps of a series tell. If a
//! vertex then meets the side that the axis is square to, that is the contact; else the features there are asked for,
//! and so on. Nothing of this is proved yet: [`crate::collision::certified::impact::filter::certificate`] does that from the end, with the axes used. Whatever
//! is not clear is left to the steps of [`crate::collision::certified::impact::search`].
//!
//! Of the axes that part the bodies at a moment, the one that lasts longest is the best, not the one with the widest
//! gap: no axis lasts longer than contact, and that of the contact lasts until it. So where vertices are closest, the sides
//! that meet in them are tried before the direction between them. Where the vertex comes down beside the side of a round
//! body, the sides next to that are looked over, once, before a distance query is made.

mod certificate;
mod gap_series;
mod touch;

use crate::collision::answer::Outcome;
use crate::collision::certified::distance::filter::descent::{ANYWHERE, Asked, Guess, search};
use crate::collision::certified::impact::axis::{Axis, AxisSpan};
use crate::collision::certified::impact::closest::certified;
use crate::collision::certified::impact::filter::certificate::{AXES, Parted, Proof};
use crate::collision::certified::impact::filter::gap_series::{Instant, TurnedGap, first_root, rounding};
use crate::collision::certified::impact::limits::Limits;
use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{Enclosure, Side, perp};

/// Moments at which one axis is evaluated.
const EVALUATIONS: usize = 48;

/// No step of a series turns the bodies by more than this together, in radians.
const LARGEST_TURN: f64 = 1.0;

/// At a series' root nearer than this (radians), the place of the vertex is foretold, to this part of the side.
const FORESEEN: f64 = 0.25;

/// The search ends with a gap between these, in roundings, and aims between them.
const BAND: std::ops::Range<f64> = 1.25..4.0;

/// See [`BAND`].
const AIM: f64 = 2.5;

/// A vertex that comes down beside a side is looked for over the sides next to it, up to this part of the way round.
const NEIGHBOURHOOD: usize = 16;

/// A closing speed below this part of the largest speed is a graze: above it, its rounding is below 1e-8 of it.
const GRAZE: f64 = 1e-6;

/// What the filter can say of a pair.
pub(crate) struct Filtered {
    /// The first contact or that there is none, proved; None where that is left to the search.
    pub(crate) outcome: Option<Outcome>,
    /// Distance queries made.
    pub(crate) queries: usize,
}

/// The first contact of a pair, where doubles find it and prove it; the axes of the proof are reported in order of time.
pub(crate) fn first_contact(pair: &MovingPair, limits: Limits, report: impl FnMut(AxisSpan)) -> Filtered {
    let mut quick = QuickImpact::new(pair, limits.allowed(), limits.max_queries);
    let found = quick.run();
    if found.is_some() {
        quick.proof.spans().copied().for_each(report);
    }
    let outcome = found.map(|found| match found {
        Found::Miss => Outcome::Miss,
        Found::Hit(time, near) => {
            let [a, b] = pair.bodies;
            let contact =
                touch::separation(a, b, time.lo, near).unwrap_or_else(|| certified(a, b, time.lo, near));
            Outcome::Hit { time, contact }
        }
    });
    Filtered { outcome, queries: quick.queries }
}

/// What the first stage found.
enum Found {
    /// A contact: the time bounds, and its features.
    Hit(Enclosure, DifferenceFeature),
    /// None in [0, 1].
    Miss,
}

/// A search in doubles.
pub(crate) struct QuickImpact<'p, 'q> {
    pair: &'p MovingPair<'q>,
    /// Bound on the error of a gap.
    error: f64,
    /// Width of the time bounds times the closing speed that contact may leave.
    allowed: f64,
    /// Distance queries that may be made.
    limit: usize,
    /// Distance queries made.
    pub(crate) queries: usize,
    /// What is proved.
    pub(crate) proof: Proof<'p, 'q>,
}

/// Where an axis is used up.
enum Used {
    /// Not in [0, 1]; its gap at the end.
    Never(TurnedGap),
    /// Here, with a gap in [`BAND`].
    Here(Instant, TurnedGap),
    /// About here, by this vertex, which is not over the axis's side.
    About(Instant, usize),
}

impl<'p, 'q> QuickImpact<'p, 'q> {
    /// A search that may leave time bounds as wide as `allowed` over the closing speed.
    pub(crate) fn new(pair: &'p MovingPair<'q>, allowed: f64, limit: usize) -> Self {
        let error = rounding(pair);
        Self { pair, error, allowed, limit, queries: 0, proof: Proof::new(pair, error) }
    }

    /// The first contact, proved.
    fn run(&mut self) -> Option<Found> {
        if self.pair.unit != 1.0 || self.allowed < 2.0 * BAND.end * self.error {
            return None;
        }
        let mut axes: [Option<Parted>; AXES] = [None; AXES];
        let mut parted = self.ask(&Instant::start(self.pair), None)?;
        let mut asked = true;
        for round in 0..AXES {
            axes[round] = Some(parted);
            let (axis, gap) = parted;
            let mut next = None;
            for foresight in [true, false] {
                let (then, vertex) = match self.follow(&axis, gap, foresight)? {
                    Used::Never(last) => {
                        self.proof.reach(&axes[..=round], last)?;
                        return Some(Found::Miss);
                    }
                    Used::About(then, vertex) => (then, vertex),
                    Used::Here(then, last) => {
                        if let Some(hit) = self.contact(&axis, &last) {
                            self.proof.reach(&axes[..=round], last)?;
                            return Some(hit);
                        }
                        (then, last.lowest)
                    }
                };
                let beside = if asked { self.beside(&axis, vertex, &then) } else { None };
                asked = beside.is_none();
                next = beside.or_else(|| self.ask(&then, Some(&parted)));
                if next.is_some() {
                    break;
                }
            }
            parted = next?;
        }
        None
    }

    /// The axis to follow at a moment, with its gap; looked for from another one on.
    fn ask(&mut self, at: &Instant, from: Option<&Parted>) -> Option<Parted> {
        let parted = match self.nearest(at, from)? {
            DifferenceFeature::Edge(DifferenceEdge { source: owner, edge, vertex }) => {
                let axis = self.square_to(owner, edge, vertex);
                (axis, axis.turned_gap(self.pair, at, vertex)?)
            }
            DifferenceFeature::Vertex([i, j]) => self.of_vertices(i, j, at)?,
        };
        (parted.1.value >= BAND.end * self.error).then_some(parted)
    }

    /// An axis that parts the pair at a moment at which another is used up by a vertex that is beside its side: the owner's
    /// feature next to that vertex has it, if nothing else came nearer.
    fn beside(&self, axis: &Axis, vertex: usize, at: &Instant) -> Option<Parted> {
        let (owner, other) = (axis.owner, axis.owner.other());
        let (own, q) = (self.pair.hull(owner), self.pair.hull(other).vertices[vertex]);
        let d = if owner == Side::A { at.apart } else { -at.apart };
        let x = at.rotations[owner as usize].undo(d + at.rotations[other as usize].apply(q));
        let (mut k, mut way) = (axis.own, 0);
        for _ in 0..own.edges.len() / NEIGHBOURHOOD {
            let side = own.edges[k];
            let place = (x - own.vertices[k]).dot(side);
            let (step, met, next) = if place < 0.0 {
                (-1, k, own.previous(k))
            } else if place > side.dot(side) {
                (1, own.next(k), own.next(k))
            } else {
                let found = self.square_to(owner, k, vertex);
                let gap = found.turned_gap(self.pair, at, vertex)?;
                return (axis.edge != Some(k) && gap.value >= BAND.end * self.error).then_some((found, gap));
            };
            if way + step == 0 {
                let [i, j] = a_then_b(owner, met, vertex);
                return self.of_vertices(i, j, at);
            }
            (k, way) = (next, step);
        }
        None
    }

    /// The closest features, in doubles.
    fn nearest(&mut self, at: &Instant, from: Option<&Parted>) -> Option<DifferenceFeature> {
        if self.queries >= self.limit {
            return None;
        }
        self.queries += 1;
        let (a, b) = (self.pair.hull(Side::A), self.pair.hull(Side::B));
        let [of_a, of_b] = at.rotations;
        let (center, rotation) = (of_a.undo(at.apart), of_b.then(of_a.inverse()));
        let asked = Asked { a, b, center, rotation };
        let (toward, vertices) = match from {
            Some((axis, gap)) if axis.owner == Side::A => (axis.n, (axis.own, gap.lowest)),
            Some((axis, gap)) => (-rotation.apply(axis.n), (gap.lowest, axis.own)),
            None => (center, ANYWHERE),
        };
        match search(&asked, toward, vertices) {
            Guess::Apart(feature) => Some(feature),
            _ => None,
        }
    }

    /// The axis square to a side.
    fn square_to(&self, owner: Side, edge: usize, facing: usize) -> Axis {
        let hull = self.pair.hull(owner);
        let n = hull.normals[edge];
        Axis { owner, n: *n, support: n.dot(hull.vertices[edge]), own: edge, facing, edge: Some(edge) }
    }

    /// Of the axes of two vertices that are closest, the one that seems to last longest: where bodies are sharp the sides'
    /// come first.
    fn of_vertices(&self, i: usize, j: usize, at: &Instant) -> Option<Parted> {
        let sides = || {
            [(Side::A, i, j), (Side::B, j, i)].into_iter().flat_map(|(owner, k, facing)| {
                let hull = self.pair.hull(owner);
                let count = if hull.edges.is_empty() { 0 } else { 2 };
                [k, hull.previous(k)]
                    .into_iter()
                    .take(count)
                    .map(move |edge| self.square_to(owner, edge, facing))
            })
        };
        let between = || self.between(i, j, at).into_iter().flatten();
        if self.pair.radius.hi == 0.0 {
            self.longest(sides(), at).or_else(|| self.longest(between(), at))
        } else {
            self.longest(between(), at).or_else(|| self.longest(sides(), at))
        }
    }

    /// Of some axes that part the pair at a moment, the one that seems to last longest.
    fn longest(&self, axes: impl Iterator<Item = Axis>, at: &Instant) -> Option<Parted> {
        let mut best: Option<(Parted, f64)> = None;
        for axis in axes {
            let Some(gap) = axis.turned_gap(self.pair, at, axis.facing) else { continue };
            if gap.value >= BAND.end * self.error {
                let until = first_root(&gap.series(self.pair, axis.owner), 1.0 - at.t).unwrap_or(1.0);
                if best.as_ref().is_none_or(|(_, latest)| until > *latest) {
                    best = Some(((axis, gap), until));
                }
            }
        }
        best.map(|(parted, _)| parted)
    }

    /// The axes through two vertices: as they are, and when they will touch, or be closest, if they go on as they move.
    fn between(&self, i: usize, j: usize, at: &Instant) -> [Option<Axis>; 2] {
        let pair = self.pair;
        let owner = pair.calmer();
        let arm = |side: Side, k: usize| at.rotations[side as usize].apply(pair.hull(side).vertices[k]);
        let (x, y) = (arm(Side::A, i), arm(Side::B, j));
        let (_, v) = pair.offset(Side::A, 0.0);
        let p = at.apart + y - x;
        let w = v + perp(y) * pair.rate[1] - perp(x) * pair.rate[0] - perp(p) * pair.rate[owner as usize];
        let (squared, along) = (w.length_squared(), p.dot(w));
        let c = p.length_squared() - pair.radius.hi * pair.radius.hi;
        let discriminant = along * along - squared * c;
        let h = if along >= 0.0 {
            0.0
        } else if discriminant > 0.0 {
            c / (discriminant.sqrt() - along)
        } else {
            -along / squared
        };
        let hull = pair.hull(owner);
        let [own, facing] = a_then_b(owner, i, j);
        [p, p + w * h].map(|toward| {
            let direction = toward / toward.length_squared().sqrt();
            let n = at.rotations[owner as usize].undo(if owner == Side::A { direction } else { -direction });
            let own = hull.highest(n, own);
            let support = n.dot(hull.vertices[own]);
            n.is_finite().then_some(Axis { owner, n, support, own, facing, edge: None })
        })
    }

    /// Follows an axis from an open gap to where it is used up.
    fn follow(&self, axis: &Axis, start: TurnedGap, foresight: bool) -> Option<Used> {
        let (pair, error) = (self.pair, self.error);
        let rates = pair.rate[0].abs() + pair.rate[1].abs();
        let largest = LARGEST_TURN / rates;
        let (mut lo, mut hi, mut closed) = (start.t, 1.0, false);
        let mut gap = start;
        for _ in 0..EVALUATIONS {
            let mut series = gap.series(pair, axis.owner);
            series[0] -= AIM * error;
            let next = if gap.value >= BAND.end * error {
                lo = gap.t;
                if lo >= 1.0 {
                    return Some(Used::Never(gap));
                }
                let limit = largest.min(hi - lo);
                let step = first_root(&series, limit);
                if foresight
                    && let Some(h) = step
                    && h * rates < FORESEEN
                    && !self.may_touch(axis, &gap, h)
                {
                    return Some(Used::About(Instant::new(pair, lo + h), gap.lowest));
                }
                lo + step.unwrap_or(limit)
            } else {
                (hi, closed) = (gap.t, true);
                // Back to where the same vertex was not through yet.
                gap.t - series[0] / series[1]
            };
            let inside = next > lo && (next < hi || (next == hi && !closed));
            let next = if inside { next } else { 0.5 * (lo + hi) };
            if next <= lo || (closed && next >= hi) {
                return None;
            }
            let at = Instant::new(pair, next);
            gap = axis.turned_gap(pair, &at, gap.lowest)?;
            if BAND.contains(&(gap.value / error)) {
                return Some(Used::Here(at, gap));
            }
        }
        None
    }

    /// Whether the vertex that faces the axis's side may be over it a time h later; with some room.
    fn may_touch(&self, axis: &Axis, gap: &TurnedGap, h: f64) -> bool {
        let Some(edge) = axis.edge else { return false };
        let (from, to) = self.ends(axis, edge);
        let (place, speed) = gap.place(self.pair, axis.owner);
        let (then, room) = (place + speed * h, FORESEEN * ((to - from) + (speed * h).abs()));
        then > from - room && then < to + room
    }

    /// The ends of an axis's side along perp(n).
    fn ends(&self, axis: &Axis, edge: usize) -> (f64, f64) {
        let hull = self.pair.hull(axis.owner);
        let along = perp(axis.n);
        (along.dot(hull.vertices[edge]), along.dot(hull.vertices[hull.next(edge)]))
    }

    /// The contact that is proved just after the moment of a gap that is all but used up.
    ///
    /// The vertex is outside the side's line now. By `hi` it has crossed it: f + G − h |f'| + ½ K h² ≤ 0. It moves by
    /// less than the margin on the way.
    fn contact(&self, axis: &Axis, gap: &TurnedGap) -> Option<Found> {
        let (pair, error) = (self.pair, self.error);
        let edge = axis.edge?;
        let (speed, fastest) = (-gap.slope(pair, axis.owner), pair.speed(axis.owner));
        if speed <= GRAZE * fastest {
            return None;
        }
        let hi = (gap.t + (gap.value + 4.0 * error) / speed).next_up();
        let length = hi - gap.t;
        let margin = fastest * length + error;
        let (from, to) = self.ends(axis, edge);
        let (place, _) = gap.place(pair, axis.owner);
        let proved = hi <= 1.0
            && length * speed <= self.allowed
            && pair.acceleration(axis.owner) * length * length <= error
            && place >= from + margin
            && place <= to - margin;
        let near = DifferenceFeature::Edge(DifferenceEdge { source: axis.owner, edge, vertex: gap.lowest });
        proved.then_some(Found::Hit(Enclosure { lo: gap.t, hi }, near))
    }
}

#[cfg(test)]
mod tests;
