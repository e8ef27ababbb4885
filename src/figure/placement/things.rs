//! What a label could name, on the page: its own thing, and every other of the same kind.
//!
//! Whoever reads a picture takes a label for the name of what it stands nearest to, among the things that a
//! label like it can name: a body's name belongs to a body or a ghost, a point's to a marker, a length to a
//! dimension line. So each label has to stand nearer to its own thing than to any rival, or has to be led to
//! it by a line.
//!
//! ```text
//! margin = min over rivals of d(box, rival) − d(box, own)
//! ```
//!
//! d is 0 for a box that touches an area. Where the box is as far from both, the distances of its middle
//! decide: a wide label over a short bar stands at the bar that it is centred on. A thing that lies within
//! another one is named by what stands at both: a name in a ball that lies in a box is the ball's.

use std::cell::OnceCell;

use crate::drawing::{Offset, Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Best, Cover, MARKER, Obstacle, Request, SPECK};

use super::Candidate;
use super::pole::grid;
use super::polyline::Polyline;
use super::rect::{about, distance_to, rect_distance};
use super::weights::Places;

/// Distances that differ by less look alike, page pixels: a third of an outline's width. At ten times, labels
/// would count as wrong that stand right at their thing with another one three times as far.
pub(super) const ALIKE: f64 = 0.75;
/// Things that are nowhere farther from each other than this look like one, page pixels: a marker's radius.
/// What stands at one of them stands at all.
const ONE: f64 = 4.5;
/// The part of a line, from its start, on which a leader line may end: clear of what marks its ends.
const MIDDLE: (f64, f64) = (0.3, 0.7);
/// The sine of the angle between a line and a leader line to it that makes less look like one line: 20°.
const OBLIQUE: f64 = 0.34;
/// How many points of a thing are looked at to see whether it lies within another one; an outline that has
/// more is smooth between them.
const LOOKS: usize = 24;

/// What labels of one sort can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Bodies, ghosts, differences.
    Area,
    /// Points, with or without a marker.
    Point,
    /// Vectors, which are named at their tip.
    Vector,
    /// Lines that are named beside their middle.
    Line,
    /// Dimension lines and bars.
    Length,
    /// Arcs, with or without a head.
    Arc,
}

/// Something that a label could name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Thing {
    /// What sort of label names it.
    kind: Kind,
    /// Its line on the page, or its one point.
    line: Polyline,
    /// The radius that its marker covers, page pixels.
    clear: f64,
    /// The point of an outline that nothing fills where its label is led to: nothing stands inside of it, so
    /// that it is named by what is beside its line.
    hollow: Option<Point>,
}

/// A thing that a label must not seem to name.
pub(super) struct Rival<'t> {
    /// The thing.
    thing: &'t Thing,
    /// Whether the label's own thing lies within it.
    around: bool,
}

/// The things of one label.
pub(super) struct Things<'t> {
    /// What it names; none for a note at a corner of the panel.
    pub(super) own: Option<Thing>,
    /// What else a label like it could name.
    pub(super) rivals: Vec<Rival<'t>>,
    /// The bodies that what it names lies beside, where that is a length or line between them.
    pub(super) beside: Vec<&'t Thing>,
    /// The panel on the page.
    panel: Rect,
    /// What [`Things::remote`] says, once it was asked for.
    remote: OnceCell<Vec<(Point, f64)>>,
}

/// Everything in a panel that a label could name: what has a label, what a layer said has none, and markers.
pub(crate) fn things(
    requests: &[Request],
    unnamed: &[Anchor],
    obstacles: &[Obstacle],
    frame: &Frame,
) -> Vec<Thing> {
    let named = requests.iter().map(|request| &request.label.anchor);
    let mut all: Vec<Thing> = named.chain(unnamed).filter_map(|a| Thing::of(a, frame)).collect();
    all.extend(obstacles.iter().filter_map(|obstacle| match obstacle.cover {
        Cover::Marker { at, radius } => Thing::new(Kind::Point, vec![at], radius),
        Cover::Stroke { .. } | Cover::Head { .. } => None,
    }));
    all
}

impl<'t> Things<'t> {
    /// What a label belongs to, and what it must not seem to belong to.
    pub(super) fn of(anchor: &Anchor, all: &'t [Thing], frame: &Frame) -> Self {
        Self::among(all, Thing::of(anchor, frame), &frame.panel)
    }

