//! What tracing costs where nobody listens: instructions of the same queries with [`NoTrace`] and with every
//! recording cut out of the source.
//!
//! ```text
//! cargo bench --profile dev --bench trace_cost
//! ```
//!
//! Needs valgrind, whose callgrind counts instructions: the numbers are the same on every run, unlike times.
//! The rooms `geometry`, `trace` and `collision` are copied twice to `target/trace-cost` as a small crate,
//! once as they are and once with every `….record(|| …)` replaced by `()` and every `….listens()` by `false`.
//! Both are built with the crate's release profile and run 0 and 1,000 times over the pairs of
//! `benches/trace_cost/queries.rs`; the difference is the queries' alone.

#![expect(clippy::print_stdout, reason = "a table for whoever runs it")]

use std::collections::BTreeMap;
use std::error::Error;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// Queries a run.
const COUNT: u32 = 1000;

/// Most that tracing may add, as a part of the instructions without any.
const ALLOWED: f64 = 0.02;

/// Whether recordings stay in the copy.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Recording {
    Kept,
    Cut,
}

fn main() -> Result<(), Box<dyn Error>> {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("trace_cost: skipped, valgrind is not installed");
        return Ok(());
    }
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let work = root.join("target/trace-cost");
    let kept = build(&root, &work, Recording::Kept)?;
    let cut = build(&root, &work, Recording::Cut)?;
    let mut worst = f64::NEG_INFINITY;
    println!("| algorithm | instructions a query, untraced | without recording | more |");
    println!("|---|---|---|---|");
    for name in String::from_utf8(Command::new(&kept).arg("list").output()?.stdout)?.lines() {
        let (with, without) = (instructions(&kept, name)?, instructions(&cut, name)?);
        let more = with / without - 1.0;
        worst = worst.max(more);
        println!("| {name} | {with:.1} | {without:.1} | {:+.2} % |", 100.0 * more);
    }
    if worst > ALLOWED {
        return Err(format!("tracing costs {:.2} % where nobody listens", 100.0 * worst).into());
    }
    Ok(())
}

/// Instructions of one query.
fn instructions(program: &Path, algorithm: &str) -> Result<f64, Box<dyn Error>> {
    let count = |queries: u32| -> Result<f64, Box<dyn Error>> {
        let run = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(program)
            .args([algorithm, &queries.to_string()])
            .output()?;
        let log = String::from_utf8(run.stderr)?;
        let collected = log.lines().find_map(|line| line.split("Collected : ").nth(1));
        Ok(collected.ok_or_else(|| format!("no count from valgrind: {log}"))?.trim().parse()?)
    };
    Ok((count(COUNT)? - count(0)?) / f64::from(COUNT))
}

/// Builds a copy of the three rooms with the driver, and answers where the program is.
fn build(root: &Path, work: &Path, recording: Recording) -> Result<PathBuf, Box<dyn Error>> {
    let name = if recording == Recording::Kept { "kept" } else { "cut" };
    let copy = work.join(name);
    if copy.exists() {
        fs::remove_dir_all(&copy)?;
    }
    for room in ["geometry", "trace", "collision"] {
        copy_room(&root.join("src").join(room), &copy.join("src").join(room), recording)?;
    }
    fs::write(copy.join("src/lib.rs"), "pub mod collision;\npub mod geometry;\npub mod trace;\n")?;
    fs::copy(root.join("benches/trace_cost/queries.rs"), copy.join("src/main.rs"))?;
    fs::write(copy.join("Cargo.toml"), manifest(&fs::read_to_string(root.join("Cargo.toml"))?, name))?;
    let built = Command::new(env!("CARGO"))
        .args(["build", "--release", "--quiet"])
        .env("CARGO_TARGET_DIR", work.join("target"))
        .env("RUSTFLAGS", "-Awarnings")
        .current_dir(&copy)
        .status()?;
    if !built.success() {
        return Err(format!("the copy in {} does not build", copy.display()).into());
    }
    Ok(work.join("target/release").join(format!("trace-cost-{name}")))
}

/// The manifest of a copy: the crate's own dependencies of these rooms, and its release profile.
fn manifest(whole: &str, name: &str) -> String {
    let used = ["glam", "libm", "robust", "serde", "serde_json"];
    let is_used = |line: &&str| used.iter().any(|u| line.starts_with(&format!("{u} = ")));
    let dependencies: Vec<&str> = whole.lines().filter(is_used).collect();
    let profile: Vec<&str> =
        whole.lines().skip_while(|l| *l != "[profile.release]").take_while(|l| !l.is_empty()).collect();
    format!(
        "[package]\nname = \"trace-cost-{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
         [lib]\nname = \"tracefig\"\n\n[dependencies]\n{}\n\n{}\n\n[workspace]\n",
        dependencies.join("\n"),
        profile.join("\n")
    )
}

/// Copies a folder of sources.
fn copy_room(from: &Path, to: &Path, recording: Recording) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let path = entry?.path();
        let target = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() {
            copy_room(&path, &target, recording)?;
            continue;
        }
        let source = fs::read_to_string(&path)?;
        let records = from.components().any(|part| part.as_os_str() == "collision");
        let cut = recording == Recording::Cut && records;
        fs::write(target, if cut { without_recordings(&source)? } else { source })?;
    }
    Ok(())
}

/// A source with its recordings cut out.
fn without_recordings(source: &str) -> Result<String, syn::Error> {
    let mut found = Recordings::default();
    found.visit_file(&syn::parse_file(source)?);
    let mut text = source.to_owned();
    for (range, instead) in found.0.into_values().rev() {
        text.replace_range(range, instead);
    }
    Ok(text)
}

/// Places of recordings, outermost only, by their start.
#[derive(Default)]
struct Recordings(BTreeMap<usize, (Range<usize>, &'static str)>);

impl<'ast> Visit<'ast> for Recordings {
    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        let takes_closure = matches!(call.args.first(), Some(syn::Expr::Closure(_)));
        let instead = match call.method.to_string().as_str() {
            "record" if takes_closure => "()",
            "listens" => "false",
            _ => return visit::visit_expr_method_call(self, call),
        };
        let range = call.span().byte_range();
        self.0.insert(range.start, (range, instead));
    }
}
