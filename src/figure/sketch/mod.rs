//! What a layer draws with: primitives in the panel's space, mapped to the page by the panel's [`Frame`].
//!
//! Every primitive also says what it covers, so that labels keep off it. A layer names its parts (`part`),
//! and what it draws until the next part belongs to that part; a label belongs to the part that is current
//! when it is asked for, and may touch that part's strokes only.

mod construction;
mod cover;
mod cues;
mod detail;
mod intersection;
mod label;
mod line;
mod look;
mod marker;
mod measure;
mod neighbours;
mod outline;
mod overlap;
mod pen;
mod right_angle;
mod round;
mod span;
mod words;

use crate::drawing::{Contour, Group, Item, Paint, Path, Point, Rect, Shown};
use crate::figure::cue::Cue;
use crate::figure::frame::{Extent, Frame};
use crate::figure::handle::Hold;
use crate::figure::limits::{DASH, MAX_POINTS, PATTERNED, whole};
use crate::figure::theme::Theme;
use crate::geometry::DVec2;

pub(crate) use cover::{Cover, Obstacle, Weight};
use cues::Cues;
pub(crate) use detail::Detail;
pub(crate) use label::{Anchor, Best, Corner, Label, Rank, Size, left_of};
pub(crate) use line::{HEAD_LENGTH, HEAD_WIDTH};
pub(crate) use marker::SPECK;
pub(crate) use outline::{Outline, Piece, angle_of, on_circle};
pub(crate) use pen::{Dash, LARGE_MARKER, MARKER, Marker, Pen, SMALL_MARKER, Wash};
pub(crate) use words::Words;

/// The least length of a mark that can be read, page pixels: below, an arrow's head takes half of it.
const SEEN: f64 = 14.0;
/// The share of a panel's shorter edge that a mark may take at most: what is larger dwarfs what it is drawn
/// at.
const SHARE: f64 = 1.0 / 3.0;

/// A label that a layer asked for, with the part and layer that it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Request {
    /// What was asked for.
    pub(crate) label: Label,
    /// The part that it belongs to.
    pub(crate) part: usize,
    /// The index of the layer in its panel.
    pub(crate) layer: usize,
    /// When it comes and goes, as [`Sketched::cues`] have it.
    pub(crate) shown: Shown,
}

/// A panel that layers draw in, one after the other.
pub(crate) struct Sketch<'f> {
    /// The map from the panel to the page.
    frame: Frame,
    /// The colours.
    theme: &'f Theme,
    /// The width on the page of what is one pixel wide on the usual page; at most 1.
    unit: f64,
    /// What the layers drew so far, a group each, with a group for each part.
    layers: Vec<Group>,
    /// The names of all layers of the panel, drawn already or not.
    names: Vec<&'static str>,
    /// The number of the current part.
    part: usize,
    /// How much labels mind what is drawn now.
    weight: Weight,
    /// Whether the current layer writes its labels.
    labels: bool,
    /// Whether axes have numbers.
    numbers: bool,
    /// Whether there are axes at all.
    axes: bool,
    /// The size of small letters, page pixels an em.
    small: f64,
    /// What labels keep off so far.
    obstacles: Vec<Obstacle>,
    /// Where the arrows end and begin that end at points without a marker so far, in the panel's space.
    tips: Vec<(DVec2, DVec2)>,
    /// The labels asked for so far.
    requests: Vec<Request>,
    /// The bodies that were filled so far.
    bodies: overlap::Bodies,
    /// What has no label so far, though one of its kind could name it.
    unnamed: Vec<Anchor>,
    /// What a reader may take hold of so far, each once.
    holds: Vec<Hold>,
    /// Smallest and largest coordinates of what was drawn, in the panel's space.
    extent: Extent,
    /// Smallest and largest coordinates of what steps take away again.
    passed: Extent,
    /// What the panel is about and may be too small to see.
    details: Vec<Detail>,
    /// The page rectangle beside the numbers along the panel's edges.
    free: Rect,
    /// Points of all lines so far.
    points: usize,
    /// Million page pixels of all areas so far.
    painted: f64,
    /// With what marks come and go.
    cues: Cues,
}

/// What a panel's layers drew and asked for.
pub(crate) struct Sketched {
    /// The map from the panel to the page by which it was drawn.
    pub(crate) frame: Frame,
    /// A group for each layer, with a group for each part.
    pub(crate) layers: Vec<Group>,
    /// What labels keep off.
    pub(crate) obstacles: Vec<Obstacle>,
    /// The labels that were asked for.
    pub(crate) requests: Vec<Request>,
    /// What has no label, though one of its kind could name it.
    pub(crate) unnamed: Vec<Anchor>,
    /// What a reader may take hold of.
    pub(crate) holds: Vec<Hold>,
    /// Smallest and largest coordinates of what was drawn, in the panel's space.
    pub(crate) extent: Extent,
    /// Smallest and largest coordinates of what steps take away again, in the panel's space.
    pub(crate) passed: Extent,
    /// What the panel is about and may be too small to see.
    pub(crate) details: Vec<Detail>,
    /// The page rectangle beside the numbers along the panel's edges.
    pub(crate) free: Rect,
    /// Points of all lines; beyond [`MAX_POINTS`] what was drawn is not kept.
    pub(crate) points: usize,
    /// Million page pixels of all areas.
    pub(crate) painted: f64,
    /// The cues of marks and labels: what is shown since 2 comes with the first one; since 1 is what was
    /// there before.
    pub(crate) cues: Vec<Cue>,
}

