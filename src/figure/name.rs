//! How a body's name is set: as a letter of mathematics, or as words.
//!
//! A name is text and never the source of a formula. One letter, as in the article, is a symbol: *A*, *A*′,
//! *θ*. Everything else is upright words, spelled as the scene spells it, in scripts too: v with the script
//! bullet.

use crate::geometry::small;
use crate::typeset::{as_markup, escaped, plain};

/// Letters of a script at most: a longer one is wider than what it stands at, and is cut in its middle. Names
/// of one scene differ mostly at an end.
const SCRIPT: usize = 12;
/// Letters that stay of a name that is cut, before and after the cut.
const KEPT: [usize; 2] = [6, 4];
/// Letters of a name that has no room as it is, at least and at most: they are read as a sign, not a word.
const BRIEF: [usize; 2] = [3, 4];

/// A body's name, to be set in type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Name<'n> {
    /// The letters, or the source of the formula.
    text: &'n str,
    /// Whether the scene calls it by a formula.
    is_formula: bool,
}

impl<'n> Name<'n> {
    /// A name of letters.
    pub(crate) const fn words(text: &'n str) -> Self {
        Self { text, is_formula: false }
    }

    /// A name that a label writes as a formula, in LaTeX without dollar signs.
    pub(crate) const fn formula(text: &'n str) -> Self {
        Self { text, is_formula: true }
    }

    /// The name in plain words.
    #[must_use]
    pub(crate) fn in_words(self) -> String {
        if self.is_formula { plain(&format!("${}$", self.text)) } else { self.text.to_owned() }
    }

    /// Whether the name is a symbol: one Latin or Greek letter, primes after it allowed. Any other letter the
    /// formula's face has only upright, or not at all.
    #[must_use]
    pub(crate) fn is_symbol(self) -> bool {
        let mut letters = self.text.chars();
        let first = letters.next();
        let is_greek = |c| ('α'..='ω').contains(&c) || ('Α'..='Ω').contains(&c);
        first.is_some_and(|c| c.is_ascii_alphabetic() || is_greek(c)) && letters.all(is_prime)
    }

    /// The name as markup, with more primes after it: for the body elsewhere, or at another time.
    #[must_use]
    pub(crate) fn primed(self, primes: usize) -> String {
        if self.is_formula && primes == 0 {
            format!("${}$", self.text)
        } else if self.is_symbol() || self.is_formula {
            format!("${}{}$", self.term(), "'".repeat(primes))
        } else {
            format!("{}{}", as_markup(self.text), "′".repeat(primes))
        }
    }

    /// The name as a term within a formula, in LaTeX.
    #[must_use]
    pub(crate) fn term(self) -> String {
        if self.is_symbol() {
            return self.text.replace(is_prime, "'");
        }
        if self.is_formula {
            return format!("{{{}}}", self.text);
        }
        let words: Vec<&str> = self.text.split_ascii_whitespace().collect();
        format!(r"\text{{{}}}", escaped(&words.join(" ")))
    }

    /// The name as a term within a script, in LaTeX: a long one without its middle.
    #[must_use]
    pub(crate) fn script(self) -> String {
        self.cut().map_or_else(|| self.term(), |cut| Name::words(&cut).term())
    }

    /// The name as markup, a long one without its middle: where the whole one stands beside it.
    #[must_use]
    pub(crate) fn shortened(self) -> String {
        self.cut().map_or_else(|| self.primed(0), |cut| Name::words(&cut).primed(0))
    }

    /// The name as a term within a script, where it finds no room else: the letters that tell it from all of
    /// the `others`, of its beginning or else of its end. None where it is hardly longer than that.
    #[must_use]
    pub(crate) fn brief(self, others: &[&str]) -> Option<String> {
        let letters: Vec<char> = self.text.chars().collect();
        let [least, most] = BRIEF;
        if self.is_formula || self.is_symbol() || letters.len() < most + 2 {
            return None;
        }
        let others = || others.iter().filter(|other| **other != self.text);
        let head = |count: usize| letters[..count].iter().collect::<String>();
        let tail = |count: usize| letters[letters.len() - count..].iter().collect::<String>();
        let heads =
            (least..=most).map(head).filter(|head| !others().any(|other| other.starts_with(head.as_str())));
        let tails =
            (least..=most).map(tail).filter(|tail| !others().any(|other| other.ends_with(tail.as_str())));
        let ends = heads.map(|head| format!("{}…", head.trim_end()));
        let brief = ends.chain(tails.map(|tail| format!("…{}", tail.trim_start()))).next()?;
        Some(Name::words(&brief).term())
    }

