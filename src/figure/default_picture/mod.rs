//! What is drawn where a scene does not say: for every kind of answer one picture, written as a scene would
//! write it.
//!
//! A picture is one file of this folder and one row in [`PICTURES`]: the panels, in the language of scenes,
//! and the answers that they suit, by how these turned out and by what the algorithm told. The first row that
//! fits is taken, so the particular ones come first. A layer of a picture that an answer has nothing for is
//! left out. In its panels `A` and `B` stand for the query's bodies, whatever their names.

mod axis_test;
mod bounded_approach;
mod bounded_motion;
mod bounded_motions;
mod bounded_translation;
mod bounded_turn;
mod bounding_box;
mod box_extents;
mod circle_lengths;
mod circle_penetration;
mod clamped_circle;
mod contact_points;
mod early_hit;
mod gjk_distance;
mod gjk_penetration;
mod gjk_rounded;
mod overlap_at_start;
mod pair_apart;
mod pair_overlapping;
mod separating_edge;
mod sweep_hit;
mod sweep_miss;
mod sweep_steps;
mod sweep_undecided;
mod turning_hit;
mod turning_miss;
mod turning_miss_in_steps;
mod turning_steps;
mod turning_steps_of_both;
mod turning_undecided;

use std::borrow::Cow;
use std::ops::Range;

use crate::collision::{Answer, Outcome};
use crate::geometry::{Body, read};
use crate::scene::{self, LayerSpec, Panel, Scene, Space, Spanned, Value, When, panels_of_text};
use crate::trace::Event;

use super::fault::Problem;
use super::language::Language;
use super::runs::{Run, Runs};
use super::text::rounded_down;

/// A row of the table of pictures.
pub struct Picture {
    /// The word for it, and the name of its file.
    pub name: &'static str,
    /// The answers that it is for, in one line.
    pub about: &'static str,
    /// Whether it suits a case.
    pub(crate) fits: fn(&Case) -> bool,
    /// Its panels, as a scene writes them; `A` and `B` are the query's bodies.
    pub panels: &'static str,
}

/// Every picture; the first that fits is taken.
///
/// ```
/// use tracefig::{figure::default_picture::PICTURES, scene::{Source, read}};
/// let bodies = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";
/// let first = &PICTURES[0];
/// let scene = read(&Source::new("s.toml", &format!("{bodies}\n{}", first.panels))).unwrap();
/// assert_eq!((first.name, scene.panels.len()), ("bounding-box", 1));
/// ```
pub static PICTURES: &[Picture] = &[
    bounding_box::PICTURE,
    bounded_turn::PICTURE,
    bounded_translation::PICTURE,
    bounded_approach::PICTURE,
    bounded_motions::PICTURE,
    bounded_motion::PICTURE,
    overlap_at_start::PICTURE,
    turning_steps::PICTURE,
    turning_steps_of_both::PICTURE,
    turning_hit::PICTURE,
    turning_miss_in_steps::PICTURE,
    turning_miss::PICTURE,
    turning_undecided::PICTURE,
    early_hit::PICTURE,
    sweep_steps::PICTURE,
    sweep_hit::PICTURE,
    sweep_miss::PICTURE,
    sweep_undecided::PICTURE,
    circle_penetration::PICTURE,
    circle_lengths::PICTURE,
    box_extents::PICTURE,
    clamped_circle::PICTURE,
    contact_points::PICTURE,
    axis_test::PICTURE,
    separating_edge::PICTURE,
    gjk_penetration::PICTURE,
    gjk_rounded::PICTURE,
    gjk_distance::PICTURE,
    pair_overlapping::PICTURE,
    pair_apart::PICTURE,
];

/// A scene and its answer, which a picture suits or does not.
pub(crate) struct Case<'c> {
    /// The scene.
    scene: &'c Scene,
    /// The answer, and what the algorithm told.
    run: &'c Run,
}

