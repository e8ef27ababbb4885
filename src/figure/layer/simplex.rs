//! One step of GJK or EPA on B ⊖ A: the simplex, its point v closest to the origin, and the vertex w that is
//! farthest towards the origin and comes next; or the polytope grown around the origin.
//!
//! Of rounded bodies GJK sees the cores alone: their difference is drawn inside B ⊖ A, and where the search
//! ends the radii, which B ⊖ A reaches beyond it.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, MARKER, Marker, Outline, Pen, Rank, Size, Sketch, Wash, Weight,
};
use crate::figure::text::{self, number, whole_and_parts};
use crate::geometry::{DVec2, perp};
use crate::scene::NOTES;
use crate::trace::{Event, phrase};

use super::coordinates::coordinates;
use super::cores::{cores, radii, radii_in_words};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, number_of};

/// Opacity of a simplex's fill: it lies on the difference, which is filled too.
const FILL: f64 = 0.12;

/// Length of the arrow of the search, page pixels: it has a direction only, and is seen beyond O's ring.
const SEARCH: f64 = 40.0;
/// How far from O the supporting line must be for its right angle to be marked on O's side, page pixels:
/// clear of O's ring.
const CLEAR: f64 = 30.0;
/// How far beside v its distance from the origin is measured, page pixels: clear of v's head.
const LEAST: f64 = 16.0;
/// How far a supporting line reaches past what it supports, page pixels.
const PAST: f64 = 44.0;

/// How far from a supporting line a vertex may be that it supports, in parts of the line's distance from
/// the origin: both are rounded a few times.
const ON_LINE: f64 = 1e-9;

pub(super) const LAYER: Layer = Layer {
    name: "simplex",
    in_words: phrase(["simplex", "Simplex", "simplexe", "símplex"]),
    about: "one step of GJK or EPA: the simplex, its closest point, the next vertex",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "step",
            takes: Takes::Number,
            default: "the last",
            about: "which simplex or polytope, from 1",
        },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the length of v and the supporting line's distance: the most and the least",
        },
        OptionSpec {
            name: "coordinates",
            takes: Takes::Flag,
            default: "false",
            about: "writes those of the vertex that the search begins with, and of each that comes next",
        },
        OptionSpec {
            name: "numbers",
            takes: Takes::Flag,
            default: "false",
            about: "names each vertex by the step that asked for it: w₀, w₁, …",
        },
    ],
    labels: &[
        LabelKey { key: "closest", about: "the point of the simplex closest to the origin" },
        LabelKey { key: "search", about: "the direction −v in which the next vertex is searched" },
        LabelKey { key: "w", about: "the vertex that comes next" },
        LabelKey { key: "vertex", about: "the first vertex, with coordinates; each, with numbers" },
        LabelKey { key: "least", about: "the supporting line's distance from the origin, with values" },
        LabelKey { key: "dropped", about: "a vertex of the step before that is no longer needed" },
        LabelKey { key: "stop", about: "that no vertex is farther, where the search ends" },
        LabelKey { key: "cores", about: "the difference of the cores, of rounded bodies" },
        LabelKey { key: "r", about: "how far B ⊖ A reaches beyond that, where the search ends" },
    ],
    needs: "the algorithm \"gjk\", and no more steps than it took",
    fed: |context, options| {
        let [found, any] = [options, &Options::default()].map(|options| shown(context, options));
        match found.as_ref().filter(|_| NOTES).and_then(|step| unwritten(step, options)) {
            Some((option, why)) => Fed::Without { option, why },
            None => Fed::by_the_steps(found.is_some(), any.is_some(), has_simplexes(context)),
        }
    },
    draw,
};

/// The option that has nothing to write at a step, and why not. Of steps that a scene shows one by one the
/// last has less to write than the others.
fn unwritten(step: &Step, options: &Options) -> Option<(&'static str, &'static str)> {
    let asks = |option| options.flag(option, false) && !options.gives("step");
    if asks("coordinates") && step.next.is_none() && step.vertices.len() > 1 {
        return Some(("coordinates", "no vertex comes next at the last step"));
    }
    (asks("values") && step.closest.is_none()).then_some(("values", "the origin lies in the simplex"))
}

