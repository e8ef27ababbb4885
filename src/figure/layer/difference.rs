//! B ⊖ A in configuration space: its area, its edges in the colour of the body that each comes from (B's
//! cased). Its vertices have marks where the layer "vertices" names them. Round bodies make it an arc.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::difference::{Difference, Edge};
use crate::figure::runs::tells_difference;
use crate::figure::sketch::{Anchor, Label, Pen, Piece, Rank, Size, Sketch, Wash, Weight};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::trace::{Event, phrase};

use crate::scene::{NOTES, When};

use super::difference_name::{called, name};
use super::edge_cues::EdgeCues;
use super::facing::{faces_away, velocity_along};
use super::half_extents::ON_LINE;
use super::held;
use super::step_numbers::step_numbers;
use super::unbuilt::unbuilt;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, STEPS, Shows, Takes, Tells, fade, number_of};

/// Width, page pixels, and opacity of an edge that faces away from the ray.
const THIN: (f64, f64) = (1.25, 0.5);

/// How many iterations are drawn at most; more are a blur.
const MOST: usize = 6;

/// Width of the edges of earlier iterations, page pixels.
const EARLIER: f64 = 1.25;

/// Opacity of the first iteration, and of the last but one.
const SERIES: [f64; 2] = [0.3, 0.8];

/// How far from a vertex an edge may begin that begins there, in parts of the largest coordinate: some
/// roundings, and far below what is seen.
const BEGINS: f64 = 1e-12;

pub(super) const LAYER: Layer = Layer {
    name: "difference",
    in_words: phrase([
        "difference",
        "Minkowski-Differenz",
        "différence de Minkowski",
        "diferencia de Minkowski",
    ]),
    about: "the Minkowski difference B ⊖ A, edges by source",
    shows: Shows::Configuration,
    tells: Tells::Built,
    options: &[
        OptionSpec {
            name: "at",
            takes: Takes::When(&[When::START, When::HIT, When::CLOSEST, When::END, STEPS]),
            default: "the panel's moment",
            about: "when, or at every step of the algorithm",
        },
        OptionSpec {
            name: "culled",
            takes: Takes::Word(&["same", "thin"]),
            default: "\"same\"",
            about: "how edges look that face away from the ray",
        },
        OptionSpec {
            name: "sources",
            takes: Takes::Flag,
            default: "false",
            about: "labels \"from A\" and \"from B\"",
        },
        OptionSpec {
            name: "numbers",
            takes: Takes::Flag,
            default: "false",
            about: "names the steps t₁, t₂, …",
        },
        OptionSpec {
            name: "built",
            takes: Takes::Flag,
            default: "true",
            about: "false: faint and without vertices, for an algorithm that never builds it",
        },
        OptionSpec {
            name: "fill",
            takes: Takes::Flag,
            default: "true",
            about: "unbuilt, its faint area, with the name in it",
        },
        OptionSpec {
            name: "dotted",
            takes: Takes::Flag,
            default: "false",
            about: "the outline alone, dotted, named with its moment: where it is at another one",
        },
    ],
    labels: &[
        LabelKey { key: "difference", about: "its name, B ⊖ A" },
        LabelKey { key: "difference'", about: "its name, and when it is there, with dotted" },
        LabelKey { key: "from.A", about: "at an edge of A, with sources" },
        LabelKey { key: "from.B", about: "at an edge of B, with sources" },
        LabelKey { key: "step", about: "numbers of the steps" },
    ],
    needs: "two convex bodies; for \"steps\" an advancement",
    fed: |context, options| match options.word("at", "") {
        STEPS => Fed::by_the_scene(!context.steps().is_empty()),
        When::HIT | When::CLOSEST if when(context, options).is_none() => {
            Fed::by_the_answer(false, context.asks_for_a_hit())
        }
        _ => {
            let time = when(context, options).unwrap_or(context.difference_time());
            let fed = Fed::by_the_scene(difference(context, time).is_some());
            let is_without =
                NOTES && fed == Fed::Yes && is_culled(options) && velocity_along(context).is_none();
            if is_without { Fed::Without { option: "culled", why: "there is no ray" } } else { fed }
        }
    },
    draw,
};

