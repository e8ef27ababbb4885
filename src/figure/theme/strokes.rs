//! Widths of lines, by what a line is: those of the house, and what a theme makes of them.
//!
//! A layer draws a line of a kind, as "the outline of a body", and may make it thinner or thicker than usual;
//! a theme gives the kind another width, and every line of that kind keeps its proportion to it.

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// The outline of a body.
    Outline,
    /// What a figure is about.
    Highlighted,
    /// The shaft of a vector.
    Vector,
    /// Construction.
    Construction,
    /// A path through time.
    Path,
    /// The outline of a body at another time or place.
    Ghost,
    /// A dimension.
    Dimension,
    /// An axis.
    Axes,
    /// A line of a grid, and other lines that stand back.
    Grid,
}

impl LineKind {
    /// Every kind, in the order of [`Strokes`].
    pub const ALL: [Self; 9] = [
        Self::Outline,
        Self::Highlighted,
        Self::Vector,
        Self::Construction,
        Self::Path,
        Self::Ghost,
        Self::Dimension,
        Self::Axes,
        Self::Grid,
    ];

    /// The key for it in a theme file.
    ///
    /// ```
    /// assert_eq!(tracefig::figure::theme::LineKind::Axes.name(), "axes");
    /// ```
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Outline => "outline",
            Self::Highlighted => "highlighted",
            Self::Vector => "vector",
            Self::Construction => "construction",
            Self::Path => "path",
            Self::Ghost => "ghost",
            Self::Dimension => "dimension",
            Self::Axes => "axes",
            Self::Grid => "grid",
        }
    }

    /// What is drawn so, in words.
    pub(super) fn about(self) -> &'static str {
        match self {
            Self::Outline => "outlines of bodies, and of their difference",
            Self::Highlighted => "what a figure is about",
            Self::Vector => "shafts of vectors; heads grow with them",
            Self::Construction => "construction lines, dashed",
            Self::Path => "paths through time",
            Self::Ghost => "bodies at another time or place, dotted",
            Self::Dimension => "dimensions, radii, angles",
            Self::Axes => "axes",
            Self::Grid => "grids, and lines out to a dimension",
        }
    }

    /// The width of the house on the usual page, page pixels.
    ///
    /// ```
    /// assert_eq!(tracefig::figure::theme::LineKind::Outline.width(), 2.1);
    /// ```
    #[must_use]
    pub const fn width(self) -> f64 {
        match self {
            Self::Outline | Self::Vector => 2.1,
            Self::Highlighted => 3.0,
            Self::Construction | Self::Dimension => 1.25,
            Self::Path | Self::Ghost => 1.5,
            Self::Axes => 1.0,
            Self::Grid => 0.75,
        }
    }
}

/// How wide a theme draws each kind of line, against the house.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strokes([f64; 9]);

impl Strokes {
    /// The widths of the house.
    pub(super) const HOUSE: Self = Self([1.0; 9]);
    /// The least and the largest width of a line on the usual page, page pixels: a thinner one is lost on a
    /// page of half the size, a thicker one covers what it meets.
    pub(super) const RANGE: (f64, f64) = (0.5, 8.0);

    /// How many times as wide as in the house a kind is drawn.
    pub(crate) fn factor(&self, kind: LineKind) -> f64 {
        LineKind::ALL.iter().zip(self.0).find(|(k, _)| **k == kind).map_or(1.0, |(_, factor)| factor)
    }

    /// The widths with another one for a kind, page pixels on the usual page.
    pub(super) fn with(mut self, kind: LineKind, width: f64) -> Self {
        for (k, factor) in LineKind::ALL.into_iter().zip(&mut self.0) {
            if k == kind {
                *factor = width / kind.width();
            }
        }
        self
    }
}
