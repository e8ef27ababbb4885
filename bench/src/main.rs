//! `tracefig report`, with the peers in it: the same cases, tables and plots.
//!
//! `cargo run --release --manifest-path bench/Cargo.toml -- OUTPUT_DIR [FILTER]`

mod box2d;
mod parry;

use std::path::PathBuf;
use std::process::ExitCode;

use tracefig::report::{self, Contender, Effort};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().unwrap_or_else(|| "target/report".into()));
    let filter = arguments.next().unwrap_or_default();
    let ours = report::contenders();
    let mut all: Vec<&dyn Contender> = ours.iter().map(AsRef::as_ref).collect();
    all.push(&parry::Parry);
    all.push(&box2d::Box2d);
    let workloads: Vec<_> = report::workloads().into_iter().filter(|w| w.name().contains(&filter)).collect();
    let found = report::run(&workloads, &all, Effort::default(), report::machine(), &mut |done, of, what| {
        eprint!("\r\x1b[K{done}/{of} {what}");
        true
    });
    eprintln!();
    match report::write(&found, &folder) {
        Ok(files) => {
            for file in files {
                println!("{}", file.display());
            }
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{}: {error}", folder.display());
            ExitCode::FAILURE
        }
    }
}
