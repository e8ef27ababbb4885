//! Contours: polygons, curves, circular arcs, whole circles.

use super::{Paint, Pattern, Point, Stroke};

/// A contour with what is drawn in and along it, in the order fill, pattern, stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// The line itself.
    pub contour: Contour,
    /// The colour of the area (non-zero winding).
    pub fill: Option<Paint>,
    /// Marks over the area.
    pub pattern: Option<Pattern>,
    /// The line along the contour.
    pub stroke: Option<Stroke>,
}

impl Path {
    /// An area without a line.
    #[must_use]
    pub fn filled(contour: Contour, fill: Paint) -> Self {
        Self { contour, fill: Some(fill), pattern: None, stroke: None }
    }

    /// A line without an area.
    #[must_use]
    pub fn stroked(contour: Contour, stroke: Stroke) -> Self {
        Self { contour, fill: None, pattern: None, stroke: Some(stroke) }
    }
}

/// A closed or open line.
#[derive(Clone, Debug, PartialEq)]
pub enum Contour {
    /// A whole circle.
    Circle {
        /// Its centre.
        center: Point,
        /// Its radius in page pixels.
        radius: f64,
    },
    /// Pieces end to end, beginning with [`Segment::Move`].
    Segments(Vec<Segment>),
}

impl Contour {
    /// A straight line.
    #[must_use]
    pub fn line(from: Point, to: Point) -> Self {
        Self::Segments(vec![Segment::Move(from), Segment::Line(to)])
    }

    /// A line through `points`.
    #[must_use]
    pub fn polyline(points: &[Point]) -> Self {
        let piece = |(i, &p): (usize, &Point)| if i == 0 { Segment::Move(p) } else { Segment::Line(p) };
        Self::Segments(points.iter().enumerate().map(piece).collect())
    }

    /// A line through `points` and back to the first.
    #[must_use]
    pub fn polygon(points: &[Point]) -> Self {
        let Self::Segments(mut segments) = Self::polyline(points) else { return Self::Segments(Vec::new()) };
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
        /// Its radius in page pixels.
        radius: f64,
        /// Where it starts: radians from the x axis towards the y axis, which is clockwise on the page.
        start: f64,
        /// How far it runs, in radians, clockwise on the page where positive; at most a full turn.
        sweep: f64,
    },
    /// A straight line back to the last [`Segment::Move`].
    Close,
}
