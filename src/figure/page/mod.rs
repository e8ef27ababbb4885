//! The page: a headline, rows of panels with titles above them, a caption below.
//!
//! A page without a given height ends where the drawing ends: each row of panels is as high as what its
//! panels show at their width, within limits. A page of a given height has rows of one height, in the
//! arrangement that leaves the panels largest.

mod flow;
mod measures;
mod rows;

use crate::drawing::{Point, Rect};

use measures::count;

pub(crate) use measures::Measures;
pub(crate) use rows::{Want, in_column, room};

/// What a page has to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    /// Its sizes.
    pub(crate) measures: Measures,
    /// Panels side by side, where the scene says how many.
    pub(crate) columns: Option<usize>,
    /// Lines of the longest title of a panel; 0 where none has one.
    pub(crate) titles: usize,
    /// Lines of the headline.
    pub(crate) head: usize,
    /// Lines of the caption.
    pub(crate) lines: usize,
}

/// The room that each panel has for its words.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Words {
    /// The least width of each panel, page pixels.
    widths: Vec<f64>,
    /// Lines of caption that there is room for below each.
    lines: usize,
    /// Whether the page grows with them.
    grows: bool,
}

impl Words {
    /// How wide a line of a panel's title may be, page pixels; `None` on a page of a given height, where more
    /// lines would take room from the panels.
    pub(crate) fn title_width(&self, panel: usize) -> Option<f64> {
        self.widths.get(panel).copied().filter(|_| self.grows)
    }

    /// How wide a line of a panel's caption is, page pixels, and how many lines there is room for.
    pub(crate) fn under(&self, panel: usize) -> (f64, usize) {
        (self.widths.get(panel).copied().unwrap_or_default(), self.lines)
    }
}

/// Where things lie on a page.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Page {
    /// Width of the page, page pixels.
    pub(crate) width: f64,
    /// Height of the page, page pixels.
    pub(crate) height: f64,
    /// Panels of one column side by side.
    pub(crate) columns: usize,
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
    /// From the left end of a column of the caption to that of the next, page pixels.
    pub(crate) caption_column: f64,
    /// From a panel's title's baseline down to the panel, page pixels.
    title_drop: f64,
    /// From one baseline of a panel's title to the next, page pixels.
    title_step: f64,
    /// From a panel down to the first baseline of its caption, page pixels.
    drop: f64,
    /// From one baseline of a caption to the next, page pixels.
    pub(crate) step: f64,
}

impl Layout {
    /// Cells for panels that show so much, above the caption.
    pub(crate) fn page(&self, wants: &[Want]) -> Page {
        let Self { measures, titles, head, .. } = *self;
        let (side, gap) = (measures.side(), measures.gap());
        let title = measures.title(titles);
        let longest = |panels: &[Want]| panels.iter().map(|want| want.lines).max().unwrap_or(0);
        let foot = measures.foot(count(self.caption_room()));
        let top = measures.top() + measures.headline_height(head);
        let space = rows::Space {
            width: measures.width - 2.0 * side,
            height: measures.height.map(|height| height - foot - top),
            gap,
            words: title + measures.under(longest(wants)),
            larger: measures.larger(),
        };
        let rows::Grid { columns, rows } = space.grid(wants, self.columns);
        let column = space.panel_width(1, columns) + gap;
        let mut cells = Vec::new();
        let mut y0 = top;
        for (row, height) in rows {
            let of_row = wants.get(row).unwrap_or_default();
            // A row that is not full stands in the middle.
            let taken: f64 = of_row.iter().map(|want| want.taken(columns)).sum();
            let mut before = 0.5 * (count(columns) - taken);
            y0 += title;
            for want in of_row {
                let x0 = side + before * column;
                let x1 = x0 + space.panel_width(want.columns, columns);
                cells.push(Rect { x0, y0, x1, y1: y0 + height });
                before += want.taken(columns);
            }
            // On a page of a given height all rows are as high.
            let lines = longest(if measures.height.is_some() { wants } else { of_row });
            y0 += height + measures.under(lines) + gap;
        }
        let bottom = match measures.height {
            Some(height) => (height - foot).max(top + 1.0),
            None => y0 - gap,
        };
        Page {
            width: measures.width,
            height: measures.height.unwrap_or((bottom + foot).ceil()),
            columns,
            rules: rules(&cells, columns, gap, title),
            cells,
            headline: Point::new(side, measures.top() + measures.headline_rise()),
            headline_step: measures.headline_step(),
            caption: Point::new(side, bottom + measures.drop()),
            caption_column: 0.5 * (measures.measure() + measures.gap()),
            title_drop: measures.title_drop(),
            title_step: measures.title_step(),
            drop: measures.drop(),
            step: measures.step(),
        }
    }

