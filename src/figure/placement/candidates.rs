//! The candidate places of a label, by what it belongs to. Their order is fixed: the place of the same label in
//! another panel of a series has the same slot.

use crate::drawing::{Offset, Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Best, Corner, on_circle};
use crate::scene::LabelPlace;

use super::{Sought, about, distance_to, inside, nearest_in};

/// A place, and what it costs by itself.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Candidate {
    pub(super) rect: Rect,
    /// How far it is from the best kind of place: 1 is a slight preference, 10 a strong one.
    pub(super) reluctance: f64,
    pub(super) leader: Option<(Point, Point)>,
}

/// Room between a label and what it belongs to, page pixels.
const GAP: f64 = 5.0;
/// The same for the second ring of places.
const SECOND_GAP: f64 = 10.0;
/// The same for the third.
const THIRD_GAP: f64 = 16.0;
/// The last ring, whose places have a leader line.
const FAR_GAP: f64 = 27.0;
/// Reluctance to stand on the second ring.
const SECOND_RING: f64 = 3.0;
/// Reluctance to stand on the third.
const THIRD_RING: f64 = 7.0;
/// Reluctance to stand far off, with a leader.
const FAR_RING: f64 = 16.0;
/// From the panel's corner to a note, page pixels.
const INSET: f64 = 8.0;

/// Where a label may stand about a point, from the east counter-clockwise, with how little it is wanted there. Mapmakers
/// put names right above their place if they can.
const AROUND: [(f64, f64, f64); 8] = [
    (1.0, 0.0, 0.6),
    (1.0, -1.0, 0.0),
    (0.0, -1.0, 1.2),
    (-1.0, -1.0, 1.4),
    (-1.0, 0.0, 1.8),
    (-1.0, 1.0, 2.4),
    (0.0, 1.0, 2.0),
    (1.0, 1.0, 1.6),
];

/// The candidate places of a label, at least one.
pub(super) fn candidates(sought: &Sought, frame: &Frame) -> Vec<Candidate> {
    let size = sought.size();
    if let Some(pin) = sought.pin {
        return pinned(pin, &sought.anchor, size, frame);
    }
    let found = match &sought.anchor {
        Anchor::Point { at, clear, toward } => {
            let toward = (frame.page(*at + *toward) - frame.page(*at)).unit();
            around(frame.page(*at), *clear, toward, size)
        }
        Anchor::Along { from, to, best } => along(frame.page(*from), frame.page(*to), *best, size),
        Anchor::Beside { from, to, offset } => beside(frame.page(*from), frame.page(*to), *offset, size),
        Anchor::Arc { center, radius, start, sweep } => {
            let points: Vec<(Point, Offset)> = [0.5, 0.35, 0.65, 0.22, 0.78]
                .iter()
                .map(|t| {
                    let p = frame.page(on_circle(*center, *radius, start + sweep * t));
                    (p, (p - frame.page(*center)).unit().unwrap_or_default())
                })
                .collect();
            sides(&points, size, 0.8)
        }
        Anchor::Inside { area, avoid } => {
            let page = |points: &Vec<_>| points.iter().map(|&p| frame.page(p)).collect::<Vec<Point>>();
            inside::places(&page(area), &avoid.iter().map(page).collect::<Vec<_>>(), size, &frame.panel)
        }
        Anchor::Corner(corner) => corners(*corner, size, &frame.panel),
    };
    if found.is_empty() { around(frame.panel.center(), 0.0, None, size) } else { found }
}

/// Whether anything of what a label belongs to lies in its panel; what the view cuts off has no label.
pub(super) fn is_in_view(anchor: &Anchor, frame: &Frame) -> bool {
    let points: Vec<Point> = anchor.points().iter().map(|&p| frame.page(p)).collect();
    let covered = points.iter().map(|&p| Rect::new(p, p)).reduce(Rect::union);
    covered.is_none_or(|r| r.intersection(frame.panel.grown(GAP)).is_some())
}

/// Where what a label belongs to lies on the page: the same for the same thing in another panel of a series.
pub(super) fn home(anchor: &Anchor, frame: &Frame) -> Point {
    match anchor {
        Anchor::Inside { area, .. } => {
            let bounds = area.iter().map(|&p| frame.page(p)).map(|p| Rect::new(p, p)).reduce(Rect::union);
            bounds.map_or(frame.panel.center(), Rect::center)
        }
        _ => reference(anchor, frame).0,
    }
}

/// The point that a pin's direction or offset is taken from.
fn reference(anchor: &Anchor, frame: &Frame) -> (Point, f64) {
    match anchor {
        Anchor::Point { at, clear, .. } => (frame.page(*at), *clear),
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
            let page: Vec<Point> = area.iter().map(|&p| frame.page(p)).collect();
            (inside::pole(&page, &[]).0, 0.0)
        }
        Anchor::Corner(_) => (frame.panel.center(), 0.0),
    }
}

