//! Claims about whole queries: the storyboard's answers, and properties on random bodies.
//!
//! `bodies` makes the bodies and `asking` puts the questions, for the tests here and for those beside the
//! code.

pub(crate) mod asking;
pub(crate) mod bodies;
pub(crate) mod hard_pairs;
mod readiness;
mod separation_properties;
mod storyboard;
mod storyboard_motion;
mod sweep_properties;
mod unfit;