    /// What a label names, and what it must not seem to name among all things of a panel.
    pub(super) fn among(all: &'t [Thing], own: Option<Thing>, panel: &Rect) -> Self {
        let rivals = own.as_ref().map_or_else(Vec::new, |own| own.rivals(all));
        let beside = own.as_ref().map_or_else(Vec::new, |own| own.beside(all));
        Self { own, rivals, beside, panel: *panel, remote: OnceCell::new() }
    }

    /// Points of the area that is only its own, the remotest from any line first, each with that distance,
    /// page pixels; none for what is no area.
    pub(super) fn remote(&self, w: &Places) -> &[(Point, f64)] {
        let area = || self.own.as_ref().filter(|own| own.is_area());
        let found = || area().map(|own| grid(&own.line, &self.avoid(), &self.panel, w));
        self.remote.get_or_init(|| found().unwrap_or_default())
    }

    /// The contours of the areas that a name should keep out of.
    pub(super) fn avoid(&self) -> Vec<&'t Polyline> {
        self.rivals.iter().filter(|r| !r.around && r.thing.hollow.is_none()).map(|r| &r.thing.line).collect()
    }

    /// How much nearer a box is to its own thing than to any other, page pixels, at most `reach`; anything up
    /// to [`ALIKE`] is not nearer.
    pub(super) fn margin(&self, rect: &Rect, reach: f64) -> f64 {
        self.own.as_ref().map_or(reach, |own| margin(own, &self.rivals, rect, reach))
    }

    /// Whether a place names something else to who looks at it: no line leads to its own thing, which is no
    /// nearer than another one.
    pub(super) fn misleads(&self, place: &Candidate) -> bool {
        place.leader.is_none() && self.margin(&place.rect, f64::INFINITY) <= ALIKE
    }
}

/// How much nearer a box is to a thing than to any rival, page pixels, at most `reach`.
fn margin(own: &Thing, rivals: &[Rival], rect: &Rect, reach: f64) -> f64 {
    if rivals.is_empty() {
        return reach;
    }
    let near = own.distance(rect);
    let middle = about(rect.center(), (0.0, 0.0));
    let mut least = reach;
    for rival in rivals {
        if rect_distance(rect, &rival.thing.line.bounds()) - rival.thing.clear > near + least {
            continue;
        }
        let far = rival.thing.distance(rect);
        if far - near > ALIKE {
            // A name in its own area, and in no other one, is at home.
            let at_home = own.kind == Kind::Area && near <= 0.0;
            least = if at_home { least } else { least.min(far - near) };
        } else if near - far > ALIKE {
            least = least.min(far - near);
        } else if !rival.around {
            least = least.min(rival.thing.distance(&middle) - own.distance(&middle));
        }
    }
    least
}

/// No page reaches as far, page pixels; the squares of lesser lengths are finite.
const BEYOND: f64 = 1e150;

impl Thing {
    /// A thing of points on the page; none without a point, or with one that no page has.
    pub(super) fn new(kind: Kind, points: Vec<Point>, clear: f64) -> Option<Self> {
        let line = if kind == Kind::Area { Polyline::closed(points) } else { Polyline::open(points) }?;
        let Rect { x0, y0, x1, y1 } = line.bounds();
        let on_page = [x0, y0, x1, y1].iter().all(|v| v.abs() < BEYOND);
        on_page.then_some(Self { kind, line, clear, hollow: None })
    }

    /// What a label belongs to, on the page; none for a corner of the panel.
    fn of(anchor: &Anchor, frame: &Frame) -> Option<Self> {
        let mut points: Vec<Point> = anchor.points().iter().map(|&p| frame.page(p)).collect();
        let (kind, clear) = match anchor {
            Anchor::Point { clear, .. } => (Kind::Point, *clear),
            Anchor::Tick { .. } => (Kind::Point, MARKER),
            Anchor::Along { best: Best::Tip, .. } => (Kind::Vector, 0.0),
            Anchor::Along { .. } => (Kind::Line, 0.0),
            Anchor::Beside { offset, .. } => {
                if let [from, to] = points.as_mut_slice() {
                    let shift = (*to - *from).unit().unwrap_or_default().left() * *offset;
                    (*from, *to) = (*from + shift, *to + shift);
                }
                (Kind::Length, 0.0)
            }
            Anchor::Arc { .. } => (Kind::Arc, 0.0),
            Anchor::Inside { .. } | Anchor::Outline { .. } => (Kind::Area, 0.0),
            Anchor::Corner(_) => return None,
        };
        let hollow = match anchor {
            Anchor::Outline { at, .. } => Some(frame.page(*at)),
            _ => None,
        };
        Some(Self { hollow, ..Self::new(kind, points, clear)? })
    }

