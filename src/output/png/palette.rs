//! The colours of an image, where 256 suffice.

use super::changes::Changes;
use crate::output::raster::Pixel;

/// Slots of the table: a power of two, and four times the colours, so that a search for one seldom goes on.
const SLOTS: usize = 1024;

/// Colours and their numbers.
pub(super) struct Palette {
    /// The colours in the order of their numbers, which is that of their first pixel in the image.
    colors: Vec<Pixel>,
    /// A colour's number plus 1, found by hash and linear search; 0 for an empty slot.
    slots: Vec<u16>,
}

impl Palette {
    /// All colours of an image and the numbers of its changed pixels, or `None` where there are more than
    /// 256.
    ///
    /// The colour above the first row is number 0.
    pub(super) fn of(image: &Changes) -> Option<(Self, Vec<u8>)> {
        let mut palette = Self { colors: Vec::with_capacity(256), slots: vec![0; SLOTS] };
        let mut numbers = Vec::with_capacity(image.pixels.len());
        let (mut last, mut number) = (image.above, palette.number(image.above)?);
        for &color in &image.pixels {
            if color != last {
                (last, number) = (color, palette.number(color)?);
            }
            numbers.push(number);
        }
        Some((palette, numbers))
    }

    /// Red, green and blue of each colour, as the chunk `PLTE` holds them.
    pub(super) fn bytes(&self) -> Vec<u8> {
        super::rgb(&self.colors)
    }

    /// The opacity of each colour, as the chunk `tRNS` holds them; `None` where all are opaque.
    pub(super) fn opacities(&self) -> Option<Vec<u8>> {
        let clear = !self.colors.iter().all(|color| super::is_opaque(*color));
        clear.then(|| self.colors.iter().map(|color| color[3]).collect())
    }

    /// The number of a colour, a new one where it has none; `None` where there are no more.
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "at most 256 colours")]
    fn number(&mut self, color: Pixel) -> Option<u8> {
        let mut slot = slot(color);
        loop {
            match usize::from(self.slots[slot]) {
                0 if self.colors.len() == 256 => return None,
                0 => {
                    self.colors.push(color);
                    self.slots[slot] = self.colors.len() as u16;
                    return Some((self.colors.len() - 1) as u8);
                }
                number if self.colors[number - 1] == color => return Some((number - 1) as u8),
                _ => slot = (slot + 1) % SLOTS,
            }
        }
    }
}

/// The slot in which the search for a colour begins: Knuth's multiplicative hash, 2³² over the golden ratio.
fn slot(color: Pixel) -> usize {
    (u32::from_le_bytes(color).wrapping_mul(0x9E37_79B1) >> 22) as usize % SLOTS
}
