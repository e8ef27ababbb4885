//! Formulas: LaTeX maths to glyphs and rules by TeX's rules (Knuth, *The `TeXbook`*, 1984, appendix G).
//!
//! `latex-rust` parses and lays out in exact rationals of an em; here its boxes become page pixels. TeX's
//! scripts are 0.7 and its scripts of scripts 0.55 of the base; where that would be under [`SMALLEST`], the
//! script box is enlarged about its own origin and what follows it moves to the right.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use latex_rust::{BoxContent, Error, FontError, MathBox, MathStyle, ParseError};

use super::digits;
use super::face::{Loaded, UNITS_PER_EM, ems};
use super::inner_words::{self, Taken};
use super::line::{Face, Glyph, PlacedGlyph, Rule, TypesetError};
use super::plain;
use super::vec_accent::Vector;
use super::words::missing;

/// Size in page pixels below which no script is set: smaller letters can't be read on a screen at 100 %.
const SMALLEST: f64 = 9.0;

/// Bytes of LaTeX in one formula; what is longer is an error. A formula on a figure has under 100.
const LONGEST: usize = 500;

/// Glyphs and rules of a formula and its advance width, in page pixels.
#[derive(Clone, Debug, Default)]
pub(super) struct Formula {
    /// The glyphs, from the formula's own origin.
    pub(super) glyphs: Vec<PlacedGlyph>,
    /// Fraction bars and the roofs of roots, from the same origin.
    pub(super) rules: Vec<Rule>,
    /// The advance width in page pixels.
    pub(super) width: f64,
    /// What it says in plain text.
    pub(super) text: String,
}

/// Formulas kept for the next time: the panels, themes and captions of figures say the same few again and
/// again.
const KEPT: usize = 1024;

/// Sets the LaTeX between two dollar signs; `offset` is its first byte's place in the markup.
pub(super) fn set(latex: &str, offset: usize, size: f64) -> Result<Formula, TypesetError> {
    static FORMULAS: Mutex<BTreeMap<(String, u64), Formula>> = Mutex::new(BTreeMap::new());
    let key = (latex.to_owned(), size.to_bits());
    if let Some(known) = FORMULAS.lock().unwrap_or_else(PoisonError::into_inner).get(&key) {
        return Ok(known.clone());
    }
    if let Some(formula) = with_digits(latex, offset, size) {
        return Ok(formula);
    }
    let formula = set_new(latex, offset, size)?;
    let mut kept = FORMULAS.lock().unwrap_or_else(PoisonError::into_inner);
    if kept.len() < KEPT {
        kept.insert(key, formula.clone());
    }
    Ok(formula)
}

/// A formula whose digits alone are its own: of all that differ in them one is laid out and kept.
fn with_digits(latex: &str, offset: usize, size: f64) -> Option<Formula> {
    let (pattern, digits) = digits::apart(latex).filter(|(pattern, _)| pattern != latex)?;
    let mut formula = set(&pattern, offset, size).ok()?;
    digits::put(&digits, &mut formula.glyphs, size)?;
    formula.text = plain::formula_in_words(latex);
    Some(formula)
}

fn set_new(latex: &str, offset: usize, size: f64) -> Result<Formula, TypesetError> {
    let fail = |at: usize, message: String| TypesetError { offset: offset + at, message };
    if latex.len() > LONGEST {
        let message = format!("a formula of {} bytes; the longest allowed has {LONGEST}", latex.len());
        return Err(fail(latex.floor_char_boundary(LONGEST), message));
    }
    let taken = inner_words::take(latex, offset)?;
    let font = Loaded::of(Face::Math)
        .and_then(Loaded::math)
        .ok_or_else(|| fail(0, "the face for formulas can't be read".to_owned()))?;
    let laid_out = latex_rust::parse(&taken.latex)
        .map_err(Error::from)
        .and_then(|node| latex_rust::layout(&node, font, MathStyle::Text));
    let tree = laid_out.map_err(|error| explain(&error, &taken, offset))?;
    let mut writer = Writer { size, taken: &taken, formula: Formula::default() };
    let grown = writer.put(&tree, 0.0, 0.0, size).map_err(|what| fail(0, what))?;
    // A slanted letter leans over its advance width; a word that follows must not touch it.
    let advance = ems(&tree.width) * size + grown;
    let ink = writer.formula.glyphs.last().map_or(0.0, right);
    writer.formula.width = advance.max(ink);
    writer.formula.text = plain::formula_in_words(latex);
    Ok(writer.formula)
}

