//! From a scene to a drawing: panels, layers, labels, theme.
//!
//! [`plan`] resolves what a scene asks to show against the tables of layers and themes and says with the scene's places
//! what is wrong; [`draw`] runs the algorithms, once for each moment that a panel needs, lets each layer draw what
//! they told, and places the labels. No figure has code of its own.

pub mod alt;
mod budget;
pub mod chart;
mod context;
mod difference;
mod draw;
mod frame;
mod label;
mod labels;
pub mod layer;
mod options;
mod outline;
mod page;
mod pen;
mod plan;
mod runs;
mod sketch;
mod texts;
pub mod theme;
pub mod values;
mod view;

pub use context::{Context, Moment};
pub use difference::{Difference, Edge};
pub use draw::{Figure, draw};
pub use frame::Frame;
pub use label::{Anchor, Best, Corner, Label, Rank, Size, left_of};
pub use labels::{Fault, Labelled, Placed, faults};
pub use options::{COMMON, OptionSpec, Options, Setting, Takes};
pub use outline::{Outline, Piece, angle_of, on_circle};
pub use pen::{Dash, LARGE_MARKER, MARKER, Marker, Pen, SMALL_MARKER, Wash};
pub use plan::{Plan, plan};
pub use runs::Run;
pub use sketch::{Cover, Ends, Obstacle, Request, Sketch, Weight};
