//! Half-extents `h_x` and `h_y`, from the centre of a box to its sides, as bars or dimension lines beside it.

use crate::collision::Answer;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch, Weight, left_of};
use crate::figure::text::number;
use crate::geometry::DVec2;
use crate::trace::step::bounds;
use crate::trace::{Event, phrase};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Distance of the lines from the box where the scene does not say, page pixels: a dimension's label fits
/// beside it.
const OFFSET: f64 = 24.0;

/// How far the anchor of a label is moved to the side of a line that it belongs to, page pixels: too little
/// to be seen.
pub(super) const ON_LINE: f64 = 1.0;

/// About how wide "`h_y` = " is with the gap before it, page pixels.
const LETTERS: f64 = 46.0;

/// About how wide a digit is, page pixels.
const DIGIT: f64 = 8.0;

/// What a fitted view has beside what is drawn, page pixels.
const ROOM: f64 = 40.0;

/// Opacity of a line that leads through a body to its length.
pub(super) const GUIDE: f64 = 0.55;

pub(super) const LAYER: Layer = Layer {
    name: "half-extents",
    in_words: phrase(["half-extents", "halbe Ausdehnungen", "demi-étendues", "semiextensiones"]),
    about: "half-extents of a box, from its centre to its edges, without a radius",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "of",
            takes: Takes::Bodies,
            default: "the first box",
            about: "which body, unless the query is for bounds",
        },
        OptionSpec {
            name: "style",
            takes: Takes::Word(&["bar", "dimension", "inside"]),
            default: "\"dimension\"",
            about: "thick bars or dimension lines beside the box, or dimension lines from its centre",
        },
        OptionSpec {
            name: "offset",
            takes: Takes::Number,
            default: "24",
            about: "distance from the box, page px",
        },
    ],
    labels: &[
        LabelKey { key: "h_x", about: "half the width" },
        LabelKey { key: "h_y", about: "half the height" },
    ],
    needs: "a query for bounds, or a box",
    fed: |context, options| Fed::by_the_scene(boxed(context, options).is_some()),
    draw,
};

/// A box with its axes, all in the world.
struct Boxed {
    /// The middle of the box.
    center: DVec2,
    /// Unit vector along its x axis.
    x: DVec2,
    /// Unit vector along its y axis.
    y: DVec2,
    /// Half-extents along its own axes, world units.
    half: DVec2,
}

/// The bounds that the query found, or the first box that the scene wants.
fn boxed(context: &Context, options: &Options) -> Option<Boxed> {
    if let Answer::Bounds(bounds) = context.run().answer {
        return Some(Boxed { center: bounds.center, x: DVec2::X, y: DVec2::Y, half: bounds.half_extents });
    }
    options.of(&context.sides()).into_iter().find_map(|side| {
        let half = context.body(side)?.shape.half_extents?;
        let pose = context.pose(side, context.time)?;
        Some(Boxed { center: pose.position, x: pose.vector(DVec2::X), y: pose.vector(DVec2::Y), half })
    })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(b) = boxed(context, options) else { return };
    sketch.since(
        context.cue(|event| matches!(event, Event::BoundsFound { .. })).map(|cue| cue.part(bounds::CENTER)),
    );
    let offset = sketch.px(options.number("offset").unwrap_or(OFFSET));
    // Beside the box, on the sides that no other body is at; below and to the right where all are free.
    let away = others(context, &b);
    let down = if away.y < 0.0 { b.y } else { -b.y };
    let aside = if away.x > 0.0 { -b.x } else { b.x };
    // In the box away from other bodies too; beside it to the corner of largest coordinates.
    let inside = options.word("style", "dimension") == "inside";
    let [right, up] = if inside { [aside, down] } else { [b.x, b.y] };
    line(
        sketch,
        options,
        &Line {
            key: "h_x",
            from: b.center,
            along: right * b.half.x,
            out: down * (b.half.y + offset),
            past: down * b.half.y,
            length: b.half.x,
        },
    );
    line(
        sketch,
        options,
        &Line {
            key: "h_y",
            from: b.center,
            along: up * b.half.y,
            out: aside * (b.half.x + offset),
            past: aside * b.half.x,
            length: b.half.y,
        },
    );
}

/// Where the other bodies are from the box, along its axes; only the signs count.
fn others(context: &Context, b: &Boxed) -> DVec2 {
    let far = context.sides().into_iter().filter_map(|side| context.pose(side, context.time));
    let sum: DVec2 = far.map(|pose| pose.position - b.center).sum();
    if matches!(context.run().answer, Answer::Bounds(_)) {
        DVec2::ZERO
    } else {
        DVec2::new(sum.dot(b.x), sum.dot(b.y))
    }
}

/// A half-extent to be drawn, in the world.
struct Line {
    /// Key of its label.
    key: &'static str,
    /// The centre of the box.
    from: DVec2,
    /// From the centre to the side that the half-extent reaches.
    along: DVec2,
    /// From the centre to where the line is drawn, beside the box.
    out: DVec2,
    /// From the centre to the box's side on the way there.
    past: DVec2,
    /// The half-extent, world units.
    length: f64,
}

/// Draws one half-extent.
fn line(sketch: &mut Sketch, options: &Options, l: &Line) {
    if l.length == 0.0 {
        return;
    }
    let style = options.word("style", "dimension");
    let bar = style == "bar";
    let role = options.role(Role::Ink);
    if style == "inside" {
        let tip = l.from + l.along;
        sketch.part(l.key.replace('_', "-")).dimension(l.from, tip, 0.0, Pen::dimension(role).width(1.5));
        let text = format!("${} = {}$", l.key, number(l.length));
        sketch.label(Label::new(l.key, text, Anchor::middle(l.from, tip), role));
        return;
    }
    let (p, q) = (l.from + l.out, l.from + l.out + l.along);
    let part = l.key.replace('_', "-");
    // A bar stands for the way from the centre; a length begins at the box, as a line from the centre would
    // look like an axis.
    let begin = if bar { l.from } else { l.from + l.past };
    // Faint, as it may lead through the body.
    let guide = Pen::extension().opacity(if bar { GUIDE } else { 1.0 });
    sketch.part(&part).weight(Weight::Light).line(begin, p, guide);
    sketch.part(&part).weight(Weight::Light).line(l.from + l.past + l.along, q, Pen::extension());
    let pen = if bar { Pen::highlighted(role) } else { Pen::dimension(role) };
    sketch.part(&part).bar(p, q, 0.0, pen);
    // A fitted view has room for a short number beside a bar, and more is made for a longer one.
    let written = number(l.length);
    let px = LETTERS + DIGIT * f64::from(u32::try_from(written.len()).unwrap_or(0)) - ROOM;
    let aside = (l.out.normalize_or_zero() * DVec2::X * sketch.px(px.max(0.0))).x;
    sketch.reach(&[0.5 * (p + q) + DVec2::new(aside, 0.0)]);
    let text = format!("${} = {written}$", l.key);
    sketch.label(Label::new(l.key, text, beside(p, q, l.out), role));
}

/// The anchor of a label beside a line of the world, on the side of `out`.
pub(super) fn beside(p: DVec2, q: DVec2, out: DVec2) -> Anchor {
    let (from, to) = if left_of(p, q).dot(out) < 0.0 { (q, p) } else { (p, q) };
    Anchor::Beside { from, to, offset: ON_LINE }
}
