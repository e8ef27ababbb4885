//! Numbers with a power of ten, written without it.

/// A number without its power of ten: its point moved.
pub(super) fn plain(mantissa: &str, exponent: i32) -> String {
    let (sign, mantissa) = mantissa.strip_prefix('-').map_or(("", mantissa), |digits| ("-", digits));
    let (before, after) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let Ok(moved) = usize::try_from(exponent) else {
        let zeros = usize::try_from(-1 - exponent).unwrap_or(0);
        return [sign, "0.", &"0".repeat(zeros), before, after].concat();
    };
    match after.split_at_checked(moved) {
        Some((whole, "")) => [sign, before, whole].concat(),
        Some((whole, part)) => [sign, before, whole, ".", part].concat(),
        None => [sign, before, after, &"0".repeat(moved - after.len())].concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::power_of_ten;

    #[test]
    fn a_moved_point_gives_the_digits_that_the_rounded_number_has() {
        let mut random = oorandom::Rand64::new(6);
        let mut upto = |end: u64| i32::try_from(random.rand_range(0..end)).unwrap();
        for _ in 0..20_000 {
            let (mantissa, digits) = (f64::from(upto(20_000) - 10_000) / 1e4, upto(9));
            let value = 9.9999 * mantissa * power_of_ten(f64::from(upto(18) - 9));
            let scientific = format!("{value:.*e}", usize::try_from(digits).unwrap());
            let (mantissa, exponent) = scientific.split_once('e').unwrap();
            let exponent: i32 = exponent.parse().unwrap();
            let decimals = usize::try_from(digits - exponent).unwrap_or(0);
            let rounded: f64 = scientific.parse().unwrap();
            assert_eq!(plain(mantissa, exponent), format!("{rounded:.decimals$}"), "{scientific}");
        }
    }
}
