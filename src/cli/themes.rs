//! Themes as commands take them: words for those of the house, and files.

use std::fmt;
use std::path::{Path, PathBuf};

use tracefig::figure::theme::{self, Theme, ThemeError};
use tracefig::scene::limits::MAX_FILE_BYTES;
use tracefig::scene::{self, Problem, Refused, Source, visible};

use super::inputs::shown;
use super::regular::read_regular;

/// A theme of the house, or one from a file.
#[derive(Clone, Debug)]
pub(crate) struct ChosenTheme {
    /// The word for it; for a file the stem of its name.
    pub(crate) name: String,
    /// The colours.
    pub(crate) theme: Theme,
    /// What tells it apart in a hash: the name, or the file's text.
    pub(crate) key: String,
    /// The file; `None` for one of the house.
    pub(crate) file: Option<PathBuf>,
    /// What asked for it, by which it can be read again.
    pub(crate) asked: String,
}

impl ChosenTheme {
    /// One of the house.
    pub(crate) fn of_the_house(theme: &Theme) -> Self {
        let (name, key) = (theme.name.to_string(), theme.name.to_string());
        Self { asked: name.clone(), name, theme: theme.clone(), key, file: None }
    }
}

/// A theme of the command line.
#[derive(Clone, Debug)]
pub(crate) struct AskedTheme {
    /// What asks for it.
    asked: String,
    /// The theme, or what is wrong with the text of its file, which is no fault of the command.
    pub(crate) theme: Result<ChosenTheme, Box<Refused>>,
}

impl AskedTheme {
    /// A theme as written on the command line.
    ///
    /// # Errors
    /// Where the word is none, or the file can't be read.
    pub(crate) fn read(text: &str) -> Result<Self, String> {
        let theme = match theme_in(Path::new(""), text) {
            Ok(theme) => Ok(theme),
            Err(NoTheme::File(refused)) => Err(refused),
            Err(said) => return Err(said.to_string()),
        };
        Ok(Self { asked: text.to_owned(), theme })
    }

    /// The file; `None` for one of the house.
    pub(crate) fn file(&self) -> Option<&Path> {
        let side = theme::dark_side_of(&self.asked);
        theme::is_file(&self.asked).then(|| Path::new(side.unwrap_or(&self.asked)))
    }

    /// Reads its file anew.
    ///
    /// # Errors
    /// Where it was a theme and is none any more.
    pub(crate) fn again(&self) -> Result<Self, String> {
        let Some(file) = self.file() else { return Ok(self.clone()) };
        let told = |error: String| format!("{}: {error}", shown(file));
        match (Self::read(&self.asked).map_err(told)?, &self.theme) {
            (Self { theme: Err(refused), .. }, Ok(_)) => Err(told(NoTheme::File(refused).to_string())),
            (read, _) => Ok(read),
        }
    }
}

/// A theme by its word, or from a file whose path is relative to a folder.
pub(crate) fn theme_in(folder: &Path, text: &str) -> Result<ChosenTheme, NoTheme> {
    if let Some(known) = theme::find(text) {
        return Ok(ChosenTheme::of_the_house(known));
    }
    if theme::is_file(text) {
        return from_file(folder, text);
    }
    let names: Vec<&str> = theme::THEMES.iter().map(|t| t.name).collect();
    Err(NoTheme::Said(format!("expected one of {}, or a file ending in .toml", names.join(", "))))
}

/// Why there is no such theme.
pub(crate) enum NoTheme {
    /// The word is none, or the file can't be read.
    Said(String),
    /// The file is no theme.
    File(Box<Refused>),
}

impl fmt::Display for NoTheme {
    /// In a line: what is wrong with a file comes with its place there, and the nearest word where one is.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Said(said) => f.write_str(said),
            Self::File(refused) => {
                let Refused { source, problems } = &**refused;
                let Some(Problem { fault, span }) = problems.first() else { return Ok(()) };
                let (place, help) = (source.place(span.start), fault.help());
                write!(f, "{}:{}:{}: {fault}", source.name, place.line, place.column)?;
                help.map_or(Ok(()), |help| write!(f, "; {help}"))
            }
        }
    }
}

/// A theme file that is none, as messages show it.
fn refused(path: &Path, text: &str, error: &ThemeError) -> Refused {
    let source = Source::new(&path.display().to_string(), text);
    let words = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect();
    let fault = match error {
        // The reader's own message quotes the line, which stands below ours.
        ThemeError::Malformed(message) => {
            scene::Fault::Syntax { message: message.trim_end().lines().last().unwrap_or_default().to_owned() }
        }
        ThemeError::UnknownBase(name) => {
            let names: Vec<&str> = theme::THEMES.iter().map(|theme| theme.name).collect();
            scene::Fault::UnknownWord { what: "theme", got: name.clone(), known: words(&names) }
        }
        ThemeError::UnknownKey { table, key, known } => {
            scene::Fault::UnknownKey { key: key.clone(), place: format!("`[{table}]`"), known: words(known) }
        }
        ThemeError::NotAColor { table, role, written } => scene::Fault::WrongType {
            key: format!("{table}.{role}"),
            expected: "`#RRGGBB` or `#RGB`".to_owned(),
            got: format!("`{written}`"),
        },
        ThemeError::OutOfRange { key, got, least, most } => scene::Fault::OutOfRange {
            key: key.clone(),
            expected: format!("a number from {least} to {most}"),
            got: got.to_string(),
        },
    };
    Refused { source, problems: vec![Problem::new(fault, error.place(text))] }
}

/// The theme in a file, or its dark side alone, by what asks for it in a folder.
pub(crate) fn from_file(folder: &Path, asked: &str) -> Result<ChosenTheme, NoTheme> {
    let dark_side = theme::dark_side_of(asked);
    let path = folder.join(dark_side.unwrap_or(asked));
    let bytes = read_regular(&path, MAX_FILE_BYTES).map_err(|e| NoTheme::Said(e.to_string()))?;
    if bytes.len() > MAX_FILE_BYTES {
        return Err(NoTheme::Said(format!("expected at most {MAX_FILE_BYTES} bytes")));
    }
    let mut key = String::from_utf8(bytes).map_err(|e| NoTheme::Said(e.to_string()))?;
    let none = |error| NoTheme::File(Box::new(refused(&path, &key, &error)));
    let mut theme = theme::parse(&key).map_err(none)?;
    let mut name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    if let Some(file) = dark_side {
        let none = || NoTheme::Said(format!("{} has no table `[dark]`", visible(file)));
        theme = theme.in_the_dark().ok_or_else(none)?;
        let side = asked.strip_prefix(file).unwrap_or_default();
        name.push_str(&side.replace('#', "-"));
        key.push_str(side);
    }
    Ok(ChosenTheme { name, theme, key, file: Some(path), asked: folder.join(asked).display().to_string() })
}

/// Each theme once; the error is of two with one name, whose files would be one.
pub(crate) fn each_once(themes: &[ChosenTheme]) -> Result<Vec<ChosenTheme>, String> {
    let mut once: Vec<ChosenTheme> = Vec::new();
    for theme in themes {
        match once.iter().find(|other| other.name == theme.name) {
            Some(other) if other.key != theme.key => {
                let name = visible(&theme.name);
                return Err(format!("two themes are called `{name}`, and their files would be one"));
            }
            Some(_) => {}
            None => once.push(theme.clone()),
        }
    }
    Ok(once)
}
