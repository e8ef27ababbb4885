//! One mark, one meaning: vectors that say their scale, lengths without heads, ghosts that say when they are.

use crate::drawing::{Contour, Path, Point, Segment};
use crate::figure::layer::normal::scaled;
use crate::figure::{Figure, draw, plan};
use crate::geometry::DVec2;
use crate::scene::open_text;

use super::{labels, lines, paths, points};

/// A box that goes and turns towards a disc, asked by `query`, shown by `layers`.
fn figure(turn: &str, query: &str, layers: &str) -> Figure {
    let text = format!(
        "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [4, 2]{turn} }}
         shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0] }}
         query = {{ kind = '{query}', of = ['A', 'B'] }}
         panels = [{{ view = [-3, -3, 9, 4], layers = [{layers}] }}]"
    );
    let scene = open_text("marks.toml", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    draw(&plan, plan.theme, "marks")
}

#[test]
fn a_vector_that_is_not_drawn_at_its_length_says_its_scale() {
    assert_eq!([1.0, 0.25, 3.0].map(|f| scaled(f, "$v$")), ["$v$", "¼ $v$", "$3$ $v$"]);
    let said = |layer: &str, key: &str| labels(&figure("", "linear-sweep", layer))[key].0.clone();
    assert_eq!(said("'velocity'", "v_A"), "$v_A$");
    assert_eq!(said("{ layer = 'velocity', scale = 0.5 }", "v_A"), "½ $v_A$");
    assert_eq!(said("{ layer = 'velocity', values = true }", "v_A"), "$v_A$ $= (4, 2)$");
    let both = said("{ layer = 'velocity', scale = 0.5, values = true }", "v_A");
    assert_eq!(both, "$v_A$ $= (4, 2)$, drawn at ½");
    assert_eq!(said("{ layer = 'normal', length = 2 }", "n"), "$2$ $n$");
}

#[test]
fn a_spin_says_its_degrees_where_the_scene_wants_them() {
    let turn = ", angular_velocity_deg = -90";
    let said = |layer: &str| labels(&figure(turn, "time-of-impact", layer))["omega_A"].0.clone();
    assert_eq!(said("'spin'"), r"$\omega_A$");
    assert_eq!(said("{ layer = 'spin', values = true }"), r"$\omega_A$ $= -90°$");
}