/// The boxes of the LaTeX between two dollar signs, with what stands for words among them.
#[cfg(not(tracefig_page))]
pub(super) fn layout(latex: &str) -> Option<MathBox> {
    let taken = inner_words::take(latex, 0).ok()?;
    let node = latex_rust::parse(&taken.latex).ok()?;
    latex_rust::layout(&node, Loaded::of(Face::Math)?.math()?, MathStyle::Text).ok()
}

/// Right edge of a glyph's ink.
fn right(placed: &PlacedGlyph) -> f64 {
    let [_, _, right, _] = placed.glyph.outline().bounds;
    placed.x + f64::from(right) / UNITS_PER_EM * placed.size
}

/// Walks the boxes of a layout and writes down their glyphs and rules.
struct Writer<'t> {
    /// Page pixels of an em of the base.
    size: f64,
    /// The words of the formula.
    taken: &'t Taken,
    /// All that was met so far.
    formula: Formula,
}

impl Writer<'_> {
    /// Puts a box whose parent's baseline passes (`x`, `y`), with `em` page pixels an em of its dimensions.
    /// Comes back with the page pixels that it grew by, as a script was enlarged.
    fn put(&mut self, piece: &MathBox, x: f64, y: f64, em: f64) -> Result<f64, String> {
        let y = y - ems(&piece.shift) * em;
        let factor = self.enlargement(piece, em);
        let grown = self.content(piece, x, y, em * factor)?;
        Ok(grown + ems(&piece.width) * em * (factor - 1.0))
    }

    fn content(&mut self, piece: &MathBox, x: f64, y: f64, em: f64) -> Result<f64, String> {
        match &piece.content {
            BoxContent::Empty | BoxContent::Kern(_) => {}
            BoxContent::Glyph { ch, scale, .. } if self.taken.at(*ch).is_some() => {
                let em = ems(scale) * em;
                let words = self.taken.at(*ch).into_iter().flat_map(|words| &words.glyphs);
                self.formula.glyphs.extend(words.map(|g| PlacedGlyph { x: x + g.x * em, y, size: em, ..*g }));
            }
            BoxContent::Glyph { glyph_id, scale, .. } => {
                let glyph = Glyph { face: Face::Math, id: *glyph_id };
                self.formula.glyphs.push(PlacedGlyph { glyph, x, y, size: ems(scale) * em });
            }
            BoxContent::Rule => self.rule(x, y - ems(&piece.height) * em, piece, em),
            BoxContent::HList(children) => {
                let (start, mut x) = (x, x);
                let mut natural = 0.0;
                for child in children {
                    let width = ems(&child.width) * em;
                    x += width + self.put(child, x, y, em)?;
                    natural += width;
                }
                return Ok(x - start - natural);
            }
            BoxContent::VList(children) => return self.column(children, x, y, em),
            BoxContent::Overlap(children) => {
                if let Some(vector) = Vector::of(children) {
                    return self.vector(&vector, x, y, em, ems(&piece.width) * em);
                }
                let mut grown = 0.0_f64;
                for child in children {
                    let beyond = self.put(child, x, y, em)? + ems(&child.width) * em - ems(&piece.width) * em;
                    grown = grown.max(beyond);
                }
                return Ok(grown);
            }
            BoxContent::Color(..) | BoxContent::BackColor(..) => {
                return Err(
                    "colours in a formula are not supported; the role of a text gives its colour".to_owned()
                );
            }
            BoxContent::Line { .. } => return Err("crossed-out formulas are not supported".to_owned()),
            BoxContent::Frame { .. } => return Err("framed formulas are not supported".to_owned()),
        }
        Ok(0.0)
    }

    /// Letters, and the arrow over their middle. Comes back like [`Self::content`], of a box that is `width`
    /// wide.
    fn vector(&mut self, vector: &Vector, x: f64, y: f64, em: f64, width: f64) -> Result<f64, String> {
        let letters = self.put(vector.base, x, y, em)? + ems(&vector.base.width) * em;
        let [left, _, right, _] = vector.arrow.outline().bounds.map(|b| f64::from(b) / UNITS_PER_EM);
        let size = vector.scale * em;
        let middle = x + vector.middle.map_or(0.5 * letters, |m| m * em);
        let x = middle - 0.5 * (left + right) * size;
        self.formula.glyphs.insert(
            self.formula.glyphs.len().saturating_sub(1),
            PlacedGlyph { glyph: vector.arrow, x, y: y - vector.raise * em, size },
        );
        Ok(letters - width)
    }

    /// A vertical list: the first child on the baseline, each next one below.
    fn column(&mut self, children: &[MathBox], x: f64, y: f64, em: f64) -> Result<f64, String> {
        let (mut grown, mut baseline) = (0.0_f64, y);
        for (i, child) in children.iter().enumerate() {
            if i > 0 {
                baseline += ems(&child.height) * em;
            }
            grown = grown.max(self.put(child, x, baseline, em)?);
            baseline += ems(&child.depth) * em;
        }
        Ok(grown)
    }

    fn rule(&mut self, x: f64, y: f64, piece: &MathBox, em: f64) {
        let (width, height) = (ems(&piece.width) * em, (ems(&piece.height) + ems(&piece.depth)) * em);
        if width > 0.0 && height > 0.0 {
            self.formula.rules.push(Rule { x, y, width, height });
        }
    }

    /// The factor that brings the box's largest glyph to [`SMALLEST`] when an em of its dimensions has `em`
    /// page pixels; 1 where it is as large already.
    fn enlargement(&self, piece: &MathBox, em: f64) -> f64 {
        // At a base of less than SMALLEST a script has the base's size.
        let wanted = SMALLEST.min(self.size);
        match largest_scale(piece) {
            Some(scale) if scale * em < wanted => wanted / (scale * em),
            _ => 1.0,
        }
    }
}

