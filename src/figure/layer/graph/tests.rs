//! What a graph shows of the steps: lines, values, the last number.

use super::*;
use crate::drawing::{Contour, Point, Segment};
use crate::figure::layer::tests::{paths, points};
use crate::figure::{Figure, draw, draw_in_motion, draw_in_steps, plan};
use crate::scene::open_text;

/// A box that turns towards a polygon, with a graph of it.
fn graph(algorithm: &str, values: bool) -> Result<(Figure, Vec<Step>), String> {
    let text = format!(
        "shapes.A = {{ kind = 'box', half_extents = [1.5, 0.5], position = [-4, -1], velocity = [7, 2],
            angle_deg = 20, angular_velocity_deg = 90 }}
        shapes.B = {{ kind = 'polygon', vertices = [[2, -1], [5, -2], [6, 1], [3, 2]] }}
        query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = '{algorithm}' }}
        panels = [{{ view = [0, 0, 4, 3], layers = [{{ layer = 'graph', values = {values} }}] }}]"
    );
    let scene = open_text("graph", &text).unwrap().scene;
    let plan = plan(&scene).map_err(|problems| format!("{problems:?}"))?;
    let steps = steps(&plan.panels[0].context(&scene, &plan.runs));
    Ok((draw(&plan, plan.theme, "graph"), steps))
}

#[test]
fn each_line_of_the_fastest_approach_ends_where_the_next_step_begins_and_is_never_above_the_curve() {
    let (figure, steps) = graph("conservative-advancement", false).unwrap();
    assert!(steps.len() > 3);
    let ends = |part: &str| -> Vec<Vec<crate::drawing::Point>> {
        let points = |path: &crate::drawing::Path| match &path.contour {
            Contour::Segments(segments) => segments
                .iter()
                .filter_map(|s| match *s {
                    Segment::Move(p) | Segment::Line(p) => Some(p),
                    _ => None,
                })
                .collect(),
            Contour::Circle { .. } => Vec::new(),
        };
        paths(&figure.drawing.items, part).into_iter().map(points).collect()
    };
    let (lines, looks) = (ends("worst"), ends("look"));
    for (line, look) in lines.iter().zip(&looks) {
        assert!((line[1] - look[0]).length() < 1e-9, "{line:?} does not end at {look:?}");
    }
    let curve = &ends("curve")[0];
    for [p, q] in lines.iter().map(|line| [line[0], line[1]]) {
        for c in curve.iter().filter(|c| c.x > p.x && c.x < q.x) {
            // On the page y is down.
            let under = p.y + (q.y - p.y) * (c.x - p.x) / (q.x - p.x);
            assert!(c.y <= under + 1e-6, "the curve falls below the line at {c:?}");
        }
    }
}

#[test]
fn level_with_a_picture_of_the_same_view_separations_are_as_long_as_there() {
    let view = "view = [-2, -2, 14, 8]";
    let text = format!(
        "shapes.A = {{ kind = 'box', half_extents = [1.2, 0.4], position = [0, 6], angle_deg = 70,
            velocity = [9, -5], angular_velocity_rad = -4 }}
        shapes.B = {{ kind = 'polygon', vertices = [[-2, 0.5], [-2, -1], [13, -1], [13, 0.5]] }}
        query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
            tolerance = 0.5 }}
        panels = [{{ {view}, layers = [{{ layer = 'separation', at = 'steps' }}] }},
            {{ {view}, layers = [{{ layer = 'graph', level = true }}] }}]"
    );
    let scene = open_text("level", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "level");
    let ends = |part| paths(&figure.drawing.items, part).into_iter().map(points).collect::<Vec<_>>();
    // Of each step after the first the line from the axis of time to the curve, and the one from A to B.
    let (looks, lines) = (ends("look"), ends("separation"));
    let level = |[p, q]: [crate::drawing::Point; 2]| (p.y - q.y).abs() < 1e-6;
    let drawn = |look: &[_]| lines.iter().any(|l| level([l[0], look[1]]) && level([l[1], look[0]]));
    assert!(looks.len() > 1 && looks.iter().all(|look| drawn(look)), "{looks:?} in {lines:?}");
    // A goes by 9 to the right, and each time is where it is then.
    let context = plan.panels[1].context(&scene, &plan.runs);
    for (look, step) in looks.iter().zip(&steps(&context)[1..]) {
        let x = figure.panels[1].frame.page(crate::geometry::DVec2::new(9.0 * step.time, 0.0)).x;
        assert!((look[0].x - x).abs() < 1e-6, "{look:?} is not at {x}");
    }
}

