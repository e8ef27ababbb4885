//! What a message says of a fault, in the words of the language that the scene is written in: a line of JSON
//! has objects and no `[table]`, and a number that no double holds is told as it stands there.

use std::fmt;
use std::ops::Range;

use super::problem::Fault;
use super::source::{Source, Syntax};

/// A fault that can be shown to a reader: its `Display` says what is wrong, "expected X, got Y".
pub trait Explain: fmt::Display {
    /// The stable word for programs, one of [`ERRORS`](super::ERRORS) or of the codes of shapes.
    fn code(&self) -> &'static str;

    /// What would help, where something is known that would, as it is written in TOML.
    fn help(&self) -> Option<String>;

    /// What would help, for a reader who looks at the scene: of an error always something, if only what helps
    /// against any of its kind.
    fn remedy(&self) -> Option<String> {
        self.help()
    }

    /// What is wrong, in the words of the source's language; `span` are the bytes at fault.
    ///
    /// ```
    /// use tracefig::scene::{Explain, Fault, Source};
    /// let got = "a list of 2 values".to_owned();
    /// let fault = Fault::WrongType { key: "canvas".to_owned(), expected: "a table".to_owned(), got };
    /// let of = |text: &str| fault.told(&Source::new("s", text), &(0..1));
    /// assert_eq!(of("canvas = [1, 2]"), "`canvas`: expected a table, got a list of 2 values");
    /// assert_eq!(of("{\"canvas\": [1, 2]}"), "`canvas`: expected an object, got a list of 2 values");
    /// ```
    fn told(&self, _source: &Source, _span: &Range<usize>) -> String {
        self.to_string()
    }

    /// Whether it lies at a place in the text, which is then quoted; a file that can't be read has none.
    fn has_place(&self) -> bool {
        true
    }
}

impl Explain for Fault {
    fn code(&self) -> &'static str {
        Self::code(self)
    }

    fn help(&self) -> Option<String> {
        Self::help(self)
    }

    fn remedy(&self) -> Option<String> {
        self.help().or_else(|| Some(self.general()))
    }

    fn told(&self, source: &Source, span: &Range<usize>) -> String {
        match self {
            Self::WrongType { key, expected, got } if source.syntax == Syntax::Json => {
                let got = if got == "a table" { "an object".to_owned() } else { got.clone() };
                let expected = of_json(expected);
                Self::WrongType { key: key.clone(), expected, got }.to_string()
            }
            Self::MissingKey { key, place, expected } if source.syntax == Syntax::Json => {
                let (key, place, expected) = (key.clone(), place.clone(), of_json(expected));
                Self::MissingKey { key, place, expected }.to_string()
            }
            Self::NotFinite { key, .. } => match source.text.get(span.clone()).filter(|text| is_digits(text))
            {
                Some(text) => {
                    let got = format!("{text}, which is beyond {:e}", f64::MAX);
                    Self::NotFinite { key: key.clone(), got }.to_string()
                }
                None => self.to_string(),
            },
            _ => self.to_string(),
        }
    }

    fn has_place(&self) -> bool {
        !matches!(self, Self::Unreadable { .. } | Self::Endless { .. })
    }
}

/// Whether a number is written in digits, and not as a word for what is none.
fn is_digits(text: &str) -> bool {
    text.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit() || c == '.')
}

/// What was expected, as JSON calls it.
fn of_json(expected: &str) -> String {
    expected.replace("a table", "an object").replace("tables", "objects")
}

/// What would help, as it is written in a language.
pub(super) fn help_in(syntax: Syntax, help: Option<String>) -> Option<String> {
    help.map(|help| if syntax == Syntax::Json { in_json(&help) } else { help })
}

