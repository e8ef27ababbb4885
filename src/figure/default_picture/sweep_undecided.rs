//! A sweep without turning of which nobody knows whether it touches: where the bodies begin, and where the
//! proof ends.

use crate::collision::Outcome;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "sweep-undecided",
    about: "an undecided question for the first contact of bodies that do not turn; its \
            end is the time until which they are apart",
    fits: |case| matches!(case.outcome(), Some(Outcome::Unresolved { .. })),
    panels: r#"
[[panels]]
title = "World"
time = "start"
layers = ["shapes", { layer = "ghosts", at = "end" }, "velocity"]

[[panels]]
title = "Configuration space"
space = "configuration"
time = "start"
layers = ["axes", "difference", "ray", "origin"]
"#,
};
