//! Bodies at another moment or place, dotted: where they hit, where they were, every step between, or pushed
//! apart. A moment that counts as much as the panel's, as a frame that a test looks at, may be solid.

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, Label, Marker, Outline, Pen, Rank, SMALL_MARKER, Size, Sketch, Wash, Weight,
};
use crate::figure::text::{Digits, in_math, number};
use crate::geometry::{DVec2, Side, sort_by};
use crate::scene::When;
use crate::trace::phrase;

use super::closest::longer_way;
use super::difference::difference;
use super::elsewhere::{moves, then};
use super::look_alike::look_alike;
use super::moment::written;
use super::spin::seen;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, STEPS, Shows, Takes, Tells, fade, part};

/// The word for bodies pushed apart by the minimum translation, which is no moment.
const SEPARATED: &str = "separated";
/// The word for bodies pushed apart by the next longer way out.
const RIVAL: &str = "rival";
/// The word for bodies where they are, in a panel that draws them solid where they are pushed to.
const NOW: &str = "now";

/// Opacity of a ghost's fill: a body is seen, and not taken for one that is there.
pub(super) const FAINT: f64 = 0.06;
/// A body that is pushed by less, the width of its line in page pixels, is drawn where it was.
const UNSEEN: f64 = 2.25;
/// How many degrees a body turns before it stands as it stood, and a picture of both says too little.
const WHOLE_TURN: f64 = 360.0;
/// The least turn that is written of a body that looks the same after it, degrees.
const SEEN_TURN: f64 = 0.05;
/// Digits of how far a body turned that is seen in another pose.
const TENTHS: Digits = Digits::Decimals(1);

/// How many ghosts of a series are drawn at most, the last included; more are a blur.
const MOST: usize = 5;
/// Opacity of the first ghost of a series, and of the last but one.
const SERIES: [f64; 2] = [0.5, 0.75];

pub(super) const LAYER: Layer = Layer {
    name: "ghosts",
    in_words: phrase(["ghosts", "Körper anderswo", "corps ailleurs", "cuerpos en otro lugar"]),
    about: "bodies at another moment or place, dotted",
    shows: Shows::World,
    tells: Tells::Given,
    options: &[
        OptionSpec {
            name: "of",
            takes: Takes::Bodies,
            default: "those that are elsewhere then",
            about: "which bodies",
        },
        OptionSpec {
            name: "at",
            takes: Takes::When(&[
                When::HIT,
                When::CLOSEST,
                When::BOUND,
                SEPARATED,
                RIVAL,
                NOW,
                When::START,
                When::END,
                STEPS,
            ]),
            default: "\"hit\"",
            about: "when, or overlapping bodies \"separated\" by the minimum translation, or by the \
                next local minimum, a longer push, \"now\" where they are, or at every step, of more than \
                five at those farthest apart in time",
        },
        OptionSpec {
            name: "fill",
            takes: Takes::Flag,
            default: "true",
            about: "a faint fill, unless `faint`, or \"separated\", where it would tint the body twice",
        },
        OptionSpec {
            name: "faint",
            takes: Takes::Flag,
            default: "false",
            about: "half as dark: beside the point",
        },
        OptionSpec {
            name: "solid",
            takes: Takes::Flag,
            default: "false",
            about: "as bodies that are there, solid and filled: a frame that a test looks at",
        },
        OptionSpec {
            name: "path",
            takes: Takes::Flag,
            default: "false",
            about: "the way of the body's origin between here and there, in the order of time",
        },
        OptionSpec {
            name: "centers",
            takes: Takes::Flag,
            default: "false",
            about: "marks the body's origin, with \"steps\" at each but the first, and with \"now\"",
        },
        OptionSpec {
            name: "numbered",
            takes: Takes::Flag,
            default: "false",
            about: "at every step, the step's number instead of its time, as the layer \"graph\" has it",
        },
        OptionSpec {
            name: "text",
            takes: Takes::Lines,
            default: "its name, and when it is there",
            about: "lines of the label in this panel",
        },
    ],
    labels: &[
        LabelKey { key: "A'", about: "the first body, and when it is there" },
        LabelKey { key: "B'", about: "the second body, and when it is there" },
        LabelKey { key: "then", about: "the time of a step before the last" },
    ],
    needs: "an answer with that moment: a hit for \"hit\", a miss for \"closest\", \
        a first step for \"bound\", \
        a separation for \"separated\", another way out for \"rival\", \
        an algorithm that advances in steps for \"steps\"",
    fed: |context, options| match options.word("at", When::HIT) {
        SEPARATED => match separation(context) {
            Some(answer) if push(&answer).is_none() => Fed::not_here("no push is needed to part the bodies"),
            answer => Fed::by_the_scene(answer.is_some()).at_one_moment(options),
        },
        RIVAL => match (rival(context), separation(context)) {
            (None, Some(_)) => Fed::not_here("the bodies are apart already, or have no other way out"),
            (way, _) => Fed::by_the_scene(way.is_some()).at_one_moment(options),
        },
        NOW => Fed::Yes.at_one_moment(options),
        STEPS => Fed::by_the_scene(!context.steps().is_empty()),
        _ => Fed::by_a_moment(when(context, options).is_some(), context, options.when("at")),
    },
    draw,
};

