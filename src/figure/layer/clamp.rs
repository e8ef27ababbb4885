//! A circle's centre clamped to a box: V and its components, what is left of them, `B_c`, and D = B − `B_c`.
//!
//! Everything lies in the box's frame and is drawn along the box's axes, so the layer stands in a world panel
//! and in the panel of the box's own frame alike.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, HEAD_LENGTH, HEAD_WIDTH, LARGE_MARKER, Label, MARKER, Marker, Outline, Pen, Rank, Sketch, Wash,
    Weight,
};
use crate::figure::text::{in_panel, number};
use crate::geometry::{DVec2, Pose, Rotation, Side};
use crate::trace::step::clamped as parts;
use crate::trace::{Event, phrase};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Opacity of the rectangle that the clamped components span.
const SPANNED: f64 = 0.1;

/// The words of the parts that can be shown alone.
const PARTS: &[&str] = &["V", "components", "clamped", "Bc", "D"];

pub(super) const LAYER: Layer = Layer {
    name: "clamp",
    in_words: phrase([
        "clamp",
        "Begrenzen auf das Rechteck",
        "bornage au rectangle",
        "limitación al rectángulo",
    ]),
    about: "a circle's centre clamped to a box",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec { name: "show", takes: Takes::Words(PARTS), default: "all", about: "which parts" },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the components of V and of D, in the frame of the panel; with V_x and V_y of a \
                    box that is turned there, theirs and the length of D",
        },
    ],
    labels: &[
        LabelKey { key: "V", about: "from the box's centre to the circle's" },
        LabelKey { key: "V_x", about: "its component along the box's x axis" },
        LabelKey { key: "V_y", about: "its component along the box's y axis" },
        LabelKey { key: "clamped_x", about: "what is left of V_x" },
        LabelKey { key: "clamped_y", about: "what is left of V_y" },
        LabelKey { key: "B_c", about: "the point of the box closest to the circle" },
        LabelKey { key: "D", about: "from there to the circle's centre" },
    ],
    needs: "the algorithm \"clamp\": a circle against a box",
    fed: |context, _| Fed::by_the_scene(clamped(context).is_some()),
    draw,
};

/// What the algorithm found, in the world where nothing else is said.
struct Clamped {
    /// The box.
    side: Side,
    /// Where the box is.
    pose: Pose,
    /// From the box's centre to the circle's, in the box's frame.
    v: DVec2,
    /// What clamping left of `v`, in the box's frame.
    kept: DVec2,
    /// The point of the box closest to the circle's centre.
    closest: DVec2,
    /// From there to the circle's centre.
    d: DVec2,
}

/// What the algorithm told of its clamping.
fn clamped(context: &Context) -> Option<Clamped> {
    context.run().find_told(|event| match *event {
        Event::Clamped { body, v, clamped, closest, d, .. } => Some(Clamped {
            side: body,
            pose: context.pose(body, context.time)?,
            v,
            kept: clamped,
            closest,
            d,
        }),
        _ => None,
    })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(c) = clamped(context) else { return };
    let shows = |part| options.shows("show", part, true);
    let cue = context.cue(|event| matches!(event, Event::Clamped { .. }));
    let at = |part| cue.map(|cue| cue.part(part));
    sketch.since(at(parts::WAY));
    // Components in the frame of the panel are not those along the axes of a box that is turned in it.
    let is_turned = context.frame().map_or(Rotation::NONE, |frame| frame.rotation) != c.pose.rotation;
    let along = is_turned && options.flag("values", false) && (shows("components") || shows("clamped"));
    if shows("components") {
        components(sketch, &c, shows("clamped"), along);
    }
    if shows("clamped") {
        kept(sketch.since(at(parts::CUT)), options, &c, (along, shows("components")));
    }
    // Both in the frame of the panel, so that D is V less what is kept of it in the world as well.
    // In the frame of the box they are as the algorithm has them: what was not cut leaves nothing. Of a
    // centre inside nothing is cut, and D is square to the nearest side.
    let is_own = context.frame().is_some_and(|frame| frame.rotation == c.pose.rotation);
    let [v, d] = match [c.pose.vector(c.v), c.d].map(|v| in_panel(context, v)) {
        [_, d] if is_own && c.v == c.kept => [c.v, square(d)],
        _ if is_own => [c.v, c.v - c.kept],
        seen => seen,
    };
    // V and D end at the circle's centre: their heads stop short of it, V's behind D's where they would meet.
    let behind = if shows("D") && heads_meet(c.v, c.d) { MARKER + HEAD_LENGTH } else { MARKER };
    if shows("V") {
        let (from, tip) = (c.pose.position, c.pose.point(c.v));
        sketch.since(at(parts::WAY)).part("V").arrow_to(from, tip, behind, Pen::vector(Role::Ink));
        let text = if along { "$V$".to_owned() } else { valued("V", v, options) };
        sketch.label(Label::new("V", text, Anchor::middle(from, tip), Role::Ink));
    }
    if shows("D") {
        let (from, tip) = (c.closest, c.closest + c.d);
        sketch.since(at(parts::CLOSEST)).part("D").arrow_to(
            from,
            tip,
            MARKER,
            Pen::vector(Role::Translation),
        );
        let text = if along { with_value("$|D|$", d.length(), true) } else { valued("D", d, options) };
        sketch.label(Label::new("D", text, Anchor::middle(from, tip), Role::Translation));
    }
    if shows("Bc") {
        let marker = if c.side == Side::A { Marker::Disc } else { Marker::Square };
        let role = Role::from(c.side);
        sketch.since(at(parts::CLOSEST)).part("Bc").marker(c.closest, marker, role, LARGE_MARKER);
        // The circle's centre, clamped; below a name, c would be the centre of what is called so.
        let text = match context.named(c.side.other()) {
            name if context.has_letters() => format!("${}_c$", name.term()),
            _ => "closest point".to_owned(),
        };
        sketch.label(Label::new("B_c", text, Anchor::point(c.closest), Role::Ink).rank(Rank::Point));
    }
}

