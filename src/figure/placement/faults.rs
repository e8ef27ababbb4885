//! What is wrong with placed labels, for tests, warnings and the report.

use std::ops::Range;

use crate::drawing::Rect;
use crate::figure::sketch::Cover;

use super::Labelled;
use super::rect::{distance_to, length_inside};
use super::weights::Costs;

/// Length of a leader line beyond which it is a fault, page pixels.
const LONGEST_LEADER: f64 = 40.0;
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
    /// The label found no place and is left out.
    Dropped {
        /// The key of the label.
        key: &'static str,
        /// Where the label comes from in the scene, bytes of its text.
        span: Range<usize>,
    },
}

impl LabelFault {
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
            Self::Dropped { key, .. } => write!(f, "the label `{key}` found no place and is left out"),
        }
    }
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
        if label.leader.is_some_and(|(p, q)| (q - p).length() > LONGEST_LEADER) {
            found.push(LabelFault::LongLeader { key, span });
        }
    }
    found
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
