//! Witness points and what lies between them: the distance of bodies apart as a length; the minimum
//! translation of bodies that overlap as an arrow, the way B goes.
//!
//! `p_B` − `p_A` = s n, so the line runs outside both bodies or inside both, and its length is |s|. B parts
//! from A by −s n, which takes `p_B` to `p_A`.

use std::sync::Arc;

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::runs::Run;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Size, Sketch, Weight, left_of};
use crate::figure::text::{Quantity, asked_distance, distance_or_depth};
use crate::geometry::{DVec2, Side, perp};
use crate::trace::{Event, phrase};

use crate::scene::{NOTES, When};

use super::carrying::{drawn, edges};
use super::closest::{WayOut, longer, longer_way, unseen};
use super::depth_disc::{disc, disc_place};
use super::difference::difference;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, STEPS, Shows, Takes, Tells, tied};
use super::{moment, step_lengths};

/// A length that is no line on the page, page pixels.
const NOTHING: f64 = 0.5;

/// How far the longer push is drawn beside the shortest one where both are on one line, page pixels: a head's
/// width and as much between.
const ASIDE: f64 = 14.0;

/// How far the carrier line reaches beyond its edge, world units.
const CARRIER: f64 = 1.0;

/// Why nothing is drawn of an edge.
pub(super) const NO_EDGE: &str = "neither closest point is on an edge that faces the other body";

pub(super) const LAYER: Layer = Layer {
    name: "separation",
    in_words: phrase(["separation", "Abstand", "distance", "separación"]),
    about: "the distance or depth between the closest points",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "at",
            takes: Takes::When(&[When::START, When::HIT, When::CLOSEST, When::BOUND, When::END, STEPS]),
            default: "the panel's moment",
            about: "when the bodies are asked for their separation, or at every step: s₁, s₂, …",
        },
        OptionSpec {
            name: "style",
            takes: Takes::Word(&["arrow", "dimension", "bar"]),
            default: "\"arrow\"",
            about: "an arrow the way B goes (apart: a dimension line), a dimension line, or a thick bar",
        },
        OptionSpec {
            name: "offset",
            takes: Takes::Number,
            default: "0",
            about: "page px to the right of the way from A to B",
        },
        OptionSpec {
            name: "carrier",
            takes: Takes::Flag,
            default: "false",
            about: "the line of the edge that faces, dashed",
        },
        OptionSpec {
            name: "points",
            takes: Takes::Flag,
            default: "false",
            about: "marks the closest points",
        },
        OptionSpec {
            name: "rival",
            takes: Takes::Flag,
            default: "false",
            about: "of bodies that overlap, the next local minimum: a longer push that no slightly \
                    other direction shortens",
        },
        OptionSpec {
            name: "disc",
            takes: Takes::Flag,
            default: "false",
            about: "of bodies that overlap, where every push of that length takes the deepest point, if none \
                    of them takes it out of the other body",
        },
        OptionSpec {
            name: "rim",
            takes: Takes::Flag,
            default: "false",
            about: "of the disc the rim alone: over bodies, with its tint under them",
        },
        OptionSpec {
            name: "text",
            takes: Takes::Lines,
            default: "by the algorithm",
            about: "lines of the label in this panel",
        },
    ],
    labels: &[
        LabelKey { key: "d", about: "distance or depth" },
        LabelKey { key: "p", about: "the signed penetration of two circles" },
        LabelKey { key: "rival", about: "length of the next longer push, with rival" },
        LabelKey { key: "disc", about: "the disc, with disc; only where a scene gives it a text" },
        LabelKey { key: "s_k", about: "the separation at a step, where it is long enough" },
        LabelKey { key: "distance", about: "the distance of a circle from a box" },
    ],
    needs: "two bodies; for \"hit\" or another moment of a motion a question for the first contact; \
        for \"steps\" an advancement",
    fed: |context, options| match options.when("at") {
        when @ Some(When::Hit | When::Closest | When::Bound) => {
            Fed::by_a_moment(found(context, options).is_some(), context, when)
        }
        _ if is_of_steps(options) => Fed::by_the_scene(!context.steps().is_empty()),
        _ => found(context, options).map_or(Fed::Never, |run| beside(context, options, &run)),
    },
    draw,
};

