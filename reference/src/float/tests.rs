//! The arithmetic against an independent library, and against numbers known by head.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

use super::{Float, Real};
use crate::random::Random;

type Oracle = FBig<HalfEven, 2>;

fn oracle(x: f64) -> Oracle {
    Oracle::try_from(x).expect("finite").with_precision(400).value()
}

/// A double of a random sign and magnitude, now and then close to another.
fn operand(random: &mut Random) -> f64 {
    let x = random.between(-2.0, 2.0);
    match random.below(4) {
        0 => x,
        1 => x * 1e-20,
        2 => x * 1e15,
        _ => 1.0 + x * 1e-12,
    }
}

/// Sums the parts of a value as doubles, so that it can be handed over exactly.
fn handed_over(mut x: Real) -> Oracle {
    let mut sum = oracle(0.0);
    for _ in 0..8 {
        let part = x.to_f64();
        sum += oracle(part);
        x = x - Real::from(part);
    }
    sum
}

fn assert_close(ours: Real, theirs: &Oracle, what: &str) {
    let difference = (handed_over(ours) - theirs).to_f64().value().abs();
    assert!(
        difference <= theirs.to_f64().value().abs() * Real::power_of_two(-314).to_f64(),
        "{what}: {ours} is off by {difference}"
    );
}

#[test]
fn sums_products_quotients_and_roots_agree_with_dashu() {
    let mut random = Random::new(7);
    for _ in 0..4000 {
        let [a, b, c, d] = [(); 4].map(|()| operand(&mut random));
        let (x, y) = (Real::from(a) * Real::from(b), Real::from(c) * Real::from(d));
        let (u, v) = (oracle(a) * oracle(b), oracle(c) * oracle(d));
        assert_close(x + y, &(&u + &v), "sum");
        assert_close(x - y, &(&u - &v), "difference");
        assert_close(x.over(y), &(&u / &v), "quotient");
        let (p, q) = (x.over(y).over_int(3), &u / &v / oracle(3.0));
        assert_close(p, &q, "quotient by 3");
        assert_close(p * x, &(&q * &u), "product");
        assert_close(p.abs().sqrt(), &oracle_sqrt(&q), "root");
    }
}

fn oracle_sqrt(x: &Oracle) -> Oracle {
    use dashu_float::ops::Abs;
    x.clone().abs().sqrt()
}

#[test]
fn cancellation_keeps_the_difference() {
    let one = Real::one();
    let tiny = Real::power_of_two(-300);
    assert_eq!((one + tiny) - one, tiny);
    assert_eq!(one - (one - tiny), tiny);
    let just_below = one - Real::power_of_two(-320);
    assert_eq!(one - just_below, Real::power_of_two(-320));
}

#[test]
fn doubles_come_back_and_denormals_too() {
    let mut random = Random::new(3);
    for _ in 0..10_000 {
        let x = f64::from_bits(random.bits());
        if x.is_finite() {
            assert_eq!(Real::from(x).to_f64().to_bits(), (x + 0.0).to_bits(), "{x:e}");
        }
    }
    assert_eq!(Real::from(5e-324).to_f64(), 5e-324);
}

#[test]
fn pi_has_its_known_digits() {
    let known = "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798";
    let known = Real::from_decimal(known).expect("a number");
    assert!((Real::pi() - known).abs() < Real::power_of_two(-312));
}

#[test]
fn floors_and_quarters_are_those_of_integers() {
    for (x, floor) in [(2.5, 2.0), (-2.5, -3.0), (-2.0, -2.0), (0.25, 0.0), (-0.25, -1.0), (1e15 + 0.5, 1e15)]
    {
        assert_eq!(Real::from(x).floor().to_f64(), floor);
    }
    for (x, k) in [(0.0, 0), (5.0, 1), (-1.0, 3), (-6.0, 2), (4e9 + 3.0, 3)] {
        assert_eq!(Real::from(x).modulo_four(), k, "{x}");
    }
}

#[test]
fn decimals_read_and_print() {
    let x = Real::from_decimal("-1.25e-3").expect("a number");
    assert!((x - Real::from(-0.001_25)).abs() < Real::power_of_two(-60));
    assert_eq!(Real::from(-0.375).to_string(), "-3.750000000000000000000000e-1");
    assert_eq!(Float::<4>::from(7.5).to_string(), "7.500000000000000000000000e0");
}
