//! What is wrong with placed labels, for tests, warnings and the report.

use std::ops::Range;

use crate::drawing::Rect;
use crate::figure::sketch::{Cover, Obstacle};

use super::rect::{distance_to, length_inside};
use super::things::{ALIKE, Thing};
use super::weights::Costs;
use super::{Labelled, Placed};

/// How much boxes of glyphs may share in one direction and only seem to touch, page pixels.
const SEEMING: f64 = 0.5;
/// The part of an arrowhead's disc, about its middle, that the head itself covers.
const HEAD: f64 = 0.75;

/// A label that a reader of the figure trips over.
#[derive(Clone, Debug, PartialEq)]
pub enum LabelFault {
    /// The label overlaps another one.
    Overlap {
        /// The key of the label.
        key: &'static str,
        /// The key of the other label.
        other: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// The label covers a marker.
    OnMarker {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// The label covers an arrowhead.
    OnHead {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// A line of something else runs through the label.
    OnStroke {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// The label reaches over the edge of its panel.
    OverEdge {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// The line that leads to the label is longer than 40 page pixels.
    LongLeader {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// The label stands as near to another thing that it could name as to its own, or nearer, and no line
    /// leads to it.
    Misleading {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// Two labels stand each at what the other one names.
    Swapped {
        /// The key of the label.
        key: &'static str,
        /// The key of the other label.
        other: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// The line that leads to a label runs under another one.
    UnderLabel {
        /// The key of the label that the line leads to.
        key: &'static str,
        /// The key of the other label.
        other: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
    /// The label found no place and is left out.
    Dropped {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
}

impl Placed {
    /// Whether the line that leads to it runs under another label.
    fn leads_under(&self, other: &Self) -> bool {
        let line = self.leader.filter(|_| !std::ptr::eq(self, other));
        line.is_some_and(|line| length_inside(line.from, line.to, &core(&other.bounds)).is_some())
    }
}

impl Labelled {
    /// Whether nothing of the panel lies under a box: no label, and nothing that labels keep off.
    pub(crate) fn is_free(&self, bounds: &Rect) -> bool {
        let has_label = self.placed.iter().any(|label| label.bounds.intersection(*bounds).is_some());
        !has_label && !hides(&self.obstacles, usize::MAX, bounds)
    }

    /// Whether a line of something else runs through a label of the panel.
    pub(crate) fn is_crossed(&self, label: &Placed) -> bool {
        let rect = core(&label.bounds);
        // Most places cost less than any line costs, and need no search.
        label.standing.cost >= Costs::TUNED.light
            && self.obstacles.iter().any(|o| o.part != label.part && is_stroke_under(&o.cover, &rect))
    }
}

impl LabelFault {
    /// Whether a label of a key that comes from a place of the scene is at fault, alone or with another one.
    pub(super) fn is_of(&self, label: &str, from: &Range<usize>) -> bool {
        let other = match self {
            Self::Overlap { other, .. } | Self::Swapped { other, .. } | Self::UnderLabel { other, .. } => {
                other
            }
            _ => "",
        };
        self.label() == (label, from) || other == label
    }

    /// The key of the label, as in `[labels]`, and where it comes from in the scene: bytes of its text.
    ///
    /// ```
    /// use tracefig::figure::LabelFault;
    /// let fault = LabelFault::Dropped { key: "d", span: 10..20 };
    /// assert_eq!(fault.label(), ("d", &(10..20)));
    /// ```
    #[must_use]
    pub fn label(&self) -> (&'static str, &Range<usize>) {
        match self {
            Self::Overlap { key, span, .. }
            | Self::OnMarker { key, span }
            | Self::OnHead { key, span }
            | Self::OnStroke { key, span }
            | Self::OverEdge { key, span }
            | Self::LongLeader { key, span }
            | Self::Misleading { key, span }
            | Self::Swapped { key, span, .. }
            | Self::UnderLabel { key, span, .. }
            | Self::Dropped { key, span } => (key, span),
        }
    }
}

impl std::fmt::Display for LabelFault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Overlap { key, other, .. } => write!(f, "the label `{key}` overlaps the label `{other}`"),
            Self::OnMarker { key, .. } => write!(f, "the label `{key}` covers a marker"),
            Self::OnHead { key, .. } => write!(f, "the label `{key}` covers an arrowhead"),
            Self::OnStroke { key, .. } => write!(f, "a line runs through the label `{key}`"),
            Self::OverEdge { key, .. } => write!(f, "the label `{key}` reaches over the edge of its panel"),
            Self::LongLeader { key, .. } => write!(f, "the label `{key}` stands far from what it names"),
            Self::Misleading { key, .. } => {
                write!(f, "the label `{key}` seems to name something else than its own thing")
            }
            Self::Swapped { key, other, .. } => {
                write!(f, "the labels `{key}` and `{other}` stand each at what the other one names")
            }
            Self::UnderLabel { key, other, .. } => {
                write!(f, "the line to the label `{key}` runs under the label `{other}`")
            }
            Self::Dropped { key, .. } => write!(f, "the label `{key}` found no place and is left out"),
        }
    }
}

/// Whether a label of a part of the drawing hides a marker, an arrowhead or a stroke of something else.
pub(super) fn hides(obstacles: &[Obstacle], part: usize, bounds: &Rect) -> bool {
    let rect = core(bounds);
    let hidden = |o: &Obstacle| {
        is_marker_under(&o.cover, &rect)
            || is_head_under(&o.cover, &rect)
            || o.part != part && is_stroke_under(&o.cover, &rect)
    };
    obstacles.iter().any(hidden)
}

/// The part of a label's box that nothing may share with it: all but a seam, and of a tiny one its middle.
fn core(bounds: &Rect) -> Rect {
    bounds.grown(-SEEMING.min(0.5 * bounds.width()).min(0.5 * bounds.height()))
}

/// Every fault of a panel's labels; at most one of a kind for each label (or pair).
pub(crate) fn faults(panel: &Labelled) -> Vec<LabelFault> {
    let mut found: Vec<LabelFault> =
        panel.dropped.iter().map(|(key, span)| LabelFault::Dropped { key, span: span.clone() }).collect();
    for (i, label) in panel.placed.iter().enumerate() {
        let (key, span) = (label.key, label.span.clone());
        let rect = core(&label.bounds);
        for other in &panel.placed[..i] {
            if rect.intersection(core(&other.bounds)).is_some() {
                found.push(LabelFault::Overlap { key, other: other.key, span: span.clone() });
            }
        }
        for other in panel.placed.iter().filter(|other| label.leads_under(other)) {
            found.push(LabelFault::UnderLabel { key, other: other.key, span: span.clone() });
        }
        let covers =
            |hides: fn(&Cover, &Rect) -> bool| panel.obstacles.iter().any(|o| hides(&o.cover, &rect));
        if covers(is_marker_under) {
            found.push(LabelFault::OnMarker { key, span: span.clone() });
        }
        if covers(is_head_under) {
            found.push(LabelFault::OnHead { key, span: span.clone() });
        }
        if panel.obstacles.iter().any(|o| o.part != label.part && is_stroke_under(&o.cover, &rect)) {
            found.push(LabelFault::OnStroke { key, span: span.clone() });
        }
        let edge = panel.frame.panel.grown(Costs::TUNED.spill + SEEMING);
        if edge.union(label.bounds) != edge {
            found.push(LabelFault::OverEdge { key, span: span.clone() });
        }
        if label.leader.is_some_and(|line| line.is_long()) {
            found.push(LabelFault::LongLeader { key, span: span.clone() });
        }
        if misleads(label, &panel.things) {
            found.push(LabelFault::Misleading { key, span: span.clone() });
        }
        for other in panel.placed[..i].iter().filter(|other| are_swapped(label, other)) {
            found.push(LabelFault::Swapped { key, other: other.key, span: span.clone() });
        }
    }
    found
}

/// Whether a label names something else to who looks at it.
fn misleads(label: &Placed, things: &[Thing]) -> bool {
    label.leader.is_none()
        && label.thing.as_ref().is_some_and(|own| own.margin(things, &label.bounds) <= ALIKE)
}

/// Whether each of two labels stands nearer to what the other one names.
fn are_swapped(label: &Placed, other: &Placed) -> bool {
    let (Some(own), Some(its)) = (&label.thing, &other.thing) else { return false };
    let astray = |label: &Placed, own: &Thing, its: &Thing| {
        label.leader.is_none() && own.margin(std::slice::from_ref(its), &label.bounds) < -ALIKE
    };
    astray(label, own, its) && astray(other, its, own)
}

/// Whether it is a marker that reaches under a label.
fn is_marker_under(cover: &Cover, rect: &Rect) -> bool {
    matches!(*cover, Cover::Marker { at, radius } if distance_to(rect, at) < radius)
}

/// Whether it is an arrowhead that reaches under a label.
fn is_head_under(cover: &Cover, rect: &Rect) -> bool {
    matches!(*cover, Cover::Head { at, radius } if distance_to(rect, at) < HEAD * radius)
}

/// Whether it is a stroke that runs under a label.
fn is_stroke_under(cover: &Cover, rect: &Rect) -> bool {
    matches!(*cover, Cover::Stroke { from, to, .. } if length_inside(from, to, rect).is_some())
}
