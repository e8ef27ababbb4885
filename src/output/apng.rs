//! APNG: drawings one after the other, in a file that any viewer of PNG opens.
//!
//! The first drawing is the image that a viewer without animation shows. All frames are RGB, with opacity
//! where a page has no background, and whole: frames of a figure differ in moving shapes, and what stays is
//! cheap, as it repeats (see [`super::png`]). A frame is in memory while it is packed: the stream writer of
//! `png` 0.18.1, which takes rows, puts the number of a chunk into the data of the first frame, and no viewer
//! opens that (image-rs/image-png, issue 411; mended since).
//! Source: *Portable Network Graphics (PNG) Specification, Third Edition*, W3C 2025, section 11.3.8.

use super::hold::holds;
use super::motion::played;
use super::png::{BRACKET, KEYWORD, READER, encoder};
use super::{Depends, Format, InMotion, InSteps, Options, OutputError, PngEffort, Writer, raster};
use crate::drawing::Drawing;

/// The row of the table. Its files are read picture by picture.
pub(super) const FORMAT: Format = Format {
    name: "apng",
    about: "animated PNG of a sequence of drawings",
    media_type: "image/apng",
    usual: false,
    in_the_dark: false,
    depends: Depends::Pixels,
    write: Writer::Sequence(write),
    in_steps: Some(write_steps),
    in_motion: Some(write_motion),
    bind: None,
    bracket: BRACKET,
    read: Some(READER),
    live: None,
};

/// How long a frame is shown, in milliseconds.
const FRAME: u32 = 80;

/// How long the last frame is shown, in milliseconds: the result is what the reader should see.
const LAST_FRAME: u32 = 1500;

/// What a second has of the unit of those times.
const MILLISECONDS: u16 = 1000;

/// How many times the sequence is played: 0 stands for without end.
const PLAYS: u32 = 0;

/// How many times steps are played: the last one stays.
const ONCE: u32 = 1;

fn write(drawings: &[&Drawing], options: &Options) -> Result<Vec<u8>, OutputError> {
    let last = drawings.len().saturating_sub(1);
    let times: Vec<u32> = (0..drawings.len()).map(|i| if i == last { LAST_FRAME } else { FRAME }).collect();
    animation(drawings, &times, PLAYS, options)
}

/// Writes a frame for each step, played once: the figure stays.
fn write_steps(drawing: &Drawing, options: &Options, in_steps: InSteps) -> Result<Vec<u8>, OutputError> {
    let steps: Vec<Drawing> = (1..=drawing.steps.len()).map(|step| drawing.at_step(step)).collect();
    animation(&steps.iter().collect::<Vec<_>>(), &holds(drawing, in_steps), ONCE, options)
}

/// Writes all pictures of a figure that plays, again and again.
fn write_motion(drawing: &Drawing, options: &Options, in_motion: InMotion) -> Result<Vec<u8>, OutputError> {
    let (pictures, times) = played(drawing, options, (in_motion, f64::from(MILLISECONDS)))?;
    animation(&pictures, &times, PLAYS, options)
}

/// An animation of drawings, each shown for some milliseconds.
fn animation(
    drawings: &[&Drawing],
    times: &[u32],
    plays: u32,
    options: &Options,
) -> Result<Vec<u8>, OutputError> {
    let [first, ..] = drawings else { return Err(OutputError::Sequence) };
    if drawings.iter().any(|drawing| (drawing.width, drawing.height) != (first.width, first.height)) {
        return Err(OutputError::Sequence);
    }
    let is_clear = drawings.iter().any(|drawing| drawing.is_transparent());
    let count = u32::try_from(drawings.len()).map_err(|_| OutputError::Sequence)?;
    let mut out = Vec::new();
    let mut encoder = encoder(&mut out, raster::size(first, options.scale)?, PngEffort::Fast);
    if is_clear {
        encoder.set_color(png::ColorType::Rgba);
    }
    let refused = |error| OutputError::encoder(&error);
    encoder.set_animated(count, plays).map_err(refused)?;
    if let Some(hash) = drawings.last().map(|last| &last.hash).filter(|hash| !hash.is_empty()) {
        encoder.add_text_chunk(KEYWORD.to_owned(), hash.clone()).map_err(refused)?;
    }
    let mut writer = encoder.write_header().map_err(refused)?;
    for (drawing, time) in drawings.iter().zip(times) {
        let (count, parts) = delay(*time);
        writer.set_frame_delay(count, parts).map_err(refused)?;
        writer.write_image_data(&frame(drawing, options.scale, is_clear)?).map_err(refused)?;
    }
    writer.finish().map_err(refused)?;
    Ok(out)
}

/// Some milliseconds as a count of parts of a second, each of 16 bits; of more than a minute the parts are
/// coarser.
fn delay(milliseconds: u32) -> (u16, u16) {
    let parts = [MILLISECONDS, 100, 10, 1];
    let count = |parts: u16| u16::try_from(milliseconds / u32::from(MILLISECONDS / parts)).ok();
    parts.into_iter().find_map(|parts| Some((count(parts)?, parts))).unwrap_or((u16::MAX, 1))
}

/// Every pixel of a drawing: red, green, blue, and opacity where some frame `is_clear`.
fn frame(drawing: &Drawing, scale: f64, is_clear: bool) -> Result<Vec<u8>, OutputError> {
    let (width, height) = raster::size(drawing, scale)?;
    let channels = if is_clear { 4 } else { 3 };
    let mut bytes = Vec::with_capacity(channels * width as usize * height as usize);
    raster::rows(drawing, scale, |_, row| row.iter().for_each(|p| bytes.extend_from_slice(&p[..channels])))?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::super::rasterize;
    use super::super::samples::everything;
    use super::*;

    #[test]
    fn a_long_time_is_counted_in_coarser_parts() {
        let delays = [0, 65_535, 65_536, 100_000, 600_000].map(delay);
        assert_eq!(delays, [(0, 1000), (65_535, 1000), (6_553, 100), (10_000, 100), (60_000, 100)]);
    }

    #[test]
    fn every_frame_can_be_read_and_shows_its_drawing() {
        let first = everything();
        let mut second = first.clone();
        second.items.truncate(3);
        let options = Options { scale: 0.5, ..Options::default() };
        let file = write(&[&first, &second], &options).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        assert_eq!(reader.info().animation_control.map(|a| (a.num_frames, a.num_plays)), Some((2, 0)));
        for (drawing, time) in [(first, FRAME), (second, LAST_FRAME)] {
            let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut rgb).unwrap();
            let control = reader.info().frame_control.unwrap();
            assert_eq!((control.delay_num, control.delay_den), (u16::try_from(time).unwrap(), 1000));
            let pixels = rasterize(&drawing, 0.5).unwrap();
            let expected: Vec<u8> = pixels.rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
            assert!(rgb == expected);
        }
    }

    #[test]
    fn drawings_of_two_sizes_are_no_sequence() {
        let first = everything();
        let second = Drawing { width: 100.0, ..first.clone() };
        assert_eq!(write(&[&first, &second], &Options::default()), Err(OutputError::Sequence));
        assert_eq!(write(&[], &Options::default()), Err(OutputError::Sequence));
    }
}
