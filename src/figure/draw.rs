//! A plan to a display list: layers, labels, titles, caption.

use std::borrow::Cow;

use crate::drawing::{
    Color, Contour, Dark, Drawing, Group, Halo, Item, Paint, Path, Point, Rect, Role, Shown, Stroke,
};

use crate::scene::Background;

use super::cue::Cue;
use super::describe;
use super::fault::{Fault, Problem};
use super::handle::Handle;
use super::inset::Inset;
use super::layer::is_key;
use super::lettering::{Lettering, lettered};
use super::page::Page;
use super::panel::PanelPlan;
use super::placement::{Ground, LabelFault, Labelled, Leader, Placed, Sought, faults, place, things};
use super::plan::Plan;
use super::playhead::given;
use super::runs::Run;
use super::sketch::{Anchor, Request, Size, Sketched};
use super::steps::{Scope, numbered};
use super::text::{Across, Wording, plain};
use super::theme::{Side, Theme};

/// How far a label's halo reaches, page pixels.
const HALO: f64 = 2.5;
/// Width of leader lines and of the lines between panels, page pixels.
const THIN: f64 = 0.75;
/// Radius of the dot at the end of a leader line in an area, page pixels: twice the line, and no marker.
const LEADER_DOT: f64 = 1.6;

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
    let figure = draw_in_steps(plan, theme, id);
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
    let theme = &on_background(theme, plan);
    let run = plan.runs.own(plan.scene, plan.panels.first().map_or(0.0, |p| p.moment.time));
    let mut items = vec![rules(plan, theme)];
    let (mut panels, mut insets): (Vec<Labelled>, Vec<Labelled>) = (Vec::new(), Vec::new());
    let mut handles = Vec::new();
    let mut scopes = Vec::new();
    for panel in &plan.panels {
        let drawn = draw_panel(plan, theme, &panels, &mut handles);
        let DrawnPanel { group, labelled, inset, cues, base } = drawn;
        let begin = items.len();
        insets.extend(inset);
        items.push(Item::Group(group));
        items.extend(panel.title.as_ref().map(|text| title(text, plan, &labelled, theme)));
        scopes.push(Scope { items: begin..items.len(), cues, base });
        panels.push(labelled);
    }
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
    let mut warnings = plan.warnings.clone();
    warnings.extend(panels.iter().chain(&insets).flat_map(faults).map(|fault| {
        let span = fault.label().1.clone();
        Problem::new(Fault::LabelClash(fault), span)
    }));
    let steps = numbered(&mut items, &scopes, (plan.scene, &plan.runs));
    let drawing = Drawing {
        width: plan.page.width,
        height: plan.page.height,
        id: id.to_owned(),
        title: plan.alt.clone().unwrap_or_else(|| describe::short(plan.scene, plan.title.as_deref(), &run)),
        is_titled: plan.alt.is_some(),
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
    };
    Figure { drawing, panels, insets, handles, warnings }
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

/// The panels before one that show the same space in the same size: where their labels stand, the same stand
/// again.
pub(super) fn earlier(plan: &Plan, index: usize) -> impl Iterator<Item = usize> {
    let this = &plan.panels[index];
    let same = move |p: &PanelPlan| p.source.space == this.source.space && p.frame.scale == this.frame.scale;
    (0..index).filter(move |&i| same(&plan.panels[i]))
}

/// An enlarged detail of a panel, drawn.
pub(super) struct Enlarged {
    /// Where it stands, and what it shows.
    inset: Inset,
    /// What the panel's layers draw there.
    sketched: Sketched,
    /// The labels that found a place there.
    labelled: Labelled,
}

/// What a panel's layers draw in a theme, and the labels that seek their places there; its inset, if it has
/// one, in which labels stand already.
pub(super) fn sought(
    plan: &Plan,
    theme: &Theme,
    index: usize,
) -> ((Sketched, Vec<Sought>), Option<Enlarged>) {
    let panel = &plan.panels[index];
    let context = panel.context(plan.scene, &plan.runs);
    let mut sketched = panel.sketch(&context, theme);
    let enlarged = panel.inset(&sketched).map(|inset| {
        let enlarged = panel.sketch_inset(&inset, &context, theme);
        let sought = seeking(plan, (theme, index), &enlarged);
        let mut labelled = labelled(plan, &enlarged, &sought, &[]);
        inset.without_the_cut_off(&mut labelled);
        inset.claim(&mut sketched, &named(&sought, &labelled));
        Enlarged { inset, sketched: enlarged, labelled }
    });
    let sought = seeking(plan, (theme, index), &sketched);
    ((sketched, sought), enlarged)
}

