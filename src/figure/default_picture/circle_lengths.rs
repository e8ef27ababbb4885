//! Two circles apart: what the way between the centres is longer than both radii.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "circle-lengths",
    about: "two circles apart",
    fits: |case| case.count(|e| matches!(e, Event::CirclesCompared { .. })) > 0,
    panels: r#"
[[panels]]
inset = "small"
layers = [
  { layer = "shapes", centers = true },
  { layer = "radii", as = "lengths" },
  { layer = "separation", style = "bar" },
]
"#,
};
