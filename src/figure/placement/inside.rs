//! Places inside an area: its pole of inaccessibility, the point farthest from its boundary, first.
//!
//! The pole is found on a grid that is refined about its best points; after Garcia-Castellanos, Lombardo,
//! "Poles of inaccessibility: A calculation algorithm for the remotest places on earth", Scottish
//! Geographical Journal 123(3), 2007. Other areas that cover part of this one count as boundary, so that the
//! name of A stands in A only.

use crate::drawing::{Offset, Point, Rect};

use super::Candidate;
use super::rect::{DIRECTIONS, about, bounds, length_inside, reach};
use super::things::{Thing, Things};
use super::weights::Places;

/// How much remoter than the line itself, in shares of the pole's distance, a place may count: one on the
/// line costs `off_pole`, one outside of the area at most twice that.
const MOST_OFF_POLE: f64 = 2.0;
/// The search for a pole ends at steps of this, page pixels: what no eye sees.
const FINE: f64 = 0.5;
/// A step towards the pole has to gain this, page pixels, so that rounding never decides between equal
/// places.
const PAYS: f64 = 0.01;
/// The directions about an area from the best, as places in [`DIRECTIONS`]: upper right, up, right, upper
/// left, left, lower right, down, lower left.
const OUTSIDE: [usize; 8] = [1, 2, 0, 3, 4, 7, 6, 5];

/// Places for a name inside its area, best where no other area is, then around it.
pub(super) fn places(things: &Things, size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let Some(area) = things.own.as_ref().map(Thing::points) else { return Vec::new() };
    let Some(bounds) = bounds(area.iter().copied()) else { return Vec::new() };
    let avoid = things.avoid();
    let best = things.remote.first().map_or(1.0, |p| p.1.max(1.0));
    let reach = 0.5 * libm::hypot(bounds.width(), bounds.height()).max(1.0);
    let mut inside: Vec<Candidate> = Vec::new();
    for &(center, room) in &things.remote {
        let rect = about(center, size);
        if fits(&rect, area, w) {
            let off_pole = w.off_pole * (1.0 - room / best).clamp(0.0, MOST_OFF_POLE);
            let off_middle = w.off_middle * (center - bounds.center()).length() / reach;
            let reluctance = off_pole + off_middle + shared(&rect, &avoid, w);
            inside.push(Candidate { rect, reluctance, leader: None });
        }
    }
    inside.sort_by(|a, b| a.reluctance.total_cmp(&b.reluctance));
    let spread = (w.spread * size.0).max(w.least_spread);
    let mut all: Vec<Candidate> = Vec::new();
    for candidate in inside {
        let near = |c: &Candidate| (c.rect.center() - candidate.rect.center()).length() < spread;
        if all.len() < w.inside && !all.iter().any(near) {
            all.push(candidate);
        }
    }
    all.extend(outside(things, &avoid, size, w));
    all
}

/// What it costs to stand on another area.
fn shared(rect: &Rect, avoid: &[&[Point]], w: &Places) -> f64 {
    if avoid.iter().any(|a| meets(rect, a, w)) { w.shared } else { 0.0 }
}

/// The pole of inaccessibility of an area on the page.
pub(super) fn pole(area: &[Point], w: &Places) -> Point {
    let everywhere = Rect { x0: f64::MIN, y0: f64::MIN, x1: f64::MAX, y1: f64::MAX };
    let fallback = area.first().copied().unwrap_or_default();
    grid(area, &[], &everywhere, w).first().map_or(fallback, |&(pole, _)| pole)
}

