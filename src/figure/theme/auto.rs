//! Light, and dark where the page or the reader's system is: one SVG for both.

use super::{Side, Theme, dark, light};

pub(super) const THEME: Theme = Theme {
    name: "auto",
    about: "light or dark, as the reader's system is",
    dark: Some(Side { colors: dark::COLORS, words: dark::WORDS, fill_opacity: dark::THEME.fill_opacity }),
    ..light::THEME
};
