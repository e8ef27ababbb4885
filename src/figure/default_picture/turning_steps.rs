//! One body that turns on its way into the other, and what an advancement looks at: where the body is at each
//! of its steps, and how far from the other, beside the bound that says how far it may go on.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-steps",
    about: "the hit of bodies of which one moves and turns, by an advancement",
    fits: |case| case.hits() && case.turns() && case.steps() > 0 && case.movers() == 1,
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = [
  "shapes",
  { layer = "ghosts", at = "steps", numbered = true },
  { layer = "separation", at = "steps" },
  "velocity",
  "spin",
  "contact",
]

[[panels]]
title = "Separation over time"
time = "start"
layers = [{ layer = "graph", values = true }]
"#,
};

/// What a panel of configuration space shows of an advancement where a scene does not say: B ⊖ A at each of
/// its steps.
pub(super) const DIFFERENCES: Picture = Picture {
    name: "turning-differences",
    about: "a panel of configuration space, of an advancement",
    fits: |case| case.steps() > 0,
    panels: r#"
[[panels]]
space = "configuration"
layers = ["axes", { layer = "difference", at = "steps", numbers = true }, "origin"]
"#,
};
