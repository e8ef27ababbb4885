//! The report as plots: error against time, steps against tolerance, growth with n.

use super::chart::{Axis, Chart, Marker, Series, draw};
use crate::drawing::{Color, Role};
use crate::typeset::TypesetError;

use super::contender::Preparation;
use super::measure::Row;
use super::workload::{Class, Difficulty, VERTICES};
use super::{Plot, Report};

/// What an exact answer counts as, so that it can stand on a logarithmic axis: a tenth of the ε of doubles, a
/// step below the smallest error there is.
const NO_ERROR: f64 = f64::EPSILON / 10.0;

/// Colours, markers and dashes in the order in which series take them; no two series look the same.
const LOOKS: [(Role, &[f64]); 7] = [
    (Role::A, &[]),
    (Role::B, &[7.0, 4.0]),
    (Role::Difference, &[2.0, 3.0]),
    (Role::Translation, &[9.0, 3.0, 2.0, 3.0]),
    (Role::Ink, &[]),
    (Role::Now, &[5.0, 2.0]),
    (Role::Muted, &[3.0, 3.0]),
];

/// Every plot that the rows allow; `color` is the theme's.
///
/// # Errors
///
/// A [`TypesetError`] where a contender's name has a character that the fonts lack.
///
/// ```
/// use tracefig::{figure::theme, report::{Report, plots}};
/// let report = Report { machine: vec![], rows: vec![], partial: true };
/// assert!(plots(&report, &|role| theme::THEMES[0].color(role))?.is_empty(), "no rows, no plots");
/// # Ok::<(), tracefig::typeset::TypesetError>(())
/// ```
pub fn plots(report: &Report, color: &dyn Fn(Role) -> Color) -> Result<Vec<Plot>, TypesetError> {
    let names = names(report);
    let mut all = Vec::new();
    for class in Class::ALL {
        for difficulty in Difficulty::ALL {
            let rows: Vec<&Row> =
                report.rows.iter().filter(|r| r.class == class && r.difficulty == difficulty).collect();
            let name = format!("{}-{}", class.name(), difficulty.name());
            for chart in [
                growth(&rows, &names, &name),
                error_against_time(&rows, &names, &name),
                steps(&rows, &names, &name),
            ] {
                if !chart.series.is_empty() {
                    all.push(Plot { stem: chart.id.clone(), drawing: draw(&chart, color)? });
                }
            }
        }
    }
    Ok(all)
}

/// The contenders in the order in which they ran, so that each looks the same in every plot.
fn names(report: &Report) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for row in &report.rows {
        if !names.contains(&row.contender.as_str()) {
            names.push(&row.contender);
        }
    }
    names
}

/// Time per query against n, at each contender's finest tolerance.
fn growth(rows: &[&Row], names: &[&str], name: &str) -> Chart {
    let series = series(rows, names, |of| {
        VERTICES
            .iter()
            .filter_map(|&vertices| {
                let finest = of
                    .iter()
                    .filter(|r| r.vertices == vertices)
                    .min_by(|p, q| p.tolerance.total_cmp(&q.tolerance))?;
                #[expect(clippy::cast_precision_loss, reason = "at most 1,024")]
                Some((vertices as f64, finest.nanoseconds))
            })
            .collect()
    });
    #[expect(clippy::cast_precision_loss, reason = "at most 1,024")]
    let marks: Vec<f64> = VERTICES.iter().map(|&n| n as f64).collect();
    let x = Axis { name: "vertices $n$ of each polygon".into(), lo: 3.4, hi: 1200.0, marks };
    let y = Axis::powers_of_ten("time per query, ns", values(&series, |p| p.1));
    chart(format!("growth-{name}"), &format!("Growth with n: {name}"), x, y, series)
}

/// Worst error against time per query; a point for each n (direct algorithms) or each tolerance at n = 8.
fn error_against_time(rows: &[&Row], names: &[&str], name: &str) -> Chart {
    let series = series(rows, names, |of| {
        let iterative = of.iter().any(|r| r.tolerance != of[0].tolerance);
        of.iter()
            .filter(|r| r.vertices == 8 || !iterative)
            .filter(|r| r.answered > r.wrong)
            .map(|r| (r.nanoseconds, r.worst_error.max(NO_ERROR)))
            .collect()
    });
    let x = Axis::powers_of_ten("time per query, ns", values(&series, |p| p.0));
    let y = Axis::powers_of_ten("worst error", values(&series, |p| p.1));
    chart(format!("error-{name}"), &format!("Error against time: {name}"), x, y, series)
}

/// Steps against tolerance at n = 8, for the algorithms that have one.
fn steps(rows: &[&Row], names: &[&str], name: &str) -> Chart {
    let series = series(rows, names, |of| {
        of.iter()
            .filter(|r| r.vertices == 8 && r.tolerance > 0.0)
            .filter_map(|r| Some((r.tolerance, r.steps?.max(1.0))))
            .collect()
    });
    let x = Axis::powers_of_ten("tolerance, world units", values(&series, |p| p.0));
    let y = Axis::powers_of_ten("steps (distance queries)", values(&series, |p| p.1));
    chart(format!("steps-{name}"), &format!("Steps against tolerance: {name}"), x, y, series)
}

fn chart(id: String, title: &str, x: Axis, y: Axis, series: Vec<Series>) -> Chart {
    Chart { id, title: title.to_owned(), x, y, series }
}

/// One coordinate of all points.
fn values(series: &[Series], pick: fn(&(f64, f64)) -> f64) -> Vec<f64> {
    series.iter().flat_map(|s| s.points.iter().map(pick)).collect()
}

/// A series for each contender; prepared shapes where the contender has them, from the scene's numbers
/// elsewhere.
fn series(rows: &[&Row], names: &[&str], points: impl Fn(&[&Row]) -> Vec<(f64, f64)>) -> Vec<Series> {
    let mut all = Vec::new();
    for (i, name) in names.iter().enumerate() {
        let of: Vec<&Row> = rows.iter().filter(|r| r.contender == *name).copied().collect();
        if of.is_empty() {
            continue;
        }
        let prepared: Vec<&Row> =
            of.iter().filter(|r| r.preparation == Preparation::Prepared).copied().collect();
        let points = points(if prepared.is_empty() { &of } else { &prepared });
        if !points.is_empty() {
            let (role, dash) = LOOKS[i % LOOKS.len()];
            let marker = Marker::ALL[i % Marker::ALL.len()];
            all.push(Series { name: (*name).to_owned(), role, marker, dash: dash.to_vec(), points });
        }
    }
    all
}
