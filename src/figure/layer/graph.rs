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
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Outline, Pen, Rank, Size, Sketch, Weight};
use crate::figure::text::number;
use crate::geometry::DVec2;
use crate::scene::When;
use crate::trace::step::advanced;
use crate::trace::{Event, phrase};

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

/// The least distance of the numbers along the axis to one that stands for several steps, page pixels.
const TOGETHER_GAP: f64 = 30.0;

/// The least height of the line of the tolerance, page pixels: a lower one can't be told from the axis.
const SEEN: f64 = 3.0;

/// The share of a line of fastest approach beside which its words stand: at its foot are the times.
const ABOVE_AXIS: f64 = 0.6;

/// The distance below which a step and the last one are one to the eye, page pixels.
const APART: f64 = 1.0;

/// Room below for the times, and to the right for the last separation, page pixels.
const VALUE_ROOM: f64 = 16.0;
const VALUE_ASIDE: f64 = 46.0;

pub(super) const LAYER: Layer = Layer {
    name: "graph",
    in_words: phrase([
        "graph",
        "Abstand über der Zeit",
        "distance en fonction du temps",
        "separación en el tiempo",
    ]),
    about: "separation against time, with the steps of an advancement; in a panel of its own",
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
            about: "marks the kinks of the curve, where another vertex becomes the nearest",
        },
        OptionSpec {
            name: "level",
            takes: Takes::Flag,
            default: "false",
            about: "separations to the panel's scale, above the height of B's closest point at the first \
                    step, and times below A where it goes to the right: level with a panel of the same view",
        },
    ],
    labels: &[
        LabelKey { key: "t", about: "the axis of time" },
        LabelKey { key: "s", about: "the axis of separation" },
        LabelKey { key: "step", about: "the times of the steps" },
        LabelKey { key: "end", about: "where a motion without a hit ends, with values" },
        LabelKey { key: "more", about: "how many steps follow those that are drawn" },
        LabelKey { key: "s_1", about: "the separation at the first step" },
        LabelKey { key: "s_k", about: "the separation at a later step, where it is high enough" },
        LabelKey { key: "worst", about: "the first of the lines of the fastest approach" },
        LabelKey { key: "tolerance", about: "the separation at which it stops, with tolerance" },
        LabelKey { key: "kink", about: "the sharpest kink of the curve, with kink" },
    ],
    needs: "an algorithm that advances in steps: `conservative-advancement` of a time of impact, \
            `ray-clipping` of a linear sweep",
    fed: |context, options| match steps(context).as_slice() {
        [] => Fed::Never,
        all => kinks::fed(context, options, || curve(context, all).1),
    },
    draw,
};

/// How far the axis of separation reaches above that of time at least, as a part of what is below that.
const ABOVE: f64 = 0.2;

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

/// Until when the graph runs, and the separations up to then, those of the steps among them.
fn curve(context: &Context, all: &[Step]) -> (f64, Vec<DVec2>) {
    let last = all.last().map(|step| step.time).filter(|time| context.hit_time().is_some() && *time > 0.0);
    let until = last.unwrap_or(1.0);
    let times: Vec<f64> = all.iter().take(MOST).map(|step| step.time).collect();
    (until, separations(context, until, &times))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let all = steps(context);
    if all.is_empty() {
        return;
    }
    let (until, points) = curve(context, &all);
    let points = kinks::kept(context, &points);
    // Bodies that touch or overlap at the start have depths below the axis.
    let is_at_start = context.hit_time().is_some() && all.last().is_some_and(|step| step.time <= 0.0);
    let depths = points.iter().filter(|_| is_at_start).map(|p| p.y);
    let least = depths.fold(all[0].separation.min(0.0), f64::min);
    let highest = points.iter().map(|p| p.y).fold(all[0].separation, f64::max).max(-ABOVE * least);
    let values = options.flag("values", false);
    let [left, right, below, above] = ROOM;
    let [right, below] = if values { [right + VALUE_ASIDE, below + VALUE_ROOM] } else { [right, below] };
    let room = [left, right, below, above];
    let most = DVec2::new(until, highest);
    let chart = match floor(context).filter(|_| least == 0.0 && options.flag("level", false)) {
        Some(height) => Chart::level(sketch, context, [left, right, above], (height, most)),
        None => Chart::new(sketch, context, room, (least, most)),
    };
    chart.axes(sketch, [("t", "$t$"), ("s", "$s$")]);
    if least < 0.0 {
        sketch.part("axis").line(chart.place(0.0, least), chart.place(0.0, 0.0), Pen::axis());
    }
    if options.flag("lines", true) {
        worst(sketch, (context, &chart), &all, values);
    }
    if options.flag("tolerance", false) {
        tolerance(sketch, (context, &chart));
    }
    let role = options.role(Role::Translation);
    let curve: Vec<DVec2> = points.iter().map(|p| chart.place(p.x, p.y)).collect();
    // The algorithm knows its steps and the lines; what lies between them is seen in the end.
    sketch
        .since(context.answered())
        .part("curve")
        .weight(Weight::Background)
        .stroke(&Outline::polyline(&curve), Pen::outline(role));
    if options.flag("kink", false) {
        kinks::mark(sketch, context, (&chart, |s| s), &points);
    }
    marks(sketch, (context, &chart), &all, (role, values));
    now(sketch, (context, &chart), &all, &points);
}

