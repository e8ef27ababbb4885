//! One point of contact: of the vertices of both bodies the one that is deepest in the other.
//!
//! A crate on the ground has two that are as deep. Held at one of them it turns about it, sinks in at the
//! other, and is held there in the next frame: it trembles. Clipping finds both (see `algorithm/clip.rs`).

use crate::collision::QueryKind;
use crate::collision::certified::distance::Pair;

use super::bodies::both;
use super::{Claim, Naive};

pub(super) const NAIVE: Naive = Naive {
    name: "deepest-vertex",
    kinds: &[QueryKind::Contact],
    claims: |[a, b], time| {
        let found = Pair::at(a, b, time).separation();
        if found.separation > 0.0 {
            return Some(Claim::Miss);
        }
        let [a, b] = both([a, b], time)?;
        let n = *found.normal;
        // The one that is where they touch: a far corner of a large body is in nothing.
        let deepest = [a.support(n) + n * a.radius, b.support(-n) - n * b.radius];
        let [of_a, of_b] = [0, 1].map(|i: usize| deepest[i].distance(found.points[i]));
        Some(Claim::Contact(deepest[usize::from(of_b <= of_a)]))
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, placed};
    use crate::geometry::DVec2;

    #[test]
    fn of_a_crate_that_rests_it_is_one_end_and_of_a_hair_s_tilt_the_other() {
        let ground = placed(boxed("box", 5., 0.5), 0., -0.5, 0.);
        let at = |tilt: f64| {
            let body = placed(boxed("box", 1., 1.), 0., 0.9375, tilt);
            let Some(Claim::Contact(at)) = (NAIVE.claims)([&ground, &body], 0.0) else { panic!() };
            at
        };
        let near = |p: DVec2, x: f64| (p - DVec2::new(x, -0.0625)).length() < 1e-3;
        assert!(near(at(0.01), -1.0) && near(at(-0.01), 1.0), "{} {}", at(0.01), at(-0.01));
        assert!(near(at(0.0), -1.0) || near(at(0.0), 1.0), "{}", at(0.0));
        for tilt in [0.01, 0.0] {
            let on_a_roof = placed(boxed("box", 1., 1.), 0., 0.9375, tilt);
            let Some(Claim::Contact(swapped)) = (NAIVE.claims)([&on_a_roof, &ground], 0.0) else { panic!() };
            assert!(near(swapped, -1.0) || tilt == 0.0 && near(swapped, 1.0), "{tilt}: {swapped}");
        }
        let apart = placed(boxed("box", 1., 1.), 0., 1.5, 0.);
        assert_eq!((NAIVE.claims)([&ground, &apart], 0.0), Some(Claim::Miss));
    }
}
