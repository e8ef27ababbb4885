//! The coordinates of a point as a reader computes with them: `(2, −1.25)`.
//!
//! They are written as fine as the picture shows places, to a page pixel, or whole where that takes two
//! decimals more, and in the panel's space, so that a grid and the numbers of the axes say the same.

use crate::figure::context::Context;
use crate::figure::sketch::Sketch;
use crate::figure::text::{exponent, in_math};
use crate::geometry::{DVec2, read};

use super::ruler::whole;

/// How fine a coordinate is written, page pixels.
const FINE: f64 = 1.0;
/// How many decimal places more a coordinate may have that is written whole.
const WHOLE: usize = 2;
/// By how much a coordinate may be beside a whole one that is written for it, parts of what is fine.
const NOTHING: f64 = 1e-6;
/// Decimal exponents within which a coordinate is written without a power of ten.
const PLAIN: std::ops::RangeInclusive<i32> = -3..=5;
/// The largest where a page pixel is less than [`COARSE`]: 1000002.5 is sooner read than it with a power.
const FAR: i32 = 11;
/// The exponent of a page pixel from which on what is shown has a power of ten itself.
const COARSE: i32 = 3;

/// The coordinates of a point of the world (or of configuration space) in the panel's space, as markup.
pub(super) fn coordinates(sketch: &Sketch, context: &Context, p: DVec2) -> String {
    let (p, fine) = (context.in_space(p), sketch.px(FINE));
    format!("$({}, {})$", coordinate(p.x, fine), coordinate(p.y, fine))
}

/// A coordinate as LaTeX, no coarser than `fine` and with as many digits as that takes.
fn coordinate(x: f64, fine: f64) -> String {
    let last = exponent(fine);
    let size = exponent(x);
    if x == 0.0 || size < last {
        return "0".to_owned();
    }
    let plain = *PLAIN.start()..=if last < COARSE { FAR } else { *PLAIN.end() };
    if !plain.contains(&size) {
        let digits = whole(f64::from(size - last).clamp(0.0, 12.0));
        let text = format!("{x:.digits$e}");
        let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
        return in_math(&format!("{}e{power}", without_zeros(mantissa)));
    }
    let places = whole(f64::from(-last).clamp(0.0, 12.0));
    let all = x.to_string();
    if all.split_once('.').is_none_or(|(_, decimals)| decimals.len() <= places + WHOLE) {
        return all;
    }
    let text = format!("{x:.places$}");
    let short = without_zeros(&text);
    // Zeros say that digits were cut: 3.0018 is 3.00, and 3 only what computing has left beside a 3.
    let exact = read(short).is_some_and(|short| (x - short).abs() <= fine * NOTHING);
    if exact { short.to_owned() } else { text }
}

/// Decimals without zeros at their end.
fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_is_as_fine_as_the_picture() {
        let cases = [
            (2.0, 0.01, "2"),
            (-1.25, 0.01, "-1.25"),
            (std::f64::consts::PI, 0.01, "3.14"),
            (0.0625, 0.01, "0.0625"),
            (1234.5, 0.06, "1234.5"),
            (1e-17, 0.01, "0"),
            (-1e-17, 0.01, "0"),
            (-0.004_321, 0.01, "0"),
            (3.001_84, 0.01, "3.00"),
            (-2.498_61, 0.01, "-2.50"),
            (3.000_000_000_4, 0.01, "3"),
            (0.1 + 0.2, 0.01, "0.3"),
            (1e9, 0.01, "1000000000"),
            (1_000_000_001.25, 0.01, "1000000001.25"),
            (1.25e9, 1e4, r"1.25 \times 10^{9}"),
            (2.5e-6, 1e-8, r"2.5 \times 10^{-6}"),
            (1e300, 1e-300, "10^{300}"),
        ];
        for (x, fine, text) in cases {
            assert_eq!(coordinate(x, fine), text, "{x} to {fine}");
        }
    }
}
