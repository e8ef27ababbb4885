//! Bodies that turn and do not meet: at the start, and where they are closest.

use crate::collision::Outcome;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-miss",
    about: "a miss of bodies that turn",
    fits: |case| case.turns() && matches!(case.outcome(), Some(Outcome::Miss)),
    panels: r#"
[[panels]]
time = "start"
inset = "small"
layers = ["shapes", "approach", "velocity", "spin"]
"#,
};
