//! A theme that a user wrote as a TOML file.
//!
//! ```toml
//! based_on = "dark"          # what is not given is taken from here
//! fill_opacity = 0.25
//!
//! [colors]
//! a = "#FF6650"
//! background = "#101010"
//!
//! [text]                     # page pixels an em
//! name = 20
//!
//! [stroke]                   # page pixels
//! outline = 3
//!
//! [dark]                     # with it, the theme follows the reader's system
//! a = "#FFB0A0"
//! ```
//!
//! What is not given is moved out of the way of what is ([`adapted`](super::adapted)); whether readers can
//! tell the given colours apart is asked of each figure ([`fitness`](super::fitness)).

use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, Visitor};
use toml::de::{DeTable, DeValue};

use crate::drawing::{Color, Role};

use super::adapted::adapted;
use super::contrast::contrast;
use super::strokes::{LineKind, Strokes};
use super::type_sizes::{TextKind, TypeSizes};
use super::{Side, THEMES, Theme, find, index};

/// A table of the file: its keys, each with what is written there. A map of the standard library would add
/// 2 kB to the module of live pages, packed.
struct Keys<T>(Vec<(String, T)>);

impl<T> Default for Keys<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Keys<T> {
    fn deserialize<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        table.deserialize_map(OfKeys(PhantomData))
    }
}

/// Reads a table.
struct OfKeys<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for OfKeys<T> {
    type Value = Keys<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut table: A) -> Result<Self::Value, A::Error> {
        let mut keys = Vec::new();
        while let Some(entry) = table.next_entry()? {
            keys.push(entry);
        }
        Ok(Keys(keys))
    }
}

/// `#RRGGBB` by the word of its role, as written.
type Written = Keys<String>;

/// A theme file, as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    /// The theme that what is not given is taken from.
    based_on: Option<String>,
    /// Opacity of areas, from 0 to 1.
    fill_opacity: Option<f64>,
    /// The colours, or those of the light side.
    #[serde(default)]
    colors: Written,
    /// The colours for readers whose system is dark.
    dark: Option<Written>,
    /// Sizes of letters by what a text is, page pixels an em.
    #[serde(default)]
    text: Keys<f64>,
    /// Widths of lines by what a line is, page pixels.
    #[serde(default)]
    stroke: Keys<f64>,
}

/// Why a theme file is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum ThemeError {
    /// The file is not TOML, or has an unknown key or a wrong type; the text names the line and quotes it.
    Malformed(String),
    /// The theme that it is based on is none of the house.
    UnknownBase(String),
    /// A key that its table does not have.
    UnknownKey {
        /// The table that it is in.
        table: &'static str,
        /// The key as written.
        key: String,
        /// The keys that the table has.
        known: Vec<&'static str>,
    },
    /// A colour is not written `#RRGGBB` or `#RGB`.
    NotAColor {
        /// The table that it is in.
        table: &'static str,
        /// The role that it is given to.
        role: String,
        /// What was written.
        written: String,
    },
    /// A number is outside of what its key takes.
    OutOfRange {
        /// The key, with its table.
        key: String,
        /// What was written.
        got: f64,
        /// The least value.
        least: f64,
        /// The largest value.
        most: f64,
    },
}

impl fmt::Display for ThemeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Malformed(text) => f.write_str(text.trim_end()),
            Self::UnknownBase(name) => {
                let names: Vec<&str> = THEMES.iter().map(|theme| theme.name).collect();
                write!(f, "based_on: expected one of {}, got `{name}`", names.join(", "))
            }
            Self::UnknownKey { table, key, known } => {
                write!(f, "{table}: expected one of {}, got `{key}`", known.join(", "))
            }
            Self::NotAColor { table, role, written } => {
                write!(f, "{table}.{role}: expected `#RRGGBB` or `#RGB`, got `{written}`")
            }
            Self::OutOfRange { key, got, least, most } => {
                write!(f, "{key}: expected {least} to {most}, got {got}")
            }
        }
    }
}

impl std::error::Error for ThemeError {}

impl ThemeError {
    /// Where it is in the text of the file, in bytes; the beginning where the text does not say.
    ///
    /// ```
    /// use tracefig::figure::theme;
    /// let text = "[colors]\naccent = \"#F9A825\"\n";
    /// let place = theme::parse(text).unwrap_err().place(text);
    /// assert_eq!(&text[place], "accent");
    /// ```
    #[must_use]
    pub fn place(&self, text: &str) -> Range<usize> {
        let (path, is_value) = match self {
            Self::Malformed(_) => {
                let span = toml::from_str::<File>(text).err().and_then(|error| error.span());
                return span.unwrap_or(0..0);
            }
            Self::UnknownBase(_) => (vec!["based_on"], true),
            Self::UnknownKey { table, key, .. } => (vec![*table, key.as_str()], false),
            Self::NotAColor { table, role, .. } => (vec![*table, role.as_str()], true),
            Self::OutOfRange { key, .. } => (key.split('.').collect(), true),
        };
        let root = DeTable::parse(text).ok();
        root.and_then(|root| place_in(root.get_ref(), &path, is_value)).unwrap_or(0..0)
    }
}

