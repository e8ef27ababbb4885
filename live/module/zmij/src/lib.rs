//! What `serde_json` writes numbers with, under the name that it asks for: the shortest decimals that are
//! read as the same double, written as the crate of that name does.
//!
//! The standard library finds them too, and the module has that already; the tables of the other are 6 kB, of
//! which nothing packs. It is the faster, which a page with some hundred numbers does not see.

use std::fmt::LowerExp;

/// The least power of ten that is written as such.
const PLAIN: i32 = 16;
/// The least that is not.
const SMALL: i32 = -5;

/// Digits with which a number that lies in the middle between two of 16 is written out.
const EXACT: usize = 30;

/// Room for a number.
#[derive(Default)]
pub struct Buffer(String);

/// `f32` and `f64`.
pub trait Float: LowerExp + Copy + Into<f64> {
    /// Digits that a number has at least which lies in the middle between two of so many: from two of fewer it
    /// is told apart.
    const MIDDLE: usize;
}
impl Float for f32 {
    const MIDDLE: usize = 7;
}
impl Float for f64 {
    const MIDDLE: usize = 16;
}

impl Buffer {
    /// An empty one.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A number, or `NaN`, `inf` and `-inf`.
    pub fn format<F: Float>(&mut self, value: F) -> &str {
        self.format_finite(value)
    }

    /// A finite number: `1.0`, `0.25`, `1e+16`, `1.5e-7`.
    pub fn format_finite<F: Float>(&mut self, value: F) -> &str {
        self.0 = to_even(format!("{value:e}"), value);
        if let Some((mantissa, exponent)) = self.0.split_once('e') {
            let exponent: i32 = exponent.parse().unwrap_or(0);
            self.0 = match exponent {
                SMALL..PLAIN => plain(mantissa, exponent),
                0.. => format!("{mantissa}e+{exponent}"),
                _ => return &self.0,
            };
        }
        &self.0
    }
}

/// Of two shortest decimals that are as near the even one, as the standard library takes the larger one.
/// All digits are written out where it may be so, as that takes ten times as long.
fn to_even<F: Float>(shortest: String, value: F) -> String {
    let Some((mantissa, power)) = shortest.split_once('e') else { return shortest };
    let is_odd = mantissa.ends_with(['1', '3', '5', '7', '9']);
    // A point is between them.
    let digits = mantissa.trim_start_matches('-').len();
    if !is_odd || !mantissa.contains('.') || digits <= F::MIDDLE {
        return shortest;
    }
    // In the middle it has one decimal more than these digits, and doubled as often it is whole.
    let decimals = i32::try_from(digits).unwrap_or(0) - 1 - power.parse::<i32>().unwrap_or(0);
    let scaled = value.into() * 2f64.powi(decimals);
    if scaled != scaled.trunc() {
        return shortest;
    }
    let exact = format!("{value:.EXACT$e}");
    let beyond = exact.get(mantissa.len()..).and_then(|rest| rest.strip_prefix('5'));
    let is_middle = beyond.is_some_and(|rest| rest.trim_start_matches('0').starts_with('e'));
    if is_middle {
        return format!("{}e{power}", &exact[..mantissa.len()]);
    }
    shortest
}

/// `1.25` times 10 to a power, with a point and without the power.
fn plain(mantissa: &str, exponent: i32) -> String {
    let (sign, mantissa) = mantissa.strip_prefix('-').map_or(("", mantissa), |rest| ("-", rest));
    let digits: String = mantissa.chars().filter(|&c| c != '.').collect();
    let zeros = |count: i32| "0".repeat(usize::try_from(count).unwrap_or(0));
    let Ok(before) = usize::try_from(exponent + 1) else {
        return format!("{sign}0.{}{digits}", zeros(-exponent - 1));
    };
    match digits.split_at_checked(before) {
        _ if before == 0 => format!("{sign}0.{digits}"),
        Some((whole, "")) => format!("{sign}{whole}.0"),
        Some((whole, rest)) => format!("{sign}{whole}.{rest}"),
        None => {
            let missing = exponent + 1 - i32::try_from(digits.len()).unwrap_or(0);
            format!("{sign}{digits}{}.0", zeros(missing))
        }
    }
}