    /// What panels that ask for so many columns each may take for their words, whatever they show, on a page
    /// whose scene says how many columns it has.
    pub(crate) fn words(measures: &Measures, asked: Vec<usize>, columns: Option<usize>) -> Words {
        let space = without_end(measures);
        let columns = space.most(&asked, columns);
        let lines = measures.caption_lines(count(flow::rows(&asked, columns).len()));
        let widths = asked.into_iter().map(|asked| space.panel_width(asked, columns)).collect();
        Words { widths, lines, grows: measures.height.is_none() }
    }

    /// Fewer columns than so many, the most first, in which panels fill all rows that ask for so many each;
    /// with the width of each panel there, page pixels.
    pub(crate) fn fewer(&self, asked: &[usize], columns: usize) -> impl Iterator<Item = (usize, Vec<f64>)> {
        let space = without_end(&self.measures);
        let full = (1..columns).rev().filter(|columns| flow::is_full(asked, *columns));
        full.map(move |columns| (columns, asked.iter().map(|n| space.panel_width(*n, columns)).collect()))
    }

    /// Lines that the caption has room for: on a page of a given height no fewer than two, so that the panels
    /// of two figures with short captions are as high.
    fn caption_room(&self) -> usize {
        match (self.lines, self.measures.height) {
            (0, _) | (_, None) => self.lines,
            (lines, Some(_)) => lines.max(2),
        }
    }
}

impl Page {
    /// Left ends of the baselines of the caption below a panel, page pixels, from the top.
    pub(crate) fn caption_baselines(&self, cell: &Rect) -> impl Iterator<Item = Point> {
        let (left, first, step) = (cell.x0, cell.y1 + self.drop, self.step);
        (0_u32..).map(move |below| Point::new(left, first + step * f64::from(below)))
    }

    /// Left ends of the baselines of a title of so many lines over a panel, page pixels, from the top.
    pub(crate) fn title_baselines(&self, cell: &Rect, lines: usize) -> impl Iterator<Item = Point> {
        let (left, last, step) = (cell.x0, cell.y0 - self.title_drop, self.title_step);
        (0..lines).rev().map(move |above| Point::new(left, last - step * count(above)))
    }
}

/// The room for panels of a page that ends with the drawing.
fn without_end(measures: &Measures) -> rows::Space {
    rows::Space {
        width: measures.measure(),
        height: None,
        gap: measures.gap(),
        words: 0.0,
        larger: measures.larger(),
    }
}