fn largest_scale(piece: &MathBox) -> Option<f64> {
    match &piece.content {
        BoxContent::Glyph { scale, .. } => Some(ems(scale)),
        BoxContent::HList(children) | BoxContent::VList(children) | BoxContent::Overlap(children) => {
            children.iter().filter_map(largest_scale).reduce(f64::max)
        }
        _ => None,
    }
}

/// Words and place of an error. The engine does not say where; what it rejects begins where the longest
/// prefix ends that it accepts, or at the command or character that it names.
fn explain(error: &Error, taken: &Taken, offset: usize) -> TypesetError {
    let latex = &taken.latex;
    if let Error::Font(FontError::MissingGlyph { ch }) = error {
        return missing(offset + taken.origin(latex.find(*ch).unwrap_or(0)), *ch);
    }
    let named = match error {
        Error::Parse(ParseError::Unknown(name) | ParseError::Unsupported(name)) => latex.find(name.as_str()),
        _ => None,
    };
    let at = taken.origin(named.unwrap_or_else(|| accepted_prefix(latex)));
    TypesetError { offset: offset + at, message: format!("malformed formula: {error}") }
}

fn accepted_prefix(latex: &str) -> usize {
    let mut ends = latex.char_indices().map(|(at, _)| at).rev();
    ends.find(|&end| !cuts_a_command(latex, end) && latex_rust::parse(&latex[..end]).is_ok()).unwrap_or(0)
}

