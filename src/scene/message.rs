//! A problem as a person reads it: what is wrong, file, line and column, the line itself, what would help.
//!
//! ```text
//! error[unknown-key]: unknown key `raduis` in a circle
//!  --> scene.toml:3:1
//!   |
//! 3 | raduis = 1
//!   | ^^^^^^
//!   |
//!   = help: did you mean `radius`?
//! ```

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Element, Level, Origin, Renderer, Snippet};

use super::explain::{Explain, help_in};
use super::problem::Problem;
use super::source::Source;
use super::visible::{brief, visible};

/// Whether anyone is told notes and warnings: a page shows the picture alone, and its module has none.
pub(crate) const NOTES: bool = !cfg!(tracefig_page);

/// How grave a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// There is no figure or answer.
    Error,
    /// There is one, and something about it should be better.
    Warning,
    /// There is one, and it shows less than another answer to the same question would have let it show.
    Note,
}

/// Whether a message is coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Characters only.
    Plain,
    /// With the escape codes of a terminal.
    Coloured,
}

/// Characters of a line that are quoted at most, around the place when the line is longer: what a terminal
/// shows without wrapping, wide as it is.
const QUOTED: usize = 120;

/// Characters that are quoted before the place when the line is longer: somewhat less than half of
/// [`QUOTED`], as what follows a mistake explains it more often.
const BEFORE: usize = 50;

/// The message, ending in a line break.
///
/// ```
/// use tracefig::scene::{Fault, Ink, Problem, Severity, Source, message};
/// let source = Source::new("s.toml", "title = 1");
/// let fault = Fault::WrongType { key: "title".into(), expected: "a text".into(), got: "1".into() };
/// let text = message(&source, &Problem::new(fault, 8..9), Severity::Error, Ink::Plain);
/// assert!(text.starts_with("error[wrong-type]: `title`: expected a text, got 1\n --> s.toml:1:9\n"));
/// assert!(text.contains("1 | title = 1\n  |         ^"));
/// ```
#[must_use]
pub fn message<F: Explain>(source: &Source, problem: &Problem<F>, severity: Severity, ink: Ink) -> String {
    message_at(source, problem, source.pointer(&problem.span), severity, ink)
}

/// The message of a problem whose JSON pointer is known; see [`message`].
pub(super) fn message_at<F: Explain>(
    source: &Source,
    problem: &Problem<F>,
    pointer: Option<String>,
    severity: Severity,
    ink: Ink,
) -> String {
    let level = match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let (fault, name) = (&problem.fault, visible(&source.name).into_owned());
    let mut elements: Vec<Element<'_>> = Vec::new();
    if name.is_empty() {
        // Of values that a program made there is no text.
    } else if fault.has_place() {
        let place = source.place(problem.span.start);
        let origin = Origin::path(name.as_str()).line(place.line).char_column(place.column);
        let Quote { line, span, from_start } = quote(source, &problem.span).visible();
        let is_blank = line.trim().is_empty();
        let quoted =
            Snippet::source(line).line_start(place.line).annotation(AnnotationKind::Primary.span(span));
        if is_blank {
            elements.push(origin.into());
        } else if from_start {
            elements.push(quoted.path(name.as_str()).into());
        } else {
            // The snippet would count columns from where the line was cut.
            elements.push(origin.into());
            elements.push(quoted.into());
        }
    } else {
        elements.push(Origin::path(name.as_str()).into());
    }
    // What helps against any fault of a kind speaks of a file: what a program made of values has no name.
    let help = if source.name.is_empty() { fault.help() } else { fault.remedy() };
    elements.extend(help_in(source.syntax, help).map(|help| Level::HELP.message(brief(&help)).into()));
    elements.extend(
        pointer
            .filter(|pointer| !pointer.is_empty())
            .map(|pointer| Level::NOTE.message(format!("at {}", brief(&pointer))).into()),
    );
    let report =
        level.primary_title(brief(&fault.told(source, &problem.span))).id(fault.code()).elements(elements);
    let renderer = match ink {
        Ink::Plain => Renderer::plain(),
        Ink::Coloured => Renderer::styled(),
    };
    aligned(&renderer.render(&[report]))
}

/// A rendered message, ending in a line break, in the columns of all others: one without a quote, whose place
/// would stand a column further left, and without the row that announces a quote which was cut.
fn aligned(rendered: &str) -> String {
    let is_quoted = rendered.lines().any(|line| uncoloured(line).trim() == "|");
    let mut text = String::new();
    for (i, line) in rendered.lines().enumerate() {
        if uncoloured(line).trim() == ":::" {
            continue;
        }
        text.push_str(if i == 0 || is_quoted { "" } else { " " });
        text.push_str(line);
        text.push('\n');
    }
    text
}

/// A rendered line without the codes that colour it, each `ESC[` up to an `m`.
fn uncoloured(line: &str) -> String {
    let mut parts = line.split('\u{1b}');
    let first = parts.next().unwrap_or_default().to_owned();
    first + &parts.map(|part| part.split_once('m').map_or(part, |(_, rest)| rest)).collect::<String>()
}

/// The line of a place, cut to what can be read, and the place within it.
struct Quote {
    /// The line, cut where it is long.
    line: String,
    /// The place, in bytes of `line`.
    span: Range<usize>,
    /// Whether nothing was cut off before the place.
    from_start: bool,
}

