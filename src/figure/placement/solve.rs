//! Greedy by regret, then 1-opt, then pairs, until nothing moves.

use std::cell::Cell;
use std::sync::Arc;

use crate::drawing::{Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Corner, Obstacle};

use super::anywhere::anywhere;
use super::candidates::{candidates, home, nudged};
use super::cost::{Surroundings, near_by, own_cost, pair_cost};
use super::faults::hides;
use super::things::{Thing, Things};
use super::weights::{TUNED, Weights};
use super::worth::worth_naming;
use super::{Candidate, LEADING, Labelled, Placed, Sought};

/// Passes of improvement; each lowers the sum of costs, so that they end, and this many are never seen.
const PASSES: usize = 64;
/// A move has to gain this much, so that rounding never decides between equal places.
const GAIN: f64 = 1e-6;
/// Costs count in parts of this: places that are as good as each other, as above and below a level edge, stay
/// so whatever the last bits of an answer are, and the first of them is taken.
const PARTS: f64 = 1e6;

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
    /// How many panels the figure has, which share the work of the search.
    pub(crate) panels: usize,
}

/// The candidates of every label, and which one each has at the moment.
struct Choices<'w> {
    /// For each label its candidates, each with what it costs whatever the other labels do.
    places: Vec<Vec<(Candidate, f64)>>,
    /// For each label the index of its candidate.
    chosen: Vec<usize>,
    /// The numbers that decide.
    weights: &'w Weights,
    /// How many pairs of places were priced so far.
    priced: Cell<usize>,
    /// How many may be.
    most: usize,
}

/// Places the labels of a panel.
pub(crate) fn place(sought: &[Sought], ground: &Ground) -> Labelled {
    place_by(&TUNED, sought, ground)
}

/// Places the labels of a panel by other numbers than the tuned ones.
pub(super) fn place_by(weights: &Weights, sought: &[Sought], ground: &Ground) -> Labelled {
    let Ground { frame, obstacles, things, earlier, panels } = *ground;
    let sought = &worth_naming(sought, frame, weights);
    let surroundings = Surroundings { frame, obstacles, earlier, costs: &weights.costs, hiding: 0.0 };
    let seekers: Vec<Seeker> = sought
        .iter()
        .map(|sought| {
            let things = Things::of(&sought.anchor, things, frame, &weights.places);
            Seeker { sought, home: home(&sought.anchor, frame, &weights.places), things }
        })
        .collect();
    let places = seekers
        .iter()
        .map(|s| s.priced(candidates(s.sought, &s.things, frame, &weights.places), &surroundings));
    let (places, chosen, most) = (places.collect(), vec![0; sought.len()], MAX_PRICED / panels.max(1));
    let mut choices = Choices { places, chosen, weights, priced: Cell::new(0), most };
    choices.greedy();
    choices.improve();
    choices.widen(&seekers, &surroundings);
    choices.improve();
    if choices.search_all(&seekers, &surroundings) {
        choices.improve();
    }
    choices.finish(&seekers, ground)
}

/// A label that seeks its place.
struct Seeker<'s> {
    /// What it says, and of what.
    sought: &'s Sought,
    /// Where what it belongs to lies, page pixels.
    home: Point,
    /// What it names, and what it must not seem to name.
    things: Things<'s>,
}

impl Seeker<'_> {
    /// Places, each with what it costs whatever the other labels do.
    fn priced(&self, all: Vec<Candidate>, scene: &Surroundings) -> Vec<(Candidate, f64)> {
        let near_by = near_by(self.sought, &all, scene);
        let own = |c: &Candidate| own_cost((self.sought, &self.things), self.home, c, &near_by, scene);
        let cost = |c: &Candidate| steady(own(c));
        all.into_iter().map(|c| (cost(&c), c)).map(|(cost, c)| (c, cost)).collect()
    }
}

/// A cost rounded to whole [`PARTS`].
fn steady(cost: f64) -> f64 {
    (PARTS * cost).round() / PARTS
}

