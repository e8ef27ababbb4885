//! The face of formulas has all that their language can say, in the measures of the face that it is cut from.

use latex_rust::{Dim, MathBox, MathFont, MathStyle, layout, parse, symbols};

use super::face::Loaded;
use super::line::Face;

/// Commands that put letters into another alphabet.
const ALPHABETS: [&str; 11] = [
    "mathrm",
    "mathbf",
    "mathit",
    "mathsf",
    "mathtt",
    "mathbb",
    "mathcal",
    "mathscr",
    "mathfrak",
    "boldsymbol",
    "pmb",
];

/// Letters and digits that another alphabet may have.
const LETTERS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789\
                       ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρςστυφχψωϵϑϰϕϱϖϴ∇∂";

/// What stands above or below something, or on both sides of it, as large as it is.
const GROWING: [&str; 27] = [
    r"\widehat{xyz}",
    r"\widetilde{xyz}",
    r"\overline{xyz}",
    r"\underline{xyz}",
    r"\overrightarrow{xyz}",
    r"\overleftarrow{xyz}",
    r"\overleftrightarrow{xyz}",
    r"\underrightarrow{xyz}",
    r"\underleftarrow{xyz}",
    r"\overbrace{x + y + z}^{n}",
    r"\underbrace{x + y + z}_{n}",
    r"\xrightarrow{abc}",
    r"\xleftarrow{abc}",
    r"\acute{x}",
    r"\grave{x}",
    r"\dddot{x}",
    r"\ddddot{x}",
    r"\mathring{x}",
    r"\not=",
    r"\not\in",
    r"\sqrt{\frac{a}{b}}",
    r"\sqrt[3]{x}",
    r"\binom{n}{k}",
    r"\displaystyle\sum_{i=1}^{n} x_i",
    r"\displaystyle\int_0^1 f",
    r"\begin{cases} a \\ b \end{cases}",
    r"\begin{bmatrix} a & b \\ c & d \end{bmatrix}",
];

/// Fences, of which each may be larger than the letters between.
const FENCES: [[&str; 2]; 9] = [
    ["(", ")"],
    ["[", "]"],
    [r"\{", r"\}"],
    ["|", "|"],
    [r"\|", r"\|"],
    [r"\langle", r"\rangle"],
    [r"\lfloor", r"\rfloor"],
    [r"\lceil", r"\rceil"],
    ["/", r"\backslash"],
];

/// Formulas that between them say all that the language can.
fn formulas() -> Vec<String> {
    let named = symbols().iter().map(|symbol| symbol.latex.replace("{}", "{x}"));
    let typed = (' '..='~').chain('\u{a0}'..='\u{ff}').map(|c| c.to_string());
    let styled = ALPHABETS.iter().flat_map(|name| LETTERS.chars().map(move |c| format!("\\{name}{{{c}}}")));
    let fenced = FENCES.iter().flat_map(|[open, close]| {
        let inside = ["x", r"\frac{a}{b}", r"\frac{\frac{a}{b}}{\frac{c}{d}}"].map(str::to_owned);
        let tall = [3, 9].map(|rows| format!(r"\begin{{matrix}}{}\end{{matrix}}", r"a \\ ".repeat(rows)));
        inside.into_iter().chain(tall).map(move |inside| format!("\\left{open} {inside} \\right{close}"))
    });
    let plain: Vec<String> =
        named.chain(typed).chain(styled).chain(fenced).chain(GROWING.map(str::to_owned)).collect();
    let scripts = plain.iter().map(|formula| format!("a_{{{formula}}}^{{b^{{{formula}}}}}"));
    plain.iter().cloned().chain(scripts).collect()
}

/// A formula in a face; `None` where the face or the language can't set it.
fn set(formula: &str, font: &MathFont) -> Option<MathBox> {
    layout(&parse(formula).ok()?, font, MathStyle::Text).ok()
}

#[test]
fn words_find_the_signs_that_their_own_face_lacks() {
    let whole = MathFont::stix_two_math().unwrap();
    let ours = Loaded::of(Face::Math).and_then(Loaded::math).unwrap();
    let lent = [
        '\u{1ea0}'..='\u{1ef9}',
        '\u{2000}'..='\u{209f}',
        '\u{2190}'..='\u{22ff}',
        '\u{25a0}'..='\u{25ff}',
        '\u{27c0}'..='\u{27ef}',
    ];
    let has = |font: &MathFont, c: char| font.face().glyph_index(c).is_some();
    let missing: Vec<char> =
        lent.into_iter().flatten().filter(|&c| has(&whole, c) && !has(ours, c)).collect();
    assert_eq!(missing, [' '; 0]);
    assert!(has(ours, '\u{202f}') && has(ours, '⟂'));
}

#[test]
fn the_face_sets_all_that_the_language_can_say() {
    let whole = MathFont::stix_two_math().unwrap();
    let ours = Loaded::of(Face::Math).and_then(Loaded::math).unwrap();
    let measures = |set: &MathBox| [&set.width, &set.height, &set.depth].map(Dim::as_ratio);
    let (mut count, mut wrong) = (0, Vec::new());
    for formula in formulas() {
        let Some(wanted) = set(&formula, &whole) else { continue };
        count += 1;
        // Scripts of other alphabets are scaled and not drawn apart: theirs are other measures.
        let is_scaled =
            formula.starts_with("a_") && ALPHABETS.iter().chain(&["Bbbk"]).any(|name| formula.contains(name));
        match set(&formula, ours) {
            Some(found) if is_scaled || measures(&found) == measures(&wanted) => {}
            Some(_) => wrong.push(format!("{formula}: other measures")),
            None => wrong.push(format!("{formula}: can't be set")),
        }
    }
    assert!(count > 4000, "{count} formulas");
    assert!(wrong.is_empty(), "{} of {count}: {:#?}", wrong.len(), &wrong[..wrong.len().min(40)]);
}
