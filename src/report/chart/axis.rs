//! Axes: the range they show, how a value maps to it, and their ticks.

/// A logarithmic axis: equal ratios are equal lengths.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// What it measures, with the unit, markup.
    pub(crate) name: String,
    /// The smallest value shown, above 0.
    pub(crate) lo: f64,
    /// The largest value shown.
    pub(crate) hi: f64,
    /// Values to mark; empty for powers of ten.
    pub(crate) marks: Vec<f64>,
}

/// A value that the axis names.
pub(super) struct Tick {
    /// Where it is, in the unit of the axis.
    pub(super) value: f64,
    /// What it is called, markup.
    pub(super) label: String,
}

/// How many ticks an axis has at most; more would touch each other.
const TICKS: i32 = 9;

impl Axis {
    /// An axis over whole powers of ten that holds all of `values` above 0; from 1 to 10 without
    /// any.
    #[must_use]
    pub(crate) fn powers_of_ten(name: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let logs: Vec<f64> = values.into_iter().filter(|v| *v > 0.0).map(libm::log10).collect();
        let lo = logs.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let (lo, hi) = if lo <= hi { (lo.floor(), hi.ceil().max(lo.floor() + 1.0)) } else { (0.0, 1.0) };
        Self { name: name.to_owned(), lo: libm::exp10(lo), hi: libm::exp10(hi), marks: Vec::new() }
    }

    /// Where a value lies between `lo` (0) and `hi` (1), clamped to them.
    pub(super) fn fraction(&self, value: f64) -> f64 {
        let of = |v: f64| libm::log10(v.max(self.lo));
        ((of(value) - of(self.lo)) / (of(self.hi) - of(self.lo))).clamp(0.0, 1.0)
    }

    /// The values that the axis names: its marks, or powers of ten.
    pub(super) fn ticks(&self) -> Vec<Tick> {
        if !self.marks.is_empty() {
            return self.marks.iter().map(|&value| Tick { value, label: format!("{value}") }).collect();
        }
        #[expect(clippy::cast_possible_truncation, reason = "powers of ten of a double are below 400")]
        let (lo, hi) = (libm::log10(self.lo).round() as i32, libm::log10(self.hi).round() as i32);
        let step = ((hi - lo) / TICKS + 1).max(1);
        (lo..=hi)
            .filter(|power| (power - lo) % step == 0)
            .map(|power| Tick { value: libm::exp10(f64::from(power)), label: format!("$10^{{{power}}}$") })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_powers_of_ten_around_the_values_are_shown() {
        let axis = Axis::powers_of_ten("ns", [25.0, 4000.0]);
        assert!((axis.lo - 10.0).abs() < 1e-12 && (axis.hi - 10_000.0).abs() < 1e-9);
        assert!((axis.fraction(100.0) - 1.0 / 3.0).abs() < 1e-12);
        assert_eq!(axis.ticks().len(), 4);
    }

    #[test]
    fn an_axis_of_no_values_is_still_an_axis() {
        let axis = Axis::powers_of_ten("ns", []);
        assert!(axis.lo < axis.hi);
    }
}