/// Points inside the area and the panel, the farthest from all boundaries first, the best refined; each with
/// that distance, page pixels.
pub(super) fn grid(area: &[Point], avoid: &[&[Point]], panel: &Rect, w: &Places) -> Vec<(Point, f64)> {
    let Some(all) = bounds(area.iter().copied()) else { return Vec::new() };
    let Some(bounds) = all.intersection(*panel) else { return Vec::new() };
    let count = u32::try_from(w.grid).unwrap_or(1);
    let step = bounds.width().max(bounds.height()) / f64::from(count);
    let room = |p: Point| room_at(p, area, avoid, panel);
    let mut points = Vec::new();
    if step <= 0.0 {
        return points;
    }
    // Odd multiples of half a step about the middle keep the grid symmetric for symmetric shapes.
    let middle = bounds.center();
    for i in 0..count {
        for j in 0..count {
            let at = |k: u32| (f64::from(k) - 0.5 * f64::from(count - 1)) * step;
            let p = middle + Offset::new(at(i), at(j));
            if bounds.contains(p) && contains(area, p) {
                points.push((p, room(p)));
            }
        }
    }
    points.sort_by(|a, b| b.1.total_cmp(&a.1));
    // Where many points are as remote, as along the middle of a box, the one nearest to the area's middle is
    // best.
    let starts =
        points.iter().take(w.refined).map(|&(p, _)| p).chain(contains(area, middle).then_some(middle));
    let mut refined: Vec<(Point, f64)> = starts.map(|p| climb(p, 0.5 * step, &bounds, &room)).collect();
    refined.extend(points);
    refined.sort_by(|a, b| b.1.total_cmp(&a.1));
    refined
}

