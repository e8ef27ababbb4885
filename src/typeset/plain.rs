//! Markup as plain text: formulas as they would be written in running text.

use super::inner_words::{group, unescaped};
use super::markup::{Piece, characters, pieces};

/// LaTeX commands and what they are in plain text, where that is not the sign that the formula engine knows.
const COMMANDS: [(&str, &str); 42] = [
    ("ominus", "⊖"),
    ("oplus", "⊕"),
    ("cdot", "·"),
    ("times", "×"),
    ("theta", "θ"),
    ("omega", "ω"),
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("Delta", "Δ"),
    ("epsilon", "ε"),
    ("varepsilon", "ε"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("phi", "φ"),
    ("varphi", "φ"),
    ("psi", "ψ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("pi", "π"),
    ("le", "≤"),
    ("leq", "≤"),
    ("ge", "≥"),
    ("geq", "≥"),
    ("ne", "≠"),
    ("approx", "≈"),
    ("to", "→"),
    ("in", "∈"),
    ("pm", "±"),
    ("infty", "∞"),
    ("ldots", "…"),
    ("circ", "°"),
    ("cos", "cos "),
    ("sin", "sin "),
    ("min", "min"),
    ("max", "max"),
    ("lVert", "‖"),
    ("rVert", "‖"),
    ("sum", "∑"),
    ("degree", "°"),
];

/// Functions that are written by their names, with the space that parts them from what they are of.
const FUNCTIONS: [&str; 27] = [
    "tan ", "cot ", "sec ", "csc ", "arcsin ", "arccos ", "arctan ", "sinh ", "cosh ", "tanh ", "coth ",
    "log ", "ln ", "lg ", "exp ", "lim", "limsup", "liminf", "sup", "inf", "det ", "dim ", "ker ", "deg ",
    "gcd ", "lcm ", "Pr ",
];

/// Commands whose first argument, in braces, says how something looks and is not read.
const MEASURES: [&str; 8] =
    ["hspace", "begin", "end", "textcolor", "colorbox", "label", "vphantom", "hphantom"];

/// Signs that are raised like a power and read at the foot of what they follow.
const RAISED: [&str; 3] = ["prime", "circ", "degree"];

/// Markup without its dollars and roles, formulas in plain text: `$B \ominus A$` becomes `B ⊖ A`. What is no
/// markup, as a formula without an end, is read as it stands.
pub(crate) fn plain(markup: &str) -> String {
    let words = |text| characters(0, text).map(|(_, c)| c).collect::<String>();
    let Ok(pieces) = pieces(markup) else { return words(markup) };
    let read = pieces.into_iter().map(|piece| match piece {
        Piece::Role(..) | Piece::Plain => String::new(),
        Piece::Words(_, text) => words(text),
        Piece::Formula(_, latex) => formula_in_words(latex),
    });
    read.collect()
}

/// What stands between two dollar signs, in plain text with single spaces.
pub(super) fn formula_in_words(latex: &str) -> String {
    squeezed(&read(latex))
}

/// A formula in plain text.
fn read(formula: &str) -> String {
    let mut out = String::new();
    let mut rest = formula;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        match c {
            '\\' => rest = command(rest, &mut out),
            '{' | '}' => {}
            '\'' => out.push('′'),
            '-' => out.push('−'),
            '~' | '&' => out.push(' '),
            '^' if is_raised(rest) => {}
            c => out.push(c),
        }
    }
    out
}

/// Whether a power is a sign that is raised anyway, as in `p^\prime` or `30^\circ`.
fn is_raised(power: &str) -> bool {
    let power = power.trim_start_matches([' ', '{']);
    let Some(name) = power.strip_prefix('\\') else { return false };
    let end = name.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(name.len());
    RAISED.contains(&&name[..end])
}

/// Reads what follows a backslash and returns what is left.
fn command<'t>(text: &'t str, out: &mut String) -> &'t str {
    let end = text.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    match name {
        "" => match rest.chars().next() {
            Some('|') => {
                out.push('‖');
                &rest[1..]
            }
            Some(c) => {
                let spaces = [',', ';', ':', '!', ' ', '\\'];
                out.push(if spaces.contains(&c) { ' ' } else { c });
                &rest[c.len_utf8()..]
            }
            None => rest,
        },
        "frac" | "tfrac" | "dfrac" => {
            let (over, rest) = argument(rest);
            let (under, rest) = argument(rest);
            out.push_str(&bracketed(&read(over)));
            out.push('/');
            out.push_str(&bracketed(&read(under)));
            rest
        }
        "sqrt" => {
            let (index, rest) = index(rest);
            let (under, rest) = argument(rest);
            out.push_str(&read(index));
            out.push('√');
            out.push_str(&bracketed(&read(under)));
            rest
        }
        "not" => {
            let (sign, rest) = denied(rest);
            out.push_str(&sign);
            rest
        }
        "phantom" => argument(rest).1,
        name if MEASURES.contains(&name) => argument(rest).1,
        "text" | "mbox" => {
            let (words, rest) = argument(rest);
            out.extend(unescaped(words).map(|(_, c)| c));
            rest
        }
        "left" | "right" | "quad" | "qquad" | "displaystyle" => rest,
        name => {
            out.push_str(command_in_words(name));
            rest
        }
    }
}