/// The separation at the panel's moment.
fn separation(context: &Context) -> Option<Separation> {
    context.separation_at(context.time)?.separation().copied()
}

/// The shortest way that parts bodies that overlap, as B goes; `None` where they touch or are apart.
fn push(answer: &Separation) -> Option<DVec2> {
    (answer.bounds.hi < 0.0).then(|| -answer.normal * answer.separation)
}

/// The time at which the scene wants the ghosts; `None` where the answer has no such moment.
fn when(context: &Context, options: &Options) -> Option<f64> {
    Some(context.moment(&options.when("at").unwrap_or(When::Hit))?.time)
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    for (i, side) in options.of(&context.sides()).into_iter().enumerate() {
        // Either is pushed all of the way, and not both.
        let or = if i > 0 { "or " } else { "" };
        match options.word("at", When::HIT) {
            SEPARATED => {
                let way = separation(context).and_then(|answer| push(&answer));
                pushed(sketch, context, options, (side, way, [or, "pushed out"]));
            }
            RIVAL => pushed(sketch, context, options, (side, rival(context), [or, "pushed farther"])),
            NOW => now(sketch, context, options, side),
            STEPS => steps(sketch, context, options, side),
            _ => moment(sketch, context, options, side),
        }
    }
}

/// The next longer way out of bodies that overlap, as B goes.
fn rival(context: &Context) -> Option<DVec2> {
    let answer = separation(context).filter(|answer| answer.bounds.hi < 0.0)?;
    let found = difference(context, context.time)?;
    let way = longer_way(&found, DVec2::ZERO, -answer.separation)?;
    Some(-way.edge.normal * way.length)
}

/// Draws a body parted from the other: B by the way, A against it; `how` says which way it is, after an "or"
/// where the other body is drawn so too.
fn pushed(
    sketch: &mut Sketch,
    context: &Context,
    options: &Options,
    (side, way, [or, how]): (Side, Option<DVec2>, [&str; 2]),
) {
    let (Some(way), Some(outline)) = (way, context.outline(side, context.time)) else { return };
    sketch.since(context.separation_at(context.time).map(|run| run.end()));
    let text = format!("{or}{} {how}", context.named(side).primed(0));
    if way.length() < sketch.px(UNSEEN) {
        return;
    }
    ghost(sketch, options, side, &outline.moved(if side == Side::A { -way } else { way }), vec![text]);
}

/// Draws a body where it is: as a ghost if it is pushed from there, and else as a body.
fn now(sketch: &mut Sketch, context: &Context, options: &Options, side: Side) {
    let Some(outline) = context.outline(side, context.time) else { return };
    let lines = vec![context.named(side).primed(0)];
    if separation(context).is_some_and(|answer| push(&answer).is_some()) {
        ghost(sketch, options, side, &outline, lines);
        return center(sketch, context, options, (side, context.time));
    }
    let role = options.role(side.into());
    sketch.part(part("body", side)).area(&outline, Some(Wash::theme(role)), Some(Pen::outline(role)));
    let label = Label { lines, ..Label::new(key(side), "", Anchor::inside(&outline), role) };
    sketch.label(label.rank(Rank::Name).size(Size::Name));
}

/// The key of a ghost's label.
fn key(side: Side) -> &'static str {
    if side == Side::A { "A'" } else { "B'" }
}

/// Draws a body at another moment, if it is elsewhere then.
fn moment(sketch: &mut Sketch, context: &Context, options: &Options, side: Side) {
    let Some(time) = when(context, options) else { return };
    sketch.since(context.known(&options.when("at").unwrap_or(When::Hit)));
    if let Some(outline) = then(context, side, time) {
        way(sketch, context, options, (side, time));
        elsewhere(sketch, context, options, (side, time, &written(context, time)), &outline);
    }
}

