//! Dark lines on white.

use crate::drawing::Color;

use super::{Strokes, Theme, TypeSizes};

pub(super) const COLORS: [Color; 10] = [
    Color::hex(0xBC_0D2A),
    Color::hex(0x00_856F),
    Color::hex(0x3A_2FB0),
    Color::hex(0xB6_5E00),
    Color::hex(0x0B_5FCC),
    Color::hex(0xFF_D35A),
    Color::hex(0x1B_1F24),
    Color::hex(0x5B_6472),
    Color::hex(0xE6_E9EE),
    Color::hex(0xFF_FFFF),
];

pub(super) const THEME: Theme = Theme {
    name: "light",
    about: "dark lines on white",
    colors: COLORS,
    words: COLORS,
    strokes: Strokes::HOUSE,
    text: TypeSizes::HOUSE,
    fill_opacity: 0.2,
    pattern_opacity: 0.0,
    patterns: &[],
    dark: None,
};
