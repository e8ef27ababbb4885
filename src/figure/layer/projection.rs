//! Both bodies projected on one axis of the separating-axis test, and what the test measures there: from
//! where A ends along n to where B begins.
//!
//! An interval is the shadow of a body: from the least to the largest n·x of its points. The axis n points
//! out of an edge of A, or into one of B, so that the measure is that of the other body's support from the
//! edge's line. Where B begins beyond A's end it is the gap of the intervals. Else it is the depth: how far B
//! must go along n until the edge parts them: the overlap, or more, where one reaches past the other's end.

use crate::collision::Answer;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Size, Sketch};
use crate::figure::text::{Quantity, terms};
use crate::geometry::{DVec2, Feature, Side, perp, sort_by};
use crate::trace::{Event, phrase};

use super::axis_unit::{LIGHT, from_origin, light, numbers, on_axis, sees, shadow_of, units, written, zero};
use super::half_extents::beside;
use super::normal::{unit_length, unit_vector};
use super::shadow::{guide, highest, lit};
use super::tested_axis::{Tested, may_stop, stopped_at, told};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, number_of};

/// The part of a measure by which others are as large, as far as rounding tells.
const TIED: f64 = 1e-12;

/// Distance of the axis from the bodies, page pixels.
const OFFSET: f64 = 26.0;

/// Distance of the two intervals from the axis, page pixels: beside each other where they overlap.
const TRACK: f64 = 6.0;

/// Distance of the measure from the axis, page pixels: below the intervals.
const MEASURE: f64 = 48.0;

/// How far the axis reaches past the intervals, page pixels, so that its arrow head stands free.
const PAST: f64 = 22.0;

pub(super) const LAYER: Layer = Layer {
    name: "projection",
    in_words: phrase(["projection", "Projektion auf Achse", "projection sur axe", "proyección sobre eje"]),
    about: "both bodies' intervals on one axis of the separating-axis test",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "axis",
            takes: Takes::Number,
            default: "the one of the largest gap, else of the least depth",
            about: "which tested axis, from 1",
        },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the axis, its 0, and where A ends and B begins along it",
        },
        OptionSpec {
            name: "light",
            takes: Takes::Flag,
            default: "false",
            about: "arrows over the bodies, the way light falls that casts the intervals as shadows",
        },
        OptionSpec {
            name: "joined",
            takes: Takes::Flag,
            default: "false",
            about: "of intervals that are apart, one bar on the axis: A's, the gap, B's",
        },
    ],
    labels: &[
        LabelKey { key: "end.A", about: "where A ends along the axis, with values" },
        LabelKey { key: "begin.B", about: "where B begins along the axis, with values" },
        LabelKey { key: "zero", about: "0 of the axis, with values" },
        LabelKey { key: "n", about: "the axis" },
        LabelKey { key: "axis", about: "what the axis is along, with values" },
        LabelKey { key: "light", about: "the arrows of light" },
        LabelKey { key: "gap", about: "from where A ends to where B begins: gap, overlap or depth" },
    ],
    needs: "the algorithm \"separating-axes\", and no more axes than it tested; or \"minkowski\", \
        asked for the overlap of bodies that are apart",
    fed: |context, options| {
        // A test for overlap stops at the first axis that separates; the others look at every axis.
        let some = context.run().events().any(|e| matches!(e, Event::AxisTested { .. }));
        let stopped = matches!(context.run().answer, Answer::Overlap(_));
        let may_stop = options.number("axis").is_none() && may_stop(context);
        Fed::by_the_answer(tested(context, options).is_some(), some && stopped || may_stop)
    },
    draw,
};

/// The most axes that come and go, which the eye could follow.
const MOST_PASSING: usize = 40;

/// The tested axis that the scene wants; else the one of the largest measure.
fn tested(context: &Context, options: &Options) -> Option<Tested> {
    let run = context.run();
    let all: Vec<Tested> = run.told(told).collect();
    match options.number("axis") {
        Some(k) => all.iter().enumerate().find(|(i, _)| number_of(i + 1) == k).map(|(_, t)| *t),
        None => widest(context, &all).or_else(|| stopped_at(context)),
    }
}

