//! B ⊖ A where no algorithm builds it: what is there though GJK and EPA ask for its vertices one by one.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::{Difference, Edge};
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Sketch, Wash, Weight};

use super::Options;
use super::difference_name::{called, name};
use super::half_extents::ON_LINE;

/// Width, page pixels, and opacity of the outline of a difference that nobody has built, and the opacity of
/// its area: seen, and less than anything that is known of it.
const UNBUILT: [f64; 3] = [1.5, 0.6, 0.07];

/// Draws its outline faintly, and its name: in its faint area, or, where it has none as what is drawn in
/// there is something else, outside of its longest edge.
pub(super) fn unbuilt(
    sketch: &mut Sketch,
    context: &Context,
    options: &Options,
    (found, time): (&Difference, f64),
) {
    let role = options.role(Role::Difference);
    let pen = Pen::outline(role).width(UNBUILT[0]).opacity(UNBUILT[1]);
    sketch.part("difference").weight(Weight::Light);
    let wash = options.flag("fill", true).then(|| Wash::faint(role, UNBUILT[2]));
    sketch.area(&found.outline(), wash, Some(pen));
    let length = |edge: &Edge| edge.from.distance(edge.to);
    let longest = found.edges.iter().max_by(|e, f| length(e).total_cmp(&length(f)));
    let Some((from, to)) = longest.filter(|_| wash.is_none()).map(|edge| found.drawn(edge)) else {
        name(sketch, context, options, (found, time));
        return;
    };
    let anchor = Anchor::Beside { from: to, to: from, offset: ON_LINE };
    let label = Label::new("difference", called(context), anchor, role);
    sketch.part("name").label(label.rank(Rank::Name));
}
