//! Colours onto opaque pixels.

use super::coverage::{LEVELS, Span};
use crate::drawing::Paint;

/// A paint ready to be laid on: its channels and its opacity in 255ths.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    channels: [u32; 3],
    alpha: u32,
}

impl Ink {
    pub(super) fn of(paint: &Paint) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let alpha = (paint.opacity.clamp(0.0, 1.0) * 255.0).round() as u32;
        Self { channels: [paint.color.r, paint.color.g, paint.color.b].map(u32::from), alpha }
    }

    /// The pixel that this ink at a level of coverage makes of one: the nearest to the exact mixture.
    fn over(self, pixel: [u8; 4], level: u32) -> [u8; 4] {
        const WHOLE: u32 = 255 * LEVELS;
        let share = self.alpha * self.visible_level(pixel, level);
        let mix = |ink: u32, under: u8| {
            let sum = ink * share + u32::from(under) * (WHOLE - share);
            #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes")]
            {
                ((sum + WHOLE / 2) / WHOLE) as u8
            }
        };
        let [r, g, b] = self.channels;
        [mix(r, pixel[0]), mix(g, pixel[1]), mix(b, pixel[2]), 255]
    }
    /// The level, rounded where the pixel is so near the ink that fewer levels are as smooth: no step between two levels
    /// is larger than the one between black and white, 16 of 255. Fewer colours make a smaller file.
    fn visible_level(self, pixel: [u8; 4], level: u32) -> u32 {
        let differences = self.channels.iter().zip(pixel).map(|(&ink, under)| ink.abs_diff(u32::from(under)));
        let contrast = differences.max().unwrap_or(0) * self.alpha / 255;
        let step = match contrast {
            0..=32 => LEVELS / 2,
            33..=64 => LEVELS / 4,
            65..=128 => LEVELS / 8,
            _ => 1,
        };
        (level + step / 2) / step * step
    }
}

/// Lays ink on the covered pixels of an image whose rows have `width` pixels.
pub(super) fn lay(pixels: &mut [[u8; 4]], width: usize, spans: &[Span], ink: Ink) {
    let solid = ink.over([0; 4], LEVELS);
    for span in spans {
        let row = span.y as usize * width;
        let covered = &mut pixels[row + span.start as usize..row + span.end as usize];
        if span.level == LEVELS && ink.alpha == 255 {
            covered.fill(solid);
            continue;
        }
        // Neighbours mostly have one colour, and then one mixture.
        let mut last = [0; 4];
        let mut mixture = [0; 4];
        for pixel in covered {
            if *pixel != last {
                last = *pixel;
                mixture = ink.over(last, span.level);
            }
            *pixel = mixture;
        }
    }
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