/// The axis of the largest measure; of several the one along the answer's normal, as its sentence has it, and
/// of two edges with that the one that the trace names.
fn widest(context: &Context, all: &[Tested]) -> Option<Tested> {
    let widest = all.iter().map(|t| t.gap).max_by(f64::total_cmp)?;
    let mut ties: Vec<Tested> = all.to_vec();
    ties.retain(|t| widest - t.gap <= TIED * widest.abs());
    let found = context.separation_at(context.time).filter(|_| ties.len() > 1);
    if let Some((run, s)) = found.as_ref().and_then(|run| Some((run, run.separation()?))) {
        let along = |t: &Tested| t.n.dot(*s.normal);
        let most = ties.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
        ties.retain(|t| most - along(t) <= TIED);
        let is_other = |t: &Tested| run.candidate() != Some(t.source);
        sort_by(&mut ties, |s, t| is_other(s).cmp(&is_other(t)));
    }
    ties.first().copied()
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(t) = tested(context, options) else { return };
    let tested = |event: &Event| match *event {
        Event::AxisTested { axis, source, .. } => (axis, source) == (t.n, t.source),
        _ => false,
    };
    let found = |event: &Event| matches!(event, Event::SeparatingAxisFound { .. });
    sketch.since(context.cue(tested).or_else(|| context.cue(found)));
    draw_axis(sketch, (context, options), &t);
    if options.number("axis").is_some() {
        return;
    }
    // Only the axis that decides stays: each other goes when the next one is tested, and the best so far when
    // it is no longer that.
    let run = context.run();
    let all: Vec<(Cue, Tested)> = run.cues(told).take(MOST_PASSING).collect();
    let is_the_one = |other: &Tested| (other.n, other.source) == (t.n, t.source);
    let mut best = f64::NEG_INFINITY;
    for (i, (from, other)) in all.iter().enumerate() {
        let is_best = !other.is_behind() && other.gap > best;
        best = if is_best { other.gap } else { best };
        let ends = |next: &Tested| !is_best || is_the_one(next) || !next.is_behind() && next.gap > best;
        let to = all[i + 1..].iter().find(|(_, next)| ends(next)).map_or(run.end(), |(cue, _)| *cue);
        if !is_the_one(other) && *from != to {
            sketch.passing([*from, to], |sketch| draw_axis(sketch, (context, options), other));
        }
    }
}

