//! Numbers as text: three significant digits, or all where they are few, and no more than the bounds allow.

use super::digits::Digits;
use crate::geometry::{power_of_ten, read};

/// The digits of a number on a figure where nobody asks for others.
pub(crate) const USUAL: Digits = Digits::Usual;

/// The digits of a number that has many, in every case.
const THREE: Digits = Digits::Significant(TOLD);

/// The part of a number that rounding may have added to it in a few operations.
const ROUNDING: f64 = 1e-14;

/// Digits that terms and their result are given at most, until they add up as they are written: each digit
/// more does for three sums of four.
const MORE: usize = 6;

/// Digits that a picture has of a number that has many.
const TOLD: usize = 3;

/// Half a unit of the last digit, within which what is left of a sum rounds to what is written.
const HALF: f64 = 0.5;

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

/// A number that is not less than the one given, and that to three digits is what that one is: of an upper
/// bound beside a picture that has the number itself. It has as few digits as that takes, from three on.
#[must_use]
pub(crate) fn rounded_up_beside(value: f64) -> String {
    let written = THREE.of(value, value);
    let all =
        [USUAL, Digits::Significant(TOLD + 1), Digits::Significant(TOLD + 2), Digits::Significant(MORE)];
    for digits in all {
        let text = digits.at_least(value);
        if read(&text).is_some_and(|n| THREE.of(n, n) == written) {
            return text;
        }
    }
    rounded_up(value)
}

/// A number to three digits that is not more than the one given: of a lower bound.
#[must_use]
pub(crate) fn rounded_down(value: f64) -> String {
    USUAL.at_most(value)
}

/// A lower bound as LaTeX, to three digits in every case: in a picture, what is bounded is not beside it.
#[must_use]
pub(crate) fn least(value: f64) -> String {
    bound(value, &rounded_down(value), &THREE.at_most(value))
}

/// An upper bound as LaTeX, as [`least`] has a lower one.
#[must_use]
pub(crate) fn most(value: f64) -> String {
    bound(value, &rounded_up(value), &THREE.at_least(value))
}

/// What a bound is written as where that has few digits, else as `short`.
fn bound(value: f64, usual: &str, short: &str) -> String {
    in_math(if usual == rounded(value, value) { usual } else { short })
}

/// A double as LaTeX, as [`rounded`] has it.
#[must_use]
pub(crate) fn number(value: f64) -> String {
    in_math(&rounded(value, value))
}

/// The terms of a difference of two numbers, or of a sum, and its result, as LaTeX: to the last digit of the
/// result, and of each other where one is short, or to more digits, so that who takes one from the other as
/// they are written has the result as it is written. What is short is written as anywhere else.
#[must_use]
pub(crate) fn terms(terms: [f64; 2], result: f64) -> ([String; 2], String) {
    let sum = Sum::of(&terms, result);
    let own = (0..2).filter(|&i| sum.short[i]).map(|i| after_point(&sum.texts[i])).max();
    let fewest = after_point(&sum.texts[2]).max(own.unwrap_or(0));
    let mut first = sum.to_decimals(fewest);
    first[2].clone_from(&sum.texts[2]);
    let [p, q, result] = [0, 1, 2].map({
        let written = sum.written(first, fewest);
        move |i| written[i].clone()
    });
    ([p, q], result)
}

/// The terms of a sum and its result as LaTeX, each as anywhere else; or all to as many digits after the
/// point, so that who adds them up as they are written has the result as it is written.
#[must_use]
pub(crate) fn parts(parts: &[f64], result: f64) -> (Vec<String>, String) {
    let sum = Sum::of(parts, result);
    let fewest = sum.texts.iter().map(|text| after_point(text)).max().unwrap_or(0);
    let mut written = sum.written(sum.texts.clone(), fewest);
    let result = written.pop().unwrap_or_default();
    (written, result)
}

/// A length and its parts as LaTeX, whose rest is written elsewhere: each as anywhere else, or all to as many
/// digits after the point, so that who takes the parts from the whole as they are written has the rest as it
/// is written.
#[must_use]
pub(crate) fn whole_and_parts(whole: f64, parts: &[f64], rest: f64) -> Vec<String> {
    let all: Vec<f64> = [whole].iter().chain(parts).copied().collect();
    let sum = Sum::of(&all, rest);
    let fewest = sum.texts.iter().map(|text| after_point(text)).max().unwrap_or(0);
    let unit = power_of_ten(-f64::from(u32::try_from(fewest).unwrap_or(u32::MAX)));
    // A rest that is written whole is exactly what is left.
    let within = if sum.short.last() == Some(&true) { 0.0 } else { HALF * unit };
    let rest = sum.texts.last().and_then(|text| read(text)).unwrap_or(rest);
    let mut written = sum.written_until(sum.texts.clone(), fewest, |texts| {
        let numbers: Vec<f64> = texts.iter().take(all.len()).filter_map(|text| read(text)).collect();
        let left = numbers.first().unwrap_or(&whole) - numbers.iter().skip(1).sum::<f64>();
        (left - rest).abs() <= within + ROUNDING * whole.abs()
    });
    written.truncate(all.len());
    written
}

