//! Contours: polygons, curves, circular arcs, whole circles.

use std::f64::consts::FRAC_PI_2;

use super::{Offset, Paint, Pattern, Point, Rect, Shown, Stroke};

/// A contour with what is drawn in and along it, in the order fill, pattern, stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// The line around the area.
    pub contour: Contour,
    /// The colour of the area, which is inside by the non-zero rule; none leaves it as it is.
    pub fill: Option<Paint>,
    /// Marks over the area; none for most.
    pub pattern: Option<Pattern>,
    /// The line along the contour; none where only the area is drawn.
    pub stroke: Option<Stroke>,
    /// Which steps of the figure show it.
    pub shown: Shown,
}

impl Path {
    /// An area without a line.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Contour, Paint, Path, Point, Role};
    /// let disc = Contour::Circle { center: Point::new(5.0, 6.0), radius: 2.0 };
    /// assert!(Path::filled(disc, Paint::role(Role::B, Color::hex(0))).stroke.is_none());
    /// ```
    #[must_use]
    pub fn filled(contour: Contour, fill: Paint) -> Self {
        Self { contour, fill: Some(fill), pattern: None, stroke: None, shown: Shown::ALWAYS }
    }

    /// A line without an area.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Contour, Paint, Path, Point, Role, Stroke};
    /// let line = Contour::line(Point::new(0.0, 0.0), Point::new(9.0, 0.0));
    /// let stroke = Stroke::solid(Paint::role(Role::Ink, Color::hex(0)), 1.0);
    /// assert!(Path::stroked(line, stroke).fill.is_none());
    /// ```
    #[must_use]
    pub fn stroked(contour: Contour, stroke: Stroke) -> Self {
        Self { contour, fill: None, pattern: None, stroke: Some(stroke), shown: Shown::ALWAYS }
    }
}

/// A closed or open line.
#[derive(Clone, Debug, PartialEq)]
pub enum Contour {
    /// A whole circle.
    Circle {
        /// The circle's centre.
        center: Point,
        /// The circle's radius in page pixels.
        radius: f64,
    },
    /// Pieces end to end, beginning with [`Segment::Move`].
    Segments(Vec<Segment>),
}

impl Contour {
    /// A straight line from one point to another.
    ///
    /// ```
    /// use tracefig::drawing::{Contour, Point, Segment};
    /// let (from, to) = (Point::new(0.0, 0.0), Point::new(9.0, 0.0));
    /// assert_eq!(Contour::line(from, to), Contour::Segments(vec![Segment::Move(from), Segment::Line(to)]));
    /// ```
    #[must_use]
    pub fn line(from: Point, to: Point) -> Self {
        Self::Segments(vec![Segment::Move(from), Segment::Line(to)])
    }

    /// An open line through points.
    ///
    /// ```
    /// use tracefig::drawing::{Contour, Point};
    /// let points = [Point::new(0.0, 0.0), Point::new(9.0, 0.0)];
    /// assert_eq!(Contour::polyline(&points), Contour::line(points[0], points[1]));
    /// ```
    #[must_use]
    pub fn polyline(points: &[Point]) -> Self {
        let piece = |(i, &p): (usize, &Point)| if i == 0 { Segment::Move(p) } else { Segment::Line(p) };
        Self::Segments(points.iter().enumerate().map(piece).collect())
    }

    /// A closed line through points and back to the first.
    ///
    /// ```
    /// use tracefig::drawing::{Contour, Point, Segment};
    /// let triangle = [Point::new(0.0, 0.0), Point::new(9.0, 0.0), Point::new(0.0, 5.0)];
    /// let Contour::Segments(segments) = Contour::polygon(&triangle) else { unreachable!() };
    /// assert_eq!(segments.last(), Some(&Segment::Close));
    /// ```
    #[must_use]
    pub fn polygon(points: &[Point]) -> Self {
        let Self::Segments(mut segments) = Self::polyline(points) else { return Self::Segments(Vec::new()) };
        segments.push(Segment::Close);
        Self::Segments(segments)
    }

    /// The line around a rectangle whose corners are arcs of a `radius` in page pixels; less where the
    /// rectangle is too small for that.
    ///
    /// ```
    /// use tracefig::drawing::{Contour, Rect, Segment};
    /// let card = Rect { x0: 0.0, y0: 0.0, x1: 90.0, y1: 12.0 };
    /// let Contour::Segments(segments) = Contour::rounded(card, 8.0) else { unreachable!() };
    /// assert!(matches!(segments[2], Segment::Arc { radius: 6.0, .. }));
    /// ```
    #[must_use]
    pub fn rounded(around: Rect, radius: f64) -> Self {
        let Rect { x0, y0, x1, y1 } = around;
        let radius = radius.min(0.5 * (x1 - x0)).min(0.5 * (y1 - y0));
        let mut segments = vec![Segment::Move(Point::new(x0 + radius, y0))];
        // Clockwise on the page, from the upper right corner on: each with the way in and out, seen from it.
        let (right, down) = (Offset::new(radius, 0.0), Offset::new(0.0, radius));
        let corners = [
            (Point::new(x1, y0), -right, down, -FRAC_PI_2),
            (Point::new(x1, y1), -down, -right, 0.0),
            (Point::new(x0, y1), right, -down, FRAC_PI_2),
            (Point::new(x0, y0), down, right, 2.0 * FRAC_PI_2),
        ];
        for (corner, from, to, start) in corners {
            segments.push(Segment::Line(corner + from));
            let center = corner + from + to;
            segments.push(Segment::Arc { center, radius, start, sweep: FRAC_PI_2 });
        }
        segments.push(Segment::Close);
        Self::Segments(segments)
    }
}

/// A piece of a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Begins a piece elsewhere.
    Move(Point),
    /// A straight line to a point.
    Line(Point),
    /// A quadratic Bézier curve: control point, end.
    Quad(Point, Point),
    /// A cubic Bézier curve: two control points, end.
    Cubic(Point, Point, Point),
    /// A circular arc, after a straight line to its start where that is not the current point.
    Arc {
        /// Centre of the circle.
        center: Point,
        /// The circle's radius in page pixels.
        radius: f64,
        /// Where it starts: radians from the x axis towards the y axis, which is clockwise on the page.
        start: f64,
        /// How far it runs, in radians, clockwise on the page where positive; at most a full turn.
        sweep: f64,
    },
    /// A straight line back to the last [`Segment::Move`].
    Close,
}
