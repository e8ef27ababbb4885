//! One step of EPA on B ⊖ A: the polytope, its edge e nearest to the origin with its distance d, its outward
//! normal nₑ, along which the search looks past that edge, and the vertex w that it finds there and that
//! splits the edge. Of the last one nₑ is −n: n is the normal from A to B, along which B is pushed out.
//!
//! The dashed line is the supporting line of B ⊖ A along nₑ: nothing of B ⊖ A is beyond it. At the last step
//! it would be the line of the nearest edge itself, so that no way out is shorter, and the search stops. Of
//! rounded bodies it looks at the cores alone.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{
    Anchor, Label, MARKER, Marker, Outline, Pen, Rank, SMALL_MARKER, Size, Sketch, Wash, Weight,
};
use crate::figure::text::{Quantity, least};
use crate::geometry::{DVec2, perp};
use crate::scene::NOTES;
use crate::trace::{Event, phrase};

use super::coordinates::coordinates;
use super::cores::{cores, radii, radii_in_words};
use super::simplex::{MOST_PASSING, has_simplexes};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, number_of};

/// How far the supporting line reaches past the nearest edge and past w, page pixels.
const PAST: f64 = 34.0;

/// Opacity of the polytope, and of what the step before added to it.
const FILL: (f64, f64) = (0.1, 0.26);

/// Opacity of the edge that was split.
const SPLIT: f64 = 0.75;

/// The shortest and the longest that nₑ is drawn, page pixels, where one unit of the space is less or more.
const READABLE: [f64; 2] = [24.0, 48.0];

/// What is said of the nearest edge where it comes to be when B is pushed out.
pub(super) const PUSHED: &str = "pushed to $O$";

/// How far from the foot its normal stands, in parts of the way to the farther end of the edge.
const ASIDE: f64 = 0.4;

pub(super) const LAYER: Layer = Layer {
    name: "polytope",
    in_words: phrase(["polytope", "Polytop", "polytope", "politopo"]),
    about: "one step of EPA: the polytope, its nearest edge, the vertex beyond it",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "step",
            takes: Takes::Number,
            default: "the last",
            about: "which polytope, from 1",
        },
        OptionSpec {
            name: "pushed",
            takes: Takes::Flag,
            default: "false",
            about: "at the last step, the push of B by −d nₑ, which brings the nearest edge to O, dotted",
        },
        OptionSpec {
            name: "coordinates",
            takes: Takes::Flag,
            default: "false",
            about: "writes those of the vertices that the search begins with, and of each that is added",
        },
    ],
    labels: &[
        LabelKey { key: "d", about: "distance of the nearest edge from the origin" },
        LabelKey {
            key: "n", about: "the outward normal nₑ of that edge, along which it looks for a vertex"
        },
        LabelKey { key: "w", about: "the vertex beyond the edge, which splits it" },
        LabelKey { key: "vertex", about: "the vertices that are new, with coordinates" },
        LabelKey { key: "stop", about: "at the last step, why it stops" },
        LabelKey { key: "pushed", about: "the nearest edge when B is pushed, with pushed" },
        LabelKey { key: "cores", about: "the difference of the cores, of rounded bodies" },
    ],
    needs: "the algorithm \"gjk\" and bodies that overlap, and no more polytopes than it had",
    fed: |context, options| {
        let [found, any] = [options, &Options::default()].map(|options| shown(context, options));
        let pushed = |(step, _): &(Step, _)| options.flag("pushed", false) && !is_pushed(context, step);
        if NOTES && found.as_ref().is_some_and(pushed) {
            return Fed::Without { option: "pushed", why: "the nearest edge is not yet one of B ⊖ A" };
        }
        Fed::by_the_steps(found.is_some(), any.is_some(), has_simplexes(context))
    },
    draw,
};

/// Whether a push brings the nearest edge to O: at the last step it is one of B ⊖ A, where no radii are.
fn is_pushed(context: &Context, step: &Step) -> bool {
    step.beyond.is_none() && radii(context) == 0.0
}

