//! Text as stamps: the coverage of a glyph is found once for each place in a pixel that it can stand at, and
//! kept.
//!
//! The eight figures of the article show 2,184 glyphs and halos of glyphs by 874 stamps. A stamp is a pure
//! function of its key, so no run can tell whether it was kept or made anew.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use tiny_skia::{Path, PathBuilder};

use super::coverage::{Filler, Part, Span};
use super::paths;
use crate::drawing::{Point, Rect, Text};
use crate::typeset::{Glyph, PlacedGlyph, UNITS_PER_EM};

/// Places in a pixel, along each axis, that a glyph can stand at. With four, a print of hatched shapes
/// differs from what resvg draws by more than `tests/witness.rs` allows; with sixteen, rendering the
/// article's figures takes a twentieth longer.
const PLACES: f64 = 8.0;

/// Image pixels from which on a halo is so wide that it stands at whole pixels: those of figures at their own
/// size and above. Its edge is mostly the background's colour on itself. With all halos in eighths, rendering
/// takes a sixth longer; with narrow ones at whole pixels too, letters of a figure at a quarter of its size
/// lose it on one side.
const WIDE_HALO: f64 = 2.0;

/// Image pixels of an em and its halo up to which glyphs are stamps. Larger ones are few, and areas like
/// others: the mask of a stamp is as large as the glyph, however small the image is.
const LARGEST: f64 = 256.0;

/// Spans that a thread keeps, of 12 bytes each; the article's figures have 73,000 in 874 stamps. Beyond, all
/// are forgotten: with half as many, those figures at two sizes in turns would make them all anew each time.
const MOST_SPANS: usize = 1 << 18;

/// The coverage of a glyph.
pub(super) struct Stamp {
    /// Columns from the pixel that the glyph stands in to the leftmost pixel of the stamp, mostly below 0.
    left: i64,
    /// Rows from the pixel that the glyph stands in to the top of the stamp, mostly below 0.
    top: i64,
    /// Columns of the stamp.
    width: i64,
    /// The spans of all rows; columns count from `left`.
    spans: Vec<Span>,
    /// Where the spans of each row end.
    ends: Vec<usize>,
}

/// A stamp on the image.
pub(super) struct Placed {
    /// What covers the image there.
    stamp: Rc<Stamp>,
    /// Column of the pixel that the glyph stands in.
    x: i64,
    /// Row of that pixel.
    y: i64,
}

/// All that a stamp depends on.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    /// Which glyph.
    glyph: Glyph,
    /// Image pixels of a unit of the glyph, as bits.
    unit: u64,
    /// How far beyond the glyph it reaches, in image pixels, as bits.
    reach: u64,
    /// The place in its pixel, right and down, in parts of it.
    place: (u8, u8),
}

/// The stamps of this thread.
#[derive(Default)]
struct Stamps {
    /// Every stamp that was made so far.
    all: HashMap<Key, Rc<Stamp>>,
    /// The number of spans in all stamps.
    count: usize,
    /// Finds the coverage of new ones.
    filler: Filler,
}

thread_local! { static STAMPS: RefCell<Stamps> = RefCell::default(); }

/// A text, ready to be laid on.
pub(super) struct Letters {
    /// The glyphs.
    pub(super) stamps: Vec<Placed>,
    /// What is no stamp: rules, and glyphs that are too large.
    pub(super) rest: Option<Path>,
}

/// The glyphs and rules of a text, grown by `reach` page pixels; the rest is not grown.
pub(super) fn letters(text: &Text, reach: f64, scale: f64) -> Letters {
    let (mut stamps, mut rest) = (Vec::new(), PathBuilder::new());
    STAMPS.with_borrow_mut(|known| {
        for glyph in &text.line.glyphs {
            let origin = Point::new((text.origin.x + glyph.x) * scale, (text.origin.y + glyph.y) * scale);
            if (glyph.size.abs() + 2.0 * reach) * scale <= LARGEST {
                stamps.extend(known.placed(glyph, origin, reach * scale, scale));
            } else {
                let unit = glyph.size / UNITS_PER_EM * scale;
                paths::push_glyph(&mut rest, glyph.glyph.outline(), origin, unit);
            }
        }
    });
    for rule in &text.line.rules {
        let (x0, y0) = ((text.origin.x + rule.x) * scale, (text.origin.y + rule.y) * scale);
        let rect = Rect { x0, y0, x1: x0 + rule.width * scale, y1: y0 + rule.height * scale };
        paths::push_rectangle(&mut rest, rect);
    }
    Letters { stamps, rest: rest.finish() }
}

