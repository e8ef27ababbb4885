//! What lines, areas and markers look like: the sizes of the house, in page pixels.

use crate::drawing::Role;

/// A line's pattern along itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dash {
    /// Unbroken.
    Solid,
    /// Construction, 7 on 4 off.
    Dashed,
    /// Another time.
    Dotted,
    /// An edge of a difference that comes from B: longer dashes than construction.
    Long,
}

impl Dash {
    /// Lengths of dashes and gaps in page pixels for a line of this width.
    #[must_use]
    pub(crate) fn lengths(self, width: f64) -> Vec<f64> {
        match self {
            Self::Solid => Vec::new(),
            Self::Dashed => vec![7.0, 4.0],
            Self::Dotted => vec![0.0, 2.2 * width.max(1.0)],
            Self::Long => vec![11.0, 3.5],
        }
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pen {
    /// Its colour.
    pub(crate) role: Role,
    /// Page pixels.
    pub(crate) width: f64,
    /// Its pattern.
    pub(crate) dash: Dash,
    /// From 0 to 1.
    pub(crate) opacity: f64,
}

impl Pen {
    const fn of(role: Role, width: f64, dash: Dash) -> Self {
        Self { role, width, dash, opacity: 1.0 }
    }

    /// The outline of a body: 2.25 px.
    #[must_use]
    pub(crate) const fn outline(role: Role) -> Self {
        Self::of(role, 2.25, Dash::Solid)
    }

    /// What a figure is about: 3 px.
    #[must_use]
    pub(crate) const fn highlighted(role: Role) -> Self {
        Self::of(role, 3.0, Dash::Solid)
    }

    /// The shaft of a vector: 1.75 px.
    #[must_use]
    pub(crate) const fn vector(role: Role) -> Self {
        Self::of(role, 1.75, Dash::Solid)
    }

    /// Construction lines: 1.5 px, dashed.
    #[must_use]
    pub(crate) const fn construction(role: Role) -> Self {
        Self::of(role, 1.5, Dash::Dashed)
    }

    /// Another time or place: 1.5 px, dotted; at 1.25 the dots were lost on a third of the size.
    #[must_use]
    pub(crate) const fn ghost(role: Role) -> Self {
        Self::of(role, 1.5, Dash::Dotted)
    }

    /// Dimension lines: 1 px.
    #[must_use]
    pub(crate) const fn dimension(role: Role) -> Self {
        Self::of(role, 1.0, Dash::Solid)
    }

    /// Coordinate axes: 1 px.
    #[must_use]
    pub(crate) const fn axis() -> Self {
        Self::of(Role::Muted, 1.0, Dash::Solid)
    }

    /// Extension lines of dimensions: 0.75 px, dashed, muted.
    #[must_use]
    pub(crate) const fn extension() -> Self {
        Self::of(Role::Muted, 0.75, Dash::Dashed)
    }

    /// The same at another width in page pixels.
    #[must_use]
    pub(crate) const fn width(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// The same with another pattern.
    #[must_use]
    pub(crate) const fn dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// The same, fainter: from 0 to 1.
    #[must_use]
    pub(crate) const fn opacity(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }
}

/// How an area is filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wash {
    /// Its colour, and its pattern where the theme has one for the role.
    pub(crate) role: Role,
    /// From 0 to 1; none for the theme's own.
    pub(crate) opacity: Option<f64>,
}

impl Wash {
    /// The theme's fill for a role.
    #[must_use]
    pub(crate) const fn theme(role: Role) -> Self {
        Self { role, opacity: None }
    }

    /// A faint fill, without the theme's pattern.
    #[must_use]
    pub(crate) const fn faint(role: Role, opacity: f64) -> Self {
        Self { role, opacity: Some(opacity) }
    }
}

/// The shape of a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Marker {
    /// Points of A, and of nobody.
    Disc,
    /// Points of B.
    Square,
    /// Vertices of a difference.
    Diamond,
    /// A square, not filled.
    HollowSquare,
    /// A centre.
    Cross,
    /// The origin: a dot in a ring.
    Origin,
    /// A disc in a ring: a new estimate.
    RingedDisc,
}

/// Radius of a usual marker, page pixels.
pub(crate) const MARKER: f64 = 4.5;
/// Radius of a marker that stands back.
pub(crate) const SMALL_MARKER: f64 = 3.0;
/// Radius of a marker that the figure is about.
pub(crate) const LARGE_MARKER: f64 = 6.0;
