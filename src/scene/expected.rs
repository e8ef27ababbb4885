//! `[query] expected`: what someone else answered.

use super::checked::{Checked, check};
use super::fields::{EXPECTED, EXPECTED_POINTS};
use super::problem::{Fault, Problems};
use crate::collision::{Bodies, Expected, Question, Verdict, When};
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
    let (separation, time) = (number("separation"), number("time"));
    Some(Expected { outcome: outcome(&table, question, p), separation, time, normal, points })
}

/// What came out, where the question may come out so.
fn outcome(table: &Checked<'_>, question: &Question, p: &mut Problems) -> Option<Verdict> {
    let told = table.text("outcome")?;
    let place = |verdict: &Verdict| verdict.suits()[usize::from(question.when == When::AtAMoment)];
    let verdict = Verdict::ALL.into_iter().find(|verdict| verdict.word() == told.value)?;
    if !place(&verdict) {
        let message = format!("a `{}` never comes out as {:?}", question.word, told.value);
        let known: Vec<String> =
            Verdict::ALL.iter().filter(|verdict| place(verdict)).map(|v| format!("{:?}", v.word())).collect();
        p.add(Fault::Conflict { message, help: format!("write {}", known.join(" or ")) }, &told.span);
        return None;
    }
    Some(verdict)
}
