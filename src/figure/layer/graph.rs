//! The separation s of the bodies against time t, with the steps of an advancement on it.
//!
//! A step at t₁ with separation s₁ assumes the worst: that s falls as fast as the bound μ allows. The dashed
//! line of slope −μ from (t₁, s₁) meets the axis at t₂, up to where nothing can touch; there the next step
//! looks again. The curve is never below these lines, and the steps shrink towards the contact.
//!
//! The graph fills its panel; its axes have scales of their own, so that it stands alone there.

use crate::collision::Answer;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Outline, Pen, Rank, Size, Sketch, Weight};
use crate::figure::text::number;
use crate::geometry::DVec2;
use crate::scene::When;
use crate::trace::Event;

use super::chart::{Chart, floor, separations};
use super::kinks;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Room around the graph, page pixels: left, right, below, above.
const ROOM: [f64; 4] = [46.0, 30.0, 44.0, 30.0];

/// How many steps are drawn; the later ones are a blur at the contact.
const MOST: usize = 12;

/// The least height of a separation that is named, page pixels: that of its letters.
const NAMED: f64 = 24.0;

/// The least distance of the numbers of two steps along the axis, page pixels.
const GAP: f64 = 22.0;

/// The least distance of two steps along the axis that have their times below their numbers, page pixels.
const VALUE_GAP: f64 = 30.0;

/// The share of a line of fastest approach beside which its words stand: at its foot are the times.
const ABOVE_AXIS: f64 = 0.6;

/// Room below for the times, page pixels.
const VALUE_ROOM: f64 = 16.0;

pub(super) const LAYER: Layer = Layer {
    name: "graph",
    about: "separation against time, with the steps of an advancement",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "lines",
            takes: Takes::Flag,
            default: "true",
            about: "the lines along which the separation could fall at most, to the next step",
        },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the times, the separations and the speed of the first line",
        },
        OptionSpec {
            name: "tolerance",
            takes: Takes::Flag,
            default: "false",
            about: "the separation at which it stops, as a line",
        },
        OptionSpec {
            name: "kink",
            takes: Takes::Flag,
            default: "false",
            about: "marks the sharpest kink of the curve, where another vertex becomes the nearest",
        },
        OptionSpec {
            name: "level",
            takes: Takes::Flag,
            default: "false",
            about: "separations to the panel's scale, above the height of B's closest point at the first \
                    step: level with a panel beside it of the same view",
        },
    ],
    labels: &[
        LabelKey { key: "t", about: "the axis of time" },
        LabelKey { key: "s", about: "the axis of separation" },
        LabelKey { key: "step", about: "the times of the steps" },
        LabelKey { key: "more", about: "how many steps follow those that are drawn" },
        LabelKey { key: "s_1", about: "the separation at the first step" },
        LabelKey { key: "s_k", about: "the separation at a later step, where it is high enough" },
        LabelKey { key: "worst", about: "the first of the lines of the fastest approach" },
        LabelKey { key: "tolerance", about: "the separation at which it stops, with tolerance" },
        LabelKey { key: "kink", about: "the sharpest kink of the curve, with kink" },
    ],
    needs: "an algorithm that advances in steps",
    fed: |context, _| Fed::by_the_scene(!steps(context).is_empty()),
    draw,
};

/// A step of the advancement.
#[derive(Clone, Copy)]
struct Step {
    /// When it looks.
    time: f64,
    /// The separation then.
    separation: f64,
    /// The most by which s falls in a unit of time, for all the algorithm knows.
    bound: f64,
    /// When the next one looks.
    next: Option<f64>,
}

/// The steps that the algorithm told.
fn steps(context: &Context) -> Vec<Step> {
    let told = |event: &Event| match *event {
        Event::Advanced { at, separation, bound, next, .. } => {
            Some(Step { time: at.time, separation, bound, next })
        }
        _ => None,
    };
    context.run().told(told).collect()
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let all = steps(context);
    let Some(last) = all.last() else { return };
    let until = if context.hit_time().is_some() && last.time > 0.0 { last.time } else { 1.0 };
    let times: Vec<f64> = all.iter().take(MOST).map(|step| step.time).collect();
    let points = separations(context, until, &times);
    let highest = points.iter().map(|p| p.y).fold(all[0].separation, f64::max);
    let values = options.flag("values", false);
    let [left, right, below, above] = ROOM;
    let room = [left, right, if values { below + VALUE_ROOM } else { below }, above];
    let most = DVec2::new(until, highest);
    let chart = match floor(context).filter(|_| options.flag("level", false)) {
        Some(height) => Chart::level(sketch, context, [left, right, above], (height, most)),
        None => Chart::new(sketch, context, room, (0.0, most)),
    };
    chart.axes(sketch, [("t", "$t$"), ("s", "$s$")]);
    if options.flag("lines", true) {
        worst(sketch, (context, &chart), &all, values);
    }
    if options.flag("tolerance", false) {
        tolerance(sketch, (context, &chart));
    }
    let role = options.role(Role::Translation);
    let curve: Vec<DVec2> = points.iter().map(|p| chart.place(p.x, p.y)).collect();
    sketch
        .since(None)
        .part("curve")
        .weight(Weight::Background)
        .stroke(&Outline::polyline(&curve), Pen::outline(role));
    if options.flag("kink", false) {
        kinks::mark(sketch, context, &chart, &points);
    }
    marks(sketch, (context, &chart), &all, (role, values));
}