/// What labels that found a place belong to, with their keys.
fn named<'s>(sought: &'s [Sought], labelled: &Labelled) -> Vec<(&'static str, &'s Anchor)> {
    let is_placed = |s: &&Sought| labelled.placed.iter().any(|p| p.key == s.key && p.part == s.part);
    sought.iter().filter(is_placed).map(|s| (s.key, &s.anchor)).collect()
}

/// The labels that seek their places among what was drawn of a panel.
fn seeking(plan: &Plan, (theme, index): (&Theme, usize), sketched: &Sketched) -> Vec<Sought> {
    let panel = &plan.panels[index];
    let context = &panel.context(plan.scene, &plan.runs);
    let size = |size: Size| plan.layout.measures.size(size.kind());
    let marked = !theme.counts_on_color();
    let wording = Wording { context, type_size: &size, is_key, marked };
    // A text that can't be set was said by the plan.
    let set =
        |request: &Request| wording.set(request, panel.span_of(request), &mut Vec::new()).ok().flatten();
    sketched.requests.iter().filter_map(set).collect()
}

/// A panel, drawn.
struct DrawnPanel {
    /// What is drawn of it.
    group: Group,
    /// Its labels.
    labelled: Labelled,
    /// The labels of its inset.
    inset: Option<Labelled>,
    /// The cues of what is drawn, in the order of their numbers.
    cues: Vec<Cue>,
    /// With what the panel as a whole comes.
    base: Option<Cue>,
}

/// Draws a panel beside those before it. Where the answer gives its moment, what is dragged would move that
/// too, and nothing has a handle.
fn draw_panel(plan: &Plan, theme: &Theme, before: &[Labelled], handles: &mut Vec<Handle>) -> DrawnPanel {
    let index = before.len();
    let panel = &plan.panels[index];
    let ((sketched, sought), enlarged) = sought(plan, theme, index);
    if given(&panel.source, plan.scene).is_some() {
        handles.extend(sketched.holds.iter().filter_map(|hold| hold.on_page(&sketched.frame, index)));
    }
    let series = earlier(plan, index).map(|i| &before[i]);
    let series: Vec<(Rect, Placed)> =
        series.flat_map(|l| l.placed.iter().map(|p| (l.frame.panel, p.clone()))).collect();
    let labelled = labelled(plan, &sketched, &sought, &series);
    let mut group = Group::new(format!("panel-{}", index + 1));
    group.label = panel.source.title.as_ref().map(|t| plain(&t.value));
    let names = labels(&labelled, &sketched.requests, theme);
    let mut cues = sketched.cues.clone();
    group.items = vec![layers(sketched)];
    group.items.extend(enlarged.iter().map(|enlarged| enlarged.inset.marks(theme)));
    group.items.push(names);
    let inset = enlarged.map(|Enlarged { inset, sketched, labelled }| {
        let [ground, frame] = inset.ground(theme);
        let mut detail = Group::new("inset");
        detail.label = Some(inset.in_words());
        let names = labels(&labelled, &sketched.requests, theme);
        let (first, own) = (cues.len(), sketched.cues.clone());
        detail.items = vec![ground, layers(sketched), frame, names];
        let mut detail = Item::Group(detail);
        detail.for_each_shown(&|shown| *shown = shown.after(first));
        cues.extend(own);
        group.items.push(detail);
        labelled
    });
    let base = panel.known(&panel.context(plan.scene, &plan.runs));
    DrawnPanel { group, labelled, inset, cues, base }
}

/// What was drawn of a panel with its labels at their places; `series` are those of earlier panels.
fn labelled(plan: &Plan, sketched: &Sketched, sought: &[Sought], series: &[(Rect, Placed)]) -> Labelled {
    let Sketched { frame, obstacles, requests, unnamed, .. } = sketched;
    let things = &things(requests, unnamed, obstacles, frame);
    let ground = Ground { frame, obstacles, things, earlier: series, panels: plan.panels.len() };
    place(sought, &ground)
}

