//! What is said of a figure behind its word: `alt="Two circles" width=60%`.

use tracefig::figure::theme;

/// How a figure is to stand in its page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Attributes {
    /// The alternative text, as markup; else the scene's, or one made from the answer.
    pub(crate) alt: Option<String>,
    /// How wide it is at most, in CSS; else as wide as its page says.
    pub(crate) width: Option<String>,
    /// The theme that it keeps on every page, a word or a file; else it follows the book.
    pub(crate) theme: Option<String>,
    /// Whether the scene itself is shown before it.
    pub(crate) source: bool,
    /// Whether a reader may drag it where scripts run.
    pub(crate) live: bool,
    /// Whether it is the question of an exercise with the key folded away behind it.
    pub(crate) exercise: bool,
}

/// Every attribute, with what it takes.
const KNOWN: [(&str, &str); 6] = [
    ("alt", "a text in quotes"),
    ("exercise", "nothing"),
    ("live", "nothing"),
    ("source", "nothing"),
    ("theme", "the name of a theme, or a theme file"),
    ("width", "page pixels, as 400, or a share of the page, as 60%"),
];

impl Attributes {
    /// Reads what stands behind the word, pairs and words between blanks or commas.
    ///
    /// # Errors
    /// In a sentence: a word that is no attribute, a value that it does not take, a quote without an end.
    pub(crate) fn read(text: &str) -> Result<Self, String> {
        let mut read = Self::default();
        for (key, value) in pairs(text)? {
            let Some((_, takes)) = KNOWN.iter().find(|(known, _)| *known == key) else {
                let known: Vec<&str> = KNOWN.iter().map(|(known, _)| *known).collect();
                return Err(format!("unknown attribute `{key}`; there are {}", known.join(", ")));
            };
            let wrong = || format!("`{key}` takes {takes}");
            match (key.as_str(), value) {
                ("alt", Some(value)) => read.alt = Some(value),
                ("exercise", None) => read.exercise = true,
                ("live", None) => read.live = true,
                ("source", None) => read.source = true,
                ("theme", Some(value)) => read.theme = Some(named_theme(value)?),
                ("width", Some(value)) => read.width = Some(width(&value).ok_or_else(wrong)?),
                _ => return Err(wrong()),
            }
        }
        if read.exercise && read.live {
            return Err("a figure is `live` or an `exercise`: dragged, a question would answer".to_owned());
        }
        Ok(read)
    }
}

/// The keys in their order, each with its value if it has one.
fn pairs(text: &str) -> Result<Vec<(String, Option<String>)>, String> {
    let gap = |c: char| c.is_whitespace() || c == ',';
    let mut rest = text.trim_start_matches(gap);
    let mut pairs = Vec::new();
    while !rest.is_empty() {
        let end = rest.find(|c: char| gap(c) || c == '=').unwrap_or(rest.len());
        let (key, behind) = rest.split_at(end);
        let mut value = None;
        rest = behind;
        if let Some(behind) = behind.strip_prefix('=') {
            let (inner, behind) = match behind.chars().next() {
                Some(quote @ ('"' | '\'')) => {
                    behind[1..].split_once(quote).ok_or_else(|| format!("the quote of `{key}` has no end"))?
                }
                _ => behind.split_at(behind.find(gap).unwrap_or(behind.len())),
            };
            value = Some(inner.to_owned());
            rest = behind;
        }
        pairs.push((key.to_owned(), value));
        rest = rest.trim_start_matches(gap);
    }
    Ok(pairs)
}

/// A theme's name, as written.
fn named_theme(word: String) -> Result<String, String> {
    if theme::find(&word).is_some() || theme::is_file(&word) {
        return Ok(word);
    }
    let names: Vec<&str> = theme::THEMES.iter().map(|t| t.name).collect();
    Err(format!("unknown theme `{word}`; there are {}, or a file ending in .toml", names.join(", ")))
}

/// A width in CSS, from page pixels or a share of the page.
fn width(word: &str) -> Option<String> {
    let (number, unit) = match word.strip_suffix('%') {
        Some(number) => (number, "%"),
        None => (word.strip_suffix("px").unwrap_or(word), "px"),
    };
    let width: u32 = number.parse().ok()?;
    (width > 0).then(|| format!("{width}{unit}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_stand_between_blanks_or_commas_in_any_order() {
        let read = Attributes::read(r#",width=60%  alt="Two circles, apart" source live"#).unwrap();
        assert_eq!((read.width.as_deref(), read.source, read.live), (Some("60%"), true, true));
        assert_eq!(read.alt.as_deref(), Some("Two circles, apart"));
        assert_eq!(Attributes::read(" width=400px").unwrap(), Attributes::read(",width='400'").unwrap());
        assert_eq!(Attributes::read("").unwrap(), Attributes::default());
    }

    #[test]
    fn what_is_no_attribute_is_told_with_those_that_there_are() {
        let told = |text: &str| Attributes::read(text).unwrap_err();
        assert_eq!(
            told("hight=3"),
            "unknown attribute `hight`; there are alt, exercise, live, source, theme, width"
        );
        assert_eq!(told("width=wide"), "`width` takes page pixels, as 400, or a share of the page, as 60%");
        assert_eq!(told("width=0"), told("width=-3"));
        assert_eq!(told("source=yes"), "`source` takes nothing");
        assert!(told("live exercise").starts_with("a figure is `live` or an `exercise`"));
        assert_eq!(told("alt"), "`alt` takes a text in quotes");
        assert_eq!(told("alt=\"x"), "the quote of `alt` has no end");
        assert!(told("theme=drak").starts_with("unknown theme `drak`; there are light, dark,"));
    }
}
