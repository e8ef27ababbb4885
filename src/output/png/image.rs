//! A PNG read again, whoever wrote it, and an image that comes row by row as a PNG.

use std::cell::RefCell;
use std::io::{self, Cursor, Write};
use std::rc::Rc;

use super::super::picture::{Later, MOST_A_SIDE, Pace, Picture, TooMuch, Unread};
use super::super::{MOST_PIXELS, PngEffort, Reader, Stamped};
use super::raster::Pixel;
use super::{CHUNK, KEYWORD, encoder};

/// Reads PNG, and APNG whose pictures are whole, as ours are.
pub(in crate::output) const READER: Reader = Reader { stamp, picture: Some(picture) };

/// Pixels of the largest image that comes in several passes, which has to be in memory to have rows. None of
/// ours does, but other programs that pack our images may make such.
const MOST_IN_PASSES: usize = 1 << 24;

/// The hash in the text chunk of our keyword.
fn stamp(bytes: &[u8]) -> Option<Stamped> {
    let reader = png::Decoder::new(Cursor::new(bytes)).read_info().ok()?;
    let text = reader.info().uncompressed_latin1_text.iter().find(|text| text.keyword == KEYWORD)?;
    Some(Stamped::Hash(text.text.clone()))
}

/// A file whose head says that it is a PNG of a size that ours may have.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Image<'b> {
    /// The file.
    bytes: &'b [u8],
}

fn picture(bytes: &[u8]) -> Result<Picture<'_>, Unread> {
    let reader = png::Decoder::new(Cursor::new(bytes)).read_info().map_err(|_| Unread::Other)?;
    let info = reader.info();
    let (width, height) = (f64::from(info.width), f64::from(info.height));
    let too_much = |what, most| Err(Unread::TooMuch(TooMuch { what, most }));
    if info.width.max(info.height) as usize > MOST_A_SIDE {
        return too_much("pixels a side", MOST_A_SIDE);
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number, 2^26")]
    let most = if info.interlaced { MOST_IN_PASSES } else { MOST_PIXELS as usize };
    #[expect(clippy::cast_precision_loss, reason = "at most 2^26")]
    if width * height > most as f64 {
        return too_much("pixels", most);
    }
    Ok(Picture::Image(Image { bytes }))
}

impl<'b> Image<'b> {
    /// The rows of the image, of any depth and colour type; `None` where the file is broken.
    pub(crate) fn rows(&self) -> Option<ImageRows<'b>> {
        let mut decoder = png::Decoder::new(Cursor::new(self.bytes));
        decoder
            .set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
        let mut reader = decoder.read_info().ok()?;
        let channels = match reader.output_color_type() {
            (png::ColorType::Rgba, png::BitDepth::Eight) => 4,
            (png::ColorType::GrayscaleAlpha, png::BitDepth::Eight) => 2,
            _ => return None,
        };
        let (width, height) = (reader.info().width, reader.info().height);
        let line = reader.output_line_size(width)?;
        let in_passes = reader.info().interlaced;
        let mut bytes = vec![0; if in_passes { reader.output_buffer_size()? } else { line }];
        if in_passes {
            reader.next_frame(&mut bytes).ok()?;
        }
        let size = (width, height);
        Some(ImageRows { reader, bytes, in_passes, channels, line, size, next: 0, picture: 1 })
    }
}

/// The rows of an image that is being read.
pub(crate) struct ImageRows<'b> {
    /// Where rows come from.
    reader: png::Reader<Cursor<&'b [u8]>>,
    /// The last row, or the whole image where it came in passes.
    bytes: Vec<u8>,
    /// Whether the image came in passes.
    in_passes: bool,
    /// Bytes a pixel: red, green, blue and opacity, or grey and opacity.
    channels: usize,
    /// Bytes a row.
    line: usize,
    /// Width and height in pixels.
    size: (u32, u32),
    /// Number of the next row, from the top.
    next: u32,
    /// Number of the picture that the rows are of, from 1.
    picture: u32,
}

