//! Lines, polygons, vectors.

use crate::drawing::{Contour, Item, Offset, Path, Point, Role};
use crate::geometry::DVec2;

use super::{Cover, Dash, Outline, Pen, Sketch};

/// How far beside its panel a dashed line goes on, page pixels: farther than a page that is read.
const NEAR: f64 = 2000.0;
/// Length of an arrowhead on a vector of 1.75 px, page pixels.
pub(crate) const HEAD_LENGTH: f64 = 9.0;
/// Width of that arrowhead across, page pixels.
pub(crate) const HEAD_WIDTH: f64 = 6.5;
/// How much a head grows for each pixel of the shaft above 1.75, page pixels.
const HEAD_GROWTH: f64 = 2.4;
/// The length of a vector, page pixels, below which its head is smaller: half of it, so that a shaft remains.
const SHORT: f64 = 14.0;
/// The length of a vector, page pixels, below which it is a dot: no direction can be seen.
const DOT: f64 = 6.0;
/// Radius of that dot, page pixels.
const DOT_RADIUS: f64 = 2.2;
/// Width of either rail of a cased line, in widths of a plain one: with the core as much ink as that has.
const RAIL: f64 = 0.42;
/// How far the middle of either rail is from the line at least, page pixels: a gap that is seen at a third of
/// the size.
const RAIL_GAP: f64 = 0.3;
/// How much farther, in widths of a plain line.
const RAIL_OFF: f64 = 0.48;
/// Opacity of the core between the rails: a tint, which in print is no line.
const CORE: f64 = 0.16;

