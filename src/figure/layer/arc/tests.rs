//! What is drawn of the arc of a body's farthest point.

use crate::figure::layer::tests::paths;
use crate::figure::{draw, draw_in_steps, plan};
use crate::geometry::DVec2;
use crate::scene::open_text;

#[test]
fn the_circle_of_the_farthest_point_has_the_whole_body_in_it() {
    for (spin, drawn) in [(60, true), (-60, true), (360, false)] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-1, -1], [3, -1], [3, 4], [-1, 2]],
                angular_velocity_deg = {spin} }}
            query = {{ kind = 'motion-bound', of = ['A'] }}
            panels = [{{ view = [-6, -6, 6, 6], layers = [{{ layer = 'arc', around = true }}] }}]"
        );
        let scene = open_text("arc", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "arc");
        let circle = paths(&figure.drawing.items, "way-around");
        assert_eq!(!circle.is_empty(), drawn, "{spin}: what its own arc has gone over is there already");
        if let Some(bounds) = circle.first().and_then(|path| path.contour.bounds()) {
            // (3, 4) is 5 out, and most of the circle is left.
            let frame = &figure.panels[0].frame;
            let px = (frame.page(DVec2::X) - frame.page(DVec2::ZERO)).length();
            assert!((bounds.width() / px - 10.0).abs() < 0.7, "{}", bounds.width() / px);
        }
    }
}

#[test]
fn every_straightened_arc_of_a_fan_ends_on_one_line_whose_slope_is_the_angle() {
    for (inner, rungs) in [("", 4), (", inner = [1.5, 2]", 3), (", inner = [0.6, 0.8]", 4)] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-1, -1], [3, -1], [3, 4], [-1, 2]],
                angular_velocity_rad = 0.75 }}
            query = {{ kind = 'motion-bound', of = ['A'] }}
            panels = [{{ view = [-1, -2, 6, 5],
                layers = [{{ layer = 'arc', unrolled = true, fan = true{inner} }}] }}]"
        );
        let scene = open_text("fan", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "fan");
        let frame = &figure.panels[0].frame;
        let fan = paths(&figure.drawing.items, "fan");
        assert_eq!(fan.len(), rungs, "{inner}: that of q is drawn anyway");
        for bounds in fan.iter().map(|path| path.contour.bounds().unwrap()) {
            let radius = (bounds.x0 - frame.page(DVec2::ZERO).x) / frame.scale;
            assert!((bounds.height() / frame.scale - 0.75 * radius).abs() < 1e-6, "{radius}");
        }
    }
}

#[test]
fn a_bound_comes_in_steps_from_the_farthest_point_to_the_answer() {
    let steps = |query: &str| {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-1, -0.5], [2.5, -0.7], [1.5, 1.2]],
                angular_velocity_deg = 80, velocity = [1, 2] }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [6, 2], velocity = [-2, 0] }}
            query = {{ kind = 'motion-bound', of = {query} }}"
        );
        let scene = open_text("bound", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let steps = draw_in_steps(&plan, plan.theme, "bound").drawing.steps;
        (steps[0].sentences[0].clone(), steps[1..].iter().map(|s| s.sentences.join(" ")).collect::<Vec<_>>())
    };
    let (asked, told) = steps("['A']");
    assert_eq!(asked, "How far can a point of A move?");
    let starts = [
        "Farthest from the origin of A",
        "A turns by",
        "Turning moves no point of A farther than L = θ r = 3.62492",
    ];
    assert!(
        told.len() == 3 && told.iter().zip(starts).all(|(told, start)| told.starts_with(start)),
        "{told:?}"
    );
    assert!(told[2].contains("travels farther than 5.86"), "{told:?}");
    let (asked, told) = steps("['A', 'B']");
    assert_eq!(asked, "By how much can points of A and B come nearer to each other?");
    assert!(told.last().unwrap().contains("come nearer to each other by more than 7.2"), "{told:?}");
}

#[test]
fn what_lies_farthest_of_a_body_with_a_radius_is_no_vertex() {
    let text = "shapes.A = { kind = 'capsule', points = [[-1, 0], [1.2, 0.3]], radius = 0.4,
            angular_velocity_deg = 70 }
        shapes.B = { kind = 'circle', center = [0.5, 0], radius = 0.3, position = [4, 1],
            angular_velocity_deg = 45 }
        query = { kind = 'motion-bound', of = ['A', 'B'] }";
    let scene = open_text("bound", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let steps = draw_in_steps(&plan, plan.theme, "bound").drawing.steps;
    let said: String = steps.iter().flat_map(|step| step.sentences.clone()).collect();
    assert!(said.contains("at r = 1.63693: the rounding of vertex 1 at"), "{said}");
    assert!(said.contains("at r = 0.8: the outline around the centre at"), "{said}");
}

#[test]
fn the_bound_of_a_body_that_does_not_turn_is_a_step() {
    let text = "shapes.A = { kind = 'box', half_extents = [0.7, 0.3], velocity = [2, 1] }
        query = { kind = 'motion-bound', of = ['A'] }";
    let scene = open_text("bound", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let steps = draw_in_steps(&plan, plan.theme, "bound").drawing.steps;
    let [_, last] = &steps[..] else { panic!("{steps:?}") };
    assert_eq!(last.sentences.join(" "), "A does not turn. No point of A travels farther than 2.24.");
}
