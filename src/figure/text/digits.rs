//! How many digits of a number are asked for: `.3` three after the point, `.3g` three in all. Where nothing
//! is asked for, a number has three, or all it has where those are no more than five.
//!
//! A number lies between its bounds. A digit that the two ends do not share is not proved, and is never
//! written: the most digits at which both ends round to the same text are all there are; where nobody asks
//! for digits and that is one, both ends are written. Ends as near to each other as the rounding of doubles
//! are one number, and half a digit is rounded away from 0, as at school: else 2.125, known to sixteen
//! digits, would have two, as its ends lie on two sides of a half.

use crate::geometry::{power_of_ten, read};

use super::point::plain;
use crate::trace::{TOLD, USUAL, WHOLE};

/// Most digits in all: of a double's sixteen the last ones are rounding wherever it was computed.
const MOST: usize = 12;
/// The part of a bound by which a number may pass it that is written for it, and of a number by which its
/// bounds may differ and be one number: what proving a bound added to a round number, far below the third
/// digit. At 0 the bound of 5 would be written 5.01.
const NOTHING: f64 = 1e-9;
/// The part of a number that rounding of doubles may have taken from it: half a digit is meant where so much
/// lacks. At 0 the double nearest to 1.005, which is just below it, has 1.00 for two digits.
const LACKING: f64 = 1e-13;
/// The most that a unit of the last digit is of a number that has [`TOLD`] of them.
const UNIT_TOLD: f64 = 1e-9;
/// Half of a digit's unit, which takes a number that was rounded to one side to the other.
const HALF: f64 = 0.5;
/// Fewest digits that say where a number lies better than its two ends: of one in [0.96, 1.04] the only one
/// that is proved is 1, which reads as if it were that.
const FEWEST: usize = 2;
/// Decimal exponents within which a number is written without a power of ten.
const PLAIN: std::ops::RangeInclusive<i32> = -3..=5;

/// Sizes of numbers of which a few steps tell whether they have many digits.
const SIZES_SEEN: std::ops::Range<f64> = 1e-9..1e9;
/// The powers of ten among them.
const POWERS: [f64; 18] =
    [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8];
/// How many of them are at most 1.
const POWERS_TO_ONE: usize = 10;

/// How many digits of a number are written at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Digits {
    /// Digits in all, without zeros at their end.
    Significant(usize),
    /// Digits after the point, zeros at their end included.
    Decimals(usize),
    /// What a number has where nobody asks for digits: all, where they are few, else three.
    Usual,
}

impl Digits {
    /// What a text asks for after the colon of `{=name:.3}`; `None` for anything else.
    pub(crate) fn asked(text: &str) -> Option<Self> {
        let digits = text.strip_prefix('.')?;
        let (digits, kind): (_, fn(usize) -> Self) = match digits.strip_suffix('g') {
            Some(digits) => (digits, Self::Significant),
            None => (digits, Self::Decimals),
        };
        let is_number = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        let asked = kind(is_number.then(|| digits.parse().ok())??);
        (asked != Self::Significant(0)).then_some(asked)
    }

    /// A number lying in [lo, hi]: digits that the two ends do not share are left out. A minus is a hyphen,
    /// and a power of ten is written `1.5e-9`.
    #[must_use]
    pub(crate) fn of(self, lo: f64, hi: f64) -> String {
        if let Some(whole) = self.whole(lo, hi) {
            return whole;
        }
        let (lo, hi) = as_one(lo, hi);
        let (most, least) = match self {
            Self::Usual => (usual(lo.abs().max(hi.abs())), FEWEST),
            Self::Significant(most) => (most.min(MOST), 1),
            Self::Decimals(most) => (most.min(decimals_within(lo.abs().max(hi.abs()))), 0),
        };
        if lo.to_bits() == hi.to_bits() && least <= most {
            return self.written(lo, most);
        }
        for digits in (least..=most).rev() {
            let (p, q) = (self.written(lo, digits), self.written(hi, digits));
            if p == q {
                return p;
            }
        }
        // Both hold what lies between them.
        let [lo, hi] = [(lo, -1.0), (hi, 1.0)].map(|(end, side)| {
            let all = self.whole(end, end).unwrap_or_else(|| self.written(end, most));
            if lacks(&all, end, side) { self.beyond(end, side) } else { all }
        });
        format!("{lo}…{hi}")
    }

