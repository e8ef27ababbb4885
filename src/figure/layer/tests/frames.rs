//! In the panel of a body's frame, what is written of a point or a vector are its components there.

use crate::figure::layer::tests::labels_of;
use crate::figure::plan;

/// What the labels of a key say in a scene's first panel, in the order of drawing.
fn said(text: &str, key: &str) -> Vec<String> {
    let scene = crate::scene::open_text("frames", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let panel = &plan.panels[0];
    let labels = labels_of(panel.sketch(&panel.context(&scene, &plan.runs), plan.theme), panel);
    labels.into_iter().filter(|label| label.1 == key).map(|label| label.2).collect()
}

#[test]
fn a_velocity_has_the_components_of_the_frame_that_it_is_drawn_in() {
    for (space, keys, text) in [
        ("space = 'world'", "", "$v_B$ $= (3, 1)$"),
        ("space = 'body', frame = 'A'", "", "$v_B$ $= (1, -3)$"),
        ("space = 'body', frame = 'A'", ", velocity = [1, 0]", "$v_{B/A}$ $= (1, -2)$"),
    ] {
        let text_of = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 1], angle_deg = 90 {keys} }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [-9, 4], velocity = [3, 1] }}
            query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
            panels = [{{ {space}, time = 'start', layers = [{{ layer = 'velocity', values = true }}] }}]"
        );
        assert_eq!(said(&text_of, "v_B"), [text], "{space}{keys}");
    }
}

#[test]
fn an_axis_and_the_numbers_along_it_are_those_of_the_frame() {
    let all = |space: &str| {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 1], angle_deg = 90, position = [5, 7] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [9, 7] }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }}
            panels = [{{ {space}, layers = [{{ layer = 'projection', values = true }}] }}]"
        );
        ["axis", "end.A", "begin.B", "gap"].map(|key| said(&text, key).concat())
    };
    let [axis, ends @ .., gap] = all("space = 'body', frame = 'A'");
    assert!(axis.contains("n = (0, -1)"), "{axis}");
    assert_eq!((ends, gap.as_str()), (["$1$".to_owned(), "$3$".to_owned()], "gap $= 3 - 1 = 2$"));
    let [axis, ends @ .., gap] = all("space = 'world'");
    assert!(axis.contains("n = (1, 0)"), "{axis}");
    assert_eq!((ends, gap.as_str()), (["$6$".to_owned(), "$8$".to_owned()], "gap $= 8 - 6 = 2$"));
}

#[test]
fn the_corners_of_bounds_have_the_coordinates_of_the_frame() {
    for (angle, space, texts) in [
        (90, "space = 'world'", ["min $= (4, 1)$", "max $= (6, 5)$", r"$x_{\min} = 4$"]),
        (90, "space = 'body', frame = 'A'", ["min $= (-2, 1)$", "max $= (2, -1)$", r"$x_{\min}$"]),
        (0, "space = 'body', frame = 'A'", ["min $= (-2, -1)$", "max $= (2, 1)$", r"$x_{\min} = -2$"]),
    ] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 1], angle_deg = {angle}, position = [5, 3] }}
            query = {{ kind = 'bounds', of = ['A'] }}
            panels = [{{ {space}, layers = ['bounds'] }}]"
        );
        let written = ["min", "max", "touching.left"].map(|key| said(&text, key).concat());
        assert_eq!(written, texts, "{angle}, {space}");
    }
}

#[test]
fn from_a_centre_inside_the_box_d_goes_to_it_from_the_nearest_side() {
    // In the frame of the box, which is turned by 90° or 30°, the centre is at (1.5, 0), the side at x = 2.
    for (angle, place) in [(90, "[1, 2.5]"), (30, "[2.299038105676658, 1.75]")] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 1], angle_deg = {angle}, position = [1, 1] }}
            shapes.B = {{ kind = 'circle', radius = 0.4, position = {place} }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'clamp' }}
            panels = [{{ space = 'body', frame = 'A', layers = [{{ layer = 'clamp', values = true }}] }}]"
        );
        assert_eq!(said(&text, "D"), ["$D = (-0.5, 0)$"], "{angle}");
    }
}
