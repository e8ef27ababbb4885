//! What a layer says of a label: its text and what it belongs to; never where it stands.

use crate::drawing::Role;
use crate::figure::theme::TextKind;
use crate::geometry::{DVec2, perp};

use super::Outline;

/// What a label belongs to, in the panel's space, from which its places are found.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Anchor {
    /// A point, to stand around.
    Point {
        /// The point, in the panel's space.
        at: DVec2,
        /// Radius that its marker covers, page pixels.
        clear: f64,
        /// The side that it should stand on, as a direction in the panel's space; zero for none.
        toward: DVec2,
    },
    /// A tick of an axis, whose number stands in line with it.
    Tick {
        /// Where the tick crosses its axis, in the panel's space.
        at: DVec2,
        /// The side of the axis that the number should stand on, as a direction in the panel's space.
        toward: DVec2,
    },
    /// A vector or line, to stand beside or beyond.
    Along {
        /// Tail, in the panel's space.
        from: DVec2,
        /// Tip, in the panel's space.
        to: DVec2,
        /// Which part of the line is best to stand at.
        best: Best,
    },
    /// A dimension line or bar beside what it measures, to stand on its far side.
    Beside {
        /// Start of what is measured, in the panel's space.
        from: DVec2,
        /// End of what is measured, in the panel's space.
        to: DVec2,
        /// How far to the left of from → to the line lies, page pixels.
        offset: f64,
    },
    /// An arc, to stand outside or inside of, at its middle or quarters.
    Arc {
        /// Centre, in the panel's space.
        center: DVec2,
        /// Radius, in units of the panel's space.
        radius: f64,
        /// Where it starts, radians counter-clockwise from +x.
        start: f64,
        /// How far it runs, radians, counter-clockwise where positive.
        sweep: f64,
    },
    /// An area, to stand inside of where there is room, else around.
    Inside {
        /// Points along the area's contour, in the panel's space.
        area: Vec<DVec2>,
    },
    /// The outline of an area that nothing fills, to stand outside of at one of its points.
    Outline {
        /// Points along the area's contour, in the panel's space.
        area: Vec<DVec2>,
        /// The point, on the contour, in the panel's space.
        at: DVec2,
        /// The side that it should stand on, as a direction in the panel's space; zero for none.
        toward: DVec2,
    },
    /// A corner or edge of the panel, to stand in.
    Corner(Corner),
}

/// Which part of a line a label stands at best.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Best {
    /// Beside the middle of the line.
    Middle,
    /// Beyond the tip of the line.
    Tip,
}

/// A corner of the panel, or the middle of its upper or lower edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corner {
    /// The upper left corner.
    TopLeft,
    /// The middle of the upper edge.
    Top,
    /// The upper right corner.
    TopRight,
    /// The lower left corner.
    BottomLeft,
    /// The middle of the lower edge.
    Bottom,
    /// The lower right corner.
    BottomRight,
}

impl Corner {
    /// Every corner with its word in a scene, and where it lies from the panel's middle: x to the right, y
    /// down.
    const ALL: [(&'static str, Self, (f64, f64)); 6] = [
        ("top-left", Self::TopLeft, (-1.0, -1.0)),
        ("top", Self::Top, (0.0, -1.0)),
        ("top-right", Self::TopRight, (1.0, -1.0)),
        ("bottom-left", Self::BottomLeft, (-1.0, 1.0)),
        ("bottom", Self::Bottom, (0.0, 1.0)),
        ("bottom-right", Self::BottomRight, (1.0, 1.0)),
    ];

    /// The words of all corners in a scene.
    pub(crate) const WORDS: [&'static str; 6] = {
        let mut words = [""; 6];
        let mut i = 0;
        while i < words.len() {
            words[i] = Self::ALL[i].0;
            i += 1;
        }
        words
    };

    /// The corner of a word; `None` for any other word.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, ..)| *known == word).map(|&(_, corner, _)| corner)
    }

    /// Where the corner lies from the panel's middle, −1, 0 or 1 each: x to the right, y down.
    pub(crate) fn direction(self) -> (f64, f64) {
        Self::ALL
            .iter()
            .find(|(_, corner, _)| *corner == self)
            .map_or((0.0, 0.0), |&(.., direction)| direction)
    }
}

