//! Where bodies touch at a hit: at a point, along a segment where edge meets edge, or nowhere that is known.
//!
//! A hit tells its witness points at the last moment proved free. The bodies touch by the end of its time
//! bounds; until then no point of theirs is carried farther than its body's fastest one. Where the gap that
//! is left and that way are below what three digits tell, the middle of the witness points is the place. A
//! loose tolerance leaves more open.

use crate::collision::{Answer, Query, Separation, scale_of};
use crate::geometry::{Body, DVec2, Enclosure, Feature, perp};

/// The part of the size of what is asked about, bodies or place, that is half of the last of three digits.
const HALF_A_DIGIT: f64 = 5e-4;

/// The part of a body's size by which vertices lie in one line: far above rounding, far below a digit.
const LEVEL: f64 = 1e-9;

/// The share of the size of a pair below which a gap at the first contact is none: that moment is known to
/// its bounds, and nothing parts the bodies there. A wider one is what the tolerance of a search leaves, and
/// is told as it is drawn. A millionth of the pair is a thousandth of a pixel.
const TOUCHING: f64 = 1e-6;

/// Where bodies touch first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Touching {
    /// At this point of the world.
    At(DVec2),
    /// Edge to edge, along the segment between these points.
    Along([DVec2; 2]),
    /// It is open: the bounds of the time are too wide.
    Open,
}

/// Where two bodies touch that hit each other within a span of `time`, by the pair at its start, in the
/// world.
pub(crate) fn touching([a, b]: [&Body; 2], time: Enclosure, contact: &Separation) -> Touching {
    let at = 0.5 * (contact.points[0] + contact.points[1]);
    let size = at.length().max(reach(a)).max(reach(b));
    let open = contact.bounds.hi + (time.hi - time.lo) * (fastest(a) + fastest(b));
    if open > HALF_A_DIGIT * size {
        return Touching::Open;
    }
    let n = *contact.normal;
    let along = perp(n);
    let [from, to] = match contact.features {
        [Feature::Edge(_), Feature::Edge(_)] => {
            let ([p, q], [r, s]) = (face(a, n, time.lo), face(b, -n, time.lo));
            [along.dot(p).min(along.dot(q)), along.dot(r).min(along.dot(s))]
                .into_iter()
                .zip([along.dot(p).max(along.dot(q)), along.dot(r).max(along.dot(s))])
                .fold([f64::NEG_INFINITY, f64::INFINITY], |[lo, hi], (x, y)| [lo.max(x), hi.min(y)])
        }
        _ => [0.0, 0.0],
    };
    if to - from > LEVEL * size {
        Touching::Along([from, to].map(|x| at + along * (x - along.dot(at))))
    } else {
        Touching::At(at)
    }
}

/// Lets bodies touch whose separation is none but for rounding.
pub(super) fn touch(answer: &mut Answer, query: &Query) {
    let Answer::Separation(found) = answer else { return };
    if query.b.is_some_and(|b| is_touch(found, query.a, b)) {
        (found.separation, found.bounds) = (0.0, Enclosure { lo: 0.0, hi: 0.0 });
    }
}

/// Whether the separation of two bodies is none but for rounding.
pub(crate) fn is_touch(found: &Separation, a: &Body, b: &Body) -> bool {
    let Enclosure { lo, hi } = found.bounds;
    lo.abs().max(hi.abs()) <= TOUCHING * scale_of(a, b)
}

/// The farthest point of a body from its origin.
fn reach(body: &Body) -> f64 {
    body.shape.vertices.iter().map(|v| v.length()).fold(0.0, f64::max) + body.shape.radius
}

/// No point of a body is faster than this.
fn fastest(body: &Body) -> f64 {
    body.velocity.length() + body.spin.radians().abs() * reach(body)
}

/// The first and the last of a body's vertices that are as far along `outward` as any, in the world.
fn face(body: &Body, outward: DVec2, time: f64) -> [DVec2; 2] {
    let pose = body.pose_at(time);
    let points = || body.shape.vertices.iter().map(|&v| pose.point(v));
    let far = points().map(|p| outward.dot(p)).fold(f64::NEG_INFINITY, f64::max);
    let level = || points().filter(|&p| outward.dot(p) >= far - LEVEL * reach(body));
    let along = |p: &DVec2, q: &DVec2| perp(outward).dot(*p).total_cmp(&perp(outward).dot(*q));
    [level().min_by(along), level().max_by(along)].map(|p| p.unwrap_or(pose.position))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Outcome;
    use crate::scene::open_text;

    fn found(text: &str) -> Touching {
        let scene = open_text("hit", text).unwrap().scene;
        let query = scene.query_at(0.0);
        let crate::collision::Answer::Impact(impact) = scene.query().algorithm.ask(&query) else { panic!() };
        let Outcome::Hit { time, contact } = impact.outcome else { panic!("{impact:?}") };
        touching([query.a, query.b.unwrap()], time, &contact)
    }

    #[test]
    fn a_box_that_meets_a_box_edge_to_edge_touches_along_what_both_edges_share() {
        let boxes = |height: f64| {
            format!(
                "shapes.A = {{ kind = 'aabb', half_extents = [1, 0.5], position = [-5, {height}],
                     velocity = [8, 0] }}
                 shapes.B = {{ kind = 'aabb', half_extents = [0.5, 2], position = [2, 0.5] }}
                 query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}"
            )
        };
        for (height, from, to) in [(0.0, -0.5, 0.5), (2.25, 1.75, 2.5)] {
            let Touching::Along(mut ends) = found(&boxes(height)) else { panic!("at {height}") };
            ends.sort_by(|p, q| p.y.total_cmp(&q.y));
            let off = ends.iter().zip([from, to]).map(|(p, y)| (*p - DVec2::new(1.5, y)).length());
            assert!(off.fold(0.0, f64::max) < 1e-12, "{ends:?}");
        }
        assert!(matches!(found(&boxes(3.0)), Touching::At(_)), "end to end");
    }

    #[test]
    fn a_loose_tolerance_leaves_the_place_open() {
        let arm = |tolerance: &str| {
            format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 0.1], angular_velocity_deg = 90 }}
                 shapes.B = {{ kind = 'circle', radius = 0.2, position = [0, 1] }}
                 query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
                     tolerance = {tolerance} }}"
            )
        };
        assert_eq!(found(&arm("0.1")), Touching::Open);
        let Touching::At(p) = found(&arm("1e-9")) else { panic!("as good as known") };
        assert!((p - DVec2::new(0.191, 0.940)).length() < 1e-3, "{p}");
    }
}
