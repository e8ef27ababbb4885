//! What must hold of the sweeps on pairs that nobody chose.

use crate::collision::Impact;
use crate::collision::Outcome;
use crate::collision::tests::storyboard::{placed, polygon};
use crate::collision::tests::storyboard_motion::{ask, moving};
use crate::geometry::Body;

/// Numbers in [0, 1), the same on every run.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).expect("32 bits")) / 4_294_967_296.0
    }

    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.roll()
    }

    /// A polygon of 1 to 6 vertices on an ellipse, some with a radius.
    fn body(&mut self) -> Body {
        let count = 1 + u32::try_from((self.0 >> 40) % 6).expect("below 6");
        let vertices = f64::from(count);
        let (x, y) = (self.between(0.3, 2.0), self.between(0.3, 2.0));
        let vertices: Vec<[f64; 2]> = (0..count)
            .map(|k| (f64::from(k) + 0.7 * self.roll()) * std::f64::consts::TAU / vertices)
            .map(|angle| [x * libm::cos(angle), y * libm::sin(angle)])
            .collect();
        let radius = if self.roll() < 0.4 { self.between(0.1, 0.6) } else { 0.0 };
        let angle = if self.roll() < 0.5 { 0.0 } else { self.between(-180.0, 180.0) };
        let (x, y) = (self.between(-4.0, 4.0), self.between(-4.0, 4.0));
        placed(polygon(&vertices, radius), x, y, angle)
    }

    pub(crate) fn flying(&mut self, most: f64) -> Body {
        let body = self.body();
        let velocity = [self.between(-8.0, 8.0), self.between(-8.0, 8.0)];
        let spin = if self.roll() < 0.3 { 0.0 } else { self.between(-most, most) };
        moving(body, velocity, spin)
    }
}

/// The last moment proved free, and the first with proved contact.
fn span(impact: &Impact) -> (f64, f64) {
    match impact.outcome {
        Outcome::Hit { time, .. } => (time.lo, time.hi),
        Outcome::Miss => (1.0, f64::INFINITY),
        Outcome::Overlapping { .. } => (0.0, 0.0),
        Outcome::Unresolved { free_until, .. } => (free_until, f64::INFINITY),
    }
}

#[test]
fn ray_clipping_never_passes_the_ray_cast() {
    let mut dice = Dice(5);
    for _ in 0..400 {
        let (a, b) = (dice.flying(0.0), dice.flying(0.0));
        let (direct, clipped) = (ask("ray-cast", &a, &b, 0.0).0, ask("ray-clipping", &a, &b, 1e-9).0);
        assert!(
            span(&clipped).0 < span(&direct).1 || span(&direct).1 == 0.0,
            "{direct:?} {clipped:?} {a:?} {b:?}"
        );
        assert!(
            span(&direct).0 < span(&clipped).1 || span(&direct).1 == 0.0,
            "{direct:?} {clipped:?} {a:?} {b:?}"
        );
        assert!(!matches!(direct.outcome, Outcome::Unresolved { .. }), "{direct:?} {a:?} {b:?}");
    }
}

#[test]
fn the_swept_axis_agrees_with_the_ray_cast_where_nothing_turns() {
    let mut dice = Dice(6);
    for _ in 0..400 {
        let (a, b) = (dice.flying(0.0), dice.flying(0.0));
        let (direct, swept) = (ask("ray-cast", &a, &b, 0.0).0, ask("swept-axis", &a, &b, 1e-12).0);
        assert_eq!(direct.outcome.word(), swept.outcome.word(), "{a:?} {b:?}");
        let ((lo, hi), (from, to)) = (span(&direct), span(&swept));
        assert!(lo <= to && from <= hi, "{direct:?} {swept:?} {a:?} {b:?}");
    }
}

#[test]
fn conservative_advancement_never_passes_the_swept_axis() {
    let mut dice = Dice(7);
    for _ in 0..300 {
        let (a, b) = (dice.flying(400.0), dice.flying(400.0));
        let swept = ask("swept-axis", &a, &b, 1e-12).0;
        let advanced = ask("conservative-advancement", &a, &b, 1e-6).0;
        let ((lo, hi), (from, to)) = (span(&swept), span(&advanced));
        assert!((from < hi || hi == 0.0) && (lo < to || to == 0.0), "{swept:?} {advanced:?} {a:?} {b:?}");
        assert!(!matches!(swept.outcome, Outcome::Unresolved { .. }), "{swept:?} {a:?} {b:?}");
        if matches!(advanced.outcome, Outcome::Miss) {
            assert_eq!(swept.outcome, Outcome::Miss, "{a:?} {b:?}");
        }
    }
}

#[test]
fn swapping_the_bodies_keeps_the_time() {
    let mut dice = Dice(8);
    for _ in 0..300 {
        let (a, b) = (dice.flying(400.0), dice.flying(400.0));
        let (there, back) = (ask("swept-axis", &a, &b, 1e-12).0, ask("swept-axis", &b, &a, 1e-12).0);
        assert_eq!(there.outcome.word(), back.outcome.word());
        let ((lo, hi), (from, to)) = (span(&there), span(&back));
        assert!(lo <= to && from <= hi, "{there:?} {back:?}");
        if let (Outcome::Hit { contact: x, .. }, Outcome::Hit { contact: y, .. }) =
            (there.outcome, back.outcome)
        {
            assert!((*x.normal + *y.normal).length() < 1e-6, "{x:?} {y:?}");
        }
    }
}
