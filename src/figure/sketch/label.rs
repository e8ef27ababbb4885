//! What a layer says of a label: its text and what it belongs to; never where it stands.

use crate::drawing::Role;
use crate::geometry::{DVec2, perp};

use super::Outline;

/// What a label belongs to, in the panel's space. Places are found from it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Anchor {
    /// A point: around it.
    Point {
        /// The point.
        at: DVec2,
        /// Radius in page pixels that its marker covers.
        clear: f64,
        /// The side that it should stand on, as a direction in the panel's space; zero for none.
        toward: DVec2,
    },
    /// A vector or line: beside it, or beyond its tip.
    Along {
        /// Tail.
        from: DVec2,
        /// Tip.
        to: DVec2,
        /// Which part of it is best.
        best: Best,
    },
    /// A dimension line or bar that lies `offset` page pixels to the left of from → to.
    Beside {
        /// Start.
        from: DVec2,
        /// End.
        to: DVec2,
        /// Page pixels to the left.
        offset: f64,
    },
    /// An arc: outside or inside of it, at its middle or quarters. Angles in radians, counter-clockwise.
    Arc {
        /// Centre.
        center: DVec2,
        /// World units.
        radius: f64,
        /// Start.
        start: f64,
        /// Sweep.
        sweep: f64,
    },
    /// An area: inside where there is room, else around.
    Inside {
        /// Its contour, sampled.
        area: Vec<DVec2>,
        /// Areas that it should keep out of, sampled.
        avoid: Vec<Vec<DVec2>>,
    },
    /// A corner or side of the panel.
    Corner(Corner),
}

/// Which part of a line a label belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Best {
    /// Its middle.
    Middle,
    /// Its tip.
    Tip,
}

/// A corner or side of the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corner {
    /// Upper left.
    TopLeft,
    /// Upper middle.
    Top,
    /// Upper right.
    TopRight,
    /// Lower left.
    BottomLeft,
    /// Lower middle.
    Bottom,
    /// Lower right.
    BottomRight,
}

impl Corner {
    /// Every place with its word in a scene, and where it lies from the panel's middle: x to the right, y down.
    const ALL: [(&'static str, Self, (f64, f64)); 6] = [
        ("top-left", Self::TopLeft, (-1.0, -1.0)),
        ("top", Self::Top, (0.0, -1.0)),
        ("top-right", Self::TopRight, (1.0, -1.0)),
        ("bottom-left", Self::BottomLeft, (-1.0, 1.0)),
        ("bottom", Self::Bottom, (0.0, 1.0)),
        ("bottom-right", Self::BottomRight, (1.0, 1.0)),
    ];

    /// The words for them in a scene.
    pub(crate) const WORDS: [&'static str; 6] = {
        let mut words = [""; 6];
        let mut i = 0;
        while i < words.len() {
            words[i] = Self::ALL[i].0;
            i += 1;
        }
        words
    };

    /// The place of a word; `None` for any other word.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, ..)| *known == word).map(|&(_, corner, _)| corner)
    }

    /// Where it lies from the panel's middle, −1, 0 or 1 each: x to the right, y down.
    pub(crate) fn direction(self) -> (f64, f64) {
        Self::ALL
            .iter()
            .find(|(_, corner, _)| *corner == self)
            .map_or((0.0, 0.0), |&(.., direction)| direction)
    }
}

impl Anchor {
    /// Around a point with a usual marker.
    #[must_use]
    pub(crate) fn point(at: DVec2) -> Self {
        Self::Point { at, clear: super::pen::MARKER, toward: DVec2::ZERO }
    }

    /// Around a point, on the side of `toward` if there is room.
    #[must_use]
    pub(crate) fn point_toward(at: DVec2, toward: DVec2) -> Self {
        Self::Point { at, clear: super::pen::MARKER, toward }
    }

    /// At the tip of a vector.
    #[must_use]
    pub(crate) fn tip(from: DVec2, to: DVec2) -> Self {
        Self::Along { from, to, best: Best::Tip }
    }

    /// Beside the middle of a line.
    #[must_use]
    pub(crate) fn middle(from: DVec2, to: DVec2) -> Self {
        Self::Along { from, to, best: Best::Middle }
    }

    /// Inside an area, best where the others are not.
    #[must_use]
    pub(crate) fn inside(area: &Outline, avoid: &[Outline]) -> Self {
        Self::Inside { area: area.sampled(), avoid: avoid.iter().map(Outline::sampled).collect() }
    }

    /// The points of the panel's space that it is made of.
    #[must_use]
    pub(crate) fn points(&self) -> Vec<DVec2> {
        match self {
            Self::Point { at, .. } => vec![*at],
            Self::Along { from, to, .. } | Self::Beside { from, to, .. } => vec![*from, *to],
            Self::Arc { center, radius, start, sweep } => {
                Outline::arc(*center, *radius, *start, *sweep).sampled()
            }
            Self::Inside { area, .. } => area.clone(),
            Self::Corner(_) => Vec::new(),
        }
    }
}

/// Which label gives way to which, from the weakest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Rank {
    /// Numbers of iterations, words beside what is clear already.
    Word,
    /// Lengths, times, vectors.
    Measure,
    /// Points.
    Point,
    /// Names of bodies, of the difference, of the origin.
    Name,
    /// Formulas at a corner of the panel.
    Note,
}

/// How large a label is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Size {
    /// Names of shapes: 17 px.
    Name,
    /// Points and vectors: 16 px.
    Point,
    /// Notes and words: 14 px.
    Note,
    /// Numbers of iterations: 12 px.
    Small,
}

impl Size {
    /// Page pixels an em.
    #[must_use]
    pub(crate) fn px(self) -> f64 {
        match self {
            Self::Name => 17.0,
            Self::Point => 16.0,
            Self::Note => 14.0,
            Self::Small => 12.0,
        }
    }
}

/// A label that a layer asks for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Label {
    /// Its key in `[labels]`.
    pub(crate) key: &'static str,
    /// Default lines of markup; `{=…}` stands for values.
    pub(crate) lines: Vec<String>,
    /// What it belongs to.
    pub(crate) anchor: Anchor,
    /// Its colour.
    pub(crate) role: Role,
    /// Who gives way.
    pub(crate) rank: Rank,
    /// How large.
    pub(crate) size: Size,
}

impl Label {
    /// A label of one line, of rank `Measure`, 16 px. Without text it appears only where a scene gives it one.
    #[must_use]
    pub(crate) fn new(key: &'static str, text: impl Into<String>, anchor: Anchor, role: Role) -> Self {
        Self { key, lines: vec![text.into()], anchor, role, rank: Rank::Measure, size: Size::Point }
    }

    /// With several lines.
    #[must_use]
    pub(crate) fn lines(self, lines: &[String]) -> Self {
        Self { lines: lines.to_vec(), ..self }
    }

    /// With a rank.
    #[must_use]
    pub(crate) fn rank(self, rank: Rank) -> Self {
        Self { rank, ..self }
    }

    /// With a size.
    #[must_use]
    pub(crate) fn size(self, size: Size) -> Self {
        Self { size, ..self }
    }
}

/// The direction to the left of from → to, of unit length; zero where they coincide.
#[must_use]
pub(crate) fn left_of(from: DVec2, to: DVec2) -> DVec2 {
    perp(to - from).normalize_or_zero()
}
