//! Round marks along an axis: where a grid has its lines and an axis its numbers.
//!
//! ```text
//! marks k · step,  step = m · 10ᵉ with m = 1, 2 or 5, the least that is long enough to be told apart
//! ```
//!
//! Numbers far from 0, very large and very small ones would be long and alike. What they share is written
//! once, at the end of the axis: 3 with × 10⁻⁶ + 10⁹ stands for 1000000000.000003.

use crate::figure::text::{decimal, exponent, in_math, round_up};

/// The least distance of marks where the scene does not say, page pixels: a number and its room.
const LEAST: f64 = 24.0;
/// The least distance of marks at a step that the scene gives, page pixels: closer ones are a grey area.
const CLOSEST: f64 = 6.0;
/// The largest whole number up to which every one is a double: 2⁵³.
const WHOLE: f64 = 9_007_199_254_740_992.0;
/// How many times what is shown its distance from 0 may be, before numbers are counted from elsewhere.
const FAR: f64 = 1e4;
/// Sizes of the largest number within which it is written without a power of ten.
const PLAIN: std::ops::Range<f64> = 0.01..1e6;
/// The most letters of a number from which others are counted; a longer one has a power of ten.
const LONG: usize = 9;
/// Decimal places of a number beyond those of the step's first digit: a step of 0.0625 shows them all.
const FINE: f64 = 3.0;

/// The marks of an axis within what a panel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ruler {
    /// From one mark to the next, in units of the space.
    step: f64,
    /// The number of the first mark that is in view: it lies at this many steps.
    first: f64,
    /// The number of the last mark that is in view.
    last: f64,
}

/// What the numbers of an axis share: each is written as (value − base) / 10^power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shared {
    /// From where is counted, in units of the space.
    base: f64,
    /// The power of ten of all numbers.
    power: i32,
}

impl Ruler {
    /// The marks from `lo` to `hi`; `step` is the scene's, and `px` the length of a page pixel in the space.
    /// Where the scene's marks would be too close, every second, fifth or tenth stands. `None` where no
    /// doubles lie as close as the marks would.
    pub(super) fn of([lo, hi]: [f64; 2], step: Option<f64>, px: f64) -> Option<Self> {
        let step = match step {
            Some(step) if CLOSEST * px <= step => step,
            Some(step) => step * round_up(CLOSEST * px / step)?,
            None => round_up(LEAST * px)?,
        };
        let (first, last) = ((lo / step).ceil(), (hi / step).floor());
        (first.abs() < WHOLE && last.abs() < WHOLE).then_some(Self { step, first, last })
    }

    /// The marks in view, in units of the space, each with its number.
    pub(super) fn marks(self) -> impl Iterator<Item = (f64, f64)> {
        let marks = std::iter::successors(Some(self.first), |k| Some(k + 1.0));
        marks.take_while(move |&k| k <= self.last).map(move |k| (k, k * self.step))
    }

    /// What the numbers of the marks share.
    pub(super) fn shared(self) -> Shared {
        let (lo, hi) = (self.first * self.step, self.last * self.step);
        let base = base((lo, hi), self.step);
        let largest = (lo - base).abs().max((hi - base).abs());
        let plain = largest == 0.0 || PLAIN.contains(&largest);
        // In thousands, so that both axes mostly have the same.
        Shared { base, power: if plain { 0 } else { exponent(largest).div_euclid(3) * 3 } }
    }

    /// A value as the axis writes it: in decimals as fine as the step.
    pub(super) fn text(self, value: f64, shared: Shared) -> Option<String> {
        let unit = decimal(1, shared.power)?;
        let (value, step) = ((value - shared.base) / unit, self.step / unit);
        let places = (FINE - f64::from(exponent(step))).clamp(0.0, 12.0);
        let text = format!("{value:.*}", whole(places));
        let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        let text = if text == "-0" { "0" } else { text };
        value.is_finite().then(|| text.replace('-', "−"))
    }
}