impl Stamps {
    /// A glyph on the image; none for one without ink.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a place on an image, or saturated"
    )]
    fn placed(&mut self, glyph: &PlacedGlyph, origin: Point, reach: f64, scale: f64) -> Option<Placed> {
        if glyph.glyph.outline().segments.is_empty() {
            return None;
        }
        let places = if reach < WIDE_HALO { PLACES } else { 1.0 };
        let (x, y) = ((origin.x * places).round() / places, (origin.y * places).round() / places);
        let place = Point::new(x - x.floor(), y - y.floor());
        let unit = glyph.size / UNITS_PER_EM * scale;
        let key = Key {
            glyph: glyph.glyph,
            unit: unit.to_bits(),
            reach: reach.to_bits(),
            place: ((place.x * places) as u8, (place.y * places) as u8),
        };
        if self.count > MOST_SPANS {
            (self.count, self.all) = (0, HashMap::new());
        }
        let Self { all, count, filler } = self;
        let stamp = all.entry(key).or_insert_with(|| {
            let stamp = Stamp::of(glyph.glyph, place, unit, reach, filler);
            *count += stamp.spans.len();
            Rc::new(stamp)
        });
        Some(Placed { stamp: Rc::clone(stamp), x: x.floor() as i64, y: y.floor() as i64 })
    }
}

impl Stamp {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a glyph's box is small")]
    #[expect(clippy::cast_possible_wrap, reason = "a glyph's box is small")]
    fn of(glyph: Glyph, place: Point, unit: f64, reach: f64, filler: &mut Filler) -> Self {
        let mut stamp = Self { left: 0, top: 0, width: 0, spans: Vec::new(), ends: Vec::new() };
        // A mask has no pixels left of it or above, so the glyph is moved into it.
        let [left, top, ..] = glyph.outline().bounds.map(|v| f64::from(v) * unit);
        let (left, top) = ((place.x + left - reach).floor() - 1.0, (place.y + top - reach).floor() - 1.0);
        let mut builder = PathBuilder::new();
        paths::push_glyph(&mut builder, glyph.outline(), Point::new(place.x - left, place.y - top), unit);
        let Some(path) = builder.finish() else { return stamp };
        let halo = if reach > 0.0 { paths::around(&path, reach) } else { None };
        let bounds = paths::bounds(&path).grown(reach + 1.0);
        let part = Part { columns: 0..bounds.x1.ceil() as usize, rows: 0..bounds.y1.ceil() as usize };
        (stamp.left, stamp.top, stamp.width) = (left as i64, top as i64, part.columns.len() as i64);
        let both = [Some(&path), halo.as_ref()];
        let paths: Vec<&Path> = both.into_iter().flatten().collect();
        filler.fill(&paths, None, &part, |_, spans| {
            stamp.spans.extend_from_slice(spans);
            stamp.ends.push(stamp.spans.len());
        });
        stamp
    }
}

impl Placed {
    /// The rectangle that holds it, in image pixels.
    #[expect(clippy::cast_precision_loss, clippy::cast_possible_wrap, reason = "a place on an image")]
    pub(super) fn bounds(&self) -> Rect {
        let (x, y) = (self.x + self.stamp.left, self.y + self.stamp.top);
        let (right, bottom) = (x + self.stamp.width, y + self.stamp.ends.len() as i64);
        Rect { x0: x as f64, y0: y as f64, x1: right as f64, y1: bottom as f64 }
    }

    /// Hands the spans of each row that lies in `part` to `each`, with the row's place in the image.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "cut to a part of the image")]
    #[expect(clippy::cast_possible_wrap, reason = "an image is smaller than 2^26")]
    pub(super) fn rows(&self, part: &Part, spans: &mut Vec<Span>, each: &mut impl FnMut(usize, &[Span])) {
        let (left, top) = (self.x + self.stamp.left, self.y + self.stamp.top);
        let (low, high) = (part.columns.start as i64, part.columns.end as i64);
        let first = (part.rows.start as i64 - top).max(0) as usize;
        let last = (part.rows.end as i64 - top).clamp(0, self.stamp.ends.len() as i64) as usize;
        for row in first..last {
            let start = if row == 0 { 0 } else { self.stamp.ends[row - 1] };
            spans.clear();
            spans.extend(self.stamp.spans[start..self.stamp.ends[row]].iter().filter_map(|span| {
                let column = |x: u32| (left + i64::from(x)).clamp(low, high) as u32;
                let (start, end) = (column(span.start), column(span.end));
                (start < end).then_some(Span { start, end, level: span.level })
            }));
            each((top + row as i64) as usize, spans);
        }
    }
}
