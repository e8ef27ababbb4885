//! Seeded random numbers: the same cases on every machine.
//!
//! `splitmix64` of Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014.

/// A generator of random numbers.
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The sequence of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// The sequence of one case: independent of how many numbers the cases before it took.
    #[must_use]
    pub fn of_case(seed: u64, case: u64) -> Self {
        let mut random = Self::new(seed ^ case.wrapping_mul(0xd134_2543_de82_ef95));
        random.bits();
        random
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        let top = u32::try_from(self.bits() >> 32).unwrap_or(0);
        let low = u32::try_from(self.bits() >> 43).unwrap_or(0);
        (f64::from(top) + f64::from(low) / 2_097_152.0) / 4_294_967_296.0
    }

    /// Uniform in [lo, hi).
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// Uniform in 0 … n − 1.
    pub fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.bits() % (n.max(1) as u64)).unwrap_or(0)
    }

    /// A multiple of a quarter in [lo, hi]: makes ties, touching and parallel edges.
    pub fn quarter(&mut self, lo: i32, hi: i32) -> f64 {
        let steps = usize::try_from(4 * (hi - lo) + 1).unwrap_or(1);
        f64::from(lo) + f64::from(u32::try_from(self.below(steps)).unwrap_or(0)) / 4.0
    }

    /// True once in n.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// One of these.
    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// A reference to one of these, which need not be `Copy`.
    pub fn pick<'a, T>(&mut self, choices: &'a [T]) -> &'a T {
        &choices[self.below(choices.len())]
    }

    /// 10^x with x uniform in [lo, hi): a size whose order of magnitude is uniform.
    pub fn magnitude(&mut self, lo: f64, hi: f64) -> f64 {
        self.between(lo, hi).exp_of_ten()
    }
}

/// Powers of ten by multiplication alone, so that cases are the same on every machine.
trait ExpOfTen {
    fn exp_of_ten(self) -> f64;
}

impl ExpOfTen for f64 {
    fn exp_of_ten(self) -> f64 {
        let whole = self.floor();
        let mut x = 1.0 + 9.0 * (self - whole);
        let mut k = whole;
        while k >= 1.0 {
            x *= 10.0;
            k -= 1.0;
        }
        while k <= -1.0 {
            x /= 10.0;
            k += 1.0;
        }
        x
    }
}
