//! The ray along the relative velocity against B ⊖ A: it enters when the bodies touch.
//!
//! It is the origin's way over t in [0, 1] as seen from B ⊖ A: in a panel of a later moment it starts behind
//! the origin. In a figure that plays, a dot is where the origin has come to.
//!
//! Where a body turns, B ⊖ A changes on the way, and there is no such ray.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Rank, Size, Sketch, Weight};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::scene::{NOTES, When};
use crate::trace::{Culling, Event, phrase};

use super::facing::velocity_along;
use super::held;
use super::velocity::{label_of_hit, text, until_hit};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

pub(super) const LAYER: Layer = Layer {
    name: "ray",
    in_words: phrase(["ray", "Strahl", "rayon lancé", "rayo"]),
    about: "the origin's way along the relative velocity, and where it hits",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "cut",
            takes: Takes::Word(&[When::HIT]),
            default: "none",
            about: "ends soon after the hit",
        },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the components of the relative velocity",
        },
        OptionSpec {
            name: "free",
            takes: Takes::Flag,
            default: "true",
            about: "a band under the way that is free, up to the hit",
        },
        OptionSpec {
            name: "parts",
            takes: Takes::Flag,
            default: "false",
            about: "where both bodies move, A's velocity and then B's reversed, which lead to the same tip",
        },
        OptionSpec {
            name: "ends",
            takes: Takes::Flag,
            default: "false",
            about: "writes the times of its ends",
        },
        OptionSpec {
            name: "lines",
            takes: Takes::Flag,
            default: "false",
            about: "dashed lines from the edges that look against it and that it misses, to where it meets \
                    their lines before the hit",
        },
    ],
    labels: &[
        LabelKey { key: "v", about: "the relative velocity" },
        LabelKey { key: "part.A", about: "velocity of the first body, as a part of it" },
        LabelKey { key: "part.B", about: "velocity of the second body, reversed, as a part of it" },
        LabelKey {
            key: "t",
            about: "time of the hit, along the free way; without its band, with ends or lines, at the hit",
        },
        LabelKey { key: "met", about: "times at which it meets the lines, with lines" },
        LabelKey { key: "start", about: "the time where it starts, with ends" },
        LabelKey { key: "end", about: "the time where it ends, with ends" },
    ],
    needs: "a question for the first contact of bodies that move relative to each other and do not turn",
    fed: |context, options| {
        let cut = (options.word("cut", "") == When::HIT).then_some("cut");
        let given = cut.or(options.flag("lines", false).then_some("lines")).filter(|_| NOTES);
        let found = velocity_along(context).is_some();
        if !found && context.asks_for_a_hit() && !context.turns() {
            return Fed::not_here("the bodies do not move relative to each other");
        }
        Fed::by_the_scene(found).with_a_hit_for(given, context)
    },
    draw,
};

/// Width of the velocities that make up the relative one, page pixels: less than its own.
const PART: f64 = 1.25;

/// Opacity of those velocities: they run across what the relative one enters.
const FAINT: f64 = 0.7;

/// The most edges that come and go, which the eye could follow.
const MOST_PASSING: usize = 40;

/// How much farther than the hit a ray reaches that is cut there.
const PAST: f64 = 1.5;

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let v = context.closing_velocity();
    let role = options.role(Role::Ink);
    let hit = context.hit_time();
    let cut =
        hit.filter(|_| options.word("cut", "") == When::HIT).map_or(1.0, |time| 1.0_f64.min(PAST * time.lo));
    let from = -v * context.difference_time();
    let tip = from + v * cut;
    if options.flag("parts", false) {
        parts(sketch, context, options, from);
    }
    sketch.since(None).part("ray").arrow(from, tip, Pen::vector(role));
    if let Some(time) = hit.filter(|_| options.flag("free", true)) {
        sketch.since(context.answered()).part("until-hit").line(from, from + v * time.lo, until_hit());
        sketch.since(None);
    }
    let lined = options.flag("lines", false);
    if lined {
        missed(sketch, context, from, v);
    }
    // Where the times stand at its points, its own place is between them.
    let timed = options.flag("ends", false);
    let named = if timed { Anchor::middle(from, tip) } else { Anchor::tip(from, tip) };
    sketch.label(Label::new("v", text("$v$", v, options, cut), named, role));
    // Of two estimates at one place a reader sees one, with two times.
    let next = estimate(context).filter(|next| hit.is_some_and(|time| *next < time.lo));
    let apart =
        |time: f64| next.is_none_or(|next| sketch.on_page((time - next) * v.length()) >= LARGE_MARKER);
    if let Some(time) = hit.filter(|time| apart(time.lo)) {
        let hit = from + v * time.lo;
        sketch.since(context.answered());
        let along = options.flag("free", true) && !timed && !lined;
        sketch.label(label_of_hit(time, if along { Anchor::middle(from, hit) } else { Anchor::point(hit) }));
        sketch.part("hit").marker(hit, Marker::Diamond, Role::Now, LARGE_MARKER);
    }
    if timed {
        ends(sketch, [(from, -v, 0.0), (tip, v, cut)]);
    }
    if options.word("cut", "") != When::HIT {
        held::closing_velocity(sketch, context, (tip, cut - context.difference_time()));
    }
    if let Some(now) = context.play.stands_at() {
        sketch.since(None).part("now").marker(from + v * now, Marker::Disc, role, MARKER);
    }
    tests(sketch, context, from, v);
}

