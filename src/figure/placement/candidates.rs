//! The candidate places of a label, by what it belongs to. Their order is fixed: of places that are
//! as good, the first is taken.

use crate::drawing::{Offset, Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Best, Corner, MARKER, on_circle};
use crate::geometry::DVec2;
use crate::scene::LabelPlace;

use super::leader::{LONGEST, is_far, leader, led};
use super::pole::pole;
use super::polyline::Polyline;
use super::rect::{DIRECTIONS, about, bounds, part_inside, reach, way_into};
use super::things::{Thing, Things};
use super::weights::{Places, Weights};
use super::{Candidate, Cut, Fold, Sought, inside};

/// Where a label may stand along a line, as parts of the way from its start: the middle first, then about it.
const ALONG: [f64; 5] = [0.5, 0.35, 0.65, 0.2, 0.8];
/// Where the label of a tip may stand beside its vector, besides right at the head.
const ALONG_VECTOR: [f64; 3] = [0.7, 0.5, 0.35];
/// Where a label may stand along an arc, as parts of its sweep; at 0.2 and 0.8, as on a line, the angular
/// velocity of figure 7 would stand 1.5 px from where it does.
const ALONG_ARC: [f64; 5] = [0.5, 0.35, 0.65, 0.22, 0.78];
/// A normal that rises by less than this, as a unit offset, counts as level: rounding does not choose its
/// side.
const LEVEL: f64 = 1e-9;

/// The candidate places of a label, at least one; of a long name, in each of the ways to break it.
pub(super) fn candidates(sought: &Sought, things: &Things, frame: &Frame, w: &Places) -> Vec<Candidate> {
    let size = sought.size(0);
    if let Some(pin) = sought.pinned() {
        return pinned(pin, &sought.anchor, size, frame, things, w);
    }
    let mut all = Vec::new();
    let in_names = |fold: &Fold| fold.cut == Cut::InNames;
    for folds in 0..=sought.folds.len() {
        let fold = folds.checked_sub(1).and_then(|i| sought.folds.get(i));
        if fold.is_some_and(in_names) {
            continue;
        }
        let more = fold.map_or(0.0, |fold| fold.reluctance(w));
        let found = offered(&sought.anchor, sought.size(folds), things, frame, w);
        let found = found.into_iter().map(|c| Candidate { folds, reluctance: c.reluctance + more, ..c });
        let kept =
            |c: Candidate| [kept_in(&c, &frame.panel, w), nearly_fits(&c, &frame.panel, w).then_some(c)];
        all.extend(led(found.flat_map(kept).flatten(), things, w));
    }
    if all.is_empty() { around(frame.panel.center(), 0.0, None, size, w) } else { all }
}

/// The places for a label of a size, by what it belongs to.
fn offered(anchor: &Anchor, size: (f64, f64), things: &Things, frame: &Frame, w: &Places) -> Vec<Candidate> {
    // The middle of a line that the view cuts off is that of what is seen.
    let seen = |from: &DVec2, to: &DVec2| part_inside(frame.page(*from), frame.page(*to), &frame.panel);
    match anchor {
        Anchor::Point { at, clear, toward } => {
            let toward = (frame.page(*at + *toward) - frame.page(*at)).unit();
            around(frame.page(*at), *clear, toward, size, w)
        }
        Anchor::Tick { at, toward } => {
            let toward = (frame.page(*at + *toward) - frame.page(*at)).unit();
            around(frame.page(*at), MARKER, toward, size, &Places { astray: w.off_tick, ..w.clone() })
        }
        Anchor::Outline { at, toward, .. } => {
            let toward = (frame.page(*at + *toward) - frame.page(*at)).unit();
            around(frame.page(*at), MARKER, toward, size, w)
        }
        Anchor::Along { from, to, best: Best::Tip } => {
            along((frame.page(*from), frame.page(*to)), Best::Tip, size, w)
        }
        Anchor::Along { from, to, best } => along(seen(from, to), *best, size, w),
        Anchor::Beside { from, to, offset } => beside(seen(from, to), *offset, size, w),
        Anchor::Arc { center, radius, start, sweep } => {
            let points = ALONG_ARC.map(|t| {
                let p = frame.page(on_circle(*center, *radius, start + sweep * t));
                (p, (p - frame.page(*center)).unit().unwrap_or_default())
            });
            sides(&points, size, w.other_side, w)
        }
        Anchor::Inside { .. } => match things.own.as_ref().and_then(Thing::speck) {
            // Drawn as a marker.
            Some(at) => around(at, MARKER, None, size, w),
            None => inside::places(things, size, w),
        },
        Anchor::Corner(corner) => corners(*corner, size, &frame.panel, w),
    }
}