impl ImageRows<'_> {
    /// Width and height of the image in pixels.
    pub(crate) fn size(&self) -> (u32, u32) {
        self.size
    }

    /// How many pictures the file plays, how often, and how long it shows this one; `None` where it plays
    /// none.
    pub(crate) fn pace(&self) -> Option<Pace> {
        let (info, control) = (self.reader.info(), self.reader.info().animation_control?);
        let delay = info.frame_control.map(|frame| (frame.delay_num, frame.delay_den));
        Some(Pace { pictures: control.num_frames, plays: control.num_plays, delay })
    }

    /// Goes on to the next picture of a file that plays, after the last row of the one before.
    pub(crate) fn next_picture(&mut self) -> Later {
        let Some(pace) = self.pace() else { return Later::End };
        // An image before the first picture, or pictures in several passes: none of ours has them.
        if pace.delay.is_none() || self.in_passes {
            return Later::Unread;
        }
        if self.picture >= pace.pictures {
            return Later::End;
        }
        // What is read after the last row ends the picture.
        let is_ended = self.reader.read_row(&mut self.bytes).is_ok_and(|row| row.is_none());
        if !is_ended || !self.reader.next_frame_info().is_ok_and(|frame| is_whole(frame, self.size)) {
            return Later::Unread;
        }
        (self.picture, self.next) = (self.picture + 1, 0);
        Later::Next
    }

    /// Puts the next row into `row`; `None` after the last one, and where the file is broken.
    pub(crate) fn next_into(&mut self, row: &mut Vec<Pixel>) -> Option<()> {
        if self.next == self.size.1 {
            return None;
        }
        let start = if self.in_passes { self.next as usize * self.line } else { 0 };
        if !self.in_passes {
            self.reader.read_row(&mut self.bytes).ok()??;
        }
        let bytes = self.bytes.get(start..start + self.line)?;
        if self.channels == 4 {
            row.extend_from_slice(bytes.as_chunks::<4>().0);
        } else {
            row.extend(bytes.as_chunks::<2>().0.iter().map(|&[grey, opacity]| [grey, grey, grey, opacity]));
        }
        self.next += 1;
        Some(())
    }
}

/// Whether a picture takes the place of all of the one before.
fn is_whole(frame: &png::FrameControl, size: (u32, u32)) -> bool {
    let is_all = (frame.width, frame.height) == size && (frame.x_offset, frame.y_offset) == (0, 0);
    is_all && frame.blend_op == png::BlendOp::Source
}

/// An image that becomes a PNG row by row.
pub(crate) struct ImageWriter {
    /// Where rows go.
    rows: png::StreamWriter<'static, Shared>,
    /// The bytes of the last row.
    line: Vec<u8>,
    /// The file so far.
    file: Shared,
}

