//! How much of each pixel an area covers: exact areas, no samples.
//!
//! Walking along an outline, each piece inside a pixel row adds to the pixel that it crosses the area to its right in that
//! pixel, and to all pixels further right its height. The running sum along a row is then the coverage, times the winding
//! number. Only crossed pixels are stored; between them coverage is constant. Windings of one sign add up and are cut at 1,
//! which is the non-zero rule except in pixels that two edges share.
//! Source: the *cells* of D. Turner's smooth rasterizer in `FreeType`, and of M. Shemanarev's Anti-Grain Geometry, 2002.

use super::polyline::Polylines;
use crate::drawing::Point;

/// Levels of coverage. Sixteen are what the eye tells apart at an edge, and keep the colours of an image few.
pub(super) const LEVELS: u32 = 16;

/// Pixels of one row with one coverage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) y: u32,
    pub(super) start: u32,
    pub(super) end: u32,
    /// From 1 to [`LEVELS`].
    pub(super) level: u32,
}

/// A pixel that an outline crosses.
#[derive(Clone, Copy)]
struct Cell {
    x: i32,
    y: u32,
    /// Signed height of the outline in this pixel.
    cover: f32,
    /// Signed area right of it in this pixel.
    area: f32,
}

/// Collects outlines and gives their coverage; its memory is used again.
#[derive(Default)]
pub(super) struct Rasterizer {
    width: f64,
    height: f64,
    cells: Vec<Cell>,
    /// Cells in order of their row.
    sorted: Vec<Cell>,
    /// Where each row's cells begin in `sorted`.
    rows: Vec<usize>,
    spans: Vec<Span>,
}

impl Rasterizer {
    pub(super) fn new(width: u32, height: u32) -> Self {
        Self { width: f64::from(width), height: f64::from(height), ..Self::default() }
    }

    /// Adds outlines; open ones are closed.
    pub(super) fn add(&mut self, lines: &Polylines) {
        for (points, _) in lines.chains() {
            let Some(&last) = points.last() else { continue };
            let mut from = last;
            for &to in points {
                self.line(from, to);
                from = to;
            }
        }
    }

    /// Adds a piece of an outline, cut to the image: above and below it nothing counts, left of it only the height does,
    /// right of it nothing does.
    fn line(&mut self, from: Point, to: Point) {
        if from.y == to.y {
            return;
        }
        let (mut p, mut q) = (from, to);
        if !cut(&mut p, &mut q, 0.0, |p| p.y, -1.0) || !cut(&mut p, &mut q, self.height, |p| p.y, 1.0) {
            return;
        }
        let x_at = |x: f64| {
            let t = (x - p.x) / (q.x - p.x);
            Point::new(x, p.y + t * (q.y - p.y))
        };
        let (low, high) = (p.x.min(q.x), p.x.max(q.x));
        if low >= self.width {
            return;
        }
        let clamp = |point: Point| Point::new(point.x.max(0.0), point.y);
        let mut start = p;
        let mut stops = [0.0, self.width];
        if p.x > q.x {
            stops.reverse();
        }
        for stop in stops {
            if low < stop && stop < high {
                let middle = x_at(stop);
                self.piece(clamp(start), clamp(middle));
                start = middle;
            }
        }
        self.piece(clamp(start), clamp(q));
    }

    /// Adds a piece that lies within the image's rows and not left of it.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside the image")]
    fn piece(&mut self, p: Point, q: Point) {
        if p.y == q.y || p.x.min(q.x) >= self.width {
            return;
        }
        let (sign, top, bottom) = if p.y < q.y { (1.0, p, q) } else { (-1.0, q, p) };
        let slope = (bottom.x - top.x) / (bottom.y - top.y);
        // Nothing is negative here, so cutting off the fraction is rounding down.
        let mut row = top.y as u32;
        let (mut x, mut y) = (top.x, top.y);
        let rows = self.height as u32;
        while y < bottom.y && row < rows {
            let next_row = f64::from(row + 1);
            let (next_x, next_y) = if next_row < bottom.y {
                (top.x + (next_row - top.y) * slope, next_row)
            } else {
                (bottom.x, bottom.y)
            };
            self.within_row(row, x, next_x, sign * (next_y - y));
            (x, y) = (next_x, next_y);
            row += 1;
        }
    }

