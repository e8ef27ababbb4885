//! Words within a formula, `\text{…}`: set in the face of words, as those around the formula are.
//!
//! The formula engine knows one face. It gets a glyph of no meaning in the place of the words, with a space
//! that makes up for the difference in width, and the writer of glyphs puts the words where that glyph is: so
//! they stand in scripts and fractions like any letter. Within the braces a backslash before a sign that is
//! neither letter nor digit stands for that sign, so that every text can be written ([`escaped`]).

use std::fmt::Write;

use super::line::{Face, PlacedGlyph, Style, TypesetError};
use super::words;

/// The first of the signs that stand for words while a formula is laid out: a row of upright capitals for
/// private use in the face of formulas, as high as the words, which no scene means.
const FIRST: u32 = 0xE17D;

/// How many words within a formula there can be: as many as there are such signs.
const MOST: usize = 16;

/// The commands whose braces hold words.
const COMMANDS: [&str; 2] = ["text", "mbox"];

/// Words within a formula, set at one page pixel an em.
pub(super) struct Inner {
    /// The glyphs, from the words' start.
    pub(super) glyphs: Vec<PlacedGlyph>,
}

/// A formula whose words are taken out.
pub(super) struct Taken {
    /// What the formula engine is given.
    pub(super) latex: String,
    /// The words, in the order of the signs that stand for them.
    pub(super) words: Vec<Inner>,
    /// Where each piece that was changed ends, in what the engine is given and in the formula.
    ends: Vec<(usize, usize)>,
}

impl Taken {
    /// The words that a sign of the layout stands for.
    pub(super) fn at(&self, sign: char) -> Option<&Inner> {
        self.words.get(usize::try_from(u32::from(sign).checked_sub(FIRST)?).ok()?)
    }

    /// The place in the formula of a place in what the engine is given.
    pub(super) fn origin(&self, place: usize) -> usize {
        let before = self.ends.iter().rev().find(|(end, _)| *end <= place);
        before.map_or(place, |(end, origin)| origin + place - end)
    }
}

/// Takes the words out of a formula; `offset` is its first byte's place in the markup.
pub(super) fn take(formula: &str, offset: usize) -> Result<Taken, TypesetError> {
    let is_ours = |c: char| (0..MOST).any(|i| sign(i) == Some(c));
    if let Some((at, c)) = formula.char_indices().find(|(_, c)| is_ours(*c)) {
        return Err(words::missing(offset + at, c));
    }
    let mut taken =
        Taken { latex: String::with_capacity(formula.len()), words: Vec::new(), ends: Vec::new() };
    let mut rest = formula;
    while let Some(at) = rest.find('\\') {
        taken.latex.push_str(&signs(&rest[..at]));
        rest = &rest[at..];
        let Some((content, after)) = words_of(rest).filter(|(content, _)| !content.trim().is_empty()) else {
            // A command, or a backslash and the sign after it.
            let next = rest[1..].chars().next().map_or(1, |c| 1 + c.len_utf8());
            taken.latex.push_str(&rest[..next]);
            rest = &rest[next..];
            continue;
        };
        let place = formula.len() - rest.len() + rest.find('{').unwrap_or(0) + 1;
        taken.put(content, offset + place)?;
        taken.ends.push((taken.latex.len(), formula.len() - after.len()));
        rest = after;
    }
    taken.latex.push_str(&signs(rest));
    Ok(taken)
}

/// A formula without texts, as the engine is given it. A comma in braces is a sign as any other, by which
/// LaTeX writes a decimal comma; the engine takes it for punctuation, and so gets the quotation mark of the
/// same form, which has as many bytes.
fn signs(formula: &str) -> String {
    formula.replace("{,}", "\u{201A}")
}

impl Taken {
    /// Writes what stands for words, whose first byte is at `offset` of the markup.
    fn put(&mut self, content: &str, offset: usize) -> Result<(), TypesetError> {
        let font = super::face::Loaded::of(Face::Math).map(super::face::Loaded::face);
        let standing = sign(self.words.len()).and_then(|sign| {
            let id = font?.glyph_index(sign)?;
            Some((sign, font?.glyph_hor_advance(id)?))
        });
        let Some((sign, advance)) = standing else {
            let message = format!("a formula with more than {MOST} texts in it");
            return Err(TypesetError { offset, message });
        };
        let set = words::set(unescaped(content).map(|(at, c)| (offset + at, c)), Style::regular(1.0))?;
        let wider = set.width - f64::from(advance) / super::face::UNITS_PER_EM;
        // Writing to a text can't fail.
        let _ = write!(self.latex, "{{{sign}\\hspace{{{wider:.6}em}}}}");
        self.words.push(Inner { glyphs: set.glyphs });
        Ok(())
    }
}

