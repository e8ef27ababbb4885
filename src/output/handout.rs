//! Handouts: several figures on the sheets of one document.
//!
//! Figures stand in a grid, in the order in which they come, and are scaled to its cells: never cut, never
//! larger than on a page of their own. Of all grids that hold as many figures a sheet, upright or across,
//! that one is taken in which the figures are largest.

use std::sync::Arc;

use super::heading::Heading;
use super::{Binder, Format, OutputError};
use crate::drawing::{Color, Drawing, Paint, Point, Role, Shown, Text};
use crate::typeset::{Style, typeset};

/// A size of paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paper {
    /// The word for it on the command line.
    pub name: &'static str,
    /// Width and height of the upright sheet, in points.
    pub size: [f64; 2],
}

/// Every size of paper, the usual one first: ISO 216 A4, 210 × 297 mm, and ANSI A, 8.5 × 11 inches.
///
/// ```
/// use tracefig::output::PAPERS;
/// assert_eq!(PAPERS.map(|paper| paper.name), ["a4", "letter"]);
/// ```
pub const PAPERS: [Paper; 2] = [
    Paper { name: "a4", size: [210.0 * MILLIMETRE, 297.0 * MILLIMETRE] },
    Paper { name: "letter", size: [612.0, 792.0] },
];

/// Points in a millimetre.
const MILLIMETRE: f64 = 72.0 / 25.4;

/// White around the figures of a sheet, in points: 15 mm, of which a printer needs 5 and a punch 12.
const MARGIN: f64 = 15.0 * MILLIMETRE;

/// White between two cells of the grid, in points.
const GAP: f64 = 6.0 * MILLIMETRE;

/// Points of the letters of the numbers of sheets and figures.
const NUMBER: f64 = 9.0;

/// Points that the number of a figure takes below it: a line of such letters.
const CAPTION: f64 = 1.5 * NUMBER;

/// Points a page pixel where a figure has its own size.
pub(super) const POINTS: f64 = 0.75;

/// The most figures on a sheet: at 36 on A4 the letters have 1.5 points.
pub const MOST_A_SHEET: usize = 36;

/// How figures are put onto sheets.
#[derive(Clone, Debug, PartialEq)]
pub struct Handout {
    /// The paper.
    pub paper: Paper,
    /// Figures a sheet; at least 1, and at most [`MOST_A_SHEET`].
    pub per_page: usize,
    /// Whether each figure has its number below it, counted over all sheets: "Figure 3".
    pub numbers: bool,
    /// What stands above the figures of the first sheet.
    pub heading: Heading,
}

impl Default for Handout {
    /// Two figures on a sheet of A4, numbered: those of a usual page then are as wide as the sheet.
    fn default() -> Self {
        Self { paper: PAPERS[0], per_page: 2, numbers: true, heading: Heading::default() }
    }
}

/// A figure at its place on a sheet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed<'d> {
    /// The figure.
    pub(super) drawing: &'d Drawing,
    /// Points from the sheet's upper left vertex to the figure's, right and down.
    pub(super) at: [f64; 2],
    /// Points a page pixel.
    pub(super) scale: f64,
}

/// A sheet of a document.
#[derive(Clone, Debug)]
pub(crate) struct Sheet<'d> {
    /// Width and height in points.
    pub(super) size: [f64; 2],
    /// The figures on it.
    pub(super) figures: Vec<Placed<'d>>,
    /// Words besides the figures, in points, y down.
    pub(super) words: Vec<Text>,
}

/// A grid of cells on a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grid {
    /// Width and height of the sheet in points.
    sheet: [f64; 2],
    /// Cells side by side, and one above the other.
    cells: [usize; 2],
    /// Height of the line below each figure, in points.
    caption: f64,
}

impl Handout {
    /// Writes figures as one document of a format.
    ///
    /// # Errors
    ///
    /// [`OutputError::NoSheets`] where the format has none or there is no figure, else what the format says.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, output::{Handout, format}, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1 }
    /// shapes.B = { kind = "circle", radius = 1, position = [3, 1] }
    /// query = { kind = "separation", of = ["A", "B"] }
    /// panels = [{ space = "world", layers = ["shapes", "separation"] }]
    /// "#;
    /// let scene = read(&Source::new("circles.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let drawing = draw(&plan, plan.theme, "circles").drawing;
    /// let handout = Handout { per_page: 1, ..Handout::default() };
    /// let bytes = handout.write(&[&drawing, &drawing], format("pdf").unwrap()).unwrap();
    /// assert!(bytes.starts_with(b"%PDF"));
    /// assert!(handout.write(&[&drawing], format("svg").unwrap()).is_err());
    /// ```
    pub fn write(&self, drawings: &[&Drawing], format: &Format) -> Result<Vec<u8>, OutputError> {
        let Some(Binder::Sheets(bind)) = format.bind.filter(|_| !drawings.is_empty()) else {
            return Err(OutputError::NoSheets);
        };
        drawings.iter().try_for_each(|drawing| super::validity::page(drawing))?;
        let finished: Vec<Drawing> = drawings.iter().map(|&drawing| drawing.clone().finished()).collect();
        bind(&self.sheets(&finished.iter().collect::<Vec<_>>()))
    }

