//! Margins, type sizes and line widths of a page, as its canvas asks for them.
//!
//! A page of 960 × 540 has the sizes that are written in the code. A smaller page of a given height shrinks
//! them; one that ends with its drawing has room to grow downward and keeps them to a width of 320.

use crate::figure::theme::{TextKind, TypeSizes};
use crate::scene::Canvas;

/// Left and right margin, and the gap between panels, page pixels.
const MARGIN: f64 = 24.0;
/// Room above what is drawn, page pixels.
const TOP: f64 = 20.0;
/// Room below the panels where there is no caption, page pixels.
const BOTTOM: f64 = 20.0;
/// Height of a row of titles, page pixels.
const TITLE: f64 = 24.0;
/// From one baseline of a title to the next, page pixels.
const TITLE_STEP: f64 = 17.0;
/// From a title's baseline down to its panel, page pixels.
const TITLE_DROP: f64 = 14.0;
/// From the panels down to the first baseline of the caption, page pixels.
const CAPTION_DROP: f64 = 24.0;
/// From one baseline of the caption to the next, page pixels.
const CAPTION_STEP: f64 = 20.0;
/// Width of a caption's line at most, in ems: some 95 letters, as many as the eye finds its way back over.
const CAPTION_MEASURE: f64 = 43.0;
/// The least width of a column of a caption that has two, in ems: some 60 letters.
const CAPTION_COLUMN: f64 = 28.0;
/// From one baseline of the headline to the next, in ems: headings stand closer than text.
const HEADLINE_STEP: f64 = 1.25;
/// Height of the capitals of a headline, in ems.
const CAPITALS: f64 = 0.66;
/// From the last baseline of the headline down to what is below, in ems: a gap that is wider than that
/// between its lines.
const HEADLINE_DROP: f64 = 0.9;
/// The share of the page's height that a headline may take; a longer one is left to the alternative text.
const HEADLINE_SHARE: f64 = 0.17;
/// How far letters reach below their baseline, as a share of their size.
const DESCENT: f64 = 0.3;
/// The share of `CAPTION_DROP` that stays on the smallest pages, whose letters are not as small as their
/// margins.
const LEAST_DROP: f64 = 0.75;
/// Width and height of the page that all sizes are made for, page pixels.
const USUAL: (f64, f64) = (960.0, 540.0);
/// Width of the narrowest page without a given height that has letters and lines as large as the usual one,
/// page pixels: a column on a telephone.
const NARROW: f64 = 320.0;
/// The smallest base size that is set, page pixels an em.
const SMALLEST_TYPE: f64 = 11.0;
/// The share of the page's height that a caption may take; a longer one is left to the alternative text.
const CAPTION_SHARE: f64 = 0.34;
/// The height that stands for that of a page which ends with its drawing, where shares of it are taken: a
/// caption may have some seventy lines.
const TALLEST: f64 = 4096.0;
/// The share of a page that a margin may take at each edge.
const MARGIN_SHARE: f64 = 0.3;

/// The sizes on one page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Measures {
    /// Width of the page, page pixels.
    pub(crate) width: f64,
    /// Height of the page, page pixels; `None` where it ends with the drawing.
    pub(crate) height: Option<f64>,
    /// The margin that the canvas asks for, page pixels.
    margin: Option<f64>,
    /// How large margins are against those of the usual page.
    share: f64,
    /// The width of a line that is one pixel wide on the usual page; at most 1.
    pub(crate) unit: f64,
    /// How large letters are against those of the usual page, before the smallest size.
    letters: f64,
    /// The sizes of letters on the usual page.
    text: TypeSizes,
}

impl Measures {
    /// The sizes on the page of a canvas; `text` are those of letters on the usual page.
    pub(crate) fn of(canvas: &Canvas, text: TypeSizes) -> Self {
        let (width, height) = (canvas.page_width(), canvas.page_height());
        let wide = width / USUAL.0;
        let (share, unit) = match height {
            Some(height) => {
                let share = wide.min(height / USUAL.1);
                (share, share)
            }
            None => (wide, width / NARROW),
        };
        let unit = unit.min(1.0).sqrt();
        let letters = canvas.text.map_or(unit, |size| size / text.of(TextKind::Caption));
        let most = MARGIN_SHARE * width.min(height.unwrap_or(width));
        let margin = canvas.margin.map(|margin| margin.min(most));
        Self { width, height, margin, share: share.clamp(1.0 / 3.0, 1.0), unit, letters, text }
    }

