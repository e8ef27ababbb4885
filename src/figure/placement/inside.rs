//! Places inside an area: its pole of inaccessibility, the point farthest from its boundary, first.
//!
//! The pole is found on a grid that is refined about its best points; after Garcia-Castellanos, Lombardo, "Poles of
//! inaccessibility: A calculation algorithm for the remotest places on earth", Scottish Geographical Journal 123(3),
//! 2007. Other areas that cover part of this one count as boundary, so that the name of A stands in A only.

use crate::drawing::{Offset, Point, Rect};

use super::about;
use super::candidates::Candidate;

/// Points of the grid along the longer side of an area.
const GRID: u32 = 22;
/// Places inside that a label is offered.
const INSIDE: usize = 20;
/// Reluctance to stand as far from the area's middle as its line is: among equally remote places the middle one.
const OFF_MIDDLE: f64 = 0.8;
/// Room between a name and the area's line, page pixels.
const ROOM: f64 = 5.0;
/// Reluctance to stand in a part that another area covers.
const SHARED: f64 = 9.0;
/// Reluctance to stand outside of the area.
const OUTSIDE: f64 = 7.0;

/// Inside first, then around.
pub(super) fn places(area: &[Point], avoid: &[Vec<Point>], size: (f64, f64), panel: &Rect) -> Vec<Candidate> {
    let points = grid(area, avoid, panel);
    let best = points.first().map_or(1.0, |p| p.1.max(1.0));
    let Some(bounds) = area.iter().map(|&p| Rect::new(p, p)).reduce(Rect::union) else { return Vec::new() };
    let reach = 0.5 * libm::hypot(bounds.width(), bounds.height()).max(1.0);
    let mut inside: Vec<Candidate> = Vec::new();
    for (center, room) in points {
        let rect = about(center, size);
        if fits(&rect, area) {
            let off_pole = 5.0 * (1.0 - room / best).clamp(0.0, 2.0);
            let off_middle = OFF_MIDDLE * (center - bounds.center()).length() / reach;
            let reluctance = off_pole + off_middle + shared(&rect, avoid);
            inside.push(Candidate { rect, reluctance, leader: None });
        }
    }
    inside.sort_by(|a, b| a.reluctance.total_cmp(&b.reluctance));
    let spread = (0.25 * size.0).max(10.0);
    let mut all: Vec<Candidate> = Vec::new();
    for candidate in inside {
        let near = |c: &Candidate| (c.rect.center() - candidate.rect.center()).length() < spread;
        if all.len() < INSIDE && !all.iter().any(near) {
            all.push(candidate);
        }
    }
    all.extend(outside(area, avoid, size));
    all
}

/// What it costs to stand on another area.
fn shared(rect: &Rect, avoid: &[Vec<Point>]) -> f64 {
    if avoid.iter().any(|a| meets(rect, a)) { SHARED } else { 0.0 }
}

/// The pole of inaccessibility of an area without others, and its distance from the boundary.
pub(super) fn pole(area: &[Point], avoid: &[Vec<Point>]) -> (Point, f64) {
    let everywhere = Rect { x0: f64::MIN, y0: f64::MIN, x1: f64::MAX, y1: f64::MAX };
    let fallback = area.first().copied().unwrap_or_default();
    grid(area, avoid, &everywhere).first().copied().unwrap_or((fallback, 0.0))
}

/// Points inside the area and the panel, the farthest from all boundaries first, the best refined.
fn grid(area: &[Point], avoid: &[Vec<Point>], panel: &Rect) -> Vec<(Point, f64)> {
    let Some(all) = area.iter().map(|&p| Rect::new(p, p)).reduce(Rect::union) else { return Vec::new() };
    let Some(bounds) = all.intersection(*panel) else { return Vec::new() };
    let step = bounds.width().max(bounds.height()) / f64::from(GRID);
    let room = |p: Point| room_at(p, area, avoid, panel);
    let mut points = Vec::new();
    if step <= 0.0 {
        return points;
    }
    // Odd multiples of half a step about the middle keep the grid symmetric for symmetric shapes.
    let middle = bounds.center();
    for i in 0..GRID {
        for j in 0..GRID {
            let at = |k: u32| (f64::from(k) - 0.5 * f64::from(GRID - 1)) * step;
            let p = middle + Offset::new(at(i), at(j));
            if bounds.contains(p) && contains(area, p) {
                points.push((p, room(p)));
            }
        }
    }
    points.sort_by(|a, b| b.1.total_cmp(&a.1));
    // Where many points are as remote, as along the middle of a box, the one nearest to the area's middle is best.
    let starts = points.iter().take(4).map(|&(p, _)| p).chain(contains(area, middle).then_some(middle));
    let mut refined: Vec<(Point, f64)> = starts.map(|p| climb(p, 0.5 * step, &room)).collect();
    refined.extend(points);
    refined.sort_by(|a, b| b.1.total_cmp(&a.1));
    refined
}

