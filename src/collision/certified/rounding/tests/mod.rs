//! Every row of the table against 320 bits: no error is above its bound, and no bound is ten times the worst
//! error.
//!
//! A search looks for the worst: of many random pairs the one that uses most of a bound is taken, and its
//! numbers are moved, by a lot or by a few last bits, as long as it uses more. What it finds is a lower bound
//! of the worst there is.

mod cases;
mod shares;
mod truth;

use tracefig_reference::random::Random;

use super::{LOSSY, TAME};
use crate::collision::certified::distance::pair::scaled;
use crate::geometry::{Dd, two_product};
use cases::{Case, level, parabolas, triangles};
use shares::{
    cross, derivative, dot, extreme, gap, last, last_ball, level_dot, missed, moving_gap, offset, placing,
    placing_ball, rest, rest_ball, root, turned_dot, view_gap,
};

/// Random pairs that a search looks at.
const PAIRS: usize = 100;

/// Changes that it tries to the worst of them.
const CHANGES: usize = 700;

/// Share of a bound that its worst error must use.
const LEAST: f64 = 0.1;

/// Share for [`ROOT_ERROR`], which is taken off twice, of a and of h, where a root needs only one of them.
const LEAST_OF_TWO: f64 = 0.04;

/// Times that a bound may be as wide as the radius of a ball that says the same.
const MOST: f64 = 10.0;

/// What a bound may not be ten times as large as.
enum Yardstick {
    /// The worst error that is found: at least this share of the bound.
    Worst(f64),
    /// The radius of balls that compute the same of a case: bound over radius.
    ///
    /// A bound in ε² sums some thirty roundings of lower halves, each of either sign: they never all point
    /// the same way, and the worst that a search finds is a fiftieth of the sum. A ball adds them up as well,
    /// each with the size that it has.
    Ball(fn(&Case) -> f64),
}

/// A row of the table: its name, where the search begins (one of a hundred seeds that leads far), how a case
/// is drawn, its error as a share of the bound, and what to compare the bound with.
type Row = (&'static str, u64, fn(&mut Random) -> Case, fn(&Case) -> f64, Yardstick);

/// The bounds of the table.
const ROWS: [Row; 15] = [
    ("GAP_ERROR", 7, triangles, gap, Yardstick::Worst(LEAST)),
    ("GAP_ERROR, in a view", 82, triangles, view_gap, Yardstick::Worst(LEAST)),
    ("DOT_ERROR", 33, triangles, dot, Yardstick::Worst(LEAST)),
    ("DOT_ERROR, of a cross product", 25, triangles, cross, Yardstick::Worst(LEAST)),
    ("LEVEL_ERROR", 28, triangles, level_dot, Yardstick::Worst(LEAST)),
    ("OFFSET_ERROR", 107, triangles, offset, Yardstick::Worst(LEAST)),
    ("PLACING_ERROR", 7, triangles, placing, Yardstick::Ball(placing_ball)),
    ("LAST_ERROR", 37, triangles, last, Yardstick::Ball(last_ball)),
    ("REST_ERROR", 16, triangles, rest, Yardstick::Ball(rest_ball)),
    ("MOVING_GAP_ERROR", 18, triangles, moving_gap, Yardstick::Worst(LEAST)),
    ("MISSED_ERROR", 38, level, missed, Yardstick::Worst(LEAST)),
    ("TURNED_DOT_ERROR", 1, triangles, turned_dot, Yardstick::Worst(LEAST)),
    ("DERIVATIVE_ERROR", 12, triangles, derivative, Yardstick::Worst(LEAST)),
    ("ROOT_ERROR", 23, parabolas, root, Yardstick::Worst(LEAST_OF_TWO)),
    ("EXTREME_ERROR", 33, triangles, extreme, Yardstick::Worst(LEAST)),
];

#[test]
fn every_bound_holds_and_is_used() {
    let mut wrong = Vec::new();
    for (name, seed, draw, share, yardstick) in ROWS {
        let worst = worst(seed, draw, share);
        if worst > 1.0 {
            wrong.push(format!("{name}: an error is {worst:.3} times the bound"));
        }
        match yardstick {
            Yardstick::Worst(least) if worst < least => {
                wrong.push(format!("{name}: the worst error is {worst:.3} of the bound"));
            }
            Yardstick::Worst(_) => {}
            Yardstick::Ball(ratio) => {
                let mut random = Random::new(seed);
                let least = (0..PAIRS).map(|_| ratio(&draw(&mut random))).fold(f64::INFINITY, f64::min);
                if least > MOST {
                    wrong.push(format!("{name}: the bound is never below {least:.1} radii of a ball"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_bounds_hold_to_the_ends_of_the_range_of_tame_scenes() {
    for end in [TAME.start * 64.0, TAME.end / 64.0] {
        for (name, seed, draw, share, _) in ROWS.iter().filter(|row| row.0 != "ROOT_ERROR") {
            let mut random = Random::new(*seed);
            let worst = (0..20).map(|_| share(&draw(&mut random).scaled(end))).fold(0.0, f64::max);
            assert!(worst <= 1.0, "{name}: an error is {worst:.3} times the bound at {end:e}");
        }
        let four = (end * end) * (end * end);
        let (product, rest) = two_product(four / 3.0, 1.0 / 3.0);
        assert!(product.is_finite() && rest != 0.0, "nothing is left out of a product of four lengths");
        let far = libm::pow(end, 10.0);
        assert!(far == 0.0 || far.is_infinite(), "exponents ten times as large are no doubles");
    }
}

#[test]
fn a_scaled_number_keeps_its_bits_or_says_that_it_may_not() {
    let (down, up) = (libm::scalbn(1.0, -300), libm::scalbn(1.0, 300));
    for exponent in -1090..=-900 {
        let x = libm::scalbn(1.0 + 0.1 + f64::EPSILON, exponent + 300);
        let ball = scaled(Dd::new(x), down);
        let lost = (ball.value.hi * up - x).abs();
        assert!(lost <= ball.radius * up, "2^{exponent}: {lost:e} is lost of {x:e}");
        // Eight times LOSSY is not below it, and far above what underflow takes.
        assert!(exponent < -957 || ball.radius == 0.0, "2^{exponent}: as wide as {:e}", ball.radius);
    }
    let lower = Dd { hi: up, lo: libm::scalbn(1.0 + 0.3, -800) };
    assert!(scaled(lower, down).radius >= LOSSY, "the lower half may lose bits too");
}

/// The largest share that a search finds.
fn worst(seed: u64, draw: fn(&mut Random) -> Case, share: fn(&Case) -> f64) -> f64 {
    let mut random = Random::new(seed);
    let mut best = (draw(&mut random), 0.0);
    for _ in 0..PAIRS {
        let case = draw(&mut random);
        let used = share(&case);
        if used > best.1 {
            best = (case, used);
        }
    }
    for _ in 0..CHANGES {
        let mut case = best.0.clone();
        for _ in 0..=random.below(2) {
            case.change(&mut random);
        }
        let used = share(&case);
        if used > best.1 {
            best = (case, used);
        }
    }
    best.1
}
