//! Places inside an area: its pole of inaccessibility, the point farthest from its boundary, first.
//!
//! Where other areas cover part of it, or it has no room, the name keeps to the part that is its alone, or
//! stands around the area.

use crate::drawing::{Offset, Point, Rect};
use crate::geometry::sort_by;

use super::Candidate;
use super::pole::FINE;
use super::polyline::Polyline;
use super::rect::{DIRECTIONS, about, reach};
use super::things::{Thing, Things};
use super::weights::Places;

/// How much remoter than the line itself, in shares of the pole's distance, a place may count: one on the
/// line costs `off_pole`, one outside of the area at most twice that.
const MOST_OFF_POLE: f64 = 2.0;
/// The directions about an area from the best, as places in [`DIRECTIONS`]: upper right, up, right, upper
/// left, left, lower right, down, lower left.
const OUTSIDE: [usize; 8] = [1, 2, 0, 3, 4, 7, 6, 5];

/// Places for a name inside its area, best where no other area is, then around it.
pub(super) fn places(things: &Things, size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let Some(area) = things.own.as_ref().map(Thing::line) else { return Vec::new() };
    let bounds = area.bounds();
    let avoid = things.avoid();
    let best = things.remote(w).first().map_or(1.0, |p| p.1.max(1.0));
    let reach = 0.5 * libm::hypot(bounds.width(), bounds.height()).max(1.0);
    let ample = ample(size, w);
    let mut inside: Vec<Candidate> = Vec::new();
    for &(center, room) in things.remote(w) {
        let rect = about(center, size);
        if room > ample || fits(&rect, area, w) {
            let off_pole = w.off_pole * (1.0 - room / best).clamp(0.0, MOST_OFF_POLE);
            let off_middle = w.off_middle * (center - bounds.center()).length() / reach;
            let shared = if room > ample { 0.0 } else { shared(&rect, &avoid, w) };
            inside.push(Candidate::new(rect, off_pole + off_middle + shared));
        }
    }
    sort_by(&mut inside, |a, b| a.reluctance.total_cmp(&b.reluctance));
    let spread = (w.spread * size.0).max(w.least_spread);
    let mut all: Vec<Candidate> = Vec::new();
    for candidate in inside {
        let near = |c: &Candidate| (c.rect.center() - candidate.rect.center()).square() < spread * spread;
        if all.len() < w.inside && !all.iter().any(near) {
            all.push(candidate);
        }
    }
    all.extend(outside(things, &avoid, size, w));
    all
}

/// Room about a point in which a label of a size stands clear of every line, whatever their direction.
fn ample((width, height): (f64, f64), w: &Places) -> f64 {
    0.5 * libm::hypot(width, height) + 1.5 * w.area_room.max(w.shared_room)
}

/// What it costs to stand on another area.
fn shared(rect: &Rect, avoid: &[&Polyline], w: &Places) -> f64 {
    if avoid.iter().any(|a| meets(rect, a, w)) { w.shared } else { 0.0 }
}

/// Whether a label has room inside the area.
fn fits(rect: &Rect, area: &Polyline, w: &Places) -> bool {
    area.contains(rect.center()) && !area.crosses(&rect.grown(w.area_room))
}

/// Whether a label touches an area.
fn meets(rect: &Rect, area: &Polyline, w: &Places) -> bool {
    area.contains(rect.center()) || area.crosses(&rect.grown(w.shared_room))
}