/// Draws one axis, with the shadows on it.
fn draw_axis(sketch: &mut Sketch, (context, options): (&Context, &Options), t: &Tested) {
    let points: Vec<DVec2> = context
        .sides()
        .into_iter()
        .filter_map(|s| context.outline(s, context.time))
        .flat_map(|outline| outline.sampled())
        .collect();
    let (down, far) = beside_bodies(sketch, context, t, &points);
    // Counted from the origin of the panel, whose components n has.
    let (origin, [a, b]) = from_origin(context, t.n, [t.a, t.b]);
    let t = &Tested { a, b, ..*t };
    let at = |along: f64, track: f64| t.n * (origin + along) + down * (far + track);
    let joined = t.gap > 0.0 && options.flag("joined", false);
    let [track, low] = if joined { [0.0; 2] } else { [TRACK, MEASURE].map(|px| sketch.px(px)) };
    // The strip passes between the bodies from beyond both, as light does that falls there.
    let top = -far - highest(&points, down);
    // What lies in both shadows is marked at them alone: light that would fall there is stopped.
    let has_light = options.flag("light", false);
    let from = if has_light { top - sketch.px(LIGHT) } else { top };
    // Where B lies behind A nothing is in both shadows, and no light falls between them this way.
    if !t.is_behind() {
        lit(sketch, t.between(), [low, if t.gap > 0.0 { from } else { -track }], at);
    }
    let past = sketch.px(PAST);
    let values = options.flag("values", false);
    let (mut first, mut last) = (t.a.lo.min(t.b.lo) - past, t.a.hi.max(t.b.hi) + past);
    if has_light {
        let gap = (t.gap > 0.0).then_some(0.5 * (t.a.hi + t.b.lo));
        light(sketch, ([first + past, last - past], gap), top, at);
    }
    // Numbers are counted from 0: the axis reaches it where it is in view.
    if values && sees(sketch, context, at(0.0, 0.0)) {
        (first, last) = (first.min(-past), last.max(past));
    }
    sketch.part("axis").arrow(at(first, 0.0), at(last, 0.0), Pen::vector(Role::Muted).width(1.0));
    let beyond = Anchor::tip(at(first, 0.0), at(last, 0.0));
    let from_zero = values && (first..=last).contains(&0.0);
    if from_zero {
        units(sketch, (first, last - past), at);
        on_axis(sketch, (t.n, &written(context, t.n)), at);
    } else if values {
        let along = format!("along ${}$", written(context, t.n));
        let label = Label::new("axis", along, beyond.clone(), Role::Muted);
        sketch.label(label.rank(Rank::Measure).size(Size::Note));
    }
    // Of a round body's vertex there is no edge to show n at.
    if edge(sketch, context, t, !from_zero).is_none() && !values {
        sketch.part("axis").label(Label::new("n", "$n$", beyond, Role::Muted));
    }
    for (body, interval, track) in [(Side::A, t.a, -track), (Side::B, t.b, track)] {
        for end in [interval.lo, interval.hi] {
            let measured = end == if body == Side::A { t.a.hi } else { t.b.lo };
            let track = if measured { low } else { track };
            guide(sketch, (context, body.other()), &points, (t.n, origin + end), (down, far + track));
        }
        let ends = [interval.lo, interval.hi].map(|along| at(along, track));
        shadow_of(sketch, body, ends, options.role(body.into()));
    }
    let pen = pen(options, t, joined);
    let distance = context.separation_at(context.time).and_then(|run| run.separation().map(|s| s.separation));
    let rounding = context.scene.query_at(context.time).rounding();
    measure(sketch, t, ((values, distance, rounding), pen, low), (is_of_vertices(context, t), at));
    if values {
        numbers(sketch, ([t.a.hi, t.b.lo], t.gap), (t.n, down, TRACK), at);
        zero(sketch, (first, last), down, at);
    }
}

/// Whether an axis is that of two vertices and of no edge; a circle's only one is called none.
fn is_of_vertices(context: &Context, t: &Tested) -> bool {
    let mut bodies = context.sides().into_iter().filter_map(|side| context.body(side));
    matches!(t.source, (_, Feature::Vertex(_))) && bodies.all(|body| body.shape.vertices.len() > 1)
}

/// How the measure is drawn.
fn pen(options: &Options, t: &Tested, joined: bool) -> Pen {
    // Where bodies are apart, an overlap on one axis is no way to move.
    let is_asked = options.number("axis").is_some() && t.gap <= 0.0;
    let role = match is_asked {
        true => Role::Ink,
        false if t.is_behind() => Role::Muted,
        false => Role::Translation,
    };
    if joined { Pen::highlighted(role) } else { Pen::dimension(role).width(1.5) }
}

