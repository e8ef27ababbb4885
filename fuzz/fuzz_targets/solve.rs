//! Any line to `solve --jsonl`.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz_bodies/solve.rs"]
mod body;

fuzz_target!(|text: &str| body::holds(text));
