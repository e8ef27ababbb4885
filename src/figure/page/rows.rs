//! How panels share the room that a page has for them: how many stand side by side, how high each row is.

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
    /// Whether labels need room around it.
    pub(crate) room: bool,
    /// Lines of the caption below it.
    pub(crate) lines: usize,
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
    /// Panels side by side.
    pub(super) columns: usize,
    /// Width of each, page pixels.
    pub(super) width: f64,
    /// Height of each row, page pixels.
    pub(super) heights: Vec<f64>,
}

/// Room for labels left and right of what a panel draws, and above and below, page pixels, in a panel of
/// `width` × `height` pixels whose letters are `larger` than usual.
pub(crate) fn room((width, height): (f64, f64), larger: f64) -> (f64, f64) {
    let room = ROOM * larger;
    (room.min(ROOM_SHARE.0 * width), room.min(ROOM_SHARE.1 * height))
}

/// Whether panels fill rows of so many: a number of columns that leaves a row nearly empty is none.
fn is_even(panels: usize, columns: usize) -> bool {
    columns == panels.div_ceil(panels.div_ceil(columns))
}

impl Space {
    /// The panels in `asked` columns, or in as many as suit them; in these too where so few columns would
    /// have more rows than a page of a given height has room for.
    pub(super) fn grid(&self, wants: &[Want], asked: Option<usize>) -> Grid {
        let fits = |columns: &usize| self.heights(wants, *columns).iter().all(|height| *height > 1.0);
        let asked = asked.map(|columns| columns.min(wants.len().max(1))).filter(fits);
        let columns = asked.unwrap_or_else(|| self.columns(wants));
        Grid { columns, width: self.panel_width(columns), heights: self.heights(wants, columns) }
    }

    /// The number of columns where the scene does not say it. On a page of a given height the one that leaves
    /// the panels largest. Elsewhere the fewest whose rows are no higher together than one panel may be
    /// alone; where there are none, as many as leave the panels wide enough.
    fn columns(&self, wants: &[Want]) -> usize {
        let panels = wants.len().max(1);
        if self.height.is_some() {
            let size = |columns: usize| {
                let height = self.heights(wants, columns).first().copied().unwrap_or(1.0);
                self.panel_width(columns).min(WIDE * height)
            };
            return (2..=panels).fold(1, |best, c| if size(c) > size(best) { c } else { best });
        }
        let wide = |columns: &usize| *columns == 1 || self.panel_width(*columns) >= NARROWEST * self.larger;
        let mut fit = (1..=panels).filter(|c| is_even(panels, *c)).filter(wide);
        let all = |columns: &usize| self.all(&self.heights(wants, *columns)) <= TALLEST.0 * self.width;
        fit.clone().find(all).or_else(|| fit.next_back()).unwrap_or(1)
    }

    /// The least width that a panel, one of so many, has on a page that ends with the drawing, whatever they
    /// show.
    pub(super) fn narrowest(&self, panels: usize, asked: Option<usize>) -> f64 {
        let panels = panels.max(1);
        let wide = |columns: &usize| *columns == 1 || self.panel_width(*columns) >= NARROWEST * self.larger;
        let asked = asked.map(|columns| columns.min(panels));
        let columns = asked.or_else(|| (1..=panels).filter(|c| is_even(panels, *c)).rfind(wide));
        self.panel_width(columns.unwrap_or(1))
    }

    /// Width of a panel, one of so many side by side.
    fn panel_width(&self, columns: usize) -> f64 {
        ((self.width - count(columns - 1) * self.gap) / count(columns)).max(1.0)
    }

    /// The height of each row.
    fn heights(&self, wants: &[Want], columns: usize) -> Vec<f64> {
        let rows = wants.len().max(1).div_ceil(columns);
        let between = (count(rows) - 1.0) * self.gap + count(rows) * self.words;
        if let Some(height) = self.height {
            return vec![((height - between) / count(rows)).max(1.0); rows];
        }
        let width = self.panel_width(columns);
        let share = if rows == 1 { TALLEST.0 } else { TALLEST.1 };
        let most = (share * self.width).max(ANYWAY).min(TALL * width);
        let most = most.min((MOST - between) / count(rows)).max(1.0);
        let least = (LOWEST * self.larger).min(most);
        let height = |want: &Want| self.height_of(want, width).clamp(least, most).ceil();
        let row = |row: &[Want]| row.iter().map(height).fold(least, f64::max);
        match wants {
            [] => vec![least],
            _ => wants.chunks(columns).map(row).collect(),
        }
    }

    /// All rows with their titles and the gaps between them.
    fn all(&self, heights: &[f64]) -> f64 {
        heights.iter().sum::<f64>() + count(heights.len()) * (self.words + self.gap) - self.gap
    }

    /// The height at which a panel of that width shows what it has to and no more.
    fn height_of(&self, want: &Want, width: f64) -> f64 {
        let slope = want.height / want.width;
        let slope = if slope.is_nan() { 1.0 } else { slope };
        if !want.room {
            return width * slope;
        }
        let (aside, above) = room((width, f64::INFINITY), self.larger);
        let inner = (width - 2.0 * aside) * slope;
        (inner + 2.0 * above).min(inner / (1.0 - 2.0 * ROOM_SHARE.1))
    }
}
