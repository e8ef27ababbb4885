//! What a group is cut off at: a rectangle, with corners as round as those of the ground that it lies on.

use std::f64::consts::FRAC_1_SQRT_2;

use super::{Contour, Rect};

/// A rectangle outside which nothing of a group is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// The rectangle, in page pixels.
    pub rect: Rect,
    /// The radius of its corners, in page pixels; 0 for square ones, and half of the shorter side at most.
    pub radius: f64,
}

impl From<Rect> for Clip {
    /// The rectangle with square corners.
    fn from(rect: Rect) -> Self {
        Self { rect, radius: 0.0 }
    }
}

impl Clip {
    /// The rectangle with corners of a `radius`; of less, where it is too small for that.
    ///
    /// ```
    /// use tracefig::drawing::{Clip, Rect};
    /// let rect = Rect { x0: 0.0, y0: 0.0, x1: 90.0, y1: 12.0 };
    /// assert_eq!(Clip::rounded(rect, 8.0).radius, 6.0);
    /// assert_eq!(Clip::from(rect).radius, 0.0);
    /// ```
    #[must_use]
    pub fn rounded(rect: Rect, radius: f64) -> Self {
        Self { rect, radius: radius.min(0.5 * rect.width()).min(0.5 * rect.height()).max(0.0) }
    }

    /// The line around it.
    ///
    /// ```
    /// use tracefig::drawing::{Clip, Contour, Rect};
    /// let rect = Rect { x0: 0.0, y0: 0.0, x1: 90.0, y1: 12.0 };
    /// assert_eq!(Clip::rounded(rect, 4.0).contour(), Contour::rounded(rect, 4.0));
    /// ```
    #[must_use]
    pub fn contour(self) -> Contour {
        Contour::rounded(self.rect, self.radius)
    }

    /// Whether it surely cuts nothing off what lies in `bounds`.
    pub(crate) fn spares(self, bounds: Rect) -> bool {
        // The largest square corner that fits into a round one is this far from both sides.
        let rect = self.rect.grown(-self.radius * (1.0 - FRAC_1_SQRT_2));
        rect.union(bounds) == rect
    }

    /// What is in both: the inner one's corners stay, as it lies in the outer one wherever we draw it.
    pub(crate) fn inside(self, outer: Self) -> Option<Self> {
        let rect = self.rect.intersection(outer.rect)?;
        let radius = if rect == outer.rect { outer.radius } else { self.radius };
        Some(Self::rounded(rect, radius))
    }

    /// How far a corner takes a row in from the left and right, in a row that far from the rectangle's nearer
    /// end: nothing beyond the radius.
    pub(crate) fn taken(self, from_end: f64) -> f64 {
        let off = (self.radius - from_end).clamp(0.0, self.radius);
        self.radius - (self.radius * self.radius - off * off).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: Rect = Rect { x0: 0.0, y0: 0.0, x1: 20.0, y1: 20.0 };

    #[test]
    fn what_reaches_into_a_corner_is_not_spared() {
        let clip = Clip::rounded(SQUARE, 10.0);
        let disc = |half: f64| Rect { x0: 10.0 - half, y0: 10.0 - half, x1: 10.0 + half, y1: 10.0 + half };
        // The square in a circle of radius 10 has half a side of 7.07.
        assert!(clip.spares(disc(7.0)) && !clip.spares(disc(7.1)));
        assert!(Clip::from(SQUARE).spares(SQUARE));
    }

    #[test]
    fn a_corner_takes_what_a_circle_leaves() {
        let clip = Clip::rounded(SQUARE, 10.0);
        assert_eq!([0.0, 10.0, 15.0].map(|y| clip.taken(y)), [10.0, 0.0, 0.0]);
        assert!((clip.taken(4.0) - 2.0).abs() < 1e-12, "8² + 6² = 10²");
        assert_eq!(Clip::from(SQUARE).taken(0.0), 0.0);
    }

    #[test]
    fn a_clip_in_a_clip_keeps_its_corners() {
        let outer = Clip::rounded(SQUARE, 4.0);
        let inner = Clip::from(Rect { x0: 5.0, y0: 5.0, x1: 9.0, y1: 30.0 });
        let both = inner.inside(outer).unwrap();
        assert_eq!((both.rect.y1, both.radius), (20.0, 0.0));
        assert_eq!(Clip::from(Rect { x0: -1.0, y0: -1.0, x1: 99.0, y1: 99.0 }).inside(outer), Some(outer));
        assert_eq!(inner.inside(Clip::from(Rect { x0: 50.0, ..SQUARE })), None);
    }
}