impl<'f> Sketch<'f> {
    /// An empty panel; `unit` is how wide on its page a pixel of the usual page is, at most 1.
    pub(crate) fn new(frame: Frame, theme: &'f Theme, unit: f64) -> Self {
        Self {
            frame,
            theme,
            unit,
            layers: Vec::new(),
            names: Vec::new(),
            part: 0,
            weight: Weight::Normal,
            labels: true,
            numbers: true,
            axes: true,
            small: theme.text.of(Size::Small.kind()),
            obstacles: Vec::new(),
            tips: Vec::new(),
            requests: Vec::new(),
            bodies: overlap::Bodies::default(),
            unnamed: Vec::new(),
            holds: Vec::new(),
            extent: None,
            passed: None,
            details: Vec::new(),
            free: frame.panel,
            points: 0,
            painted: 0.0,
            cues: Cues::default(),
        }
    }

    /// What is drawn from here on belongs to a layer of this name; `labels` says whether its labels are
    /// written.
    pub(crate) fn begin_layer(&mut self, name: &str, labels: bool) {
        self.layers.push(Group::new(name));
        self.labels = labels;
        self.cues.rest();
        self.part(name);
    }

    /// What all layers drew and asked for.
    pub(crate) fn finish(self) -> Sketched {
        let Self { frame, mut layers, obstacles, requests, unnamed, holds, extent, .. } = self;
        let Self { passed, details, free, points, painted, .. } = self;
        construction::end_at_lines(&mut layers);
        let cues = self.cues.known;
        Sketched {
            frame,
            layers,
            obstacles,
            requests,
            unnamed,
            holds,
            extent,
            passed,
            details,
            free,
            points,
            painted,
            cues,
        }
    }

    /// Whether more was drawn than a figure may show: it will be refused.
    pub(crate) fn is_full(&self) -> bool {
        self.points > MAX_POINTS
    }

    /// Begins a part of this name, a group in the drawing that tests and pages find: what is drawn from here
    /// on belongs to it, and labels mind it as usual.
    pub(crate) fn part(&mut self, name: impl Into<String>) -> &mut Self {
        self.weight = Weight::Normal;
        self.part += 1;
        if let Some(layer) = self.layers.last_mut() {
            layer.items.push(Item::Group(Group::new(name)));
        }
        self
    }

    /// Sets how much labels mind what is drawn from here to the next part.
    pub(crate) fn weight(&mut self, weight: Weight) -> &mut Self {
        self.weight = weight;
        self
    }

    /// Asks for a label of the current part; without effect where the scene turned this layer's labels off.
    pub(crate) fn label(&mut self, label: Label) -> &mut Self {
        if !self.labels {
            return self.unnamed(label.anchor);
        }
        if self.requests.len() < MAX_POINTS {
            let layer = self.layers.len().saturating_sub(1);
            let (part, shown) = (self.part, self.cues.now);
            self.requests.push(Request { label, part, layer, shown });
        }
        self
    }

    /// Tells of something that has no label of its own: one of its kind that stands nearer to it than to its
    /// own thing would name it.
    pub(crate) fn unnamed(&mut self, anchor: Anchor) -> &mut Self {
        if self.unnamed.len() < MAX_POINTS {
            self.unnamed.push(anchor);
        }
        self
    }

    /// Lets a reader of a live figure take hold of something that is drawn here; once, whoever draws it.
    pub(crate) fn hold(&mut self, hold: Hold) {
        let same = |h: &Hold| (h.body, h.grip, h.vertex) == (hold.body, hold.grip, hold.vertex);
        if self.holds.len() < MAX_POINTS && !self.holds.iter().any(same) {
            self.holds.push(hold);
        }
    }

    /// The smallest and largest coordinates that the panel shows, in its space (a body's own, in its panel).
    #[must_use]
    pub(crate) fn visible(&self) -> (DVec2, DVec2) {
        self.frame.visible()
    }

    /// Page pixels of what is `px` on the usual page; fewer on a small one.
    #[must_use]
    pub(crate) fn fitted(&self, px: f64) -> f64 {
        px * self.unit
    }

    /// The length in the panel's space of `px` pixels of the usual page.
    #[must_use]
    pub(crate) fn px(&self, px: f64) -> f64 {
        self.fitted(px) / self.frame.scale
    }