/// Bytes that the packer writes and that are taken when it has ended.
#[derive(Clone, Default)]
struct Shared(Rc<RefCell<Vec<u8>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl ImageWriter {
    /// An image without rows that says of itself what stamp says; `None` where it would have no pixels.
    pub(crate) fn new(size: (u32, u32), stamp: &str) -> Option<Self> {
        let file = Shared::default();
        let mut encoder = encoder(file.clone(), size, PngEffort::Fast);
        encoder.add_text_chunk(KEYWORD.to_owned(), stamp.to_owned()).ok()?;
        let writer = encoder.write_header().ok()?;
        Some(Self { rows: writer.into_stream_writer_with_size(CHUNK).ok()?, line: Vec::new(), file })
    }

    /// Adds a row; `None` where it has another width, or is one too many.
    pub(crate) fn row(&mut self, row: &[Pixel]) -> Option<()> {
        self.line.clear();
        self.line.extend(row.iter().flat_map(|p| [p[0], p[1], p[2]]));
        self.rows.write_all(&self.line).ok()
    }

    /// The file; `None` where rows are missing.
    pub(crate) fn finish(self) -> Option<Vec<u8>> {
        self.rows.finish().ok()?;
        Some(self.file.0.take())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rows of a file.
    fn read(bytes: &[u8]) -> Option<Vec<Vec<Pixel>>> {
        let Ok(Picture::Image(image)) = picture(bytes) else { return None };
        let mut rows = image.rows()?;
        let (mut all, mut row) = (Vec::new(), Vec::new());
        while rows.next_into(&mut row).is_some() {
            all.push(std::mem::take(&mut row));
        }
        (all.len() == rows.size().1 as usize).then_some(all)
    }

    fn written(rows: &[Vec<Pixel>], size: (u32, u32)) -> Option<Vec<u8>> {
        let mut writer = ImageWriter::new(size, "x 0")?;
        rows.iter().try_for_each(|row| writer.row(row))?;
        writer.finish()
    }

    /// A file with this head and no pixels.
    fn head(width: u32, height: u32) -> Vec<u8> {
        let mut out = Vec::new();
        let writer = png::Encoder::new(&mut out, width, height).write_header().unwrap();
        drop(writer);
        // A chunk of pixels begins, so that a reader knows that the head has ended.
        out.truncate(out.iter().rposition(|&b| b == b'I').unwrap_or(out.len()).saturating_sub(4));
        out.extend(b"\0\0\0\x01IDAT\0\0\0\0\0");
        out
    }

    #[test]
    fn what_is_written_is_read_and_less_is_refused() {
        let rows = vec![vec![[1, 2, 3, 255], [250, 0, 9, 255]], vec![[0, 0, 0, 255], [7, 7, 7, 255]]];
        assert_eq!(read(&written(&rows, (2, 2)).unwrap()), Some(rows.clone()));
        assert_eq!(
            (written(&rows, (2, 3)), written(&rows, (3, 2)), written(&rows, (2, 0))),
            (None, None, None)
        );
        assert_eq!((read(b"\x89PNG\r\n"), stamp(b"\x89PNG\r\n").is_none()), (None, true));
    }

    #[test]
    fn a_file_that_is_cut_off_has_no_rows_to_its_end() {
        let rows: Vec<Vec<Pixel>> = (0..200).map(|y| (0..50).map(|x| [y ^ x, x, y, 255]).collect()).collect();
        let whole = written(&rows, (50, 200)).unwrap();
        assert_eq!(read(&whole[..whole.len() / 2]), None);
    }

    #[test]
    fn grey_images_are_read_also_those_that_come_in_passes() {
        let mut out = Vec::new();
        let mut encoder = png::Encoder::new(&mut out, 2, 1);
        encoder.set_color(png::ColorType::Grayscale);
        encoder.write_header().unwrap().write_image_data(&[3, 200]).unwrap();
        assert_eq!(read(&out), Some(vec![vec![[3, 3, 3, 255], [200, 200, 200, 255]]]));
        // Made by hand, as nothing here writes passes.
        let in_passes =
            b"\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00\x03\x00\x00\x00\x02\x08\x00\
            \x00\x00\x01\xcf\x18\x09P\x00\x00\x00\x12IDATx\xdac`d`f`b`ae\x03\x00\x00N\x00\x16\
            \xcbS\x02\xd0\x00\x00\x00\x00IEND\xaeB`\x82";
        let grey = |all: [u8; 3]| all.map(|grey| [grey, grey, grey, 255]).to_vec();
        assert_eq!(read(in_passes), Some(vec![grey([1, 2, 3]), grey([4, 5, 6])]));
    }

    #[test]
    fn a_head_alone_takes_no_memory() {
        for (width, height, what) in
            [(60_000, 60_000, "pixels a side"), (1, 20_000_000, "pixels a side"), (30_000, 30_000, "pixels")]
        {
            let Err(Unread::TooMuch(told)) = picture(&head(width, height)) else { panic!("{width}") };
            assert_eq!(told.what, what);
        }
        assert_eq!(read(&head(8_192, 8_192)), None);
    }
}
