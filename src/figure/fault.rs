//! What can be wrong with a figure: what its plan refuses and what its drawing warns of.
//!
//! A [`Fault`] keeps fields and not sentences, as the reader's own [`scene::Fault`](crate::scene::Fault)
//! does, and looks like one to who reads the message. Codes stand in the one list of
//! [`ERRORS`](crate::scene::ERRORS).

use std::fmt;
use std::ops::Range;

use crate::scene::{self, Explain, NOTES, Severity, Source, codes};

use super::placement::LabelFault;

/// What is wrong with a figure, with its place in the scene.
pub(crate) type Problem = scene::Problem<Fault>;

/// What is wrong with a figure.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// A word, key, value or amount that the reader of scenes would refuse with the same words.
    Scene(scene::Fault),
    /// A panel shows a step that the algorithm did not take.
    NoSuchStep {
        /// The step that the panel shows, from 1.
        step: usize,
        /// How many steps the algorithm took.
        took: usize,
    },
    /// A panel shows the moment of the hit, or of a miss, and the question is not for one.
    NoHit,
    /// A note: a panel is of the hit, or of a miss, and the answer is another, so that it shows another
    /// moment.
    OtherMoment {
        /// The moment that it shows, as "the closest approach".
        shown: &'static str,
        /// The moment that the scene names, as "the hit".
        asked: &'static str,
        /// How the answer turned out, as "the answer is a miss".
        why: &'static str,
    },
    /// A note: a panel is of a step that the algorithm did not need, so that it shows the last one.
    OtherStep {
        /// The step that the scene names, from 1.
        asked: usize,
        /// The last step, which is shown.
        last: usize,
    },
    /// A note: this answer has nothing for a layer that another answer could feed.
    NothingToDraw {
        /// The name of the layer.
        layer: &'static str,
        /// How the answer turned out, or what the case is.
        why: &'static str,
    },
    /// A note: a body that the query is not about lies outside of every panel.
    OutOfView {
        /// Its name.
        name: String,
    },
    /// A note: all that a layer draws lies beside what its panel shows.
    LayerOutOfView {
        /// The name of the layer.
        layer: &'static str,
    },
    /// A note: the figure was to play, and none of its panels does.
    NothingPlays {
        /// What the case is, as "no body moves".
        why: &'static str,
    },
    /// A note: panels play, and a text of the figure tells their moment, which it has only once.
    StillText {
        /// Which text, as "headline".
        what: &'static str,
    },
    /// A note: the scene has words for more steps than the figure has.
    NoStepLeft {
        /// How many it has.
        count: usize,
    },
    /// A note: something that a scene lets be dragged, and no layer draws it.
    NotHeld {
        /// What it is, as the scene writes it.
        what: String,
    },
    /// A flag of a layer that makes no difference.
    IdleOption {
        /// The name of the layer.
        layer: &'static str,
        /// The option.
        option: &'static str,
    },
    /// A warning: the list of a panel's layers is empty, and so is the panel.
    NoLayers,
    /// A note: an option of a layer has nothing to draw here, though the layer has.
    NothingForOption {
        /// The name of the layer.
        layer: &'static str,
        /// The option.
        option: &'static str,
        /// What the case is, as "the bodies are apart".
        why: &'static str,
    },
    /// A warning: what a panel draws lies all outside of its `view`, so that it stays empty, or of its
    /// `inset`.
    EmptyView {
        /// Which of the two.
        what: &'static str,
        /// The smallest and the largest coordinates of what is drawn, in the panel's space.
        reach: [[f64; 2]; 2],
    },
    /// A layer that shows another space than its panel.
    UnsuitedLayer {
        /// The name of the layer.
        layer: &'static str,
        /// The space that it shows, as a scene names it.
        space: &'static str,
    },
    /// A chart that shares its panel with layers that show where things are.
    SharedChart {
        /// The name of the layer.
        layer: &'static str,
    },
    /// A layer that draws what this query does not give.
    UnfedLayer {
        /// The name of the layer.
        layer: &'static str,
        /// What it needs of the scene.
        needs: String,
    },
    /// A note: this answer lacks a value that a text names, and a dash stands in its place.
    NoValue {
        /// The name of the value.
        value: String,
        /// How the answer turned out.
        why: &'static str,
    },
    /// A note: the name of a shape has letters that the embedded faces lack, and the picture calls it by
    /// another one.
    BadName {
        /// The name in the scene.
        name: String,
        /// What the picture calls it.
        shown: String,
        /// The key of `[labels]` that gives it another text, where there is one.
        key: Option<&'static str>,
        /// Which letter, in the typesetter's words.
        reason: String,
    },
    /// A theme file that can't be read, or is no theme.
    BadTheme {
        /// The name in the scene.
        name: String,
        /// Why not.
        reason: String,
    },
    /// A text that can't be typeset.
    BadMarkup {
        /// The text, its values filled in.
        markup: String,
        /// Why not, in the typesetter's words.
        reason: String,
    },
    /// A warning: the page has no room for the caption or the headline, which is left out.
    TextDropped {
        /// Which of the two.
        what: &'static str,
        /// How many lines it takes.
        lines: usize,
        /// How many lines the page has room for.
        room: usize,
    },
    /// A place that is so far outside of what a panel shows that it can't be written.
    OffPage {
        /// What has the place, as "body-A".
        group: String,
    },
    /// A warning: a label stands where a reader trips over it, or nowhere.
    LabelClash {
        /// What is wrong with it.
        fault: LabelFault,
        /// Which panel it is in, from 1, where there are several and it is in no inset.
        panel: Option<usize>,
        /// Whether it is in an inset.
        in_inset: bool,
        /// Whether the scene has a panel of its own, which may have a `view`.
        has_view: bool,
        /// Whether the scene says where the label stands.
        is_pinned: bool,
    },
}

