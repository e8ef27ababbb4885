//! Formulas that differ in their digits alone: one layout serves them all.
//!
//! Every digit of the face of formulas is as wide as any other, and of one that stands on the baseline of the
//! whole formula nothing depends on how high or deep it is. So `d = 2.41` is `d = 0.00` with other glyphs: as
//! a figure moves its numbers change in every frame, and what the formula engine makes of them does not.

use super::face::Loaded;
use super::line::{Face, Glyph, PlacedGlyph};

/// Commands beside which a digit is as free as without: signs, which take nothing.
const SIGNS: [&str; 8] = ["approx", "cdot", "ge", "le", "omega", "ominus", "theta", "times"];

/// A formula with a zero for each digit that is free, and these digits in their order; `None` where none is.
pub(super) fn apart(latex: &str) -> Option<(String, Vec<char>)> {
    let (mut pattern, mut digits) = (String::with_capacity(latex.len()), Vec::new());
    // What comes next is a script.
    let mut is_script = false;
    let (mut depth, mut rest) = (0_usize, latex);
    while let Some(c) = rest.chars().next() {
        let mut len = c.len_utf8();
        match c {
            '\\' => {
                let name = &rest[1..];
                let end = name.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(name.len());
                let is_space = end == 0 && name.starts_with([',', ';', '|']);
                if !is_space && !SIGNS.contains(&&name[..end]) {
                    return None;
                }
                len += end.max(1);
            }
            '{' => depth += 1,
            '}' => depth = depth.checked_sub(1)?,
            '0'..='9' if depth == 0 && !is_script => {
                len = rest.find(|c: char| c != '.' && !c.is_ascii_digit()).unwrap_or(rest.len());
                let has_script = rest[len..].trim_start().starts_with(['^', '_', '\'']);
                for digit in rest[..len].chars() {
                    let is_free = digit != '.' && !has_script;
                    digits.extend(is_free.then_some(digit));
                    pattern.push(if is_free { '0' } else { digit });
                }
                rest = &rest[len..];
                continue;
            }
            _ => {}
        }
        is_script = matches!(c, '^' | '_') || is_script && c == ' ';
        pattern.push_str(&rest[..len]);
        rest = &rest[len..];
    }
    (!digits.is_empty()).then_some((pattern, digits))
}

/// Gives the glyphs of a formula with zeros, as [`apart`] made it, set at a size, its own digits; `None`
/// where its zeros on the baseline are not these.
pub(super) fn put(digits: &[char], glyphs: &mut [PlacedGlyph], size: f64) -> Option<()> {
    let face = Loaded::of(Face::Math)?;
    let of = |digit: char| Some(Glyph { face: Face::Math, id: face.face().glyph_index(digit)?.0 });
    let zero = of('0')?;
    let mut next = digits.iter();
    for placed in glyphs {
        if placed.glyph == zero && placed.y == 0.0 && placed.size == size {
            placed.glyph = of(*next.next()?)?;
        }
    }
    next.next().is_none().then_some(())
}
