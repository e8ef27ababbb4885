//! One step of GJK or EPA on B ⊖ A: the simplex, its point v closest to the origin, and the vertex w that is
//! farthest towards the origin and comes next; or the polytope grown around the origin.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Outline, Pen, Rank, Sketch, Wash};
use crate::geometry::DVec2;
use crate::trace::Event;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, number_of};

/// Opacity of a simplex's fill: it lies on the difference, which is filled too.
const FILL: f64 = 0.12;

pub(super) const LAYER: Layer = Layer {
    name: "simplex",
    about: "one step of GJK or EPA: the simplex, its closest point, the next vertex",
    shows: Shows::Configuration,
    options: &[OptionSpec {
        name: "step",
        takes: Takes::Number,
        default: "the last",
        about: "which simplex or polytope, from 1",
    }],
    labels: &[
        LabelKey { key: "closest", about: "the point of the simplex closest to the origin" },
        LabelKey { key: "w", about: "the vertex that comes next" },
    ],
    needs: "the algorithm \"gjk\", and no more steps than it took",
    fed: |context, options| {
        let some = context.run().events().any(|e| matches!(e, Event::SimplexUpdated { .. }));
        Fed::by_the_answer(shown(context, options).is_some(), some)
    },
    draw,
};

/// A simplex or polytope that the algorithm told.
struct Step {
    /// Its vertices, in configuration space.
    vertices: Vec<DVec2>,
    /// Its point closest to the origin, v; `None` where the origin lies in it.
    closest: Option<DVec2>,
    /// The vertex that it lacks and the next step has, w.
    next: Option<DVec2>,
}

/// The step that the scene wants; else the last.
fn shown(context: &Context, options: &Options) -> Option<Step> {
    let run = context.run();
    let all: Vec<(&Vec<DVec2>, Option<DVec2>)> = run
        .told(|event| match event {
            Event::SimplexUpdated { vertices, closest, .. } => Some((vertices, Some(*closest))),
            Event::PolytopeExpanded { vertices, .. } => Some((vertices, None)),
            _ => None,
        })
        .collect();
    let index = match options.number("step") {
        Some(step) => (0..all.len()).find(|&i| number_of(i + 1) == step)?,
        None => all.len().checked_sub(1)?,
    };
    let &(vertices, closest) = all.get(index)?;
    let next =
        all.get(index + 1).and_then(|(after, _)| after.iter().find(|w| !vertices.contains(w)).copied());
    Some(Step { vertices: vertices.clone(), closest: closest.filter(|v| *v != DVec2::ZERO), next })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(step) = shown(context, options) else { return };
    let role = options.role(Role::Now);
    if step.vertices.len() > 1 {
        let wash = (step.vertices.len() > 2).then(|| Wash::faint(role, FILL));
        sketch.part("simplex").area(&Outline::polygon(&step.vertices), wash, Some(Pen::highlighted(role)));
    }
    for &vertex in &step.vertices {
        sketch.part("simplex").marker(vertex, Marker::Disc, role, MARKER);
    }
    if let Some(v) = step.closest {
        let blue = Role::Translation;
        sketch.part("closest").arrow(DVec2::ZERO, v, Pen::vector(blue));
        sketch.label(Label::new("closest", "$v$", Anchor::middle(DVec2::ZERO, v), blue));
    }
    if let Some(w) = step.next {
        sketch.part("next").marker(w, Marker::RingedDisc, role, MARKER);
        sketch.label(Label::new("w", "$w$", Anchor::point(w), role).rank(Rank::Point));
    }
}
