//! The exact answers of the workloads: 40 digits each, computed outside this crate by code that shares
//! nothing with it.
//!
//! `answers.tsv` has a line for each case: the workload's name, the case's number, the answer to 40 digits or
//! `miss`, and what the double nearest to the answer leaves over. `tests/answers/workloads.rs` computes the
//! file again.

use std::collections::BTreeMap;
use std::sync::LazyLock;

/// An exact answer as an unevaluated sum hi + lo.
type TwoDoubles = [f64; 2];

/// The file, by workload and number of the case.
static ANSWERS: LazyLock<BTreeMap<(&str, usize), Option<TwoDoubles>>> =
    LazyLock::new(|| include_str!("answers.tsv").lines().filter_map(line).collect());

/// A line of the file; `None` where it is none.
fn line(line: &'static str) -> Option<((&'static str, usize), Option<TwoDoubles>)> {
    let mut fields = line.split('\t');
    let key = (fields.next()?, fields.next()?.parse().ok()?);
    let answer = match fields.next()? {
        "miss" => None,
        digits => Some([digits.parse().ok()?, fields.next()?.parse().ok()?]),
    };
    Some((key, answer))
}

/// The exact answer of a case; `None` for a miss.
pub(super) fn exact(workload: &str, index: usize) -> Option<TwoDoubles> {
    ANSWERS.get(&(workload, index)).copied().flatten()
}
