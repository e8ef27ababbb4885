//! GIF: drawings one after the other, for mail, chats and slides that take no other animation.
//!
//! A GIF has 256 colours. Those are taken that most dots have, over all frames: the colours of the theme and
//! what lies between two of them at an edge; any other dot gets the nearest. Of each frame only the rectangle
//! is written that differs from the frame before. Frames are drawn twice, once to count colours, so that at
//! most two are in memory.
//! Source: *Graphics Interchange Format, Version 89a*, `CompuServe` 1990.

use std::borrow::Cow;
use std::collections::BTreeMap;

use gif::{AnyExtension, DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::hold::holds;
use super::motion::played;
use super::{
    Bracket, Depends, Format, InMotion, InSteps, Options, OutputError, Pixel, Reader, Stamped, Writer, raster,
};
use crate::drawing::Drawing;

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "gif",
    about: "animation in 256 colours, for what takes no other",
    media_type: "image/gif",
    usual: false,
    in_the_dark: false,
    depends: Depends::Pixels,
    write: Writer::Sequence(write),
    bind: None,
    in_steps: Some(write_steps),
    in_motion: Some(write_motion),
    bracket: Bracket { begins: &[b"GIF89a".as_slice()], ends: &[b"\x3b".as_slice()] },
    // Its colours are those nearest to the drawing's, so files are compared byte by byte.
    read: Some(Reader { stamp, picture: None }),
    live: None,
};

/// Hundredths of a second that a frame is shown at least: players take less for no time at all.
const LEAST: u32 = 2;

/// What the comment with the scene's hash begins with.
const KEYWORD: &str = "tracefig ";
/// The label of a comment (section 24).
const COMMENT: u8 = 0xFE;
/// The most colours of a GIF.
const MOST_COLORS: usize = 256;
/// The most bytes of a part of a comment.
const MOST_PART: usize = 255;
/// Hundredths of a second that a frame of a motion is shown, and the last one.
const FRAMES: [u16; 2] = [8, 150];
/// What a second has of the unit of times.
const HUNDREDTHS: u16 = 100;
/// Opacity from which on a dot is drawn: there is all or nothing.
const OPAQUE: u8 = 128;

/// The hash that a file says of itself.
fn stamp(bytes: &[u8]) -> Option<Stamped> {
    let at = bytes.windows(KEYWORD.len()).position(|part| part == KEYWORD.as_bytes())?;
    let length = usize::from(*bytes.get(at.checked_sub(1)?)?).checked_sub(KEYWORD.len())?;
    let begin = at + KEYWORD.len();
    let text = std::str::from_utf8(bytes.get(begin..begin + length)?).ok()?;
    Some(Stamped::Hash(text.to_owned()))
}

fn write(drawings: &[&Drawing], options: &Options) -> Result<Vec<u8>, OutputError> {
    let last = drawings.len().saturating_sub(1);
    let times: Vec<u16> = (0..drawings.len()).map(|i| FRAMES[usize::from(i == last)]).collect();
    animation(drawings, &times, Repeat::Infinite, options)
}

/// Writes a frame for each step, played once: the figure stays.
fn write_steps(drawing: &Drawing, options: &Options, in_steps: InSteps) -> Result<Vec<u8>, OutputError> {
    let steps: Vec<Drawing> = (1..=drawing.steps.len()).map(|step| drawing.at_step(step)).collect();
    let hundredths = |time: u32| u16::try_from((time / 10).max(LEAST)).unwrap_or(u16::MAX);
    let times = holds(drawing, in_steps).into_iter().map(hundredths);
    animation(&steps.iter().collect::<Vec<_>>(), &times.collect::<Vec<_>>(), Repeat::Finite(0), options)
}

/// Writes all pictures of a figure that plays, again and again.
fn write_motion(drawing: &Drawing, options: &Options, in_motion: InMotion) -> Result<Vec<u8>, OutputError> {
    let (pictures, times) = played(drawing, options, (in_motion, f64::from(HUNDREDTHS)))?;
    // The longest that is asked for is ten minutes, and eleven fit.
    let times: Vec<u16> = times.into_iter().map(|time| u16::try_from(time).unwrap_or(u16::MAX)).collect();
    animation(&pictures, &times, Repeat::Infinite, options)
}

