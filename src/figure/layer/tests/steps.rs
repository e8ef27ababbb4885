//! What is drawn of an algorithm's steps, and of a whole motion, lies where the next step and the end have
//! it.

use crate::drawing::{Contour, Path, Point};
use crate::figure::{Figure, draw, plan};
use crate::geometry::DVec2;
use crate::scene::open_text;
use crate::trace::Event;

use super::{labels, last_number, lines, paths, points};

/// How far apart a thing may be drawn, page pixels.
const NEAR: f64 = 1e-6;

/// A box that goes towards a disc.
const BODIES: &str = r#"
    shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [3, 1], angle_deg = 10 }
    shapes.B = { kind = "circle", radius = 0.75, position = [4, 0.5], velocity = [-1, 0.5] }
"#;

/// The middle of the first circle or path of a part.
fn middle(figure: &Figure, part: &str) -> Point {
    let path: &Path = paths(&figure.drawing.items, part)[0];
    match &path.contour {
        Contour::Circle { center, .. } => *center,
        Contour::Segments(_) => {
            let bounds = path.contour.bounds().unwrap();
            Point::new(0.5 * (bounds.x0 + bounds.x1), 0.5 * (bounds.y0 + bounds.y1))
        }
    }
}

#[test]
fn the_new_estimate_of_a_step_is_the_estimate_of_the_next_one() {
    for (kind, algorithm) in
        [("linear-sweep", "ray-clipping"), ("time-of-impact", "conservative-advancement")]
    {
        let figure = |step: usize| {
            let text = format!(
                "{BODIES}\nquery = {{ kind = '{kind}', of = ['A', 'B'], algorithm = '{algorithm}' }}
                panels = [{{ space = 'configuration', step = {step}, view = [-2, -3, 6, 4],
                    layers = ['difference', 'advancement',
                        {{ layer = 'note', lines = ['{{=step.time}}', '{{=separation}}'] }}] }}]"
            );
            let scene = open_text("steps", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let told = |e: &Event| match *e {
                Event::Advanced { at, separation, next, .. } => Some((at.time, separation, next)),
                _ => None,
            };
            let told = plan.own_run().events().filter_map(told).nth(step - 1).unwrap();
            (draw(&plan, plan.theme, "steps"), told)
        };
        let ((one, (time, separation, next)), (two, (later, ..))) = (figure(1), figure(2));
        assert_eq!(next, Some(later));
        let v = DVec2::new(4.0, 0.5) * one.panels[0].frame.scale;
        // A sweep's difference rests and its estimate moves; else the estimate rests in the origin.
        let gone = if kind == "linear-sweep" { 0.0 } else { later - time };
        let [from, to] = [middle(&one, "next"), middle(&two, "estimate")];
        let off = DVec2::new(from.x - v.x * gone - to.x, from.y + v.y * gone - to.y);
        assert!(off.length() < NEAR, "{algorithm}: {off}");
        let [sought, given] = [separation, labels(&one)["note"].1];
        assert!((sought - given).abs() < 0.005, "{algorithm}: {given} is not {sought}");
    }
}

#[test]
fn an_arc_begins_and_ends_at_the_vertex_of_the_body_then() {
    let figure = |time: f64| {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[2, 1], [-0.5, 0.5], [0, -1]], angle_deg = 20,
                velocity = [1, -2], angular_velocity_deg = 100 }}
            query = {{ kind = 'motion-bound', of = ['A'] }}
            panels = [{{ time = {time}, view = [-4, -4, 4, 4], layers = ['arc', 'shapes'] }}]"
        );
        let scene = open_text("arc", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let vertex = scene.shapes[0].1.pose_at(time).point(DVec2::new(2.0, 1.0));
        let figure = draw(&plan, plan.theme, "arc");
        let vertex = figure.panels[0].frame.page(vertex);
        let ends: Vec<Point> = paths(&figure.drawing.items, "extreme-point")
            .into_iter()
            .filter_map(|p| if let Contour::Circle { center, .. } = p.contour { Some(center) } else { None })
            .collect();
        (ends, vertex)
    };
    for (time, end) in [(0.0, 0), (1.0, 1)] {
        let (ends, vertex) = figure(time);
        assert!((ends[end] - vertex).length() < NEAR, "{time}: {ends:?} {vertex:?}");
    }
}

#[test]
fn only_bodies_that_overlap_are_separated() {
    for (x, apart) in [(1.0, false), (3.0, true)] {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [{x}, 0] }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}
            panels = [{{ layers = ['shapes', {{ layer = 'ghosts', at = 'separated' }}] }}]"
        );
        let scene = open_text("ghosts", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "ghosts");
        assert_eq!(paths(&figure.drawing.items, "ghost-B").is_empty(), apart);
        assert_eq!(figure.warnings.iter().any(|w| w.fault.to_string().contains("no push is needed")), apart);
    }
}