impl Quote {
    /// The quote with signs for what would act; a tab stays one.
    fn visible(self) -> Self {
        let signs = |text: &str| text.split('\t').map(visible).collect::<Vec<_>>().join("\t");
        let Range { start, end } = self.span;
        let (Some(before), Some(marked), Some(after)) =
            (self.line.get(..start), self.line.get(start..end), self.line.get(end..))
        else {
            return Self { line: signs(&self.line), span: 0..0, ..self };
        };
        let (mut line, marked) = (signs(before), signs(marked));
        let start = line.len();
        line.push_str(&marked);
        let span = start..line.len();
        line.push_str(&signs(after));
        Self { line, span, ..self }
    }
}

/// The line of a place, cut to what can be read, and the place within it.
fn quote(source: &Source, span: &Range<usize>) -> Quote {
    let (line_start, line) = source.line_at(span.start);
    let start = span.start.saturating_sub(line_start).min(line.len());
    let end = span.end.saturating_sub(line_start).clamp(start, line.len());
    if line.chars().count() <= QUOTED {
        return Quote { line: line.to_owned(), span: start..end, from_start: true };
    }
    let back = line[..start].char_indices().rev().take(BEFORE).last().map_or(start, |(i, _)| i);
    let forward = line[back..].char_indices().nth(QUOTED).map_or(line.len(), |(i, _)| back + i);
    let before = if back > 0 { "…" } else { "" };
    let after = if forward < line.len() { "…" } else { "" };
    let shift = before.len();
    Quote {
        line: format!("{before}{}{after}", &line[back..forward]),
        span: start - back + shift..end.min(forward).max(start) - back + shift,
        from_start: back == 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Fault;

    fn plain(source: &Source, span: Range<usize>) -> String {
        let fault = Fault::Syntax { message: "broken".to_owned() };
        message(source, &Problem::new(fault, span), Severity::Error, Ink::Plain)
    }

    #[test]
    fn a_long_line_is_quoted_around_the_place() {
        let text = format!("{}!{}", "δ".repeat(5000), "x".repeat(5000));
        let got = plain(&Source::new("long.toml", &text), 10_000..10_001);
        assert!(got.contains("--> long.toml:1:5001"), "{got}");
        assert!(got.contains("…δδδ") && got.contains("δ!xxx") && got.contains("x…"), "{got}");
        assert!(got.lines().all(|line| line.chars().count() < 160), "{got}");
    }

    #[test]
    fn every_message_has_the_same_columns_coloured_or_not() {
        let long = format!("{}!", "x".repeat(500));
        for (text, span) in [("a = 1", 4..5), ("", 0..0), (long.as_str(), 500..501)] {
            let source = Source::new("s.toml", text);
            let fault = || Fault::UnknownKey { key: "a".into(), place: "b".into(), known: vec!["c".into()] };
            let said = |ink| message(&source, &Problem::new(fault(), span.clone()), Severity::Error, ink);
            let (got, coloured) = (said(Ink::Plain), said(Ink::Coloured));
            assert!(got.lines().nth(1).unwrap().starts_with(" --> s.toml:1:"), "{got}");
            assert!(got.lines().last().unwrap().starts_with("  = help: "), "{got}");
            assert!(!got.contains(":::"), "{got}");
            let uncoloured: String = coloured.lines().map(|line| uncoloured(line) + "\n").collect();
            assert_eq!(uncoloured, got);
        }
    }

    #[test]
    fn a_place_beyond_its_line_marks_the_rest_of_it() {
        let got = plain(&Source::new("s.json", "{\n  \"a\": [1,\n 2]\n}"), 9..16);
        assert!(got.contains("2 |   \"a\": [1,\n  |        ^^^"), "{got}");
        assert!(got.contains("= note: at /a"), "{got}");
    }

    #[test]
    fn a_place_at_the_end_of_the_text_is_shown() {
        let got = plain(&Source::new("s.toml", "a ="), 3..3);
        assert!(got.contains("--> s.toml:1:4") && got.contains("1 | a ="), "{got}");
    }

    #[test]
    fn escape_codes_in_a_scene_do_not_reach_the_terminal() {
        let got = plain(&Source::new("s.toml", "title = '\u{1b}[31mred'"), 0..5);
        assert!(!got.contains('\u{1b}'), "{got:?}");
        let got =
            plain(&Source::new("\u{1b}[31m\n.json", "{\"\u{9b}\": {\"\\u001b[2J\\u0085\": 1}}"), 26..27);
        assert!(got.contains("--> ␛[31m␊.json:1:") && got.contains("= note: at /�/␛[2J�"), "{got:?}");
        assert!(!got.contains(['\u{1b}', '\u{85}', '\u{9b}']), "{got:?}");
    }

    #[test]
    fn a_key_that_fills_the_screen_is_cut() {
        let key = "k".repeat(900_000);
        let fault =
            Fault::UnknownKey { key: key.clone(), place: "a circle".to_owned(), known: vec![key.clone()] };
        let source = Source::new("s.json", &format!("{{\"{key}\": 1}}"));
        let got = message(&source, &Problem::new(fault, 2..900_002), Severity::Error, Ink::Plain);
        assert!(got.len() < 6_000, "{} bytes", got.len());
    }
}