/// The sign that stands for the words of a number.
fn sign(index: usize) -> Option<char> {
    let code = FIRST + u32::try_from(index).ok().filter(|_| index < MOST)?;
    char::from_u32(code)
}

/// The content of `\text{…}` at the start of a formula, and what follows it.
fn words_of(formula: &str) -> Option<(&str, &str)> {
    let command = COMMANDS.iter().find_map(|name| formula.strip_prefix('\\')?.strip_prefix(name))?;
    group(command.trim_start())
}

/// The content of the `{…}` at the start, and what follows it; `None` where no such group begins or ends. A
/// brace after a backslash is a sign like any other.
#[must_use]
pub(crate) fn group(text: &str) -> Option<(&str, &str)> {
    let inner = text.strip_prefix('{')?;
    let (mut depth, mut is_escaped) = (1_usize, false);
    for (at, c) in inner.char_indices() {
        match c {
            '{' if !is_escaped => depth += 1,
            '}' if !is_escaped => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some((&inner[..at], &inner[at + 1..]));
        }
        is_escaped = c == '\\' && !is_escaped;
    }
    None
}

/// The characters that the content of `\text{…}` stands for, each with its place there.
pub(crate) fn unescaped(content: &str) -> impl Iterator<Item = (usize, char)> + '_ {
    let mut rest = content.char_indices().peekable();
    std::iter::from_fn(move || {
        let (at, c) = rest.next()?;
        match rest.peek() {
            Some(&(_, next)) if c == '\\' && !next.is_alphanumeric() => rest.next().map(|_| (at, next)),
            _ => Some((at, c)),
        }
    })
}

/// A text as the content of `\text{…}`, whatever its letters.
#[must_use]
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c == '\\' || c.is_ascii_punctuation() {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::typeset;
    use super::*;

    #[test]
    fn any_text_can_be_written_within_a_formula() {
        for text in ["bullet", "100%", "a_b", "{x}", "}{", "$5", r"back\slash", r"\", "A&B", "~^#'", "a  b"] {
            let content = escaped(text);
            let read: String = unescaped(&content).map(|(_, c)| c).collect();
            assert_eq!(read, text);
            let in_braces = format!("{{{content}}} + x");
            assert_eq!(group(&in_braces), Some((content.as_str(), " + x")));
            let formula = format!("$v_{{\\text{{{content}}}}}$");
            assert!(typeset(&formula, Style::regular(16.0)).is_ok(), "{formula}");
        }
    }

    #[test]
    fn words_in_a_formula_are_the_words_around_it() {
        let style = Style::regular(16.0);
        let (inside, outside) =
            (typeset(r"$\text{bullet}$", style).unwrap(), typeset("bullet", style).unwrap());
        let ids = |line: &super::super::Line| line.glyphs.iter().map(|g| g.glyph).collect::<Vec<_>>();
        assert_eq!(ids(&inside), ids(&outside));
        assert!((inside.width - outside.width).abs() < 0.1, "{} {}", inside.width, outside.width);
    }

    #[test]
    fn words_as_a_script_are_small_and_push_what_follows() {
        let style = Style::regular(16.0);
        let line = typeset(r"$v_{\text{bullet}} = 3$", style).unwrap();
        let script = &line.glyphs[1..7];
        assert!(script.iter().all(|g| g.glyph.face == Face::Regular && g.y > 1.0 && g.size < 12.0));
        let end = script[5].x + 0.3 * script[5].size;
        assert!(line.glyphs[7].x > end, "{:?}", line.glyphs);
    }

    #[test]
    fn a_comma_in_braces_is_part_of_a_number() {
        let width = |markup| typeset(markup, Style::regular(16.0)).unwrap().width;
        assert!((width("$2{,}5$") - width("$2.5$")).abs() < 1.0);
        assert!(width("$2, 5$") > width("$2{,}5$") + 1.0);
        let error = typeset(r"$2{,}5 + \foo$", Style::regular(16.0)).unwrap_err();
        assert_eq!(error.offset, 9, "{error}");
    }

    #[test]
    fn a_letter_without_a_glyph_is_named_with_its_place() {
        let error = typeset(r"$v_{\text{a木b}}$", Style::regular(16.0)).unwrap_err();
        assert_eq!(error.offset, 11);
        assert!(error.message.contains('木'), "{error}");
        let error = typeset(r"$\text{wall} + \foo$", Style::regular(16.0)).unwrap_err();
        assert_eq!(error.offset, 15, "{error}");
    }

    #[test]
    fn a_formula_with_too_many_texts_is_refused() {
        let many = format!("${}$", r"\text{a}".repeat(MOST + 1));
        let error = typeset(&many, Style::regular(16.0)).unwrap_err();
        assert!(error.message.contains("more than 16"), "{error}");
    }
}
