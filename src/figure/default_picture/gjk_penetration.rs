//! Bodies that overlap, and the last polytope in B ⊖ A around the origin.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "gjk-penetration",
    about: "GJK and EPA on bodies whose cores overlap",
    fits: |case| case.overlaps() && case.count(|e| matches!(e, Event::PolytopeExpanded { .. })) > 0,
    panels: r#"
[[panels]]
title = "World"
inset = "small"
layers = [
  "shapes",
  { layer = "ghosts", of = "B", at = "separated" },
  { layer = "separation", points = true },
]

[[panels]]
title = "Configuration space"
space = "configuration"
inset = "small"
layers = ["axes", "difference", "polytope", "origin"]
"#,
};
