//! What is drawn and written of a step of GJK.

use crate::figure::layer::tests::{labels, lines, paths};
use crate::figure::{draw, plan};
use crate::scene::open_text;

#[test]
fn of_rounded_bodies_the_cores_are_drawn_beyond_whose_vertices_none_is() {
    for (place, radius) in [("[1.6, 1.5]", 0.3), ("[2.6, 2.2]", 0.3), ("[2.6, 2.2]", 0.0)] {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-1, 0], [1, 0], [0, 0.8]], radius = {} }}
            shapes.B = {{ kind = 'box', half_extents = [0.6, 0.6], radius = {radius},
                position = {place}, angle_deg = 30 }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
            panels = [{{ space = 'configuration', layers = ['difference', 'simplex'] }}]",
            2.0 * radius
        );
        let scene = open_text("gjk", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "gjk");
        let (labels, scale) = (labels(&figure), figure.panels[0].frame.scale);
        assert_eq!(labels.contains_key("cores"), radius > 0.0, "{labels:?}");
        assert_eq!(labels["stop"].0.contains("cores"), radius > 0.0, "{labels:?}");
        assert_eq!(paths(&figure.drawing.items, "cores").len(), usize::from(radius > 0.0));
        if radius > 0.0 {
            let drawn = lines(&figure, "beyond").into_iter().fold(0.0, f64::max) / scale;
            assert!((drawn - 0.9).abs() < 1e-9 && labels["r"].0.ends_with("= 0.9$"), "{drawn} {labels:?}");
        }
    }
}

#[test]
fn each_step_encloses_the_distance_and_crosses_out_what_the_one_before_had_and_it_has_not() {
    // 5.2 is the distance of O from the line through (5, 2) and (2, 6).
    let dropped = [0, 1, 0, 1];
    for (step, dropped) in (1..).zip(dropped) {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-2, -3], [2, 0], [-3, 2]] }}
            shapes.B = {{ kind = 'polygon', vertices = [[7, 2], [8, 7], [4, 6]] }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
            panels = [{{ space = 'configuration',
                layers = [{{ layer = 'simplex', step = {step}, values = true }}] }}]"
        );
        let scene = open_text("gjk", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "gjk");
        let labels = labels(&figure);
        let most = labels["closest"].1;
        let least = labels.get("least").map(|least| least.1);
        assert!(most >= 5.2 && least.is_none_or(|least| least < 5.2), "{step}: {least:?} to {most}");
        assert_eq!((least.is_none(), labels.contains_key("stop")), (step == 4, step == 4));
        assert_eq!(labels.contains_key("dropped"), dropped > 0, "step {step}");
        assert_eq!(paths(&figure.drawing.items, "dropped").is_empty(), dropped == 0, "step {step}");
        // What it was dropped from: the page's colour and its own, without an outline.
        let before = paths(&figure.drawing.items, "before");
        assert_eq!(before.len(), if dropped > 0 { 2 } else { 0 }, "step {step}");
        assert!(before.iter().all(|p| p.fill.is_some() && p.stroke.is_none()), "step {step}");
        assert!(!lines(&figure, "supporting-line").is_empty());
    }
}

#[test]
fn what_the_last_step_has_nothing_to_write_for_is_told() {
    // Of bodies that overlap the origin lies in the last one.
    let told = |place: &str, options: &str| {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 1] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = {place}, angle_deg = 20 }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
            panels = [{{ space = 'configuration', layers = [{{ layer = 'simplex', {options} = true }}] }}]"
        );
        let scene = open_text("told", &text).unwrap().scene;
        plan(&scene).unwrap().warnings.iter().map(|note| note.fault.to_string()).collect::<String>()
    };
    let begin = |option: &str| format!("`{option}` of `simplex` draws nothing: ");
    for (place, no_values) in [("[1.5, 0.5]", "the origin lies in the simplex"), ("[5, 0]", "")] {
        let none = begin("coordinates") + "no vertex comes next at the last step";
        assert_eq!(told(place, "coordinates"), none);
        assert_eq!(told(place, "step = 1, coordinates"), "");
        assert_eq!(told(place, "numbers"), "");
        let none = if no_values.is_empty() { String::new() } else { begin("values") + no_values };
        assert_eq!(told(place, "values"), none);
    }
}
