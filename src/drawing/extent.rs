//! How much of the page an item covers.

use super::{Contour, Group, Item, Path, Point, Rect, Segment, Text};
use crate::typeset::UNITS_PER_EM;

impl Rect {
    /// From where to where a segment lies inside it, as shares of its way (Liang, Barsky); `None` where it
    /// does not even touch.
    pub(crate) fn shares_inside(&self, from: Point, to: Point) -> Option<(f64, f64)> {
        // Most segments are far off.
        Self::new(from, to).intersection(*self)?;
        let d = to - from;
        let (mut lo, mut hi) = (0.0_f64, 1.0_f64);
        for (start, step, min, max) in [(from.x, d.dx, self.x0, self.x1), (from.y, d.dy, self.y0, self.y1)] {
            if step == 0.0 {
                if start < min || start > max {
                    return None;
                }
                continue;
            }
            let (a, b) = ((min - start) / step, (max - start) / step);
            (lo, hi) = (lo.max(a.min(b)), hi.min(a.max(b)));
        }
        (lo <= hi).then_some((lo, hi))
    }

    /// The rectangle between two opposite corners, in any order.
    ///
    /// ```
    /// use tracefig::drawing::{Point, Rect};
    /// let rect = Rect::new(Point::new(5.0, 1.0), Point::new(2.0, 3.0));
    /// assert_eq!(rect, Rect { x0: 2.0, y0: 1.0, x1: 5.0, y1: 3.0 });
    /// assert_eq!((rect.width(), rect.height(), rect.center()), (3.0, 2.0, Point::new(3.5, 2.0)));
    /// ```
    #[must_use]
    pub fn new(p: Point, q: Point) -> Self {
        Self { x0: p.x.min(q.x), y0: p.y.min(q.y), x1: p.x.max(q.x), y1: p.y.max(q.y) }
    }

    /// The smallest rectangle that holds both.
    #[must_use]
    pub(crate) fn union(self, other: Self) -> Self {
        Self {
            x0: self.x0.min(other.x0),
            y0: self.y0.min(other.y0),
            x1: self.x1.max(other.x1),
            y1: self.y1.max(other.y1),
        }
    }

    /// What both have in common, if they meet; it may have no width or no height.
    ///
    /// ```
    /// use tracefig::drawing::Rect;
    /// let left = Rect { x0: 0.0, y0: 0.0, x1: 4.0, y1: 2.0 };
    /// let right = Rect { x0: 3.0, y0: 1.0, x1: 9.0, y1: 9.0 };
    /// assert_eq!(left.intersection(right), Some(Rect { x0: 3.0, y0: 1.0, x1: 4.0, y1: 2.0 }));
    /// assert_eq!(left.intersection(Rect { x0: 5.0, x1: 6.0, ..left }), None);
    /// ```
    #[must_use]
    pub fn intersection(self, other: Self) -> Option<Self> {
        let r = Self {
            x0: self.x0.max(other.x0),
            y0: self.y0.max(other.y0),
            x1: self.x1.min(other.x1),
            y1: self.y1.min(other.y1),
        };
        (r.x0 <= r.x1 && r.y0 <= r.y1).then_some(r)
    }

    /// The rectangle with each of its sides moved outward by `d`.
    #[must_use]
    pub(crate) fn grown(self, d: f64) -> Self {
        Self { x0: self.x0 - d, y0: self.y0 - d, x1: self.x1 + d, y1: self.y1 + d }
    }

    /// Width in page pixels.
    ///
    /// ```
    /// let rect = tracefig::drawing::Rect { x0: 10.0, y0: 20.0, x1: 40.0, y1: 24.0 };
    /// assert_eq!(rect.width(), 30.0);
    /// ```
    #[must_use]
    pub fn width(self) -> f64 {
        self.x1 - self.x0
    }

    /// Height in page pixels.
    ///
    /// ```
    /// let rect = tracefig::drawing::Rect { x0: 10.0, y0: 20.0, x1: 40.0, y1: 24.0 };
    /// assert_eq!(rect.height(), 4.0);
    /// ```
    #[must_use]
    pub fn height(self) -> f64 {
        self.y1 - self.y0
    }

    /// The point in its middle.
    ///
    /// ```
    /// let rect = tracefig::drawing::Rect { x0: 10.0, y0: 20.0, x1: 40.0, y1: 24.0 };
    /// assert_eq!((rect.center().x, rect.center().y), (25.0, 22.0));
    /// ```
    #[must_use]
    pub fn center(self) -> Point {
        Point::new(0.5 * (self.x0 + self.x1), 0.5 * (self.y0 + self.y1))
    }

    /// Whether the point lies in it or on its border.
    #[must_use]
    pub(crate) fn contains(self, p: Point) -> bool {
        self.x0 <= p.x && p.x <= self.x1 && self.y0 <= p.y && p.y <= self.y1
    }
}

