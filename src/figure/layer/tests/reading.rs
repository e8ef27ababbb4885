//! What a reader computes along with is true: numbers of axes, numbers and coordinates of vertices, points
//! and features.

use crate::drawing::{Group, Item, Path, Point, Text};
use crate::figure::sketch::Request;
use crate::figure::{Figure, draw, plan};
use crate::geometry::DVec2;
use crate::scene::{Explain, open_text};

use super::{labels, last_number, lines, paths};

/// How far apart a thing may be drawn, page pixels.
const NEAR: f64 = 1e-6;

/// A clockwise polygon with a vertex within an edge, and a box, turned.
const BODIES: &str = r#"
    shapes.A = { kind = "polygon", vertices = [[0, 0], [0, 2], [1, 2], [2, 2], [2, 0]], position = [-3, 1] }
    shapes.B = { kind = "box", half_extents = [1, 0.5], position = [2, 2], angle_deg = 30 }
    query = { kind = "separation", of = ["A", "B"] }
"#;

/// A scene of these bodies with a panel, drawn, and the labels that its layers ask for.
fn drawn(bodies: &str, panel: &str) -> (Figure, Vec<Request>) {
    let scene = open_text("reading", &format!("{bodies}\npanels = [{{ {panel} }}]")).unwrap().scene;
    let plan = plan(&scene).unwrap_or_else(|problems| panic!("{panel}: {problems:?}"));
    let context = plan.panels[0].context(&scene, &plan.runs);
    let requests = plan.panels[0].sketch(&context, plan.theme).requests;
    (draw(&plan, plan.theme, "reading"), requests)
}

/// The codes of what is wrong with a panel.
fn codes(panel: &str) -> Vec<&'static str> {
    let scene = open_text("reading", &format!("{BODIES}\npanels = [{{ {panel} }}]")).unwrap().scene;
    plan(&scene).map(|_| ()).unwrap_err().iter().map(|p| p.fault.code()).collect()
}

/// The texts written in the groups of a name.
fn texts<'d>(items: &'d [Item], name: &str) -> Vec<&'d Text> {
    let mut found = Vec::new();
    for item in items {
        if let Item::Group(Group { name: own, items, .. }) = item {
            found.extend(texts(items, name));
            found.extend(items.iter().filter_map(|item| match item {
                Item::Text(text) if own == name => Some(text),
                _ => None,
            }));
        }
    }
    found
}

/// The points that the labels of a key belong to, with their texts.
fn named(requests: &[Request], key: &str) -> Vec<(DVec2, String)> {
    let own = requests.iter().filter(|request| request.label.key == key);
    own.map(|request| (request.label.anchor.points()[0], request.label.lines.join(" "))).collect()
}

#[test]
fn a_number_of_an_axis_stands_at_its_coordinate_and_a_line_of_the_grid_runs_there() {
    let panel = r#"view = [-5, -3, 5, 3], layers = ["grid", { layer = "axes", ticks = true }, "shapes"]"#;
    let (figure, _) = drawn(BODIES, panel);
    let frame = figure.panels[0].frame;
    let numbers = texts(&figure.drawing.items, "x-numbers");
    assert!(numbers.len() > 8, "{}", numbers.len());
    for text in numbers {
        let x = last_number(&text.line.markup);
        let place = frame.page(DVec2::new(x, 0.0)).x;
        assert!((text.origin.x + 0.5 * text.line.width - place).abs() < NEAR, "{x}");
    }
    for text in texts(&figure.drawing.items, "y-numbers") {
        let y = last_number(&text.line.markup);
        let middle = text.origin.y - 0.5 * (text.line.ascent - text.line.descent);
        assert!((middle - frame.page(DVec2::new(0.0, y)).y).abs() < NEAR, "{y}");
    }
    let upright = paths(&figure.drawing.items, "upright")[0].contour.bounds().unwrap();
    assert_eq!([upright.y0, upright.y1], [frame.panel.y0, frame.panel.y1]);
    let there = |x: f64| frame.page(DVec2::new(x, 0.0)).x;
    let ends = [(upright.x0 - frame.panel.x0) / frame.scale, (frame.panel.x1 - upright.x1) / frame.scale];
    assert!(ends.iter().all(|end| (0.0..1.0).contains(end)) && there(0.0) > upright.x0, "{ends:?}");
}

