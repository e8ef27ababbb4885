//! Claims about whole queries: the storyboard's answers, and properties on random bodies.

mod impact_properties;
mod ray_stages;
pub(crate) mod storyboard;
mod storyboard_motion;
pub(crate) mod sweep_properties;
