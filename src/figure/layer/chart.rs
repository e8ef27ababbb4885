//! A chart over time that fills its panel, with scales of its own: what `graph.rs` and `fastest_approach.rs`
//! stand on.

use crate::drawing::Role;
use crate::figure::context::{Context, whole_turns};
use crate::figure::sketch::{Anchor, Label, Pen, Size, Sketch, Weight};
use crate::geometry::{DVec2, Side, sort_by};

/// Pieces of a curve at least, and for each full turn of its bodies: a chord is then within half a pixel of a
/// curve that bends once over its panel, and a body of eight vertices that turns by another comes nearer and
/// goes away eight times, six pieces each.
const PIECES: u32 = 48;
/// Turns of the bodies whose curve is drawn: more are a blur, and at fewer pieces each another curve.
const MOST_TURNS: u32 = 64;

/// How much longer the axes are than what they measure, in parts of that.
const LONGER: f64 = 0.08;
/// How much longer they are at least, page pixels: a head is seen beside the last marker of a short one.
const NEAREST: f64 = 18.0;
/// How much longer they are at most, page pixels: less than the room to the right of a chart and above it.
const FARTHEST: f64 = 29.5;

/// The height of a chart at least where its view is fitted, page pixels: in that of a flat pair of bodies its
/// lines would run through its words.
const LEAST_HEIGHT: f64 = 130.0;

/// Half the length of a tick on the axis of time, page pixels.
const TICK: f64 = 4.0;

/// A chart's place in its panel and its scales.
pub(super) struct Chart<'c> {
    /// What the panel knows.
    context: &'c Context<'c>,
    /// The lower left and the upper right end of its area, in the panel's space.
    area: [DVec2; 2],
    /// The value at its lower edge.
    least: f64,
    /// The time and the value at its upper right.
    pub(super) most: DVec2,
    /// The value up to which the axis reaches, where it has more room than it needs.
    up_to: Option<f64>,
}

impl<'c> Chart<'c> {
    /// A chart that fills its panel but for some room around it: left, right, below and above, page pixels.
    /// Values run from `least` to that of `most`.
    pub(super) fn new(
        sketch: &mut Sketch,
        context: &'c Context<'c>,
        room: [f64; 4],
        (least, most): (f64, DVec2),
    ) -> Self {
        sketch.at_least_high(LEAST_HEIGHT);
        let (lo, hi) = sketch.visible();
        let [left, right, below, above] = room.map(|px| sketch.px(px));
        let area = [lo + DVec2::new(left, below), hi - DVec2::new(right, above)];
        let height = if most.y > least { most.y } else { least + 1.0 };
        Self { context, area, least, most: DVec2::new(most.x, height), up_to: None }
    }

    /// A chart as wide as its panel but for the room at its left and right, and above its axis of values,
    /// page pixels; with values to the panel's own scale, from 0 at a height of its space: level with what
    /// is there in a panel beside it. Where the first body goes to the right, and its way keeps that room,
    /// each time is where it is then: below what is there in a panel above.
    pub(super) fn level(
        sketch: &Sketch,
        context: &'c Context<'c>,
        [left, right, above]: [f64; 3],
        (height, most): (f64, DVec2),
    ) -> Self {
        let (lo, hi) = sketch.visible();
        let room = [lo.x + sketch.px(left), hi.x - sketch.px(right)];
        let ends = way(context, most.x).filter(|w| room[0] <= w[0] && w[0] < w[1] && w[1] <= room[1]);
        let ends = ends.unwrap_or(room);
        let area = [DVec2::new(ends[0], height), DVec2::new(ends[1], height + most.y)];
        let up_to = Some(hi.y - sketch.px(above) - height).filter(|top| *top > most.y);
        Self { context, area, least: 0.0, most, up_to }
    }

    /// A vector of the page, to the right and up, in the panel's space.
    pub(super) fn vector(&self, v: DVec2) -> DVec2 {
        self.context.frame().map_or(v, |pose| pose.vector(v))
    }

