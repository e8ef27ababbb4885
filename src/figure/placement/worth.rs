//! Which labels are worth a place: what is in view, and of those that name one thing twice the first.

use crate::figure::frame::Frame;
use crate::figure::sketch::Anchor;

use super::Sought;
use super::candidates::{home, is_in_view};
use super::polyline::Polyline;
use super::weights::Weights;

/// Two layers may name the same thing, or a body and a point in it: it is named once. What the view cuts off
/// is not named, and a text that shows nothing names nothing.
pub(super) fn worth_naming(sought: &[Sought], frame: &Frame, weights: &Weights) -> Vec<Sought> {
    let home = |s: &Sought| home(&s.anchor, frame, &weights.places);
    let same = |a: &Sought, b: &Sought| {
        let near = |a, b| (home(a) - home(b)).length() < weights.search.same_thing;
        let [p, q] = [a, b].map(|s| s.lines.iter().map(|l| &l.markup));
        p.eq(q) && (near(a, b) || marks(a, b, frame) || marks(b, a, frame))
    };
    let mut kept: Vec<Sought> = Vec::new();
    for one in sought {
        let shows = one.lines.iter().any(|l| !(l.glyphs.is_empty() && l.rules.is_empty()));
        if shows
            && is_in_view(&one.anchor, frame, &weights.places)
            && !kept.iter().any(|other| same(one, other))
        {
            kept.push(one.clone());
        }
    }
    kept
}

/// Whether a label is of a point within the area of another one, as of a body's origin.
fn marks(point: &Sought, area: &Sought, frame: &Frame) -> bool {
    match (&point.anchor, &area.anchor) {
        (Anchor::Point { at, .. }, Anchor::Inside { area }) => {
            let area = Polyline::closed(area.iter().map(|&p| frame.page(p)).collect());
            area.is_some_and(|area| area.contains(frame.page(*at)))
        }
        _ => false,
    }
}
