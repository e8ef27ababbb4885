//! Labels place themselves.
//!
//! A label has up to 32 candidate places around what it belongs to, a name in an area some more. A place
//! costs more the more it hides: foreign strokes, markers, arrowheads, the panel's edge; two places that
//! overlap cost each other most. Labels are set in the order of regret (who would lose most by waiting goes
//! first), then one after the other moves to its best place until none wants to. No clock and no randomness:
//! the same figure gives the same places.
//!
//! The approach follows Christensen, Marks, Shieber, "An Empirical Study of Algorithms for Point-Feature
//! Label Placement", ACM Transactions on Graphics 14(3), 1995, with regret as the greedy order.
//!
//! Every label stands nearer to its own thing than to any other that it could name, or a [`leader`] line
//! joins them.
//!
//! In a figure that moves, a label [rests](rest) where it stood in the frame before, while that is
//! comfortable, and keeps [`reserve`] for the digits of other frames; [`moving`] says who must not rest, nor
//! stand where the scene pins it.
//!
//! The way through: [`worth`] says which labels seek a place, [`things`](mod@things) what each could name,
//! [`candidates`] and [`inside`] offer places, [`anywhere`] all others, [`cost`] and [`astray`] price them,
//! [`choices`] chooses among them, [`solve`] leads the search, [`faults`] says what is still wrong. All
//! their numbers are [`weights`]. [`tinted`] gives a halo the colour of what lies under it.

mod anywhere;
mod astray;
mod candidates;
mod choices;
mod cost;
mod faults;
mod inside;
mod leader;
mod moving;
mod pole;
mod polyline;
mod rect;
mod reserve;
mod rest;
mod seeker;
mod solve;
mod things;
mod tinted;
mod weights;
mod worth;

use std::ops::Range;
use std::sync::Arc;

use crate::drawing::{Offset, Point, Rect, Role, Shown};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Obstacle, Rank};
use crate::scene::LabelPlace;
use crate::typeset::Line;

use weights::Places;

pub use faults::LabelFault;
pub(crate) use faults::faults;
pub(crate) use leader::Leader;
pub(crate) use moving::place;
pub(crate) use reserve::Reserve;
pub(crate) use solve::Ground;
pub(crate) use things::{Thing, things};
pub(crate) use tinted::tint;

/// A label whose text is set and whose place is sought.
#[derive(Clone, Debug)]
pub(crate) struct Sought {
    /// Its key in `[labels]`.
    pub(crate) key: &'static str,
    /// Its lines, set, from the top.
    pub(crate) lines: Vec<Arc<Line>>,
    /// Other ways to break it into lines.
    pub(crate) folds: Vec<Fold>,
    /// What it belongs to, in the panel's space.
    pub(crate) anchor: Anchor,
    /// Its colour.
    pub(crate) role: Role,
    /// Which label is left out where two clash beyond help.
    pub(crate) rank: Rank,
    /// The number of the part of the drawing that it belongs to, whose strokes it may touch.
    pub(crate) part: usize,
    /// Where the scene wants it, if it says so.
    pub(crate) pin: Option<LabelPlace>,
    /// Whether it may stand elsewhere nevertheless: in a figure that moves it stood badly there.
    pub(crate) loose: bool,
    /// The room that it keeps for wider texts of other frames.
    pub(crate) room: Reserve,
    /// When it comes and goes.
    pub(crate) shown: Shown,
    /// Where it comes from in the scene: what a warning points at.
    pub(crate) span: Range<usize>,
}

/// A way to break a label into lines.
#[derive(Clone, Debug)]
pub(crate) struct Fold {
    /// The lines, set, from the top.
    pub(crate) lines: Vec<Arc<Line>>,
    /// Where it is broken.
    pub(crate) cut: Cut,
}

/// Where a label is broken into lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cut {
    /// At spaces.
    AtSpaces,
    /// In long words too.
    InWords,
    /// Between a sum and its result.
    InSum,
    /// In the names of bodies in scripts, where no place suits the whole label.
    InNames,
}

impl Fold {
    /// How little a label likes to be broken so.
    fn reluctance(&self, w: &Places) -> f64 {
        let lines = u32::try_from(self.lines.len()).map_or(f64::INFINITY, f64::from);
        let cut = match self.cut {
            Cut::AtSpaces => 0.0,
            Cut::InWords => w.broken,
            Cut::InSum => w.result_below,
            Cut::InNames => w.brief,
        };
        w.folded * lines + cut
    }
}

/// Room between two lines of a label, page pixels.
const LEADING: f64 = 6.0;