impl Contour {
    /// The smallest rectangle that holds the line itself, without its stroke's width, in page pixels; `None`
    /// where it has no points. Curves are measured by their control points, arcs exactly.
    ///
    /// ```
    /// use tracefig::drawing::{Contour, Point, Rect};
    /// let circle = Contour::Circle { center: Point::new(5.0, 6.0), radius: 2.0 };
    /// assert_eq!(circle.bounds(), Some(Rect { x0: 3.0, y0: 4.0, x1: 7.0, y1: 8.0 }));
    /// ```
    #[must_use]
    pub fn bounds(&self) -> Option<Rect> {
        match self {
            Self::Circle { center, radius } => Some(Rect::new(*center, *center).grown(*radius)),
            Self::Segments(segments) => segments.iter().filter_map(segment_bounds).reduce(Rect::union),
        }
    }
}

fn segment_bounds(segment: &Segment) -> Option<Rect> {
    match *segment {
        Segment::Move(p) | Segment::Line(p) => Some(Rect::new(p, p)),
        Segment::Quad(c, p) => Some(Rect::new(c, p)),
        Segment::Cubic(c, d, p) => Some(Rect::new(c, d).union(Rect::new(p, p))),
        Segment::Arc { center, radius, start, sweep } => Some(arc_bounds(center, radius, start, sweep)),
        Segment::Close => None,
    }
}

/// The rectangle that holds an arc's ends, and those of the circle's four extreme points that it passes.
fn arc_bounds(center: Point, radius: f64, start: f64, sweep: f64) -> Rect {
    use std::f64::consts::FRAC_PI_2;
    let at =
        |angle: f64| Point::new(center.x + radius * libm::cos(angle), center.y + radius * libm::sin(angle));
    let mut bounds = Rect::new(at(start), at(start + sweep));
    let (lo, hi) = (start.min(start + sweep), start.max(start + sweep));
    let first = (lo / FRAC_PI_2).ceil();
    for quarter in 0..4 {
        let angle = (first + f64::from(quarter)) * FRAC_PI_2;
        if angle <= hi {
            let p = at(angle);
            bounds = bounds.union(Rect::new(p, p));
        }
    }
    bounds
}

impl Path {
    /// The area that it may paint, in page pixels: its line and half its stroke's width around it; `None`
    /// where it has no points.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Contour, Paint, Path, Point, Rect, Role, Stroke};
    /// let line = Contour::line(Point::new(1.0, 5.0), Point::new(9.0, 5.0));
    /// let path = Path::stroked(line, Stroke::solid(Paint::role(Role::Ink, Color::hex(0)), 2.0));
    /// assert_eq!(path.extent(), Some(Rect { x0: 0.0, y0: 4.0, x1: 10.0, y1: 6.0 }));
    /// ```
    #[must_use]
    pub fn extent(&self) -> Option<Rect> {
        let half = self.stroke.as_ref().map_or(0.0, |s| 0.5 * s.width);
        self.contour.bounds().map(|r| r.grown(half))
    }
}

impl Text {
    /// The box of the line, halo excluded, in page pixels: from its start to its advance width, its ascent to
    /// its descent. Letters may lean out of it to the left and the right; [`Text::extent`] holds them.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use tracefig::drawing::{Color, Paint, Point, Role, Shown, Text};
    /// let line = tracefig::typeset::typeset("A", tracefig::typeset::Style::regular(16.0)).unwrap();
    /// let (width, paint) = (line.width, Paint::role(Role::Ink, Color::hex(0)));
    /// let (origin, shown) = (Point::new(30.0, 40.0), Shown::ALWAYS);
    /// let text = Text { line: Arc::new(line), origin, paint, halo: None, shown };
    /// assert_eq!((text.bounds().x0, text.bounds().x1, text.bounds().y1), (30.0, 30.0 + width, 40.0));
    /// ```
    #[must_use]
    pub fn bounds(&self) -> Rect {
        let Point { x, y } = self.origin;
        Rect { x0: x, y0: y - self.line.ascent, x1: x + self.line.width, y1: y + self.line.descent }
    }

    /// The area that it may paint, in page pixels: its box, the ink of its glyphs, and the halo around both.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use tracefig::drawing::{Color, Paint, Point, Role, Shown, Text};
    /// let line = tracefig::typeset::typeset("A", tracefig::typeset::Style::regular(16.0)).unwrap();
    /// let paint = Paint::role(Role::Ink, Color::hex(0));
    /// let (origin, shown) = (Point::new(30.0, 40.0), Shown::ALWAYS);
    /// let text = Text { line: Arc::new(line), origin, paint, halo: None, shown };
    /// let (bounds, extent) = (text.bounds(), text.extent());
    /// assert!(extent.x0 <= bounds.x0 && bounds.x1 <= extent.x1);
    /// ```
    #[must_use]
    pub fn extent(&self) -> Rect {
        let ink = self.line.glyphs.iter().map(|placed| {
            let unit = placed.size / UNITS_PER_EM;
            let [x0, y0, x1, y1] = placed.glyph.outline().bounds.map(|v| f64::from(v) * unit);
            let (x, y) = (self.origin.x + placed.x, self.origin.y + placed.y);
            Rect { x0: x + x0, y0: y + y0, x1: x + x1, y1: y + y1 }
        });
        ink.fold(self.bounds(), Rect::union).grown(self.halo.as_ref().map_or(0.0, |h| h.width))
    }
}

