//! `tracefig report`: speed against error, as tables and plots.

use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use tracefig::report::{self, Contender, Effort};

use super::console::Console;
use super::render::cant_write;
use super::{Runs, Status};

/// Options of `report`.
#[derive(Args)]
pub(crate) struct Report {
    /// Folder for the tables and plots, made if it is not there
    #[arg(short, long, value_name = "DIR", default_value = "target/report")]
    output: PathBuf,
    /// Only workloads whose name contains this
    #[arg(long, value_name = "TEXT", default_value = "")]
    filter: String,
    /// Shorter batches: rougher times, in a fifth of the time
    #[arg(long)]
    quick: bool,
}

/// A `--quick` batch and how many there are; the usual ones are in [`Effort`].
const QUICK: Effort = Effort { batch: Duration::from_millis(1), batches: 3 };

impl Runs for Report {
    /// The files are written anew after each workload, so that a run that is stopped leaves what is finished.
    fn run(self, console: &mut Console) -> io::Result<Status> {
        let ours = report::contenders();
        let contenders: Vec<&dyn Contender> = ours.iter().map(AsRef::as_ref).collect();
        let workloads: Vec<_> =
            report::workloads().into_iter().filter(|w| w.name().contains(&self.filter)).collect();
        if workloads.is_empty() {
            console.error(&format!("no workload's name contains `{}`", self.filter));
            return Ok(Status::Wrong);
        }
        let effort = if self.quick { QUICK } else { Effort::default() };
        let bar = progress(workloads.len(), console);
        let mut total = report::Report { machine: report::machine(), rows: Vec::new(), partial: true };
        let mut files = Vec::new();
        for (i, workload) in workloads.iter().enumerate() {
            let mut tell = |_: usize, _: usize, what: &str| {
                bar.set_message(what.to_owned());
                true
            };
            let one = std::slice::from_ref(workload);
            total.rows.extend(report::run(one, &contenders, effort, Vec::new(), &mut tell).rows);
            total.partial = i + 1 < workloads.len();
            files = match report::write(&total, &self.output) {
                Ok(files) => files,
                Err(error) => {
                    Console::message(&cant_write(&self.output, &error));
                    return Ok(Status::Wrong);
                }
            };
            bar.inc(1);
        }
        bar.finish_and_clear();
        for file in files {
            writeln!(console.out, "{}", file.display())?;
        }
        Ok(Status::Done)
    }
}

fn progress(workloads: usize, console: &Console) -> ProgressBar {
    if !console.is_watched() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} workloads, {eta} left  {msg}");
    let bar = ProgressBar::with_draw_target(Some(workloads as u64), ProgressDrawTarget::stderr());
    style.map_or(bar.clone(), |style| bar.with_style(style))
}
