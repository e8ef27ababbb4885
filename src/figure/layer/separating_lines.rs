//! The lines that pass between two bodies, from one that touches both to the other: the cone of separating
//! directions in the world.
//!
//! A line between A and B, square to n, can turn until it touches both. The two where it does, the inner
//! tangents of the bodies, are the tangents from O to B ⊖ A of [`separating_cone`](super::separating_cone):
//!
//! ```text
//! support of B against n − support of A along n = the point of B ⊖ A that is touched
//! ```
//!
//! so the directions square to them bound the same cone. It is drawn where the two lines cross: each line
//! through that point square to a direction of the cone passes between the bodies.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, Label, MARKER, Marker, Outline, Pen, Rank, SMALL_MARKER, Size, Sketch, Wash, Weight, angle_of,
    on_circle,
};
use crate::geometry::{DVec2, Side, perp};
use crate::trace::phrase;

use super::separating_cone::{Cone, FILL, NAMES, PAST, TANGENT, TURNED, cone, fitting_radius, right_angle};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Opacity of a line that touches both bodies where it runs through the cone: it is no side of that.
const FAINT: f64 = 0.3;

/// How many times farther from where the lines cross one touches A than B where it is named on the way to A.
const SHORT: f64 = 3.0;

/// The words of the option `show`.
const PARTS: [&str; 2] = ["line", "cone"];

pub(super) const LAYER: Layer = Layer {
    name: "separating-lines",
    in_words: phrase(["separating-lines", "trennende Geraden", "droites séparatrices", "rectas separadoras"]),
    about: "the lines between the bodies that touch both, with the cone of directions that separate them",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "names",
            takes: Takes::Flag,
            default: "false",
            about: "names both lines, and each end of the cone by the line that it is square to",
        },
        OptionSpec {
            name: "show",
            takes: Takes::Words(&PARTS),
            default: "all",
            about: "which parts: the direction of the greatest gap, alone with a line square to it; the two \
                lines with the cone",
        },
    ],
    labels: &[
        LabelKey { key: "n", about: "the direction of the greatest gap" },
        LabelKey { key: "pivot", about: "where the two lines cross; only where a scene gives it a text" },
        LabelKey { key: "t_1", about: "the line square to the cone's first end, with names" },
        LabelKey { key: "t_2", about: "the line square to the cone's second end, with names" },
        LabelKey { key: "n_1", about: "the first end of the cone, with names" },
        LabelKey { key: "n_2", about: "the second end of the cone, with names" },
    ],
    needs: "two convex bodies",
    fed: |context, _| {
        let found = super::difference::difference(context, context.difference_time()).is_some();
        Fed::by_the_answer(cone(context).is_some(), found)
    },
    draw,
};

/// A line that touches both bodies and passes between them.
struct Touching {
    /// The direction square to it that leads from A to B, an angle in radians.
    turn: f64,
    /// Its direction, from where it touches A to where it touches B.
    along: f64,
    /// Where it touches A and B.
    at: [DVec2; 2],
}

/// The two lines that touch both bodies at the panel's moment, the first as in [`Cone::tangents`] the last.
fn lines(context: &Context, cone: &Cone) -> Option<[Touching; 2]> {
    let line = |along: f64, turn: f64| {
        let n = on_circle(DVec2::ZERO, 1.0, turn);
        let at = [support(context, Side::A, n)?, support(context, Side::B, -n)?];
        Some(Touching { turn, along, at })
    };
    let [right, left] = cone.tangents;
    Some([line(left, left - FRAC_PI_2)?, line(right, right + FRAC_PI_2)?])
}

/// The point of a body farthest along a unit vector, in the world.
fn support(context: &Context, side: Side, n: DVec2) -> Option<DVec2> {
    let (body, pose) = (context.body(side)?, context.pose(side, context.time)?);
    let core = body.shape.core.iter().filter_map(|&k| body.shape.vertices.get(k));
    let far = core.map(|&v| pose.point(v)).max_by(|p, q| p.dot(n).total_cmp(&q.dot(n)))?;
    Some(far + body.shape.radius * n)
}

/// Where the two lines cross; where they are one line, the middle of what is free of it.
fn crossing([p, q]: &[Touching; 2]) -> DVec2 {
    let [u, w] = [p, q].map(|line| on_circle(DVec2::ZERO, 1.0, line.along));
    let part = (q.at[0] - p.at[0]).perp_dot(w) / u.perp_dot(w);
    let most = (p.at[1] - p.at[0]).dot(u);
    // Between the bodies, however little the lines differ.
    let part = if part.is_finite() { part.clamp(0.0, most.max(0.0)) } else { 0.5 * most };
    p.at[0] + part * u
}

