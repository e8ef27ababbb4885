//! The embedded faces and the outlines of their glyphs.
//!
//! A face is read once a process and an outline is built the first time that it is asked for; after that a
//! glyph is a look-up in an array. What is kept is a pure function of the embedded bytes, so no run can tell
//! the difference.

use std::sync::OnceLock;

use latex_rust::{Dim, MathFont};
use ttf_parser::{GlyphId, OutlineBuilder};

#[cfg(tracefig_page)]
use super::brought::file;
use super::line::{Face, Glyph};
use super::pairs::Pairs;

/// The files of the faces, in the order of [`Face`].
#[cfg(not(tracefig_page))]
static FILES: [&[u8]; 3] = [
    include_bytes!("fonts/tracefig-sans-regular.ttf"),
    include_bytes!("fonts/tracefig-sans-semibold.ttf"),
    include_bytes!("fonts/tracefig-math.otf"),
];

/// Units of an [`Outline`] in an em.
pub const UNITS_PER_EM: f64 = 1000.0;

/// Contours of a glyph, in thousandths of an em from the glyph's origin, x right, y **down**; filled by the
/// non-zero winding rule.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The pieces, each contour closed.
    pub segments: Vec<OutlineSegment>,
    /// Left, top, right, bottom of the control points; all 0 for a glyph without ink.
    pub bounds: [f32; 4],
}

/// A piece of an [`Outline`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutlineSegment {
    /// Begins a contour at x, y.
    Move([f32; 2]),
    /// A straight line.
    Line([f32; 2]),
    /// A quadratic Bézier curve: control point, end.
    Quad([f32; 2], [f32; 2]),
    /// A cubic Bézier curve: two control points, end.
    Cubic([f32; 2], [f32; 2], [f32; 2]),
    /// A straight line back to the contour's beginning.
    Close,
}

impl Glyph {
    /// The glyph's contours; none for a space.
    ///
    /// ```
    /// use tracefig::typeset::{Style, typeset};
    /// let line = typeset("A", Style::regular(16.0)).unwrap();
    /// assert!(!line.glyphs[0].glyph.outline().segments.is_empty());
    /// ```
    #[must_use]
    pub fn outline(self) -> &'static Outline {
        static NONE: Outline = Outline { segments: Vec::new(), bounds: [0.0; 4] };
        let Some(loaded) = Loaded::of(self.face) else { return &NONE };
        match loaded.outlines.get(usize::from(self.id)) {
            Some(kept) => kept.get_or_init(|| Box::new(build(loaded.face(), self.id))),
            None => &NONE,
        }
    }
}

/// A face with what was built from it so far.
pub(super) struct Loaded {
    /// The face itself.
    source: Source,
    /// The outlines that were asked for so far, by the glyph's number.
    outlines: Vec<OnceLock<Box<Outline>>>,
    /// What it said so far of characters and of pairs of glyphs.
    pub(super) pairs: Pairs,
}

/// A face as the part that sets it wants it.
enum Source {
    /// A face of words.
    Words(Box<ttf_parser::Face<'static>>),
    /// The face of formulas, with its table of mathematical constants.
    Formulas(Box<MathFont>),
}

impl Loaded {
    /// The face, read at the first call; `None` where the embedded bytes are no font.
    pub(super) fn of(face: Face) -> Option<&'static Self> {
        static FACES: [OnceLock<Option<Loaded>>; 3] = [OnceLock::new(), OnceLock::new(), OnceLock::new()];
        let slot = &FACES[face as usize];
        slot.get_or_init(|| Self::load(face, file(face))).as_ref()
    }

    /// A face of words, or that of formulas, from the bytes of its file.
    fn load(face: Face, bytes: &'static [u8]) -> Option<Self> {
        // Packed faces of words have both weights.
        let weight = u32::from(cfg!(tracefig_page) && face == Face::Semibold);
        let source = match face {
            Face::Regular | Face::Semibold => {
                Source::Words(Box::new(ttf_parser::Face::parse(bytes, weight).ok()?))
            }
            Face::Math => Source::Formulas(Box::new(MathFont::from_bytes(bytes).ok()?)),
        };
        let mut loaded = Self { source, outlines: Vec::new(), pairs: Pairs::new(0) };
        let count = loaded.face().number_of_glyphs();
        loaded.outlines.resize_with(usize::from(count), OnceLock::new);
        loaded.pairs = Pairs::new(count);
        Some(loaded)
    }