/// Moves to a better neighbour until the step is under half a pixel.
fn climb(start: Point, step: f64, room: &impl Fn(Point) -> f64) -> (Point, f64) {
    let (mut p, mut best, mut step) = (start, room(start), step);
    while step > 0.5 {
        let mut moved = false;
        for (dx, dy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
            let q = p + Offset::new(dx, dy) * step;
            let r = room(q);
            // A step has to pay, so that rounding never decides between equal places.
            if r > best + 0.01 {
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
fn room_at(p: Point, area: &[Point], avoid: &[Vec<Point>], panel: &Rect) -> f64 {
    let own = distance_to_line(area, p);
    let own = if contains(area, p) { own } else { -own };
    let edge = (p.x - panel.x0).min(panel.x1 - p.x).min(p.y - panel.y0).min(panel.y1 - p.y);
    avoid.iter().fold(own.min(edge), |room, other| {
        let d = distance_to_line(other, p);
        room.min(if contains(other, p) { -d } else { d })
    })
}

fn edges(line: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    let last = line.last().copied();
    line.windows(2).map(|pair| (pair[0], pair[1])).chain(last.zip(line.first().copied()))
}

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
fn contains(line: &[Point], p: Point) -> bool {
    let mut inside = false;
    for (a, b) in edges(line) {
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) {
            inside = !inside;
        }
    }
    inside
}

/// Whether a label has room inside the area.
fn fits(rect: &Rect, area: &[Point]) -> bool {
    contains(area, rect.center()) && !crosses(&rect.grown(ROOM), area)
}

/// Whether a label touches an area.
fn meets(rect: &Rect, area: &[Point]) -> bool {
    contains(area, rect.center()) || crosses(&rect.grown(2.0), area)
}

fn crosses(rect: &Rect, line: &[Point]) -> bool {
    edges(line).any(|(a, b)| super::length_inside(a, b, rect).is_some())
}

/// Around the area, touching it from outside in eight directions.
fn outside(area: &[Point], avoid: &[Vec<Point>], size: (f64, f64)) -> Vec<Candidate> {
    let Some(bounds) = area.iter().map(|&p| Rect::new(p, p)).reduce(Rect::union) else { return Vec::new() };
    let center = bounds.center();
    let directions = [
        (1.0, -1.0),
        (0.0, -1.0),
        (1.0, 0.0),
        (-1.0, -1.0),
        (-1.0, 0.0),
        (1.0, 1.0),
        (0.0, 1.0),
        (-1.0, 1.0),
    ];
    directions
        .iter()
        .enumerate()
        .filter_map(|(i, &(dx, dy))| {
            let u = Offset::new(dx, dy).unit()?;
            let reach = area.iter().map(|&p| (p - center).dot(u)).fold(0.0, f64::max);
            let half = 0.5 * (u.dx.abs() * size.0 + u.dy.abs() * size.1);
            let rank = f64::from(u8::try_from(i).unwrap_or(8));
            let rect = about(center + u * (reach + ROOM + half), size);
            Some(Candidate { rect, reluctance: OUTSIDE + 0.3 * rank + shared(&rect, avoid), leader: None })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x0: f64, y0: f64, side: f64) -> Vec<Point> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(x, y)| Point::new(x0 + side * x, y0 + side * y))
            .to_vec()
    }

    #[test]
    fn the_pole_of_a_square_is_its_middle() {
        let (pole, room) = pole(&square(10.0, 20.0, 80.0), &[]);
        assert!((pole.x - 50.0).abs() < 1.0 && (pole.y - 60.0).abs() < 1.0, "{pole:?}");
        assert!((room - 40.0).abs() < 1.0);
    }

    #[test]
    fn a_name_keeps_out_of_the_part_that_another_body_covers() {
        let panel = Rect { x0: 0.0, y0: 0.0, x1: 300.0, y1: 300.0 };
        let (a, b) = (square(10.0, 10.0, 100.0), square(60.0, 10.0, 100.0));
        let best = places(&a, std::slice::from_ref(&b), (12.0, 12.0), &panel)
            .into_iter()
            .min_by(|p, q| p.reluctance.total_cmp(&q.reluctance))
            .unwrap();
        assert!(best.rect.x1 < 60.0 && best.rect.x0 > 10.0, "{best:?}");
        assert!(fits(&best.rect, &a) && !meets(&best.rect, &b));
    }

    #[test]
    fn a_name_that_has_no_room_inside_stands_outside() {
        let panel = Rect { x0: 0.0, y0: 0.0, x1: 300.0, y1: 300.0 };
        let tiny = square(100.0, 100.0, 8.0);
        assert!(places(&tiny, &[], (12.0, 12.0), &panel).iter().all(|c| !crosses(&c.rect, &tiny)));
    }
}
