//! The layers: what a panel can show, one layer a file, each a row in [`LAYERS`].
//!
//! A layer reads events and answers through a [`Context`] and draws with a [`Sketch`] in the panel's space. It never
//! asks a scene for a coordinate of something that an algorithm can compute, and it does not place its labels: it
//! says what they belong to.

mod advancement;
mod arc;
mod axes;
mod axis_gaps;
mod bounds;
mod clamp;
mod closest;
mod contact;
mod difference;
mod frame;
mod ghosts;
mod grown;
mod half_extents;
mod normal;
mod note;
pub(crate) mod options;
mod origin;
mod projection;
mod radii;
mod ray;
mod separation;
mod shapes;
mod simplex;
mod spin;
mod support;
mod sweep;
mod tracks;
mod translation;
mod velocity;

use crate::figure::context::Context;
use crate::figure::sketch::Sketch;

pub(crate) use options::Options;
pub use options::{COMMON, OptionSpec, Takes};

/// Which panels a layer can stand in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// World panels, and those of a body's frame.
    World,
    /// Configuration space.
    Configuration,
    /// Any panel.
    Anywhere,
}

/// A label that a layer writes.
#[derive(Clone, Copy, Debug)]
pub struct LabelKey {
    /// Its key in a scene's `[labels]`.
    pub key: &'static str,
    /// One line for `tracefig list`.
    pub about: &'static str,
}

/// A row of the table of layers.
pub struct Layer {
    /// Its name in a scene.
    pub name: &'static str,
    /// One line for `tracefig list`.
    pub about: &'static str,
    /// The panels it can stand in.
    pub shows: Shows,
    /// Its options, beside those that every layer has.
    pub options: &'static [OptionSpec],
    /// The labels it writes.
    pub labels: &'static [LabelKey],
    /// What it needs of the scene; the text of an error says it: "needs …".
    pub needs: &'static str,
    /// Whether the scene can feed it.
    pub(crate) fed: fn(&Context, &Options) -> bool,
    /// Draws it.
    pub(crate) draw: fn(&mut Sketch, &Context, &Options),
}

/// The word of a layer that draws something at every step of the algorithm.
const STEPS: &str = "steps";

/// Every layer.
pub static LAYERS: &[Layer] = &[
    shapes::LAYER,
    ghosts::LAYER,
    separation::LAYER,
    normal::LAYER,
    contact::LAYER,
    bounds::LAYER,
    half_extents::LAYER,
    clamp::LAYER,
    radii::LAYER,
    translation::LAYER,
    axis_gaps::LAYER,
    frame::LAYER,
    axes::LAYER,
    grown::LAYER,
    difference::LAYER,
    origin::LAYER,
    closest::LAYER,
    support::LAYER,
    velocity::LAYER,
    ray::LAYER,
    sweep::LAYER,
    advancement::LAYER,
    tracks::LAYER,
    spin::LAYER,
    arc::LAYER,
    projection::LAYER,
    simplex::LAYER,
    note::LAYER,
];

/// The layer of a name.
pub(crate) fn find(name: &str) -> Option<&'static Layer> {
    LAYERS.iter().find(|l| l.name == name)
}

/// Opacities of a series of `count`, from the first to the last.
fn fade([first, last]: [f64; 2], count: usize) -> impl Iterator<Item = f64> {
    let steps = u32::try_from(count.saturating_sub(1)).unwrap_or(u32::MAX);
    (0..=steps).map(
        move |i| if steps == 0 { last } else { first + (last - first) * f64::from(i) / f64::from(steps) },
    )
}

/// A small count as a number.
fn number_of(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::INFINITY, f64::from)
}
