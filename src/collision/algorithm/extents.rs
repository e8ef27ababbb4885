//! AABB against AABB, axis by axis.
//!
//! ```text
//! D = |c_B − c_A| − (h_A + h_B)      overlap = D_x < 0 and D_y < 0
//! ```
//!
//! One positive component is a gap: apart. With both negative the boxes overlap, and the axis of the larger D
//! is the shorter way out. That is the minimum translation a reader of the article asks for: move B by |D| on
//! that axis, away from A. (Here touching, D = 0, counts as overlap too.) Apart on both axes, the nearest
//! features are vertices and the distance is ‖D‖. Coincident centres are moved apart towards +x, or +y where
//! that is shorter.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section AABB vs AABB, and the comments.

use crate::collision::algorithm::candidate::{self, Candidate, CoreFeature};
use crate::collision::algorithm::outline;
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops};
use crate::collision::{Answer, Query};
use crate::geometry::{Body, DVec2, Side, length};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "extents",
    about: "AABB against AABB: D by component and the minimum translation (Firth 2011, AABB vs AABB)",
    kinds: DISCRETE,
    shapes,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Takes two AABBs, and no other shapes.
fn shapes(query: &Query) -> Result<(), &'static str> {
    let aabb = |body: &Body| body.shape.kind == "aabb" && body.shape.core.len() == 4;
    match query.b {
        Some(b) if aabb(query.a) && aabb(b) => Ok(()),
        _ => Err("takes two aabbs"),
    }
}

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = PairView::start(query, ALGORITHM.name, tracer);
    outline::tell(&pair, tracer);
    let half_extents = [Side::A, Side::B].map(|s| pair.vertex(s, 2) - pair.origin(s));
    let apart = pair.origin(Side::B);
    let gap = apart.abs() - (half_extents[0] + half_extents[1]);
    tracer.record(|| Event::ExtentsCompared {
        centers: [Side::A, Side::B].map(|s| pair.world_point(pair.origin(s))),
        half_extents,
        gap,
    });
    let separation = candidate::conclude(&pair, &candidate(apart, gap), tracer);
    candidate::finish(query.kind, separation, tracer)
}

/// The vertices or the edges that face each other, of boxes whose centres are `apart`, with this gap on each
/// axis.
fn candidate(apart: DVec2, gap: DVec2) -> Candidate {
    // Towards B on each axis; where the centres coincide, towards (+, +).
    let toward = DVec2::new(if apart.x >= 0.0 { 1.0 } else { -1.0 }, if apart.y >= 0.0 { 1.0 } else { -1.0 });
    if gap.x > 0.0 && gap.y > 0.0 {
        let distance = length(gap);
        let features = [toward, -toward].map(CoreFeature::box_vertex);
        return Candidate { distance, normal: gap * toward / distance, features };
    }
    let (distance, normal) =
        if gap.x >= gap.y { (gap.x, DVec2::new(toward.x, 0.0)) } else { (gap.y, DVec2::new(0.0, toward.y)) };
    Candidate { distance, normal, features: [normal, -normal].map(CoreFeature::box_edge) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, placed};
    use crate::collision::{QueryKind, Separation};
    use crate::geometry::Feature;
    use crate::trace::NoTrace;

    fn extents(a: &Body, b: &Body) -> Separation {
        let kind = QueryKind::Separation;
        let query = Query { kind, a, b: Some(b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        match answer(&query, &mut NoTrace) {
            Answer::Separation(s) => s,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_minimum_translation_is_along_the_axis_of_the_larger_gap() {
        let a = boxed("aabb", 4., 2.);
        let s = extents(&a, &placed(boxed("aabb", 1., 1.), -1., 2.5, 0.));
        // D = (1, 2.5) − (5, 3) = (−4, −0.5): up by 0.5.
        assert_eq!((s.separation, *s.normal), (-0.5, DVec2::Y));
        assert_eq!(s.features, [Feature::Edge(2), Feature::Edge(0)]);
    }

    #[test]
    fn apart_on_both_axes_vertices_face_each_other() {
        let a = boxed("aabb", 1., 1.);
        let s = extents(&a, &placed(boxed("aabb", 2., 1.), -6., 6., 0.));
        assert_eq!((s.separation, *s.normal), (5.0, DVec2::new(-0.6, 0.8)));
        assert_eq!(s.features, [Feature::Vertex(3), Feature::Vertex(1)]);
    }
}
