//! The arc of the farthest point of a body that turns in its place, and its measures.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-turn",
    about: "the motion bound of a body that turns in its place",
    fits: |case| {
        case.scene.query.of.len() == 1 && case.bounded(|theta, way| theta > 0.0 && way == 0.0) == Some(1)
    },
    panels: r#"
[[panels]]
time = "start"
layers = ["shapes", { layer = "ghosts", at = "end" }, { layer = "arc", sector = true }]
"#,
};