    /// A time and a value in the panel's space.
    pub(super) fn place(&self, time: f64, value: f64) -> DVec2 {
        let [lo, hi] = self.area;
        let share = DVec2::new(time / self.most.x, (value - self.least) / (self.most.y - self.least));
        let p = lo + (hi - lo) * share;
        self.context.frame().map_or(p, |pose| pose.point(p))
    }

    /// How far a time lies along its axis, page pixels.
    pub(super) fn along(&self, sketch: &Sketch, time: f64) -> f64 {
        time / self.most.x * sketch.on_page(self.area[1].x - self.area[0].x)
    }

    /// Draws the axis of time and that of values, each with its key and name.
    pub(super) fn axes(&self, sketch: &mut Sketch, [(time, t), (value, s)]: [(&'static str, &str); 2]) {
        let corner = self.place(0.0, 0.0);
        // Within the room around the chart, where heads and names are seen.
        let longer = |end: DVec2| {
            let past = (LONGER * end.distance(corner)).max(sketch.px(NEAREST)).min(sketch.px(FARTHEST));
            end + (end - corner).normalize_or_zero() * past
        };
        let top = self.up_to.map(|value| self.place(0.0, value));
        let ends = [
            (time, t, longer(self.place(self.most.x, 0.0)), DVec2::NEG_Y),
            (value, s, top.unwrap_or(longer(self.place(0.0, self.most.y))), DVec2::NEG_X),
        ];
        for (key, name, end, toward) in ends {
            sketch.part("axis").weight(Weight::Background).arrow(corner, end, Pen::axis());
            // Words stand inside, where the curve that begins below is far.
            let (size, toward) =
                if name.starts_with('$') { (Size::Point, toward) } else { (Size::Note, DVec2::X) };
            let anchor = Anchor::point_toward(end, self.vector(toward));
            sketch.label(Label::new(key, name, anchor, Role::Muted).size(size));
        }
    }

    /// Draws a tick on the axis of time.
    pub(super) fn tick(&self, sketch: &mut Sketch, time: f64, role: Role) {
        let (at, half) = (self.place(time, 0.0), self.vector(DVec2::Y * sketch.px(TICK)));
        sketch.line(at - half, at + half, Pen::dimension(role));
    }
}

/// How far to the right the first body's origin is at the start and at a time.
fn way(context: &Context, until: f64) -> Option<[f64; 2]> {
    let at = |time| Some(context.pose(Side::A, time)?.position.x);
    Some([at(0.0)?, at(until)?])
}

/// The height of B's closest point at the first step, above which separations can be drawn as they are.
pub(super) fn floor(context: &Context) -> Option<f64> {
    let answer = context.separation_seen(*context.steps().first()?)?;
    Some(answer.points[1].y)
}

/// The separation of the bodies at some times from 0 to `until`, those of `more` among them; none where the
/// bodies turn more often than can be drawn.
pub(super) fn separations(context: &Context, until: f64, more: &[f64]) -> Vec<DVec2> {
    let query = context.scene.query_of_bodies();
    let Some(b) = query.b else { return Vec::new() };
    let turns = until * [query.a, b].map(|body| body.spin.degrees().abs() / 360.0).into_iter().sum::<f64>();
    let Some(whole) = whole_turns(turns, MOST_TURNS) else { return Vec::new() };
    let pieces = PIECES * whole;
    let even = (0..=pieces).map(|i| until * (f64::from(i) / f64::from(pieces)));
    let more = more.iter().copied().filter(|time| (0.0..until).contains(time));
    let mut times: Vec<f64> = even.chain(more).collect();
    sort_by(&mut times, f64::total_cmp);
    times.dedup();
    let at = |time| DVec2::new(time, context.runs.distances.at(query.a, b, time).separation);
    times.into_iter().map(at).collect()
}
