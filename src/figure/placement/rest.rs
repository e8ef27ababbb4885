//! Labels that rest: in a figure that is drawn again and again while someone drags a body, a label stays
//! where it stood in the frame before, as seen from what it names.
//!
//! Placed afresh in each frame, labels would jump: over the committed figures, with their bodies dragged by a
//! pixel a frame, 35 of 100 frames had a jump of more than 8 px, and more than half of them went back soon.
//! So a label looks for another place only where its own has become bad:
//!
//! ```text
//! place = place before + home − home before
//! rests ⇔ cost − reluctance < comfort  or  cost − cost when it was chosen < worse
//! ```
//!
//! Two that rest and stand in each other's way wake the weaker one. Who does not rest has the choice of all
//! places, its old one cheaper than it is by `inertia`. Neither clock nor chance: a frame is a function of
//! the scene and the frame before.

use crate::drawing::{Offset, Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::Anchor;

use super::cost::{Surroundings, pair_cost};
use super::leader::{LONGEST, Leader, is_far, leader};
use super::seeker::Seeker;
use super::weights::Weights;
use super::{Candidate, Labelled, Placed, Standing};

/// What a label names has turned round, rather than moved, if it is this far from where it was, page pixels.
const TURNED: f64 = 8.0;

/// What a label may do with the place that it had in the frame before.
pub(super) struct Stay {
    /// The place, moved along with what the label names.
    pub(super) place: Candidate,
    /// What it costs by itself now.
    pub(super) cost: f64,
    /// How the label came by it.
    pub(super) standing: Standing,
    /// Whether the label rests there.
    pub(super) rests: bool,
}

/// For each label the place that it had in the frame before; none for one that had none, that the scene
/// pins, or whose thing has changed so that no place is left of it.
pub(super) fn stays(
    seekers: &[Seeker],
    before: &Labelled,
    scene: &Surroundings,
    weights: &Weights,
) -> Vec<Option<Stay>> {
    let search = &weights.search;
    let mut free: Vec<&Placed> = before.placed.iter().collect();
    let mut all: Vec<Option<Stay>> = Vec::with_capacity(seekers.len());
    for seeker in seekers {
        let label = match_of(seeker, &mut free, scene.frame);
        let places = label.map(|label| places_now(seeker, label, (&before.frame, scene.frame), weights));
        let priced = seeker.priced(places.unwrap_or_default(), scene).into_iter();
        let best = priced.min_by(|(_, p), (_, q)| p.total_cmp(q));
        all.push(best.zip(label).map(|((place, cost), label)| {
            let standing = label.standing;
            let rests = cost - place.reluctance < search.comfort || cost - standing.cost < search.worse;
            Stay { place, cost, standing, rests }
        }));
    }
    wake(&mut all, seekers, weights);
    all
}

/// Wakes the weaker of two that rest and cost each other much: of the same rank, the later one.
fn wake(all: &mut [Option<Stay>], seekers: &[Seeker], weights: &Weights) {
    for i in 0..all.len() {
        for j in 0..i {
            let (Some(a), Some(b)) = (&all[i], &all[j]) else { continue };
            let apart = pair_cost(&a.place, &b.place, &weights.costs) < weights.search.unrest;
            if apart || !(a.rests && b.rests) {
                continue;
            }
            let weaker = if seekers[j].sought.rank < seekers[i].sought.rank { j } else { i };
            if let Some(stay) = &mut all[weaker] {
                stay.rests = false;
            }
        }
    }
}

/// The label of the frame before that has this one's key: of several the one whose thing is nearest. It is
/// taken out of `free`.
fn match_of<'b>(seeker: &Seeker, free: &mut Vec<&'b Placed>, frame: &Frame) -> Option<&'b Placed> {
    if seeker.sought.pin.is_some() {
        return None;
    }
    let home = seeker.home - corner(frame);
    let like = free.iter().enumerate().filter(|(_, label)| label.key == seeker.sought.key);
    let off = |label: &Placed| (Point::default() + label.home - (Point::default() + home)).square();
    let (i, _) = like.min_by(|(_, a), (_, b)| off(a).total_cmp(&off(b)))?;
    Some(free.remove(i))
}

