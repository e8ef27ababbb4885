//! The page: a headline, cells of panels, titles above them, a caption below.
//!
//! On 960 × 540 a panel reaches from y = 44 (20 without titles) to 476 and the caption has two lines below.
//! Other pages keep these margins and give the rest to the panels, in the arrangement of rows that leaves
//! them largest.

use crate::drawing::{Point, Rect};

/// Left and right margin, and the gap between panels, page pixels.
const MARGIN: f64 = 24.0;
/// Room above the panels, without their titles, page pixels.
const TOP: f64 = 20.0;
/// Height of a row of titles, page pixels.
const TITLE: f64 = 24.0;
/// From a title's baseline down to its panel, page pixels.
const TITLE_DROP: f64 = 12.0;
/// Room below the panels where there is no caption, page pixels.
const BOTTOM: f64 = 20.0;
/// Room below the panels for a caption of two lines, page pixels.
const CAPTION: f64 = 64.0;
/// From the panels down to the first baseline of the caption, page pixels.
const CAPTION_DROP: f64 = 24.0;
/// From one baseline of the caption to the next, on the usual page, page pixels.
const CAPTION_STEP: f64 = 20.0;
/// Type size of the caption, on the usual page, page pixels an em.
pub(crate) const CAPTION_SIZE: f64 = 14.0;
/// The share of `CAPTION_DROP` that stays on the smallest pages, whose letters are not as small as their
/// margins.
const LEAST_DROP: f64 = 0.75;
/// Width and height of the page that type sizes are made for, page pixels.
const USUAL: (f64, f64) = (960.0, 540.0);
/// The smallest base size that is set, page pixels an em.
const SMALLEST_TYPE: f64 = 11.0;
/// How much wider than high a panel looks best: what lies beyond it in width counts for nothing.
const WIDE: f64 = 1.2;
/// Type size of the headline, on the usual page, page pixels an em.
pub(crate) const HEADLINE_SIZE: f64 = 19.0;
/// From one baseline of the headline to the next, in ems: headings stand closer than text.
const HEADLINE_STEP: f64 = 1.25;
/// Height of the capitals of a headline, in ems.
const CAPITALS: f64 = 0.66;
/// From the last baseline of the headline down to what is below, in ems: a gap that is wider than that
/// between its lines.
const HEADLINE_DROP: f64 = 0.9;
/// The share of the page's height that a headline may take; a longer one is left to the alternative text.
const HEADLINE_SHARE: f64 = 0.17;
/// The share of the page's height that a caption may take; a longer one is left to the alternative text.
const CAPTION_SHARE: f64 = 0.34;

/// Where things lie on a page.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Page {
    /// Width of the page, page pixels.
    pub(crate) width: f64,
    /// Height of the page, page pixels.
    pub(crate) height: f64,
    /// The panels, row by row, page pixels.
    pub(crate) cells: Vec<Rect>,
    /// Lines between panels, page pixels.
    pub(crate) rules: Vec<(Point, Point)>,
    /// Left end of the first baseline of the headline, page pixels.
    pub(crate) headline: Point,
    /// From one baseline of the headline to the next, page pixels.
    pub(crate) headline_step: f64,
    /// Left end of the first baseline of the caption, page pixels.
    pub(crate) caption: Point,
    /// From one baseline of the caption to the next, page pixels.
    pub(crate) step: f64,
    /// Width of a caption's line, page pixels.
    pub(crate) measure: f64,
}