/// What a command of a sign or a letter is in plain text; empty for any other.
pub(crate) fn command_in_words(name: &str) -> &'static str {
    let known = COMMANDS.iter().find(|(known, _)| *known == name).map(|(_, plain)| *plain);
    known
        .or_else(|| FUNCTIONS.into_iter().find(|function| function.trim_end() == name))
        .or_else(|| sign(name))
        .unwrap_or("")
}

/// The sign of a command as the formula engine has it; `None` where that stands for a construction.
fn sign(name: &str) -> Option<&'static str> {
    let alone = format!("\\{name}");
    let entry = latex_rust::symbols().iter().find(|entry| entry.latex == alone)?;
    (entry.glyph.chars().count() == 1).then_some(entry.glyph)
}

/// A sign that `\not` strikes out, and what comes after: `≠` for the equals sign.
fn denied(text: &str) -> (String, &str) {
    let text = text.trim_start();
    let mut read = String::new();
    let rest = if let Some(name) = text.strip_prefix('\\') {
        command(name, &mut read)
    } else {
        let (sign, rest) = argument(text);
        read.push_str(sign);
        rest
    };
    let struck = if read == "=" { "≠".to_owned() } else { format!("{read}\u{338}") };
    (struck, rest)
}

/// What stands in the square brackets that may follow a root, and what comes after; empty where none do.
fn index(text: &str) -> (&str, &str) {
    text.trim_start().strip_prefix('[').and_then(|rest| rest.split_once(']')).unwrap_or(("", text))
}

/// What a command is applied to: the content of the `{…}` that follows, or the sign; and what comes after.
fn argument(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    let sign = || text.split_at(text.chars().next().map_or(0, char::len_utf8));
    group(text).unwrap_or_else(sign)
}

/// A term in brackets, unless it is one word.
fn bracketed(text: &str) -> String {
    if text.chars().all(char::is_alphanumeric) { text.to_owned() } else { format!("({text})") }
}

/// A text with single spaces.
fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_formulas_of_the_figures_read_well() {
        assert_eq!(plain(r"$v = v_A - v_B$"), "v = v_A − v_B");
        assert_eq!(plain(r"the distance $\|D\| - r_A = 1.5$"), "the distance ‖D‖ − r_A = 1.5");
        assert_eq!(plain(r"$\frac{d}{v}$ costs 5 \$"), "d/v costs 5 $");
        assert_eq!(plain(r"$A'$ at $t = 0.5$"), "A′ at t = 0.5");
        assert_eq!(
            plain(r"$t \ge \frac{d}{v \cdot n + r_A|\omega_A|} = 0.308$"),
            "t ≥ d/(v · n + r_A|ω_A|) = 0.308"
        );
        assert_eq!(plain(r"$1.09 \times 10^{-9}$"), "1.09 × 10^−9");
        assert_eq!(plain(r"$x_{\min}$"), "x_min");
        assert_eq!(plain(r"$v_{\text{left\-crate\_1}} \ne 0$"), "v_left-crate_1 ≠ 0");
        assert_eq!(plain("costs $5"), "costs $5");
        assert_eq!(plain(r"{a|the red box} and {difference|$B \ominus A$}"), "the red box and B ⊖ A");
    }

    #[test]
    fn every_sign_that_can_be_set_is_read() {
        let style = super::super::Style::regular(16.0);
        let mut read = 0;
        let functions = FUNCTIONS.iter().map(|name| name.trim_end().to_owned());
        let alone = |latex: &str| latex.strip_prefix('\\').map(str::to_owned);
        let signs = latex_rust::symbols().iter().filter_map(|entry| alone(entry.latex));
        for name in functions.chain(signs).filter(|name| name.chars().all(|c| c.is_ascii_alphabetic())) {
            let markup = format!("$a \\{name} b$");
            if super::super::typeset(&markup, style).is_ok() {
                let plain = plain(&markup);
                let is_read = name == "backslash" || !plain.contains('\\');
                assert!(plain.len() > "a b".len() && is_read, "{markup}: {plain}");
                read += 1;
            }
        }
        assert!(read > 300, "{read} signs");
    }

    #[test]
    fn what_is_raised_or_struck_out_keeps_its_meaning() {
        assert_eq!(plain(r"$p^\prime = p^{\prime}$"), "p′ = p′");
        assert_eq!(plain(r"$30^\circ$, $30^{\circ}$, $x^2$"), "30°, 30°, x^2");
        assert_eq!(plain(r"$a \not= b$, $a \not\in B$"), "a ≠ b, a ∈\u{338} B");
        assert_eq!(plain(r"$\sqrt[3]{8}$, $\sqrt{n + 1}$"), "3√8, √(n + 1)");
        assert_eq!(plain(r"$a\hspace{2em}b \tan \theta$"), "ab tan θ");
    }

    #[test]
    fn malformed_markup_is_read_without_a_panic() {
        for text in [r"$\frac{a", r"$\frac", "$", r"\", r"$\", "$}$", r"$\sqrt$", "$é\\é$"] {
            let _ = plain(text);
        }
    }
}
