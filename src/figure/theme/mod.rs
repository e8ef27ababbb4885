//! Themes: a colour for each role, and what tells roles apart without colour. One theme a file, each a row in
//! [`THEMES`].
//!
//! The role decides the colour everywhere, so that a reader learns it once. [`contrast`] and [`vision`]
//! measure what a theme promises; tests refuse a theme that does not keep it.

mod auto;
pub mod contrast;
mod dark;
mod light;
mod print;
mod user;
pub mod vision;

pub use user::{Shortcoming, ThemeError, parse};

use crate::drawing::{Color, Paint, PatternKind, Role};

/// A colour for each role, and what tells roles apart without colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// The name in a scene and on the command line.
    pub name: &'static str,
    /// What it is for, for `tracefig list`.
    pub about: &'static str,
    /// The colours, in the order of [`Role::ALL`].
    pub colors: [Color; 9],
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
    pub colors: [Color; 9],
    /// Opacity of the fill of areas, from 0 to 1.
    pub fill_opacity: f64,
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
        let index = Role::ALL.iter().position(|&r| r == role).unwrap_or(0);
        self.colors[index]
    }

    /// The opaque paint of a role.
    #[must_use]
    pub(crate) fn paint(&self, role: Role) -> Paint {
        Paint::role(role, self.color(role))
    }

    /// Whether it tells roles by colour; one that has patterns is also for readers without.
    #[must_use]
    pub(crate) fn counts_on_color(&self) -> bool {
        self.patterns.is_empty()
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
