//! What B ⊖ A is called, and where that stands.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::Difference;
use crate::figure::sketch::{Anchor, Label, Rank, Size, Sketch};
use crate::geometry::Side;

use super::Options;

/// What B ⊖ A is called, as markup.
pub(super) fn called(context: &Context) -> String {
    if context.has_letters() {
        let [a, b] = Side::BOTH.map(|side| context.named(side).term());
        return format!(r"${b} \ominus {a}$");
    }
    format!(r"{} $\ominus$ {}", context.name(Side::B), context.name(Side::A))
}

/// Names the difference inside it.
pub(super) fn name(sketch: &mut Sketch, context: &Context, options: &Options, found: &Difference) {
    let text = called(context);
    let anchor = Anchor::inside(&found.outline());
    let role = options.role(Role::Difference);
    // A part of its own, as the name must not lie on the vertices.
    sketch.part("name").label(Label::new("difference", text, anchor, role).rank(Rank::Name).size(Size::Name));
}
