//! Lengths that a panel is about: an inset enlarges one that is too small to be seen.

use crate::drawing::{Rect, Shown};
use crate::geometry::DVec2;

use super::Sketch;

/// A length that the panel is about, which an inset enlarges where it is too small to see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Detail {
    /// The least rectangle about its points, page pixels.
    pub(crate) rect: Rect,
    /// When it comes and goes, as [`Sketched::cues`] have it.
    pub(crate) shown: Shown,
}

impl Sketch<'_> {
    /// Tells that the panel is about what lies between these points, drawn now.
    pub(crate) fn detail(&mut self, points: &[DVec2]) -> &mut Self {
        let page = points.iter().map(|&p| self.frame.page(p));
        let rect = page.map(|p| Rect::new(p, p)).reduce(Rect::union);
        let shown = self.cues.now;
        self.details.extend(rect.map(|rect| Detail { rect, shown }));
        self
    }
}
