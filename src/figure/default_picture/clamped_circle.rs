//! A circle against a box: its centre, clamped to the half-extents, is the closest point.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "clamped-circle",
    about: "a circle and a box, by clamping",
    fits: |case| case.count(|e| matches!(e, Event::Clamped { .. })) > 0,
    panels: r#"
[[panels]]
inset = "small"
layers = [
  { layer = "shapes", centers = true },
  { layer = "half-extents", style = "dimension" },
  { layer = "clamp", show = ["V", "clamped", "Bc", "D"], values = true },
  "radii",
  { layer = "separation", style = "dimension", offset = 16 },
]
"#,
};
