//! Markers: points that have a meaning, told apart by shape as well as by colour.

use std::f64::consts::TAU;

use crate::drawing::{Contour, Item, Offset, Path, Point, Rect, Role, Shown};
use crate::geometry::DVec2;

use super::{Cover, Dash, MARKER, Marker, Outline, Pen, Sketch, Wash, angle_of};

/// Line width of hollow markers, page pixels.
const HOLLOW: f64 = 1.75;
/// Half the edge of the square that looks as large as a disc of radius 1.
const SQUARE: f64 = 0.89;
/// Half the diagonal of the diamond that looks as large as a disc of radius 1.
const DIAMOND: f64 = 1.2;
/// Half the diagonal of a diamond that is not filled, in radii of a disc: its background must be seen.
const OPEN: f64 = 1.45;
/// Radius of the ring about the origin, in radii of a usual disc.
const RING: f64 = 1.75;
/// Radius of the dot in that ring, in radii of a usual disc: at 1 the ring closes at a third of the size.
const ORIGIN_DOT: f64 = 0.8;
/// Half the opening of that ring where an arrow ends in it, radians: as wide as its head is there.
const OPENING: f64 = 0.34;
/// Radius of the dot there, in radii of a usual disc: the head's point is as wide.
const YIELDING_DOT: f64 = 0.45;
/// A closed outline that reaches less than this in any direction has no form to be seen, page pixels: half
/// the width of its line.
pub(crate) const SPECK: f64 = 1.0;

impl Sketch<'_> {
    /// Draws a marker of `radius` page pixels, less on a small page, at a point of the panel's space.
    pub(crate) fn marker(&mut self, at: DVec2, marker: Marker, role: Role, radius: f64) -> &mut Self {
        self.reach(&[at]);
        let radius = radius * self.unit;
        let p = self.frame.page(at);
        self.keep_off(Cover::Marker { at: p, radius: marker.reach(radius) });
        let disc = |r: f64| Contour::Circle { center: p, radius: r };
        match marker {
            Marker::Disc => self.solid(disc(radius), role),
            Marker::Square => self.solid(square(p, SQUARE * radius), role),
            Marker::Diamond => self.solid(diamond(p, DIAMOND * radius), role),
            Marker::HollowDisc => self.hollow(disc(radius), role),
            Marker::HollowSquare => self.hollow(square(p, SQUARE * radius), role),
            Marker::HollowDiamond => self.hollow(diamond(p, OPEN * radius), role),
            Marker::Cross => self.cross(p, radius, role),
            Marker::Origin => self.origin(at, radius, role),
        }
    }

    /// Where an outline is that closes about next to nothing.
    pub(super) fn speck(&self, outline: &Outline, points: &[DVec2]) -> Option<DVec2> {
        let page = points.iter().map(|&p| self.frame.page(p));
        let bounds = page.map(|p| Rect::new(p, p)).reduce(Rect::union)?;
        let small = outline.closed && bounds.width() < SPECK && bounds.height() < SPECK;
        points.first().copied().filter(|_| small)
    }

    /// Draws an area that is a point as a marker, a dotted one as a ring.
    pub(super) fn as_point(&mut self, at: DVec2, wash: Option<Wash>, pen: Option<Pen>) -> &mut Self {
        let Some(role) = pen.map(|p| p.role).or(wash.map(|w| w.role)) else { return self };
        match pen.filter(|p| p.dash != Dash::Solid) {
            Some(pen) => self.ring(at, pen),
            None => self.marker(at, Marker::of(role), role, MARKER),
        }
    }

    /// Draws a ring of a usual marker's size about a point of the panel's space.
    fn ring(&mut self, at: DVec2, pen: Pen) -> &mut Self {
        self.reach(&[at]);
        let (center, radius) = (self.frame.page(at), MARKER * self.unit);
        self.keep_off(Cover::Marker { at: center, radius });
        self.push_stroked(Contour::Circle { center, radius }, pen);
        self
    }

    /// Draws a filled marker.
    fn solid(&mut self, contour: Contour, role: Role) -> &mut Self {
        let paint = self.paint(role);
        self.push(Item::Path(Path::filled(contour, paint)))
    }

    /// Draws a marker in outline, filled with the background.
    fn hollow(&mut self, contour: Contour, role: Role) -> &mut Self {
        let stroke = self.stroke_of(Pen::vector(role).width(HOLLOW));
        let fill = Some(self.paint(Role::Background));
        self.push(Item::Path(Path {
            contour,
            fill,
            pattern: None,
            stroke: Some(stroke),
            shown: Shown::ALWAYS,
        }))
    }

    /// Draws a dot in a ring, which is not filled: what begins or ends there is seen up to the dot, at its
    /// true length. It yields to an arrow that ends there, whose point is the origin.
    fn origin(&mut self, at: DVec2, radius: f64, role: Role) -> &mut Self {
        let (center, ring, pen) = (self.frame.page(at), RING * radius, Pen::vector(role).width(HOLLOW));
        let ends = |(tip, _): &&(DVec2, DVec2)| (self.frame.page(*tip) - center).length() < SPECK;
        let disc = |radius| Contour::Circle { center, radius };
        let Some(&(_, tail)) = self.tips.iter().find(ends) else {
            self.push_stroked(disc(ring), pen);
            return self.solid(disc(ORIGIN_DOT * radius), role);
        };
        let ring = ring / self.frame.scale;
        self.arc(at, ring, angle_of(tail - at) + OPENING, TAU - 2.0 * OPENING, pen);
        self.solid(disc(YIELDING_DOT * radius), role)
    }

    /// Draws two lines across each other.
    fn cross(&mut self, p: Point, radius: f64, role: Role) -> &mut Self {
        for d in [Offset::new(radius, radius), Offset::new(radius, -radius)] {
            self.push_stroked(Contour::line(p + -d, p + d), Pen::vector(role));
        }
        self
    }
}

impl Marker {
    /// The shape of points of a body or of a difference.
    #[must_use]
    fn of(role: Role) -> Self {
        match role {
            Role::B => Self::Square,
            Role::Difference => Self::Diamond,
            _ => Self::Disc,
        }
    }

    /// How far what ends at a marker of `radius` page pixels stays off its point, page pixels: as far as that
    /// is filled.
    #[must_use]
    pub(crate) fn rim(self, radius: f64) -> f64 {
        if self == Self::Origin { ORIGIN_DOT * radius } else { self.reach(radius) }
    }

    /// How far a marker of `radius` page pixels reaches from its point at most, page pixels.
    #[must_use]
    pub(crate) fn reach(self, radius: f64) -> f64 {
        match self {
            Self::Origin => radius * RING + 0.5 * HOLLOW,
            Self::HollowDiamond => radius * OPEN + 0.5 * HOLLOW,
            Self::Square | Self::HollowSquare | Self::Diamond | Self::Cross => radius * DIAMOND,
            Self::Disc => radius,
            Self::HollowDisc => radius + 0.5 * HOLLOW,
        }
    }
}

/// A square about a point of the page; `half` its edge in page pixels.
fn square(p: Point, half: f64) -> Contour {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    Contour::polygon(&corners.map(|(x, y)| p + Offset::new(x * half, y * half)))
}

/// A square on its vertex about a point of the page; `reach` in page pixels.
fn diamond(p: Point, reach: f64) -> Contour {
    let corners = [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)];
    Contour::polygon(&corners.map(|(x, y)| p + Offset::new(x * reach, y * reach)))
}
