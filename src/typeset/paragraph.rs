//! Lines from words and formulas, broken where a space allows it.
//!
//! Breaking is first-fit: a caption has two lines, where a global optimum would rarely differ. Runs of
//! spaces count as one, those at the ends of a line as none. The space within a point, `(0, 1)`, allows
//! no break. Words and formulas are set once, whatever the widths are that lines of them are tried in.

use super::draft::Draft;
use super::line::{Line, PlacedGlyph, Rule, Run, Style, Tint, TypesetError};
use super::markup::{Piece, characters, pieces};
use super::{formula, words};

/// Bytes of one markup; what is longer is an error. A page holds a few thousand letters.
const LONGEST: usize = 10_000;

/// What a newline in the markup means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Newlines {
    /// A newline is a space.
    Spaces,
    /// A newline ends the line.
    Breaks,
}

/// A text that is set, but not yet broken into lines.
pub(crate) struct Paragraph {
    /// The markup that was set.
    markup: String,
    /// Page pixels of an em of its words.
    size: f64,
    /// Page pixels that a space takes.
    space: f64,
    /// What no line breaks.
    chunks: Vec<Chunk>,
}

/// What stands between two spaces outside of formulas.
struct Chunk {
    /// What is set.
    set: Draft,
    /// Whether its line ends behind it, however much room there is.
    is_last: bool,
}

/// Which chunks stand on a line, and how wide that is in page pixels.
struct Row {
    /// The number of its chunks.
    count: usize,
    /// The advance width.
    width: f64,
}

impl Paragraph {
    /// Sets markup.
    pub(super) fn of(markup: &str, style: Style, newlines: Newlines) -> Result<Self, TypesetError> {
        if markup.len() > LONGEST {
            let message = format!("a text of {} bytes; the longest allowed has {LONGEST}", markup.len());
            return Err(TypesetError { offset: markup.floor_char_boundary(LONGEST), message });
        }
        let space = words::space(style);
        let (chunks, chunk) = (Vec::new(), Draft::default());
        let mut setter = Setter { style, newlines, space, role: None, chunks, chunk, is_held: false };
        for piece in pieces(markup)? {
            match piece {
                Piece::Formula(offset, latex) => {
                    let set = formula::set(latex, offset, style.size)?;
                    setter.put(set.text, set.glyphs, set.rules, set.width);
                }
                Piece::Words(offset, text) => setter.words(offset, text)?,
                Piece::Role(_, role) => setter.role = Some(role),
                Piece::Plain => setter.role = None,
            }
        }
        setter.end_chunk();
        let markup = markup.to_owned();
        Ok(Self { markup, size: style.size, space, chunks: setter.chunks })
    }

    /// Lines of at most `width` page pixels; a word or formula that is wider has a line of its own.
    pub(crate) fn lines(&self, width: f64) -> Vec<Line> {
        let mut rest = self.chunks.iter();
        let rows = self.rows(width).into_iter();
        rows.map(|row| {
            let mut line = Draft::default();
            for chunk in rest.by_ref().take(row.count) {
                line.append(&chunk.set, self.space);
            }
            line.into_line(&self.markup, self.size)
        })
        .collect()
    }

    /// How many lines of at most `width` page pixels it takes, and how wide the widest is.
    pub(crate) fn extent(&self, width: f64) -> (usize, f64) {
        let rows = self.rows(width);
        (rows.len(), rows.iter().map(|row| row.width).fold(0.0, f64::max))
    }

    /// How many glyphs it has.
    pub(super) fn glyphs(&self) -> usize {
        self.chunks.iter().map(|chunk| chunk.set.glyphs.len()).sum()
    }

    /// What stands on lines of at most `width` page pixels.
    fn rows(&self, width: f64) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        let mut is_open = false;
        for Chunk { set, is_last } in &self.chunks {
            match rows.last_mut().filter(|_| is_open) {
                Some(row) if row.width + self.space + set.width <= width => {
                    row.count += 1;
                    row.width = row.width + self.space + set.width;
                }
                _ => rows.push(Row { count: 1, width: set.width }),
            }
            is_open = !is_last;
        }
        rows
    }
}

/// The chunks that are set, and the one being set.
struct Setter<'m> {
    /// How words are set.
    style: Style,
    /// What newlines mean.
    newlines: Newlines,
    /// Page pixels that a space takes.
    space: f64,
    /// The role that is worn at this place of the markup.
    role: Option<&'m str>,
    /// What was set up to the last space outside a formula.
    chunks: Vec<Chunk>,
    /// What was set since.
    chunk: Draft,
    /// Whether no line ends at the space behind what was set last: in a point, and within what French puts
    /// between words and their marks.
    is_held: bool,
}

