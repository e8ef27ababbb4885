//! Sizes of letters, by what a text is: those of the house, and what a theme makes of them.

/// What a text is, which says how large it is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextKind {
    /// Names of shapes.
    Name,
    /// Points and vectors.
    Point,
    /// Notes and words.
    Note,
    /// Numbers of iterations and of axes.
    Small,
    /// Titles of panels.
    Title,
    /// The caption.
    Caption,
    /// The headline.
    Headline,
}

impl TextKind {
    /// Every kind, in the order of [`TypeSizes`].
    pub const ALL: [Self; 7] =
        [Self::Name, Self::Point, Self::Note, Self::Small, Self::Title, Self::Caption, Self::Headline];

    /// The key for it in a theme file.
    ///
    /// ```
    /// assert_eq!(tracefig::figure::theme::TextKind::Note.name(), "note");
    /// ```
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Name => "name",
            Self::Point => "point",
            Self::Note => "note",
            Self::Small => "small",
            Self::Title => "title",
            Self::Caption => "caption",
            Self::Headline => "headline",
        }
    }

    /// What is set so, in words.
    pub(super) fn about(self) -> &'static str {
        match self {
            Self::Name => "names of shapes",
            Self::Point => "points, vectors and lengths",
            Self::Note => "notes and words at things",
            Self::Small => "numbers of steps and of axes",
            Self::Title => "titles of panels",
            Self::Caption => "the caption",
            Self::Headline => "the headline",
        }
    }

    /// The size of the house on the usual page, page pixels an em.
    ///
    /// ```
    /// assert_eq!(tracefig::figure::theme::TextKind::Name.size(), 17.0);
    /// ```
    #[must_use]
    pub const fn size(self) -> f64 {
        match self {
            Self::Name => 17.0,
            Self::Point => 16.0,
            Self::Note | Self::Caption => 14.0,
            Self::Small => 12.0,
            Self::Title => 13.0,
            Self::Headline => 19.0,
        }
    }
}

/// How large a theme sets each kind of text, page pixels an em on the usual page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TypeSizes([f64; 7]);

impl TypeSizes {
    /// The sizes of the house.
    pub(crate) const HOUSE: Self = Self([
        TextKind::Name.size(),
        TextKind::Point.size(),
        TextKind::Note.size(),
        TextKind::Small.size(),
        TextKind::Title.size(),
        TextKind::Caption.size(),
        TextKind::Headline.size(),
    ]);
    /// The least and the largest size: letters of less can't be read, and formulas have scripts of six tenths
    /// of it; larger ones leave no room for the picture.
    pub(super) const RANGE: (f64, f64) = (11.0, 40.0);

    /// The size of a kind, page pixels an em on the usual page.
    pub(crate) fn of(&self, kind: TextKind) -> f64 {
        TextKind::ALL.iter().zip(self.0).find(|(k, _)| **k == kind).map_or(kind.size(), |(_, size)| size)
    }

    /// The sizes with another one for a kind.
    pub(super) fn with(mut self, kind: TextKind, size: f64) -> Self {
        for (k, own) in TextKind::ALL.into_iter().zip(&mut self.0) {
            if k == kind {
                *own = size;
            }
        }
        self
    }
}
