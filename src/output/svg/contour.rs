//! Path data: contours of the page, and outlines of glyphs.
//!
//! An SVG arc is given by its ends, so its centre is only as good as its rounded ends make it. That is worst
//! near a half turn, where the centre moves by √(r ε) for an error ε of the chord, and near a whole turn,
//! where the ends coincide. Arcs are therefore written in pieces of at most 120°, whose centre moves by about
//! ε.

use std::f64::consts::{FRAC_PI_3, TAU};

use super::super::curves::{at, end, touches};
use super::super::number::{push_coordinate, text, written_alike};
use crate::drawing::{Point, Segment};
use crate::typeset::{Outline, OutlineSegment};

/// The longest arc in one piece, in radians. At twice, arcs come near a whole turn, whose centre the ends do
/// not give; at half, a quarter turn takes two pieces and files grow.
const LONGEST_ARC: f64 = 2.0 * FRAC_PI_3;

/// Appends the path data of a contour.
pub(super) fn segments(out: &mut String, segments: &[Segment]) {
    let mut pen = PagePen { out, at: None, last: ' ' };
    for segment in segments {
        match *segment {
            Segment::Move(p) => pen.begin(p),
            Segment::Line(p) => pen.line(p),
            Segment::Quad(c, p) => pen.command('Q', &[c, p]),
            Segment::Cubic(c, d, p) => pen.command('C', &[c, d, p]),
            Segment::Close => {
                pen.out.push('Z');
                pen.last = ' ';
            }
            Segment::Arc { center, radius, start, sweep } => {
                let from = at(center, radius, start);
                match pen.at {
                    None => pen.begin(from),
                    Some(point) if !touches(point, from) => pen.line(from),
                    Some(_) => {}
                }
                arc(pen.out, center, radius, start, sweep);
                pen.last = ' ';
            }
        }
        pen.at = end(segment).or(pen.at);
    }
}

/// Writes path data in page pixels: a letter only where it is another one, and one number for a level or
/// upright line.
struct PagePen<'o> {
    /// The path data so far.
    out: &'o mut String,
    /// Where the last piece ended; `None` before the first.
    at: Option<Point>,
    /// The letter that the next numbers would be taken for.
    last: char,
}

impl PagePen<'_> {
    /// Begins a contour. What follows a move without a letter is a line.
    fn begin(&mut self, p: Point) {
        self.command('M', &[p]);
        self.last = 'L';
    }

    fn line(&mut self, p: Point) {
        match self.at {
            Some(from) if written_alike(from.y, p.y) => self.letter('H', p.x),
            Some(from) if written_alike(from.x, p.x) => self.letter('V', p.y),
            _ => self.command('L', &[p]),
        }
        self.at = Some(p);
    }

    fn letter(&mut self, letter: char, value: f64) {
        if self.last != letter {
            self.out.push(letter);
        }
        self.last = letter;
        push_coordinate(self.out, value);
    }

    fn command(&mut self, letter: char, points: &[Point]) {
        if self.last != letter {
            self.out.push(letter);
        }
        self.last = letter;
        for p in points {
            push_coordinate(self.out, p.x);
            push_coordinate(self.out, p.y);
        }
    }
}

/// Appends an arc in pieces of at most [`LONGEST_ARC`].
fn arc(out: &mut String, center: Point, radius: f64, start: f64, sweep: f64) {
    let sweep = sweep.clamp(-TAU, TAU);
    let pieces = (sweep.abs() / LONGEST_ARC).ceil().max(1.0);
    let r = text(radius);
    let mut i = 0.0;
    while i < pieces {
        i += 1.0;
        let to = at(center, radius, start + sweep * i / pieces);
        out.push('A');
        out.push_str(&r);
        out.push(' ');
        out.push_str(&r);
        out.push_str(if sweep > 0.0 { " 0 0 1 " } else { " 0 0 0 " });
        push_coordinate(out, to.x);
        push_coordinate(out, to.y);
    }
}

/// Appends the path data of a glyph in thousandths of an em, relative and in whole numbers: the faces have no
/// others.
pub(super) fn outline(out: &mut String, outline: &Outline) {
    let mut pen = Pen { out, at: [0.0; 2], begin: [0.0; 2], last: ' ', control: None };
    for segment in &outline.segments {
        match *segment {
            OutlineSegment::Move(p) => {
                pen.command('m', &[p]);
                pen.begin = p;
            }
            OutlineSegment::Line(p) => pen.line(p),
            OutlineSegment::Quad(c, p) => pen.quad(c, p),
            OutlineSegment::Cubic(c, d, p) => pen.command('c', &[c, d, p]),
            OutlineSegment::Close => {
                pen.out.push('z');
                (pen.at, pen.last) = (pen.begin, 'z');
            }
        }
    }
}

/// Writes relative path data as short as it can be said.
struct Pen<'o> {
    /// The path data so far.
    out: &'o mut String,
    /// Where the last piece ended, in thousandths of an em.
    at: [f32; 2],
    /// Where the last move went.
    begin: [f32; 2],
    /// The last letter; the same one again needs no letter.
    last: char,
    /// The control point of the last piece, if it was a quadratic curve.
    control: Option<[f32; 2]>,
}

impl Pen<'_> {
    fn line(&mut self, p: [f32; 2]) {
        let [x, y] = self.at;
        let (letter, value) = match p {
            [px, py] if py == y => ('h', px - x),
            [px, py] if px == x => ('v', py - y),
            _ => return self.command('l', &[p]),
        };
        self.letter(letter);
        push_coordinate(self.out, f64::from(value));
        self.at = p;
    }

    /// Writes a quadratic curve. Where the control point is the last one's mirror image about the point
    /// between, as between two corners of a `TrueType` outline that are both off the curve, it need not be
    /// said.
    fn quad(&mut self, c: [f32; 2], p: [f32; 2]) {
        let [x, y] = self.at;
        match self.control {
            Some([cx, cy]) if c == [2.0 * x - cx, 2.0 * y - cy] => self.command('t', &[p]),
            _ => self.command('q', &[c, p]),
        }
        self.control = Some(c);
    }

    fn command(&mut self, letter: char, points: &[[f32; 2]]) {
        self.letter(letter);
        for p in points {
            for (to, from) in p.iter().zip(self.at) {
                push_coordinate(self.out, f64::from(*to) - f64::from(from));
            }
        }
        self.at = points.last().copied().unwrap_or(self.at);
    }

    fn letter(&mut self, letter: char) {
        if self.last != letter {
            self.out.push(letter);
        }
        self.last = letter;
        self.control = None;
    }
}
