//! `[[steps]]`: which steps of a figure are shown as one or left out, and in what words.
//!
//! How many steps there are is known when the figure is drawn; here they are in order.

use std::ops::Range;

use super::checked::{Checked, as_list, check, too_many};
use super::fields::STEP;
use super::limits::MAX_STEPS;
use super::node::Node;
use super::problem::{Fault, Problems};

/// Some steps of a figure that follow one another, as a scene wants them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StepWords {
    /// The last of them, counted from 1 in the figure as it comes about without such words; `None` is the one
    /// after those before. Beyond the last step of the figure it is that one.
    pub until: Option<usize>,
    /// What they are called, plain text; `None` is as the last of them.
    pub title: Option<String>,
    /// What they say, plain text; `None` is what they say anyway.
    pub text: Option<String>,
    /// Whether they come with the step after them, without words.
    pub skip: bool,
    /// Where the scene says so, in bytes of the source text.
    pub span: Range<usize>,
}

/// Reads what is said of the steps; what is wrong is told and left out.
pub(super) fn read(top: &Checked<'_>, p: &mut Problems) -> Vec<StepWords> {
    let Some(node) = top.get("steps") else { return Vec::new() };
    let items = as_list(node).unwrap_or_default();
    if items.len() > MAX_STEPS {
        too_many("`steps`", MAX_STEPS, "steps", items.len(), &node.span, p);
        return Vec::new();
    }
    let mut before = 0;
    items.iter().filter_map(|item| step(item, &mut before, p)).collect()
}

/// Reads one entry; `before` is the last step of the entry before.
pub(super) fn step(node: &Node, before: &mut usize, p: &mut Problems) -> Option<StepWords> {
    let table = check(node, "steps", STEP.place, STEP.fields, p)?;
    let until = table.count("until");
    if let Some(until) = until.as_ref().filter(|until| until.value <= *before) {
        let message = format!("`until` goes on from step {before}: expected more, got {}", until.value);
        let help = format!("the least is `until = {}`", *before + 1);
        p.add(Fault::Conflict { message, help }, &until.span);
        return None;
    }
    *before = until.as_ref().map_or(*before + 1, |until| until.value);
    let text = |key| table.text(key).map(|text| text.value);
    let skip = table.switch("skip").unwrap_or(false);
    if skip && let Some(words) = table.text("title").or_else(|| table.text("text")) {
        let message = "a step with `skip` is not told: expected no `title` and no `text`".to_owned();
        let help = "leave the words out, or `skip`".to_owned();
        p.add(Fault::Conflict { message, help }, &words.span);
    }
    let (until, [title, said]) = (until.map(|until| until.value), ["title", "text"].map(text));
    Some(StepWords { until, title, text: said, skip, span: node.span.clone() })
}
