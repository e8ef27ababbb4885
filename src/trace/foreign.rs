//! Texts of ours in the languages of scenes: from the tables that have them, or from a page.
//!
//! The module of live pages has its tables in English alone, and a page in another language brings the texts
//! of that one. Of which row a text is, the row's place in memory says: rows stand in statics.

#[cfg(tracefig_page)]
use std::sync::OnceLock;

/// How many languages beside English have texts of ours; they are the last columns of a row.
#[cfg(not(tracefig_page))]
const LANGUAGES: usize = 3;

/// The text of a column of a row: the row's own, else that which a page brought, else the first one.
pub(crate) fn text(row: &[&'static str], column: usize) -> &'static str {
    let own = row.get(column).copied();
    own.or_else(|| brought(row)).or(row.first().copied()).unwrap_or_default()
}

/// The text of a row in a language, from 1, which is the first one beside English.
#[cfg(not(tracefig_page))]
pub(crate) fn of_language(row: &[&'static str], language: usize) -> &'static str {
    text(row, row.len() - LANGUAGES + language - 1)
}

/// No page brings what the tables have.
#[cfg(not(tracefig_page))]
fn brought(_: &[&'static str]) -> Option<&'static str> {
    None
}

/// Leaves the tables as they are: they have all languages.
#[cfg(not(tracefig_page))]
pub(crate) fn bring_texts(_: impl Iterator<Item = (&'static [&'static str], String)>) {}

/// What a page brought, by the addresses of the rows.
#[cfg(tracefig_page)]
static BROUGHT: OnceLock<Vec<(usize, String)>> = OnceLock::new();

/// What a page brought for a row.
#[cfg(tracefig_page)]
fn brought(row: &[&'static str]) -> Option<&'static str> {
    let all = BROUGHT.get()?;
    all.iter().find(|(place, _)| *place == address(row)).map(|(_, text)| text.as_str())
}

/// Tells from now on in the texts that a page brings, each for a row.
#[cfg(tracefig_page)]
pub(crate) fn bring_texts(texts: impl Iterator<Item = (&'static [&'static str], String)>) {
    BROUGHT.get_or_init(|| texts.map(|(row, text)| (address(row), text)).collect());
}

/// The place of a row in memory.
#[cfg(tracefig_page)]
fn address(row: &[&'static str]) -> usize {
    row.as_ptr().addr()
}
