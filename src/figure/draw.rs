//! A plan to a display list: layers, labels, titles, caption.

use std::borrow::Cow;

use crate::drawing::{Color, Dark, Drawing, Item, Paint, Role};

use crate::scene::{Background, Space, Variant};

use super::bands::{A_FIFTH, A_QUARTER, widest};
use super::describe::{self, Account, Shown};
use super::drawn_panel::{DrawnPanel, Sheet, draw_panel};
use super::exercise;
use super::fault::{Fault, Problem};
use super::grounds::grounds;
use super::handle::Handle;
use super::heading::heading;
use super::layer::{find, is_key};
use super::page::Page;
use super::panel::PanelPlan;
use super::placement::{LabelFault, Labelled, faults, tint};
use super::plan::Plan;
use super::printed::{across, title, under};
use super::runs::Run;
use super::steps::{Scope, numbered};
use super::text::overridden;
use super::theme::{Side, Theme};
use super::tongue::tongue;
use super::words_in_steps::let_words_come;

/// The shares of their scale at which panels without a `view` are tried in turn, where labels stand badly: of
/// a panel of 400 px the second leaves 40 more on each side, room for a leader line and a name.
const SHARES: [f64; 3] = [0.9, 0.8, 0.7];

/// Points of all lines of a figure beyond which it is drawn once, whatever its labels do: far more than a
/// committed figure has, drawn in 40 ms.
const MOST_POINTS: usize = 20_000;

/// A figure, drawn in a theme.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The display list that an output format writes, page pixels, y down.
    pub drawing: Drawing,
    /// Each panel's map from its space to the page, what labels keep off, and its labels.
    pub panels: Vec<Labelled>,
    /// Each inset's map, obstacles and labels, in the order of their panels.
    pub insets: Vec<Labelled>,
    /// What a reader of a live figure may drag, panel by panel.
    pub handles: Vec<Handle>,
    /// What should be better, with its place in the scene.
    pub warnings: Vec<Problem>,
    /// The share of their scale at which panels without a `view` are drawn: less than 1 where labels found
    /// no room beside the drawing.
    pub(crate) share: f64,
}

impl Figure {
    /// Everything that is wrong with the labels, panel by panel; none for a figure without fault. The same is
    /// said in [`Figure::warnings`].
    ///
    /// ```
    /// use tracefig::{figure::{LabelFault, draw, plan}, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1 }
    /// query = { kind = "bounds", of = ["A"] }
    /// labels.O.at = [0, 0]
    /// panels = [{ space = "world", layers = ["origin"] }]
    /// "#;
    /// let scene = read(&Source::new("pinned.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let figure = draw(&plan, plan.theme, "pinned");
    /// assert!(matches!(figure.faults()[..], [LabelFault::OnMarker { key: "O", .. }]));
    /// assert_eq!(figure.warnings.len(), 1);
    /// ```
    #[must_use]
    pub fn faults(&self) -> Vec<LabelFault> {
        self.panels.iter().chain(&self.insets).flat_map(faults).collect()
    }
}

/// Draws a plan in a theme; it cannot fail.
///
/// `id` is the prefix of every id in an SVG. Metadata and hash of the drawing are left empty, to who writes
/// files.
///
/// ```
/// use tracefig::{figure::{draw, plan, theme}, geometry::DVec2, scene::{Source, read}};
/// let text = r#"
/// shapes.A = { kind = "circle", radius = 1 }
/// query = { kind = "bounds", of = ["A"] }
/// panels = [{ space = "world", view = [-2, -1, 2, 1], layers = ["shapes"] }]
/// "#;
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let figure = draw(&plan, theme::find("dark").unwrap(), "circle");
/// let panel = &figure.panels[0];
/// assert_eq!(panel.frame.page(DVec2::ZERO), panel.frame.panel.center());
/// assert_eq!(panel.placed[0].key, "A");
/// ```
#[must_use]
pub fn draw(plan: &Plan, theme: &Theme, id: &str) -> Figure {
    let mut figure = draw_in_steps(plan, theme, id);
    // A still picture has no steps.
    figure.warnings.retain(|problem| !matches!(problem.fault, Fault::NoStepLeft { .. }));
    Figure { drawing: figure.drawing.finished(), ..figure }
}