    /// The smallest letters of a figure's words on a sheet of these figures, in points; none where it has no
    /// words. Letters of scripts are smaller than the words that they stand in.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, output::Handout, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1 }
    /// shapes.B = { kind = "circle", radius = 1, position = [3, 1] }
    /// query = { kind = "separation", of = ["A", "B"] }
    /// panels = [{ space = "world", layers = ["shapes", "separation"] }]
    /// "#;
    /// let scene = read(&Source::new("circles.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let drawing = draw(&plan, plan.theme, "circles").drawing;
    /// let smallest = |per_page| Handout { per_page, ..Handout::default() }.letters(&[&drawing])[0].unwrap();
    /// assert!(smallest(1) > 6.0 && smallest(8) < 6.0);
    /// ```
    #[must_use]
    pub fn letters(&self, drawings: &[&Drawing]) -> Vec<Option<f64>> {
        let sheets = self.sheets(drawings);
        let figures = sheets.iter().flat_map(|sheet| &sheet.figures);
        figures.map(|placed| Some(placed.drawing.smallest_words()? * placed.scale)).collect()
    }

    /// The sheets of these figures.
    fn sheets<'d>(&self, drawings: &[&'d Drawing]) -> Vec<Sheet<'d>> {
        let per_page = self.per_page.clamp(1, MOST_A_SHEET);
        let grid = self.grid(drawings, per_page);
        let of = drawings.len().div_ceil(per_page);
        let sheet = |(i, some): (usize, &[&'d Drawing])| {
            let figures: Vec<Placed<'d>> =
                some.iter().enumerate().map(|(cell, drawing)| grid.place(cell, drawing)).collect();
            let numbered = (i * per_page + 1..).zip(&figures).filter(|_| self.numbers);
            let captions = numbered.filter_map(|(number, placed)| caption(number, placed));
            let head = || self.heading.words((grid.sheet[0], MARGIN), some.first().copied());
            let head = if i == 0 { head() } else { Vec::new() };
            let words = captions.chain(page_number(i + 1, of, grid.sheet)).chain(head).collect();
            Sheet { size: grid.sheet, figures, words }
        };
        drawings.chunks(per_page).enumerate().map(sheet).collect()
    }

    /// The grid in which the figures are largest; upright, with few columns, where that is all the same.
    fn grid(&self, drawings: &[&Drawing], per_page: usize) -> Grid {
        let [width, height] = self.paper.size;
        let caption = if self.numbers { CAPTION } else { 0.0 };
        let grids = [[width, height], [height, width]].into_iter().flat_map(|sheet| {
            (1..=per_page).map(move |columns| {
                let cells = [columns, per_page.div_ceil(columns)];
                Grid { sheet, cells, caption }
            })
        });
        let total = |grid: &Grid| drawings.iter().map(|drawing| grid.scale(drawing)).sum::<f64>();
        let first = Grid { sheet: [width, height], cells: [1, per_page], caption };
        grids.fold(first, |best, grid| if total(&grid) > total(&best) { grid } else { best })
    }
}

impl Grid {
    /// Width and height of a cell, in points.
    fn cell(&self) -> [f64; 2] {
        std::array::from_fn(|axis| {
            #[expect(clippy::cast_precision_loss, reason = "at most as many as figures on a sheet")]
            let cells = self.cells[axis] as f64;
            (self.sheet[axis] - 2.0 * MARGIN - (cells - 1.0) * GAP) / cells
        })
    }

    /// Points a page pixel at which a figure fits into a cell.
    fn scale(&self, drawing: &Drawing) -> f64 {
        let [width, height] = self.cell();
        (width / drawing.width).min((height - self.caption) / drawing.height).min(POINTS)
    }

    /// A figure in the middle of the top of a cell; cells are counted along rows.
    fn place<'d>(&self, cell: usize, drawing: &'d Drawing) -> Placed<'d> {
        let scale = self.scale(drawing);
        let size = self.cell();
        #[expect(clippy::cast_precision_loss, reason = "at most as many as figures on a sheet")]
        let [column, row] = [cell % self.cells[0], cell / self.cells[0]].map(|number| number as f64);
        let x = MARGIN + column * (size[0] + GAP) + 0.5 * (size[0] - drawing.width * scale);
        let y = MARGIN + row * (size[1] + GAP);
        Placed { drawing, at: [x, y], scale }
    }
}

/// Which sheet it is, of how many, in the middle of the margin below; nothing where it is the only one.
fn page_number(number: usize, of: usize, [width, height]: [f64; 2]) -> Option<Text> {
    let middle = Point::new(0.5 * width, height - 0.5 * MARGIN);
    words(&format!("{number} / {of}"), middle).filter(|_| of > 1)
}

