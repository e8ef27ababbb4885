//! Two boxes with the axes: their half-extents against the distance of the centres, axis by axis.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "box-extents",
    about: "two AABBs, compared by extents",
    fits: |case| case.count(|e| matches!(e, Event::ExtentsCompared { .. })) > 0,
    panels: r#"
[[panels]]
layers = ["axis-gaps", { layer = "shapes", centers = true }, "separation"]
"#,
};
