//! What a place costs, in units of slight preferences.

use crate::drawing::{Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Cover, Obstacle, Weight};

use super::rect::{cross, distance_to, length_inside, nearest_in, rect_distance, segment_distance};
use super::things::{ALIKE, Thing, Things};
use super::weights::Costs;
use super::{Candidate, Placed, Sought};

/// The cosine of an angle between lines that are one: less than that of a right angle's square or of an
/// arrow's head.
const ALONG: f64 = 0.99;

/// Obstacles that can cost a label something, each with the box outside which it costs nothing.
pub(super) type NearBy<'p> = Vec<(Rect, &'p Obstacle)>;

/// The obstacles that can cost any of a label's places something: of thousands of strokes mostly few.
pub(super) fn near_by<'p>(sought: &Sought, places: &[Candidate], scene: &Surroundings<'p>) -> NearBy<'p> {
    let named = named(sought, scene.frame);
    let Some(reach) = places.iter().map(|c| hull(c, named)).reduce(Rect::union) else { return Vec::new() };
    let bounded = scene.obstacles.iter().map(|obstacle| (influence(obstacle, scene.costs), obstacle));
    bounded.filter(|(bounds, _)| bounds.intersection(reach).is_some()).collect()
}

/// Outside this box an obstacle costs a label nothing. A page pixel is to spare, so that rounding decides
/// nothing.
fn influence(obstacle: &Obstacle, w: &Costs) -> Rect {
    match obstacle.cover {
        Cover::Stroke { from, to, .. } => Rect::new(from, to).grown(w.crowd_reach + 1.0),
        Cover::Marker { at, radius } | Cover::Head { at, radius } => {
            Rect::new(at, at).grown(radius + w.naming_reach + 1.0)
        }
    }
}

/// All that is looked at for a place: its box, its leader, the way to the point that it names.
fn hull(candidate: &Candidate, named: Option<Point>) -> Rect {
    let rect = named.map_or(candidate.rect, |p| candidate.rect.union(Rect::new(p, p)));
    candidate.leader.map_or(rect, |line| rect.union(Rect::new(line.from, line.to)))
}

/// The point that a label names.
fn named(sought: &Sought, frame: &Frame) -> Option<Point> {
    match &sought.anchor {
        Anchor::Point { at, .. } | Anchor::Tick { at, .. } | Anchor::Outline { at, .. } => {
            Some(frame.page(*at))
        }
        _ => None,
    }
}

/// What a place costs whatever the other labels do; infinite where that is more than `most`.
pub(super) fn own_cost(
    (sought, things): (&Sought, &Things),
    home: Point,
    (candidate, most): (&Candidate, f64),
    near_by: &NearBy,
    scene: &Surroundings,
) -> f64 {
    let w = scene.costs;
    let mut cost = candidate.reluctance + edge(&candidate.rect, &scene.frame.panel, w);
    let named = named(sought, scene.frame);
    let near = named.map(|p| (p, nearest_in(&candidate.rect, p)));
    let reach = hull(candidate, named);
    for (bounds, obstacle) in near_by {
        // Nothing of a cost is negative.
        if cost > most {
            return f64::INFINITY;
        }
        if bounds.intersection(reach).is_none() {
            continue;
        }
        if let (Some((p, q)), Cover::Stroke { from, to, .. }) = (near, obstacle.cover)
            && obstacle.weight == Weight::Normal
            && cross(p, q, from, to)
        {
            cost += w.parted;
        }
        cost += obstacle_cost(obstacle, obstacle.part == sought.part, candidate, scene);
        if let (Some(line), Cover::Marker { at, radius }) = (candidate.leader, obstacle.cover)
            && things.own.as_ref().is_some_and(Thing::has_ends)
            && (line.from - at).length() < radius + w.marker_room
        {
            // It leads to the marker that ends the line.
            cost += w.nearer;
        }
        if let (Anchor::Inside { .. }, Cover::Marker { at, radius }) = (&sought.anchor, obstacle.cover) {
            let near = 1.0 - (distance_to(&candidate.rect, at) - radius) / w.naming_reach;
            cost += w.naming * near.clamp(0.0, 1.0);
        }
    }
    if candidate.leader.is_none() {
        cost += doubt(things.margin(&candidate.rect, w.doubt_reach), w);
    }
    cost += w.astray * things.astray(&candidate.rect);
    cost += if moved(sought, home, candidate, scene) { w.moved } else { 0.0 };
    if cost > most { f64::INFINITY } else { cost }
}

/// What standing nearer to another thing costs, or not much nearer to its own, by a margin in page pixels.
fn doubt(margin: f64, w: &Costs) -> f64 {
    if margin <= ALIKE { w.nearer } else { w.doubt * (1.0 - margin / w.doubt_reach).max(0.0) }
}

/// Whether an earlier panel has this label of a thing at the same place, and elsewhere than here.
fn moved(sought: &Sought, home: Point, candidate: &Candidate, scene: &Surroundings) -> bool {
    let shift = |(rect, _): (Rect, _)| candidate.rect.center() - rect.center();
    in_series(sought, home, scene).is_some_and(|before| shift(before).length() > scene.costs.same_place)
}