/// Draws a plan in a theme with all that its steps show: also what a later step takes away. Labels are placed
/// once, for the finished figure, so [`Drawing::at_step`] moves nothing.
///
/// ```
/// use tracefig::{figure::{draw_in_steps, plan}, scene::{Source, read}};
/// let text = r#"
/// shapes.A = { kind = "circle", radius = 1 }
/// shapes.B = { kind = "circle", radius = 1, position = [3, 1] }
/// query = { kind = "separation", of = ["A", "B"] }
/// panels = [{ space = "world", layers = ["shapes", "separation"] }]
/// "#;
/// let scene = read(&Source::new("circles.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let steps = draw_in_steps(&plan, plan.theme, "circles").drawing.steps;
/// assert_eq!(steps[0].title, "The question");
/// assert!(steps[1].sentences[0].starts_with("A and B are 1.16 apart"));
/// ```
#[must_use]
pub fn draw_in_steps(plan: &Plan, theme: &Theme, id: &str) -> Figure {
    draw_after(plan, theme, id, None)
}

/// Draws a plan as the next frame of a figure that moves: labels rest where they stood in the frame before.
///
/// A label keeps its place, as seen from what it names, until it stands badly there. Nothing else is taken
/// from the frame before; without one this is [`draw_in_steps`], so [`Drawing::at_step`] gives the picture.
///
/// ```
/// use tracefig::{figure::{Figure, draw_after, plan}, geometry::DVec2, scene::{Source, read}};
/// let frame = |x: f64, before: Option<&Figure>| {
///     let text = format!(
///         "shapes.A = {{ kind = 'circle', radius = 1, position = [{x}, 0] }}\n\
///          query = {{ kind = 'bounds', of = ['A'] }}\n\
///          panels = [{{ view = [-4, -2, 4, 2], layers = ['shapes'] }}]"
///     );
///     let scene = read(&Source::new("frame.toml", &text)).unwrap();
///     let plan = plan(&scene).unwrap();
///     draw_after(&plan, plan.theme, "frame", before)
/// };
/// let first = frame(0.0, None);
/// let next = frame(0.25, Some(&first));
/// let [a, b] = [&first, &next].map(|figure| figure.panels[0].placed[0].bounds.x0);
/// let [from, to] = [0.0, 0.25].map(|x| first.panels[0].frame.page(DVec2::new(x, 0.0)).x);
/// assert!((b - a - (to - from)).abs() < 1e-9);
/// ```
#[must_use]
pub fn draw_after(plan: &Plan, theme: &Theme, id: &str, before: Option<&Figure>) -> Figure {
    let mut figure = draw_unjudged(plan, theme, id, before);
    let has_view = !plan.scene.panels.is_empty();
    let is_pinned =
        |key: &str| overridden(plan.scene, key, is_key).is_some_and(|(_, label)| label.at.is_some());
    let number = |i: usize| Some(i + 1).filter(|_| figure.panels.len() > 1);
    let of_panels = figure.panels.iter().enumerate().map(|(i, panel)| (number(i), false, panel));
    let all = of_panels.chain(figure.insets.iter().map(|inset| (None, true, inset)));
    let told = all.flat_map(|(panel, in_inset, labelled)| {
        faults(labelled).into_iter().map(move |fault| {
            let (key, span) = fault.label();
            let (is_pinned, span) = (is_pinned(key), span.clone());
            Problem::new(Fault::LabelClash { fault, panel, in_inset, has_view, is_pinned }, span)
        })
    });
    let told: Vec<Problem> = told.collect();
    figure.warnings.extend(told);
    figure
}

/// What [`draw_after`] draws, without a look at how the labels stand, which takes a twentieth of a frame.
pub(crate) fn draw_unjudged(plan: &Plan, theme: &Theme, id: &str, before: Option<&Figure>) -> Figure {
    let theme = &on_background(theme, plan);
    let run = plan.run_of_the_whole();
    let sheet = |share| Sheet { plan, theme, share };
    let drawn = match before {
        Some(before) => Panels::drawn(sheet(before.share), Some(before)),
        None => {
            SHARES.into_iter().fold(Panels::drawn(sheet(1.0), None), |best, share| best.looser(sheet(share)))
        }
    };
    let Panels { mut items, scopes, labelled: panels, insets, handles, share, .. } = drawn;
    let Page { headline, headline_step, caption, step, caption_column, .. } = plan.page;
    items.push(across("headline", &plan.headline, (headline, headline_step, 0.0), theme));
    items.push(across("caption", &plan.caption, (caption, step, caption_column), theme));
    let shaded = |side: Side| theme.shaded().map(|role| (role, side.word_color(role))).collect();
    let dark = theme.dark.map(|side| Dark {
        colors: Role::ALL.into_iter().zip(side.colors).collect(),
        ink: side.word_color(Role::Ink),
        words: shaded(side),
        fill_opacity: side.fill_opacity,
    });
    let (steps, note) = numbered(&mut items, &scopes, (plan.scene, &plan.runs));
    let_words_come(&mut items, &scopes, plan, steps.len());
    tint(&mut items);
    let drawing = Drawing {
        width: plan.page.width,
        height: plan.page.height,
        id: id.to_owned(),
        title: short(plan, &run),
        is_titled: plan.alt.is_some(),
        heading: heading(plan),
        lang: plan.scene.lang.as_ref().map(|lang| lang.value.clone()),
        desc: description(plan, &run),
        background: page_paint(plan, theme),
        ink: theme.word_color(Role::Ink),
        words: shaded(theme.light()),
        fill_opacity: theme.fill_opacity,
        dark,
        metadata: String::new(),
        hash: String::new(),
        items,
        steps,
        motion: Vec::new(),
        narrow: None,
    };
    let warnings = plan.warnings.iter().cloned().chain(note).collect();
    Figure { drawing, panels, insets, handles, warnings, share }
}