/// B ⊖ A at a time, as the algorithm that tells of it found it.
pub(super) fn difference(context: &Context, time: f64) -> Option<Difference> {
    Difference::of(context.difference_at(time)?.told(tells_shape))
}

/// A vertex of B ⊖ A and where it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Origin {
    /// Its place, in configuration space.
    pub(super) at: DVec2,
    /// The number of A's vertex.
    pub(super) a: usize,
    /// The number of B's vertex.
    pub(super) b: usize,
}

impl Origin {
    /// The number of a body's vertex.
    pub(super) fn of(&self, side: Side) -> usize {
        if side == Side::A { self.a } else { self.b }
    }
}

/// The vertices of B ⊖ A at a time, each a vertex of B less a vertex of A: an edge of the one body begins
/// there, and the other's supporting vertex is told with it.
pub(super) fn origins(context: &Context, found: &Difference, time: f64) -> Vec<Origin> {
    if found.edges.is_empty() {
        let at = |at| Origin { at, a: 0, b: 0 };
        return found.center.map(at).into_iter().collect();
    }
    let places = |side| {
        let count = context.body(side).map_or(0, |body| body.shape.vertices.len());
        (0..count).filter_map(|k| context.vertex(side, k, time)).collect::<Vec<_>>()
    };
    let [a, b] = Side::BOTH.map(places);
    let of = |side| if side == Side::A { &a } else { &b };
    let size = a.iter().chain(&b).map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let origin = |edge: &Edge| {
        let other = if edge.source == Side::A { Side::B } else { Side::A };
        let still = *of(other).get(edge.vertex)?;
        let sought = if edge.source == Side::A { still - edge.from } else { still + edge.from };
        let shape = &context.body(edge.source)?.shape;
        let off = |k: usize| of(edge.source).get(k).map_or(f64::INFINITY, |p| p.distance(sought));
        let nearest = |all: &[usize]| all.iter().copied().min_by(|&k, &l| off(k).total_cmp(&off(l)));
        // An edge with vertices within it is told by one of its pieces.
        let end = nearest(&shape.edge_ends(edge.index)?).filter(|&k| off(k) <= BEGINS * size);
        let own = end.or_else(|| nearest(&shape.core))?;
        let (a, b) = if edge.source == Side::A { (own, edge.vertex) } else { (edge.vertex, own) };
        Some(Origin { at: edge.from, a, b })
    };
    found.edges.iter().filter_map(origin).collect()
}

/// An event that tells of the difference, or that another search for it begins.
fn tells_shape(event: &Event) -> Option<&Event> {
    (tells_difference(event) || matches!(event, Event::Started { .. })).then_some(event)
}

/// The time at which the scene wants it; `None` where it does not say, or the answer has no such moment.
fn when(context: &Context, options: &Options) -> Option<f64> {
    Some(context.moment(&options.when("at")?)?.time)
}

/// A point inside of B ⊖ A.
fn middle(found: &Difference) -> DVec2 {
    let points = found.outline().sampled();
    points.iter().sum::<DVec2>() / number_of(points.len().max(1))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    if options.word("at", "") == STEPS {
        steps(sketch, context, options);
        return;
    }
    let time = when(context, options).unwrap_or(context.difference_time());
    let Some(found) = difference(context, time) else { return };
    if options.flag("dotted", false) {
        dotted(sketch, context, options, (time, &found));
        return;
    }
    held::difference(sketch, context, middle(&found));
    if !options.flag("built", true) {
        unbuilt(sketch.since(None), context, options, (&found, time));
        return;
    }
    let cues = EdgeCues::at(context, time);
    area(sketch.since(cues.whole), options, &found);
    let away = is_culled(options).then(|| faces_away(context));
    edges(sketch, &found, |edge, pen| {
        let thin = away.as_ref().is_some_and(|away| away(edge));
        let pen = if thin { pen.width(THIN.0).opacity(THIN.1) } else { pen };
        (pen, cues.of(edge))
    });
    name(sketch.since(cues.whole), context, options, (&found, time));
    if options.flag("sources", false) {
        sources(sketch, context, &found);
    }
    cues.told_in_turn(sketch, &found.edges, |edge| found.drawn(edge));
}