    /// The face's tables.
    pub(super) fn face(&self) -> &ttf_parser::Face<'static> {
        match &self.source {
            Source::Words(face) => face,
            Source::Formulas(font) => font.face(),
        }
    }

    /// The face as the formula engine wants it; `None` for a face of words.
    pub(super) fn math(&self) -> Option<&MathFont> {
        match &self.source {
            Source::Words(_) => None,
            Source::Formulas(font) => Some(font),
        }
    }

    /// Ems in a unit of the face.
    pub(super) fn em(&self) -> f64 {
        1.0 / f64::from(self.face().units_per_em())
    }
}

/// The file of a face, whole.
#[cfg(not(tracefig_page))]
pub(super) fn file(face: Face) -> &'static [u8] {
    FILES[face as usize]
}

/// A layout dimension in ems, as the nearest double or its neighbour: both parts of the rational are far
/// below 2⁵³.
#[expect(
    clippy::cast_precision_loss,
    reason = "layout rationals are small; a rounding here is below 1e-15 em"
)]
pub(super) fn ems(dim: &Dim) -> f64 {
    dim.as_ratio().map_or(0.0, |(numerator, denominator)| numerator as f64 / denominator as f64)
}

/// The outline of a glyph, with its bounds.
fn build(face: &ttf_parser::Face, id: u16) -> Outline {
    #[expect(clippy::cast_possible_truncation, reason = "a thousand is exact")]
    let scale = UNITS_PER_EM as f32 / f32::from(face.units_per_em());
    let mut pen = Pen { scale, outline: Outline::default(), low: [f32::MAX; 2], high: [f32::MIN; 2] };
    face.outline_glyph(GlyphId(id), &mut pen);
    if !pen.outline.segments.is_empty() {
        pen.outline.bounds = [pen.low[0], pen.low[1], pen.high[0], pen.high[1]];
    }
    pen.outline.segments.shrink_to_fit();
    pen.outline
}

/// Turns the face's y-up units into thousandths of an em, y down.
struct Pen {
    /// Thousandths of an em in a unit of the face.
    scale: f32,
    /// The outline so far, without its bounds.
    outline: Outline,
    /// The least x and y so far.
    low: [f32; 2],
    /// The greatest x and y so far.
    high: [f32; 2],
}

impl Pen {
    fn at(&mut self, x: f32, y: f32) -> [f32; 2] {
        // `0.0 - y` and not `-y`: a point on the baseline is at 0, not at -0.
        let p = [x * self.scale, 0.0 - y * self.scale];
        let bounds = self.low.iter_mut().zip(&mut self.high);
        for (value, (low, high)) in p.into_iter().zip(bounds) {
            *low = low.min(value);
            *high = high.max(value);
        }
        p
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let p = self.at(x, y);
        self.outline.segments.push(OutlineSegment::Move(p));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let p = self.at(x, y);
        self.outline.segments.push(OutlineSegment::Line(p));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (c, p) = (self.at(x1, y1), self.at(x, y));
        self.outline.segments.push(OutlineSegment::Quad(c, p));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (c, d, p) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.outline.segments.push(OutlineSegment::Cubic(c, d, p));
    }

    fn close(&mut self) {
        self.outline.segments.push(OutlineSegment::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_embedded_face_can_be_read() {
        for face in [Face::Regular, Face::Semibold, Face::Math] {
            let loaded = Loaded::of(face).unwrap();
            assert_eq!(f64::from(loaded.face().units_per_em()), UNITS_PER_EM, "{face:?}");
            assert_eq!(loaded.math().is_some(), face == Face::Math);
        }
    }

    #[test]
    fn an_outline_is_y_down_and_stands_on_the_baseline() {
        let loaded = Loaded::of(Face::Regular).unwrap();
        let id = loaded.face().glyph_index('H').unwrap().0;
        let outline = Glyph { face: Face::Regular, id }.outline();
        let [_, top, _, bottom] = outline.bounds;
        assert_eq!(bottom, 0.0, "H stands on the baseline");
        assert_eq!(top, -656.0, "as the font file has it");
        assert!(std::ptr::eq(outline, Glyph { face: Face::Regular, id }.outline()), "built once");
    }
}