    /// How much nearer a label's box is to it than to any other of the things, page pixels; anything up to
    /// [`ALIKE`] is not nearer.
    pub(super) fn margin(&self, things: &[Self], rect: &Rect) -> f64 {
        margin(self, &self.rivals(things), rect, f64::INFINITY)
    }

    /// The things of its kind that it can be told from.
    fn rivals<'t>(&self, all: &'t [Self]) -> Vec<Rival<'t>> {
        let others = all.iter().filter(|other| other.kind == self.kind);
        others
            .filter_map(|thing| {
                let around = self.lies_in(thing);
                let one = around && thing.lies_in(self) && self.looks().all(|p| thing.passes(p));
                (!one).then_some(Rival { thing, around })
            })
            .collect()
    }

    /// The distance of a box from what is seen of it, page pixels; 0 where they touch.
    pub(super) fn distance(&self, rect: &Rect) -> f64 {
        if self.holds(rect.center()) {
            return 0.0;
        }
        if let [only] = *self.line.points() {
            return (distance_to(rect, only) - self.clear).max(0.0);
        }
        self.line.square_from(rect, f64::INFINITY).sqrt()
    }

    /// Whether a box is farther from it than a length in page pixels.
    pub(super) fn is_farther(&self, rect: &Rect, than: f64) -> bool {
        if self.line.points().len() == 1 || than <= 0.0 {
            return self.distance(rect) > than;
        }
        let outside = !self.holds(rect.center());
        // A line at just this distance is none that is farther.
        let most = (than * than).next_up();
        outside && self.line.square_from(rect, most) >= most
    }

    /// The point of its line that is nearest to a point of the page.
    pub(super) fn nearest(&self, p: Point) -> Point {
        self.line.nearest(p)
    }

    /// Where a leader line from a point of the page ends on it: of a line between two points not near those,
    /// where markers and heads are.
    pub(super) fn aim(&self, p: Point) -> Point {
        if let Some(at) = self.hollow {
            return at;
        }
        match *self.line.points() {
            [from, to] if self.has_ends() => {
                let inner = [MIDDLE.0, MIDDLE.1].map(|part| from + (to - from) * part);
                Polyline::open(inner.to_vec()).map_or_else(|| self.nearest(p), |line| line.nearest(p))
            }
            _ => self.nearest(p),
        }
    }

    /// Whether it is a line between two points, which is named at its middle.
    pub(super) fn has_ends(&self) -> bool {
        matches!(self.kind, Kind::Length | Kind::Line) && self.line.points().len() == 2
    }

    /// Whether a box stands beside it rather than off one of its ends, where a reader takes it for a label of
    /// what lies there: of a line between two points, half of it or of the box, whichever is less, is beside
    /// the other. All other things have no ends.
    pub(super) fn is_beside(&self, rect: &Rect) -> bool {
        let &[from, to] = self.line.points() else { return true };
        if !self.has_ends() {
            return true;
        }
        let Some(u) = (to - from).unit() else { return true };
        let length = (to - from).length();
        let half = 0.5 * (u.dx.abs() * rect.width() + u.dy.abs() * rect.height());
        let middle = (rect.center() - from).dot(u);
        let common = (middle + half).min(length) - (middle - half).max(0.0);
        common >= half.min(0.5 * length)
    }

    /// Whether a leader line to it would look like a part of it: it runs along a line between two points.
    pub(super) fn is_along(&self, way: Offset) -> bool {
        let &[from, to] = self.line.points() else { return false };
        let both = (to - from).unit().zip(way.unit());
        self.has_ends() && both.is_some_and(|(u, v)| u.left().dot(v).abs() < OBLIQUE)
    }

    /// Whether a name stands inside it where it can.
    pub(super) fn is_area(&self) -> bool {
        self.kind == Kind::Area && self.hollow.is_none()
    }

    /// Whether a point lies in its area.
    pub(super) fn holds(&self, p: Point) -> bool {
        self.is_area() && self.line.contains(p)
    }

    /// Where it is, if it is so small that it is drawn as a point.
    pub(super) fn speck(&self) -> Option<Point> {
        let bounds = self.line.bounds();
        let small = bounds.width() < SPECK && bounds.height() < SPECK;
        self.line.points().first().copied().filter(|_| small)
    }

    /// Its line on the page, or its one point.
    pub(super) fn line(&self) -> &Polyline {
        &self.line
    }

    /// The radius that its marker covers, page pixels.
    pub(super) fn clear(&self) -> f64 {
        if self.speck().is_some() && self.is_area() { MARKER } else { self.clear }
    }

    /// Some of its points, evenly along the list.
    fn looks(&self) -> impl Iterator<Item = Point> + '_ {
        let points = self.line.points();
        points.iter().copied().step_by(points.len().div_ceil(LOOKS).max(1))
    }

    /// Whether a point looks as if it were on its line.
    fn passes(&self, p: Point) -> bool {
        (self.nearest(p) - p).square() <= ONE * ONE
    }

    /// Whether it lies within another thing, or on it.
    fn lies_in(&self, other: &Self) -> bool {
        let wide = other.line.bounds().grown(ONE);
        let covers = |p: Point| other.holds(p) || other.passes(p);
        wide.union(self.line.bounds()) == wide && self.looks().all(covers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(kind: Kind, points: &[(f64, f64)]) -> Thing {
        Thing::new(kind, points.iter().map(|&(x, y)| Point::new(x, y)).collect(), 0.0).unwrap()
    }

    fn square(x0: f64, y0: f64, side: f64) -> Thing {
        let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
        line(Kind::Area, &points.map(|(x, y)| (x0 + side * x, y0 + side * y)))
    }

    /// How much nearer a box of 20 × 10 about a point is to a thing than to the others.
    fn margin_at(own: &Thing, others: &[Thing], x: f64, y: f64) -> f64 {
        own.margin(others, &about(Point::new(x, y), (20.0, 10.0)))
    }

    #[test]
    fn a_name_over_two_bodies_names_the_nearer_one() {
        let (a, b) = (square(0.0, 0.0, 100.0), square(50.0, 0.0, 100.0));
        let others = [a.clone(), b.clone()];
        assert!(margin_at(&a, &others, 25.0, -10.0) > ALIKE);
        assert!(margin_at(&b, &others, 25.0, -10.0) < -ALIKE);
        // Over the part that both share it names neither.
        assert!(margin_at(&a, &others, 75.0, -10.0) <= ALIKE && margin_at(&b, &others, 75.0, 50.0) <= ALIKE);
    }

    #[test]
    fn a_body_inside_another_one_is_named_by_what_stands_in_both() {
        let (ball, room) = (square(40.0, 40.0, 30.0), square(0.0, 0.0, 200.0));
        let others = [ball.clone(), room.clone()];
        assert!(margin_at(&ball, &others, 55.0, 55.0) > ALIKE);
        assert!(margin_at(&room, &others, 55.0, 55.0) <= ALIKE);
        assert!(margin_at(&room, &others, 120.0, 120.0) > ALIKE);
        assert!(margin_at(&ball, &others, 55.0, 82.0) < -ALIKE, "beside the ball, in the room");
    }

    #[test]
    fn a_label_as_wide_as_two_bars_is_at_the_one_that_it_is_centred_on() {
        let bars = [[0.0, 10.0], [10.0, 20.0]].map(|[a, b]| line(Kind::Length, &[(a, 0.0), (b, 0.0)]));
        assert!(margin_at(&bars[0], &bars, 4.0, -12.0) > ALIKE);
        assert!(margin_at(&bars[1], &bars, 4.0, -12.0) <= ALIKE);
    }

    #[test]
    fn things_at_one_place_and_things_of_other_kinds_mislead_nobody() {
        let (a, again) = (square(0.0, 0.0, 100.0), square(1.0, 1.0, 100.0));
        let bar = line(Kind::Length, &[(0.0, -20.0), (100.0, -20.0)]);
        assert_eq!(margin_at(&a, &[a.clone(), again, bar], 50.0, -10.0), f64::INFINITY);
    }
}
