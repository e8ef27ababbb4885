//! The head of a document of several figures: what it is, and a line for the name of who fills it in.
//!
//! It stands in the margin of the first sheet, so that the figures are as large with it as without.

use std::sync::Arc;

use crate::drawing::{Color, Drawing, Paint, Point, Role, Shown, Text};
use crate::typeset::{Line, Style, as_markup, typeset};

/// Points of its letters: a little larger than a usual figure's on the sheet.
const LETTERS: f64 = 12.0;
/// Where its baseline is, as a part of the margin: letters end 5 mm below the paper's edge, which a printer
/// needs, and their tails 4 mm above the figures.
const BASELINE: f64 = 0.65;
/// White between the heading and the name, in points.
const APART: f64 = 24.0;
/// Underscores of the line: 5 cm, a first and a last name by hand.
const BLANK: usize = 24;
/// What stands before the line, in each of [`Drawing::LANGS`].
const NAME: [&str; Drawing::LANGS.len()] = ["Name", "Name", "Nom", "Nombre"];

/// What stands above the figures of the first sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heading {
    /// What the document is, in plain words; nothing where empty.
    pub title: String,
    /// Whether there is a line for a name at the right.
    pub name: bool,
}

impl Heading {
    /// Its words on a sheet of a width and a margin in points, in the language of a figure.
    pub(super) fn words(&self, (width, margin): (f64, f64), of: Option<&Drawing>) -> Vec<Text> {
        let word = NAME[of.and_then(Drawing::of_langs).unwrap_or(0)];
        let line = self.name.then(|| format!("{word}: {}", "_".repeat(BLANK)));
        let name = line.and_then(|line| set(&line, Style::regular(LETTERS), f64::INFINITY));
        let taken = name.as_ref().map_or(0.0, |line| line.width + APART);
        let title = Some(&self.title).filter(|title| !title.is_empty());
        let title = title.and_then(|t| set(t, Style::semibold(LETTERS), width - 2.0 * margin - taken));
        let right = name.map(|line| (width - margin - line.width, line));
        let all = title.map(|line| (margin, line)).into_iter().chain(right);
        all.map(|(x, line)| at(Point::new(x, BASELINE * margin), line)).collect()
    }
}

/// Plain words in a style, smaller where they would be wider than a length in points.
fn set(words: &str, style: Style, most: f64) -> Option<Line> {
    let markup = as_markup(words);
    let line = typeset(&markup, style).ok()?;
    if line.width <= most {
        return Some(line);
    }
    typeset(&markup, Style { size: style.size * most / line.width, ..style }).ok()
}

/// Words that begin at a point.
fn at(origin: Point, line: Line) -> Text {
    let paint = Paint::role(Role::Ink, Color::hex(0));
    Text { line: Arc::new(line), origin, paint, halo: None, shown: Shown::ALWAYS }
}

#[cfg(test)]
mod tests {
    use super::super::samples::everything;
    use super::*;

    #[test]
    fn a_heading_and_a_line_for_a_name_stand_in_the_margin_and_apart() {
        let german = Drawing { lang: Some("de".into()), ..everything() };
        for title in ["Blatt 3", &"sehr lang ".repeat(30)] {
            let heading = Heading { title: title.to_owned(), name: true };
            let words = heading.words((595.0, 42.0), Some(&german));
            let [title, name] = &words[..] else { panic!("two") };
            assert!(title.origin.x + title.line.width < name.origin.x);
            assert!(name.origin.x + name.line.width < 595.0 - 42.0 + 1e-6);
            assert!(name.line.markup.starts_with("Name: ") && name.origin.y < 42.0);
        }
        assert!(Heading::default().words((595.0, 42.0), Some(&german)).is_empty());
    }
}
