//! How panels share the room that a page has for them: how many stand side by side, how high each row is.

use std::ops::Range;

use super::flow;
use super::measures::count;

/// How much wider than high a panel of a page of a given height looks best: what lies beyond it in width
/// counts for nothing.
const WIDE: f64 = 1.2;
/// The least width of a panel that stands beside another one, page pixels: a name, a vector and its label.
const NARROWEST: f64 = 220.0;
/// The least height of a panel, page pixels: two labels above one another.
const LOWEST: f64 = 96.0;
/// The height of one row against the page's width, at most; and of each of several rows.
const TALLEST: (f64, f64) = (0.64, 0.42);
/// The height that any panel may have, page pixels: on a narrow page it is more than its share.
const ANYWAY: f64 = 400.0;
/// How much higher than wide a panel is at most.
const TALL: f64 = 1.6;
/// Height of all rows that a page can have, page pixels.
const MOST: f64 = 4096.0;
/// Room for labels around what a panel without a `view` draws, page pixels; less in small panels.
const ROOM: f64 = 40.0;
/// The share of a panel's width that this room may take at each end, and of its height.
const ROOM_SHARE: (f64, f64) = (0.12, 0.18);

/// What a panel has to show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Want {
    /// Width of what it shows, in units of its space.
    pub(crate) width: f64,
    /// Height of what it shows, in the same units.
    pub(crate) height: f64,
    /// Whether it is as large as all others are, with room for labels around it.
    pub(crate) room: bool,
    /// The columns that it asks for.
    pub(crate) columns: usize,
    /// Lines of the caption below it.
    pub(crate) lines: usize,
}

impl Want {
    /// The columns that it takes, of so many.
    pub(crate) fn taken(&self, columns: usize) -> f64 {
        count(flow::taken(self.columns, columns))
    }
}

/// How much of their space the panels that are as large as each other show in a column of so many.
pub(crate) fn in_column(wants: &[Want], columns: usize) -> f64 {
    let own = |want: &Want| want.width / want.taken(columns);
    wants.iter().filter(|want| want.room).map(own).fold(0.0, f64::max)
}

/// The room that a page has for panels, page pixels.
pub(super) struct Space {
    /// From the left margin to the right one.
    pub(super) width: f64,
    /// From the first title to the caption; `None` where the page ends with the drawing.
    pub(super) height: Option<f64>,
    /// Between panels.
    pub(super) gap: f64,
    /// Height of the titles above each row, and of the longest captions below.
    pub(super) words: f64,
    /// How much larger letters are than usual; at least 1.
    pub(super) larger: f64,
}

/// Panels in rows.
pub(super) struct Grid {
    /// Panels of one column side by side.
    pub(super) columns: usize,
    /// Each row by the panels in it, and its height, page pixels.
    pub(super) rows: Vec<(Range<usize>, f64)>,
}

/// Room for labels left and right of what a panel draws, and above and below, page pixels, in a panel of
/// `width` × `height` pixels whose letters are `larger` than usual.
pub(crate) fn room((width, height): (f64, f64), larger: f64) -> (f64, f64) {
    let room = ROOM * larger;
    (room.min(ROOM_SHARE.0 * width), room.min(ROOM_SHARE.1 * height))
}

impl Space {
    /// The panels in `asked` columns, or in as many as suit them; in these too where so few columns would
    /// have more rows than a page of a given height has room for.
    pub(super) fn grid(&self, wants: &[Want], asked: Option<usize>) -> Grid {
        let fits = |columns: &usize| self.heights(wants, *columns).iter().all(|(_, height)| *height > 1.0);
        let all: usize = asked_of(wants).iter().sum();
        let asked = asked.map(|columns| columns.min(all.max(1))).filter(fits);
        let columns = asked.unwrap_or_else(|| self.columns(wants));
        Grid { columns, rows: self.heights(wants, columns) }
    }

