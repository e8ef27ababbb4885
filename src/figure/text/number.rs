//! Numbers as text: three significant digits, or all where they are few, and no more than the bounds allow.

use super::digits::Digits;
use crate::geometry::read;

/// The digits of a number on a figure where nobody asks for others.
pub(crate) const USUAL: Digits = Digits::Usual;

/// The part of a number that rounding may have added to it in a few operations.
const ROUNDING: f64 = 1e-14;

/// A number lying in [lo, hi], to three digits, or all it has where they are few: digits that the two ends do
/// not share are left out.
#[must_use]
pub(crate) fn rounded(lo: f64, hi: f64) -> String {
    USUAL.of(lo, hi)
}

/// A number to three digits that is not less than the one given: of an upper bound.
#[must_use]
pub(crate) fn rounded_up(value: f64) -> String {
    USUAL.at_least(value)
}

/// A number to three digits that is not more than the one given: of a lower bound.
#[must_use]
pub(crate) fn rounded_down(value: f64) -> String {
    USUAL.at_most(value)
}

/// A double as LaTeX, as [`rounded`] has it.
#[must_use]
pub(crate) fn number(value: f64) -> String {
    in_math(&rounded(value, value))
}

/// The terms of a sum, of which the result is written by [`number`], as LaTeX: to the last digit of the
/// result, and of each other where one is short, so that who adds them up as they are written has the result.
/// A term that is short is written as anywhere else.
#[must_use]
pub(crate) fn terms(terms: [f64; 2], result: f64) -> [String; 2] {
    let after_point = |text: &str| text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let whole = rounded(result, result);
    let texts = terms.map(|term| rounded(term, term));
    if texts.iter().chain([&whole]).any(|text| text.contains('e')) {
        return terms.map(number);
    }
    let is_short = |text: &str, term: f64| {
        read(text).is_some_and(|written| (written - term).abs() <= ROUNDING * term.abs())
    };
    let short = [0, 1].map(|i| is_short(&texts[i], terms[i]));
    let own = [0, 1].into_iter().filter(|&i| short[i]).map(|i| after_point(&texts[i])).max();
    let decimals = Digits::Decimals(after_point(&whole).max(own.unwrap_or(0)));
    [0, 1].map(|i| if short[i] { in_math(&texts[i]) } else { in_math(&decimals.of(terms[i], terms[i])) })
}

/// A number from [`rounded`] as LaTeX.
#[must_use]
pub(crate) fn in_math(number: &str) -> String {
    let power = |part: &str| match part.split_once('e') {
        Some(("1", exponent)) => format!("10^{{{exponent}}}"),
        Some((mantissa, exponent)) => format!(r"{mantissa} \times 10^{{{exponent}}}"),
        None => part.to_owned(),
    };
    number.split('…').map(power).collect::<Vec<_>>().join(r" \ldots ")
}

/// A number from [`rounded`] as markup among words: a real minus sign, and a formula where it has a power of
/// ten.
#[must_use]
pub(crate) fn in_words(number: &str) -> String {
    if number.contains('e') || number.contains('…') {
        format!("${}$", in_math(number))
    } else {
        number.replace('-', "−")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_is_rounded_to_its_own_side() {
        for (value, up, down) in [
            (6.20244, "6.21", "6.20"),
            (6.2, "6.2", "6.2"),
            (9.999_123, "10.0", "9.99"),
            (0.1 + 0.2, "0.3", "0.3"),
            (0.300_001, "0.301", "0.300"),
            (-6.20244, "-6.20", "-6.21"),
            (0.0, "0", "0"),
            (1.234_567e9, "1.24e9", "1.23e9"),
        ] {
            assert_eq!((rounded_up(value).as_str(), rounded_down(value).as_str()), (up, down), "{value}");
        }
        assert_eq!(rounded_up(f64::MAX), "1.80e308");
    }

    #[test]
    fn three_digits_or_all_where_they_are_few() {
        assert_eq!(rounded(4.293_51, 4.293_51), "4.29");
        assert_eq!(rounded(11.5, 11.5), "11.5");
        assert_eq!(rounded(0.791_532, 0.791_532), "0.792");
        assert_eq!(rounded(1234.0, 1234.0), "1234", "written whole");
        assert_eq!(rounded(-2.500_000_000_000_000_4, -2.5), "-2.5");
        assert_eq!(rounded(0.0, 0.0), "0");
        assert_eq!(rounded(1.09e-9, 1.09e-9), "1.09e-9");
        assert_eq!(rounded(9.999_123, 9.999_123), "10.0");
        assert_eq!(rounded(0.000_999_912, 0.000_999_912), "0.00100");
        assert_eq!(number(4.293_51), "4.29");
    }

    #[test]
    fn a_sum_comes_out_as_it_is_written() {
        for (of, result, shown) in [
            ([2.956_91, 2.859_91], 0.097, ["2.957", "2.860"]),
            ([1.634_234, 0.164_123], 1.470_111, ["1.63", "0.16"]),
            ([2.5, 0.5], 2.0, ["2.5", "0.5"]),
            ([3.0, 1.0], 2.0, ["3", "1"]),
            ([2.5, 0.123_456], 2.376_544, ["2.5", "0.12"]),
            ([1e-7, 0.0], 1e-7, ["10^{-7}", "0"]),
            ([4.0, -2.25], 6.25, ["4", "-2.25"]),
        ] {
            assert_eq!(terms(of, result), shown, "{of:?}");
        }
    }

    #[test]
    fn digits_that_the_bounds_do_not_share_are_not_printed() {
        assert_eq!(rounded(0.123, 0.124), "0.12");
        assert_eq!(rounded(0.308_487, 0.308_488), "0.308");
        assert_eq!(rounded(0.499_999_999_999_999_94, 0.5), "0.5");
        assert_eq!(rounded(0.31, 0.34), "0.31…0.34");
        assert_eq!(rounded(0.96, 1.04), "0.96…1.04", "which is not 1");
        assert_eq!(rounded(0.25, 1.0), "0.25…1");
        assert_eq!(in_math("0.25…1"), r"0.25 \ldots 1");
    }

    #[test]
    fn formulas_have_powers_of_ten_and_words_a_real_minus_sign() {
        assert_eq!(in_math("1.5e-9"), r"1.5 \times 10^{-9}");
        assert_eq!(in_math("1e6"), "10^{6}");
        assert_eq!(in_words("-2.5"), "−2.5");
        assert_eq!(in_words("1.5e-9"), r"$1.5 \times 10^{-9}$");
    }
}