/// Around the area, touching it from outside: in eight directions from its middle, and square to its line at
/// points along it.
fn outside(things: &Things, avoid: &[&Polyline], size: (f64, f64), w: &Places) -> Vec<Candidate> {
    let Some(own) = &things.own else { return Vec::new() };
    let (line, bounds) = (own.line(), own.line().bounds());
    let place = |rect: Rect, rank: f64, off: f64| {
        Candidate::new(rect, w.outside + w.outside_next * rank + off + shared(&rect, avoid, w))
    };
    let [near, far] = w.area_rings;
    let rings = [(w.area_room, 0.0), (near, w.area_ring), (far, 2.0 * w.area_ring)];
    let mut all = Vec::new();
    for (rank, direction) in (0_u8..).map(f64::from).zip(OUTSIDE) {
        let (dx, dy) = DIRECTIONS[direction];
        let Some(u) = Offset::new(dx, dy).unit() else { continue };
        let far = line.points().iter().map(|&p| (p - bounds.center()).dot(u)).fold(0.0, f64::max);
        let far = far + reach(u, size);
        for (room, off) in rings {
            let rect = touching(own, bounds.center(), u * (far + room), size, room);
            all.push(place(rect, rank, off));
        }
    }
    for (p, normal) in along(line, w.beside_area) {
        for n in [normal, -normal] {
            for (room, off) in rings {
                let rect = about(p + n * (room + reach(n, size)), size);
                if own.is_farther(&rect, room - FINE) {
                    all.push(place(rect, w.off_eight, off));
                }
            }
        }
    }
    all
}

/// A box that comes from far off towards the middle of an area, where it is first as near as `room`: `far` is
/// where it certainly is not.
fn touching(own: &Thing, middle: Point, far: Offset, size: (f64, f64), room: f64) -> Rect {
    let (mut near, mut off) = (0.0, 1.0);
    while (off - near) * far.length() > FINE {
        let half = 0.5 * (near + off);
        // Of an area that is 1e17 times the page's size, doubles do not tell the ends of a pixel apart.
        if half <= near || off <= half {
            break;
        }
        let apart = own.is_farther(&about(middle + far * half, size), room);
        (near, off) = if apart { (near, half) } else { (half, off) };
    }
    about(middle + far * off, size)
}

/// Points at even distances along a closed line, each with a normal of it.
fn along(line: &Polyline, count: usize) -> Vec<(Point, Offset)> {
    let length: f64 = line.pieces().map(|(a, b)| (b - a).length()).sum();
    let step = length / f64::from(u32::try_from(count.max(1)).unwrap_or(1));
    let (mut all, mut before, mut next) = (Vec::new(), 0.0, 0.5 * step);
    for (a, b) in line.pieces() {
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
    use super::super::pole::tests::square;
    use super::super::things::Kind;
    use super::*;

    const W: &Places = &Places::TUNED;

    /// The places of a name of 12 × 12 in one area among others.
    fn offered(area: &[Point], others: &[Vec<Point>]) -> Vec<Candidate> {
        let panel = Rect { x0: 0.0, y0: 0.0, x1: 300.0, y1: 300.0 };
        let thing = |points: &[Point]| Thing::new(Kind::Area, points.to_vec(), 0.0).unwrap();
        let all: Vec<Thing> = others.iter().map(|other| thing(other)).collect();
        places(&Things::among(&all, Some(thing(area)), &panel), (12.0, 12.0), W)
    }

    #[test]
    fn a_name_keeps_out_of_the_part_that_another_body_covers() {
        let squares = [square(10.0, 10.0, 100.0), square(60.0, 10.0, 100.0)];
        let best = offered(&squares[0], &squares[1..])
            .into_iter()
            .min_by(|p, q| p.reluctance.total_cmp(&q.reluctance))
            .unwrap();
        assert!(best.rect.x1 < 60.0 && best.rect.x0 > 10.0, "{best:?}");
        let [a, b] = squares.map(|points| Polyline::closed(points).unwrap());
        assert!(fits(&best.rect, &a, W) && !meets(&best.rect, &b, W));
    }

    #[test]
    fn a_name_that_has_no_room_inside_stands_outside_and_beside_it() {
        let tiny = square(100.0, 100.0, 8.0);
        let thing = Thing::new(Kind::Area, tiny.clone(), 0.0).unwrap();
        for place in offered(&tiny, &[]) {
            assert!(!thing.line().crosses(&place.rect));
            assert!(thing.distance(&place.rect) < W.area_rings[1] + 2.0 * FINE, "{place:?}");
        }
    }
}
