//! A strictly convex core, prepared for queries: corners counter-clockwise, its sides' directions and normals.
//!
//! A point has one corner and no side; a segment two corners and two sides, there and back, which lets every algorithm
//! that walks round a polygon walk round a segment too.

use glam::DVec2;

/// The corners of a convex core in counter-clockwise order, and what follows from them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hull {
    /// Corners in the body's frame, exactly as written.
    pub corners: Vec<DVec2>,
    /// Side i runs from corner i to corner i + 1: their difference, each component within ε/2 of itself.
    pub sides: Vec<DVec2>,
    /// Outward unit normals of the sides; each component within 3ε.
    pub normals: Vec<DVec2>,
    /// Not below the distance of any corner from the body's origin.
    pub reach: f64,
}

impl Hull {
    /// Prepares corners that are strictly convex and counter-clockwise.
    #[must_use]
    pub(crate) fn new(corners: Vec<DVec2>) -> Self {
        let n = corners.len();
        let sides: Vec<DVec2> =
            if n < 2 { Vec::new() } else { (0..n).map(|i| corners[(i + 1) % n] - corners[i]).collect() };
        let normals = sides.iter().map(|&side| outward(side)).collect();
        let reach = corners.iter().fold(0.0, |reach: f64, &q| reach.max(length(q)));
        Self { corners, sides, normals, reach: reach * (1.0 + 4.0 * f64::EPSILON) }
    }

    /// Corner after `i`, counter-clockwise.
    #[inline]
    #[must_use]
    pub fn next(&self, i: usize) -> usize {
        if i + 1 == self.corners.len() { 0 } else { i + 1 }
    }

    /// Corner before `i`.
    #[inline]
    #[must_use]
    pub fn previous(&self, i: usize) -> usize {
        if i == 0 { self.corners.len() - 1 } else { i - 1 }
    }
}

/// A power of two near 1 / |v|, that keeps squares from overflowing or vanishing.
fn tamer(v: DVec2) -> f64 {
    let largest = v.x.abs().max(v.y.abs());
    if (1e-140..1e140).contains(&largest) {
        1.0
    } else if largest < 1e-140 {
        f64::from_bits((1023 + 1000) << 52)
    } else {
        f64::from_bits((1023 - 900) << 52)
    }
}

/// |v| to 2ε, without overflow or underflow.
fn length(v: DVec2) -> f64 {
    let k = tamer(v);
    let v = v * k;
    let length = (v.x * v.x + v.y * v.y).sqrt();
    if k < 1.0 { length / k } else { (length / k).next_up() }
}

/// The unit normal to the right of a side: outward where corners run counter-clockwise.
fn outward(side: DVec2) -> DVec2 {
    let v = side * tamer(side);
    if v.x == 0.0 {
        return DVec2::new(v.y.signum(), 0.0);
    }
    if v.y == 0.0 {
        return DVec2::new(0.0, -v.x.signum());
    }
    let length = (v.x * v.x + v.y * v.y).sqrt();
    DVec2::new(v.y / length, -v.x / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_has_two_sides_there_and_back() {
        let hull = Hull::new(vec![DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)]);
        assert_eq!(hull.normals, vec![DVec2::new(0.0, -1.0), DVec2::new(0.0, 1.0)]);
    }

    #[test]
    fn normals_are_unit_at_every_size() {
        for scale in [1e-320, 1e-200, 1.0, 1e200] {
            let hull = Hull::new(
                vec![DVec2::ZERO, DVec2::new(3.0, 0.0), DVec2::new(0.0, 4.0)]
                    .iter()
                    .map(|v| *v * scale)
                    .collect(),
            );
            for normal in &hull.normals {
                assert!((normal.x * normal.x + normal.y * normal.y - 1.0).abs() < 1e-3, "{scale}");
            }
            assert!(hull.reach >= 4.0 * scale);
        }
    }
}
