//! Two circles that overlap: their radii are longer than the way between the centres by the depth.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "circle-penetration",
    about: "two circles that overlap",
    fits: |case| case.overlaps() && case.count(|e| matches!(e, Event::CirclesCompared { .. })) > 0,
    panels: r#"
[[panels]]
inset = "small"
layers = [
  { layer = "shapes", centers = true },
  { layer = "ghosts", of = "B", at = "separated" },
  { layer = "radii", as = "lengths" },
  { layer = "separation", style = "bar" },
]
"#,
};
