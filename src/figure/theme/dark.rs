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

pub(super) const THEME: Theme = Theme {
    name: "dark",
    about: "light lines on a dark page",
    colors: COLORS,
    words: COLORS,
    strokes: Strokes::HOUSE,
    text: TypeSizes::HOUSE,
    fill_opacity: 0.24,
    pattern_opacity: 0.0,
    patterns: &[],
    dark: None,
};
