//! How much of each pixel an area covers: exact areas, no samples.
//!
//! Walking along an outline, each piece inside a pixel row adds to the pixel that it crosses the area to its right in that
//! pixel, and to all pixels further right its height. The running sum along a row is then the coverage, times the winding
//! number. A bit for each pixel tells which ones are crossed, so that they are met from left to right without sorting;
//! between them coverage is constant. Windings of one sign add up and are cut at 1, which is the non-zero rule except in
//! pixels that two edges share.
//! Source: the *cells* of D. Turner's smooth rasterizer in `FreeType`, and of M. Shemanarev's Anti-Grain Geometry, 2002.

use std::ops::Range;

use super::edges::Edge;

/// Levels of coverage. Sixteen are what the eye tells apart at an edge, and keep the colours of an image few.
pub(super) const LEVELS: u32 = 16;

/// Pixels of one row with one coverage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) start: u32,
    pub(super) end: u32,
    /// From 1 to [`LEVELS`].
    pub(super) level: u32,
}

/// What outlines add to a pixel that they cross.
#[derive(Clone, Copy, Default)]
struct Cell {
    /// Signed height of the outlines in this pixel.
    cover: f32,
    /// Signed area right of them in this pixel.
    area: f32,
}

/// Pixels whose bits lie in one word.
const WORD: usize = u64::BITS as usize;

/// The cells of a band of rows; all are zero before and after an area.
pub(super) struct Cells {
    width: usize,
    /// One more than `width` a row: right of the image nothing counts.
    all: Vec<Cell>,
    /// A bit for each cell: whether an outline crosses it.
    crossed: Vec<u64>,
    /// Words a row.
    words: usize,
}

/// Where an area's outlines run in a band.
#[derive(Clone)]
pub(super) struct Reach {
    /// Rows from the band's top.
    pub(super) rows: Range<usize>,
    /// Words of bits in each row.
    words: Range<usize>,
}

impl Cells {
    pub(super) fn new(width: usize, rows: usize) -> Self {
        let words = width / WORD + 1;
        let cells = vec![Cell::default(); (width + 1) * rows];
        Self { width, all: cells, crossed: vec![0; words * rows], words }
    }

    /// Adds edges that lie in the band whose first row is `top`.
    pub(super) fn add(&mut self, edges: &[Edge], top: usize) -> Reach {
        let (mut left, mut right) = (f64::INFINITY, 0.0_f64);
        let (mut first, mut last) = (usize::MAX, 0);
        for edge in edges {
            left = left.min(edge.from.x.min(edge.to.x));
            right = right.max(edge.from.x.max(edge.to.x));
            let rows = self.edge(edge, top);
            first = first.min(rows.start);
            last = last.max(rows.end);
        }
        let word = |x: f64| (floor(x) as usize).min(self.width) / WORD;
        Reach { rows: first.min(last)..last, words: word(left)..word(right) + 1 }
    }

    /// Adds one edge; the rows that it crosses.
    #[inline]
    fn edge(&mut self, edge: &Edge, band_top: usize) -> Range<usize> {
        let (p, q) = (edge.from, edge.to);
        let (sign, top, bottom) = if p.y < q.y { (1.0, p, q) } else { (-1.0, q, p) };
        let first = floor(top.y);
        let start = (first as usize).saturating_sub(band_top);
        if bottom.y <= f64::from(first + 1) {
            self.within_row(start, top.x, bottom.x, sign * (bottom.y - top.y));
            return start..start + 1;
        }
        let slope = (bottom.x - top.x) / (bottom.y - top.y);
        let (mut row, mut next_row, mut x, mut y) = (start, f64::from(first + 1), top.x, top.y);
        while y < bottom.y {
            let (next_x, next_y) = if next_row < bottom.y {
                (top.x + (next_row - top.y) * slope, next_row)
            } else {
                (bottom.x, bottom.y)
            };
            self.within_row(row, x, next_x, sign * (next_y - y));
            (x, y) = (next_x, next_y);
            row += 1;
            next_row += 1.0;
        }
        start..row
    }

