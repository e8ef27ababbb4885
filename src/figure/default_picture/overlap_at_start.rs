//! Bodies that overlap before they move: how deep, and which way each is about to go.

use crate::collision::Outcome;
use crate::figure::layer::ruler::round_up;
use crate::geometry::Body;
use crate::scene::{LayerSpec, Spanned, Value};

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
time = "start"
inset = "small"
layers = ["shapes", { layer = "separation", points = true }, "velocity", "spin"]

[[panels]]
title = "Configuration space"
space = "configuration"
time = "start"
inset = "small"
layers = ["axes", "difference", "origin", "closest"]
"#,
};

/// Draws the velocities of fast bodies to a scale at which the bodies are seen.
pub(super) fn slow_down(layer: &mut LayerSpec, case: &Case) {
    if !(PICTURE.fits)(case) || layer.name.value != "velocity" {
        return;
    }
    let (bodies, span) = (&case.scene.query.of, &layer.name.span);
    let bodies = || bodies.iter().filter_map(|&i| case.scene.shapes.get(i)).map(|(_, body)| body);
    let reach: f64 = bodies().map(|Body { shape, .. }| shape.hull.reach + shape.radius).sum();
    let fastest = bodies().map(|body| body.velocity.length()).fold(0.0, f64::max);
    if let Some(scale) = round_up(DRAWN * (reach / fastest)).filter(|_| fastest > FAST * reach) {
        let key = Spanned { value: "scale".to_owned(), span: span.clone() };
        let scale = Spanned { value: Value::Number(scale), span: span.clone() };
        layer.options.push((key, scale));
    }
}