/// A help line with its TOML as JSON: `key = value` as `"key": value`, of `a.b` with b inside, `[[key]]` as a
/// list of objects and `[key]` as an object, which in backticks is a name.
fn in_json(help: &str) -> String {
    let is_of_key = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    let is_key = |text: &str| !text.is_empty() && text.chars().all(is_of_key);
    let nested = |key: &str| key.replace('.', "\": {\"");
    let help = help.replace(", which stands above the first `[table]`", "").replace("a table", "an object");
    let (mut json, mut open, mut rest) = (String::new(), 0, help.as_str());
    while let Some(c) = rest.chars().next() {
        let word = rest.split(|c: char| !is_of_key(c)).next().unwrap_or_default();
        let in_brackets = |left: &str, right: &str| {
            let (key, after) = rest.strip_prefix(left)?.split_once(right)?;
            is_key(key).then_some((key, after))
        };
        let value = rest[word.len()..].strip_prefix(" = ").filter(|_| is_key(word));
        let (said, after) = if let Some((key, after)) = in_brackets("[[", "]]") {
            (format!("\"{key}\": [{{…}}]"), after)
        } else if let Some((key, after)) = in_brackets("`[", "]`") {
            (format!("`{key}`"), after)
        } else if let Some((key, after)) = in_brackets("[", "]") {
            let close = "}".repeat(key.matches('.').count());
            (format!("\"{}\": {{…}}{close}", nested(key)), after)
        } else if let Some(after) = value {
            open += word.matches('.').count();
            (format!("\"{}\": ", nested(word)), after)
        } else {
            let (same, after) = rest.split_at(word.len().max(c.len_utf8()));
            (same.to_owned(), after)
        };
        json.push_str(&said);
        rest = after;
    }
    json + &"}".repeat(open)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Ink, open_jsonl_line, open_text, solve_jsonl_line};

    #[test]
    fn help_for_a_line_of_json_is_written_in_json() {
        for (toml, json) in [
            (
                r#"as: query = { kind = "separation", of = ["A"] }"#,
                r#"as: "query": { "kind": "separation", "of": ["A"] }"#,
            ),
            ("as: shapes.A = { radius = 1 }", r#"as: "shapes": {"A": { "radius": 1 }}"#),
            ("each is a table of its own: [[steps]]", r#"each is an object of its own: "steps": [{…}]"#),
            ("there is one alone: [query]", r#"there is one alone: "query": {…}"#),
            ("each is one: [shapes.A]", r#"each is one: "shapes": {"A": {…}}"#),
            ("it is a key of `[canvas]`", "it is a key of `canvas`"),
            ("`view = [x0, y0, x1, y1]` does", r#"`"view": [x0, y0, x1, y1]` does"#),
            ("did you mean `größe`?", "did you mean `größe`?"),
        ] {
            assert_eq!(in_json(toml), json);
        }
    }

    #[test]
    fn a_line_that_is_no_object_is_told_so_without_brackets_of_toml() {
        let line = solve_jsonl_line("[1,2]", 1).line;
        assert!(line.contains("expected an object, got a list of 2 values"), "{line}");
        assert!(
            line.contains(r#"a scene is one, as: \"shapes\": {\"A\": { \"kind\": \"circle\","#),
            "{line}"
        );
        let line =
            solve_jsonl_line(r#"{"shapes": {"A": {"kind": "circle", "radius": 1}}, "query": [{}]}"#, 1).line;
        assert!(line.contains(r#"there is one alone: \"query\": {…}"#), "{line}");
        let line = open_jsonl_line(r#"{"query": 3, "shapes": {"A": {"kind": "circle", "radius": 1}}}"#, 1)
            .unwrap_err()
            .render(Ink::Plain);
        assert!(line.contains("expected an object, got 3"), "{line}");
    }

    #[test]
    fn a_number_beyond_a_double_is_told_as_it_is_written() {
        let json = r#"{"query": {"kind": "bounds", "of": ["A"]},
            "shapes": {"A": {"kind": "circle", "radius": -1e400}}}"#;
        let line = solve_jsonl_line(json, 1).line;
        assert!(line.contains("expected a finite number, got -1e400, which is beyond 1.79"), "{line}");
        let toml = |radius: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = {radius} }}
                query = {{ kind = 'bounds', of = ['A'] }}"
            );
            open_text("s.toml", &text).unwrap_err().render(Ink::Plain)
        };
        assert!(toml("1e400").contains("got 1e400, which is beyond"), "{}", toml("1e400"));
        assert!(toml("inf").contains("expected a finite number, got inf\n"), "{}", toml("inf"));
    }
}
