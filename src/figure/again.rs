//! How often two bodies that never touch are as near as anywhere: a body that turns may come by with each
//! vertex, or stay as near all the time.
//!
//! The distance of bodies that turn has as many minima as it likes. Its values at even moments show where one
//! may be, and steps by thirds lead down to it. A minimum that is found is one; another may be missed.

use std::f64::consts::TAU;
use std::sync::OnceLock;

use crate::collision::Pair;
use crate::geometry::{Body, Enclosure};
use crate::scene::Scene;

/// Moments that are looked at: of ten turns of a box, six to a minimum. A prime, so that a regular polygon
/// does not look alike at all of them.
const MOMENTS: u16 = 251;

/// The most that both bodies turn, radians: beyond ten turns the moments miss too much.
const MOST_TURNED: f64 = 10.0 * TAU;

/// How wide the bounds of a least distance may be that is told as the least, in roundings of the pair's
/// numbers: a millionth of their size.
const KNOWN: f64 = 1e10;

/// Steps to a minimum: the last third is below the last bit of a time.
const THIRDS: usize = 92;

/// How often bodies are as near as at their closest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Nearest {
    /// At one moment or for one while, as far as is found.
    Once,
    /// At several moments, between which they are farther apart.
    Again,
    /// All the time.
    Always,
    /// Nobody knows: they turn too fast for a proof that they are hardly nearer at any other moment.
    Unknown,
}

/// How often the bodies of one run are as near as at their closest, found when it is first asked: every
/// sentence about a miss asks it, which was half of what a frame of such a figure cost.
#[derive(Debug, Default)]
pub(crate) struct Often(OnceLock<Nearest>);

impl Often {
    /// How often the bodies of a scene are as near as at `time`, with these bounds of their least distance,
    /// world units: those of the run's closest approach. Of bodies that do not turn it is one piece of time.
    pub(crate) fn of(&self, scene: &Scene, time: f64, bounds: Enclosure) -> Nearest {
        *self.0.get_or_init(|| nearest(scene, time, bounds))
    }
}

/// [`Often::of`], found anew.
fn nearest(scene: &Scene, time: f64, bounds: Enclosure) -> Nearest {
    let query = scene.query_at(time);
    if bounds.hi - bounds.lo > KNOWN * query.rounding() {
        return Nearest::Unknown;
    }
    let turned = |b: &&Body| query.a.spin.radians().abs() + b.spin.radians().abs();
    let Some(b) = query.b.filter(|b| turned(b) > 0.0 && turned(b) <= MOST_TURNED) else {
        return Nearest::Once;
    };
    let apart = |t: f64| Pair::at(query.a, b, t).separation().separation;
    let moments: Vec<f64> = (0..=MOMENTS).map(|k| f64::from(k) / f64::from(MOMENTS)).collect();
    let near = bounds.hi + query.rounding();
    let all: Vec<f64> = moments.iter().map(|&t| apart(t)).collect();
    if all.iter().all(|&s| s <= near) {
        return Nearest::Always;
    }
    let last = all.len() - 1;
    let is_another = |k: usize| {
        let (s, before, after) = (all[k], k.saturating_sub(1), (k + 1).min(last));
        let beside = all[before].max(all[after]);
        let is_low = s <= all[before] && s <= all[after];
        // Under the sample it may fall as far as it rises beside it.
        let may_be = s - near <= beside - s;
        let is_between = |t: f64| (t - time) * (moments[k] - t) > 0.0;
        let parted = || moments.iter().zip(&all).any(|(&t, &s)| s > near && is_between(t));
        is_low && may_be && parted() && least(&apart, [moments[before], moments[after]]) <= near
    };
    if (0..all.len()).any(is_another) { Nearest::Again } else { Nearest::Once }
}

/// The least value within a span of time in which there is one minimum.
fn least(apart: &impl Fn(f64) -> f64, [mut from, mut to]: [f64; 2]) -> f64 {
    let mut found = apart(from).min(apart(to));
    for _ in 0..THIRDS {
        let third = (to - from) / 3.0;
        let (p, q) = (from + third, to - third);
        let (at_p, at_q) = (apart(p), apart(q));
        found = found.min(at_p).min(at_q);
        if at_p <= at_q { to = q } else { from = p }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::{ALGORITHMS, closest_approach};
    use crate::scene::open_text;

    fn of(b: &str) -> Nearest {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
            shapes.B = {{ {b} }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'] }}"
        );
        let scene = open_text("s", &text).unwrap().scene;
        let query = scene.query_at(0.0);
        let swept = ALGORITHMS.iter().find(|algorithm| algorithm.name == "swept-axis").unwrap();
        let closest = closest_approach(&query, &swept.ask(&query)).unwrap();
        nearest(&scene, closest.time, closest.bounds)
    }

    #[test]
    fn a_box_that_turns_comes_by_with_every_vertex_and_a_disc_stays() {
        let turning = "kind = 'box', half_extents = [1.4, 0.5], position = [0, 2.7]";
        assert_eq!(of(&format!("{turning}, angular_velocity_deg = 360")), Nearest::Again);
        assert_eq!(of(&format!("{turning}, angular_velocity_deg = 60")), Nearest::Once);
        assert_eq!(of(&format!("{turning}, angular_velocity_deg = 360, velocity = [0, 2]")), Nearest::Once);
        // A box is alike after each quarter turn: at as many moments it would seem to stay.
        assert_eq!(of(&format!("{turning}, angular_velocity_deg = 22590")), Nearest::Once);
        let disc = "kind = 'circle', radius = 1, position = [0, 2.7], angular_velocity_deg = 90";
        assert_eq!(of(disc), Nearest::Always);
    }
}
