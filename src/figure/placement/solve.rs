//! The search of a panel's labels for their places: what each is offered when, and what is left out in the
//! end.

use std::cell::Cell;

use crate::drawing::{Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::Obstacle;
use crate::geometry::{sort_by, sorted};

use super::anywhere::anywhere;
use super::candidates::{candidates, home, nudged};
use super::choices::Choices;
use super::cost::{Surroundings, own_reach};
use super::faults::hides;
use super::reserve::Reserve;
use super::rest::{Stay, matches, stays};
use super::seeker::Seeker;
use super::things::Thing;
use super::weights::Weights;
use super::worth::worth_naming;
use super::{Candidate, Labelled, Placed, Sought};

/// Pairs of places that the search for better ones may price in a figure, shared evenly by its panels; labels
/// then stay where they are. A pair takes 5 ns. The committed figures take 60,000 in a panel at most, 2,000
/// random scenes a million; fourteen labels of one point would take 17 million.
const MAX_PRICED: usize = 6_000_000;
/// Obstacles too far off to cost a place anything that take as long to pass by as a pair of places.
const BOXES: usize = 8;

/// A panel in which labels seek their places.
pub(crate) struct Ground<'p> {
    /// The panel and its map.
    pub(crate) frame: &'p Frame,
    /// What labels keep off.
    pub(crate) obstacles: &'p [Obstacle],
    /// Everything that a label could name.
    pub(crate) things: &'p [Thing],
    /// Labels of earlier panels of the series, each with its panel.
    pub(crate) earlier: &'p [(Rect, Placed)],
    /// The panel in the frame before of a figure that moves.
    pub(crate) before: Option<&'p Labelled>,
    /// How many panels the figure has, which share the work of the search.
    pub(crate) panels: usize,
}

/// What a label makes of the place that it had in the frame before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Old {
    /// It rests there, where that is comfortable.
    Comfortable,
    /// It rests there in any case.
    Kept,
    /// It likes it better than it is, and does not rest.
    Liked,
    /// It looks for a place as if it had none.
    Forgotten,
}

/// Searches for the places of a panel's labels, each of which makes something of where it stood in the frame
/// before.
pub(super) fn searched(
    weights: &Weights,
    sought: &[Sought],
    ground: &Ground,
    old: &dyn Fn(&Sought) -> Old,
) -> Labelled {
    let Ground { frame, obstacles, things, earlier, before, panels } = *ground;
    let mut sought = worth_naming(sought, frame, weights);
    let homes: Vec<Point> = sought.iter().map(|s| home(&s.anchor, frame, &weights.places)).collect();
    let labels: Vec<(&Sought, Point)> = sought.iter().zip(homes.iter().copied()).collect();
    let then = before.map_or_else(|| vec![None; sought.len()], |before| matches(&labels, before, frame));
    for (label, &then) in sought.iter_mut().zip(&then) {
        label.room = Reserve::of(label, then.filter(|_| old(label) != Old::Forgotten));
    }
    let surroundings = Surroundings { frame, obstacles, earlier, costs: &weights.costs, hiding: 0.0 };
    let seekers = sought.iter().zip(homes).map(|(s, home)| Seeker::new(s, home, things, frame));
    let seekers: Vec<Seeker> = seekers.collect();
    let none = || seekers.iter().map(|_| None).collect();
    let stays = before.map_or_else(none, |before| stays(&seekers, (before, &then), &surroundings, weights));
    let stay = |(stay, seeker): (Option<Stay>, &Seeker)| match old(seeker.sought) {
        Old::Comfortable => stay,
        Old::Liked => stay.map(|stay| Stay { rests: false, ..stay }),
        Old::Kept => stay.map(|stay| Stay { rests: true, ..stay }),
        Old::Forgotten => None,
    };
    let stays = stays.into_iter().zip(&seekers).map(stay).collect();
    let mut choices = Choices {
        places: vec![Vec::new(); seekers.len()],
        chosen: vec![0; seekers.len()],
        stays,
        urged: vec![false; seekers.len()],
        weights,
        priced: Cell::new(0),
        most: MAX_PRICED / panels.max(1),
    };
    choices.offer(&seekers, &surroundings);
    choices.greedy();
    choices.improve();
    let awake: Vec<usize> = (0..seekers.len()).filter(|&label| !choices.rests(label)).collect();
    choices.widen(&awake, &seekers, &surroundings);
    choices.improve();
    let woken = choices.wake(&seekers, &surroundings);
    if !woken.is_empty() {
        choices.improve();
        choices.widen(&woken, &seekers, &surroundings);
        choices.improve();
    }
    if choices.search_all(&seekers, &surroundings) {
        choices.improve();
    }
    choices.finish(&seekers, ground, &surroundings)
}