/// The lines of the labels of a key.
fn said(figure: &Figure, key: &str) -> Vec<String> {
    let placed = figure.panels.iter().flat_map(|panel| &panel.placed);
    let lines = placed.filter(|label| label.key == key).flat_map(|label| &label.lines);
    lines.map(|(_, line)| line.markup.clone()).collect()
}

#[test]
fn values_are_those_of_the_steps_and_only_written_where_they_are_asked_for() {
    let (figure, steps) = graph("conservative-advancement", true).unwrap();
    let times = said(&figure, "step");
    assert_eq!(times[..2], ["$t_{1}$", "$0$"]);
    assert_eq!(times[2..4], ["$t_{2}$".to_owned(), format!("${}$", number(steps[1].time))]);
    assert!(said(&figure, "worst").contains(&format!("${}$ in a unit of time", number(steps[0].bound))));
    assert_eq!(said(&figure, "s_k")[0], format!("$s_{{2}} = {}$", number(steps[1].separation)));
    let (plain, _) = graph("conservative-advancement", false).unwrap();
    assert_eq!(said(&plain, "s_k")[0], "$s_{2}$");
    assert!(said(&plain, "step").iter().all(|line| line.starts_with("$t_")));
}

#[test]
fn the_curve_of_fast_spins_goes_through_every_step_and_the_axes_keep_their_names() {
    let text = "
        shapes.A = { kind = 'box', half_extents = [2, 0.12], angular_velocity_deg = 3600 }
        shapes.B = { kind = 'circle', radius = 0.3, position = [5, 0.5], velocity = [-4, 0] }
        query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
            tolerance = 1e-3 }
        canvas = { width = 1100, height = 620 }
        panels = [{ layers = ['graph'] }]";
    let scene = open_text("graph", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let context = plan.panels[0].context(&scene, &plan.runs);
    let steps = steps(&context);
    assert!(steps.len() > 2 * MOST);
    let times: Vec<f64> = steps.iter().take(MOST).map(|step| step.time).collect();
    let curve = separations(&context, 1.0, &times);
    for step in steps.iter().take(MOST) {
        let on = curve.iter().find(|p| p.x == step.time).unwrap();
        assert!((on.y - step.separation).abs() < 1e-9, "{on} {}", step.separation);
    }
    // In each of ten turns the box comes near twice and goes away twice.
    let turns = curve.windows(3).filter(|p| (p[1].y - p[0].y) * (p[2].y - p[1].y) < 0.0).count();
    assert!((38..=42).contains(&turns), "{turns}");
    let figure = draw(&plan, plan.theme, "graph");
    let keys: Vec<_> = figure.panels[0].placed.iter().map(|label| label.key).collect();
    assert!(["t", "s", "more"].iter().all(|key| keys.contains(key)), "{keys:?}");
    let (count, last) = (steps.len() - MOST, steps.len());
    let more = figure.panels[0].placed.iter().find(|label| label.key == "more").unwrap();
    assert_eq!(more.lines[0].1.markup, format!("{count} more steps, to $t_{{{last}}}$"));
    assert_eq!(super::more(MOST + 1), "one more step, $t_{13}$");
}

#[test]
fn the_tolerance_is_a_line_over_all_times_at_its_separation() {
    let text = "shapes.A = { kind = 'circle', radius = 1, velocity = [8, 0], angular_velocity_deg = 30 }
        shapes.B = { kind = 'box', half_extents = [1, 1], position = [6, 1], angle_deg = 30 }
        query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
            tolerance = 0.5 }
        panels = [{ view = [0, 0, 4, 3], layers = [{ layer = 'graph', tolerance = true }] }]";
    let scene = open_text("graph", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "graph");
    let level = |part: &str| paths(&figure.drawing.items, part)[0].contour.bounds().unwrap();
    // The line of the second look runs from 0 up to s₂. That of the fastest approach has a gap where it
    // would run along the curve.
    let (line, worst, look) = (level("tolerance"), level("worst"), level("look"));
    let second = steps(&plan.panels[0].context(&scene, &plan.runs))[1].separation;
    let height = (look.y1 - line.y0) / (look.y1 - look.y0) * second;
    assert!(line.y0 == line.y1 && (height - 0.5).abs() < 1e-9, "{height}");
    assert!(line.x1 - line.x0 > worst.x1 - worst.x0);
}