impl Setter<'_> {
    fn words(&mut self, offset: usize, text: &str) -> Result<(), TypesetError> {
        let mut rest = characters(offset, text).peekable();
        let mut opens = false;
        while let Some(&(_, character)) = rest.peek() {
            if character.is_ascii_whitespace() {
                rest.next();
                let closes =
                    rest.peek().is_some_and(|&(_, next)| matches!(next, ';' | ':' | '?' | '!' | '»'));
                self.is_held = (opens || closes) && character == ' ';
                if self.is_held {
                    continue;
                }
                self.end_chunk();
                if character == '\n' && self.newlines == Newlines::Breaks {
                    self.chunks.iter_mut().last().into_iter().for_each(|chunk| chunk.is_last = true);
                }
                continue;
            }
            let word = std::iter::from_fn(|| rest.next_if(|&(_, c)| !c.is_ascii_whitespace()));
            let mut read = String::new();
            let word = word.inspect(|&(_, c)| read.push(c));
            let style = if self.role.is_some() { Style::semibold(self.style.size) } else { self.style };
            let set = words::set(word, style)?;
            opens = opens_a_point(&read) || read == "«";
            self.put(read, set.glyphs, Vec::new(), set.width);
        }
        Ok(())
    }

    /// Adds what is set to the chunk, in the role that is worn; `text` is how it is read.
    fn put(&mut self, text: String, glyphs: Vec<PlacedGlyph>, rules: Vec<Rule>, width: f64) {
        let tint = self.role.map(|role| Tint {
            role: role.to_owned(),
            glyphs: 0..glyphs.len(),
            rules: 0..rules.len(),
            x: [0.0, width],
        });
        let run = Run { text, x: [0.0, width], size: self.style.size };
        let runs = Some(run).filter(|run| !run.text.is_empty()).into_iter().collect();
        let set = Draft { glyphs, rules, tints: tint.into_iter().collect(), runs, width };
        let space = if std::mem::take(&mut self.is_held) { self.space } else { 0.0 };
        if space > 0.0 { self.chunk.append(&set, space) } else { self.chunk.join(&set) }
    }

    /// Ends what no line breaks.
    fn end_chunk(&mut self) {
        if !self.chunk.is_empty() {
            self.chunks.push(Chunk { set: std::mem::take(&mut self.chunk), is_last: false });
        }
    }
}

/// Whether a word is the first coordinate of a point, as `(−0.5,` is, so that the next one belongs to it.
fn opens_a_point(word: &str) -> bool {
    let number = word.strip_prefix('(').and_then(|word| word.strip_suffix([',', ';']));
    number.is_some_and(|number| number.chars().all(|c| matches!(c, '0'..='9' | '.' | ',' | '-' | '−')))
}

#[cfg(test)]
mod tests {
    use super::super::{typeset, wrap};
    use super::*;

    #[test]
    fn wrapped_lines_fit_and_hold_every_glyph_once() {
        let text =
            "$V$ runs from A's centre to B's. Cut down to $h_x$ and $h_y$, it leads to $B_c$, closest to B.";
        let style = Style::regular(14.0);
        let whole = typeset(text, style).unwrap();
        let lines = wrap(text, style, 200.0).unwrap();
        assert!(lines.len() >= 3);
        assert!(lines.iter().all(|line| line.width <= 200.0));
        let glyphs: Vec<_> = lines.iter().flat_map(|line| &line.glyphs).map(|g| g.glyph).collect();
        assert_eq!(glyphs, whole.glyphs.iter().map(|g| g.glyph).collect::<Vec<_>>());
    }

    #[test]
    fn lines_and_stretches_are_read_as_the_markup_is() {
        let text = r"{a|$A$'s red box}, and from it $\|D\| - \frac{r}{2}$ to {b|B}.";
        let style = Style::regular(14.0);
        let read = |line: &Line| line.runs.iter().map(|run| run.text.as_str()).collect::<String>();
        for width in [60.0, 150.0, 900.0] {
            let lines = wrap(text, style, width).unwrap();
            let all: Vec<String> = lines.iter().map(read).collect();
            assert_eq!(all.join(" "), super::super::plain::plain(text));
            for line in &lines {
                let parts: String = line.stretches().iter().map(|(.., part)| read(part)).collect();
                assert_eq!(parts, read(line));
            }
        }
    }

    #[test]
    fn a_text_longer_than_a_page_is_refused() {
        let error = typeset(&"é ".repeat(LONGEST), Style::regular(14.0)).unwrap_err();
        assert!(error.offset <= LONGEST && error.message.contains("10000"), "{error:?}");
    }

    /// Pieces that markup of every kind is made of, and what is none.
    const PARTS: [&str; 43] = [
        "{a|",
        "{x-y|",
        "\\{b|",
        "$",
        "\\",
        "{",
        "}",
        "^",
        "_",
        "'",
        "&",
        "%",
        "#",
        "~",
        " ",
        "\n",
        "x",
        "A",
        "1",
        "-",
        "é",
        "ж",
        "☃",
        "𝐀",
        "\u{301}",
        "\\frac",
        "\\hat",
        "\\left",
        "\\right",
        "(",
        ")",
        "\\|",
        "\\min",
        "\\sqrt",
        "\\text",
        "\\begin{matrix}",
        "\\end{matrix}",
        "\\over",
        "\\def",
        "\\color{red}",
        "\\vec",
        "\\ ",
        "\\$",
    ];