/// Lines in the middle of the gaps between panels; `title` is the height of a row of titles. Between rows of
/// several panels titles part enough: lines both ways would be a cross, the first thing that is seen.
fn rules(cells: &[Rect], columns: usize, gap: f64, title: f64) -> Vec<(Point, Point)> {
    let mut rules = Vec::new();
    let top = cells.first().map_or(0.0, |cell| cell.y0);
    for (i, cell) in cells.iter().enumerate() {
        if i > 0 && cells[i - 1].y0 == cell.y0 {
            let x = cell.x0 - 0.5 * gap;
            rules.push((Point::new(x, cell.y0), Point::new(x, cell.y1)));
        }
        if cell.y0 > top && (columns == 1 || title == 0.0) {
            let y = cell.y0 - title - 0.5 * gap;
            rules.push((Point::new(cell.x0, y), Point::new(cell.x1, y)));
        }
    }
    rules
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::theme::TypeSizes;
    use crate::scene::{Canvas, Height};

    /// A page for panels that show so much each.
    fn page(canvas: &Canvas, wants: &[(f64, f64)], titles: usize, lines: usize) -> Page {
        let measures = Measures::of(canvas, TypeSizes::HOUSE);
        let layout = Layout { measures, columns: canvas.columns, titles, head: 0, lines };
        let want = |&(width, height)| Want { width, height, room: false, columns: 1, lines: 0 };
        layout.page(&wants.iter().map(want).collect::<Vec<_>>())
    }

    /// A page for panels, twice as wide as high, that ask for so many columns each.
    fn spread(canvas: &Canvas, asked: &[usize]) -> Page {
        let measures = Measures::of(canvas, TypeSizes::HOUSE);
        let layout = Layout { measures, columns: canvas.columns, titles: 1, head: 1, lines: 1 };
        let want = |&columns| Want { width: 2.0, height: 1.0, room: false, columns, lines: 2 };
        layout.page(&asked.iter().map(want).collect::<Vec<_>>())
    }

    fn of_size(width: f64, height: Option<f64>) -> Canvas {
        Canvas { width: Some(width), height: height.map(Height::Pixels), ..Canvas::default() }
    }

    #[test]
    fn a_page_of_a_given_height_gives_the_panels_all_that_the_caption_leaves() {
        let usual = of_size(960.0, Some(540.0));
        let one = page(&usual, &[(1.0, 1.0)], 0, 2);
        assert_eq!(one.cells, [Rect { x0: 24.0, y0: 20.0, x1: 936.0, y1: 476.0 }]);
        let two = page(&usual, &[(1.0, 1.0); 2], 1, 1);
        assert_eq!(two.cells[0], Rect { x0: 24.0, y0: 44.0, x1: 468.0, y1: 476.0 });
        assert_eq!(two.cells[1], Rect { x0: 492.0, y0: 44.0, x1: 936.0, y1: 476.0 });
        assert_eq!(two.title_baselines(&two.cells[0], 1).next().unwrap().y, 30.0);
        let three = page(&usual, &[(1.0, 1.0); 3], 1, 2);
        assert_eq!(three.cells[2].width(), 288.0);
    }

    #[test]
    fn a_page_without_a_height_ends_where_the_drawing_ends() {
        let page = page(&Canvas::default(), &[(4.0, 1.0)], 0, 1);
        assert_eq!(page.cells, [Rect { x0: 24.0, y0: 20.0, x1: 936.0, y1: 248.0 }]);
        assert_eq!((page.caption.y, page.height), (272.0, 292.0));
    }

    #[test]
    fn a_headline_moves_the_panels_down() {
        for canvas in [Canvas::default(), of_size(960.0, Some(540.0))] {
            let layout = |head| Layout {
                measures: Measures::of(&canvas, TypeSizes::HOUSE),
                columns: None,
                titles: 0,
                head,
                lines: 2,
            };
            let page = |head| {
                layout(head).page(&[Want { width: 2.0, height: 1.0, room: false, columns: 1, lines: 0 }])
            };
            let top = |head| page(head).cells[0].y0;
            assert!(top(1) > top(0) + 19.0 && top(2) - top(1) == 24.0);
            let page = page(2);
            assert!(page.headline.y + page.headline_step < page.cells[0].y0);
        }
    }

    #[test]
    fn a_row_keeps_room_for_its_own_captions_and_on_a_page_of_a_given_height_for_the_longest() {
        let bottom = |canvas: &Canvas, lines: [usize; 2]| {
            let measures = Measures::of(canvas, TypeSizes::HOUSE);
            let layout = Layout { measures, columns: Some(1), titles: 0, head: 0, lines: 0 };
            let page = layout.page(&lines.map(|lines| Want {
                width: 2.0,
                height: 1.0,
                room: false,
                columns: 1,
                lines,
            }));
            (page.height, page.cells[1].y1, page.cells[0].y1)
        };
        let free = Canvas::default();
        assert!(bottom(&free, [2, 1]).0 < bottom(&free, [2, 2]).0);
        assert_eq!(bottom(&free, [2, 1]).1, bottom(&free, [2, 2]).1);
        let given = of_size(960.0, Some(1200.0));
        assert_eq!(bottom(&given, [2, 1]), bottom(&given, [2, 2]));
    }

    #[test]
    fn a_title_of_more_lines_stands_above_its_panel() {
        let page = |titles| page(&Canvas::default(), &[(2.0, 1.0)], titles, 0);
        let top = |titles| page(titles).cells[0].y0;
        assert!(top(1) > top(0) && (top(3) - top(1) - 2.0 * 17.0).abs() < 1e-9);
        let page = page(3);
        let ys: Vec<f64> = page.title_baselines(&page.cells[0], 3).map(|p| p.y).collect();
        assert!(20.0 + 9.0 < ys[0] && ys[0] < ys[1] && ys[2] == page.cells[0].y0 - 14.0, "{ys:?}");
    }

    #[test]
    fn panels_of_a_row_share_its_height_and_rows_differ() {
        let canvas = Canvas { columns: Some(2), ..Canvas::default() };
        let cells = page(&canvas, &[(2.0, 1.0), (1.0, 1.0), (4.0, 1.0)], 0, 0).cells;
        let heights: Vec<f64> = cells.iter().map(|cell| cell.height()).collect();
        assert_eq!(heights[0], heights[1]);
        assert_eq!(heights[2], 111.0);
        assert_eq!(cells[2].center().x, 480.0, "a row that is not full stands in the middle");
    }

    #[test]
    fn a_panel_of_two_columns_is_as_wide_as_two_panels_with_the_gap_between() {
        for (asked, above, below) in [(vec![1, 1, 2], 0..2, 2..3), (vec![2, 1, 1], 1..3, 0..1)] {
            for canvas in [Canvas::default(), of_size(960.0, Some(700.0))] {
                let Page { cells, columns, .. } = spread(&canvas, &asked);
                let (two, one) = (&cells[above.clone()], &cells[below.clone()]);
                assert_eq!((columns, one[0].x0, one[0].x1), (2, two[0].x0, two[1].x1), "{asked:?}");
                assert!(two[0].y0 == two[1].y0 && two[0].width() < one[0].width() / 2.0);
            }
        }
        // Three above two, the first of which is wider; and on a telephone each is alone.
        let cells = spread(&Canvas { columns: Some(3), ..Canvas::default() }, &[1, 1, 1, 2, 1]).cells;
        assert_eq!([cells[3].x1, cells[4].x0], [cells[1].x1, cells[2].x0]);
        let narrow = spread(&of_size(360.0, None), &[1, 1, 2]);
        assert!(
            narrow.columns == 1 && narrow.cells.iter().all(|cell| cell.width() == narrow.cells[0].width())
        );
    }

    #[test]
    fn words_of_a_panel_are_as_wide_as_it_is() {
        let sizes = [(960.0, None), (960.0, Some(540.0)), (1200.0, Some(300.0)), (360.0, None)];
        for ((width, height), asked) in sizes.into_iter().zip([[1, 1, 2], [1, 1, 2], [3, 1, 2], [1, 2, 1]]) {
            let canvas = of_size(width, height);
            let words = Layout::words(&Measures::of(&canvas, TypeSizes::HOUSE), asked.to_vec(), None);
            for (i, cell) in spread(&canvas, &asked).cells.iter().enumerate() {
                assert!(words.under(i).0 <= cell.width(), "{width} {asked:?}");
            }
        }
    }

    #[test]
    fn rules_do_not_cross_where_titles_part_the_rows() {
        let level = |columns, titles| {
            let canvas = Canvas { columns: Some(columns), ..Canvas::default() };
            let page = page(&canvas, &[(2.0, 1.0); 4], titles, 0);
            page.rules.iter().filter(|(p, q)| p.y == q.y).count()
        };
        assert_eq!([level(2, 1), level(2, 0), level(1, 1)], [0, 2, 3]);
    }

    #[test]
    fn panels_lie_on_every_page_without_touching() {
        let sizes = [(320.0, 180.0), (960.0, 540.0), (540.0, 960.0), (4096.0, 4096.0), (320.0, 4096.0)];
        let given = sizes.map(|(w, h)| of_size(w, Some(h)));
        let grown = [100.0, 320.0, 960.0, 4096.0].map(|w| of_size(w, None));
        for canvas in given.iter().chain(&grown) {
            for (panels, columns) in (1..=6).flat_map(|n| [(n, None), (n, Some(1)), (n, Some(4))]) {
                let canvas = &Canvas { columns, ..canvas.clone() };
                let asked: Vec<usize> = (1..=panels).map(|i| 1 + 2 * i % 3).collect();
                are_apart(canvas, &spread(canvas, &asked));
                for wants in [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0), (1e300, 1e-300)] {
                    let page = page(canvas, &vec![wants; panels], 1, 2);
                    assert_eq!(page.cells.len(), panels);
                    are_apart(canvas, &page);
                }
            }
        }
    }

    fn are_apart(canvas: &Canvas, page: &Page) {
        for (i, cell) in page.cells.iter().enumerate() {
            let on_page = cell.x0 >= 0.0 && cell.x1 <= page.width + 1e-9 && cell.y1 <= page.height;
            assert!(on_page && cell.x0 < cell.x1 && cell.y0 < cell.y1, "{canvas:?} {cell:?}");
            assert!(page.cells[..i].iter().all(|c| c.intersection(*cell).is_none()));
        }
    }
}
