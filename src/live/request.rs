//! What a live figure is opened with.

use std::borrow::Cow;

use serde_json::{Map, Value};

use super::refusal::Refusal;
use super::{faces, texts};
use crate::drawing::Role;
use crate::figure::theme::{self, Theme};

/// What a request looks like, for messages.
const EXPECTED: &str = "an object with a `scene`";

/// What every id of an SVG begins with where nobody says it.
const USUAL_ID: &str = "fig";

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
    fn read(written: Value) -> Result<Self, Refusal> {
        let mut written = Fields::of(written)?;
        let words = written.take("words").map(|words| match words {
            Value::Array(names) => names.iter().map(role).collect::<Result<Vec<_>, _>>(),
            other => Err(malformed(&other)),
        });
        written.end()?;
        Ok(Self { words: words.transpose()? })
    }
}

impl Request {
    /// Reads a request, sets with the glyphs that it brings and tells in its texts.
    pub(super) fn read(text: &str) -> Result<Self, Refusal> {
        let written = serde_json::from_str(text)
            .map_err(|error| Refusal::Malformed { expected: EXPECTED, got: error.to_string() })?;
        let mut written = Fields::of(written)?;
        let scene = written.take("scene").ok_or_else(|| malformed(&Value::Null))?;
        let id = written.take("id").map(text_of).transpose()?.unwrap_or_else(|| USUAL_ID.to_owned());
        let look = written.take("theme").map_or(Ok(Look::Own), look)?;
        let inline = written.take("inline").map(Inline::read).transpose()?;
        // What the page shows before the module is there, and in which order it copies bodies.
        for own in ["info", "bodyNames"] {
            written.take(own);
        }
        if let Some(faces) = written.take("faces") {
            faces::bring_all(&Fields::of(faces)?.0)?;
        }
        if let Some(texts) = written.take("texts") {
            texts::bring_all(texts)?;
        }
        written.end()?;
        Ok(Self { scene, id, look, inline })
    }
}

/// The entries of a table that were not taken yet.
struct Fields(Map<String, Value>);

impl Fields {
    /// The entries of a value that is a table.
    fn of(value: Value) -> Result<Self, Refusal> {
        match value {
            Value::Object(fields) => Ok(Self(fields)),
            other => Err(malformed(&other)),
        }
    }

    /// Takes an entry; nothing is as if it were not there.
    fn take(&mut self, key: &str) -> Option<Value> {
        self.0.shift_remove(key).filter(|value| !value.is_null())
    }

    /// Refuses what nobody took.
    fn end(self) -> Result<(), Refusal> {
        self.0.keys().next().map_or(Ok(()), |key| Err(malformed(&Value::String(key.clone()))))
    }
}

/// A request that has something else where it should have this.
fn malformed(got: &Value) -> Refusal {
    Refusal::Malformed { expected: EXPECTED, got: got.to_string() }
}

/// A value that is a text.
fn text_of(value: Value) -> Result<String, Refusal> {
    if let Value::String(text) = value { Ok(text) } else { Err(malformed(&value)) }
}

/// The role of a name.
fn role(name: &Value) -> Result<Role, Refusal> {
    let found = Role::ALL.into_iter().find(|role| name == role.name());
    found.ok_or_else(|| Refusal::Malformed { expected: "roles of words", got: name.to_string() })
}

/// A theme that a request names or gives: one of the house by its name, or one of a user's own, its file with
/// what stands for it in the hash of a figure.
fn look(written: Value) -> Result<Look, Refusal> {
    let (theme, key) = match written {
        Value::String(name) => match theme::find(&name) {
            Some(theme) => (Cow::Borrowed(theme), name),
            None => return Err(Refusal::Theme { reason: format!("there is none called `{name}`") }),
        },
        own => {
            let mut own = Fields::of(own)?;
            let key = own.take("key").ok_or_else(|| malformed(&Value::Null)).and_then(text_of)?;
            let theme = theme::of_json(&own.take("file").unwrap_or_default());
            own.end()?;
            (Cow::Owned(theme.map_err(|error| Refusal::Theme { reason: error.to_string() })?), key)
        }
    };
    Ok(Look::Given { theme: Box::new(theme), key })
}
