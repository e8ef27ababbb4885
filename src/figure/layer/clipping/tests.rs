//! What is drawn of a contact that was clipped.

use crate::collision::Answer;
use crate::figure::layer::tests::{labels, lines, paths};
use crate::figure::{Figure, draw, plan};
use crate::scene::{open_text, solve};

/// Two bodies whose contact is clipped, B at a place, rounded by a radius.
fn clipped(place: &str, radius: f64) -> (Figure, Vec<f64>) {
    let text = format!(
        "shapes.A = {{ kind = 'polygon', vertices = [[-2.5, -3], [2, -4], [3, 0], [-3, 2.5]] }}
        shapes.B = {{ kind = 'box', half_extents = [2, 1], radius = {radius}, position = {place},
            angle_deg = -20 }}
        query = {{ kind = 'contact', of = ['A', 'B'] }}
        panels = [{{ layers = ['shapes', 'clipping'] }}]"
    );
    let scene = open_text("clip", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let Answer::Contact(contact) = solve(&scene) else { panic!("a contact") };
    (draw(&plan, plan.theme, "clip"), contact.found().map(|point| -point.separation).collect())
}

#[test]
fn each_depth_is_written_drawn_and_answered_alike() {
    for (place, radius, contacts) in
        [("[1, 1.5]", 0.0, 2), ("[2, 1]", 0.25, 2), ("[1.5, 1.5]", 0.5, 2), ("[4.5, -2]", 0.0, 1)]
    {
        let (figure, depths) = clipped(place, radius);
        let drawn = lines(&figure, "depth");
        let markers = paths(&figure.drawing.items, "contact-point").len();
        assert_eq!((depths.len(), markers), (contacts, contacts), "{place}");
        let square = paths(&figure.drawing.items, "right-angle").len();
        assert!(square == depths.iter().filter(|d| *d * figure.panels[0].frame.scale > 20.0).count());
        let labels = labels(&figure);
        for (k, (depth, key)) in depths.iter().zip(["d_1", "d_2"]).enumerate() {
            // A bar is a line and two ticks.
            let length = drawn[3 * k] / figure.panels[0].frame.scale;
            assert!((length - depth).abs() < 1e-9, "{place}: {length} is not {depth}");
            assert!((labels[key].1 - depth).abs() < 0.006, "{place}: {:?} is not {depth}", labels[key]);
        }
        let named = ["c_1", "c_2"].map(|key| labels.get(key).map(|label| label.0.clone()));
        let wanted = [Some("contact 1".to_owned()), (contacts == 2).then(|| "contact 2".to_owned())];
        assert_eq!(named, wanted, "{place}");
    }
}

#[test]
fn the_edges_face_each_other_before_they_are_cut_at_two_planes() {
    for (show, [planes, normals]) in [
        ("[]", [0, 0]),
        ("['edges', 'cut']", [0, 0]),
        ("['edges', 'depths']", [0, 0]),
        ("['edges', 'planes']", [2, 1]),
    ] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-2.5, -3], [2, -4], [3, 0], [-3, 2.5]] }}
            shapes.B = {{ kind = 'box', half_extents = [2, 1], position = [1, 1.5], angle_deg = -20 }}
            query = {{ kind = 'contact', of = ['A', 'B'] }}
            panels = [{{ layers = ['shapes', {{ layer = 'clipping', show = {show} }}] }}]"
        );
        let scene = open_text("clip", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "clip");
        // A shaft and its head.
        let arrows =
            ["incident-normal", "reference-normal"].map(|p| paths(&figure.drawing.items, p).len() / 2);
        assert_eq!(arrows, [normals; 2], "{show}");
        assert_eq!(paths(&figure.drawing.items, "plane").len(), planes, "{show}");
    }
}

#[test]
fn a_circle_touches_at_one_point_and_nothing_is_clipped() {
    let text = "shapes.ball = { kind = 'circle', radius = 1, position = [1, 1.75] }
        shapes.ground = { kind = 'box', half_extents = [4, 1] }
        query = { kind = 'contact', of = ['ball', 'ground'] }
        panels = [{ layers = ['shapes', 'clipping'] }]";
    let scene = open_text("ball", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "ball");
    let Answer::Contact(contact) = solve(&scene) else { panic!("a contact") };
    assert_eq!((contact.reference, contact.found().count()), (None, 1));
    assert_eq!(labels(&figure)["d_1"].1, 0.25);
    assert!(paths(&figure.drawing.items, "reference").is_empty() && plan.warnings.is_empty());
}

#[test]
fn bodies_apart_leave_nothing_to_clip_and_the_figure_says_why() {
    let (figure, depths) = clipped("[1, 6]", 0.0);
    assert!(depths.is_empty() && paths(&figure.drawing.items, "reference").is_empty());
    assert!(figure.warnings.iter().any(|w| w.fault.to_string().contains("apart")), "{:?}", figure.warnings);
}

#[test]
fn parts_that_are_asked_for_and_are_not_there_are_told() {
    let told = |b: &str, show: &str| {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [3, 0.5] }}
            shapes.B = {{ {b} }}
            query = {{ kind = 'contact', of = ['A', 'B'] }}
            panels = [{{ layers = ['shapes', {{ layer = 'clipping', show = {show} }}] }}]"
        );
        let scene = open_text("parts", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawn = paths(&draw(&plan, plan.theme, "parts").drawing.items, "depth").len();
        let notes = plan.warnings.iter().map(|note| note.fault.to_string()).collect::<Vec<_>>().join("; ");
        (notes, drawn > 0)
    };
    let circle = "kind = 'circle', radius = 1, position = [0, 1.25]";
    let why = "draws nothing: the bodies touch at one point, and no edge is clipped";
    assert_eq!(told(circle, "['edges', 'cut']"), (format!("`clipping` {why}"), false));
    assert_eq!(told(circle, "['depths', 'edges']"), (format!("`edges` of `clipping` {why}"), true));
    assert_eq!(told(circle, "['depths']"), (String::new(), true));
    let on_top = "kind = 'box', half_extents = [1, 1], position = [0, 1.25]";
    let why = "`cut` of `clipping` draws nothing: no plane cuts anything off";
    assert_eq!(told(on_top, "['edges', 'cut', 'depths']"), (why.to_owned(), true));
    let over = "kind = 'box', half_extents = [1, 1], position = [3, 1.25]";
    assert_eq!(told(over, "['edges', 'cut', 'depths']"), (String::new(), true));
}
