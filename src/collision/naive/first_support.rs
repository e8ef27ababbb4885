//! B ⊖ A with one supporting vertex for each edge, the first, where there may be two.
//!
//! Where edges of A and B are parallel, two vertices are equally far, and the edge of B ⊖ A is as long as
//! both edges together. With one of the two it is cut short, so that the origin projects beside the rest.

use crate::collision::QueryKind;
use crate::geometry::{Body, DVec2};

use super::bodies::{Placed, both};
use super::outline::claim_of_edges;
use super::{Claim, Naive};

pub(super) const NAIVE: Naive =
    Naive { name: "first-support", kinds: &[QueryKind::Separation, QueryKind::Overlap], claims };

fn claims(bodies: [&Body; 2], time: f64) -> Option<Claim> {
    let [a, b] = &both(bodies, time)?;
    claim_of_edges(&edges(a, b), a.radius + b.radius)
}

/// The edges of B ⊖ A, each from one supporting vertex.
fn edges(a: &Placed, b: &Placed) -> Vec<[DVec2; 2]> {
    let of = |body: &Placed| -> Vec<(DVec2, DVec2)> {
        let next = body.core.iter().cycle().skip(1);
        body.core.iter().copied().zip(next.copied()).filter(|(p, q)| p != q).collect()
    };
    let of_a = of(a).into_iter().zip(a.normals()).map(|((p, q), n)| {
        let support = b.support(-n);
        [support - p, support - q]
    });
    let of_b = of(b).into_iter().zip(b.normals()).map(|((p, q), n)| {
        let support = a.support(-n);
        [p - support, q - support]
    });
    of_a.chain(of_b).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Pair;
    use crate::collision::tests::bodies::{boxed, placed};

    /// What is claimed of two boxes, the second above the first and turned, and what is proved.
    fn boxes(x: f64, y: f64, angle: f64) -> (f64, f64) {
        let (a, b) = (boxed("box", 1., 1.), placed(boxed("box", 1., 1.), x, y, angle));
        let Some(Claim::Separation(claimed, _)) = claims([&a, &b], 0.0) else { panic!() };
        (claimed, Pair::at(&a, &b, 0.0).separation().separation)
    }

    #[test]
    fn parallel_edges_lose_half_of_theirs() {
        let (claimed, proved) = boxes(-0.5, 3.0, 0.0);
        assert!((proved - 1.0).abs() < 1e-12 && claimed > 1.1, "{claimed}, {proved}");
        // On the other side the first of the two is the right one.
        let (claimed, proved) = boxes(0.5, 3.0, 0.0);
        assert!((claimed - proved).abs() < 1e-12, "{claimed}, {proved}");
    }

    #[test]
    fn no_edge_is_lost_where_none_are_parallel() {
        for (x, y) in [(-0.5, 3.0), (0.7, -2.9), (3.5, 3.5), (0.5, 1.5)] {
            let (claimed, proved) = boxes(x, y, 20.0);
            assert!((claimed - proved).abs() < 1e-12, "{claimed}, {proved}");
        }
    }
}