/// Draws the way of a body's origin between the panel's moment and another, if the scene wants it.
fn way(sketch: &mut Sketch, context: &Context, options: &Options, (side, time): (Side, f64)) {
    if !options.flag("path", false) {
        return;
    }
    let way = context.track(side, DVec2::ZERO, [time.min(context.time), time.max(context.time)]);
    let role = options.role(side.into());
    sketch.part(part("way", side)).path_to_its_end(&way, Pen::path(role));
    // Its head says where the origin comes to; a dot, where it was.
    if let Some(&start) = way.first() {
        sketch.marker(start, Marker::Disc, role, SMALL_MARKER);
    }
}

/// Draws a body at a moment in which it has another pose; where its outline is one with that of now, and it
/// is not on its way there, it is only said, as two names would stand on one body.
pub(super) fn elsewhere(
    sketch: &mut Sketch,
    context: &Context,
    options: &Options,
    (side, time, written): (Side, f64, &str),
    outline: &Outline,
) {
    let now = context.outline(side, context.time);
    let is_wanted = options.words("text").is_some() || options.flag("solid", false);
    let is_drawn = is_wanted || context.play.moves();
    if is_drawn || !now.is_some_and(|now| look_alike(&now, outline, sketch.px(UNSEEN))) {
        let mut lines = at_moment(context, side, written);
        lines.extend(turned(context, side, time, WHOLE_TURN));
        return ghost(sketch, options, side, outline, lines);
    }
    let mut lines = vec!["looks the same".to_owned(), format!("at $t = {written}$")];
    lines.extend(turned(context, side, time, SEEN_TURN));
    sketch.label(label(options, side, outline, lines));
}

/// The label of a body at a moment: "A at t = 0.5"; below each other where the name is a word, as a long line
/// reaches from the body now to the body then.
fn at_moment(context: &Context, side: Side, time: &str) -> Vec<String> {
    let (name, then) = (context.named(side), format!("at $t = {time}$"));
    if name.is_symbol() { vec![format!("{} {then}", name.primed(0))] } else { vec![name.primed(0), then] }
}

/// How far a body has turned by a moment since the start, whatever moment its panel shows, clockwise with a
/// minus, where that is so many degrees or more: five whole turns look like none. To a tenth of a degree,
/// which is about what is seen: −360.4° in three digits would be none.
fn turned(context: &Context, side: Side, time: f64, least: f64) -> Option<String> {
    let (_, spin) = seen(context, side)?;
    let degrees = spin * time;
    let tenths = TENTHS.of(degrees, degrees);
    let written = tenths.strip_suffix(".0").unwrap_or(&tenths);
    (degrees.abs() >= least).then(|| format!("turned ${}°$", in_math(written)))
}

/// Fill and line of a ghost.
fn look(options: &Options, role: Role) -> (Option<Wash>, Pen) {
    if options.flag("solid", false) {
        (Some(Wash::theme(role)), Pen::outline(role))
    } else {
        // What only might be is fainter than what is.
        let is_faint = options.flag("faint", options.word("at", When::HIT) == RIVAL);
        let opacity = if is_faint { SERIES[0] } else { 1.0 };
        // A body is seldom pushed by more than its size: its tint over its own would be a third colour.
        let is_filled = !is_faint && options.word("at", When::HIT) != SEPARATED;
        (options.flag("fill", is_filled).then(|| Wash::faint(role, FAINT)), Pen::ghost(role).opacity(opacity))
    }
}

/// Draws one ghost and names it by `lines`.
pub(super) fn ghost(
    sketch: &mut Sketch,
    options: &Options,
    side: Side,
    outline: &Outline,
    lines: Vec<String>,
) {
    let (wash, pen) = look(options, options.role(side.into()));
    sketch.part(part("ghost", side)).weight(Weight::Light).area(outline, wash, Some(pen));
    sketch.label(label(options, side, outline, lines));
}

/// The label of a body at another moment, or in the words that the scene has for it.
fn label(options: &Options, side: Side, outline: &Outline, lines: Vec<String>) -> Label {
    let anchor = Anchor::inside(outline);
    let label = Label { lines, ..Label::new(key(side), "", anchor, options.role(side.into())) };
    let label = label.rank(Rank::Name).size(Size::Note);
    if let Some(text) = options.words("text") { label.given(text) } else { label }
}

