//! The text of a scene and how to point into it.

use std::ops::Range;

use super::json;
use super::node::Node;
use super::problem::{Fault, Problem};
#[cfg(not(tracefig_page))]
use super::toml;

/// The language a scene is written in; the structure is the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Syntax {
    /// TOML.
    Toml,
    /// JSON, also one line of a JSONL stream.
    Json,
}

/// The text of a scene, its name for messages, and its language.
#[derive(Clone, Debug)]
pub struct Source {
    /// How messages call it: the path as given, or `<stdin>`.
    pub name: String,
    /// The whole text.
    pub text: String,
    /// The language that it is written in.
    pub syntax: Syntax,
    /// Number of its first line: 1, or for a line of a stream its own.
    pub first_line: usize,
}

/// A place as a reader counts: lines and columns from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Number of the line, from 1.
    pub line: usize,
    /// Number of the character in its line, from 1.
    pub column: usize,
}

impl Source {
    /// A text that is JSON when its first character is `{`, else TOML.
    ///
    /// ```
    /// use tracefig::scene::{Source, Syntax};
    /// assert_eq!(Source::new("-", "{}").syntax, Syntax::Json);
    /// assert_eq!(Source::new("-", "title = 'x'").syntax, Syntax::Toml);
    /// ```
    #[must_use]
    pub fn new(name: &str, text: &str) -> Self {
        let syntax = if text.trim_start().starts_with('{') { Syntax::Json } else { Syntax::Toml };
        Self { name: name.to_owned(), text: text.to_owned(), syntax, first_line: 1 }
    }

    /// One line of a JSONL stream.
    pub(crate) fn json_line(name: &str, text: &str, line: usize) -> Self {
        Self { name: name.to_owned(), text: text.to_owned(), syntax: Syntax::Json, first_line: line }
    }

    /// Line and column of a byte.
    ///
    /// ```
    /// use tracefig::scene::{Place, Source};
    /// let source = Source::new("s.toml", "a = 1\nδ = 2");
    /// assert_eq!(source.place(9), Place { line: 2, column: 3 });
    /// ```
    #[must_use]
    pub fn place(&self, at: usize) -> Place {
        let before = self.text.get(..at).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        Place {
            line: self.first_line + before.bytes().filter(|&b| b == b'\n').count(),
            column: 1 + before[line_start..].chars().count(),
        }
    }

    /// The line that holds a byte, and where that line starts.
    pub(super) fn line_at(&self, at: usize) -> (usize, &str) {
        let at = at.min(self.text.len());
        let start = self.text.as_bytes()[..at].iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
        let line = self.text[start..].split('\n').next().unwrap_or_default();
        (start, line.strip_suffix('\r').unwrap_or(line))
    }

    /// The values of the text as JSON, keys in its order; `None` where it can't be parsed.
    ///
    /// ```
    /// let source = tracefig::scene::Source::new("brand.toml", "[colors]\na = '#0072B2'");
    /// assert_eq!(source.json().as_deref(), Some(r##"{"colors":{"a":"#0072B2"}}"##));
    /// ```
    #[must_use]
    pub fn json(&self) -> Option<String> {
        self.tree().ok().map(|root| json::value(&root).to_string())
    }

    /// The JSON pointer (RFC 6901) to the value at a place; `None` in TOML or where the text is no JSON.
    pub(crate) fn pointer(&self, span: &Range<usize>) -> Option<String> {
        match self.syntax {
            Syntax::Toml => None,
            Syntax::Json => json::parse(&self.text).ok().map(|root| json::pointer(&root, span.start)),
        }
    }

    /// The tree of values, or what keeps it from being one.
    pub(crate) fn tree(&self) -> Result<Node, Vec<Problem>> {
        if self.is_blank() {
            let fault = if self.syntax == Syntax::Json { Fault::BlankLine } else { Fault::Empty };
            return Err(vec![Problem::new(fault, 0..0)]);
        }
        match self.syntax {
            #[cfg(not(tracefig_page))]
            Syntax::Toml => toml::parse(&self.text),
            // The page holds its scene as JSON.
            #[cfg(tracefig_page)]
            Syntax::Toml => Err(vec![Problem::new(Fault::Empty, 0..0)]),
            Syntax::Json => json::parse(&self.text),
        }
    }

    /// Whether there is nothing but blanks and comments.
    fn is_blank(&self) -> bool {
        self.text.lines().all(|line| {
            let line = line.trim();
            line.is_empty() || (self.syntax == Syntax::Toml && line.starts_with('#'))
        })
    }
}