impl Shared {
    /// What all numbers share, as markup; `None` where they stand for themselves.
    pub(super) fn text(self) -> Option<String> {
        let power = if self.power == 0 { String::new() } else { format!(r"\times 10^{{{}}}", self.power) };
        let plain = self.base.abs().to_string();
        let size = if plain.len() <= LONG { plain } else { in_math(&format!("{:e}", self.base.abs())) };
        let sign = if self.base < 0.0 { "-" } else { "+" };
        let base = if self.base == 0.0 { String::new() } else { format!(r"{sign}\,{size}") };
        let both = format!(r"{power}\,{base}");
        match (self.power, self.base == 0.0) {
            (0, true) => None,
            (_, true) => Some(format!("${power}$")),
            (0, false) => Some(format!("${base}$")),
            (..) => Some(format!("${both}$")),
        }
    }
}

/// From where numbers between `lo` and `hi` are counted: 0, or the roundest number among them where all are
/// far from 0.
fn base((lo, hi): (f64, f64), step: f64) -> f64 {
    let (middle, span) = (0.5 * lo + 0.5 * hi, (hi - lo).max(step));
    if middle.abs() <= FAR * span {
        return 0.0;
    }
    let most = exponent(middle);
    let units = (exponent(step)..=most).rev().filter_map(|e| decimal(1, e));
    let mut rounded = units.map(|unit| (middle / unit).round() * unit);
    rounded.find(|base| (base - middle).abs() <= span).unwrap_or(0.0)
}

/// A small whole number of decimal places.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 12")]
pub(super) fn whole(places: f64) -> usize {
    places as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(range: [f64; 2], step: Option<f64>, px: f64) -> (Vec<String>, Option<String>) {
        let ruler = Ruler::of(range, step, px).unwrap();
        let shared = ruler.shared();
        (ruler.marks().map(|(_, x)| ruler.text(x, shared).unwrap()).collect(), shared.text())
    }

    #[test]
    fn steps_are_round_and_wide_enough() {
        for (px, step) in
            [(1.0 / 24.0, 1.0), (0.0417, 2.0), (0.09, 5.0), (0.3, 10.0), (4e-8, 1e-6), (1e9, 5e10)]
        {
            assert_eq!(Ruler::of([0.0, 1.0], None, px).unwrap().step, step, "{px}");
        }
    }

    #[test]
    fn numbers_have_the_decimals_of_their_step() {
        let (numbers, shared) = texts([-0.35, 0.35], Some(0.1), 0.01);
        assert_eq!(numbers, ["−0.3", "−0.2", "−0.1", "0", "0.1", "0.2", "0.3"]);
        assert_eq!(shared, None);
        assert_eq!(texts([0.0, 0.2], Some(0.0625), 0.001).0, ["0", "0.0625", "0.125", "0.1875"]);
    }

    #[test]
    fn what_large_and_small_numbers_share_is_written_once() {
        let cases = [
            ([-1e9, 2e9], 4e7, vec!["−1", "0", "1", "2"], Some(r"$\times 10^{9}$")),
            ([0.0, 3e-6], 4e-8, vec!["0", "1", "2", "3"], Some(r"$\times 10^{-6}$")),
            ([1e9 - 1.0, 1e9 + 2.0], 0.04, vec!["−1", "0", "1", "2"], Some(r"$+\,10^{9}$")),
            ([0.0, 1.5e10], 3e8, vec!["0", "10"], Some(r"$\times 10^{9}$")),
            ([500_123.0, 500_125.0], 0.04, vec!["−1", "0", "1"], Some(r"$+\,500124$")),
            ([-250.0, 250.0], 5.0, vec!["−200", "0", "200"], None),
        ];
        for (range, px, numbers, shared) in cases {
            let (found, said) = texts(range, None, px);
            assert_eq!((found, said.as_deref()), (numbers.into_iter().map(str::to_owned).collect(), shared));
        }
    }

    #[test]
    fn marks_that_would_be_a_grey_area_are_thinned_and_none_are_where_doubles_are_too_far_apart() {
        assert_eq!(Ruler::of([0.0, 10.0], Some(1e-9), 0.1).unwrap().step, 1.0);
        assert_eq!(Ruler::of([0.0, 10.0], Some(0.25), 0.1).unwrap().step, 1.25);
        assert_eq!(Ruler::of([1e300, 1.1e300], Some(1.0), 1e280), None);
        assert_eq!(Ruler::of([f64::NAN, 1.0], None, 0.1), None);
        assert_eq!(Ruler::of([0.0, f64::INFINITY], None, 0.1), None);
    }
}
