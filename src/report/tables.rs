//! The report as Markdown for people and as JSON for programs.

use std::fmt::Write;

use serde_json::{Value, json};

use super::Report;
use super::contender::Preparation;
use super::measure::Row;
use super::workload::{Class, Difficulty, VERTICES};

/// The report as Markdown: for each class, difficulty and preparation one table of time per query and one of
/// error, contenders down, numbers of vertices across.
///
/// ```
/// use tracefig::report::{Report, markdown};
/// let report = Report { machine: vec![], rows: vec![], partial: true };
/// assert!(markdown(&report).contains("Stopped before the end"));
/// ```
#[must_use]
pub fn markdown(report: &Report) -> String {
    let mut out = String::from("# Speed against error\n\n");
    for (what, value) in &report.machine {
        let _ = writeln!(out, "- {what}: {value}");
    }
    if report.partial {
        out.push_str("\nStopped before the end: only what was finished is here.\n");
    }
    for class in Class::ALL {
        for difficulty in Difficulty::ALL {
            for preparation in [Preparation::Prepared, Preparation::FromScene] {
                section(&mut out, report, class, difficulty, preparation);
            }
        }
    }
    out
}

/// Adds one table: a class, a difficulty, a preparation.
fn section(
    out: &mut String,
    report: &Report,
    class: Class,
    difficulty: Difficulty,
    preparation: Preparation,
) {
    let rows: Vec<&Row> = report
        .rows
        .iter()
        .filter(|r| r.class == class && r.difficulty == difficulty && r.preparation == preparation)
        .collect();
    if rows.is_empty() {
        return;
    }
    let from = match preparation {
        Preparation::Prepared => "prepared shapes",
        Preparation::FromScene => "from the scene's numbers",
    };
    let _ = writeln!(out, "\n## {}, {}, {from}\n", class.name(), difficulty.name());
    let _ = write!(out, "| contender | tolerance |");
    for vertices in VERTICES {
        let _ = write!(out, " n = {vertices} |");
    }
    out.push_str(" worst error | steps | wrong | undecided |\n|---|---|");
    out.push_str(&"---:|".repeat(VERTICES.len() + 4));
    out.push('\n');
    for (contender, precision, tolerance) in settings(&rows) {
        let of: Vec<&&Row> =
            rows.iter().filter(|r| r.contender == contender && r.tolerance == tolerance).collect();
        let _ = write!(out, "| {contender} ({precision}) | {} |", tolerance_cell(tolerance));
        for vertices in VERTICES {
            match of.iter().find(|r| r.vertices == vertices) {
                Some(row) => {
                    let _ = write!(out, " {} ns |", three_digits(row.nanoseconds));
                }
                None => out.push_str(" – |"),
            }
        }
        let worst = of.iter().map(|r| r.worst_error).fold(0.0, f64::max);
        let (wrong, undecided, cases) =
            of.iter().fold((0, 0, 0), |(w, u, c), r| (w + r.wrong, u + r.undecided, c + r.cases));
        let steps = of.iter().filter_map(|r| r.steps).reduce(f64::max);
        let steps = steps.map_or_else(|| "–".to_owned(), |s| format!("{s:.1}"));
        let _ = writeln!(out, " {worst:.1e} | {steps} | {wrong} of {cases} | {undecided} |");
    }
}

/// Contenders with their tolerances, in the order in which they ran.
fn settings<'r>(rows: &[&'r Row]) -> Vec<(&'r str, &'r str, f64)> {
    let mut all: Vec<(&str, &str, f64)> = Vec::new();
    for row in rows {
        let setting = (row.contender.as_str(), row.precision.as_str(), row.tolerance);
        if !all.contains(&setting) {
            all.push(setting);
        }
    }
    all
}

fn tolerance_cell(tolerance: f64) -> String {
    if tolerance == 0.0 { "–".to_owned() } else { format!("{tolerance:.0e}") }
}

/// A time with about three digits.
fn three_digits(value: f64) -> String {
    if value < 10.0 {
        format!("{value:.2}")
    } else if value < 100.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.0}")
    }
}

/// The report as JSON, every row with all its numbers.
///
/// ```
/// use tracefig::report::{Report, json};
/// let report = Report { machine: vec![], rows: vec![], partial: true };
/// assert_eq!(json(&report)["partial"], true);
/// ```
#[must_use]
pub fn json(report: &Report) -> Value {
    let machine: serde_json::Map<String, Value> =
        report.machine.iter().map(|(k, v)| (k.clone(), Value::from(v.as_str()))).collect();
    let rows: Vec<Value> = report.rows.iter().map(row_json).collect();
    json!({ "tracefig_report": 1, "machine": machine, "partial": report.partial, "rows": rows })
}

fn row_json(row: &Row) -> Value {
    json!({
        "class": row.class.name(),
        "difficulty": row.difficulty.name(),
        "corners": row.vertices,
        "contender": row.contender,
        "precision": row.precision,
        "preparation": match row.preparation {
            Preparation::Prepared => "prepared",
            Preparation::FromScene => "from-scene",
        },
        "tolerance": row.tolerance,
        "nanoseconds": row.nanoseconds,
        "worst_error": row.worst_error,
        "median_error": row.median_error,
        "steps": row.steps,
        "answered": row.answered,
        "wrong": row.wrong,
        "undecided": row.undecided,
        "cases": row.cases,
    })
}