/// A place that reaches over the panel's edge, moved to lie within; `None` of another one.
fn kept_in(place: &Candidate, panel: &Rect, w: &Places) -> Option<Candidate> {
    if panel.union(place.rect) == *panel {
        return None;
    }
    // A little farther than just within: what touches the edge looks cut off.
    let by = way_into(&place.rect, &panel.grown(-w.from_edge));
    let Rect { x0, y0, x1, y1 } = place.rect;
    let rect = Rect::new(Point::new(x0, y0) + by, Point::new(x1, y1) + by);
    Some(Candidate { rect, reluctance: place.reluctance + w.kept_in * by.length(), ..*place })
}

/// Whether a place reaches over the panel's edge by no more than a label's room.
fn nearly_fits(place: &Candidate, panel: &Rect, w: &Places) -> bool {
    let wide = panel.grown(w.gap);
    wide.union(place.rect) == wide
}

/// Whether anything of what a label belongs to lies in its panel; what the view cuts off has no label, and
/// neither has what is so far away that it has no place on the page.
pub(super) fn is_in_view(anchor: &Anchor, frame: &Frame, w: &Places) -> bool {
    let page: Vec<Point> = anchor.points().iter().map(|&p| frame.page(p)).collect();
    if page.iter().any(|p| !(p.x.is_finite() && p.y.is_finite())) {
        return false;
    }
    let view = frame.panel.grown(w.gap);
    let near = bounds(page.clone()).is_none_or(|r| r.intersection(view).is_some());
    near && (page.len() < 2 || comes_into(anchor, page, &view))
}

/// Whether a line or an area comes into a view, and not only the box around it.
fn comes_into(anchor: &Anchor, page: Vec<Point>, view: &Rect) -> bool {
    match anchor {
        // The line may be moved aside.
        Anchor::Beside { .. } => true,
        // Nothing that is seen of an outline fills the view.
        Anchor::Inside { .. } => Polyline::closed(page)
            .is_none_or(|line| line.square_from(view, f64::INFINITY) <= 0.0 || line.contains(view.center())),
        _ => Polyline::open(page).is_none_or(|line| line.square_from(view, f64::INFINITY) <= 0.0),
    }
}

/// Where what a label belongs to lies on the page: the same for the same thing in another panel of a series.
pub(super) fn home(anchor: &Anchor, frame: &Frame, w: &Places) -> Point {
    match anchor {
        Anchor::Inside { area, .. } => {
            bounds(area.iter().map(|&p| frame.page(p))).map_or(frame.panel.center(), Rect::center)
        }
        _ => reference(anchor, frame, w).0,
    }
}

/// The point that a pin's direction or offset is taken from, and the radius about it that a marker covers,
/// both page pixels.
fn reference(anchor: &Anchor, frame: &Frame, w: &Places) -> (Point, f64) {
    match anchor {
        Anchor::Point { at, clear, .. } => (frame.page(*at), *clear),
        Anchor::Tick { at, .. } | Anchor::Outline { at, .. } => (frame.page(*at), MARKER),
        Anchor::Along { to, best: Best::Tip, .. } => (frame.page(*to), 0.0),
        Anchor::Along { from, to, .. } => (frame.page(0.5 * (*from + *to)), 0.0),
        Anchor::Beside { from, to, offset } => {
            let (p, q) = (frame.page(*from), frame.page(*to));
            let left = (q - p).unit().unwrap_or_default().left();
            (p + (q - p) * 0.5 + left * *offset, 0.0)
        }
        Anchor::Arc { center, radius, start, sweep } => {
            (frame.page(on_circle(*center, *radius, start + 0.5 * sweep)), 0.0)
        }
        Anchor::Inside { area, .. } => {
            let line = Polyline::closed(area.iter().map(|&p| frame.page(p)).collect());
            (line.map_or(frame.panel.center(), |line| pole(&line, w)), 0.0)
        }
        Anchor::Corner(_) => (frame.panel.center(), 0.0),
    }
}

