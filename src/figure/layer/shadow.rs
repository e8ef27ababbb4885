//! What casts the shadows of bodies on an axis: the points whose shadows are an interval's ends, and what of
//! the lines from there to the axis another body hides.

use crate::figure::context::Context;
use crate::geometry::{DVec2, Side};

/// The point of the bodies whose shadow is nearest to the end of an interval; of several the one nearest to
/// the axis.
pub(super) fn casting(points: &[DVec2], n: DVec2, end: f64, down: DVec2) -> Option<DVec2> {
    let off = |p: DVec2| (p.dot(n) - end).abs();
    points
        .iter()
        .copied()
        .min_by(|p, q| off(*p).total_cmp(&off(*q)).then(q.dot(down).total_cmp(&p.dot(down))))
}

/// From where to where along `down` a body hides the line of all points whose shadow is at `end`; `None`
/// where that line misses it.
pub(super) fn hidden_by(context: &Context, side: Side, n: DVec2, end: f64, down: DVec2) -> Option<[f64; 2]> {
    let points = context.outline(side, context.time)?.sampled();
    let off = |p: DVec2| p.dot(n) - end;
    let next = points.iter().skip(1).chain(points.first());
    let crossings = points.iter().zip(next).filter(|(p, q)| (off(**p) < 0.0) != (off(**q) < 0.0));
    let depths = crossings.map(|(&p, &q)| (p + (q - p) * (off(p) / (off(p) - off(q)))).dot(down));
    depths.map(|depth| [depth; 2]).reduce(|[lo, hi], [least, most]| [lo.min(least), hi.max(most)])
}

/// The parts of a line, from the less to the more along it, that nothing hides.
pub(super) fn seen([from, to]: [f64; 2], hidden: Option<[f64; 2]>) -> impl Iterator<Item = [f64; 2]> {
    let [lo, hi] = hidden.unwrap_or([to; 2]);
    [[from, lo.min(to)], [hi.max(from), to]].into_iter().filter(|[p, q]| p < q)
}
