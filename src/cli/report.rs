//! `tracefig report`: speed against error, as tables and plots.

use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use tracefig::report::{self, Contender, Effort};

use super::atomic_file::{Wait, write_whole};
use super::console::Console;
use super::inputs::shown;
use super::manual::Manual;
use super::written::cant_write;
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

/// How long `--quick` measures: a fifth of the default of [`Effort`].
const QUICK: Effort = Effort { batch: Duration::from_millis(1), batches: 3 };

impl Runs for Report {
    const MANUAL: Manual = Manual {
        examples: &[(
            "tracefig report --quick -o target/report",
            "Measure briefly, and write tables and plots there",
        )],
        files: &[],
        wrong: Some("no workload has such a name, or the measuring was stopped"),
    };

    /// Ctrl-C ends the measuring; what is finished is written.
    fn run(self, console: &mut Console) -> io::Result<Status> {
        let stop = stopped_by_ctrl_c(console);
        let ours = report::contenders();
        let contenders: Vec<&dyn Contender> = ours.iter().map(AsRef::as_ref).collect();
        let workloads: Vec<_> =
            report::workloads().into_iter().filter(|w| w.name().contains(&self.filter)).collect();
        if workloads.is_empty() {
            console.error(&format!("no workload's name contains `{}`", self.filter));
            return Ok(Status::Wrong);
        }
        let effort = if self.quick { QUICK } else { Effort::default() };
        let bar = progress(console);
        let found = report::run(&workloads, &contenders, effort, report::machine(), &mut |done, of, what| {
            bar.set_length(of as u64);
            bar.set_position(done as u64);
            bar.set_message(what.to_owned());
            !stop.load(Ordering::Relaxed)
        });
        bar.finish_and_clear();
        if found.partial {
            console.error("stopped: the report holds what was finished");
        }
        let files = std::fs::create_dir_all(&self.output).and_then(|()| report::files(&found));
        let files = match files {
            Ok(files) => files,
            Err(error) => {
                Console::message(&cant_write(&self.output, &error));
                return Ok(Status::Io);
            }
        };
        let mut status = if found.partial { Status::Wrong } else { Status::Done };
        for (name, bytes) in files {
            let path = self.output.join(name);
            match write_whole(&path, &bytes, Wait::No) {
                Ok(()) => writeln!(console.out, "{}", shown(&path))?,
                Err(error) => {
                    Console::message(&cant_write(&path, &error));
                    status = Status::Io;
                }
            }
        }
        Ok(status)
    }
}

/// A flag that becomes true at the first Ctrl-C.
fn stopped_by_ctrl_c(console: &Console) -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let heard = Arc::clone(&stop);
    if let Err(error) = ctrlc::set_handler(move || heard.store(true, Ordering::Relaxed)) {
        console.error(&format!("Ctrl-C will lose what is finished: {error}"));
    }
    stop
}

/// A bar where someone watches.
fn progress(console: &Console) -> ProgressBar {
    if !console.is_watched() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len}, {eta} left  {msg}");
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
    style.map_or(bar.clone(), |style| bar.with_style(style))
}