#[test]
fn a_moving_bodys_panel_has_the_numbers_of_its_own_frame() {
    let bodies =
        BODIES.replace("angle_deg = 30", "angle_deg = 30, velocity = [4, 1], angular_velocity_deg = 50");
    let bodies = bodies.replace("separation", "time-of-impact");
    let panel = r#"space = "body", frame = "B", time = 0.4, view = [-4, -4, 4, 4],
        layers = [{ layer = "axes", ticks = true, step = 2 },
            { layer = "vertices", of = "B", coordinates = true },
            { layer = "point", of = "B", at = [0.25, -1.5], coordinates = true }]"#;
    let (figure, requests) = drawn(&bodies, panel);
    let middle = figure.panels[0].frame.panel.center();
    let zero = texts(&figure.drawing.items, "x-numbers").into_iter().find(|t| t.line.markup == "0").unwrap();
    assert!((zero.origin.x + 0.5 * zero.line.width - middle.x).abs() < NEAR);
    let said: Vec<String> = named(&requests, "vertex.B").into_iter().map(|(_, text)| text).collect();
    assert_eq!(said, ["$(-1, -0.5)$", "$(1, -0.5)$", "$(1, 0.5)$", "$(-1, 0.5)$"]);
    assert_eq!(named(&requests, "point")[0].1, "$(0.25, -1.5)$");
}

#[test]
fn far_from_the_axes_and_at_every_scale_numbers_are_there_and_labels_keep_off() {
    for (at, size) in [(0.0, 1.0), (1e9, 1.0), (0.0, 1e-6), (0.0, 1e9), (-1e-6, 1e-9), (1e40, 1e30)] {
        let bodies = format!(
            "shapes.A = {{ kind = 'box', half_extents = [{size}, {size}], position = [{at}, {at}] }}
            shapes.B = {{ kind = 'circle', radius = {size}, position = [{}, {at}] }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}",
            at + 5.0 * size
        );
        let panel = "layers = ['grid', { layer = 'axes', ticks = true }, 'shapes', 'separation',
            { layer = 'vertices', coordinates = true },
            { layer = 'note', lines = ['a', 'b'], at = 'bottom-left' }]";
        let (figure, _) = drawn(&bodies, panel);
        let numbers: Vec<&Text> =
            ["x-numbers", "y-numbers"].iter().flat_map(|name| texts(&figure.drawing.items, name)).collect();
        assert!(numbers.len() > 8, "{at}, {size}: {}", numbers.len());
        for text in &numbers {
            let (p, line) = (text.origin, &text.line);
            let inside =
                |q: Point| q.x > p.x && q.x < p.x + line.width && q.y < p.y && q.y > p.y - line.ascent;
            let over = figure.panels[0].placed.iter().find(|label| inside(label.bounds.center()));
            assert!(over.is_none(), "{at}, {size}: {} is under {over:?}", line.markup);
            assert!(line.markup.chars().count() <= 30, "{}", line.markup);
        }
    }
}

