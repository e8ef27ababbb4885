//! Every rounding term of balls against 320 bits: each operation on balls keeps the exact result,
//! and needs what it allows for. A whole query hides a deleted term behind the others; here nothing does.

use tracefig_reference::float::Real;
use tracefig_reference::point;
use tracefig_reference::random::Random;

use crate::geometry::number::degrees::{COS_SIN_ERROR, TAILED_ERROR};
use crate::geometry::number::double_double::COMBINED_ERROR;
use crate::geometry::{Angle, Ball, Dd, Rotation, Turn, combined};

/// Operands of each operation.
const CASES: usize = 5_000;

fn exact(x: Dd) -> Real {
    Real::from(x.hi) + Real::from(x.lo)
}

/// The magnitude |x|.
fn size(x: Ball) -> Ball {
    if x.value.hi < 0.0 { -x } else { x }
}

/// A double-double of any last bits, about 1 and now and then far from it.
fn operand(random: &mut Random) -> Dd {
    let hi = random.between(-2.0, 2.0) * random.one_of(&[1.0, 1.0, 1e-9, 1e6]);
    Dd::sum(hi, hi * f64::EPSILON * random.between(-0.4, 0.4))
}

/// The largest |exact − value| / radius of an operation on exact balls: above 1 it is wrong, near 0 it is
/// wide.
fn used(random: &mut Random, operate: impl Fn(Ball, Ball) -> (Ball, Real)) -> f64 {
    let mut most = 0.0_f64;
    for _ in 0..CASES {
        let (x, y) = (operand(random), operand(random));
        let (ball, truth) = operate(Ball::exact(x), Ball::exact(y));
        let error = (truth - exact(ball.value)).abs();
        if !error.is_zero() {
            most = most.max(error.over(Real::from(ball.radius)).to_f64());
            assert!(ball.radius > 0.0, "{x:?} and {y:?} are rounded without an allowance");
        }
    }
    most
}

/// Share of a bound that its worst error must use.
const LEAST: f64 = 0.1;

#[test]
fn operations_on_balls_keep_the_exact_result() {
    let mut random = Random::new(1);
    let of = |x: Ball| exact(x.value);
    let double = |x: Ball| Real::from(x.value.hi);
    // One bound, [`Dd::ROUNDING`], is for all of them, the quotient, which needs most of it, among them.
    let most = [
        ("x + y", used(&mut random, |x, y| (x + y, of(x) + of(y)))),
        ("x − y", used(&mut random, |x, y| (x - y, of(x) - of(y)))),
        ("x · y", used(&mut random, |x, y| (x * y, of(x) * of(y)))),
        ("x / y", used(&mut random, |x, y| (x.over(y), of(x).over(of(y))))),
        ("x · double", used(&mut random, |x, y| (x.scale(y.value.hi), of(x) * double(y)))),
        ("√x", used(&mut random, |x, _| (size(x).sqrt(), of(x).abs().sqrt()))),
    ];
    for (name, most) in most {
        assert!(most <= 1.0, "{name}: off by {most} radii");
        assert!(most > 0.5 * LEAST, "{name}: the radius is {:.0} times too large", most.recip());
    }
    assert!(most.iter().any(|(_, most)| *most > LEAST), "the radius is ten times too large: {most:?}");
}

/// Whether a ball of the result holds the result at each end of the operands.
fn holds_ends(
    random: &mut Random,
    operate: impl Fn(Ball, Ball) -> Ball,
    truth: impl Fn(Real, Real) -> Real,
) -> bool {
    (0..CASES).all(|_| {
        let mut ball = || {
            let value = operand(random);
            Ball::within(value, value.hi.abs() * random.magnitude(-30.0, -2.0))
        };
        let (x, y) = (ball(), ball());
        let result = operate(x, y);
        [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].into_iter().all(|(p, q)| {
            let end = |x: Ball, sign: f64| exact(x.value) + Real::from(sign) * Real::from(x.radius);
            (truth(end(x, p), end(y, q)) - exact(result.value)).abs() <= Real::from(result.radius)
        })
    })
}

#[test]
fn the_radii_of_operands_are_carried_on() {
    let mut random = Random::new(2);
    assert!(holds_ends(&mut random, |x, y| x + y, |x, y| x + y), "x + y");
    assert!(holds_ends(&mut random, |x, y| x - y, |x, y| x - y), "x − y");
    assert!(holds_ends(&mut random, |x, y| x * y, |x, y| x * y), "x · y");
    assert!(holds_ends(&mut random, Ball::over, Real::over), "x / y");
    assert!(holds_ends(&mut random, |x, _| x.scale(0.7), |x, _| x * Real::from(0.7)), "x · 0.7");
    assert!(holds_ends(&mut random, |x, _| size(x).sqrt(), |x, _| x.abs().sqrt()), "√x");
}