/// Where the panel's step of an advancement goes next.
fn estimate(context: &Context) -> Option<f64> {
    let next = |event: &Event| match *event {
        Event::Advanced { step, next, .. } if Some(step) == context.step => next,
        _ => None,
    };
    context.run().find_told(next)
}

/// Draws the edges one by one as the ray `from` along v is held against them: each that faces it, and where
/// it meets the line of one that it misses, until the next; the one that it enters through, and those in a
/// row that are passed over, together, to the end.
fn tests(sketch: &mut Sketch, context: &Context, from: DVec2, v: DVec2) {
    let run = context.run();
    let clipped = |event: &Event| match *event {
        Event::RayClipped { from: p, to: q, outcome, time, .. } => {
            Some(([p + from, q + from], outcome, time))
        }
        _ => None,
    };
    let all: Vec<(Cue, _)> = run.cues(clipped).take(MOST_PASSING).collect();
    let mut first = run.end();
    for (i, &(cue, (ends, outcome, time))) in all.iter().enumerate() {
        let is_away = outcome == Culling::BackFacing;
        let follows = i > 0 && is_away && all[i - 1].1.1 == outcome;
        first = if follows { first } else { cue };
        let goes = outcome == Culling::Missed;
        let next = all.get(i + 1).filter(|_| goes).map_or(run.end(), |(next, _)| *next);
        if first == next {
            continue;
        }
        let role = if is_away { Role::Muted } else { Role::Now };
        sketch.passing([first, next], |sketch| {
            sketch.part("tested");
            // Of round bodies a vertex, about which the outline runs.
            if ends[0] == ends[1] {
                sketch.marker(ends[0], Marker::HollowDisc, role, LARGE_MARKER);
            } else {
                sketch.line(ends[0], ends[1], Pen::highlighted(role));
            }
            let Some(at) = time.filter(|time| (0.0..=1.0).contains(time)).map(|time| from + v * time) else {
                return;
            };
            if goes {
                line_to(sketch, ends, at);
            } else if outcome == Culling::Hit {
                sketch.part("meets").marker(at, Marker::HollowDisc, Role::Ink, MARKER);
            }
        });
    }
}

/// Draws the line of an edge on to where the ray meets it.
fn line_to(sketch: &mut Sketch, [p, q]: [DVec2; 2], meets: DVec2) {
    let end = if meets.distance_squared(p) < meets.distance_squared(q) { p } else { q };
    sketch.part("line").weight(Weight::Light).line(end, meets, Pen::construction());
    sketch.part("meets").marker(meets, Marker::HollowDisc, Role::Ink, MARKER);
}

/// Draws the lines of the edges that the ray from `start` along v misses on its way to the hit: it meets the
/// line of the edge that it enters through last.
fn missed(sketch: &mut Sketch, context: &Context, start: DVec2, v: DVec2) {
    let Some(hit) = context.hit_time() else { return };
    let run = context.run();
    let told = run.told(|event| match *event {
        Event::RayClipped { from, to, outcome: Culling::Missed, time: Some(time), .. } => {
            Some((from + start, to + start, time))
        }
        _ => None,
    });
    // Two edges on one line are met together.
    let mut named = Vec::new();
    for (p, q, time) in told.filter(|(p, q, time)| p != q && (0.0..hit.lo).contains(time)) {
        let meets = start + v * time;
        line_to(sketch.since(context.answered()), [p, q], meets);
        if !named.contains(&time) {
            named.push(time);
            let text = format!("its line: $t = {}$", number(time));
            let label = Label::new("met", text, Anchor::point(meets), Role::Ink);
            sketch.label(label.rank(Rank::Word).size(Size::Note));
        }
    }
}

