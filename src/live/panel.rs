//! What a figure says beside its picture, as JSON.

use serde_json::json;

use crate::figure::{Account, Figure, Frame, Plan, handles_json};
use crate::geometry::DVec2;
use crate::scene::{NOTES, Severity, Solution};

/// The result in words and in numbers, what this answer lacks, what can be dragged, and where
/// the panels' spaces lie on the page.
pub(super) fn panel(plan: &Plan<'_>, draws: &Figure) -> String {
    let run = plan.own_run();
    let notes: Vec<String> = plan
        .warnings
        .iter()
        .filter(|problem| NOTES && problem.fault.severity() == Severity::Note)
        .map(|problem| problem.fault.to_string())
        .collect();
    let frames = draws.panels.iter().map(|panel| {
        let Frame { panel: rect, .. } = panel.frame;
        let at = |p: DVec2| panel.frame.page(p);
        let (origin, x, y) = (at(DVec2::ZERO), at(DVec2::X), at(DVec2::Y));
        json!({
            "rect": [rect.x0, rect.y0, rect.x1, rect.y1],
            "zero": [origin.x, origin.y],
            "x": [x.x - origin.x, x.y - origin.y],
            "y": [y.x - origin.x, y.y - origin.y],
        })
    });
    let steps =
        draws.drawing.steps.iter().map(|step| json!({ "title": step.title, "sentences": step.sentences }));
    let said = json!({
        "sentence": Account::of(plan.scene, &plan.runs, &run).sentence(),
        "answer": Solution::told(plan.scene, run.answer.clone()).json(),
        "notes": notes,
        "handles": handles_json(&draws.handles, plan.scene),
        "steps": steps.collect::<Vec<_>>(),
        "panels": frames.collect::<Vec<_>>(),
    });
    serde_json::to_string(&said).unwrap_or_default()
}
