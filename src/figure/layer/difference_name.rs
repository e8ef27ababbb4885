//! What B ⊖ A is called, and where that stands.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::Difference;
use crate::figure::sketch::{Anchor, Label, Rank, Size, Sketch};
use crate::geometry::Side;

use super::Options;
use super::moment::at;

/// What B ⊖ A is called, as markup.
pub(super) fn called(context: &Context) -> String {
    if context.has_letters() {
        let [a, b] = Side::BOTH.map(|side| context.named(side).term());
        return format!(r"${b} \ominus {a}$");
    }
    format!(r"{} $\ominus$ {}", context.name(Side::B), context.name(Side::A))
}

/// Names the difference inside it, with its moment where that is not the panel's.
pub(super) fn name(
    sketch: &mut Sketch,
    context: &Context,
    options: &Options,
    (found, time): (&Difference, f64),
) {
    let moment = (time != context.difference_time()).then(|| at(context, time));
    let lines = std::iter::once(called(context)).chain(moment).collect();
    let anchor = Anchor::inside(&found.outline());
    let role = options.role(Role::Difference);
    // A part of its own, as the name must not lie on the vertices.
    let label = Label { lines, ..Label::new("difference", "", anchor, role) };
    sketch.part("name").label(label.rank(Rank::Name).size(Size::Name));
}
