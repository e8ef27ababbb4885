//! The box around one body or two, with its corners, its half-extents and the vertices that touch it.

use crate::collision::Answer;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounding-box",
    about: "the bounds of one body or two",
    fits: |case| matches!(case.run.answer, Answer::Bounds(_)),
    panels: r#"
[[panels]]
layers = ["shapes", "bounds", { layer = "half-extents", style = "bar" }]
"#,
};
