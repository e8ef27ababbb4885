//! What a live figure is opened with.

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::Value;

use super::refusal::Refusal;
use crate::figure::theme::{self, Theme};

/// What a request looks like, for messages.
const EXPECTED: &str = "an object with a `scene`";

/// What every id of an SVG begins with where nobody says it.
const USUAL_ID: &str = "fig";

/// A request as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    /// The scene.
    scene: Value,
    /// What every id of the SVG begins with.
    id: Option<String>,
    /// The theme.
    theme: Option<WrittenTheme>,
}

/// A theme as it is written.
#[derive(Deserialize)]
#[serde(untagged)]
enum WrittenTheme {
    /// One of the house by its name.
    House(String),
    /// One of a user's own.
    Own {
        /// What stands for it in the hash of a figure.
        key: String,
        /// Its file.
        file: Value,
    },
}

/// How a figure is to look.
#[derive(Clone, Debug)]
pub(super) enum Look {
    /// In the theme that its scene says.
    Own,
    /// In a given theme.
    Given {
        /// The theme.
        theme: Box<Cow<'static, Theme>>,
        /// What stands for it in the hash of a figure.
        key: String,
    },
}

/// What a live figure is opened with.
pub(super) struct Request {
    /// The scene as JSON.
    pub(super) scene: Value,
    /// What every id of the SVG begins with.
    pub(super) id: String,
    /// The theme.
    pub(super) look: Look,
}

impl Request {
    /// Reads a request.
    pub(super) fn read(text: &str) -> Result<Self, Refusal> {
        let written: Written = serde_json::from_str(text)
            .map_err(|error| Refusal::Malformed { expected: EXPECTED, got: error.to_string() })?;
        let id = written.id.unwrap_or_else(|| USUAL_ID.to_owned());
        let look = written.theme.map_or(Ok(Look::Own), look)?;
        Ok(Self { scene: written.scene, id, look })
    }
}

/// A theme that a request names.
fn look(written: WrittenTheme) -> Result<Look, Refusal> {
    let (theme, key) = match written {
        WrittenTheme::House(name) => match theme::find(&name) {
            Some(theme) => (Cow::Borrowed(theme), name),
            None => return Err(Refusal::Theme { reason: format!("there is none called `{name}`") }),
        },
        WrittenTheme::Own { key, file } => match theme::of_json(&file) {
            Ok(theme) => (Cow::Owned(theme), key),
            Err(error) => return Err(Refusal::Theme { reason: error.to_string() }),
        },
    };
    Ok(Look::Given { theme: Box::new(theme), key })
}
