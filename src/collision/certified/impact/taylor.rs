//! How long a quantity that starts positive surely stays positive, from its value, two derivatives and a
//! bound on the third.
//!
//! For f with f(0) ≥ a > 0, f'(0) ≥ b, f''(0) ≥ c and |f'''| ≤ M, Taylor's theorem gives for all h ≥ 0
//!
//! ```text
//! f(h) ≥ a + b h + ½ c h² − ⅙ M h³
//! ```
//!
//! and on [0, H], where h³ ≤ H h², the parabola a + b h + ½ (c − ⅓ M H) h². Its first root r needs no
//! iteration and no cancellation, r = 2a / (−b + √(b² − 2aq)) where f falls at first, and f is positive on
//! [0, min(r, H)). Trying H near r itself makes the parabola as good as the cubic: the order is three at a
//! crossing, 3/2 at a graze.

use crate::collision::certified::rounding::ROOT_ERROR;

/// Value and derivatives of a quantity at one moment, each a lower bound, and a bound on the third derivative
/// over the whole motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Taylor {
    /// The quantity f, positive; world units.
    pub(crate) value: f64,
    /// Its first derivative, world units per unit of time.
    pub(crate) slope: f64,
    /// Its second derivative.
    pub(crate) curvature: f64,
    /// Bound M on the magnitude of its third derivative.
    pub(crate) third: f64,
}

impl Taylor {
    /// Whether f is positive on [0, `limit`] even if each term is as low as it gets there: a cheap test that
    /// lets most vertices pass.
    #[inline]
    pub(crate) fn stays_positive(&self, limit: f64) -> bool {
        let fall = self.slope.min(0.0) + limit * (0.5 * self.curvature.min(0.0) - limit * self.third / 6.0);
        self.value + limit * fall > ROOT_ERROR * self.value
    }
}

/// H is first tried this much beyond the root of the tangent. Half the excess saves 0.4 % of the search's
/// gaps and asks for balls 11 % more often, twice costs 0.6 % and asks 5 % less often.
const BEYOND_TANGENT: f64 = 1.25;

/// A second H is tried where the first leaves more than this part of it unproved: it then gains more than it
/// costs. Half and twice ask for balls 13 % and 7 % more often, with as many gaps to half a percent.
const WORTHWHILE: f64 = 0.25;

/// A time h ≤ `limit` such that f > 0 on [0, h].
///
/// Dimension: time, as `limit`. Never more than the true first root; close to it where M h³ is small against
/// `value`.
pub(crate) fn positive_until(f: Taylor, limit: f64) -> f64 {
    let root =
        |horizon: f64| parabola_root(f.value, f.slope, f.curvature - f.third * horizon / 3.0, ROOT_ERROR);
    let near = if f.slope < 0.0 { limit.min(BEYOND_TANGENT * f.value / -f.slope) } else { limit };
    let first = root(near);
    let proved = first.min(near);
    if proved >= limit || (first < near && first > near * (1.0 - WORTHWHILE)) {
        return proved;
    }
    // The root grows as H shrinks: where it is before H, a better H is between the two; else there may be
    // none at all.
    let far = if first < near { 0.5 * (first + near) } else { limit };
    proved.max(root(far).min(far))
}

/// First root of a + b h + ½ q h², less an allowance for its rounding; infinite where there is none.
///
/// Of the two ways to write a root, (−b − √(b² − 2aq)) / q and 2a / (√(b² − 2aq) − b), the one that adds what
/// has the same sign is taken: where f rises at first and a is tiny, the other one would keep no digit.
pub(crate) fn parabola_root(a: f64, b: f64, q: f64, allowance: f64) -> f64 {
    let a = a * (1.0 - allowance);
    let discriminant = b * b - 2.0 * a * q;
    if discriminant < 0.0 {
        return f64::INFINITY;
    }
    let root = discriminant.sqrt();
    let first = if b <= 0.0 { 2.0 * a / (root - b) } else { -(b + root) / q };
    // Past the last root, or with nothing that falls, the quotient is negative, infinite or not a number.
    if first > 0.0 { first * (1.0 - allowance) } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cubic(f: Taylor, h: f64) -> f64 {
        f.value + h * (f.slope + h * (0.5 * f.curvature - h * f.third / 6.0))
    }

    #[test]
    fn a_falling_line_is_used_up_at_its_root() {
        let h = positive_until(Taylor { value: 3.0, slope: -6.0, curvature: 0.0, third: 0.0 }, 1.0);
        assert!(h <= 0.5 && 0.5 - h < 64.0 * f64::EPSILON, "{h}");
    }

    #[test]
    fn a_parabola_that_stays_above_zero_is_never_used_up() {
        let f = Taylor { value: 1.0, slope: -2.0, curvature: 2.0 + 1e-6, third: 0.0 };
        assert_eq!(positive_until(f, 10.0), 10.0);
    }

    #[test]
    fn a_parabola_that_touches_zero_stops_before_it() {
        let f = Taylor { value: 1.0, slope: -2.0, curvature: 2.0, third: 0.0 };
        let h = positive_until(f, 10.0);
        assert!(h < 1.0 && h > 1.0 - 1e-6, "{h}");
    }

    #[test]
    fn a_rise_from_next_to_nothing_keeps_the_digits_of_its_root() {
        let f = Taylor { value: 1e-14, slope: 1.0, curvature: -3.0, third: 0.0 };
        let (h, root) = (positive_until(f, 1.0), (1.0 + (1.0_f64 + 6e-14).sqrt()) / 3.0);
        assert!(h < root && root - h < 64.0 * f64::EPSILON, "{h} {root}");
    }

    #[test]
    fn the_cubic_is_positive_up_to_the_answer_and_the_answer_is_near_its_root() {
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 32).expect("32 bits")) / 4_294_967_296.0
        };
        for _ in 0..2000 {
            let f = Taylor {
                value: next() + 1e-3,
                slope: 8.0 * next() - 6.0,
                curvature: 8.0 * next() - 4.0,
                third: 6.0 * next(),
            };
            let h = positive_until(f, 1.0);
            assert!((0..=200).all(|k| cubic(f, h * f64::from(k) / 200.0) > -1e-15), "{f:?} {h}");
            assert!(h > 0.0);
        }
    }
}
