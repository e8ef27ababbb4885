//! Figures in words: a [`short`] text for `alt`, a [`long`] one for `desc` and for readers who do not see the
//! picture.
//!
//! Both are generated from the scene, the answer and the trace: what is there, where it is, what was asked,
//! the result with its number, how many steps it took, and what each panel shows. Words only: formulas are
//! read out as they would be written in running text.

pub(in crate::figure) mod body;
pub(crate) mod body_phrases;
mod long;
mod number;
mod off;
mod phrases;
mod result;
mod short;

pub(crate) use long::{Shown, long, shown, shown_at};
pub(crate) use phrases::QUESTION;
pub(crate) use result::{Account, closing};
pub(crate) use short::short;

use crate::trace::Phrase;

/// Every phrase of the short and the long text, in an order that stays.
pub(crate) fn all_phrases() -> impl Iterator<Item = &'static Phrase> {
    phrases::ALL.iter().chain(body_phrases::ALL).copied()
}