impl Choices<'_> {
    /// Where a label stands at the moment.
    fn candidate(&self, label: usize) -> &Candidate {
        &self.places[label][self.chosen[label]].0
    }

    /// Whether all the work is done that may be.
    fn is_spent(&self) -> bool {
        self.priced.get() > self.most
    }

    /// The cost of a place beside the labels in `set`, or what of it is already as much as `most`.
    fn cost_within(&self, label: usize, slot: usize, set: &[usize], most: f64) -> f64 {
        let (candidate, own) = &self.places[label][slot];
        let mut pairs = 0.0;
        for &other in set.iter().filter(|&&other| other != label) {
            if own + pairs >= most {
                break;
            }
            self.priced.set(self.priced.get() + 1);
            pairs += self.pair(candidate, self.candidate(other));
        }
        own + pairs
    }

    /// The cost of a place beside the labels in `set`.
    fn cost(&self, label: usize, slot: usize, set: &[usize]) -> f64 {
        self.cost_within(label, slot, set, f64::INFINITY)
    }

    /// The best place beside the labels in `set`, and how much worse the second best is.
    fn regret(&self, label: usize, set: &[usize]) -> (usize, f64) {
        let (mut best, mut first, mut second) = (0, f64::INFINITY, f64::INFINITY);
        for slot in 0..self.places[label].len() {
            let cost = self.cost_within(label, slot, set, second);
            if cost < first {
                (best, second, first) = (slot, first, cost);
            } else if cost < second {
                second = cost;
            }
        }
        (best, second - first)
    }

    /// The best of the places beside the labels in `set` that cost less than `most`, and its cost.
    fn best(&self, label: usize, set: &[usize], most: f64) -> Option<(usize, f64)> {
        let mut best = None;
        for slot in 0..self.places[label].len() {
            let least = best.map_or(most, |(_, cost)| cost);
            let cost = self.cost_within(label, slot, set, least);
            if cost < least {
                best = Some((slot, cost));
            }
        }
        best
    }

    /// The places of a label that cost least by themselves.
    fn cheapest(&self, label: usize, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.places[label].len()).collect();
        order.sort_by(|&a, &b| self.places[label][a].1.total_cmp(&self.places[label][b].1));
        order.truncate(count);
        order
    }

    /// What two places cost each other.
    fn pair(&self, a: &Candidate, b: &Candidate) -> f64 {
        pair_cost(a, b, &self.weights.costs)
    }

    /// Sets the label that would lose most by waiting, then the next.
    fn greedy(&mut self) {
        let mut waiting: Vec<usize> =
            (0..self.places.len()).filter(|&i| !self.places[i].is_empty()).collect();
        let mut set = Vec::new();
        while !waiting.is_empty() {
            let mut next = (0, 0, f64::NEG_INFINITY);
            for (i, &label) in waiting.iter().enumerate() {
                let (slot, regret) = self.regret(label, &set);
                if regret > next.2 {
                    next = (i, slot, regret);
                }
            }
            let label = waiting.remove(next.0);
            self.chosen[label] = next.1;
            set.push(label);
        }
    }

    /// Moves one label after the other to its best place, until none wants to.
    fn improve(&mut self) {
        let all: Vec<usize> = (0..self.places.len()).collect();
        for _ in 0..PASSES {
            let mut moved = false;
            for &label in &all {
                if self.is_spent() {
                    return;
                }
                let now = self.cost(label, self.chosen[label], &all);
                if let Some((slot, _)) = self.best(label, &all, now).filter(|(_, cost)| cost + GAIN < now) {
                    self.chosen[label] = slot;
                    moved = true;
                }
            }
            if !moved && !all.iter().any(|&label| self.eject(label, &all)) {
                return;
            }
        }
    }

    /// Offers the labels in trouble places about their places.
    fn widen(&mut self, seekers: &[Seeker], scene: &Surroundings) {
        let all: Vec<usize> = (0..seekers.len()).collect();
        let search = &self.weights.search;
        for (label, seeker) in seekers.iter().enumerate() {
            if self.is_spent() {
                break;
            }
            if seeker.sought.pin.is_some() || self.cost(label, self.chosen[label], &all) < search.trouble {
                continue;
            }
            let about = |slot: usize| nudged(&self.places[label][slot].0, &seeker.things, self.weights);
            let more = self.cheapest(label, search.cheapest).into_iter().flat_map(about).collect();
            let more = self.price(seeker, more, scene);
            self.places[label].extend(more);
        }
    }

    /// Offers the labels that hide something a place anywhere, and makes all of their places that hide
    /// something a last resort; whether there are any.
    fn search_all(&mut self, seekers: &[Seeker], scene: &Surroundings) -> bool {
        let strict = Surroundings { hiding: self.weights.search.hiding, ..*scene };
        let mut any = false;
        for (label, seeker) in seekers.iter().enumerate() {
            let (sought, rect) = (seeker.sought, self.candidate(label).rect);
            if self.is_spent() || sought.pin.is_some() || !hides(scene.obstacles, sought.part, &rect) {
                continue;
            }
            let mut places: Vec<Candidate> = self.places[label].drain(..).map(|(place, _)| place).collect();
            places.extend(anywhere(sought, &seeker.things, scene.frame, self.weights));
            self.places[label] = self.price(seeker, places, &strict);
            any = true;
        }
        any
    }

    /// Places, each with what it costs by itself; the work counts as that of pairs of places.
    fn price(&self, seeker: &Seeker, places: Vec<Candidate>, scene: &Surroundings) -> Vec<(Candidate, f64)> {
        self.priced.set(self.priced.get() + places.len() * scene.obstacles.len() / BOXES);
        seeker.priced(places, scene)
    }

    /// Gives a label that stands badly each of its good places in turn, lets those whom it disturbs there
    /// move, and keeps the first that lowers the sum of all costs.
    fn eject(&mut self, label: usize, all: &[usize]) -> bool {
        let now = self.cost(label, self.chosen[label], all);
        if now < self.weights.search.uneasy {
            return false;
        }
        let (before, kept) = (self.total(all), self.chosen.clone());
        for slot in self.cheapest(label, self.weights.search.cheapest) {
            if self.places[label][slot].1 >= now || self.is_spent() {
                break;
            }
            self.chosen[label] = slot;
            let disturbed =
                |&&o: &&usize| o != label && self.pair(self.candidate(label), self.candidate(o)) > 0.0;
            let disturbed: Vec<usize> = all.iter().filter(disturbed).copied().collect();
            for other in disturbed {
                let best = self.best(other, all, f64::INFINITY);
                self.chosen[other] = best.map_or(self.chosen[other], |(slot, _)| slot);
            }
            if self.total(all) + GAIN < before {
                return true;
            }
            self.chosen.clone_from(&kept);
        }
        false
    }

    /// The sum of all costs.
    fn total(&self, all: &[usize]) -> f64 {
        all.iter().map(|&label| self.cost(label, self.chosen[label], &all[..label])).sum()
    }

    /// The labels at their places, without those that clash beyond help.
    fn finish(&self, seekers: &[Seeker], ground: &Ground) -> Labelled {
        let Ground { frame, obstacles, things, .. } = *ground;
        let clash = self.weights.search.clash;
        let mut order: Vec<usize> = (0..seekers.len()).collect();
        order.sort_by_key(|&i| std::cmp::Reverse(seekers[i].sought.rank));
        let mut kept: Vec<usize> = Vec::new();
        let mut dropped = Vec::new();
        for &i in &order {
            let rect = self.candidate(i).rect;
            let clashes = |&o: &usize| {
                let both = rect.intersection(self.candidate(o).rect);
                both.is_some_and(|r| r.width() > clash && r.height() > clash)
            };
            if kept.iter().any(clashes) {
                dropped.push((seekers[i].sought.key, seekers[i].sought.span.clone()));
            } else {
                kept.push(i);
            }
        }
        kept.sort_unstable();
        let placed = kept.iter().map(|&i| placed(&seekers[i], self.candidate(i), frame)).collect();
        let (obstacles, things) = (obstacles.to_vec(), things.to_vec());
        Labelled { frame: *frame, obstacles, things, placed, dropped }
    }
}

/// A label at its place: its lines below each other, centred but for notes.
fn placed(seeker: &Seeker, candidate: &Candidate, frame: &Frame) -> Placed {
    let sought = seeker.sought;
    let bounds = candidate.rect;
    // The lines of a note are read as a paragraph or a column of equations.
    let align = match sought.anchor {
        Anchor::Corner(corner) if !matches!(corner, Corner::Top | Corner::Bottom) => 0.0,
        _ => 0.5,
    };
    let mut y = bounds.y0;
    let mut lines = Vec::with_capacity(sought.lines.len());
    for line in sought.folded(candidate.folds) {
        let x = bounds.x0 + align * (bounds.width() - line.width);
        lines.push((Point::new(x, y + line.ascent), Arc::clone(line)));
        y += line.height() + LEADING;
    }
    let Sought { key, role, part, .. } = *sought;
    let home = seeker.home - Point::new(frame.panel.x0, frame.panel.y0);
    let (leader, thing, span) = (candidate.leader, seeker.things.own.clone(), sought.span.clone());
    Placed { key, role, lines, bounds, leader, thing, part, home, span }
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
