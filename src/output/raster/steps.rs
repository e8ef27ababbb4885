//! The display list as steps of painting: which areas, in which order, laid on with what.
//!
//! A clip, or the area under a pattern's marks, is an area too: one whose coverage is kept, for later areas to be cut by.

use std::ops::Range;

use super::blend::{Fineness, Ink};
use super::edges::Bands;
use super::polyline::Polylines;
use super::{glyphs, stroke};
use crate::drawing::{Contour, Group, Item, Paint, Path, Pattern, Point, Rect, Segment, Stroke, Text};

/// A step of painting.
pub(super) enum Step {
    /// An area in a colour.
    Lay {
        ink: Ink,
        /// The step whose area cuts this one.
        within: Option<usize>,
    },
    /// An area whose coverage is kept.
    Keep {
        /// The step whose area cuts this one.
        within: Option<usize>,
    },
    /// A see-through group begins: what is there is kept.
    Save(Part),
    /// A see-through group ends: what is there now is mixed with what was there.
    Fade { part: Part, opacity: f64 },
}

/// A part of the image.
#[derive(Clone)]
pub(super) struct Part {
    pub(super) columns: Range<usize>,
    pub(super) rows: Range<usize>,
}

/// Turns items into steps.
pub(super) struct Recorder {
    pub(super) steps: Vec<Step>,
    pub(super) bands: Bands,
    size: (usize, usize),
    scale: f64,
    /// The clip in force and its step.
    clip: Option<(Rect, usize)>,
}

impl Recorder {
    pub(super) fn new((width, height): (usize, usize), scale: f64) -> Self {
        let bands = Bands::new(width, height);
        Self { steps: Vec::new(), bands, size: (width, height), scale, clip: None }
    }

    pub(super) fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.group(group),
                Item::Path(path) => self.path(path),
                Item::Text(text) => self.text(text),
            }
        }
    }

    fn group(&mut self, group: &Group) {
        let Some(rect) = group.clip else { return self.see_through(group) };
        let outer = self.clip.map(|(rect, _)| rect);
        let Some(rect) = outer.map_or(Some(rect), |o| o.intersection(rect)) else { return };
        let lines = self.lines(&glyphs::rectangle(rect));
        let step = self.area(Step::Keep { within: None }, &lines);
        let kept = self.clip.replace((rect, step));
        self.see_through(group);
        self.clip = kept;
    }

    /// A group's items. Where the group has an opacity they are drawn solid and then mixed with what was there, which is
    /// what laying a separate image of the group over it comes to.
    fn see_through(&mut self, group: &Group) {
        if group.opacity >= 1.0 {
            return self.items(&group.items);
        }
        let Some(part) = group.extent().and_then(|extent| self.part(extent)) else { return };
        self.mark(Step::Save(part.clone()), &part);
        self.items(&group.items);
        self.mark(Step::Fade { part: part.clone(), opacity: group.opacity }, &part);
    }

    fn mark(&mut self, step: Step, part: &Part) {
        self.bands.mark(self.steps.len(), &part.rows);
        self.steps.push(step);
    }

    /// What of the image holds `extent`; `None` where nothing does.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "cut to the image before")]
    #[expect(clippy::cast_precision_loss, reason = "an image is narrower than 2^26")]
    fn part(&self, extent: Rect) -> Option<Part> {
        let range = |low: f64, high: f64, most: usize| {
            // One pixel more on each side, for edges that only touch it.
            let low = ((low * self.scale).floor() - 1.0).clamp(0.0, most as f64) as usize;
            low..((high * self.scale).ceil() + 1.0).clamp(0.0, most as f64) as usize
        };
        let columns = range(extent.x0, extent.x1, self.size.0);
        let rows = range(extent.y0, extent.y1, self.size.1);
        (!columns.is_empty() && !rows.is_empty()).then_some(Part { columns, rows })
    }

    fn path(&mut self, path: &Path) {
        let Some(extent) = path.extent() else { return };
        let lines = self.lines(&path.contour);
        if let Some(paint) = &path.fill {
            self.fill(&lines, paint, extent);
        }
        if let Some(pattern) = &path.pattern {
            self.pattern(&path.contour, &lines, pattern);
        }
        if let Some(stroke) = &path.stroke {
            let outline = self.outline(&lines, stroke);
            self.fill(&outline, &stroke.paint, extent);
        }
    }

    fn text(&mut self, text: &Text) {
        let lines = glyphs::lines(text, self.scale);
        let extent = text.extent();
        if let Some(halo) = &text.halo {
            self.fill(&stroke::grown(&lines, halo.width * self.scale), &halo.paint, extent);
        }
        self.fill(&lines, &text.paint, extent);
    }

    /// The marks as lines, cut by the contour.
    fn pattern(&mut self, area: &Contour, lines: &Polylines, pattern: &Pattern) {
        let Some(bounds) = area.bounds() else { return };
        let inside = self.area(Step::Keep { within: self.clip.map(|(_, step)| step) }, lines);
        let (marks, stroke) = pattern.marks(bounds);
        let segments = marks.into_iter().flat_map(|(from, to)| [Segment::Move(from), Segment::Line(to)]);
        let lines = self.lines(&Contour::Segments(segments.collect()));
        let outline = self.outline(&lines, &stroke);
        let ink = self.ink(&stroke.paint);
        self.area(Step::Lay { ink, within: Some(inside) }, &outline);
    }

    fn fill(&mut self, lines: &Polylines, paint: &Paint, extent: Rect) {
        let ink = self.ink(paint);
        let cut = self.clip.filter(|(rect, _)| rect.intersection(extent) != Some(extent));
        self.area(Step::Lay { ink, within: cut.map(|(_, step)| step) }, lines);
    }

    fn area(&mut self, step: Step, lines: &Polylines) -> usize {
        let number = self.steps.len();
        self.steps.push(step);
        self.bands.add(number, lines);
        number
    }

    fn ink(&self, paint: &Paint) -> Ink {
        Ink::of(paint, Fineness::at(self.scale))
    }

    fn lines(&self, contour: &Contour) -> Polylines {
        let scale = self.scale;
        Polylines::of(contour, |p| Point::new(p.x * scale, p.y * scale))
    }

    fn outline(&self, lines: &Polylines, line: &Stroke) -> Polylines {
        let dash: Vec<f64> = line.dash.iter().map(|d| d * self.scale).collect();
        let dashed = if dash.is_empty() { None } else { stroke::dashes(lines, &dash) };
        stroke::outline(dashed.as_ref().unwrap_or(lines), line.width * self.scale, line.cap)
    }
}