/// All panels of a figure, drawn.
struct Panels {
    /// What tells the panels apart, then each panel with its title and caption.
    items: Vec<Item>,
    /// Which items come with which events.
    scopes: Vec<Scope>,
    /// The labels of each panel.
    labelled: Vec<Labelled>,
    /// The labels of each inset.
    insets: Vec<Labelled>,
    /// What a reader may drag.
    handles: Vec<Handle>,
    /// Points of all lines.
    points: usize,
    /// The share of their scale at which panels without a `view` are drawn.
    share: f64,
}

impl Panels {
    /// The panels of a sheet; `before` is the frame before of a figure that moves.
    fn drawn(sheet: Sheet, before: Option<&Figure>) -> Self {
        let Sheet { plan, theme, share } = sheet;
        let (mut items, mut scopes, mut points) = (vec![grounds(plan, theme)], Vec::new(), 0);
        let (mut panels, mut insets, mut handles) = (Vec::new(), Vec::new(), Vec::new());
        for (i, panel) in plan.panels.iter().enumerate() {
            let last = before.map(|before| [before.panels.get(i), before.insets.get(insets.len())]);
            let drawn = draw_panel(sheet, (&panels, last.unwrap_or_default()), &mut handles);
            let DrawnPanel { group, labelled, inset, cues, base, points: more } = drawn;
            points += more;
            let begin = items.len();
            insets.extend(inset);
            items.push(Item::Group(group));
            items.extend(panel.title.as_ref().map(|text| title(text, plan, &labelled, theme)));
            items.extend(under(panel, plan, &labelled, theme));
            let shows_bodies = panel.source.space != Space::Configuration;
            scopes.push(Scope { items: begin..items.len(), cues, base, shows_bodies });
            panels.push(labelled);
        }
        let in_the_world = |handle: &Handle| plan.panels[handle.panel].source.space != Space::Configuration;
        let same = |a: &Handle, b: &Handle| (a.body, a.grip, a.vertex) == (b.body, b.grip, b.vertex);
        // What is held in the world is held there.
        let world: Vec<Handle> = handles.iter().copied().filter(in_the_world).collect();
        handles.retain(|handle| in_the_world(handle) || !world.iter().any(|other| same(handle, other)));
        Self { items, scopes, labelled: panels, insets, handles, points, share }
    }

    /// What is wrong with the labels of the panels whose scale is ours to choose.
    fn faults(&self, plan: &Plan) -> usize {
        let free = self.labelled.iter().zip(&plan.panels).filter(|(_, panel)| panel.source.view.is_none());
        free.map(|(labelled, _)| faults(labelled).len()).sum()
    }

    /// The panels of a sheet whose drawings leave more room for labels, if fewer of them stand badly there.
    fn looser(self, sheet: Sheet) -> Self {
        let now = self.faults(sheet.plan);
        if now == 0 || self.points > MOST_POINTS {
            return self;
        }
        let looser = Self::drawn(sheet, None);
        let left = looser.faults(sheet.plan);
        // What was full stays so, or nearly so where every label then stands well.
        let widest = |panels: &Self| widest(sheet.plan, &panels.labelled, &panels.insets);
        let most = if left == 0 { A_QUARTER } else { A_FIFTH };
        let is_better = left < now && (widest(&looser) <= most || widest(&self) > A_FIFTH);
        if is_better { looser } else { self }
    }
}

/// The theme with the background that the scene gives: halos have its colour too.
fn on_background<'t>(theme: &'t Theme, plan: &Plan) -> Cow<'t, Theme> {
    match plan.scene.canvas.background.as_ref().map(|given| given.value) {
        Some(Background::Color([r, g, b])) => Cow::Owned(theme.on(Color { r, g, b })),
        Some(Background::Transparent) | None => Cow::Borrowed(theme),
    }
}

