//! APNG: drawings one after the other, in a file that any viewer of PNG opens.
//!
//! The first drawing is the image that a viewer without animation shows. All frames are RGB and whole: frames of a figure differ
//! in moving shapes, and what stays is cheap (see [`super::png`]).
//! Source: *Portable Network Graphics (PNG) Specification, Third Edition*, W3C 2025, section 11.3.8.

use super::png::{READER, SIGNATURE, chunk, draw, pack_rgb};
use super::{Depends, Format, Options, OutputError, Writer, raster};
use crate::drawing::Drawing;

/// The row of the table. Its files are read as any viewer of PNG shows them: by the first frame.
pub(super) const FORMAT: Format = Format {
    name: "apng",
    about: "animated PNG of a sequence of drawings",
    usual: false,
    depends: Depends::Pixels,
    write: Writer::Sequence(write),
    read: Some(READER),
};

/// How long a frame is shown, in milliseconds.
const FRAME: u16 = 80;

/// How long the last frame is shown, in milliseconds: the result is what the reader should see.
const LAST_FRAME: u16 = 1500;

fn write(drawings: &[&Drawing], options: &Options) -> Result<Vec<u8>, OutputError> {
    let Some(first) = drawings.first() else { return Err(OutputError::Sequence) };
    let count = u32::try_from(drawings.len()).map_err(|_| OutputError::Sequence)?;
    let mut out = SIGNATURE.to_vec();
    let mut sequence = 0_u32;
    for (i, drawing) in drawings.iter().enumerate() {
        if (drawing.width, drawing.height) != (first.width, first.height) {
            return Err(OutputError::Sequence);
        }
        let (width, height) = raster::size(drawing, options.scale)?;
        let packed = pack_rgb(draw(drawing, options.scale)?);
        if i == 0 {
            chunk(&mut out, *b"IHDR", &packed.header);
            // Count of frames, and 0 for playing without end.
            chunk(&mut out, *b"acTL", &[count.to_be_bytes(), [0; 4]].concat());
        }
        let delay = if i + 1 == drawings.len() { LAST_FRAME } else { FRAME };
        chunk(&mut out, *b"fcTL", &control(&mut sequence, width, height, delay));
        if i == 0 {
            chunk(&mut out, *b"IDAT", &packed.data);
        } else {
            let number = next(&mut sequence);
            chunk(&mut out, *b"fdAT", &[number.as_slice(), &packed.data].concat());
        }
    }
    chunk(&mut out, *b"IEND", &[]);
    Ok(out)
}

/// The control chunk of a frame: number, size, place, delay in thousandths of a second, and that it replaces what is there.
fn control(sequence: &mut u32, width: u32, height: u32, delay: u16) -> Vec<u8> {
    let mut bytes = next(sequence).to_vec();
    for value in [width, height, 0, 0] {
        bytes.extend(value.to_be_bytes());
    }
    bytes.extend(delay.to_be_bytes());
    bytes.extend(1000_u16.to_be_bytes());
    bytes.extend([0, 0]);
    bytes
}

fn next(sequence: &mut u32) -> [u8; 4] {
    let number = *sequence;
    *sequence += 1;
    number.to_be_bytes()
}

#[cfg(test)]
mod tests {
    use super::super::rasterize;
    use super::super::samples::everything;
    use super::*;

    #[test]
    fn every_frame_can_be_read_and_shows_its_drawing() {
        let first = everything();
        let mut second = first.clone();
        second.items.truncate(3);
        let options = Options { scale: 0.5, ..Options::default() };
        let file = write(&[&first, &second], &options).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        assert_eq!(reader.info().animation_control.map(|a| a.num_frames), Some(2));
        for drawing in [first, second] {
            let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut rgb).unwrap();
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
