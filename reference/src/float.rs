//! Binary floats of 64·N bits, of fixed size: what "exact" means in this package.
//!
//! A value is ± 0.m · 2^exp with the top bit of m set, m an N-limb integer read as a fraction. Results are
//! truncated, so one operation is wrong by less than 2^(1 − 64 N) of its result; with N = 5 that is 2⁻³¹⁹.
//! Nothing here overflows or underflows: the exponent has 64 bits. No heap, so that a hundred thousand cases
//! take seconds.

mod decimal;
mod operators;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::sync::OnceLock;

/// A float of 64·N bits.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Float<const N: usize> {
    /// −1, 0 or 1.
    sign: i8,
    exp: i64,
    /// Least significant limb first.
    m: [u64; N],
}

/// The precision of all checks: 320 bits.
pub type Real = Float<5>;

impl<const N: usize> Float<N> {
    /// Zero.
    pub const ZERO: Self = Self { sign: 0, exp: 0, m: [0; N] };

    /// One.
    #[must_use]
    pub fn one() -> Self {
        Self::from(1.0)
    }

    /// 2^k.
    #[must_use]
    pub fn power_of_two(k: i64) -> Self {
        Self::one().scaled(k)
    }

    /// The value times 2^k, exactly.
    #[must_use]
    pub fn scaled(mut self, k: i64) -> Self {
        if self.sign != 0 {
            self.exp += k;
        }
        self
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn signum(&self) -> i8 {
        self.sign
    }

    /// Whether it is exactly 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.sign == 0
    }

    /// The magnitude.
    #[must_use]
    pub fn abs(mut self) -> Self {
        self.sign = self.sign.abs();
        self
    }

    /// The square.
    #[must_use]
    pub fn squared(self) -> Self {
        self * self
    }

    /// The smaller of two.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// The larger of two.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// 1 / self, to within 4 units of the last bit; 0 for 0, which no caller divides by.
    #[must_use]
    pub fn recip(self) -> Self {
        if self.sign == 0 {
            return Self::ZERO;
        }
        let y = Self { sign: 1, exp: 0, m: self.m };
        let mut x = Self::from(1.0 / y.to_f64());
        let mut bits = 50;
        while bits < 64 * N {
            x = x + x * (Self::one() - y * x);
            bits *= 2;
        }
        x.sign = self.sign;
        x.scaled(-self.exp)
    }

    /// The quotient.
    #[must_use]
    pub fn over(self, divisor: Self) -> Self {
        self * divisor.recip()
    }

    /// The quotient by a small positive integer.
    #[must_use]
    pub fn over_int(self, divisor: u64) -> Self {
        if self.sign == 0 {
            return self;
        }
        let mut out = [0; N];
        let mut rest: u128 = 0;
        for i in (0..N).rev() {
            let part = (rest << 64) | u128::from(self.m[i]);
            out[i] = low(part / u128::from(divisor));
            rest = part % u128::from(divisor);
        }
        let guard = low((rest << 64) / u128::from(divisor));
        Self::normalized(self.sign, self.exp, out, guard)
    }

