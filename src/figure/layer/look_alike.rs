//! Whether two outlines are one to the eye: a body that moved by less than its line is wide, or that a
//! symmetry of its own took to itself, as a square that turned a quarter.

use crate::figure::sketch::Outline;
use crate::geometry::DVec2;

/// How far apart the tips of unit vectors are that are one to the eye: 1.7 px of an arrow of 85.
const ALIKE: f64 = 0.02;

/// Whether no corner of one outline is farther than `near` from the other, in units of the space: of convex
/// outlines none of their points is then, and arcs are sampled.
pub(super) fn look_alike(one: &Outline, other: &Outline, near: f64) -> bool {
    let [p, q] = [one, other].map(Outline::sampled);
    lies_along(&p, &q, near) && lies_along(&q, &p, near)
}

/// Whether two unit vectors are one to the eye.
pub(super) fn point_alike(n: DVec2, other: DVec2) -> bool {
    n.distance(other) < ALIKE
}

/// Whether all points are within `near` of a closed line. Each is looked for from where the last one was: of
/// two lines that go around one outline the points follow each other.
fn lies_along(points: &[DVec2], line: &[DVec2], near: f64) -> bool {
    let mut last = 0;
    points.iter().all(|&p| {
        let mut pieces = (0..line.len() - 1).map(|i| (last + i) % (line.len() - 1));
        let found = pieces.find(|&i| from_segment(p, line[i], line[i + 1]) <= near);
        last = found.unwrap_or(last);
        found.is_some()
    })
}

/// The distance of a point from a segment.
fn from_segment(p: DVec2, from: DVec2, to: DVec2) -> f64 {
    let way = to - from;
    let length = way.length_squared();
    let along = if length > 0.0 { ((p - from).dot(way) / length).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(from + along * way)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn a_square_looks_alike_after_a_quarter_turn_and_after_no_other() {
        let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(DVec2::from);
        let square = Outline::polygon(&corners);
        let turned = Outline::polygon(&corners.map(|p| DVec2::new(-p.y, p.x)));
        assert!(look_alike(&square, &turned, 0.0));
        let eighth = Outline::polygon(&corners.map(|p| 0.5_f64.sqrt() * DVec2::new(p.x - p.y, p.x + p.y)));
        assert!(!look_alike(&square, &eighth, 0.4));
        let beside = square.moved(DVec2::new(0.1, 0.0));
        assert!(look_alike(&square, &beside, 0.11) && !look_alike(&square, &beside, 0.09));
        let half = Outline::polygon(&corners[..3]);
        assert!(!look_alike(&half, &square, 0.1), "one lies along the other, which has a corner more");
    }

    #[test]
    fn a_body_that_looks_the_same_at_another_moment_is_named_once() {
        // A square that turns a quarter, a bar that turns a little, and what is clearly elsewhere.
        let told = |body: &str, spin: f64| {
            let text = format!(
                "shapes.door = {{ {body}, angular_velocity_deg = {spin} }}
                 shapes.wall = {{ kind = 'box', half_extents = [1, 1], position = [9, 0] }}
                 query = {{ kind = 'time-of-impact', of = ['door', 'wall'] }}
                 panels = [{{ layers = ['shapes', {{ layer = 'ghosts', of = 'door', at = 'end' }}] }}]"
            );
            let scene = open_text("marks", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "marks");
            (labels(&figure)["A'"].0.clone(), paths(&figure.drawing.items, "ghost-A").len())
        };
        let square = "kind = 'box', half_extents = [1, 1]";
        let bar = "kind = 'capsule', points = [[0, 0], [3, 0]], radius = 0.1";
        assert_eq!(told(square, 90.0), ("looks the same at $t = 1$ turned $90°$".into(), 0));
        assert_eq!(told(bar, 0.004), ("looks the same at $t = 1$".into(), 0));
        assert_eq!(told("kind = 'circle', radius = 1", -30.0).0, "looks the same at $t = 1$ turned $-30°$");
        assert_eq!(told(square, 45.0).0, "door at $t = 1$");
        assert_eq!(told(bar, 4.0).0, "door at $t = 1$");
    }

    #[test]
    fn steps_at_which_a_body_looks_as_at_the_last_have_no_ghosts() {
        let text = "shapes.hammer = { kind = 'box', half_extents = [0.5, 0.35], position = [0.2, 2.6],
                velocity = [0, -3.4], angular_velocity_deg = -35 }
            shapes.anvil = { kind = 'box', half_extents = [2, 0.4] }
            query.kind = 'time-of-impact'
            query.of = ['hammer', 'anvil']
            query.algorithm = 'conservative-advancement'
            panels = [{ time = 'start', layers = ['shapes', { layer = 'ghosts', at = 'steps' }] }]";
        let scene = open_text("steps", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "steps");
        // Ten steps, of which the last eight are within a pixel.
        assert_eq!(paths(&figure.drawing.items, "ghost-A").len(), 2);
    }
}
