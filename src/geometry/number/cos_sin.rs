//! Cosine and sine of a turning body's angle, quickly, for sweeps and impacts in doubles.
//!
//! The angle in degrees, a + ω t, is kept as a sum of two doubles, and quarter turns come off exactly; only
//! the rest,
//! |δ| ≤ 45°, is rounded and turned into radians. An angle in radians becomes one in degrees, to twice the
//! precision of a double. The series then need no table:
//!
//! ```text
//! sin x = x − x³/3! + … − x¹⁵/15!        remainder ≤ x¹⁷/17! < ε/4 for |x| ≤ π/4
//! cos x = 1 − x²/2! + … + x¹⁶/16!        remainder ≤ x¹⁸/18! < ε/64
//! ```
//!
//! δ, π/180 and their product are rounded by ε/2 each, 1.2 ε of x at most; the sums lose ε more. So each is
//! within 3 ε, for any number of turns. [`Turn`] is six times as precise, and slower.

use crate::geometry::{Angle, Rotation, Turn, two_product, two_sum};

/// Above this the number of quarter turns would not be exact; [`Turn`] takes over.
const MANY_DEGREES: f64 = 1e12;

/// 1.5 · 2⁵²: adding and subtracting it rounds to the nearest whole number.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Radians in a degree: π/180.
const RADIANS: f64 = std::f64::consts::PI / 180.0;

/// Cosine and sine of `angle` + `spin` t, each within 3 ε.
#[inline]
pub(crate) fn cos_sin(angle: Angle, spin: Angle, t: f64) -> Rotation<f64> {
    let (Angle::Degrees(a), Angle::Degrees(w)) = (angle, spin) else {
        return of_radians(angle, spin, t);
    };
    if !(w.abs() < MANY_DEGREES && a.abs() < MANY_DEGREES) {
        return Turn::at(angle, spin, t).rotation();
    }
    let (p, e) = two_product(w, t);
    let (sum, f) = two_sum(a, p);
    of_sum(sum, e + f)
}

/// Cosine and sine where an angle or a spin is in radians.
fn of_radians(angle: Angle, spin: Angle, t: f64) -> Rotation<f64> {
    let (a, w) = (angle.degrees_tailed(), spin.degrees_tailed());
    if !(w.hi.abs() < MANY_DEGREES && a.hi.abs() < MANY_DEGREES) {
        return Turn::at(angle, spin, t).rotation();
    }
    let sum = a + w.scale(t);
    of_sum(sum.hi, sum.lo)
}

/// Cosine and sine of a sum of doubles in degrees.
#[inline]
fn of_sum(sum: f64, low: f64) -> Rotation<f64> {
    let quarters = (sum * (1.0 / 90.0) + WHOLE) - WHOLE;
    let x = ((sum - 90.0 * quarters) + low) * RADIANS;
    let z = x * x;
    let sin = x - x * z * (S3 - z * (S5 - z * (S7 - z * (S9 - z * (S11 - z * (S13 - z * S15))))));
    let cos = 1.0 - z * (0.5 - z * (C4 - z * (C6 - z * (C8 - z * (C10 - z * (C12 - z * (C14 - z * C16)))))));
    #[expect(clippy::cast_possible_truncation, reason = "whole, and below 2⁴⁰; masked to 0 to 3")]
    let quarters = (quarters as i64 & 3).unsigned_abs() as u8;
    Rotation { cos, sin }.quarters_on(quarters)
}

const S3: f64 = 1.0 / 6.0;
const S5: f64 = 1.0 / 120.0;
const S7: f64 = 1.0 / 5_040.0;
const S9: f64 = 1.0 / 362_880.0;
const S11: f64 = 1.0 / 39_916_800.0;
const S13: f64 = 1.0 / 6_227_020_800.0;
const S15: f64 = 1.0 / 1_307_674_368_000.0;
const C4: f64 = 1.0 / 24.0;
const C6: f64 = 1.0 / 720.0;
const C8: f64 = 1.0 / 40_320.0;
const C10: f64 = 1.0 / 3_628_800.0;
const C12: f64 = 1.0 / 479_001_600.0;
const C14: f64 = 1.0 / 87_178_291_200.0;
const C16: f64 = 1.0 / 20_922_789_888_000.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_within_three_epsilon_of_the_finer_one() {
        let mut worst = 0.0_f64;
        for k in -30_000..30_000 {
            let (angle, spin, t) =
                (Angle::Degrees(f64::from(k) * 0.0137), Angle::Degrees(f64::from(k % 97) * 1111.1), 0.377);
            let Rotation { cos, sin } = cos_sin(angle, spin, t);
            let Rotation { cos: c, sin: s } = Turn::at(angle, spin, t).rotation_in_balls();
            let off = |x: f64, y: crate::geometry::Ball| ((y.value.hi - x) + y.value.lo).abs();
            worst = worst.max(off(cos, c)).max(off(sin, s));
        }
        assert!(worst < 3.0 * f64::EPSILON, "{}", worst / f64::EPSILON);
        assert!(worst > 0.3 * f64::EPSILON, "the bound would be idle: {}", worst / f64::EPSILON);
    }
}
