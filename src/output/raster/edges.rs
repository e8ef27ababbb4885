//! Outlines cut to the image and dealt to bands of rows.
//!
//! An image is made a band of rows at a time, so that what is worked on stays small and near. An edge that runs through
//! several bands is cut at their borders; what is above or below the image is left out, what is left of it counts at the
//! left border (it covers what is right of it), what is right of it counts nowhere.

use super::polyline::Polylines;
use crate::drawing::Point;

/// Pixels of a band, about: its cells and colours then fit a second-level cache.
const BAND: usize = 1 << 15;

/// Most rows of a band.
const MOST_ROWS: usize = 16;

/// A directed piece of an outline, inside one band.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) from: Point,
    pub(super) to: Point,
}

/// What happens in one band, in painting order.
#[derive(Default)]
pub(super) struct Band {
    edges: Vec<Edge>,
    /// Numbers of steps, each with where its edges begin in `edges`.
    steps: Vec<(u32, u32)>,
}

impl Band {
    /// The steps that concern this band, each with its edges.
    pub(super) fn steps(&self) -> impl Iterator<Item = (usize, &[Edge])> {
        let ends = self.steps.iter().skip(1).map(|&(_, start)| start as usize);
        let ends = ends.chain([self.edges.len()]);
        self.steps
            .iter()
            .zip(ends)
            .map(|(&(step, start), end)| (step as usize, &self.edges[start as usize..end]))
    }
}

/// The bands of an image.
pub(super) struct Bands {
    width: f64,
    height: f64,
    /// Rows a band, a power of two.
    rows: usize,
    all: Vec<Band>,
}

impl Bands {
    #[expect(clippy::cast_precision_loss, reason = "an image is smaller than 2^26")]
    pub(super) fn new(width: usize, height: usize) -> Self {
        let rows = 1 << (BAND / width.max(1)).clamp(1, MOST_ROWS).ilog2();
        let mut bands = Vec::new();
        bands.resize_with(height.div_ceil(rows), Band::default);
        Self { width: width as f64, height: height as f64, rows, all: bands }
    }

    /// Rows a band.
    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// The bands from the top.
    pub(super) fn into_bands(self) -> Vec<Band> {
        self.all
    }

    /// A step without edges concerns the bands of these rows.
    #[expect(clippy::cast_possible_truncation, reason = "a display list has fewer than 2^32 entries")]
    pub(super) fn mark(&mut self, step: usize, rows: &std::ops::Range<usize>) {
        for band in &mut self.all[rows.start / self.rows..rows.end.div_ceil(self.rows)] {
            band.steps.push((step as u32, band.edges.len() as u32));
        }
    }

    /// Adds a step's outlines; open ones are closed.
    pub(super) fn add(&mut self, step: usize, lines: &Polylines) {
        for (points, _) in lines.chains() {
            let Some(&last) = points.last() else { continue };
            let mut from = last;
            for &to in points {
                self.line(step, from, to);
                from = to;
            }
        }
    }

    /// Cuts a line to the image.
    fn line(&mut self, step: usize, from: Point, to: Point) {
        if from.y == to.y {
            return;
        }
        let (mut p, mut q) = (from, to);
        if !cut(&mut p, &mut q, 0.0, -1.0) || !cut(&mut p, &mut q, self.height, 1.0) {
            return;
        }
        let (low, high) = (p.x.min(q.x), p.x.max(q.x));
        if 0.0 <= low && high < self.width {
            return self.deal(step, p, q);
        }
        if low >= self.width {
            return;
        }
        let x_at = |x: f64| Point::new(x, p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y));
        let clamp = |point: Point| Point::new(point.x.max(0.0), point.y);
        let mut start = p;
        let mut stops = [0.0, self.width];
        if p.x > q.x {
            stops.reverse();
        }
        for stop in stops {
            if low < stop && stop < high {
                let middle = x_at(stop);
                self.deal(step, clamp(start), clamp(middle));
                start = middle;
            }
        }
        self.deal(step, clamp(start), clamp(q));
    }

    /// Deals a line inside the image's rows and not left of it to the bands that it runs through.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside the image")]
    #[expect(clippy::cast_precision_loss, reason = "rows of an image")]
    fn deal(&mut self, step: usize, p: Point, q: Point) {
        if p.y == q.y || p.x.min(q.x) >= self.width {
            return;
        }
        let (top, bottom) = if p.y < q.y { (p, q) } else { (q, p) };
        let (mut band, rows) = (top.y as usize / self.rows, self.rows);
        let border = |band: usize| ((band + 1) * rows) as f64;
        if bottom.y <= border(band) {
            return self.push(step, band, Edge { from: p, to: q });
        }
        let slope = (bottom.x - top.x) / (bottom.y - top.y);
        let mut from = top;
        while from.y < bottom.y {
            let y = border(band).min(bottom.y);
            let to = if y == bottom.y { bottom } else { Point::new(top.x + (y - top.y) * slope, y) };
            self.push(step, band, if p.y < q.y { Edge { from, to } } else { Edge { from: to, to: from } });
            (band, from) = (band + 1, to);
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "a display list has fewer than 2^32 edges")]
    fn push(&mut self, step: usize, band: usize, edge: Edge) {
        // A line may end in the image's last row by rounding only.
        let Some(band) = self.all.get_mut(band) else { return };
        if band.steps.last().is_none_or(|&(last, _)| last as usize != step) {
            band.steps.push((step as u32, band.edges.len() as u32));
        }
        band.edges.push(edge);
    }
}

/// Cuts the piece from `p` to `q` at a height, keeping what is on the side where `sign · y` is smaller; `false` where
/// nothing is left.
fn cut(p: &mut Point, q: &mut Point, limit: f64, sign: f64) -> bool {
    let (a, b) = (sign * (p.y - limit), sign * (q.y - limit));
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
