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
//! Else it slides by some pixels to where it is comfortable. Of two that rest and stand in each other's way
//! the weaker one slides. Who has nowhere to slide wakes, and has the choice of all places, its old one
//! cheaper than it is by `inertia`. Neither clock nor chance: a frame is a function of
//! the scene and the frame before.

use crate::drawing::{Offset, Point, Rect};
use crate::figure::frame::Frame;

use super::cost::{Surroundings, pair_cost};
use super::leader::{LONGEST, Leader, is_far, leader, onto};
use super::rect::DIRECTIONS;
use super::reserve::{origin, resized};
use super::seeker::Seeker;
use super::weights::Weights;
use super::{Candidate, Labelled, Placed, Sought, Standing};

/// What a label names has turned round, rather than moved, if it is this far from where it was, page pixels.
const TURNED: f64 = 8.0;

/// How far a label slides in a frame to stand well again, page pixels: less than what is seen as a jump.
const SLIDE: f64 = 7.0;

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

/// For each label, with where what it belongs to lies, the one of the frame before that it is; none for one
/// that had none, or that the scene pins.
pub(super) fn matches<'b>(
    labels: &[(&Sought, Point)],
    before: &'b Labelled,
    frame: &Frame,
) -> Vec<Option<&'b Placed>> {
    let mut free: Vec<&Placed> = before.placed.iter().collect();
    labels.iter().map(|&label| match_of(label, &mut free, frame)).collect()
}

/// For each label the place that it had in the frame before; none for one that had none, that the scene
/// pins, or whose thing has changed so that no place is left of it.
pub(super) fn stays(
    seekers: &[Seeker],
    (before, labels): (&Labelled, &[Option<&Placed>]),
    scene: &Surroundings,
    weights: &Weights,
) -> Vec<Option<Stay>> {
    let mut all: Vec<Option<Stay>> = Vec::with_capacity(seekers.len());
    for (seeker, &label) in seekers.iter().zip(labels) {
        let places = label.map(|label| places_now(seeker, label, (&before.frame, scene.frame), weights));
        let priced = seeker.priced(places.unwrap_or_default(), scene).into_iter();
        let best = priced.min_by(|(_, p), (_, q)| p.total_cmp(q));
        all.push(best.zip(label).map(|(best, label)| stay(seeker, best, label, (scene, weights))));
    }
    settle(&mut all, seekers, (scene, weights));
    all
}

/// What a label may do with its place; where it stands badly there, it slides to one that it is comfortable
/// at, if one is near.
fn stay(
    seeker: &Seeker,
    (place, cost): (Candidate, f64),
    label: &Placed,
    (scene, weights): (&Surroundings, &Weights),
) -> Stay {
    let standing = label.standing;
    let is_fit = |(place, cost): &(Candidate, f64)| rests(place, *cost, &standing, weights);
    let (place, cost) = match (place, cost) {
        fit if is_fit(&fit) => return Stay { place: fit.0, cost: fit.1, standing, rests: true },
        unfit => unfit,
    };
    let near = slides(seeker, &place, (scene, weights)).into_iter();
    let slid = near.filter(is_fit).min_by(|(_, p), (_, q)| p.total_cmp(q));
    let rests = slid.is_some();
    let (place, cost) = slid.unwrap_or((place, cost));
    let standing = if rests { standing.slid(&place) } else { standing };
    Stay { place, cost, standing, rests }
}

impl Standing {
    /// The standing of a label that slid to a place near its own.
    fn slid(self, place: &Candidate) -> Self {
        Self { reluctance: place.reluctance, ..self }
    }
}

/// Whether a label that came by its place so rests at one of some cost.
fn rests(place: &Candidate, cost: f64, standing: &Standing, weights: &Weights) -> bool {
    let search = &weights.search;
    cost - place.reluctance < search.comfort || cost - standing.cost < search.worse
}

/// Places so near to one that a label which goes there slides rather than jumps, each with what it costs.
fn slides(
    seeker: &Seeker,
    place: &Candidate,
    (scene, weights): (&Surroundings, &Weights),
) -> Vec<(Candidate, f64)> {
    let ways = DIRECTIONS.iter().filter_map(|&(dx, dy)| Offset::new(dx, dy).unit());
    let ways = ways.flat_map(|u| [u * (0.5 * SLIDE), u * SLIDE]);
    let slid = |by: Offset| {
        let reluctance = place.reluctance + weights.search.nudged * by.length();
        shifted(seeker, place, by, weights).map(|place| Candidate { reluctance, ..place })
    };
    seeker.priced(ways.filter_map(slid).collect(), scene)
}

