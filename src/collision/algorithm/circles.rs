//! Circle against circle.
//!
//! Two circles overlap when their centres are closer than the sum of their radii. Squared, that needs no
//! root:
//!
//! ```text
//! ‖A − B‖² < (r₁ + r₂)²
//! p = ‖A − B‖ − (r₁ + r₂)      N = (A − B)/‖A − B‖      P = N p
//! ```
//!
//! p is the signed separation, N the article's normal, from B to A (ours, n, is −N), and P moves B until the
//! two just touch. Where the centres coincide N does not exist: every direction parts them as well as
//! another, the normal is the world's x axis and `ties` is 0.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section Circle vs circle.

use crate::collision::algorithm::candidate::{self, Candidate};
use crate::collision::algorithm::outline;
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops};
use crate::collision::{Answer, Overlap, Query, QueryKind};
use crate::geometry::{Enclosure, Side};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "circles",
    about: "circle against circle: squared early-out, p, N and P (Firth 2011, Circle vs circle)",
    kinds: DISCRETE,
    shapes,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Takes two circles, and no other shapes.
fn shapes(query: &Query) -> Result<(), &'static str> {
    let round = |body: &crate::geometry::Body| body.shape.core.len() == 1;
    match query.b {
        Some(b) if round(query.a) && round(b) => Ok(()),
        _ => Err("takes two circles"),
    }
}

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = PairView::start(query, ALGORITHM.name, tracer);
    outline::tell(&pair, tracer);
    if query.kind == QueryKind::Overlap
        && let Some(settled) = squared_test(&pair, tracer)
    {
        tracer.record(|| Event::Finished { outcome: settled.word() });
        return Answer::Overlap(settled);
    }
    if query.kind != QueryKind::Overlap {
        tell_comparison(&pair, false, tracer);
    }
    let candidate = Candidate::of_vertices(&pair, 0, 0);
    let separation = candidate::conclude(&pair, &candidate, tracer);
    tracer.record(|| Event::PenetrationMeasured {
        p: separation.separation,
        direction: -*separation.normal,
        vector: -separation.normal * separation.separation,
    });
    candidate::finish(query.kind, separation, tracer)
}

/// The verdict of the squares, where they differ by more than their rounding.
///
/// With d = ‖A − B‖, R = r₁ + r₂ and the 1-norm m ≥ d, the separation d − R = (d² − R²)/(d + R) is bounded
/// without a root by (d² − R²)/(m + R).
///
/// With e the error of d, that of d² − R² is at most 2 (m + R) e + e² and 8 roundings of (m + R)², which are
/// all below 4 (m + R) e, since e is no less than 16 ε (m + R).
fn squared_test(pair: &PairView, tracer: &mut impl Tracer) -> Option<Overlap> {
    let v = pair.vertex(Side::B, 0) - pair.vertex(Side::A, 0);
    let radius = pair.radius();
    let reach = v.x.abs() + v.y.abs() + radius;
    let excess = v.length_squared() - radius * radius;
    let slack = 4.0 * pair.gap_error();
    let settled = excess.abs() > slack * reach;
    tell_comparison(pair, settled, tracer);
    let near = excess / reach;
    let separation_bounds = match (settled, excess > 0.0) {
        (false, _) => return None,
        (true, true) => Enclosure { lo: near - slack, hi: (reach - radius) - radius + slack },
        (true, false) => Enclosure { lo: -radius.next_up(), hi: near + slack },
    };
    Some(Overlap { overlap: Some(excess < 0.0), separation_bounds })
}

/// Tells both sides of the squared inequality, and whether it settled the question: the article's early-out.
fn tell_comparison(pair: &PairView, early_out: bool, tracer: &mut impl Tracer) {
    tracer.record(|| {
        let centers = [pair.told(Side::A, 0).point, pair.told(Side::B, 0).point];
        let v = pair.vertex(Side::B, 0) - pair.vertex(Side::A, 0);
        Event::CirclesCompared {
            centers,
            radii: [pair.a.shape.radius, pair.b.shape.radius],
            distance_squared: v.length_squared(),
            radii_squared: pair.radius() * pair.radius(),
            early_out,
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{placed, polygon};
    use crate::trace::Trace;

    /// The verdict on two circles of radius 1, and whether the squares settled it.
    fn overlap(apart: f64) -> (Overlap, bool) {
        let a = polygon(&[[0., 0.]], 1.0);
        let b = placed(polygon(&[[0., 0.]], 1.0), apart, 0., 0.);
        let kind = QueryKind::Overlap;
        let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let mut trace = Trace::default();
        let Answer::Overlap(found) = answer(&query, &mut trace) else { panic!("{trace:?}") };
        (found, trace.events.iter().any(|e| matches!(e, Event::CirclesCompared { early_out: true, .. })))
    }

    #[test]
    fn squares_settle_what_is_clear() {
        for (apart, expected) in [(2.5, false), (1.5, true), (0.0, true)] {
            let (found, early) = overlap(apart);
            assert_eq!((found.overlap, early), (Some(expected), true));
            let bounds = found.separation_bounds;
            assert!(bounds.lo <= apart - 2.0 && apart - 2.0 <= bounds.hi, "{bounds:?}");
        }
    }

    #[test]
    fn squares_settle_a_gap_of_two_hundred_ulp_and_leave_one_of_ten() {
        assert!(overlap(2.0 + 400.0 * f64::EPSILON).1);
        let (found, early) = overlap(2.0 + 20.0 * f64::EPSILON);
        assert_eq!((found.overlap, early), (Some(false), false));
    }

    #[test]
    fn touching_is_overlap_and_needs_the_root() {
        let (found, early) = overlap(2.0);
        assert_eq!((found.overlap, early), (Some(true), false));
        assert_eq!((found.separation_bounds.lo, found.separation_bounds.hi), (0.0, 0.0));
    }
}