/// Whether the algorithm told simplexes, as GJK does before EPA.
pub(super) fn has_simplexes(context: &Context) -> bool {
    context.run().events().any(|event| matches!(event, Event::SimplexUpdated { .. }))
}

/// A simplex or polytope that the algorithm told.
pub(super) struct Step {
    /// Its vertices, in configuration space.
    vertices: Vec<DVec2>,
    /// Its point closest to the origin, v; `None` where the origin lies in it.
    closest: Option<DVec2>,
    /// The vertex that it lacks and the next step has, w.
    next: Option<DVec2>,
    /// Vertices of the step before that it does without.
    dropped: Vec<DVec2>,
    /// The vertices that were asked for so far, in that order, with the next one.
    asked: Vec<DVec2>,
    /// With what it comes.
    pub(super) cue: Option<Cue>,
}

impl Step {
    /// The number of a vertex in the order in which they were asked for, from 0.
    fn number(&self, vertex: DVec2) -> Option<usize> {
        self.asked.iter().position(|w| *w == vertex)
    }

    /// What it proves of the distance of B ⊖ A, without the bodies' radii: at least that of the supporting
    /// line through w, at most that of v. `None` where the origin lies in the simplex.
    pub(super) fn bracket(&self) -> Option<[f64; 2]> {
        let v = self.closest?;
        let most = v.length();
        Some([self.next.map_or(most, |w| w.dot(v) / most).clamp(0.0, most), most])
    }
}

/// The most vertices of the steps before the last that come and go: as many as the eye could follow, and few
/// beside what a figure may draw.
pub(super) const MOST_PASSING: usize = 500;

/// All steps that the algorithm told.
pub(super) fn steps(context: &Context) -> Vec<Step> {
    let run = context.run();
    let updated = |event: &Event| match event {
        Event::SimplexUpdated { .. } | Event::PolytopeExpanded { .. } => Some(()),
        _ => None,
    };
    let told: Vec<(&Vec<DVec2>, Option<DVec2>)> = run
        .told(|event| match event {
            Event::SimplexUpdated { vertices, closest, .. } => Some((vertices, Some(*closest))),
            Event::PolytopeExpanded { vertices, .. } => Some((vertices, None)),
            _ => None,
        })
        .collect();
    let none = Vec::new();
    let mut asked: Vec<DVec2> = Vec::new();
    let step = |(i, (cue, ())): (usize, (Cue, ()))| {
        let &(vertices, closest) = told.get(i)?;
        let after = told.get(i + 1).map_or(&none, |(after, _)| *after);
        let before = i.checked_sub(1).and_then(|i| told.get(i)).map_or(&none, |(before, _)| *before);
        for w in vertices.iter().chain(after) {
            if !asked.contains(w) {
                asked.push(*w);
            }
        }
        Some(Step {
            asked: asked.clone(),
            vertices: vertices.clone(),
            closest: closest.filter(|v| *v != DVec2::ZERO),
            next: after.iter().find(|w| !vertices.contains(w)).copied(),
            dropped: before.iter().filter(|w| !vertices.contains(w)).copied().collect(),
            cue: Some(cue),
        })
    };
    run.cues(updated).enumerate().filter_map(step).collect()
}

/// The step that the scene wants; else the last.
fn shown(context: &Context, options: &Options) -> Option<Step> {
    let mut all = steps(context);
    let index = match options.number("step") {
        Some(step) => (0..all.len()).find(|&i| number_of(i + 1) == step)?,
        None => all.len().checked_sub(1)?,
    };
    Some(all.swap_remove(index))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(step) = shown(context, options) else { return };
    cores(sketch, context);
    sketch.since(step.cue);
    draw_step(sketch, context, &step, options);
    if options.number("step").is_some() {
        return;
    }
    // Of the search only the end stays: each step before it goes when the next one comes.
    let mut vertices = 0;
    for pair in steps(context).windows(2) {
        let (Some(from), Some(to)) = (pair[0].cue, pair[1].cue) else { break };
        vertices += pair[0].vertices.len();
        if vertices > MOST_PASSING {
            break;
        }
        sketch.passing([from, to], |sketch| draw_step(sketch, context, &pair[0], options));
    }
}

