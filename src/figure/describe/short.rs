//! The short text: a sentence or two.

use super::result::Account;

/// A text for `alt`: the title in plain words, and the result that is `told` with its number.
pub(crate) fn short(title: Option<&str>, told: &Account) -> String {
    let Some(title) = title else { return told.sentence() };
    if title.trim_end().ends_with(['.', '!', '?', '…', ':', ';']) {
        format!("{} {}", title.trim_end(), told.sentence())
    } else {
        told.titled(title)
    }
}