/// The run that answers with the separation at the moment that the scene wants.
fn found(context: &Context, options: &Options) -> Option<Arc<Run>> {
    let time = match options.when("at") {
        Some(when) => context.moment(&when)?.time,
        None => context.time,
    };
    context.separation_at(time).filter(|run| run.separation().is_some())
}

/// Whether all that a scene wants beside the line can be drawn.
fn beside(context: &Context, options: &Options, run: &Run) -> Fed {
    let wants = |option: &'static str| options.flag(option, false).then_some(option);
    let Some(answer) = run.separation().filter(|_| NOTES) else { return Fed::Yes };
    if let Some(option) = wants("carrier").filter(|_| edges(context, run.time, answer).is_empty()) {
        return Fed::Without { option, why: NO_EDGE };
    }
    let apart = wants("disc").or(wants("rival")).filter(|_| answer.bounds.hi >= 0.0);
    if let Some(option) = apart {
        return Fed::Without { option, why: "the bodies do not overlap" };
    }
    if let Some(option) = wants("disc").filter(|_| disc_place(context, run.time, answer).is_none()) {
        return Fed::Without { option, why: "the deepest point alone is out sooner another way" };
    }
    let way = || longer_way(&difference(context, run.time)?, DVec2::ZERO, -answer.separation);
    match wants("rival").filter(|_| way().is_none()) {
        Some(option) => Fed::Without { option, why: "there is no longer push that is a local minimum" },
        None => Fed::Yes,
    }
}

/// Whether the scene wants the separation at every step.
fn is_of_steps(options: &Options) -> bool {
    options.word("at", "") == STEPS
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    if is_of_steps(options) {
        return step_lengths::draw(sketch, context, options, LAYER.name);
    }
    let Some(run) = found(context, options) else { return };
    let Some(answer) = context.separation_seen(run.time) else { return };
    let role = options.role(Role::Translation);
    sketch.since(run.nearest());
    if options.flag("carrier", false) {
        carrier(sketch, context, &run, &answer);
    }
    let [p, q] = answer.points;
    let offset = sketch.fitted(options.number("offset").unwrap_or(0.0));
    sketch.since(run.end());
    if options.flag("disc", false) && answer.bounds.hi < 0.0 {
        disc(sketch, (context, run.time), &answer, options.flag("rim", false));
    }
    sketch.part("separation");
    match options.word("style", "arrow") {
        "dimension" => sketch.dimension(p, q, -offset, Pen::dimension(role).width(1.5)),
        "bar" => sketch.bar(p, q, -offset, Pen::highlighted(role)),
        _ if answer.bounds.hi < 0.0 => {
            let clear = if options.flag("points", false) { MARKER } else { 0.0 };
            sketch.arrow_to(q, p, clear, Pen::vector(role))
        }
        _ => sketch.dimension(p, q, 0.0, Pen::dimension(role).width(1.5)),
    };
    sketch.detail(&answer.points);
    // A disc that the edge touches says as much; a bar is a part of a way that goes on, and says how long.
    let is_touched = options.flag("disc", false) && disc_place(context, run.time, &answer).is_some();
    if !is_touched && options.word("style", "arrow") != "bar" {
        right_angles(sketch, context, &run, &answer, left_of(p, q) * sketch.px(-offset));
    }
    if options.flag("rival", false) && answer.bounds.hi < 0.0 {
        rival(sketch.since(run.end()), context, &run, &answer);
    }
    let is_touching = touches(context, &run, &answer);
    points(sketch.since(run.nearest()), options, &answer, is_touching);
    let (key, text) = words(context, &run, &answer);
    let text = asked_distance(context, &answer).unwrap_or(text);
    // On the outer side of a line that is moved aside; a long text on a short arrow beyond one of its ends.
    let anchor = if is_touching { Anchor::point(p) } else { Anchor::Beside { from: q, to: p, offset } };
    // That of concentric circles every way is as long is plain to see, where there is little room.
    let ties = tied(answer.ties).filter(|_| answer.bounds.hi < 0.0 && answer.ties > 0);
    let then = moment::other(context, run.time);
    let lines =
        std::iter::once(text).chain(then).chain(unseen(sketch, context, &answer)).chain(ties).collect();
    let label = Label { lines, ..Label::new(key, "", anchor, role) };
    sketch.since(run.end()).label(match options.words("text") {
        Some(lines) => label.given(lines),
        None => label,
    });
}

