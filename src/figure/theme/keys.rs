//! The keys of a theme file, for who writes one.

use std::fmt;

use crate::drawing::Role;

use super::THEMES;
use super::strokes::{LineKind, Strokes};
use super::type_sizes::{TextKind, TypeSizes};

/// What a key of a theme file takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ThemeValue {
    /// The word for a theme of the house.
    Base,
    /// A colour, `#RRGGBB` or `#RGB`.
    Color,
    /// A share, from 0 to 1.
    Share,
    /// Page pixels, from the first number to the second.
    Pixels(f64, f64),
}

impl fmt::Display for ThemeValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Base => f.write_str(&THEMES.iter().map(|theme| theme.name).collect::<Vec<_>>().join(" | ")),
            Self::Color => f.write_str("#RRGGBB or #RGB"),
            Self::Share => f.write_str("0 to 1"),
            Self::Pixels(least, most) => write!(f, "{least} to {most} pixels"),
        }
    }
}

/// A key of a theme file.
#[derive(Clone, Debug, PartialEq)]
pub struct ThemeKey {
    /// The table that it is in; empty for the file itself.
    pub table: &'static str,
    /// The key.
    pub name: &'static str,
    /// What it takes.
    pub takes: ThemeValue,
    /// What it is for, and its value where it is not given.
    pub about: String,
}

/// Every key of a theme file, in the order in which they are told.
///
/// ```
/// use tracefig::figure::theme::keys;
/// let key = keys().into_iter().find(|key| key.table == "stroke" && key.name == "outline").unwrap();
/// assert_eq!(key.takes.to_string(), "0.5 to 8 pixels");
/// ```
#[must_use]
pub fn keys() -> Vec<ThemeKey> {
    let key = |table, name, takes, about: String| ThemeKey { table, name, takes, about };
    let based = "the theme that the rest is taken from; default by the colour of the page".to_owned();
    let opacity = "opacity of areas; default as that theme's".to_owned();
    let mut keys = vec![
        key("", "based_on", ThemeValue::Base, based),
        key("", "fill_opacity", ThemeValue::Share, opacity),
    ];
    let color = ThemeValue::Color;
    keys.extend(Role::ALL.map(|role| key("colors", role.name(), color, role.about().to_owned())));
    let dark = |role: Role| format!("{}, for readers whose system is dark", role.about());
    keys.extend(Role::ALL.map(|role| key("dark", role.name(), color, dark(role))));
    let pixels = |(least, most)| ThemeValue::Pixels(least, most);
    keys.extend(TextKind::ALL.map(|kind| {
        let about = format!("size of {}; default {}", kind.about(), kind.size());
        key("text", kind.name(), pixels(TypeSizes::RANGE), about)
    }));
    keys.extend(LineKind::ALL.map(|kind| {
        let about = format!("width of {}; default {}", kind.about(), kind.width());
        key("stroke", kind.name(), pixels(Strokes::RANGE), about)
    }));
    keys
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::*;

    #[test]
    fn every_key_is_taken_by_a_theme_file() {
        for ThemeKey { table, name, takes, .. } in keys() {
            let value = match takes {
                ThemeValue::Base => "'dark'".to_owned(),
                ThemeValue::Color => "'#123456'".to_owned(),
                ThemeValue::Share => "0.5".to_owned(),
                ThemeValue::Pixels(least, _) => least.to_string(),
            };
            let header = if table.is_empty() { String::new() } else { format!("[{table}]\n") };
            let read = parse(&format!("{header}{name} = {value}"));
            assert!(read.is_ok(), "{table} {name}: {read:?}");
        }
    }
}