    /// Adds a piece inside one row that runs from `x0` to `x1` and has that signed height.
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "inside the image")]
    fn within_row(&mut self, y: u32, x0: f64, x1: f64, height: f64) {
        let (left, right) = if x0 < x1 { (x0, x1) } else { (x1, x0) };
        let (first, last) = (left as i32, right as i32);
        if first == last {
            let area = height * (1.0 - (0.5 * (left + right) - f64::from(first)));
            self.cell(y, first, height as f32, area as f32);
            return;
        }
        let per_pixel = height / (right - left);
        let mut at = left;
        let mut pixel = first;
        while at < right {
            let next = f64::from(pixel + 1).min(right);
            let part = per_pixel * (next - at);
            let area = part * (1.0 - (0.5 * (at + next) - f64::from(pixel)));
            self.cell(y, pixel, part as f32, area as f32);
            at = next;
            pixel += 1;
        }
    }

    #[inline]
    fn cell(&mut self, y: u32, x: i32, cover: f32, area: f32) {
        if let Some(last) = self.cells.last_mut()
            && last.x == x
            && last.y == y
        {
            last.cover += cover;
            last.area += area;
            return;
        }
        self.cells.push(Cell { x, y, cover, area });
    }

    /// The coverage of all that was added since the last call, by rows from the top and from left to right.
    pub(super) fn finish(&mut self) -> &[Span] {
        self.spans.clear();
        self.sort();
        for row in 0..self.rows.len().saturating_sub(1) {
            let (start, end) = (self.rows[row], self.rows[row + 1]);
            let cells = &mut self.sorted[start..end];
            if let Some(first) = cells.first() {
                let y = first.y;
                cells.sort_unstable_by_key(|cell| cell.x);
                sweep(y, cells, self.width, &mut self.spans);
            }
        }
        self.cells.clear();
        &self.spans
    }

    /// Brings the cells into the order of their rows by counting.
    fn sort(&mut self) {
        let top = self.cells.iter().map(|cell| cell.y).min().unwrap_or(0);
        let bottom = self.cells.iter().map(|cell| cell.y + 1).max().unwrap_or(0);
        self.rows.clear();
        self.rows.resize((bottom - top) as usize + 1, 0);
        for cell in &self.cells {
            self.rows[(cell.y - top) as usize + 1] += 1;
        }
        for row in 1..self.rows.len() {
            self.rows[row] += self.rows[row - 1];
        }
        self.sorted.clear();
        self.sorted.resize(self.cells.len(), Cell { x: 0, y: 0, cover: 0.0, area: 0.0 });
        let mut next = self.rows.clone();
        for &cell in &self.cells {
            let place = &mut next[(cell.y - top) as usize];
            self.sorted[*place] = cell;
            *place += 1;
        }
    }
}

/// Cuts the piece from `p` to `q` at `limit` of a coordinate, keeping what is on the side where `sign · coordinate` is
/// smaller; `false` where nothing is left.
fn cut(p: &mut Point, q: &mut Point, limit: f64, of: impl Fn(&Point) -> f64, sign: f64) -> bool {
    let (a, b) = (sign * (of(p) - limit), sign * (of(q) - limit));
    if a >= 0.0 && b >= 0.0 {
        return false;
    }
    if a > 0.0 || b > 0.0 {
        let t = a / (a - b);
        let middle = Point::new(p.x + t * (q.x - p.x), limit);
        *(if a > 0.0 { p } else { q }) = middle;
    }
    true
}

