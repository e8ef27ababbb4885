//! A circle may lie beside its body's origin: what is said of its centre stands there.

use crate::drawing::{Contour, Point};
use crate::figure::layer::tests::{paths, points};
use crate::figure::{Figure, draw, plan};
use crate::geometry::DVec2;
use crate::scene::open_text;

/// A circle about (0.5, 0) in the frame of a body at (1, 2) turned by 90°, with more of its keys.
fn drawn(keys: &str) -> Figure {
    let text = format!(
        "shapes.A = {{ kind = 'circle', radius = 1, center = [0.5, 0], position = [1, 2], angle_deg = 90
             {keys} }}
         shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [6, 2.5] }}
         query = {{ kind = 'time-of-impact', of = ['A', 'B'] }}
         panels = [{{ layers = [{{ layer = 'shapes', centers = true }}, 'velocity'] }}]"
    );
    let scene = open_text("centers", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    draw(&plan, plan.theme, "centers")
}

/// Whether a part has a place of its first path within a tenth of a pixel of a point of the world.
fn stands_at(figure: &Figure, part: &str, place: DVec2) -> bool {
    let at = figure.panels[0].frame.page(place);
    let near = |p: &Point| (*p - at).length() < 0.1;
    paths(&figure.drawing.items, part).iter().any(|path| match &path.contour {
        Contour::Circle { center, .. } => near(center),
        Contour::Segments(_) => points(path).iter().any(near),
    })
}

#[test]
fn the_mark_of_a_circle_is_at_its_centre() {
    let figure = drawn(", velocity = [3, 0]");
    assert!(stands_at(&figure, "center-A", DVec2::new(1.0, 2.5)));
}

#[test]
fn the_velocity_of_a_circle_that_goes_straight_starts_at_its_centre() {
    for (turning, from) in [("", 2.5), (", angular_velocity_deg = 20", 2.0)] {
        let figure = drawn(&format!(", velocity = [3, 0]{turning}"));
        assert!(stands_at(&figure, "velocity", DVec2::new(1.0, from)), "{turning}");
    }
}
