//! What a place costs, in units of slight preferences.

use crate::drawing::{Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Cover, Obstacle, Weight};

use super::candidates::Candidate;
use super::{Placed, Sought, distance_to, length_inside, nearest_in, segment_distance};

/// Room that labels keep from foreign strokes, page pixels.
const STROKE_ROOM: f64 = 2.0;
/// Room that labels keep from markers and arrowheads, page pixels.
const MARKER_ROOM: f64 = 1.5;
/// Room that labels keep from each other, page pixels.
const LABEL_ROOM: f64 = 3.0;
/// Two labels at this distance are as good as apart, page pixels.
const LABEL_COMFORT: f64 = 18.0;
/// Touching a foreign stroke; a page pixel of it inside the label.
const STROKE: (f64, f64) = (14.0, 0.5);
/// The same for construction lines, ghosts and axes.
const LIGHT_STROKE: (f64, f64) = (11.0, 0.3);
/// Touching a stroke of one's own.
const OWN_STROKE: (f64, f64) = (10.0, 0.4);
/// A foreign stroke within this distance, page pixels, crowds a label, and what that costs at most.
const CROWDED: (f64, f64) = (7.0, 1.2);
/// A line between a label and the point that it names.
const PARTED: f64 = 7.0;
/// Touching a marker or an arrowhead.
const MARKER: f64 = 30.0;
/// Near a marker that belongs to something else, where a reader could take the label for its.
const MISLEADING: f64 = 2.5;
/// Within this distance a marker misleads, page pixels.
const NEAR: f64 = 8.0;
/// Within this distance the name of an area seems to name a marker, page pixels, and what that costs at most.
const NAMING: (f64, f64) = (30.0, 6.0);
/// Reaching farther than [`SPILL`] over the panel's edge; a page pixel of it.
const EDGE: (f64, f64) = (60.0, 2.0);
/// Reaching over the panel's edge, into the gap between panels; a page pixel of it.
const SPILLED: (f64, f64) = (1.5, 0.3);
/// A label may reach so far over the edge of its panel, page pixels: a quarter of the gap.
pub(super) const SPILL: f64 = 6.0;
/// Two labels that overlap; a square page pixel of it.
const OVERLAP: (f64, f64) = (70.0, 0.2);
/// Two labels that nearly touch; less the farther they are.
const CLOSE: f64 = 4.0;
/// A stroke or label under a leader line.
const LEADER: f64 = 8.0;
/// Standing elsewhere than the same label of the same thing in an earlier panel.
const MOVED: f64 = 6.0;
/// Things and labels of two panels are at the same place if they are so near, page pixels.
const SAME: f64 = 1.0;

/// Obstacles that can cost a label something, each with the box outside which it costs nothing.
pub(super) type NearBy<'p> = Vec<(Rect, &'p Obstacle)>;

/// The obstacles that can cost any of a label's places something: of thousands of strokes mostly few.
pub(super) fn near_by<'p>(sought: &Sought, places: &[Candidate], scene: &Surroundings<'p>) -> NearBy<'p> {
    let named = named(sought, scene.frame);
    let Some(reach) = places.iter().map(|c| hull(c, named)).reduce(Rect::union) else { return Vec::new() };
    let bounded = scene.obstacles.iter().map(|obstacle| (influence(obstacle), obstacle));
    bounded.filter(|(bounds, _)| bounds.intersection(reach).is_some()).collect()
}

/// Outside this box an obstacle costs a label nothing. A page pixel is to spare, so that rounding decides nothing.
fn influence(obstacle: &Obstacle) -> Rect {
    match obstacle.cover {
        Cover::Stroke { from, to, .. } => Rect::new(from, to).grown(CROWDED.0 + 1.0),
        Cover::Marker { at, radius } | Cover::Head { at, radius } => {
            Rect::new(at, at).grown(radius + NAMING.0 + 1.0)
        }
    }
}

/// All that is looked at for a place: its box, its leader, the way to the point that it names.
fn hull(candidate: &Candidate, named: Option<Point>) -> Rect {
    let rect = named.map_or(candidate.rect, |p| candidate.rect.union(Rect::new(p, p)));
    candidate.leader.map_or(rect, |(p, q)| rect.union(Rect::new(p, q)))
}

/// The point that a label names.
fn named(sought: &Sought, frame: &Frame) -> Option<Point> {
    match &sought.anchor {
        Anchor::Point { at, .. } => Some(frame.page(*at)),
        _ => None,
    }
}

/// What a place costs whatever the other labels do.
pub(super) fn own_cost(
    sought: &Sought,
    home: Point,
    candidate: &Candidate,
    near_by: &NearBy,
    scene: &Surroundings,
) -> f64 {
    let mut cost = candidate.reluctance + edge(&candidate.rect, &scene.frame.panel);
    let named = named(sought, scene.frame);
    let near = named.map(|p| (p, nearest_in(&candidate.rect, p)));
    let reach = hull(candidate, named);
    for (bounds, obstacle) in near_by {
        if bounds.intersection(reach).is_none() {
            continue;
        }
        if let (Some((p, q)), Cover::Stroke { from, to, .. }) = (near, obstacle.cover)
            && obstacle.weight == Weight::Normal
            && cross(p, q, from, to)
        {
            cost += PARTED;
        }
        cost += obstacle_cost(obstacle, obstacle.part == sought.part, candidate);
        if let (Anchor::Inside { .. }, Cover::Marker { at, radius }) = (&sought.anchor, obstacle.cover) {
            let near = 1.0 - (distance_to(&candidate.rect, at) - radius) / NAMING.0;
            cost += NAMING.1 * near.clamp(0.0, 1.0);
        }
    }
    cost + if moved(sought, home, candidate, scene) { MOVED } else { 0.0 }
}

