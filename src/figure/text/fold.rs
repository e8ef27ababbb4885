//! A long name on two or three lines, as short as they can be.

use std::sync::Arc;

use crate::figure::placement::{Cut, Fold};
use crate::typeset::{Line, Style, line, paragraph};

/// A name that is shorter than this, in ems, stays on one line: a word of eight letters.
const SHORT: f64 = 4.0;
/// A word beside what is clear already stays on one line if it is shorter than this, in ems: longer than all
/// that a layer says by itself, so that what is folded has a long name in it.
const WORDY: f64 = 10.0;
/// A letter with its script is longer than this, in ems.
const SCRIPTED: f64 = 1.5;
/// Most lines of a name; with more it would be read as a paragraph.
const MOST: usize = 3;
/// Lines are as short as they can be up to this, in ems.
const STEP: f64 = 0.25;

/// A word of more letters than this may be broken where it has no space.
const LONG: usize = 9;

/// Signs after which a word is broken rather than between two letters.
const JOINTS: [char; 5] = ['-', '_', '/', '.', ':'];

/// The ways to set a word beside what is clear already, as `edge 2 of` a body with a long name.
pub(super) fn wordy(line: &Line, style: Style) -> Vec<Fold> {
    if line.width < WORDY * style.size { Vec::new() } else { folds(line, style) }
}

/// The ways to set a line on two lines and on three, broken at spaces, and where a word is long, in words
/// too; none where it is short.
pub(super) fn folds(line: &Line, style: Style) -> Vec<Fold> {
    if line.width < SHORT * style.size {
        return Vec::new();
    }
    let kept = narrow(&line.markup, line.width, style).into_iter();
    let mut all: Vec<Fold> = kept.map(|lines| Fold { lines, cut: Cut::AtSpaces }).collect();
    if let Some(broken) = broken(&line.markup) {
        let cut = narrow(&broken, line.width, style).into_iter();
        all.extend(cut.map(|lines| Fold { lines, cut: Cut::InWords }));
    }
    all
}

/// The way to set a sum and its result, as `d $= a - b = c$`, or a long product and its value, on two lines:
/// the last equals sign begins the second one. A letter stays with its value, and what words stand before it
/// are the first line. None where there is no such formula, or the line is short.
pub(super) fn chain(set: &Line, style: Style) -> Option<Fold> {
    let (sum, result) = set.markup.rsplit_once(" = ")?;
    let first = before_the_cut(set, style, sum)?;
    let (words, formula) = sum.rsplit_once('$')?;
    let set_apart = |markup: &str| line(markup, style).ok();
    // What has no equals sign before is one letter mostly, which is no line; with a script it is.
    let has_script =
        || set_apart(&format!("${formula}$")).is_some_and(|set| set.width >= SCRIPTED * style.size);
    let is_chain = formula.contains('=') || !formula.is_empty() && has_script();
    let lines = if is_chain {
        vec![first, set_apart(&format!("$= {result}"))?]
    } else {
        let words = Some(words.trim_end()).filter(|words| !words.is_empty() && !formula.is_empty())?;
        vec![set_apart(words)?, set_apart(&format!("${formula} = {result}"))?]
    };
    Some(Fold { lines, cut: Cut::InSum })
}

/// The way to set the difference of two points with long names, as `$b - a$`, on two lines: the minus sign
/// begins the second one. None where the text is another one, or short.
pub(super) fn difference(set: &Line, style: Style) -> Option<Fold> {
    let (to, from) = set.markup.split_once(" - ")?;
    let first = before_the_cut(set, style, to)?;
    // The empty group before the sign: it is one between two terms.
    let second = line(&format!("${{}} - {from}"), style).ok()?;
    Some(Fold { lines: vec![first, second], cut: Cut::InSum })
}

/// The ways to set a formula whose scripts have long names, with a few letters of those: each of `names` with
/// its script and what stands for that. None where it has no such script.
pub(super) fn in_names(set: &Line, style: Style, names: &[(String, String)]) -> Vec<Fold> {
    let mut markup = set.markup.clone();
    for (script, brief) in names {
        markup = markup.replace(&format!("_{{{script}"), &format!("_{{{brief}"));
    }
    let Some(whole) = line(&markup, style).ok().filter(|_| markup != set.markup) else { return Vec::new() };
    let mut ways = vec![vec![Arc::clone(&whole)]];
    ways.extend(chain(&whole, style).map(|fold| fold.lines));
    ways.into_iter().map(|lines| Fold { lines, cut: Cut::InNames }).collect()
}

