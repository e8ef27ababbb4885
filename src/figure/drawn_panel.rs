//! A panel to groups of a display list: what its layers draw, its inset, its labels at their places.

use crate::drawing::{Clip, Contour, Group, Halo, Item, Path, Rect, Role, Stroke};
use crate::scene::Space;

use super::cue::Cue;
use super::grounds::ground;
use super::handle::Handle;
use super::inset::Inset;
use super::layer::is_key;
use super::lettering::lettered;
use super::panel::PanelPlan;
use super::placement::{Ground, Labelled, Leader, Placed, Sought, place, things};
use super::plan::Plan;
use super::playhead::given;
use super::question::keeps_the_difference;
use super::sketch::{Anchor, Request, Size, Sketched};
use super::text::{Wording, plain};
use super::theme::Theme;

/// How far the halo of a label reaches through which a line runs, page pixels: over the gaps of its words, in
/// which what is left of the line would be read as a minus.
const WIDE_HALO: f64 = 4.0;
/// How far a label's halo reaches, page pixels.
const HALO: f64 = 2.5;
/// Width of leader lines, page pixels.
const THIN: f64 = 0.75;
/// Radius of the dot at the end of a leader line in an area, page pixels: twice the line, and no marker.
const LEADER_DOT: f64 = 1.6;

/// A plan in a theme and a size.
#[derive(Clone, Copy)]
pub(super) struct Sheet<'p> {
    /// What is drawn.
    pub(super) plan: &'p Plan<'p>,
    /// In which colours.
    pub(super) theme: &'p Theme,
    /// The share of their scale at which panels without a `view` are drawn.
    pub(super) share: f64,
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

/// What a panel's layers draw in a theme; if the plan has kept it, with the labels of all of it.
fn sketched(Sheet { plan, theme, share }: Sheet, index: usize) -> (Sketched, Option<Vec<Sought>>) {
    let panel = &plan.panels[index];
    let is_planned = std::ptr::eq(theme, plan.theme);
    let kept = if is_planned { plan.kept.take(index, &panel.frame_at(share)) } else { None };
    let (sketched, sought) = kept.unzip();
    let draw = || panel.sketch_at(share, &panel.context(plan.scene, &plan.runs), theme);
    (sketched.unwrap_or_else(draw), sought)
}

