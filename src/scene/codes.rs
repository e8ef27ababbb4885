//! The stable codes of everything that can be wrong with a scene.

/// A code of an error and what it means, for `tracefig list errors`.
#[derive(Clone, Copy, Debug)]
pub struct ErrorCode {
    /// The stable word that programs see.
    pub code: &'static str,
    /// What it means, in one line.
    pub about: &'static str,
}

const fn row(code: &'static str, about: &'static str) -> ErrorCode {
    ErrorCode { code, about }
}

/// Every code that reading a scene can give, besides those of shapes
/// ([`SHAPE_ERRORS`](crate::geometry::shape::SHAPE_ERRORS)), some of which are here too.
pub static ERRORS: &[ErrorCode] = &[
    row("unreadable-file", "the file is missing, is no file, or may not be read"),
    row("not-utf8", "the file is not UTF-8 text"),
    row("empty-file", "the file holds nothing but blanks and comments"),
    row("syntax", "the text is not TOML or not JSON"),
    row("duplicate-key", "a key stands twice in one table"),
    row("over-limit", "a file, list, text or number is larger than tracefig takes"),
    row("unknown-key", "a key that means nothing in its table"),
    row(
        "unknown-word",
        "a word that is none of those known there: a kind, algorithm, layer, space, theme, …",
    ),
    row("missing-key", "a table lacks a key that it must have"),
    row("wrong-type", "a value of another type than its key holds"),
    row("not-finite", "a number that is infinite or not a number"),
    row("out-of-range", "a number outside of what its key allows, as a time outside [0, 1]"),
    row("conflict", "two keys that exclude each other, or a key that does not apply there"),
    row("unknown-body", "the query or a panel names a shape that the scene does not have"),
    row("wrong-count", "the query is of too many or too few shapes"),
    row("turning-body", "a linear sweep of a shape that turns"),
    row("fixed-angle", "an angle or angular velocity on a kind of shape that does not turn"),
    row("unsuited-algorithm", "an algorithm that does not answer this query of these shapes"),
    row("unsuited-shape", "a shape that the query cannot be asked of, as an outline in a separation"),
    row("no-panels", "a scene without panels is to be drawn"),
    row("no-such-moment", "a panel shows a hit or a step that the answer does not have"),
    row("unsuited-layer", "a layer that shows another space than its panel"),
    row("unfed-layer", "a layer that needs what this query does not give"),
    row("bad-markup", "a text whose formula can't be typeset"),
    row("caption-dropped", "warning: the caption has more lines than the page has room for"),
    row("label-clash", "warning: a label found no free place"),
    row("internal", "a bug of tracefig"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_listed_once() {
        for (i, row) in ERRORS.iter().enumerate() {
            assert!(ERRORS[..i].iter().all(|other| other.code != row.code), "{} stands twice", row.code);
        }
    }
}