/// The place of a key, or of its value, by the keys that lead to it.
fn place_in(table: &DeTable<'_>, path: &[&str], is_value: bool) -> Option<Range<usize>> {
    let (first, rest) = path.split_first()?;
    let (key, value) = table.iter().find(|(key, _)| key.get_ref() == first)?;
    match (rest.is_empty(), value.get_ref()) {
        (true, _) => Some(if is_value { value.span() } else { key.span() }),
        (false, DeValue::Table(inner)) => place_in(inner, rest, is_value),
        (false, _) => None,
    }
}

/// What follows the path of a theme file where its side for dark systems alone is asked for.
const DARK_SIDE: &str = "#dark";

/// Whether a theme of this name is a file, or the dark side of one, and none of the house.
///
/// ```
/// use tracefig::figure::theme::is_file;
/// assert!(is_file("brand.toml") && is_file("brand.toml#dark") && !is_file("dark"));
/// ```
#[must_use]
pub fn is_file(name: &str) -> bool {
    let stem = dark_side_of(name).unwrap_or(name).strip_suffix(".toml");
    stem.is_some_and(|stem| !stem.is_empty() && !stem.ends_with(std::path::is_separator))
}

/// The theme file whose side for dark systems alone a name asks for; `None` where it asks for a theme as a
/// whole.
///
/// ```
/// use tracefig::figure::theme::dark_side_of;
/// assert_eq!(dark_side_of("brand.toml#dark"), Some("brand.toml"));
/// assert_eq!(dark_side_of("brand.toml"), None);
/// ```
#[must_use]
pub fn dark_side_of(name: &str) -> Option<&str> {
    name.strip_suffix(DARK_SIDE)
}

/// Reads the text of a theme file into a theme of the name `user`.
///
/// What the file does not give is taken from the theme that it is based on; without one, from that of the
/// house whose page is as light or dark as the file's.
///
/// # Errors
///
/// A [`ThemeError`] where the text is not such a file.
///
/// ```
/// use tracefig::drawing::{Color, Role};
/// use tracefig::figure::theme;
/// let theme = theme::parse("[colors]\na = \"#9A1620\"").unwrap();
/// assert_eq!(theme.color(Role::A), Color::hex(0x9A1620));
/// assert!(theme::parse("[colors]\nink = \"black\"").is_err());
/// ```
pub fn parse(text: &str) -> Result<Theme, ThemeError> {
    theme(toml::from_str(text).map_err(|e| ThemeError::Malformed(e.to_string()))?)
}

/// A theme file whose tables stand in JSON.
pub(crate) fn of_json(file: &serde_json::Value) -> Result<Theme, ThemeError> {
    theme(File::deserialize(file).map_err(|e| ThemeError::Malformed(e.to_string()))?)
}

/// The theme that a file says.
fn theme(file: File) -> Result<Theme, ThemeError> {
    let given = colors("colors", file.colors)?;
    let base = match file.based_on {
        Some(name) => find(&name).ok_or(ThemeError::UnknownBase(name))?,
        None => base(given[index(Role::Background)]),
    };
    let mut theme = Theme { name: "user", about: "from a file", ..base.clone() };
    for (key, size) in file.text.0 {
        let kind = known("text", key, &TextKind::ALL.map(|kind| (kind.name(), kind)))?;
        theme.text = theme.text.with(kind, within(&format!("text.{}", kind.name()), size, TypeSizes::RANGE)?);
    }
    for (key, width) in file.stroke.0 {
        let kind = known("stroke", key, &LineKind::ALL.map(|kind| (kind.name(), kind)))?;
        let width = within(&format!("stroke.{}", kind.name()), width, Strokes::RANGE)?;
        theme.strokes = theme.strokes.with(kind, width);
    }
    if let Some(opacity) = file.fill_opacity {
        theme.fill_opacity = within("fill_opacity", opacity, (0.0, 1.0))?;
        theme.dark = theme.dark.map(|dark| Side { fill_opacity: opacity, ..dark });
    }
    let Theme { colors: own, words, fill_opacity, .. } = theme;
    let light = with(Side { colors: own, words, fill_opacity }, &given);
    (theme.colors, theme.words) = (light.colors, light.words);
    if let Some(written) = file.dark {
        let given = colors("dark", written)?;
        let other = theme.dark.or_else(|| THEMES.iter().find_map(|theme| theme.dark));
        let opacity = |dark: Side| file.fill_opacity.unwrap_or(dark.fill_opacity);
        theme.dark = other.map(|dark| with(Side { fill_opacity: opacity(dark), ..dark }, &given));
    }
    Ok(theme)
}

/// The colours that are given, in the order of [`Role::ALL`].
fn colors(table: &'static str, written: Written) -> Result<[Option<Color>; 10], ThemeError> {
    let mut colors = [None; 10];
    for (role, written) in written.0 {
        let known = known(table, role.clone(), &Role::ALL.map(|role| (role.name(), role)))?;
        let color = color(&written).ok_or(ThemeError::NotAColor { table, role, written })?;
        colors[index(known)] = Some(color);
    }
    Ok(colors)
}