#[test]
fn vertices_have_the_numbers_of_the_file_and_those_of_the_difference_come_from_them() {
    let (_, requests) = drawn(BODIES, "layers = ['vertices']");
    let found = named(&requests, "vertex.A");
    let places = [(-3.0, 1.0), (-3.0, 3.0), (-2.0, 3.0), (-1.0, 3.0), (-1.0, 1.0)];
    assert_eq!(found.len(), 5);
    for (k, ((p, text), place)) in found.into_iter().zip(places).enumerate() {
        assert_eq!((p, text), (DVec2::from(place), k.to_string()));
    }
    let (_, only) = drawn(BODIES, "layers = [{ layer = 'vertices', of = 'A', only = [1, 4] }]");
    assert_eq!(named(&only, "vertex.A").into_iter().map(|(_, text)| text).collect::<Vec<_>>(), ["1", "4"]);
    let world = |key: &str, k: usize| named(&requests, key)[k].0;
    let panel =
        "space = 'configuration', layers = [{ layer = 'vertices', numbers = true, coordinates = false }]";
    let (_, of_both) = drawn(BODIES, panel);
    let difference = named(&of_both, "vertex");
    assert_eq!(difference.len(), 8);
    for (p, text) in difference {
        let numbers: Vec<usize> =
            text.split(|c: char| !c.is_ascii_digit()).filter_map(|word| word.parse().ok()).collect();
        let [j, i] = numbers[..] else { panic!("{text}") };
        let expected = world("vertex.B", j) - world("vertex.A", i);
        assert!(p.distance(expected) < 1e-12, "{text} is at {p}, not {expected}");
    }
}

#[test]
fn the_emphasised_features_are_those_of_the_answer_or_those_named() {
    // A's right edge, number 3 of the file, holds the closest point; B's vertex 3 is the other one.
    let (figure, requests) = drawn(BODIES, "view = [-4, -3, 4, 4], layers = ['feature']");
    assert_eq!(named(&requests, "feature.A")[0].1, "edge 3");
    assert_eq!(named(&requests, "feature.B")[0].1, "vertex 3");
    let scale = figure.panels[0].frame.scale;
    assert!((lines(&figure, "feature-A")[0] - 2.0 * scale).abs() < NEAR);
    // The same edge on the difference, on the line that is the separation away from the origin.
    let panel = "space = 'configuration', view = [-1, -4, 8, 4], layers = ['feature']";
    let (figure, requests) = drawn(BODIES, panel);
    assert_eq!(named(&requests, "feature.A")[0].1, "edge 3 of $A$");
    let frame = figure.panels[0].frame;
    let bounds = paths(&figure.drawing.items, "feature-A")[0].contour.bounds().unwrap();
    assert_eq!(bounds.x0, bounds.x1);
    let separation = (bounds.x0 - frame.page(DVec2::ZERO).x) / frame.scale;
    let corner = 2.0 - 3.0_f64.sqrt() / 2.0 - 0.25;
    assert!((separation - (corner + 1.0)).abs() < 1e-12, "{separation}");
    let (figure, requests) =
        drawn(BODIES, "layers = [{ layer = 'feature', of = 'B', edge = [0, 2], vertex = 1 }]");
    let said: Vec<String> = named(&requests, "feature.B").into_iter().map(|(_, text)| text).collect();
    assert_eq!(said, ["edge 0", "edge 2", "vertex 1"]);
    assert_eq!(paths(&figure.drawing.items, "feature-A"), [] as [&Path; 0]);
}

#[test]
fn an_edge_of_a_round_body_lies_on_its_outline_and_faces_the_other_body() {
    let bodies = "
        shapes.A = { kind = 'capsule', points = [[-1, 0], [1, 0]], radius = 0.5 }
        shapes.B = { kind = 'circle', radius = 0.25, position = [0.5, 2] }
        query = { kind = 'separation', of = ['A', 'B'] }";
    let (figure, _) = drawn(bodies, "view = [-3, -1, 3, 3], layers = ['feature']");
    let frame = figure.panels[0].frame;
    let edges = paths(&figure.drawing.items, "feature-A");
    let bounds = edges[0].contour.bounds().unwrap();
    assert_eq!(edges.len(), 1);
    assert!((bounds.y0 - frame.page(DVec2::new(0.0, 0.5)).y).abs() < NEAR);
    let (figure, _) = drawn(bodies, "layers = [{ layer = 'feature', of = 'A', edge = 0 }]");
    assert_eq!(paths(&figure.drawing.items, "feature-A").len(), 2);
}

