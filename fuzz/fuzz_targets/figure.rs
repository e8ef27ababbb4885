//! Any choices, as a scene with all layers and options, all the way to bytes.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz_bodies/choices.rs"]
mod choices;
#[path = "../../tests/fuzz_bodies/figure.rs"]
mod figure;
#[path = "../../tests/fuzz_bodies/render.rs"]
mod render;
#[path = "../../tests/fuzz_bodies/scene.rs"]
mod scene;

fuzz_target!(|bytes: &[u8]| figure::holds(bytes));
