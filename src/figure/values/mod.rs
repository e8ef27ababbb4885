//! Values of the answer in text: `{=time}`, `{=separation}`, `{=D.x}` … in captions, labels and notes.
//!
//! A value is written with at most three significant digits, and with no more than its bounds allow: digits in which
//! the two ends of the bounds, rounded, differ are not printed.

mod number;
mod table;

pub use number::{in_math, in_words, number, rounded};
pub use table::{Quantity, VALUES, Value};

use super::Context;

/// A `{=name}` that the query does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownValue {
    /// Byte offset of the `{=` in the text.
    pub offset: usize,
    /// The name as written.
    pub name: String,
    /// The names that this query has, in the order of the table.
    pub known: Vec<String>,
}

/// The text with every `{=name}` replaced by its value. Braces alone belong to LaTeX.
///
/// # Errors
///
/// [`UnknownValue`] where the query of this context has no such value, or the `{=` is not closed.
pub fn fill(text: &str, context: &Context) -> Result<String, UnknownValue> {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find("{=") {
        let (before, from) = rest.split_at(start);
        out.push_str(before);
        let offset = text.len() - from.len();
        let end = from.find('}').unwrap_or(from.len());
        let name = &from[2..end];
        let quantity = VALUES.iter().find(|v| v.name == name).and_then(|v| (v.of)(context));
        let Some(quantity) = quantity else {
            return Err(UnknownValue { offset, name: name.to_owned(), known: known(context) });
        };
        let number = rounded(quantity.lo, quantity.hi);
        out.push_str(&if inside_formula(&out) { in_math(&number) } else { in_words(&number) });
        rest = from.get(end + 1..).unwrap_or("");
    }
    out.push_str(rest);
    Ok(out)
}

/// The names of the values that this query has.
#[must_use]
pub fn known(context: &Context) -> Vec<String> {
    VALUES.iter().filter(|v| (v.of)(context).is_some()).map(|v| v.name.to_owned()).collect()
}

/// Whether the end of `text` stands between two `$`.
fn inside_formula(text: &str) -> bool {
    let mut inside = false;
    let mut escaped = false;
    for c in text.chars() {
        inside ^= c == '$' && !escaped;
        escaped = c == '\\' && !escaped;
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_escaped_dollar_opens_no_formula() {
        assert!(inside_formula("costs $x = "));
        assert!(!inside_formula(r"costs 5 \$ and "));
        assert!(!inside_formula("$x$ and "));
    }
}
