//! Many reports as one table: the worst of each measure by category, and every fault with the scene that
//! shows it.

use std::collections::BTreeMap;
use std::fmt::{self, Write as _};

use crate::check::{Report, check};
use crate::json::Json;
use crate::scene::Scene;

/// A wrong answer.
#[derive(Clone, Debug)]
pub struct Failure {
    /// What is wrong.
    pub faults: String,
    /// The scene, a line.
    pub scene: String,
    /// The answer, a line.
    pub answer: String,
}

/// Counts and worst measures.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    rows: BTreeMap<String, Row>,
    /// How often each claim was false, by category.
    claims: BTreeMap<(&'static str, String), usize>,
    /// Wrong answers, in order.
    pub failures: Vec<Failure>,
}

#[derive(Clone, Debug, Default)]
struct Row {
    cases: usize,
    wrong: usize,
    unresolved: usize,
    worst: BTreeMap<&'static str, f64>,
}

impl Tally {
    /// Checks a line against its scene and counts it; tells whether it is right.
    pub fn line(&mut self, scene: &str, answer: &str) -> bool {
        let report = match (Scene::parse(scene), Json::parse(answer)) {
            (Ok(scene), Ok(answer)) => check(&scene, &answer),
            (Err(error), _) | (_, Err(error)) => {
                let mut report = Report::default();
                report.fault("read", error);
                report
            }
        };
        self.add(scene, answer, &report)
    }

    /// Counts a report; tells whether it has no faults.
    pub fn add(&mut self, scene: &str, answer: &str, report: &Report) -> bool {
        let id = Json::parse(scene)
            .ok()
            .and_then(|json| json.text_at("id").map(str::to_owned))
            .unwrap_or_default();
        let category = id.split('/').next().unwrap_or("").to_owned();
        let row = self.rows.entry(category.clone()).or_default();
        row.cases += 1;
        row.unresolved += usize::from(answer.contains("\"unresolved\""));
        for (name, value) in &report.measures {
            let worst = row.worst.entry(name).or_insert(0.0);
            *worst = worst.max(*value);
        }
        if report.faults.is_empty() {
            return true;
        }
        row.wrong += 1;
        for fault in &report.faults {
            *self.claims.entry((fault.claim, category.clone())).or_default() += 1;
        }
        let told: Vec<_> =
            report.faults.iter().map(|fault| format!("{}: {}", fault.claim, fault.detail)).collect();
        self.failures.push(Failure {
            faults: told.join("; "),
            scene: scene.to_owned(),
            answer: answer.to_owned(),
        });
        false
    }

    /// Number of cases.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.rows.values().map(|row| row.cases).sum()
    }

    /// The first failures of each category, each with its scene: at most `each` of one.
    #[must_use]
    pub fn told(&self, each: usize) -> String {
        let mut seen: BTreeMap<String, usize> = BTreeMap::new();
        let mut text = String::new();
        for failure in &self.failures {
            let kind = failure.scene.split('/').next().unwrap_or("").to_owned();
            let count = seen.entry(kind).or_default();
            *count += 1;
            if *count <= each {
                let Failure { faults, scene, answer } = failure;
                // Writing to a String cannot fail.
                let _ = writeln!(text, "wrong: {faults}\n  scene:  {scene}\n  answer: {answer}");
            }
        }
        text
    }
}

impl fmt::Display for Tally {
    /// A Markdown table; measures that a category does not have are left out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const COLUMNS: [&str; 12] = [
            "error / εS",
            "error / |s|",
            "error / bound",
            "width / εS",
            "width / |s|",
            "off n",
            "p_B − p_A − s n / εS",
            "point off feature / εS",
            "Δt · closing / (4 tol + 16 εS)",
            "closest: error / εS",
            "closest: width / εS",
            "closest: width / S, turning",
        ];
        write!(f, "| category | cases | wrong | unresolved |")?;
        COLUMNS.iter().try_for_each(|column| write!(f, " {column} |"))?;
        write!(f, "\n|---|--:|--:|--:|")?;
        COLUMNS.iter().try_for_each(|_| write!(f, "--:|"))?;
        writeln!(f)?;
        for (name, row) in &self.rows {
            write!(f, "| {name} | {} | {} | {} |", row.cases, row.wrong, row.unresolved)?;
            for column in COLUMNS {
                match row.worst.get(column) {
                    Some(worst) => write!(f, " {worst:.2e} |")?,
                    None => write!(f, " |")?,
                }
            }
            writeln!(f)?;
        }
        for ((claim, category), count) in &self.claims {
            writeln!(f, "{count} × `{claim}` in {category}")?;
        }
        Ok(())
    }
}
