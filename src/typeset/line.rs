//! What typesetting gives: a line of placed glyphs and rules, in page pixels.

use std::fmt;
use std::ops::Range;

/// How words and formulas are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Page pixels of an em.
    pub size: f64,
    /// The weight of the words; formulas have their own face.
    pub weight: Weight,
}

impl Style {
    /// Regular words at `size` page pixels an em.
    ///
    /// ```
    /// use tracefig::typeset::{Style, Weight};
    /// assert_eq!(Style::regular(14.0), Style { size: 14.0, weight: Weight::Regular });
    /// ```
    #[must_use]
    pub fn regular(size: f64) -> Self {
        Self { size, weight: Weight::Regular }
    }

    /// Semibold words at `size` page pixels an em.
    ///
    /// ```
    /// use tracefig::typeset::{Style, typeset};
    /// let width = |style| typeset("World", style).unwrap().width;
    /// assert!(width(Style::semibold(14.0)) > width(Style::regular(14.0)));
    /// ```
    #[must_use]
    pub fn semibold(size: f64) -> Self {
        Self { size, weight: Weight::Semibold }
    }
}

/// How bold words are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// The weight of captions and labels.
    Regular,
    /// The weight of titles.
    Semibold,
}

/// An embedded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Face {
    /// The face of regular words.
    Regular,
    /// The face of semibold words.
    Semibold,
    /// The face of formulas.
    Math,
}

/// A glyph of an embedded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Glyph {
    /// The face that it is in.
    pub face: Face,
    /// The glyph's number in that face.
    pub id: u16,
}

/// A glyph on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedGlyph {
    /// Which glyph.
    pub glyph: Glyph,
    /// Page pixels from the line's start to the glyph's origin, to the right.
    pub x: f64,
    /// Page pixels from the line's baseline to the glyph's origin, down.
    pub y: f64,
    /// Page pixels of an em.
    pub size: f64,
}

/// A filled rectangle on a line: a fraction bar, the roof of a root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    /// Page pixels from the line's start to the left edge.
    pub x: f64,
    /// Page pixels from the line's baseline down to the top edge.
    pub y: f64,
    /// Width in page pixels.
    pub width: f64,
    /// Height in page pixels.
    pub height: f64,
}

/// A stretch of a line that wears a role.
#[derive(Clone, Debug, PartialEq)]
pub struct Tint {
    /// The word of the role, as markup names it.
    pub role: String,
    /// The glyphs that wear it, by their place in [`Line::glyphs`].
    pub glyphs: Range<usize>,
    /// The rules that wear it, by their place in [`Line::rules`].
    pub rules: Range<usize>,
    /// Page pixels from the line's start to the beginning and to the end of the stretch.
    pub x: [f64; 2],
}

/// A word or a formula of a line as it is read out: what a search finds and what is copied.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// What it says in plain text, with a space at its end where one follows.
    pub text: String,
    /// Page pixels from the line's start to its beginning and to its end, without the space.
    pub x: [f64; 2],
    /// Page pixels of an em.
    pub size: f64,
}

/// A line of text: glyphs and rules with the extent that they need, baseline at y = 0, y down.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// The markup that was set.
    pub markup: String,
    /// The glyphs, left to right as set.
    pub glyphs: Vec<PlacedGlyph>,
    /// Fraction bars and the roofs of roots.
    pub rules: Vec<Rule>,
    /// The stretches that wear a role, left to right.
    pub tints: Vec<Tint>,
    /// The words and formulas, left to right.
    pub runs: Vec<Run>,
    /// Advance width in page pixels.
    pub width: f64,
    /// Page pixels above the baseline that belong to the line: its ink, and the letters' x-height at least.
    pub ascent: f64,
    /// Page pixels below the baseline that belong to the line: its ink, and at least 0.
    pub descent: f64,
}

impl Line {
    /// A line without anything on it, as high as one.
    pub(super) fn empty(markup: &str, style: Style) -> Self {
        Self { markup: markup.to_owned(), ascent: 0.5 * style.size, ..Self::default() }
    }

    /// The line cut where the role changes: each stretch with the word of its role and the distance of its
    /// start from the line's, in page pixels.
    pub(crate) fn stretches(&self) -> Vec<(Option<&str>, f64, Self)> {
        let mut all = Vec::new();
        let (mut glyphs, mut rules, mut x) = (0, 0, 0.0);
        for tint in &self.tints {
            let before = self.stretch(glyphs..tint.glyphs.start, rules..tint.rules.start, [x, tint.x[0]]);
            let worn = self.stretch(tint.glyphs.clone(), tint.rules.clone(), tint.x);
            all.push((None, x, before));
            all.push((Some(tint.role.as_str()), tint.x[0], worn));
            (glyphs, rules, x) = (tint.glyphs.end, tint.rules.end, tint.x[1]);
        }
        let (glyphs, rules) = (glyphs..self.glyphs.len(), rules..self.rules.len());
        all.push((None, x, self.stretch(glyphs, rules, [x, self.width])));
        all.retain(|(.., line)| !line.glyphs.is_empty() || !line.rules.is_empty());
        all
    }

    /// A part of the line, as a line that begins where the part does.
    fn stretch(&self, glyphs: Range<usize>, rules: Range<usize>, [from, to]: [f64; 2]) -> Self {
        let is_within = |run: &&Run| (from..to).contains(&(0.5 * (run.x[0] + run.x[1])));
        let moved = |run: &Run| Run { x: run.x.map(|x| x - from), ..run.clone() };
        Self {
            markup: self.markup.clone(),
            glyphs: self.glyphs[glyphs].iter().map(|g| PlacedGlyph { x: g.x - from, ..*g }).collect(),
            rules: self.rules[rules].iter().map(|r| Rule { x: r.x - from, ..*r }).collect(),
            tints: Vec::new(),
            runs: self.runs.iter().filter(is_within).map(moved).collect(),
            width: to - from,
            ..*self
        }
    }

    /// Ascent and descent together, in page pixels.
    ///
    /// ```
    /// let line = tracefig::typeset::typeset("$h_x$", tracefig::typeset::Style::regular(16.0)).unwrap();
    /// assert_eq!(line.height(), line.ascent + line.descent);
    /// ```
    #[must_use]
    pub fn height(&self) -> f64 {
        self.ascent + self.descent
    }
}

/// Why a markup can't be set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TypesetError {
    /// The byte of the markup where it goes wrong.
    pub offset: usize,
    /// The fault, in a sentence without a full stop.
    pub message: String,
}

impl fmt::Display for TypesetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for TypesetError {}
