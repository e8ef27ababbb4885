//! With which event each edge of B ⊖ A comes, and the whole of it.

use std::collections::BTreeMap;

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::difference::Edge;
use crate::figure::sketch::{Pen, Sketch};
use crate::geometry::DVec2;
use crate::trace::Event;

/// The width of the line that shows an edge as new, page pixels: it is seen on both sides of the edge's own.
const NEW: f64 = 9.0;
/// Its opacity: which body an edge comes from is seen through it.
const SOFT: f64 = 0.4;
/// The most edges that are shown as new.
const MOST_IN_TURN: usize = 40;

/// The cues of B ⊖ A at one moment.
pub(super) struct EdgeCues {
    /// The cue of each edge, by the bits of its ends.
    edges: BTreeMap<[u64; 4], Cue>,
    /// The edges as they were told, by their ends.
    order: Vec<[u64; 4]>,
    /// The cue of the whole.
    pub(super) whole: Option<Cue>,
}

impl EdgeCues {
    /// The cues at a time in [0, 1].
    pub(super) fn at(context: &Context, time: f64) -> Self {
        let Some(run) = context.difference_at(time) else {
            return Self { edges: BTreeMap::new(), order: Vec::new(), whole: None };
        };
        let ends = |event: &Event| match *event {
            Event::DifferenceEdgeFound { from, to, .. } => Some(key(from, to)),
            _ => None,
        };
        // Where an edge is told again, it was there already.
        let (mut edges, mut order) = (BTreeMap::new(), Vec::new());
        for (cue, key) in run.cues(ends) {
            edges.entry(key).or_insert_with(|| {
                order.push(key);
                cue
            });
        }
        Self { edges, order, whole: run.whole_difference() }
    }

    /// The cue of the first edge; that of the whole where no event told one.
    pub(super) fn first(&self) -> Option<Cue> {
        self.order.first().and_then(|key| self.edges.get(key)).copied().or(self.whole)
    }

    /// Draws each of some edges in turn, by its two ends, as what is new until the next one comes: in steps
    /// alone, and of those that the eye can follow.
    pub(super) fn told_in_turn(
        &self,
        sketch: &mut Sketch,
        edges: &[Edge],
        ends: impl Fn(&Edge) -> (DVec2, DVec2),
    ) {
        let cue = |key: &[u64; 4]| self.edges.get(key).copied();
        for (k, own) in self.order.iter().enumerate().take(MOST_IN_TURN) {
            let edge = edges.iter().find(|edge| key(edge.from, edge.to) == *own);
            let until = self.order.get(k + 1).and_then(cue).or(self.whole);
            if let (Some(edge), Some(since), Some(until)) = (edge, cue(own), until) {
                let (from, to) = ends(edge);
                sketch.passing([since, until], |sketch| {
                    sketch.part("new").line(from, to, Pen::highlighted(Role::Now).width(NEW).opacity(SOFT));
                });
            }
        }
    }

    /// The cue of an edge; that of the whole where no event told it so.
    pub(super) fn of(&self, edge: &Edge) -> Option<Cue> {
        self.edges.get(&key(edge.from, edge.to)).copied().or(self.whole)
    }
}

/// What tells an edge from others: the bits of its ends.
fn key(from: DVec2, to: DVec2) -> [u64; 4] {
    [from.x, from.y, to.x, to.y].map(f64::to_bits)
}
