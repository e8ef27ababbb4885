//! Places as text: coordinates as fine as the bodies of a scene are large.

use crate::geometry::Body;
use crate::scene::Scene;
use crate::trace::place;

use super::number::{in_math, rounded};

/// The part of the largest body that a unit of a coordinate's last digit may be: half of it is a 200th, a
/// page pixel or two.
const OF_LARGEST: f64 = 1e-2;
/// The part of the smallest body: a place that is off by a 20th of it is still seen to be its own.
const OF_SMALLEST: f64 = 1e-1;

/// The part of a unit of the last digit below which a coordinate is rounding, and 0.
const NOTHING: f64 = 1e-9;

/// How finely the places of a scene are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Places {
    /// The unit of the last digit at most, world units; infinite where no body has a size.
    pub(crate) unit: f64,
}

impl Places {
    /// Places of any size, written as other numbers are.
    #[cfg(test)]
    pub(crate) const ANY: Self = Self { unit: f64::INFINITY };

    /// How finely places are written beside the bodies that a scene asks about.
    pub(crate) fn of(scene: &Scene) -> Self {
        let query = scene.query_of_bodies();
        let sizes = [Some(query.a), query.b].into_iter().flatten().map(extent).filter(|&size| size > 0.0);
        let (least, most) =
            sizes.fold((f64::INFINITY, 0.0_f64), |(least, most), size| (least.min(size), most.max(size)));
        let unit = (OF_SMALLEST * least).min(OF_LARGEST * most);
        Self { unit: if least.is_finite() { unit } else { f64::INFINITY } }
    }

    /// A coordinate, with a hyphen for a minus.
    pub(crate) fn written(self, x: f64) -> String {
        // Far below the last digit is what rounding left of a 0.
        let x = if self.unit.is_finite() && x.abs() < NOTHING * self.unit { 0.0 } else { x };
        place(x, rounded(x, x), self.unit)
    }

    /// A coordinate as LaTeX.
    pub(crate) fn latex(self, x: f64) -> String {
        in_math(&self.written(x))
    }
}

/// The larger side of a body's bounding box, as its own frame has it, world units.
fn extent(body: &Body) -> f64 {
    let vertices = &body.shape.vertices;
    let sides = |pick: fn(&crate::geometry::DVec2) -> f64| {
        let (least, most) = vertices
            .iter()
            .map(pick)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
        (most - least).max(0.0)
    };
    sides(|v| v.x).max(sides(|v| v.y)) + 2.0 * body.shape.radius
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    use super::Places;

    /// The unit of places beside these bodies.
    fn unit(shapes: &str) -> f64 {
        let scene = open_text("s", &format!("{shapes}\nquery = {{ kind = 'separation', of = ['A', 'B'] }}"));
        Places::of(&scene.unwrap().scene).unit
    }

    #[test]
    fn a_place_is_as_fine_as_the_larger_body_is_seen_and_the_smaller_is_found() {
        let planet = "shapes.A = { kind = 'circle', radius = 6371 }";
        let crate_ = "shapes.B = { kind = 'box', half_extents = [0.5, 0.25], position = [0, 6372] }";
        assert_eq!(unit(&format!("{planet}\n{crate_}")), 0.1);
        let point = |name| format!("shapes.{name} = {{ kind = 'circle', radius = 0 }}");
        assert_eq!(unit(&format!("{}\n{crate_}", point("A"))), 0.01);
        assert_eq!(unit(&format!("{}\n{}", point("A"), point("B"))), f64::INFINITY);
    }

    #[test]
    fn what_rounding_left_of_a_coordinate_is_0() {
        let disc = |name| format!("shapes.{name} = {{ kind = 'circle', radius = 1 }}");
        let text =
            format!("{}\n{}\nquery = {{ kind = 'separation', of = ['A', 'B'] }}", disc("A"), disc("B"));
        let places = Places::of(&open_text("s", &text).unwrap().scene);
        assert_eq!([-4.33e-15, 4.33e-5].map(|x| places.written(x)), ["0", "4.33e-5"]);
        assert_eq!(Places::ANY.written(-4.33e-15), "-4.33e-15");
    }

    #[test]
    fn far_from_the_origin_a_box_is_told_where_it_is() {
        let text = "caption = 'From {=min.x} to {=max.x}.'
            shapes.A = { kind = 'polygon', vertices = [[0, 0], [2.5, -0.5], [1, 1.5]], position = [1e6, 2e6] }
            query = { kind = 'bounds', of = ['A'] }
            panels = [{ layers = ['shapes', 'bounds'] }]";
        let scene = open_text("s", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawn = draw(&plan, plan.theme, "s");
        assert_eq!(plan.caption.words.as_deref(), Some("From 1000000 to 1000002.5."));
        let box_ = "(1000000, 1999999.5) to (1000002.5, 2000001.5)";
        assert!(drawn.drawing.desc.contains(box_), "{}", drawn.drawing.desc);
        let labels = drawn.panels[0].placed.iter().flat_map(|placed| &placed.lines);
        let labels: Vec<&str> = labels.map(|(_, line)| line.markup.as_str()).collect();
        for label in [
            r"$x_{\min} = 1000000$",
            r"$y_{\min} = 1999999.5$",
            r"$x_{\max} = 1000002.5$",
            "max $= (1000002.5, 2000001.5)$",
        ] {
            assert!(labels.contains(&label), "{label}: {labels:?}");
        }
    }
}
