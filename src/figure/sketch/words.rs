//! Lines and words at places of their own on the page: numbers of an axis, whose place is their meaning.

use std::sync::Arc;

use crate::drawing::{Contour, Halo, Item, Path, Point, Rect, Role, Segment, Shown, Text};
use crate::geometry::DVec2;
use crate::typeset::{Line, Style, line};

use super::{Cover, Pen, Sketch};

/// How far the halo of words reaches, page pixels.
const HALO: f64 = 2.5;

/// A line of words that is set, ready to be written anywhere.
#[derive(Clone, Debug)]
pub(crate) struct Words {
    /// The glyphs of the line.
    line: Arc<Line>,
    /// How wide it is, page pixels.
    pub(crate) width: f64,
    /// How far it reaches above its baseline, page pixels.
    pub(crate) ascent: f64,
    /// How far it reaches below its baseline, page pixels.
    pub(crate) descent: f64,
}

impl Sketch<'_> {
    /// The panel on the page, page pixels.
    #[must_use]
    pub(crate) fn panel(&self) -> Rect {
        self.frame.panel
    }

    /// The panel with small letters of another size, page pixels an em.
    #[must_use]
    pub(crate) fn with_small_letters(self, small: f64) -> Self {
        Self { small, ..self }
    }

    /// The panel, in which axes have no numbers: a detail of another one that has them.
    #[must_use]
    pub(crate) fn without_numbers(self) -> Self {
        Self { numbers: false, ..self }
    }

    /// Whether axes have numbers here.
    #[must_use]
    pub(crate) fn has_numbers(&self) -> bool {
        self.numbers
    }

    /// The panel without axes: of a detail that is a few pixels wide they say nothing, and take the room of
    /// its label.
    #[must_use]
    pub(crate) fn without_axes(self) -> Self {
        Self { axes: false, ..self }
    }

    /// Whether axes are drawn here.
    #[must_use]
    pub(crate) fn has_axes(&self) -> bool {
        self.axes
    }

    /// Where a point of the panel's space lies on the page.
    #[must_use]
    pub(crate) fn page(&self, p: DVec2) -> Point {
        self.frame.page(p)
    }

    /// Draws straight lines on the page that labels do not mind, as one path.
    pub(crate) fn quiet_lines(&mut self, lines: &[(Point, Point)], pen: Pen) -> &mut Self {
        if lines.is_empty() {
            return self;
        }
        let ends = lines.iter().flat_map(|&(from, to)| [Segment::Move(from), Segment::Line(to)]);
        let stroke = self.stroke_of(pen);
        self.spend(lines.len());
        self.push(Item::Path(Path::stroked(Contour::Segments(ends.collect()), stroke)))
    }

    /// Sets markup in the size of small notes; `None` where it can't be set.
    #[must_use]
    pub(crate) fn set(&self, markup: &str) -> Option<Words> {
        let line = line(markup, Style::regular(self.small)).ok()?;
        let (width, ascent, descent) = (line.width, line.ascent, line.descent);
        Some(Words { line, width, ascent, descent })
    }

    /// Keeps strips along the panel's left and lower edge for numbers, so wide, page pixels.
    pub(crate) fn set_aside(&mut self, [left, low]: [f64; 2]) {
        let Rect { x0, y1, .. } = self.frame.panel;
        self.free.x0 = self.free.x0.max(x0 + left);
        self.free.y1 = self.free.y1.min(y1 - low);
    }

    /// Writes a line of text on the page, its baseline beginning at `origin`, and makes labels keep off it;
    /// without effect where the scene turned this layer's labels off.
    pub(crate) fn write(&mut self, words: &Words, origin: Point, role: Role) -> &mut Self {
        if !self.labels {
            return self;
        }
        let (top, bottom) = (origin.y - words.ascent, origin.y + words.descent);
        for y in [top, 0.5 * (top + bottom), bottom] {
            let (from, to) = (Point::new(origin.x, y), Point::new(origin.x + words.width, y));
            self.keep_off(Cover::Stroke { from, to, half: 0.5 });
        }
        let halo = Some(Halo::plain(self.paint(Role::Background), HALO));
        let paint = self.word_paint(role);
        self.push(Item::Text(Text {
            line: Arc::clone(&words.line),
            origin,
            paint,
            halo,
            shown: Shown::ALWAYS,
        }))
    }
}
