//! The keys of a theme file, for who writes one.

use crate::drawing::Role;

use super::THEMES;
use super::strokes::{LineKind, Strokes};
use super::type_sizes::{TextKind, TypeSizes};

/// A key of a theme file.
#[derive(Clone, Debug, PartialEq)]
pub struct ThemeKey {
    /// The table that it is in; empty for the file itself.
    pub table: &'static str,
    /// The key.
    pub name: &'static str,
    /// What it takes, in words.
    pub takes: String,
    /// What it is for, and its value where it is not given.
    pub about: String,
}

/// Every key of a theme file, in the order in which they are told.
///
/// ```
/// use tracefig::figure::theme::keys;
/// let key = keys().into_iter().find(|key| key.table == "stroke" && key.name == "outline").unwrap();
/// assert_eq!(key.takes, "0.5 to 8 pixels");
/// ```
#[must_use]
pub fn keys() -> Vec<ThemeKey> {
    let key = |table, name, takes: String, about: String| ThemeKey { table, name, takes, about };
    let words: Vec<&str> = THEMES.iter().map(|theme| theme.name).collect();
    let based = "the theme that the rest is taken from; default by the colour of the page".to_owned();
    let opacity = "opacity of areas; default as that theme's".to_owned();
    let mut keys = vec![
        key("", "based_on", words.join(" | "), based),
        key("", "fill_opacity", "0 to 1".to_owned(), opacity),
    ];
    let color = || "#RRGGBB or #RGB".to_owned();
    keys.extend(Role::ALL.map(|role| key("colors", role.name(), color(), role.about().to_owned())));
    let dark = |role: Role| format!("{}, for readers whose system is dark", role.about());
    keys.extend(Role::ALL.map(|role| key("dark", role.name(), color(), dark(role))));
    let pixels = |(least, most): (f64, f64)| format!("{least} to {most} pixels");
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
            let word = takes.split(' ').next().unwrap();
            let value = match word.parse::<f64>() {
                Ok(number) => number.to_string(),
                Err(_) if word.starts_with('#') => "'#123456'".to_owned(),
                Err(_) => format!("'{word}'"),
            };
            let header = if table.is_empty() { String::new() } else { format!("[{table}]\n") };
            let read = parse(&format!("{header}{name} = {value}"));
            assert!(read.is_ok(), "{table} {name}: {read:?}");
        }
    }
}
