//! A panel and its layers, resolved: what [`plan`](super::plan::plan) makes and [`draw`](super::draw::draw)
//! draws.

use std::borrow::Cow;
use std::ops::Range;

use crate::drawing::Rect;
use crate::scene::{self, Detail, Panel, Scene, Spanned};

use super::context::{Context, Moment};
use super::cue::Cue;
use super::frame::{Extent, Frame};
use super::inset::Inset;
use super::layer::{LabelKey, Layer, Options, is_chart};
use super::lettering::Lettering;
use super::limits::MAX_POINTS;
use super::page::Measures;
use super::play::Play;
use super::runs::Runs;
use super::sketch::{Request, Size, Sketch, Sketched};
use super::text::Decimal;
use super::theme::Theme;

/// The most points of all lines of an inset that nobody asked for: a fifth of what a figure may have.
const MOST_ENLARGED: usize = MAX_POINTS / 5;

/// A panel of a scene, resolved.
#[derive(Debug)]
pub(crate) struct PanelPlan<'s> {
    /// The panel as the scene wrote it, or as a default picture has it.
    pub(crate) source: Cow<'s, Panel>,
    /// When it shows the bodies.
    pub(crate) moment: Moment,
    /// The layers, in drawing order.
    pub(crate) layers: Vec<LayerPlan>,
    /// The labels of layers that this answer has nothing for: a scene may speak of them.
    pub(crate) unwritten: Vec<&'static LabelKey>,
    /// The title, set in type.
    pub(crate) title: Option<Lettering>,
    /// What leads through it, set as wide as the panel; no lines where there is no room for it.
    pub(crate) caption: Lettering,
    /// The plain words of that; `None` where it has none.
    pub(crate) caption_words: Option<String>,
    /// Where its space lies on the page.
    pub(crate) frame: Frame,
    /// What it shows besides what it draws, its smallest and largest coordinates: where bodies are on their
    /// way in a figure that plays.
    pub(crate) reach: Extent,
    /// Whether it is drawn for its steps: its labels then keep off what comes and goes with those.
    pub(crate) in_steps: bool,
    /// What becomes of it in a figure that plays.
    pub(crate) play: Play,
}

/// A layer of a panel with its options, checked.
pub(crate) struct LayerPlan {
    /// The row in the table of layers.
    pub(crate) layer: &'static Layer,
    /// What the scene gave, each value fit for its option.
    pub(crate) options: Options,
    /// Where its name stands in the scene: what a warning about its labels points at.
    pub(crate) span: Range<usize>,
}

impl std::fmt::Debug for LayerPlan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { layer, options, span: _ } = self;
        f.debug_struct("LayerPlan")
            .field("layer", &layer.name)
            .field("options", options)
            .finish_non_exhaustive()
    }
}