impl Case<'_> {
    /// How a question for the first contact turned out; `None` for other questions.
    fn outcome(&self) -> Option<&Outcome> {
        if let Answer::Impact(impact) = &self.run.answer { Some(&impact.outcome) } else { None }
    }

    /// For how many bodies the angle of the turn and the way of a motion bound are so; `None` for other
    /// questions.
    fn bounded(&self, is_so: fn(f64, f64) -> bool) -> Option<usize> {
        let of_body = |event: &Event| match *event {
            Event::MotionBounded { theta, linear, .. } => is_so(theta, linear),
            _ => false,
        };
        matches!(self.run.answer, Answer::MotionBound(_)).then(|| self.count(of_body))
    }

    /// Whether the bodies touch on their way.
    fn hits(&self) -> bool {
        matches!(self.outcome(), Some(Outcome::Hit { .. }))
    }

    /// Whether the bodies are proved to overlap at the moment of the question, and not only to touch: no push
    /// parts bodies that touch.
    fn overlaps(&self) -> bool {
        match &self.run.answer {
            Answer::Separation(found) => found.bounds.hi < 0.0,
            Answer::Contact(found) => found.separation.bounds.hi < 0.0,
            Answer::Overlap(found) => found.separation_bounds.hi < 0.0,
            _ => false,
        }
    }

    /// The bodies of the question.
    fn bodies(&self) -> impl Iterator<Item = &Body> {
        self.scene.query.of.iter().filter_map(|&i| self.scene.shapes.get(i)).map(|(_, body)| body)
    }

    /// Whether a body of the question turns.
    fn turns(&self) -> bool {
        self.bodies().any(|body| !body.spin.is_zero())
    }

    /// How many bodies of the question move.
    fn movers(&self) -> usize {
        self.bodies().filter(|body| body.moves()).count()
    }

    /// How many events of a kind the algorithm told.
    fn count(&self, is_so: impl Fn(&Event) -> bool) -> usize {
        self.run.events().filter(|event| is_so(event)).count()
    }

    /// How many steps an advancement took.
    fn steps(&self) -> usize {
        self.count(|event| matches!(event, Event::Advanced { .. }))
    }
}

/// A panel to be drawn, and whether its layers are those of a picture of this table.
pub(crate) struct Sheet<'s> {
    /// The panel.
    pub(crate) panel: Cow<'s, Panel>,
    /// Whether the layers are ours: one that the answer has nothing for is then left out in silence.
    pub(crate) ours: bool,
}

impl Sheet<'_> {
    /// Whether it shows the world by layers of ours.
    fn is_our_world(&self) -> bool {
        self.ours && self.panel.space == Space::World
    }

    /// Shows another moment than the scene says.
    pub(crate) fn pin(&mut self, time: f64) {
        let span = self.panel.span.clone();
        self.panel.to_mut().when = Some(Spanned { value: When::Time(time), span });
    }
}

/// The panels of a scene, those that it leaves out filled in; in `problems`, a panel whose layers are not
/// given and for which no picture has any. What someone else answered is shown by the layer `compared`,
/// in the first panel of ours where bodies are.
pub(crate) fn sheets<'s>(
    scene: &'s Scene,
    runs: &Runs,
    compared: &str,
    problems: &mut Vec<Problem>,
) -> Vec<Sheet<'s>> {
    let mut sheets = of_the_table(scene, runs, problems);
    if scene.query.expected.is_some()
        && let Some(world) = sheets.iter_mut().find(|sheet| sheet.is_our_world())
    {
        world.panel.to_mut().layers.get_or_insert_default().push(LayerSpec::named(compared));
    }
    sheets
}

/// The panels of a scene, those that it leaves out as the table has them.
fn of_the_table<'s>(scene: &'s Scene, runs: &Runs, problems: &mut Vec<Problem>) -> Vec<Sheet<'s>> {
    let whole = scene.panels.iter().all(|panel| panel.layers.is_some());
    if whole && !scene.panels.is_empty() {
        let given = |panel| Sheet { panel: Cow::Borrowed(panel), ours: false };
        return scene.panels.iter().map(given).collect();
    }
    let run = runs.own(scene, scene.query.time);
    let case = Case { scene, run: &run };
    let suiting = PICTURES.iter().filter(|picture| (picture.fits)(&case));
    if scene.panels.is_empty() {
        let panels = suiting.take(1).flat_map(|picture| of_case(picture, &case, &scene.query.span));
        return panels.map(|panel| Sheet { panel: Cow::Owned(panel), ours: true }).collect();
    }
    let rows: Vec<&Picture> = suiting.collect();
    scene.panels.iter().map(|panel| filled(panel, &case, &rows, problems)).collect()
}