#[test]
fn what_is_not_there_is_refused() {
    for (panel, expected) in [
        ("layers = [{ layer = 'grid', step = 0 }]", ["wrong-type"]),
        ("layers = [{ layer = 'axes', step = '1' }]", ["wrong-type"]),
        ("layers = ['point']", ["unfed-layer"]),
        ("layers = [{ layer = 'point', at = [1] }]", ["wrong-type"]),
        ("layers = [{ layer = 'point', at = [1, 1e200] }]", ["wrong-type"]),
        ("space = 'configuration', layers = [{ layer = 'point', at = [0, 0], of = 'A' }]", ["unfed-layer"]),
        ("layers = [{ layer = 'vertices', only = [9] }]", ["unfed-layer"]),
        ("layers = [{ layer = 'vertices', only = 1.5 }]", ["wrong-type"]),
        ("layers = [{ layer = 'vertices', only = -1 }]", ["wrong-type"]),
        ("layers = [{ layer = 'feature', edge = 9 }]", ["unfed-layer"]),
    ] {
        assert_eq!(codes(panel), expected, "{panel}");
    }
}

#[test]
fn a_vertex_that_is_as_far_as_p_has_no_shorter_arc() {
    let told = |vertex: usize| {
        let text = format!(
            "shapes.door = {{ kind = 'polygon', vertices = [[0, 0], [2, 0], [2, 1]],
                angular_velocity_deg = 75 }}
             query = {{ kind = 'motion-bound', of = ['door'] }}
             panels = [{{ layers = ['shapes', {{ layer = 'arc', sector = true, nearer = {vertex} }}] }}]"
        );
        let scene = open_text("door", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawn = labels(&draw(&plan, plan.theme, "door")).contains_key("q");
        (drawn, plan.warnings.iter().map(|w| w.fault.to_string()).collect::<Vec<_>>())
    };
    assert_eq!(told(1), (true, vec![]));
    let none = "`nearer` of `arc` draws nothing: that vertex is as far as p, or the origin";
    assert_eq!(told(2), (false, vec![none.to_owned()]));
}

#[test]
fn what_has_no_edge_to_stand_on_is_told() {
    let told = |y: f64, layer: &str| {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[0, 0], [2, -1], [2, 1]] }}
             shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [-3, {y}] }}
             query = {{ kind = 'separation', of = ['A', 'B'] }}
             panels = [{{ layers = ['shapes', {layer}] }}]"
        );
        let scene = open_text("vertices", &text).unwrap().scene;
        plan(&scene).unwrap().warnings.iter().map(|w| w.fault.to_string()).collect::<Vec<_>>()
    };
    for (layer, option) in [("separation", "carrier = true"), ("normal", "from = 'edge'")] {
        let asked = format!("{{ layer = '{layer}', {option} }}");
        assert_eq!(told(0.5, &asked), Vec::<String>::new(), "A's vertex is before an edge of B");
        let option = option.split(' ').next().unwrap();
        let why = "neither closest point is on an edge that faces the other body";
        assert_eq!(told(2.0, &asked), [format!("`{option}` of `{layer}` draws nothing: {why}")]);
    }
}

#[test]
fn a_body_that_turned_more_than_once_says_how_far_and_which_way() {
    let told_at = |spin: f64, time: f64| {
        let text = format!(
            "shapes.blade = {{ kind = 'box', half_extents = [1, 0.1], angular_velocity_deg = {spin} }}
             shapes.wall = {{ kind = 'box', half_extents = [1, 1], position = [9, 0] }}
             query = {{ kind = 'time-of-impact', of = ['blade', 'wall'] }}
             panels = [{{ time = {time},
                layers = ['shapes', {{ layer = 'ghosts', of = 'blade', at = 'end' }}] }}]"
        );
        let scene = open_text("blade", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        labels(&draw(&plan, plan.theme, "blade"))["A'"].0.clone()
    };
    let told = |spin| told_at(spin, 0.0);
    // Since the start, whatever the panel shows.
    assert!(told_at(1845.0, 0.25).ends_with("turned $1845°$"), "{}", told_at(1845.0, 0.25));
    assert!(told(1845.0).ends_with("turned $1845°$"), "{}", told(1845.0));
    assert!(told(-360.44).ends_with("turned $-360.4°$"), "{}", told(-360.44));
    assert!(!told(-350.0).contains("turned"));
}
