//! All directions that separate two bodies, as a cone at the origin of configuration space.
//!
//! A direction n separates them where all of B ⊖ A lies beyond the line through O square to n. Seen from O,
//! B ⊖ A fills the angle between its two tangents from O, α to β; so n may turn from β − 90° to α + 90°:
//!
//! ```text
//! n · p > 0 for all p of B ⊖ A      vertex p of a core rounded by ρ fills   arg p ± asin(ρ/|p|)
//! ```
//!
//! That line is drawn for the n of the greatest gap, and the gap as what is free between it and B ⊖ A.
//! The nearer O comes to B ⊖ A the narrower is the cone; where O is on the boundary it is one direction, the
//! edge's normal; inside there is none.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, Label, MARKER, Marker, Outline, Pen, Rank, Size, Sketch, Wash, Weight, angle_of, on_circle,
};
use crate::figure::text::number;
use crate::geometry::{DVec2, perp};
use crate::trace::phrase;

use super::difference::difference;
use super::half_extents::beside;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Radius of the cone, page pixels; less where B ⊖ A is near.
const RADIUS: f64 = 120.0;

/// How far from O the cone's angle is written, in parts of the cone's radius: its rim is the arc of it.
const ANGLE: f64 = 0.5;

/// The share of the way to B ⊖ A that the cone's radius takes at most, and its least radius, page pixels.
const FREE: (f64, f64) = (0.86, 48.0);

/// Opacity of the cone: the axes may lie under it.
pub(super) const FILL: f64 = 0.16;

/// Opacity of the strip between the line square to n and B ⊖ A.
const LIT: f64 = 0.11;

/// How far a tangent reaches past the point where it touches, page pixels.
pub(super) const PAST: f64 = 30.0;

/// How far a tangent reaches back through O, page pixels: the right angle is marked there, outside the cone.
const BACK: f64 = 30.0;

/// How far beside what touches B ⊖ A the gap is measured, page pixels.
const ASIDE: f64 = 30.0;

/// Edge of the square that marks a right angle, page pixels: clear of O's ring.
const SQUARE: f64 = 15.0;

/// How much nearer one of two points must be to count as nearer, page pixels: level ones don't change sides.
const LEVEL: f64 = 1.0;

/// How much farther from O, as a part of that, both ends of an edge may be along its normal: a few roundings.
const LEVEL_PART: f64 = 1e-9;

/// How far a line reaches past the gap's measure, page pixels.
const TICK: f64 = 10.0;

/// How far the line square to n reaches beyond O and beyond what is nearest to it, the other way, page
/// pixels: past the mark of its right angle.
const BEHIND: f64 = 34.0;

/// The shortest and the longest that n is drawn, page pixels, where one unit of the space is less or more.
const READABLE: [f64; 2] = [24.0, RADIUS];

/// The keys of the names of each tangent and of the end of the cone square to it, the left tangent first.
pub(super) const NAMES: [[&str; 2]; 2] = [["t_1", "n_1"], ["t_2", "n_2"]];

/// The colour of the ends of the cone and of the tangents that they are square to.
pub(super) const TURNED: Role = Role::Now;

/// Width of a tangent and of the line square to n, page pixels: less than that of an end of the cone.
pub(super) const TANGENT: f64 = 1.25;

/// The words of the option `show`.
const PARTS: [&str; 4] = ["line", "cone", "n_1", "n_2"];