/// Draws one step.
fn draw_step(sketch: &mut Sketch, context: &Context, step: &Step, options: &Options) {
    let role = options.role(Role::Now);
    if !step.dropped.is_empty() && step.closest.is_some() {
        let before: Vec<DVec2> = step.vertices.iter().chain(&step.dropped).copied().collect();
        let before = Outline::polygon(&before);
        // On the page's own colour: over the tint of B ⊖ A its own would be a third one.
        sketch.part("before").area(&before, Some(Wash::faint(Role::Background, 1.0)), None);
        sketch.area(&before, Some(Wash::faint(role, FILL)), None);
    }
    if step.vertices.len() > 1 {
        let wash = (step.vertices.len() > 2).then(|| Wash::faint(role, FILL));
        sketch.part("simplex").area(&Outline::polygon(&step.vertices), wash, Some(Pen::highlighted(role)));
    }
    for &vertex in &step.vertices {
        sketch.part("simplex").marker(vertex, Marker::Diamond, role, MARKER);
    }
    names(sketch, context, step, options);
    if let Some(v) = step.closest {
        let values = options.flag("values", false);
        let blue = Role::Translation;
        let clear = if step.vertices.contains(&v) { Marker::Diamond.reach(MARKER) } else { 0.0 };
        sketch.part("closest").arrow_to(DVec2::ZERO, v, clear, Pen::vector(blue));
        sketch.detail(&[DVec2::ZERO, v]);
        let radius = radii(context);
        let lengths = of_cores(v.length(), radius, values && radius > 0.0 && step.next.is_none());
        let text = if values { format!(r"$\|v\| = {}$", lengths[0]) } else { "$v$".to_owned() };
        sketch.label(Label::new("closest", text, Anchor::middle(DVec2::ZERO, v), blue));
        search(sketch, v, step, (values, radius > 0.0));
        if radius > 0.0 && step.next.is_none() {
            beyond(sketch, context, (v, radius), &lengths[1]);
        }
    }
    if let Some(w) = step.next {
        sketch.part("next").marker(w, Marker::HollowDiamond, role, MARKER);
        let name = step.number(w).filter(|_| options.flag("numbers", false));
        let name = name.map_or_else(|| "w".to_owned(), |k| format!("w_{{{k}}}"));
        let text = if options.flag("coordinates", false) {
            format!("${name} = {}$", coordinates(sketch, context, w).trim_matches('$'))
        } else {
            format!("${name}$")
        };
        sketch.label(Label::new("w", text, Anchor::point(w), role).rank(Rank::Point));
    }
}