/// A bound, a number that is part of it, and the bound of the rest: bounds no smaller than they are, to as
/// many digits after the point as the first one has, or more, so that the two parts add up to it as they are
/// written; `None` where [`MORE`] digits do not.
#[must_use]
pub(crate) fn bound_and_parts(bound: f64, part: f64, rest: f64) -> Option<[String; 3]> {
    let usual = [USUAL.at_least(bound), USUAL.of(part, part), USUAL.at_least(rest)];
    if usual.iter().any(|text| text.contains('e')) {
        return None;
    }
    // Where a picture has the rest rounded, that is a rounding of this one too.
    let drawn = USUAL.of(rest, rest);
    let half = HALF * power_of_ten(-f64::from(u32::try_from(after_point(&drawn)).unwrap_or(u32::MAX)));
    let is_drawn = |q: f64| read(&drawn).is_some_and(|drawn| (q - drawn).abs() <= half + ROUNDING * q);
    let fewest = after_point(&usual[0]);
    (fewest..=fewest + MORE).map(Digits::Decimals).find_map(|digits| {
        let [p, q] = [digits.of(part, part), digits.at_least(rest)];
        let [part, rest] = [&p, &q].map(|text| read(text).unwrap_or(f64::NAN));
        let sum = part + rest;
        let holds = sum >= bound * (1.0 - ROUNDING) && is_drawn(rest);
        holds.then(|| [digits.of(sum, sum), p, q].map(without_zeros))
    })
}

