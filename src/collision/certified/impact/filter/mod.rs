//! Filter of the first contact: doubles find it first, and prove afterwards that it is one, and the first.
//!
//! From the closest features at a moment comes an axis ([`axes`]); where its gap is used up, a few steps of a
//! series tell ([`gap_series`]). If a vertex then meets the edge that the axis is square to, that is the
//! contact; else the next axis is asked for there, and so on. Nothing of this is proved yet: [`certificate`]
//! does that from the end, with the axes used, and [`touch`] proves how the bodies stand just before.
//! Whatever is not clear is left to the search.

mod axes;
mod certificate;
pub(in crate::collision::certified) mod gap_series;
mod touch;

use crate::collision::answer::Outcome;
use crate::collision::certified::impact::axis::{Axis, AxisSpan};
use crate::collision::certified::impact::closest::separation_at;
use crate::collision::certified::impact::filter::certificate::{AXES, Proof};
use crate::collision::certified::impact::filter::gap_series::{
    Instant, OpenAxis, TurnedGap, first_root, rounding,
};
use crate::collision::certified::impact::limits::Limits;
use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{Enclosure, perp};

/// Moments at which one axis is evaluated at most. Half decide 56 random pairs fewer, twice 17 more: those
/// that turn several times along one axis.
const EVALUATIONS: usize = 48;

/// No step of a series turns the bodies by more than this together, in radians: the fifth order leaves out a
/// hundredth of the reach then. Half decides 57 random pairs fewer with 29 % more gaps, twice 11 more with 15
/// % fewer: most of these pairs turn by several radians.
const LARGEST_TURN: f64 = 1.0;

/// At a series' root nearer than this, in radians, the foot of the vertex on the edge is foretold; with room
/// for this part of the edge and of its way. Half decides 5 random pairs more and one hard one fewer, twice
/// the reverse.
const FORESEEN: f64 = 0.25;

/// The filter's search ends with a gap between these, in roundings, and aims between them. Below the lower
/// end the gap would not be proved open, a wider band makes time bounds wider. Half and twice of its width
/// decide one hard pair more or less.
const BAND: std::ops::Range<f64> = 1.25..4.0;

/// Where inside [`BAND`] a step aims, in roundings: near the middle, so that a small miss on either side
/// still ends the search. Anywhere in it is as good to a thousandth.
const AIM: f64 = 2.5;

/// A closing speed below this part of the largest speed is a graze: above it, its rounding is below 1e-8 of
/// it. A hundredth of it is not noticed, a hundred times decides 6 hard pairs fewer.
const GRAZE: f64 = 1e-6;

/// What the filter can say of a pair.
pub(crate) struct Filtered {
    /// The first contact or that there is none, proved; None where that is left to the search.
    pub(crate) outcome: Option<Outcome>,
    /// Distance queries made.
    pub(crate) queries: usize,
}

/// The first contact of a pair, where doubles find it and prove it; the axes of the proof are reported in
/// order of time.
pub(crate) fn first_contact(pair: &MovingPair, limits: Limits, report: impl FnMut(AxisSpan)) -> Filtered {
    let mut finder = Finder::new(pair, limits.allowed(), limits.max_queries);
    let found = finder.run();
    if found.is_some() {
        finder.proof.spans().copied().for_each(report);
    }
    let outcome = found.map(|found| match found {
        Found::Miss => Outcome::Miss,
        Found::Hit(time, near) => {
            let [a, b] = pair.bodies;
            let contact =
                touch::separation(a, b, time.lo, near).unwrap_or_else(|| separation_at(a, b, time.lo, near));
            Outcome::Hit { time, contact }
        }
    });
    Filtered { outcome, queries: finder.queries }
}

/// What the filter found.
enum Found {
    /// A contact: the bounds of its time, and the edge that is met with the vertex that meets it.
    Hit(Enclosure, DifferenceFeature),
    /// No contact in [0, 1].
    Miss,
}

/// A search in doubles, and the proof of what it found.
struct Finder<'p, 'q> {
    /// The two bodies in motion.
    pair: &'p MovingPair<'q>,
    /// Bound on the error of a gap.
    error: f64,
    /// Width of the time bounds times the closing speed that contact may leave.
    allowed: f64,
    /// Distance queries that may be made.
    limit: usize,
    /// Distance queries made.
    queries: usize,
    /// The axes that are proved to separate the bodies.
    proof: Proof<'p, 'q>,
}

/// When an axis is used up.
enum UsedUp {
    /// Not in [0, 1]; its gap at t = 1.
    Never(TurnedGap),
    /// At this moment, with this gap, which is in [`BAND`].
    At(Instant, TurnedGap),
    /// About this moment, by this vertex of the other body, which does not come down on the axis's edge.
    About(Instant, usize),
}

