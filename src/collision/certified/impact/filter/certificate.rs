//! The proof that two bodies stay apart until a moment, put together backwards from the axes that a search
//! used.
//!
//! The last axis separates the bodies just before contact, and by the chord of
//! [`crate::collision::certified::impact::filter::gap_series`] for a long while before, often from t = 0 on.
//! Where it does not, the axis before takes over: each separates the bodies at the moment at which it was
//! found, so that between two such moments there is one at which both do.

use crate::collision::certified::impact::axis::{Axis, AxisSpan};
use crate::collision::certified::impact::filter::gap_series::{Instant, OpenAxis, TurnedGap};
use crate::collision::certified::impact::moving_pair::MovingPair;

/// Axes that a proof can be made of. Half as many decide 49 random pairs fewer, twice as many 48 more with 17
/// % more gaps.
pub(crate) const AXES: usize = 12;

/// Midpoints at which the gap between two moments is evaluated at most. Half decide two hard pairs fewer,
/// twice two more.
const MIDPOINTS: usize = 48;

/// Midpoints at most where another proof is at hand. Half and twice change the count of gaps by a thousandth.
const FEW_MIDPOINTS: usize = 2;

/// Times that a span is halved at most. Half decide 25 random and 8 hard pairs fewer, twice none more.
const HALVINGS: usize = 8;

/// Moments tried between two axes, to go over from one to the other. Neither half nor twice decides another
/// pair; twice costs 0.7 % more gaps.
const SPLITS: usize = 8;

/// Axes whose spans reach from the end back to the start, as far as they are proved.
pub(crate) struct Proof<'p, 'q> {
    /// The two bodies in motion.
    pair: &'p MovingPair<'q>,
    /// Bound on the error of a gap.
    error: f64,
    /// What is proved, the last axis first.
    spans: [Option<AxisSpan>; 2 * AXES],
    /// How many of them there are.
    count: usize,
}

impl<'p, 'q> Proof<'p, 'q> {
    /// Nothing proved yet; `error` bounds that of a gap.
    pub(crate) fn new(pair: &'p MovingPair<'q>, error: f64) -> Self {
        Self { pair, error, spans: [None; 2 * AXES], count: 0 }
    }

    /// Proves that the pair is apart from the start to the moment of `last`, a gap of the last of the axes;
    /// None where the proof is not found.
    pub(crate) fn reach(&mut self, axes: &[Option<OpenAxis>], last: TurnedGap) -> Option<()> {
        let (used, before) = axes.split_last()?;
        let OpenAxis { axis, gap: found } = (*used)?;
        let midpoints = if before.is_empty() { MIDPOINTS } else { FEW_MIDPOINTS };
        if let Some(first) = axis.turned_gap(self.pair, &Instant::start(self.pair), found.lowest)
            && self.is_open(&axis, first, last, midpoints)
        {
            self.add(axis, 0.0, last.t);
            return Some(());
        }
        if !self.is_open(&axis, found, last, MIDPOINTS) {
            return None;
        }
        self.add(axis, found.t, last.t);
        let mut later = OpenAxis { axis, gap: found };
        for earlier in before.iter().rev() {
            let earlier = (*earlier)?;
            self.go_over(earlier, later)?;
            later = earlier;
        }
        Some(())
    }

    /// The axes with their spans, in order of time.
    pub(crate) fn spans(&self) -> impl Iterator<Item = &AxisSpan> {
        self.spans[..self.count].iter().rev().flatten()
    }

    /// From the moment of one axis to that of the next.
    fn go_over(&mut self, earlier: OpenAxis, later: OpenAxis) -> Option<()> {
        let (OpenAxis { axis: before, gap: early }, OpenAxis { axis: after, gap: late }) = (earlier, later);
        let length = late.t - early.t;
        // The later axis may have opened only just before: half of the time since then, less and less.
        let opening = late.slope(self.pair, after.owner);
        let since = if opening > 0.0 { (late.value / opening).min(length) } else { length };
        let mut back = length;
        for _ in 0..SPLITS {
            let middle = (late.t - back).max(early.t);
            back = (0.125 * back).min(0.5 * since);
            let at = Instant::new(self.pair, middle);
            let then = after.turned_gap(self.pair, &at, late.lowest);
            if !then.is_some_and(|then| self.is_open(&after, then, late, MIDPOINTS)) {
                continue;
            }
            if middle <= early.t {
                self.add(after, middle, late.t);
                return Some(());
            }
            let until = before.turned_gap(self.pair, &at, early.lowest);
            if until.is_some_and(|until| self.is_open(&before, early, until, MIDPOINTS)) {
                self.add(after, middle, late.t);
                self.add(before, early.t, middle);
                return Some(());
            }
        }
        None
    }

    /// Puts an axis with its span before those that are proved already.
    fn add(&mut self, axis: Axis, from: f64, to: f64) {
        if let Some(Some(next)) = self.count.checked_sub(1).map(|k| &mut self.spans[k])
            && next.axis == axis
        {
            next.from = from;
        } else if self.count < self.spans.len() {
            self.spans[self.count] = Some(AxisSpan { axis, from, to });
            self.count += 1;
        }
    }

    /// Whether an axis is proved to separate the bodies between two of its gaps, with more of them between
    /// where the chord does not do.
    fn is_open(&self, axis: &Axis, from: TurnedGap, to: TurnedGap, midpoints: usize) -> bool {
        let mut left = from;
        let mut ahead = [to; HALVINGS];
        let (mut depth, mut used) = (1, 0);
        while depth > 0 {
            let right = ahead[depth - 1];
            if left.stays_open(&right, self.pair, axis.owner, self.error) {
                left = right;
                depth -= 1;
                continue;
            }
            if used >= midpoints || depth >= HALVINGS || left.value.min(right.value) <= self.error {
                return false;
            }
            let at = Instant::new(self.pair, 0.5 * (left.t + right.t));
            let Some(middle) = axis.turned_gap(self.pair, &at, left.lowest) else { return false };
            used += 1;
            ahead[depth] = middle;
            depth += 1;
        }
        true
    }
}