pub(super) const LAYER: Layer = Layer {
    name: "separating-cone",
    in_words: phrase([
        "separating-cone",
        "trennende Richtungen",
        "directions séparatrices",
        "direcciones separadoras",
    ]),
    about: "the directions that separate the bodies: tangents from O to B ⊖ A, the cone of normals",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "names",
            takes: Takes::Flag,
            default: "false",
            about: "names the line square to n, the tangents, and each end of the cone by the tangent that \
                it is square to",
        },
        OptionSpec {
            name: "show",
            takes: Takes::Words(&PARTS),
            default: "all",
            about: "which parts: the direction of the greatest gap with the line square to it; the tangents \
                with the cone; of these what that direction passes up to n_1, with its tangent; the whole \
                cone with that of n_2",
        },
    ],
    labels: &[
        LabelKey { key: "cone", about: "the cone's angle" },
        LabelKey { key: "n", about: "the direction of the greatest gap" },
        LabelKey { key: "gap", about: "the greatest gap" },
        LabelKey { key: "line", about: "the line through O square to that direction, with names" },
        LabelKey { key: "t_1", about: "the tangent to the left of B ⊖ A, with names" },
        LabelKey { key: "t_2", about: "the tangent to the right of B ⊖ A, with names" },
        LabelKey { key: "n_1", about: "the end of the cone square to the first tangent, with names" },
        LabelKey { key: "n_2", about: "the end of the cone square to the second tangent, with names" },
    ],
    needs: "two convex bodies",
    fed: |context, _| {
        let found = difference(context, context.difference_time()).is_some();
        Fed::by_the_answer(cone(context).is_some(), found)
    },
    draw,
};

/// The directions that separate, at the panel's moment.
pub(super) struct Cone {
    /// The angles of the two tangents from O, in radians; the second one is up to π to the left of the first.
    pub(super) tangents: [f64; 2],
    /// Where each touches.
    touching: [DVec2; 2],
    /// The direction of the greatest gap.
    pub(super) normal: DVec2,
    /// Its angle, in radians, between the two ends of the cone.
    ahead: f64,
    /// The greatest gap: from the line through O square to `normal` to B ⊖ A.
    gap: f64,
    /// The vertices of its core that are nearest to that line: one, or the ends of an edge.
    nearest: Vec<DVec2>,
}

/// The cone; `None` for bodies that are not proved to be apart.
pub(super) fn cone(context: &Context) -> Option<Cone> {
    let found = difference(context, context.difference_time())?;
    let answer = context.separation_seen(context.time)?;
    if answer.bounds.lo <= 0.0 {
        return None;
    }
    let normal = *answer.normal;
    let origin = context.estimate();
    let core: Vec<DVec2> = found.edges.iter().map(|edge| edge.from).chain(found.center).collect();
    // Angles from n, between −90° and 90°, of both tangents to the disc about each vertex.
    let seen = core.iter().map(|p| {
        let p = *p - origin;
        let angle = libm::atan2(normal.perp_dot(p), normal.dot(p));
        let half = libm::asin((found.radius / p.length()).min(1.0));
        let far = (p.length_squared() - found.radius * found.radius).max(0.0).sqrt();
        [(angle - half, far), (angle + half, far)]
    });
    let first = seen.clone().map(|[low, _]| low).reduce(|a, b| if b.0 < a.0 { b } else { a })?;
    let last = seen.map(|[_, high]| high).reduce(|a, b| if b.0 > a.0 { b } else { a })?;
    let base = angle_of(normal);
    let tangents = [base + first.0, base + last.0];
    let touching = [on_circle(origin, first.1, tangents[0]), on_circle(origin, last.1, tangents[1])];
    let ahead = |p: DVec2| normal.dot(p - origin);
    let least = core.iter().map(|p| ahead(*p)).fold(f64::INFINITY, f64::min);
    let nearest = core.into_iter().filter(|p| ahead(*p) <= least * (1.0 + LEVEL_PART)).collect();
    Some(Cone { tangents, touching, normal, ahead: base, gap: answer.separation, nearest })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(found) = cone(context) else { return };
    let role = options.role(Role::Translation);
    sketch.since(context.separation_at(context.time).map(|run| run.end()));
    let origin = context.estimate();
    let [line, cone, first, second] = PARTS.map(|part| options.shows("show", part, true));
    let (ends, names) = ([cone || first, cone || second], options.flag("names", false));
    if line {
        square(sketch, &found, origin, (role, names, ends == [false; 2]));
    }
    if ends != [false; 2] {
        fan(sketch, &found, origin, (role, names, ends));
    }
    // As long as what it is compared with.
    let [least, most] = READABLE.map(|px| sketch.px(px));
    let length = if line { 1.0_f64.max(least).min(most) } else { fitting_radius(sketch, found.gap) };
    let tip = origin + found.normal * length;
    sketch.part("direction").arrow(origin, tip, Pen::vector(Role::Ink));
    sketch.label(Label::new("n", "$n$", Anchor::tip(origin, tip), Role::Ink));
}