/// A label's place in the frame before, moved along with what it names. What turned round, as the line to
/// another vertex, may have left its label at the better place on the page: that place too.
fn places_now(
    seeker: &Seeker,
    label: &Placed,
    (then, now): (&Frame, &Frame),
    weights: &Weights,
) -> Vec<Candidate> {
    let home = |frame: &Frame, at: Point| match seeker.sought.anchor {
        Anchor::Corner(corner) => {
            let ((dx, dy), panel) = (corner.direction(), &frame.panel);
            panel.center() + Offset::new(0.5 * dx * panel.width(), 0.5 * dy * panel.height())
        }
        _ => at,
    };
    let (was, is) = (home(then, corner(then) + label.home), home(now, seeker.home));
    let (along, still) = (is - was, corner(now) - corner(then));
    let turned = (along - still).length() > TURNED;
    let ways = std::iter::once(along).chain(turned.then_some(still));
    ways.filter_map(|by| moved(seeker, label, (was, by), weights)).collect()
}

/// A label's place in the frame before, moved by an offset; `home` is where its thing was. None where the
/// text breaks in other ways now, or a leader line would not reach.
fn moved(
    seeker: &Seeker,
    label: &Placed,
    (home, by): (Point, Offset),
    weights: &Weights,
) -> Option<Candidate> {
    let Standing { folds, reluctance, .. } = label.standing;
    if folds > seeker.sought.folds.len() {
        return None;
    }
    let rect = resized(&label.bounds, home, seeker.sought.size(folds));
    let rect = Rect::new(Point::new(rect.x0, rect.y0) + by, Point::new(rect.x1, rect.y1) + by);
    let is_far = is_far(&seeker.things, &rect, &weights.places);
    let leader = match label.leader.map(|line| line.shifted(by)) {
        Some(line) if line.dot => still_in(seeker, line).or_else(|| line_to(seeker, &rect, weights)),
        None if !is_far => None,
        _ => line_to(seeker, &rect, weights),
    };
    (leader.is_some() || !is_far).then_some(Candidate { rect, reluctance, leader, folds })
}

/// The leader line of a label, if it is no longer than one may be.
fn line_to(seeker: &Seeker, rect: &Rect, weights: &Weights) -> Option<Leader> {
    leader(&seeker.things, rect, &weights.places).filter(|line| line.length() <= LONGEST)
}

/// A leader line whose dot still lies in the label's own area, and in no other one.
fn still_in(seeker: &Seeker, line: Leader) -> Option<Leader> {
    let own = seeker.things.own.as_ref()?;
    let alone = !seeker.things.avoid().iter().any(|other| other.contains(line.from));
    (alone && own.line().contains(line.from)).then_some(line)
}

/// A label's box for a text of another size, as a number has from frame to frame: the edges towards what it
/// names stay, and it grows to both sides where it stands above, below or on it.
fn resized(bounds: &Rect, home: Point, (width, height): (f64, f64)) -> Rect {
    let (x0, x1) = spread((bounds.x0, bounds.x1), home.x, width);
    let (y0, y1) = spread((bounds.y0, bounds.y1), home.y, height);
    Rect { x0, y0, x1, y1 }
}

/// The ends of a stretch that gets another length and keeps its end towards `home`.
fn spread((lo, hi): (f64, f64), home: f64, length: f64) -> (f64, f64) {
    let more = length - (hi - lo);
    let share = if home <= lo {
        0.0
    } else if home >= hi {
        1.0
    } else {
        0.5
    };
    (lo - share * more, hi + (1.0 - share) * more)
}

/// The upper left corner of a panel.
fn corner(frame: &Frame) -> Point {
    Point::new(frame.panel.x0, frame.panel.y0)
}

#[cfg(test)]
mod tests;
