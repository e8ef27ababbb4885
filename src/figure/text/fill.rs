//! Fills in the values of a text: `{=time}`, `{=separation}`, `{=D.x}` … in captions, labels and notes.

use std::ops::Range;

use crate::figure::context::Context;
use crate::figure::fault::Problem;
use crate::scene::Fault;
use crate::typeset::ends_in_formula;

use super::number::{in_math, in_words, rounded};
use super::values::{VALUES, another_answer_has};

/// What stands for a value that this answer lacks and another one has, in words and in formulas.
const LACKING: [&str; 2] = ["–", r"\text{–}"];

/// The text with every `{=name}` replaced by its value, and the names of those that this answer lacks: a
/// dash stands for them. Braces alone belong to LaTeX.
///
/// # Errors
/// Where the query of this context has no such value, or the `{=` is not closed; `at` is the text's place in
/// the scene.
pub(crate) fn fill(
    text: &str,
    context: &Context,
    at: &Range<usize>,
) -> Result<(String, Vec<String>), Problem> {
    let (mut out, mut lacking) = (String::with_capacity(text.len()), Vec::new());
    let mut rest = text;
    while let Some(start) = rest.find("{=") {
        let (before, from) = rest.split_at(start);
        out.push_str(before);
        let end = from.find('}').unwrap_or(from.len());
        let name = &from[2..end];
        let quantity = VALUES.iter().find(|v| v.name == name).and_then(|v| (v.of)(context));
        rest = from.get(end + 1..).unwrap_or("");
        let [in_text, in_formula] = LACKING;
        let Some(quantity) = quantity else {
            if another_answer_has(name, context) {
                out.push_str(if ends_in_formula(&out) { in_formula } else { in_text });
                lacking.push(name.to_owned());
                continue;
            }
            let fault = Fault::UnknownWord { what: "value", got: name.to_owned(), known: known(context) };
            return Err(Problem::new(fault.into(), at.clone()));
        };
        let number = rounded(quantity.lo, quantity.hi);
        out.push_str(&if ends_in_formula(&out) { in_math(&number) } else { in_words(&number) });
    }
    out.push_str(rest);
    Ok((out, lacking))
}

/// The names of the values that this query has, in the order of the table.
fn known(context: &Context) -> Vec<String> {
    VALUES.iter().filter(|v| (v.of)(context).is_some()).map(|v| v.name.to_owned()).collect()
}