/// The label as the last earlier panel has it in which its thing lies at the same place, and where it would
/// stand so in this one.
pub(super) fn in_series<'p>(
    sought: &Sought,
    home: Point,
    scene: &Surroundings<'p>,
) -> Option<(Rect, &'p Placed)> {
    let corner = |rect: &Rect| Point::new(rect.x0, rect.y0);
    let now = corner(&scene.frame.panel);
    let is_same = |p: &Placed| p.key == sought.key && (home - now - p.home).length() < scene.costs.same_place;
    let (panel, before) = scene.earlier.iter().rev().find(|(_, p)| is_same(p))?;
    let (by, Rect { x0, y0, x1, y1 }) = (now - corner(panel), before.bounds);
    Some((Rect::new(Point::new(x0, y0) + by, Point::new(x1, y1) + by), before))
}

/// What a panel offers and what stands already.
pub(super) struct Surroundings<'p> {
    /// The panel and its map.
    pub(super) frame: &'p Frame,
    /// What labels keep off.
    pub(super) obstacles: &'p [Obstacle],
    /// Labels of earlier panels of the series, each with its panel.
    pub(super) earlier: &'p [(Rect, Placed)],
    /// What each fault of a place costs.
    pub(super) costs: &'p Costs,
    /// What hiding something else costs besides.
    pub(super) hiding: f64,
}

/// What an obstacle costs at a place; `own` where it is of the thing that the label belongs to.
fn obstacle_cost(obstacle: &Obstacle, own: bool, candidate: &Candidate, scene: &Surroundings) -> f64 {
    let (rect, w) = (&candidate.rect, scene.costs);
    match obstacle.cover {
        Cover::Stroke { from, to, half } => {
            let room = if own { half } else { half + w.stroke_room };
            let is_light = own || obstacle.weight != Weight::Normal;
            let (touch, pixel) = if is_light { (w.light, w.light_px) } else { (w.stroke, w.stroke_px) };
            // Far strokes are most of them: a test of boxes first.
            let apart = rect.grown(w.crowd_reach).intersection(Rect::new(from, to)).is_none();
            let distance = if apart { w.crowd_reach } else { segment_distance(rect, from, to) - half };
            let hidden = if distance + half < room {
                let hiding = if own { 0.0 } else { scene.hiding };
                hiding + touch + pixel * length_inside(from, to, &rect.grown(room)).unwrap_or(0.0)
            } else if own {
                0.0
            } else {
                w.crowd * (1.0 - distance / w.crowd_reach).max(0.0)
            };
            let led =
                candidate.leader.filter(|_| !own).is_some_and(|line| cross(line.border, line.to, from, to));
            hidden + if led { w.leader } else { 0.0 }
        }
        Cover::Marker { at, radius } | Cover::Head { at, radius } => {
            let distance = distance_to(rect, at) - radius;
            if distance < w.marker_room {
                w.marker + scene.hiding
            } else if !own && distance < w.mislead_reach && matches!(obstacle.cover, Cover::Marker { .. }) {
                w.mislead
            } else {
                0.0
            }
        }
    }
}

/// How far what a label belongs to reaches beyond its point or line, page pixels: half of the width of that
/// line, or what a marker larger than usual has beyond that. The room beside it begins there.
pub(super) fn own_reach(sought: &Sought, scene: &Surroundings) -> f64 {
    let page = |p| scene.frame.page(p);
    let reach = |obstacle: &Obstacle| match (&sought.anchor, obstacle.cover) {
        (
            Anchor::Along { from, to, .. } | Anchor::Beside { from, to, .. },
            Cover::Stroke { from: p, to: q, half },
        ) if obstacle.part == sought.part => {
            let (u, v) = ((page(*to) - page(*from)).unit()?, (q - p).unit()?);
            (u.dot(v).abs() > ALONG).then_some(half)
        }
        (Anchor::Point { at, clear, .. }, Cover::Marker { at: p, radius }) => {
            ((page(*at) - p).length() < scene.costs.same_place).then_some(radius - clear)
        }
        _ => None,
    };
    scene.obstacles.iter().filter_map(reach).fold(0.0, f64::max)
}

/// What standing near the panel's edge costs, and reaching over it.
fn edge(rect: &Rect, panel: &Rect, w: &Costs) -> f64 {
    let over = (panel.x0 - rect.x0).max(rect.x1 - panel.x1).max(panel.y0 - rect.y0).max(rect.y1 - panel.y1);
    match over {
        _ if over > w.spill => w.edge + w.edge_px * over,
        _ if over > 0.0 => w.rim + w.spilled_px * over,
        _ => w.rim * (1.0 + over / w.rim_reach).max(0.0),
    }
}

/// What two places cost each other.
pub(super) fn pair_cost(a: &Candidate, b: &Candidate, w: &Costs) -> f64 {
    // Most pairs are far apart.
    if hull(a, None).grown(w.label_comfort + 1.0).intersection(hull(b, None)).is_none() {
        return 0.0;
    }
    let mut cost = 0.0;
    for (line, other) in [(a.leader, b), (b.leader, a)] {
        if line.is_some_and(|line| length_inside(line.from, line.to, &other.rect).is_some()) {
            cost += w.under;
        }
    }
    if let (Some(p), Some(q)) = (a.leader, b.leader)
        && cross(p.from, p.to, q.from, q.to)
    {
        cost += w.under;
    }
    if a.rect.grown(w.label_room).intersection(b.rect).is_some() {
        cost += w.overlap;
    } else if a.rect.grown(w.label_comfort).intersection(b.rect).is_some() {
        let apart = rect_distance(&a.rect, &b.rect);
        cost += w.close * (1.0 - apart / w.label_comfort).max(0.0);
        cost += w.as_one * (1.0 - apart / w.word).max(0.0);
    }
    cost
}
