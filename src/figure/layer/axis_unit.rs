//! What the numbers along an axis are counted in: the unit vector n on it, from its 0, which lies below the
//! origin of the world.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Size, Sketch, Weight};
use crate::figure::text::number;
use crate::geometry::DVec2;

use super::half_extents::beside;
use super::normal::unit_length;

/// Half the length of the mark of 0 on the axis, page pixels: past both intervals.
const ZERO: f64 = 11.0;

/// Half the length of the mark of each unit on the axis, page pixels: between both intervals.
const UNIT: f64 = 3.0;

/// The least that a unit is long for each to be marked, page pixels: marks that are nearer are a hatch.
const LEAST: f64 = 12.0;

/// The axis with its components, in LaTeX.
pub(super) fn written(n: DVec2) -> String {
    format!("n = ({}, {})", number(n.x), number(n.y))
}

/// Draws n on the axis from its 0, where numbers are counted in its lengths.
pub(super) fn on_axis(sketch: &mut Sketch, n: DVec2, at: impl Fn(f64, f64) -> DVec2) {
    let length = unit_length(sketch);
    let to_scale = if length == 1.0 { "" } else { " (not to scale)" };
    let (from, tip) = (at(0.0, 0.0), at(length, 0.0));
    sketch.part("normal").arrow(from, tip, Pen::vector(Role::Ink));
    sketch.right_angle(from, at(0.0, -1.0) - from, -n);
    let label = Label::new("axis", format!("${}${to_scale}", written(n)), beside(from, tip, n), Role::Ink);
    sketch.label(label.rank(Rank::Measure));
}

/// Units from 0 within which they are marked: a panel is at most some thousands of page pixels wide, and a
/// unit is longer than [`LEAST`].
const FARTHEST: f64 = 1e4;

/// Marks each unit on the axis between two places, counted from 0, where they can be told apart.
pub(super) fn units(sketch: &mut Sketch, (first, last): (f64, f64), at: impl Fn(f64, f64) -> DVec2) {
    if sketch.on_page(1.0) < LEAST {
        return;
    }
    let half = sketch.px(UNIT);
    // Far beyond the panel nothing is marked: from 2⁵³ on k + 1 would be k, and there would be no end.
    let (first, last) = (first.max(-FARTHEST), last.min(FARTHEST));
    let each = std::iter::successors(Some(first.ceil()), |k| Some(k + 1.0)).take_while(|k| *k < last);
    let marks: Vec<_> = each.map(|k| (sketch.page(at(k, -half)), sketch.page(at(k, half)))).collect();
    sketch.part("units").quiet_lines(&marks, Pen::dimension(Role::Muted));
}

/// Whether a place of the world is in the panel's view.
pub(super) fn sees(sketch: &Sketch, context: &Context, place: DVec2) -> bool {
    let (lo, hi) = sketch.visible();
    let place = context.in_space(place);
    lo.cmple(place).all() && hi.cmpge(place).all()
}

/// Marks on the axis from where its numbers are counted, below the origin, if that is in reach.
pub(super) fn zero(
    sketch: &mut Sketch,
    context: &Context,
    (first, last): (f64, f64),
    (down, far): (DVec2, f64),
    at: impl Fn(f64, f64) -> DVec2,
) {
    if !(first..=last).contains(&0.0) {
        return;
    }
    let tick = sketch.px(ZERO);
    if far > 0.0 && sees(sketch, context, DVec2::ZERO) {
        // Dashed, as it is no body's.
        sketch.part("shadow-of-origin").weight(Weight::Light);
        sketch.line(DVec2::ZERO, at(0.0, -tick), Pen::construction());
    }
    sketch.part("zero").line(at(0.0, -tick), at(0.0, tick), Pen::dimension(Role::Ink).width(1.5));
    let label = Label::new("zero", "$0$", Anchor::point_toward(at(0.0, tick), down), Role::Ink);
    sketch.label(label.rank(Rank::Measure).size(Size::Note));
}
