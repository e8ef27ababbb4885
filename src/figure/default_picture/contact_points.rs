//! Bodies that touch, and the edges, planes and depths of their points of contact.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "contact-points",
    about: "points of contact by clipping",
    fits: |case| case.count(|e| matches!(e, Event::EdgesFaced { .. })) > 0,
    panels: r#"
[[panels]]
title = "Between the reference edge's ends"
layers = ["shapes", { layer = "clipping", show = ["edges", "planes", "cut"] }]

[[panels]]
title = "Points of contact"
inset = "small"
layers = ["shapes", { layer = "clipping", show = ["edges", "cut", "depths"] }]
"#,
};