impl Anchor {
    /// Around a point of the panel's space that has a usual marker.
    #[must_use]
    pub(crate) fn point(at: DVec2) -> Self {
        Self::Point { at, clear: super::pen::MARKER, toward: DVec2::ZERO }
    }

    /// Around a point of the panel's space, in the direction of `toward` if there is room there.
    #[must_use]
    pub(crate) fn point_toward(at: DVec2, toward: DVec2) -> Self {
        Self::Point { at, clear: super::pen::MARKER, toward }
    }

    /// Beyond the tip of a vector of the panel's space.
    #[must_use]
    pub(crate) fn tip(from: DVec2, to: DVec2) -> Self {
        Self::Along { from, to, best: Best::Tip }
    }

    /// Beside the middle of a line of the panel's space.
    #[must_use]
    pub(crate) fn middle(from: DVec2, to: DVec2) -> Self {
        Self::Along { from, to, best: Best::Middle }
    }

    /// Inside an area of the panel's space, best where no other area is that a label stands in.
    #[must_use]
    pub(crate) fn inside(area: &Outline) -> Self {
        Self::Inside { area: area.sampled() }
    }

    /// Outside of the outline of an area that nothing fills, at a point of it, in the direction of `toward`;
    /// all in the panel's space.
    #[must_use]
    pub(crate) fn outline(area: &Outline, at: DVec2, toward: DVec2) -> Self {
        Self::Outline { area: area.sampled(), at, toward }
    }

    /// Points of the panel's space that it is made of; none for a corner of the panel.
    #[must_use]
    pub(crate) fn points(&self) -> Vec<DVec2> {
        match self {
            Self::Point { at, .. } | Self::Tick { at, .. } => vec![*at],
            Self::Along { from, to, .. } | Self::Beside { from, to, .. } => vec![*from, *to],
            Self::Arc { center, radius, start, sweep } => {
                Outline::arc(*center, *radius, *start, *sweep).sampled()
            }
            Self::Inside { area } | Self::Outline { area, .. } => area.clone(),
            Self::Corner(_) => Vec::new(),
        }
    }
}

/// Which of two labels that clash beyond help is left out: the weaker one. From the weakest:
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Rank {
    /// The rank of numbers of iterations, and of words beside what is clear already.
    Word,
    /// The rank of lengths, times and vectors.
    Measure,
    /// The rank of points.
    Point,
    /// The rank of names of bodies, of the difference, of the origin.
    Name,
    /// The rank of notes at a corner of the panel.
    Note,
}

/// How large a label is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Size {
    /// The size of names of shapes.
    Name,
    /// The size of points and vectors.
    Point,
    /// The size of notes and words.
    Note,
    /// The size of numbers of iterations.
    Small,
}

impl Size {
    /// What a theme calls it.
    #[must_use]
    pub(crate) fn kind(self) -> TextKind {
        match self {
            Self::Name => TextKind::Name,
            Self::Point => TextKind::Point,
            Self::Note => TextKind::Note,
            Self::Small => TextKind::Small,
        }
    }
}

/// A label that a layer asks for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Label {
    /// The key in a scene's `[labels]`.
    pub(crate) key: &'static str,
    /// The lines where `[labels]` gives no others, as markup.
    pub(crate) lines: Vec<String>,
    /// Whether a scene wrote these lines: only then `{=…}` stands for a value, as a name may hold it too.
    pub(crate) is_given: bool,
    /// What it belongs to, in the panel's space.
    pub(crate) anchor: Anchor,
    /// The colour of its letters.
    pub(crate) role: Role,
    /// Which label is left out where two clash beyond help.
    pub(crate) rank: Rank,
    /// How large it is set.
    pub(crate) size: Size,
}

impl Label {
    /// A label of one line, of rank `Measure`, 16 px. Without text it appears only where a scene gives it
    /// one.
    #[must_use]
    pub(crate) fn new(key: &'static str, text: impl Into<String>, anchor: Anchor, role: Role) -> Self {
        let lines = vec![text.into()];
        Self { key, lines, is_given: false, anchor, role, rank: Rank::Measure, size: Size::Point }
    }

    /// The label with lines that a scene wrote.
    #[must_use]
    pub(crate) fn given(self, lines: &[String]) -> Self {
        Self { lines: lines.to_vec(), is_given: true, ..self }
    }

    /// The label with another rank.
    #[must_use]
    pub(crate) fn rank(self, rank: Rank) -> Self {
        Self { rank, ..self }
    }

    /// The label with another size.
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
