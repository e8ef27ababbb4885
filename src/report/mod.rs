//! Speed against error: the same cases to every contender, time per query and distance from the exact answer.
//!
//! [`run`] takes the contenders, so that a program outside this crate can hand in other libraries and get the
//! same tables and plots with them. A [`Workload`] is a deterministic family of cases with answers of 40
//! digits, computed by code that shares nothing with the solvers.

mod answers;
mod chart;
mod contender;
mod files;
mod measure;
mod ours;
mod plots;
mod tables;
mod workload;

pub use contender::{Contender, Outcome, Preparation, Prepared};
pub use files::{files, machine, write};
pub use measure::{Effort, Row, run};
pub use ours::contenders;
pub use plots::plots;
pub use tables::{json, markdown};
pub use workload::{Case, Class, Difficulty, Workload, workloads};

use crate::drawing::Drawing;

/// Everything a run measured.
#[derive(Clone, Debug)]
pub struct Report {
    /// What it ran on: processor, operating system, version and commit of this crate.
    pub machine: Vec<(String, String)>,
    /// One row for each workload, contender and setting.
    pub rows: Vec<Row>,
    /// Whether it was stopped before the end; the rows are those that were finished.
    pub partial: bool,
}

/// A plot, ready to be written in any format.
pub struct Plot {
    /// Name of its file without the extension.
    pub stem: String,
    /// What is drawn.
    pub drawing: Drawing,
}
