//! Outlines as they are packed: their pieces, and the ways between the points that these take.

use ttf_parser::{GlyphId, OutlineBuilder};

use super::super::face::Loaded;

/// A piece of an outline: the points that it takes, the last of which is where it ends.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Piece {
    /// Begins a contour.
    Move([f32; 2]),
    /// A line, or a curve with control points.
    Way(Vec<[f32; 2]>),
    /// Ends a contour.
    Close,
}

/// An outline as it is told.
#[derive(Default)]
pub(super) struct Told(pub(super) Vec<Piece>);

impl OutlineBuilder for Told {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.push(Piece::Move([x, y]));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.push(Piece::Way(vec![[x, y]]));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.push(Piece::Way(vec![[x1, y1], [x, y]]));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.push(Piece::Way(vec![[x1, y1], [x2, y2], [x, y]]));
    }

    fn close(&mut self) {
        self.0.push(Piece::Close);
    }
}

/// An outline, packed: its pieces, and the ways between the points that they take.
#[derive(Default)]
pub(super) struct Outline {
    /// Its pieces.
    pub(super) pieces: Vec<u8>,
    /// From point to point, x and y.
    pub(super) ways: [Vec<i32>; 2],
}

impl Outline {
    /// The outlines of a glyph in each weight, of the same pieces: what is left out is so in all.
    pub(super) fn of_all(faces: &[&Loaded], id: u16) -> Vec<Self> {
        let told = faces.iter().map(|face| {
            let mut told = Told::default();
            face.face().outline_glyph(GlyphId(id), &mut told);
            told.0
        });
        let told: Vec<Vec<Piece>> = told.collect();
        let count = told.first().map_or(0, Vec::len);
        let ends: Vec<End> = (0..count).map(|k| End::of(&told, k)).collect();
        told.iter().map(|pieces| Self::of(pieces, &ends)).collect()
    }

    /// An outline, packed.
    fn of(told: &[Piece], ends: &[End]) -> Self {
        let (mut packed, mut at) = (Self::default(), [0.0; 2]);
        for (piece, end) in told.iter().zip(ends) {
            match piece {
                Piece::Move(point) => {
                    packed.pieces.push(1);
                    packed.go(&mut at, *point);
                }
                Piece::Way(points) => {
                    packed.pieces.push(match (points.len(), end) {
                        (1, End::Told) => 2,
                        (1, _) => 3,
                        (2, End::Told) => 4,
                        (2, End::Halfway) => 5,
                        (2, End::Start) => 6,
                        (_, End::Told) => 7,
                        (_, _) => 8,
                    });
                    let told = points.len() - usize::from(*end != End::Told);
                    points[..told].iter().for_each(|point| packed.go(&mut at, *point));
                }
                Piece::Close => packed.pieces.push(9),
            }
        }
        packed.pieces.push(0);
        packed
    }

    /// Takes a point, which in our faces has whole coordinates.
    #[expect(clippy::cast_possible_truncation, reason = "units of a face are below 2¹⁵")]
    fn go(&mut self, at: &mut [f32; 2], point: [f32; 2]) {
        for axis in 0..2 {
            self.ways[axis].push((point[axis] - at[axis]) as i32);
        }
        *at = point;
    }
}

/// Where a piece of an outline ends.
#[derive(Clone, Copy, PartialEq)]
enum End {
    /// At a point that is told.
    Told,
    /// Halfway to the control point of the next.
    Halfway,
    /// Where the contour began.
    Start,
}

impl End {
    /// Where the piece of a number ends in each of these outlines.
    fn of(outlines: &[Vec<Piece>], k: usize) -> Self {
        let is_all = |is: fn(&[Piece], usize) -> bool| outlines.iter().all(|pieces| is(pieces, k));
        match () {
            () if is_all(ends_halfway) => Self::Halfway,
            () if is_all(ends_at_start) => Self::Start,
            () => Self::Told,
        }
    }
}

/// Whether a piece is a curve that ends halfway between its control point and that of the next.
fn ends_halfway(pieces: &[Piece], k: usize) -> bool {
    let (Some(Piece::Way(own)), Some(Piece::Way(next))) = (pieces.get(k), pieces.get(k + 1)) else {
        return false;
    };
    let [control, end] = own[..] else { return false };
    next.len() == 2 && (0..2).all(|axis| end[axis] == control[axis] + 0.5 * (next[0][axis] - control[axis]))
}

/// Whether a piece ends where its contour began.
fn ends_at_start(pieces: &[Piece], k: usize) -> bool {
    let start = pieces[..k].iter().rev().find_map(|piece| match piece {
        Piece::Move(start) => Some(start),
        _ => None,
    });
    matches!(&pieces[k], Piece::Way(points) if points.last() == start)
}
