//! For paper, in colour or grey: A is hatched and B dotted, so that nothing is lost without colour.

use crate::drawing::{Color, PatternKind, Role};

use super::{Strokes, Theme, TypeSizes};

const COLORS: [Color; 10] = [
    Color::hex(0x8E_0F18),
    Color::hex(0x00_7A66),
    Color::hex(0x2E_2A8F),
    Color::hex(0xB3_5C00),
    Color::hex(0x0B_55B8),
    Color::hex(0xEF_D27A),
    Color::hex(0x00_0000),
    Color::hex(0x4A_4A4A),
    Color::hex(0xDD_DDDD),
    Color::hex(0xFF_FFFF),
];

pub(super) const THEME: Theme = Theme {
    name: "print",
    about: "for paper, also in grey: A hatched, B dotted",
    colors: COLORS,
    words: COLORS,
    strokes: Strokes::HOUSE,
    text: TypeSizes::HOUSE,
    fill_opacity: 0.1,
    pattern_opacity: 0.35,
    patterns: &[(Role::A, PatternKind::Hatch), (Role::B, PatternKind::Dots)],
    dark: None,
};
