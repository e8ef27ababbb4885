//! When two moving bodies are closest: looked for densely, then closer and closer about the best moments.
//!
//! Nothing is proved here: a minimum between two samples may be missed. The check of an answer proves its
//! bounds by subdivision; this is what a perfect solver would print.

use crate::first_contact::Motion;
use crate::float::Real;

/// Samples of a motion without turning, and most samples of any.
const SAMPLES: [u32; 2] = [64, 4096];

/// Samples a turn: a separation of convex bodies has few minima in one.
const SAMPLES_OF_TURN: f64 = 64.0;

/// Best samples about which the minimum is looked for.
const BEST: usize = 4;

/// Golden sections: 2⁻⁷⁶ of a sample's distance is left.
const SECTIONS: u32 = 110;

/// The moment in [0, 1], a double, at which the separation is least, the separation then, and the least one
/// of moments that are no doubles too.
#[must_use]
pub fn closest(motion: &Motion, turns: f64) -> (f64, Real, Real) {
    let [least, most] = SAMPLES.map(f64::from);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, from 64 to 4096")]
    let count = (least + SAMPLES_OF_TURN * turns).min(most) as u32;
    let at = |t: Real| motion.separation(t).separation;
    let moment = |k: u32| Real::from(f64::from(k.min(count)) / f64::from(count));
    let mut samples: Vec<(u32, Real)> = (0..=count).map(|k| (k, at(moment(k)))).collect();
    samples.sort_by_key(|(_, s)| *s);
    let refined = samples.iter().take(BEST).map(|(k, _)| {
        let t = section(at, moment(k.saturating_sub(1)), moment(k + 1));
        (t.to_f64(), at(Real::from(t.to_f64())), at(t))
    });
    let ends = [0.0, 1.0].map(|t| (t, at(Real::from(t)), at(Real::from(t))));
    refined.chain(ends).min_by_key(|(_, _, least)| *least).unwrap_or(ends[0])
}

/// Where a function with one minimum in [lo, hi] is least.
fn section(at: impl Fn(Real) -> Real, mut lo: Real, mut hi: Real) -> Real {
    let golden = Real::from(0.618_033_988_749_894_9);
    let (mut low, mut high) = (hi - (hi - lo) * golden, lo + (hi - lo) * golden);
    let (mut at_low, mut at_high) = (at(low), at(high));
    for _ in 0..SECTIONS {
        if at_low <= at_high {
            (hi, high, at_high) = (high, low, at_low);
            low = hi - (hi - lo) * golden;
            at_low = at(low);
        } else {
            (lo, low, at_low) = (low, high, at_high);
            high = lo + (hi - lo) * golden;
            at_high = at(high);
        }
    }
    (lo + hi).scaled(-1)
}

#[cfg(test)]
mod tests {
    use super::section;
    use crate::float::Real;

    #[test]
    fn a_minimum_is_found_to_half_of_the_bits_and_a_kink_to_all() {
        let middle = Real::from(0.3);
        let smooth = section(|t| (t - middle).squared(), Real::ZERO, Real::one());
        assert!((smooth - middle).abs() < Real::power_of_two(-58), "{smooth}");
        let kink = section(|t| (t - middle).abs(), Real::ZERO, Real::one());
        assert!((kink - middle).abs() < Real::power_of_two(-58), "{kink}");
    }
}
