//! Headline and caption, broken into lines, and their words for readers who do not see it.
//!
//! A text that can't be set is told with its place before anything is drawn.

use std::sync::Arc;

use crate::figure::context::Context;
use crate::figure::fault::{Fault, Problem};
use crate::figure::lettering::Lettering;
use crate::figure::name::Name;
use crate::figure::page::Measures;
use crate::scene::{Scene, Spanned};
use crate::typeset::{Line, Style, TypesetError, as_markup, paragraph};

use super::columns::columns;
use super::fill::fill;
use super::plain;
use super::wording::{bad_markup, bad_role, no_value};

/// How near the least width of balanced lines is found, in ems: less than a letter.
const BALANCE: f64 = 0.25;

/// A text that stands across the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Block {
    /// The claim of the figure, above the panels.
    Headline,
    /// What leads through the figure, below the panels.
    Caption,
}

impl Block {
    /// What messages call it.
    fn name(self) -> &'static str {
        match self {
            Self::Headline => "headline",
            Self::Caption => "caption",
        }
    }

    /// The text of the scene for it.
    fn of(self, scene: &Scene) -> Option<&Spanned<String>> {
        match self {
            Self::Headline => scene.headline.as_ref(),
            Self::Caption => scene.caption.as_ref(),
        }
    }

    /// How it is set on a page of these sizes.
    fn room(self, measures: &Measures) -> Room {
        let page = measures.measure();
        match self {
            Self::Headline => Room {
                style: Style::semibold(measures.headline_size()),
                widths: [page; 2],
                column: None,
                most: measures.headline_lines(),
                is_balanced: true,
            },
            Self::Caption => Room {
                style: Style::regular(measures.caption_size()),
                widths: [measures.caption_measure(), page],
                column: measures.caption_column(),
                most: measures.caption_lines(1.0),
                is_balanced: false,
            },
        }
    }
}

/// The room that a page has for a text across it, and how it is filled.
struct Room {
    /// How the text is set.
    style: Style,
    /// How wide lines are that are read with ease, and at most, page pixels.
    widths: [f64; 2],
    /// How wide each of two columns is, page pixels; `None` where there is room for one alone.
    column: Option<f64>,
    /// How many lines there is room for.
    most: usize,
    /// Whether the lines are as long as each other, so that the last one is not a single word.
    is_balanced: bool,
}

impl Room {
    /// Sets markup in one or two columns.
    fn columns(
        &self,
        markup: &str,
        typeset: impl Fn(&str, &Self) -> Result<Lettering, TypesetError>,
    ) -> Result<Vec<Lettering>, TypesetError> {
        let Some(column) = self.column else { return Ok(vec![typeset(markup, self)?]) };
        match columns(markup, self.style, self.widths[0])?.as_slice() {
            [left, right] => {
                let each = Self { widths: [column; 2], column: None, ..*self };
                Ok(vec![typeset(left, &each)?, typeset(right, &each)?])
            }
            _ => Ok(vec![typeset(markup, self)?]),
        }
    }

    /// Sets markup on lines that are read with ease, or on longer ones where these would be too many.
    fn set(&self, markup: &str) -> Result<Vec<Arc<Line>>, TypesetError> {
        let [ease, widest] = self.widths;
        let set = paragraph(markup, self.style)?;
        let (count, _) = set.extent(ease);
        Ok(set.lines(match count {
            _ if count > self.most => widest,
            _ if self.is_balanced => self.balanced(count, |width| set.extent(width)),
            _ => ease,
        }))
    }

    /// The least width, page pixels, at which a text takes no more than `count` lines, as many as where it is
    /// as wide as there is room for. `extent` says how many lines a width takes, and how wide the widest is.
    fn balanced(&self, count: usize, extent: impl Fn(f64) -> (usize, f64)) -> f64 {
        let (mut narrow, mut wide) = (0.0, self.widths[0]);
        while count > 1 && wide - narrow > BALANCE * self.style.size {
            let middle = 0.5 * (narrow + wide);
            let (lines, widest) = extent(middle);
            if lines == count && widest <= middle { wide = middle } else { narrow = middle }
        }
        wide
    }
}

