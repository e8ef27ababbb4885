//! Where several answers are as good, a layer shows the one that the sentence tells.

use crate::figure::layer::tests::{labels, lines};
use crate::figure::{draw, plan};
use crate::scene::open_text;
use crate::trace::story;

#[test]
fn of_axes_that_tie_the_projection_is_onto_the_one_that_the_sentence_names() {
    for (position, n) in [("[0, 0]", "(0, -1)"), ("[0, 0.1]", "(0, 1)"), ("[0, -0.1]", "(0, -1)")] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 1.5] }}
             shapes.B = {{ kind = 'box', half_extents = [0.5, 0.5], angle_deg = 45, position = {position} }}
             query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }}
             panels = [{{ layers = ['shapes', {{ layer = 'projection', values = true }}] }}]"
        );
        let scene = open_text("ties", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "ties");
        let said = format!("along {}", n.replace('-', "−"));
        assert!(figure.drawing.desc.contains(&said), "{position}: {}", figure.drawing.desc);
        assert_eq!(labels(&figure)["axis"].0, format!("$n = {n}$"), "{position}");
    }
}

#[test]
fn no_label_has_a_number_that_rounding_made() {
    // 0.1 + 0.2 is not 0.3, as numbers are written; along x and by the circle's radius.
    let boxes = "shapes.A = { kind = 'aabb', half_extents = [0.1, 0.1] }
        shapes.B = { kind = 'aabb', half_extents = [0.2, 0.2], position = [0.3, 0.05] }";
    let round = "shapes.A = { kind = 'aabb', half_extents = [0.1, 0.1] }
        shapes.B = { kind = 'circle', radius = 0.2, position = [0.3, 0.05] }";
    let circles = "shapes.A = { kind = 'circle', radius = 1 }
        shapes.B = { kind = 'circle', radius = 0.5, position = [1.2, 0.9] }";
    let polygons = ["closest-features", "extents", "merge", "minkowski", "separating-axes", "gjk"];
    let all = polygons.iter().map(|by| (boxes, *by)).chain([(round, "clamp"), (circles, "circles")]);
    let mut wrong = Vec::new();
    for (bodies, by) in all {
        let text =
            format!("{bodies}\nquery = {{ kind = 'separation', of = ['A', 'B'], algorithm = '{by}' }}");
        let scene = open_text("rounding", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let labels = labels(&draw(&plan, plan.theme, "rounding"));
        wrong
            .extend(labels.into_iter().filter(|label| label.1.0.contains("10^{-1")).map(|label| (by, label)));
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn of_opposite_edges_with_one_gap_the_normal_stands_on_the_one_that_the_trace_names() {
    let text = "shapes.A = { kind = 'regular-polygon', edges = 3, circumradius = 1 }
         shapes.B = { kind = 'box', half_extents = [0.7, 0.4], position = [1.6, 0.2], angle_deg = 30 }
         query = { kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }
         panels = [{ layers = ['shapes', 'projection'] }]";
    let scene = open_text("ties", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let told = story(&plan.own_run().trace, &scene.names());
    assert!(told.contains("The largest gap is the distance: 0.285641, by edge 1 of A."), "{told}");
    let figure = draw(&plan, plan.theme, "ties");
    // An edge of the triangle is √3 long, those of the box 1.4 and 0.8.
    let long = lines(&figure, "edge")[0] / figure.panels[0].frame.scale;
    assert!((long - 3.0_f64.sqrt()).abs() < 0.01, "{long}");
}