#[test]
fn a_distance_has_ticks_and_no_head_and_a_depth_one_head() {
    let heads = |figure: &Figure| {
        let filled = |path: &&&Path| path.fill.is_some();
        paths(&figure.drawing.items, "separation").iter().filter(filled).count()
    };
    let apart = figure("", "separation", "'separation'");
    assert_eq!((heads(&apart), lines(&apart, "separation").len()), (0, 3), "a line and two ticks");
    let text = "shapes.A = { kind = 'circle', radius = 2 }
         shapes.B = { kind = 'circle', radius = 2, position = [3, 0] }
         query = { kind = 'separation', of = ['A', 'B'] }\npanels = [{ layers = ['separation'] }]";
    let scene = open_text("marks.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let inside = draw(&plan, plan.theme, "marks");
    assert_eq!(heads(&inside), 1);
    // B goes to the right: from its leftmost point to A's rightmost one.
    let ends = points(paths(&inside.drawing.items, "separation")[0]);
    assert!(ends[0].x < ends[1].x, "{ends:?}");
}

#[test]
fn a_ghost_says_when_it_is_and_the_way_there_leads_on() {
    let figure = figure("", "linear-sweep", "'shapes', { layer = 'ghosts', at = 'hit', path = true }");
    assert_eq!(labels(&figure)["A'"].0, "$A$ at $t = 0.5$");
    let way = paths(&figure.drawing.items, "way-A");
    // A line, its head, and a dot where it begins.
    let filled = [1, 2].iter().all(|&k: &usize| way[k].fill.is_some());
    assert!(way.len() == 3 && filled && way[0].stroke.as_ref().unwrap().dash.is_empty());
    let ghost = paths(&figure.drawing.items, "ghost-A");
    // A body, and less of one than what is there.
    let [fill, body] = ["ghost-A", "body-A"]
        .map(|part| paths(&figure.drawing.items, part)[0].fill.as_ref().unwrap().opacity);
    assert!(fill < 0.5 * body && !ghost[0].stroke.as_ref().unwrap().dash.is_empty());
}

#[test]
fn a_solid_ghost_is_drawn_as_a_body_is_and_a_body_may_say_when_it_is_there() {
    let layers = "{ layer = 'shapes', text = 'at $t = 0$' }, { layer = 'ghosts', of = 'A', solid = true }";
    let hit = figure("", "linear-sweep", layers);
    let first = |part| paths(&hit.drawing.items, part)[0].clone();
    let (body, ghost) = (first("body-A"), first("ghost-A"));
    assert_eq!((&body.fill, &body.stroke), (&ghost.fill, &ghost.stroke));
    assert_eq!(labels(&hit)["A"].0, "at $t = 0$");
    let layers = "{ layer = 'ghosts', of = 'A', at = 'steps', solid = true }";
    let steps = figure("", "time-of-impact', algorithm = 'conservative-advancement", layers);
    let ghosts = paths(&steps.drawing.items, "ghost-A");
    assert!(!ghosts.is_empty() && ghosts.iter().all(|ghost| ghost.fill.is_some()));
    let layers = "{ layer = 'ghosts', of = 'A', at = 'steps', path = true }";
    let steps = figure("", "time-of-impact', algorithm = 'conservative-advancement", layers);
    assert_eq!(paths(&steps.drawing.items, "way-A").len(), 3, "one way to the last step");
}

#[test]
fn the_rival_is_the_next_longer_way_out() {
    // B ⊖ A is a box of 4 by 6 with the origin 1 from its left edge, 2.5 from its upper one.
    let text = "shapes.A = { kind = 'box', half_extents = [1, 2] }
         shapes.B = { kind = 'box', half_extents = [1, 1], position = [1, 0.5] }
         query = { kind = 'separation', of = ['A', 'B'], algorithm = 'minkowski' }
         panels = [{ space = 'configuration', layers = [{ layer = 'closest', rival = true }] }]";
    let scene = open_text("marks.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "marks");
    let (label, length) = labels(&figure)["rival"].clone();
    assert_eq!((label.as_str(), length), ("$2.5$, longer", 2.5));
    assert!((lines(&figure, "rival")[0] / figure.panels[0].frame.scale - length).abs() < 1e-9);
}

#[test]
fn the_rival_of_a_push_runs_from_the_deepest_vertex_to_another_edge() {
    // B's vertex (3, 1) is 2 from A's edge x = 5 and 3 from y = 4; then the bodies change places.
    let a = "vertices = [[0, -9], [5, -9], [5, 4], [0, 4]]";
    let b = "vertices = [[3, 1], [9, 3], [7, 8]]";
    for (a, b, pushed) in [(a, b, [3.0, 4.0]), (b, a, [5.0, 1.0])] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', {a} }}\nshapes.B = {{ kind = 'polygon', {b} }}
             query = {{ kind = 'separation', of = ['A', 'B'] }}
             panels = [{{ layers = [{{ layer = 'separation', rival = true }},
                {{ layer = 'ghosts', of = ['B'], at = 'rival' }}] }}]"
        );
        let scene = open_text("marks.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        assert_eq!(labels(&figure)["rival"].0, "$3$, longer");
        let frame = &figure.panels[0].frame;
        let ends: Vec<_> = paths(&figure.drawing.items, "rival").into_iter().flat_map(points).collect();
        let at = |p: [f64; 2]| ends.iter().any(|&q| (q - frame.page(DVec2::from(p))).length() < 0.5);
        assert!(at([3.0, 1.0]) && at([3.0, 4.0]), "{ends:?}");
        // There B just touches A.
        let ghost = points(paths(&figure.drawing.items, "ghost-B")[0]);
        let to = frame.page(DVec2::from(pushed));
        assert!(ghost.iter().any(|&q| (q - to).length() < 0.5), "{ghost:?}");
        assert_eq!(labels(&figure)["B'"].0, "$B$ pushed farther", "the shortest push has another ghost");
    }
}

#[test]
fn a_body_that_is_pushed_by_less_than_its_line_is_wide_is_not_named_a_second_time() {
    for (depth, named) in [(0.5, true), (0.001, false)] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 1] }}
             shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [{}, 0.5] }}
             query = {{ kind = 'separation', of = ['A', 'B'] }}
             panels = [{{ layers = ['shapes', {{ layer = 'ghosts', at = 'separated' }}] }}]",
            2.0 - depth
        );
        let scene = open_text("marks.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        assert_eq!(labels(&figure).contains_key("B'"), named, "{depth}");
    }
}