/// A panel of the scene with the layers of the first picture that has some for its space.
fn filled<'s>(panel: &'s Panel, case: &Case, rows: &[&Picture], problems: &mut Vec<Problem>) -> Sheet<'s> {
    if panel.layers.is_some() {
        return Sheet { panel: Cow::Borrowed(panel), ours: false };
    }
    let configuration = |space: &Space| *space == Space::Configuration;
    let same = |other: &Panel| configuration(&other.space) == configuration(&panel.space);
    let fits = |picture: &&Picture| (picture.fits)(case);
    let alone = Some(&contact_points::ALONE).filter(fits);
    let beside = Some(&turning_steps::DIFFERENCES).filter(fits);
    let mut rows = alone.into_iter().chain(rows.iter().copied()).chain(beside);
    let layers = rows.find_map(|row| of_case(row, case, &panel.span).into_iter().find(same)?.layers);
    if layers.is_none() {
        let fault = scene::Fault::MissingKey {
            key: "layers".to_owned(),
            place: "a panel of a space that no picture of this answer shows".to_owned(),
            expected: "a list of layers".to_owned(),
        };
        problems.push(Problem::new(fault.into(), panel.span.clone()));
    }
    Sheet { panel: Cow::Owned(Panel { layers, ..panel.clone() }), ours: true }
}

/// The panels of a picture for the answer of a case.
fn of_case(picture: &Picture, case: &Case, at: &Range<usize>) -> Vec<Panel> {
    let mut panels = panels(picture, case.scene, at);
    let has_many = case.bodies().map(|body| body.shape.vertices.len()).sum::<usize>() > MANY;
    for panel in &mut panels {
        let is_crowded = (has_many || case.movers() > 1) && panel.space == Space::World;
        let Some(layers) = &mut panel.layers else { continue };
        layers.retain(|layer| !(is_crowded && is_of_steps(layer)));
        for layer in layers {
            until_undecided(layer, case);
            overlap_at_start::slow_down(layer, case);
        }
    }
    panels
}

/// Vertices of both bodies beyond which a picture of the world has none of their steps: their lines would be
/// more than labels can be placed among. Nor has one of bodies that both move, which would hide each other.
const MANY: usize = 2000;

/// Whether a layer draws every step.
fn is_of_steps(layer: &LayerSpec) -> bool {
    let is_so = |value: &Value| matches!(value, Value::Text(text) if text == "steps");
    layer.options.iter().any(|(key, value)| key.value == "at" && is_so(&value.value))
}

/// The panels of a picture for the bodies of a scene, their titles in its language; what goes wrong with
/// them is told at `at`.
fn panels(picture: &Picture, scene: &Scene, at: &Range<usize>) -> Vec<Panel> {
    let mut panels = panels_of_text(picture.panels, at);
    let language = Language::of(scene);
    for panel in &mut panels {
        let said = |title: &mut Spanned<String>| title.value = language.words(&title.value);
        panel.title.iter_mut().for_each(said);
        panel.title.take_if(|title| title.value.is_empty());
    }
    for layer in panels.iter_mut().filter_map(|panel| panel.layers.as_mut()).flatten() {
        name_bodies(layer, scene);
    }
    panels
}

/// The layers of all pictures, each with the space of its panel.
pub(crate) fn layers_of_all(scene: &Scene) -> Vec<(Space, LayerSpec)> {
    let of_panel = |panel: Panel| {
        let space = panel.space;
        panel.layers.unwrap_or_default().into_iter().map(move |layer| (space.clone(), layer))
    };
    PICTURES.iter().flat_map(|row| panels(row, scene, &scene.query.span)).flat_map(of_panel).collect()
}

/// Shows an undecided motion where it is no longer proved to be free, in the place of its end: that is what
/// the caption tells of, and a body that turns may end where it began.
fn until_undecided(layer: &mut LayerSpec, case: &Case) {
    let Some(Outcome::Unresolved { free_until, .. }) = case.outcome() else { return };
    // As the caption writes it.
    let Some(time) = read(&rounded_down(*free_until)).filter(|time| (f64::MIN_POSITIVE..1.0).contains(time))
    else {
        return;
    };
    for (_, value) in layer.options.iter_mut().filter(|(key, _)| key.value == "at") {
        if value.value == Value::Text(When::END.to_owned()) {
            value.value = Value::Number(time);
        }
    }
}

/// Puts the name of a body of the query in the place of `A` or `B` in a layer's option `of`.
fn name_bodies(layer: &mut LayerSpec, scene: &Scene) {
    for (_, value) in layer.options.iter_mut().filter(|(key, _)| key.value == "of") {
        let side = usize::from(value.value == Value::Text("B".to_owned()));
        if let Some((name, _)) = scene.query.of.get(side).and_then(|&i| scene.shapes.get(i)) {
            value.value = Value::Text(name.value.clone());
        }
    }
}

#[cfg(test)]
mod tests;