impl Choices<'_> {
    /// Gives every label its places: all of them, or the one where it rests.
    fn offer(&mut self, seekers: &[Seeker], scene: &Surroundings) {
        for (label, seeker) in seekers.iter().enumerate() {
            if let Some(stay) = self.stays[label].as_ref().filter(|stay| stay.rests) {
                self.places[label] = vec![(stay.place.clone(), stay.cost)];
            } else {
                self.offer_all(label, seeker, scene);
            }
        }
    }

    /// Gives a label all its places, and first of all the one that it had, cheaper than it is.
    fn offer_all(&mut self, label: usize, seeker: &Seeker, scene: &Surroundings) {
        let stay = self.stays[label].as_ref();
        let old = stay.map(|stay| (stay.place.clone(), stay.cost - self.weights.search.inertia));
        self.urged[label] = old.is_some();
        let near = self.weights.places.beside(own_reach(seeker.sought, scene));
        let mut places = candidates(seeker.sought, &seeker.things, scene.frame, &near);
        places.extend(seeker.as_in_series(scene));
        self.places[label] = old.into_iter().chain(seeker.priced(places, scene)).collect();
        self.chosen[label] = 0;
    }

    /// Wakes the labels that rest where one that found no better place stands in their way.
    fn wake(&mut self, seekers: &[Seeker], scene: &Surroundings) -> Vec<usize> {
        let all = 0..seekers.len();
        let in_the_way = |label: usize, other: usize| {
            !self.rests(other)
                && self.pair(self.candidate(label), self.candidate(other)) >= self.weights.search.unrest
        };
        let disturbed = |&label: &usize| self.rests(label) && all.clone().any(|o| in_the_way(label, o));
        let woken: Vec<usize> = all.clone().filter(disturbed).collect();
        for &label in &woken {
            if let Some(stay) = &mut self.stays[label] {
                stay.rests = false;
            }
            self.offer_all(label, &seekers[label], scene);
        }
        woken
    }

    /// Offers those of some labels that are in trouble places about their places; those in a body that what
    /// they name lies beside, places anywhere.
    fn widen(&mut self, labels: &[usize], seekers: &[Seeker], scene: &Surroundings) {
        let all: Vec<usize> = (0..seekers.len()).collect();
        let search = &self.weights.search;
        for &label in labels {
            if self.is_spent() {
                break;
            }
            let seeker = &seekers[label];
            let now = self.cost(label, self.chosen[label], &all);
            if seeker.sought.pinned().is_some() || now < search.trouble {
                continue;
            }
            let about = |slot: usize| nudged(&self.places[label][slot].0, &seeker.things, self.weights);
            let mut more: Vec<_> =
                self.cheapest(label, search.cheapest).into_iter().flat_map(about).collect();
            if seeker.things.astray(&self.candidate(label).rect) > 0.0 {
                more.extend(anywhere(seeker.sought, &seeker.things, scene.frame, self.weights));
            }
            let more = self.price(seeker, (more, now + search.hopeless), scene);
            self.places[label].extend(more);
        }
    }

    /// Offers the labels that hide something or would be left out a place anywhere, and makes all of their
    /// places that hide something a last resort; whether there are any.
    fn search_all(&mut self, seekers: &[Seeker], scene: &Surroundings) -> bool {
        let strict = Surroundings { hiding: self.weights.search.hiding, ..*scene };
        let mut any = false;
        for (label, seeker) in seekers.iter().enumerate() {
            let (sought, rect) = (seeker.sought, self.candidate(label).rect);
            if self.is_spent()
                || self.rests(label)
                || sought.pinned().is_some()
                || !hides(scene.obstacles, sought.part, &rect) && !self.clashes(label, 0..seekers.len())
            {
                continue;
            }
            let places: Vec<Candidate> = self.places[label].drain(..).map(|(place, _)| place).collect();
            self.places[label] = self.price(seeker, (places, f64::INFINITY), &strict);
            let most = self.places[label][self.chosen[label]].1 + self.weights.search.hopeless;
            let more = anywhere(sought, &seeker.things, scene.frame, self.weights);
            let more = self.price(seeker, (more, most), &strict);
            self.places[label].extend(more);
            self.urged[label] = true;
            any = true;
        }
        any
    }

    /// The places that cost no more than `most` by themselves, each with that; the work counts as that of
    /// pairs of places.
    fn price(
        &self,
        seeker: &Seeker,
        (places, most): (Vec<Candidate>, f64),
        scene: &Surroundings,
    ) -> Vec<(Candidate, f64)> {
        self.priced.set(self.priced.get() + places.len() * scene.obstacles.len() / BOXES);
        seeker.priced_within(most, places, scene)
    }

    /// Whether a label clashes with one of some others, so that one of them is left out.
    fn clashes(&self, label: usize, mut others: impl Iterator<Item = usize>) -> bool {
        let (rect, clash) = (self.candidate(label).rect, self.weights.search.clash);
        others.any(|other| {
            let both = rect.intersection(self.candidate(other).rect).filter(|_| other != label);
            both.is_some_and(|r| r.width() > clash && r.height() > clash)
        })
    }

    /// The labels at their places, without those that clash beyond help.
    fn finish(&self, seekers: &[Seeker], ground: &Ground, scene: &Surroundings) -> Labelled {
        let Ground { frame, obstacles, things, .. } = *ground;
        let order = sorted(seekers.len(), &|i, j| seekers[j].sought.rank.cmp(&seekers[i].sought.rank));
        let mut kept: Vec<usize> = Vec::new();
        let mut dropped = Vec::new();
        for &i in &order {
            if self.clashes(i, kept.iter().copied()) {
                dropped.push((seekers[i].sought.key, seekers[i].sought.span.clone()));
            } else {
                kept.push(i);
            }
        }
        sort_by(&mut kept, Ord::cmp);
        let placed = kept.iter().map(|&i| self.placed(i, &seekers[i], scene)).collect();
        let (obstacles, things) = (obstacles.to_vec(), things.to_vec());
        Labelled { frame: *frame, obstacles, things, placed, dropped }
    }

    /// A label at its place; what that costs by itself is what it cost where the label rests.
    fn placed(&self, label: usize, seeker: &Seeker, scene: &Surroundings) -> Placed {
        let (place, cost) = &self.places[label][self.chosen[label]];
        let resting = self.stays[label].as_ref().filter(|stay| stay.rests);
        let plain = || seeker.priced(vec![place.clone()], scene).first().map(|(_, cost)| *cost);
        let again = if self.urged[label] { plain() } else { None };
        let cost = resting.map(|stay| stay.standing.cost).or(again).unwrap_or(*cost);
        seeker.placed((place, cost), scene.frame, self.weights)
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    /// Where the labels of a figure's scene stand, with a velocity that is off by some of its last bits.
    fn places(off: f64) -> Vec<(String, f64, f64)> {
        let scene = include_str!("../../../figures/07-conservative-bound.toml");
        let shifted = scene.replace("velocity = [-10, 6]", &format!("velocity = [{}, 6]", -10.0 + off));
        let scene = open_text("s.toml", &shifted).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "s");
        let placed = figure.panels.iter().flat_map(|panel| &panel.placed);
        placed.filter_map(|p| p.lines.first().map(|(at, _)| (p.key.to_owned(), at.x, at.y))).collect()
    }

    #[test]
    fn the_last_bits_of_a_scene_move_no_label() {
        let exact = places(0.0);
        assert!(exact.len() > 8, "{exact:?}");
        for off in [1e-12, -1e-12, 3e-11, -3e-11] {
            for (a, b) in exact.iter().zip(places(off)) {
                assert!((a.1 - b.1).abs() < 1e-6 && (a.2 - b.2).abs() < 1e-6, "{off}: {a:?} {b:?}");
            }
        }
    }
}