impl Sought {
    /// Where the scene wants it, unless it is loose.
    fn pinned(&self) -> Option<LabelPlace> {
        self.pin.filter(|_| !self.loose)
    }

    /// Its lines: its own, or those of a way to break it, from 1.
    fn folded(&self, folds: usize) -> &[Arc<Line>] {
        folds.checked_sub(1).and_then(|i| self.folds.get(i)).map_or(&self.lines, |fold| &fold.lines)
    }

    /// The width in page pixels of its own lines, or of those of a way to break it, from 1.
    fn width(&self, folds: usize) -> f64 {
        self.folded(folds).iter().map(|l| l.width).fold(0.0, f64::max)
    }

    /// Width and height in page pixels of its own lines, or of those of a way to break it, from 1, with the
    /// room that it keeps.
    fn size(&self, folds: usize) -> (f64, f64) {
        let height: f64 = self.folded(folds).iter().map(|l| l.height() + LEADING).sum();
        (self.width(folds) + self.room.beyond(self), (height - LEADING).max(0.0))
    }
}

/// A place that a label may take, and what it costs by itself.
#[derive(Clone, Debug, PartialEq)]
struct Candidate {
    /// The box of its glyphs there, page pixels.
    rect: Rect,
    /// How far it is from the best kind of place: 1 is a slight preference, 10 a strong one.
    reluctance: f64,
    /// The line that leads from what it belongs to, where it stands far off or near something else.
    leader: Option<Leader>,
    /// Which of the ways to break the label into lines it takes: 0 for its own.
    folds: usize,
}

impl Candidate {
    /// A place for a label on its own lines and without a leader line.
    fn new(rect: Rect, reluctance: f64) -> Self {
        Self { rect, reluctance, leader: None, folds: 0 }
    }
}

/// How a label came by its place: by that it is judged in the next frame of a figure that moves.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Standing {
    /// Which of the ways to break the label into lines it takes: 0 for its own.
    folds: usize,
    /// How far its place is from the best kind of place.
    reluctance: f64,
    /// What the place cost by itself when it was chosen.
    cost: f64,
    /// Whether the scene wants it elsewhere.
    loose: bool,
    /// The room that it kept.
    room: Reserve,
    /// Since how many frames it stands badly, as it would wherever it went; 0 where it stands well.
    stuck: usize,
}

/// A label at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// Its key in the `[labels]` of a scene, as `d` for a distance.
    pub key: &'static str,
    /// Its colour.
    pub(crate) role: Role,
    /// What was set, with the left end of each baseline, page pixels.
    pub(crate) lines: Vec<(Point, Arc<Line>)>,
    /// The box of its glyphs, page pixels.
    pub bounds: Rect,
    /// A line to what it belongs to, where it stands far from it or near something else.
    pub(crate) leader: Option<Leader>,
    /// What it belongs to; none for a note at a corner of the panel.
    pub(crate) thing: Option<Thing>,
    /// The number of the part of the drawing that it belongs to.
    pub(crate) part: usize,
    /// Where what it belongs to lies, page pixels from the upper left corner of its panel.
    pub(crate) home: Offset,
    /// When it comes and goes.
    pub(crate) shown: Shown,
    /// What the picture after this one has to know of its place.
    standing: Standing,
    /// Where it comes from in the scene: what a warning points at.
    pub(crate) span: Range<usize>,
}

impl Placed {
    /// Whether a line leads to the label from what it belongs to.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1 }
    /// query = { kind = "bounds", of = ["A"] }
    /// labels.O.at = [40, -30]
    /// panels = [{ space = "world", layers = ["shapes", "origin"] }]
    /// "#;
    /// let scene = read(&Source::new("pinned.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let figure = draw(&plan, plan.theme, "pinned");
    /// let led = |key| figure.panels[0].placed.iter().any(|p| p.key == key && p.is_led());
    /// assert!(led("O") && !led("A"));
    /// ```
    #[must_use]
    pub fn is_led(&self) -> bool {
        self.leader.is_some()
    }
}

/// A panel with its labels.
#[derive(Clone, Debug, PartialEq)]
pub struct Labelled {
    /// The panel on the page, and its map from its space.
    pub frame: Frame,
    /// What labels keep off.
    pub(crate) obstacles: Vec<Obstacle>,
    /// Everything that a label could name.
    pub(crate) things: Vec<Thing>,
    /// The labels that found a place, in the order in which the layers asked for them.
    pub placed: Vec<Placed>,
    /// Keys of labels that did not, with the places that warnings point at.
    pub(crate) dropped: Vec<(&'static str, Range<usize>)>,
}