    /// The size of a kind of text on this page, page pixels an em.
    pub(crate) fn size(&self, kind: TextKind) -> f64 {
        self.type_size(self.text.of(kind))
    }

    /// The size of the headline, page pixels an em.
    pub(crate) fn headline_size(&self) -> f64 {
        self.size(TextKind::Headline)
    }

    /// The size of the titles of panels, page pixels an em.
    pub(crate) fn title_size(&self) -> f64 {
        self.size(TextKind::Title)
    }

    /// The size of the caption, page pixels an em.
    pub(crate) fn caption_size(&self) -> f64 {
        self.size(TextKind::Caption)
    }

    /// How much larger a kind of text is than the house has it on the usual page; at least 1.
    fn grown(&self, kind: TextKind) -> f64 {
        (self.letters * self.text.of(kind) / kind.size()).max(1.0)
    }

    /// A type size on this page, page pixels an em: never under 11.
    fn type_size(&self, size: f64) -> f64 {
        (size * self.letters).max(SMALLEST_TYPE.min(size))
    }

    /// How much larger labels are than those of the usual page; at least 1.
    pub(crate) fn larger(&self) -> f64 {
        let labels = [TextKind::Name, TextKind::Point, TextKind::Note];
        labels.into_iter().map(|kind| self.grown(kind)).fold(1.0, f64::max)
    }

    /// Left and right margin, page pixels.
    pub(super) fn side(&self) -> f64 {
        self.margin.unwrap_or(self.gap())
    }

    /// The gap between panels, page pixels.
    pub(crate) fn gap(&self) -> f64 {
        MARGIN * self.share
    }

    /// Room above what is drawn, page pixels.
    pub(super) fn top(&self) -> f64 {
        self.margin.unwrap_or(TOP * self.share)
    }

    /// Height of a row of titles of so many lines, page pixels.
    pub(super) fn title(&self, lines: usize) -> f64 {
        match lines {
            0 => 0.0,
            _ => TITLE * self.grown(TextKind::Title) + self.title_step() * count(lines - 1),
        }
    }

    /// From one baseline of a panel's title to the next, page pixels.
    pub(super) fn title_step(&self) -> f64 {
        TITLE_STEP * self.title_size() / TextKind::Title.size()
    }

    /// From a title's baseline down to its panel, page pixels.
    pub(super) fn title_drop(&self) -> f64 {
        TITLE_DROP * self.grown(TextKind::Title).sqrt()
    }

    /// Room below the panels for a caption of `lines` lines and the margin, page pixels.
    pub(super) fn foot(&self, lines: f64) -> f64 {
        let below = self.margin.map(|margin| margin + DESCENT * self.size(TextKind::Caption));
        match lines {
            0.0 => self.margin.unwrap_or(BOTTOM * self.share),
            _ => self.drop() + self.step() * (lines - 1.0) + below.unwrap_or(self.step()),
        }
    }

    /// Height of captions of so many lines below each panel of a row, page pixels.
    pub(super) fn under(&self, lines: usize) -> f64 {
        match lines {
            0 => 0.0,
            _ => self.drop() + self.step() * count(lines - 1) + DESCENT * self.size(TextKind::Caption),
        }
    }

    /// From the panels down to the first baseline of the caption, page pixels.
    pub(super) fn drop(&self) -> f64 {
        CAPTION_DROP * self.share.max(LEAST_DROP) * self.grown(TextKind::Caption)
    }

    /// From one baseline of the caption to the next, page pixels.
    pub(crate) fn step(&self) -> f64 {
        CAPTION_STEP * self.size(TextKind::Caption) / TextKind::Caption.size()
    }

    /// Width of a line across the page, page pixels.
    pub(crate) fn measure(&self) -> f64 {
        self.width - 2.0 * self.side()
    }

    /// Width of a caption's line that is read with ease, page pixels: on a wide page less than the page has.
    pub(crate) fn caption_measure(&self) -> f64 {
        self.measure().min(CAPTION_MEASURE * self.size(TextKind::Caption))
    }

