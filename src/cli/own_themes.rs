//! Theme files that scenes name: each is read once, and one that is none is quoted where it is wrong.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use tracefig::figure::{Fault, theme};
use tracefig::scene::{Ink, Problem, Refused, SceneFile, Source, visible};

use super::inputs::Input;
use super::themes::{ChosenTheme, NoTheme, from_file};

/// The theme files that scenes name, each read once.
#[derive(Default)]
pub(crate) struct OwnThemes(Mutex<BTreeMap<PathBuf, Arc<ChosenTheme>>>);

impl Clone for OwnThemes {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// Why a scene does not have the theme file that it names.
pub(crate) struct NoOwnTheme {
    /// What the scene calls it.
    pub(crate) theme: String,
    /// What is wrong, in a line.
    pub(crate) said: String,
    /// The message, which quotes the theme file, or the scene where there is none to quote.
    pub(crate) message: String,
}

impl OwnThemes {
    /// The theme of the file that a scene names, from the folder that the scene lies in or, where it comes
    /// from standard input, from the working directory; `None` where it names none, or one of the house.
    ///
    /// # Errors
    /// Where the file can't be read or is no theme, in a message with `ink`.
    pub(crate) fn of(
        &self,
        file: &SceneFile,
        input: &Input,
        ink: Ink,
    ) -> Result<Option<Arc<ChosenTheme>>, NoOwnTheme> {
        let Some(asked) = file.scene.canvas.theme.as_ref().filter(|t| theme::is_file(&t.value)) else {
            return Ok(None);
        };
        let refuse = |none: NoTheme| {
            let (theme, said) = (visible(&asked.value).into_owned(), none.to_string());
            let at = asked.span.clone();
            let message = match none {
                NoTheme::File(refused) => refused.render(ink) + &named_at(&file.source, at.start),
                NoTheme::Said(reason) => {
                    let fault = Fault::BadTheme { name: asked.value.clone(), reason };
                    let problems = vec![Problem::new(fault, at)];
                    Refused { source: file.source.clone(), problems }.render(ink)
                }
            };
            NoOwnTheme { theme, said: visible(&said).into_owned(), message }
        };
        let named = Path::new(&asked.value);
        if named.has_root() || named.is_absolute() {
            return Err(refuse(NoTheme::Said("expected a path from the scene's own folder".to_owned())));
        }
        let folder = match input {
            Input::File(path) => path.parent().unwrap_or(Path::new("")),
            Input::Stdin | Input::Line { .. } => Path::new(""),
        };
        let path = folder.join(named);
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(theme) = known.get(&path) {
            return Ok(Some(Arc::clone(theme)));
        }
        let theme = Arc::new(from_file(folder, &asked.value).map_err(refuse)?);
        known.insert(path, Arc::clone(&theme));
        Ok(Some(theme))
    }
}

/// Which line of which scene names the theme file that a message quotes.
fn named_at(scene: &Source, start: usize) -> String {
    let place = scene.place(start);
    format!("  named at {}:{}:{}\n", visible(&scene.name), place.line, place.column)
}
