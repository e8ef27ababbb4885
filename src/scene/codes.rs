//! The stable codes of everything that can be wrong with a scene or with the figure that it asks for: the one
//! list.

/// A code of an error and what it means, for `tracefig list errors`.
#[derive(Clone, Copy, Debug)]
pub struct ErrorCode {
    /// The stable word that programs see.
    pub code: &'static str,
    /// What it means, in one line.
    pub about: &'static str,
}

/// Names each code once: as a constant, which a fault gives, and as a row of [`ERRORS`].
macro_rules! codes {
    ($($name:ident = $code:literal, $about:literal;)+) => {
        $(pub(crate) const $name: ErrorCode = ErrorCode { code: $code, about: $about };)+

        /// Every code that reading or drawing a scene can give, besides those of shapes
        /// ([`SHAPE_ERRORS`](crate::geometry::shape::SHAPE_ERRORS)), some of which are here too.
        pub static ERRORS: &[ErrorCode] = &[$($name),+];
    };
}

codes! {
    UNREADABLE = "unreadable-file", "the file is missing, is no file, or may not be read";
    NOT_UTF8 = "not-utf8", "the file is not UTF-8 text";
    EMPTY = "empty-file", "the file holds nothing but blanks and comments";
    SYNTAX = "syntax", "the text is not TOML or not JSON";
    DUPLICATE_KEY = "duplicate-key", "a key stands twice in one table";
    OVER_LIMIT = "over-limit", "a file, list, text or number is larger than tracefig takes";
    UNKNOWN_KEY = "unknown-key", "a key that means nothing in its table";
    UNKNOWN_WORD = "unknown-word",
        "a word that is none of those known there: a kind, algorithm, layer, space, theme, …";
    MISSING_KEY = "missing-key", "a table lacks a key that it must have";
    WRONG_TYPE = "wrong-type", "a value of another type than its key holds";
    NOT_FINITE = "not-finite", "a number that is infinite or not a number";
    OUT_OF_RANGE = "out-of-range", "a number outside of what its key allows, as a time outside [0, 1]";
    CONFLICT = "conflict", "two keys that exclude each other, or a key that does not apply there";
    UNKNOWN_BODY = "unknown-body", "the query or a panel names a shape that the scene does not have";
    WRONG_COUNT = "wrong-count", "the query is of too many or too few shapes";
    TURNING_BODY = "turning-body", "a linear sweep of a shape that turns";
    FIXED_ANGLE = "fixed-angle", "an angle or angular velocity on a kind of shape that does not turn";
    UNSUITED_ALGORITHM = "unsuited-algorithm",
        "an algorithm that does not answer this query of these shapes";
    UNSUITED_SHAPE = "unsuited-shape",
        "a shape that the query cannot be asked of, as an outline in a separation";
    NO_SUCH_MOMENT = "no-such-moment", "a panel shows a hit or a step that no answer to the query has";
    NOTHING_PLAYS = "nothing-plays", "note: a figure that was to play, and no panel of it does";
    NO_STEP_LEFT = "no-step-left", "note: `[[steps]]` has words for more steps than the figure has";
    NOT_HELD = "not-held", "note: `[live] drag` names what no layer of the figure draws";
    NO_LAYERS = "no-layers", "warning: a panel whose list of layers is empty";
    EMPTY_VIEW = "empty-view",
        "warning: a panel's `view` or `inset` holds nothing of what the panel draws";
    UNSUITED_LAYER = "unsuited-layer", "a layer that shows another space than its panel";
    SHARED_CHART = "shared-chart", "warning: a chart whose panel has other layers too";
    UNFED_LAYER = "unfed-layer", "a layer that needs what this query does not give";
    NOT_IN_ANSWER = "not-in-answer",
        "note: a layer or a moment that this answer lacks, as the contact where it is a miss";
    BAD_THEME = "bad-theme", "a theme file that can't be read, or is no theme";
    BAD_MARKUP = "bad-markup", "a text whose formula can't be typeset";
    BAD_NAME = "bad-name",
        "note: a name has a letter that the fonts lack, so that the picture has another one";
    CAPTION_DROPPED = "caption-dropped", "warning: a text has more lines than the page has room for";
    OUT_OF_VIEW = "out-of-view",
        "note: a body that the query is not about is far from those it is about, or a layer beside the view";
    OFF_PAGE = "off-page", "a panel shows places so far outside that no page reaches there";
    LABEL_CLASH = "label-clash", "warning: a label found no free place";
    INTERNAL = "internal", "a bug of tracefig";
}

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
