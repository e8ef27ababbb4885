//! What is wrong with placed labels, for tests, warnings and the report.

use std::ops::Range;

use crate::figure::sketch::Cover;

use super::Labelled;
use super::rect::{distance_to, length_inside};
use super::weights::Costs;

/// A leader line longer than this is a fault, page pixels.
const LONGEST_LEADER: f64 = 40.0;
/// Boxes of glyphs that share less than this in one direction only seem to touch, page pixels.
const SEEMING: f64 = 0.5;
/// The part of an arrowhead's disc, about its middle, that the head itself covers.
const HEAD: f64 = 0.75;

/// Something that a reader of the figure trips over.
#[derive(Clone, Debug, PartialEq)]
pub enum LabelFault {
    /// Two labels overlap.
    Overlap {
        /// The one.
        key: &'static str,
        /// The other.
        other: &'static str,
        /// Where the label comes from in the scene.
        span: Range<usize>,
    },
    /// A label covers a marker.
    OnMarker {
        /// The label.
        key: &'static str,
        /// Where the label comes from in the scene.
        span: Range<usize>,
    },
    /// A label covers an arrowhead.
    OnHead {
        /// The label.
        key: &'static str,
        /// Where the label comes from in the scene.
        span: Range<usize>,
    },
    /// A stroke that is not its own runs through a label.
    OnStroke {
        /// The label.
        key: &'static str,
        /// Where the label comes from in the scene.
        span: Range<usize>,
    },
    /// A label reaches over the edge of its panel.
    OverEdge {
        /// The label.
        key: &'static str,
        /// Where the label comes from in the scene.
        span: Range<usize>,
    },
    /// A leader line is longer than 40 px.
    LongLeader {
        /// The label.
        key: &'static str,
        /// Where the label comes from in the scene.
        span: Range<usize>,
    },
    /// A label found no place.
    Dropped {
        /// The label.
        key: &'static str,
        /// Where the label comes from in the scene.
        span: Range<usize>,
    },
}

impl LabelFault {
    /// The key of the label and where it comes from in the scene.
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

/// Every fault of a panel's labels; at most one of a kind for each label (or pair).
pub(crate) fn faults(panel: &Labelled) -> Vec<LabelFault> {
    let mut found: Vec<LabelFault> =
        panel.dropped.iter().map(|(key, span)| LabelFault::Dropped { key, span: span.clone() }).collect();
    for (i, label) in panel.placed.iter().enumerate() {
        let (key, span) = (label.key, label.span.clone());
        let rect = label.bounds.grown(-SEEMING);
        for other in &panel.placed[..i] {
            if rect.intersection(other.bounds.grown(-SEEMING)).is_some() {
                found.push(LabelFault::Overlap { key, other: other.key, span: span.clone() });
            }
        }
        let marker =
            |c: &Cover| matches!(*c, Cover::Marker { at, radius } if distance_to(&rect, at) < radius);
        let head =
            |c: &Cover| matches!(*c, Cover::Head { at, radius } if distance_to(&rect, at) < HEAD * radius);
        let stroke = |c: &Cover| matches!(*c, Cover::Stroke { from, to, .. } if length_inside(from, to, &rect).is_some());
        if panel.obstacles.iter().any(|o| marker(&o.cover)) {
            found.push(LabelFault::OnMarker { key, span: span.clone() });
        }
        if panel.obstacles.iter().any(|o| head(&o.cover)) {
            found.push(LabelFault::OnHead { key, span: span.clone() });
        }
        if panel.obstacles.iter().any(|o| o.part != label.part && stroke(&o.cover)) {
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