    /// Lets a view that is fitted be so high at least, page pixels, about the middle of what is seen now.
    pub(crate) fn at_least_high(&mut self, px: f64) {
        let ((lo, hi), half) = (self.visible(), 0.5 * self.px(px));
        let middle = 0.5 * (lo + hi);
        let ends = [middle - DVec2::Y * half, middle + DVec2::Y * half];
        let (from, to) = self.extent.unwrap_or((ends[0], ends[1]));
        self.extent = Some((from.min(ends[0]), to.max(ends[1])));
    }

    /// The length on the page, in pixels, of a length in the panel's space.
    #[must_use]
    pub(crate) fn on_page(&self, length: f64) -> f64 {
        length * self.frame.scale
    }

    /// Whether a mark that is `length` long in the panel's space can be seen, and lets the rest be seen:
    /// [`SEEN`] page pixels at least, and at most [`SHARE`] of the panel's shorter edge.
    #[must_use]
    pub(crate) fn is_legible(&self, length: f64) -> bool {
        let panel = self.frame.panel;
        let most = SHARE * panel.width().min(panel.height());
        (SEEN..=most.max(SEEN)).contains(&self.on_page(length))
    }

    /// Draws an area and its line, each where it is given; `outline` is in the panel's space. What is too
    /// small to have a form is drawn as a marker of the role's shape.
    pub(crate) fn area(&mut self, outline: &Outline, wash: Option<Wash>, pen: Option<Pen>) -> &mut Self {
        if self.is_full() {
            return self; // The figure will be refused.
        }
        let points = outline.sampled();
        if let Some(at) = self.speck(outline, &points) {
            return self.as_point(at, wash, pen);
        }
        let path = Path {
            contour: outline.on_page(&self.frame),
            fill: wash.map(|w| self.wash(w)),
            pattern: wash.and_then(|w| self.pattern(w)),
            stroke: pen.map(|p| self.stroke_of(p)),
            shown: Shown::ALWAYS,
        };
        self.count(&points, wash, pen);
        self.reach(&points);
        if let Some(pen) = pen {
            self.cover(&points, self.width(pen));
        }
        self.push(Item::Path(path))
    }

    /// Counts what an outline costs: points, dashes, the area that is painted.
    fn count(&mut self, points: &[DVec2], wash: Option<Wash>, pen: Option<Pen>) {
        self.spend(points.len());
        let frame = self.frame;
        let page = || points.iter().map(|&p| frame.page(p));
        if pen.is_some_and(|p| p.dash != Dash::Solid) {
            let length: f64 = page().zip(page().skip(1)).map(|(p, q)| (q - p).length()).sum();
            self.spend(whole(length / DASH));
        }
        let Some(wash) = wash else { return };
        let bounds = page().map(|p| Rect::new(p, p)).reduce(Rect::union);
        if let Some(seen) = bounds.and_then(|bounds| bounds.intersection(frame.panel)) {
            let times = if self.pattern(wash).is_some() { PATTERNED } else { 1.0 };
            self.painted += times * seen.width() * seen.height() / 1e6;
        }
    }

    /// Counts points as drawn; there is no end to the dashes of a long line.
    fn spend(&mut self, points: usize) {
        self.points = self.points.saturating_add(points);
    }

    /// Puts something into the current part.
    fn push(&mut self, mut item: Item) -> &mut Self {
        self.cues.stamp(&mut item);
        self.spend(1);
        if self.is_full() {
            return self;
        }
        if let Some(Item::Group(part)) = self.layers.last_mut().and_then(|l| l.items.last_mut()) {
            part.items.push(item);
        }
        self
    }

    /// Counts points on the page for the fit of the view: what lies beside what it measures.
    fn reach_on_page(&mut self, points: &[Point]) {
        if self.weight == Weight::Background {
            return;
        }
        for &p in points {
            let off = p - self.frame.middle;
            let q = self.frame.center + DVec2::new(off.dx, -off.dy) / self.frame.scale;
            let (lo, hi) = self.extent.unwrap_or((q, q));
            self.extent = Some((lo.min(q), hi.max(q)));
        }
    }

    /// Puts an area on the page into the current part.
    fn push_filled(&mut self, contour: Contour, paint: Paint) {
        self.push(Item::Path(Path::filled(contour, paint)));
    }

    /// Puts a line on the page into the current part.
    fn push_stroked(&mut self, contour: Contour, pen: Pen) {
        let stroke = self.stroke_of(pen);
        self.push(Item::Path(Path::stroked(contour, stroke)));
    }

    /// Counts points for the fit of the view.
    pub(crate) fn reach(&mut self, points: &[DVec2]) {
        if self.weight == Weight::Background {
            return;
        }
        for &p in points {
            let q = self.frame.pose.map_or(p, |pose| pose.inverse_point(p));
            let (lo, hi) = self.extent.unwrap_or((q, q));
            self.extent = Some((lo.min(q), hi.max(q)));
        }
    }
}
