//! A panel's moment, layers and options, resolved against what the answer has.
//!
//! What no answer to the scene's question could have is a problem of the scene. What this answer lacks, as
//! the hit where it is a miss, is a note: a scene may be a template that every line of a log is put through.

use std::borrow::Cow;

use crate::collision::{Answer, Outcome};
use crate::drawing::Rect;
use crate::geometry::{DVec2, Side};
use crate::scene::{self, LayerSpec, NOTES, Panel, Scene, Space, Spanned, Value, When};
use crate::typeset::{Style, line, paragraph};

use super::context::{Context, Moment};
use super::default_picture::Sheet;
use super::fault::{Fault, Problem};
use super::frame::Frame;
use super::layer::{self, Fed, Layer, Options, Shows};
use super::moment_title::title_by_moment;
use super::page::{Layout, Measures, Words};
use super::panel::{LayerPlan, PanelPlan};
use super::play::Play;
use super::question::is_of_a_moment;
use super::runs::Runs;
use super::standing::standing;
use super::text::{filled, set, under};

/// Lines of the longest title that is broken into lines.
const MOST_TITLE: usize = 4;

/// The options that name vertices or edges by their numbers, with the words for one of them and for several.
const COUNTED: [(&str, [&str; 2]); 3] = [
    ("edge", ["edge", "edges"]),
    ("vertex", ["vertex, number 0", "vertices, numbered from 0"]),
    ("only", ["vertex, number 0", "vertices, numbered from 0"]),
];

/// Resolves the panels of a scene and keeps what is wrong with them.
pub(super) struct Resolver<'r, 's> {
    /// The scene whose panels they are.
    pub(super) scene: &'s Scene,
    /// The algorithm runs of the figure so far.
    pub(super) runs: &'r Runs,
    /// The sizes on the page.
    pub(super) measures: &'r Measures,
    /// The room that each panel has for its words.
    pub(super) words: Words,
    /// What keeps the figure from being drawn.
    pub(super) problems: Vec<Problem>,
    /// What the answer lacks, with its place in the scene.
    pub(super) notes: Vec<Problem>,
}