fn pinned(pin: LabelPlace, anchor: &Anchor, size: (f64, f64), frame: &Frame) -> Vec<Candidate> {
    let (at, clear) = reference(anchor, frame);
    match pin {
        LabelPlace::Offset(dx, dy) => {
            let rect = about(at + Offset::new(dx, dy), size);
            vec![Candidate { rect, reluctance: 0.0, leader: leader(at, clear, &rect) }]
        }
        LabelPlace::Compass(direction) => {
            let (dx, dy, _) = AROUND[usize::from(direction) % AROUND.len()];
            [(GAP, 0.0), (SECOND_GAP, SECOND_RING)]
                .iter()
                .map(|&(gap, reluctance)| Candidate {
                    rect: toward(at, clear + gap, (dx, dy), size),
                    reluctance,
                    leader: None,
                })
                .collect()
        }
    }
}

/// The rectangle in a direction from a point, `gap` page pixels off: its nearest side or corner is there.
fn toward(at: Point, gap: f64, (dx, dy): (f64, f64), (w, h): (f64, f64)) -> Rect {
    let diagonal = if dx != 0.0 && dy != 0.0 { std::f64::consts::FRAC_1_SQRT_2 } else { 1.0 };
    let near = at + Offset::new(dx, dy) * (gap * diagonal);
    about(near + Offset::new(0.5 * dx * w, 0.5 * dy * h), (w, h))
}

fn around(at: Point, clear: f64, preferred: Option<Offset>, size: (f64, f64)) -> Vec<Candidate> {
    let mut all = Vec::with_capacity(4 * AROUND.len());
    let rings = [(GAP, 0.0), (SECOND_GAP, SECOND_RING), (THIRD_GAP, THIRD_RING), (FAR_GAP, FAR_RING)];
    for (gap, more) in rings {
        for &(dx, dy, usual) in &AROUND {
            let rect = toward(at, clear + gap, (dx, dy), size);
            let own = preferred.map_or(usual, |u| {
                let d = Offset::new(dx, dy).unit().unwrap_or_default();
                3.0 * (1.0 - u.dot(d)) + 0.05 * usual
            });
            all.push(Candidate { rect, reluctance: own + more, leader: leader(at, clear, &rect) });
        }
    }
    all
}

/// A line from what a label belongs to, where it stands so far off that a reader has to be led.
fn leader(at: Point, clear: f64, rect: &Rect) -> Option<(Point, Point)> {
    let near = nearest_in(rect, at);
    let u = (near - at).unit()?;
    (distance_to(rect, at) - clear > 0.7 * FAR_GAP).then(|| (at + u * (clear + 2.0), near + u * -2.0))
}

/// Beside points of a line, on the side of their normals or (more reluctantly by `other`) on the other one.
fn sides(points: &[(Point, Offset)], size: (f64, f64), other: f64) -> Vec<Candidate> {
    let mut all = Vec::new();
    for (gap, more) in [(GAP, 0.0), (SECOND_GAP, SECOND_RING)] {
        for (i, &(p, n)) in points.iter().enumerate() {
            let off_middle = [0.0, 1.0, 1.0, 2.2, 2.2].get(i).copied().unwrap_or(3.0);
            for (normal, side) in [(n, 0.0), (-n, other)] {
                let reach = 0.5 * (normal.dx.abs() * size.0 + normal.dy.abs() * size.1);
                let rect = about(p + normal * (gap + reach), size);
                all.push(Candidate { rect, reluctance: off_middle + side + more, leader: None });
            }
        }
    }
    all
}

/// The normal of a line that points up the page, or to the right for one that is upright.
fn upward(u: Offset) -> Offset {
    let n = u.left();
    if n.dy < -1e-9 || (n.dy.abs() <= 1e-9 && n.dx > 0.0) { n } else { -n }
}

fn along(from: Point, to: Point, best: Best, size: (f64, f64)) -> Vec<Candidate> {
    let Some(u) = (to - from).unit() else { return around(to, 0.0, None, size) };
    let n = upward(u);
    let at = |t: f64| from + (to - from) * t;
    if best == Best::Middle {
        let points: Vec<_> = [0.5, 0.35, 0.65, 0.2, 0.8].iter().map(|&t| (at(t), n)).collect();
        let mut all = sides(&points, size, 0.6);
        all.extend(beyond(from, to, u, size));
        return all;
    }
    let reach = 0.5 * (u.dx.abs() * size.0 + u.dy.abs() * size.1);
    let mut all = Vec::new();
    for (gap, more) in [(GAP, 0.0), (SECOND_GAP, SECOND_RING)] {
        all.push(Candidate { rect: about(to + u * (gap + reach), size), reluctance: more, leader: None });
    }
    let near_tip = to + u * -6.0;
    let beside = sides(&[(near_tip, n), (at(0.7), n), (at(0.5), n), (at(0.35), n)], size, 0.4);
    all.extend(beside.into_iter().map(|c| Candidate { reluctance: c.reluctance + 0.5, ..c }));
    all
}

