//! The quick stage against the balls.

use crate::collision::Pair;
use crate::collision::certified::sweep::filter::{Heading, Met, met};
use crate::collision::certified::sweep::ray::*;
use crate::collision::tests::sweep_properties::Dice;

#[test]
fn doubles_prove_most_rays_and_say_what_balls_say() {
    let (mut dice, mut quick, count) = (Dice(11), 0, 3000);
    for k in 0..count {
        let (a, b) = (dice.flying(0.0), dice.flying(0.0));
        let pair = Pair::finely_at(&a, &b, 0.0);
        let entry = Ray::new(&pair).entry();
        let quick_entry = Heading::of(&pair).and_then(|heading| met(&pair, &heading));
        match (quick_entry, &entry) {
            (None, _) => continue,
            (Some(Met::Nothing), entry) => assert!(matches!(entry, Entry::Misses), "{k}: {entry:?}"),
            (Some(Met::At(piece, time, _) | Met::Outside(piece, time)), Entry::At(same, first, last)) => {
                assert_eq!(format!("{piece:?}"), format!("{same:?}"), "{k}");
                let (lo, hi) = (first.doubles().0, last.doubles().1);
                let outside = (time.hi < 0.0 || time.lo >= 1.0) && time.lo <= lo && hi <= time.hi;
                assert!(outside || (time.lo, time.hi) == (lo, hi), "{k}: {piece:?}");
            }
            (Some(quick), entry) => panic!("{k}: {quick:?}, but {entry:?}"),
        }
        quick += 1;
    }
    assert!(quick * 10 >= count * 9, "{quick} of {count}");
}
