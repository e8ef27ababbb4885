//! The labels of a panel among their places: greedy by regret, then 1-opt, then pairs, until nothing moves.

use std::cell::Cell;

use super::Candidate;
use super::cost::pair_cost;
use super::rest::Stay;
use super::weights::Weights;
use crate::geometry::sorted;

/// Passes of improvement; each lowers the sum of costs, so that they end, and this many are never seen.
const PASSES: usize = 64;
/// A move has to gain this much, so that rounding never decides between equal places.
const GAIN: f64 = 1e-6;

/// The candidates of every label, and which one each has at the moment.
pub(super) struct Choices<'w> {
    /// For each label its candidates, each with what it costs whatever the other labels do.
    pub(super) places: Vec<Vec<(Candidate, f64)>>,
    /// For each label the index of its candidate.
    pub(super) chosen: Vec<usize>,
    /// For each label the place that it had in the frame before: one that rests has no other.
    pub(super) stays: Vec<Option<Stay>>,
    /// For each label whether the search priced its places otherwise than for what lies there.
    pub(super) urged: Vec<bool>,
    /// The numbers that decide.
    pub(super) weights: &'w Weights,
    /// How many pairs of places were priced so far.
    pub(super) priced: Cell<usize>,
    /// How many may be.
    pub(super) most: usize,
}

/// What a place costs beside the first of the labels that are set: each of them is priced once, while one is
/// set after the other.
#[derive(Clone, Copy, Default)]
struct Sum {
    /// What it costs beside them.
    pairs: f64,
    /// How many they are.
    count: usize,
}

impl Choices<'_> {
    /// Whether a label rests where it stood in the frame before.
    pub(super) fn rests(&self, label: usize) -> bool {
        self.stays[label].as_ref().is_some_and(|stay| stay.rests)
    }

    /// Where a label stands at the moment.
    pub(super) fn candidate(&self, label: usize) -> &Candidate {
        &self.places[label][self.chosen[label]].0
    }

    /// Whether all the work is done that may be.
    pub(super) fn is_spent(&self) -> bool {
        self.priced.get() > self.most
    }

    /// The cost of a place beside the labels in `set`, or what of it is already as much as `most`.
    pub(super) fn cost_within(&self, label: usize, slot: usize, set: &[usize], most: f64) -> f64 {
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

    /// The cost of a place of a label beside those in `set`, or what of it is already as much as `most`; the
    /// sum so far goes on.
    fn cost_further(&self, (label, slot): (usize, usize), set: &[usize], most: f64, sum: &mut Sum) -> f64 {
        let (candidate, own) = &self.places[label][slot];
        for &other in set.iter().skip(sum.count) {
            if own + sum.pairs >= most {
                break;
            }
            self.priced.set(self.priced.get() + 1);
            sum.pairs += self.pair(candidate, self.candidate(other));
            sum.count += 1;
        }
        own + sum.pairs
    }

    /// The cost of a place beside the labels in `set`.
    pub(super) fn cost(&self, label: usize, slot: usize, set: &[usize]) -> f64 {
        self.cost_within(label, slot, set, f64::INFINITY)
    }

    /// The best place beside the labels in `set`, and how much worse the second best is; `sums` are those of
    /// the label's places.
    fn regret(&self, label: usize, set: &[usize], sums: &mut [Sum]) -> (usize, f64) {
        let (mut best, mut first, mut second) = (0, f64::INFINITY, f64::INFINITY);
        for (slot, sum) in sums.iter_mut().enumerate() {
            let cost = self.cost_further((label, slot), set, second, sum);
            if cost < first {
                (best, second, first) = (slot, first, cost);
            } else if cost < second {
                second = cost;
            }
        }
        (best, second - first)
    }

    /// The best of the places beside the labels in `set` that cost less than `most`, and its cost.
    pub(super) fn best(&self, label: usize, set: &[usize], most: f64) -> Option<(usize, f64)> {
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
    pub(super) fn cheapest(&self, label: usize, count: usize) -> Vec<usize> {
        let places = &self.places[label];
        let mut order = sorted(places.len(), &|a, b| places[a].1.total_cmp(&places[b].1));
        order.truncate(count);
        order
    }

    /// What two places cost each other.
    pub(super) fn pair(&self, a: &Candidate, b: &Candidate) -> f64 {
        pair_cost(a, b, &self.weights.costs)
    }

    /// Sets the label that would lose most by waiting, then the next.
    pub(super) fn greedy(&mut self) {
        let mut waiting: Vec<usize> =
            (0..self.places.len()).filter(|&i| !self.places[i].is_empty()).collect();
        let mut set = Vec::new();
        let mut sums: Vec<Vec<Sum>> =
            self.places.iter().map(|places| vec![Sum::default(); places.len()]).collect();
        while !waiting.is_empty() {
            let mut next = (0, 0, f64::NEG_INFINITY);
            for (i, &label) in waiting.iter().enumerate() {
                let (slot, regret) = self.regret(label, &set, &mut sums[label]);
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
    pub(super) fn improve(&mut self) {
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

    /// Gives a label that stands badly each of its good places in turn, lets those whom it disturbs there
    /// move, and keeps the first that lowers the sum of all costs.
    pub(super) fn eject(&mut self, label: usize, all: &[usize]) -> bool {
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
    pub(super) fn total(&self, all: &[usize]) -> f64 {
        all.iter().map(|&label| self.cost(label, self.chosen[label], &all[..label])).sum()
    }
}