/// Where the scene pins a label: at an offset, or on the first two rings in a direction.
fn pinned(
    pin: LabelPlace,
    anchor: &Anchor,
    size: (f64, f64),
    frame: &Frame,
    things: &Things,
    w: &Places,
) -> Vec<Candidate> {
    let (at, clear) = reference(anchor, frame, w);
    match pin {
        LabelPlace::Offset(dx, dy) => {
            let rect = about(at + Offset::new(dx, dy), size);
            let place = Candidate::new(rect, 0.0);
            let line = is_far(things, &rect, w) || things.misleads(&place);
            vec![Candidate { leader: if line { leader(things, &rect, w) } else { None }, ..place }]
        }
        LabelPlace::Compass(direction) => {
            let direction = DIRECTIONS[usize::from(direction) % DIRECTIONS.len()];
            near_rings(w)
                .map(|(gap, reluctance)| {
                    let rect = toward(at, clear + gap, direction, size);
                    Candidate::new(rect, reluctance)
                })
                .to_vec()
        }
    }
}

/// Gap and reluctance of the first two rings of places.
fn near_rings(w: &Places) -> [(f64, f64); 2] {
    [(w.gap, 0.0), (w.second_gap, w.second_ring)]
}

/// The rectangle in a direction from a point, `gap` page pixels off: its nearest side or corner is there.
fn toward(at: Point, gap: f64, (dx, dy): (f64, f64), (w, h): (f64, f64)) -> Rect {
    let diagonal = if dx != 0.0 && dy != 0.0 { std::f64::consts::FRAC_1_SQRT_2 } else { 1.0 };
    let near = at + Offset::new(dx, dy) * (gap * diagonal);
    about(near + Offset::new(0.5 * dx * w, 0.5 * dy * h), (w, h))
}

/// On five rings about a point, in eight directions; best on the `preferred` side where there is one.
fn around(at: Point, clear: f64, preferred: Option<Offset>, size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let mut all = Vec::with_capacity(5 * DIRECTIONS.len());
    let [first, second] = near_rings(w);
    let [third, far] = [(w.third_gap, w.third_ring), (w.far_gap, w.far_ring)];
    for (gap, more) in [first, second, third, far, (w.last_gap, w.last_ring)] {
        for (&(dx, dy), &usual) in DIRECTIONS.iter().zip(&w.around) {
            let rect = toward(at, clear + gap, (dx, dy), size);
            let own = preferred.map_or(usual, |u| {
                let d = Offset::new(dx, dy).unit().unwrap_or_default();
                w.astray * (1.0 - u.dot(d)) + w.around_asked * usual
            });
            all.push(Candidate::new(rect, own + more));
        }
    }
    all
}

/// Beside at most five points of a line, from the best, on the side of their normals or (more reluctantly by
/// `other`) on the other one.
fn sides(points: &[(Point, Offset)], size: (f64, f64), other: f64, w: &Places) -> Vec<Candidate> {
    let mut all = Vec::new();
    let off_middle = [0.0, w.off_best, w.off_best, w.off_end, w.off_end];
    let [first, second] = near_rings(w);
    for (gap, more) in [first, second, (w.far_gap, w.far_ring)] {
        for (&(p, n), off_middle) in points.iter().zip(off_middle) {
            for (normal, side) in [(n, 0.0), (-n, other)] {
                let rect = about(p + normal * (gap + reach(normal, size)), size);
                all.push(Candidate::new(rect, off_middle + side + more));
            }
        }
    }
    all
}

/// The normal of a line that points up the page, or to the right for one that is upright.
fn upward(u: Offset) -> Offset {
    let n = u.left();
    if n.dy < -LEVEL || (n.dy.abs() <= LEVEL && n.dx > 0.0) { n } else { -n }
}