/// Draws how s would fall at the fastest from each step, to where the next one begins.
fn worst(sketch: &mut Sketch, (context, chart): (&Context, &Chart), all: &[Step], values: bool) {
    for (k, step) in all.iter().take(MOST).enumerate() {
        let Some(next) = step.next.filter(|t| *t <= chart.most.x) else { continue };
        let look = |k| context.cue(|event| matches!(event, Event::Advanced { step, .. } if *step == k));
        sketch.since(look(k + 1));
        let (from, to) = (chart.place(step.time, step.separation), chart.place(next, 0.0));
        let dashed = Pen::construction();
        sketch.part("worst").weight(Weight::Background).line(from, to, dashed);
        if k == 0 {
            let speed = values.then(|| format!("${}$ in a unit of time", number(step.bound)));
            let lines = std::iter::once("fastest approach".to_owned()).chain(speed).collect();
            let label = Label::new("worst", "", Anchor::middle(from, from.lerp(to, ABOVE_AXIS)), Role::Muted);
            sketch.label(Label { lines, ..label }.rank(Rank::Word).size(Size::Note));
        }
        if let Some(then) = all.get(k + 1).filter(|_| k + 1 < MOST) {
            sketch.since(look(k + 2));
            let up = chart.place(then.time, then.separation);
            sketch.part("look").weight(Weight::Background).line(to, up, Pen::dimension(Role::Now));
            left(sketch, (k + 2, then), [to, up], chart.along(sketch, then.time - step.time), values);
        }
    }
}

