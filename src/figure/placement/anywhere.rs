//! Places anywhere about what a label belongs to, as far as a leader line reaches.
//!
//! The places of [`candidates`](super::candidates) are those that mapmakers like. A long name among many
//! lines may find a line under each of them, where a free spot lies just between two rings. Such a label
//! looks at a whole field of spots.

use crate::drawing::{Point, Rect};
use crate::figure::frame::Frame;

use super::leader::{LONGEST, led};
use super::rect::about;
use super::things::Things;
use super::weights::Weights;
use super::{Candidate, Sought};

/// Spots that a label looks at, at most, in each way to break it: on the page of a committed figure they are
/// 8 px apart around a body of 250 px.
const MOST: f64 = 2000.0;

/// The places of a label all over the field that a leader line reaches, in each of the ways to break it.
pub(super) fn anywhere(sought: &Sought, things: &Things, frame: &Frame, w: &Weights) -> Vec<Candidate> {
    let mut all = Vec::new();
    for folds in 0..=sought.folds.len() {
        let size = sought.size(folds);
        let broken = folds.checked_sub(1).and_then(|i| sought.folds.get(i));
        let reluctant = broken.map_or(0.0, |fold| fold.reluctance(&w.places));
        let found = field(things, size, &frame.panel, w).into_iter();
        let found = found.map(|c| Candidate { folds, reluctance: c.reluctance + reluctant, ..c });
        all.extend(led(found, things, &w.places));
    }
    all
}

/// A lattice of places for a label of a size that are in the panel and in reach of its thing.
fn field(things: &Things, size: (f64, f64), panel: &Rect, w: &Weights) -> Vec<Candidate> {
    let Some(own) = &things.own else { return Vec::new() };
    let half = (0.5 * size.0, 0.5 * size.1);
    let b = own.line().bounds().grown(LONGEST);
    let reach = Rect { x0: b.x0 - half.0, y0: b.y0 - half.1, x1: b.x1 + half.0, y1: b.y1 + half.1 };
    let room =
        Rect { x0: panel.x0 + half.0, y0: panel.y0 + half.1, x1: panel.x1 - half.0, y1: panel.y1 - half.1 };
    let Some(field) = room.intersection(reach) else { return Vec::new() };
    let step = w.search.field_step.max((field.width() * field.height() / MOST).sqrt());
    let mut all = Vec::new();
    for x in steps(field.x0, field.x1, step) {
        for y in steps(field.y0, field.y1, step) {
            let rect = about(Point::new(x, y), size);
            if !own.is_farther(&rect, LONGEST) {
                let reluctance = w.search.in_field + w.search.field_off * own.distance(&rect);
                all.push(Candidate::new(rect, reluctance));
            }
        }
    }
    all
}

/// Numbers from one to another.
fn steps(from: f64, to: f64, step: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(from), move |x| Some(x + step)).take_while(move |&x| x <= to)
}

#[cfg(test)]
mod tests {
    use super::super::things::{Kind, Thing};
    use super::super::weights::TUNED;
    use super::*;

    #[test]
    fn the_field_is_all_that_a_leader_line_reaches_within_the_panel() {
        let panel = Rect { x0: 0.0, y0: 0.0, x1: 300.0, y1: 100.0 };
        let own = Thing::new(Kind::Point, vec![Point::new(20.0, 50.0)], 4.5).unwrap();
        let things = Things::among(&[], Some(own.clone()), &panel);
        let all = field(&things, (30.0, 12.0), &panel, &TUNED);
        assert!(all.len() > 50, "{}", all.len());
        for place in &all {
            assert!(panel.union(place.rect) == panel && own.distance(&place.rect) <= LONGEST, "{place:?}");
        }
        assert!(field(&things, (301.0, 12.0), &panel, &TUNED).is_empty(), "wider than the panel");
    }
}
