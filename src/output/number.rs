//! How exactly numbers are written in SVG and PDF.
//!
//! A value is rounded to a fixed count of decimals first and then written without needless signs, so equal
//! pictures have equal bytes: no `-0`, no trailing zeros, no exponent.

/// Appends `value` rounded to hundredths: at twice the size, a fiftieth of a pixel, which no eye sees.
///
/// A place to tenths would be a fifth of a pixel off at that size, which is seen where lines should meet, and
/// save 0.6 % of the bytes of the article's eight figures; one to thousandths would cost 0.5 %.
pub(super) fn push(out: &mut String, value: f64) {
    rounded(out, value, 2);
}

/// Appends `value` rounded to millionths, for factors.
pub(super) fn push_factor(out: &mut String, value: f64) {
    rounded(out, value, 6);
}

/// Text of a value, rounded to hundredths.
pub(super) fn text(value: f64) -> String {
    let mut out = String::new();
    push(&mut out, value);
    out
}

/// Whether two values are written alike when they are rounded to hundredths.
pub(super) fn written_alike(a: f64, b: f64) -> bool {
    (100.0 * a).round() == (100.0 * b).round()
}

/// Appends a number of path data: a separator only where the number before would swallow it.
pub(super) fn push_coordinate(out: &mut String, value: f64) {
    let at = out.len();
    push(out, value);
    let joins = |byte: u8| byte.is_ascii_digit() || byte == b'.';
    let bytes = out.as_bytes();
    if at > 0 && joins(bytes[at - 1]) && joins(bytes[at]) {
        out.insert(at, ' ');
    }
}

/// Rounds a value to hundredths, for a writer that takes single-precision numbers.
///
/// It writes the fewest digits that tell such numbers apart, which are those of the hundredths up to 10⁵.
pub(super) fn hundredths(value: f64) -> f32 {
    single((100.0 * value).round() / 100.0)
}

/// Rounds a factor to millionths, for a writer that takes single-precision numbers.
///
/// Less than ten millionths become zero: the writer would give them an exponent, which PDF does not know.
pub(super) fn millionths(value: f64) -> f32 {
    if value.abs() < 1e-5 { 0.0 } else { single((1e6 * value).round() / 1e6) }
}

/// The nearest single-precision number.
#[expect(clippy::cast_possible_truncation, reason = "the nearest single is meant")]
fn single(value: f64) -> f32 {
    value as f32
}

/// Appends `value` rounded to that many decimals.
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates; drawings are checked to be far smaller")]
fn rounded(out: &mut String, value: f64, decimals: u32) {
    let unit = 10_i64.pow(decimals);
    #[expect(clippy::cast_precision_loss, reason = "a power of ten up to 10⁶ is exact")]
    let scaled = (value * unit as f64).round() as i64;
    let magnitude = scaled.unsigned_abs();
    let (whole, mut fraction) = (magnitude / unit.unsigned_abs(), magnitude % unit.unsigned_abs());
    let mut digits = Digits::new();
    for _ in 0..decimals {
        // No zeros at the end.
        if fraction % 10 > 0 || !digits.is_empty() {
            digits.before(b'0' + (fraction % 10) as u8);
        }
        fraction /= 10;
    }
    if !digits.is_empty() {
        digits.before(b'.');
    }
    if whole > 0 || magnitude == 0 {
        digits.integer(whole);
    }
    if scaled < 0 {
        digits.before(b'-');
    }
    out.push_str(digits.text());
}

/// Writes a whole number in digits.
pub(super) fn push_integer(out: &mut String, value: u64) {
    let mut digits = Digits::new();
    digits.integer(value);
    out.push_str(digits.text());
}

/// The characters of a number, from its last to its first: it is appended at once.
struct Digits {
    /// The characters, at the end.
    bytes: [u8; 32],
    /// Where they begin.
    from: usize,
}

impl Digits {
    /// None yet. The longest number has a sign, twenty digits and a point.
    fn new() -> Self {
        Self { bytes: [0; 32], from: 32 }
    }

    /// Puts a character of ASCII before the others.
    fn before(&mut self, byte: u8) {
        self.from -= 1;
        self.bytes[self.from] = byte;
    }

    /// Puts a whole number before them.
    fn integer(&mut self, mut value: u64) {
        loop {
            self.before(b'0' + (value % 10) as u8);
            value /= 10;
            if value == 0 {
                break;
            }
        }
    }

    /// Whether there is none.
    fn is_empty(&self) -> bool {
        self.from == self.bytes.len()
    }

    /// All of them.
    fn text(&self) -> &str {
        std::str::from_utf8(&self.bytes[self.from..]).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_have_no_negative_zero() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-0.004, "0"),
            (0.5, ".5"),
            (-0.25, "-.25"),
            (12.0, "12"),
            (12.305, "12.31"),
            (1.05, "1.05"),
            (100.999, "101"),
            (-7.1, "-7.1"),
            (1_234_567.891, "1234567.89"),
        ] {
            assert_eq!(text(value), expected, "{value}");
        }
        let mut factor = String::new();
        push_factor(&mut factor, 0.0098);
        assert_eq!(factor, ".0098");
    }

    #[test]
    fn single_precision_keeps_what_is_written_on_any_page() {
        for value in [0.01, -0.29, 1234.56, 4095.99, 65_535.99, -0.004] {
            let (single, mut written) = (hundredths(value).to_string(), String::new());
            push(&mut written, value);
            let expected: f64 = written.parse().unwrap();
            assert_eq!(single.parse::<f64>().unwrap(), expected, "{value}");
        }
        assert_eq!((millionths(0.000_012_4), millionths(9.9e-6)), (0.000_012, 0.0));
    }

    #[test]
    fn coordinates_stay_apart() {
        let mut out = String::from("M");
        for value in [1.5, 0.25, -3.0, 4.0] {
            push_coordinate(&mut out, value);
        }
        assert_eq!(out, "M1.5 .25-3 4");
    }
}