impl<'p, 'q> Finder<'p, 'q> {
    /// A search that may leave time bounds as wide as `allowed` over the closing speed.
    fn new(pair: &'p MovingPair<'q>, allowed: f64, limit: usize) -> Self {
        let error = rounding(pair);
        Self { pair, error, allowed, limit, queries: 0, proof: Proof::new(pair, error) }
    }

    /// The first contact, proved.
    fn run(&mut self) -> Option<Found> {
        if self.pair.unit != 1.0 || self.allowed < 2.0 * BAND.end * self.error {
            return None;
        }
        let mut axes: [Option<OpenAxis>; AXES] = [None; AXES];
        let mut open = self.axis_of_closest(&Instant::start(self.pair), None)?;
        let mut asked = true;
        for round in 0..AXES {
            axes[round] = Some(open);
            let mut next = None;
            for foresight in [true, false] {
                let (then, vertex) = match self.follow(&open, foresight)? {
                    UsedUp::Never(last) => {
                        self.proof.reach(&axes[..=round], last)?;
                        return Some(Found::Miss);
                    }
                    UsedUp::About(then, vertex) => (then, vertex),
                    UsedUp::At(then, last) => {
                        if let Some(hit) = self.contact(&open.axis, &last) {
                            self.proof.reach(&axes[..=round], last)?;
                            return Some(hit);
                        }
                        (then, last.lowest)
                    }
                };
                let beside = if asked { self.axis_beside(&open.axis, vertex, &then) } else { None };
                asked = beside.is_none();
                next = beside.or_else(|| self.axis_of_closest(&then, Some(&open)));
                if next.is_some() {
                    break;
                }
            }
            open = next?;
        }
        None
    }

    /// Follows an axis from the moment of its open gap to where it is used up. With foresight it stops as
    /// soon as the series says that the vertex will not come down on the axis's edge.
    fn follow(&self, OpenAxis { axis, gap: start }: &OpenAxis, foresight: bool) -> Option<UsedUp> {
        let (pair, error) = (self.pair, self.error);
        let rates = pair.rate[0].abs() + pair.rate[1].abs();
        let largest = LARGEST_TURN / rates;
        let (mut lo, mut hi, mut closed) = (start.t, 1.0, false);
        let mut gap = *start;
        for _ in 0..EVALUATIONS {
            let mut series = gap.series(pair, axis.owner);
            series[0] -= AIM * error;
            let next = if gap.value >= BAND.end * error {
                lo = gap.t;
                if lo >= 1.0 {
                    return Some(UsedUp::Never(gap));
                }
                let limit = largest.min(hi - lo);
                let step = first_root(&series, limit);
                if foresight
                    && let Some(h) = step
                    && h * rates < FORESEEN
                    && !self.may_touch(axis, &gap, h)
                {
                    return Some(UsedUp::About(Instant::new(pair, lo + h), gap.lowest));
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
                return Some(UsedUp::At(at, gap));
            }
        }
        None
    }

    /// Whether the vertex that faces the axis's edge may be above it a time h later; with some room.
    fn may_touch(&self, axis: &Axis, gap: &TurnedGap, h: f64) -> bool {
        let Some(edge) = axis.edge else { return false };
        let (from, to) = self.ends(axis, edge);
        let (foot, speed) = gap.foot(self.pair, axis.owner);
        let (then, room) = (foot + speed * h, FORESEEN * ((to - from) + (speed * h).abs()));
        then > from - room && then < to + room
    }

    /// The ends of an axis's edge along perp(n).
    fn ends(&self, axis: &Axis, edge: usize) -> (f64, f64) {
        let hull = self.pair.hull(axis.owner);
        let along = perp(axis.n);
        (along.dot(hull.vertices[edge]), along.dot(hull.vertices[hull.next(edge)]))
    }

    /// The contact that is proved just after the moment of a gap that is all but used up.
    ///
    /// The vertex is outside the edge's line now. By `hi` it has crossed it: f + G − h |f'| + ½ K h² ≤ 0. It
    /// moves by less than the margin on the way.
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
        let (foot, _) = gap.foot(pair, axis.owner);
        let proved = hi <= 1.0
            && length * speed <= self.allowed
            && pair.acceleration(axis.owner) * length * length <= error
            && foot >= from + margin
            && foot <= to - margin;
        let near = DifferenceFeature::Edge(DifferenceEdge { source: axis.owner, edge, vertex: gap.lowest });
        proved.then_some(Found::Hit(Enclosure { lo: gap.t, hi }, near))
    }
}

#[cfg(test)]
mod tests;
