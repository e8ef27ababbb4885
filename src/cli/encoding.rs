//! From a drawing to the bytes of a file, and what is said of those that can't be.

use tracefig::drift::fingerprint;
use tracefig::figure::{Fault, off_page};
use tracefig::output::{OutputError, short_id};
use tracefig::scene::{Ink, Problem, Refused, SceneFile, message, visible};

use super::inputs::Input;
use super::jobs::{Job, Planned, Target};

/// Adds the messages of warnings.
pub(crate) fn warn(file: &SceneFile, warnings: &[Problem<Fault>], ink: Ink, messages: &mut String) {
    for warning in warnings {
        messages.push_str(&message(&file.source, warning, warning.fault.severity(), ink));
    }
}

/// What the ids and classes of a figure begin with, so that several can stand in one page: made of the
/// file's name.
pub(crate) fn figure_id(job: &Job, planned: &Planned) -> String {
    let stem = match (&planned.target, &job.input) {
        (Target::File(path), _) | (Target::Stdout, Input::File(path)) => path.file_stem(),
        (Target::Stdout, Input::Stdin | Input::Line { .. }) => None,
    };
    let name = stem.map_or("stdin".into(), |s| s.to_string_lossy());
    short_id(u128::from_str_radix(&fingerprint(&name, "id"), 16).unwrap_or(0))
}

/// The message of a file that a format can't make.
pub(crate) fn cant_encode(file: &SceneFile, planned: &Planned, error: &OutputError, ink: Ink) -> String {
    if let OutputError::NotFinite { outer, group } = error {
        let problems = vec![off_page(&file.scene, outer, group)];
        return Refused { source: file.source.clone(), problems }.render(ink);
    }
    format!("error: can't write {} as {}: {error}\n", visible(&file.source.name), planned.format.name)
}