/// Whether the place is inside a command's name: `\le` of `\left` would be accepted.
fn cuts_a_command(latex: &str, end: usize) -> bool {
    let name = latex[..end].trim_end_matches(|c: char| c.is_ascii_alphabetic());
    name.ends_with('\\') && latex[end..].starts_with(|c: char| c.is_ascii_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(latex: &str) -> usize {
        set(latex, 0, 16.0).err().map_or(usize::MAX, |e| e.offset)
    }

    #[test]
    fn malformed_latex_is_reported_where_it_goes_wrong() {
        assert_eq!(at(r"a + \foo"), 4);
        assert_eq!(at(r"a + \frac{1}"), 4);
        assert_eq!(at("x_1_2"), 3);
        assert_eq!(at("a}"), 1);
        assert_eq!(at(r"r \left( x"), 2);
        assert_eq!(at("v_"), 1);
        assert_eq!(at(r"\color{red}x"), 0);
        assert_eq!(at(&"x".repeat(LONGEST + 1)), LONGEST);
    }

    #[test]
    fn formulas_that_differ_in_digits_are_laid_out_alike() {
        let patterns = ["d = 2.#1", r"w_# = (#, -#.#)", r"\ge #.#4", "x_1#", "#^2", "n' = #'", "v_{#} + ##"];
        let others =
            [r"\frac12 + #", r"\text{at #} #", r"\left(#\right)", r"2\,# \omega_#", "# _ # #", "{#}#"];
        for pattern in patterns.into_iter().chain(others) {
            for digit in '0'..='9' {
                for size in [11.0, 16.0] {
                    let latex = pattern.replace('#', &digit.to_string());
                    let (kept, new) = (set(&latex, 0, size).unwrap(), set_new(&latex, 0, size).unwrap());
                    assert!(kept.glyphs == new.glyphs && kept.rules == new.rules, "{latex} at {size}");
                    assert!(kept.width == new.width && kept.text == new.text, "{latex} at {size}");
                }
            }
        }
        let told = ["d = 2.51", "x_12", "7^2", r"\frac12"].map(digits::apart);
        let zeros = told.map(|pattern| pattern.map(|(pattern, _)| pattern));
        assert_eq!(zeros.map(Option::unwrap_or_default), ["d = 0.00", "x_10", "", ""]);
    }

    #[test]
    fn no_script_is_smaller_than_nine_pixels() {
        for size in [11.0, 12.0, 14.0, 16.0, 17.0] {
            for latex in ["A'", "h_x", "x_{\\min}", "e^{x_i^2}", "\\frac{v_A'}{2}"] {
                let formula = set(latex, 0, size).unwrap();
                for glyph in &formula.glyphs {
                    assert!(glyph.size > SMALLEST - 1e-9, "{latex} at {size}: {}", glyph.size);
                }
            }
        }
    }

    #[test]
    fn enlarged_scripts_push_what_follows_and_do_not_cover_it() {
        let formula = set("x_{\\min} y", 0, 11.0).unwrap();
        let left = |g: &PlacedGlyph| g.x + f64::from(g.glyph.outline().bounds[0]) / 1000.0 * g.size;
        for pair in formula.glyphs.windows(2) {
            assert!(right(&pair[0]) < left(&pair[1]) + 0.6, "{pair:?}");
        }
        let last = formula.glyphs.last().unwrap();
        assert!(right(last) <= formula.width);
    }

    #[test]
    fn a_subscript_is_below_and_a_prime_close_to_its_letter() {
        let formula = set("h_x", 0, 16.0).unwrap();
        assert!(formula.glyphs[1].y > 1.0 && formula.glyphs[1].size < 12.0);
        let formula = set("A'", 0, 16.0).unwrap();
        let letter_end = 0.681 * 16.0;
        assert!((formula.glyphs[1].x - letter_end).abs() < 1.0, "{:?}", formula.glyphs);
    }

    #[test]
    fn the_notation_of_the_article_can_be_set() {
        let all = [
            r"\|A\|",
            r"\hat n",
            r"\frac{1}{2}",
            r"B \ominus A",
            r"\omega \cdot r",
            r"\theta\,r \ge 0",
            r"x_{\min}",
            r"\mathbf{R}_A^{-1} p",
            r"\sqrt{x^2 + y^2}",
            r"A''",
            r"\max(|D_x|, 0)",
            r"t_0 + \frac{d}{\|v\| + \omega r}",
            r"\Delta t \le \varepsilon",
            r"\vec v \times \dot x",
        ];
        for latex in all {
            let formula = set(latex, 0, 16.0).unwrap_or_else(|e| panic!("{latex}: {e}"));
            assert!(formula.width > 1.0 && formula.glyphs.iter().all(|g| g.glyph.id != 0), "{latex}");
        }
        assert_eq!(set(r"\frac{1}{2}", 0, 16.0).unwrap().rules.len(), 1, "the bar");
    }
}
