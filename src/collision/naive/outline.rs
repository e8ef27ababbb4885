//! What a method claims that has found edges of B ⊖ A: how far the origin is from them.

use crate::geometry::DVec2;

use super::Claim;

/// The claim of edges in a ring, counter-clockwise, of bodies whose radii are so much together. Outside of
/// one edge the nearest point of all counts, inside of all the nearest line; `None` without an edge.
pub(super) fn claim_of_edges(edges: &[[DVec2; 2]], radii: f64) -> Option<Claim> {
    let (mut nearest, mut inside): (Option<DVec2>, Option<(f64, DVec2)>) = (None, None);
    for &[from, to] in edges {
        let edge = to - from;
        let foot = from + edge * (-from.dot(edge) / edge.dot(edge)).clamp(0.0, 1.0);
        if nearest.is_none_or(|known| foot.length() < known.length()) {
            nearest = Some(foot);
        }
        // Along n, from A to B, the gap between the bodies; B ⊖ A is on the other side of this edge.
        let n = DVec2::new(-edge.y, edge.x) / edge.length();
        let gap = from.dot(n);
        if inside.is_none_or(|(known, _)| gap > known) {
            inside = Some((gap, n));
        }
    }
    let (gap, n) = inside?;
    if gap < 0.0 {
        return Some(Claim::Separation(gap - radii, n));
    }
    let foot = nearest?;
    let n = foot / foot.length();
    Some(if n.is_finite() { Claim::Separation(foot.length() - radii, n) } else { Claim::Nothing })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is claimed of a square of edge 2 around a point.
    fn square(x: f64, y: f64) -> Option<Claim> {
        let ring = [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]].map(|[dx, dy]| DVec2::new(x + dx, y + dy));
        let edges: Vec<_> = (0..4).map(|i| [ring[i], ring[(i + 1) % 4]]).collect();
        claim_of_edges(&edges, 0.5)
    }

    #[test]
    fn the_origin_is_outside_inside_or_on_a_vertex() {
        assert_eq!(square(3.0, 0.0), Some(Claim::Separation(1.5, DVec2::X)));
        assert_eq!(square(0.5, 0.0), Some(Claim::Separation(-1.0, DVec2::X)));
        assert_eq!(square(1.0, 1.0), Some(Claim::Nothing));
        assert_eq!(claim_of_edges(&[], 0.5), None);
    }
}