/// A text of the scene, filled and set by `typeset`; `None`, with the reason in `problems`, where it can't
/// be. What the answer lacks for it is in `notes`.
pub(crate) fn set(
    text: &Spanned<String>,
    context: &Context,
    said: (&mut Vec<Problem>, &mut Vec<Problem>),
    typeset: impl Fn(&str) -> Result<Vec<Arc<Line>>, TypesetError>,
) -> Option<Lettering> {
    set_as(text, context, said, |filled| Lettering::new(filled, typeset))
}

/// A text of the scene, filled and set by `typeset` as [`set`] does it.
fn set_as<T>(
    text: &Spanned<String>,
    context: &Context,
    (problems, notes): (&mut Vec<Problem>, &mut Vec<Problem>),
    typeset: impl FnOnce(&str) -> Result<T, TypesetError>,
) -> Option<T> {
    let filled = match fill(&text.value, context, &text.span) {
        Ok((filled, lacking)) => {
            notes.extend(lacking.into_iter().map(|value| no_value(value, context, &text.span)));
            filled
        }
        Err(problem) => {
            problems.push(problem);
            return None;
        }
    };
    if let Some(problem) = bad_role(&filled, &text.span) {
        problems.push(problem);
        return None;
    }
    typeset(&filled).map_err(|e| problems.push(bad_markup(e, filled.clone(), &text.span))).ok()
}

/// A text across the page, set.
#[derive(Clone, Debug, Default)]
pub(crate) struct Across {
    /// Its lines, column by column from the left; none where there is no text, or no room for it on the page.
    pub(crate) columns: Vec<Lettering>,
    /// Its plain words; `None` where there is no text.
    pub(crate) words: Option<String>,
    /// Whether it is the sentence of the answer, which comes with the last step.
    pub(crate) is_answer: bool,
}

impl Across {
    /// How many lines the longest column has.
    pub(crate) fn lines(&self) -> usize {
        self.columns.iter().map(Lettering::len).max().unwrap_or(0)
    }
}

