//! Any text, read as a scene.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz_bodies/scene.rs"]
mod body;

fuzz_target!(|text: &str| body::holds(text));
