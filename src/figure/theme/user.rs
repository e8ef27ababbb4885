//! A theme that a user wrote as a TOML file, held to the limits that the themes of the house keep.
//!
//! ```toml
//! based_on = "dark"          # what is not given is taken from here; light unless given
//! fill_opacity = 0.25
//!
//! [colors]
//! a = "#FF6650"
//! background = "#101010"
//! ```

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

use crate::drawing::{Color, Role};

use super::contrast::{blend, contrast};
use super::vision::worst_difference;
use super::{THEMES, Theme, find};

/// The least contrast of text against what lies under it (WCAG 2.2, level AA).
const TEXT_CONTRAST: f64 = 4.5;
/// The least ΔE2000 of shape A and shape B for the worst of four visions.
const BODIES_APART: f64 = 20.0;
/// The least ΔE2000 of any other two roles; dashes, markers and shapes tell them apart besides.
const ROLES_APART: f64 = 9.0;

/// The roles that colour lines and words.
const SPEAKING: [Role; 7] =
    [Role::A, Role::B, Role::Difference, Role::Now, Role::Translation, Role::Ink, Role::Muted];

/// A theme file, as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    /// The theme that what is not given is taken from.
    based_on: Option<String>,
    /// Opacity of areas, from 0 to 1.
    fill_opacity: Option<f64>,
    #[serde(default)]
    /// `#RRGGBB` by the word of its role.
    colors: BTreeMap<String, String>,
}

/// A pair of roles whose colours are too near each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Shortcoming {
    /// The measure: `contrast` or `ΔE2000`.
    pub measure: &'static str,
    /// The two roles whose colours were compared.
    pub roles: [Role; 2],
    /// The value of the measure.
    pub value: f64,
    /// The least value that would do.
    pub limit: f64,
}

/// Why a theme file is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum ThemeError {
    /// The file is not TOML, or has an unknown key or a wrong type; the text names the line and quotes it.
    Malformed(String),
    /// The theme that it is based on is none of the house.
    UnknownBase(String),
    /// A colour is given to a role that there is not.
    UnknownRole(String),
    /// A colour is not written `#RRGGBB`.
    NotAColor {
        /// The role that it is given to.
        role: String,
        /// What was written.
        written: String,
    },
    /// The opacity of areas is not from 0 to 1.
    FillOpacity(f64),
    /// The colours can't be read or told apart.
    Unfit(Vec<Shortcoming>),
}

impl fmt::Display for ThemeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Malformed(text) => f.write_str(text.trim_end()),
            Self::UnknownBase(name) => {
                let names: Vec<&str> = THEMES.iter().map(|theme| theme.name).collect();
                write!(f, "based_on: expected one of {}, got `{name}`", names.join(", "))
            }
            Self::UnknownRole(name) => {
                let names: Vec<&str> = Role::ALL.iter().map(|r| r.name()).collect();
                write!(f, "colors: expected one of {}, got `{name}`", names.join(", "))
            }
            Self::NotAColor { role, written } => {
                write!(f, "colors.{role}: expected `#RRGGBB`, got `{written}`")
            }
            Self::FillOpacity(value) => write!(f, "fill_opacity: expected 0 to 1, got {value}"),
            Self::Unfit(all) => {
                f.write_str("colours that readers can't tell apart:")?;
                for Shortcoming { measure, roles: [p, q], value, limit } in all {
                    write!(f, "\n  {} and {}: {measure} {value:.1}, at least {limit}", p.name(), q.name())?;
                }
                Ok(())
            }
        }
    }
}

impl std::error::Error for ThemeError {}

/// Reads the text of a theme file into a theme of the name `user`.
///
/// # Errors
///
/// A [`ThemeError`] where the text is not such a file, or its colours fall short of the limits.
///
/// ```
/// use tracefig::drawing::{Color, Role};
/// use tracefig::figure::theme;
/// let theme = theme::parse("[colors]\na = \"#9A1620\"").unwrap();
/// assert_eq!(theme.color(Role::A), Color::hex(0x9A1620));
/// assert!(theme::parse("[colors]\nink = \"#EEEEEE\"").is_err());
/// ```
pub fn parse(text: &str) -> Result<Theme, ThemeError> {
    let file: File = toml::from_str(text).map_err(|e| ThemeError::Malformed(e.to_string()))?;
    let base = file.based_on.unwrap_or_else(|| THEMES[0].name.to_owned());
    let mut theme = find(&base).cloned().ok_or(ThemeError::UnknownBase(base))?;
    theme.name = "user";
    theme.about = "from a file";
    if let Some(opacity) = file.fill_opacity {
        if !(0.0..=1.0).contains(&opacity) {
            return Err(ThemeError::FillOpacity(opacity));
        }
        theme.fill_opacity = opacity;
    }
    for (role, written) in file.colors {
        let Some(index) = Role::ALL.iter().position(|r| r.name() == role) else {
            return Err(ThemeError::UnknownRole(role));
        };
        theme.colors[index] = color(&written).ok_or(ThemeError::NotAColor { role, written })?;
    }
    let short = shortcomings(&theme);
    if short.is_empty() { Ok(theme) } else { Err(ThemeError::Unfit(short)) }
}

/// The colour of `#RRGGBB`; `None` for anything else.
fn color(written: &str) -> Option<Color> {
    let digits =
        written.strip_prefix('#').filter(|d| d.len() == 6 && d.bytes().all(|b| b.is_ascii_hexdigit()))?;
    u32::from_str_radix(digits, 16).ok().map(Color::hex)
}

/// Everything in which a theme falls short of the limits; empty for a fit one.
pub(crate) fn shortcomings(theme: &Theme) -> Vec<Shortcoming> {
    let mut all = Vec::new();
    let mut hold = |measure, roles, value: f64, limit| {
        if value < limit {
            all.push(Shortcoming { measure, roles, value, limit });
        }
    };
    let page = theme.color(Role::Background);
    for role in SPEAKING {
        hold("contrast", [role, Role::Background], contrast(theme.color(role), page), TEXT_CONTRAST);
    }
    for role in [Role::A, Role::B, Role::Difference] {
        let fill = blend(theme.color(role), theme.fill_opacity, page);
        hold("contrast", [Role::Ink, role], contrast(theme.color(Role::Ink), fill), TEXT_CONTRAST);
    }
    for (i, &p) in SPEAKING.iter().enumerate() {
        for &q in &SPEAKING[i + 1..] {
            let limit = if [p, q] == [Role::A, Role::B] { BODIES_APART } else { ROLES_APART };
            hold("ΔE2000", [p, q], worst_difference(theme.color(p), theme.color(q)), limit);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_with_a_theme_file_is_named() {
        let said = |text: &str| parse(text).unwrap_err().to_string();
        assert!(said("based_on = \"lite\"").contains("light, dark, print, auto, got `lite`"));
        assert!(said("[colors]\nc = \"#000000\"").contains("got `c`"));
        assert!(said("[colors]\na = \"red\"").contains("`#RRGGBB`, got `red`"));
        assert!(said("colour = 1").contains("colour"));
        assert!(said("fill_opacity = 2.0").contains("0 to 1"));
        assert!(said("[colors]\na = \"#00856F\"").contains("a and b: ΔE2000 0.0"));
        assert!(said("[colors]\nmuted = \"#C0C0C0\"").contains("muted and background: contrast 1.8"));
    }

    #[test]
    fn the_themes_of_the_house_keep_the_limits_too() {
        for theme in THEMES {
            assert_eq!(shortcomings(theme), [], "{}", theme.name);
        }
    }
}