/// A text across the page; without lines where the page has no room for all of them, which is a warning. Its
/// values are those of `context`, the first panel's.
pub(crate) fn across(
    block: Block,
    (context, measures): (&Context, &Measures),
    (problems, warnings): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> Across {
    let Some(text) = block.of(context.scene) else { return Across::default() };
    in_room((text, block.name()), context, &block.room(measures), (problems, warnings))
}

/// The caption of a panel, in lines as wide as that and as long as each other; without lines where there are
/// more than there is room for; and its plain words. Its values are those of the panel.
pub(crate) fn under(
    text: &Spanned<String>,
    (width, most): (f64, usize),
    (context, measures): (&Context, &Measures),
    said: (&mut Vec<Problem>, &mut Vec<Problem>),
) -> (Lettering, Option<String>) {
    let of_page = Block::Caption.room(measures);
    let widths = [width.min(of_page.widths[0]), width];
    let room = Room { widths, column: None, most, is_balanced: true, ..of_page };
    let Across { mut columns, words, .. } = in_room((text, Block::Caption.name()), context, &room, said);
    (columns.pop().unwrap_or_default(), words)
}

/// A text in its room.
fn in_room(
    (text, what): (&Spanned<String>, &'static str),
    context: &Context,
    room: &Room,
    (problems, warnings): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> Across {
    let in_columns = |filled: &str| room.columns(filled, |part, room| Lettering::new(part, |t| room.set(t)));
    let columns = set_as(text, context, (problems, warnings), in_columns).unwrap_or_default();
    let filled = fill(&text.value, context, &text.span).ok();
    let words = filled.map(|(filled, _)| plain(&filled));
    let set = Across { columns, words, is_answer: false };
    if set.lines() <= room.most {
        return set;
    }
    let fault = Fault::TextDropped { what, lines: set.lines(), room: room.most };
    warnings.push(Problem::new(fault, text.span.clone()));
    Across { columns: Vec::new(), ..set }
}

/// A text of a scene in plain words, for those who do not see the figure; `None`, with the reason in
/// `problems`, where there is none that can be read. Its values are those of `context`.
pub(crate) fn spoken(
    text: Option<&Spanned<String>>,
    context: &Context,
    (problems, notes): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> Option<String> {
    let text = text?;
    // What can't be set in type can be said all the same.
    match fill(&text.value, context, &text.span) {
        Ok((filled, lacking)) => {
            notes.extend(lacking.into_iter().map(|value| no_value(value, context, &text.span)));
            Some(plain(&filled))
        }
        Err(problem) => {
            problems.push(problem);
            None
        }
    }
}

/// A caption in `words` of ours, which are set as `markup`; empty where the page has no room for it, or the
/// font lacks a letter.
pub(crate) fn caption_of_words(measures: &Measures, words: String, markup: &str) -> Across {
    // In columns each sentence would be read as the caption of the panel over it.
    let room = Room { column: None, ..Block::Caption.room(measures) };
    let markup = with_powers(markup);
    let columns = room.columns(&markup, |part, room| Lettering::new(part, |text| room.set(text)));
    let set = Across { columns: columns.unwrap_or_default(), words: Some(words), is_answer: true };
    if set.columns.is_empty() || set.lines() > room.most { Across::default() } else { set }
}

/// A caption of paragraphs in markup of ours, each on lines of its own: `head`, and beside it, where the page
/// has room for two columns, else below it, `list`. Where that has too many lines, `more` stands for those
/// that are left out, with their number. `Err` where one can't be set.
pub(crate) fn paragraphs(
    measures: &Measures,
    head: &[String],
    list: &[String],
    more: impl Fn(usize) -> String,
) -> Result<Across, TypesetError> {
    let room = Block::Caption.room(measures);
    let width = room.column.filter(|_| !list.is_empty()).unwrap_or(room.widths[1]);
    let set = |all: &[String]| {
        Lettering::new(&all.join("\n"), |text| {
            let lines = text.split('\n').map(|text| Ok(paragraph(text, room.style)?.lines(width)));
            Ok(lines.collect::<Result<Vec<_>, _>>()?.concat())
        })
    };
    let mut kept = list.len();
    loop {
        let left_out = (kept < list.len()).then(|| more(list.len() - kept));
        let rest: Vec<String> = list[..kept].iter().cloned().chain(left_out).collect();
        let columns = match room.column {
            Some(_) if !rest.is_empty() => vec![set(head)?, set(&rest)?],
            _ => vec![set(&[head, &rest].concat())?],
        };
        let words = head.iter().chain(&rest).map(|text| plain(text)).collect::<Vec<_>>().join(" ");
        let across = Across { columns, words: Some(words), is_answer: false };
        if across.lines() <= room.most || kept == 0 {
            return Ok(across);
        }
        kept -= 1;
    }
}

/// Characters for private use, which no text has: they stand for names, whose letters words have, too.
const STAND_INS: [&str; 2] = ["\u{E000}", "\u{E001}"];

/// What `say` says of bodies of these names, as markup: the names as labels have them, a letter in italics.
/// An empty name is that of no body.
pub(crate) fn named(names: [Name; 2], say: impl FnOnce([&str; 2]) -> String) -> String {
    // Little words before a name depend on how that begins: "d’étagère".
    let begins = |name: &str| name.chars().take(3).take_while(|c| c.is_alphabetic()).collect::<String>();
    let marks = [0, 1].map(|side| match names[side].in_words() {
        name if name.is_empty() => name,
        name => begins(&name) + STAND_INS[side],
    });
    let text = as_markup(&say([&marks[0], &marks[1]]));
    let stand = names.iter().zip(&marks).filter(|(_, mark)| !mark.is_empty());
    stand.fold(text, |text, (name, mark)| text.replace(mark.as_str(), &name.primed(0)))
}

/// What stands before a power of ten.
const TIMES: &str = " × ";

/// Words as markup whose powers of ten, `10^−6` in words, are formulas.
pub(crate) fn with_powers(words: &str) -> String {
    let mut pieces = words.split("10^");
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find(|c: char| c != '−' && !c.is_ascii_digit()).unwrap_or(piece.len());
        let (exponent, rest) = piece.split_at(end);
        if exponent.is_empty() {
            // A name may hold it, too.
            text.extend(["10^", piece]);
            continue;
        }
        // No line ends within a number.
        if text.ends_with(TIMES) {
            text.truncate(text.len() - TIMES.len());
            text.push_str("\u{a0}×\u{a0}");
        }
        text.extend(["$10^{", &exponent.replace('−', "-"), "}$", rest]);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The room for a text on a page of a size.
    fn room(block: Block, canvas: &str) -> Room {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
            query = {{ kind = 'bounds', of = ['A'] }}
            canvas = {{ {canvas} }}"
        );
        let scene = crate::scene::open_text("page.toml", &text).unwrap().scene;
        block.room(&Measures::of(&scene.canvas, crate::figure::theme::TypeSizes::HOUSE))
    }

    #[test]
    fn little_words_before_a_name_are_those_of_sentences() {
        for (name, said) in [("étagère", "d’étagère"), ("mur", "de mur"), ("éa$", "d’éa"), ("A", "de $A$")]
        {
            let text = format!(
                "lang = 'fr'
                shapes.'{name}' = {{ kind = 'circle', radius = 1 }}
                query = {{ kind = 'bounds', of = ['{name}'] }}"
            );
            let scene = crate::scene::open_text("page.toml", &text).unwrap().scene;
            let plan = crate::figure::plan(&scene).unwrap();
            let figure = crate::figure::draw(&plan, plan.theme, "page");
            assert!(format!("{:?}", figure.drawing.items).contains(said), "{said}");
        }
    }

    #[test]
    fn a_line_of_caption_has_some_ninety_five_letters_on_every_page() {
        let text =
            "A and B overlap. The shortest way to part them is to push B by the depth along n. ".repeat(9);
        for canvas in ["width = 960", "width = 2000", "width = 960, text = 20", "width = 400"] {
            let lines = room(Block::Caption, canvas).set(&text).unwrap();
            let words: usize = lines.iter().map(|line| line.glyphs.len()).max().unwrap();
            // Spaces are no glyphs: some 17 of 95.
            assert!(words <= 85 && (words > 65 || canvas.ends_with("400")), "{canvas}: {words}");
        }
        let low = room(Block::Caption, "width = 2000, height = 320");
        assert!(low.set(&text).unwrap().len() <= low.most, "longer lines where there is no other room");
    }

    #[test]
    fn a_headline_on_two_lines_has_lines_of_like_length() {
        let room = room(Block::Headline, "width = 400");
        let text = "The nearest edge of the difference is the shortest way out of it";
        let widths: Vec<f64> = room.set(text).unwrap().iter().map(|line| line.width).collect();
        assert!(widths.len() == 2 && (widths[0] - widths[1]).abs() < 0.3 * widths[0], "{widths:?}");
        assert_eq!(room.set("Short").unwrap().len(), 1);
    }

    #[test]
    fn a_power_of_ten_in_words_becomes_a_formula() {
        assert_eq!(with_powers("at (1.5 × 10^−6, 2)."), "at (1.5\u{a0}×\u{a0}$10^{-6}$, 2).");
        assert_eq!(with_powers("10^12"), "$10^{12}$");
        assert_eq!(with_powers("no power"), "no power");
    }
}
