//! One step of an advancement along the ray: from the estimate to the closest point of B ⊖ A with its normal;
//! where the tangent there cuts the ray lies the new estimate, never past the surface.

use crate::collision::scale_of;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Rank, SMALL_MARKER, Size, Sketch, Weight};
use crate::figure::text::Quantity;
use crate::geometry::{DVec2, Side, perp};
use crate::trace::step::advanced;
use crate::trace::{Event, phrase};

use super::normal::unit_vector;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// How far the tangent reaches behind the closest point and past the ray, page pixels.
const TANGENT: [f64; 2] = [110.0, 40.0];

/// The share of the size of the pair below which a distance is what rounding left of none.
const NOTHING: f64 = 1e-12;

pub(super) const LAYER: Layer = Layer {
    name: "advancement",
    in_words: phrase([
        "advancement",
        "ein Schritt der Annäherung",
        "une étape de l’avance",
        "un paso del avance",
    ]),
    about: "one step: estimate, closest point, normal, tangent, new estimate",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[OptionSpec {
        name: "words",
        takes: Takes::Words(&["estimate", "closest", "next", "tangent"]),
        default: "all",
        about: "which parts are named in words",
    }],
    labels: &[
        LabelKey { key: "estimate", about: "where the step starts" },
        LabelKey { key: "closest", about: "the closest point of B ⊖ A" },
        LabelKey { key: "d", about: "its distance from the estimate" },
        LabelKey { key: "n", about: "the normal there, from the estimate on" },
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
    /// The unit normal there, from the estimate into B ⊖ A: from A to B.
    normal: DVec2,
    /// The distance of the two.
    separation: f64,
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
        Event::Advanced { step, at, estimate, closest, normal, separation, next, .. } if step == wanted => {
            // B ⊖ A rests and the estimate moves, or the estimate rests in the origin and B ⊖ A moves.
            let next = next.map(|t| if estimate == v * at.time { v * t } else { v * (t - at.time) });
            Some(Step { estimate, closest, normal, separation, next })
        }
        _ => None,
    })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(s) = step(context) else { return };
    let is_this =
        |event: &Event| matches!(event, Event::Advanced { step, .. } if Some(*step) == context.step);
    let cue = context.cue(is_this);
    sketch.since(cue);
    sketch.detail(&[s.estimate, s.closest, s.next.unwrap_or(s.closest)]);
    let tangent = TANGENT.map(|px| sketch.px(px));
    let past = s.next.map_or(0.0, |next| next.distance(s.closest)) + tangent[1];
    let along = tangent_direction(&s, context.closing_velocity());
    let (behind, ahead) = (s.closest - along * tangent[0], s.closest + along * past);
    sketch.part("tangent").weight(Weight::Light).line(behind, ahead, Pen::construction());
    sketch.part("right-angle").right_angle(s.closest, along, s.estimate - s.closest);
    let blue = Role::Translation;
    sketch.part("distance").dimension(s.estimate, s.closest, 0.0, Pen::dimension(blue).width(1.5));
    // What is left at the contact is what rounding left.
    let nothing = match (context.body(Side::A), context.body(Side::B)) {
        (Some(a), Some(b)) => NOTHING * scale_of(a, b),
        _ => 0.0,
    };
    let distance = format!("$d {}$", Quantity::exactly(s.separation).equals(nothing));
    sketch.label(Label::new("d", distance, Anchor::middle(s.estimate, s.closest), blue));
    let n = Label::new("n", "$n$", Anchor::point(s.closest), Role::B);
    unit_vector(sketch, (s.closest, s.normal), None, n);
    sketch.part("closest").marker(s.closest, Marker::Diamond, Role::B, MARKER);
    sketch.part("estimate");
    // The origin's own mark stays what it is where the search starts there.
    let radius = if s.estimate == DVec2::ZERO { SMALL_MARKER } else { MARKER };
    sketch.marker(s.estimate, Marker::Disc, Role::Ink, radius);
    word(
        sketch,
        options,
        "tangent",
        Anchor::Beside { from: behind, to: s.closest, offset: 0.0 },
        Role::Muted,
    );
    sketch.part("closest");
    word(sketch, options, "closest", Anchor::point_toward(s.closest, s.normal), Role::B);
    sketch.part("estimate");
    word(sketch, options, "estimate", Anchor::point_toward(s.estimate, DVec2::new(-2.0, -2.0)), Role::Ink);
    if let Some(next) = s.next {
        let role = options.role(Role::Now);
        sketch.since(cue.map(|cue| cue.part(advanced::NEXT))).part("next").marker(
            next,
            Marker::HollowDiamond,
            role,
            MARKER,
        );
        word(sketch, options, "next", Anchor::point_toward(next, DVec2::new(2.0, -2.0)), role);
    }
}

/// Along the tangent towards the ray's far end.
fn tangent_direction(s: &Step, v: DVec2) -> DVec2 {
    let along = perp(s.normal);
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
