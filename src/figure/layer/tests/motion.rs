//! Sweeps, rays and what faces each other: the parts that an option adds.

use crate::drawing::Path;
use crate::figure::placement::Placed;
use crate::figure::{Figure, draw, plan};
use crate::geometry::DVec2;
use crate::scene::open_text;

use super::{labels, paths};

fn figure(text: &str) -> Figure {
    let scene = open_text("motion.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    draw(&plan, plan.theme, "motion")
}

/// A disc that reaches another after half of (4, 0), shown by `layers`.
fn discs(layers: &str) -> Figure {
    figure(&format!(
        "shapes.A = {{ kind = 'circle', radius = 1, velocity = [4, 0] }}
         shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0] }}
         query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
         panels = [{{ view = [-2, -2, 6, 2], layers = [{layers}] }}]"
    ))
}

/// The least and greatest x of what some paths reach, world units.
fn reach(figure: &Figure, paths: &[&Path]) -> [f64; 2] {
    let frame = &figure.panels[0].frame;
    let (origin, one) = (frame.page(DVec2::ZERO).x, frame.page(DVec2::X).x);
    let bounds = paths.iter().map(|path| path.contour.bounds().unwrap());
    let all = bounds.fold([f64::MAX, f64::MIN], |[lo, hi], b| [lo.min(b.x0), hi.max(b.x1)]);
    all.map(|x| (x - origin) / (one - origin))
}

#[test]
fn a_sweep_goes_to_the_hit_or_to_the_end_with_a_fill_where_the_scene_wants_it() {
    for (options, lines, fills) in [
        ("", [0.0, 2.0], None),
        (", fill = true", [0.0, 2.0], Some([-1.0, 3.0])),
        (", to = 'end', fill = true", [0.0, 4.0], Some([-1.0, 5.0])),
    ] {
        let figure = discs(&format!("{{ layer = 'sweep'{options} }}"));
        let band = paths(&figure.drawing.items, "sweep-A");
        let (filled, edges): (Vec<&Path>, Vec<&Path>) = band.into_iter().partition(|p| p.fill.is_some());
        let near = |found: [f64; 2], wanted: [f64; 2]| {
            assert!((0..2).all(|i| (found[i] - wanted[i]).abs() < 1e-6), "{options}: {found:?} {wanted:?}");
        };
        assert_eq!((edges.len(), filled.len()), (2, usize::from(fills.is_some())), "{options}");
        near(reach(&figure, &edges), lines);
        if let Some(fills) = fills {
            near(reach(&figure, &filled), fills);
        }
    }
}

#[test]
fn a_ghost_says_what_the_scene_wants_it_to_say() {
    let said = |options: &str| labels(&discs(&format!("{{ layer = 'ghosts'{options} }}")))["A'"].0.clone();
    assert_eq!(said(""), "$A$ at $t = 0.5$");
    assert_eq!(said(", text = 'touches, $t = {=time}$'"), "touches, $t = 0.5$");
}

#[test]
fn the_parts_of_a_ray_are_the_first_velocity_and_the_second_reversed() {
    let shown = |options: &str, velocity: &str| {
        figure(&format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [4, 2] }}
             shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0]{velocity} }}
             query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
             panels = [{{ space = 'configuration', layers = [{{ layer = 'ray'{options} }}] }}]"
        ))
    };
    let both = shown(", parts = true, values = true", ", velocity = [-1, 0.5]");
    let said = labels(&both);
    assert_eq!(said["part.A"].0, "$v_A$ $= (4, 2)$");
    assert_eq!(said["part.B"].0, "$-v_B$ $= (1, -0.5)$");
    // End to end from O to the tip of v = (5, 1.5).
    for (part, from, to) in [("ray-A", [0.0, 0.0], [4.0, 2.0]), ("ray-B", [4.0, 2.0], [5.0, 1.5])] {
        let place = |p: [f64; 2]| both.panels[0].frame.page(DVec2::from(p));
        let drawn = paths(&both.drawing.items, part);
        let shaft = drawn[0].contour.bounds().unwrap();
        assert!((shaft.x0 - place(from).x).abs() < 1.0, "{part}: {shaft:?}");
        assert!(
            drawn.iter().any(|path| (path.contour.bounds().unwrap().x1 - place(to).x).abs() < 1e-6),
            "{part}"
        );
    }
    // Of one body that moves there are no parts.
    for (options, velocity) in [("", ", velocity = [-1, 0.5]"), (", parts = true", "")] {
        assert!(!labels(&shown(options, velocity)).contains_key("part.A"), "{options}{velocity}");
    }
}