/// What layers drew, cut off at the edges of their panel.
fn layers(sketched: Sketched) -> Item {
    let mut layers = Group::new("layers");
    layers.clip = Some(sketched.frame.panel);
    layers.items = sketched.layers.into_iter().map(without_empty_parts).map(Item::Group).collect();
    Item::Group(layers)
}

/// The long alternative text: the headline, what is there, and the caption where the page has no room for it.
fn description(plan: &Plan, run: &Run) -> String {
    let panels: Vec<_> = plan.panels.iter().map(|panel| panel.source.as_ref()).collect();
    let long = describe::long(plan.scene, run, &panels);
    let headline = plan.headline.words.as_deref().map(sentence);
    let caption = plan.caption.words.clone().filter(|_| plan.caption.lines() == 0);
    headline.into_iter().chain([long]).chain(caption).collect::<Vec<_>>().join(" ")
}

/// A text that ends as a sentence does, so that another one can follow.
fn sentence(text: &str) -> String {
    let is_ended = text.trim_end().ends_with(['.', '!', '?', '…', ':', ';']);
    if is_ended { text.to_owned() } else { format!("{text}.") }
}

/// A layer without the parts that it began and drew nothing in.
fn without_empty_parts(mut layer: Group) -> Group {
    layer.items.retain(|item| !matches!(item, Item::Group(part) if part.items.is_empty()));
    layer
}

/// The labels of a panel, each with its halo and its leader line.
fn labels(panel: &Labelled, requests: &[Request], theme: &Theme) -> Item {
    let mut group = Group::new("labels");
    for label in &panel.placed {
        let mut one = Group::new(format!("label-{}", label.key));
        one.role = Some(label.role);
        if let Some(Leader { from, to, dot, .. }) = label.leader {
            let stroke = Stroke::solid(theme.paint(Role::Muted), THIN);
            one.items.push(Item::Path(Path::stroked(Contour::line(from, to), stroke)));
            if dot {
                let disc = Contour::Circle { center: from, radius: LEADER_DOT };
                one.items.push(Item::Path(Path::filled(disc, theme.paint(Role::Muted))));
            }
        }
        let halo = Some(Halo { paint: theme.paint(Role::Background), width: HALO });
        one.items.extend(
            label.lines.iter().flat_map(|(origin, line)| lettered(line, *origin, label.role, (theme, halo))),
        );
        let asked = requests.iter().find(|r| (r.part, r.label.key) == (label.part, label.key));
        let now = asked.map_or(Shown::ALWAYS, |request| request.shown);
        let mut one = Item::Group(one);
        one.for_each_shown(&|shown| *shown = now);
        group.items.push(one);
    }
    Item::Group(group)
}

/// The title over a panel.
fn title(text: &Lettering, plan: &Plan, panel: &Labelled, theme: &Theme) -> Item {
    let lines = text.of(theme);
    let mut group = Group::new("title");
    for (line, at) in lines.iter().zip(plan.page.title_baselines(&panel.frame.panel, lines.len())) {
        let origin = Point::new(at.x - 0.5 * line.width, at.y);
        group.items.extend(lettered(line, origin, Role::Ink, (theme, None)));
    }
    Item::Group(group)
}

/// A text across the page: its first baseline begins at `at`, the others follow by `step` pixels, and another
/// column by `aside`.
fn across(name: &str, text: &Across, (at, step, aside): (Point, f64, f64), theme: &Theme) -> Item {
    let mut group = Group::new(name);
    group.label.clone_from(&text.words);
    let mut x = at.x;
    for column in &text.columns {
        let mut y = at.y;
        for line in column.of(theme) {
            group.items.extend(lettered(line, Point::new(x, y), Role::Ink, (theme, None)));
            y += step;
        }
        x += aside;
    }
    Item::Group(group)
}

/// The thin lines between panels.
fn rules(plan: &Plan, theme: &Theme) -> Item {
    let mut group = Group::new("rules");
    for &(from, to) in &plan.page.rules {
        let stroke = Stroke::solid(theme.paint(Role::Grid), 2.0 * THIN);
        group.items.push(Item::Path(Path::stroked(Contour::line(from, to), stroke)));
    }
    Item::Group(group)
}