impl PanelPlan<'_> {
    /// What the panel's layers may know.
    pub(crate) fn context<'p>(&'p self, scene: &'p Scene, runs: &'p Runs) -> Context<'p> {
        let Moment { time, step } = self.moment;
        Context { scene, space: &self.source.space, time, step, play: self.play, runs }
    }

    /// The labels that the panel's layers can write, whether the answer has something for them or not.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &'static LabelKey> {
        let drawn = self.layers.iter().flat_map(|planned| planned.layer.labels);
        drawn.chain(self.unwritten.iter().copied())
    }

    /// Whether its lines stand for times and lengths.
    pub(crate) fn is_chart(&self) -> bool {
        self.layers.iter().any(|planned| is_chart(planned.layer))
    }

    /// With what the panel comes: its moment may be one that an algorithm finds.
    pub(crate) fn known(&self, context: &Context) -> Option<Cue> {
        context.known(&self.source.when.as_ref()?.value)
    }

    /// Lets every layer draw, in the panel's frame and the theme's colours.
    pub(crate) fn sketch(&self, context: &Context, theme: &Theme) -> Sketched {
        self.sketch_at(1.0, context, theme)
    }

    /// Lets every layer draw at a share of the panel's scale, which leaves room about the drawing; a panel
    /// with a `view` has the scale that the scene asks for.
    pub(crate) fn sketch_at(&self, share: f64, context: &Context, theme: &Theme) -> Sketched {
        self.drawn(begun(self.frame_at(share), context, theme), context).finish()
    }

    /// Where its space lies on the page at a share of its scale.
    pub(crate) fn frame_at(&self, share: f64) -> Frame {
        let share = if self.source.view.is_some() { 1.0 } else { share };
        Frame { scale: share * self.frame.scale, ..self.frame }
    }

    /// Lets every layer draw in the frame of an inset; `own` is what they drew in the panel.
    pub(crate) fn sketch_inset(
        &self,
        inset: &Inset,
        own: &Sketched,
        (context, theme): (&Context, &Theme),
    ) -> Sketched {
        let bare = begun(inset.frame, context, theme).without_numbers();
        let is_small = self.source.inset.as_ref().is_some_and(|inset| inset.value == Detail::Small);
        let mut sketch = self.drawn(if is_small { bare.without_axes() } else { bare }, context);
        inset.write_factor(&mut sketch, |number| Decimal::of(context.scene).in_latex(number));
        let mut sketched = sketch.finish();
        inset.without_the_panels(&self.source, own, &mut sketched);
        inset.keep_off_the_frame(&mut sketched);
        sketched
    }

    /// The inset that the panel asks for, if it asks for one that enlarges, beside what its layers drew;
    /// `before` is where it stood in the frame before of a figure that moves.
    pub(crate) fn inset(&self, sketched: &Sketched, before: Option<Rect>) -> Option<Inset> {
        Inset::of(&self.source, sketched, before)
    }

    /// The inset that the panel asks for, and where the scene asks for it; `None` where all of it lies beside
    /// what the panel shows, of which there is a warning.
    ///
    /// # Errors
    ///
    /// Where it shows so much that nothing could be enlarged.
    pub(crate) fn asked_inset(
        &self,
        sketched: &Sketched,
    ) -> Result<Option<(&Range<usize>, Inset)>, scene::Problem> {
        let Some(Spanned { value, span }) = &self.source.inset else { return Ok(None) };
        let found = self.inset(sketched, None);
        if found.is_none() && *value != Detail::Small && !Inset::is_beside(&self.source, sketched) {
            let message = "the inset shows too much of its panel to be enlarged".to_owned();
            let help = "give it a smaller rectangle, `inset = [x0, y0, x1, y1]`".to_owned();
            return Err(scene::Problem::new(scene::Fault::Conflict { message, help }, span.clone()));
        }
        Ok(found.map(|inset| (span, inset)))
    }

    /// Does without the inset of what is small, where nothing is, or where it would draw too much: a dotted
    /// line is as much longer as it is enlarged.
    pub(crate) fn keep_inset(&mut self, (scene, runs): (&Scene, &Runs), theme: &Theme, sketched: &Sketched) {
        let asked = self.source.inset.as_ref().map(|inset| inset.value);
        if asked != Some(Detail::Small) {
            return;
        }
        let drawn = |inset: Inset| {
            let context = self.context(scene, runs);
            self.sketch_inset(&inset, sketched, (&context, theme)).points
        };
        // Where labels want more room the panel is drawn smaller: what is nearly too small here is so there.
        let elsewhere = Rect { x0: 0.0, y0: 0.0, x1: 0.0, y1: 0.0 };
        if self.inset(sketched, Some(elsewhere)).is_none_or(|inset| drawn(inset) > MOST_ENLARGED) {
            self.source.to_mut().inset = None;
        }
    }

    /// What every layer draws where some have other options, by their place in the panel.
    pub(crate) fn sketch_with(
        &self,
        other: &[Option<Options>],
        (scene, runs, theme): (&Scene, &Runs, &Theme),
    ) -> Sketched {
        let context = &self.context(scene, runs);
        let other = |index: usize| other.get(index)?.as_ref();
        self.drawn_with(begun(self.frame, context, theme), context, other).finish()
    }

    /// What every layer draws in a panel.
    fn drawn<'f>(&self, sketch: Sketch<'f>, context: &Context) -> Sketch<'f> {
        self.drawn_with(sketch, context, |_| None)
    }

    /// What every layer draws in a panel, some of them with other options than the scene's.
    fn drawn_with<'f, 'o>(
        &'o self,
        sketch: Sketch<'f>,
        context: &Context,
        other: impl Fn(usize) -> Option<&'o Options>,
    ) -> Sketch<'f> {
        let sketch = sketch.of_layers(self.layers.iter().map(|planned| planned.layer.name));
        let mut sketch = sketch.in_steps(self.in_steps);
        for (index, planned) in self.layers.iter().enumerate() {
            if sketch.is_full() {
                break;
            }
            let options = other(index).unwrap_or(&planned.options);
            sketch.begin_layer(planned.layer.name, options.flag("labels", true));
            (planned.layer.draw)(&mut sketch, context, options);
        }
        sketch
    }

    /// Where the layer that asked for a label stands in the scene.
    pub(crate) fn span_of(&self, request: &Request) -> &Range<usize> {
        self.layers.get(request.layer).map_or(&self.source.span, |planned| &planned.span)
    }
}

/// An empty panel of a frame.
fn begun<'f>(frame: Frame, context: &Context, theme: &'f Theme) -> Sketch<'f> {
    let measures = Measures::of(&context.scene.canvas, theme.text);
    let sketch = Sketch::new(frame, theme, measures.unit);
    sketch.with_small_letters(measures.size(Size::Small.kind()))
}
