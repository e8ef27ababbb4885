//! Bodies that touch, and the edges, planes and depths of their points of contact.

use crate::trace::Event;

use super::{Case, Picture};

pub(super) const PICTURE: Picture = Picture {
    name: "contact-points",
    about: "points of contact by clipping",
    fits: clipped,
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

/// What a panel of bodies that touch shows where a scene does not say: all of it in one.
pub(super) const ALONE: Picture = Picture {
    name: "contact-points-alone",
    about: "a panel of bodies, of points of contact by clipping",
    fits: clipped,
    panels: r#"
[[panels]]
layers = ["shapes", "clipping"]
"#,
};

/// Whether edges were clipped.
fn clipped(case: &Case) -> bool {
    case.count(|event| matches!(event, Event::EdgesFaced { .. })) > 0
}
