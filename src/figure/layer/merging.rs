//! B ⊖ A being built: the edges taken so far, numbered, and at the vertex that the merge has come to the next
//! edge of either body, of which it takes the one that turns less.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Rank, Size, Sketch, Weight, angle_of};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::trace::phrase;

use super::edge_fan::{Merged, merged};
use super::half_extents::ON_LINE;
use super::vertices::mean;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, number_of, part};

/// Opacity of the edge that is not taken.
const REJECTED: f64 = 0.55;

/// How far the edge before is drawn on, page pixels.
const AHEAD: f64 = 76.0;

/// Radius of the arc of the smaller turn, page pixels; that of the other one is less.
const TURN: f64 = 60.0;

pub(super) const LAYER: Layer = Layer {
    name: "merging",
    in_words: phrase(["merging", "Mischen der Kanten", "fusion des arêtes", "fusión de las aristas"]),
    about: "B ⊖ A being built: the edges taken so far, and the next edge of either body",
    shows: Shows::Configuration,
    tells: Tells::Built,
    options: &[OptionSpec {
        name: "step",
        takes: Takes::Number,
        default: "the last",
        about: "which edge is taken, from 1",
    }],
    labels: &[
        LabelKey { key: "step", about: "the edge's number in the order of directions" },
        LabelKey { key: "start", about: "where the first edge begins" },
        LabelKey { key: "e.A", about: "the number of the next edge of A, mirrored" },
        LabelKey { key: "e.B", about: "the number of the next edge of B" },
        LabelKey { key: "less", about: "beside the edge that is taken: how far it turns" },
        LabelKey { key: "more", about: "how far the other one turns" },
    ],
    needs: "the algorithm \"merge\" and bodies with edges, and no more edges than they have",
    fed: |context, options| {
        Fed::by_the_steps(shown(context, options).is_some(), !merged(context).is_empty(), false)
    },
    draw,
};

