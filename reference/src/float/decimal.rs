//! Floats as decimals: read in full precision, written with 25 digits.

use std::fmt;

use super::Float;

impl<const N: usize> Float<N> {
    /// A decimal number as in `-1.25e-3`; None for anything else.
    #[must_use]
    pub fn from_decimal(text: &str) -> Option<Self> {
        let (number, exponent) = match text.split_once(['e', 'E']) {
            Some((number, exponent)) => (number, exponent.parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (negative, digits) = match number.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, number),
        };
        let mut value = Self::ZERO;
        let mut places = exponent;
        let mut after_point = false;
        for c in digits.chars() {
            if c == '.' && !after_point {
                after_point = true;
                continue;
            }
            value = value * Self::from(10.0) + Self::from(f64::from(c.to_digit(10)?));
            places -= i32::from(after_point);
        }
        let mut ten = Self::one();
        for _ in 0..places.unsigned_abs() {
            ten = ten * Self::from(10.0);
        }
        let value = if places < 0 { value.over(ten) } else { value * ten };
        Some(if negative { -value } else { value })
    }
}

impl<const N: usize> fmt::Debug for Float<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<const N: usize> Float<N> {
    /// The number as a decimal with so many significant digits, cut, not rounded.
    #[must_use]
    pub fn to_decimal(self, digits: usize) -> String {
        let Some((all, exponent)) = leading_digits(self, digits) else { return "0".to_owned() };
        format!("{}{}.{}e{exponent}", if self.sign < 0 { "-" } else { "" }, &all[..1], &all[1..])
    }
}

impl<const N: usize> fmt::Display for Float<N> {
    /// 25 significant digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.to_decimal(25))
    }
}

/// A whole number from 0 to 9.
fn digit(x: f64) -> u32 {
    (0..10).find(|k| f64::from(*k) > x - 0.5).unwrap_or(9)
}

/// The first `count` digits and the power of ten of the first of them; None for 0.
fn leading_digits<const N: usize>(x: Float<N>, count: usize) -> Option<(String, i64)> {
    if x.is_zero() {
        return None;
    }
    let (ten, one) = (Float::<N>::from(10.0), Float::<N>::one());
    let (mut rest, mut exponent) = (x.abs(), 0);
    let tenth = ten.recip();
    while rest >= ten {
        rest = rest * tenth;
        exponent += 1;
    }
    while rest < one {
        rest = rest * ten;
        exponent -= 1;
    }
    let mut digits = String::new();
    for _ in 0..count {
        let whole = rest.floor();
        digits.push(char::from_digit(digit(whole.to_f64()), 10).unwrap_or('9'));
        rest = (rest - whole) * ten;
    }
    Some((digits, exponent))
}
