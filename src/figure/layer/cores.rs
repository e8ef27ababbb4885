//! The difference of the cores of rounded bodies, which is all that GJK and EPA look at: B ⊖ A is that,
//! grown by both radii.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::Edge;
use crate::figure::sketch::{Anchor, Label, Outline, Pen, Rank, Size, Sketch, Weight};
use crate::geometry::{DVec2, Side};

use super::difference::difference;

/// Width, page pixels, and opacity of the outline of the cores' difference: seen on the fill of B ⊖ A, and
/// less than the simplex.
const CORE: (f64, f64) = (1.25, 0.8);

/// The sum of the bodies' radii, world units.
pub(super) fn radii(context: &Context) -> f64 {
    Side::BOTH.iter().filter_map(|side| context.body(*side)).map(|body| body.shape.radius).sum()
}

/// Draws the difference of the cores, in which the search goes, where the bodies are rounded.
pub(super) fn cores(sketch: &mut Sketch, context: &Context) {
    let (radius, time) = (radii(context), context.difference_time());
    let Some(found) = difference(context, time).filter(|_| radius > 0.0) else { return };
    let core: Vec<DVec2> = found.edges.iter().map(|edge| edge.from).collect();
    if core.len() > 1 {
        sketch.since(context.difference_at(time).and_then(|run| run.whole_difference()));
        let outline = Outline::polygon(&core);
        let pen = Pen::outline(Role::Difference).width(CORE.0).opacity(CORE.1);
        sketch.part("cores").weight(Weight::Light).area(&outline, None, Some(pen));
        // On the far side, where the search leaves room.
        let far = |edge: &&Edge| (edge.from + edge.to).length_squared();
        let edge = found.edges.iter().max_by(|e, f| far(e).total_cmp(&far(f)));
        let (from, to) = edge.map_or((DVec2::ZERO, DVec2::ZERO), |edge| (edge.from, edge.to));
        let anchor = Anchor::middle(from, to);
        let label = Label::new("cores", "without radii", anchor, Role::Difference);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// The sum of the bodies' radii in LaTeX, as `r_1 + r_2`; a body without one is no part of it.
pub(super) fn radii_in_words(context: &Context) -> String {
    let round = |side: &&Side| context.body(**side).is_some_and(|body| body.shape.radius > 0.0);
    let terms = Side::BOTH.iter().filter(round).map(|side| context.numbered("r", *side));
    terms.collect::<Vec<_>>().join(" + ")
}

/// What leads from the difference of two vertices to the boundary of a round B ⊖ A, in LaTeX, as ` - r_1 n`;
/// empty without radii.
pub(super) fn less_radii(context: &Context) -> String {
    match radii_in_words(context) {
        radii if radii.is_empty() => radii,
        radii if radii.contains('+') => format!(r" - ({radii})\,n"),
        radii => format!(r" - {radii}\,n"),
    }
}