/// Draws where it is at another moment: its outline, dotted, with its name and that moment.
fn dotted(sketch: &mut Sketch, context: &Context, options: &Options, (time, found): (f64, &Difference)) {
    let (role, outline) = (options.role(Role::Difference), found.outline());
    sketch.since(EdgeCues::at(context, time).whole);
    sketch.part("then").weight(Weight::Light).area(&outline, None, Some(Pen::ghost(role)));
    let text = format!("{} at $t = {}$", called(context), number(time));
    let label = Label::new("difference'", text, Anchor::inside(&outline), role);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Draws the area, and its line where no edge of a body is.
fn area(sketch: &mut Sketch, options: &Options, found: &Difference) {
    let role = options.role(Role::Difference);
    sketch.part("difference").area(&found.outline(), Some(Wash::theme(role)), None);
    arcs(sketch, found, Pen::outline(role));
}

/// Draws the outline where it is no body's edge: the arcs about the core's vertices.
pub(super) fn arcs(sketch: &mut Sketch, found: &Difference, pen: Pen) {
    sketch.part("arcs");
    for piece in found.outline().pieces {
        if let Piece::Arc { center, radius, start, sweep } = piece {
            if found.edges.is_empty() {
                sketch.circle(center, radius, None, Some(pen));
            } else {
                sketch.arc(center, radius, start, sweep, pen);
            }
        }
    }
}

/// Draws an edge in the colour of the body that it comes from: A's as a plain line, B's as a cased one.
pub(super) fn draw_edge(sketch: &mut Sketch, source: Side, (from, to): (DVec2, DVec2), pen: Pen) {
    match source {
        Side::A => sketch.line(from, to, pen.round()),
        Side::B => sketch.cased(from, to, pen),
    };
}

/// Draws the edges, as one part for each body that they come from; `pen` changes the pen of an outline, and
/// says with what an edge comes.
fn edges(sketch: &mut Sketch, found: &Difference, pen: impl Fn(&Edge, Pen) -> (Pen, Option<Cue>)) {
    for (side, part) in [(Side::A, "edges-A"), (Side::B, "edges-B")] {
        sketch.part(part);
        for edge in found.edges.iter().filter(|e| e.source == side) {
            let (pen, cue) = pen(edge, Pen::outline(side.into()));
            draw_edge(sketch.since(cue), side, found.drawn(edge), pen);
        }
    }
}

/// Writes `from A` and `from B` outside the first edge of each that faces up, away from the origin.
fn sources(sketch: &mut Sketch, context: &Context, found: &Difference) {
    for (side, key) in [(Side::A, "from.A"), (Side::B, "from.B")] {
        let own = found.edges.iter().filter(|e| e.source == side);
        let Some(edge) =
            own.max_by(|e, f| e.normal.y.total_cmp(&f.normal.y).then(e.normal.x.total_cmp(&f.normal.x)))
        else {
            continue;
        };
        let (from, to) = found.drawn(edge);
        // Counter-clockwise, so that outside is on the right of from → to, and on the left of to → from.
        let anchor = Anchor::Beside { from: to, to: from, offset: ON_LINE };
        let text = format!("from {}", context.name(side));
        sketch.label(Label::new(key, text, anchor, side.into()).rank(Rank::Measure).size(Size::Note));
    }
}

/// Whether the scene wants edges thin that face away from the ray.
fn is_culled(options: &Options) -> bool {
    options.word("culled", "same") == "thin"
}

/// Draws every iteration's difference, fainter the earlier; the last one whole.
fn steps(sketch: &mut Sketch, context: &Context, options: &Options) {
    let at = |(k, time): (usize, f64)| Some((k, difference(context, time)?));
    let all: Vec<(usize, Difference)> = thinned(&context.steps()).into_iter().filter_map(at).collect();
    let Some(((number, last), before)) = all.split_last() else { return };
    for ((step, found), opacity) in before.iter().zip(fade(SERIES, before.len())) {
        let cue = context.known(&When::Step(*step));
        sketch.since(cue);
        arcs(sketch, found, Pen::outline(options.role(Role::Difference)).width(EARLIER).opacity(opacity));
        edges(sketch, found, |_, pen| (pen.width(EARLIER).opacity(opacity), cue));
    }
    let cue = context.known(&When::Step(*number));
    area(sketch.since(cue), options, last);
    edges(sketch, last, |_, pen| (pen, cue));
    name(sketch, context, options, (last, context.difference_time()));
    step_numbers(sketch, context, &all, options.flag("numbers", false));
}

/// The steps that are drawn, each with its number, from 1: at most [`MOST`]. An advancement closes in, so
/// that its first steps are the ones that differ; those, and the last.
pub(super) fn thinned(steps: &[f64]) -> Vec<(usize, f64)> {
    let all = (1..).zip(steps.iter().copied());
    all.filter(|&(k, _)| k < MOST || k == steps.len()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Path;
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn vertices_have_marks_only_where_they_are_asked_for() {
        for (layers, marks) in [("'difference'", 0), ("'difference', 'vertices'", 7)] {
            let text = format!(
                "shapes.A = {{ kind = 'regular-polygon', edges = 3, circumradius = 1 }}
                shapes.B = {{ kind = 'regular-polygon', edges = 4, circumradius = 1.3, angle_deg = 3 }}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration', layers = [{layers}] }}, {{ layers = ['shapes'] }}]"
            );
            let scene = open_text("many", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "many");
            let filled = |path: &&&Path| path.fill.is_some() && path.stroke.is_none();
            let found = ["vertices", "vertex"].map(|part| paths(&figure.drawing.items, part));
            assert_eq!(found.iter().flatten().filter(filled).count(), marks, "{layers}");
        }
    }

    #[test]
    fn edges_that_face_away_from_the_ray_are_thin_and_of_a_segment_one_of_its_two() {
        let pairs = [
            "shapes.A = { kind = 'capsule', points = [[-1, 0], [1, 0]], radius = 0, velocity = [2, -6],
                position = [0, 4] }
            shapes.B = { kind = 'capsule', points = [[0, -1], [0, 1]], radius = 0 }",
            "shapes.A = { kind = 'box', half_extents = [1, 0.5], velocity = [4, -3], position = [-4, 3] }
            shapes.B = { kind = 'box', half_extents = [1, 1], angle_deg = 20 }",
        ];
        for (pair, algorithm, wanted) in [
            (pairs[0], "'ray-cast'", (2, 4)),
            (pairs[1], "'ray-cast'", (4, 8)),
            (pairs[1], "'ray-clipping'", (4, 8)),
        ] {
            let text = format!(
                "{pair}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'], algorithm = {algorithm} }}
                panels = [{{ space = 'configuration', time = 'start',
                    layers = [{{ layer = 'difference', culled = 'thin' }}] }}]"
            );
            let scene = open_text("culled", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let context = plan.panels[0].context(&scene, &plan.runs);
            let (found, away) = (difference(&context, 0.0).unwrap(), faces_away(&context));
            let count = found.edges.iter().filter(|edge| away(edge)).count();
            assert_eq!((count, found.edges.len()), wanted, "{algorithm}");
            // A's edges are plain lines.
            let drawn = draw(&plan, plan.theme, "culled");
            let widths = paths(&drawn.drawing.items, "edges-A");
            let thin = widths.iter().filter(|path| path.stroke.as_ref().unwrap().width == THIN.0).count();
            assert_eq!((thin, widths.len()), (wanted.0 / 2, wanted.1 / 2), "{algorithm}");
        }
    }

    #[test]
    fn of_many_steps_the_first_and_the_last_are_drawn() {
        let steps: Vec<f64> = (0..23).map(f64::from).collect();
        let kept: Vec<usize> = thinned(&steps).into_iter().map(|(k, _)| k).collect();
        assert_eq!(kept, [1, 2, 3, 4, 5, 23]);
    }

    #[test]
    fn few_steps_are_all_drawn() {
        assert_eq!(thinned(&[0.0, 0.5]), [(1, 0.0), (2, 0.5)]);
        assert!(thinned(&[]).is_empty());
    }
}
