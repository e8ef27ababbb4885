//! The point where the bodies touch at the hit.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Sketch};
use crate::figure::touching::{Touching, touching};
use crate::geometry::Side;
use crate::trace::phrase;

use super::{Fed, LabelKey, Layer, Options, Shows, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "contact",
    in_words: phrase(["contact", "Berührpunkt", "point de contact", "punto de contacto"]),
    about: "the point of first contact",
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
    let open = match (context.body(Side::A), context.body(Side::B)) {
        (Some(a), Some(b)) => touching([a, b], bounds, &contact) == Touching::Open,
        _ => false,
    };
    // An estimate within a tolerance that is seen is none of the bodies' points.
    let marker = if open { Marker::HollowDisc } else { Marker::Disc };
    sketch.part("contact").marker(point, marker, role, MARKER);
    sketch.label(Label::new("contact", "", Anchor::point(point), role));
    // A body that is no larger than the marker is seen in an inset alone.
    for side in Side::BOTH {
        if let Some(outline) = context.outline(side, bounds.lo) {
            sketch.detail(&outline.sampled());
        }
    }
}
