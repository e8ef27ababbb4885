//! The pole of inaccessibility of an area: the point farthest from its boundary.
//!
//! It is found on a grid that is refined about its best points; after Garcia-Castellanos, Lombardo, "Poles of
//! inaccessibility: A calculation algorithm for the remotest places on earth", Scottish Geographical Journal
//! 123(3), 2007. Other areas that cover part of this one count as boundary, so that the name of A stands in A
//! only. All lengths are page pixels.

use crate::drawing::{Offset, Point, Rect};
use crate::geometry::sort_by;

use super::polyline::Polyline;
use super::rect::nearest_in;
use super::weights::Places;

/// The search for a pole ends at steps of this, page pixels: what no eye sees.
pub(super) const FINE: f64 = 0.5;
/// A step towards the pole has to gain this, page pixels, so that rounding never decides between equal
/// places.
const PAYS: f64 = 0.01;
/// The pole of inaccessibility of an area on the page.
pub(super) fn pole(area: &Polyline, w: &Places) -> Point {
    let everywhere = Rect { x0: f64::MIN, y0: f64::MIN, x1: f64::MAX, y1: f64::MAX };
    let fallback = area.points().first().copied().unwrap_or_default();
    grid(area, &[], &everywhere, w).first().map_or(fallback, |&(pole, _)| pole)
}

/// Points inside the area and the panel, the farthest from all boundaries first, the best refined; each with
/// that distance, page pixels.
pub(super) fn grid(area: &Polyline, avoid: &[&Polyline], panel: &Rect, w: &Places) -> Vec<(Point, f64)> {
    let Some(bounds) = area.bounds().intersection(*panel) else { return Vec::new() };
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
            if bounds.contains(p) && area.contains(p) {
                points.push((p, room(p)));
            }
        }
    }
    sort_by(&mut points, |a, b| b.1.total_cmp(&a.1));
    // Where many points are as remote, as along the middle of a box, the one nearest to the area's middle is
    // best.
    let starts =
        points.iter().take(w.refined).map(|&(p, _)| p).chain(area.contains(middle).then_some(middle));
    let mut refined: Vec<(Point, f64)> = starts.map(|p| climb(p, 0.5 * step, &bounds, &room)).collect();
    refined.extend(points);
    sort_by(&mut refined, |a, b| b.1.total_cmp(&a.1));
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
fn room_at(p: Point, area: &Polyline, avoid: &[&Polyline], panel: &Rect) -> f64 {
    let edge = (p.x - panel.x0).min(panel.x1 - p.x).min(p.y - panel.y0).min(panel.y1 - p.y);
    let own = if area.contains(p) { distance_within(area, p, edge) } else { -distance(area, p) };
    avoid.iter().fold(own.min(edge), |room, other| {
        let away = (p - nearest_in(&other.bounds(), p)).square();
        // What is farther off than another line is, and does not hold the point, changes nothing.
        if away > 0.0 && (room <= 0.0 || away >= room * room) {
            room
        } else if other.contains(p) {
            room.min(-distance(other, p))
        } else {
            distance_within(other, p, room)
        }
    })
}

/// The distance of a point from a line.
fn distance(line: &Polyline, p: Point) -> f64 {
    line.square_within(p, f64::INFINITY).sqrt()
}

/// The distance of a point from a line, or `most` where that is less.
fn distance_within(line: &Polyline, p: Point, most: f64) -> f64 {
    let square = if most > 0.0 { most * most } else { return most };
    let least = line.square_within(p, square);
    if least < square { least.sqrt() } else { most }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    const W: &Places = &Places::TUNED;

    /// A square by its upper left vertex and its side, page pixels.
    pub(in super::super) fn square(x0: f64, y0: f64, side: f64) -> Vec<Point> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(x, y)| Point::new(x0 + side * x, y0 + side * y))
            .to_vec()
    }

    #[test]
    fn the_pole_of_a_square_is_its_middle() {
        let area = Polyline::closed(square(10.0, 20.0, 80.0)).unwrap();
        let pole = pole(&area, W);
        assert!((pole.x - 50.0).abs() < 1.0 && (pole.y - 60.0).abs() < 1.0, "{pole:?}");
        assert!((distance(&area, pole) - 40.0).abs() < 1.0);
    }
}
