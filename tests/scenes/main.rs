//! Any text is a scene or is refused, and any scene is drawn: random ones, broken ones, those that fuzzing
//! found.

mod broken_scenes;
mod context;
mod corpus;
mod editors;
mod exercises;
mod extreme_sizes;
#[path = "../fuzz_bodies/mod.rs"]
mod fuzz_bodies;
mod label_faults;
mod label_rule;
mod layer_options;
mod names;
mod no_panic;
mod templates;
