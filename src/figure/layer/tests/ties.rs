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
