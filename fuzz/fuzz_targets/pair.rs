//! Any two bodies, in both orders.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz_bodies/choices.rs"]
mod choices;
#[path = "../../tests/fuzz_bodies/pair.rs"]
mod pair;

fuzz_target!(|bytes: &[u8]| pair::holds(bytes));
