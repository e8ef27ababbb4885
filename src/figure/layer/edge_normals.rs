//! The outward unit normals nᵢ of the edges of B ⊖ A. A ray enters only through edges whose normal looks
//! against it, v · nᵢ < 0: the others have their normals muted. The letter n without a number is the normal
//! from A to B, which is against that of the edge that faces.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::{Difference, Edge};
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Size, Sketch, Weight, angle_of};
use crate::geometry::DVec2;
use crate::trace::phrase;

use super::difference::difference;
use super::edge_cues::EdgeCues;
use super::facing::{faces_away, velocity_along};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Width, page pixels, and opacity of the normals of edges that face away: one of either kind has words.
const AWAY: (f64, f64) = (1.0, 0.6);
/// How near to where the ray enters no normal stands, page pixels: a mark of that, and a head.
const CLEAR: f64 = 30.0;
/// The angle between the ray and a normal against it that is seen best, radians.
const AGAINST: f64 = 0.75 * PI;
/// Radius of the arc between a normal and the ray's direction, in parts of the normal.
const ANGLE: f64 = 0.5;
/// The length of a normal on the page at least, page pixels, where 1 is shorter.
const LEAST: f64 = 22.0;

pub(super) const LAYER: Layer = Layer {
    name: "edge-normals",
    in_words: phrase(["edge-normals", "Kantennormalen", "normales des arêtes", "normales de las aristas"]),
    about: "outward unit normals of the edges of B ⊖ A; muted where the edge faces away from the ray",
    shows: Shows::Configuration,
    tells: Tells::Built,
    options: &[
        OptionSpec {
            name: "length",
            takes: Takes::Positive,
            default: "1, or 22 px",
            about: "drawn length, units of configuration space",
        },
        OptionSpec {
            name: "signs",
            takes: Takes::Flag,
            default: "false",
            about: "says of one normal of either kind whether n · v is less or more than 0, and \
                draws v's direction beside the first",
        },
    ],
    labels: &[
        LabelKey {
            key: "n",
            about: "the nᵢ that look against the ray, with signs one of them; without a ray, the first",
        },
        LabelKey { key: "away", about: "the normal that looks most along the ray, with signs" },
        LabelKey { key: "along", about: "the ray's direction beside the normal against it, with signs" },
    ],
    needs: "two convex bodies, one of them with edges",
    fed: |context, _| Fed::by_the_scene(found(context).is_some()),
    draw,
};

/// B ⊖ A at the panel's moment, if it has edges.
fn found(context: &Context) -> Option<Difference> {
    difference(context, context.difference_time()).filter(|found| !found.edges.is_empty())
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(found) = found(context) else { return };
    let length = options.number("length").unwrap_or(1.0_f64.max(sketch.px(LEAST)));
    let role = options.role(Role::Ink);
    let (v, away) = (velocity_along(context).unwrap_or_default(), faces_away(context));
    let cues = EdgeCues::at(context, context.difference_time());
    let hit = hit(context);
    let arrow = |edge: &Edge| {
        let (p, q) = found.drawn(edge);
        let foot = foot((p, q), hit.map(|hit| (hit, sketch.px(CLEAR))));
        (foot, foot + edge.normal * length)
    };
    let arrows: Vec<(DVec2, DVec2)> = found.edges.iter().map(arrow).collect();
    for (edge, &(from, tip)) in found.edges.iter().zip(&arrows) {
        let away = away(edge);
        let pen = Pen::vector(if away { Role::Muted } else { role });
        sketch.since(cues.of(edge)).part(if away { "away" } else { "facing" }).weight(Weight::Light);
        sketch.arrow(from, tip, if away { pen.width(AWAY.0).opacity(AWAY.1) } else { pen });
    }
    let angle = |(edge, _): &(&Edge, &(DVec2, DVec2))| edge.normal.angle_to(v).abs();
    let signs = options.flag("signs", false) && v != DVec2::ZERO;
    let all = || found.edges.iter().zip(&arrows);
    // An angle is told from a right one best where it is half of one off.
    let off = |wanted: f64| move |one: &(&Edge, &(DVec2, DVec2))| (angle(one) - wanted).abs();
    let nearest = |wanted: f64, kind: fn(f64) -> bool| {
        all().filter(|one| kind(angle(one))).min_by(|e, f| off(wanted)(e).total_cmp(&off(wanted)(f)))
    };
    // Against the ray one is shown to be so; along it, the one that is most.
    if let Some((edge, &(from, tip))) = nearest(AGAINST, |angle| angle > FRAC_PI_2).filter(|_| signs) {
        let label = Label::new("n", r"$n_i \cdot v < 0$", Anchor::tip(from, tip), role);
        sketch.since(cues.of(edge)).label(label.rank(Rank::Measure).size(Size::Point));
        along(sketch, (from, tip), v);
    }
    let first = all().take(usize::from(v == DVec2::ZERO));
    let against = all().filter(|one| v != DVec2::ZERO && angle(one) > FRAC_PI_2);
    for (edge, &(from, tip)) in first.chain(against).filter(|_| !signs) {
        let label = Label::new("n", "$n_i$", Anchor::tip(from, tip), role);
        sketch.since(cues.of(edge)).label(label.rank(Rank::Measure).size(Size::Point));
    }
    if let Some((edge, &(from, tip))) = nearest(0.0, |angle| angle < FRAC_PI_2).filter(|_| signs) {
        sketch.since(cues.of(edge));
        let label = Label::new("away", r"$n_i \cdot v > 0$", Anchor::tip(from, tip), Role::Muted);
        sketch.label(label.rank(Rank::Measure).size(Size::Point));
    }
}

