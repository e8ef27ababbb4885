//! Which event a mark comes with, and which takes it away: a layer says it before it draws.

use crate::drawing::{Item, Shown};
use crate::figure::cue::Cue;
use crate::figure::frame::{Extent, union};

use super::{Cover, Obstacle, Sketch, Weight};

/// The cues of a panel so far, and those of what is drawn now.
#[derive(Debug, Default)]
pub(super) struct Cues {
    /// Each cue once, in the order in which they were named.
    pub(super) known: Vec<Cue>,
    /// When what is drawn now comes and goes.
    pub(super) now: Shown,
    /// Whether labels keep off what goes again.
    keeps: bool,
}

impl Cues {
    /// What is drawn from here on was there before the first event.
    pub(super) fn rest(&mut self) {
        self.now = Shown::ALWAYS;
    }

    /// Says of an item that it is drawn now.
    pub(super) fn stamp(&self, item: &mut Item) {
        item.for_each_shown(&|shown| *shown = self.now);
    }

    /// The number of a cue: 2 for the first one, as 1 is what was there before.
    fn number(&mut self, cue: Cue) -> usize {
        let known = self.known.iter().rposition(|&other| other == cue);
        let index = known.unwrap_or(self.known.len());
        if known.is_none() {
            self.known.push(cue);
        }
        index + 2
    }
}

/// Makes what is soon gone an obstacle that a label crosses before others, and that names nothing.
fn light(obstacle: &mut Obstacle) {
    obstacle.weight = Weight::Light;
    if let Cover::Marker { at, radius: half } | Cover::Head { at, radius: half } = obstacle.cover {
        obstacle.cover = Cover::Stroke { from: at, to: at, half };
    }
}

/// What there was before something that passes was drawn.
struct Before {
    /// Obstacles, labels that are asked for, things without one, handles.
    counts: [usize; 4],
    /// What was reached.
    extent: Extent,
    /// Details.
    details: usize,
    /// Items of the layer, which stay.
    stays: usize,
}

impl Sketch<'_> {
    /// With whether it is of a figure in steps.
    pub(crate) fn in_steps(mut self, is_so: bool) -> Self {
        self.cues.keeps = is_so;
        self
    }

    /// What is drawn and labelled from here to the end of the layer comes with this event; without one it was
    /// there before the first event.
    pub(crate) fn since(&mut self, cue: impl Into<Option<Cue>>) -> &mut Self {
        let since = cue.into().map_or(1, |cue| self.cues.number(cue));
        self.cues.now = Shown { since, until: None };
        self
    }

    /// What `draw` draws comes with one event and goes with another: only steps between them show it. The
    /// finished figure has none of it, so nothing of it has a label or a handle; labels keep off it, and a
    /// panel makes room for it, only where it is drawn in steps. It is the last that its layer draws, and
    /// lies under what stays.
    pub(crate) fn passing(&mut self, cues: [Cue; 2], draw: impl FnOnce(&mut Self)) {
        let before = self.begin_passing(cues);
        draw(self);
        self.end_passing(before);
    }

    /// What is drawn from here on passes; what there was before.
    fn begin_passing(&mut self, [from, to]: [Cue; 2]) -> Before {
        let counts = [self.obstacles.len(), self.requests.len(), self.unnamed.len(), self.holds.len()];
        let (extent, details) = (self.extent.take(), self.details.len());
        let stays = self.layers.last().map_or(0, |layer| layer.items.len());
        self.since(from);
        self.cues.now.until = Some(self.cues.number(to));
        Before { counts, extent, details, stays }
    }

    /// What is drawn from here on stays.
    fn end_passing(&mut self, Before { counts, extent, details, stays }: Before) {
        if let Some(layer) = self.layers.last_mut() {
            let mut items = layer.items.split_off(stays);
            items.append(&mut layer.items);
            layer.items = items;
        }
        if self.cues.keeps {
            self.obstacles.iter_mut().skip(counts[0]).for_each(light);
        } else {
            self.obstacles.truncate(counts[0]);
        }
        self.requests.truncate(counts[1]);
        self.unnamed.truncate(counts[2]);
        self.holds.truncate(counts[3]);
        self.passed = union(self.passed, std::mem::replace(&mut self.extent, extent));
        self.details.truncate(details);
        self.since(None);
    }
}