/// The edges up to the one that the scene wants, else all.
fn shown(context: &Context, options: &Options) -> Option<Vec<Merged>> {
    let mut all = merged(context);
    if let Some(step) = options.number("step") {
        let count = (1..=all.len()).find(|&k| number_of(k) == step)?;
        all.truncate(count);
    }
    (!all.is_empty()).then_some(all)
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(all) = shown(context, options) else { return };
    let turned = match all.as_slice() {
        [.., before, next] if options.gives("step") && next.other.is_some() => {
            straight_on(sketch.since(next.cue), before.edge, next)
        }
        _ => None,
    };
    let whole = !options.gives("step");
    let before = if whole { all.len() } else { all.len() - 1 };
    for (k, edge) in (1..).zip(&all[..before]) {
        let (from, to) = (edge.at, edge.at + edge.edge);
        let role = Role::from(edge.taken);
        sketch.since(edge.cue).part(part("taken", edge.taken));
        arrow(sketch, edge.taken, (from, to), Pen::outline(role));
        // Outside, where nothing else of B ⊖ A is.
        let outside = Anchor::Beside { from: to, to: from, offset: ON_LINE };
        let label = Label::new("step", k.to_string(), outside, role);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    if let Some(next) = all.last().filter(|_| !whole) {
        let count = all.len();
        let later = merged(context).into_iter().skip(count).position(|edge| edge.taken != next.taken);
        choice(sketch.since(next.cue), next, [count, count + 1 + later.unwrap_or(0)], turned);
    }
    if let Some(first) = all.first().filter(|_| before > 0) {
        sketch.since(first.cue);
        let middle = mean(&all.iter().map(|edge| edge.at).collect::<Vec<_>>());
        let anchor = Anchor::point_toward(first.at, first.at - middle);
        let label = Label::new("start", "start", anchor, Role::Muted);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// Draws how the edge before would go on, and how far either next edge turns from that; and says by which
/// arc the one turns that is taken.
fn straight_on(sketch: &mut Sketch, before: DVec2, next: &Merged) -> Option<(Anchor, String)> {
    let u = before.try_normalize()?;
    let ahead = next.at + u * sketch.px(AHEAD);
    sketch.part("straight-on").weight(Weight::Light).line(next.at, ahead, Pen::construction());
    let both = [(next.taken, Some(next.edge), TURN), (next.taken.other(), next.other, TURN * 0.6)];
    let mut own = None;
    for (side, edge, radius) in both {
        let Some(edge) = edge else { continue };
        let (start, turn) = (angle_of(u), libm::atan2(u.perp_dot(edge), u.dot(edge)));
        let radius = sketch.px(radius);
        sketch.part("turn").weight(Weight::Light);
        sketch.arc_arrow(next.at, radius, start, turn, Pen::dimension(side.into()));
        let arc = Anchor::Arc { center: next.at, radius, start, sweep: turn };
        let degrees = format!("${}°$", number(turn.abs().to_degrees()));
        if own.is_none() {
            own = Some((arc, degrees));
        } else {
            let label = Label::new("more", degrees, arc, side.into());
            sketch.label(label.rank(Rank::Word).size(Size::Note));
        }
    }
    own
}

/// Draws the next edge of either body with its number, first that of the one that is taken, which turns less,
/// if an edge is before it by the arc `turned`.
fn choice(sketch: &mut Sketch, next: &Merged, numbers: [usize; 2], turned: Option<(Anchor, String)>) {
    let own = next.at + next.edge;
    let named = |side: Side, number: usize, tip: DVec2| {
        let label = Label::new(key(side), number.to_string(), Anchor::tip(next.at, tip), side.into());
        label.rank(Rank::Word).size(Size::Note)
    };
    if let Some(other) = next.other {
        let (side, tip) = (next.taken.other(), next.at + other);
        let pen = Pen::vector(side.into()).opacity(REJECTED);
        arrow(sketch.part("rejected"), side, (next.at, tip), pen);
        sketch.label(named(side, numbers[1], tip));
    }
    let role = Role::from(next.taken);
    arrow(sketch.part("chosen"), next.taken, (next.at, own), Pen::highlighted(role));
    sketch.label(named(next.taken, numbers[0], own));
    if next.other.is_some() {
        let (anchor, text) = match turned {
            Some((arc, degrees)) => (arc, format!("{degrees}, less")),
            None => (Anchor::middle(next.at, own), "turns less".to_owned()),
        };
        let label = Label::new("less", text, anchor, role);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    sketch.part("reached").marker(next.at, Marker::Diamond, Role::Now, MARKER);
}

/// Draws a body's edge as a vector, B's cased as in B ⊖ A.
fn arrow(sketch: &mut Sketch, side: Side, (from, to): (DVec2, DVec2), pen: Pen) {
    match side {
        Side::A => sketch.arrow(from, to, pen),
        Side::B => sketch.cased_arrow(from, to, pen),
    };
}

/// The key of the label of a body's next edge.
fn key(side: Side) -> &'static str {
    if side == Side::A { "e.A" } else { "e.B" }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn a_choice_shows_both_turns_from_the_edge_before_where_there_is_one() {
        for (step, choice) in [("step = 4", true), ("step = 1", false), ("labels = true", false)] {
            let text = format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-2, -1], [1, -2], [2, 1]] }}
                shapes.B = {{ kind = 'polygon', vertices = [[3.5, 2.5], [7, 1], [8, 3], [5, 5]] }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'merge' }}
                panels = [{{ space = 'configuration', layers = [{{ layer = 'merging', {step} }}] }}]"
            );
            let scene = open_text("merge", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "merge");
            // An arc and its head for each of the two.
            let turns = paths(&figure.drawing.items, "turn").len();
            assert_eq!(turns, if choice { 4 } else { 0 }, "{step}");
            assert_eq!(paths(&figure.drawing.items, "straight-on").is_empty(), !choice, "{step}");
            let labels = labels(&figure);
            assert_eq!(labels.contains_key("less"), !step.starts_with("labels"), "{step}");
            // A's mirrored edges are 1, 3 and 5 of seven.
            let numbers = ["e.A", "e.B"].map(|key| labels.get(key).map(|label| label.0.as_str()));
            let wanted = match step {
                "step = 4" => [Some("5"), Some("4")],
                "step = 1" => [Some("1"), Some("2")],
                _ => [None, None],
            };
            assert_eq!(numbers, wanted, "{step}");
        }
    }
}