/// A layer that can stand in its panel.
enum Resolved {
    /// It has something to draw.
    Drawn(LayerPlan),
    /// The answer has nothing for it.
    Unfed(&'static Layer),
}

impl<'r, 's> Resolver<'r, 's> {
    /// A resolver of panels that ask for so many columns each; `problems` are those of the scene so far.
    pub(super) fn of(
        scene: &'s Scene,
        runs: &'r Runs,
        (measures, columns): (&'r Measures, Vec<usize>),
        problems: Vec<Problem>,
    ) -> Self {
        let words = Layout::words(measures, columns, scene.canvas.columns);
        Self { scene, runs, measures, words, problems, notes: Vec::new() }
    }

    /// A panel, by its place among all, with its moment and its layers; `None`, with the reason told, where
    /// its moment can't exist.
    pub(super) fn panel(&mut self, index: usize, sheet: Sheet<'s>) -> Option<PanelPlan<'s>> {
        let Sheet { panel: mut source, ours } = sheet;
        if source.layers.as_ref().is_some_and(Vec::is_empty) {
            self.notes.push(Problem::new(Fault::NoLayers, source.span.clone()));
        }
        let moment = self.moment(&source)?;
        let (scene, runs) = (self.scene, self.runs);
        title_by_moment(scene, &mut source, moment);
        let space = source.space.clone();
        let context =
            Context { scene, space: &space, time: moment.time, step: moment.step, play: Play::No, runs };
        let (mut layers, mut unwritten, mut silent) = (Vec::<LayerPlan>::new(), Vec::new(), Vec::new());
        for (i, spec) in source.layers.iter().flatten().enumerate() {
            match self.layer(&context, spec, ours) {
                Some(Resolved::Drawn(layer)) => layers.push(layer),
                Some(Resolved::Unfed(layer)) => {
                    unwritten.extend(layer.labels);
                    silent.push(i);
                }
                None => {}
            }
        }
        self.charts_alone(&layers);
        // Else its lines would run through numbers and bodies.
        let (beneath, above): (Vec<_>, Vec<_>) =
            layers.into_iter().partition(|planned| layer::lies_beneath(planned.layer));
        let layers = beneath.into_iter().chain(above).collect();
        let title = source.title.as_ref().and_then(|t| {
            let style = Style::semibold(self.measures.title_size());
            let width = self.words.title_width(index);
            set(t, &context, (&mut self.problems, &mut self.notes), |text| {
                let whole = line(text, style)?;
                let Some(width) = width.filter(|width| whole.width > *width) else { return Ok(vec![whole]) };
                let folded = paragraph(text, style)?.lines(width);
                Ok(if folded.len() <= MOST_TITLE { folded } else { vec![whole] })
            })
        });
        let captioned = source.caption.as_ref().map(|text| {
            let said = (&mut self.problems, &mut self.notes);
            under(text, self.words.under(index), (&context, self.measures), said)
        });
        let (caption, caption_words) = captioned.unwrap_or_default();
        // What is said of the panel has the values that stand over it.
        let said = source.title.as_ref().and_then(|t| filled(t, &context));
        if let Some(said) = said
            && let Some(title) = &mut source.to_mut().title
        {
            title.value = said;
        }
        let frame = Frame::fit(None, DVec2::ZERO, DVec2::ONE, Rect::default());
        Some(PanelPlan {
            source: without(source, &silent),
            moment,
            layers,
            unwritten,
            title,
            caption,
            caption_words,
            frame,
            reach: None,
            in_steps: false,
            play: Play::No,
        })
    }

    /// Tells of charts that share their panel: a line of theirs over the bodies says nothing true of those.
    fn charts_alone(&mut self, layers: &[LayerPlan]) {
        let placed: Vec<&LayerPlan> = layers.iter().filter(|l| !layer::is_placeless(l.layer)).collect();
        for chart in placed.iter().filter(|l| layer::is_chart(l.layer) && placed.len() > 1) {
            let fault = Fault::SharedChart { layer: chart.layer.name };
            self.notes.push(Problem::new(fault, chart.span.clone()));
        }
    }

    /// The panel's moment; `None`, with the reason told, where no answer can have it.
    fn moment(&mut self, panel: &Panel) -> Option<Moment> {
        let (scene, runs) = (self.scene, self.runs);
        let own = if is_of_a_moment(scene.query.kind) { scene.query.time } else { 0.0 };
        let Some(when) = &panel.when else { return Some(Moment { time: own, step: None }) };
        let context = Context { scene, space: &panel.space, time: own, step: None, play: Play::No, runs };
        context.moment(&when.value).or_else(|| self.other_moment(&context, when))
    }

    /// The moment that a panel shows where this answer lacks the one that it names: of a miss its closest
    /// approach, of a hit that, of an undecided one the last moment that is proved free, of a step after the
    /// last one that.
    fn other_moment(&mut self, context: &Context, when: &Spanned<When>) -> Option<Moment> {
        let steps = context.steps();
        let answer = &context.run().answer;
        let (fault, moment) = match (&when.value, answer, steps.last()) {
            (&When::Step(asked), _, Some(&time)) => {
                let step = steps.len();
                (Fault::OtherStep { asked, last: step }, Moment { time, step: Some(step) })
            }
            (When::Hit | When::Closest | When::Bound, Answer::Impact(impact), _) => {
                let (shown, time) = match impact.outcome {
                    Outcome::Unresolved { free_until, .. } => ("the last moment proved free", free_until),
                    Outcome::Miss => ("the closest approach", context.closest()?.time),
                    Outcome::Hit { time, .. } => ("the first contact", time.lo),
                    Outcome::Overlapping { .. } => ("the start", 0.0),
                };
                let asked = match when.value {
                    When::Hit => "the hit",
                    When::Bound => "the bound of the first step",
                    _ => "the closest approach",
                };
                (Fault::OtherMoment { shown, asked, why: standing(answer) }, Moment { time, step: None })
            }
            (&When::Step(step), ..) => {
                self.problems.push(Problem::new(Fault::NoSuchStep { step, took: 0 }, when.span.clone()));
                return None;
            }
            _ => {
                self.problems.push(Problem::new(Fault::NoHit, when.span.clone()));
                return None;
            }
        };
        self.notes.push(Problem::new(fault, when.span.clone()));
        Some(moment)
    }

    /// A layer with its options; `None`, with the reasons told, where it can't be drawn in this panel.
    fn layer(&mut self, context: &Context, spec: &LayerSpec, ours: bool) -> Option<Resolved> {
        let span = &spec.name.span;
        let Some(layer) = layer::find(&spec.name.value) else {
            let known = layer::LAYERS.iter().map(|l| l.name.to_owned()).collect();
            let fault = scene::Fault::UnknownWord { what: "layer", got: spec.name.value.clone(), known };
            self.problems.push(Problem::new(fault.into(), span.clone()));
            return None;
        };
        let options = match Options::read(layer.options, spec, context.scene) {
            Ok(options) => options,
            Err(more) => {
                self.problems.extend(more.into_iter().map(Problem::from));
                return None;
            }
        };
        if let Some(space) = other_space(layer, context.space) {
            let fault = Fault::UnsuitedLayer { layer: layer.name, space };
            self.problems.push(Problem::new(fault, span.clone()));
            return None;
        }
        // Nor does a question know what a layer would need of the answer.
        let is_question = context.scene.variant == scene::Variant::Question;
        let why = match (layer.fed)(context, &options) {
            // A default picture shows what there is.
            Fed::NotByThisAnswer | Fed::NotHere(_) | Fed::Never if ours || is_question => {
                return Some(Resolved::Unfed(layer));
            }
            Fed::Yes => return Some(Resolved::Drawn(LayerPlan { layer, options, span: span.clone() })),
            Fed::Without { option, why } => {
                if !ours && !is_question {
                    let fault = Fault::NothingForOption { layer: layer.name, option, why };
                    let key = spec.options.iter().find(|(key, _)| key.value == option);
                    self.notes.push(Problem::new(fault, key.map_or(span, |(key, _)| &key.span).clone()));
                }
                return Some(Resolved::Drawn(LayerPlan { layer, options, span: span.clone() }));
            }
            Fed::NotByThisAnswer | Fed::NotHere(_) if !NOTES => {
                return Some(Resolved::Unfed(layer));
            }
            Fed::NotByThisAnswer => standing(&context.run().answer),
            Fed::NotHere(why) => why,
            Fed::Never => {
                let told = || needs(layer, spec).to_owned() + &there_are(context, &options);
                let needs = if NOTES { told() } else { String::new() };
                let fault = Fault::UnfedLayer { layer: layer.name, needs };
                self.problems.push(Problem::new(fault, span.clone()));
                return None;
            }
        };
        self.notes.push(Problem::new(Fault::NothingToDraw { layer: layer.name, why }, span.clone()));
        Some(Resolved::Unfed(layer))
    }
}

/// What a layer needs of a scene; where it needs different things for the words of an option, that of the
/// word which the scene says.
fn needs(layer: &Layer, spec: &LayerSpec) -> &'static str {
    let mut said = spec.options.iter().filter_map(|(_, value)| match &value.value {
        Value::Text(word) => Some(format!(" for \"{word}\"")),
        _ => None,
    });
    let parts = || layer.needs.split([':', ',']).map(str::trim);
    let of_word = |word: String| parts().find_map(|part| part.strip_suffix(word.as_str()));
    said.find_map(of_word).unwrap_or(layer.needs)
}

/// How many vertices or edges the bodies have, where a scene names some by their numbers.
fn there_are(context: &Context, options: &Options) -> String {
    let names = |option: &(&str, _)| options.counts(option.0).is_some();
    let Some((option, words)) = COUNTED.into_iter().find(names) else { return String::new() };
    let have = |(side, &index): (&Side, &usize)| {
        let (name, body) = context.scene.shapes.get(index)?;
        let is_one = |&i: &usize| option != "edge" || body.shape.edge_ends(i).is_some();
        let count = (0..body.shape.vertices.len()).filter(is_one).count();
        let word = words[usize::from(count != 1)];
        options.of(&Side::BOTH).contains(side).then(|| format!("; `{}` has {count} {word}", name.value))
    };
    Side::BOTH.iter().zip(&context.scene.query.of).filter_map(have).collect()
}

/// A panel without some of its layers, so that the description speaks of what is there.
fn without<'s>(mut panel: Cow<'s, Panel>, silent: &[usize]) -> Cow<'s, Panel> {
    if !silent.is_empty()
        && let Some(layers) = &mut panel.to_mut().layers
    {
        let mut index = 0..;
        layers.retain(|_| index.next().is_none_or(|i| !silent.contains(&i)));
    }
    panel
}

