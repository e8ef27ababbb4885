//! Lines from words and formulas, broken where a space allows it.
//!
//! Breaking is first-fit: a caption has two lines, where a global optimum would rarely differ. Runs of spaces
//! count as one, those at the ends of a line as none.

use super::line::{Line, PlacedGlyph, Rule, Run, Style, Tint, TypesetError};
use super::markup::{Piece, characters, pieces};
use super::{formula, words};

/// Height of the letter x in the word face, in ems; a line's ascent is never less.
const X_HEIGHT: f64 = 0.486;

/// Bytes of one markup; what is longer is an error. A page holds a few thousand letters.
const LONGEST: usize = 10_000;

/// What a newline in the markup means.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Newlines {
    /// A newline is a space.
    Spaces,
    /// A newline ends the line.
    Breaks,
}

/// Sets lines of at most `width` page pixels; a word or formula that is wider has a line of its own.
pub(super) fn lines(
    markup: &str,
    style: Style,
    width: f64,
    newlines: Newlines,
) -> Result<Vec<Line>, TypesetError> {
    if markup.len() > LONGEST {
        let message = format!("a text of {} bytes; the longest allowed has {LONGEST}", markup.len());
        return Err(TypesetError { offset: markup.floor_char_boundary(LONGEST), message });
    }
    let mut setter = Setter { style, newlines, width, space: words::space(style), ..Setter::new() };
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
    setter.end_line();
    Ok(setter.lines.into_iter().map(|draft| draft.into_line(markup, style.size)).collect())
}

/// A line, or a part of one, while it is set.
#[derive(Default)]
struct Draft {
    /// The glyphs so far, from the draft's start.
    glyphs: Vec<PlacedGlyph>,
    /// The rules so far, from the draft's start.
    rules: Vec<Rule>,
    /// The stretches so far that wear a role.
    tints: Vec<Tint>,
    /// The words and formulas so far.
    runs: Vec<Run>,
    /// The advance width so far, in page pixels.
    width: f64,
}

impl Draft {
    fn is_empty(&self) -> bool {
        self.glyphs.is_empty() && self.rules.is_empty()
    }

    fn append(&mut self, other: Self) {
        let x = self.width;
        let (glyphs, rules) = (self.glyphs.len(), self.rules.len());
        for Tint { role, glyphs: g, rules: r, x: [from, to] } in other.tints {
            let (g, r) = (glyphs + g.start..glyphs + g.end, rules + r.start..rules + r.end);
            match self.tints.last_mut() {
                // Nothing that is seen lies between the words of one stretch.
                Some(last)
                    if last.role == role && last.glyphs.end == g.start && last.rules.end == r.start =>
                {
                    (last.glyphs.end, last.rules.end, last.x[1]) = (g.end, r.end, x + to);
                }
                _ => self.tints.push(Tint { role, glyphs: g, rules: r, x: [x + from, x + to] }),
            }
        }
        let moved = |run: Run| Run { x: run.x.map(|from| x + from), ..run };
        self.runs.extend(other.runs.into_iter().map(moved));
        self.glyphs.extend(other.glyphs.into_iter().map(|g| PlacedGlyph { x: x + g.x, ..g }));
        self.rules.extend(other.rules.into_iter().map(|r| Rule { x: x + r.x, ..r }));
        self.width += other.width;
    }

    fn into_line(self, markup: &str, size: f64) -> Line {
        let (mut ascent, mut descent) = (X_HEIGHT * size, 0.0_f64);
        for g in &self.glyphs {
            let [_, top, _, bottom] = g.glyph.outline().bounds;
            let em = g.size / super::face::UNITS_PER_EM;
            ascent = ascent.max(-(g.y + f64::from(top) * em));
            descent = descent.max(g.y + f64::from(bottom) * em);
        }
        for r in &self.rules {
            ascent = ascent.max(-r.y);
            descent = descent.max(r.y + r.height);
        }
        let Self { glyphs, rules, tints, runs, width } = self;
        Line { markup: markup.to_owned(), glyphs, rules, tints, runs, width, ascent, descent }
    }
}

/// Lines, a line being filled, and the chunk without a break being set.
struct Setter<'m> {
    /// How words are set.
    style: Style,
    /// The role that is worn at this place of the markup.
    role: Option<&'m str>,
    /// What newlines mean.
    newlines: Newlines,
    /// Page pixels that a line may take.
    width: f64,
    /// Page pixels that a space takes.
    space: f64,
    /// The lines that are full.
    lines: Vec<Draft>,
    /// The line being filled.
    line: Draft,
    /// What was set since the last space outside a formula.
    chunk: Draft,
}

impl Setter<'_> {
    fn new() -> Self {
        Self {
            style: Style::regular(0.0),
            role: None,
            newlines: Newlines::Spaces,
            width: f64::INFINITY,
            space: 0.0,
            lines: Vec::new(),
            line: Draft::default(),
            chunk: Draft::default(),
        }
    }

    fn words(&mut self, offset: usize, text: &str) -> Result<(), TypesetError> {
        let mut rest = characters(offset, text).peekable();
        while let Some(&(_, character)) = rest.peek() {
            if character.is_ascii_whitespace() {
                rest.next();
                self.end_chunk();
                if character == '\n' && self.newlines == Newlines::Breaks {
                    self.end_line();
                }
                continue;
            }
            let word = std::iter::from_fn(|| rest.next_if(|&(_, c)| !c.is_ascii_whitespace()));
            let mut read = String::new();
            let word = word.inspect(|&(_, c)| read.push(c));
            let style = if self.role.is_some() { Style::semibold(self.style.size) } else { self.style };
            let set = words::set(word, style)?;
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
        self.chunk.append(Draft { glyphs, rules, tints: tint.into_iter().collect(), runs, width });
    }

    /// Adds the chunk to the line, or to the next one where it does not fit.
    fn end_chunk(&mut self) {
        if self.chunk.is_empty() {
            return;
        }
        let chunk = std::mem::take(&mut self.chunk);
        if !self.line.is_empty() && self.line.width + self.space + chunk.width > self.width {
            self.end_line();
        }
        if !self.line.is_empty() {
            self.line.width += self.space;
            self.line.runs.iter_mut().last().into_iter().for_each(|run| run.text.push(' '));
        }
        self.line.append(chunk);
    }

    fn end_line(&mut self) {
        if !self.line.is_empty() {
            self.lines.push(std::mem::take(&mut self.line));
        }
    }
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
