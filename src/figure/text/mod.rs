//! Everything that a figure says in letters, from the scene's markup to lines that are set.
//!
//! `{=name}` in a text stands for a value of the answer ([`values`]), a [`quantity`] written as a
//! [`number`](number::number) of three digits, or all where they are few ([`fill`](fill::fill)). Headline and
//! [`caption`] are broken into lines, a long caption in two [`columns`](columns::columns), a label gets its
//! [`wording`], and [`plain`](plain::plain) reads markup out in words for the alternative text.

mod boxes;
mod caption;
mod columns;
mod contacts;
mod decimal;
mod digits;
mod directions;
mod fill;
mod fold;
mod givers;
mod letters;
mod number;
mod outcome;
mod overrides;
mod places;
mod plain;
mod point;
mod quantity;
mod round;
mod step_values;
mod symbols;
mod turns;
mod values;
mod wording;

pub(crate) use caption::{
    Across, Block, across, caption_of_words, named, paragraphs, set, spoken, under, with_powers,
};
pub(crate) use decimal::Decimal;
pub(crate) use digits::Digits;
pub(crate) use directions::in_panel;
pub(crate) use fill::filled;
pub(crate) use givers::{NO_OTHER, givers};
pub(crate) use number::{
    bound_and_parts, in_math, in_words, least, most, number, parts, rounded, rounded_down, rounded_up_beside,
    terms, whole_and_parts,
};
pub(crate) use overrides::{label_key, overridden};
pub(crate) use places::Places;
pub use plain::plain;
pub(crate) use quantity::{Quantity, asked_distance, distance_or_depth};
pub(crate) use round::{decimal, exponent, round_up};
pub(crate) use symbols::{Symbol, symbols};
pub(crate) use values::value_of;
pub use values::values;
pub(crate) use wording::{Wording, bad_markup, check_texts};
