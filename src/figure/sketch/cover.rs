//! What marks cover on the page, which labels keep off.

use crate::drawing::Point;
use crate::geometry::DVec2;

use super::{Outline, Sketch};

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

/// How many corners of an area are minded at most: each costs as much as there are lines under it.
const CORNERS: usize = 128;

impl Sketch<'_> {
    /// Makes labels keep off a line of `width` page pixels through points of the panel's space.
    pub(super) fn cover(&mut self, points: &[DVec2], width: f64) {
        let page: Vec<Point> = points.iter().map(|&p| self.frame.page(p)).collect();
        for pair in page.windows(2) {
            self.keep_off(Cover::Stroke { from: pair[0], to: pair[1], half: 0.5 * width });
        }
    }

    /// What labels keep off so far.
    pub(crate) fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// Lets labels stand on what the current part drew in a convex area: something opaque will lie on it. Of
    /// an area of many corners it takes [`CORNERS`], between which it is smaller than it is.
    pub(crate) fn hidden_under(&mut self, area: &Outline) {
        let area = area.sampled();
        let nth = area.len().div_ceil(CORNERS).max(1);
        let area: Vec<Point> = area.iter().step_by(nth).map(|&p| self.frame.page(p)).collect();
        let part = self.part;
        let (drawn, kept): (Vec<_>, Vec<_>) = self.obstacles.drain(..).partition(|o| o.part == part);
        self.obstacles = kept;
        for obstacle in drawn {
            let Cover::Stroke { from, to, half } = obstacle.cover else {
                self.obstacles.push(obstacle);
                continue;
            };
            let seen = outside((from, to), &area).into_iter();
            let seen =
                seen.map(|(from, to)| Obstacle { cover: Cover::Stroke { from, to, half }, ..obstacle });
            self.obstacles.extend(seen);
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

/// The pieces of a line outside of a convex area: none, one or two.
fn outside((from, to): (Point, Point), area: &[Point]) -> Vec<(Point, Point)> {
    let edges = || area.iter().copied().zip(area.iter().copied().cycle().skip(1));
    let turn: f64 = edges().map(|(p, q)| p.x * q.y - q.x * p.y).sum();
    // The part of the way, from 0 to 1, that is on the inner side of every edge so far.
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (p, q) in edges() {
        let inner = (q - p).left() * -turn.signum();
        let [at_start, at_end] = [from, to].map(|end| (end - p).dot(inner));
        if at_start.max(at_end) <= 0.0 {
            return vec![(from, to)];
        }
        let crossing = at_start / (at_start - at_end);
        if at_start < 0.0 {
            enters = enters.max(crossing);
        } else if at_end < 0.0 {
            leaves = leaves.min(crossing);
        }
    }
    if enters >= leaves {
        return vec![(from, to)];
    }
    let at = |share: f64| from + (to - from) * share;
    let pieces = [(enters > 0.0).then(|| (from, at(enters))), (leaves < 1.0).then(|| (at(leaves), to))];
    pieces.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_line_through_an_area_the_pieces_outside_stay() {
        let p = Point::new;
        let round = [p(0.0, 0.0), p(4.0, 0.0), p(4.0, 4.0), p(0.0, 4.0)];
        let mut other = round;
        other.reverse();
        for area in [round, other] {
            let line = |x0: f64, x1: f64, y: f64| outside((p(x0, y), p(x1, y)), &area);
            assert_eq!(line(-1.0, 5.0, 2.0), [(p(-1.0, 2.0), p(0.0, 2.0)), (p(4.0, 2.0), p(5.0, 2.0))]);
            assert_eq!(line(1.0, 5.0, 2.0), [(p(4.0, 2.0), p(5.0, 2.0))]);
            assert_eq!(line(1.0, 3.0, 2.0), []);
            assert_eq!(line(-1.0, 5.0, 5.0), [(p(-1.0, 5.0), p(5.0, 5.0))]);
            assert_eq!(line(5.0, 6.0, 2.0), [(p(5.0, 2.0), p(6.0, 2.0))]);
            let corner = (p(-1.0, 3.5), p(1.0, 5.5));
            assert_eq!(outside(corner, &area), [corner], "past a corner");
        }
    }
}
