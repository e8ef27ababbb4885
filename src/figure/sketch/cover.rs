//! What marks cover on the page, which labels keep off.

use crate::drawing::Point;
use crate::geometry::DVec2;

use super::Sketch;

/// How much labels mind what is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Weight {
    /// Crossed last: outlines, vectors, dimensions.
    Normal,
    /// Crossed before others: construction lines, ghosts.
    Light,
    /// Crossed before others, and not counted for the fit of the view: what lies outside of the subject, as
    /// axes.
    Background,
}

/// What a primitive covers on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Cover {
    /// A straight piece of a line.
    Stroke {
        /// One end, page pixels.
        from: Point,
        /// The other end, page pixels.
        to: Point,
        /// Half the line's width, page pixels.
        half: f64,
    },
    /// A marker, as a disc.
    Marker {
        /// The centre of the disc, page pixels.
        at: Point,
        /// The radius of the disc, page pixels.
        radius: f64,
    },
    /// An arrowhead, as a disc about its middle.
    Head {
        /// The middle of the head, page pixels.
        at: Point,
        /// Half the head's length, page pixels.
        radius: f64,
    },
}

/// Something that labels keep off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Obstacle {
    /// What it covers on the page.
    pub(crate) cover: Cover,
    /// How much labels mind it.
    pub(crate) weight: Weight,
    /// The part that it belongs to: the number of the call of [`Sketch::part`] in its panel.
    pub(crate) part: usize,
}

impl Sketch<'_> {
    /// Makes labels keep off a line of `width` page pixels through points of the panel's space.
    pub(super) fn cover(&mut self, points: &[DVec2], width: f64) {
        let page: Vec<Point> = points.iter().map(|&p| self.frame.page(p)).collect();
        for pair in page.windows(2) {
            self.keep_off(Cover::Stroke { from: pair[0], to: pair[1], half: 0.5 * width });
        }
    }

    /// Makes labels keep off something of the current part.
    pub(super) fn keep_off(&mut self, cover: Cover) {
        if self.is_full() {
            return;
        }
        self.obstacles.push(Obstacle { cover, weight: self.weight, part: self.part });
    }
}