impl Page {
    /// Cells for `panels` panels, `titled` or not, between a headline of `head` lines and a caption of
    /// `lines` lines on a page of `width` × `height` pixels.
    pub(crate) fn new(
        (width, height): (f64, f64),
        panels: usize,
        titled: bool,
        (head, lines): (usize, usize),
    ) -> Self {
        let margin = margin(width, height);
        let k = margin / MARGIN;
        let step = caption_step(width, height);
        let foot = match lines {
            0 => BOTTOM * k,
            _ => k * (CAPTION - 2.0 * CAPTION_STEP) + step * count(lines.max(2)),
        };
        let top = TOP * k + headline_height(width, height, head);
        let body = Rect { x0: margin, y0: top, x1: width - margin, y1: (height - foot).max(top + 1.0) };
        let columns = columns(&body, panels, titled, margin);
        let rows = panels.max(1).div_ceil(columns);
        let size = cell(&body, columns, rows, titled, margin);
        let mut cells = Vec::new();
        for i in 0..panels {
            let (row, column) = (i / columns, i % columns);
            // A last row that is not full stands in the middle.
            let missing = columns - columns.min(panels - row * columns);
            let x0 = body.x0 + (count(column) + 0.5 * count(missing)) * (size.0 + margin);
            let y0 = body.y0 + count(row) * (size.1 + margin + title(titled)) + title(titled);
            cells.push(Rect { x0, y0, x1: x0 + size.0, y1: y0 + size.1 });
        }
        let rules = rules(&cells, columns, margin, titled);
        let caption = Point::new(margin, body.y1 + CAPTION_DROP * k.max(LEAST_DROP));
        let em = type_size(width, height, HEADLINE_SIZE);
        let headline = Point::new(margin, TOP * k + CAPITALS * em);
        let (headline_step, measure) = (HEADLINE_STEP * em, width - 2.0 * margin);
        Self { width, height, cells, rules, headline, headline_step, caption, step, measure }
    }

    /// The most lines of headline that a page takes.
    pub(crate) fn headline_lines(width: f64, height: f64) -> usize {
        let mut lines = 0;
        while headline_height(width, height, lines + 1) < HEADLINE_SHARE * height {
            lines += 1;
        }
        lines
    }

    /// The most lines of caption that a page takes.
    pub(crate) fn caption_lines(width: f64, height: f64) -> usize {
        let mut lines = 1;
        while caption_step(width, height) * count(lines + 1) < CAPTION_SHARE * height {
            lines += 1;
        }
        lines.max(2)
    }

    /// Middle of the baseline of a title over a panel, page pixels.
    pub(crate) fn title_baseline(cell: &Rect) -> Point {
        Point::new(cell.center().x, cell.y0 - TITLE_DROP)
    }
}

/// Margin of a page of `width` × `height` pixels, page pixels: smaller on small pages.
pub(crate) fn margin(width: f64, height: f64) -> f64 {
    MARGIN * (width / USUAL.0).min(height / USUAL.1).clamp(1.0 / 3.0, 1.0)
}

/// A type size on a page of `width` × `height` pixels: smaller on small pages, never under 11 px.
pub(crate) fn type_size(width: f64, height: f64, size: f64) -> f64 {
    (size * unit(width, height)).max(SMALLEST_TYPE.min(size))
}

/// The width of a line that is one pixel wide on the usual page; thinner on small pages.
pub(crate) fn unit(width: f64, height: f64) -> f64 {
    libm::sqrt((width / USUAL.0).min(height / USUAL.1).min(1.0))
}

/// What a headline of so many lines takes from the panels, page pixels.
fn headline_height(width: f64, height: f64, lines: usize) -> f64 {
    let em = type_size(width, height, HEADLINE_SIZE);
    let between = HEADLINE_STEP * count(lines.saturating_sub(1));
    if lines == 0 { 0.0 } else { (CAPITALS + between + HEADLINE_DROP) * em }
}

/// From one baseline of the caption to the next on a page, page pixels.
fn caption_step(width: f64, height: f64) -> f64 {
    CAPTION_STEP * type_size(width, height, CAPTION_SIZE) / CAPTION_SIZE
}

/// Height of the row of titles, if there is one, page pixels.
fn title(titled: bool) -> f64 {
    if titled { TITLE } else { 0.0 }
}

/// Width and height of each panel in so many columns and rows, page pixels.
fn cell(body: &Rect, columns: usize, rows: usize, titled: bool, gap: f64) -> (f64, f64) {
    let (c, r) = (count(columns), count(rows));
    let width = (body.width() - (c - 1.0) * gap) / c;
    let height = (body.height() - (r - 1.0) * gap - r * title(titled)) / r;
    (width.max(1.0), height.max(1.0))
}

