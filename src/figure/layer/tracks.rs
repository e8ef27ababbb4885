//! The paths of the two points that touch, from t = 0 to the hit: rarely the points that are closest at the
//! start. Each is marked where it is at the panel's moment; a figure in steps shows the bodies where an
//! advancement looks at them on the way.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Rank, Sketch};
use crate::geometry::{DVec2, Side};
use crate::trace::{Event, phrase};

use super::elsewhere::then;
use super::ghosts::ghost;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

/// The most places on the way that come and go, which the eye could follow.
const MOST_PASSING: usize = 40;

pub(super) const LAYER: Layer = Layer {
    name: "tracks",
    in_words: phrase([
        "tracks",
        "Wege der Berührpunkte",
        "trajets des points de contact",
        "caminos de los puntos de contacto",
    ]),
    about: "paths of the two points that touch at the hit, from the start until then",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "ahead",
            takes: Takes::Flag,
            default: "false",
            about: "the way that is still ahead at the panel's moment, and no more",
        },
        OptionSpec {
            name: "paths",
            takes: Takes::Flag,
            default: "true",
            about: "the ways; without them the points at the panel's moment",
        },
    ],
    labels: &[
        LabelKey { key: "x1", about: "the point of A" },
        LabelKey { key: "x2", about: "the point of B" },
    ],
    needs: "a hit",
    fed: |context, _| Fed::by_a_hit(context),
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((time, contact)) = context.hit() else { return };
    sketch.since(context.answered());
    for (side, point, key, marker) in
        [(Side::A, contact.points[0], "x1", Marker::Disc), (Side::B, contact.points[1], "x2", Marker::Square)]
    {
        let (Some(then), Some(now)) = (context.pose(side, time), context.pose(side, context.time)) else {
            continue;
        };
        let local = then.inverse_point(point);
        let begin = if options.flag("ahead", false) { context.time.min(time) } else { 0.0 };
        let path = context.track(side, local, [begin, time]);
        let role = options.role(side.into());
        if options.flag("paths", true) && path.first() != path.last() {
            sketch.part(part("track", side)).path_through_time(&path, Pen::path(role));
        }
        let place = now.point(local);
        sketch.part(part("track", side)).marker(place, marker, role, LARGE_MARKER);
        let back = path.first().zip(path.get(1)).map_or(DVec2::ZERO, |(&start, &next)| start - next);
        // Where the two are at one place, each name stands in its own body.
        let inward = contact.normal * if side == Side::A { -1.0 } else { 1.0 };
        let away = if context.time >= time { inward } else { back };
        let anchor = Anchor::point_toward(place, away);
        let text = format!("${}$", context.numbered("x", side));
        sketch.label(Label::new(key, text, anchor, role).rank(Rank::Point));
    }
    // From where the story begins, as it is told.
    let begins = context.time == 0.0 && context.moving_frame().is_none();
    if begins && options.flag("paths", true) && !options.flag("ahead", false) {
        looks(sketch, context, options);
    }
}

/// Where an advancement looks on the way, and how far apart the bodies are there: each goes when the next one
/// comes.
fn looks(sketch: &mut Sketch, context: &Context, options: &Options) {
    let run = context.run();
    let look = |event: &Event| match *event {
        Event::Advanced { at, points, .. } => Some((at.time, points)),
        _ => None,
    };
    let all: Vec<(Cue, (f64, [DVec2; 2]))> = run.cues(look).take(MOST_PASSING).collect();
    let ends = all.iter().skip(1).map(|(cue, _)| *cue).chain([run.end()]);
    for ((from, (time, points)), to) in all.iter().zip(ends).filter(|((from, _), to)| from != to) {
        sketch.passing([*from, to], |sketch| {
            for side in context.sides() {
                if let Some(outline) = then(context, side, *time) {
                    ghost(sketch, options, side, &outline, Vec::new());
                }
            }
            sketch.part("look").line(points[0], points[1], Pen::dimension(Role::Translation));
            sketch.marker(points[0], Marker::Disc, Role::Translation, MARKER);
            sketch.marker(points[1], Marker::Square, Role::Translation, MARKER);
        });
    }
}
