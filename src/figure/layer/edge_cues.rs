//! With which event each edge of B ⊖ A comes, and the whole of it.

use std::collections::BTreeMap;

use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::difference::Edge;
use crate::geometry::DVec2;
use crate::trace::Event;

/// The cues of B ⊖ A at one moment.
pub(super) struct EdgeCues {
    /// The cue of each edge, by the bits of its ends.
    edges: BTreeMap<[u64; 4], Cue>,
    /// The cue of the whole.
    pub(super) whole: Option<Cue>,
}

impl EdgeCues {
    /// The cues at a time in [0, 1].
    pub(super) fn at(context: &Context, time: f64) -> Self {
        let Some(run) = context.difference_at(time) else {
            return Self { edges: BTreeMap::new(), whole: None };
        };
        let ends = |event: &Event| match *event {
            Event::DifferenceEdgeFound { from, to, .. } => Some(key(from, to)),
            _ => None,
        };
        // Where an edge is told again, it was there already.
        let mut edges = BTreeMap::new();
        for (cue, key) in run.cues(ends) {
            edges.entry(key).or_insert(cue);
        }
        Self { edges, whole: run.whole_difference() }
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
