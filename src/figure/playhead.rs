//! The playhead of a live figure: the moment that its panels show, as a reader moves it.
//!
//! A question about a moment has one of its own, and panels follow it. One about the whole motion has none:
//! there the playhead is the moment of panels that do not say another. `live.time` in the scene takes it
//! away, or gives it to the first panel of the world that is pinned to a given time.

use serde_json::{Value, json};

use crate::scene::{Panel, Scene, Space, When};

use super::question::is_of_a_moment;

/// The moment in [0, 1] that the scene gives a panel; `None` where the answer gives it.
pub(crate) fn given(panel: &Panel, scene: &Scene) -> Option<f64> {
    match panel.when.as_ref().map(|when| &when.value) {
        None if is_of_a_moment(scene.query.kind) => Some(scene.query.time),
        None | Some(When::Start) => Some(0.0),
        Some(When::End) => Some(1.0),
        Some(&When::Time(time)) => Some(time),
        Some(When::Hit | When::Closest | When::Bound | When::Step(_)) => None,
    }
}

/// The playhead as a page takes it; `None` where there is none.
pub(super) fn playhead(scene: &Scene) -> Option<Value> {
    let mut bodies = scene.query.of.iter().filter_map(|&i| scene.shapes.get(i));
    if scene.live.time == Some(false) || !bodies.any(|(_, body)| body.moves()) {
        return None;
    }
    let follow: Vec<usize> = (0..scene.panels.len()).filter(|&i| scene.panels[i].when.is_none()).collect();
    let of_panel = |i: usize| json!(["panels", i, "time"]);
    let (paths, time) = if is_of_a_moment(scene.query.kind) && (scene.panels.is_empty() || !follow.is_empty())
    {
        (vec![json!(["query", "time"])], scene.query.time)
    } else if !follow.is_empty() {
        (follow.into_iter().map(of_panel).collect(), 0.0)
    } else if scene.live.time == Some(true) {
        let world = |panel: &Panel| panel.space == Space::World;
        let pinned = |(i, panel): (usize, &Panel)| Some((i, given(panel, scene).filter(|_| world(panel))?));
        let (first, time) = scene.panels.iter().enumerate().find_map(pinned)?;
        (vec![of_panel(first)], time)
    } else {
        return None;
    };
    Some(json!({ "grip": "time", "name": "time", "paths": paths, "value": time, "range": [0.0, 1.0] }))
}