#[test]
fn the_closest_point_of_a_box_has_the_circles_letter_but_not_its_name() {
    for (circle, said) in [("B", "$B_c$"), ("coin", "closest point")] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 1] }}
             shapes.{circle} = {{ kind = 'circle', radius = 1, position = [4, 3] }}
             query = {{ kind = 'separation', of = ['A', '{circle}'], algorithm = 'clamp' }}
             panels = [{{ layers = ['shapes', 'clamp'] }}]"
        );
        let scene = open_text("marks.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        assert_eq!(labels(&draw(&plan, plan.theme, "marks"))["B_c"].0, said);
    }
}

#[test]
fn a_body_reaches_from_its_origin_to_its_farthest_point() {
    let layer = "{ layer = 'radii', as = 'reach', of = ['A', 'B'] }";
    let figure = figure("", "linear-sweep", layer);
    let scale = figure.panels[0].frame.scale;
    for (key, part, reach) in [("r1", "reach-A", 2.0_f64.sqrt()), ("r2", "reach-B", 1.0)] {
        assert!((labels(&figure)[key].1 - reach).abs() < 0.005);
        assert!((lines(&figure, part)[0] / scale - reach).abs() < 1e-9);
    }
}

#[test]
fn a_radius_goes_on_where_the_distance_ends() {
    // Discs of radii 1 and 2, 5 apart: from 1 to 3 the distance, then B's radius to 5, A's from 0 to 1.
    let text = "shapes.A = { kind = 'circle', radius = 1 }
         shapes.B = { kind = 'circle', radius = 2, position = [5, 0] }
         query = { kind = 'separation', of = ['A', 'B'] }
         panels = [{ layers = [{ layer = 'radii', as = 'dimension', offset = 20 }] }]";
    let scene = open_text("marks.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "marks");
    let frame = &figure.panels[0].frame;
    for (part, key, [from, to]) in [("radius-A", "r1", [0.0, 1.0]), ("radius-B", "r2", [3.0, 5.0])] {
        let drawn: Vec<Point> = paths(&figure.drawing.items, part).into_iter().flat_map(points).collect();
        let at = |x: f64| {
            let place = frame.page(DVec2::new(x, 0.0));
            drawn.iter().any(|q| (q.x - place.x).abs() < 0.5 && (q.y - place.y - 20.0).abs() < 0.5)
        };
        assert!(at(from) && at(to), "{part}: {drawn:?}");
        assert!((labels(&figure)[key].1 - (to - from)).abs() < 1e-9);
    }
}

#[test]
fn points_as_far_as_the_extreme_one_are_marked() {
    let text = "shapes.A = { kind = 'box', half_extents = [2, 1], angular_velocity_deg = 60 }
         query = { kind = 'motion-bound', of = ['A'] }\npanels = [{ layers = ['arc'] }]";
    let scene = open_text("marks.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "marks");
    assert_eq!(paths(&figure.drawing.items, "as-far").len(), 3);
    assert_eq!(labels(&figure)["others"].0, "as far as $p$");
}

#[test]
fn an_inner_point_on_the_way_to_the_extreme_one_shares_its_radii_and_its_angle() {
    // (1.5, 2) is half-way to (3, 4); (0, −1) lies elsewhere, with radii and an angle of its own.
    for (inner, radii, angles) in [("[1.5, 2]", 0, 1), ("[0, -1]", 2, 2)] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-1, 0], [3, -3], [3, 4]],
                angular_velocity_rad = 0.5 }}
             query = {{ kind = 'motion-bound', of = ['A'] }}
             panels = [{{ layers = [{{ layer = 'arc', inner = {inner} }}] }}]"
        );
        let scene = open_text("marks.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        let count = |part| paths(&figure.drawing.items, part).len();
        assert_eq!((count("nearer"), count("angle")), (radii, angles), "{inner}");
        assert!(count("nearer-arc") > 0 && labels(&figure).contains_key("q'"), "{inner}");
    }
}