/// Whether the heads of two arrows to one point meet: their backs are nearer to each other than one is wide.
fn heads_meet(v: DVec2, d: DVec2) -> bool {
    let sine = v.perp_dot(d).abs() / (v.length() * d.length());
    d.length() > 0.0 && (v.dot(d) > 0.0 && sine * (MARKER + HEAD_LENGTH) < HEAD_WIDTH)
}

/// A vector along one of two axes, without what rounding left of the other component.
fn square(v: DVec2) -> DVec2 {
    if v.x.abs() < v.y.abs() { DVec2::new(0.0, v.y) } else { DVec2::new(v.x, 0.0) }
}

/// The label of a vector, with its components where the scene wants them.
fn valued(letter: &str, vector: DVec2, options: &Options) -> String {
    if options.flag("values", false) {
        format!("${letter} = ({}, {})$", number(vector.x), number(vector.y))
    } else {
        format!("${letter}$")
    }
}

/// A formula, with its value where one is wanted, and where nothing is seen of it.
fn with_value(formula: &str, value: f64, is_wanted: bool) -> String {
    match formula.strip_suffix('$').filter(|_| is_wanted || value == 0.0) {
        Some(open) => format!("{open} = {}$", number(value)),
        None => formula.to_owned(),
    }
}

/// The axes of the box with the component of V and what clamping left of it.
fn axes(c: &Clamped) -> [(DVec2, f64, f64); 2] {
    [(c.pose.vector(DVec2::X), c.v.x, c.kept.x), (c.pose.vector(DVec2::Y), c.v.y, c.kept.y)]
}

/// Draws `V_x` and `V_y` as arrows along the box's axes, each with a dashed line from its tip to the circle's
/// centre; `values` beside their letters. A component that was not cut is drawn only once, as what is left of
/// it.
fn components(sketch: &mut Sketch, c: &Clamped, with_kept: bool, values: bool) {
    let names = [("V_x", "$V_x$"), ("V_y", "$V_y$")];
    for ((axis, component, kept), (key, text)) in axes(c).into_iter().zip(names) {
        let tip = c.pose.position + axis * component;
        sketch.part("projections").weight(Weight::Light).line(tip, c.pose.point(c.v), Pen::construction());
        if !(with_kept && component == kept) {
            sketch.part(key).arrow(c.pose.position, tip, Pen::vector(Role::Muted));
            let anchor = Anchor::tip(c.pose.position, tip);
            sketch.label(Label::new(key, with_value(text, component, values), anchor, Role::Muted));
        }
    }
}

/// Draws what clamping left of the components, thick, `values` beside their letters, and the rectangle that
/// they span. Where the components themselves are not `drawn`, the values are of both.
fn kept(sketch: &mut Sketch, options: &Options, c: &Clamped, (values, drawn): (bool, bool)) {
    let role = options.role(Role::Now);
    // The two lead to its corner.
    let corners = [DVec2::ZERO, DVec2::new(c.kept.x, 0.0), c.kept, DVec2::new(0.0, c.kept.y)];
    let spanned = Outline::polygon(&corners.map(|p| c.pose.point(p)));
    sketch.part("spanned").weight(Weight::Background).area(&spanned, Some(Wash::faint(role, SPANNED)), None);
    let names =
        [("clamped_x", "V_x", "$V_x$", "clamped $V_x$"), ("clamped_y", "V_y", "$V_y$", "clamped $V_y$")];
    for ((axis, component, kept), (key, whole_key, whole, cut)) in axes(c).into_iter().zip(names) {
        let end = c.pose.position + axis * kept;
        sketch.part("clamped").line(c.pose.position, end, Pen::highlighted(role));
        let (key, text) = if component == kept { (whole_key, whole) } else { (key, cut) };
        let text = if component == kept || drawn || !values {
            with_value(text, kept, values)
        } else {
            format!("{}, clamped to ${}$", with_value(whole, component, true), number(kept))
        };
        sketch.label(Label::new(key, text, Anchor::middle(c.pose.position, end), role));
    }
}