/// A polytope that the algorithm told, in configuration space.
struct Step {
    /// Its vertices, counter-clockwise.
    vertices: Vec<DVec2>,
    /// The ends of the edge nearest to the origin.
    edge: [DVec2; 2],
    /// Distance of that edge from the origin.
    distance: f64,
    /// Its outward unit normal.
    normal: DVec2,
    /// The vertex of B ⊖ A beyond the edge that is farthest along the normal; `None` where none is beyond.
    beyond: Option<DVec2>,
    /// The triangle by which it is larger than the one before: that one's nearest edge and the vertex beyond.
    added: Option<[DVec2; 3]>,
}

/// What an event tells of a polytope.
fn told(event: &Event) -> Option<Step> {
    let Event::PolytopeExpanded { vertices, nearest, edge, normal, support, beyond } = event else {
        return None;
    };
    let ends = [vertices.get(*edge)?, vertices.get((edge + 1) % vertices.len())?].map(|p| *p);
    let beyond = (*beyond > 0.0).then_some(*support);
    Some(Step {
        vertices: vertices.clone(),
        edge: ends,
        distance: *nearest,
        normal: *normal,
        beyond,
        added: None,
    })
}

/// The step that the scene wants, else the last, and with what it comes.
fn shown(context: &Context, options: &Options) -> Option<(Step, Option<Cue>)> {
    let run = context.run();
    let cues: Vec<(Cue, ())> =
        run.cues(|e| matches!(e, Event::PolytopeExpanded { .. }).then_some(())).collect();
    let wanted = options.number("step").unwrap_or(number_of(cues.len()));
    let (mut step, mut added) = (0, None);
    run.find_told(|event| match event {
        Event::PolytopeExpanded { .. } => {
            step += 1;
            let found = Step { added, ..told(event)? };
            added = found.beyond.map(|w| [found.edge[0], w, found.edge[1]]);
            let cue = cues.get(step - 1).map(|(cue, ())| *cue);
            (number_of(step) == wanted).then_some((found, cue))
        }
        _ => None,
    })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((step, cue)) = shown(context, options) else { return };
    cores(sketch, context);
    sketch.since(cue);
    draw_step(sketch, context, &step, options);
    if options.number("step").is_some() {
        return;
    }
    // Of the search only the end stays: each polytope before it goes when the next one comes.
    let run = context.run();
    let all: Vec<(Cue, Step)> = run.cues(told).collect();
    let mut vertices = 0;
    for ((from, before), (to, _)) in all.iter().zip(all.iter().skip(1)) {
        vertices += before.vertices.len();
        if vertices > MOST_PASSING {
            break;
        }
        sketch.passing([*from, *to], |sketch| draw_step(sketch, context, before, options));
    }
}