#[test]
fn a_nearer_vertex_has_a_shorter_arc_of_the_same_turn() {
    // (3, 4) is 5 from the origin, (−1, 0) is 1: at their places, and both in the direction of (3, 4).
    for (sector, keys) in [(false, 0), (true, 2)] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-1, 0], [3, -3], [3, 4]],
                angular_velocity_rad = 0.5 }}
             query = {{ kind = 'motion-bound', of = ['A'] }}
             panels = [{{ layers = [{{ layer = 'arc', sector = {sector}, nearer = 0 }}] }}]"
        );
        let scene = open_text("marks.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        let radius = |part: &str| {
            let mut segments =
                paths(&figure.drawing.items, part).into_iter().flat_map(|path| match &path.contour {
                    Contour::Segments(segments) => segments.clone(),
                    Contour::Circle { .. } => Vec::new(),
                });
            let arc = |segment| if let Segment::Arc { radius, .. } = segment { Some(radius) } else { None };
            segments.find_map(arc).unwrap() / figure.panels[0].frame.scale
        };
        assert!((radius("arc") - 5.0).abs() < 1e-9 && (radius("nearer-arc") - 1.0).abs() < 1e-9);
        let labels = labels(&figure);
        assert!(labels.contains_key("q") && labels.contains_key("q'"));
        assert_eq!(["r_q", "L_q"].iter().filter(|key| labels.contains_key(**key)).count(), keys);
        if sector {
            assert_eq!((labels["r_q"].1, labels["L_q"].1), (1.0, 0.5));
        }
    }
}

#[test]
fn a_frame_says_the_angle_by_which_the_body_is_turned() {
    for (turn, says) in
        [(", rotation = [0.6, -0.8]", Some(-53.1)), (", angle_deg = 120", Some(120.0)), ("", None)]
    {
        let figure = figure(turn, "linear-sweep", "{ layer = 'frame', angle = true }");
        assert_eq!(labels(&figure).get("angle").map(|(_, number)| *number), says, "{turn}");
        // Of a body that is not turned it lies on the axis.
        assert_eq!(paths(&figure.drawing.items, "level").len(), usize::from(says.is_some()), "{turn}");
        let back = self::figure(turn, "linear-sweep", "{ layer = 'frame', angle = true, back = true }");
        assert_eq!(labels(&back).get("angle").map(|(_, number)| -number), says, "{turn}");
        // The head is at the other end: it lies on the level line.
        let head = |figure: &Figure| {
            let all = paths(&figure.drawing.items, "angle");
            all.into_iter().find(|path| path.fill.is_some()).map(|path| points(path)[0])
        };
        let level =
            |figure: &Figure, tip: Point| (tip.y - figure.panels[0].frame.page(DVec2::ZERO).y).abs() < 1e-6;
        assert!(head(&back).is_none_or(|tip| level(&back, tip)), "{turn}");
        assert!(head(&figure).is_none_or(|tip| !level(&figure, tip)), "{turn}");
    }
}

