//! Angles as they are written in files: degrees or radians, exactly, any number of turns.
//!
//! An angle at time t is a sum of doubles and products of doubles, that is, a sum of doubles without any
//! rounding. Each is reduced by whole turns (`%` is exact), the sum is kept as an expansion (Shewchuk,
//! *Adaptive Precision Floating-Point Arithmetic*, 1997, theorem 10), and the nearest multiple of 90 comes
//! off exactly. Only what is left, |δ| ≤ 45, is rounded, so that multiples of 90° have cosines and sines that
//! are exactly 0 and ±1, and parallel bodies are exactly parallel. Then δ = d + ρ with a whole number d of
//! degrees, and
//!
//! ```text
//! sin(d + ρ) = s + (c sin ρ + s (cos ρ − 1))      with s = sin d°, c = cos d° from a table
//! sin ρ = ρ − ρ³/3! + ρ⁵/5! − … ± ρ¹¹/11!         remainder ≤ ρ¹³/13! < 3·10⁻³⁷ for |ρ| ≤ 0.5°
//! cos ρ − 1 = − ρ²/2! + ρ⁴/4! − … − ρ¹⁰/10!       remainder ≤ ρ¹²/12! < 5·10⁻³⁴
//! ```
//!
//! (Tang, *Table-Driven Implementation of the Exponential Function in IEEE Floating-Point Arithmetic*, 1989,
//! has the idea of the table.)

use crate::geometry::Angle;
use crate::geometry::Ball;
use crate::geometry::Dd;
use crate::geometry::Rotation;
use crate::geometry::number::expansion::{Expansion, exact_product};
use crate::geometry::number::radians::add_radians;
use crate::geometry::number::series::{onto, series};
use crate::geometry::number::sines::{RADIANS_PER_DEGREE, SINES};
use crate::geometry::two_sum;

/// An exact sum of angles, less whole quarter turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turn {
    /// Quarter turns, 0 to 3.
    quarters: u8,
    /// Whole degrees, −45 to 45.
    whole: i8,
    /// The rest, in degrees, |rest| ≤ 0.5.
    rest: Dd,
    /// Bound on what `rest` leaves out, in degrees; 0 where nothing is.
    error: f64,
}

/// Bound on the error of [`Turn::rotation`], ε/2: half an ulp of a double below 1 is ε/4, and the correction
/// in the bracket is below 0.01 with at most ten roundings of ε/2 and the series' own 10⁻¹⁹.
#[cfg(test)]
pub(crate) const COS_SIN_ERROR: f64 = 0.5 * f64::EPSILON;

/// Parts of a sum of radians in degrees. An angle of ordinary size needs six, one of 300 digits twenty; what
/// finds no room is rounded away, and counts as an error.
const PARTS: usize = 32;

/// At least π/180, and what cosine or sine may change by for each degree that an angle is off.
const PER_DEGREE: f64 = 0.02;

/// Bound on the error of [`Turn::rotation_tailed`] besides that of the angle, ε/16.
///
/// The correction in the bracket is below 0.0088 with four roundings of ε/2 on its way, and the table's lower
/// half comes with it.
pub(crate) const TAILED_ERROR: f64 = f64::EPSILON / 16.0;

/// Bound on the error of the double-double cosine and sine, 2 ε²: the entry of the table ε²/8; ρ, below
/// 0.0088, is off by 5ε² of itself; the series and the products with them lose less than ε²/10 (see
/// [`crate::geometry::number::series`]); of the lower half of the sum, below 1.2ε, the two additions lose
/// ε²/2 each at most.
const FINE_ERROR: f64 = 2.0 * f64::EPSILON * f64::EPSILON;

impl Turn {
    /// No turn.
    pub(crate) const NONE: Self = Self { quarters: 0, whole: 0, rest: Dd::ZERO, error: 0.0 };

    /// The turn at time t: `angle` + `spin` · `t`.
    #[inline]
    #[must_use]
    pub(crate) fn at(angle: Angle, spin: Angle, t: f64) -> Self {
        let (Angle::Degrees(a), Angle::Degrees(w)) = (angle, spin) else {
            return Self::mixed(&[(angle, 1.0), (spin, t)]);
        };
        if w == 0.0 || t == 0.0 { Self::of_two(a, 0.0) } else { Self::turning(a, w, t) }
    }

    /// The sum a + w t, exactly.
    fn turning(a: f64, w: f64, t: f64) -> Self {
        let (p, e, lost) = exact_product(w, t);
        let mut turn = Self::sum(&[a, p, e]);
        turn.error += lost;
        turn
    }