/// Draws the edge whose normal the axis is, thick, and n square to it outside of its middle, where it is
/// nowhere else; `None` where the axis is of no edge.
fn edge(sketch: &mut Sketch, context: &Context, t: &Tested, with_normal: bool) -> Option<()> {
    let (side, Feature::Edge(index)) = t.source else { return None };
    let body = context.body(side)?;
    let [i, j] = body.shape.edge_ends(index)?;
    let (p, q) = (context.vertex(side, i, context.time)?, context.vertex(side, j, context.time)?);
    let out = body.shape.radius * if side == Side::A { t.n } else { -t.n };
    let (p, q) = (p + out, q + out);
    let middle = 0.5 * (p + q);
    // n points from A to B: away from an edge of A, and up to one of B.
    let (from, outward) = match side {
        Side::B => (middle - t.n * unit_length(sketch), -t.n),
        Side::A => (middle, t.n),
    };
    sketch.part("edge").line(p, q, Pen::highlighted(side.into()));
    if !with_normal {
        return Some(());
    }
    sketch.right_angle(middle, q - middle, outward);
    unit_vector(sketch, (from, t.n), None, Label::new("n", "$n$", Anchor::point(middle), Role::Ink));
    Some(())
}

/// The side of the bodies that the axis is drawn on, and how far along it: below, unless the axis is in view
/// only above.
fn beside_bodies(sketch: &Sketch, context: &Context, t: &Tested, points: &[DVec2]) -> (DVec2, f64) {
    let side = perp(t.n);
    let onto = context.in_space(side) - context.in_space(DVec2::ZERO);
    let down = if onto.y > 0.0 || onto.y == 0.0 && onto.x < 0.0 { -side } else { side };
    let far = |down: DVec2| {
        points.iter().map(|p| p.dot(down)).fold(f64::NEG_INFINITY, f64::max) + sketch.px(OFFSET)
    };
    let (lo, hi) = sketch.visible();
    let hidden = |down: DVec2| {
        let out = |along: f64| {
            let p = context.in_space(t.n * along + down * far(down));
            (lo - p).max(p - hi).max(DVec2::ZERO).length()
        };
        out(t.a.lo.min(t.b.lo)) + out(t.a.hi.max(t.b.hi))
    };
    let down = if hidden(-down) < hidden(down) { -down } else { down };
    (down, far(down))
}

/// Draws what the test measures: from A's upper end to B's lower one, with both where their `values` are
/// written, and whether the axis is that of two vertices and of no edge.
fn measure(
    sketch: &mut Sketch,
    t: &Tested,
    ((values, distance, rounding), pen, track): ((bool, Option<f64>, f64), Pen, f64),
    (cornered, at): (bool, impl Fn(f64, f64) -> DVec2),
) {
    let (p, q) = (at(t.a.hi, track), at(t.b.lo, track));
    sketch.part("gap").bar(p, q, 0.0, pen);
    let out = at(0.0, 1.0) - at(0.0, 0.0);
    let word = match t.gap < -rounding {
        true if t.a.lo <= t.b.lo && t.a.hi <= t.b.hi => "overlap $",
        true => "depth $",
        false => "gap $",
    };
    // Subtracted so that what is left is positive.
    let (more, less) = if t.gap < 0.0 { (t.a.hi, t.b.lo) } else { (t.b.lo, t.a.hi) };
    let ([from, text], result) = terms([more, less], t.gap.abs());
    let minus = if less < 0.0 { format!("- ({text})") } else { format!("- {text}") };
    let equals = match Quantity::exactly(t.gap.abs()).equals(rounding) {
        equals if !values => equals,
        equals if t.gap != 0.0 && t.gap.abs() <= rounding => format!("= {from} {minus} {equals}"),
        _ => format!("= {from} {minus} = {result}"),
    };
    let mut lines = vec![format!("{word}{equals}$")];
    if t.is_behind() {
        // Apart the other way round: another edge tells of that gap.
        lines.push("(the edge faces away)".to_owned());
    } else if t.gap > 0.0 && distance.is_some_and(|distance| distance - t.gap > TIED * distance) {
        // The gap of an axis is not how far apart the bodies are.
        lines.push("(less than the distance)".to_owned());
    } else if cornered {
        lines.push("(from vertex to vertex)".to_owned());
    }
    let label = Label { lines, ..Label::new("gap", "", beside(p, q, out), pen.role) };
    sketch.label(label.rank(Rank::Measure));
}

#[cfg(test)]
mod tests;