/// Beside a dimension line: on its far side first, then between it and what it measures, then beyond its ends.
fn beside(from: Point, to: Point, offset: f64, size: (f64, f64)) -> Vec<Candidate> {
    let Some(u) = (to - from).unit() else { return around(from, 0.0, None, size) };
    let shift = u.left() * offset;
    let (a, b) = (from + shift, to + shift);
    let n = if offset == 0.0 { upward(u) } else { u.left() * offset.signum() };
    let points: Vec<_> = [0.5, 0.35, 0.65, 0.2, 0.8].iter().map(|&t| (a + (b - a) * t, n)).collect();
    let mut all = sides(&points, size, if offset == 0.0 { 0.6 } else { 2.0 });
    all.extend(beyond(a, b, u, size));
    all
}

/// Beyond the ends of a line, in its direction.
fn beyond(a: Point, b: Point, u: Offset, size: (f64, f64)) -> Vec<Candidate> {
    let reach = 0.5 * (u.dx.abs() * size.0 + u.dy.abs() * size.1);
    let place = |(end, direction): (Point, Offset)| {
        let rect = about(end + direction * (2.0 * GAP + reach), size);
        Candidate { rect, reluctance: 3.0, leader: None }
    };
    [(b, u), (a, -u)].map(place).to_vec()
}

/// A label is moved at most this far from one of its places, page pixels.
const NUDGE: i32 = 24;
/// By steps of so many page pixels.
const NUDGE_STEP: usize = 4;
/// Reluctance for each page pixel.
const NUDGED: f64 = 0.16;

/// Places about a place, for a label that finds room nowhere else.
pub(super) fn nudged(place: &Candidate) -> Vec<Candidate> {
    let steps = || (-NUDGE..=NUDGE).step_by(NUDGE_STEP).map(f64::from);
    let mut all = Vec::new();
    for dx in steps() {
        for dy in steps() {
            let by = Offset::new(dx, dy);
            let rect = about(place.rect.center() + by, (place.rect.width(), place.rect.height()));
            let reluctance = place.reluctance + NUDGED * by.length();
            all.push(Candidate { rect, reluctance, leader: place.leader.map(|(p, q)| (p, q + by)) });
        }
    }
    all
}

fn corners(corner: Corner, size: (f64, f64), panel: &Rect) -> Vec<Candidate> {
    let (sx, sy) = match corner {
        Corner::TopLeft => (-1.0, -1.0),
        Corner::Top => (0.0, -1.0),
        Corner::TopRight => (1.0, -1.0),
        Corner::BottomLeft => (-1.0, 1.0),
        Corner::Bottom => (0.0, 1.0),
        Corner::BottomRight => (1.0, 1.0),
    };
    let room = (
        (0.5 * (panel.width() - size.0) - INSET).max(0.0),
        (0.5 * (panel.height() - size.1) - INSET).max(0.0),
    );
    let mut all = Vec::new();
    for down in [0.0, 24.0, 48.0, 72.0] {
        for across in [0.0, 32.0, -32.0, 64.0, -64.0, 96.0, -96.0] {
            if sx != 0.0 && across < 0.0 {
                continue;
            }
            let x = if sx == 0.0 { across } else { sx * (room.0 - across) };
            let center =
                panel.center() + Offset::new(x.clamp(-room.0, room.0), sy * (room.1 - down).max(0.0));
            let reluctance = 0.03 * (down + f64::abs(across));
            all.push(Candidate { rect: about(center, size), reluctance, leader: None });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_about_a_point_keep_clear_of_its_marker() {
        let at = Point::new(100.0, 100.0);
        for candidate in around(at, 5.0, None, (30.0, 12.0)) {
            assert!(distance_to(&candidate.rect, at) >= 5.0, "{candidate:?}");
        }
    }

    #[test]
    fn a_far_place_has_a_leader_of_at_most_forty_pixels() {
        let at = Point::new(0.0, 0.0);
        let far: Vec<_> = around(at, 4.5, None, (30.0, 12.0)).into_iter().filter_map(|c| c.leader).collect();
        assert!(!far.is_empty());
        assert!(far.iter().all(|(p, q)| (*q - *p).length() <= 40.0));
    }

    #[test]
    fn what_the_view_cuts_off_is_not_in_view() {
        use crate::geometry::DVec2;
        let panel = Rect { x0: 0.0, y0: 0.0, x1: 100.0, y1: 100.0 };
        let frame = Frame::fit(None, DVec2::ZERO, DVec2::new(10.0, 10.0), panel);
        assert!(is_in_view(&Anchor::point(DVec2::new(9.0, 1.0)), &frame));
        assert!(!is_in_view(&Anchor::point(DVec2::new(12.0, 1.0)), &frame));
        assert!(is_in_view(&Anchor::tip(DVec2::ONE, DVec2::new(30.0, 1.0)), &frame), "its tail is");
        assert!(is_in_view(&Anchor::Corner(Corner::Top), &frame));
    }

    #[test]
    fn a_dimension_has_its_label_on_the_far_side() {
        let best = beside(Point::new(0.0, 0.0), Point::new(100.0, 0.0), -20.0, (30.0, 12.0))
            .into_iter()
            .min_by(|p, q| p.reluctance.total_cmp(&q.reluctance))
            .unwrap();
        assert!(best.rect.y0 > 20.0, "to the right of east is down: {best:?}");
    }
}