    /// Width of each of two columns of a caption, page pixels, the second of which begins where the right one
    /// of two panels does; `None` where the page is too narrow for two.
    pub(crate) fn caption_column(&self) -> Option<f64> {
        let (column, size) = (0.5 * (self.measure() - self.gap()), self.size(TextKind::Caption));
        (column >= CAPTION_COLUMN * size).then(|| column.min(CAPTION_MEASURE * size))
    }

    /// From one baseline of the headline to the next, page pixels: whole ones, so that what stands below is
    /// as sharp as without it.
    pub(super) fn headline_step(&self) -> f64 {
        (HEADLINE_STEP * self.size(TextKind::Headline)).round()
    }

    /// From the top of the headline's capitals down to its first baseline, whole page pixels.
    pub(super) fn headline_rise(&self) -> f64 {
        (CAPITALS * self.size(TextKind::Headline)).round()
    }

    /// What a headline of so many lines takes from the panels, page pixels.
    pub(super) fn headline_height(&self, lines: usize) -> f64 {
        let between = self.headline_step() * count(lines.saturating_sub(1));
        let below = (HEADLINE_DROP * self.size(TextKind::Headline)).round();
        if lines == 0 { 0.0 } else { self.headline_rise() + between + below }
    }

    /// The most lines of headline that the page takes.
    pub(crate) fn headline_lines(&self) -> usize {
        let room = HEADLINE_SHARE * self.height.unwrap_or(TALLEST);
        let mut lines = 0;
        while self.headline_height(lines + 1) < room {
            lines += 1;
        }
        lines
    }

    /// The most lines of caption that the page takes below each of so many rows.
    pub(crate) fn caption_lines(&self, rows: f64) -> usize {
        let room = CAPTION_SHARE * self.height.unwrap_or(TALLEST) / rows;
        let (mut lines, mut taken) = (1, 2.0 * self.step());
        while taken < room {
            lines += 1;
            taken += self.step();
        }
        lines.max(2)
    }
}

/// A count as a number.
#[expect(clippy::cast_precision_loss, reason = "counts of panels and lines")]
pub(super) fn count(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Height;

    fn page(width: f64, height: Option<f64>, text: Option<f64>) -> Measures {
        let height = height.map(Height::Pixels);
        Measures::of(&Canvas { width: Some(width), height, text, ..Canvas::default() }, TypeSizes::HOUSE)
    }

    #[test]
    fn type_is_never_under_eleven_pixels() {
        assert_eq!(page(320.0, Some(180.0), None).type_size(12.0), 11.0);
        assert_eq!(page(960.0, Some(540.0), None).type_size(17.0), 17.0);
        assert_eq!(page(4096.0, Some(4096.0), None).type_size(17.0), 17.0);
        assert_eq!(page(100.0, None, None).type_size(12.0), 11.0);
        assert_eq!(page(960.0, None, Some(8.0)).type_size(13.0), 11.0);
    }

    #[test]
    fn a_narrow_page_that_may_grow_downward_keeps_its_letters_and_a_text_size_sets_them_all() {
        assert_eq!(page(360.0, None, None).type_size(17.0), 17.0);
        assert!(page(360.0, Some(200.0), None).type_size(17.0) < 12.0);
        let slide = page(960.0, None, Some(28.0));
        assert_eq!((slide.type_size(14.0), slide.type_size(17.0), slide.step()), (28.0, 34.0, 40.0));
    }

    #[test]
    fn a_page_of_a_given_height_takes_few_lines_of_headline() {
        assert_eq!(page(960.0, Some(540.0), None).headline_lines(), 3);
        assert!(page(320.0, Some(180.0), None).headline_lines() < 3);
        assert!(page(320.0, None, None).headline_lines() > 9);
    }

    #[test]
    fn a_margin_is_as_wide_as_asked_and_leaves_most_of_a_small_page() {
        let measures = |width, margin| {
            Measures::of(
                &Canvas { width: Some(width), margin: Some(margin), ..Canvas::default() },
                TypeSizes::HOUSE,
            )
        };
        assert_eq!((measures(960.0, 3.0).side(), measures(960.0, 3.0).top()), (3.0, 3.0));
        assert_eq!(measures(960.0, 3.0).foot(0.0), 3.0);
        assert_eq!(measures(100.0, 200.0).measure(), 40.0);
    }
}