#[test]
fn a_tolerance_that_cannot_be_told_from_the_axis_says_so() {
    for (tolerance, unseen) in [(0.5, false), (1e-3, true)] {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1, velocity = [8, 0], angular_velocity_deg = 30 }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [6, 1], angle_deg = 30 }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
                tolerance = {tolerance} }}
            panels = [{{ view = [0, 0, 4, 3], layers = [{{ layer = 'graph', tolerance = true }}] }}]"
        );
        let scene = open_text("graph", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "graph");
        let label = figure.panels[0].placed.iter().find(|label| label.key == "tolerance").unwrap();
        let text = &label.lines[0].1.markup;
        assert_eq!(text.ends_with("too small to be seen"), unseen, "{text}");
    }
}

#[test]
fn an_algorithm_without_steps_has_no_graph() {
    assert!(graph("swept-axis", true).is_err());
}

#[test]
fn steps_without_a_number_of_their_own_are_told_with_the_last_one() {
    assert_eq!(["$t_{4}$", "$t_{3}, t_{4}$", "$t_{2} \\ldots t_{4}$"], [0, 1, 2].map(|n| numbered(4, n)));
    for values in [false, true] {
        let (figure, steps) = graph("conservative-advancement", values).unwrap();
        let times = said(&figure, "step");
        let numbers = |line: &str| -> Vec<usize> {
            let digits = line.split(|c: char| !c.is_ascii_digit()).filter_map(|n| n.parse().ok());
            digits.collect()
        };
        let numbers: Vec<Vec<usize>> =
            times.iter().filter(|line| line.starts_with("$t_")).map(|line| numbers(line)).collect();
        let (last, before) = numbers.split_last().unwrap();
        let first = last[0];
        assert_eq!(*last.last().unwrap(), steps.len().min(MOST));
        assert!(last.len() < 2 || before.last().unwrap()[0] < first, "{numbers:?}");
    }
}

#[test]
fn of_a_short_graph_the_head_of_the_axis_of_time_is_seen_beyond_the_last_step() {
    let text = "shapes.A = { kind = 'box', half_extents = [1.2, 0.4], position = [0, 6], angle_deg = 70,
            velocity = [9, -5], angular_velocity_rad = -4 }
        shapes.B = { kind = 'polygon', vertices = [[-2, 0.5], [-2, -1], [13, -1], [13, 0.5]] }
        query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }
        panels = [{ view = [-40, -40, 80, 50], layers = [{ layer = 'graph', level = true }] }]";
    let scene = open_text("short", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "short");
    let bounds = |part| {
        let all = paths(&figure.drawing.items, part).into_iter().filter_map(|path| path.contour.bounds());
        all.reduce(crate::drawing::Rect::union).unwrap()
    };
    let (axes, steps) = (bounds("axis"), bounds("steps"));
    // A marker is no wider than 12, and the head is 9 long.
    assert!(axes.x1 - steps.x1 > 9.0, "{axes:?} {steps:?}");
    let more = figure.panels[0].placed.iter().find(|label| label.key == "more");
    assert!(more.is_none_or(|label| label.bounds.y1 < axes.y1), "over the axis or above it: {more:?}");
}

#[test]
fn a_graph_marks_the_moment_that_others_show_while_a_figure_plays() {
    let text = "shapes.A = { kind = 'circle', radius = 1, position = [-4, 0], velocity = [8, 1] }
        shapes.B = { kind = 'box', half_extents = [1, 1], position = [3, 0], angular_velocity_deg = 40 }
        query = { kind = 'time-of-impact', of = ['A', 'B'] , algorithm = 'conservative-advancement' }
        panels = [{ time = 'start', layers = ['shapes'] }, { layers = ['graph'] }]";
    let scene = open_text("s", text).unwrap().scene;
    let plan = plan(&scene).unwrap().with_room_to_move().unwrap();
    let figure = draw_in_motion(&plan, plan.theme, "s", 5).unwrap().drawing;
    let middle = |items: &[crate::drawing::Item]| {
        let marks: Vec<_> = paths(items, "now").iter().filter_map(|path| path.contour.bounds()).collect();
        marks.last().map(|bounds| bounds.center().x)
    };
    let places: Vec<f64> = figure.motion.iter().filter_map(|frame| middle(&frame.drawing.items)).collect();
    assert!(places.len() >= 4 && places.windows(2).all(|pair| pair[1] > pair[0] + 10.0), "{places:?}");
    assert_eq!(middle(&figure.items), None, "the figure itself shows all moments");
}