/// Draws one step.
fn draw_step(sketch: &mut Sketch, context: &Context, step: &Step, options: &Options) {
    let rounded = radii(context) > 0.0;
    let role = options.role(Role::Now);
    let outline = Outline::polygon(&step.vertices);
    if let Some(triangle) = step.added {
        let [from, added, to] = triangle;
        let before: Vec<DVec2> = step.vertices.iter().filter(|p| **p != added).copied().collect();
        sketch.part("before").area(&Outline::polygon(&before), Some(Wash::faint(role, FILL.0)), None);
        sketch.part("added").area(&Outline::polygon(&triangle), Some(Wash::faint(role, FILL.1)), None);
        sketch.part("split").weight(Weight::Light).line(from, to, Pen::dimension(role).opacity(SPLIT));
    }
    let wash = step.added.is_none().then(|| Wash::faint(role, FILL.0));
    sketch.part("polytope").area(&outline, wash, Some(Pen::vector(role)));
    let foot = step.normal * step.distance;
    sketch.part("nearest").line(step.edge[0], step.edge[1], Pen::highlighted(role).width(4.0));
    let coordinated = options.flag("coordinates", false);
    for &vertex in &step.vertices {
        sketch.part("vertices").marker(vertex, Marker::Diamond, role, SMALL_MARKER);
        if coordinated && step.added.is_none_or(|[_, added, _]| added == vertex) {
            let label =
                Label::new("vertex", coordinates(sketch, context, vertex), Anchor::point(vertex), role);
            sketch.label(label.rank(Rank::Word).size(Size::Note));
        }
    }
    sketch.part("right-angle").right_angle(foot, step.edge[1] - foot, -foot);
    let blue = Pen::highlighted(Role::Translation);
    if options.flag("pushed", false) && is_pushed(context, step) {
        let [from, to] = step.edge.map(|end| end - foot);
        sketch.part("pushed").weight(Weight::Light).line(from, to, Pen::ghost(Role::Difference));
        let label = Label::new("pushed", PUSHED, Anchor::middle(from, to), Role::Difference);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
        sketch.part("push").arrow(foot, DVec2::ZERO, blue);
    } else {
        // O at one end, the right angle at the other: ticks would lie on both.
        sketch.part("distance").line(DVec2::ZERO, foot, blue);
    }
    sketch.detail(&[DVec2::ZERO, foot]);
    let beside = Anchor::middle(DVec2::ZERO, foot);
    // Of rounded bodies the depth is more, by their radii.
    let left =
        if rounded { format!(" - {}", radii_in_words(context).replace(" + ", " - ")) } else { String::new() };
    let rounding = context.scene.query_at(context.time).rounding();
    // Before the last step it is only a bound of the depth.
    let d = match step.beyond {
        Some(_) => format!(r"$d{left} \ge {}$", least(step.distance)),
        None => format!("$d{left} {}$", Quantity::exactly(step.distance).equals(rounding)),
    };
    sketch.label(Label::new("d", d, beside, Role::Translation));
    outward(sketch, step, foot);
    if let Some(w) = step.beyond {
        supporting_line(sketch, (step.normal, foot), w);
        sketch.part("next").marker(w, Marker::HollowDiamond, role, MARKER);
        sketch.label(Label::new("w", "$w$", Anchor::point(w), role).rank(Rank::Point));
    } else {
        let [from, to] = step.edge;
        let beside = Anchor::Beside { from, to, offset: 0.0 };
        let words = if rounded { "no vertex of the cores beyond" } else { "nothing beyond" };
        let stop = Label::new("stop", words, beside, role);
        sketch.label(stop.rank(Rank::Word).size(Size::Note));
    }
}

/// Draws the outward normal of the nearest edge, along which it looks for a vertex.
fn outward(sketch: &mut Sketch, step: &Step, foot: DVec2) {
    let [least, most] = READABLE.map(|px| sketch.px(px));
    // Beside the foot, where it would go on the line from O.
    let far = step.edge.into_iter().max_by(|p, q| p.distance(foot).total_cmp(&q.distance(foot)));
    let from = foot.lerp(far.unwrap_or(foot), ASIDE);
    let tip = from + step.normal * 1.0_f64.max(least).min(most);
    sketch.part("direction").arrow(from, tip, Pen::vector(Role::Ink));
    sketch.label(Label::new("n", "$n_e$", Anchor::tip(from, tip), Role::Ink));
}

