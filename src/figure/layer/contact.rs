//! The point where the bodies touch at the hit, or the segment, where edge meets edge.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Sketch};
use crate::figure::touching::{Touching, touching};
use crate::geometry::Side;
use crate::trace::phrase;

use super::{Fed, LabelKey, Layer, Options, Shows, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "contact",
    in_words: phrase(["contact", "Berührpunkt", "point de contact", "punto de contacto"]),
    about: "the point of first contact, or the segment where edge meets edge",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[],
    labels: &[LabelKey { key: "contact", about: "the point of first contact; without a text of its own" }],
    needs: "a hit",
    fed: |context, _| Fed::by_a_hit(context),
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let (Some((_, contact)), Some(bounds)) = (context.hit(), context.hit_time()) else { return };
    // At the last moment proved free the witness points are a rounding apart; the contact is between them.
    sketch.since(context.answered());
    let point = 0.5 * (contact.points[0] + contact.points[1]);
    let role = options.role(Role::Ink);
    let touch = match (context.body(Side::A), context.body(Side::B)) {
        (Some(a), Some(b)) => touching([a, b], bounds, &contact),
        _ => Touching::At(point),
    };
    sketch.part("contact");
    match touch {
        // Each point of the segment touches.
        Touching::Along([from, to]) => {
            sketch.line(from, to, Pen::highlighted(role));
            for end in [from, to] {
                sketch.marker(end, Marker::Disc, role, MARKER);
            }
        }
        Touching::At(_) => {
            sketch.marker(point, Marker::Disc, role, MARKER);
        }
        // An estimate within a tolerance that is seen is none of the bodies' points.
        Touching::Open => {
            sketch.marker(point, Marker::HollowDisc, role, MARKER);
        }
    }
    sketch.label(Label::new("contact", "", Anchor::point(point), role));
    // A body that is no larger than the marker is seen in an inset alone.
    for side in Side::BOTH {
        if let Some(outline) = context.outline(side, bounds.lo) {
            sketch.detail(&outline.sampled());
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn where_edge_meets_edge_all_of_what_touches_is_marked() {
        let marks = |degrees: f64| {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [8, 0],
                    angle_deg = {degrees} }}
                shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [6, 0.5] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
                panels = [{{ layers = ['contact'] }}]"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            let bounds = |path: &&crate::drawing::Path| path.contour.bounds();
            let all: Vec<_> = paths(&figure.drawing.items, "contact").iter().filter_map(bounds).collect();
            let high = all.iter().map(|b| b.y1).fold(f64::NEG_INFINITY, f64::max)
                - all.iter().map(|b| b.y0).fold(f64::INFINITY, f64::min);
            high / figure.panels[0].frame.scale
        };
        // From y = -0.5 to 1, and the markers at its ends; a corner touches at one.
        assert!((marks(0.0) - 1.5).abs() < 0.3, "{}", marks(0.0));
        assert!(marks(30.0) < 0.3, "{}", marks(30.0));
    }
}
