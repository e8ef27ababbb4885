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
pub mod live;
pub mod output;
#[cfg(not(tracefig_page))]
pub mod report;
pub mod scene;
pub mod trace;
pub mod typeset;

pub use scene::{Refused, Scene, SceneFile, open, solve, solve_jsonl_line};

/// The chapters of the guide, whose Rust is run with the examples of the library.
#[cfg(doctest)]
mod guide {
    #![doc = include_str!("../guide/src/introduction.md")]
    #![doc = include_str!("../guide/src/circles.md")]
    #![doc = include_str!("../guide/src/boxes.md")]
    #![doc = include_str!("../guide/src/circle-and-box.md")]
    #![doc = include_str!("../guide/src/oriented-boxes-and-axes.md")]
    #![doc = include_str!("../guide/src/the-minkowski-difference.md")]
    #![doc = include_str!("../guide/src/gjk.md")]
    #![doc = include_str!("../guide/src/epa.md")]
    #![doc = include_str!("../guide/src/contact-points.md")]
    #![doc = include_str!("../guide/src/rotating-calipers.md")]
    #![doc = include_str!("../guide/src/moving.md")]
    #![doc = include_str!("../guide/src/turning.md")]
    #![doc = include_str!("../guide/src/numbers.md")]
}
