//! Bodies, filled, and where two overlap a region of its own: two tints over each other would make a grey
//! that means neither.

use std::mem;

use crate::drawing::{Item, Path, Role};
use crate::geometry::Side;

use super::intersection::{Common, common};
use super::{Outline, Pen, Sketch, Wash};

/// The least width of a region, in widths of an outline, at which its colour is seen between the outlines
/// that lie over its edges: half of either lies in it.
const SEEN: f64 = 1.0;

/// The bodies that a panel filled so far.
#[derive(Default)]
pub(super) struct Bodies {
    /// Each with its line, in drawing order.
    filled: Vec<Filled>,
    /// What they share, in drawing order.
    shared: Vec<Outline>,
    /// Pairs of pieces that were looked at for what they share.
    looked: usize,
}

/// A body that a layer filled.
struct Filled {
    /// Whose it is.
    side: Side,
    /// Its outline, in the panel's space.
    outline: Outline,
    /// The line around it.
    pen: Pen,
}

impl Sketch<'_> {
    /// Draws a body: its area, its line, and over them what it shares with bodies of the other side that were
    /// drawn before; `outline` is in the panel's space.
    pub(crate) fn body(&mut self, side: Side, outline: &Outline, role: Role) -> &mut Self {
        let pen = Pen::outline(role);
        self.area(outline, Some(Wash::theme(role)), Some(pen));
        if self.is_full() {
            return self;
        }
        let (mut filled, mut looked) = (mem::take(&mut self.bodies.filled), self.bodies.looked);
        for other in filled.iter().filter(|other| other.side != side) {
            let shared = common(&other.outline, outline, &mut looked);
            if let Some(common) = shared.filter(|common| self.is_wide(&common.whole, pen)) {
                self.overlap(&common, [other.pen, pen]);
            }
        }
        filled.push(Filled { side, outline: outline.clone(), pen });
        (self.bodies.filled, self.bodies.looked) = (filled, looked);
        self
    }

    /// What bodies of different sides share that were drawn so far, in the panel's space, in drawing order.
    pub(crate) fn regions(&self) -> &[Outline] {
        &self.bodies.shared
    }

    /// Whether a region is wide enough to be seen between the lines of a pen around it.
    fn is_wide(&self, region: &Outline, pen: Pen) -> bool {
        let points = region.sampled();
        let length: f64 = points.windows(2).map(|w| (w[1] - w[0]).length()).sum();
        let area: f64 = points.windows(2).map(|w| 0.5 * (w[0] - points[0]).perp_dot(w[1] - points[0])).sum();
        // A long strip has an area of its width times half the way around it.
        self.on_page(2.0 * area / length) > SEEN * self.fitted(self.width(pen))
    }

    /// Draws a region that two bodies share, and over it those pieces of their lines that it hides by half.
    fn overlap(&mut self, common: &Common, pens: [Pen; 2]) {
        self.area(&common.whole, Some(Wash::faint(Role::Overlap, 1.0)), None);
        self.bodies.shared.push(common.whole.clone());
        for (lines, pen) in common.lines.iter().zip(pens) {
            for line in lines {
                let stroke = self.stroke_of(pen);
                self.push(Item::Path(Path::stroked(line.on_page(&self.frame), stroke)));
            }
        }
    }
}