    #[test]
    fn any_text_is_set_or_refused_at_a_place_inside_it() {
        arbtest::arbtest(|u| {
            let count = u.int_in_range(0..=24)?;
            let mut text = String::new();
            for _ in 0..count {
                text.push_str(u.choose(&PARTS)?);
            }
            let text = if u.arbitrary()? { format!("${text}$") } else { text };
            match wrap(&text, Style::regular(12.0), 100.0) {
                Ok(lines) => {
                    assert!(lines.iter().all(|l| l.width.is_finite() && l.height().is_finite()), "{text}");
                }
                Err(error) => {
                    assert!(error.offset <= text.len() && text.is_char_boundary(error.offset), "{text}");
                }
            }
            Ok(())
        });
    }

    #[test]
    fn a_full_stop_stays_with_its_formula() {
        let style = Style::regular(14.0);
        let narrow = wrap("a $x$.", style, 1.0).unwrap();
        assert_eq!(narrow.len(), 2);
        assert_eq!(narrow[1].glyphs.len(), 2);
    }

    /// What stands on each line of a text that has room for nothing.
    fn narrow(text: &str) -> Vec<String> {
        let read = |line: &Line| line.runs.iter().map(|run| run.text.as_str()).collect();
        wrap(text, Style::regular(14.0), 1.0).unwrap().iter().map(read).collect()
    }

    #[test]
    fn no_line_begins_with_a_mark_that_french_sets_apart() {
        let text = "la roue $A$ ; est-ce « non » ? ou :\noui : bien";
        assert_eq!(narrow(text), ["la", "roue", "A ;", "est-ce", "« non » ?", "ou :", "oui :", "bien"]);
    }

    #[test]
    fn a_point_is_not_broken() {
        let style = Style::regular(14.0);
        let text = "along (0, 1) and (−0.5; 2,5) to it (which, here, is far).";
        let expected =
            ["along", "(0, 1)", "and", "(−0.5; 2,5)", "to", "it", "(which,", "here,", "is", "far)."];
        assert_eq!(narrow(text), expected);
        let [wide, set] = [wrap(text, style, 900.0).unwrap().remove(0), typeset(text, style).unwrap()];
        assert_eq!(wide.width, set.width);
        let space = typeset("a b", style).unwrap().width - typeset("ab", style).unwrap().width;
        let [point, tight] = ["(0, 1)", "(0,1)"].map(|text| typeset(text, style).unwrap().width);
        assert!((point - tight - space).abs() < 0.01, "{point} {tight} {space}");
    }

    #[test]
    fn words_in_a_role_are_semibold_and_cut_out_of_the_line_with_their_formula() {
        let style = Style::regular(14.0);
        let line = typeset(r"see {a|the red box $\frac{A}{2}$} there", style).unwrap();
        let plain = typeset(r"see there", style).unwrap();
        assert!(plain.tints.is_empty() && plain.stretches().len() == 1);
        let [tint] = &line.tints[..] else { panic!("one stretch: {:?}", line.tints) };
        assert_eq!((tint.role.as_str(), tint.rules.clone()), ("a", 0..1));
        let stretches = line.stretches();
        let roles: Vec<_> = stretches.iter().map(|(role, ..)| *role).collect();
        assert_eq!(roles, [None, Some("a"), None]);
        for (_, x, part) in &stretches {
            assert!(part.glyphs.iter().all(|g| g.x >= -1e-9 && g.x < part.width), "{x}: {part:?}");
        }
        let put_back: Vec<_> = stretches
            .iter()
            .flat_map(|(_, x, part)| part.glyphs.iter().map(move |g| (g.glyph, x + g.x)))
            .collect();
        assert_eq!(put_back.len(), line.glyphs.len());
        let stays = |(now, before): (&(_, f64), &PlacedGlyph)| {
            now.0 == before.glyph && (now.1 - before.x).abs() < 1e-9
        };
        assert!(put_back.iter().zip(&line.glyphs).all(stays));
        assert!(line.glyphs[3..12].iter().all(|g| g.glyph.face == crate::typeset::Face::Semibold));
        let lines = wrap("see {a|the red box} there", style, 50.0).unwrap();
        assert!(lines.len() > 2 && lines.iter().filter(|l| !l.tints.is_empty()).count() >= 2);
    }

    #[test]
    fn a_newline_ends_a_line_of_a_paragraph_and_is_a_space_in_a_label() {
        let style = Style::regular(14.0);
        assert_eq!(wrap("a\nb", style, 500.0).unwrap().len(), 2);
        assert_eq!(
            typeset("a\nb", style).unwrap(),
            Line { markup: "a\nb".into(), ..typeset("a b", style).unwrap() }
        );
    }

    #[test]
    fn ascent_and_descent_hold_the_ink() {
        let line = typeset("$h_x$", Style::regular(16.0)).unwrap();
        assert!(line.descent > 2.0, "the subscript hangs below");
        assert!(line.ascent > 10.0, "h is taller than x");
        let x = typeset("x", Style::regular(10.0)).unwrap();
        assert_eq!((x.ascent, x.descent), (4.86, 0.0), "x is the least and stands on the baseline");
    }
}
