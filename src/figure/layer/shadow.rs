//! What casts the shadows of bodies on an axis: the points whose shadows are an interval's ends, and what of
//! the lines from there to the axis another body hides.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Outline, Pen, Sketch, Wash, Weight};
use crate::geometry::{DVec2, Side};

use super::half_extents::GUIDE;

/// Opacity of the strip of light between the bodies.
const LIT: f64 = 0.11;

/// Draws the strip between A's upper end and B's lower one, from a depth below the axis to one above it: of
/// light, or where B begins before A ends, of what lies in both shadows.
pub(super) fn lit(
    sketch: &mut Sketch,
    [end, begin]: [f64; 2],
    [low, top]: [f64; 2],
    at: impl Fn(f64, f64) -> DVec2,
) {
    let strip = [(end, low), (begin, low), (begin, top), (end, top)].map(|(along, depth)| at(along, depth));
    let wash =
        if end < begin { Wash::faint(Role::Translation, LIT) } else { Wash::faint(Role::Overlap, 1.0) };
    sketch.part("lit").weight(Weight::Light).area(&Outline::polygon(&strip), Some(wash), None);
}

/// Draws the line from the point that casts an end of a shadow along n down to a depth, where the other body
/// does not hide it.
pub(super) fn guide(
    sketch: &mut Sketch,
    (context, other): (&Context, Side),
    points: &[DVec2],
    (n, end): (DVec2, f64),
    (down, depth): (DVec2, f64),
) {
    let Some(from) = casting(points, n, end, down) else { return };
    let across = hidden_by(context, other, n, end, down);
    sketch.part("shadows").weight(Weight::Light);
    for ends in seen([from.dot(down), depth], across) {
        let [p, q] = ends.map(|depth| n * end + down * depth);
        sketch.line(p, q, Pen::extension().opacity(GUIDE));
    }
}

/// How far against `down` the points reach.
pub(super) fn highest(points: &[DVec2], down: DVec2) -> f64 {
    points.iter().map(|p| -p.dot(down)).fold(f64::NEG_INFINITY, f64::max)
}

/// The point of the bodies whose shadow is nearest to the end of an interval; of several the one nearest to
/// the axis.
fn casting(points: &[DVec2], n: DVec2, end: f64, down: DVec2) -> Option<DVec2> {
    let off = |p: DVec2| (p.dot(n) - end).abs();
    points
        .iter()
        .copied()
        .min_by(|p, q| off(*p).total_cmp(&off(*q)).then(q.dot(down).total_cmp(&p.dot(down))))
}

/// From where to where along `down` a body hides the line of all points whose shadow is at `end`; `None`
/// where that line misses it.
fn hidden_by(context: &Context, side: Side, n: DVec2, end: f64, down: DVec2) -> Option<[f64; 2]> {
    let points = context.outline(side, context.time)?.sampled();
    let off = |p: DVec2| p.dot(n) - end;
    let next = points.iter().skip(1).chain(points.first());
    let crossings = points.iter().zip(next).filter(|(p, q)| (off(**p) < 0.0) != (off(**q) < 0.0));
    let depths = crossings.map(|(&p, &q)| (p + (q - p) * (off(p) / (off(p) - off(q)))).dot(down));
    depths.map(|depth| [depth; 2]).reduce(|[lo, hi], [least, most]| [lo.min(least), hi.max(most)])
}

/// The parts of a line, from the less to the more along it, that nothing hides.
fn seen([from, to]: [f64; 2], hidden: Option<[f64; 2]>) -> impl Iterator<Item = [f64; 2]> {
    let [lo, hi] = hidden.unwrap_or([to; 2]);
    [[from, lo.min(to)], [hi.max(from), to]].into_iter().filter(|[p, q]| p < q)
}
