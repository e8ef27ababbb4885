//! Markup read out in words, for alternative texts and names.

use crate::typeset;

/// Markup without its dollars and roles, formulas in plain text: `$B \ominus A$` becomes `B ⊖ A`. What is no
/// markup, as a formula without an end, is read as it stands.
///
/// ```
/// use tracefig::figure::plain;
/// assert_eq!(plain(r"{a|the box} and $B \ominus A$"), "the box and B ⊖ A");
/// ```
#[must_use]
pub fn plain(markup: &str) -> String {
    typeset::plain(markup)
}