impl From<scene::Fault> for Fault {
    fn from(fault: scene::Fault) -> Self {
        Self::Scene(fault)
    }
}

impl From<scene::Problem> for Problem {
    fn from(problem: scene::Problem) -> Self {
        Self::new(problem.fault.into(), problem.span)
    }
}

impl Fault {
    /// How grave it is, where the figure is drawn all the same.
    ///
    /// ```
    /// use tracefig::{figure::Fault, scene::Severity};
    /// let fault = Fault::NothingToDraw { layer: "contact", why: "the answer is a miss" };
    /// assert_eq!(fault.severity(), Severity::Note);
    /// assert_eq!(Fault::TextDropped { what: "caption", lines: 9, room: 4 }.severity(), Severity::Warning);
    /// ```
    #[must_use]
    pub fn severity(&self) -> Severity {
        match self {
            Self::OtherMoment { .. }
            | Self::OtherStep { .. }
            | Self::NothingToDraw { .. }
            | Self::NothingForOption { .. }
            | Self::IdleOption { .. }
            | Self::NothingPlays { .. }
            | Self::StillText { .. }
            | Self::NoStepLeft { .. }
            | Self::NotHeld { .. }
            | Self::OutOfView { .. }
            | Self::LayerOutOfView { .. }
            | Self::BadName { .. }
            | Self::NoValue { .. } => Severity::Note,
            Self::NoLayers
            | Self::SharedChart { .. }
            | Self::EmptyView { .. }
            | Self::TextDropped { .. }
            | Self::LabelClash { .. } => Severity::Warning,
            _ => Severity::Error,
        }
    }
}