    /// The number of columns where the scene does not say it. On a page of a given height the one that leaves
    /// the panels largest. Elsewhere the fewest whose rows are no higher together than one panel may be
    /// alone; where there are none, as many as leave the panels wide enough.
    fn columns(&self, wants: &[Want]) -> usize {
        let asked = asked_of(wants);
        if self.height.is_some() {
            let height = |columns| self.heights(wants, columns).first().map_or(1.0, |(_, height)| *height);
            let size = |columns| self.panel_width(1, columns).min(WIDE * height(columns));
            let largest = |most| (2..=most).fold(1, |best, c| if size(c) > size(best) { c } else { best });
            // Captions are as wide as panels are on a page that ends with the drawing.
            let has_captions = wants.iter().any(|want| want.lines > 0);
            let read = has_captions.then(|| largest(self.most(&asked, None)));
            let read = read.filter(|columns| height(*columns) > 1.0);
            return read.unwrap_or_else(|| largest(asked.iter().sum()));
        }
        let mut fit = flow::suited(&asked).filter(|columns| self.is_wide(*columns));
        let all = |columns: &usize| self.all(&self.heights(wants, *columns)) <= TALLEST.0 * self.width;
        fit.clone().find(all).or_else(|| fit.next_back()).unwrap_or_else(|| self.fewer(&asked))
    }

    /// The most columns that leave the panels wide enough, where they are fewer than the widest panel asks
    /// for.
    fn fewer(&self, asked: &[usize]) -> usize {
        let widest = asked.iter().copied().max().unwrap_or(1);
        (2..widest).rfind(|columns| self.is_wide(*columns)).unwrap_or(1)
    }

    /// Whether a panel that stands beside others is wide enough.
    fn is_wide(&self, columns: usize) -> bool {
        columns == 1 || self.panel_width(1, columns) >= NARROWEST * self.larger
    }

    /// The most columns of a page that ends with the drawing, whatever panels show that ask for so many each.
    pub(super) fn most(&self, asked: &[usize], said: Option<usize>) -> usize {
        let all: usize = asked.iter().sum();
        let suited = || flow::suited(asked).rfind(|columns| self.is_wide(*columns));
        said.map(|columns| columns.min(all.max(1))).or_else(suited).unwrap_or_else(|| self.fewer(asked))
    }

    /// Width of a panel that asks for some of so many columns, page pixels.
    pub(super) fn panel_width(&self, asked: usize, columns: usize) -> f64 {
        let column = ((self.width - count(columns - 1) * self.gap) / count(columns)).max(1.0);
        column + count(flow::taken(asked, columns) - 1) * (column + self.gap)
    }

    /// Each row with its height.
    fn heights(&self, wants: &[Want], columns: usize) -> Vec<(Range<usize>, f64)> {
        let rows = flow::rows(&asked_of(wants), columns);
        let number = count(rows.len());
        let between = (number - 1.0) * self.gap + number * self.words;
        if let Some(height) = self.height {
            let height = ((height - between) / number).max(1.0);
            return rows.into_iter().map(|row| (row, height)).collect();
        }
        let share = if rows.len() == 1 { TALLEST.0 } else { TALLEST.1 };
        let least = LOWEST * self.larger;
        let column = in_column(wants, columns);
        let height = |want: &Want| {
            let width = self.panel_width(want.columns, columns);
            let most = (share * self.width).max(ANYWAY).min(TALL * width);
            let most = most.min((MOST - between) / number).max(1.0);
            let slope = want.height / if want.room { column * want.taken(columns) } else { want.width };
            self.height_of((slope, want.room), width).clamp(least.min(most), most).ceil()
        };
        let high = |row: &Range<usize>| wants.get(row.clone()).unwrap_or_default().iter().map(height);
        rows.into_iter().map(|row| (row.clone(), high(&row).reduce(f64::max).unwrap_or(least))).collect()
    }

    /// All rows with their titles and the gaps between them.
    fn all(&self, rows: &[(Range<usize>, f64)]) -> f64 {
        let heights: f64 = rows.iter().map(|(_, height)| height).sum();
        heights + count(rows.len()) * (self.words + self.gap) - self.gap
    }

    /// The height at which a panel of that width shows what is so much higher than wide and no more, with
    /// room around it if it has to have some.
    fn height_of(&self, (slope, has_room): (f64, bool), width: f64) -> f64 {
        let slope = if slope.is_nan() { 1.0 } else { slope };
        if !has_room {
            return width * slope;
        }
        let (aside, above) = room((width, f64::INFINITY), self.larger);
        let inner = (width - 2.0 * aside) * slope;
        (inner + 2.0 * above).min(inner / (1.0 - 2.0 * ROOM_SHARE.1))
    }
}

/// The columns that each panel asks for.
fn asked_of(wants: &[Want]) -> Vec<usize> {
    wants.iter().map(|want| want.columns).collect()
}
