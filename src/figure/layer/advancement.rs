//! One step of an advancement along the ray: from the estimate to the closest point of B ⊖ A with its normal;
//! where the tangent there cuts the ray lies the new estimate, never past the surface.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Rank, Size, Sketch, Weight};
use crate::geometry::{DVec2, perp};
use crate::trace::Event;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes};

/// Drawn length of the normal, world units: shorter than the distance of the second step of figure 6.
const NORMAL: f64 = 0.5;

/// The longest that the normal is drawn, page pixels, and the shortest: bodies may be micrometres or
/// kilometres large. The tangent is stretched as much.
const READABLE: [f64; 2] = [14.0, 40.0];

/// How far the tangent reaches behind the closest point and past the ray, world units.
const TANGENT: [f64; 2] = [1.6, 0.9];

pub(super) const LAYER: Layer = Layer {
    name: "advancement",
    about: "one step: estimate, closest point, normal, tangent, new estimate",
    shows: Shows::Configuration,
    options: &[OptionSpec {
        name: "words",
        takes: Takes::Words(&["estimate", "closest", "next", "tangent"]),
        default: "all",
        about: "which parts are named in words",
    }],
    labels: &[
        LabelKey { key: "estimate", about: "where the step starts" },
        LabelKey { key: "closest", about: "the closest point of B ⊖ A" },
        LabelKey { key: "n", about: "its normal" },
        LabelKey { key: "tangent", about: "the tangent there" },
        LabelKey { key: "next", about: "the new estimate" },
    ],
    needs: "an advancement without rotation, and a panel with a step",
    fed: |context, _| {
        let ever = context.step.is_some() && !context.steps().is_empty();
        Fed::by_the_answer(step(context).is_some(), ever)
    },
    draw,
};

/// What a step found, in configuration space.
struct Step {
    /// Where on the ray the step starts.
    estimate: DVec2,
    /// The point of B ⊖ A closest to the estimate.
    closest: DVec2,
    /// Outward unit normal of B ⊖ A.
    outward: DVec2,
    /// Where on the ray the next step starts; `None` at the last one.
    next: Option<DVec2>,
}

/// The panel's step; only of bodies that do not turn, for else the tangent does not say where the next one
/// starts.
fn step(context: &Context) -> Option<Step> {
    let wanted = context.step?;
    let v = context.closing_velocity();
    if context.turns() {
        return None;
    }
    context.run().find_told(|event| match *event {
        Event::Advanced { step, at, estimate, closest, normal, next, .. } if step == wanted => {
            // B ⊖ A rests and the estimate moves, or the estimate rests in the origin and B ⊖ A moves.
            let next = next.map(|t| if estimate == v * at.time { v * t } else { v * (t - at.time) });
            Some(Step { estimate, closest, outward: -normal, next })
        }
        _ => None,
    })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(s) = step(context) else { return };
    let [least, most] = READABLE.map(|px| sketch.px(px));
    let normal = NORMAL.max(least).min(most);
    let tangent = TANGENT.map(|reach| reach * (normal / NORMAL));
    let past = s.next.map_or(0.0, |next| next.distance(s.closest)) + tangent[1];
    let along = tangent_direction(&s, context.closing_velocity());
    let (behind, ahead) = (s.closest - along * tangent[0], s.closest + along * past);
    sketch.part("tangent").weight(Weight::Light).line(behind, ahead, Pen::construction(Role::Muted));
    sketch.part("distance").line(s.estimate, s.closest, Pen::vector(Role::Translation));
    let tip = s.closest + s.outward * normal;
    sketch.part("normal").arrow(s.closest, tip, Pen::vector(Role::B));
    sketch.part("closest").marker(s.closest, Marker::Square, Role::B, MARKER);
    sketch.part("estimate").marker(s.estimate, Marker::Disc, Role::Ink, LARGE_MARKER);
    sketch.label(Label::new("n", "$n$", Anchor::tip(s.closest, tip), Role::B));
    word(
        sketch,
        options,
        "tangent",
        Anchor::Beside { from: behind, to: s.closest, offset: 0.0 },
        Role::Muted,
    );
    word(sketch, options, "closest", Anchor::point_toward(s.closest, -s.outward), Role::B);
    word(sketch, options, "estimate", Anchor::point_toward(s.estimate, DVec2::new(-2.0, -2.0)), Role::Ink);
    if let Some(next) = s.next {
        let role = options.role(Role::A);
        sketch.part("next").marker(next, Marker::RingedDisc, role, MARKER);
        word(sketch, options, "next", Anchor::point_toward(next, DVec2::new(2.0, -2.0)), role);
    }
}

/// Along the tangent towards the ray's far end.
fn tangent_direction(s: &Step, v: DVec2) -> DVec2 {
    let along = perp(s.outward);
    if along.dot(s.next.unwrap_or(v) - s.closest) < 0.0 { -along } else { along }
}

/// Names a part in words, where the scene wants that.
fn word(sketch: &mut Sketch, options: &Options, key: &'static str, anchor: Anchor, role: Role) {
    let text = match key {
        "closest" => "closest point",
        "next" => "new estimate",
        other => other,
    };
    if options.shows("words", key, true) {
        sketch.label(Label::new(key, text, anchor, role).rank(Rank::Word).size(Size::Note));
    }
}