    /// The turn of a fraction of degrees, `over` / `under`, where both are below 2⁴⁰. Whole degrees come off
    /// exactly; of the rest one quotient is rounded.
    #[must_use]
    pub(crate) fn ratio(over: i64, under: i64) -> Self {
        let nearest = |part: i64| (2 * over + part).div_euclid(2 * part);
        let quarters = nearest(90 * under);
        let left = over - quarters * 90 * under;
        let whole = (2 * left + under).div_euclid(2 * under);
        let rest = left - whole * under;
        #[expect(clippy::cast_precision_loss, reason = "both are below 2⁴⁸")]
        let rest = Dd::new(rest as f64).div(Dd::new(under as f64));
        let error = Dd::ROUNDING * rest.hi.abs();
        #[expect(clippy::cast_possible_truncation, reason = "|whole| ≤ 45 after the reduction")]
        let (quarters, whole) = (quarters.rem_euclid(4).unsigned_abs() as u8, whole as i8);
        Self { quarters, whole, rest, error }
    }

    /// The angle of `to` less the angle of `from`, both at `t`; each is (angle, spin).
    #[inline]
    #[must_use]
    pub(crate) fn between(from: (Angle, Angle), to: (Angle, Angle), t: f64) -> Self {
        let (Angle::Degrees(a), Angle::Degrees(v)) = from else { return Self::between_mixed(from, to, t) };
        let (Angle::Degrees(b), Angle::Degrees(w)) = to else { return Self::between_mixed(from, to, t) };
        if t == 0.0 || (v == 0.0 && w == 0.0) {
            Self::of_two(b, -a)
        } else {
            Self::turning_apart([a, b], [v, w], t)
        }
    }

    /// The sum b − a + (w − v) t, exactly.
    fn turning_apart([a, b]: [f64; 2], [v, w]: [f64; 2], t: f64) -> Self {
        let (p, e, lost_p) = exact_product(w, t);
        let (q, f, lost_q) = exact_product(v, t);
        let mut turn = Self::sum(&[b, -a, p, -q, e, -f]);
        turn.error += lost_p + lost_q;
        turn
    }

    /// [`Self::between`] where not all is in degrees.
    #[cold]
    fn between_mixed(from: (Angle, Angle), to: (Angle, Angle), t: f64) -> Self {
        Self::mixed(&[(to.0, 1.0), (from.0, -1.0), (to.1, t), (from.1, -t)])
    }

    /// A sum of at most four angles times numbers; equal radians of opposite sign leave nothing.
    #[cold]
    fn mixed(terms: &[(Angle, f64)]) -> Self {
        let (mut degrees, mut radians) = (Expansion::<PARTS>::default(), Expansion::<8>::default());
        for &(angle, factor) in terms.iter().take(4) {
            match angle {
                Angle::Degrees(size) => {
                    let (p, e, lost) = exact_product(size, factor);
                    degrees.grow(p % 360.0);
                    degrees.grow(e % 360.0);
                    degrees.error += lost;
                }
                Angle::Radians(size) => {
                    let (p, e, lost) = exact_product(size, factor);
                    radians.grow(p);
                    radians.grow(e);
                    // A radian has 57.3 degrees.
                    degrees.error += lost * 64.0;
                }
            }
        }
        for part in radians.largest_first() {
            add_radians(&mut degrees, part);
        }
        Self::reduced(degrees)
    }

