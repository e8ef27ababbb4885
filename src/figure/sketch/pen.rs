//! What lines, areas and markers look like: the sizes of the house, in page pixels.

use crate::drawing::Role;
use crate::figure::theme::LineKind;
use crate::geometry::Side;

/// A line's pattern along itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dash {
    /// Unbroken.
    Solid,
    /// Dashes of 7 px and gaps of 4: construction.
    Dashed,
    /// Dots: another time or place.
    Dotted,
}

impl Dash {
    /// Lengths of dashes and gaps, page pixels, for a line of `width` page pixels; none for an unbroken one.
    #[must_use]
    pub(crate) fn lengths(self, width: f64) -> Vec<f64> {
        match self {
            Self::Solid => Vec::new(),
            Self::Dashed => vec![7.0, 4.0],
            Self::Dotted => vec![0.0, 2.2 * width.max(1.0)],
        }
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pen {
    /// The colour of the line.
    pub(crate) role: Role,
    /// What the line is: a theme may draw all of a kind thicker or thinner.
    pub(crate) kind: LineKind,
    /// Width on the usual page in the themes of the house, page pixels.
    pub(crate) width: f64,
    /// The line's pattern along itself.
    pub(crate) dash: Dash,
    /// Opacity, from 0 to 1.
    pub(crate) opacity: f64,
    /// Whether its ends are round: a corner of two lines is whole then.
    pub(crate) round: bool,
}

impl Pen {
    /// An opaque line.
    const fn of(role: Role, kind: LineKind, dash: Dash) -> Self {
        Self { role, kind, width: kind.width(), dash, opacity: 1.0, round: false }
    }

    /// A pen for the outline of a body: 2.25 px.
    #[must_use]
    pub(crate) const fn outline(role: Role) -> Self {
        Self::of(role, LineKind::Outline, Dash::Solid)
    }

    /// A pen for what a figure is about: 3 px.
    #[must_use]
    pub(crate) const fn highlighted(role: Role) -> Self {
        Self::of(role, LineKind::Highlighted, Dash::Solid)
    }

    /// A pen for the shaft of a vector: 1.75 px.
    #[must_use]
    pub(crate) const fn vector(role: Role) -> Self {
        Self::of(role, LineKind::Vector, Dash::Solid)
    }

    /// A pen for construction lines: 1.25 px, dashed, muted.
    #[must_use]
    pub(crate) const fn construction() -> Self {
        Self::of(Role::Muted, LineKind::Construction, Dash::Dashed)
    }

    /// A pen for a path through time: 1.5 px.
    #[must_use]
    pub(crate) const fn path(role: Role) -> Self {
        Self::of(role, LineKind::Path, Dash::Solid)
    }

    /// A pen for bodies at another time or place: 1.5 px, dotted; at 1.25 the dots were lost on a third of
    /// the size.
    #[must_use]
    pub(crate) const fn ghost(role: Role) -> Self {
        Self::of(role, LineKind::Ghost, Dash::Dotted)
    }

    /// A pen for dimension lines: 1 px.
    #[must_use]
    pub(crate) const fn dimension(role: Role) -> Self {
        Self::of(role, LineKind::Dimension, Dash::Solid)
    }

    /// A pen for coordinate axes: 1 px, muted.
    #[must_use]
    pub(crate) const fn axis() -> Self {
        Self::of(Role::Muted, LineKind::Axes, Dash::Solid)
    }

    /// A pen for lines of a grid: 0.75 px.
    #[must_use]
    pub(crate) const fn grid(role: Role) -> Self {
        Self::of(role, LineKind::Grid, Dash::Solid)
    }

    /// A pen for extension lines of dimensions: 0.75 px, muted.
    #[must_use]
    pub(crate) const fn extension() -> Self {
        Self::of(Role::Muted, LineKind::Grid, Dash::Solid)
    }

    /// The pen at another width, page pixels.
    #[must_use]
    pub(crate) const fn width(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// The pen with round ends.
    #[must_use]
    pub(crate) const fn round(self) -> Self {
        Self { round: true, ..self }
    }

    /// The pen at another opacity, from 0 to 1.
    #[must_use]
    pub(crate) const fn opacity(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }
}

/// How an area is filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wash {
    /// The colour of the area, and its pattern where the theme has one for the role.
    pub(crate) role: Role,
    /// Opacity, from 0 to 1; `None` for the theme's own.
    pub(crate) opacity: Option<f64>,
}

impl Wash {
    /// The theme's own fill for a role.
    #[must_use]
    pub(crate) const fn theme(role: Role) -> Self {
        Self { role, opacity: None }
    }

    /// A faint fill, without the theme's pattern; `opacity` from 0 to 1.
    #[must_use]
    pub(crate) const fn faint(role: Role, opacity: f64) -> Self {
        Self { role, opacity: Some(opacity) }
    }
}

/// The shape of a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Marker {
    /// A filled disc: points of A, and of nobody.
    Disc,
    /// A filled square: points of B.
    Square,
    /// A filled square on its vertex: points of a difference.
    Diamond,
    /// A disc, not filled: supporting vertices of A.
    HollowDisc,
    /// A square, not filled: supporting vertices of B.
    HollowSquare,
    /// A square on its vertex, not filled: what is new in this step.
    HollowDiamond,
    /// Two lines across each other: a centre.
    Cross,
    /// A disc in a ring: the origin, and nothing else.
    Origin,
}

/// Radius of a usual marker, page pixels.
pub(crate) const MARKER: f64 = 4.5;
/// Radius of a marker that stands back.
pub(crate) const SMALL_MARKER: f64 = 3.0;
/// Radius of a marker that the figure is about.
pub(crate) const LARGE_MARKER: f64 = 6.0;

impl From<Side> for Role {
    fn from(side: Side) -> Self {
        match side {
            Side::A => Self::A,
            Side::B => Self::B,
        }
    }
}