impl Sketch<'_> {
    /// Draws the line of an outline of the panel's space, without its area.
    pub(crate) fn stroke(&mut self, outline: &Outline, pen: Pen) -> &mut Self {
        self.area(outline, None, Some(pen))
    }

    /// Draws a straight line between points of the panel's space.
    pub(crate) fn line(&mut self, from: DVec2, to: DVec2, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let shown = if pen.dash == Dash::Solid { [from, to] } else { self.about_the_panel([from, to]) };
        self.stroke(&Outline::polyline(&shown), pen)
    }

    /// What of a line is in the panel or near it: there is no end to the dashes of one that goes far out. One
    /// that does not is whole.
    fn about_the_panel(&self, [from, to]: [DVec2; 2]) -> [DVec2; 2] {
        let near = self.frame.panel.grown(NEAR);
        let (p, q) = (self.frame.page(from), self.frame.page(to));
        match near.shares_inside(p, q) {
            Some((lo, hi)) if hi - lo < 1.0 => [lo, hi].map(|share| from + (to - from) * share),
            _ => [from, to],
        }
    }

    /// Draws a vector of the panel's space: a shaft that ends inside a filled head. Under 14 px the head is
    /// smaller, under 6 px it is a dot.
    pub(crate) fn arrow(&mut self, from: DVec2, to: DVec2, pen: Pen) -> &mut Self {
        self.arrow_to(from, to, 0.0, pen)
    }

    /// Draws a vector to a point that bears a marker of `clear` page pixels, which its head does not hide: it
    /// ends at the marker's rim, unless it is too short for that.
    pub(crate) fn arrow_to(&mut self, from: DVec2, to: DVec2, clear: f64, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let (tail, end) = (self.frame.page(from), self.frame.page(to));
        let clear = self.fitted(clear);
        let room = (end - tail).length() - clear >= SHORT;
        let tip = (end - tail).unit().filter(|_| room).map_or(end, |u| end + u * -clear);
        self.page_arrow(tail, tip, pen);
        if clear == 0.0 && room {
            self.tips.push((to, from));
        }
        self
    }

    /// Draws a straight line between points of the panel's space as two thin rails beside it, joined at its
    /// ends, and a pale core: told from a plain line without colour, and no heavier.
    pub(crate) fn cased(&mut self, from: DVec2, to: DVec2, pen: Pen) -> &mut Self {
        let (rail, off) = (pen.width(RAIL * pen.width), RAIL_GAP + RAIL_OFF * self.width(pen));
        let (p, q) = (self.frame.page(from), self.frame.page(to));
        let Some(u) = (q - p).unit() else { return self };
        self.reach(&[from, to]);
        let aside = u.left() * self.fitted(off);
        let case = Contour::polygon(&[p + aside, q + aside, q + -aside, p + -aside]);
        let core = self.paint(pen.role).with_opacity(CORE * pen.opacity);
        let path = Path { stroke: Some(self.stroke_of(rail)), ..Path::filled(case, core) };
        self.push(Item::Path(path));
        self.keep_off(Cover::Stroke { from: p, to: q, half: off + 0.5 * rail.width });
        self
    }

    /// Draws a vector of the panel's space with a cased shaft.
    pub(crate) fn cased_arrow(&mut self, from: DVec2, to: DVec2, pen: Pen) -> &mut Self {
        let (tail, tip) = (self.frame.page(from), self.frame.page(to));
        let length = (tip - tail).length();
        let Some(u) = (tip - tail).unit().filter(|_| length >= SHORT) else {
            return self.arrow(from, to, pen);
        };
        let head = self.head_length(pen, length);
        self.cased(from, to - (to - from) * (0.8 * head / length), pen);
        self.reach(&[to]);
        self.page_head(tip, u, head, pen);
        self
    }

    /// Draws a path through time, given by points of the panel's space: a line with a small head half-way
    /// that looks the way it goes.
    pub(crate) fn path_through_time(&mut self, points: &[DVec2], pen: Pen) -> &mut Self {
        self.stroke(&Outline::polyline(points), pen);
        self.head_along(points, 0.5, pen)
    }

    /// Draws a path through time with its head at its end: where a body is then is seen.
    pub(crate) fn path_to_its_end(&mut self, points: &[DVec2], pen: Pen) -> &mut Self {
        self.stroke(&Outline::polyline(points), pen);
        self.head_along(points, 1.0, pen)
    }

    /// Draws a head along a path: half-way its middle, at a `share` of 1 its point.
    fn head_along(&mut self, points: &[DVec2], share: f64, pen: Pen) -> &mut Self {
        let page: Vec<Point> = points.iter().map(|&p| self.frame.page(p)).collect();
        let length = |w: &[Point]| (w[1] - w[0]).length();
        let whole: f64 = page.windows(2).map(length).sum();
        let head = self.head_length(pen, whole);
        if whole < SHORT {
            return self;
        }
        let mut left = share * whole + (1.0 - share) * head;
        let last = page.len().saturating_sub(2);
        for (i, w) in page.windows(2).enumerate() {
            let (own, along) = (length(w), (w[1] - w[0]).unit());
            // The last piece is as long as what is left of the whole, but for rounding.
            if let Some(u) = along.filter(|_| own >= left || i == last) {
                self.page_head(w[0] + u * left.min(own), u, head, pen);
                break;
            }
            left -= own;
        }
        self
    }

    /// Draws a vector on the page.
    fn page_arrow(&mut self, tail: Point, tip: Point, pen: Pen) {
        let shaft = tip - tail;
        let length = shaft.length();
        let Some(u) = shaft.unit().filter(|_| length >= DOT) else {
            self.page_dot(tail + shaft * 0.5, DOT_RADIUS, pen);
            return;
        };
        let head = self.head_length(pen, length);
        self.push_stroked(Contour::line(tail, tip + u * (-0.6 * head)), pen);
        self.keep_off(Cover::Stroke { from: tail, to: tip, half: 0.5 * self.width(pen) });
        self.page_head(tip, u, head, pen);
    }

    /// Draws a filled head on the page with its point at `tip`, looking along the unit offset `u`.
    pub(super) fn page_head(&mut self, tip: Point, u: Offset, length: f64, pen: Pen) {
        let half = u.left() * (0.5 * length * HEAD_WIDTH / HEAD_LENGTH);
        let base = tip + u * -length;
        let paint = self.paint(pen.role).with_opacity(pen.opacity);
        self.keep_off(Cover::Head { at: tip + u * (-0.5 * length), radius: 0.5 * length });
        self.push_filled(Contour::polygon(&[tip, base + half, base + -half]), paint);
    }

    /// Draws a dot on the page; `radius` in page pixels.
    pub(super) fn page_dot(&mut self, center: Point, radius: f64, pen: Pen) {
        let paint = self.paint(pen.role).with_opacity(pen.opacity);
        self.keep_off(Cover::Marker { at: center, radius });
        self.push_filled(Contour::Circle { center, radius }, paint);
    }

    /// Length of a head on a shaft of `length` page pixels, page pixels.
    pub(super) fn head_length(&self, pen: Pen, length: f64) -> f64 {
        let usual = HEAD_LENGTH + HEAD_GROWTH * (self.width(pen) - Pen::vector(Role::Ink).width).max(0.0);
        let share = if length < SHORT { 0.5 } else { 0.7 };
        (usual * self.unit).min(share * length)
    }
}
