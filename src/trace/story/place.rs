//! How finely a place is told: by the size of what is there, not by the size of the number.
//!
//! Three digits in all are enough for a length. A body of 3 units at x = 501.47 begins, told so, at 501, a
//! sixth of itself beside where it is; at 10⁶ it begins where it ends. So a coordinate has a digit of its
//! bodies' size, and no power of ten which they have not.

use crate::geometry::read;

/// Digits after the point beyond those needed with which a coordinate is told whole: 1000002.125.
const MORE: usize = 1;
/// Digits of a double that are as they were given.
const TOLD: usize = 15;
/// The part of a coordinate by which its text may differ and tell all of it: what computing left there.
const NOTHING: f64 = 1e-9;
/// Units from which on a number may have a power of ten: what is there is then 10⁵ large itself.
const COARSE: f64 = 1e3;

/// A coordinate as `text` has it, where that is no coarser than `unit`; else with so many digits after the
/// point. A minus is a hyphen.
#[must_use]
pub(crate) fn place(x: f64, text: String, unit: f64) -> String {
    let Some(written) = read(&text) else { return text };
    let needed = decimals(unit);
    let off = (written - x).abs();
    let is_whole = off <= NOTHING * unit;
    let is_fine = is_whole || off <= unit && (text.contains('e') || after_point(&text) >= needed);
    let is_plain = !text.contains('e') || x.abs() < 1.0 || unit >= COARSE;
    if is_fine && is_plain {
        return text;
    }
    let all = x.to_string();
    let before_point = all.trim_start_matches('-').split('.').next().map_or(1, str::len);
    if before_point > TOLD {
        return text;
    }
    let told = TOLD - before_point;
    if after_point(&all) <= (needed + MORE).min(told) {
        return all;
    }
    let places = needed.min(told);
    format!("{x:.places$}")
}

/// The fewest digits after the point whose unit is no coarser than the one given.
fn decimals(unit: f64) -> usize {
    (0..TOLD).find(|&k| (0..k).fold(1.0, |fine, _| fine / 10.0) <= unit).unwrap_or(TOLD)
}

/// Digits of a number after its point.
fn after_point(text: &str) -> usize {
    text.split_once('.').map_or(0, |(_, decimals)| decimals.len())
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn a_coordinate_is_as_fine_as_what_is_there() {
        for (x, text, unit, told) in [
            (501.47, "501", 0.03, "501.47"),
            (103.773_5, "104", 0.046, "103.77"),
            (99.113_5, "99.1", 0.046, "99.11"),
            (4.293_51, "4.29", 0.03, "4.29"),
            (1_000_002.5, "1.00e6", 0.025, "1000002.5"),
            (1e6, "1e6", 0.025, "1000000"),
            (-1_000_002.123_456, "-1.00e6", 0.025, "-1000002.12"),
            (16_777_216.7, "1.68e7", 0.01, "16777216.7"),
            (2.000_001_5, "2.00", 1e-8, "2.0000015"),
            (1.5e-6, "1.5e-6", 0.01, "1.5e-6"),
            (1.234_5e9, "1.23e9", 1e7, "1.23e9"),
            (6_371.068_1, "6371", 0.01, "6371.07"),
            (1e300, "1e300", 0.01, "1e300"),
            (0.3 + 1e-13, "0.3", 0.001, "0.3"),
            (12.0, "12", f64::INFINITY, "12"),
        ] {
            assert_eq!(place(x, text.to_owned(), unit), told, "{x} to {unit}");
        }
    }
}
