//! Any file in the place of a figure.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz_bodies/check.rs"]
mod check;
#[path = "../../tests/fuzz_bodies/choices.rs"]
mod choices;

fuzz_target!(|bytes: &[u8]| check::holds(bytes));
