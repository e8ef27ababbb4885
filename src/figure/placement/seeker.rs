//! A label that seeks its place: what it says, where what it names lies, what its places cost by themselves.

use std::sync::Arc;

use crate::drawing::{Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Corner};

use super::cost::{Surroundings, in_series, near_by, own_cost};
use super::reserve::{origin, resized};
use super::things::{Thing, Things};
use super::weights::Weights;
use super::{Candidate, LEADING, Placed, Sought, Standing};

/// Costs count in parts of this: places that are as good as each other, as above and below a level edge, stay
/// so whatever the last bits of an answer are, and the first of them is taken.
const PARTS: f64 = 1e6;

/// Lengths that differ by less are one, page pixels: what adding a place on the page leaves of a size.
const ROUNDED: f64 = 1e-6;

/// A label that seeks its place.
pub(super) struct Seeker<'s> {
    /// What it says, and of what.
    pub(super) sought: &'s Sought,
    /// Where what it belongs to lies, page pixels.
    pub(super) home: Point,
    /// What it names, and what it must not seem to name.
    pub(super) things: Things<'s>,
}

impl<'s> Seeker<'s> {
    /// A label among all things of its panel, with where what it belongs to lies.
    pub(super) fn new(sought: &'s Sought, home: Point, all: &'s [Thing], frame: &Frame) -> Self {
        let things = Things::of(&sought.anchor, all, frame);
        Self { sought, home, things }
    }

    /// The place at which an earlier panel of a series has the label, if it is as large there.
    pub(super) fn as_in_series(&self, scene: &Surroundings) -> Option<Candidate> {
        let (rect, before) = in_series(self.sought, self.home, scene)?;
        let Standing { folds, reluctance, .. } = before.standing;
        let is_plain = self.sought.pinned().is_none() && before.leader.is_none();
        let fits = folds <= self.sought.folds.len() && is_plain;
        let (width, height) = if fits { self.sought.size(folds) } else { return None };
        let is_as_large = (rect.width() - width).abs() < ROUNDED && (rect.height() - height).abs() < ROUNDED;
        is_as_large.then(|| Candidate { folds, ..Candidate::new(rect, reluctance) })
    }

    /// Places, each with what it costs whatever the other labels do.
    pub(super) fn priced(&self, all: Vec<Candidate>, scene: &Surroundings) -> Vec<(Candidate, f64)> {
        self.priced_within(f64::INFINITY, all, scene)
    }

    /// The places that cost no more than `most`, each with what it costs whatever the other labels do.
    pub(super) fn priced_within(
        &self,
        most: f64,
        all: Vec<Candidate>,
        scene: &Surroundings,
    ) -> Vec<(Candidate, f64)> {
        let near_by = near_by(self.sought, &all, scene);
        let named = (self.sought, &self.things);
        let cost = |c: &Candidate| steady(own_cost(named, self.home, (c, most), &near_by, scene));
        let priced = all.into_iter().map(|c| (cost(&c), c));
        priced.filter(|(cost, _)| most.is_infinite() || *cost <= most).map(|(cost, c)| (c, cost)).collect()
    }

    /// The box of its glyphs at a place, without the room that it keeps.
    fn bounds(&self, candidate: &Candidate, frame: &Frame) -> Rect {
        let (sought, rect) = (self.sought, candidate.rect);
        if sought.room.beyond(sought) <= 0.0 {
            return rect;
        }
        let size = (sought.width(candidate.folds), rect.height());
        resized(&rect, origin(&sought.anchor, self.home, frame), size)
    }

    /// The label at its place: its lines below each other, centred but for notes.
    pub(super) fn placed(
        &self,
        (candidate, cost): (&Candidate, f64),
        frame: &Frame,
        weights: &Weights,
    ) -> Placed {
        let sought = self.sought;
        let bounds = self.bounds(candidate, frame);
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
        let Sought { key, role, part, shown, .. } = *sought;
        let home = self.home - Point::new(frame.panel.x0, frame.panel.y0);
        let leader = candidate
            .leader
            .map(|line| if bounds == candidate.rect { line } else { line.until(&bounds, &weights.places) });
        let (thing, span) = (self.things.own.clone(), sought.span.clone());
        let Candidate { folds, reluctance, .. } = *candidate;
        let standing = Standing { folds, reluctance, cost, loose: sought.loose, room: sought.room, stuck: 0 };
        Placed { key, role, lines, bounds, leader, thing, part, home, shown, standing, span }
    }
}

/// A cost rounded to whole [`PARTS`].
fn steady(cost: f64) -> f64 {
    (PARTS * cost).round() / PARTS
}
