//! With which event each edge of B ⊖ A comes, and the whole of it.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::{Cue, Teller};
use crate::figure::difference::Edge;
use crate::figure::sketch::{Pen, Sketch};
use crate::geometry::{DVec2, sorted};
use crate::trace::Event;

/// The width of the line that shows an edge as new, page pixels: it is seen on both sides of the edge's own.
const NEW: f64 = 9.0;
/// Its opacity: which body an edge comes from is seen through it.
const SOFT: f64 = 0.4;
/// The most edges that are shown as new.
const MOST_IN_TURN: usize = 40;

/// The cues of B ⊖ A at one moment.
pub(super) struct EdgeCues {
    /// Each edge by the bits of its ends, with its cue, as they were told.
    told: Vec<([u64; 4], Cue)>,
    /// Places in that list, by the bits; of an edge that is told again, which was there already, the first
    /// place comes first.
    sorted: Vec<usize>,
    /// The cue of the whole.
    pub(super) whole: Option<Cue>,
}

impl EdgeCues {
    /// The cues at a time in [0, 1].
    pub(super) fn at(context: &Context, time: f64) -> Self {
        let Some(run) = context.difference_at(time) else {
            return Self { told: Vec::new(), sorted: Vec::new(), whole: None };
        };
        let ends = |event: &Event| match *event {
            Event::DifferenceEdgeFound { from, to, .. } => Some(key(from, to)),
            _ => None,
        };
        let told: Vec<([u64; 4], Cue)> = run.cues(ends).map(|(cue, key)| (key, cue)).collect();
        let sorted = sorted(told.len(), &|i, j| told[i].0.cmp(&told[j].0));
        Self { told, sorted, whole: run.whole_difference() }
    }

    /// Where an edge was first told.
    fn first_told(&self, edge: [u64; 4]) -> Option<usize> {
        let before = self.sorted.partition_point(|&place| self.told[place].0 < edge);
        self.sorted.get(before).copied().filter(|&place| self.told[place].0 == edge)
    }

    /// The cue of the first edge; that of the whole where no event told one.
    pub(super) fn first(&self) -> Option<Cue> {
        self.told.first().map(|(_, cue)| *cue).or(self.whole)
    }

    /// Draws each of some edges in turn, by its two ends, as what is new until the next one comes: in steps
    /// alone, and of those that the eye can follow.
    pub(super) fn told_in_turn(
        &self,
        sketch: &mut Sketch,
        edges: &[Edge],
        ends: impl Fn(&Edge) -> (DVec2, DVec2),
    ) {
        let all =
            self.told.iter().enumerate().filter(|(place, told)| self.first_told(told.0) == Some(*place));
        // What another algorithm knows is given as a whole.
        let all = all.map(|(_, told)| told).filter(|(_, cue)| cue.teller == Teller::Own);
        let mut all = all.take(MOST_IN_TURN).peekable();
        while let Some(&(own, since)) = all.next() {
            let edge = edges.iter().find(|edge| key(edge.from, edge.to) == own);
            let until = all.peek().map(|told| told.1).or(self.whole);
            if let (Some(edge), Some(until)) = (edge, until) {
                let (from, to) = ends(edge);
                sketch.passing([since, until], |sketch| {
                    sketch.part("new").line(from, to, Pen::highlighted(Role::Now).width(NEW).opacity(SOFT));
                });
            }
        }
    }

    /// The cue of an edge; that of the whole where no event told it so.
    pub(super) fn of(&self, edge: &Edge) -> Option<Cue> {
        let first = self.first_told(key(edge.from, edge.to));
        first.map(|place| self.told[place].1).or(self.whole)
    }
}

/// What tells an edge from others: the bits of its ends.
fn key(from: DVec2, to: DVec2) -> [u64; 4] {
    [from.x, from.y, to.x, to.y].map(f64::to_bits)
}
