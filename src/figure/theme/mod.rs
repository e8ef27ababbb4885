//! Themes: a colour for each role, and what tells roles apart without colour. One theme a file, each a row in
//! [`THEMES`].
//!
//! The role decides the colour everywhere, so that a reader learns it once. [`contrast`] and [`vision`] measure what a
//! theme promises; tests refuse a theme that does not keep it.

mod auto;
pub mod contrast;
mod dark;
mod light;
mod print;
mod user;
pub mod vision;

pub use user::{Shortcoming, ThemeError, parse, shortcomings};

use crate::drawing::{Color, Paint, PatternKind, Role};

/// Colours by role.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// The word in a scene and on the command line.
    pub name: &'static str,
    /// One line for `tracefig list`.
    pub about: &'static str,
    /// In the order of [`Role::ALL`].
    pub colors: [Color; 9],
    /// Opacity of the fill of areas.
    pub fill_opacity: f64,
    /// Opacity of the pattern on fills.
    pub pattern_opacity: f64,
    /// Patterns of the fills, by role.
    pub patterns: &'static [(Role, PatternKind)],
    /// What readers whose system is dark see, where the theme follows it.
    pub dark: Option<Side>,
}

/// The other side of a theme that follows the reader's system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// In the order of [`Role::ALL`].
    pub colors: [Color; 9],
    /// Opacity of the fill of areas.
    pub fill_opacity: f64,
}

impl Theme {
    /// The colour of a role.
    #[must_use]
    pub fn color(&self, role: Role) -> Color {
        let index = Role::ALL.iter().position(|&r| r == role).unwrap_or(0);
        self.colors[index]
    }

    /// The opaque paint of a role.
    #[must_use]
    pub fn paint(&self, role: Role) -> Paint {
        Paint::role(role, self.color(role))
    }

    /// The pattern on the fills of a role.
    #[must_use]
    pub fn pattern(&self, role: Role) -> Option<PatternKind> {
        self.patterns.iter().find(|(r, _)| *r == role).map(|&(_, kind)| kind)
    }
}

/// Every theme; the first is the default.
pub static THEMES: &[Theme] = &[light::THEME, dark::THEME, print::THEME, auto::THEME];

/// The theme of a name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Theme> {
    THEMES.iter().find(|t| t.name == name)
}