    /// All digits of a number that has few, where nobody asks for fewer or more.
    fn whole(self, lo: f64, hi: f64) -> Option<String> {
        if self != Self::Usual || has_many_digits(lo) {
            return None;
        }
        let all = significant(lo, WHOLE);
        // Most numbers have more, which is seen without writing more.
        if read(&all).is_some_and(|all| (lo - all).abs() > UNIT_TOLD * lo.abs()) {
            return None;
        }
        let is_all = |end: f64| significant(end, TOLD) == all;
        (is_all(lo) && (lo.to_bits() == hi.to_bits() || is_all(hi))).then_some(all)
    }

    /// A number that is not less than the one given: of an upper bound.
    #[must_use]
    pub(crate) fn at_least(self, value: f64) -> String {
        self.to_a_side(value, 1.0)
    }

    /// A number that is not more than the one given: of a lower bound.
    #[must_use]
    pub(crate) fn at_most(self, value: f64) -> String {
        self.to_a_side(value, -1.0)
    }

    /// The nearest number of so many digits, or its neighbour where that one lies on the other side.
    fn to_a_side(self, value: f64, side: f64) -> String {
        let nearest = self.of(value, value);
        if !lacks(&nearest, value, side) {
            return nearest;
        }
        // Beside what it bounds, 20.9, a bound of 20.944 would look larger as 21.0.
        let more = (usual(value) + 1..=WHOLE).map(|digits| in_digits(value, digits, Zeros::Kept));
        let alike = more.filter(|_| self == Self::Usual).find(|text| !lacks(text, value, side));
        alike.unwrap_or_else(|| self.beyond(value, side))
    }

    /// The neighbour of the nearest number of so many digits, where that one lies on the other side.
    fn beyond(self, value: f64, side: f64) -> String {
        let last = match self {
            Self::Significant(digits) => exponent(value) + 1 - exponent_of(digits.min(MOST)),
            Self::Usual => exponent(value) + 1 - exponent_of(usual(value)),
            Self::Decimals(digits) => -exponent_of(digits.min(decimals_within(value.abs()))),
        };
        let beyond = value + side * HALF * power_of_ten(f64::from(last));
        self.of(beyond, beyond)
    }

    /// A double to so many digits.
    fn written(self, value: f64, digits: usize) -> String {
        match self {
            Self::Decimals(_) if exponent(value) < exponent_of(MOST) => {
                let text = format!("{value:.digits$}");
                let is_zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
                if is_zero { text.trim_start_matches('-').to_owned() } else { text }
            }
            Self::Decimals(_) => significant(value, MOST),
            Self::Significant(_) => significant(value, digits),
            Self::Usual => in_digits(value, digits, Zeros::Kept),
        }
    }
}

/// Whether a text says less than a value, or more where `side` is -1, by more than rounding.
fn lacks(text: &str, value: f64, side: f64) -> bool {
    read(text).is_some_and(|number| side * (value - number) > NOTHING * value.abs())
}

/// The decimal exponent of a double; 0 of 0.
fn exponent(value: f64) -> i32 {
    if SIZES_SEEN.contains(&value.abs()) {
        // A double below that nearest to a power of ten is written with digits below it.
        let reached = POWERS.iter().filter(|&&power| value.abs() >= power).count();
        return exponent_of(reached) - exponent_of(POWERS_TO_ONE);
    }
    let scientific = format!("{value:e}");
    scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// Whether a number has surely more than [`WHOLE`] digits, as most have, seen without writing any: so far
/// from so many that rounding here, some 1e-15 of it, decides nothing. A frame of a drag asks
/// for some hundred.
fn has_many_digits(value: f64) -> bool {
    let mut scaled = value.abs();
    if !SIZES_SEEN.contains(&scaled) {
        return false;
    }
    // From 10⁴ to 10⁵ the digits before the point are WHOLE.
    while scaled < 1e4 {
        scaled *= 10.0;
    }
    while scaled >= 1e5 {
        scaled /= 10.0;
    }
    (scaled - scaled.round()).abs() > 2.0 * UNIT_TOLD * scaled
}

/// Digits in all of a number where nobody asks: three, or all before the point of one that is written without
/// a power of ten. A place at 12342.4 is not at 12300.
fn usual(value: f64) -> usize {
    let before_point = exponent(value).min(*PLAIN.end()) + 1;
    let is_plain = PLAIN.contains(&exponent(value));
    usize::try_from(before_point).ok().filter(|_| is_plain).map_or(USUAL, |digits| digits.max(USUAL))
}

/// A count of digits as an exponent.
fn exponent_of(digits: usize) -> i32 {
    i32::try_from(digits).unwrap_or(i32::MAX)
}

/// Digits after the point that a number of a size has within the most in all.
fn decimals_within(size: f64) -> usize {
    usize::try_from(exponent_of(MOST).saturating_sub(1).saturating_sub(exponent(size))).unwrap_or(0)
}

/// The ends of a number's bounds, or twice the one that is farther from 0 where they are as good as one.
fn as_one(lo: f64, hi: f64) -> (f64, f64) {
    let far = if hi.abs() > lo.abs() { hi } else { lo };
    let one = far + LACKING * far;
    if hi - lo <= NOTHING * far.abs() && one.is_finite() { (one, one) } else { (lo, hi) }
}

/// What becomes of zeros at a number's end, after the point.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Zeros {
    /// They say how far it was rounded.
    Kept,
    /// They say nothing.
    Dropped,
}

