//! The unit normal n from A to B along which B moves apart; turned round it is the N of the article's
//! circles. It is one unit long; where that is far less or more than the bodies it says that it is not.

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::scene::{NOTES, When};
use crate::trace::phrase;

use super::carrying::{Carrying, drawn, edges};
use super::moment;
use super::separation::NO_EDGE;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, tied};

/// Drawn length of the unit vector where the scene does not say, world units: its own.
const LENGTH: f64 = 1.0;
/// Drawn length where its own is no length to be seen beside the bodies, page pixels.
const FITTED: f64 = 40.0;
/// How far from a closest point on an edge the arrow may start to start there, in parts of the edge: some
/// roundings, and far below what is seen.
const ON_EDGE: f64 = 1e-9;

pub(super) const LAYER: Layer = Layer {
    name: "normal",
    in_words: phrase(["normal", "Normale", "normale", "normal"]),
    about: "the unit normal from A to B",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "at",
            takes: Takes::When(&[When::START, When::HIT, When::CLOSEST, When::END]),
            default: "the panel's moment",
            about: "when the bodies are asked for their normal",
        },
        OptionSpec {
            name: "from",
            takes: Takes::Word(&["contact", "edge", "A", "B"]),
            default: "\"contact\"",
            about: "starts at the closest point of A, on the edge that faces, or at the origin of a body",
        },
        OptionSpec { name: "flip", takes: Takes::Flag, default: "false", about: "from B to A instead" },
        OptionSpec {
            name: "length",
            takes: Takes::Number,
            default: "1, or 40 px",
            about: "drawn length, world units",
        },
    ],
    labels: &[
        LabelKey { key: "n", about: "the normal from A to B" },
        LabelKey { key: "N", about: "the normal from B to A, with flip" },
    ],
    needs: "two convex bodies; for \"hit\" a question for the first contact",
    fed: |context, options| match options.when("at") {
        Some(When::Hit | When::Closest) => {
            Fed::by_the_answer(found(context, options).is_some(), context.asks_for_a_hit())
        }
        _ => found(context, options)
            .map_or(Fed::Never, |(time, answer)| on_edge(context, options, time, &answer)),
    },
    draw,
};

/// Whether the edge that the arrow is to start on faces.
fn on_edge(context: &Context, options: &Options, time: f64, answer: &Separation) -> Fed {
    let asked = NOTES && options.word("from", "") == "edge";
    let none = asked && edges(context, time, answer).is_empty();
    if none { Fed::Without { option: "from", why: NO_EDGE } } else { Fed::Yes }
}

/// The moment that the scene wants, and the pair then.
fn found(context: &Context, options: &Options) -> Option<(f64, Separation)> {
    let time = match options.when("at") {
        Some(when) => context.moment(&when)?.time,
        None => context.time,
    };
    Some((time, context.separation_seen(time)?))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((time, answer)) = found(context, options) else { return };
    let Some(from) = start(context, options, time, &answer) else { return };
    let drawn = drawn(sketch, context, time, &answer);
    sketch.since(context.separation_at(time).map(|run| run.nearest()));
    let flip = options.flag("flip", false);
    let n = if flip { -answer.normal } else { answer.normal };
    let role = options.role(Role::Ink);
    let (key, letter) = if flip { ("N", "N") } else { ("n", "n") };
    let mut lines = vec![format!("${letter}$")];
    lines.extend(moment::other(context, time));
    lines.extend(tied(answer.ties));
    let length = options.number("length");
    let leg = edge(options, &drawn).or_else(|| touched(&drawn, from));
    if let Some((on, leg)) = leg {
        sketch.part("right-angle").right_angle(on, leg, *n);
    }
    unit_vector(
        sketch,
        (from, *n),
        length,
        Label { lines, ..Label::new(key, "", Anchor::point(from), role) },
    );
}

/// How long a unit vector is drawn where the scene does not say, world units.
pub(super) fn unit_length(sketch: &Sketch) -> f64 {
    if sketch.is_legible(LENGTH) { LENGTH } else { sketch.px(FITTED) }
}

