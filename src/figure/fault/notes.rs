//! What is said of a picture that is drawn all the same, and what would better it.

use std::fmt;

use super::Fault;

impl Fault {
    /// What is said of a picture that is drawn all the same.
    pub(super) fn said(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OtherMoment { shown, asked, why } => {
                write!(f, "the panel shows {shown} in place of {asked}: {why}")
            }
            Self::OtherStep { asked, last } => {
                write!(f, "the panel shows step {last} in place of step {asked}: the algorithm took {last}")
            }
            Self::NoValue { value, why } => write!(f, "a dash stands for `{{={value}}}`: {why}"),
            Self::NothingToDraw { layer, why } => write!(f, "`{layer}` draws nothing: {why}"),
            Self::IdleOption { layer, option } => write!(f, "`{option}` of `{layer}` changes nothing here"),
            Self::NothingForOption { layer, option, why } => {
                write!(f, "`{option}` of `{layer}` draws nothing: {why}")
            }
            Self::EmptyView { what, reach: [[x0, y0], [x1, y1]] } => {
                write!(
                    f,
                    "the panel's `{what}` is empty: all that it draws is from ({x0}, {y0}) to ({x1}, {y1})"
                )
            }
            Self::NothingPlays { why } => write!(f, "nothing plays: {why}"),
            Self::NotHeld { what } => write!(f, "no layer draws `{what}`, so that nobody can drag it"),
            Self::StillText { what } => {
                write!(f, "the `{what}` of the figure stands still while panels play, and tells a moment")
            }
            Self::NoStepLeft { count } => {
                write!(f, "no step is left for these words: the figure has {count}")
            }
            Self::OutOfView { name } => {
                write!(f, "`{name}` is not on the picture: it is far from the bodies of the query")
            }
            Self::LayerOutOfView { layer } => {
                write!(f, "what `{layer}` draws lies beside the panel's `view`")
            }
            Self::NoLayers => f.write_str("the panel stays empty: its list of layers has none"),
            Self::SharedChart { layer } => {
                write!(f, "`{layer}` has axes of its own, and its lines run through the other layers")
            }
            Self::BadName { name, shown, reason, .. } => {
                write!(f, "the picture calls `{name}` {shown}: {reason}")
            }
            Self::TextDropped { what, lines, room } => {
                write!(f, "the {what} takes {lines} lines and the page has room for {room}: it is left out")
            }
            Self::LabelClash { fault, in_inset: true, .. } => write!(f, "{fault} (in an inset)"),
            Self::LabelClash { fault, panel: Some(panel), .. } => write!(f, "{fault} (panel {panel})"),
            Self::LabelClash { fault, .. } => write!(f, "{fault}"),
            // Of these no picture is drawn.
            Self::Scene(_)
            | Self::NoSuchStep { .. }
            | Self::NoHit
            | Self::UnsuitedLayer { .. }
            | Self::UnfedLayer { .. }
            | Self::BadTheme { .. }
            | Self::BadMarkup { .. }
            | Self::OffPage { .. } => Ok(()),
        }
    }

    /// What would help against it, if anything.
    pub(super) fn betters(&self) -> Option<String> {
        match self {
            Self::NoLayers => Some("without the key `layers` it shows what suits the answer".to_owned()),
            Self::EmptyView { what: "view", .. } => {
                Some("without the key `view` it shows all of it".to_owned())
            }
            Self::EmptyView { .. } => Some("give it a rectangle within that".to_owned()),
            Self::NothingPlays { .. } => Some("it is drawn as it stands".to_owned()),
            Self::NotHeld { .. } => Some("a page has its numbers all the same".to_owned()),
            Self::StillText { .. } => Some("the `caption` or `title` of a panel plays".to_owned()),
            Self::NoStepLeft { .. } => Some("`until` counts the figure's own steps, from 1".to_owned()),
            Self::OutOfView { .. } | Self::LayerOutOfView { .. } => {
                Some("a panel's `view = [x0, y0, x1, y1]` reaches as far as it says".to_owned())
            }
            Self::TextDropped { .. } => Some(
                "it stays in the alternative text; a larger canvas or a shorter text shows it".to_owned(),
            ),
            Self::BadName { key, .. } => {
                let fonts = "the fonts have Latin, Greek and Cyrillic letters";
                let labels = |key| format!("{fonts}; `{key} = \"…\"` in `[labels]` calls it otherwise");
                Some(key.map_or_else(|| fonts.to_owned(), labels))
            }
            Self::SharedChart { layer } => {
                Some(format!("give it a panel of its own: `[[panels]]` with `layers = [\"{layer}\"]`"))
            }
            Self::LabelClash { fault, in_inset, has_view, is_pinned, .. } => {
                let key = fault.label().0;
                // Where it is pinned it is so in the panel, too.
                let room = if *in_inset {
                    return Some("give the figure a larger `width` in `[canvas]`".to_owned());
                } else if *has_view {
                    "give the panel a wider `view`"
                } else {
                    "give the figure a larger `width` in `[canvas]`"
                };
                Some(if *is_pinned {
                    format!("pin it elsewhere or let it find a place, shorten its text, or {room}")
                } else {
                    format!("pin it: `{key} = {{ at = \"NE\" }}` in `[labels]`, or {room}")
                })
            }
            Self::OtherMoment { .. }
            | Self::OtherStep { .. }
            | Self::NothingToDraw { .. }
            | Self::NothingForOption { .. }
            | Self::IdleOption { .. }
            | Self::NoValue { .. }
            | Self::Scene(_)
            | Self::NoSuchStep { .. }
            | Self::NoHit
            | Self::UnsuitedLayer { .. }
            | Self::UnfedLayer { .. }
            | Self::BadTheme { .. }
            | Self::BadMarkup { .. }
            | Self::OffPage { .. } => None,
        }
    }
}
