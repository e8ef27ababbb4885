//! Themes: a colour for each role, and what tells roles apart without colour. One theme a file, each a row in
//! [`THEMES`].
//!
//! The role decides the colour everywhere, so that a reader learns it once. [`contrast`] and [`vision`]
//! measure what a theme promises; tests refuse a theme that does not keep it.

mod adapted;
mod auto;
pub mod contrast;
mod dark;
mod fitness;
mod keys;
mod light;
mod nearest;
mod print;
mod strokes;
mod type_sizes;
mod user;
pub mod vision;

pub use fitness::{Measure, Shortcoming, remedies, shortcomings};
pub use keys::{ThemeKey, ThemeValue, keys};
pub use strokes::{LineKind, Strokes};
pub use type_sizes::{TextKind, TypeSizes};
pub(crate) use user::of_json;
pub use user::{ThemeError, dark_side_of, is_file, parse};

use crate::drawing::{Color, Paint, PatternKind, Role};

/// A colour for each role, and what tells roles apart without colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// The name in a scene and on the command line.
    pub name: &'static str,
    /// What it is for, for `tracefig list`.
    pub about: &'static str,
    /// The colours, in the order of [`Role::ALL`].
    pub colors: [Color; 10],
    /// The colours of words, in the order of [`Role::ALL`]: the same, or a shade of them where they are too
    /// pale to read.
    pub words: [Color; 10],
    /// How wide lines are drawn.
    pub strokes: Strokes,
    /// How large letters are set.
    pub text: TypeSizes,
    /// Opacity of the fill of areas, from 0 to 1.
    pub fill_opacity: f64,
    /// Opacity of the pattern on fills, from 0 to 1.
    pub pattern_opacity: f64,
    /// The patterns on the fills of some roles.
    pub patterns: &'static [(Role, PatternKind)],
    /// What readers whose system is dark see, where the theme follows it.
    pub dark: Option<Side>,
}

/// The other side of a theme that follows the reader's system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// The colours, in the order of [`Role::ALL`].
    pub colors: [Color; 10],
    /// The colours of words, in the order of [`Role::ALL`]: the same, or a shade of them where they are too
    /// pale to read.
    pub words: [Color; 10],
    /// Opacity of the fill of areas, from 0 to 1.
    pub fill_opacity: f64,
}

impl Side {
    /// This side on another background; a grid is as quiet there as it was.
    fn on(mut self, background: Color) -> Self {
        self.colors[index(Role::Background)] = background;
        let colors = self.colors;
        let is_seen =
            |role: Role| contrast::contrast(colors[index(role)], background) >= fitness::LINE_CONTRAST;
        adapted::adapted(self, |role| role == Role::Background || (role != Role::Grid && is_seen(role)))
    }

    /// The colour of a role's words.
    pub(crate) fn word_color(&self, role: Role) -> Color {
        self.words[index(role)]
    }
}

/// The place of a role in [`Role::ALL`].
fn index(role: Role) -> usize {
    Role::ALL.iter().position(|&r| r == role).unwrap_or(0)
}

impl Theme {
    /// The colour of a role.
    ///
    /// ```
    /// use tracefig::{drawing::{Color, Role}, figure::theme::THEMES};
    /// assert_eq!(THEMES[0].color(Role::Background), Color::hex(0xFFFFFF));
    /// ```
    #[must_use]
    pub fn color(&self, role: Role) -> Color {
        self.colors[index(role)]
    }

    /// The colour of a role's words: its own, or a shade of it that is readable on the page.
    ///
    /// ```
    /// use tracefig::{drawing::Role, figure::theme::{self, contrast::contrast}};
    /// let theme = theme::parse("[colors]\na = \"#E69F00\"").unwrap();
    /// let page = theme.color(Role::Background);
    /// assert!(contrast(theme.color(Role::A), page) < 3.0, "an orange line");
    /// assert!(contrast(theme.word_color(Role::A), page) >= 4.5, "a darker orange for its name");
    /// ```
    #[must_use]
    pub fn word_color(&self, role: Role) -> Color {
        self.words[index(role)]
    }