    /// a + b, exactly; without an expansion where neither is above a turn.
    #[inline]
    fn of_two(a: f64, b: f64) -> Self {
        if a.abs().max(b.abs()) > 360.0 {
            return Self::sum(&[a, b]);
        }
        let (s, e) = two_sum(a, b);
        // Both differences are exact: of doubles within a factor of two of each other, or with 0 taken off.
        let quarters = nearest_integer(s * (1.0 / 90.0));
        let rest = s - 90.0 * quarters;
        let whole = nearest_integer(rest);
        let rest = Dd::sum(rest - whole, e);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "|quarters| ≤ 8 and |whole| ≤ 45 after the reduction"
        )]
        let (quarters, whole) = ((quarters as i32 & 3).unsigned_abs() as u8, whole as i8);
        Self { quarters, whole, rest, error: 0.0 }
    }

    /// The exact sum of at most six angles, in degrees.
    #[must_use]
    pub(crate) fn sum(terms: &[f64]) -> Self {
        let mut sum = Expansion::<8>::default();
        for &term in terms.iter().take(6) {
            sum.grow(if term.abs() < 360.0 { term } else { term % 360.0 });
        }
        Self::reduced(sum)
    }

    /// A sum in degrees, less its quarter turns and its whole degrees.
    fn reduced<const N: usize>(mut sum: Expansion<N>) -> Self {
        let quarters = nearest_integer(sum.approximate() / 90.0);
        if quarters != 0.0 {
            sum.grow(-90.0 * quarters);
        }
        let whole = nearest_integer(sum.approximate());
        if whole != 0.0 {
            sum.grow(-whole);
        }
        let (rest, error) = sum.rounded();
        #[expect(
            clippy::cast_possible_truncation,
            reason = "|quarters| ≤ 4 for each term and |whole| ≤ 45 after the reduction"
        )]
        let (quarters, whole) = ((quarters as i64).rem_euclid(4).unsigned_abs() as u8, whole as i8);
        Self { quarters, whole, rest, error: error + sum.error }
    }

    /// Whether it is exactly a number of quarter turns.
    #[must_use]
    pub(crate) fn is_quarter(&self) -> bool {
        self.whole == 0 && self.rest == Dd::ZERO && self.error == 0.0
    }

    /// How many quarter turns it is, 0 to 3; None where it is not a number of them.
    #[must_use]
    pub(crate) fn quarters(&self) -> Option<u8> {
        self.is_quarter().then_some(self.quarters)
    }

    /// Cosine and sine in doubles, each within [`COS_SIN_ERROR`]; exact for quarter turns.
    #[must_use]
    pub(crate) fn rotation(&self) -> Rotation<f64> {
        self.rotation_tailed().0.rounded()
    }

    /// Cosine and sine with what their doubles leave out, and the bound on the error of each: 0 for quarter
    /// turns, else [`TAILED_ERROR`] and what the angle is off. It costs one addition more than the doubles.
    #[inline]
    #[must_use]
    pub(crate) fn rotation_tailed(&self) -> (Rotation<Dd>, f64) {
        if self.is_quarter() {
            return (Rotation { cos: Dd::ONE, sin: Dd::ZERO }.quarters_on(self.quarters), 0.0);
        }
        let (s, c) = table(self.whole);
        let x = self.rest.hi * RADIANS_PER_DEGREE.hi
            + (self.rest.hi * RADIANS_PER_DEGREE.lo + self.rest.lo * RADIANS_PER_DEGREE.hi);
        let z = x * x;
        let sin_x = x + x * z * (-1.0 / 6.0 + z * (1.0 / 120.0 - z * (1.0 / 5040.0 - z * (1.0 / 362_880.0))));
        let cos_x = z * (-0.5 + z * (1.0 / 24.0 - z * (1.0 / 720.0 - z * (1.0 / 40_320.0))));
        let sin = Dd::sum(s.hi, s.lo + (c.hi * sin_x + s.hi * cos_x));
        let cos = Dd::sum(c.hi, c.lo + (c.hi * cos_x - s.hi * sin_x));
        (Rotation { cos, sin }.quarters_on(self.quarters), TAILED_ERROR + self.error * PER_DEGREE)
    }

    /// Cosine and sine to twice the precision, with a proven radius; points where they are exact.
    #[must_use]
    pub(crate) fn rotation_in_balls(&self) -> Rotation<Ball> {
        let (s, c) = table(self.whole);
        let (cos, sin) = if self.rest == Dd::ZERO && self.error == 0.0 {
            (entry(c), entry(s))
        } else {
            let (sin_x, cos_x) = series(self.rest * RADIANS_PER_DEGREE);
            let (sin, cos) = (onto(s, [(c, sin_x), (s, cos_x)]), onto(c, [(c, cos_x), (-s, sin_x)]));
            // However far the angle may be off, both lie in [−1, 1].
            let radius = (FINE_ERROR + self.error * PER_DEGREE).min(2.0);
            (Ball::within(cos, radius), Ball::within(sin, radius))
        };
        Rotation { cos, sin }.quarters_on(self.quarters)
    }
}

/// The integer nearest to `x`, |x| < 2⁵¹: adding 1.5 · 2⁵² leaves no room for a fraction. (`round` is a slow
/// call where the processor is not known to have the instruction.)
#[inline]
fn nearest_integer(x: f64) -> f64 {
    /// Adding and subtracting it, 1.5 · 2⁵², rounds to the nearest whole number.
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    (x + SHIFT) - SHIFT
}

/// Sine and cosine of −45 to 45 whole degrees.
fn table(whole: i8) -> (Dd, Dd) {
    let d = usize::from(whole.unsigned_abs());
    let s = SINES[d];
    (if whole < 0 { -s } else { s }, SINES[90 - d])
}

