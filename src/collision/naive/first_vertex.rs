//! B ⊖ A merged from the edges of −A and B, from the first vertex of each.
//!
//! The walk takes the edge that turns less. It ends at a convex polygon if both lists begin at their lowest
//! vertex, as those do that come from a hull. Once a body has turned, another vertex is the lowest, edges
//! come out of their order, and the outline has dents.

use crate::collision::QueryKind;
use crate::geometry::DVec2;

use super::Naive;
use super::bodies::both;
use super::outline::claim_of_edges;

pub(super) const NAIVE: Naive = Naive {
    name: "first-vertex",
    kinds: &[QueryKind::Separation, QueryKind::Overlap],
    claims: |bodies, time| {
        let [a, b] = both(bodies, time)?;
        let mirrored: Vec<DVec2> = a.core.iter().map(|&v| -v).collect();
        claim_of_edges(&merged(&mirrored, &b.core), a.radius + b.radius)
    },
};

/// The edges of two polygons in one ring, each taken where it turns less than the other's next.
fn merged(a: &[DVec2], b: &[DVec2]) -> Vec<[DVec2; 2]> {
    let mut at = a.first().copied().unwrap_or(DVec2::ZERO) + b.first().copied().unwrap_or(DVec2::ZERO);
    let edge = |of: &[DVec2], k: usize| (k < of.len()).then(|| of[(k + 1) % of.len()] - of[k]);
    let (mut i, mut j, mut edges) = (0, 0, Vec::new());
    loop {
        let step = match (edge(a, i), edge(b, j)) {
            (Some(e), Some(f)) if e.perp_dot(f) == 0.0 => {
                (i, j) = (i + 1, j + 1);
                e + f
            }
            (Some(e), f) if f.is_none_or(|f| e.perp_dot(f) > 0.0) => {
                i += 1;
                e
            }
            (_, Some(f)) => {
                j += 1;
                f
            }
            _ => return edges,
        };
        if step != DVec2::ZERO {
            edges.push([at, at + step]);
        }
        at += step;
    }
}

#[cfg(test)]
mod tests {
    use super::super::Claim;
    use super::*;
    use crate::collision::Pair;
    use crate::collision::tests::bodies::{placed, polygon};

    /// What is claimed of two triangles of which the second is turned, and what is proved. The first of A's
    /// vertices is its highest, so that of −A the lowest, and the first of B's is its lowest.
    fn turned(degrees: f64) -> (f64, f64) {
        let a = polygon(&[[0., 2.], [-1., -1.], [2., -1.]], 0.0);
        let b = placed(polygon(&[[0., -2.], [2., 1.], [-1., 1.]], 0.0), 4.0, 0.0, degrees);
        let Some(Claim::Separation(claimed, _)) = (NAIVE.claims)([&a, &b], 0.0) else { panic!() };
        (claimed, Pair::at(&a, &b, 0.0).separation().separation)
    }

    #[test]
    fn what_begins_at_the_lowest_vertex_is_right_until_another_one_is() {
        let (claimed, proved) = turned(100.0);
        assert!((claimed - proved).abs() < 1e-12, "{claimed}, {proved}");
        let (claimed, proved) = turned(200.0);
        assert!((claimed - proved).abs() > 2.0, "{claimed}, {proved}");
    }
}