/// Whether bodies are not apart and do not overlap, as far as the rounding of their numbers tells.
fn touches(context: &Context, run: &Run, answer: &Separation) -> bool {
    let rounding = context.scene.query_at(run.time).rounding();
    answer.separation.abs() <= rounding || answer.bounds.lo <= 0.0 && answer.bounds.hi >= 0.0
}

/// Marks the closest points, if the scene wants them; in any case where bodies touch, or no line is seen
/// between them.
fn points(sketch: &mut Sketch, options: &Options, answer: &Separation, is_touching: bool) {
    let [p, q] = answer.points;
    let is_asked = options.flag("points", false);
    if is_touching || !is_asked && sketch.on_page(p.distance(q)) < NOTHING {
        // Where bodies touch both are one point, and nothing else is seen of a distance of 0.
        sketch.part("closest-points").marker(p, Marker::Disc, options.role(Role::Translation), MARKER);
    } else if is_asked {
        sketch.part("closest-points").marker(p, Marker::Disc, Side::A.into(), MARKER);
        sketch.part("closest-points").marker(q, Marker::Square, Side::B.into(), MARKER);
    }
}

/// Draws the line of an edge that carries a witness point, beyond both of its ends.
fn carrier(sketch: &mut Sketch, context: &Context, run: &Run, answer: &Separation) {
    for (.., [p, q]) in edges(context, run.time, answer) {
        let reach = (q - p).normalize_or_zero() * CARRIER;
        sketch.part("carrier").weight(Weight::Light);
        sketch.line(p - reach, p, Pen::construction()).line(q, q + reach, Pen::construction());
    }
}

/// Marks the right angle of the way between the closest points, moved `aside`, against the edges that carry
/// one, where it still ends on them.
fn right_angles(sketch: &mut Sketch, context: &Context, run: &Run, answer: &Separation, aside: DVec2) {
    let [a, b] = answer.points;
    // Of two edges that face each other one is enough: they are parallel. B's, as the arrow's head is at A.
    for (_, at, [p, q]) in drawn(sketch, context, run.time, answer).into_iter().rev().take(1) {
        let other = if at == a { b } else { a };
        let foot = at + aside;
        let leg = if foot.distance_squared(p) > foot.distance_squared(q) { p } else { q };
        if (p - foot).dot(q - foot) < 0.0 || aside == DVec2::ZERO {
            sketch.part("right-angle").right_angle(foot, leg - foot, other - at);
        }
    }
    sketch.part("separation");
}

