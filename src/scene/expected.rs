//! `[query] expected`: what someone else answered.

use super::checked::{Checked, check};
use super::fields::{EXPECTED, EXPECTED_POINTS};
use super::problem::{Fault, Problems};
use crate::collision::{Bodies, Expected, Question};
use crate::geometry::UnitVector;

/// Reads it; `None` where it is left out or wrong.
pub(super) fn read(query: &Checked<'_>, question: &Question, p: &mut Problems) -> Option<Expected> {
    let node = query.get("expected")?;
    let table = check(node, "expected", EXPECTED.place, EXPECTED.fields, p)?;
    if question.bodies != Bodies::Two {
        let message = format!("`expected` does not apply to a `{}`", question.word);
        let help = "leave it out: it goes with a question about two bodies".to_owned();
        p.add(Fault::Conflict { message, help }, &node.span);
        return None;
    }
    let normal = table.pair("normal").and_then(|normal| {
        let unit = UnitVector::along(normal);
        if unit.is_none()
            && let Some(node) = table.get("normal")
        {
            let (key, expected, got) = ("normal".to_owned(), "a direction".to_owned(), "[0, 0]".to_owned());
            p.add(Fault::OutOfRange { key, expected, got }, &node.span);
        }
        unit
    });
    let points = table.get("points").and_then(|node| {
        let points = check(node, "points", EXPECTED_POINTS.place, EXPECTED_POINTS.fields, p)?;
        Some([points.pair("A")?, points.pair("B")?])
    });
    let number = |key| table.number(key).map(|n| n.value);
    Some(Expected { separation: number("separation"), time: number("time"), normal, points })
}
