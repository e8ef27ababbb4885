//! The largest gap between projections on the normals of edges, taken for the distance.
//!
//! It is the depth of polygons that overlap. Between vertices it is a lower bound only, as no edge is square
//! to the way from vertex to vertex; and of round bodies not even the sign is right there: subtracting the
//! radii from a lower bound makes them overlap that are apart (Gottschalk, Lin and Manocha 1996 test for
//! overlap alone, and sharp boxes).

use crate::collision::QueryKind;
use crate::geometry::{Body, DVec2};

use super::bodies::{both, gap};
use super::{Claim, Naive};

pub(super) const NAIVE: Naive = Naive {
    name: "largest-gap",
    kinds: &[QueryKind::Separation, QueryKind::Overlap, QueryKind::Contact],
    claims,
};

fn claims(bodies: [&Body; 2], time: f64) -> Option<Claim> {
    let placed = both(bodies, time)?;
    let [a, b] = &placed;
    let axes: Vec<DVec2> = a.normals().chain(b.normals().map(|n| -n)).collect();
    let gaps = axes.into_iter().map(|n| (gap(&placed, n), n));
    let (gap, n) = gaps.reduce(|best, next| if next.0 > best.0 { next } else { best })?;
    Some(Claim::Separation(gap, n))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Pair;
    use crate::collision::tests::bodies::{boxed, placed, polygon};

    #[test]
    fn a_ball_at_a_vertex_is_said_to_overlap_a_box_that_it_is_apart_from() {
        let (a, b) = (boxed("box", 1., 1.), placed(polygon(&[[0., 0.]], 0.8), 1.7, 1.7, 0.));
        let Some(Claim::Separation(claimed, _)) = claims([&a, &b], 0.0) else { panic!() };
        let proved = Pair::at(&a, &b, 0.0).separation().bounds;
        assert!((claimed + 0.1).abs() < 1e-12 && proved.lo > 0.18, "{claimed}, {proved:?}");
    }

    #[test]
    fn it_is_the_depth_of_polygons_that_overlap() {
        let (a, b) = (boxed("box", 2., 1.), placed(boxed("box", 1., 1.), 2.5, 1.25, 30.));
        let Some(Claim::Separation(claimed, _)) = claims([&a, &b], 0.0) else { panic!() };
        let proved = Pair::at(&a, &b, 0.0).separation().separation;
        assert!(proved < -0.2 && (claimed - proved).abs() < 1e-12, "{claimed}, {proved}");
    }
}
