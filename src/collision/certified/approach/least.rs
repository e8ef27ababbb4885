//! The least value of a function near a moment, by parabolas: a guess, of which nothing has to hold.
//!
//! A parabola through the three best points has its vertex near the least value; where it leads nowhere, or
//! out of the interval, a golden section takes its place. Three to six evaluations where the function is
//! smooth, forty where it is not.
//!
//! Source: Richard Brent, *Algorithms for Minimization without Derivatives*, 1973, chapter 5.

/// Evaluations at most: what golden sections need to go from an interval of 1 to a billionth of it.
const EVALUATIONS: usize = 44;

/// 1 − 1/φ, the part of an interval at which a golden section cuts.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// Where `f` is least in the interval from `lo` to `hi`, to within `tolerance`, and its value there: of a
/// function with one minimum there, the least; else one of its local ones.
pub(super) fn least(f: impl Fn(f64) -> f64, [mut lo, mut hi]: [f64; 2], tolerance: f64) -> (f64, f64) {
    let start = lo + GOLDEN * (hi - lo);
    let value = f(start);
    // The best three points so far, the best first.
    let (mut x, mut w, mut v) = ((start, value), (start, value), (start, value));
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    for _ in 0..EVALUATIONS {
        let middle = 0.5 * (lo + hi);
        if (x.0 - middle).abs() <= 2.0 * tolerance - 0.5 * (hi - lo) {
            break;
        }
        let parabola = vertex(x, w, v).filter(|d| {
            let to = x.0 + d;
            before.abs() > tolerance && d.abs() < 0.5 * before.abs() && to > lo && to < hi
        });
        (before, step) = if let Some(d) = parabola {
            (step, d)
        } else {
            let longer = if x.0 < middle { hi - x.0 } else { lo - x.0 };
            (longer, GOLDEN * longer)
        };
        let at = x.0 + if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        let u = (at, f(at));
        if u.1 <= x.1 {
            if at < x.0 {
                hi = x.0;
            } else {
                lo = x.0;
            }
            (v, w, x) = (w, x, u);
        } else {
            if at < x.0 {
                lo = at;
            } else {
                hi = at;
            }
            if u.1 <= w.1 || w.0 == x.0 {
                (v, w) = (w, u);
            } else if u.1 <= v.1 || v.0 == x.0 || v.0 == w.0 {
                v = u;
            }
        }
    }
    x
}

/// How far the vertex of the parabola through three points is from the first; None where there is none.
fn vertex(x: (f64, f64), w: (f64, f64), v: (f64, f64)) -> Option<f64> {
    let r = (x.0 - w.0) * (x.1 - v.1);
    let q = (x.0 - v.0) * (x.1 - w.1);
    let d = ((x.0 - w.0) * r - (x.0 - v.0) * q) / (2.0 * (q - r));
    d.is_finite().then_some(d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    /// Where a function is found least in [0, 1], and after how many evaluations.
    fn found(f: impl Fn(f64) -> f64) -> (f64, usize) {
        let count = Cell::new(0);
        let counted = |t: f64| {
            count.set(count.get() + 1);
            f(t)
        };
        (least(counted, [0.0, 1.0], 1e-9).0, count.get())
    }

    #[test]
    fn a_smooth_minimum_takes_few_evaluations() {
        let (t, count) = found(|t| 2.0 - libm::cos(2.0 * (t - 0.3)));
        assert!((t - 0.3).abs() < 1e-7 && count <= 14, "{t} after {count}");
    }

    #[test]
    fn a_minimum_with_a_kink_is_found() {
        let (t, count) = found(|t| (t - 0.7).abs() + (t - 0.7).max(0.0));
        assert!((t - 0.7).abs() < 1e-8 && count <= EVALUATIONS + 1, "{t} after {count}");
    }

    #[test]
    fn a_minimum_at_an_end_is_neared() {
        assert!(found(|t| t).0 < 1e-8);
        assert!(found(|t| -t).0 > 1.0 - 1e-8);
    }
}