/// An entry of the table as a ball: a point where it is rational (0, ½, 1), else within ε²/8.
fn entry(x: Dd) -> Ball {
    let rational = x.lo == 0.0;
    Ball::within(x, if rational { 0.0 } else { 0.125 * f64::EPSILON * f64::EPSILON })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_halves_and_whole_turns_are_exact() {
        for (degrees, cos, sin) in
            [(0.0, 1.0, 0.0), (90.0, 0.0, 1.0), (-180.0, -1.0, 0.0), (36_270.0, 0.0, -1.0)]
        {
            let turn = Turn::at(Angle::Degrees(degrees), Angle::Degrees(0.0), 0.0);
            assert_eq!(turn.rotation(), Rotation { cos, sin }, "{degrees}");
            assert_eq!(turn.rotation_tailed().1, 0.0, "{degrees}");
            let balls = Rotation { cos: Ball::new(cos), sin: Ball::new(sin) };
            assert_eq!(turn.rotation_in_balls(), balls, "{degrees}");
        }
    }

    #[test]
    fn rational_cosines_are_points() {
        let sixty = Turn::at(Angle::Degrees(60.0), Angle::Degrees(0.0), 0.0).rotation_in_balls();
        assert_eq!(sixty.cos, Ball::new(0.5));
        let many =
            Turn::at(Angle::Degrees(0.0), Angle::Degrees(18_000.0 * 7.0 + 150.0), 1.0).rotation_in_balls();
        assert_eq!(many.sin, Ball::new(0.5));
    }

    #[test]
    fn the_table_obeys_the_addition_theorem() {
        let (s1, c1) = table(1);
        for d in 1..=44 {
            let ((s, c), (next, _)) = (table(d), table(d + 1));
            let error = (s * c1 + c * s1 - next).to_f64();
            assert!(error.abs() <= 2.0 * f64::EPSILON * f64::EPSILON, "{d}: {error:e}");
        }
    }

    #[test]
    fn one_degree_of_the_table_is_the_sum_of_the_series() {
        // sin 1° and cos 1° from the series at half a degree, doubled: anchors the table.
        let half = Turn::sum(&[0.5]);
        let Rotation { cos: c, sin: s } = half.rotation_in_balls();
        let (s1, c1) = table(1);
        assert!((s * c).scale(2.0).value.hi - s1.hi == 0.0);
        let error =
            ((s * c).scale(2.0).value - s1).to_f64().abs() + ((c * c - s * s).value - c1).to_f64().abs();
        assert!(error <= 4.0 * f64::EPSILON * f64::EPSILON, "{error:e}");
    }

    #[test]
    fn both_precisions_agree_within_their_bounds() {
        for k in -4000..4000 {
            let turn =
                Turn::at(Angle::Degrees(f64::from(k) * 0.137), Angle::Degrees(f64::from(k) * 1e4), 0.37);
            let (rough, Rotation { cos: c, sin: s }) = (turn.rotation(), turn.rotation_in_balls());
            assert!((c - Ball::new(rough.cos)).value.hi.abs() <= COS_SIN_ERROR, "{k}");
            assert!((s - Ball::new(rough.sin)).value.hi.abs() <= COS_SIN_ERROR, "{k}");
            assert!((c * c + s * s - Ball::ONE).value.hi.abs() <= 4.0 * FINE_ERROR, "{k}");
        }
    }

    #[test]
    fn a_difference_of_equal_angles_is_no_turn() {
        let turn = Turn::between(
            (Angle::Degrees(36.869_897), Angle::Degrees(1e7)),
            (Angle::Degrees(36.869_897), Angle::Degrees(1e7)),
            0.123,
        );
        assert!(turn.is_quarter());
        assert_eq!(turn.rotation_in_balls().cos, Ball::ONE);
    }

    #[test]
    fn a_tiny_difference_of_angles_is_kept() {
        let turn = Turn::between(
            (Angle::Degrees(30.0), Angle::Degrees(0.0)),
            (Angle::Degrees(30.0_f64.next_up()), Angle::Degrees(0.0)),
            0.5,
        );
        let sine = turn.rotation().sin;
        assert!((sine / (4.0 * f64::EPSILON * 4.0).to_radians() - 1.0).abs() < 1e-12 || sine > 0.0);
    }

    #[test]
    fn fifty_turns_and_a_third_have_the_cosine_of_120_degrees() {
        let turn = Turn::at(Angle::Degrees(18_000.0), Angle::Degrees(240.0), 0.5).rotation();
        assert!((turn.cos + 0.5).abs() <= COS_SIN_ERROR);
        assert!((turn.sin - 3_f64.sqrt() / 2.0).abs() <= 2.0 * COS_SIN_ERROR);
    }
}