/// The first line of a formula that ends the text and is cut in two; none where the cut is not in such a
/// formula, or the whole is short.
fn before_the_cut(set: &Line, style: Style, before: &str) -> Option<Arc<Line>> {
    let in_formula = before.matches('$').count() % 2 == 1;
    let ends = set.markup.ends_with('$') && !set.markup[before.len()..set.markup.len() - 1].contains('$');
    let long = set.width >= SHORT * style.size;
    if in_formula && ends && long { line(&format!("{before}$"), style).ok() } else { None }
}

/// A text on two lines and on three, each as narrow as it can be; `width` is that of the whole.
fn narrow(markup: &str, width: f64, style: Style) -> Vec<Vec<Arc<Line>>> {
    let mut all: Vec<Vec<Arc<Line>>> = Vec::new();
    let Ok(set) = paragraph(markup, style) else { return all };
    for most in 2..=MOST {
        // The least width that keeps to so many lines.
        let (mut narrow, mut wide) = (0.0, width);
        while wide - narrow > STEP * style.size {
            let middle = 0.5 * (narrow + wide);
            if set.extent(middle).0 <= most { wide = middle } else { narrow = middle }
        }
        let lines = set.lines(wide);
        if lines.len() == most {
            all.push(lines);
        }
    }
    all
}

/// A text in which each long word that is no formula is broken into lines, with a hyphen where that is
/// between two letters; none where no word is long.
fn broken(markup: &str) -> Option<String> {
    let mut text = markup.to_owned();
    for word in markup.split(' ') {
        if word.chars().count() > LONG && !word.contains(['$', '\\', '{', '|', '}']) {
            let (head, tail) = word.split_at(break_of(word));
            let hyphen =
                if head.ends_with(takes_hyphen) && tail.starts_with(takes_hyphen) { "-" } else { "" };
            text = text.replace(word, &format!("{head}{hyphen}\n{tail}"));
        }
    }
    (text != markup).then_some(text)
}

/// Whether a word that is broken beside this letter has a hyphen there, as in the scripts before those of
/// East Asia.
fn takes_hyphen(letter: char) -> bool {
    letter.is_alphabetic() && letter < '\u{2e80}'
}