/// A double to `digits` significant digits, without trailing zeros; with a power of ten where it is very
/// large or small.
fn significant(value: f64, digits: usize) -> String {
    in_digits(value, digits, Zeros::Dropped)
}

/// A double to `digits` significant digits, with a power of ten where it is very large or small.
fn in_digits(value: f64, digits: usize, zeros: Zeros) -> String {
    let trimmed = |text: &str| match zeros {
        Zeros::Dropped if text.contains('.') => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        _ => text.to_owned(),
    };
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let within = *PLAIN.start()..=*PLAIN.end().max(&(exponent_of(digits) - 1));
    if !within.contains(&exponent) {
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    trimmed(&plain(mantissa, exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_after_the_point_or_in_all_are_asked_for() {
        assert_eq!(Digits::asked(".3"), Some(Digits::Decimals(3)));
        assert_eq!(Digits::asked(".0"), Some(Digits::Decimals(0)));
        assert_eq!(Digits::asked(".12g"), Some(Digits::Significant(12)));
        for wrong in
            ["", ".", "3", ".g", ".0g", ".3f", ".-1", ".+1", " .3", ".3 ", ".x", ".99999999999999999999"]
        {
            assert_eq!(Digits::asked(wrong), None, "{wrong:?}");
        }
    }

    #[test]
    fn the_exponent_of_a_double_is_that_with_which_it_is_written() {
        let written = |value: f64| format!("{value:e}").split_once('e').map(|(_, e)| e.parse().unwrap());
        for power in POWERS {
            for value in [power.next_down(), power, power.next_up(), 3.7 * power, -power] {
                assert_eq!(Some(exponent(value)), written(value), "{value:e}");
            }
        }
    }

    #[test]
    fn a_number_that_seems_to_have_many_digits_has_them() {
        let mut random = oorandom::Rand64::new(5);
        for _ in 0..20_000 {
            let size = power_of_ten(f64::from(i8::try_from(random.rand_range(0..20)).unwrap()) - 10.0);
            let few = (random.rand_float() * 1e5).round() * size;
            let off = [0.0, 0.5e-9, 1e-9, 1.5e-9, 3e-9][usize::try_from(random.rand_range(0..5)).unwrap()];
            let value = few * (1.0 + off);
            let written = read(&significant(value, WHOLE)).unwrap();
            let has_more = (value - written).abs() > UNIT_TOLD * value.abs();
            assert!(has_more || !has_many_digits(value), "{value}");
            assert!(
                off < 2.5e-9 || few == 0.0 || !SIZES_SEEN.contains(&value) || has_many_digits(value),
                "{value}"
            );
        }
    }

    #[test]
    fn decimals_keep_their_zeros_and_never_pass_the_bounds() {
        let three = Digits::Decimals(3);
        assert_eq!(three.of(0.5, 0.5), "0.500");
        assert_eq!(three.of(0.499_999_999_999_999_94, 0.5), "0.500");
        assert_eq!(three.of(-2.5, -2.5), "-2.500");
        assert_eq!(three.of(-0.000_1, -0.000_1), "0.000");
        assert_eq!(three.of(0.343_1, 0.343_9), "0.34", "0.343 and 0.344 differ");
        assert_eq!(three.of(0.3, 0.6), "0…1".replace("0…1", "0.300…0.600"));
        assert_eq!(Digits::Decimals(0).of(1234.4, 1234.4), "1234");
        assert_eq!(Digits::Decimals(1).of(1_234_567.891, 1_234_567.891), "1234567.9");
        assert_eq!(Digits::Decimals(300).of(0.1, 0.1), "0.100000000000", "twelve digits, one is a zero");
        assert_eq!(
            Digits::Decimals(2).of(1.234_567_890_123_45e20, 1.234_567_890_123_45e20),
            "1.23456789012e20"
        );
    }

    #[test]
    fn a_bound_has_as_many_digits_as_are_asked_for_on_its_own_side() {
        for (digits, value, up, down) in [
            (Digits::Decimals(2), 2.651_29, "2.66", "2.65"),
            (Digits::Decimals(3), 2.651_29, "2.652", "2.651"),
            (Digits::Decimals(1), 2.5, "2.5", "2.5"),
            (Digits::Decimals(2), -0.004, "0.00", "-0.01"),
            (Digits::Decimals(0), 99.2, "100", "99"),
            (Digits::Significant(2), 99.2, "100", "99"),
            (Digits::Significant(5), 0.308_487_2, "0.30849", "0.30848"),
            (Digits::Significant(1), 9.4e-9, "1e-8", "9e-9"),
        ] {
            assert_eq!((digits.at_least(value), digits.at_most(value)), (up.into(), down.into()), "{value}");
        }
    }

    #[test]
    fn a_number_of_few_digits_is_written_whole_where_nobody_asks_for_fewer() {
        for (value, text) in [
            (130.5, "130.5"),
            (8.125, "8.125"),
            (1234.0, "1234"),
            (0.1 + 0.2, "0.3"),
            (-0.031_25, "-0.03125"),
            (123_456.0, "123456"),
            (12_342.402, "12342"),
            (-8_005.25, "-8005"),
            (1.0 / 3.0, "0.333"),
            (2.000_04, "2.00"),
            (5e-9, "5e-9"),
        ] {
            assert_eq!(Digits::Usual.of(value, value), text, "{value}");
            assert_eq!(Digits::Significant(3).of(130.5, 130.5), "131", "three are asked for");
        }
        assert_eq!(Digits::Usual.at_least(20.943_95), "20.944", "as what it bounds, 20.9");
        assert_eq!(Digits::Usual.at_least(4.0 / 3.0), "1.34", "no more digits bound it");
        let bounds = (Digits::Usual.at_least(8.125), Digits::Usual.at_most(8.125));
        assert_eq!(bounds, ("8.125".into(), "8.125".into()));
    }

    #[test]
    fn half_a_digit_is_rounded_as_at_school_and_takes_no_digit_with_it() {
        let around = |x: f64| (x.next_down(), x.next_up());
        for (value, digits, text) in [
            (2.125, Digits::Significant(3), "2.13"),
            (-2.125, Digits::Significant(3), "-2.13"),
            (1.005, Digits::Decimals(2), "1.01"),
            (130.5, Digits::Decimals(0), "131"),
            (0.687_5, Digits::Decimals(3), "0.688"),
            (0.687_5, Digits::Usual, "0.6875"),
            (99.95, Digits::Usual, "99.95"),
        ] {
            let (lo, hi) = around(value);
            assert_eq!([digits.of(value, value), digits.of(lo, hi)], [text, text]);
        }
        assert_eq!(Digits::Significant(3).of(2.12, 2.13), "2.1", "these differ by a digit");
    }

    #[test]
    fn zeros_say_how_far_a_number_was_rounded() {
        for (value, text) in [(1.099_91, "1.10"), (0.349_721, "0.350"), (9.999_123, "10.0"), (1.1, "1.1")] {
            assert_eq!(Digits::Usual.of(value, value), text);
        }
        assert_eq!(Digits::Usual.of(1.099_912_3e-9, 1.099_912_3e-9), "1.10e-9");
        assert_eq!(Digits::Significant(3).of(1.099_91, 1.099_91), "1.1", "asked for at most");
    }

    #[test]
    fn significant_digits_are_at_most_those_that_both_ends_share() {
        assert_eq!(Digits::Significant(5).of(0.308_487_2, 0.308_487_2), "0.30849");
        assert_eq!(Digits::Significant(5).of(0.308_1, 0.308_4), "0.308");
        assert_eq!(Digits::Significant(8).of(12_345_678.0, 12_345_678.0), "12345678");
        assert_eq!(Digits::Significant(40).of(1.0 / 3.0, 1.0 / 3.0), "0.333333333333");
    }
}