/// Beside a vector or line; at a tip beyond it first.
fn along((from, to): (Point, Point), best: Best, size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let Some(u) = (to - from).unit() else { return around(to, 0.0, None, size, w) };
    let n = upward(u);
    let at = |t: f64| from + (to - from) * t;
    if best == Best::Middle {
        let mut all = sides(&ALONG.map(|t| (at(t), n)), size, w.other_side, w);
        all.extend(beyond(from, to, u, size, w));
        all.extend(about_short(from, to, size, w));
        return all;
    }
    let ahead = |(gap, reluctance)| {
        let rect = about(to + u * (gap + reach(u, size)), size);
        Candidate::new(rect, reluctance)
    };
    let mut all = near_rings(w).map(ahead).to_vec();
    let near_tip = to + u * -w.before_tip;
    let [a, b, c] = ALONG_VECTOR.map(|t| (at(t), n));
    let beside = sides(&[(near_tip, n), a, b, c], size, w.other_side, w);
    all.extend(beside.into_iter().map(|c| Candidate { reluctance: c.reluctance + w.beside_tip, ..c }));
    all
}

/// Beside a dimension line: on its far side first, then between it and what it measures, then beyond its
/// ends.
fn beside((from, to): (Point, Point), offset: f64, size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let Some(u) = (to - from).unit() else { return around(from, 0.0, None, size, w) };
    let shift = u.left() * offset;
    let (a, b) = (from + shift, to + shift);
    let n = if offset == 0.0 { upward(u) } else { u.left() * offset.signum() };
    let other = if offset == 0.0 { w.other_side } else { w.inner_side };
    let mut all = sides(&ALONG.map(|t| (a + (b - a) * t, n)), size, other, w);
    all.extend(beyond(a, b, u, size, w));
    all.extend(about_short(a, b, size, w));
    all
}

/// Around a line that is shorter than its label, as around a point: more reluctantly than beside it.
fn about_short(from: Point, to: Point, size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let length = (to - from).length();
    if length > size.0 {
        return Vec::new();
    }
    let about = around(from + (to - from) * 0.5, 0.5 * length, None, size, w);
    about.into_iter().map(|c| Candidate { reluctance: c.reluctance + w.about_short, ..c }).collect()
}

/// Beyond the ends of a line from `a` to `b`, in its direction `u`.
fn beyond(a: Point, b: Point, u: Offset, size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let place = |(end, direction): (Point, Offset)| {
        let rect = about(end + direction * (w.beyond_gaps * w.gap + reach(u, size)), size);
        Candidate::new(rect, w.beyond_end)
    };
    [(b, u), (a, -u)].map(place).to_vec()
}

/// Places about a place, for a label that finds room nowhere else.
pub(super) fn nudged(place: &Candidate, things: &Things, w: &Weights) -> Vec<Candidate> {
    let search = &w.search;
    let mut steps = vec![-search.nudge];
    while let Some(&last) = steps.last().filter(|&&last| last + search.nudge_step <= search.nudge) {
        steps.push(last + search.nudge_step);
    }
    let mut all = Vec::with_capacity(steps.len() * steps.len());
    for &dx in &steps {
        for &dy in &steps {
            let by = Offset::new(dx, dy);
            let rect = about(place.rect.center() + by, (place.rect.width(), place.rect.height()));
            let reluctance = place.reluctance + search.nudged * by.length();
            let far = place.leader.is_some() || is_far(things, &rect, &w.places);
            let line = || leader(things, &rect, &w.places).filter(|line| line.length() <= LONGEST);
            let leader = if far { line() } else { None };
            if leader.is_some() == far {
                all.push(Candidate { rect, reluctance, leader, folds: place.folds });
            }
        }
    }
    all
}

/// At a corner or side of the panel, and moved from there along its edges.
fn corners(corner: Corner, size: (f64, f64), panel: &Rect, w: &Places) -> Vec<Candidate> {
    let (sx, sy) = corner.direction();
    let room = (
        (0.5 * (panel.width() - size.0) - w.inset).max(0.0),
        (0.5 * (panel.height() - size.1) - w.inset).max(0.0),
    );
    let mut all = Vec::new();
    for down in [0.0, 1.0, 2.0, 3.0].map(|k| k * w.note_step) {
        for across in [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0].map(|k| k * w.note_step) {
            if sx != 0.0 && across < 0.0 {
                continue;
            }
            let x = if sx == 0.0 { across } else { sx * (room.0 - across) };
            let center =
                panel.center() + Offset::new(x.clamp(-room.0, room.0), sy * (room.1 - down).max(0.0));
            let reluctance = w.note_moved * (down + f64::abs(across));
            all.push(Candidate::new(about(center, size), reluctance));
        }
    }
    all
}

#[cfg(test)]
mod tests;
