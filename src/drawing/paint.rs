//! Colours by role, strokes, patterns and halos.

/// What a drawn thing stands for; it decides the thing's colour in every theme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// The first body, A.
    A,
    /// The second body, B.
    B,
    /// The Minkowski difference B ⊖ A.
    Difference,
    /// What changes or moves at the step shown.
    Now,
    /// The minimum translation, and the separation of bodies apart.
    Translation,
    /// Where two bodies overlap: the colour of the area itself, opaque.
    Overlap,
    /// Text and main lines.
    Ink,
    /// Secondary lines and notes.
    Muted,
    /// Grid lines.
    Grid,
    /// The page itself.
    Background,
}

impl Role {
    /// Every role, in the order of themes and style sheets.
    pub const ALL: [Self; 10] = [
        Self::A,
        Self::B,
        Self::Difference,
        Self::Now,
        Self::Translation,
        Self::Overlap,
        Self::Ink,
        Self::Muted,
        Self::Grid,
        Self::Background,
    ];

    /// The roles that words may wear, as in `{a|the box}`: those whose colours can be read on the page.
    pub const OF_WORDS: [Self; 7] =
        [Self::A, Self::B, Self::Difference, Self::Now, Self::Translation, Self::Ink, Self::Muted];

    /// What plays it, in a line.
    ///
    /// ```
    /// assert_eq!(tracefig::drawing::Role::Grid.about(), "grid lines");
    /// ```
    #[must_use]
    pub fn about(self) -> &'static str {
        match self {
            Self::A => "the first body, A",
            Self::B => "the second body, B",
            Self::Difference => "the Minkowski difference",
            Self::Now => "what is new at the step shown",
            Self::Translation => "the minimum translation, the separation",
            Self::Overlap => "where bodies overlap, the opaque colour of the area",
            Self::Ink => "text and main lines",
            Self::Muted => "secondary lines and notes",
            Self::Grid => "grid lines",
            Self::Background => "the page",
        }
    }

    /// The word for it in themes, in markup and in custom properties, as in `--tracefig-a`.
    ///
    /// ```
    /// assert_eq!(tracefig::drawing::Role::Translation.name(), "translation");
    /// ```
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::A => "a",
            Self::B => "b",
            Self::Difference => "difference",
            Self::Now => "now",
            Self::Translation => "translation",
            Self::Overlap => "overlap",
            Self::Ink => "ink",
            Self::Muted => "muted",
            Self::Grid => "grid",
            Self::Background => "background",
        }
    }
}

/// An sRGB colour, 8 bits a channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
}

impl Color {
    /// The colour written `#RRGGBB` for `0xRRGGBB`.
    ///
    /// ```
    /// use tracefig::drawing::Color;
    /// assert_eq!(Color::hex(0xA3161F), Color { r: 0xA3, g: 0x16, b: 0x1F });
    /// ```
    #[must_use]
    pub const fn hex(rgb: u32) -> Self {
        let [_, r, g, b] = rgb.to_be_bytes();
        Self { r, g, b }
    }
}

impl std::fmt::Display for Color {
    /// Writes it as a theme file does, `#RRGGBB`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { r, g, b } = self;
        write!(f, "#{r:02X}{g:02X}{b:02X}")
    }
}

/// A colour in its role.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paint {
    /// The role whose custom property a page may set; none for a colour that must not follow.
    pub role: Option<Role>,
    /// The colour where nobody sets another.
    pub color: Color,
    /// How much of what is below is covered, from 0 to 1.
    pub opacity: f64,
}

impl Paint {
    /// An opaque colour in a role.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Paint, Role};
    /// let fill = Paint::role(Role::A, Color::hex(0xA3161F)).with_opacity(0.14);
    /// assert_eq!((fill.role, fill.opacity), (Some(Role::A), 0.14));
    /// ```
    #[must_use]
    pub const fn role(role: Role, color: Color) -> Self {
        Self { role: Some(role), color, opacity: 1.0 }
    }

    /// This colour at another opacity, from 0 to 1.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Paint, Role};
    /// assert_eq!(Paint::role(Role::A, Color::hex(0)).with_opacity(0.5).opacity, 0.5);
    /// ```
    #[must_use]
    pub const fn with_opacity(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// What is seen of it on a colour: blended in sRGB, as every renderer of ours does.
    pub(crate) fn over(&self, under: Color) -> Color {
        blend(self.color, self.opacity, under)
    }
}

/// `over` at `opacity`, from 0 to 1, on `under`: blended in sRGB, as every renderer of ours does.
pub(crate) fn blend(over: Color, opacity: f64, under: Color) -> Color {
    let mix = |o: u8, u: u8| {
        let value = (opacity * f64::from(o) + (1.0 - opacity) * f64::from(u)).round().clamp(0.0, 255.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0 … 255")]
        let byte = value as u8;
        byte
    };
    Color { r: mix(over.r, under.r), g: mix(over.g, under.g), b: mix(over.b, under.b) }
}

/// How the ends of an open line, and of dashes, look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cap {
    /// Cut at the end.
    #[default]
    Butt,
    /// A half disc beyond the end; makes dots of dashes of length 0.
    Round,
}

/// A line along a contour; joins are round.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The line's colour.
    pub paint: Paint,
    /// The line's width in page pixels.
    pub width: f64,
    /// Lengths of dashes and gaps in page pixels, alternating, an even number; empty for a solid line.
    pub dash: Vec<f64>,
    /// How the line's ends look, and those of its dashes.
    pub cap: Cap,
}

impl Stroke {
    /// A solid line of a width in page pixels.
    ///
    /// ```
    /// use tracefig::drawing::{Cap, Color, Paint, Role, Stroke};
    /// let stroke = Stroke::solid(Paint::role(Role::Ink, Color::hex(0)), 1.5);
    /// assert_eq!((stroke.dash.len(), stroke.cap), (0, Cap::Butt));
    /// ```
    #[must_use]
    pub fn solid(paint: Paint, width: f64) -> Self {
        Self { paint, width, dash: Vec::new(), cap: Cap::Butt }
    }
}

/// Marks repeated over an area, so that it is told apart without colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pattern {
    /// Which marks are repeated.
    pub kind: PatternKind,
    /// The colour of the marks.
    pub paint: Paint,
}

/// The marks of a [`Pattern`]; their phase is that of the page, so that neighbours agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PatternKind {
    /// Lines at 45°, rising to the right.
    Hatch,
    /// Dots on a square grid turned by 45°.
    Dots,
}

/// A wider copy of the glyphs behind them, that keeps them readable on lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Halo {
    /// The halo's colour: the background's, under the see-through `areas`.
    pub paint: Paint,
    /// The areas that the text lies on, the lowest first: `paint` has their colours blended on the page's.
    pub areas: Vec<Paint>,
    /// How far it reaches beyond the glyphs, in page pixels.
    pub width: f64,
}

impl Halo {
    /// A halo of one colour that reaches `width` page pixels beyond the glyphs.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Halo, Paint, Role};
    /// let halo = Halo::plain(Paint::role(Role::Background, Color::hex(0xFFFFFF)), 2.5);
    /// assert_eq!((halo.width, halo.areas.len()), (2.5, 0));
    /// ```
    #[must_use]
    pub const fn plain(paint: Paint, width: f64) -> Self {
        Self { paint, areas: Vec::new(), width }
    }
}
