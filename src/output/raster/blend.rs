//! Colours onto pixels: opaque ones, and those of a page that has no background.

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
        if pixel[3] < 255 {
            return self.onto_clear(pixel, share, WHOLE, grain);
        }
        let mix = |ink: u32, under: u8| {
            let sum = ink * share + u32::from(under) * (WHOLE - share);
            let nearest = (sum + WHOLE / 2) / WHOLE;
            ((nearest + grain / 2) / grain * grain).min(255) as u8
        };
        let [r, g, b] = self.channels;
        [mix(r, pixel[0]), mix(g, pixel[1]), mix(b, pixel[2]), 255]
    }

    /// The pixel that `share` of `whole` of this ink makes of one that is not opaque. With opacities a of the
    /// ink and b of the pixel, colours p and q:
    ///
    /// ```text
    /// c = a + b (1 − a)      (p a + q b (1 − a)) / c
    /// ```
    #[expect(clippy::cast_possible_truncation, reason = "means of bytes")]
    fn onto_clear(self, pixel: [u8; 4], share: u32, whole: u32, grain: u32) -> [u8; 4] {
        let (whole, share) = (u64::from(whole), u64::from(share));
        // Both parts of the opacity in units of 1 / (255 · whole).
        let (ink, under) = (255 * share, u64::from(pixel[3]) * (whole - share));
        let sum = ink + under;
        if sum == 0 {
            return pixel;
        }
        let grain = u64::from(grain);
        let alpha = (sum + whole / 2) / whole;
        let alpha = ((alpha + grain / 2) / grain * grain).min(255) as u8;
        let mix = |p: u32, q: u8| ((u64::from(p) * ink + u64::from(q) * under + sum / 2) / sum) as u8;
        let [r, g, b] = self.channels;
        let mixed = [mix(r, pixel[0]), mix(g, pixel[1]), mix(b, pixel[2]), alpha];
        // One colour for nothing.
        if alpha == 0 { [0; 4] } else { mixed }
    }

    /// The level, rounded where the pixel is so near the ink that fewer levels are as smooth: no step between
    /// two levels is larger than it is between black and white.
    fn visible_level(self, pixel: [u8; 4], level: u32) -> u32 {
        let differences = self.channels.iter().zip(pixel).map(|(&ink, under)| ink.abs_diff(u32::from(under)));
        let clear = u32::from(255 - pixel[3]);
        let contrast = differences.max().unwrap_or(0).max(clear) * self.alpha / 255;
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
        let solid = ink.over([0, 0, 0, 255], LEVELS);
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
        if pixel != old && (pixel[3] < 255 || old[3] < 255) {
            *pixel = between(*pixel, *old, share);
        } else if pixel != old {
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

/// The mean of two pixels of any opacity, `share` 255ths of the first.
#[expect(clippy::cast_possible_truncation, reason = "means of bytes")]
fn between(pixel: [u8; 4], old: [u8; 4], share: u32) -> [u8; 4] {
    let (new, was) = (u32::from(pixel[3]) * share, u32::from(old[3]) * (255 - share));
    let sum = new + was;
    let alpha = (sum + 127) / 255;
    if alpha == 0 {
        return [0; 4];
    }
    let mix = |p: u8, q: u8| ((u32::from(p) * new + u32::from(q) * was + sum / 2) / sum) as u8;
    [mix(pixel[0], old[0]), mix(pixel[1], old[1]), mix(pixel[2], old[2]), alpha as u8]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Color, Role};

    fn ink(rgb: u32, opacity: f64) -> Ink {
        Ink::of(&Paint::role(Role::Ink, Color::hex(rgb)).with_opacity(opacity), Fineness::at(1.0))
    }

    #[test]
    fn ink_on_nothing_keeps_its_colour_and_its_share() {
        assert_eq!(ink(0x0010_2030, 1.0).over([0; 4], LEVELS), [0x10, 0x20, 0x30, 255]);
        assert_eq!(ink(0x0010_2030, 1.0).over([0; 4], LEVELS / 2), [0x10, 0x20, 0x30, 128]);
        assert_eq!(ink(0xFF_FFFF, 0.5).over([0; 4], LEVELS)[3], 128);
        assert_eq!(ink(0xFF_FFFF, 1.0).over([0; 4], 0), [0; 4]);
    }

    #[test]
    fn a_transparent_picture_laid_on_white_is_the_picture_on_white() {
        let white = |[r, g, b, a]: [u8; 4]| {
            [r, g, b].map(|c| (u32::from(c) * u32::from(a) + 255 * (255 - u32::from(a))) / 255)
        };
        let layers = [(0xA3_161F, 0.14, LEVELS), (0x00_856F, 0.5, LEVELS / 2), (0x0B_5FCC, 1.0, LEVELS / 4)];
        let (mut clear, mut opaque) = ([0; 4], [255; 4]);
        for (rgb, opacity, level) in layers {
            clear = ink(rgb, opacity).over(clear, level);
            opaque = ink(rgb, opacity).over(opaque, level);
            let apart = white(clear).iter().zip(opaque).map(|(&a, b)| a.abs_diff(u32::from(b))).max();
            assert!(apart <= Some(24), "{clear:?} {opaque:?}");
        }
    }

    #[test]
    fn half_of_a_group_over_nothing_is_half_as_opaque() {
        let mut pixels = [[9, 8, 7, 255], [9, 8, 7, 100], [0; 4]];
        fade(&mut pixels, &[[0; 4]; 3], 0.5);
        assert_eq!(pixels, [[9, 8, 7, 128], [9, 8, 7, 50], [0; 4]]);
    }
}