/// Steps before the last with their numbers: of more than [`MOST`] those that are farthest from each other,
/// from the start and from the last in time, one by one, before them the first if it is given. An advancement
/// closes in, and its last steps lie on each other.
fn apart(first: Option<f64>, before: &[f64], last: f64) -> Vec<(usize, f64)> {
    let mut kept: Vec<usize> = Vec::new();
    while kept.len() + 1 < MOST && kept.len() < before.len() {
        let room = |i: usize| {
            let taken = kept.iter().map(|&k| before[k]).chain([0.0, last]);
            taken.map(|time| (time - before[i]).abs()).fold(f64::INFINITY, f64::min)
        };
        // Of several the first.
        let free = (0..before.len()).rev().filter(|i| !kept.contains(i));
        kept.extend(free.max_by(|&i, &j| room(i).total_cmp(&room(j))));
    }
    sort_by(&mut kept, usize::cmp);
    first.map(|t| (1, t)).into_iter().chain(kept.into_iter().map(|i| (i + 2, before[i]))).collect()
}

/// Draws the body at each step where it is not now, with its time or number; of more than [`MOST`] after the
/// first those that are [`apart`], where the eye can tell them from the last, and that, which is named.
fn steps(sketch: &mut Sketch, context: &Context, options: &Options, side: Side) {
    // What rests is nowhere else at any step.
    if options.words("of").is_none() && !moves(context, side) {
        return;
    }
    let times = context.steps();
    let [first, before @ .., last] = &times[..] else { return };
    let now = context.outline(side, context.time).filter(|_| !context.play.moves());
    let unseen = sketch.px(UNSEEN);
    let is_here = |then: &Outline| now.as_ref().is_some_and(|now| look_alike(now, then, unseen));
    let elsewhere = |time: f64| context.outline(side, time).filter(|then| !is_here(then));
    let end = context.outline(side, *last);
    let is_end = |then: &Outline| end.as_ref().is_some_and(|end| look_alike(end, then, unseen));
    let role = options.role(side.into());
    let [numbered, solid] = ["numbered", "solid"].map(|flag| options.flag(flag, false));
    let then = |step: usize, time: f64| {
        if numbered { format!("$t_{{{step}}}$") } else { format!("$t = {}$", number(time)) }
    };
    let at = |then: String| format!("{} at {then}", context.named(side).primed(0));
    let kept = apart(Some(*first).filter(|t| now.is_some() && elsewhere(*t).is_some()), before, *last);
    for ((step, time), opacity) in kept.iter().zip(fade(SERIES, kept.len())) {
        let Some(outline) = elsewhere(*time).filter(|then| !is_end(then)) else { continue };
        sketch.since(context.known(&When::Step(*step)));
        let ((wash, pen), then) = (look(options, role), then(*step, *time));
        // Bodies that are there are all as much there, and named alike.
        let pen = Some(if solid { pen } else { pen.opacity(opacity) });
        sketch.part(part("ghost", side)).weight(Weight::Light).area(&outline, wash, pen);
        center(sketch, context, options, (side, *time));
        let label = Label::new("then", &then, Anchor::inside(&outline), role).rank(Rank::Word);
        sketch.label(if solid && numbered {
            Label { lines: vec![at(then)], ..label }.size(Size::Note)
        } else {
            label.size(Size::Small)
        });
    }
    if let Some(outline) = elsewhere(*last) {
        let (count, last) = (times.len(), *last);
        sketch.since(context.known(&When::Step(count)));
        way(sketch, context, options, (side, last));
        let named = || at_moment(context, side, &number(last));
        let text = if numbered { vec![at(then(count, last))] } else { named() };
        ghost(sketch, options, side, &outline, text);
        center(sketch, context, options, (side, last));
    }
}

/// Marks the origin of a body at a step, if the scene wants it: about it the body turns; hollow where the
/// body is no longer.
fn center(sketch: &mut Sketch, context: &Context, options: &Options, (side, time): (Side, f64)) {
    if let Some(pose) = context.pose(side, time).filter(|_| options.flag("centers", false)) {
        let (marker, role) = match side {
            _ if options.word("at", When::HIT) != NOW => (Marker::Disc, Role::Ink),
            Side::A => (Marker::HollowDisc, Role::A),
            Side::B => (Marker::HollowSquare, Role::B),
        };
        sketch.part(part("center", side)).marker(pose.position, marker, role, SMALL_MARKER);
    }
}