    /// The square root of a value ≥ 0; 0 for a negative one, which only rounding makes.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.sign <= 0 {
            return Self::ZERO;
        }
        let odd = self.exp.rem_euclid(2);
        let y = Self { sign: 1, exp: -odd, m: self.m };
        let mut r = Self::from(1.0 / y.to_f64().sqrt());
        let mut bits = 50;
        while bits < 64 * N {
            r = r + (r * (Self::one() - y * r * r)).scaled(-1);
            bits *= 2;
        }
        let q = y * r;
        let q = q + (r * (y - q * q)).scaled(-1);
        q.scaled((self.exp + odd) >> 1)
    }

    /// The nearest integer, as a float; halves go up.
    #[must_use]
    pub fn round(self) -> Self {
        (self + Self::from(0.5)).floor()
    }

    /// The largest integer not above it.
    #[must_use]
    pub fn floor(self) -> Self {
        let mut whole = self;
        let keep = self.exp;
        if keep <= 0 {
            return if self.sign < 0 { -Self::one() } else { Self::ZERO };
        }
        let mut cut = false;
        for i in 0..N {
            // Bit weights of limb i run from exp − 64 (N − i) upwards.
            let below = 64 * (index(N) - index(i)) - keep;
            let mask = match below {
                ..=0 => 0,
                64.. => u64::MAX,
                bits => (1_u64 << bits) - 1,
            };
            cut |= whole.m[i] & mask != 0;
            whole.m[i] &= !mask;
        }
        if cut && self.sign < 0 { whole - Self::one() } else { whole }
    }

    /// An integer of moderate size, modulo 4.
    #[must_use]
    pub fn modulo_four(self) -> u8 {
        let quarter = self.scaled(-2);
        let rest = (quarter - quarter.floor()).scaled(2).to_f64();
        [0, 1, 2, 3].into_iter().find(|k| f64::from(*k) > rest - 0.5).unwrap_or(0)
    }

    /// The nearest double (within one unit of its last place; denormals and overflow as in IEEE 754).
    #[must_use]
    pub fn to_f64(self) -> f64 {
        if self.sign == 0 {
            return 0.0;
        }
        let exp = self.exp.clamp(-1200, 1100);
        let sticky = u64::from(self.m[..N - 1].iter().any(|limb| *limb != 0));
        // 62 bits and a sticky one: `as` rounds to nearest even; two steps of scaling keep denormals to one
        // rounding but for a double rounding of at most one unit.
        #[expect(clippy::cast_precision_loss, reason = "the rounding to 53 bits is wanted")]
        let top = ((self.m[N - 1] >> 1) | sticky) as f64;
        let k = exp - 63;
        let half = k / 2;
        let magnitude = top * two_to(half) * two_to(k - half);
        if self.sign < 0 { -magnitude } else { magnitude }
    }

    /// π, by Machin's formula 16 atan(1/5) − 4 atan(1/239).
    fn machin() -> Self {
        let atan = |q: u64| {
            let mut power = Self::one().over_int(q);
            let mut sum = power;
            let mut k = 1;
            while power.sign != 0 && power.exp > -(64 * index(N)) - 8 {
                power = -power.over_int(q * q);
                k += 2;
                sum = sum + power.over_int(k);
            }
            sum
        };
        atan(5).scaled(4) - atan(239).scaled(2)
    }

    /// A magnitude with a guard limb below it, shifted up until its top bit is set.
    fn normalized(sign: i8, exp: i64, mut m: [u64; N], mut guard: u64) -> Self {
        let mut exp = exp;
        let mut limbs = 0;
        while m[N - 1] == 0 {
            if limbs > N {
                return Self::ZERO;
            }
            for i in (1..N).rev() {
                m[i] = m[i - 1];
            }
            m[0] = guard;
            guard = 0;
            exp -= 64;
            limbs += 1;
        }
        let shift = m[N - 1].leading_zeros();
        if shift > 0 {
            for i in (1..N).rev() {
                m[i] = (m[i] << shift) | (m[i - 1] >> (64 - shift));
            }
            m[0] = (m[0] << shift) | (guard >> (64 - shift));
            exp -= i64::from(shift);
        }
        Self { sign, exp, m }
    }

    /// m shifted down by `distance` bits, and the limb that falls out below.
    fn shifted_down(m: &[u64; N], distance: i64) -> ([u64; N], u64) {
        let Ok(distance) = usize::try_from(distance) else { return ([0; N], 0) };
        let (limbs, bits) = (distance / 64, distance % 64);
        let limb = |i: usize| if i < N { m[i] } else { 0 };
        let joined = |i: usize| {
            if bits == 0 { limb(i) } else { (limb(i) >> bits) | (limb(i + 1) << (64 - bits)) }
        };
        let mut out = [0; N];
        for (i, slot) in out.iter_mut().enumerate() {
            *slot = joined(i + limbs);
        }
        let guard = match limbs {
            0 if bits == 0 => 0,
            0 => m[0] << (64 - bits),
            _ => joined(limbs - 1),
        };
        (out, guard)
    }

    fn magnitude_cmp(&self, other: &Self) -> Ordering {
        self.exp.cmp(&other.exp).then_with(|| self.m.iter().rev().cmp(other.m.iter().rev()))
    }

    /// |self| + |other| with |self| ≥ |other|, both not 0.
    fn magnitude_sum(&self, other: &Self) -> Self {
        let (small, _) = Self::shifted_down(&other.m, self.exp - other.exp);
        let mut m = self.m;
        let mut carry = false;
        for i in 0..N {
            let (sum, c1) = m[i].overflowing_add(small[i]);
            let (sum, c2) = sum.overflowing_add(u64::from(carry));
            m[i] = sum;
            carry = c1 || c2;
        }
        let mut exp = self.exp;
        if carry {
            for i in 0..N - 1 {
                m[i] = (m[i] >> 1) | (m[i + 1] << 63);
            }
            m[N - 1] = (m[N - 1] >> 1) | (1 << 63);
            exp += 1;
        }
        Self { sign: self.sign, exp, m }
    }

    /// |self| − |other| with |self| > |other|, both not 0, with the sign of self.
    fn magnitude_difference(&self, other: &Self) -> Self {
        let (small, guard) = Self::shifted_down(&other.m, self.exp - other.exp);
        let (low, mut borrow) = 0_u64.overflowing_sub(guard);
        let mut m = self.m;
        for i in 0..N {
            let (rest, b1) = m[i].overflowing_sub(small[i]);
            let (rest, b2) = rest.overflowing_sub(u64::from(borrow));
            m[i] = rest;
            borrow = b1 || b2;
        }
        Self::normalized(self.sign, self.exp, m, low)
    }
}

impl Real {
    /// π, computed once.
    #[must_use]
    pub fn pi() -> Self {
        static PI: OnceLock<Real> = OnceLock::new();
        *PI.get_or_init(Self::machin)
    }
}

/// The low 64 bits.
#[expect(clippy::cast_possible_truncation, reason = "the truncation is what it is for")]
fn low(x: u128) -> u64 {
    x as u64
}

/// A limb count as an exponent; counts here are below 100.
fn index(i: usize) -> i64 {
    i64::try_from(i).unwrap_or(i64::MAX)
}

/// 2^k for −1022 ≤ k ≤ 1023, else saturated there.
fn two_to(k: i64) -> f64 {
    f64::from_bits(u64::try_from(k.clamp(-1022, 1023) + 1023).unwrap_or(0) << 52)
}

impl<const N: usize> From<f64> for Float<N> {
    /// Exact. Infinities and NaN, which no scene holds, become 0.
    fn from(x: f64) -> Self {
        if x == 0.0 || !x.is_finite() {
            return Self::ZERO;
        }
        let bits = x.to_bits();
        let biased = (bits >> 52) & 0x7ff;
        let fraction = bits & ((1 << 52) - 1);
        let (mantissa, k) = if biased == 0 {
            (fraction, -1074)
        } else {
            (fraction | (1 << 52), i64::try_from(biased).unwrap_or(0) - 1075)
        };
        let zeros = mantissa.leading_zeros();
        let mut m = [0; N];
        m[N - 1] = mantissa << zeros;
        Self { sign: if x < 0.0 { -1 } else { 1 }, exp: 64 - i64::from(zeros) + k, m }
    }
}