/// Draws the next longer way that parts the bodies, from the vertex that is deepest to the edge that it
/// leaves through, the way B goes, with its length.
fn rival(sketch: &mut Sketch, context: &Context, run: &Run, answer: &Separation) {
    let Some(found) = difference(context, run.time) else { return };
    let Some(WayOut { edge, length }) = longer_way(&found, DVec2::ZERO, -answer.separation) else { return };
    let side = edge.source.other();
    let (Some(body), Some(pose)) = (context.body(side), context.pose(side, run.time)) else { return };
    let Some(&vertex) = body.shape.vertices.get(edge.vertex) else { return };
    // B's deepest point lies along the edge's normal, A's against it; B goes against it.
    let (way, radius) = (edge.normal * length, edge.normal * body.shape.radius);
    let (start, end, on_edge) = if side == Side::B {
        let deepest = pose.point(vertex) + radius;
        (deepest, deepest - way, deepest - way)
    } else {
        let deepest = pose.point(vertex) - radius;
        (deepest + way, deepest, deepest + way)
    };
    // Two arrows on one line would hide each other.
    let off_line = |p: DVec2| (p - answer.points[0]).perp_dot(*answer.normal).abs();
    let is_on_line = off_line(start).max(off_line(end)) < sketch.px(ASIDE);
    let aside = if is_on_line { perp(way).normalize_or_zero() * sketch.px(ASIDE) } else { DVec2::ZERO };
    let (start, end, on_edge) = (start + aside, end + aside, on_edge + aside);
    let inward = if side == Side::B { way } else { -way };
    sketch.part("right-angle").right_angle(on_edge, edge.to - edge.from, inward);
    sketch.part("rival").arrow(start, end, Pen::vector(Role::Muted));
    let anchor = Anchor::middle(start, end);
    sketch.label(Label::new("rival", longer(length), anchor, Role::Muted).size(Size::Note));
    sketch.part("separation");
}

/// Key and text of the label in the algorithm's own words: the article calls the signed penetration of
/// circles p, the distance of a circle from a box distance, and the depth of polygons d, which has no sign.
fn words(context: &Context, run: &Run, answer: &Separation) -> (&'static str, String) {
    let rounding = context.scene.query_at(run.time).rounding();
    let signed = Quantity::separation(answer).equals(rounding);
    if run.tells(|e| matches!(e, Event::PenetrationMeasured { .. })) {
        ("p", format!("$p {signed}$"))
    } else if run.tells(|e| matches!(e, Event::Clamped { .. })) {
        let is_inside = answer.bounds.hi < 0.0;
        (
            "distance",
            if is_inside { distance_or_depth(answer, rounding) } else { format!("distance ${signed}$") },
        )
    } else {
        ("d", distance_or_depth(answer, rounding))
    }
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Contour, Segment};
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    const SCENE: &str = r#"
        [shapes.A]
        kind = "circle"
        radius = 1
        [shapes.B]
        kind = "circle"
        radius = 1
        position = [4, 0]
        [query]
        kind = "separation"
        of = ["A", "B"]
        [[panels]]
        view = [-2, -2, 6, 2]
        layers = [{ layer = "separation", style = "bar", offset = 16 }]
        [canvas]
    "#;

    #[test]
    fn an_offset_shrinks_with_a_small_page() {
        // Lines shrink with the root of the page: a third of it has lines of 0.577.
        let small = 16.0 * (1.0_f64 / 3.0).sqrt();
        for (size, expected) in [("width = 960", 16.0), ("width = 320\nheight = 180", small)] {
            let scene = open_text("s.toml", &format!("{SCENE}{size}")).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            let Contour::Segments(bar) = &paths(&figure.drawing.items, "separation")[0].contour else {
                panic!("a line")
            };
            let Segment::Move(from) = bar[0] else { panic!("a line begins") };
            let closest = figure.panels[0].frame.page(DVec2::X);
            assert!(((from.y - closest.y).abs() - expected).abs() < 1e-9, "{from:?} {closest:?}");
        }
    }

    #[test]
    fn a_gap_that_cannot_be_seen_says_so() {
        for (radius, gap, lines) in [(1000.0, 0.01, 2), (1000.0, 0.0, 1), (1.0, 0.5, 1)] {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = {radius} }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [{}, 0] }}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [{{ layers = ['shapes', 'separation'] }}]",
                radius + 1.0 + gap
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            let label = figure.panels[0].placed.iter().find(|label| label.key == "d").unwrap();
            assert_eq!(label.lines.len(), lines, "{radius}, {gap}");
        }
    }
}
