//! Headless renderer of explanatory diagrams for 2D collision detection.
//!
//! A scene file names two shapes, a motion and a question. The algorithm answers it and emits trace events; a
//! renderer turns the events into SVG and PNG figures.
//!
//! World space is [`geometry::DVec2`], y up; page space is [`drawing::Point`], pixels, y down.

pub mod collision;
pub mod drawing;
pub mod drift;
pub mod figure;
pub mod geometry;
pub mod output;
pub mod report;
pub mod scene;
pub mod trace;
pub mod typeset;

pub use scene::{Refused, Scene, SceneFile, open, solve, solve_jsonl_line};