    /// Adds a piece inside one row that runs from `x0` to `x1` and has that signed height.
    #[inline]
    fn within_row(&mut self, row: usize, x0: f64, x1: f64, height: f64) {
        let (left, right) = if x0 < x1 { (x0, x1) } else { (x1, x0) };
        let (first, last) = (floor(left), floor(right));
        if first == last {
            self.cell(row, first, height, height * (1.0 - (0.5 * (left + right) - f64::from(first))));
            return;
        }
        let per_pixel = height / (right - left);
        let (mut at, mut x) = (left, first);
        while at < right {
            let next = f64::from(x + 1).min(right);
            let part = per_pixel * (next - at);
            self.cell(row, x, part, part * (1.0 - (0.5 * (at + next) - f64::from(x))));
            at = next;
            x += 1;
        }
    }

    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "at most one pixel's height and area")]
    fn cell(&mut self, row: usize, x: u32, cover: f64, area: f64) {
        let x = (x as usize).min(self.width);
        let cell = &mut self.all[row * (self.width + 1) + x];
        cell.cover += cover as f32;
        cell.area += area as f32;
        self.crossed[row * self.words + x / WORD] |= 1 << (x % WORD);
    }

    /// The coverage of a row from left to right; its cells are zero then.
    #[expect(clippy::cast_possible_truncation, reason = "an image is narrower than 2^26")]
    pub(super) fn take_row(&mut self, row: usize, reach: &Reach, spans: &mut Vec<Span>) {
        spans.clear();
        let cells = &mut self.all[row * (self.width + 1)..(row + 1) * (self.width + 1)];
        let mut cover = 0.0_f32;
        let mut x = 0;
        for word in reach.words.clone() {
            let mut bits = std::mem::take(&mut self.crossed[row * self.words + word]);
            while bits != 0 {
                let at = word * WORD + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let cell = std::mem::take(&mut cells[at]);
                push(spans, x, at as u32, level(cover));
                if at < self.width {
                    push(spans, at as u32, at as u32 + 1, level(cover + cell.area));
                }
                cover += cell.cover;
                x = at as u32 + 1;
            }
        }
        push(spans, x, self.width as u32, level(cover));
    }
}

/// The row or column of a place. Nothing is below 0 but by rounding, so cutting off the fraction is rounding down.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the cast keeps to the range")]
fn floor(at: f64) -> u32 {
    at as u32
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and LEVELS")]
fn level(coverage: f32) -> u32 {
    (coverage.abs().min(1.0) * f32::from(LEVELS as u16) + 0.5) as u32
}

#[inline]
fn push(spans: &mut Vec<Span>, start: u32, end: u32, level: u32) {
    if level == 0 || start >= end {
        return;
    }
    if let Some(last) = spans.last_mut()
        && (last.end, last.level) == (start, level)
    {
        last.end = end;
        return;
    }
    spans.push(Span { start, end, level });
}

/// Where both cover something in a row, the product of their coverages.
pub(super) fn intersection(a: &[Span], b: &[Span], both: &mut Vec<Span>) {
    both.clear();
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let (p, q) = (a[i], b[j]);
        push(both, p.start.max(q.start), p.end.min(q.end), (p.level * q.level + LEVELS / 2) / LEVELS);
        if p.end <= q.end {
            i += 1;
        } else {
            j += 1;
        }
    }
}

