//! The origin O: a dot in a ring. In configuration space it lies inside B ⊖ A exactly when the bodies
//! overlap.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Rank, Sketch};
use crate::geometry::DVec2;
use crate::trace::phrase;

use super::{Fed, LabelKey, Layer, Options, Shows, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "origin",
    in_words: phrase(["origin", "Ursprung", "origine", "origen"]),
    about: "the origin of the panel's space: ring, dot, letter O",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[],
    labels: &[LabelKey { key: "O", about: "the origin" }],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let role = options.role(Role::Ink);
    let origin = context.frame().map_or(DVec2::ZERO, |frame| frame.position);
    sketch.part("origin").marker(origin, Marker::Origin, role, MARKER);
    sketch.label(Label::new("O", "$O$", Anchor::point(origin), role).rank(Rank::Name));
}