/// Lets one of two that rest and cost each other much slide out of the way: the weaker one, of the same rank
/// the later one, or else the other. Where neither can the weaker one wakes.
fn settle(all: &mut [Option<Stay>], seekers: &[Seeker], (scene, weights): (&Surroundings, &Weights)) {
    let clash = |a: &Candidate, b: &Candidate| pair_cost(a, b, &weights.costs) >= weights.search.unrest;
    for (i, j) in (0..all.len()).flat_map(|i| (0..i).map(move |j| (i, j))) {
        let rest = |k: usize| all[k].as_ref().filter(|stay| stay.rests);
        if !rest(i).zip(rest(j)).is_some_and(|(a, b)| clash(&a.place, &b.place)) {
            continue;
        }
        let weaker = if seekers[j].sought.rank < seekers[i].sought.rank { j } else { i };
        let aside = |label: usize| {
            let stay = all[label].as_ref()?;
            let others = (0..all.len()).filter(|&k| k != label).filter_map(|k| all[k].as_ref());
            let is_free = |place: &Candidate| !others.clone().any(|other| clash(place, &other.place));
            let near = slides(&seekers[label], &stay.place, (scene, weights)).into_iter();
            let fit = near.filter(|(c, cost)| rests(c, *cost, &stay.standing, weights) && is_free(c));
            Some((label, fit.min_by(|(_, p), (_, q)| p.total_cmp(q))?))
        };
        let slid = aside(weaker).or_else(|| aside(i + j - weaker));
        let Some(stay) = &mut all[slid.as_ref().map_or(weaker, |(label, _)| *label)] else { continue };
        stay.rests = slid.is_some();
        if let Some((_, (place, cost))) = slid {
            stay.standing = stay.standing.slid(&place);
            (stay.place, stay.cost) = (place, cost);
        }
    }
}

/// The label of the frame before that has this one's key: of several the one whose thing is nearest to this
/// one's. It is taken out of `free`.
fn match_of<'b>(
    (sought, home): (&Sought, Point),
    free: &mut Vec<&'b Placed>,
    frame: &Frame,
) -> Option<&'b Placed> {
    if sought.pinned().is_some() {
        return None;
    }
    let home = home - corner(frame);
    let like = free.iter().enumerate().filter(|(_, label)| label.key == sought.key);
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
    let home = |frame: &Frame, at: Point| origin(&seeker.sought.anchor, at, frame);
    let (was, is) = (home(then, corner(then) + label.home), home(now, seeker.home));
    let (along, still) = (is - was, corner(now) - corner(then));
    let turned = (along - still).length() > TURNED;
    let Standing { folds, reluctance, .. } = label.standing;
    if folds > seeker.sought.folds.len() {
        return Vec::new();
    }
    let rect = resized(&label.bounds, was, seeker.sought.size(folds));
    let place = Candidate { rect, reluctance, leader: label.leader, folds };
    let ways = std::iter::once(along).chain(turned.then_some(still));
    ways.filter_map(|by| shifted(seeker, &place, by, weights)).collect()
}

/// A label's place moved by an offset, with the leader line that it needs there; none where that would not
/// reach.
fn shifted(seeker: &Seeker, place: &Candidate, by: Offset, weights: &Weights) -> Option<Candidate> {
    let Rect { x0, y0, x1, y1 } = place.rect;
    let rect = Rect::new(Point::new(x0, y0) + by, Point::new(x1, y1) + by);
    let is_far = is_far(&seeker.things, &rect, &weights.places);
    let leader = match place.leader.map(|line| line.shifted(by)) {
        Some(line) if line.dot => still_in(seeker, line).or_else(|| line_to(seeker, &rect, weights)),
        // An area in which no dot found room has none a frame later; to look for it is half of a search.
        Some(_) => seeker.things.own.as_ref().and_then(|own| short(onto(own, &rect, &weights.places))),
        None if !is_far => None,
        None => line_to(seeker, &rect, weights),
    };
    (leader.is_some() || !is_far).then_some(Candidate { rect, leader, ..place.clone() })
}

/// The leader line of a label.
fn line_to(seeker: &Seeker, rect: &Rect, weights: &Weights) -> Option<Leader> {
    short(leader(&seeker.things, rect, &weights.places))
}

/// A leader line, if it is no longer than one may be.
fn short(line: Option<Leader>) -> Option<Leader> {
    line.filter(|line| line.length() <= LONGEST)
}

/// A leader line whose dot still lies in the label's own area, and in no other one.
fn still_in(seeker: &Seeker, line: Leader) -> Option<Leader> {
    let own = seeker.things.own.as_ref()?;
    let alone = !seeker.things.avoid().iter().any(|other| other.contains(line.from));
    (alone && own.line().contains(line.from)).then_some(line)
}

/// The upper left corner of a panel.
fn corner(frame: &Frame) -> Point {
    Point::new(frame.panel.x0, frame.panel.y0)
}

#[cfg(test)]
mod tests;