/// Names the times of both ends, each a place, the way out there, and the time.
fn ends(sketch: &mut Sketch, ends: [(DVec2, DVec2, f64); 2]) {
    for (key, (at, out, time)) in ["start", "end"].into_iter().zip(ends) {
        let anchor = Anchor::point_toward(at, out);
        let label = Label::new(key, format!("$t = {}$", number(time)), anchor, Role::Muted);
        sketch.since(None).label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// Draws the velocities that make up the relative one, `v_A` and then −`v_B`, where both bodies move.
fn parts(sketch: &mut Sketch, context: &Context, options: &Options, from: DVec2) {
    let [a, b] = [Side::A, Side::B].map(|side| context.body(side).map_or(DVec2::ZERO, |body| body.velocity));
    if a == DVec2::ZERO || b == DVec2::ZERO {
        return;
    }
    let reversed = context.symbol("v", Side::B).replacen('$', "$-", 1);
    let ways = [("part.A", Side::A, context.symbol("v", Side::A), a), ("part.B", Side::B, reversed, -b)];
    let mut tail = from;
    for (key, side, symbol, way) in ways {
        sketch.since(None).part(part("ray", side)).arrow(
            tail,
            tail + way,
            Pen::vector(side.into()).width(PART).opacity(FAINT),
        );
        let anchor = Anchor::middle(tail, tail + way);
        let label = Label::new(key, text(&symbol, way, options, 1.0), anchor, side.into());
        sketch.label(label.rank(Rank::Measure).size(Size::Note));
        tail += way;
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths, points};
    use crate::figure::{Pull, draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;
    use crate::trace::Event;

    #[test]
    fn the_ends_of_a_ray_have_their_times_where_they_are_asked_for() {
        for (options, expected) in [("", [None, None]), (", ends = true", [Some(0.0), Some(1.0)])] {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1, velocity = [8, 2] }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [5, 1] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration', layers = [{{ layer = 'ray'{options} }}] }}]"
            );
            let scene = open_text("ray", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let labels = labels(&draw(&plan, plan.theme, "ray"));
            let said = ["start", "end"].map(|key| labels.get(key).map(|label| label.1));
            assert_eq!(said, expected, "{options}");
        }
    }

    #[test]
    fn the_lines_that_it_meets_are_those_of_edges_that_look_against_it_before_the_hit() {
        for (option, count) in [("", 0), (", lines = true", 1)] {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [8, 4] }}
                shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [5, 3] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration', layers = [{{ layer = 'ray'{option} }}] }}]"
            );
            let scene = open_text("ray", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "ray");
            // It meets y = 1, the line of two edges below B ⊖ A, at (2, 1), then x = 3 at (3, 1.5).
            let frame = &figure.panels[0].frame;
            let place = frame.page(DVec2::new(2.0, 1.0));
            let lines = paths(&figure.drawing.items, "line");
            let met = lines.iter().filter(|line| (points(line)[1] - place).length() < 1e-6).count();
            assert_eq!((met > 0, lines.len() == met), (count > 0, true), "{option}");
            // When it does is said once.
            let times = figure.panels[0].placed.iter().filter(|label| label.key == "met").count();
            assert_eq!(times, count, "{option}");
        }
    }

    #[test]
    fn where_a_step_comes_as_near_as_a_marker_the_hit_is_not_named_beside_it() {
        let named = |step: usize| {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], radius = 0.3, position = [-27, -15],
                    velocity = [27, 15] }}
                shapes.B = {{ kind = 'box', half_extents = [1, 1], angle_deg = 10, radius = 0.4 }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'], algorithm = 'ray-clipping',
                    tolerance = 1e-9 }}
                canvas.width = 240
                panels = [{{ space = 'configuration', step = {step}, layers = ['ray', 'advancement'] }}]"
            );
            let scene = open_text("ray", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "ray");
            let times: Vec<f64> = plan
                .runs
                .own(&scene, 0.0)
                .told(|event| match *event {
                    Event::Advanced { next, .. } => next,
                    _ => None,
                })
                .collect();
            (figure.panels[0].placed.iter().any(|label| label.key == "t"), times)
        };
        let (first, times) = named(1);
        assert!(!first && times.len() == 2, "{times:?}");
        assert!(named(2).0, "the last estimate is the hit");
    }

    #[test]
    fn its_tip_is_held_unless_the_hit_cuts_it() {
        let handles = |v: [f64; 2], options: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1, velocity = {v:?} }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [5, 1] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration', view = [-2, -4, 12, 6],
                    layers = [{{ layer = 'ray'{options} }}] }}]"
            );
            let scene = open_text("ray", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            draw(&plan, plan.theme, "ray").handles
        };
        let (before, after) = (handles([8.0, 2.0], "")[0], handles([8.5, 1.0], "")[0]);
        let Pull::Plane([right, down]) = before.pull else { panic!("{before:?}") };
        let followed = right * (after.at.x - before.at.x) + down * (after.at.y - before.at.y);
        assert!((followed - DVec2::new(0.5, -1.0)).length() < 1e-9, "{followed}");
        assert_eq!(handles([8.0, 2.0], ", cut = 'hit'"), []);
    }
}