/// Where the ray enters after the panel's moment, when it is at O or a sweep's estimate.
fn hit(context: &Context) -> Option<DVec2> {
    let ahead = context.hit_time()?.lo - context.time;
    (ahead > 0.0).then(|| context.estimate() + context.closing_velocity() * ahead)
}

/// Where a normal stands on its edge: in its middle, or where something else is nearer than `clear` to that,
/// in the middle of the longer part that it leaves.
fn foot((p, q): (DVec2, DVec2), taken: Option<(DVec2, f64)>) -> DVec2 {
    let middle = 0.5 * (p + q);
    match taken {
        Some((at, clear)) if at.distance(middle) < clear => {
            0.5 * (at + if at.distance(p) > at.distance(q) { p } else { q })
        }
        _ => middle,
    }
}

/// Draws the direction of the ray beside a normal, as long as that, and the angle between the two: more than
/// a right one where the normal is against the ray.
fn along(sketch: &mut Sketch, (foot, tip): (DVec2, DVec2), v: DVec2) {
    let normal = tip - foot;
    let end = foot + v.normalize_or_zero() * normal.length();
    sketch.part("along").weight(Weight::Light).arrow(foot, end, Pen::vector(Role::Muted).width(AWAY.0));
    let (start, sweep) = (angle_of(normal), normal.angle_to(v));
    let radius = ANGLE * normal.length();
    sketch.part("angle").weight(Weight::Light).arc(foot, radius, start, sweep, Pen::dimension(Role::Muted));
    let label = Label::new("along", "along $v$", Anchor::tip(foot, end), Role::Muted);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn the_normals_that_look_along_the_ray_are_muted_and_without_a_ray_none_is() {
        let squares = "shapes.A = { kind = 'box', half_extents = [1, 1], velocity = [4, 3] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [4, 3] }
            panels = [{ space = 'configuration', layers = ['edge-normals'] }]
            query = { of = ['A', 'B'], kind = ";
        for (kind, away) in [
            ("'linear-sweep' }", 4),
            ("'linear-sweep', algorithm = 'ray-clipping' }", 4),
            ("'separation', algorithm = 'minkowski' }", 0),
        ] {
            let scene = open_text("normals", &format!("{squares}{kind}")).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "normals");
            // B ⊖ A has an edge of each square in every direction; an arrow is a shaft and a head.
            let count = |part| paths(&figure.drawing.items, part).len() / 2;
            assert_eq!((count("away"), count("facing")), (away, 8 - away), "{kind}");
            assert!(labels(&figure).contains_key("n"));
        }
    }

    #[test]
    fn of_the_two_edges_of_a_segment_one_looks_against_the_ray() {
        let text =
            "shapes.A = { kind = 'capsule', points = [[-1, 0], [1, 0]], radius = 0.1, position = [0, 4],
                velocity = [2, -6] }
            shapes.B = { kind = 'capsule', points = [[0, -1], [0, 1]], radius = 0 }
            query = { kind = 'linear-sweep', of = ['A', 'B'] }
            panels = [{ space = 'configuration', layers = ['edge-normals'] }]";
        let scene = open_text("segments", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "segments");
        let count = |part| paths(&figure.drawing.items, part).len() / 2;
        assert_eq!((count("away"), count("facing")), (2, 2));
    }

    #[test]
    fn signs_stand_at_one_normal_of_either_kind_where_there_is_a_ray() {
        for (velocity, signs) in [("[4, 3]", true), ("[0, 0]", false)] {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = {velocity} }}
                shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [4, 3] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration',
                    layers = [{{ layer = 'edge-normals', signs = true }}] }}]"
            );
            let scene = open_text("normals", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let said = labels(&draw(&plan, plan.theme, "normals"));
            let [n, away] = ["n", "away"].map(|key| said.get(key).map(|label| label.0.as_str()));
            assert_eq!(said.contains_key("along"), signs, "the ray's direction is seen beside one");
            assert_eq!((n == Some(r"$n_i \cdot v < 0$"), away == Some(r"$n_i \cdot v > 0$")), (signs, signs));
        }
    }

    #[test]
    fn a_normal_stands_clear_of_where_the_ray_enters() {
        let (p, q) = (DVec2::ZERO, DVec2::new(4.0, 0.0));
        assert_eq!(foot((p, q), None), DVec2::new(2.0, 0.0));
        assert_eq!(foot((p, q), Some((DVec2::new(1.5, 0.0), 0.4))), DVec2::new(2.0, 0.0));
        // In the middle of the longer part beside it.
        assert_eq!(foot((p, q), Some((DVec2::new(1.5, 0.0), 0.6))), DVec2::new(2.75, 0.0));
        assert_eq!(foot((p, q), Some((DVec2::new(2.5, 0.0), 0.6))), DVec2::new(1.25, 0.0));
    }
}