/// Where a word is broken, in bytes: after the joint that is nearest to its middle, else in the middle.
fn break_of(word: &str) -> usize {
    let middle = word.chars().count().div_ceil(2);
    let places = word.char_indices().enumerate().skip(1);
    let joints = places.clone().filter(|&(_, (at, _))| word[..at].ends_with(JOINTS));
    let joint = joints.min_by_key(|(count, _)| count.abs_diff(middle));
    let place = joint.or_else(|| places.clone().find(|&(count, _)| count == middle));
    place.map_or(word.len(), |(_, (at, _))| at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::typeset::typeset;

    /// The lines of a text that is folded one way; none where that leaves it whole.
    fn lines_of(way: fn(&Line, Style) -> Option<Fold>, markup: &str) -> Option<Vec<String>> {
        let style = Style::regular(14.0);
        let fold = way(&typeset(markup, style).unwrap(), style)?;
        Some(fold.lines.iter().map(|line| line.markup.clone()).collect())
    }

    /// The widths of the lines of each way, of those that break in words or of those that do not.
    fn widths(markup: &str, in_words: bool) -> Vec<Vec<f64>> {
        let style = Style::regular(17.0);
        let folds = folds(&typeset(markup, style).unwrap(), style);
        let folds = folds.iter().filter(|fold| (fold.cut == Cut::InWords) == in_words);
        folds.map(|fold| fold.lines.iter().map(|line| line.width).collect()).collect()
    }

    #[test]
    fn a_long_name_is_folded_at_its_spaces_into_lines_of_like_width() {
        let whole = typeset("the left crate (dynamic)", Style::regular(17.0)).unwrap().width;
        let [two, three] = &widths("the left crate (dynamic)", false)[..] else { panic!("two ways") };
        assert!(two.len() == 2 && three.len() == 3);
        assert!(two.iter().all(|&w| w < 0.65 * whole) && three.iter().all(|&w| w < 0.5 * whole));
        assert_eq!(widths(r"ground plane $\ominus$ crate", false).len(), 2);
    }

    #[test]
    fn a_sum_is_folded_before_its_result() {
        let lines = |markup: &str| lines_of(chain, markup);
        let sum = lines("overlap $= 0.5 - (-3.2) = 3.7$").unwrap();
        assert_eq!(sum, ["overlap $= 0.5 - (-3.2)$", "$= 3.7$"]);
        assert_eq!(lines("$d = a + b = 12345$").unwrap(), ["$d = a + b$", "$= 12345$"]);
        let product = r"$r_{\text{crate}}|\omega_{\text{crate}}| = 3.28$";
        assert_eq!(lines(product).unwrap(), [r"$r_{\text{crate}}|\omega_{\text{crate}}|$", "$= 3.28$"]);
        assert_eq!(lines(r"$x_{\min} = -123.5$").unwrap(), [r"$x_{\min}$", "$= -123.5$"]);
        let letter = lines("depth $d = 0.141$").unwrap();
        assert_eq!(letter, ["depth", "$d = 0.141$"], "a letter stays with its value");
        for whole in [
            "overlap $= 3.712345678$",
            "$d = 123456789$",
            "$a = b + c + d + e$",
            "words = of a = kind, no formula",
        ] {
            assert_eq!(lines(whole), None, "{whole}");
        }
    }

    #[test]
    fn a_formula_may_have_a_few_letters_of_the_names_in_its_scripts() {
        let style = Style::regular(14.0);
        let names = [(r"\text{crate}".to_owned(), r"\text{cr…}".to_owned())];
        let product = typeset(r"$r_{\text{crate}}|\omega_{\text{crate}}| = 3.28$", style).unwrap();
        let [whole, in_two] = &in_names(&product, style, &names)[..] else { panic!("two ways") };
        assert_eq!(whole.lines[0].markup, r"$r_{\text{cr…}}|\omega_{\text{cr…}}| = 3.28$");
        assert_eq!(in_two.lines.len(), 2);
        let words = typeset("the crate", style).unwrap();
        assert!(in_names(&words, style, &names).is_empty(), "a name by itself stays whole");
    }

    #[test]
    fn a_difference_of_points_with_long_names_is_folded_before_its_sign() {
        let lines = |markup: &str| lines_of(difference, markup);
        let long = r"$p_{\text{crate}} - p_{\text{player}}$";
        assert_eq!(lines(long).unwrap(), [r"$p_{\text{crate}}$", r"${} - p_{\text{player}}$"]);
        for whole in ["$b_2 - a_0$", r"the way - to the crate", r"$a - b$ from $c$ to the crate"] {
            assert_eq!(lines(whole), None, "{whole}");
        }
    }

    #[test]
    fn a_name_that_is_short_or_one_word_has_one_line() {
        assert!(widths("a b c", false).is_empty() && widths("unbreakableletters", false).is_empty());
        assert_eq!(widths("unbreakable letters", false).len(), 1, "two words make two lines at most");
    }

    #[test]
    fn a_word_is_broken_at_a_joint_where_it_has_one() {
        assert_eq!(broken("Windrad-Rotorblatt").unwrap(), "Windrad-\nRotorblatt");
        assert_eq!(broken("crate_of_the_player").unwrap(), "crate_of_\nthe_player");
        assert_eq!(broken("unbreakableletters").unwrap(), "unbreakab-\nleletters");
        assert_eq!(broken("short-one"), None);
        assert_eq!(broken("{translation|wide}"), None, "the word of a role stays whole");
    }

    #[test]
    fn a_long_word_may_be_broken_and_a_formula_never() {
        let whole = typeset("unbreakableletters", Style::regular(17.0)).unwrap().width;
        let [two] = &widths("unbreakableletters", true)[..] else { panic!("one way") };
        assert!(two.len() == 2 && two.iter().all(|&w| w < 0.63 * whole));
        assert!(widths(r"$\text{unbreakableletters}$", true).is_empty());
        assert_eq!(widths(r"unbreakableletters $\ominus$ crate", true).len(), 2);
        assert!(widths("the left crate (dynamic)", true).is_empty());
    }
}
