//! Markup as plain text: formulas as they would be written in running text.

/// LaTeX commands and what they are in plain text.
const COMMANDS: [(&str, &str); 40] = [
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
    ("min", "min"),
    ("max", "max"),
    ("lVert", "‖"),
    ("rVert", "‖"),
    ("sum", "∑"),
    ("degree", "°"),
];

/// Markup without its dollars, formulas in plain text: `$B \ominus A$` becomes `B ⊖ A`.
#[must_use]
pub(crate) fn plain(markup: &str) -> String {
    let mut out = String::with_capacity(markup.len());
    let mut formula = String::new();
    let mut inside = false;
    let mut letters = markup.chars().peekable();
    while let Some(c) = letters.next() {
        match c {
            '\\' if letters.peek() == Some(&'$') => {
                letters.next();
                if inside { formula.push('$') } else { out.push('$') }
            }
            '$' => {
                if inside {
                    out.push_str(squeezed(&read(&formula)).trim());
                    formula.clear();
                }
                inside = !inside;
            }
            c if inside => formula.push(c),
            c => out.push(c),
        }
    }
    out
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
            '~' => out.push(' '),
            c => out.push(c),
        }
    }
    out
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
            let (over, rest) = group(rest);
            let (under, rest) = group(rest);
            out.push_str(&bracketed(&read(over)));
            out.push('/');
            out.push_str(&bracketed(&read(under)));
            rest
        }
        "sqrt" => {
            let (under, rest) = group(rest);
            out.push('√');
            out.push_str(&bracketed(&read(under)));
            rest
        }
        "phantom" => group(rest).1,
        "left" | "right" | "quad" | "qquad" | "displaystyle" => rest,
        name => {
            out.push_str(COMMANDS.iter().find(|(known, _)| *known == name).map_or("", |(_, plain)| plain));
            rest
        }
    }
}

/// The content of the `{…}` at the start, and what follows it.
fn group(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    let mut depth = 0_usize;
    for (i, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 1 => return (&text[1..i], &text[i + 1..]),
            '}' => depth = depth.saturating_sub(1),
            c if depth == 0 => return text.split_at(c.len_utf8()),
            _ => {}
        }
    }
    (text, "")
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
    }

    #[test]
    fn malformed_markup_is_read_without_a_panic() {
        for text in [r"$\frac{a", r"$\frac", "$", r"\", r"$\", "$}$", r"$\sqrt$", "$é\\é$"] {
            let _ = plain(text);
        }
    }
}
