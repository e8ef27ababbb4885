//! First contact of two bodies that do not turn, proved.
//!
//! What stands ready in a [`Sweep`] is what a relative pose and a relative velocity are made of: where B is
//! and how it is turned in A's frame, and the ray's direction there. Everything that is a search happens when
//! the question is asked, of four in this order:
//!
//! 1. [`filter`]: doubles find where the ray enters B ⊖ A and mostly prove it;
//! 2. [`balls`]: else signs that are certain;
//! 3. [`exact`]: axes and touches without any rounding, where coordinates are sums of products of doubles;
//! 4. separating axes and proofs of contact, for bodies of which a vertex and the ray are told apart by no
//!    digits ([`crate::collision::certified::impact::by_axes`]).

pub(super) mod balls;
pub(super) mod exact;
pub(super) mod filter;
pub(super) mod heading;
pub(super) mod ray;

use crate::collision::answer::Outcome;
use crate::collision::certified::distance::Pair;
use crate::collision::certified::impact;
use crate::collision::feature::DifferenceFeature;
use crate::geometry::Body;
use heading::Heading;
use ray::Entry;

/// Two bodies that move and do not turn, over t in [0, 1].
#[derive(Clone, Copy, Debug)]
pub struct Sweep<'s> {
    /// Both at t = 0.
    pair: Pair<'s>,
    /// Where the ray goes; None where the filter can't be asked.
    heading: Option<Heading>,
}