    /// The letters of a long name without its middle; none of a short one.
    fn cut(self) -> Option<String> {
        let letters: Vec<char> = self.text.chars().collect();
        if letters.len() <= SCRIPT || self.is_formula {
            return None;
        }
        let [head, tail] = KEPT;
        let head: String = letters.iter().take(head).collect();
        let tail: String = letters.iter().skip(letters.len() - tail).collect();
        Some(format!("{}…{}", head.trim_end(), tail.trim_start()))
    }

    /// The name as the script of a letter, in LaTeX: `v_A`, `v_{\text{bullet}}`.
    #[must_use]
    pub(crate) fn below(self, letter: &str) -> String {
        if self.text.len() == 1 && self.is_symbol() {
            format!("{letter}_{}", self.text)
        } else {
            format!("{letter}_{{{}}}", self.script())
        }
    }

    /// The small letter of a symbol, in LaTeX.
    #[must_use]
    pub(crate) fn small(self) -> String {
        self.term().chars().map(small).collect()
    }

    /// A numbered point of the body, in LaTeX: the small letter of a symbol, `a_1` for A; for words the
    /// letter p with both below, `p_{\text{bullet},1}`.
    #[must_use]
    pub(crate) fn point(self, number: usize) -> String {
        if self.is_symbol() {
            format!("{}_{number}", self.small())
        } else {
            format!("p_{{{},{number}}}", self.script())
        }
    }
}

/// Whether a letter is a prime, as a keyboard or as print has it.
fn is_prime(c: char) -> bool {
    matches!(c, '\'' | '′')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::typeset::{Style, typeset};

    #[test]
    fn one_letter_is_a_symbol_and_everything_else_is_words() {
        for name in ["A", "b", "Γ", "θ", "A'", "B′", "x''"] {
            assert!(Name::words(name).is_symbol(), "{name}");
        }
        for name in ["", "'", "A1", "AB", "é", "Ж", "ό", "1", "_", "a_b", "木", "A b"] {
            assert!(!Name::words(name).is_symbol(), "{name}");
        }
    }

    #[test]
    fn a_symbol_is_set_in_the_formula_and_words_as_they_are_spelled() {
        assert_eq!(Name::words("A").primed(1), "$A'$");
        assert_eq!(Name::words("A′").primed(1), "$A''$");
        assert_eq!(Name::words("crate_1").primed(1), "crate_1′");
        assert_eq!(Name::words("$5").primed(0), r"\$5");
        assert_eq!(Name::words("{a|b}").primed(1), r"\{a|b}′");
        assert_eq!(Name::words("A").below("v"), "v_A");
        assert_eq!(Name::words("bullet").below("v"), r"v_{\text{bullet}}");
        assert_eq!(Name::words("B").point(2), "b_2");
        assert_eq!(Name::words("the crate 12").below("v"), r"v_{\text{the crate 12}}");
        assert_eq!(Name::words("the left crate 12").below("v"), r"v_{\text{the le…e 12}}");
        assert_eq!(Name::words("100%").point(1), r"p_{\text{100\%},1}");
        assert_eq!(Name::words("the left crate 12").shortened(), "the le…e 12");
        assert_eq!(["A", "bullet"].map(|name| Name::words(name).shortened()), ["$A$", "bullet"]);
    }

    #[test]
    fn a_brief_name_is_that_of_no_other_body() {
        let brief = |name: &'static str, other: &str| Name::words(name).brief(&[name, other]);
        assert_eq!(brief("hammer", "anvil").as_deref(), Some(r"\text{ham…}"));
        assert_eq!(brief("the hammer", "the anvil").as_deref(), Some(r"\text{…mer}"));
        assert_eq!(brief("crate_11", "crane").as_deref(), Some(r"\text{crat…}"));
        assert_eq!(brief("crate_11", "crate_12").as_deref(), Some(r"\text{…\_11}"));
        assert_eq!(brief("crate 1 left", "crate 2 left"), None);
        assert_eq!(brief("rock", "hero"), None, "short as it is");
    }

    #[test]
    fn every_form_of_every_name_that_the_faces_have_can_be_set() {
        let names = [
            "A", "θ''", "crate_1", "a b", "A&B", "{x}", "{a|x", r"\{b|x}", "}", r"\", r"a\$b", r"\frac",
            "^2", "~#", "é'",
        ];
        for name in names.map(Name::words) {
            let forms = [
                name.primed(0),
                name.primed(2),
                format!("${}$", name.below("v")),
                format!("${}$", name.point(1)),
            ];
            for markup in forms {
                assert!(typeset(&markup, Style::regular(16.0)).is_ok(), "{markup}");
            }
        }
    }
}
