//! The colours of an image, where 256 suffice.

use super::rows::Span;

/// Slots of the table, a power of two, four times the colours.
const SLOTS: usize = 1024;

/// Colours and their numbers.
pub(super) struct Palette {
    /// In order of their first pixel in the image.
    colors: Vec<[u8; 4]>,
    /// A colour's number plus 1, found by hash and linear search; 0 for an empty slot.
    slots: Vec<u16>,
}

impl Palette {
    /// All colours of the image, or `None` if there are more than 256. Pixels outside the spans equal those above, and
    /// above the first row is `background`.
    pub(super) fn of(pixels: &[[u8; 4]], width: usize, spans: &[Span], background: [u8; 4]) -> Option<Self> {
        let mut palette = Self { colors: Vec::with_capacity(256), slots: vec![0; SLOTS] };
        palette.insert(background)?;
        for span in spans {
            let mut last = None;
            for &color in span.of(pixels, width) {
                if last != Some(color) {
                    palette.insert(color)?;
                    last = Some(color);
                }
            }
        }
        Some(palette)
    }

    /// The chunk `PLTE`.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.colors.iter().flat_map(|c| [c[0], c[1], c[2]]).collect()
    }

    /// The number of a colour; 0 for one that is not there.
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "at most 256 colours")]
    pub(super) fn index(&self, color: [u8; 4]) -> u8 {
        let mut slot = slot(color);
        loop {
            match usize::from(self.slots[slot]) {
                0 => return 0,
                number if self.colors[number - 1] == color => return (number - 1) as u8,
                _ => slot = (slot + 1) % SLOTS,
            }
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "at most 256 colours")]
    fn insert(&mut self, color: [u8; 4]) -> Option<()> {
        let mut slot = slot(color);
        loop {
            match usize::from(self.slots[slot]) {
                0 if self.colors.len() == 256 => return None,
                0 => {
                    self.colors.push(color);
                    self.slots[slot] = self.colors.len() as u16;
                    return Some(());
                }
                number if self.colors[number - 1] == color => return Some(()),
                _ => slot = (slot + 1) % SLOTS,
            }
        }
    }
}

fn slot(color: [u8; 4]) -> usize {
    (u32::from_le_bytes(color).wrapping_mul(0x9E37_79B1) >> 22) as usize % SLOTS
}
