//! What `check` can't compare, beside scenes that can't be drawn: figures of two scenes, folders without
//! permission, and figures whose scene may be a file that was taken for none.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use tracefig::scene::{Ink, Refused};

use super::Status;
use super::checked::Checked;
use super::files::Plan;
use super::inputs::{Input, shown, unread_folder};
use super::jobs::Twins;

/// Files that two scenes would become: a finding for each, and a message for each pair.
pub(crate) fn of_twins(twins: &[Twins<'_>]) -> Checked {
    let mut checked = Checked::new();
    let mut pairs: BTreeMap<[String; 2], Vec<&Twins<'_>>> = BTreeMap::new();
    for one in twins {
        pairs.entry(one.inputs.map(Input::name)).or_default().push(one);
    }
    for files in pairs.values() {
        let Some(first) = files.first() else { continue };
        let more = match files.len() - 1 {
            0 => String::new(),
            more => format!(", and {more} more {}", if more == 1 { "file" } else { "files" }),
        };
        checked.say(&format!("error: {first}{more}: rename one of the scenes\n"));
        for one in files {
            let details = vec![format!("{one}: rename one of the scenes")];
            checked.miss_by(&one.path.display().to_string(), Status::Wrong, details);
        }
    }
    checked
}

/// Folders that were to be searched and can't be read.
pub(crate) fn of_folders(plan: &Plan) -> Checked {
    let mut checked = Checked::new();
    for (folder, error) in &plan.unread {
        let message = format!("error: {}\n", unread_folder(folder, error));
        checked.fail(&folder.display().to_string(), Status::Io, &message);
        checked.is_unread = true;
    }
    checked
}

/// A file that may be the scene of figures and was not taken for one: what is wrong with it.
pub(crate) fn of_doubtful(scene: &Path, figures: &[PathBuf], ink: Ink) -> Checked {
    let (mut checked, name) = (Checked::new(), shown(scene));
    let of = match figures {
        [one] => format!("{} stays, as its scene may be {name}", shown(one)),
        [first, rest @ ..] => {
            format!("{} and {} more stay, as their scene may be {name}", shown(first), rest.len())
        }
        [] => return checked,
    };
    let (why, message) = if let Err(refused) = Input::File(scene.to_owned()).open() {
        (summary(&refused), refused.render(ink))
    } else {
        let why = format!("{name} is no scene of this run: {}", left_out(scene));
        let message = format!("error: {why}\n");
        (why, message)
    };
    checked.say(&format!("{message}note: {of}\n"));
    checked.miss_by(&scene.display().to_string(), Status::Wrong, vec![why, of]);
    checked
}

/// The first line of what is wrong with a scene.
fn summary(refused: &Refused) -> String {
    refused.render(Ink::Plain).lines().next().unwrap_or_default().to_owned()
}

/// Why a search passes a scene by.
fn left_out(scene: &Path) -> &'static str {
    let is_small = scene.extension().is_some_and(|end| end == "toml" || end == "json");
    if is_small {
        "links to folders are not followed, and hidden folders not searched"
    } else {
        "names of scenes end in .toml or .json, in small letters"
    }
}