    /// This theme on another background, for dark systems too: what can't be seen there has another colour,
    /// and words a shade that can be read.
    ///
    /// ```
    /// use tracefig::{drawing::{Color, Role}, figure::theme::{THEMES, contrast::contrast}};
    /// let night = Color::hex(0x16_1923);
    /// let ink = THEMES[0].on(night).word_color(Role::Ink);
    /// assert!(contrast(ink, night) >= 4.5, "lighter than that of the light theme");
    /// ```
    #[must_use]
    pub fn on(&self, background: Color) -> Self {
        let Side { colors, words, .. } = self.light().on(background);
        Self { colors, words, dark: self.dark.map(|dark| dark.on(background)), ..self.clone() }
    }

    /// What readers whose system is dark see, for all readers: as an image has it, which follows no system.
    /// `None` for a theme that follows none either.
    ///
    /// ```
    /// use tracefig::{drawing::{Color, Role}, figure::theme};
    /// let theme = theme::parse("[colors]\na = \"#0072B2\"\n[dark]\na = \"#56B4E9\"").unwrap();
    /// let dark = theme.in_the_dark().unwrap();
    /// assert_eq!(dark.color(Role::A), Color::hex(0x56B4E9));
    /// assert!(dark.in_the_dark().is_none());
    /// ```
    #[must_use]
    pub fn in_the_dark(&self) -> Option<Self> {
        let Side { colors, words, fill_opacity } = self.dark?;
        Some(Self { colors, words, fill_opacity, dark: None, ..self.clone() })
    }

    /// The opaque paint of a role's lines and markers.
    #[must_use]
    pub(crate) fn paint(&self, role: Role) -> Paint {
        Paint::role(role, self.color(role))
    }

    /// Whether it tells roles by colour; one that has patterns is also for readers without.
    #[must_use]
    pub(crate) fn counts_on_color(&self) -> bool {
        self.patterns.is_empty()
    }

    /// The opaque paint of a role's words.
    #[must_use]
    pub(crate) fn word_paint(&self, role: Role) -> Paint {
        Paint::role(role, self.word_color(role))
    }

    /// The light side, or the only one.
    pub(crate) fn light(&self) -> Side {
        Side { colors: self.colors, words: self.words, fill_opacity: self.fill_opacity }
    }

    /// The light side, or the only one; the dark side where the theme follows the reader's system.
    pub(crate) fn sides(&self) -> impl Iterator<Item = Side> {
        [Some(self.light()), self.dark].into_iter().flatten()
    }

    /// The roles whose words have another colour than their lines, on one side at least.
    pub(crate) fn shaded(&self) -> impl Iterator<Item = Role> {
        let shaded = |i: usize| self.sides().any(|side| side.words[i] != side.colors[i]);
        Role::ALL.into_iter().enumerate().filter(move |&(i, _)| shaded(i)).map(|(_, role)| role)
    }

    /// The pattern on the fills of a role; `None` for a plain fill.
    #[must_use]
    pub(crate) fn pattern(&self, role: Role) -> Option<PatternKind> {
        self.patterns.iter().find(|(r, _)| *r == role).map(|&(_, kind)| kind)
    }
}

/// Every theme; the first is the default.
pub static THEMES: &[Theme] = &[light::THEME, dark::THEME, print::THEME, auto::THEME];

/// The theme of a name; `None` where the house has none.
///
/// ```
/// use tracefig::figure::theme::{THEMES, find};
/// assert_eq!(find("dark").unwrap().name, "dark");
/// assert!(find("drak").is_none());
/// assert_eq!(THEMES[0].name, "light", "the default");
/// ```
#[must_use]
pub fn find(name: &str) -> Option<&'static Theme> {
    THEMES.iter().find(|t| t.name == name)
}

#[cfg(test)]
mod tests {
    use super::contrast::contrast;
    use super::*;

    #[test]
    fn a_grid_is_quiet_on_every_background() {
        for theme in THEMES {
            for background in [0xFF_FFFF, 0xFF_F8E7, 0x1A_1A2E, 0x00_0000].map(Color::hex) {
                let on = theme.on(background);
                for side in on.sides() {
                    let grid = contrast(side.colors[index(Role::Grid)], background);
                    assert!((1.05..1.6).contains(&grid), "{} on {background}: {grid}", theme.name);
                }
            }
        }
    }
}