/// The number of columns that leaves the panels largest; a panel is a little wider than high.
fn columns(body: &Rect, panels: usize, titled: bool, gap: f64) -> usize {
    let size = |columns: usize| {
        let (w, h) = cell(body, columns, panels.div_ceil(columns), titled, gap);
        w.min(WIDE * h)
    };
    let mut best = 1;
    for columns in 2..=panels {
        if size(columns) > size(best) {
            best = columns;
        }
    }
    best
}

/// Lines in the middle of the gaps between panels.
fn rules(cells: &[Rect], columns: usize, gap: f64, titled: bool) -> Vec<(Point, Point)> {
    let mut rules = Vec::new();
    for (i, cell) in cells.iter().enumerate() {
        if i % columns > 0 {
            let x = cell.x0 - 0.5 * gap;
            rules.push((Point::new(x, cell.y0), Point::new(x, cell.y1)));
        }
        if i >= columns {
            let y = cell.y0 - title(titled) - 0.5 * gap;
            rules.push((Point::new(cell.x0, y), Point::new(cell.x1, y)));
        }
    }
    rules
}

#[expect(clippy::cast_precision_loss, reason = "counts of panels and lines")]
fn count(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_page_is_that_of_the_storyboard() {
        let one = Page::new((960.0, 540.0), 1, false, (0, 2));
        assert_eq!(one.cells, [Rect { x0: 24.0, y0: 20.0, x1: 936.0, y1: 476.0 }]);
        let two = Page::new((960.0, 540.0), 2, true, (0, 1));
        assert_eq!(two.cells[0], Rect { x0: 24.0, y0: 44.0, x1: 468.0, y1: 476.0 });
        assert_eq!(two.cells[1], Rect { x0: 492.0, y0: 44.0, x1: 936.0, y1: 476.0 });
        assert_eq!(Page::title_baseline(&two.cells[0]).y, 32.0);
        let three = Page::new((960.0, 540.0), 3, true, (0, 2));
        assert_eq!(three.cells[2].width(), 288.0);
    }

    #[test]
    fn a_headline_takes_its_lines_from_the_panels_and_a_page_takes_few() {
        let top = |head| Page::new((960.0, 540.0), 1, false, (head, 2)).cells[0].y0;
        assert!(top(1) > top(0) + 19.0 && (top(2) - top(1) - 1.25 * 19.0).abs() < 1e-9);
        let page = Page::new((960.0, 540.0), 1, false, (2, 2));
        assert!(page.headline.y + page.headline_step < page.cells[0].y0);
        assert_eq!(Page::headline_lines(960.0, 540.0), 3);
        assert!(Page::headline_lines(320.0, 180.0) < 3);
    }

    #[test]
    fn panels_lie_on_every_page_without_touching() {
        for (w, h) in [(320.0, 180.0), (960.0, 540.0), (540.0, 960.0), (4096.0, 4096.0), (320.0, 4096.0)] {
            for panels in 1..=6 {
                let page = Page::new((w, h), panels, true, (1, 2));
                assert_eq!(page.cells.len(), panels);
                for (i, cell) in page.cells.iter().enumerate() {
                    assert!(
                        cell.x0 >= 0.0 && cell.y0 >= 0.0 && cell.x1 <= w && cell.y1 <= h,
                        "{w} {h} {cell:?}"
                    );
                    assert!(page.cells[..i].iter().all(|c| c.intersection(*cell).is_none()));
                }
            }
        }
    }

    #[test]
    fn type_is_never_under_eleven_pixels() {
        assert_eq!(type_size(320.0, 180.0, 12.0), 11.0);
        assert_eq!(type_size(960.0, 540.0, 17.0), 17.0);
        assert_eq!(type_size(4096.0, 4096.0, 17.0), 17.0);
    }
}