impl Explain for Fault {
    fn code(&self) -> &'static str {
        match self {
            Self::Scene(fault) => fault.code(),
            Self::NoSuchStep { .. } | Self::NoHit => codes::NO_SUCH_MOMENT.code,
            Self::OtherMoment { .. }
            | Self::OtherStep { .. }
            | Self::NothingToDraw { .. }
            | Self::NothingForOption { .. }
            | Self::IdleOption { .. }
            | Self::NoValue { .. } => codes::NOT_IN_ANSWER.code,
            Self::NothingPlays { .. } | Self::StillText { .. } => codes::NOTHING_PLAYS.code,
            Self::NoStepLeft { .. } => codes::NO_STEP_LEFT.code,
            Self::NotHeld { .. } => codes::NOT_HELD.code,
            Self::OutOfView { .. } | Self::LayerOutOfView { .. } => codes::OUT_OF_VIEW.code,
            Self::NoLayers => codes::NO_LAYERS.code,
            Self::EmptyView { .. } => codes::EMPTY_VIEW.code,
            Self::UnsuitedLayer { .. } => codes::UNSUITED_LAYER.code,
            Self::SharedChart { .. } => codes::SHARED_CHART.code,
            Self::UnfedLayer { .. } => codes::UNFED_LAYER.code,
            Self::BadMarkup { .. } => codes::BAD_MARKUP.code,
            Self::BadName { .. } => codes::BAD_NAME.code,
            Self::TextDropped { .. } => codes::CAPTION_DROPPED.code,
            Self::BadTheme { .. } => codes::BAD_THEME.code,
            Self::OffPage { .. } => codes::OFF_PAGE.code,
            Self::LabelClash { .. } => codes::LABEL_CLASH.code,
        }
    }

    fn remedy(&self) -> Option<String> {
        if let Self::Scene(fault) = self { fault.remedy() } else { self.help() }
    }

    fn told(&self, source: &Source, span: &Range<usize>) -> String {
        match self {
            Self::Scene(fault) => fault.told(source, span),
            _ => self.to_string(),
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::Scene(fault) => fault.help(),
            Self::UnfedLayer { needs, .. } => Some(format!("it needs {needs}")),
            Self::UnsuitedLayer { space, .. } => Some(format!("such a panel has `space = \"{space}\"`")),
            Self::OffPage { .. } => Some(
                "give the panel a wider `view`, or none, or leave out the layer that draws it".to_owned(),
            ),
            Self::NoHit => Some(
                "`kind = \"linear-sweep\"` and `kind = \"time-of-impact\"` ask for one; a `time` is a number \
                 too"
                    .to_owned(),
            ),
            Self::NoSuchStep { took: 0, .. } => Some("without the key `step` it shows the answer".to_owned()),
            Self::NoSuchStep { took, .. } => Some(format!("they are numbered from 1 to {took}")),
            Self::BadTheme { .. } => Some("`tracefig list themes` has those that are built in".to_owned()),
            Self::BadMarkup { .. } => Some(
                "values stand as `{=time}`, words in a colour as `{a|words}`, formulas as `$x$`; `\\$` is a \
                 dollar"
                    .to_owned(),
            ),
            note if NOTES => note.betters(),
            _ => None,
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene(fault) => fault.fmt(f),
            Self::NoSuchStep { step, took } => {
                write!(f, "expected a step of the algorithm, got {step}: it took {took}")
            }
            Self::NoHit => {
                f.write_str("the panel shows the moment of a hit or a miss, but the question is not for one")
            }
            Self::UnsuitedLayer { layer, space } => {
                write!(f, "the layer `{layer}` is of the space `{space}`, and the panel of another")
            }
            Self::UnfedLayer { layer, .. } => write!(f, "this scene can't feed the layer `{layer}`"),
            Self::BadTheme { name, reason } => write!(f, "the theme `{name}` can't be used: {reason}"),
            Self::BadMarkup { markup, reason } => write!(f, "`{markup}` can't be typeset: {reason}"),
            Self::OffPage { group } => write!(f, "`{group}` has a place that is not on any page"),
            note if NOTES => note.said(f),
            _ => Ok(()),
        }
    }
}

mod notes;
#[cfg(test)]
mod tests;