/// Whether an earlier panel has this label of a thing at the same place, and elsewhere than here.
fn moved(sought: &Sought, home: Point, candidate: &Candidate, scene: &Surroundings) -> bool {
    let corner = |rect: &Rect| Point::new(rect.x0, rect.y0);
    let Some((panel, before)) = scene.earlier.iter().rev().find(|(_, p)| p.key == sought.key) else {
        return false;
    };
    let (now, then) = (corner(&scene.frame.panel), corner(panel));
    let shift = (candidate.rect.center() - now) - (before.bounds.center() - then);
    (home - now - before.home).length() < SAME && shift.length() > SAME
}

/// What a panel offers and what stands already.
pub(super) struct Surroundings<'p> {
    pub(super) frame: &'p Frame,
    pub(super) obstacles: &'p [Obstacle],
    /// Labels of earlier panels of the series, each with its panel.
    pub(super) earlier: &'p [(Rect, Placed)],
}

fn obstacle_cost(obstacle: &Obstacle, own: bool, candidate: &Candidate) -> f64 {
    let rect = &candidate.rect;
    match obstacle.cover {
        Cover::Stroke { from, to, half } => {
            let room = if own { half } else { half + STROKE_ROOM };
            let (touch, pixel) = match (own, obstacle.weight) {
                (true, _) => OWN_STROKE,
                (false, Weight::Normal) => STROKE,
                (false, _) => LIGHT_STROKE,
            };
            // Far strokes are most of them: a test of boxes first.
            let apart = rect.grown(CROWDED.0).intersection(Rect::new(from, to)).is_none();
            let distance = if apart { CROWDED.0 } else { segment_distance(rect, from, to) - half };
            let hidden = if distance + half < room {
                touch + pixel * length_inside(from, to, &rect.grown(room)).unwrap_or(0.0)
            } else if own {
                0.0
            } else {
                CROWDED.1 * (1.0 - distance / CROWDED.0).max(0.0)
            };
            let led = candidate.leader.filter(|_| !own).is_some_and(|(p, q)| cross(p, q, from, to));
            hidden + if led { LEADER } else { 0.0 }
        }
        Cover::Marker { at, radius } | Cover::Head { at, radius } => {
            let distance = distance_to(rect, at) - radius;
            if distance < MARKER_ROOM {
                MARKER
            } else if !own && distance < NEAR && matches!(obstacle.cover, Cover::Marker { .. }) {
                MISLEADING
            } else {
                0.0
            }
        }
    }
}

fn edge(rect: &Rect, panel: &Rect) -> f64 {
    let over = (panel.x0 - rect.x0).max(rect.x1 - panel.x1).max(panel.y0 - rect.y0).max(rect.y1 - panel.y1);
    match over {
        _ if over > SPILL => EDGE.0 + EDGE.1 * over,
        _ if over > 0.0 => SPILLED.0 + SPILLED.1 * over,
        _ => 0.0,
    }
}

/// What two places cost each other.
pub(super) fn pair_cost(a: &Candidate, b: &Candidate) -> f64 {
    // Most pairs are far apart.
    if hull(a, None).grown(LABEL_COMFORT + 1.0).intersection(hull(b, None)).is_none() {
        return 0.0;
    }
    let led =
        |x: &Candidate, y: &Candidate| x.leader.is_some_and(|(p, q)| length_inside(p, q, &y.rect).is_some());
    let mut cost = if led(a, b) || led(b, a) { LEADER } else { 0.0 };
    if let Some(both) = a.rect.grown(LABEL_ROOM).intersection(b.rect) {
        cost += OVERLAP.0 + OVERLAP.1 * both.width() * both.height();
    } else if a.rect.grown(LABEL_COMFORT).intersection(b.rect).is_some() {
        let gap = |lo: f64, hi: f64| (lo - hi).max(0.0);
        let dx = gap(a.rect.x0, b.rect.x1).max(gap(b.rect.x0, a.rect.x1));
        let dy = gap(a.rect.y0, b.rect.y1).max(gap(b.rect.y0, a.rect.y1));
        cost += CLOSE * (1.0 - libm::hypot(dx, dy) / LABEL_COMFORT).max(0.0);
    }
    cost
}

/// Twice the area, in square page pixels, of a triangle whose corners count as on one line: far more than the last bits of an
/// answer make, far less than is seen.
const FLAT: f64 = 1e-6;

/// Whether two segments cross; those that only touch do not.
fn cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    let side = |p: Point, q: Point, r: Point| {
        let area = (q - p).cross(r - p);
        if area.abs() < FLAT { 0.0 } else { area }
    };
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}
