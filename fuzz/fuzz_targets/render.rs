//! Any scene, all the way to bytes.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz_bodies/render.rs"]
mod body;

fuzz_target!(|text: &str| body::holds(text));