/// Draws a unit vector `n` from a point, one unit long or as long as the scene says, with its label; where it
/// is not one long, the label says so. Returns its tip.
pub(super) fn unit_vector(
    sketch: &mut Sketch,
    (from, n): (DVec2, DVec2),
    given: Option<f64>,
    Label { lines, role, key, .. }: Label,
) -> DVec2 {
    let to_scale = given.is_some() || sketch.is_legible(LENGTH);
    let tip = from + n * given.unwrap_or_else(|| unit_length(sketch));
    sketch.part("normal").arrow(from, tip, Pen::vector(role));
    let factor = given.unwrap_or(LENGTH);
    let say = |text: &str| if to_scale { scaled(factor, text) } else { format!("{text} (not to scale)") };
    let mut lines = lines;
    if let Some(letter) = lines.first_mut() {
        *letter = say(letter);
    }
    sketch.label(Label { lines, ..Label::new(key, "", Anchor::tip(from, tip), role) });
    tip
}

/// The text of a vector that is drawn `factor` times as long as it is.
pub(super) fn scaled(factor: f64, text: &str) -> String {
    let quarters = [(0.25, "¼"), (0.5, "½"), (0.75, "¾")];
    match quarters.iter().find(|(quarter, _)| *quarter == factor) {
        _ if factor == 1.0 => text.to_owned(),
        Some((_, fraction)) => format!("{fraction} {text}"),
        None => format!("${}$ {text}", number(factor)),
    }
}

/// Where the arrow starts at `time`, in the world.
fn start(context: &Context, options: &Options, time: f64, answer: &Separation) -> Option<DVec2> {
    let origin = |side| context.pose(side, time).map(|pose| pose.position);
    match options.word("from", "contact") {
        "edge" => {
            let all = edges(context, time, answer);
            Some(edge(options, &all).map_or(answer.points[0], |(on, _)| on))
        }
        "A" => origin(Side::A),
        "B" => origin(Side::B),
        _ => Some(answer.points[0]),
    }
}

/// The start of the arrow where it lies on one of the edges with a closest point, and the longer way along
/// that edge.
fn touched(edges: &[Carrying], from: DVec2) -> Option<(DVec2, DVec2)> {
    let near = edges.iter().find(|(_, at, [p, q])| at.distance(from) <= ON_EDGE * p.distance(*q));
    let &(_, at, [p, q]) = near?;
    let far = if at.distance_squared(p) < at.distance_squared(q) { q } else { p };
    Some((from, far - at))
}

/// Where the arrow starts on the first of the edges that carry a closest point, and a way along it from
/// there: in the middle of the longer part beside that point. `None` where the scene wants it elsewhere, or
/// there is no edge.
fn edge(options: &Options, edges: &[Carrying]) -> Option<(DVec2, DVec2)> {
    if options.word("from", "") != "edge" {
        return None;
    }
    let &(_, at, ends) = edges.first()?;
    let far = if at.distance_squared(ends[0]) < at.distance_squared(ends[1]) { ends[1] } else { ends[0] };
    let on = 0.5 * (at + far);
    Some((on, far - on))
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn a_normal_that_starts_on_an_edge_is_square_to_it_and_one_at_a_vertex_to_none() {
        // A circle on B's upper edge, and one on its vertex.
        for (x, square) in [(0.0, true), (2.5, false)] {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1, position = [{x}, 4], velocity = [0, -5] }}
                shapes.B = {{ kind = 'box', half_extents = [2, 1] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
                panels = [{{ time = 'hit', layers = ['normal'] }}]"
            );
            let scene = open_text("normal", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "normal");
            assert_eq!(!paths(&figure.drawing.items, "right-angle").is_empty(), square, "{x}");
        }
    }

    #[test]
    fn a_normal_that_ties_with_others_is_called_one_of_several() {
        // Vertex on vertex, edge on edge, a box in the middle of one that is as wide as high, and nearly so.
        for (position, alone) in
            [("[2, 2]", false), ("[2, 0.5]", true), ("[0, 0]", false), ("[0.5, 0]", true)]
        {
            let text = format!(
                "shapes.a = {{ kind = 'box', half_extents = [1, 1] }}
                shapes.b = {{ kind = 'box', half_extents = [1, 1], position = {position} }}
                query = {{ kind = 'separation', of = ['a', 'b'] }}
                panels = [{{ layers = ['normal', 'feature', 'separation'] }}]"
            );
            let scene = open_text("normal", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let labels = labels(&draw(&plan, plan.theme, "normal"));
            let said = |key: &str| !labels[key].0.ends_with(" one of several");
            assert_eq!((said("n"), said("feature.A")), (alone, alone), "{position}: {labels:?}");
            // Bodies that touch need no push, and have no other.
            assert_eq!(said("d"), alone || position == "[2, 2]", "{position}: {labels:?}");
        }
    }
}
