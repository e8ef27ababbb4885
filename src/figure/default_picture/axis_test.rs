//! The shadows of both bodies on the axis with the largest gap, or the least overlap.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "axis-test",
    about: "a separating-axis test",
    fits: |case| case.count(|e| matches!(e, Event::AxisTested { .. })) > 0,
    panels: r#"
[[panels]]
layers = ["shapes", { layer = "ghosts", of = "B", at = "separated" }, "projection"]
"#,
};
