//! Any scene, all the way to bytes.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz_bodies/mod.rs"]
mod fuzz_bodies;

fuzz_target!(|text: &str| fuzz_bodies::render(text));
