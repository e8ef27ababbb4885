//! + − · and the order of floats.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use super::{Float, low};

impl<const N: usize> Neg for Float<N> {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.sign = -self.sign;
        self
    }
}

impl<const N: usize> Add for Float<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.sign == 0 {
            return other;
        }
        if other.sign == 0 {
            return self;
        }
        let order = self.magnitude_cmp(&other);
        let (large, small) = if order == Ordering::Less { (other, self) } else { (self, other) };
        if large.sign == small.sign {
            large.magnitude_sum(&small)
        } else if order == Ordering::Equal {
            Self::ZERO
        } else {
            large.magnitude_difference(&small)
        }
    }
}

impl<const N: usize> Sub for Float<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const N: usize> Mul for Float<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.sign == 0 || other.sign == 0 {
            return Self::ZERO;
        }
        // Column sums from the lowest, in three limbs; `lowest` ends as the limb below the result.
        let mut m = [0; N];
        let mut guard = 0;
        let (mut acc, mut over): (u128, u64) = (0, 0);
        for column in 0..2 * N {
            for i in column.saturating_sub(N - 1)..=column.min(N - 1) {
                let (sum, carry) =
                    acc.overflowing_add(u128::from(self.m[i]) * u128::from(other.m[column - i]));
                acc = sum;
                over += u64::from(carry);
            }
            if column + 1 == N {
                guard = low(acc);
            } else if column >= N {
                m[column - N] = low(acc);
            }
            acc = (acc >> 64) | (u128::from(over) << 64);
            over = 0;
        }
        Self::normalized(self.sign * other.sign, self.exp + other.exp, m, guard)
    }
}

impl<const N: usize> PartialOrd for Float<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const N: usize> Ord for Float<N> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.sign.cmp(&other.sign).then_with(|| match self.sign {
            0 => Ordering::Equal,
            1 => self.magnitude_cmp(other),
            _ => other.magnitude_cmp(self),
        })
    }
}
