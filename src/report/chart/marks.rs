//! Markers of series.

use super::LINES;
use crate::drawing::{Contour, Paint, Path, Point, Shown, Stroke};

/// The shape of a series's points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Marker {
    /// A filled disc.
    Disc,
    /// A filled square.
    Square,
    /// A filled diamond.
    Diamond,
    /// A filled triangle.
    Triangle,
    /// A ring.
    Ring,
    /// An open square.
    HollowSquare,
    /// An open diamond.
    HollowDiamond,
}

/// Half the size of a marker, page pixels.
const HALF: f64 = 4.5;

impl Marker {
    /// Every marker, in the order in which series take them.
    pub(crate) const ALL: [Self; 7] = [
        Self::Disc,
        Self::Square,
        Self::Diamond,
        Self::Triangle,
        Self::Ring,
        Self::HollowSquare,
        Self::HollowDiamond,
    ];

    /// The marker at a place; open ones are filled with the background.
    pub(super) fn path(self, at: Point, paint: Paint, background: Paint) -> Path {
        let shifted = |(dx, dy): (f64, f64)| Point::new(at.x + dx * HALF, at.y + dy * HALF);
        let polygon = |corners: &[(f64, f64)]| {
            Contour::polygon(&corners.iter().map(|&c| shifted(c)).collect::<Vec<_>>())
        };
        let square = [(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)];
        let diamond = [(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)];
        let contour = match self {
            Self::Disc | Self::Ring => Contour::Circle { center: at, radius: HALF },
            Self::Square | Self::HollowSquare => polygon(&square),
            Self::Diamond | Self::HollowDiamond => polygon(&diamond),
            Self::Triangle => polygon(&[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)]),
        };
        let open = matches!(self, Self::Ring | Self::HollowSquare | Self::HollowDiamond);
        let fill = if open { background } else { paint };
        Path {
            contour,
            fill: Some(fill),
            pattern: None,
            stroke: Some(Stroke::solid(paint, LINES[0])),
            shown: Shown::ALWAYS,
        }
    }
}