/// Marks the moment that others show while the graph stands still, or that its own panel is given: one that
/// is no step's.
fn now(sketch: &mut Sketch, (context, chart): (&Context, &Chart), all: &[Step], points: &[DVec2]) {
    let given = || Some(context.time).filter(|&t| t > 0.0 && all.iter().all(|step| step.time != t));
    let Some(t) = context.play.stands_at().or_else(given) else { return };
    let around = points.windows(2).find(|pair| pair[0].x <= t && t <= pair[1].x);
    let Some(&[before, after]) = around.and_then(|pair| pair.first_chunk()) else { return };
    let share = if after.x > before.x { (t - before.x) / (after.x - before.x) } else { 0.0 };
    let [foot, top] = [0.0, before.y + (after.y - before.y) * share].map(|s| chart.place(t, s));
    sketch.since(None).part("now").weight(Weight::Background).line(foot, top, Pen::dimension(Role::Ink));
    sketch.part("now").marker(top, Marker::Disc, Role::Ink, MARKER);
}

/// The cue with which is told how far apart the bodies are at a step.
pub(super) fn looked(context: &Context, k: usize) -> Option<Cue> {
    context.cue(|event| matches!(event, Event::Advanced { step, .. } if *step == k))
}

/// How many steps the eye can tell from the last one, which stands for those that come later.
fn told_apart(sketch: &Sketch, chart: &Chart, all: &[Step]) -> usize {
    let at = |step: &Step| chart.place(step.time, step.separation);
    let Some(last) = all.last().map(at) else { return 0 };
    let is_near = |step: &Step| sketch.on_page(at(step).distance(last)) < APART;
    all.iter().position(is_near).unwrap_or_default()
}

/// Draws how s would fall at the fastest from each step, to where the next one begins.
fn worst(sketch: &mut Sketch, (context, chart): (&Context, &Chart), all: &[Step], values: bool) {
    let apart = told_apart(sketch, chart, all);
    for (k, step) in all.iter().take(MOST).enumerate() {
        let Some(next) = step.next.filter(|t| *t <= chart.most.x) else {
            if k + 1 == all.len() {
                to_the_end(sketch, (context, chart), step, values);
            }
            continue;
        };
        let told = if k < apart { k + 1 } else { all.len() };
        let part = |cue: Cue| if told == k + 1 { cue.part(advanced::NEXT) } else { cue };
        sketch.since(looked(context, told).map(part));
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
            let told = if k + 1 < apart { k + 2 } else { all.len() };
            sketch.since(looked(context, told));
            let up = chart.place(then.time, then.separation);
            sketch.part("look").weight(Weight::Background).line(to, up, Pen::dimension(Role::Now));
            let ends = k + 2 == all.len();
            let gap = chart.along(sketch, then.time - step.time);
            left(sketch, (k + 2, then), [to, up], gap, (values, ends));
        }
    }
}