/// The radius of a cone with so much free ahead of it: 1, as of its unit vectors, where that can be read.
pub(super) fn fitting_radius(sketch: &Sketch, free: f64) -> f64 {
    let most = sketch.px(RADIUS).min((FREE.0 * free).max(sketch.px(FREE.1)));
    if (sketch.px(FREE.1)..=most).contains(&1.0) { 1.0 } else { most }
}

/// Draws the cone, and the tangents that its `ends` are square to: of the first alone the cone from n on.
fn fan(sketch: &mut Sketch, cone: &Cone, origin: DVec2, (role, names, ends): (Role, bool, [bool; 2])) {
    let radius = fitting_radius(sketch, cone.gap);
    let turns = [cone.tangents[1] - FRAC_PI_2, cone.tangents[0] + FRAC_PI_2];
    let (start, end) = (turns[0], if ends[1] { turns[1] } else { cone.ahead });
    let sector = Outline::sector(origin, radius, start, end - start);
    sketch.part("cone").area(&sector, Some(Wash::faint(role, FILL)), None);
    let touched = [(cone.tangents[1], cone.touching[1]), (cone.tangents[0], cone.touching[0])];
    for (i, [tangent, name]) in NAMES.into_iter().enumerate().take(if ends[1] { 2 } else { 1 }) {
        let of_cone = on_circle(origin, radius, turns[i]);
        if ends[i] {
            square_tangent(sketch, origin, touched[i], (turns[i], names.then_some(tangent)));
        }
        sketch.part("cone-edge").arrow(origin, of_cone, Pen::highlighted(TURNED));
        if names {
            sketch.label(Label::new(name, format!("${name}$"), Anchor::tip(origin, of_cone), TURNED));
        }
    }
    if ends[1] {
        let (radius, sweep) = (ANGLE * radius, end - start);
        let (anchor, degrees) = (Anchor::Arc { center: origin, radius, start, sweep }, sweep * (180.0 / PI));
        sketch.label(Label::new("cone", format!("${}°$", number(degrees)), anchor, role).size(Size::Note));
    }
}