/// A number without zeros at its end, behind the point.
fn without_zeros(text: String) -> String {
    if !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Digits of a text after its point.
fn after_point(text: &str) -> usize {
    text.split_once('.').map_or(0, |(_, decimals)| decimals.len())
}

/// Terms and their result, the last, to be written so that they add up.
struct Sum {
    /// The numbers.
    values: Vec<f64>,
    /// Each as anywhere else.
    texts: Vec<String>,
    /// Whether that is all of it.
    short: Vec<bool>,
}

impl Sum {
    fn of(terms: &[f64], result: f64) -> Self {
        let values: Vec<f64> = terms.iter().copied().chain([result]).collect();
        let texts: Vec<String> = values.iter().map(|&x| rounded(x, x)).collect();
        let is_short = |(text, x): (&String, &f64)| {
            read(text).is_some_and(|written| (written - x).abs() <= ROUNDING * x.abs())
        };
        let short = texts.iter().zip(&values).map(is_short).collect();
        Self { values, texts, short }
    }

    /// What is not short to as many digits after the point.
    fn to_decimals(&self, decimals: usize) -> Vec<String> {
        let digits = Digits::Decimals(decimals);
        let text = |i: usize| {
            let x = self.values[i];
            if self.short[i] { self.texts[i].clone() } else { digits.of(x, x) }
        };
        (0..self.values.len()).map(text).collect()
    }

    /// What is written, as LaTeX: the first try, or the one with the fewest digits, from so many after the
    /// point, that adds up; as anywhere else where one has a power of ten.
    fn written(&self, first: Vec<String>, fewest: usize) -> Vec<String> {
        self.written_until(first, fewest, |texts| self.adds_up(texts))
    }

    /// What is written until it is `right`.
    fn written_until(
        &self,
        first: Vec<String>,
        fewest: usize,
        is_right: impl Fn(&[String]) -> bool,
    ) -> Vec<String> {
        let latex = |texts: &[String]| texts.iter().map(|text| in_math(text)).collect();
        if self.texts.iter().any(|text| text.contains('e')) {
            return latex(&self.texts);
        }
        let more = (fewest..=fewest + MORE).map(|decimals| self.to_decimals(decimals));
        let found = std::iter::once(first.clone()).chain(more).find(|texts| is_right(texts));
        latex(&found.unwrap_or(first))
    }

    /// Whether terms and their result are as they are written those of a sum; of a difference, where that is
    /// what the numbers make.
    fn adds_up(&self, texts: &[String]) -> bool {
        let written: Vec<f64> = texts.iter().filter_map(|text| read(text)).collect();
        let off = |numbers: &[f64], is_difference: bool| match *numbers {
            [p, q, result] if is_difference => ((p - q).abs() - result.abs()).abs(),
            [ref terms @ .., result] => (terms.iter().sum::<f64>().abs() - result.abs()).abs(),
            [] => 0.0,
        };
        let is_difference = off(&self.values, true) < off(&self.values, false);
        let size = self.values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        off(&written, is_difference) <= ROUNDING * size
    }
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
            (9.999_123, "10.0", "9.999"),
            (0.1 + 0.2, "0.3", "0.3"),
            (0.300_001, "0.301", "0.300"),
            (-6.20244, "-6.20", "-6.21"),
            (0.0, "0", "0"),
            (1.234_567e9, "1.235e9", "1.23e9"),
        ] {
            assert_eq!((rounded_up(value).as_str(), rounded_down(value).as_str()), (up, down), "{value}");
        }
        assert_eq!(rounded_up(f64::MAX), "1.80e308");
        for (value, up) in
            [(3.423_031_234, "3.424"), (3.424_991_234, "3.425"), (3.419_912_345, "3.42"), (2.5, "2.5")]
        {
            assert_eq!(rounded_up_beside(value), up);
        }
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
    fn a_bound_in_a_picture_is_a_bound_as_it_is_written() {
        for (value, down, up) in [
            (1.388_73, "1.38", "1.39"),
            (2.236_07, "2.23", "2.24"),
            (2.6, "2.6", "2.6"),
            (0.361, "0.361", "0.361"),
            (0.361_543, "0.361", "0.362"),
            (0.0, "0", "0"),
        ] {
            assert_eq!([least(value), most(value)], [down, up], "{value}");
        }
    }

    #[test]
    fn a_sum_comes_out_as_it_is_written() {
        for (of, sum, shown) in [
            ([2.956_91, 2.859_91], 0.097, ["2.957", "2.860", "0.097"]),
            ([1.634_234, 0.164_123], 1.470_111, ["1.63", "0.16", "1.47"]),
            ([2.5, 0.5], 2.0, ["2.5", "0.5", "2"]),
            ([3.0, 1.0], 2.0, ["3", "1", "2"]),
            ([2.5, 0.123_456], 2.376_544, ["2.5", "0.12", "2.38"]),
            ([1e-7, 0.0], 1e-7, ["10^{-7}", "0", "10^{-7}"]),
            ([4.0, -2.25], 6.25, ["4", "-2.25", "6.25"]),
            // To three digits the difference would be 0.110.
            ([2.146_823_4, 2.037_411_1], 0.109_412_3, ["2.1468", "2.0374", "0.1094"]),
        ] {
            let ([p, q], result) = terms(of, sum);
            assert_eq!([p, q, result], shown, "{of:?}");
        }
        // To three digits the terms make 4.65 or 4.66, and 9.706 beside 9.71.
        for (of, sum, shown) in [
            (vec![3.155_12, 1.495_01], 4.650_13, ["3.155", "1.495", "4.650"].as_slice()),
            (vec![6.0, 3.0, 0.706_412], 9.706_412, ["6", "3", "0.706", "9.706"].as_slice()),
            (vec![6.0, 3.0], 9.0, ["6", "3", "9"].as_slice()),
            (vec![6.123_456], 6.123_456, ["6.12", "6.12"].as_slice()),
        ] {
            let (mut all, result) = parts(&of, sum);
            all.push(result);
            assert_eq!(all, shown, "{of:?}");
        }
    }

    #[test]
    fn what_is_taken_from_a_whole_leaves_the_rest_that_is_written_elsewhere() {
        for (whole, of, rest, shown) in [
            (700.006_43, vec![696.0, 2.44], 1.566_43, ["700.01", "696", "2.44"].as_slice()),
            (8.0, vec![5.0, 2.0], 1.0, ["8", "5", "2"].as_slice()),
            (4.668_8, vec![2.334_4, 2.334_4], 0.0, ["4.6688", "2.3344", "2.3344"].as_slice()),
            (1000.003, vec![500.001, 700.004], -200.002, ["1000", "500", "700"].as_slice()),
            (3.0, vec![3.0], 1e-9, ["3", "3"].as_slice()),
        ] {
            assert_eq!(whole_and_parts(whole, &of, rest), shown, "{whole}");
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
        // Both ends hold the number, whichever ones are nearer.
        assert_eq!(rounded(0.805_526_25, 0.825_526_25), "0.805…0.826");
        assert_eq!(rounded(-0.825_526_25, -0.805_526_25), "-0.826…-0.805");
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