/// An animation of drawings of one size, each shown for some hundredths of a second.
fn animation(
    drawings: &[&Drawing],
    times: &[u16],
    repeat: Repeat,
    options: &Options,
) -> Result<Vec<u8>, OutputError> {
    let [first, ..] = drawings else { return Err(OutputError::Sequence) };
    if drawings.iter().any(|drawing| (drawing.width, drawing.height) != (first.width, first.height)) {
        return Err(OutputError::Sequence);
    }
    let scale = options.scale;
    let (width, height) = raster::size(first, scale)?;
    let most = f64::from(u16::MAX) / first.width.max(first.height);
    let too_large = |_| OutputError::TooLarge { scale, largest: most };
    let size = (u16::try_from(width).map_err(too_large)?, u16::try_from(height).map_err(too_large)?);
    let mut colors = Colors::of(drawings, scale)?;
    let refused = |error: EncodingError| OutputError::encoder(&error);
    let mut out = Vec::new();
    let mut encoder = Encoder::new(&mut out, size.0, size.1, &colors.bytes()).map_err(refused)?;
    // Without a count a file is played once.
    if let Repeat::Infinite = repeat {
        encoder.set_repeat(repeat).map_err(refused)?;
    }
    if let Some(hash) = drawings.last().map(|last| &last.hash).filter(|hash| !hash.is_empty()) {
        let comment = format!("{KEYWORD}{hash}");
        let parts: Vec<&[u8]> = comment.as_bytes().chunks(MOST_PART).collect();
        encoder.write_raw_extension(AnyExtension(COMMENT), &parts).map_err(refused)?;
    }
    let mut before: Option<Vec<u8>> = None;
    for (drawing, time) in drawings.iter().zip(times) {
        let dots = colors.dots(drawing, scale)?;
        let frame = changed(before.as_deref(), &dots, size, *time, colors.clear);
        encoder.write_frame(&frame).map_err(refused)?;
        before = Some(dots);
    }
    drop(encoder);
    Ok(out)
}

/// What a frame has that the one before has not; of the first one all.
fn changed(
    before: Option<&[u8]>,
    dots: &[u8],
    (width, height): (u16, u16),
    delay: u16,
    clear: Option<u8>,
) -> Frame<'static> {
    let row = usize::from(width);
    // What was there can't be made see-through again, so a page without a background is written anew.
    let known = before.filter(|_| clear.is_none());
    let area = known.map_or((0, 0, width, height), |before| differing(before, dots, (width, height)));
    let (left, top, wide, high) = area;
    let rows = dots.chunks_exact(row).skip(usize::from(top)).take(usize::from(high));
    let buffer = rows.flat_map(|r| &r[usize::from(left)..usize::from(left) + usize::from(wide)]);
    let dispose = if clear.is_some() { DisposalMethod::Background } else { DisposalMethod::Keep };
    Frame {
        delay,
        dispose,
        transparent: clear,
        top,
        left,
        width: wide,
        height: high,
        buffer: Cow::Owned(buffer.copied().collect()),
        ..Frame::default()
    }
}

/// The rectangle in which two frames differ: left, top, width, height; a dot where they are the same.
fn differing(before: &[u8], now: &[u8], (width, height): (u16, u16)) -> (u16, u16, u16, u16) {
    let row = usize::from(width);
    let (mut x, mut y) = ((width, 0), (height, 0));
    let rows = (0..height).zip(before.chunks_exact(row).zip(now.chunks_exact(row)));
    for (at, (old, new)) in rows.filter(|(_, (old, new))| old != new) {
        y = (y.0.min(at), at + 1);
        let differ = (0..width).zip(old.iter().zip(new)).filter(|(_, (a, b))| a != b).map(|(at, _)| at);
        for at in differ {
            x = (x.0.min(at), x.1.max(at + 1));
        }
    }
    if y.1 == 0 { (0, 0, 1, 1) } else { (x.0, y.0, x.1 - x.0, y.1 - y.0) }
}

/// The colours of an animation.
struct Colors {
    /// The palette.
    all: Vec<[u8; 3]>,
    /// The number of what is see-through, after the palette; none where all pages have a background.
    clear: Option<u8>,
    /// The numbers of the colours that were looked up.
    known: BTreeMap<[u8; 3], u8>,
}

