//! Numbers of seven bits a byte.

/// Numbers, packed.
#[derive(Default)]
pub(super) struct Numbers(pub(super) Vec<u8>);

impl Numbers {
    /// A number from 0.
    pub(super) fn number(&mut self, mut number: u32) {
        while number > 127 {
            self.0.push(u8::try_from(number & 127).unwrap_or(0) | 128);
            number >>= 7;
        }
        self.0.push(u8::try_from(number).unwrap_or(0));
    }

    /// How many there are of something.
    pub(super) fn count(&mut self, count: usize) {
        self.number(u32::try_from(count).unwrap_or(u32::MAX));
    }

    /// A number of either sign.
    pub(super) fn signed(&mut self, number: i32) {
        self.number(folded(number));
    }

    /// Numbers from 0.
    pub(super) fn numbers(&mut self, numbers: impl IntoIterator<Item = u32>) {
        for number in numbers {
            self.number(number);
        }
    }

    /// Numbers of either sign.
    pub(super) fn all_signed(&mut self, numbers: impl IntoIterator<Item = i32>) {
        for number in numbers {
            self.signed(number);
        }
    }

    /// The numbers of glyphs, each from the one before.
    pub(super) fn ids(&mut self, before: u16, ids: &[u16]) {
        self.count(ids.len());
        for (k, &id) in ids.iter().enumerate() {
            let before = if k == 0 { before } else { ids[k - 1] };
            self.signed(i32::from(id) - i32::from(before));
        }
    }
}

/// A number of either sign as one from 0: 0, −1, 1, −2 are 0, 1, 2, 3.
pub(super) fn folded(number: i32) -> u32 {
    let from_zero = if number < 0 { -1 - number } else { number };
    from_zero.cast_unsigned() * 2 + u32::from(number < 0)
}
