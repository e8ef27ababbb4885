//! The display list: paths, glyph runs and groups with roles and accessible names, in page pixels, y down.
//!
//! This list is closed: an output format draws a [`Drawing`] by looking at these types and at nothing else. A
//! circle stays a circle and an arc an arc, so that each format can choose its own way to say them.

mod clip;
mod extent;
mod motion;
mod offset;
mod paint;
mod path;
mod pattern;
mod shown;
mod steps;

use std::sync::Arc;

pub use clip::Clip;
pub use motion::MotionFrame;
pub use offset::Offset;
pub(crate) use paint::blend;
pub use paint::{Cap, Color, Halo, Paint, Pattern, PatternKind, Role, Stroke};
pub use path::{Contour, Path, Segment};
pub use shown::{Shown, Step};

use crate::typeset::Line;

/// A page point in pixels, x right, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Pixels right of the page's left edge.
    pub x: f64,
    /// Pixels below the page's top edge.
    pub y: f64,
}

impl Point {
    /// The point `x` right and `y` down of the page's upper left corner.
    ///
    /// ```
    /// use tracefig::drawing::{Offset, Point};
    /// assert_eq!(Point::new(3.0, 4.0) - Point::new(1.0, 1.0), Offset::new(2.0, 3.0));
    /// ```
    #[must_use]
    pub fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }
}

/// A page rectangle in pixels, `x0 ≤ x1` and `y0 ≤ y1`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rect {
    /// The left edge.
    pub x0: f64,
    /// The top edge.
    pub y0: f64,
    /// The right edge.
    pub x1: f64,
    /// The bottom edge.
    pub y1: f64,
}

/// One figure, ready to be written in any format.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Page width in pixels.
    pub width: f64,
    /// Page height in pixels.
    pub height: f64,
    /// Prefix of every id in an SVG: a letter, then letters, digits, `-` and `_`.
    pub id: String,
    /// The language of the words of the scene, as `de` or `pt-BR`; none where it is not said.
    pub lang: Option<String>,
    /// The title as plain text; the short alternative text.
    pub title: String,
    /// Whether the title is of the scene, in its language; else it is in words of ours, as the long text is.
    pub is_titled: bool,
    /// What it is about, without its answer, for who sees it come about; none where the title alone says it.
    pub heading: Option<String>,
    /// The long alternative text.
    pub desc: String,
    /// The page's colour, opaque; of opacity 0 where the page has none and what it lies on is seen.
    pub background: Paint,
    /// The colour of words around the drawing, as those of a page that shows it.
    pub ink: Color,
    /// The colours of words by role, of roles whose words have another colour than their lines, here or in
    /// the dark.
    pub words: Vec<(Role, Color)>,
    /// Opacity of the fills of areas; a page that sets other colours may set another one too.
    pub fill_opacity: f64,
    /// The other colours of an "auto" theme; none for a fixed theme.
    pub dark: Option<Dark>,
    /// JSON that says what is shown: format version, hash, answer, numbers of the trace. May be empty.
    pub metadata: String,
    /// Hash of the scene and its options, as text. May be empty.
    pub hash: String,
    /// Everything drawn, in painting order.
    pub items: Vec<Item>,
    /// The steps in which the figure comes about, the first one first; none where it has none.
    pub steps: Vec<Step>,
    /// The pictures that lead to the figure where it plays; none where it does not.
    pub motion: Vec<MotionFrame>,
    /// What a page as narrow as a phone shows of the figure, in as many steps; none where that is not drawn.
    pub narrow: Option<Box<Drawing>>,
}