#[test]
fn at_the_bound_of_the_first_step_the_bodies_are_apart_by_the_slack_that_is_left() {
    let text = "shapes.A = { kind = 'box', half_extents = [1.5, 0.5], position = [-4, -1], velocity = [7, 2],
            angle_deg = 20, angular_velocity_deg = 90 }
        shapes.B = { kind = 'polygon', vertices = [[2, -1], [5, -2], [6, 1], [3, 2]] }
        query = { kind = 'time-of-impact', of = ['A', 'B'] }
        panels = [{ time = 'bound', layers = ['shapes', { layer = 'note', lines = '{=bound}' }] },
            { layers = ['shapes', { layer = 'ghosts', at = 'bound' },
                { layer = 'separation', at = 'bound' }] }]";
    let scene = open_text("bound", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let bound = plan.panels[0].moment.time;
    let [a, b] = [0, 1].map(|i| &scene.shapes[i].1);
    let slack = crate::collision::Pair::at(a, b, bound).separation().separation;
    assert!(bound > 0.3 && slack > 0.5, "{bound}, {slack}");
    let labels = labels(&draw(&plan, plan.theme, "bound"));
    let (d, then) = labels["d"].0.split_once(" at ").unwrap();
    assert!((labels["note"].1 - bound).abs() < 0.005 && (last_number(then) - bound).abs() < 0.005);
    assert!((last_number(d) - slack).abs() < 0.01, "{labels:?}");
}

#[test]
fn a_step_has_the_same_name_among_the_ghosts_in_the_graph_and_at_its_difference() {
    let text = "shapes.A = { kind = 'box', half_extents = [1.5, 0.5], position = [-4, -1], velocity = [7, 2],
            angle_deg = 20, angular_velocity_deg = 90 }
        shapes.B = { kind = 'polygon', vertices = [[2, -1], [5, -2], [6, 1], [3, 2]] }
        query = { kind = 'time-of-impact', of = ['A', 'B'], tolerance = 0.5,
            algorithm = 'conservative-advancement' }
        panels = [{ layers = [{ layer = 'ghosts', of = 'A', at = 'steps', numbered = true }] },
            { layers = ['graph'] },
            { space = 'configuration', layers = [{ layer = 'difference', at = 'steps', numbers = true }] }]";
    let scene = open_text("names", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let count = plan.own_run().events().filter(|e| matches!(e, Event::Advanced { .. })).count();
    let figure = draw(&plan, plan.theme, "names");
    let names = |panel: usize| {
        let placed = figure.panels[panel].placed.iter();
        let named = placed.filter(|label| matches!(label.key, "then" | "A'" | "step"));
        let mut names: Vec<_> = named.map(|label| label.lines[0].1.markup.replace("$A$ at ", "")).collect();
        names.sort();
        names
    };
    let all: Vec<_> = (1..=count).map(|k| format!("$t_{{{k}}}$")).collect();
    assert!(count > 2 && names(0) == all[1..] && names(1) == all && names(2) == all, "{all:?}");
}

#[test]
fn bodies_that_are_there_at_each_step_are_all_named_alike() {
    for (solid, alike) in [(", solid = true", true), ("", false)] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1.5, 0.5], position = [-4, -1], velocity = [7, 2],
                angle_deg = 20, angular_velocity_deg = 90 }}
            shapes.B = {{ kind = 'polygon', vertices = [[2, -1], [5, -2], [6, 1], [3, 2]] }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'], tolerance = 0.5,
                algorithm = 'conservative-advancement' }}
            panels = [{{ layers = [
                {{ layer = 'ghosts', of = 'A', at = 'steps', numbered = true{solid} }}] }}]"
        );
        let scene = open_text("alike", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "alike");
        let earlier: Vec<_> = figure.panels[0].placed.iter().filter(|label| label.key == "then").collect();
        let named = |markup: &str| markup.starts_with("$A$ at $t_{");
        assert!(!earlier.is_empty() && earlier.iter().all(|label| named(&label.lines[0].1.markup) == alike));
    }
}

#[test]
fn a_radius_divided_by_a_nearer_vertex_is_measured_over_its_whole_length() {
    for (nearer, measured) in [(", nearer = 0", true), ("", false)] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-1.5, -2], [3, 4], [0, 1]],
                angular_velocity_deg = -50 }}
            query = {{ kind = 'motion-bound', of = ['A'] }}
            panels = [{{ layers = [{{ layer = 'arc', sector = true{nearer} }}] }}]"
        );
        let scene = open_text("arc", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "arc");
        let scale = figure.panels[0].frame.scale;
        let whole = |length: &f64| (length / scale - 5.0).abs() < NEAR;
        assert_eq!(lines(&figure, "radius").iter().any(whole), measured, "{nearer}");
        assert_eq!(labels(&figure)["r"].1, 5.0);
    }
}

#[test]
fn a_ray_without_its_free_way_still_hits() {
    for (option, bands) in [("", 1), (", free = false", 0)] {
        let text = format!(
            "{BODIES}\nquery = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
            panels = [{{ space = 'configuration', layers = [{{ layer = 'ray'{option} }}] }}]"
        );
        let scene = open_text("ray", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let items = draw(&plan, plan.theme, "ray").drawing.items;
        assert_eq!((paths(&items, "until-hit").len(), paths(&items, "hit").len()), (bands, 1));
    }
}

#[test]
fn v_ends_on_the_edge_that_it_is_to_and_before_the_mark_of_a_vertex() {
    for (step, v, is_marked) in [(2, [3.0, -1.5], true), (3, [3.0, 0.0], false)] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 1] }}
             shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [5, 0.5] }}
             query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
             panels = [{{ space = 'configuration', layers = [{{ layer = 'simplex', step = {step} }}] }}]"
        );
        let scene = open_text("gjk", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "gjk");
        let end = figure.panels[0].frame.page(DVec2::from(v));
        let arrow = paths(&figure.drawing.items, "closest");
        let off = arrow.iter().flat_map(|path| points(path)).map(|p| (p - end).length());
        let off = off.fold(f64::INFINITY, f64::min);
        assert!(if is_marked { off > 4.0 } else { off < NEAR }, "{step}: {off}");
    }
}
