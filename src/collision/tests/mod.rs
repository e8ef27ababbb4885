//! Claims about whole queries: the storyboard's answers, and properties on random bodies.

pub(crate) mod hard_pairs;
pub(crate) mod storyboard;
mod storyboard_motion;
pub(crate) mod sweep_properties;
