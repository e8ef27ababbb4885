//! Figures of a scene that its project file asks for no more: of a theme or a format that was dropped there.
//!
//! Which themes and formats a command line asks for differs from run to run; what a project file names is
//! what stays. A figure is known by its name, `STEM[.SEED][.VARIANT][.THEME][.steps|.step-01|…].EXT`.

use std::fmt;
use std::path::Path;

use tracefig::scene::{Variant, visible};

use super::in_time::InTime;
use super::inputs::shown;
use super::settings::Settings;

/// Why a project file does not ask for a figure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Unasked {
    /// The file names other themes.
    Theme(String),
    /// The file names one theme, which the names of its figures lack.
    OneTheme,
    /// The file names several themes, which are in the names of their figures.
    SeveralThemes(usize),
    /// The file names other formats.
    Format(String),
}

impl fmt::Display for Unasked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Theme(theme) => write!(f, "names no theme `{}`", visible(theme)),
            Self::OneTheme => f.write_str("names one theme, and the names of its figures none"),
            Self::SeveralThemes(count) => write!(f, "names {count} themes, and the name of this figure none"),
            Self::Format(format) => write!(f, "names no format `{}`", visible(format)),
        }
    }
}

/// Why the project file does not ask for a figure of one of its scenes; `parts` of its name stand between the
/// scene's stem and the extension. `None` where it does, or says nothing of themes and formats.
pub(crate) fn unasked(settings: &Settings, parts: &[String], extension: &str) -> Option<Unasked> {
    let (theme, is_plain) = theme_of(parts);
    let count = settings.themes.len();
    if settings.themes_of_project {
        match theme {
            theme if theme.is_empty() && is_plain && count > 1 && settings.in_time.is_none() => {
                return Some(Unasked::SeveralThemes(count));
            }
            theme if theme.is_empty() => {}
            theme if settings.themes.iter().all(|known| known.name != theme) => {
                return Some(Unasked::Theme(theme));
            }
            _ if count == 1 => return Some(Unasked::OneTheme),
            _ => {}
        }
    }
    // Steps, motions and exercises are asked for with formats of their own.
    let formats = &settings.formats_of_project;
    let is_other = is_plain && !formats.is_empty() && formats.iter().all(|format| format.name != extension);
    is_other.then(|| Unasked::Format(extension.to_owned()))
}

/// The theme that the parts of a figure's name tell of, empty where they do not; and whether they tell of
/// nothing else.
fn theme_of(parts: &[String]) -> (String, bool) {
    let mut rest = parts;
    let is_seed = |part: &String| part.len() > 1 && part.bytes().all(|byte| byte.is_ascii_digit());
    if let Some((_, after)) = rest.split_first().filter(|(first, _)| is_seed(first)) {
        rest = after;
    }
    if let Some((_, after)) = rest.split_first().filter(|(first, _)| Variant::of_word(first).is_some()) {
        rest = after;
    }
    if let Some((_, before)) = rest.split_last().filter(|(last, _)| InTime::is_part(last)) {
        rest = before;
    }
    (rest.join("."), rest.len() == parts.len())
}

/// The words for a figure that a project file does not ask for.
pub(crate) fn told(project: &Path, why: &Unasked) -> String {
    format!("{} {why}", shown(project))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_theme_is_what_no_other_part_of_a_name_is() {
        let of = |name: &str| {
            let parts: Vec<String> =
                name.split('.').filter(|part| !part.is_empty()).map(str::to_owned).collect();
            theme_of(&parts)
        };
        let cases = [
            ("", "", true),
            ("dark", "dark", true),
            ("brand.v2", "brand.v2", true),
            ("07.question.dark", "dark", false),
            ("key", "", false),
            ("dark.steps", "dark", false),
            ("step-01", "", false),
            ("brand.frame-40", "brand", false),
            ("motion", "", false),
            ("step-one", "step-one", true),
        ];
        for (name, theme, is_plain) in cases {
            assert_eq!(of(name), (theme.to_owned(), is_plain), "{name}");
        }
    }
}
