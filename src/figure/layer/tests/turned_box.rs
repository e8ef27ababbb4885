//! A box that is turned in its panel, whose own axes are not the panel's.

use crate::figure::layer::tests::labels_of;
use crate::figure::plan;

#[test]
fn clamped_components_of_a_turned_box_are_written_along_its_own_axes() {
    let text = "shapes.A = { kind = 'box', half_extents = [3, 2], angle_deg = 90 }
        shapes.B = { kind = 'circle', radius = 1, position = [-5, 6] }
        query = { kind = 'separation', of = ['A', 'B'], algorithm = 'clamp' }
        panels = [{ layers = [{ layer = 'clamp', values = true }] }]";
    let scene = crate::scene::open_text("s.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let panel = &plan.panels[0];
    let labels = labels_of(panel.sketch(&panel.context(&scene, &plan.runs), plan.theme), panel);
    let mut written: Vec<_> = labels.iter().map(|label| label.2.as_str()).collect();
    written.sort_unstable();
    // D = (-3, 3) in the world, of length 4.24; V = (-5, 6) there is 6 along the box's x axis, 5 along its y.
    let expected =
        ["$B_c$", "$V$", "$V_x = 6$", "$V_y = 5$", "$|D| = 4.24$", "clamped $V_x = 3$", "clamped $V_y = 2$"];
    assert_eq!(written, expected);
}