/// Moves to a better neighbour within `bounds` until the step is too small to be seen. Outside there is no
/// place for a label, however far another area reaches that covers all of this one.
fn climb(start: Point, step: f64, bounds: &Rect, room: &impl Fn(Point) -> f64) -> (Point, f64) {
    let (mut p, mut best, mut step) = (start, room(start), step);
    while step > FINE {
        let mut moved = false;
        for (dx, dy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
            let q = p + Offset::new(dx, dy) * step;
            if !bounds.contains(q) {
                continue;
            }
            let r = room(q);
            if r > best + PAYS {
                (p, best, moved) = (q, r, true);
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
    (p, best)
}

/// Signed distance to the nearest boundary: negative outside the area, or inside one to avoid.
fn room_at(p: Point, area: &[Point], avoid: &[&[Point]], panel: &Rect) -> f64 {
    let own = distance_to_line(area, p);
    let own = if contains(area, p) { own } else { -own };
    let edge = (p.x - panel.x0).min(panel.x1 - p.x).min(p.y - panel.y0).min(panel.y1 - p.y);
    avoid.iter().fold(own.min(edge), |room, other| {
        let d = distance_to_line(other, p);
        room.min(if contains(other, p) { -d } else { d })
    })
}

/// The edges of a closed line through points.
fn edges(line: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    let last = line.last().copied();
    line.windows(2).map(|pair| (pair[0], pair[1])).chain(last.zip(line.first().copied()))
}

/// The distance of a point from a closed line, page pixels.
fn distance_to_line(line: &[Point], p: Point) -> f64 {
    let mut least = f64::INFINITY;
    for (a, b) in edges(line) {
        let (d, e) = (b - a, p - a);
        let square = d.dot(d);
        let t = if square > 0.0 { (e.dot(d) / square).clamp(0.0, 1.0) } else { 0.0 };
        let off = e - d * t;
        least = least.min(off.dot(off));
    }
    libm::sqrt(least)
}

/// Even-odd: whether a ray to the right crosses the line an odd number of times.
pub(super) fn contains(line: &[Point], p: Point) -> bool {
    let mut inside = false;
    for (a, b) in edges(line) {
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) {
            inside = !inside;
        }
    }
    inside
}

/// Whether a label has room inside the area.
fn fits(rect: &Rect, area: &[Point], w: &Places) -> bool {
    contains(area, rect.center()) && !crosses(&rect.grown(w.area_room), area)
}

/// Whether a label touches an area.
fn meets(rect: &Rect, area: &[Point], w: &Places) -> bool {
    contains(area, rect.center()) || crosses(&rect.grown(w.shared_room), area)
}

/// Whether a closed line runs through a rectangle.
fn crosses(rect: &Rect, line: &[Point]) -> bool {
    edges(line).any(|(a, b)| length_inside(a, b, rect).is_some())
}

/// Around the area, touching it from outside: in eight directions from its middle, and square to its line at
/// points along it.
fn outside(things: &Things, avoid: &[&[Point]], size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let Some(own) = &things.own else { return Vec::new() };
    let Some(bounds) = bounds(own.points().iter().copied()) else { return Vec::new() };
    let place = |rect: Rect, rank: f64| {
        let reluctance = w.outside + w.outside_next * rank + shared(&rect, avoid, w);
        Candidate { rect, reluctance, leader: None }
    };
    let mut all = Vec::with_capacity(OUTSIDE.len() + w.beside_area);
    for (rank, direction) in (0_u8..).map(f64::from).zip(OUTSIDE) {
        let (dx, dy) = DIRECTIONS[direction];
        let Some(u) = Offset::new(dx, dy).unit() else { continue };
        let far = own.points().iter().map(|&p| (p - bounds.center()).dot(u)).fold(0.0, f64::max);
        let far = far + w.area_room + reach(u, size);
        all.push(place(touching(own, bounds.center(), u * far, size, w), rank));
    }
    for (p, normal) in along(own.points(), w.beside_area) {
        for n in [normal, -normal] {
            let rect = about(p + n * (w.area_room + reach(n, size)), size);
            if own.distance(&rect) > w.area_room - FINE {
                all.push(place(rect, w.off_eight));
            }
        }
    }
    all
}

/// A box that comes from far off towards the middle of an area, where it first touches: `far` is where it
/// certainly does not.
fn touching(own: &Thing, middle: Point, far: Offset, size: (f64, f64), w: &Places) -> Rect {
    let (mut near, mut off) = (0.0, 1.0);
    while (off - near) * far.length() > FINE {
        let half = 0.5 * (near + off);
        let apart = own.distance(&about(middle + far * half, size)) > w.area_room;
        (near, off) = if apart { (near, half) } else { (half, off) };
    }
    about(middle + far * off, size)
}

/// Points at even distances along a closed line, each with a normal of it.
fn along(line: &[Point], count: usize) -> Vec<(Point, Offset)> {
    let length: f64 = edges(line).map(|(a, b)| (b - a).length()).sum();
    let step = length / f64::from(u32::try_from(count.max(1)).unwrap_or(1));
    let (mut all, mut before, mut next) = (Vec::new(), 0.0, 0.5 * step);
    for (a, b) in edges(line) {
        let d = b - a;
        let Some(u) = d.unit() else { continue };
        while next < before + d.length() && all.len() < count {
            all.push((a + u * (next - before), u.left()));
            next += step;
        }
        before += d.length();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::super::things::Kind;
    use super::*;

    const W: &Places = &Places::TUNED;

    fn square(x0: f64, y0: f64, side: f64) -> Vec<Point> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(x, y)| Point::new(x0 + side * x, y0 + side * y))
            .to_vec()
    }

    #[test]
    fn the_pole_of_a_square_is_its_middle() {
        let area = square(10.0, 20.0, 80.0);
        let pole = pole(&area, W);
        assert!((pole.x - 50.0).abs() < 1.0 && (pole.y - 60.0).abs() < 1.0, "{pole:?}");
        assert!((distance_to_line(&area, pole) - 40.0).abs() < 1.0);
    }

    /// The places of a name of 12 × 12 in one area among others.
    fn offered(area: &[Point], others: &[Vec<Point>]) -> Vec<Candidate> {
        let panel = Rect { x0: 0.0, y0: 0.0, x1: 300.0, y1: 300.0 };
        let thing = |points: &[Point]| Thing::new(Kind::Area, points.to_vec(), 0.0).unwrap();
        let all: Vec<Thing> = others.iter().map(|other| thing(other)).collect();
        places(&Things::among(&all, Some(thing(area)), &panel, W), (12.0, 12.0), W)
    }

    #[test]
    fn a_name_keeps_out_of_the_part_that_another_body_covers() {
        let (a, b) = (square(10.0, 10.0, 100.0), square(60.0, 10.0, 100.0));
        let best = offered(&a, std::slice::from_ref(&b))
            .into_iter()
            .min_by(|p, q| p.reluctance.total_cmp(&q.reluctance))
            .unwrap();
        assert!(best.rect.x1 < 60.0 && best.rect.x0 > 10.0, "{best:?}");
        assert!(fits(&best.rect, &a, W) && !meets(&best.rect, &b, W));
    }

    #[test]
    fn a_name_that_has_no_room_inside_stands_outside_and_beside_it() {
        let tiny = square(100.0, 100.0, 8.0);
        let thing = Thing::new(Kind::Area, tiny.clone(), 0.0).unwrap();
        for place in offered(&tiny, &[]) {
            assert!(!crosses(&place.rect, &tiny));
            assert!(thing.distance(&place.rect) < W.area_room + 2.0 * FINE, "{place:?}");
        }
    }
}