/// The coverage of each row of an image that outlines give together.
#[cfg(test)]
pub(super) fn rows(outlines: &[&super::polyline::Polylines], width: usize, height: usize) -> Vec<Vec<Span>> {
    let mut bands = super::edges::Bands::new(width, height);
    for outline in outlines {
        bands.add(0, outline);
    }
    let count = bands.rows();
    let mut cells = Cells::new(width, count);
    let mut all = vec![Vec::new(); height];
    for (i, band) in bands.into_bands().iter().enumerate() {
        for (_, edges) in band.steps() {
            let reach = cells.add(edges, i * count);
            for row in reach.rows.clone() {
                cells.take_row(row, &reach, &mut all[i * count + row]);
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::super::polyline::Polylines;
    use super::*;
    use crate::drawing::Point;

    fn polygon(points: &[(f64, f64)]) -> Polylines {
        let points: Vec<Point> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let ends = vec![(points.len(), true)];
        Polylines { points, ends }
    }

    /// The coverage of each row of an image of 8 by 6.
    fn covered_by(outlines: &[&[(f64, f64)]]) -> Vec<Vec<Span>> {
        let all: Vec<Polylines> = outlines.iter().map(|points| polygon(points)).collect();
        rows(&all.iter().collect::<Vec<_>>(), 8, 6)
    }

    fn covered(points: &[(f64, f64)]) -> Vec<Vec<Span>> {
        covered_by(&[points])
    }

    fn sum(rows: &[Vec<Span>]) -> f64 {
        rows.iter().flatten().map(|s| f64::from((s.end - s.start) * s.level)).sum::<f64>() / f64::from(LEVELS)
    }

    #[test]
    fn a_rectangle_covers_its_area_with_halves_at_half_pixels() {
        let rows = covered(&[(1.5, 1.0), (4.0, 1.0), (4.0, 2.5), (1.5, 2.5)]);
        let span = |start, end, level| Span { start, end, level };
        assert_eq!(rows[1], [span(1, 2, 8), span(2, 4, 16)]);
        assert_eq!(rows[2], [span(1, 2, 4), span(2, 4, 8)]);
        assert_eq!(rows.iter().flatten().count(), 4);
    }

    #[test]
    fn the_sum_of_coverages_is_the_area_in_either_winding() {
        let triangle = [(0.3, 0.2), (7.7, 1.9), (2.1, 5.8)];
        let area = 0.5 * ((7.4 * 5.6) - (1.8 * 1.7));
        assert!((sum(&covered(&triangle)) - area).abs() < 0.25, "{}", sum(&covered(&triangle)));
        let reversed: Vec<_> = triangle.into_iter().rev().collect();
        assert_eq!(covered(&triangle), covered(&reversed));
    }

    #[test]
    fn what_lies_outside_the_image_is_cut() {
        let everything = covered(&[(-1e6, -1e6), (1e6, -1e6), (1e6, 1e6), (-1e6, 1e6)]);
        assert_eq!(sum(&everything), 48.0);
        assert_eq!(sum(&covered(&[(9.0, 1.0), (20.0, 1.0), (20.0, 3.0)])), 0.0);
        assert_eq!(sum(&covered(&[(-9.0, 1.0), (-2.0, 1.0), (-2.0, 3.0)])), 0.0);
        let half = covered(&[(4.0, -50.0), (4.0, 50.0), (-300.0, 0.0)]);
        assert!((sum(&half) - 24.0).abs() < 0.5, "{}", sum(&half));
    }

    #[test]
    fn areas_of_one_winding_do_not_add_up_beyond_one() {
        let one = [(1.0, 1.0), (5.0, 1.0), (5.0, 3.0), (1.0, 3.0)];
        let other = [(3.0, 1.0), (7.0, 1.0), (7.0, 3.0), (3.0, 3.0)];
        assert_eq!(sum(&covered_by(&[&one, &other])), 12.0);
    }

    #[test]
    fn an_intersection_has_what_both_have() {
        let a = covered(&[(0.0, 0.0), (4.0, 0.0), (4.0, 6.0), (0.0, 6.0)]);
        let b = covered(&[(2.5, 1.0), (8.0, 1.0), (8.0, 3.0), (2.5, 3.0)]);
        let both = |a: &[Vec<Span>], b: &[Vec<Span>]| -> Vec<Vec<Span>> {
            let mut out = Vec::new();
            for (a, b) in a.iter().zip(b) {
                let mut row = Vec::new();
                intersection(a, b, &mut row);
                out.push(row);
            }
            out
        };
        assert_eq!(sum(&both(&a, &b)), 3.0);
        assert_eq!(both(&a, &b), both(&b, &a));
    }

    #[test]
    fn bands_change_nothing() {
        let outline = polygon(&[(3.0, -20.0), (990.0, 40.5), (700.25, 93.0), (-40.0, 61.0)]);
        // Wide images have bands of fewer rows.
        let (narrow, wide) = (rows(&[&outline], 1000, 100), rows(&[&outline], 40_000, 100));
        assert_eq!(narrow, wide);
    }
}
