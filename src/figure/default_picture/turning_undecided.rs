//! Bodies that turn and of which nobody knows whether they meet: where they begin, and where the proof ends.

use crate::collision::Outcome;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-undecided",
    about: "an undecided question for the first contact of bodies that turn; its \
            end is the time until which they are apart",
    fits: |case| case.turns() && matches!(case.outcome(), Some(Outcome::Unresolved { .. })),
    panels: r#"
[[panels]]
time = "start"
layers = ["shapes", { layer = "ghosts", at = "end" }, "velocity", "spin"]
"#,
};
