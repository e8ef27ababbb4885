//! `generate [separation|impact|logged|logged-impact] N SEED` prints cases; `check CASES ANSWERS` holds
//! answers against them.
//!
//! ```text
//! cargo run -p tracefig-reference -- generate separation 1000 1 > cases.jsonl
//! tracefig solve --jsonl < cases.jsonl > answers.jsonl
//! cargo run -p tracefig-reference -- check cases.jsonl answers.jsonl
//! ```

use std::io::Write as _;
use std::process::ExitCode;

use tracefig_reference::generate::Family;
use tracefig_reference::tally::Tally;

const USAGE: &str = "usage: tracefig-reference generate [separation|impact|logged|logged-impact] N SEED\n       tracefig-reference check CASES.jsonl ANSWERS.jsonl";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["generate", count, seed] => generate(&[Family::Separation, Family::Impact], count, seed),
        ["generate", "separation", count, seed] => generate(&[Family::Separation], count, seed),
        ["generate", "impact", count, seed] => generate(&[Family::Impact], count, seed),
        ["generate", "logged", count, seed] => generate(&[Family::Logged], count, seed),
        ["generate", "logged-impact", count, seed] => generate(&[Family::LoggedImpact], count, seed),
        ["check", cases, answers] => check(cases, answers),
        _ => Err(USAGE.to_owned()),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

fn generate(families: &[Family], count: &str, seed: &str) -> Result<bool, String> {
    let count: u64 = count.parse().map_err(|_| USAGE.to_owned())?;
    let seed: u64 = seed.parse().map_err(|_| USAGE.to_owned())?;
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    for i in 0..count {
        for family in families {
            // A closed pipe ends the stream, as it does for every filter.
            if writeln!(out, "{}", family.case(seed, i)).is_err() {
                return Ok(true);
            }
        }
    }
    Ok(true)
}

fn check(cases: &str, answers: &str) -> Result<bool, String> {
    let read = |path: &str| std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"));
    let (cases, answers) = (read(cases)?, read(answers)?);
    let mut tally = Tally::default();
    let mut answers = answers.lines();
    for case in cases.lines().filter(|line| !line.trim().is_empty()) {
        tally.line(case, answers.next().unwrap_or(""));
    }
    print!("{}", tally.told(1000));
    println!("{tally}");
    println!("{} cases, {} wrong", tally.cases(), tally.failures.len());
    Ok(tally.failures.is_empty())
}
