//! Bodies that overlap before they move: how deep, and which way each is about to go.

use crate::collision::Outcome;
use crate::figure::text::round_up;
use crate::geometry::Body;
use crate::scene::{LayerSpec, Value};

use super::{Case, Picture};

/// A velocity that leads farther than so many times as far as both bodies reach is drawn shorter: the bodies
/// would be small beside their arrows, and where they go shows nothing of their overlap.
const FAST: f64 = 4.0;
/// How long the longest is drawn then at least, in how far both bodies reach.
const DRAWN: f64 = 0.75;

pub(super) const PICTURE: Picture = Picture {
    name: "overlap-at-start",
    about: "a question for the first contact of bodies that overlap from the start",
    fits: |case| matches!(case.outcome(), Some(Outcome::Overlapping { .. })),
    panels: r#"
[[panels]]
title = "World"
inset = "small"
layers = [
  "shapes",
  { layer = "ghosts", of = "B", at = "separated" },
  { layer = "velocity", scale = 1 },
  "spin",
  { layer = "separation", points = true },
]

[[panels]]
title = "Configuration space"
space = "configuration"
inset = "small"
layers = ["axes", "difference", "origin", "closest"]
"#,
};

/// Draws the velocities of fast bodies to a scale at which the bodies are seen.
pub(super) fn slow_down(layer: &mut LayerSpec, case: &Case) {
    let scales = layer.options.iter_mut().filter(|(key, _)| key.value == "scale").map(|(_, scale)| scale);
    let bodies =
        || case.scene.query.of.iter().filter_map(|&i| case.scene.shapes.get(i)).map(|(_, body)| body);
    let reach: f64 = bodies().map(|Body { shape, .. }| shape.hull.reach + shape.radius).sum();
    let fastest = bodies().map(|body| body.velocity.length()).fold(0.0, f64::max);
    if let Some(scale) = round_up(DRAWN * (reach / fastest)).filter(|_| fastest > FAST * reach) {
        scales.for_each(|drawn| drawn.value = Value::Number(scale));
    }
}