/// Adds up the cells of a row, sorted by x.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside the image")]
fn sweep(y: u32, cells: &[Cell], width: f64, spans: &mut Vec<Span>) {
    let width = width as u32;
    let mut cover = 0.0_f32;
    let mut x = 0;
    for same in cells.chunk_by(|a, b| a.x == b.x) {
        let at = (same[0].x as u32).min(width);
        push(spans, Span { y, start: x, end: at, level: level(cover) });
        let area: f32 = same.iter().map(|cell| cell.area).sum();
        if at < width {
            push(spans, Span { y, start: at, end: at + 1, level: level(cover + area) });
        }
        cover += same.iter().map(|cell| cell.cover).sum::<f32>();
        x = at + 1;
    }
    push(spans, Span { y, start: x, end: width, level: level(cover) });
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and LEVELS")]
fn level(coverage: f32) -> u32 {
    (coverage.abs().min(1.0) * f32::from(LEVELS as u16) + 0.5) as u32
}

fn push(spans: &mut Vec<Span>, span: Span) {
    if span.level == 0 || span.start >= span.end {
        return;
    }
    if let Some(last) = spans.last_mut()
        && (last.y, last.end, last.level) == (span.y, span.start, span.level)
    {
        last.end = span.end;
        return;
    }
    spans.push(span);
}

/// Where both cover something, the product of their coverages.
pub(super) fn intersection(a: &[Span], b: &[Span]) -> Vec<Span> {
    let mut both = Vec::new();
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let (p, q) = (a[i], b[j]);
        let start = p.start.max(q.start);
        let end = p.end.min(q.end);
        if p.y == q.y && start < end {
            push(&mut both, Span { y: p.y, start, end, level: (p.level * q.level + LEVELS / 2) / LEVELS });
        }
        if (p.y, p.end) <= (q.y, q.end) {
            i += 1;
        } else {
            j += 1;
        }
    }
    both
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[(f64, f64)]) -> Polylines {
        let points: Vec<Point> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let ends = vec![(points.len(), true)];
        Polylines { points, ends }
    }

    fn covered(points: &[(f64, f64)]) -> Vec<Span> {
        let mut rasterizer = Rasterizer::new(8, 6);
        rasterizer.add(&polygon(points));
        rasterizer.finish().to_vec()
    }

    fn sum(spans: &[Span]) -> f64 {
        spans.iter().map(|s| f64::from((s.end - s.start) * s.level)).sum::<f64>() / f64::from(LEVELS)
    }

    #[test]
    fn a_rectangle_covers_its_area_with_halves_at_half_pixels() {
        let spans = covered(&[(1.5, 1.0), (4.0, 1.0), (4.0, 2.5), (1.5, 2.5)]);
        let span = |y, start, end, level| Span { y, start, end, level };
        assert_eq!(spans, [span(1, 1, 2, 8), span(1, 2, 4, 16), span(2, 1, 2, 4), span(2, 2, 4, 8)]);
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
        assert_eq!(covered(&[(9.0, 1.0), (20.0, 1.0), (20.0, 3.0)]), []);
        assert_eq!(covered(&[(-9.0, 1.0), (-2.0, 1.0), (-2.0, 3.0)]), []);
        let half = covered(&[(4.0, -50.0), (4.0, 50.0), (-300.0, 0.0)]);
        assert!((sum(&half) - 24.0).abs() < 0.5, "{}", sum(&half));
    }

    #[test]
    fn areas_of_one_winding_do_not_add_up_beyond_one() {
        let mut rasterizer = Rasterizer::new(8, 6);
        rasterizer.add(&polygon(&[(1.0, 1.0), (5.0, 1.0), (5.0, 3.0), (1.0, 3.0)]));
        rasterizer.add(&polygon(&[(3.0, 1.0), (7.0, 1.0), (7.0, 3.0), (3.0, 3.0)]));
        assert_eq!(sum(rasterizer.finish()), 12.0);
    }

    #[test]
    fn an_intersection_has_what_both_have() {
        let a = covered(&[(0.0, 0.0), (4.0, 0.0), (4.0, 6.0), (0.0, 6.0)]);
        let b = covered(&[(2.5, 1.0), (8.0, 1.0), (8.0, 3.0), (2.5, 3.0)]);
        assert_eq!(sum(&intersection(&a, &b)), 3.0);
        assert_eq!(intersection(&a, &b), intersection(&b, &a));
    }
}