/// Draws the separation at which the algorithm stops over all times.
fn tolerance(sketch: &mut Sketch, (context, chart): (&Context, &Chart)) {
    let Answer::Impact(impact) = &context.run().answer else { return };
    let [from, to] = [0.0, chart.most.x].map(|time| chart.place(time, impact.tolerance));
    sketch.since(None).part("tolerance").weight(Weight::Background).line(
        from,
        to,
        Pen::dimension(Role::Muted),
    );
    let text = format!("tolerance ${}$", number(impact.tolerance));
    let label = Label::new("tolerance", text, Anchor::middle(from, to), Role::Muted);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Names the separation left at a step, beside its line from the axis to the curve; with its value, or
/// where that line is too short, at the curve, if the step is not too near to the one before.
fn left(sketch: &mut Sketch, (k, step): (usize, &Step), [foot, top]: [DVec2; 2], gap: f64, values: bool) {
    let high = !values && sketch.on_page(top.distance(foot)) >= sketch.fitted(NAMED);
    if !high && gap < sketch.fitted(GAP) {
        return;
    }
    let value = if values { format!(" = {}", number(step.separation)) } else { String::new() };
    let out = DVec2::new(1.0, 1.0);
    let anchor = if high { Anchor::middle(foot, top) } else { Anchor::point_toward(top, out) };
    sketch
        .label(Label::new("s_k", format!("$s_{{{k}}}{value}$"), anchor, Role::Translation).rank(Rank::Word));
}

/// Marks the steps on the curve, which has a role, and on the axis of time, numbered where there is room.
fn marks(
    sketch: &mut Sketch,
    (context, chart): (&Context, &Chart),
    all: &[Step],
    (role, values): (Role, bool),
) {
    let (mut free, mut wide) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    for (k, step) in (1..).zip(all.iter().take(MOST)) {
        sketch.since(context.known(&When::Step(k)));
        let on_axis = chart.place(step.time, 0.0);
        let on_curve = chart.place(step.time, step.separation);
        sketch.part("steps").weight(Weight::Background);
        chart.tick(sketch, step.time, Role::Now);
        sketch.marker(on_curve, Marker::HollowDiamond, Role::Now, MARKER);
        let along = chart.along(sketch, step.time);
        if along >= free {
            free = along + sketch.fitted(GAP);
            let mut lines = vec![format!("$t_{{{k}}}$")];
            if values && along >= wide {
                wide = along + sketch.fitted(VALUE_GAP);
                lines.push(format!("${}$", number(step.time)));
            }
            let anchor = Anchor::Tick { at: on_axis, toward: DVec2::NEG_Y };
            let label = Label { lines, ..Label::new("step", "", anchor, Role::Now) };
            sketch.label(label.size(Size::Note));
        }
    }
    if let Some(next) = all.get(MOST) {
        let more = Label::new(
            "more",
            format!("{} more steps", all.len() - MOST),
            Anchor::point_toward(chart.place(next.time, 0.0), DVec2::X),
            Role::Muted,
        );
        sketch.since(context.answered()).label(more.rank(Rank::Word).size(Size::Note));
    }
    if let Some(first) = all.first() {
        let anchor = Anchor::point_toward(chart.place(first.time, first.separation), DVec2::X);
        let text = format!("$s_1 = {}$", number(first.separation));
        sketch.label(Label::new("s_1", text, anchor, role));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Contour, Segment};
    use crate::figure::layer::tests::{paths, points};
    use crate::figure::{Figure, draw, plan};
    use crate::scene::open_text;

    /// A box that turns towards a polygon, with a graph of it.
    fn graph(algorithm: &str, values: bool) -> Result<(Figure, Vec<Step>), String> {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1.5, 0.5], position = [-4, -1], velocity = [7, 2],
                angle_deg = 20, angular_velocity_deg = 90 }}
            shapes.B = {{ kind = 'polygon', vertices = [[2, -1], [5, -2], [6, 1], [3, 2]] }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = '{algorithm}' }}
            panels = [{{ view = [0, 0, 4, 3], layers = [{{ layer = 'graph', values = {values} }}] }}]"
        );
        let scene = open_text("graph", &text).unwrap().scene;
        let plan = plan(&scene).map_err(|problems| format!("{problems:?}"))?;
        let steps = steps(&plan.panels[0].context(&scene, &plan.runs));
        Ok((draw(&plan, plan.theme, "graph"), steps))
    }

    #[test]
    fn each_line_of_the_fastest_approach_ends_where_the_next_step_begins_and_is_never_above_the_curve() {
        let (figure, steps) = graph("conservative-advancement", false).unwrap();
        assert!(steps.len() > 3);
        let ends = |part: &str| -> Vec<Vec<crate::drawing::Point>> {
            let points = |path: &crate::drawing::Path| match &path.contour {
                Contour::Segments(segments) => segments
                    .iter()
                    .filter_map(|s| match *s {
                        Segment::Move(p) | Segment::Line(p) => Some(p),
                        _ => None,
                    })
                    .collect(),
                Contour::Circle { .. } => Vec::new(),
            };
            paths(&figure.drawing.items, part).into_iter().map(points).collect()
        };
        let (lines, looks) = (ends("worst"), ends("look"));
        for (line, look) in lines.iter().zip(&looks) {
            assert!((line[1] - look[0]).length() < 1e-9, "{line:?} does not end at {look:?}");
        }
        let curve = &ends("curve")[0];
        for [p, q] in lines.iter().map(|line| [line[0], line[1]]) {
            for c in curve.iter().filter(|c| c.x > p.x && c.x < q.x) {
                // On the page y is down.
                let under = p.y + (q.y - p.y) * (c.x - p.x) / (q.x - p.x);
                assert!(c.y <= under + 1e-6, "the curve falls below the line at {c:?}");
            }
        }
    }

    #[test]
    fn level_with_a_picture_of_the_same_view_separations_are_as_long_as_there() {
        let view = "view = [-2, -2, 14, 8]";
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1.2, 0.4], position = [0, 6], angle_deg = 70,
                velocity = [9, -5], angular_velocity_rad = -4 }}
            shapes.B = {{ kind = 'polygon', vertices = [[-2, 0.5], [-2, -1], [13, -1], [13, 0.5]] }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
                tolerance = 0.5 }}
            panels = [{{ {view}, layers = [{{ layer = 'separation', at = 'steps' }}] }},
                {{ {view}, layers = [{{ layer = 'graph', level = true }}] }}]"
        );
        let scene = open_text("level", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "level");
        let ends = |part| paths(&figure.drawing.items, part).into_iter().map(points).collect::<Vec<_>>();
        // Of each step after the first the line from the axis of time to the curve, and the one from A to B.
        let (looks, lines) = (ends("look"), ends("separation"));
        let level = |[p, q]: [crate::drawing::Point; 2]| (p.y - q.y).abs() < 1e-6;
        let drawn = |look: &[_]| lines.iter().any(|l| level([l[0], look[1]]) && level([l[1], look[0]]));
        assert!(looks.len() > 1 && looks.iter().all(|look| drawn(look)), "{looks:?} in {lines:?}");
    }

    #[test]
    fn values_are_those_of_the_steps_and_only_written_where_they_are_asked_for() {
        let (figure, steps) = graph("conservative-advancement", true).unwrap();
        let said = |figure: &Figure, key: &str| -> Vec<String> {
            let placed = figure.panels.iter().flat_map(|panel| &panel.placed);
            let lines = placed.filter(|label| label.key == key).flat_map(|label| &label.lines);
            lines.map(|(_, line)| line.markup.clone()).collect()
        };
        let times = said(&figure, "step");
        assert_eq!(times[..2], ["$t_{1}$", "$0$"]);
        assert_eq!(times[2..4], ["$t_{2}$".to_owned(), format!("${}$", number(steps[1].time))]);
        assert!(said(&figure, "worst").contains(&format!("${}$ in a unit of time", number(steps[0].bound))));
        assert_eq!(said(&figure, "s_k")[0], format!("$s_{{2}} = {}$", number(steps[1].separation)));
        let (plain, _) = graph("conservative-advancement", false).unwrap();
        assert_eq!(said(&plain, "s_k")[0], "$s_{2}$");
        assert!(said(&plain, "step").iter().all(|line| line.starts_with("$t_")));
    }

    #[test]
    fn the_curve_of_fast_spins_goes_through_every_step_and_the_axes_keep_their_names() {
        let text = "
            shapes.A = { kind = 'box', half_extents = [2, 0.12], angular_velocity_deg = 3600 }
            shapes.B = { kind = 'circle', radius = 0.3, position = [5, 0.5], velocity = [-4, 0] }
            query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
                tolerance = 1e-3 }
            canvas = { width = 1100, height = 620 }
            panels = [{ layers = ['graph'] }]";
        let scene = open_text("graph", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let context = plan.panels[0].context(&scene, &plan.runs);
        let steps = steps(&context);
        assert!(steps.len() > 2 * MOST);
        let times: Vec<f64> = steps.iter().take(MOST).map(|step| step.time).collect();
        let curve = separations(&context, 1.0, &times);
        for step in steps.iter().take(MOST) {
            let on = curve.iter().find(|p| p.x == step.time).unwrap();
            assert!((on.y - step.separation).abs() < 1e-9, "{on} {}", step.separation);
        }
        // In each of ten turns the box comes near twice and goes away twice.
        let turns = curve.windows(3).filter(|p| (p[1].y - p[0].y) * (p[2].y - p[1].y) < 0.0).count();
        assert!((38..=42).contains(&turns), "{turns}");
        let figure = draw(&plan, plan.theme, "graph");
        let keys: Vec<_> = figure.panels[0].placed.iter().map(|label| label.key).collect();
        assert!(["t", "s", "more"].iter().all(|key| keys.contains(key)), "{keys:?}");
    }

    #[test]
    fn the_tolerance_is_a_line_over_all_times_at_its_separation() {
        let text = "shapes.A = { kind = 'circle', radius = 1, velocity = [8, 0], angular_velocity_deg = 30 }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [6, 1], angle_deg = 30 }
            query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
                tolerance = 0.5 }
            panels = [{ view = [0, 0, 4, 3], layers = [{ layer = 'graph', tolerance = true }] }]";
        let scene = open_text("graph", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "graph");
        let level = |part: &str| paths(&figure.drawing.items, part)[0].contour.bounds().unwrap();
        // The line of the second look runs from 0 up to s₂. That of the fastest approach has a gap where it
        // would run along the curve.
        let (line, worst, look) = (level("tolerance"), level("worst"), level("look"));
        let second = steps(&plan.panels[0].context(&scene, &plan.runs))[1].separation;
        let height = (look.y1 - line.y0) / (look.y1 - look.y0) * second;
        assert!(line.y0 == line.y1 && (height - 0.5).abs() < 1e-9, "{height}");
        assert!(line.x1 - line.x0 > worst.x1 - worst.x0);
    }

    #[test]
    fn an_algorithm_without_steps_has_no_graph() {
        assert!(graph("swept-axis", true).is_err());
    }
}
