//! The pages of a book: what of their Markdown is ours, drawn and put in its place.
//!
//! A page says ```` ```tracefig ```` before a scene, `{{#tracefig FILE}}` for one in a file, and
//! `{{=FILE VALUE}}` for a number of its answer. [`markdown`] finds them, [`figures`] draws them,
//! [`exercise`] those of a question and its key, [`colors`] lets them follow the book's theme, [`kept`] has
//! those of the last build, [`runtime`] is what those need that are live, [`links`] are the addresses of
//! code, and [`mail`] is how the book comes and goes.

pub(crate) mod attributes;
pub(crate) mod colors;
mod exercise;
pub(crate) mod figures;
pub(crate) mod kept;
pub(crate) mod links;
pub(crate) mod mail;
pub(crate) mod markdown;
pub(crate) mod places;
pub(crate) mod runtime;
