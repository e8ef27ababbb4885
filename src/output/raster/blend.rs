//! Colours onto opaque pixels.

use super::coverage::{LEVELS, Span};
use crate::drawing::Paint;

/// How fine the colours at an edge are.
///
/// An edge is smooth for the eye with sixteen levels; where an image has two pixels or more for a page pixel,
/// with eight, as the eye sees the mean of four. Fewer colours make a smaller file: most figures then fit a
/// palette, which halves it.
#[derive(Clone, Copy)]
pub(super) struct Fineness {
    /// Neighbouring levels of coverage that count as one.
    step: u32,
    /// Neighbouring values of a channel that count as one where a pixel is covered in part.
    grain: u32,
}

impl Fineness {
    /// Image pixels of a page pixel from which on an edge may be coarser: between the page's own size, which
    /// needs sixteen levels, and twice that, which needs eight.
    const DENSE: f64 = 1.5;

    /// The fineness of an image with `scale` pixels for a page pixel.
    pub(super) fn at(scale: f64) -> Self {
        if scale < Self::DENSE { Self { step: 1, grain: 1 } } else { Self { step: 2, grain: 8 } }
    }
}

/// A paint ready to be laid on.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    /// Red, green, blue.
    channels: [u32; 3],
    /// The opacity in 255ths.
    alpha: u32,
    /// How fine its edges are.
    fineness: Fineness,
}

impl Ink {
    /// The ink of a paint in an image of that fineness.
    pub(super) fn of(paint: &Paint, fineness: Fineness) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let alpha = (paint.opacity.clamp(0.0, 1.0) * 255.0).round() as u32;
        Self { channels: [paint.color.r, paint.color.g, paint.color.b].map(u32::from), alpha, fineness }
    }

    /// The pixel that this ink at a level of coverage makes of one.
    fn over(self, pixel: [u8; 4], level: u32) -> [u8; 4] {
        const WHOLE: u32 = 255 * LEVELS;
        let level = self.visible_level(pixel, level);
        if level == 0 {
            return pixel;
        }
        let grain = if level == LEVELS { 1 } else { self.fineness.grain };
        let share = self.alpha * level;
        let mix = |ink: u32, under: u8| {
            let sum = ink * share + u32::from(under) * (WHOLE - share);
            let nearest = (sum + WHOLE / 2) / WHOLE;
            ((nearest + grain / 2) / grain * grain).min(255) as u8
        };
        let [r, g, b] = self.channels;
        [mix(r, pixel[0]), mix(g, pixel[1]), mix(b, pixel[2]), 255]
    }

    /// The level, rounded where the pixel is so near the ink that fewer levels are as smooth: no step between
    /// two levels is larger than it is between black and white.
    fn visible_level(self, pixel: [u8; 4], level: u32) -> u32 {
        let differences = self.channels.iter().zip(pixel).map(|(&ink, under)| ink.abs_diff(u32::from(under)));
        let contrast = differences.max().unwrap_or(0) * self.alpha / 255;
        let step = match contrast {
            0..=32 => LEVELS / 2,
            33..=64 => LEVELS / 4,
            65..=128 => LEVELS / 8,
            _ => self.fineness.step,
        };
        (level + step / 2) / step * step
    }
}

/// Lays an ink on; remembers what it makes of the colour that it met last, as most pixels of an area have the
/// same.
pub(super) struct Mixer {
    /// What is laid on.
    ink: Ink,
    /// The pixel that is covered wholly, where the ink is opaque.
    solid: [u8; 4],
    /// The colour met last.
    under: [u8; 4],
    /// The levels whose mixture with it is known, a bit each.
    known: u32,
    /// The mixtures that are known, by level.
    mixtures: [[u8; 4]; LEVELS as usize + 1],
}

impl Mixer {
    /// Nothing was met yet.
    pub(super) fn new(ink: Ink) -> Self {
        let solid = ink.over([0; 4], LEVELS);
        Self { ink, solid, under: [0; 4], known: 0, mixtures: [[0; 4]; LEVELS as usize + 1] }
    }

    /// The pixel that the ink at a level makes of one.
    #[inline]
    fn over(&mut self, under: [u8; 4], level: u32) -> [u8; 4] {
        if under != self.under {
            (self.under, self.known) = (under, 0);
        }
        let mixture = &mut self.mixtures[level as usize];
        if self.known >> level & 1 == 0 {
            *mixture = self.ink.over(under, level);
            self.known |= 1 << level;
        }
        *mixture
    }

    /// Lays the ink on the covered pixels of a row.
    pub(super) fn lay(&mut self, row: &mut [[u8; 4]], spans: &[Span]) {
        for span in spans {
            let covered = &mut row[span.start as usize..span.end as usize];
            if let [pixel] = covered {
                *pixel = self.over(*pixel, span.level);
                continue;
            }
            if span.level == LEVELS && self.ink.alpha == 255 {
                covered.fill(self.solid);
                continue;
            }
            // Neighbours mostly have one colour, and then one mixture.
            let mut rest = covered;
            while let Some(&first) = rest.first() {
                let count = run(rest, first);
                let (same, other) = rest.split_at_mut(count);
                same.fill(self.over(first, span.level));
                rest = other;
            }
        }
    }
}

/// How many pixels from the first on have its colour.
fn run(pixels: &[[u8; 4]], first: [u8; 4]) -> usize {
    const STRIDE: usize = 8;
    let strides = pixels.chunks_exact(STRIDE).take_while(|&stride| stride == [first; STRIDE]).count();
    let at = strides * STRIDE;
    at + pixels[at..].iter().take_while(|&&pixel| pixel == first).count()
}

/// Mixes pixels with those that were there before: `opacity` of 1 keeps them, 0 brings the old ones back.
pub(super) fn fade(pixels: &mut [[u8; 4]], before: &[[u8; 4]], opacity: f64) {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
    let share = (opacity.clamp(0.0, 1.0) * 255.0).round() as u32;
    for (pixel, old) in pixels.iter_mut().zip(before) {
        if pixel != old {
            for channel in 0..3 {
                let sum = u32::from(pixel[channel]) * share + u32::from(old[channel]) * (255 - share);
                #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes")]
                {
                    pixel[channel] = ((sum + 127) / 255) as u8;
                }
            }
        }
    }
}
