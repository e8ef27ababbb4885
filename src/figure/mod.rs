//! From a scene to a drawing: panels, layers, labels, theme.
//!
//! [`plan`] resolves what a scene asks to show against the tables of layers and themes and says with the
//! scene's places what is wrong; [`draw`] runs the algorithms, once for each moment that a panel needs, lets
//! each layer draw what they told, and places the labels. No figure has code of its own.

mod again;
mod asked;
mod asked_theme;
mod askers;
mod bands;
mod budget;
mod called;
mod clock;
mod context;
mod cue;
pub mod default_picture;
mod describe;
mod difference;
mod distances;
mod draw;
mod drawn_panel;
mod empty_view;
pub mod exercise;
mod fault;
mod frame;
mod grounds;
mod handle;
mod heading;
mod idle_option;
mod inset;
mod kept;
mod label_keys;
mod language;
pub mod layer;
mod lettering;
mod limits;
mod lost_playhead;
mod moment_title;
mod motion;
mod moving_frame;
mod name;
mod narrow;
mod not_held;
mod off_page;
mod out_of_view;

mod page;
mod panel;
mod placement;
mod plan;
mod plan_runs;
mod play;
mod played;
mod playhead;
mod printed;
mod question;
#[cfg(test)]
#[path = "../../tests/random_scenes/mod.rs"]
mod random_scenes;
mod resolve;
mod runs;
mod said;
mod sketch;
mod standing;
mod step_room;
mod steps;
mod text;
mod texts;
pub mod theme;
mod told_cue;
mod tongue;
mod touching;
mod unnamed;
mod unseen_layer;
mod unset_words;
mod view;
mod whole;
mod words_below;
mod words_in_steps;

#[cfg(test)]
use crate::scene::Scene;
#[cfg(test)]
pub(crate) use layer::{LAYERS, Shows};

pub use askers::askers;
pub(crate) use describe::Account;
pub(crate) use draw::draw_unjudged;
pub use draw::{Figure, draw, draw_after, draw_in_steps};
pub use fault::Fault;
pub use frame::Frame;
pub use handle::{Handle, Pull, Setting, handles_json};
pub(crate) use language::{Language, Row, rows};
pub use layer::options::{COMMON, OptionSpec, Takes};
pub use lost_playhead::no_playhead;
pub use motion::draw_in_motion;
pub use not_held::not_held;
pub use off_page::off_page;
pub use placement::{LabelFault, Labelled, Placed};
pub use plan::{Plan, plan, plan_in};
pub use text::{plain, values};
pub(crate) use texts::all_texts;
pub use unnamed::{Unnamed, unnamed};