/// What stands before the number of a figure, in each of [`Drawing::LANGS`].
const FIGURE: [&str; Drawing::LANGS.len()] = ["Figure ", "Abbildung ", "Figure ", "Figura "];

/// The number of a figure below it; without the word of ours where the figure speaks another language.
fn caption(number: usize, Placed { drawing, at, scale }: &Placed<'_>) -> Option<Text> {
    let word = match drawing.of_langs() {
        Some(language) => FIGURE[language],
        None if drawing.lang.is_none() => FIGURE[0],
        None => "",
    };
    let [x, y] = [at[0] + 0.5 * drawing.width * scale, at[1] + drawing.height * scale];
    words(&format!("{word}{number}"), Point::new(x, y + CAPTION - 0.25 * NUMBER))
}

/// Words with the middle of their baseline at a point.
fn words(markup: &str, middle: Point) -> Option<Text> {
    let line = typeset(markup, Style::regular(NUMBER)).ok()?;
    let origin = Point::new(middle.x - 0.5 * line.width, middle.y);
    let paint = Paint::role(Role::Ink, Color::hex(0));
    Some(Text { line: Arc::new(line), origin, paint, halo: None, shown: Shown::ALWAYS })
}

#[cfg(test)]
mod tests {
    use super::super::samples::everything;
    use super::*;

    fn sample(width: f64, height: f64) -> Drawing {
        Drawing { width, height, ..everything() }
    }

    #[test]
    fn every_figure_stands_whole_within_the_margins_and_over_no_other() {
        let all = [sample(960.0, 540.0), sample(480.0, 900.0), sample(100.0, 60.0), sample(960.0, 700.0)];
        let drawings: Vec<&Drawing> = all.iter().cycle().take(11).collect();
        for paper in PAPERS {
            for per_page in 1..=9 {
                let sheets = Handout { paper, per_page, ..Handout::default() }.sheets(&drawings);
                assert_eq!(sheets.len(), drawings.len().div_ceil(per_page));
                for sheet in &sheets {
                    let ends = |p: &Placed| {
                        [p.at[0] + p.drawing.width * p.scale, p.at[1] + p.drawing.height * p.scale]
                    };
                    for (i, p) in sheet.figures.iter().enumerate() {
                        assert!(p.scale <= POINTS);
                        for axis in 0..2 {
                            assert!(p.at[axis] >= MARGIN - 1e-9);
                            assert!(ends(p)[axis] <= sheet.size[axis] - MARGIN + 1e-9);
                        }
                        for q in &sheet.figures[..i] {
                            let apart =
                                |axis: usize| p.at[axis] >= ends(q)[axis] || q.at[axis] >= ends(p)[axis];
                            assert!(apart(0) || apart(1), "{per_page} a sheet");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn the_sheet_is_turned_and_cut_so_that_figures_are_large() {
        let (wide, tall) = (sample(960.0, 540.0), sample(540.0, 960.0));
        let [a4, _] = PAPERS;
        let grid = |drawing, per_page| {
            let grid = Handout { paper: a4, per_page, ..Handout::default() }.grid(&[drawing], per_page);
            (grid.sheet[0] > grid.sheet[1], grid.cells)
        };
        assert_eq!(grid(&wide, 1), (true, [1, 1]), "across");
        assert_eq!(grid(&wide, 2), (false, [1, 2]), "one above the other");
        assert_eq!(grid(&tall, 2), (true, [2, 1]), "side by side");
        assert_eq!(grid(&wide, 4), (true, [2, 2]));
    }

    #[test]
    fn sheets_are_numbered_where_there_are_several() {
        let drawing = sample(960.0, 540.0);
        let handout = Handout { per_page: 2, numbers: false, ..Handout::default() };
        assert!(handout.sheets(&[&drawing; 2])[0].words.is_empty());
        let sheets = handout.sheets(&[&drawing; 5]);
        let numbers: Vec<&str> = sheets.iter().map(|sheet| sheet.words[0].line.markup.as_str()).collect();
        assert_eq!(numbers, ["1 / 3", "2 / 3", "3 / 3"]);
    }

    #[test]
    fn figures_are_counted_over_all_sheets_each_below_itself_and_above_the_next() {
        let (wide, german) = (sample(960.0, 540.0), Drawing { lang: Some("de".into()), ..everything() });
        let sheets = Handout { per_page: 2, ..Handout::default() }.sheets(&[&wide, &wide, &german]);
        let said =
            |sheet: &Sheet<'_>| sheet.words.iter().map(|word| word.line.markup.clone()).collect::<Vec<_>>();
        assert_eq!(said(&sheets[0]), ["Figure 1", "Figure 2", "1 / 2"]);
        assert_eq!(said(&sheets[1]), ["Abbildung 3", "2 / 2"]);
        let [first, second] = &sheets[0].figures[..] else { panic!("two figures a sheet") };
        let baseline = sheets[0].words[0].origin.y;
        let end = first.at[1] + first.drawing.height * first.scale;
        assert!(end + 0.5 * NUMBER < baseline && baseline < second.at[1] - GAP, "{end} {baseline}");
    }
}