#[test]
fn a_normal_on_the_edge_stands_beside_the_contact() {
    let text = "shapes.A = { kind = 'box', half_extents = [4, 1] }
         shapes.B = { kind = 'polygon', vertices = [[0, 0], [2, 3], [-1, 3]], position = [1, 0.5] }
         query = { kind = 'separation', of = ['A', 'B'] }
         panels = [{ layers = ['shapes', { layer = 'normal', from = 'edge' }] }]";
    let scene = open_text("marks.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "marks");
    // The contact is at (1, 1) on the edge from (4, 1) to (−4, 1), whose longer part ends at (−4, 1).
    let begins = points(paths(&figure.drawing.items, "normal")[0])[0];
    assert!((begins - figure.panels[0].frame.page(DVec2::new(-1.5, 1.0))).length() < 1e-6, "{begins:?}");
    assert_eq!(paths(&figure.drawing.items, "right-angle").len(), 1);
}

/// The figure of a box below a disc as the layers of a panel show it.
fn grown(options: &str) -> Figure {
    let text = format!(
        "shapes.A = {{ kind = 'box', half_extents = [2, 1] }}
         shapes.B = {{ kind = 'polygon', vertices = [[-1, -1], [1, -1], [0, 2]], position = [0.5, 4] }}
         query = {{ kind = 'separation', of = ['A', 'B'] }}
         panels = [{{ layers = [{{ layer = 'grown'{options} }}] }}]"
    );
    let scene = open_text("grown.toml", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    draw(&plan, plan.theme, "grown")
}

#[test]
fn the_grown_body_is_as_far_from_the_point_as_the_bodies_from_each_other() {
    assert!(!labels(&grown("")).contains_key("d"));
    let figure = grown(", distance = true");
    assert_eq!(labels(&figure)["d"].0, "$d = 2$");
    let frame = &figure.panels[0].frame;
    // From b to the top edge of A grown by 1: its middle line and two ticks.
    let way = (frame.page(DVec2::new(0.5, 4.0)) - frame.page(DVec2::new(0.5, 2.0))).length();
    assert!(lines(&figure, "distance").iter().any(|line| (line - way).abs() < 1e-9));
    // Square to that edge.
    assert_eq!(paths(&figure.drawing.items, "right-angle").len(), 1);
}

#[test]
fn a_body_lies_in_b_minus_a_turned_half_round_about_the_point_of_b() {
    let text = |options: &str| {
        format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-2, -1], [2, -1], [0, 1]] }}
             shapes.B = {{ kind = 'polygon', vertices = [[-1, -1], [1, -1], [0, 2]], position = [0.5, 4] }}
             query = {{ kind = 'separation', of = ['A', 'B'] }}
             panels = [{{ space = 'configuration', layers = [{{ layer = 'closest'{options} }}] }}]"
        )
    };
    let shown = |options: &str| {
        let scene = open_text("turned.toml", &text(options)).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw(&plan, plan.theme, "turned")
    };
    assert!(paths(&shown("").drawing.items, "turned").is_empty());
    let figure = shown(", turned = true");
    let bounds = paths(&figure.drawing.items, "turned")[0].contour.bounds().unwrap();
    // (0.5, 4) less the vertices of A.
    let page = |x: f64, y: f64| figure.panels[0].frame.page(DVec2::new(x, y));
    let (low, high) = (page(-1.5, 3.0), page(2.5, 5.0));
    assert!((bounds.x0 - low.x).abs() < 1e-9 && (bounds.y0 - high.y).abs() < 1e-9, "{bounds:?}");
    assert_eq!(labels(&figure)["turned"].0, "$A$ turned");
    // An arc and its head.
    assert_eq!(paths(&figure.drawing.items, "half-turn").len(), 2);
}

#[test]
fn copies_around_a_body_are_moved_and_not_turned() {
    let copies = |options: &str| paths(&grown(options).drawing.items, "copies").len();
    // B at one of the four edges, and its point there; or B on each of the four vertices.
    let around = ", copies = false, around = true";
    assert_eq!([copies(around), copies(", copies = false"), copies("")], [1, 0, 4]);
    assert_eq!(paths(&grown(around).drawing.items, "around").len(), 1);
    assert!(labels(&grown(around))["copy"].0.starts_with("$B$ moved around $A$"));
}

#[test]
fn a_ray_says_its_components_where_the_scene_wants_them() {
    let said = |layer: &str| {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [4, 2] }}
             shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0], velocity = [-1, 0.5] }}
             query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
             panels = [{{ space = 'configuration', layers = [{layer}] }}]"
        );
        let scene = open_text("ray.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        labels(&draw(&plan, plan.theme, "ray"))["v"].0.clone()
    };
    assert_eq!(said("'ray'"), "$v$");
    assert_eq!(said("{ layer = 'ray', values = true }"), "$v$ $= (5, 1.5)$");
}

#[test]
fn a_right_angle_is_marked_at_the_nearest_point_of_an_edge_and_not_at_a_vertex() {
    for (place, angles) in [("[5, 0.5]", 1), ("[5, 4.5]", 0)] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 1] }}
             shapes.B = {{ kind = 'box', half_extents = [1, 1], position = {place} }}
             query = {{ kind = 'separation', of = ['A', 'B'] }}
             panels = [{{ space = 'configuration', layers = ['difference', 'closest'] }}]"
        );
        let scene = open_text("marks.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        assert_eq!(paths(&figure.drawing.items, "right-angle").len(), angles, "{place}");
    }
}
