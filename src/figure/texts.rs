//! The texts of a scene: its values filled in, its lines set, its caption broken.
//!
//! Each is set once before anything is drawn, so that a text that can't be set, and more text than a figure may have, is
//! told with its place.

use crate::scene::{Fault, Problem, Scene, Spanned};
use crate::typeset::{Line, Style, wrap};

use super::budget::Budget;
use super::context::Context;
use super::labels::{Wording, bad_markup, fill};
use super::page::{CAPTION_SIZE, Page, type_size};
use super::plan::PanelPlan;
use super::runs::Runs;
use super::theme::Theme;

/// A text of the scene, filled and set.
pub(super) fn set<T>(
    text: &Spanned<String>,
    context: &Context,
    problems: &mut Vec<Problem>,
    typeset: impl Fn(&str) -> Result<T, crate::typeset::TypesetError>,
) -> Option<T> {
    let filled = match fill(&text.value, context, &text.span) {
        Ok(filled) => filled,
        Err(problem) => {
            problems.push(problem);
            return None;
        }
    };
    typeset(&filled).map_err(|e| problems.push(bad_markup(&e.message, &filled, &text.span))).ok()
}

/// The lines of the caption; none where the page has no room for all of them, which is a warning.
pub(super) fn caption(
    scene: &Scene,
    runs: &Runs,
    panels: &[PanelPlan],
    problems: &mut Vec<Problem>,
    warnings: &mut Vec<Problem>,
) -> Vec<Line> {
    let (Some(text), Some(first)) = (&scene.caption, panels.first()) else { return Vec::new() };
    let context = first.context(scene, runs);
    let (width, height) = (scene.canvas.width, scene.canvas.height);
    let measure = Page::new(width, height, 1, false, 2).measure;
    let style = Style::regular(type_size(width, height, CAPTION_SIZE));
    let lines = set(text, &context, problems, |t| wrap(t, style, measure)).unwrap_or_default();
    let most = Page::caption_lines(width, height);
    if lines.len() > most {
        let message = format!(
            "the caption takes {} lines and the page has room for {most}: it is left out",
            lines.len()
        );
        let help =
            Some("it stays in the alternative text; a larger canvas or a shorter text shows it".to_owned());
        warnings
            .push(Problem::new(Fault::Other { code: "caption-dropped", message, help }, text.span.clone()));
        return Vec::new();
    }
    lines
}

/// The caption in plain words.
pub(super) fn caption_words(scene: &Scene, runs: &Runs, panels: &[PanelPlan]) -> Option<String> {
    let (text, context) = (scene.caption.as_ref()?, panels.first()?.context(scene, runs));
    Some(super::alt::plain(&fill(&text.value, &context, &text.span).ok()?))
}

/// Sets every label once, so that a text that can't be set is said before anything is drawn.
///
/// # Errors
///
/// When the labels are more than can be set and placed.
pub(super) fn check_texts(
    scene: &Scene,
    runs: &Runs,
    theme: &Theme,
    panel: &PanelPlan,
    budget: &mut Budget,
    problems: &mut Vec<Problem>,
) -> Result<(), Problem> {
    let context = panel.context(scene, runs);
    let wording = Wording { context: &context, type_size: &|px| px };
    let sketched = panel.sketch(&context, theme);
    budget.take(panel, &sketched)?;
    for request in &sketched.requests {
        let span = panel.layers.get(request.layer).map_or(&panel.source.span, |l| l.span);
        match wording.set(request, span) {
            Ok(Some(sought)) => budget.letters(&sought.lines, span)?,
            Ok(None) => {}
            Err(problem) => problems.push(problem),
        }
    }
    Ok(())
}