/// Draws why a motion without a hit ends: at the fastest the bodies are still apart then.
fn to_the_end(sketch: &mut Sketch, (context, chart): (&Context, &Chart), step: &Step, values: bool) {
    let rest = chart.most.x - step.time;
    let left = step.separation - step.bound * rest;
    if context.hit_time().is_some() || step.bound <= 0.0 || rest <= 0.0 || left <= 0.0 {
        return;
    }
    let [from, to] =
        [(step.time, step.separation), (chart.most.x, left)].map(|(time, s)| chart.place(time, s));
    let told = context.cue(|event| matches!(event, Event::Advanced { .. }));
    sketch.since(told.map(|cue| cue.part(advanced::NEXT))).part("worst").weight(Weight::Background);
    sketch.line(from, to, Pen::construction());
    let end = chart.place(chart.most.x, 0.0);
    chart.tick(sketch.part("end"), chart.most.x, Role::Muted);
    if values && chart.along(sketch, rest) >= sketch.fitted(VALUE_GAP) {
        let anchor = Anchor::Tick { at: end, toward: DVec2::NEG_Y };
        let label = Label::new("end", format!("${}$", number(chart.most.x)), anchor, Role::Muted);
        sketch.label(label.size(Size::Note));
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
    let height = sketch.on_page(from.distance(chart.place(0.0, 0.0)));
    let unseen = if height < SEEN { ", too small to be seen" } else { "" };
    let text = format!("tolerance ${}${unseen}", number(impact.tolerance));
    let label = Label::new("tolerance", text, Anchor::middle(from, to), Role::Muted);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Names the separation left at a step, beside its line from the axis to the curve; with its value, or
/// where that line is too short, at the curve, if the step is not too near to the one before. The step that
/// `ends` has it to the right.
fn left(
    sketch: &mut Sketch,
    (k, step): (usize, &Step),
    [foot, top]: [DVec2; 2],
    gap: f64,
    (values, ends): (bool, bool),
) {
    let high = !values && sketch.on_page(top.distance(foot)) >= sketch.fitted(NAMED);
    if !high && gap < sketch.fitted(GAP) {
        return;
    }
    let value = if values { format!(" = {}", number(step.separation)) } else { String::new() };
    // Beyond the last one is no curve.
    let out = if ends { DVec2::X } else { DVec2::new(1.0, 1.0) };
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
    // The last number says how many steps there are: those that stand too near to it are told with it.
    let last = all.len().min(MOST);
    let [gap, value_gap, wider] = [GAP, VALUE_GAP, TOGETHER_GAP].map(|px| sketch.fitted(px));
    let end = all.get(last.saturating_sub(1)).map_or(f64::INFINITY, |step| chart.along(sketch, step.time));
    let among = all.get(1..last.saturating_sub(1)).unwrap_or_default();
    let near = |room: f64| among.iter().filter(|step| end - chart.along(sketch, step.time) < room).count();
    let room_at_end = if near(gap) > 0 { wider } else { gap };
    let together = near(room_at_end);
    let apart = told_apart(sketch, chart, all);
    for (k, step) in (1..).zip(all.iter().take(MOST)) {
        let told = if k <= apart { k } else { all.len() };
        sketch.since(context.known(&When::Step(told)));
        let on_axis = chart.place(step.time, 0.0);
        let on_curve = chart.place(step.time, step.separation);
        sketch.part("steps").weight(Weight::Background);
        chart.tick(sketch, step.time, Role::Now);
        sketch.since(looked(context, told)).marker(on_curve, Marker::HollowDiamond, Role::Now, MARKER);
        sketch.since(context.known(&When::Step(told)));
        let along = chart.along(sketch, step.time);
        let yields = |room: f64| k > 1 && k < last && end - along < room;
        if k == last || along >= free && !yields(room_at_end) {
            free = along + gap;
            let mut lines = vec![numbered(k, if k == last { together } else { 0 })];
            if values && (k == last || along >= wide && !yields(value_gap)) {
                wide = along + value_gap;
                let up_to = if k == last && together > 0 { r"\ldots\," } else { "" };
                lines.push(format!("${up_to}{}$", number(step.time)));
            }
            let anchor = Anchor::Tick { at: on_axis, toward: DVec2::NEG_Y };
            let label = Label { lines, ..Label::new("step", "", anchor, Role::Now) };
            sketch.label(label.size(Size::Note));
        } else {
            // The number of another step must not seem to be of this tick.
            sketch.unnamed(Anchor::Tick { at: on_axis, toward: DVec2::NEG_Y });
        }
    }
    if let Some(next) = all.get(MOST) {
        // Above the axis: below it are the times, and to the right its head.
        let on_curve = chart.place(next.time, next.separation);
        let anchor = Anchor::point_toward(on_curve, chart.vector(DVec2::ONE));
        let more = Label::new("more", more(all.len()), anchor, Role::Muted);
        sketch.since(context.answered()).label(more.rank(Rank::Word).size(Size::Note));
    }
    if let Some(first) = all.first() {
        let anchor = Anchor::point_toward(chart.place(first.time, first.separation), DVec2::X);
        let text = format!("$s_1 = {}$", number(first.separation));
        sketch.since(looked(context, 1)).label(Label::new("s_1", text, anchor, role));
    }
}

/// The times of a step and of those `before` it that have no number of their own.
fn numbered(k: usize, before: usize) -> String {
    match before {
        0 => format!("$t_{{{k}}}$"),
        1 => format!("$t_{{{}}}, t_{{{k}}}$", k.saturating_sub(1)),
        _ => format!("$t_{{{}}} \\ldots t_{{{k}}}$", k.saturating_sub(before)),
    }
}

/// How many steps follow those that are drawn, and which the last one is: the numbers on the axis may end
/// earlier, so that the count alone would begin nowhere.
fn more(all: usize) -> String {
    match all.saturating_sub(MOST) {
        1 => format!("one more step, $t_{{{all}}}$"),
        count => format!("{count} more steps, to $t_{{{all}}}$"),
    }
}

#[cfg(test)]
mod tests;
