//! How numbers and signs of a story are written: for a terminal, where they can be copied into a program; for
//! who reads a figure, with the signs that it has.

use crate::geometry::read;

/// Significant digits of the numbers: a reader compares the first three, and a step of 1e-6 still shows.
const DIGITS: usize = 6;
/// Digits in all of a number in a title or a picture that has more than [`WHOLE`].
pub(crate) const USUAL: usize = 3;
/// Most digits in all with which a number is written whole there: with three, a width of 261 has a half of
/// 130, and a place at 1234 stands at 1230. More than five are no longer read at a glance.
pub(crate) const WHOLE: usize = 5;
/// Digits in all by which a number is told to be whole: what computing it may have added is below them.
pub(crate) const TOLD: usize = 10;

/// For whom a story is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hand {
    /// For a terminal: `-1.5e-9`.
    Terminal,
    /// For readers of words: `−1.5 × 10^−9`.
    Words,
    /// For titles: with the digits that pictures have.
    Title,
    /// For a page on which letters have scripts: [`script`](super::words::script) stands for a body.
    Type,
}

impl Hand {
    /// A number as people write it, that was written for a terminal.
    pub(super) fn written(number: &str) -> String {
        let number = number.replace('-', "−");
        match number.split_once('e') {
            Some(("1", exponent)) => format!("10^{exponent}"),
            Some((mantissa, exponent)) => format!("{mantissa} × 10^{exponent}"),
            None => number,
        }
    }
}

/// A number to [`DIGITS`] significant digits, without trailing zeros; with an exponent where it is very large
/// or small.
pub(super) fn number(x: f64) -> String {
    to_digits(x, DIGITS)
}

/// A number as pictures have it: with all digits where they are few, else to three.
pub(super) fn short(x: f64) -> String {
    let [all, told] = [WHOLE, TOLD].map(|digits| to_digits(x, digits));
    if all == told { all } else { to_digits(x, USUAL) }
}

/// A number to so many significant digits.
fn to_digits(x: f64, digits: usize) -> String {
    let written = format!("{:.*e}", digits - 1, x);
    let Some(rounded) = read(&written) else { return written };
    if rounded == 0.0 {
        return "0".to_owned();
    }
    if (1e-4..1e7).contains(&rounded.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_six_digits_and_no_zeros() {
        let cases = [
            (1.0 / 3.0, "0.333333"),
            (-0.0, "0"),
            (2.5, "2.5"),
            (1e-9, "1e-9"),
            (123_456_789.0, "1.23457e8"),
        ];
        for (x, expected) in cases {
            assert_eq!(number(x), expected);
        }
    }

    #[test]
    fn a_title_has_five_digits_where_these_are_all_and_else_three() {
        for (x, expected) in [(1.234_5, "1.2345"), (2.165_06, "2.17"), (0.1 + 0.2, "0.3"), (1e-9, "1e-9")] {
            assert_eq!(short(x), expected);
        }
    }

    #[test]
    fn readers_have_real_minus_signs_and_powers_of_ten() {
        for (number, expected) in [("-2.5", "−2.5"), ("1e-9", "10^−9"), ("-4.5e-13", "−4.5 × 10^−13")]
        {
            assert_eq!(Hand::written(number), expected);
        }
    }
}