impl<'s> Sweep<'s> {
    /// The two bodies at t = 0 and the direction of the ray, with cosines and sines to twice the precision of
    /// a double, which nearly every hit needs. Spins are not looked at.
    ///
    /// ```
    /// use tracefig::collision::{Outcome, Sweep};
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::ONE))]).unwrap();
    /// let body = |x, speed| Body {
    ///     shape: shape.clone(), position: DVec2::new(x, 0.5), angle: Angle::Degrees(30.0),
    ///     velocity: DVec2::new(speed, 0.0), spin: Angle::Degrees(0.0),
    /// };
    /// let (a, b) = (body(0.0, 0.0), body(4.0, -3.0));
    /// let Outcome::Hit { time, .. } = Sweep::new(&a, &b).first_contact() else { panic!() };
    /// // 4 less the width of a square at 30°, over 3.
    /// let exact = (4.0 - 4.0 / 3f64.sqrt()) / 3.0;
    /// assert!(time.lo <= exact + 1e-16 && exact - 1e-16 <= time.hi && time.hi - time.lo < 2e-16);
    /// ```
    #[must_use]
    pub fn new(a: &'s Body, b: &'s Body) -> Self {
        let pair = Pair::refined_at(a, b, 0.0);
        Self { heading: Heading::of(&pair), pair }
    }

    /// When and how the bodies meet first.
    ///
    /// Times are in [0, 1]; the bounds enclose the exact time of the bodies as their doubles say it, mostly
    /// between two neighbouring doubles. A contact is the pair at `time.lo`, in world units.
    /// Nothing is decided of bodies that are not convex, or have numbers that are not finite.
    ///
    /// ```
    /// use tracefig::collision::{Outcome, Sweep};
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let disc = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
    /// let body = |x, speed| Body {
    ///     shape: disc.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(0.0),
    ///     velocity: DVec2::new(speed, 0.0), spin: Angle::Degrees(0.0),
    /// };
    /// let (a, near, far) = (body(0.0, 4.0), body(5.0, 0.0), body(7.0, 0.0));
    /// let Outcome::Hit { time, contact } = Sweep::new(&a, &near).first_contact() else { panic!() };
    /// assert!(time.lo < 0.75 && 0.75 <= time.hi && contact.separation < 1e-15);
    /// assert_eq!(Sweep::new(&a, &far).first_contact(), Outcome::Miss);
    /// ```
    #[must_use]
    pub fn first_contact(&self) -> Outcome {
        if !(self.pair.a.can_touch() && self.pair.b.can_touch()) {
            return Outcome::UNKNOWN;
        }
        let outcome = self.entry().outcome(&self.pair);
        if matches!(outcome, Outcome::Unresolved { .. }) { self.by_other_means(outcome) } else { outcome }
    }

    /// What the ray leaves open: exact arithmetic may decide it, or axes, or the bodies called the other way
    /// round.
    #[cold]
    fn by_other_means(&self, open: Outcome) -> Outcome {
        exact::outcome(&self.pair)
            .or_else(|| impact::by_axes(self.pair.a, self.pair.b))
            .or_else(|| self.the_other_way_round())
            .unwrap_or(open)
    }

    /// What can be decided with B called A: whatever can be with A called A is decided there as well, so that
    /// both ways round are judged alike.
    #[cold]
    fn the_other_way_round(&self) -> Option<Outcome> {
        let other = Sweep::new(self.pair.b, self.pair.a);
        let decided = match other.entry().outcome(&other.pair) {
            Outcome::Unresolved { .. } => impact::by_axes(other.pair.a, other.pair.b),
            decided => Some(decided),
        };
        decided.map(Outcome::swapped)
    }

    /// The edge or vertex of B ⊖ A through which the ray's line enters it, now or at any other time; None
    /// where it passes, or that is not certain.
    pub(crate) fn entered(&self) -> Option<DifferenceFeature> {
        match self.entry() {
            Entry::At { feature, .. } => Some(feature),
            Entry::Still | Entry::Misses | Entry::Unsure => None,
        }
    }

    /// Where the ray's line enters B ⊖ A.
    #[inline]
    fn entry(&self) -> Entry {
        let filtered = self.heading.as_ref().and_then(|heading| filter::entry(&self.pair, heading));
        filtered.unwrap_or_else(|| balls::entry(&self.pair))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::certified::distance::settle;
    use crate::collision::tests::bodies::{Bodies, boxed, moving, placed, polygon};

    #[test]
    fn a_contact_of_doubles_is_the_certified_separation_at_its_time() {
        let mut bodies = Bodies::new(17);
        for k in 0..1000 {
            let (a, b) = bodies.flying_pair(0.0);
            let Outcome::Hit { time, contact } = Sweep::new(&a, &b).first_contact() else { continue };
            let at = settle(&Pair::at(&a, &b, time.lo), None);
            assert!(contact.bounds.lo <= at.bounds.hi && at.bounds.lo <= contact.bounds.hi, "{k}");
            assert!((*contact.normal - *at.normal).length() < 1e-9, "{k}: {contact:?} {at:?}");
            let apart =
                (contact.points[0] - at.points[0]).length() + (contact.points[1] - at.points[1]).length();
            assert!(apart < 1e-9 || contact.features != at.features, "{k}: {contact:?} {at:?}");
        }
    }
    #[test]
    fn round_and_flat_segments_on_one_line_meet_in_as_narrow_a_time_as_others() {
        let segment = |radius| polygon(&[[2.5, -1.5], [-2.5, 1.5]], radius);
        let a = moving(segment(0.0), [-7.5, 4.5], 0.0);
        let b = moving(placed(segment(1.0), -7.5, 4.5, 0.0), [27.5, -16.5], 0.0);
        for sweep in [Sweep::new(&a, &b), Sweep::new(&b, &a)] {
            let Outcome::Hit { time, .. } = sweep.first_contact() else { panic!("they meet") };
            assert!(time.hi - time.lo < 1e-15, "{time:?}");
        }
    }

    #[test]
    fn a_segment_much_longer_than_any_gap_is_missed_in_both_orders() {
        // No axis at hand told them apart with the upper one called A.
        let edge = polygon(&[[2.023_162_713_892_851_5e-48, 1.875], [-2.8125, 4.0]], 0.0);
        let a = moving(placed(edge, 0.0, 0.0, 0.0), [0.0, -1e-118], 0.0);
        let b = placed(polygon(&[[-8.422_846_920_471_272e26, -0.59], [0.0, 0.0]], 0.0), 0.0, 0.0, 0.0);
        for sweep in [Sweep::new(&a, &b), Sweep::new(&b, &a)] {
            assert_eq!(sweep.first_contact(), Outcome::Miss);
        }
    }

    #[test]
    fn bodies_that_overlap_at_the_start_do_not_meet_at_a_far_end() {
        // The far end of the long one is passed in the first 2e-40 of the motion.
        let long = polygon(&[[3.0, 0.0625], [-2.5e28, 0.0625]], 2.0);
        let short = placed(polygon(&[[0.5, 0.0], [0.0, 0.0]], 0.5), 3.0, 0.0, 0.0);
        for speed in [1e30, 1e50, 1.62e68] {
            let (a, b) = (moving(long.clone(), [speed, 0.0], 0.0), moving(short.clone(), [-3.0, -1.0], 0.0));
            for sweep in [Sweep::new(&a, &b), Sweep::new(&b, &a)] {
                let outcome = sweep.first_contact();
                assert!(matches!(outcome, Outcome::Overlapping { .. }), "{speed:e}: {outcome:?}");
            }
        }
    }

    #[test]
    fn a_corner_that_grazes_a_disc_by_less_than_an_ulp_meets_it_at_one_time() {
        // Doubles lose the normal's part along the ray, which told the time from below.
        let diamond = polygon(&[[-2.0, 0.0], [0.0, -2.0], [2.0, 0.0], [0.0, 2.0]], 0.0);
        for depth in [1e-30_f64, 1e-29, 1e-28, 3e-21, 1e-16, 2e-9, 0.125] {
            let disc = placed(polygon(&[[0.0, depth]], 0.5), 0.0, -0.5, 0.0);
            for start in [8.0, 16.0, 80.0] {
                for speed in [18.0, 19.0, 23.0, 29.0] {
                    let speed = start * speed / 16.0;
                    let a = moving(placed(diamond.clone(), -start, 2.0, 0.0), [speed, 0.0], 0.0);
                    for sweep in [Sweep::new(&a, &disc), Sweep::new(&disc, &a)] {
                        let Outcome::Hit { time, contact } = sweep.first_contact() else {
                            panic!("they meet")
                        };
                        let apart = contact.bounds.hi;
                        assert!(
                            apart <= 16.0 * f64::EPSILON * start,
                            "{depth:e}, {speed}: {time:?}, {apart}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn a_box_that_slides_along_another_and_nears_it_by_1e_15_of_its_way_meets_it_at_one_time() {
        // Doubles do not tell when it meets the edge's line: axes left a hundredth of the motion open.
        let angle = -124.198_695_929_808_24;
        let a = boxed("box", 0.459_231_487_899_801_3, 0.163_307_230_774_804_52);
        let a = placed(a, -0.291_305_920_136_375_1, -0.573_868_902_898_090_1, angle);
        let b = boxed("box", 13.957_398_243_371_626, 19.669_584_837_089_09);
        let b = placed(b, -5.667_848_291_016_019, 26.800_192_402_993_05, angle);
        let b = moving(b, [-6.357_912_175_717_629, -9.355_841_711_128_317], 0.0);
        // To 400 bits.
        let exact = 0.471_225_847_406_329_8;
        for sweep in [Sweep::new(&a, &b), Sweep::new(&b, &a)] {
            let Outcome::Hit { time, .. } = sweep.first_contact() else { panic!("they meet") };
            assert!(time.lo <= exact && exact <= time.hi && time.hi - time.lo < 1e-13, "{time:?}");
        }
    }

    #[test]
    fn an_edge_that_ends_off_the_line_of_a_long_one_by_1e_45_of_its_length_is_not_parallel_to_it() {
        // A unit normal said that it may be, and the ray met the long edge beyond its end.
        let long = polygon(&[[4.511_023_394_003_684e45, 4.5625], [0.0, 0.0]], 0.0);
        let a = moving(placed(long, 0.0, 1.11e-42, 0.0), [-6.9375, -6.9375], 0.0);
        let b = placed(boxed("aabb", 6.9375, 6.9375), -6.9375, -6.9375, 0.0);
        let b = moving(b, [1e16, -1e-2], 0.0);
        // The lower end comes down on the box.
        let exact = 1.11e-42 / (6.9375 - 1e-2);
        for sweep in [Sweep::new(&a, &b), Sweep::new(&b, &a)] {
            let Outcome::Hit { time, .. } = sweep.first_contact() else { panic!("they meet") };
            assert!((time.lo - exact).abs() + (time.hi - exact).abs() < 1e-57, "{time:?}");
        }
    }

    #[test]
    fn a_ray_that_only_touches_the_disc_at_a_vertex_enters_through_the_edge_before_it() {
        // Of a capsule that reaches 1e45 the ray meets the upper side, and touches the end's disc later.
        let long = polygon(&[[2.408_231_784_405_426_8e45, -27.0], [-3.625, -3.625]], 3.625);
        let a = moving(placed(long, 0.0, 0.0, 0.0), [0.0, 3.0], 0.0);
        let b = placed(polygon(&[[0.125, 0.0], [0.0, 0.0]], 0.0), 0.0, 0.0, 0.0);
        for sweep in [Sweep::new(&a, &b), Sweep::new(&b, &a)] {
            let Outcome::Hit { time, .. } = sweep.first_contact() else { panic!("they meet") };
            // 3.625 times the slope, over 3.
            let exact = 3.625 * (27.0 - 3.625) / 2.408_231_784_405_426_8e45 / 3.0;
            assert!(time.lo <= exact * (1.0 + 1e-15) && exact * (1.0 - 1e-15) <= time.hi, "{time:?}");
        }
    }

    #[test]
    fn of_two_segments_along_the_motion_the_ends_that_face_each_other_meet_first() {
        let segment = |from: f64, to: f64, x: f64| placed(polygon(&[[from, from], [to, to]], 0.0), x, x, 0.0);
        let (needle, thread) = (segment(-3.0, -2.0, 0.0), segment(-2.0, -1.0, 4.0));
        let needle = moving(needle, [12.0, 12.0], 0.0);
        for sweep in [Sweep::new(&needle, &thread), Sweep::new(&thread, &needle)] {
            let Outcome::Hit { time, .. } = sweep.first_contact() else { panic!("a third of the way") };
            assert!(time.lo <= 1.0 / 3.0 && 1.0 / 3.0 <= time.hi && time.hi - time.lo < 1e-16, "{time:?}");
        }
        let over = segment(-2.5, 0.0, 0.0);
        assert!(matches!(Sweep::new(&needle, &over).first_contact(), Outcome::Overlapping { .. }));
    }
}
