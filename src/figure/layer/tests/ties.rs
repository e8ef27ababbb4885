//! Where several answers are as good, a layer shows the one that the sentence tells.

use crate::figure::layer::tests::labels;
use crate::figure::{draw, plan};
use crate::scene::open_text;

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
