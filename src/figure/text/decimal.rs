//! The sign between the whole and the rest of a number, as the language of the scene has it: 0.343 or 0,343.
//!
//! Source: Unicode CLDR 45, `numbers/symbols/decimal`. A language that is not in the list has a point.

use crate::scene::Scene;
use crate::typeset::{Piece, pieces};

/// Languages that write a comma, by their ISO 639 code.
const COMMA: [&str; 51] = [
    "af", "az", "be", "bg", "br", "bs", "ca", "cs", "da", "de", "el", "eo", "es", "et", "eu", "fi", "fo",
    "fr", "fy", "gl", "hr", "hu", "hy", "id", "is", "it", "ka", "kk", "kl", "ky", "lb", "lt", "lv", "mk",
    "nb", "nl", "nn", "no", "pl", "pt", "ro", "ru", "sk", "sl", "sq", "sr", "sv", "tr", "uk", "uz", "vi",
];
/// Regions that write a point where the rest of the language writes a comma.
const POINT: [(&str, &[&str]); 3] = [
    ("de", &["ch", "li"]),
    ("es", &["419", "cu", "do", "gt", "hn", "mx", "ni", "pa", "pe", "pr", "sv", "us"]),
    ("it", &["ch"]),
];

/// The sign between the whole and the rest of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Decimal {
    /// A point, as in English.
    Point,
    /// A comma, as in most of Europe and Latin America.
    Comma,
}

impl Decimal {
    /// The sign of the language that a scene is written in.
    pub(crate) fn of(scene: &Scene) -> Self {
        scene.lang.as_ref().map_or(Self::Point, |lang| Self::of_tag(&lang.value))
    }

    /// The sign of a language by its tag, as `de` or `pt-BR`.
    fn of_tag(tag: &str) -> Self {
        let tag = tag.to_ascii_lowercase();
        let mut parts = tag.split('-');
        let language = parts.next().unwrap_or("");
        let excepted = POINT.iter().find(|(of, _)| *of == language).map_or(&[][..], |(_, regions)| regions);
        let has_point = parts.any(|part| excepted.contains(&part));
        if COMMA.contains(&language) && !has_point { Self::Comma } else { Self::Point }
    }

    /// The number of a value, as markup.
    pub(crate) fn in_number(self, markup: String) -> String {
        match self {
            Self::Point => markup,
            Self::Comma if markup.contains('$') => self.in_formulas(&markup),
            Self::Comma => markup.replace('.', ","),
        }
    }

    /// The number of a value within a formula, in LaTeX.
    pub(crate) fn in_latex(self, number: String) -> String {
        match self {
            Self::Point => number,
            Self::Comma => number.replace('.', "{,}"),
        }
    }

    /// Markup of ours with the numbers in its formulas as the language has them. A name is no number, and
    /// what parts two numbers is a semicolon then.
    pub(crate) fn in_formulas(self, markup: &str) -> String {
        let parts = if self == Self::Comma { pieces(markup).unwrap_or_default() } else { Vec::new() };
        let mut out = String::with_capacity(markup.len());
        let mut done = 0;
        for part in parts {
            let Piece::Formula(at, latex) = part else { continue };
            out.push_str(&markup[done..at]);
            out.push_str(&with_commas(latex));
            done = at + latex.len();
        }
        out.push_str(&markup[done..]);
        out
    }
}

/// A formula whose numbers have commas.
fn with_commas(latex: &str) -> String {
    let bytes = latex.as_bytes();
    let is_digit = |at: Option<usize>| at.and_then(|at| bytes.get(at)).is_some_and(u8::is_ascii_digit);
    let mut out = String::with_capacity(latex.len());
    for (at, c) in latex.char_indices() {
        match c {
            // A full stop of a name has a backslash before it.
            '.' if is_digit(at.checked_sub(1)) && is_digit(Some(at + 1)) => out.push_str("{,}"),
            ',' if ends_in_number(&latex[..at]) && bytes.get(at + 1) == Some(&b' ') => out.push(';'),
            c => out.push(c),
        }
    }
    out
}

/// Whether a formula so far ends in a digit, or in the power of one: `10^{-6}`.
fn ends_in_number(latex: &str) -> bool {
    let power = latex.strip_suffix('}').and_then(|open| open.rsplit_once("^{"));
    match power {
        Some((_, exponent)) => !exponent.is_empty() && !exponent.contains(['{', '}']),
        None => latex.ends_with(|c: char| c.is_ascii_digit()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_language_has_a_comma_or_a_point_and_a_region_may_differ() {
        for tag in ["de", "DE", "de-AT", "pt-BR", "fr-CH", "es-ES", "es", "sr-Latn-RS"] {
            assert_eq!(Decimal::of_tag(tag), Decimal::Comma, "{tag}");
        }
        for tag in ["en", "en-GB", "de-CH", "es-MX", "es-419", "ja", "zh-Hans", "x-none", "", "den"] {
            assert_eq!(Decimal::of_tag(tag), Decimal::Point, "{tag}");
        }
        assert!(COMMA.is_sorted(), "so that a second entry is seen");
    }

    #[test]
    fn numbers_of_labels_have_commas_and_names_and_scripts_keep_what_they_are() {
        let set = |markup| Decimal::Comma.in_formulas(markup);
        assert_eq!(set("depth $d = 2.5$"), "depth $d = 2{,}5$");
        assert_eq!(set("max $= (1.5, 2)$"), "max $= (1{,}5; 2)$");
        assert_eq!(set(r"v1.2 $v_{\text{v1\.2}} = 10^{-3}$"), r"v1.2 $v_{\text{v1\.2}} = 10^{-3}$");
        assert_eq!(set(r"$(8 \times 10^{-6}, 10^{-6})$"), r"$(8 \times 10^{-6}; 10^{-6})$");
        assert_eq!(set(r"$p_{\text{b}}, q^{2}_{1}, 3$"), r"$p_{\text{b}}, q^{2}_{1}, 3$");
        assert_eq!(set(r"$p_{\text{b},1}$"), r"$p_{\text{b},1}$");
        assert_eq!(Decimal::Point.in_formulas("$d = 2.5$"), "$d = 2.5$");
        assert_eq!(Decimal::Comma.in_number("−2.5".to_owned()), "−2,5");
        assert_eq!(Decimal::Comma.in_number(r"$1.5 \times 10^{-9}$".to_owned()), r"$1{,}5 \times 10^{-9}$");
    }
}
