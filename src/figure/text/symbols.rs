//! The symbols of a formula: its letters, each with its script and primes, as they read in running text.

use crate::typeset::{command_in_words, group};

use super::plain::plain;

/// A symbol in plain text, as `v_A`, `A′` or `θ`.
pub(crate) type Symbol = String;

/// Commands that put something on top of a symbol, which is another one then.
const ACCENTS: [&str; 6] = ["hat", "vec", "dot", "bar", "tilde", "mathbf"];
/// Commands whose braces hold words.
const WORDS: [&str; 3] = ["text", "mbox", "operatorname"];
/// The sign of the difference of two shapes, whose name is one symbol.
const DIFFERENCE: &str = r"\ominus";

/// The symbols of a formula, in order. `B \ominus A` is one symbol and neither of the two bodies.
pub(crate) fn symbols(latex: &str) -> Vec<Symbol> {
    let mut found: Vec<(usize, Symbol)> = Vec::new();
    let mut at = 0;
    let mut joined = false;
    while at < latex.len() {
        let rest = &latex[at..];
        if let Some(after) = rest.strip_prefix(DIFFERENCE) {
            joined = true;
            at = latex.len() - after.len();
            continue;
        }
        let (read, after) = step(rest);
        if let Some(symbol) = read {
            match found.last_mut() {
                Some((_, left)) if joined => *left = format!("{left} ⊖ {symbol}"),
                _ => found.push((at, symbol)),
            }
            joined = false;
        }
        at = latex.len() - after.len();
    }
    found.into_iter().map(|(_, symbol)| symbol).collect()
}

/// Reads a symbol, or a sign that is none, at the start of a formula; and what comes after.
fn step(latex: &str) -> (Option<Symbol>, &str) {
    let mut signs = latex.chars();
    let Some(first) = signs.next() else { return (None, latex) };
    let rest = signs.as_str();
    match first {
        '\\' => command(rest),
        // A power is no part of a symbol; its letters are symbols of their own.
        '_' => (None, argument(rest).1),
        c if c.is_alphabetic() => scripted(c.to_string(), rest),
        _ => (None, rest),
    }
}

/// Reads what a backslash begins.
fn command(rest: &str) -> (Option<Symbol>, &str) {
    let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
    let (name, after) = rest.split_at(end);
    if name.is_empty() {
        let mut signs = after.chars();
        signs.next();
        return (None, signs.as_str());
    }
    if WORDS.contains(&name) {
        return (None, argument(after).1);
    }
    if ACCENTS.contains(&name) {
        let (under, after) = argument(after);
        let symbol = plain(&format!("${under}$"));
        let is_one = symbol.chars().next().is_some_and(char::is_alphabetic);
        return if is_one { scripted(symbol, after) } else { (None, after) };
    }
    let word = command_in_words(name);
    let mut letters = word.chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) if letter.is_alphabetic() => scripted(letter.to_string(), after),
        _ => (None, after),
    }
}

/// A symbol with the primes and the script that follow it; and what comes after.
fn scripted(mut symbol: String, mut rest: &str) -> (Option<Symbol>, &str) {
    loop {
        let trimmed = rest.trim_start();
        if let Some(after) = trimmed.strip_prefix('\'').or_else(|| trimmed.strip_prefix(r"^\prime")) {
            symbol.push('′');
            rest = after;
        } else if let Some(after) = trimmed.strip_prefix('_') {
            let (script, after) = argument(after);
            symbol.push('_');
            symbol.push_str(&plain(&format!("${script}$")));
            rest = after;
        } else {
            return (Some(symbol), rest);
        }
    }
}

/// What a script or a command is applied to: the content of `{…}`, a command, or the next sign; and what
/// comes after.
fn argument(latex: &str) -> (&str, &str) {
    let latex = latex.trim_start();
    if let Some(found) = group(latex) {
        return found;
    }
    let letters = latex
        .strip_prefix('\\')
        .map_or(0, |rest| rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len()));
    let first = latex.chars().next().map_or(0, char::len_utf8);
    latex.split_at(first + letters)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_symbols_with_their_scripts_and_primes() {
        let cases: [(&str, &[&str]); 14] = [
            ("A", &["A"]),
            ("A'", &["A′"]),
            (r"d\,n", &["d", "n"]),
            ("v_A - v_B", &["v_A", "v_B"]),
            (r"h_{x}", &["h_x"]),
            (r"x_{\min}", &["x_min"]),
            (r"B \ominus A", &["B ⊖ A"]),
            (r"\|B \ominus A\| + C", &["B ⊖ A", "C"]),
            (r"\frac{d}{v \cdot n + r_A|\omega_A|}", &["d", "v", "n", "r_A", "ω_A"]),
            (r"v_{\text{bullet},1} = \text{speed}", &["v_bullet,1"]),
            (r"\hat{n} \ge \min(a^2, 3)", &["n", "a"]),
            (r"p^\prime", &["p′"]),
            (r"1.5 \times 10^{-3}°", &[]),
            (r"\theta\,r = 60", &["θ", "r"]),
        ];
        for (latex, expected) in cases {
            assert_eq!(symbols(latex), expected, "{latex}");
        }
    }

    #[test]
    fn malformed_formulas_are_read_to_their_end() {
        for latex in ["_", r"\", r"\hat", "A_", "A_{", r"\ominus", r"A\ominus", "é_é", r"\text"] {
            let _ = symbols(latex);
        }
    }
}