/// The space that a layer shows, as a scene names it, where it is not the panel's.
fn other_space(layer: &Layer, space: &Space) -> Option<&'static str> {
    match (layer.shows, *space == Space::Configuration) {
        (Shows::World, true) => Some("world"),
        (Shows::Configuration, false) => Some("configuration"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::scene::{Explain, Severity, open_text};

    #[test]
    fn a_panel_whose_list_of_layers_is_empty_is_drawn_with_a_warning_at_its_place() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }\n\
                    [[panels]]\nlayers = ['shapes']\n[[panels]]\nlayers = []\n";
        let scene = open_text("s.toml", text).unwrap().scene;
        let warnings = plan(&scene).unwrap().warnings;
        let told: Vec<_> =
            warnings.iter().map(|p| (p.fault.code(), p.fault.severity(), p.span.start)).collect();
        assert_eq!(told, [("no-layers", Severity::Warning, text.rfind("[[panels]]").unwrap())]);
    }

    #[test]
    fn a_chart_that_shares_its_panel_is_told() {
        let told = |layers: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1, velocity = [4, 0] }}
                shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [3, 0] }}
                query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }}
                panels = [{{ layers = [{layers}] }}]"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let shared = plan.warnings.iter().filter(|note| note.fault.code() == "shared-chart");
            shared.map(|p| text[p.span.clone()].to_owned()).collect::<Vec<_>>()
        };
        assert_eq!(told("'graph'"), Vec::<String>::new());
        assert_eq!(told("'graph', { layer = 'note', lines = ['x'] }"), Vec::<String>::new());
        assert_eq!(told("'shapes', 'fastest-approach'"), ["'fastest-approach'"]);
        assert_eq!(told("'graph', 'fastest-approach'"), ["'graph'", "'fastest-approach'"]);
    }

    #[test]
    fn a_layer_that_draws_nothing_says_what_it_lacks() {
        let told = |layer: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1] }}
                shapes.B = {{ kind = 'circle', radius = 0.5, position = [3, 0] }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
                panels = [{{ {layer} }}]"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            plan(&scene).map_or_else(
                |problems| problems[0].fault.help().unwrap_or_default(),
                |plan| plan.warnings.iter().map(|note| note.fault.to_string()).collect(),
            )
        };
        let simplex = "space = 'configuration', layers = ['difference', { layer = 'simplex', step = 9 }]";
        assert_eq!(told(simplex), "`simplex` draws nothing: the algorithm took fewer steps");
        assert_eq!(told("layers = ['shapes', { layer = 'ghosts', at = 'hit' }]"), "it needs a hit");
        let hit = told("layers = ['shapes', { layer = 'separation', at = 'hit' }]");
        assert!(
            hit.contains("for \"hit\" or another moment of a motion a question for the first contact"),
            "{hit}"
        );
        let corner = told("layers = ['shapes', { layer = 'vertices', of = 'A', only = 7 }]");
        assert!(corner.ends_with("; `A` has 4 vertices, numbered from 0"), "{corner}");
        let edge = told("layers = ['shapes', { layer = 'feature', of = 'B', edge = 0 }]");
        assert!(edge.ends_with("; `B` has 0 edges"), "{edge}");
        let steps = told("layers = ['shapes', { layer = 'ghosts', at = 'steps' }]");
        assert_eq!(steps, "it needs an algorithm that advances in steps");
    }
}
