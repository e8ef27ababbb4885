//! What a live figure is opened with.

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::Value;

use super::refusal::Refusal;
use crate::drawing::Role;
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
    /// How it stands inside a page; without it, it is a file.
    inline: Option<WrittenInline>,
}

/// How a picture stands inside a page, as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenInline {
    /// The roles whose words have a colour of their own, where the page's style sheet sets all colours.
    words: Option<Vec<String>>,
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
    /// How the picture stands inside a page; `None` where it is a file.
    pub(super) inline: Option<Inline>,
}

/// How a picture stands inside a page.
#[derive(Clone, Debug)]
pub(super) struct Inline {
    /// The roles whose words have a colour of their own, where the page's style sheet sets all colours and
    /// says when it is dark; `None` where the picture has its own.
    pub(super) words: Option<Vec<Role>>,
}

impl Inline {
    /// Reads how a picture stands inside a page.
    fn read(written: &WrittenInline) -> Result<Self, Refusal> {
        let roles = |names: &Vec<String>| names.iter().map(|name| role(name)).collect();
        Ok(Self { words: written.words.as_ref().map(roles).transpose()? })
    }
}

impl Request {
    /// Reads a request.
    pub(super) fn read(text: &str) -> Result<Self, Refusal> {
        let written: Written = serde_json::from_str(text)
            .map_err(|error| Refusal::Malformed { expected: EXPECTED, got: error.to_string() })?;
        let id = written.id.unwrap_or_else(|| USUAL_ID.to_owned());
        let look = written.theme.map_or(Ok(Look::Own), look)?;
        let inline = written.inline.as_ref().map(Inline::read).transpose()?;
        Ok(Self { scene: written.scene, id, look, inline })
    }
}

/// The role of a name.
fn role(name: &str) -> Result<Role, Refusal> {
    let found = Role::ALL.into_iter().find(|role| role.name() == name);
    found.ok_or_else(|| Refusal::Malformed { expected: "roles of words", got: format!("`{name}`") })
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