/// What is drawn and noted of bodies that move towards each other, or away from where they overlap.
fn drawn(keys: &str, layer: &str) -> (Figure, Vec<String>) {
    let text = format!(
        "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [-3, 0], angular_velocity_deg = 30 }}
        shapes.B = {{ kind = 'box', half_extents = [1, 1], {keys} }}
        query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }}
        panels = [{{ layers = [{{ layer = '{layer}' }}] }}]"
    );
    let scene = open_text("graph", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let notes = plan.warnings.iter().map(|problem| problem.fault.to_string()).collect();
    (draw(&plan, plan.theme, "graph"), notes)
}

#[test]
fn bodies_that_overlap_at_the_start_have_their_depth_below_the_axis() {
    let (figure, _) = drawn("position = [1, 0]", "graph");
    let panel = figure.panels[0].frame.panel;
    let inside = |p: &Point| panel.x0 <= p.x && p.x <= panel.x1 && panel.y0 <= p.y && p.y <= panel.y1;
    for part in ["curve", "steps"] {
        let all = paths(&figure.drawing.items, part);
        assert!(!all.is_empty() && all.iter().all(|path| points(path).iter().all(inside)), "{part}");
    }
    assert_eq!(said(&figure, "s_1"), ["$s_1 = -1$"]);
    // What is nearest to come in a time is asked of bodies that are apart.
    let (_, notes) = drawn("position = [1, 0]", "fastest-approach");
    assert!(notes.iter().any(|note| note.contains("fastest-approach")), "{notes:?}");
}

#[test]
fn bodies_that_touch_at_the_start_have_a_graph_that_is_on_the_page() {
    for gap in ["-2.0000000000001", "-2", "-1.9999999999999"] {
        let (figure, _) = drawn(&format!("position = [{gap}, 0.3]"), "graph");
        assert!(!paths(&figure.drawing.items, "curve").is_empty(), "{gap}");
        // The axis of separation reaches above that of time, and down to what is below it.
        let axes: Vec<Point> = paths(&figure.drawing.items, "axis").into_iter().flat_map(points).collect();
        let has = |is_so: fn(f64, f64) -> bool| axes.iter().any(|p| is_so(p.y, axes[0].y));
        assert!(has(|y, zero| y < zero - 20.0) && has(|y, zero| y > zero + 20.0), "{gap}");
    }
}

#[test]
fn of_a_miss_the_last_line_reaches_the_end_above_the_axis() {
    let (figure, _) = drawn("position = [-9, 0]", "graph");
    let line = points(paths(&figure.drawing.items, "worst").last().unwrap());
    let axis = points(paths(&figure.drawing.items, "axis")[0]);
    let [from, to] = [line[0], *line.last().unwrap()];
    assert!(from.x < to.x && from.y < to.y && to.y < axis[0].y, "{line:?} {axis:?}");
}

#[test]
fn steps_that_the_eye_cannot_tell_from_the_last_one_come_with_it() {
    let text =
        "shapes.A = { kind = 'box', half_extents = [0.9, 0.25], position = [-3.4, 0.9], velocity = [5, -0.6],
            angular_velocity_deg = 60 }
        shapes.B = { kind = 'circle', radius = 0.5, position = [1.2, 0] }
        query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }
        panels = [{ layers = ['graph'] }]";
    let scene = open_text("s", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    assert!(steps(&plan.panels[0].context(&scene, &plan.runs)).len() > MOST);
    let whole = draw_in_steps(&plan, plan.theme, "s").drawing;
    let said: Vec<String> = whole.steps.iter().map(|step| step.sentences.join(" ")).collect();
    assert!(said.len() < 18 && said.iter().any(|said| said.contains("Steps in between")), "{said:#?}");
    assert!(said.last().unwrap().contains("it stops here"), "{said:#?}");
}

#[test]
fn a_miss_tells_how_far_it_is_safe_before_its_closest_approach() {
    let text = "shapes.A = { kind = 'box', half_extents = [1, 0.5], angular_velocity_deg = 120 }
        shapes.B = { kind = 'circle', radius = 0.5, position = [-3, 2.4], velocity = [6, 0] }
        query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }";
    let scene = open_text("s", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let steps = draw_in_steps(&plan, plan.theme, "s").drawing.steps;
    let place = |words: &str| steps.iter().position(|step| step.sentences.join(" ").contains(words));
    let [safe, closest] = ["after the end", "come closest at"].map(place);
    assert!(safe.is_some() && safe < closest, "{steps:#?}");
}