/// Draws a tangent from O, with the right angle to the end of the cone that is turned so far, and its name.
fn square_tangent(
    sketch: &mut Sketch,
    origin: DVec2,
    (tangent, touching): (f64, DVec2),
    (turn, name): (f64, Option<&'static str>),
) {
    let [past, behind] = [PAST, BACK].map(|px| sketch.px(px));
    let (back, beyond) = (on_circle(origin, behind, tangent + PI), on_circle(touching, past, tangent));
    sketch.part("tangent").weight(Weight::Light).line(back, beyond, Pen::vector(TURNED).width(TANGENT));
    right_angle(sketch, origin, [tangent + PI, turn]);
    sketch.part("touching").marker(touching, Marker::Diamond, Role::Difference, MARKER);
    if let Some(key) = name {
        sketch.label(Label::new(key, format!("${key}$"), Anchor::tip(origin, beyond), TURNED));
    }
}

/// Draws the line through O square to n, and beside B ⊖ A the gap between the two: on the side where a
/// tangent touches what is nearest, so that nothing stands in between. The strip between them is lit where no
/// cone lies on it.
fn square(sketch: &mut Sketch, cone: &Cone, origin: DVec2, (role, names, lit): (Role, bool, bool)) {
    let along = perp(cone.normal);
    let [last, first] = cone.touching.map(|p| p - origin);
    let ahead = |p: DVec2| cone.normal.dot(p);
    let near = if ahead(first) < ahead(last) - sketch.px(LEVEL) { first } else { last };
    let out = along.dot(near).signum();
    let [past, tick] = [ASIDE, TICK].map(|px| sketch.px(px));
    let end = along.dot(near) + out * past;
    let at = |aside: f64, ahead: f64| origin + along * aside + cone.normal * ahead;
    let beyond = cone.nearest.iter().map(|p| -out * along.dot(*p - origin)).fold(0.0, f64::max);
    let other = -out * (beyond + sketch.px(BEHIND));
    if lit {
        let far = -out * beyond;
        let strip = [at(far, 0.0), at(end, 0.0), at(end, cone.gap), at(far, cone.gap)];
        let wash = Wash::faint(role, LIT);
        sketch.part("lit").weight(Weight::Light).area(&Outline::polygon(&strip), Some(wash), None);
    }
    sketch.part("square-line").weight(Weight::Light);
    sketch.line(at(other, 0.0), at(end + out * tick, 0.0), Pen::vector(Role::Ink).width(TANGENT));
    right_angle(sketch, origin, [angle_of(cone.normal), angle_of(along * -out)]);
    if names {
        let anchor = Anchor::point_toward(at(0.6 * other, 0.0), -cone.normal);
        let label = Label::new("line", "square to $n$", anchor, Role::Ink);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    sketch.part("gap-line").weight(Weight::Light);
    let outer = cone.nearest.iter().map(|p| out * along.dot(*p - origin)).fold(f64::NEG_INFINITY, f64::max);
    sketch.line(at(out * outer, cone.gap), at(end + out * tick, cone.gap), Pen::extension());
    let (from, to) = (at(end, 0.0), at(end, cone.gap));
    sketch.part("gap").dimension(from, to, 0.0, Pen::dimension(role).width(1.5));
    let text = format!("gap $= {}$", number(cone.gap));
    sketch.label(Label::new("gap", text, beside(from, to, along * out), role));
}

/// Draws the square of a right angle at a point, between two directions.
pub(super) fn right_angle(sketch: &mut Sketch, at: DVec2, directions: [f64; 2]) {
    let [p, q] = directions.map(|angle| on_circle(at, sketch.px(SQUARE), angle));
    let square = Outline::polyline(&[p, p + q - at, q]);
    sketch.part("right-angle").weight(Weight::Light).stroke(&square, Pen::dimension(Role::Muted));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::layer::tests::{apart, labels, lines, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    /// Two bodies that are apart, and the question.
    const BODIES: &str = "shapes.A = { kind = 'polygon', vertices = [[-2, -1], [1, -2], [3, 0], [-1, 3]] }
        shapes.B = { kind = 'polygon', vertices = [[2, 3.5], [6, 1], [6.5, 4], [3, 6]] }
        query = { kind = 'separation', of = ['A', 'B'] }\n";

    /// Whether a direction separates two polygons rounded by `radius`, by all their vertices.
    fn separates(direction: DVec2, scene: &crate::scene::Scene, radius: f64) -> f64 {
        let reach = |i: usize, n: DVec2| {
            let body = &scene.shapes[i].1;
            let pose = body.pose_at(0.0);
            body.shape.vertices.iter().map(|&v| pose.point(v).dot(n)).fold(f64::NEG_INFINITY, f64::max)
        };
        -reach(1, -direction) - reach(0, direction) - radius
    }

    #[test]
    fn every_direction_in_the_cone_separates_and_none_outside() {
        for (place, r, text) in apart("{ space = 'configuration', layers = ['separating-cone'] }") {
            let scene = open_text("cone", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let cone = cone(&plan.panels[0].context(&scene, &plan.runs)).unwrap();
            let (start, end) = (cone.tangents[1] - FRAC_PI_2, cone.tangents[0] + FRAC_PI_2);
            assert!(end > start && end - start < PI, "{place}");
            let gap = |angle: f64| separates(on_circle(DVec2::ZERO, 1.0, angle), &scene, r);
            for k in 1..40 {
                assert!(gap(start + (end - start) * f64::from(k) / 40.0) > 0.0, "{place}: {k}");
                let outside = end + (2.0 * PI - (end - start)) * f64::from(k) / 40.0;
                assert!(gap(outside) < 0.0, "{place}: {k}");
            }
            // At its edges the line touches B ⊖ A.
            assert!(gap(start).abs() < 1e-12 && gap(end).abs() < 1e-12, "{place}");
        }
    }

    #[test]
    fn the_gap_is_drawn_as_long_as_it_is_written() {
        let panel = "panels = [{ space = 'configuration', layers = ['difference', 'separating-cone'] }]";
        let scene = open_text("cone", &format!("{BODIES}{panel}")).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "cone");
        // A's edge 3x + 4y = 9 and B's vertex (2, 3.5), where that is 20.
        assert_eq!(labels(&figure)["gap"].1, 2.2);
        assert!((lines(&figure, "gap")[0] / figure.panels[0].frame.scale - 2.2).abs() < 1e-9);
    }

    #[test]
    fn each_end_of_the_cone_has_the_number_of_the_tangent_that_it_is_square_to() {
        let layers = "[{ layer = 'separating-cone', names = true }]";
        let text = format!("{BODIES}panels = [{{ space = 'configuration', layers = {layers} }}]");
        let scene = open_text("cone", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "cone");
        let panel = &figure.panels[0];
        let corner = panel.frame.panel;
        let from_origin = |key: &str| {
            let label = panel.placed.iter().find(|label| label.key == key).unwrap();
            crate::drawing::Point::new(corner.x0, corner.y0) + label.home - panel.frame.page(DVec2::ZERO)
        };
        for [tangent, end] in NAMES {
            let (t, n) = (from_origin(tangent), from_origin(end));
            let cosine = (t.dx * n.dx + t.dy * n.dy) / (t.length() * n.length());
            assert!(cosine.abs() < 1e-6, "{end} is not square to {tangent}: {cosine}");
        }
    }

    #[test]
    fn the_line_and_each_end_of_the_cone_can_be_shown_apart_and_ends_have_the_colour_of_their_tangents() {
        let cases = [
            ("", [1, 2, 2]),
            (", show = ['line']", [1, 0, 0]),
            (", show = ['cone']", [0, 2, 2]),
            (", show = ['n_1']", [0, 1, 1]),
            (", show = ['n_2']", [0, 1, 2]),
        ];
        for (show, [line, tangents, ends]) in cases {
            let layers = format!("[{{ layer = 'separating-cone', names = true{show} }}]");
            let text = format!("{BODIES}panels = [{{ space = 'configuration', layers = {layers} }}]");
            let scene = open_text("cone", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "cone");
            let all = labels(&figure);
            let named = ["n", "line", "n_1", "n_2", "cone"].map(|key| all.contains_key(key));
            assert_eq!(named, [true, line > 0, ends > 0, ends > 1, ends > 1], "{show}");
            let roles = |part: &str| -> Vec<Option<Role>> {
                let strokes = paths(&figure.drawing.items, part);
                strokes.iter().filter_map(|p| p.stroke.as_ref()).map(|s| s.paint.role).collect()
            };
            assert_eq!(roles("square-line").len(), line, "{show}");
            assert_eq!(paths(&figure.drawing.items, "lit").is_empty(), line == 0 || ends > 0, "{show}");
            assert_eq!(roles("tangent"), vec![Some(TURNED); tangents], "{show}");
            assert_eq!(roles("cone-edge"), vec![Some(TURNED); ends], "{show}");
        }
    }

    #[test]
    fn bodies_that_overlap_have_no_cone() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            shapes.B = { kind = 'circle', radius = 1, position = [1, 0.5] }
            query = { kind = 'separation', of = ['A', 'B'] }
            panels = [{ space = 'configuration', layers = ['separating-cone', 'origin'] }]";
        let scene = open_text("cone", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        assert!(cone(&plan.panels[0].context(&scene, &plan.runs)).is_none());
        assert!(plan.warnings.iter().any(|w| w.fault.to_string().contains("overlap")));
    }
}