/// Draws the line through w square to the normal, past w and past the normal's line.
fn supporting_line(sketch: &mut Sketch, (normal, foot): (DVec2, DVec2), w: DVec2) {
    let along = perp(normal);
    let past = sketch.px(PAST);
    let to = along.dot(foot - w);
    let (lo, hi) = (to.min(0.0) - past, to.max(0.0) + past);
    sketch.part("supporting-line").weight(Weight::Light);
    sketch.line(w + along * lo, w + along * hi, Pen::construction());
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Contour, Segment};
    use crate::figure::layer::tests::{labels, lines, paths};
    use crate::figure::{Figure, draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;
    use crate::trace::Event;

    /// A step of the polytope of two polygons, and how many steps there are; `step` from 1.
    fn step(step: usize) -> (Figure, usize) {
        step_with(step, "")
    }

    /// A step of them with more options of the layer.
    fn step_with(step: usize, options: &str) -> (Figure, usize) {
        let (figure, steps, _) = told_with(step, options);
        (figure, steps)
    }

    /// A step of them with more options of the layer, how many steps there are, and what is told.
    fn told_with(step: usize, options: &str) -> (Figure, usize, String) {
        let text = format!(
            "shapes.A = {{ kind = 'polygon',
                vertices = [[-2, -1.5], [1, -2.5], [2.5, 0], [1, 2], [-1.5, 1]] }}
            shapes.B = {{ kind = 'polygon', vertices = [[0, 0], [4, -1], [5, 2], [2, 4], [-1, 3]] }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
            panels = [{{ space = 'configuration',
                layers = [{{ layer = 'polytope', step = {step}{options} }}] }}]"
        );
        let scene = open_text("epa", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let steps = plan.own_run().events().filter(|e| matches!(e, Event::PolytopeExpanded { .. })).count();
        let notes = plan.warnings.iter().map(|note| note.fault.to_string()).collect();
        (draw(&plan, plan.theme, "epa"), steps, notes)
    }

    #[test]
    fn of_rounded_bodies_the_cores_are_drawn_and_their_depth_is_less_by_the_radii() {
        let text = "shapes.A = { kind = 'box', half_extents = [1, 1], radius = 0.25 }
            shapes.B = { kind = 'box', half_extents = [1, 1], radius = 0.5, position = [1.5, 0.25] }
            query = { kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }
            panels = [{ space = 'configuration', layers = ['difference', 'polytope'] }]";
        let scene = open_text("epa", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let depth = -plan.own_run().separation().unwrap().separation;
        let figure = draw(&plan, plan.theme, "epa");
        let labels = labels(&figure);
        assert_eq!((depth, labels["d"].1), (1.25, 0.5), "{labels:?}");
        assert!(
            labels["d"].0.contains("d - r_1 - r_2 =") && labels["stop"].0.contains("cores"),
            "{labels:?}"
        );
        assert_eq!(paths(&figure.drawing.items, "cores").len(), 1);
    }

    #[test]
    fn the_distance_written_is_the_one_drawn_and_only_the_last_step_stops() {
        let (_, steps) = step(1);
        assert_eq!(steps, 3);
        for k in 1..=steps {
            let (figure, _) = step(k);
            let labels = labels(&figure);
            let drawn = lines(&figure, "distance")[0] / figure.panels[0].frame.scale;
            // Before the last step what is written is a lower bound as what is drawn is one.
            let less = if k < steps { 0.0..0.01 } else { -0.005..0.005 };
            assert!(less.contains(&(drawn - labels["d"].1)), "step {k}: {drawn} is not {:?}", labels["d"]);
            assert_eq!(labels.contains_key("stop"), k == steps, "step {k}");
            assert_eq!(labels.contains_key("w"), k < steps, "step {k}");
            assert_eq!(labels["d"].0.contains(r"\ge"), k < steps, "only the last one is the depth");
            assert_eq!(paths(&figure.drawing.items, "vertices").len(), k + 2);
        }
    }

    #[test]
    fn the_push_is_as_long_as_the_depth_and_comes_with_the_last_step_alone() {
        let (_, steps) = step(1);
        for k in 1..=steps {
            let (figure, _, notes) = told_with(k, ", pushed = true");
            assert_eq!(notes.contains("`pushed` of `polytope` draws nothing"), k < steps, "{notes}");
            let last = usize::from(k == steps);
            let found = ["pushed", "distance"].map(|part| paths(&figure.drawing.items, part).len().min(1));
            assert_eq!(found, [last, 1 - last], "step {k}");
            let kept = ["split", "added", "before"].map(|part| paths(&figure.drawing.items, part).len());
            assert_eq!(kept, [usize::from(k > 1); 3], "step {k}");
            // It is filled once: by itself, or as the one before and what was added to that.
            let polytope = paths(&figure.drawing.items, "polytope")[0];
            assert_eq!(polytope.fill.is_some(), k == 1, "step {k}");
            if k == steps {
                // The pushed edge runs through O.
                let o = figure.panels[0].frame.page(DVec2::ZERO);
                let Contour::Segments(edge) = &paths(&figure.drawing.items, "pushed")[0].contour else {
                    panic!("straight")
                };
                let [Segment::Move(p), Segment::Line(q)] = edge[..] else { panic!("{edge:?}") };
                let off = ((o - p).dx * (q - p).dy - (o - p).dy * (q - p).dx).abs() / (q - p).length();
                assert!(off < 1e-6, "{off}");
            }
        }
    }
}