#[test]
fn enclosures_of_balls_hold_them_and_are_a_few_ulp_wide() {
    let mut random = Random::new(3);
    for _ in 0..CASES {
        let value = operand(&mut random);
        let ball = Ball::within(value, value.hi.abs() * random.magnitude(-34.0, -14.0));
        let bounds = ball.enclosure();
        let (lo, hi) =
            (exact(ball.value) - Real::from(ball.radius), exact(ball.value) + Real::from(ball.radius));
        assert!(Real::from(bounds.lo) <= lo && hi <= Real::from(bounds.hi), "{ball:?}: {bounds:?}");
        let ulp = value.hi.abs().next_up() - value.hi.abs();
        assert!(bounds.hi - bounds.lo <= 2.0 * ball.radius + 6.0 * ulp, "{ball:?}: {bounds:?}");
    }
}

#[test]
fn cosines_and_sines_are_within_their_errors() {
    let mut random = Random::new(4);
    let (mut most, mut doubles) = (0.0_f64, [0.0_f64; 2]);
    for _ in 0..CASES {
        let angle = random.between(-1.0, 1.0) * random.one_of(&[1e-9, 45.0, 360.0, 1e5, 1e12]);
        let (spin, t) = (random.between(-720.0, 720.0), random.unit());
        let turn = Turn::at(Angle::Degrees(angle), Angle::Degrees(spin), t);
        let truth = point::Rotation::of_degrees(Real::from(angle) + Real::from(spin) * Real::from(t));
        let Rotation { cos, sin } = turn.rotation_in_balls();
        for (ball, truth) in [(cos, truth.cos), (sin, truth.sin)] {
            let error = (truth - exact(ball.value)).abs();
            let part = if error.is_zero() { 0.0 } else { error.over(Real::from(ball.radius)).to_f64() };
            assert!(part <= 1.0, "{angle} + {spin} · {t}: {part} radii off");
            most = most.max(part);
        }
        let (plain, (tailed, _)) = (turn.rotation(), turn.rotation_tailed());
        for (value, low, truth) in [(plain.cos, tailed.cos, truth.cos), (plain.sin, tailed.sin, truth.sin)] {
            let part = |x: Real, bound: f64| (x - truth).abs().over(Real::from(bound)).to_f64();
            let parts = [part(Real::from(value), COS_SIN_ERROR), part(exact(low), TAILED_ERROR)];
            assert!(parts.iter().all(|&part| part <= 1.0), "{angle} + {spin} · {t}: {parts:?} of the bounds");
            doubles = [doubles[0].max(parts[0]), doubles[1].max(parts[1])];
        }
    }
    assert!(doubles.iter().all(|&part| part > LEAST), "only {doubles:?} of the bounds is used");
    assert!(most > LEAST, "the radius is {:.0} times too large", most.recip());
}

#[test]
fn radians_are_as_good_as_degrees_at_any_size() {
    let mut random = Random::new(6);
    for _ in 0..CASES / 5 {
        let angle = random.between(-1.0, 1.0) * random.one_of(&[1e-9, 1.0, 6.3, 1e9, 1e60, 1e150]);
        let (spin, t) = (random.between(-9.0, 9.0) * random.one_of(&[1.0, 1e6]), random.unit());
        let turn = Turn::at(Angle::Radians(angle), Angle::Radians(spin), t);
        let radians = Real::from(angle) + Real::from(spin) * Real::from(t);
        // 320 bits hold an angle of 1e60 with 120 to spare, and none of 1e150.
        let Rotation { cos, sin } = turn.rotation_in_balls();
        assert!(cos.radius <= 4.0 * f64::EPSILON * f64::EPSILON, "{angle} + {spin} · {t}: {cos:?}");
        if angle.abs() < 1e61 {
            let truth = point::Rotation::of_degrees(point::degrees_of(radians));
            for (ball, truth) in [(cos, truth.cos), (sin, truth.sin)] {
                let error = (truth - exact(ball.value)).abs();
                assert!(error <= Real::from(ball.radius), "{angle} + {spin} · {t}: {error}");
            }
        }
        let mixed = Turn::between(
            (Angle::Radians(angle), Angle::ZERO),
            (Angle::Radians(angle), Angle::Degrees(60.0)),
            0.5,
        );
        assert!((mixed.rotation_in_balls().sin - Ball::new(0.5)).value == Dd::ZERO, "{angle}");
    }
}

#[test]
fn an_angle_that_no_digits_tell_is_any_angle() {
    let turn = Turn::at(Angle::Radians(1e300), Angle::Radians(-1e300), 0.3);
    let Rotation { cos, sin } = turn.rotation_in_balls();
    assert!(cos.radius > 0.0 && cos.radius <= 2.0 && sin.radius <= 2.0, "{cos:?} {sin:?}");
}

#[test]
fn a_combination_of_two_products_is_within_its_error() {
    let mut random = Random::new(5);
    let mut most = 0.0_f64;
    for _ in 0..CASES {
        let [a, x, b, y] = std::array::from_fn(|_| operand(&mut random));
        let (p, q) = (exact(a) * exact(x), exact(b) * exact(y));
        let error = (p + q - exact(combined(a, x, b, y))).abs();
        let bound = Real::from(COMBINED_ERROR) * (p.abs() + q.abs());
        most = most.max(error.over(bound).to_f64());
    }
    assert!(most <= 1.0, "off by {most} of the bound");
    assert!(most > LEAST, "the bound is {:.0} times too large", most.recip());
}