impl Colors {
    /// The colours that most dots of all drawings have.
    fn of(drawings: &[&Drawing], scale: f64) -> Result<Self, OutputError> {
        let is_clear = drawings.iter().any(|drawing| drawing.is_transparent());
        let mut counts: BTreeMap<[u8; 3], u64> = BTreeMap::new();
        for drawing in drawings {
            raster::rows(drawing, scale, |_, row| {
                for run in row.chunk_by(|a, b| a == b).filter(|run| run[0][3] >= OPAQUE) {
                    let [r, g, b, _] = run[0];
                    *counts.entry([r, g, b]).or_default() += run.len() as u64;
                }
            })?;
        }
        let mut all: Vec<([u8; 3], u64)> = counts.into_iter().collect();
        all.sort_by_key(|(color, count)| (std::cmp::Reverse(*count), *color));
        all.truncate(MOST_COLORS - usize::from(is_clear));
        let clear = u8::try_from(all.len()).ok().filter(|_| is_clear);
        Ok(Self { all: all.into_iter().map(|(color, _)| color).collect(), clear, known: BTreeMap::new() })
    }

    /// The bytes of the palette.
    fn bytes(&self) -> Vec<u8> {
        let clear = self.clear.map(|_| [0; 3]);
        self.all.iter().copied().chain(clear).flatten().collect()
    }

    /// The number of every dot of a drawing.
    fn dots(&mut self, drawing: &Drawing, scale: f64) -> Result<Vec<u8>, OutputError> {
        let mut dots = Vec::new();
        raster::rows(drawing, scale, |_, row| {
            for run in row.chunk_by(|a, b| a == b) {
                let number = self.number(run[0]);
                dots.extend(std::iter::repeat_n(number, run.len()));
            }
        })?;
        Ok(dots)
    }

    /// The number of the nearest colour.
    fn number(&mut self, [r, g, b, opacity]: Pixel) -> u8 {
        if let Some(clear) = self.clear.filter(|_| opacity < OPAQUE) {
            return clear;
        }
        let all = &self.all;
        *self.known.entry([r, g, b]).or_insert_with(|| {
            let apart = |color: &[u8; 3]| -> u32 {
                let channels = color.iter().zip([r, g, b]);
                channels.map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
            };
            let nearest = (0_u8..=u8::MAX).zip(all).min_by_key(|(_, color)| apart(color));
            nearest.map_or(0, |(number, _)| number)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::rasterize;
    use crate::output::samples::everything;

    /// The frames that an independent decoder shows, as red, green and blue, with their times.
    fn decoded(bytes: &[u8]) -> Vec<(Vec<u8>, u16)> {
        let mut reader = gif::Decoder::new(bytes).unwrap();
        let palette = reader.global_palette().unwrap().to_vec();
        let width = usize::from(reader.width());
        let mut screen = vec![0_u8; 3 * width * usize::from(reader.height())];
        let mut frames = Vec::new();
        while let Some(frame) = reader.read_next_frame().unwrap() {
            for (i, &dot) in frame.buffer.iter().enumerate() {
                let (x, y) = (i % usize::from(frame.width), i / usize::from(frame.width));
                let at = 3 * ((y + usize::from(frame.top)) * width + x + usize::from(frame.left));
                screen[at..at + 3].copy_from_slice(&palette[3 * usize::from(dot)..][..3]);
            }
            frames.push((screen.clone(), frame.delay));
        }
        frames
    }

    #[test]
    fn frames_are_the_drawings_within_a_few_levels_and_only_what_differs_is_written() {
        let whole = everything();
        let mut less = everything();
        less.items.truncate(2);
        let options = Options { scale: 0.5, ..Options::default() };
        let bytes = write(&[&less, &whole, &whole], &options).unwrap();
        let frames = decoded(&bytes);
        assert_eq!(frames.iter().map(|(_, time)| *time).collect::<Vec<_>>(), [8, 8, 150]);
        for ((shown, _), drawing) in frames.iter().zip([&less, &whole, &whole]) {
            let pixels = rasterize(drawing, 0.5).unwrap();
            let dots = pixels.rgba.as_chunks::<4>().0;
            let off = dots
                .iter()
                .zip(shown.as_chunks::<3>().0)
                .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap());
            let off: Vec<u8> = off.collect();
            let far = off.iter().filter(|off| **off > 24).count();
            assert!(far * 1000 < off.len(), "{far} of {} dots are more than 24 levels off", off.len());
        }
        let twice = write(&[&whole], &options).unwrap();
        assert!(bytes.len() < 3 * twice.len());
    }

    #[test]
    fn the_hash_is_read_again() {
        let drawing = everything();
        let bytes = write(&[&drawing], &Options { scale: 0.1, ..Options::default() }).unwrap();
        assert_eq!(stamp(&bytes), Some(Stamped::Hash(drawing.hash)));
    }
}