#[test]
fn the_joint_of_two_parts_is_the_difference_of_the_vertices_that_are_named() {
    // The upper edge of the one and the lower one of the other face each other.
    let place = |lower: &str, upper: &str| {
        figure(&format!(
            "shapes.{lower} = {{ kind = 'box', half_extents = [2, 1] }}
             shapes.{upper} = {{ kind = 'box', half_extents = [1, 1], position = [0.5, 1.5] }}
             query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'minkowski' }}
             panels = [
                 {{ layers = [{{ layer = 'support', lengths = true }}] }},
                 {{ space = 'configuration', layers = [{{ layer = 'support', lengths = true }}] }},
             ]"
        ))
    };
    for (lower, upper) in [("A", "B"), ("B", "A")] {
        let figure = place(lower, upper);
        let said = labels(&figure);
        assert!(["a_1", "a_2", "b_1", "b_2"].iter().all(|key| said.contains_key(key)), "both ends of both");
        // What they name, in world units as the page has them: from O, and from a to b.
        let homes = |panel: usize, key: &str| -> Vec<(String, DVec2)> {
            let panel = &figure.panels[panel];
            let (origin, corner) = (panel.frame.page(DVec2::ZERO), panel.frame.panel);
            // A vertex by what it is called, all else by its key.
            let called = format!("${key}$");
            let is_it = |label: &&Placed| {
                if key.contains('_') { label.lines[0].1.markup == called } else { label.key == key }
            };
            let of_key = panel.placed.iter().filter(is_it);
            let place = |label: &Placed| {
                let (x, y) = (label.home.dx + corner.x0 - origin.x, label.home.dy + corner.y0 - origin.y);
                (label.lines[0].1.markup.clone(), DVec2::new(x, y) / panel.frame.scale)
            };
            of_key.map(place).collect()
        };
        assert_eq!((homes(1, "joint").len(), homes(1, "end").len()), (1, 2));
        for (text, at) in homes(1, "joint").into_iter().chain(homes(1, "end")) {
            let (b, a) = text.trim_matches('$').split_once(" - ").unwrap();
            let difference = homes(0, b)[0].1 - homes(0, a)[0].1;
            assert!(difference.distance(at) < 0.01, "{lower}: {text} {difference} {at}");
        }
    }
}

#[test]
fn a_faint_ghost_is_half_as_dark() {
    let opacity = |options: &str| {
        let figure = discs(&format!("'shapes', {{ layer = 'ghosts'{options} }}"));
        paths(&figure.drawing.items, "ghost-A")[0].stroke.as_ref().unwrap().paint.opacity
    };
    assert_eq!(opacity(", faint = true"), 0.5 * opacity(""));
}

#[test]
fn what_a_body_is_pushed_from_is_dotted_and_a_body_that_needs_no_push_is_there() {
    let drawn = |x: f64| {
        let figure = figure(&format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
             shapes.B = {{ kind = 'circle', radius = 1, position = [{x}, 0] }}
             query = {{ kind = 'separation', of = ['A', 'B'] }}
             panels = [{{ layers = [{{ layer = 'ghosts', of = 'B', at = 'now' }}] }}]"
        ));
        let are_solid = |part| {
            let paths = paths(&figure.drawing.items, part);
            paths.iter().map(|path| path.stroke.as_ref().unwrap().dash.is_empty()).collect::<Vec<_>>()
        };
        ["ghost-B", "body-B"].map(are_solid)
    };
    assert_eq!(drawn(1.5), [vec![false], vec![]]);
    assert_eq!(drawn(3.0), [vec![], vec![true]]);
}
