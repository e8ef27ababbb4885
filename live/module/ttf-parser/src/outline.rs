//! Outlines, told from their pieces: 0 ends a glyph, 1 begins a contour, 2 is a line, 3 a line to where the
//! contour began, 4 a quadratic curve, 5 one that ends halfway to the next control point, 6 one that ends
//! where the contour began, 7 a cubic curve, 8 one that ends there, 9 ends the contour.

use crate::packed::{Glyph, Packed};
use crate::{OutlineBuilder, Rect};

/// Nobody, who asks what an outline reaches.
pub(crate) struct Untold;

impl OutlineBuilder for Untold {
    fn move_to(&mut self, _: f32, _: f32) {}
    fn line_to(&mut self, _: f32, _: f32) {}
    fn quad_to(&mut self, _: f32, _: f32, _: f32, _: f32) {}
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {}
    fn close(&mut self) {}
}

/// A walk from point to point.
struct Walk<'p> {
    packed: &'p Packed,
    /// The way that comes next.
    next: usize,
    at: [i16; 2],
    /// The least and the greatest of each coordinate so far.
    low: [i16; 2],
    high: [i16; 2],
}

impl Walk<'_> {
    /// The next point.
    fn point(&mut self) -> [f32; 2] {
        let way = self.packed.ways.each_ref().map(|ways| ways.get(self.next).copied().unwrap_or(0));
        self.next += 1;
        for (axis, way) in way.into_iter().enumerate() {
            self.at[axis] = self.at[axis].wrapping_add(way);
            self.low[axis] = self.low[axis].min(self.at[axis]);
            self.high[axis] = self.high[axis].max(self.at[axis]);
        }
        self.at.map(f32::from)
    }

    /// The place halfway to the next point, which stays the next.
    fn halfway(&self) -> [f32; 2] {
        [0, 1].map(|axis: usize| {
            let way = self.packed.ways[axis].get(self.next).copied().unwrap_or(0);
            f32::from(self.at[axis]) + 0.5 * f32::from(way)
        })
    }
}

/// Tells the outline of a glyph, and gives what it reaches; none for a glyph without ink.
pub(crate) fn tell(packed: &Packed, glyph: &Glyph, builder: &mut dyn OutlineBuilder) -> Option<Rect> {
    let mut walk = Walk { packed, next: glyph.points, at: [0; 2], low: [i16::MAX; 2], high: [i16::MIN; 2] };
    let mut start = [0.0; 2];
    let mut pieces = packed.pieces.get(glyph.pieces..)?.iter();
    loop {
        match *pieces.next()? {
            0 => break,
            1 => {
                start = walk.point();
                builder.move_to(start[0], start[1]);
            }
            2 => {
                let [x, y] = walk.point();
                builder.line_to(x, y);
            }
            3 => builder.line_to(start[0], start[1]),
            curve @ 4..=6 => {
                let control = walk.point();
                let [x, y] = match curve {
                    4 => walk.point(),
                    5 => walk.halfway(),
                    _ => start,
                };
                builder.quad_to(control[0], control[1], x, y);
            }
            curve @ (7 | 8) => {
                let (a, b) = (walk.point(), walk.point());
                let [x, y] = if curve == 7 { walk.point() } else { start };
                builder.curve_to(a[0], a[1], b[0], b[1], x, y);
            }
            _ => builder.close(),
        }
    }
    let ([x_min, y_min], [x_max, y_max]) = (walk.low, walk.high);
    (x_min <= x_max).then_some(Rect { x_min, y_min, x_max, y_max })
}
