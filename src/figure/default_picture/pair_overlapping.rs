//! Bodies that overlap: the shortest push that parts them, and the origin inside of B ⊖ A.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "pair-overlapping",
    about: "two bodies that overlap",
    fits: |case| case.overlaps(),
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
layers = ["axes", "difference", "origin", "closest"]
"#,
};