/// What a panel's layers draw in a theme, and the labels that seek their places there; its inset, if it has
/// one, in which labels stand already, `before` as in the frame before.
pub(super) fn sought(
    Sheet { plan, theme, share }: Sheet,
    index: usize,
    before: Option<&Labelled>,
) -> ((Sketched, Vec<Sought>), Option<Enlarged>) {
    let panel = &plan.panels[index];
    let context = panel.context(plan.scene, &plan.runs);
    let (mut sketched, kept) = sketched(Sheet { plan, theme, share }, index);
    let enlarged = panel.inset(&sketched, before.map(|before| before.frame.panel)).map(|inset| {
        let enlarged = panel.sketch_inset(&inset, &sketched, (&context, theme));
        let sought = seeking(plan, (theme, index), &enlarged);
        let mut labelled = labelled(plan, &enlarged, &sought, (&[], before));
        inset.without_the_cut_off(&mut labelled);
        inset.claim(&mut sketched, &named(&sought, &labelled));
        Enlarged { inset, sketched: enlarged, labelled }
    });
    // An inset claims some of the labels for itself.
    let kept = kept.filter(|_| enlarged.is_none());
    let sought = kept.unwrap_or_else(|| seeking(plan, (theme, index), &sketched));
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
pub(super) struct DrawnPanel {
    /// What is drawn of it.
    pub(super) group: Group,
    /// Its labels.
    pub(super) labelled: Labelled,
    /// The labels of its inset.
    pub(super) inset: Option<Labelled>,
    /// The cues of what is drawn, in the order of their numbers.
    pub(super) cues: Vec<Cue>,
    /// With what the panel as a whole comes.
    pub(super) base: Option<Cue>,
    /// Points of all its lines.
    pub(super) points: usize,
}

/// Draws a panel beside the earlier ones; `before` are the panel and its inset in the frame before. Where the
/// answer gives its moment, what is dragged would move that too, and nothing has a handle.
pub(super) fn draw_panel(
    sheet: Sheet,
    (panels, [before, inset]): (&[Labelled], [Option<&Labelled>; 2]),
    handles: &mut Vec<Handle>,
) -> DrawnPanel {
    let Sheet { plan, theme, .. } = sheet;
    let index = panels.len();
    let panel = &plan.panels[index];
    let ((sketched, sought), enlarged) = sought(sheet, index, inset);
    // At a step of a sweep without turning B ⊖ A is where it was at the start.
    let is_step = panel.moment.step.is_some() && panel.source.space == Space::Configuration;
    let stands = is_step && keeps_the_difference(plan.scene.query.kind);
    if stands || given(&panel.source, plan.scene).is_some() {
        handles.extend(sketched.holds.iter().filter_map(|hold| hold.on_page(&sketched.frame, index)));
    }
    let series = earlier(plan, index).map(|i| &panels[i]);
    let series: Vec<(Rect, Placed)> =
        series.flat_map(|l| l.placed.iter().map(|p| (l.frame.panel, p.clone()))).collect();
    let labelled = labelled(plan, &sketched, &sought, (&series, before));
    let mut group = Group::new(format!("panel-{}", index + 1));
    group.label = panel.source.title.as_ref().map(|t| plain(&t.value));
    let names = labels(&labelled, theme);
    let mut cues = sketched.cues.clone();
    let points = sketched.points + enlarged.as_ref().map_or(0, |enlarged| enlarged.sketched.points);
    let edge = ground(sketched.frame.panel, plan, theme);
    group.items = vec![layers(sketched, edge)];
    group.items.extend(enlarged.iter().map(|enlarged| enlarged.inset.marks(theme)));
    group.items.push(names);
    let inset = enlarged.map(|Enlarged { inset, sketched, labelled }| {
        let [ground, frame] = inset.ground(theme);
        let mut detail = Group::new("inset");
        detail.label = Some(inset.in_words());
        let names = labels(&labelled, theme);
        let (first, own) = (cues.len(), sketched.cues.clone());
        let edge = sketched.frame.panel.into();
        detail.items = vec![ground, layers(sketched, edge), frame, names];
        let mut detail = Item::Group(detail);
        detail.for_each_shown(&|shown| *shown = shown.after(first));
        cues.extend(own);
        inset.comes(&mut detail, &|a, b| is_before(&cues, a, b));
        group.items.push(detail);
        labelled
    });
    let base = panel.known(&panel.context(plan.scene, &plan.runs));
    DrawnPanel { group, labelled, inset, cues, base, points }
}

/// Whether the first of two cues, by their numbers, comes before the other: 1 is of no event, and before all.
fn is_before(cues: &[Cue], a: usize, b: usize) -> bool {
    let cue = |number: usize| number.checked_sub(2).and_then(|index| cues.get(index));
    match (cue(a), cue(b)) {
        (Some(a), Some(b)) => a.order(b).is_lt(),
        (a, b) => a.is_none() && b.is_some(),
    }
}

/// What was drawn of a panel with its labels at their places; `earlier` are those of earlier panels, `before`
/// the panel in the frame before.
fn labelled(
    plan: &Plan,
    sketched: &Sketched,
    sought: &[Sought],
    (earlier, before): (&[(Rect, Placed)], Option<&Labelled>),
) -> Labelled {
    let Sketched { frame, obstacles, requests, unnamed, .. } = sketched;
    let things = &things(requests, unnamed, obstacles, frame);
    let ground = Ground { frame, obstacles, things, earlier, before, panels: plan.panels.len() };
    place(sought, &ground)
}

/// What layers drew, cut off at an edge.
fn layers(sketched: Sketched, edge: Clip) -> Item {
    let mut layers = Group::new("layers");
    layers.clip = Some(edge);
    layers.items = sketched.layers.into_iter().map(without_empty_parts).map(Item::Group).collect();
    Item::Group(layers)
}

/// A layer without the parts that it began and drew nothing in.
fn without_empty_parts(mut layer: Group) -> Group {
    layer.items.retain(|item| !matches!(item, Item::Group(part) if part.items.is_empty()));
    layer
}

/// The labels of a panel, each with its halo and its leader line.
fn labels(panel: &Labelled, theme: &Theme) -> Item {
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
        let width = if panel.is_crossed(label) { WIDE_HALO } else { HALO };
        let halo = Some(Halo::plain(theme.paint(Role::Background), width));
        one.items.extend(
            label
                .lines
                .iter()
                .flat_map(|(origin, line)| lettered(line, *origin, label.role, (theme, halo.clone()))),
        );
        let mut one = Item::Group(one);
        one.for_each_shown(&|shown| *shown = label.shown);
        group.items.push(one);
    }
    Item::Group(group)
}
