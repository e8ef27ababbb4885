//! The way out along the line of the centres.
//!
//! It parts the bodies, but no shorter way is looked for: two long planks, one slipped along the other, are
//! pushed apart lengthwise. And bodies with one centre have no line.

use crate::collision::QueryKind;
use crate::geometry::Body;

use super::bodies::{both, gap};
use super::{Claim, Naive};

pub(super) const NAIVE: Naive =
    Naive { name: "centres", kinds: &[QueryKind::Separation, QueryKind::Contact], claims };

fn claims(bodies: [&Body; 2], time: f64) -> Option<Claim> {
    let placed = both(bodies, time)?;
    let [a, b] = &placed;
    let way = b.centre() - a.centre();
    let n = way / way.length();
    Some(if n.is_finite() { Claim::Separation(gap(&placed, n), n) } else { Claim::Nothing })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Pair;
    use crate::collision::tests::bodies::{boxed, placed};

    /// What is claimed of two planks, the second at a place, and what is proved.
    fn planks(x: f64, y: f64) -> (Claim, f64) {
        let (a, b) = (boxed("box", 3., 0.5), placed(boxed("box", 3., 0.5), x, y, 0.));
        (claims([&a, &b], 0.0).unwrap(), Pair::at(&a, &b, 0.0).separation().bounds.hi)
    }

    #[test]
    fn planks_are_parted_lengthwise_and_not_at_all_at_one_place() {
        let (claim, proved) = planks(2.0, 0.4);
        let Claim::Separation(claimed, _) = claim else { panic!("{claim:?}") };
        assert!((proved + 0.6).abs() < 1e-12 && claimed < 4.0 * proved, "{claimed}, {proved}");
        assert_eq!(planks(0.0, 0.0).0, Claim::Nothing);
    }
}
