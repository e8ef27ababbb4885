//! Pictures of a figure in time that become files of their own.

use std::path::{Path, PathBuf};

use tracefig::drawing::Drawing;

use super::in_time::InTime;
use super::jobs::{Planned, Target};

/// Digits of the number of a step or picture, at least, so that names sort.
const DIGITS: usize = 2;

/// One picture of a figure in time, for a file of its own.
pub(crate) struct OnePicture {
    /// What it shows.
    pub(crate) drawing: Drawing,
    /// Where it goes.
    pub(crate) target: Target,
    /// What tells it apart in a hash.
    pub(crate) key: String,
}

/// The pictures of a drawing that become files of their own; none where the file of the plan holds what there
/// is to show.
pub(crate) fn apart(
    drawing: &Drawing,
    planned: &Planned,
    in_time: Option<InTime>,
) -> Option<Vec<OnePicture>> {
    let in_time = in_time.filter(|in_time| in_time.are_apart(planned.format))?;
    let [of_all, of_one] = in_time.parts();
    let pictures = in_time.pictures(drawing);
    let digits = pictures.len().to_string().len().max(DIGITS);
    let one = |(number, drawing): (usize, Drawing)| OnePicture {
        drawing,
        target: match &planned.target {
            Target::Stdout => Target::Stdout,
            Target::File(path) => Target::File(numbered(path, of_all, (of_one, number, digits))),
        },
        key: format!(" {of_one}={number}"),
    };
    Some((1..).zip(pictures).map(one).collect())
}

/// The name of the file of a picture: `x.step-03.png` of `x.steps.png`.
fn numbered(path: &Path, of_all: &str, (of_one, number, digits): (&str, usize, usize)) -> PathBuf {
    let extension = path.extension().unwrap_or_default().to_owned();
    let mut stem = path.with_extension("");
    if stem.extension().is_some_and(|part| part == of_all) {
        stem.set_extension("");
    }
    let mut name = stem.into_os_string();
    name.push(format!(".{of_one}-{number:0digits$}."));
    name.push(extension);
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_in_the_place_of_the_word_and_sort() {
        let name = |path: &str, number, digits| {
            numbered(Path::new(path), "steps", ("step", number, digits)).display().to_string()
        };
        assert_eq!(name("a/x.steps.png", 3, 2), "a/x.step-03.png");
        assert_eq!(name("a.b/x.dark.steps.svg", 12, 3), "a.b/x.dark.step-012.svg");
        assert_eq!(name("x.svg", 1, 2), "x.step-01.svg");
    }
}
