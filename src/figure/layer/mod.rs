//! The layers: what a panel can show, one layer a file, each a row in [`LAYERS`].
//!
//! A layer reads events and answers through a `Context` and draws with a `Sketch` in the panel's space.
//! It never asks a scene for a coordinate of something that an algorithm can compute, and it does not place
//! its labels: it says what they belong to.

mod advancement;
mod approach;
mod arc;
mod axes;
mod axis_gaps;
mod axis_unit;
mod bounds;
mod bracket;
mod carrying;
mod chart;
mod clamp;
mod clipping;
mod closest;
mod contact;
mod coordinates;
mod cores;
mod depth_disc;
mod difference;
mod difference_name;
mod edge_cues;
mod edge_fan;
mod edge_normals;
mod elsewhere;
mod enlarged;
mod expected;
mod facing;
mod fastest_approach;
mod feature;
mod fed;
mod frame;
mod ghosts;
mod graph;
mod grid;
mod grown;
mod half_extents;
mod held;
mod kinks;
mod look_alike;
mod merging;
mod moment;
mod naive;
mod normal;
mod note;
pub(crate) mod options;
mod origin;
mod pair;
mod point;
mod polytope;
mod projection;
mod radii;
mod ray;
mod reach;
mod ruler;
mod separating_cone;
mod separating_lines;
mod separation;
mod shadow;
mod shapes;
mod simplex;
mod spin;
mod step_lengths;
mod step_numbers;
mod support;
mod sweep;
mod tested_axis;
#[cfg(test)]
mod tests;
mod tracks;
mod translation;
mod turn;
mod unbuilt;
mod unrolled;
mod velocity;
mod vertices;

use crate::figure::context::Context;
use crate::figure::sketch::Sketch;
use crate::geometry::Side;
use crate::trace::Phrase;

pub(crate) use fed::Fed;
pub(super) use grid::lies_beneath;
pub(crate) use options::{OptionSpec, Options, Takes};
pub(crate) use shapes::shows_context;

/// Which panels a layer can stand in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// Panels of the world, also in a body's frame.
    World,
    /// Panels of configuration space.
    Configuration,
    /// Any panel.
    Anywhere,
}

/// What a layer shows of a question and its answer: which of them an exercise's question may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tells {
    /// What the scene itself says: bodies, motion, axes.
    Given,
    /// What anyone can build from that without an answer: B ⊖ A.
    Built,
    /// What an algorithm found.
    Found,
}

/// A label that a layer writes.
#[derive(Clone, Copy, Debug)]
pub struct LabelKey {
    /// The key in a scene's `[labels]` that rewords, pins or hides it.
    pub key: &'static str,
    /// What it says, for `tracefig list`.
    pub about: &'static str,
}

/// A row of the table of layers.
pub struct Layer {
    /// The name by which a scene asks for it.
    pub name: &'static str,
    /// What the long text calls it: in English by its name, elsewhere in words.
    pub(crate) in_words: Phrase,
    /// What it draws, for `tracefig list`.
    pub about: &'static str,
    /// The panels it can stand in.
    pub shows: Shows,
    /// What it shows of the answer.
    pub tells: Tells,
    /// The options of its own; every layer has [`COMMON`](options::COMMON) besides.
    pub options: &'static [OptionSpec],
    /// The labels that it can write.
    pub labels: &'static [LabelKey],
    /// What it needs of the scene; the text of an error says it: "needs …".
    pub needs: &'static str,
    /// Whether it finds what it draws at the panel's moment.
    pub(crate) fed: fn(&Context, &Options) -> Fed,
    /// Draws it into the panel.
    pub(crate) draw: fn(&mut Sketch, &Context, &Options),
}

/// The word of a layer that draws something at every step of the algorithm.
const STEPS: &str = "steps";

/// What is said of an answer that ties with others.
const ONE_OF_SEVERAL: &str = "one of several";

/// What is said of a direction of an answer that ties with others, by how many do; 0 are all there are.
fn tied(ties: u32) -> Option<String> {
    let said = if ties == 0 { "any direction" } else { ONE_OF_SEVERAL };
    (ties != 1).then(|| said.to_owned())
}

/// Every layer, in the order of `tracefig list`.
pub static LAYERS: &[Layer] = &[
    shapes::LAYER,
    vertices::LAYER,
    feature::LAYER,
    point::LAYER,
    ghosts::LAYER,
    separation::LAYER,
    normal::LAYER,
    contact::LAYER,
    clipping::LAYER,
    approach::LAYER,
    expected::LAYER,
    naive::LAYER,
    bounds::LAYER,
    half_extents::LAYER,
    clamp::LAYER,
    radii::LAYER,
    translation::LAYER,
    axis_gaps::LAYER,
    frame::LAYER,
    grid::LAYER,
    axes::LAYER,
    grown::LAYER,
    difference::LAYER,
    origin::LAYER,
    closest::LAYER,
    support::LAYER,
    pair::LAYER,
    velocity::LAYER,
    ray::LAYER,
    sweep::LAYER,
    advancement::LAYER,
    tracks::LAYER,
    spin::LAYER,
    arc::LAYER,
    projection::LAYER,
    simplex::LAYER,
    bracket::LAYER,
    polytope::LAYER,
    edge_normals::LAYER,
    edge_fan::LAYER,
    merging::LAYER,
    separating_cone::LAYER,
    separating_lines::LAYER,
    graph::LAYER,
    fastest_approach::LAYER,
    enlarged::LAYER,
    note::LAYER,
];

/// The layer of what someone else answered, which a picture has where a scene says that.
pub(crate) static EXPECTED: &Layer = &expected::LAYER;

/// The layer of a name; `None` where there is none.
pub(crate) fn find(name: &str) -> Option<&'static Layer> {
    LAYERS.iter().find(|l| l.name == name)
}

/// Whether some layer has a label of a key.
pub(crate) fn is_key(key: &str) -> bool {
    LAYERS.iter().flat_map(|layer| layer.labels).any(|label| label.key == key)
}

/// Whether a layer is a chart: its lines stand for times and lengths, and for nothing where the bodies are.
pub(super) fn is_chart(layer: &Layer) -> bool {
    [graph::LAYER.name, fastest_approach::LAYER.name].contains(&layer.name)
}

/// Whether a layer shows no place of the panel's space, so that it can stand beside a chart.
pub(super) fn is_placeless(layer: &Layer) -> bool {
    layer.name == note::LAYER.name
}

/// Opacities of a series of `count`, evenly from the first to the last; of one, the last.
fn fade([first, last]: [f64; 2], count: usize) -> impl Iterator<Item = f64> {
    let steps = u32::try_from(count.saturating_sub(1)).unwrap_or(u32::MAX);
    (0..=steps).map(
        move |i| if steps == 0 { last } else { first + (last - first) * f64::from(i) / f64::from(steps) },
    )
}

/// The name of a part of the drawing that belongs to a body: `part("body", Side::A)` is `body-A`.
fn part(word: &str, side: Side) -> String {
    format!("{word}-{}", side.letter())
}

/// A small count as a number.
fn number_of(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::INFINITY, f64::from)
}