impl Drawing {
    /// The language of words of ours where they are in no other one.
    pub(crate) const OWN_LANG: &'static str = "en";
    /// The languages that words of ours can be in.
    pub(crate) const LANGS: [&'static str; 4] = [Self::OWN_LANG, "de", "fr", "es"];

    /// The languages of the title and of the long text, where they are not that of the drawing.
    pub(crate) fn languages_of_words(&self) -> [Option<&'static str>; 2] {
        let other = Some(Self::OWN_LANG).filter(|_| !self.speaks_ours());
        [other.filter(|_| !self.is_titled), other]
    }

    /// Whether words of ours are in its language, or it does not say which that is.
    pub(crate) fn speaks_ours(&self) -> bool {
        self.lang.is_none() || self.of_langs().is_some()
    }

    /// Which of [`Self::LANGS`] it says that it is in.
    pub(crate) fn of_langs(&self) -> Option<usize> {
        let language = self.lang.as_deref()?.split('-').next()?;
        Self::LANGS.iter().position(|known| language.eq_ignore_ascii_case(known))
    }
}

impl Drawing {
    /// Page pixels of an em of its smallest words; none where it has no words.
    #[must_use]
    pub(crate) fn smallest_words(&self) -> Option<f64> {
        fn sizes(items: &[Item], all: &mut Vec<f64>) {
            for item in items {
                match item {
                    Item::Group(group) => sizes(&group.items, all),
                    Item::Text(text) => all.extend(text.line.runs.iter().map(|run| run.size)),
                    Item::Path(_) => {}
                }
            }
        }
        let mut all = Vec::new();
        sizes(&self.items, &mut all);
        all.into_iter().reduce(f64::min)
    }

    /// The hash that all drawings of a file have; none where they differ or have none.
    pub(crate) fn hash_of_all<'d>(drawings: &[&'d Self]) -> Option<&'d str> {
        let first = drawings.first().map(|drawing| drawing.hash.as_str()).filter(|hash| !hash.is_empty());
        first.filter(|first| drawings.iter().all(|drawing| drawing.hash == *first))
    }

    /// Whether what the page lies on is seen between what is drawn.
    #[must_use]
    pub(crate) fn is_transparent(&self) -> bool {
        self.background.opacity == 0.0
    }
}

/// How a drawing looks for readers whose system is dark.
#[derive(Clone, Debug, PartialEq)]
pub struct Dark {
    /// The colours by role.
    pub colors: Vec<(Role, Color)>,
    /// The colour of words around the drawing.
    pub ink: Color,
    /// The colours of words by role, of the same roles as [`Drawing::words`].
    pub words: Vec<(Role, Color)>,
    /// The opacity that takes the place of [`Drawing::fill_opacity`].
    pub fill_opacity: f64,
}

/// One entry of the display list.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// Items that belong together.
    Group(Group),
    /// A filled or stroked contour.
    Path(Path),
    /// A line of text.
    Text(Text),
}

/// Items that belong together: a panel, a layer, a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Name of the layer or part; in an SVG the end of the group's id and its class.
    pub name: String,
    /// The role that its items play, where they share one.
    pub role: Option<Role>,
    /// Accessible name, which a screen reader says; none for a group without meaning of its own.
    pub label: Option<String>,
    /// Opacity of the group as a whole, from 0 to 1: what overlaps inside it is not seen through.
    pub opacity: f64,
    /// Where nothing of the group is drawn outside; none draws all.
    pub clip: Option<Clip>,
    /// The items, in painting order.
    pub items: Vec<Item>,
}

impl Group {
    /// An empty group of full opacity, without role, label or clip.
    ///
    /// ```
    /// let group = tracefig::drawing::Group::new("grid");
    /// assert_eq!((group.opacity, group.clip, group.items.len()), (1.0, None, 0));
    /// ```
    #[must_use]
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), role: None, label: None, opacity: 1.0, clip: None, items: Vec::new() }
    }
}

/// A line of text at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The set line; shared, as labels are measured, placed and drawn.
    pub line: Arc<Line>,
    /// The left end of the baseline, on the page.
    pub origin: Point,
    /// The colour of the glyphs and rules.
    pub paint: Paint,
    /// A rim behind the glyphs; none where they need no background of their own.
    pub halo: Option<Halo>,
    /// Which steps of the figure show it.
    pub shown: Shown,
}