/// What the page itself is painted with.
fn page_paint(plan: &Plan, theme: &Theme) -> Paint {
    let paint = theme.paint(Role::Background);
    match plan.scene.canvas.background.as_ref().map(|given| given.value) {
        Some(Background::Transparent) => paint.with_opacity(0.0),
        Some(Background::Color(_)) | None => paint,
    }
}

/// The short alternative text: the scene's own, or title and answer; of a question, its title.
fn short(plan: &Plan, run: &Run) -> String {
    let title = plan.title.as_deref();
    match (&plan.alt, plan.scene.variant) {
        (Some(alt), _) => alt.clone(),
        (None, Variant::Question) => {
            title.map_or_else(|| tongue(plan.scene).word(&describe::QUESTION).to_owned(), sentence)
        }
        (None, Variant::Figure | Variant::Key) => {
            describe::short(title, &Account::of(plan.scene, &plan.runs, run))
        }
    }
}

/// The long alternative text: the headline, what is there, and the caption where the page has no room for it.
fn description(plan: &Plan, run: &Run) -> String {
    let shown = |panel: &'_ PanelPlan| {
        let names = panel.source.layers.iter().flatten().map(|layer| layer.name.value.as_str());
        names.filter_map(find).map(|layer| &layer.in_words).collect()
    };
    let panels: Vec<_> = (plan.panels.iter())
        .map(|panel| {
            let (asked, layers) = (panel.source.when.as_ref().map(|when| when.value), shown(panel));
            let when = asked.map(|asked| describe::shown_at(asked, panel.moment.step, &run.answer));
            Shown { panel: &panel.source, is_chart: panel.is_chart(), when, layers }
        })
        .collect();
    let long = match exercise::spoken(plan.scene, &plan.runs) {
        Some(question) => {
            format!("{question} {}", describe::shown(plan.scene, &panels)).trim_end().to_owned()
        }
        None => describe::long((plan.scene, run), &Account::of(plan.scene, &plan.runs, run), &panels),
    };
    let headline = plan.headline.words.as_deref().map(sentence);
    let of_panels = plan.panels.iter().map(|panel| (panel.caption.len(), &panel.caption_words));
    let captions = of_panels.chain([(plan.caption.lines(), &plan.caption.words)]);
    let dropped = captions.filter_map(|(lines, words)| words.clone().filter(|_| lines == 0));
    headline.into_iter().chain([long]).chain(dropped).collect::<Vec<_>>().join(" ")
}

/// A text that ends as a sentence does, so that another one can follow.
fn sentence(text: &str) -> String {
    let is_ended = text.trim_end().ends_with(['.', '!', '?', '…', ':', ';']);
    if is_ended { text.to_owned() } else { format!("{text}.") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::plan;
    use crate::scene::open_text;

    /// A name longer than its body, about which the other one is turned.
    const CROWDED: &str = r#"
        shapes."longer than its body" = { kind = "aabb", half_extents = [3, 1], position = [-3.75, 1.5] }
        shapes.A = { kind = "aabb", half_extents = [1.5, 1.75], position = [3.75, 0.75] }
        query = { kind = "separation", of = ["longer than its body", "A"] }
        [[panels]]
        layers = ["shapes", "feature", "frame", "grown"]
        [[panels]]
        layers = ["shapes", "feature", "frame", "grown"]
    "#;

    #[test]
    fn a_drawing_is_smaller_where_its_labels_find_no_room_and_stays_so_from_frame_to_frame() {
        let scene = open_text("crowded", CROWDED).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let sheet = Sheet { plan: &plan, theme: plan.theme, share: 1.0 };
        let full = Panels::drawn(sheet, None);
        assert!(full.faults(&plan) > 0, "the scene is not crowded");
        let figure = draw(&plan, plan.theme, "crowded");
        assert!(figure.share < 1.0 && figure.faults().is_empty(), "{} {:?}", figure.share, figure.faults());
        assert_eq!(figure.panels[0].frame.scale, figure.share * plan.panels[0].frame.scale);
        assert_eq!(draw_after(&plan, plan.theme, "crowded", Some(&figure)).share, figure.share);
    }

    #[test]
    fn a_view_is_shown_as_large_as_it_was_asked_for() {
        let seen = CROWDED.replace("[[panels]]", "[[panels]]\nview = [-9, -3, 7, 5.5]");
        let scene = open_text("crowded", &seen).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "crowded");
        assert!(!figure.faults().is_empty(), "the scene is not crowded");
        assert_eq!(figure.share, 1.0);
    }
}
