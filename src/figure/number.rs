//! How a number is said in a figure: 3 significant digits at most, as text that is also LaTeX maths.

/// Significant digits of a number in a figure. More than a reader can take in at a glance is noise.
const DIGITS: usize = 3;

/// Magnitudes below 10 to this power, and from [`LARGE`] on, are said with a power of ten.
const SMALL: i32 = -4;

/// See [`SMALL`].
const LARGE: i32 = 6;

/// A number with at most 3 significant digits, without trailing zeros; very large and very small ones with a power of
/// ten in LaTeX, so that the text belongs between dollar signs.
///
/// ```
/// use tracefig::figure::number;
/// assert_eq!(number(0.308_487), "0.308");
/// assert_eq!(number(-2.499_999_999_999_999_6), "-2.5");
/// assert_eq!(number(11.5), "11.5");
/// assert_eq!(number(-0.0), "0");
/// assert_eq!(number(1.09e-9), r"1.09 \times 10^{-9}");
/// ```
#[must_use]
pub fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    // `1.09e-9`: rounded once, by the formatter, in decimal.
    let scientific = format!("{x:.*e}", DIGITS - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let Ok(power) = exponent.parse::<i32>() else { return scientific };
    if (SMALL..LARGE).contains(&power) {
        let decimals = usize::try_from(DIGITS as i32 - 1 - power).unwrap_or(0);
        let rounded: f64 = scientific.parse().unwrap_or(x);
        trimmed(&format!("{rounded:.decimals$}"))
    } else {
        format!(r"{} \times 10^{{{power}}}", trimmed(mantissa))
    }
}

/// Without zeros at the end of the decimals.
fn trimmed(text: &str) -> String {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn a_number_is_rounded_to_three_digits_wherever_its_point_is() {
        let said = [
            (4.293_51, "4.29"),
            (60.0, "60"),
            (0.625, "0.625"),
            (0.791_532, "0.792"),
            (1234.5, "1230"),
            (0.000_999_96, "0.001"),
        ];
        for (x, text) in said {
            assert_eq!(number(x), text);
        }
    }

    #[test]
    fn the_last_digit_is_rounded_and_not_cut() {
        assert_eq!(number(9.996), "10");
        assert_eq!(number(-0.066_66), "-0.0667");
    }
}
