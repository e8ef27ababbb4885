//! Both bodies projected on one axis of the separating-axis test: two intervals, and the gap or overlap
//! between them.
//!
//! An interval is the shadow of a body: from the least to the largest n·x of its points. The axis is drawn
//! beside the bodies, square to the edge whose normal it is.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Sketch, Weight};
use crate::figure::text::number;
use crate::geometry::{DVec2, Enclosure, Side, perp};
use crate::trace::Event;

use super::half_extents::beside;
use super::{LabelKey, Layer, OptionSpec, Options, Shows, Takes, number_of, part};

/// Distance of the axis from the bodies, page pixels.
const OFFSET: f64 = 26.0;

/// Distance of the two intervals from the axis, page pixels: beside each other where they overlap.
const TRACK: f64 = 6.0;

/// How far the axis reaches past the intervals, page pixels, so that its arrow head stands free.
const PAST: f64 = 22.0;

pub(super) const LAYER: Layer = Layer {
    name: "projection",
    about: "both bodies' intervals on one axis of the separating-axis test",
    shows: Shows::World,
    options: &[OptionSpec {
        name: "axis",
        takes: Takes::Number,
        default: "the one of the largest gap",
        about: "which tested axis, from 1",
    }],
    labels: &[
        LabelKey { key: "n", about: "the axis" },
        LabelKey { key: "gap", about: "gap of the intervals, negative where they overlap" },
    ],
    needs: "the algorithm \"separating-axes\", and no more axes than it tested",
    fed: |context, options| tested(context, options).is_some(),
    draw,
};

/// An axis that the algorithm tested.
#[derive(Clone, Copy)]
struct Tested {
    /// The unit vector along the axis.
    n: DVec2,
    /// From the least to the largest n·x of A's points.
    a: Enclosure,
    /// From the least to the largest n·x of B's points.
    b: Enclosure,
    /// Gap of the intervals, negative where they overlap.
    gap: f64,
}

/// The tested axis that the scene wants; else the one of the largest gap.
fn tested(context: &Context, options: &Options) -> Option<Tested> {
    let run = context.run();
    let all: Vec<Tested> = run
        .told(|event| match *event {
            Event::AxisTested { axis, interval_a, interval_b, gap, .. } => {
                Some(Tested { n: axis, a: interval_a, b: interval_b, gap })
            }
            _ => None,
        })
        .collect();
    match options.number("axis") {
        Some(k) => all.iter().enumerate().find(|(i, _)| number_of(i + 1) == k).map(|(_, t)| *t),
        None => all.into_iter().max_by(|s, t| s.gap.total_cmp(&t.gap)),
    }
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(t) = tested(context, options) else { return };
    let points: Vec<DVec2> = context
        .sides()
        .into_iter()
        .filter_map(|s| context.outline(s, context.time))
        .flat_map(|outline| outline.sampled())
        .collect();
    let (down, far) = beside_bodies(sketch, &t, &points);
    let at = |along: f64, track: f64| t.n * along + down * (far + track);
    let past = sketch.px(PAST);
    let (first, last) = (t.a.lo.min(t.b.lo) - past, t.a.hi.max(t.b.hi) + past);
    sketch.part("axis").arrow(at(first, 0.0), at(last, 0.0), Pen::vector(Role::Muted).width(1.0));
    sketch.label(Label::new("n", "$n$", Anchor::tip(at(first, 0.0), at(last, 0.0)), Role::Muted));
    for (body, interval, track) in [(Side::A, t.a, -TRACK), (Side::B, t.b, TRACK)] {
        let track = sketch.px(track);
        for end in [interval.lo, interval.hi] {
            let vertex = points.iter().copied().min_by(|p, q| {
                (p.dot(t.n) - end)
                    .abs()
                    .total_cmp(&(q.dot(t.n) - end).abs())
                    .then(q.dot(down).total_cmp(&p.dot(down)))
            });
            if let Some(vertex) = vertex {
                sketch.part("shadows").weight(Weight::Light).line(vertex, at(end, track), Pen::extension());
            }
        }
        let pen = Pen::highlighted(options.role(body.into()));
        sketch.part(part("interval", body)).bar(at(interval.lo, track), at(interval.hi, track), 0.0, pen);
    }
    gap(sketch, &t, at);
}

/// The side of the bodies that the axis is drawn on, and how far along it: below, unless the axis is in view
/// only above.
fn beside_bodies(sketch: &Sketch, t: &Tested, points: &[DVec2]) -> (DVec2, f64) {
    let side = perp(t.n);
    let down = if side.y > 0.0 || side.y == 0.0 && side.x < 0.0 { -side } else { side };
    let far = |down: DVec2| {
        points.iter().map(|p| p.dot(down)).fold(f64::NEG_INFINITY, f64::max) + sketch.px(OFFSET)
    };
    let (lo, hi) = sketch.visible();
    let hidden = |down: DVec2| {
        let out = |along: f64| {
            let p = t.n * along + down * far(down);
            (lo - p).max(p - hi).max(DVec2::ZERO).length()
        };
        out(t.a.lo.min(t.b.lo)) + out(t.a.hi.max(t.b.hi))
    };
    let down = if hidden(-down) < hidden(down) { -down } else { down };
    (down, far(down))
}

/// Draws the gap between the facing ends: apart from A's upper end to B's lower one, overlapping the other
/// way round.
fn gap(sketch: &mut Sketch, t: &Tested, at: impl Fn(f64, f64) -> DVec2) {
    let track = sketch.px(4.0 * TRACK);
    let (p, q) = (at(t.a.hi, track), at(t.b.lo, track));
    sketch.part("gap").bar(p, q, 0.0, Pen::dimension(Role::Translation).width(1.5));
    let out = at(0.0, 1.0) - at(0.0, 0.0);
    let label = Label::new("gap", format!("gap $= {}$", number(t.gap)), beside(p, q, out), Role::Translation);
    sketch.label(label.rank(Rank::Measure));
}
