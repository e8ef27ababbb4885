//! The edge of B ⊖ A that is nearest the origin, kept while the edges come by.
//!
//! Outside B ⊖ A the answer is the least positive of the signed distances to its edges, inside the least
//! penetrating one, the negative number closest to 0. One rule compares any two: outside beats inside, then
//! the nearer one wins.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section OBB vs OBB: "we are interested in
//! the least penetrating distance", then in the least positive one.

use crate::collision::algorithm::candidate::Candidate;
use crate::collision::algorithm::outline::Projection;
use crate::collision::algorithm::view::PairView;
use crate::geometry::Feature;
use crate::trace::{Event, Goal};

/// The best of the projections that were offered so far, with the signed distance that it was offered with.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct NearestEdge {
    /// The best projection with its distance; None before the first offer.
    best: Option<(f64, Projection)>,
}

/// What became of a projection that was offered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Offer {
    /// It is the best so far.
    Improves,
    /// An earlier one is as good or better.
    Loses,
}

impl NearestEdge {
    /// Keeps a projection if its signed distance, in world units and positive outside, beats all before it.
    #[inline]
    pub(crate) fn offer(&mut self, distance: f64, projection: Projection) -> Offer {
        if self.best.is_none_or(|(best, _)| is_better(distance, best)) {
            self.best = Some((distance, projection));
            Offer::Improves
        } else {
            Offer::Loses
        }
    }

    /// The best of all; None where there was no edge, since both cores are points.
    pub(crate) fn found(self) -> Option<Projection> {
        self.best.map(|(_, projection)| projection)
    }

    /// The features that face each other: those of the best, or the two points that have no edge between
    /// them.
    pub(crate) fn candidate(self, pair: &PairView) -> Candidate {
        match self.found() {
            Some(projection) => Candidate::of_projection(pair, &projection),
            None => Candidate::of_vertices(pair, 0, 0),
        }
    }
}

/// Whether a signed distance beats another: any outside beats inside, then the nearer one wins. 0 counts as
/// outside.
fn is_better(distance: f64, than: f64) -> bool {
    match (distance >= 0.0, than >= 0.0) {
        (true, true) => distance < than,
        (outside, true) => outside,
        (_, false) => distance > than,
    }
}

/// A better candidate, as an event.
pub(crate) fn improved(pair: &PairView, p: &Projection) -> Event {
    let goal = if p.distance < 0.0 { Goal::LeastPenetrating } else { Goal::LeastPositive };
    let source = (p.edge.source, Feature::Edge(pair.file_edge(p.edge.source, p.edge.edge)));
    Event::CandidateImproved { goal, distance: p.distance, foot: pair.world_vector(p.foot), source }
}

#[cfg(test)]
mod tests {
    use super::is_better;

    #[test]
    fn outside_beats_inside_and_the_nearer_one_wins() {
        let order = [0.0, 1.0, 2.0, -0.5, -1.0];
        for (k, &x) in order.iter().enumerate() {
            assert!(!is_better(x, x), "{x}");
            assert!(order[k + 1..].iter().all(|&worse| is_better(x, worse) && !is_better(worse, x)), "{x}");
        }
    }
}