/// What a key of a table means.
fn known<T: Copy>(table: &'static str, key: String, all: &[(&'static str, T)]) -> Result<T, ThemeError> {
    let found = all.iter().find(|(name, _)| *name == key).map(|&(_, what)| what);
    let known = || all.iter().map(|&(name, _)| name).collect();
    found.ok_or_else(|| ThemeError::UnknownKey { table, key, known: known() })
}

/// A number that is within its bounds.
fn within(key: &str, got: f64, (least, most): (f64, f64)) -> Result<f64, ThemeError> {
    if (least..=most).contains(&got) {
        return Ok(got);
    }
    Err(ThemeError::OutOfRange { key: key.to_owned(), got, least, most })
}

/// A side with the given colours in place of its own, and the others out of their way.
fn with(mut side: Side, given: &[Option<Color>; 10]) -> Side {
    for (own, given) in side.colors.iter_mut().zip(given) {
        *own = given.unwrap_or(*own);
    }
    adapted(side, |role| given[index(role)].is_some())
}

/// The theme of the house that is taken for a page of this colour where the file names none; the default
/// where it has no page of its own.
fn base(page: Option<Color>) -> &'static Theme {
    let is_dark = |page: Color| contrast(page, Color::hex(0xFF_FFFF)) > contrast(page, Color::hex(0));
    let alike = |theme: &&Theme| page.is_some_and(|p| is_dark(p) == is_dark(theme.color(Role::Background)));
    THEMES.iter().find(alike).unwrap_or(&THEMES[0])
}

/// The colour of `#RRGGBB` or `#RGB`; `None` for anything else.
fn color(written: &str) -> Option<Color> {
    let digits = written.strip_prefix('#').filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit()))?;
    let rgb = u32::from_str_radix(digits, 16).ok()?;
    match digits.len() {
        6 => Some(Color::hex(rgb)),
        3 => {
            Some(Color::hex([rgb >> 8, rgb >> 4, rgb].iter().fold(0, |all, d| (all << 8) | ((d & 15) * 17))))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::vision::worst_difference;
    use super::*;

    #[test]
    fn what_is_wrong_with_a_theme_file_is_named() {
        let said = |text: &str| parse(text).unwrap_err().to_string();
        assert!(said("based_on = \"lite\"").contains("light, dark, print, auto, got `lite`"));
        assert!(said("[colors]\nc = \"#000000\"").contains("got `c`"));
        assert!(said("[dark]\nc = \"#000000\"").contains("got `c`"));
        for written in ["red", "#12345", "#+123", "123456", "#1234567", ""] {
            let text = format!("[colors]\na = {written:?}");
            assert!(said(&text).contains(&format!("`#RGB`, got `{written}`")), "{}", said(&text));
        }
        assert!(said("colour = 1").contains("colour"));
        assert_eq!(said("fill_opacity = 2"), "fill_opacity: expected 0 to 1, got 2");
        assert_eq!(said("text.name = 10.5"), "text.name: expected 11 to 40, got 10.5");
        assert_eq!(said("stroke.outline = nan"), "stroke.outline: expected 0.5 to 8, got NaN");
        assert!(
            said("text.word = 12").starts_with("text: expected one of name, point, note, small, title, ")
        );
        assert!(said("stroke.line = 1").contains("dimension, axes, grid, got `line`"));
    }

    #[test]
    fn three_digits_stand_for_six() {
        let theme = parse("[colors]\na = '#1b9'").unwrap();
        assert_eq!(theme.color(Role::A), Color::hex(0x11_BB99));
    }

    #[test]
    fn a_dark_page_alone_makes_a_dark_theme() {
        let on = |page: &str| parse(&format!("[colors]\nbackground = '{page}'")).unwrap();
        assert_eq!(on("#101010").color(Role::Ink), find("dark").unwrap().color(Role::Ink));
        assert_eq!(on("#FFF8E7").color(Role::Ink), find("light").unwrap().color(Role::Ink));
    }

    #[test]
    fn what_is_not_given_moves_out_of_the_way_of_what_is() {
        let theme = parse("[colors]\na = '#0B5FCC'\nb = '#7FB2F0'").unwrap();
        let apart = |p, q| worst_difference(theme.color(p), theme.color(q));
        let house = &THEMES[0];
        assert!(worst_difference(house.color(Role::Translation), theme.color(Role::A)) < 1.0);
        assert!(apart(Role::Translation, Role::A) >= 9.0 && apart(Role::Translation, Role::B) >= 9.0);
        assert_eq!(theme.color(Role::Now), house.color(Role::Now), "in nobody's way");
        assert_eq!(parse("").unwrap().colors, house.colors);
    }

    #[test]
    fn a_dark_side_is_a_theme_that_follows_the_reader() {
        let theme = parse("[colors]\na = '#9A1620'\n[dark]\na = '#FFB0A0'").unwrap();
        let dark = theme.dark.unwrap();
        assert_eq!(dark.colors[0], Color::hex(0xFF_B0A0));
        assert_eq!(dark.colors[9], find("dark").unwrap().color(Role::Background));
        assert_eq!(theme.color(Role::A), Color::hex(0x9A_1620));
    }
}