/// Names the vertices: with coordinates the one that the search begins with, with numbers each. Marks those
/// that were dropped.
fn names(sketch: &mut Sketch, context: &Context, step: &Step, options: &Options) {
    let role = options.role(Role::Now);
    let [coordinated, numbered] = ["coordinates", "numbers"].map(|flag| options.flag(flag, false));
    let number = |vertex| step.number(vertex).filter(|_| numbered);
    for &vertex in &step.vertices {
        let place = (coordinated && step.vertices.len() == 1).then(|| coordinates(sketch, context, vertex));
        let text = match (number(vertex), place) {
            (Some(k), Some(place)) => format!("$w_{{{k}}} = {}$", place.trim_matches('$')),
            (Some(k), None) => format!("$w_{{{k}}}$"),
            (None, Some(place)) => place,
            (None, None) => continue,
        };
        sketch.label(Label::new("vertex", text, Anchor::point(vertex), role));
    }
    for &vertex in &step.dropped {
        sketch.part("dropped").marker(vertex, Marker::Cross, Role::Muted, LARGE_MARKER);
        let text = number(vertex).map_or("dropped".to_owned(), |k| format!("$w_{{{k}}}$ dropped"));
        let label = Label::new("dropped", text, Anchor::point(vertex), Role::Muted);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// The distance of the cores and the radii as LaTeX; if `compared`, so that they leave that of the bodies.
fn of_cores(distance: f64, radii: f64, compared: bool) -> [String; 2] {
    let texts = whole_and_parts(distance, &[radii], distance - radii);
    let text = |i: usize, x: f64| texts.get(i).filter(|_| compared).cloned().unwrap_or_else(|| number(x));
    [text(0, distance), text(1, radii)]
}

/// Measures from v towards the origin how far B ⊖ A reaches beyond the cores: the radii, by which the
/// distance is less than that of v.
fn beyond(sketch: &mut Sketch, context: &Context, (v, radius): (DVec2, f64), text: &str) {
    let rim = v - v.normalize_or_zero() * radius;
    sketch.part("beyond").dimension(v, rim, LEAST, Pen::dimension(Role::Difference));
    let text = format!("${} = {text}$", radii_in_words(context));
    let anchor = Anchor::Beside { from: v, to: rim, offset: LEAST };
    sketch.label(Label::new("r", text, anchor, Role::Difference).size(Size::Note));
}

/// Draws the direction −v from the origin, where v begins, and the supporting line square to it through the
/// vertex that is farthest that way: nothing of B ⊖ A lies beyond. It passes through v itself where the
/// search ends.
fn search(
    sketch: &mut Sketch,
    v: DVec2,
    Step { vertices, next, .. }: &Step,
    (values, rounded): (bool, bool),
) {
    let Some(u) = v.try_normalize() else { return };
    let w = next.unwrap_or(v);
    let (foot, across) = (u * w.dot(u), perp(u));
    // Where the search ends, w is v, on neither side: rounding must not choose.
    let side = if w.dot(across) < -ON_LINE * v.length() { -across } else { across };
    let tip = -u * sketch.px(SEARCH);
    sketch.part("search").arrow(DVec2::ZERO, tip, Pen::vector(Role::Ink));
    sketch.label(Label::new("search", "$-v$", Anchor::tip(DVec2::ZERO, tip), Role::Ink));
    // Beyond the simplex too, whose edge the line lies on where the search ends.
    let supported = vertices.iter().filter(|p| (**p - w).dot(u).abs() <= ON_LINE * v.length());
    let reached = supported.chain([&w, &foot]).map(|p| p.dot(side));
    let (lo, hi) = reached.fold((0.0, 0.0), |(lo, hi): (f64, f64), x| (lo.min(x), hi.max(x)));
    let past = sketch.px(PAST);
    let (begin, end) = (foot + side * (lo - past), foot + side * (hi + past));
    sketch.part("supporting-line").weight(Weight::Light).line(begin, end, Pen::construction());
    let near = sketch.on_page(foot.length()) < CLEAR;
    // One is enough: where v ends on an edge, that is parallel to this line.
    sketch.part("right-angle").right_angle(foot, -side * past, if near { u } else { -u } * past);
    if values && next.is_some() && w.dot(u) > 0.0 {
        least(sketch, foot, side);
    }
    if next.is_none() {
        // On one side of v are the radii, where there are any; beyond the line is the origin's side.
        let (words, anchor) = if rounded {
            ("no vertex of the cores beyond", Anchor::point_toward(end, (end - foot).normalize_or_zero() - u))
        } else {
            ("no vertex beyond", Anchor::point_toward(foot.lerp(begin, 0.5), -u))
        };
        let text = Label::new("stop", words, anchor, Role::Muted);
        sketch.label(text.rank(Rank::Word).size(Size::Note));
    }
}

/// Measures how far the supporting line is from the origin, on the other side of v than the vertex that it
/// passes through, which lies on `side`: B ⊖ A is no nearer.
fn least(sketch: &mut Sketch, foot: DVec2, side: DVec2) {
    let offset = if perp(foot).dot(side) > 0.0 { -LEAST } else { LEAST };
    sketch.part("least").dimension(DVec2::ZERO, foot, offset, Pen::dimension(Role::Ink));
    let anchor = Anchor::Beside { from: DVec2::ZERO, to: foot, offset };
    let text = format!("at least ${}$", text::least(foot.length()));
    sketch.label(Label::new("least", text, anchor, Role::Ink).rank(Rank::Measure).size(Size::Note));
}

#[cfg(test)]
mod tests;