impl Group {
    /// The area that its items may paint, cut by its clip, in page pixels; `None` where they paint nothing.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Contour, Group, Item, Paint, Path, Point, Rect, Role};
    /// let disc = Contour::Circle { center: Point::new(0.0, 0.0), radius: 10.0 };
    /// let mut panel = Group::new("panel");
    /// assert_eq!(panel.extent(), None);
    /// panel.items.push(Item::Path(Path::filled(disc, Paint::role(Role::A, Color::hex(0)))));
    /// panel.clip = Some(Rect { x0: 0.0, y0: -5.0, x1: 50.0, y1: 5.0 }.into());
    /// assert_eq!(panel.extent(), Some(Rect { x0: 0.0, y0: -5.0, x1: 10.0, y1: 5.0 }));
    /// ```
    #[must_use]
    pub fn extent(&self) -> Option<Rect> {
        let all = self.items.iter().filter_map(Item::extent).reduce(Rect::union)?;
        match self.clip {
            Some(clip) => all.intersection(clip.rect),
            None => Some(all),
        }
    }
}

impl Item {
    /// The area that it may paint, in page pixels; `None` where it paints nothing.
    ///
    /// ```
    /// use tracefig::drawing::{Group, Item};
    /// assert_eq!(Item::Group(Group::new("empty")).extent(), None);
    /// ```
    #[must_use]
    pub fn extent(&self) -> Option<Rect> {
        match self {
            Self::Group(group) => group.extent(),
            Self::Path(path) => path.extent(),
            Self::Text(text) => Some(text.extent()),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::typeset::{Style, typeset};

    #[test]
    fn an_arc_reaches_the_extreme_points_that_it_passes_and_no_others() {
        use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
        let r = arc_bounds(Point::new(0.0, 0.0), 2.0, -FRAC_PI_4, FRAC_PI_2);
        assert!((r.x1 - 2.0).abs() < 1e-12, "passes the right: {r:?}");
        assert!((r.x0 - std::f64::consts::SQRT_2).abs() < 1e-12, "not the left: {r:?}");
        let r = arc_bounds(Point::new(0.0, 0.0), 2.0, FRAC_PI_4, -FRAC_PI_2);
        assert!((r.x1 - 2.0).abs() < 1e-12, "backwards too: {r:?}");
        let r = arc_bounds(Point::new(1.0, 1.0), 2.0, 0.3, 2.0 * std::f64::consts::PI);
        assert!((r.x0 + 1.0).abs() < 1e-12 && (r.y1 - 3.0).abs() < 1e-12, "a full turn is the circle: {r:?}");
    }

    #[test]
    fn the_extent_of_a_text_holds_its_ink() {
        use super::super::{Color, Halo, Paint, Role};
        let paint = Paint::role(Role::Ink, Color::hex(0));
        // The tail of `j` begins left of its line, the hat of A too.
        for markup in ["j", r"$\hat{A}$", "$f$", r"$\vec v$", r"$\frac{1}{2}$", "Wide, plain words", " "] {
            let line = Arc::new(typeset(markup, Style::regular(16.0)).unwrap());
            let halo = Some(Halo::plain(paint, 2.5));
            let text = Text {
                line,
                origin: Point::new(30.0, 40.0),
                paint,
                halo,
                shown: crate::drawing::Shown::ALWAYS,
            };
            let all = text.extent();
            for glyph in &text.line.glyphs {
                let unit = glyph.size / UNITS_PER_EM;
                let [left, top, right, bottom] = glyph.glyph.outline().bounds.map(|v| f64::from(v) * unit);
                let (x, y) = (30.0 + glyph.x, 40.0 + glyph.y);
                let ink = Rect { x0: x + left, y0: y + top, x1: x + right, y1: y + bottom }.grown(2.5);
                assert_eq!(all.union(ink), all, "{markup}: {ink:?} leaves {all:?}");
            }
            assert_eq!(all.union(text.bounds()), all, "{markup}: its box too");
        }
    }

    #[test]
    fn a_clip_cuts_the_extent_of_its_group() {
        let mut group = Group::new("panel");
        let contour = Contour::Circle { center: Point::new(0.0, 0.0), radius: 10.0 };
        let paint = super::super::Paint::role(super::super::Role::Ink, super::super::Color::hex(0));
        group.items.push(Item::Path(Path::filled(contour, paint)));
        group.clip = Some(Rect { x0: 0.0, y0: -5.0, x1: 50.0, y1: 5.0 }.into());
        assert_eq!(group.extent(), Some(Rect { x0: 0.0, y0: -5.0, x1: 10.0, y1: 5.0 }));
    }
}
