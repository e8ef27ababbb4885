//! Directions that text may name, in the frame of the panel: its numbers say what its picture shows.

use crate::figure::context::Context;
use crate::geometry::{DVec2, Rotation};
use crate::trace::Event;

use super::quantity::Quantity;

/// The part of a vector's length up to which a component of it, turned into a frame, is rounding: the vector,
/// the cosine and the sine are off by a few ε each. Ten times as much would still be written as 0.
const ROUNDED: f64 = 16.0 * f64::EPSILON;

/// The unit normal from A to B at the panel's moment, as the panel shows it.
pub(super) fn normal(context: &Context) -> Option<DVec2> {
    let run = context.separation_at(context.time)?;
    Some(in_panel(context, *run.separation()?.normal))
}

/// The unit normal from A to B at the first contact, as the panel shows it.
pub(super) fn hit_normal(context: &Context) -> Option<DVec2> {
    let (_, contact) = context.hit()?;
    Some(in_panel(context, *contact.normal))
}

/// What `pick` takes of the article's N and P, as the panel shows them.
pub(super) fn penetration(context: &Context, pick: fn([DVec2; 2]) -> f64) -> Option<Quantity> {
    let [n, p] = context.run().find_told(|event| match event {
        Event::PenetrationMeasured { direction, vector, .. } => Some([*direction, *vector]),
        _ => None,
    })?;
    Some(Quantity::exactly(pick([n, p].map(|v| in_panel(context, v)))))
}

/// What `pick` takes of D.
pub(super) fn d(context: &Context, pick: fn(DVec2) -> f64) -> Option<Quantity> {
    context.run().find_told(|event| match event {
        Event::Clamped { d, .. } => Some(Quantity::exactly(pick(in_panel(context, *d)))),
        Event::ExtentsCompared { gap, .. } => Some(Quantity::exactly(pick(*gap))),
        _ => None,
    })
}

/// A vector of the world at the panel's moment in the frame of the panel, as long as it is.
#[must_use]
pub(crate) fn in_panel(context: &Context, v: DVec2) -> DVec2 {
    let Some(Rotation { cos, sin }) = context.frame().map(|frame| frame.rotation) else { return v };
    // A matrix that is no rotation makes it no longer.
    let turned = Rotation { cos, sin }.undo(v) / libm::hypot(cos, sin);
    let least = ROUNDED * v.length();
    DVec2::from([turned.x, turned.y].map(|c| if c.abs() <= least { 0.0 } else { c }))
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::figure::text::value_of;
    use crate::scene::open_text;

    #[test]
    fn in_the_panel_of_a_body_directions_are_those_of_its_frame() {
        let told = |asked: &str, names: &[&str]| {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [2, 1], angle_deg = 90, velocity = [4, 0] }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [5, 0] }}
                query = {{ of = ['A', 'B'], {asked} }}
                panels = [{{ layers = ['shapes'] }}, {{ space = 'body', frame = 'A', layers = ['shapes'] }}]"
            );
            let scene = open_text("frames.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let of = |name: &str, k: usize| value_of(name, &plan.panels[k].context(&scene, &plan.runs));
            [0, 1].map(|k| names.iter().map(|name| of(name, k).unwrap().lo).collect::<Vec<_>>())
        };
        let still = told("kind = 'separation', algorithm = 'clamp'", &["n.x", "n.y", "D.x", "D.y"]);
        assert_eq!(still, [[1.0, 0.0, 4.0, 0.0], [0.0, -1.0, 0.0, -4.0]]);
        let hit = told("kind = 'linear-sweep'", &["hit.n.x", "hit.n.y"]);
        assert_eq!(hit, [[1.0, 0.0], [0.0, -1.0]]);
    }
}