/// How far a point is from the outline of a body, in world units; 0 where there is none.
fn way_to(context: &Context, side: Side, from: DVec2) -> f64 {
    let Some(points) = context.outline(side, context.time).map(|outline| outline.sampled()) else {
        return 0.0;
    };
    let ends = points.iter().zip(points.iter().cycle().skip(1));
    let ways = ends.map(|(&p, &q)| {
        let along = q - p;
        let share = ((from - p).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        // A point has no direction, and no share of it.
        let share = if share.is_finite() { share } else { 0.0 };
        from.distance(p + share * along)
    });
    ways.reduce(f64::min).unwrap_or(0.0)
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(found) = cone(context) else { return };
    let Some(lines) = lines(context, &found) else { return };
    sketch.since(context.separation_at(context.time).map(|run| run.end()));
    let origin = crossing(&lines);
    let radius = fitting_radius(sketch, way_to(context, Side::B, origin));
    let [line, cone] = PARTS.map(|part| options.shows("show", part, true));
    if line && !cone {
        between(sketch, context, origin, found.normal);
    }
    if cone {
        fan(sketch, options, &lines, (origin, radius));
    }
    if line {
        let tip = origin + found.normal * radius;
        sketch.part("direction").arrow(origin, tip, Pen::vector(Role::Ink));
        sketch.label(Label::new("n", "$n$", Anchor::tip(origin, tip), Role::Ink));
    }
    sketch.part("crossing").marker(origin, Marker::Disc, Role::Ink, SMALL_MARKER + 0.5);
    let anchor = Anchor::point_toward(origin, -found.normal);
    sketch.label(Label::new("pivot", "", anchor, Role::Ink).rank(Rank::Word).size(Size::Note));
}

/// Draws both lines that touch the bodies and the cone between the directions square to them.
fn fan(sketch: &mut Sketch, options: &Options, lines: &[Touching; 2], (origin, radius): (DVec2, f64)) {
    let (role, names) = (options.role(Role::Translation), options.flag("names", false));
    let sector = Outline::sector(origin, radius, lines[0].turn, lines[1].turn - lines[0].turn);
    sketch.part("cone").area(&sector, Some(Wash::faint(role, FILL)), None);
    // Square to one side of it, each line runs through it where it is that wide.
    let inside = if (lines[1].turn - lines[0].turn).abs() > FRAC_PI_2 { radius } else { 0.0 };
    for (line, [tangent, name]) in lines.iter().zip(NAMES) {
        touching(sketch, line, (origin, inside), names.then_some(tangent));
        let tip = on_circle(origin, radius, line.turn);
        sketch.part("cone-edge").arrow(origin, tip, Pen::highlighted(TURNED));
        if names {
            sketch.label(Label::new(name, format!("${name}$"), Anchor::tip(origin, tip), TURNED));
        }
    }
}

/// Draws a line between the bodies square to a direction, as far as they reach, with its right angle.
fn between(sketch: &mut Sketch, context: &Context, origin: DVec2, normal: DVec2) {
    let along = perp(normal);
    let reach = |way: DVec2| {
        let far = Side::BOTH.into_iter().filter_map(|side| support(context, side, way));
        far.map(|p| way.dot(p - origin)).fold(0.0, f64::max)
    };
    let [from, to] = [-along, along].map(|way| origin + way * reach(way));
    sketch.part("between").line(from, to, Pen::vector(Role::Ink).width(TANGENT));
    right_angle(sketch, origin, [angle_of(normal), angle_of(-along)]);
}

/// Draws a line that touches both bodies, faintly for the length `inside` from where they cross, where it
/// touches them, its right angle to the cone's end, its name.
fn touching(
    sketch: &mut Sketch,
    line: &Touching,
    (origin, inside): (DVec2, f64),
    name: Option<&'static str>,
) {
    let (past, [a, b], pen) = (sketch.px(PAST), line.at, Pen::vector(TURNED).width(TANGENT));
    let (back, beyond) = (on_circle(a, past, line.along + PI), on_circle(b, past, line.along));
    sketch.part("tangent").weight(Weight::Light);
    if inside > 0.0 {
        let rim = on_circle(origin, inside, line.along);
        sketch.line(back, origin, pen).line(origin, rim, pen.opacity(FAINT)).line(rim, beyond, pen);
    } else {
        sketch.line(back, beyond, pen);
    }
    right_angle(sketch, origin, [line.along + PI, line.turn]);
    sketch.part("touching").marker(a, Marker::Disc, Role::A, MARKER);
    sketch.part("touching").marker(b, Marker::Square, Role::B, MARKER);
    if let Some(key) = name {
        // Between the bodies, unless the lines cross at B: there neither has a side of its own.
        let is_short = (a - origin).length() > SHORT * (b - origin).length();
        let far = if is_short { a } else { b };
        sketch.label(Label::new(key, format!("${key}$"), Anchor::middle(origin, far), TURNED));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::layer::tests::{apart, labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn lines_that_cross_at_b_are_named_at_their_own_parts() {
        let text = "shapes.A = { kind = 'box', half_extents = [5, 0.3], angle_deg = 35 }
            shapes.B = { kind = 'regular-polygon', edges = 5, circumradius = 0.6, position = [1.5, 3.5] }
            query = { kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }
            panels = [{ layers = ['shapes', { layer = 'separating-lines', names = true }] }]";
        let scene = open_text("crossing", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "crossing");
        let context = plan.panels[0].context(&scene, &plan.runs);
        let lines = lines(&context, &cone(&context).unwrap()).unwrap();
        let panel = &figure.panels[0];
        // How far a label's middle is from one of the lines, in page pixels.
        let away = |key: &str, line: &Touching| {
            let label = panel.placed.iter().find(|label| label.key == key).unwrap();
            let [p, q] = line.at.map(|p| panel.frame.page(p));
            (q - p).unit().unwrap().cross(label.bounds.center() - p).abs()
        };
        for (key, own, other) in [("t_1", &lines[0], &lines[1]), ("t_2", &lines[1], &lines[0])] {
            assert!(2.0 * away(key, own) < away(key, other), "{key}");
        }
    }

    #[test]
    fn both_lines_touch_both_bodies_and_pass_between_them_and_cross_there() {
        for (place, _, text) in apart("{ layers = ['shapes', 'separating-lines'] }") {
            let scene = open_text("lines", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let context = plan.panels[0].context(&scene, &plan.runs);
            let found = cone(&context).unwrap();
            let lines = lines(&context, &found).unwrap();
            let x = crossing(&lines);
            for line in &lines {
                let n = on_circle(DVec2::ZERO, 1.0, line.turn);
                // No point of A is beyond the line, none of B is before it, and both reach it.
                let [a, b] = [(Side::A, n), (Side::B, -n)].map(|(s, n)| support(&context, s, n).unwrap());
                assert!((a - x).dot(n).abs() < 1e-9 && (b - x).dot(n).abs() < 1e-9, "{place}");
                assert!((line.at[1] - line.at[0]).perp_dot(n).abs() > 0.1, "{place}");
            }
            // Along n, A ends before the crossing and B begins after it.
            let [a, b] = [(Side::A, found.normal), (Side::B, -found.normal)]
                .map(|(s, n)| (support(&context, s, n).unwrap() - x).dot(found.normal));
            assert!(a < 0.0 && b > 0.0, "{place}: {a} {b}");
        }
    }

    #[test]
    fn a_line_between_the_bodies_and_the_cone_are_shown_apart() {
        for (show, [line, touching]) in
            [("", [0, 2]), (", show = ['line']", [1, 0]), (", show = ['cone']", [0, 2])]
        {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 0.6], angle_deg = 30 }}
                shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [3.5, 1] }}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [{{ layers = ['shapes', {{ layer = 'separating-lines', names = true{show} }}] }}]"
            );
            let scene = open_text("lines", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "lines");
            let count = |part| paths(&figure.drawing.items, part).len();
            // Each in three pieces, the middle one faint in the cone, which is wider than a right angle.
            assert_eq!([count("between"), count("tangent")], [line, 3 * touching], "{show}");
            let all = labels(&figure);
            let named = ["n", "n_1", "n_2"].map(|key| usize::from(all.contains_key(key)));
            let n = usize::from(!show.contains("cone"));
            assert_eq!(named, [n, touching / 2, touching / 2], "{show}");
            assert_eq!(count("crossing"), 1, "{show}");
        }
    }
}
