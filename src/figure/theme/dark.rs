//! Light lines on a dark page.

use crate::drawing::Color;

use super::{Strokes, Theme, TypeSizes};

pub(super) const COLORS: [Color; 10] = [
    Color::hex(0xFF_6B57),
    Color::hex(0x3F_E0BC),
    Color::hex(0xC9_A6FF),
    Color::hex(0xFF_D166),
    Color::hex(0x40_82FF),
    Color::hex(0x4F_4319),
    Color::hex(0xE8_EAED),
    Color::hex(0x9A_A3AF),
    Color::hex(0x24_2B35),
    Color::hex(0x12_161C),
];

/// The colours of words: the blue of lines has 4.7 : 1 on a panel and 2.5 on bodies, this one 4.5 and more.
pub(super) const WORDS: [Color; 10] = {
    let mut words = COLORS;
    words[4] = Color::hex(0x8A_B8FF);
    words
};

pub(super) const THEME: Theme = Theme {
    name: "dark",
    about: "light lines on a dark page",
    colors: COLORS,
    words: WORDS,
    strokes: Strokes::HOUSE,
    text: TypeSizes::HOUSE,
    fill_opacity: 0.24,
    pattern_opacity: 0.0,
    patterns: &[],
    dark: None,
};
