//! Radians as a sum of doubles in degrees: what reduces them by whole turns without losing bits.
//!
//! With 180/π = K₀ + K₁ + …, each term the double nearest to what those before it leave out, and x a double,
//!
//! ```text
//! x rad = (x K₀ + x K₁ + x K₂ + …)°        x K = p + e exactly (Dekker)
//! ```
//!
//! Whole turns come off each p and e exactly, so that only as many terms count as are not yet negligible:
//! three for an angle of ordinary size, one more for every sixteen digits before its point. (Payne and Hanek,
//! *Radian Reduction for Trigonometric Functions*, 1983, has the idea.)

use crate::geometry::number::expansion::{Expansion, exact_product};

/// 180/π as a sum of doubles, the largest first.
pub(crate) const DEGREES_PER_RADIAN: [f64; 18] = [
    57.295_779_513_082_32,
    -1.987_849_567_057_628_3e-15,
    -1.683_339_498_039_174_4e-31,
    -5.565_957_793_698_446_4e-49,
    2.300_838_154_155_871_7e-65,
    1.943_965_693_175_492_7e-81,
    9.825_757_743_729_18e-98,
    1.252_168_771_128_197_9e-114,
    7.189_179_603_484_118e-131,
    -2.707_461_656_728_692e-147,
    -7.966_523_767_561_707e-164,
    3.908_747_856_213_253e-180,
    -3.960_134_749_301_14e-196,
    1.473_142_856_762_153_8e-212,
    9.237_174_648_108_078e-229,
    -4.951_207_661_040_386e-245,
    -8.318_731_983_770_316e-263,
    -5.430_305_918_814_637e-279,
];

/// Terms below this many degrees are left out: 2⁻¹⁴⁰, far below the ε² of what is made of them.
const NEGLIGIBLE: f64 = f64::from_bits((1023 - 140) << 52);

/// Adds `x` radians to a sum in degrees, less whole turns; what is left out is added to the sum's error.
pub(crate) fn add_radians<const N: usize>(sum: &mut Expansion<N>, x: f64) {
    if x == 0.0 {
        return;
    }
    let mut left_out = 0.0;
    for factor in DEGREES_PER_RADIAN {
        let (p, e, lost) = exact_product(x, factor);
        sum.grow(p % 360.0);
        sum.grow(e % 360.0);
        // All that follows is below ε of this term.
        left_out = p.abs() * f64::EPSILON + lost;
        if left_out < NEGLIGIBLE {
            break;
        }
    }
    sum.error += left_out;
}
