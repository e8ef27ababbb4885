//! The display list as steps of painting: which areas, in which order, laid on with what.

use std::rc::Rc;

use tiny_skia::Path;

use super::blend::{Fineness, Ink};
use super::coverage::{Filler, Part, Span};
use super::glyphs::{self, Placed};
use super::paths;
use crate::drawing::{self, Clip, Group, Item, Paint, Pattern, Rect, Text};

/// A step of painting.
pub(super) enum Step {
    /// An area in a colour.
    Lay {
        /// The colour.
        ink: Ink,
        /// What is covered by it.
        area: Area,
        /// The pixels that hold what is seen of the area.
        part: Part,
        /// What cuts it, in image pixels; none where it lies inside.
        clip: Option<Clip>,
    },
    /// A see-through group begins: the pixels of this part are kept.
    Save(Part),
    /// A see-through group ends: the part's pixels are mixed with those that were kept.
    Fade {
        /// What was kept.
        part: Part,
        /// How much stays of what was drawn since.
        opacity: f64,
    },
}

impl Step {
    /// The pixels that it concerns.
    pub(super) fn part(&self) -> &Part {
        match self {
            Self::Lay { part, .. } | Self::Save(part) | Self::Fade { part, .. } => part,
        }
    }

    /// What painting a pixel takes, against a plain area: one with marks is filled twice, and its marks are
    /// dashed anew for each band.
    pub(super) fn weight(&self) -> usize {
        match self {
            Self::Lay { area: Area::Marks { .. }, .. } => 20,
            _ => 1,
        }
    }

    /// How many pieces its outline has.
    pub(super) fn pieces(&self) -> usize {
        match self {
            Self::Lay { area: Area::Inside(path) | Area::Marks { within: path, .. }, .. } => path.len(),
            Self::Lay { area: Area::Glyphs(placed), .. } => placed.len(),
            Self::Save(_) | Self::Fade { .. } => 0,
        }
    }
}

/// What covers pixels.
pub(super) enum Area {
    /// The inside of a path.
    Inside(Rc<Path>),
    /// The marks of a pattern on the inside of a path.
    ///
    /// They are drawn anew for each part of the image that is asked for: an area as large as a page has a
    /// million dots, of which few are in one part.
    Marks {
        /// Which marks.
        pattern: Pattern,
        /// The area that they are on.
        within: Rc<Path>,
        /// Image pixels of a page pixel.
        scale: f64,
    },
    /// Glyphs of one text.
    Glyphs(Vec<Placed>),
}

impl Area {
    /// Hands the spans of each row that lies in `part` to `each`, with the row's place in the image.
    pub(super) fn rows(
        &self,
        part: &Part,
        filler: &mut Filler,
        spans: &mut Vec<Span>,
        mut each: impl FnMut(usize, &[Span]),
    ) {
        match self {
            Self::Inside(path) => filler.fill(&[path], None, part, each),
            Self::Marks { pattern, within, scale } => {
                if let Some(marks) = marks(pattern, part, *scale) {
                    filler.fill(&[&marks], Some(within), part, each);
                }
            }
            Self::Glyphs(all) => all.iter().for_each(|placed| placed.rows(part, spans, &mut each)),
        }
    }
}

/// The marks of a pattern over a part of the image.
#[expect(clippy::cast_precision_loss, reason = "an image is narrower than 2^26")]
fn marks(pattern: &Pattern, part: &Part, scale: f64) -> Option<Path> {
    let reach = pattern.stroke().width.max(1.0 / scale);
    let page = |pixels: usize| pixels as f64 / scale;
    let (x0, y0) = (page(part.columns.start), page(part.rows.start));
    let seen = Rect { x0, y0, x1: page(part.columns.end), y1: page(part.rows.end) };
    // Marks around it reach into it.
    let (lines, stroke) = pattern.marks(seen.grown(reach));
    paths::outline(&paths::lines(&lines, scale)?, &stroke, scale)
}

/// The steps that a display list comes to.
pub(super) fn of(items: &[Item], size: (usize, usize), scale: f64) -> Vec<Step> {
    let mut recorder = Recorder { steps: Vec::new(), size, scale, clip: None };
    recorder.items(items);
    recorder.steps
}

/// Turns items into steps.
struct Recorder {
    /// What is painted, in order, so far.
    steps: Vec<Step>,
    /// Width and height of the image in pixels.
    size: (usize, usize),
    /// Image pixels of a page pixel.
    scale: f64,
    /// The clip in force, in image pixels.
    clip: Option<Clip>,
}

impl Recorder {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.group(group),
                Item::Path(path) => self.path(path),
                Item::Text(text) => self.text(text),
            }
        }
    }

    fn group(&mut self, group: &Group) {
        let Some(clip) = group.clip else { return self.see_through(group) };
        let s = self.scale;
        let Clip { rect: Rect { x0, y0, x1, y1 }, radius } = clip;
        let rect = Rect { x0: x0 * s, y0: y0 * s, x1: x1 * s, y1: y1 * s };
        let clip = Clip { rect, radius: radius * s };
        let Some(clip) = self.clip.map_or(Some(clip), |outer| clip.inside(outer)) else { return };
        let outer = self.clip.replace(clip);
        self.see_through(group);
        self.clip = outer;
    }

    /// A group's items. Where the group has an opacity they are drawn solid and then mixed with what was
    /// there, which is what laying a separate image of the group over it comes to.
    fn see_through(&mut self, group: &Group) {
        if group.opacity >= 1.0 {
            return self.items(&group.items);
        }
        let first = self.steps.len();
        // What the group touches is known once its items have been drawn.
        self.steps.push(Step::Save(Part::default()));
        self.items(&group.items);
        let part = self.steps[first..].iter().map(Step::part).fold(Part::default(), Part::union);
        if part.is_empty() {
            return self.steps.truncate(first);
        }
        self.steps[first] = Step::Save(part.clone());
        self.steps.push(Step::Fade { part, opacity: group.opacity });
    }

    fn path(&mut self, path: &drawing::Path) {
        let Some(shape) = paths::contour(&path.contour, self.scale) else { return };
        let shape = Rc::new(shape);
        if let Some(paint) = &path.fill {
            self.inside(Rc::clone(&shape), paint);
        }
        if let Some(pattern) = &path.pattern {
            let share = paths::visible_width(&pattern.stroke(), self.scale).1;
            let bounds = paths::bounds(&shape);
            let area = Area::Marks { pattern: *pattern, within: Rc::clone(&shape), scale: self.scale };
            self.lay(area, &pattern.paint, share, bounds);
        }
        if let Some(stroke) = &path.stroke
            && let Some(outline) = paths::outline(&shape, stroke, self.scale)
        {
            let share = paths::visible_width(stroke, self.scale).1;
            let bounds = paths::bounds(&outline);
            self.lay(Area::Inside(Rc::new(outline)), &stroke.paint, share, bounds);
        }
    }

    fn text(&mut self, text: &Text) {
        if let Some(halo) = &text.halo {
            self.letters(text, &halo.paint, halo.width);
        }
        self.letters(text, &text.paint, 0.0);
    }

    /// A text grown by `reach` page pixels.
    fn letters(&mut self, text: &Text, paint: &Paint, reach: f64) {
        let letters = glyphs::letters(text, reach, self.scale);
        if let Some(bounds) = letters.stamps.iter().map(Placed::bounds).reduce(Rect::union) {
            self.lay(Area::Glyphs(letters.stamps), paint, 1.0, bounds);
        }
        let Some(rest) = letters.rest else { return };
        if reach > 0.0
            && let Some(around) = paths::around(&rest, reach * self.scale)
        {
            self.inside(Rc::new(around), paint);
        }
        self.inside(Rc::new(rest), paint);
    }

    fn inside(&mut self, path: Rc<Path>, paint: &Paint) {
        let bounds = paths::bounds(&path);
        self.lay(Area::Inside(path), paint, 1.0, bounds);
    }

    /// An area in `share` of a colour; all of it lies in `bounds`, in image pixels.
    fn lay(&mut self, area: Area, paint: &Paint, share: f64, bounds: Rect) {
        let visible = self.clip.map_or(Some(bounds), |clip| clip.rect.intersection(bounds));
        let Some(part) = visible.and_then(|visible| self.part(visible)) else { return };
        let ink = Ink::of(&paint.with_opacity(paint.opacity * share), Fineness::at(self.scale));
        let clip = self.clip.filter(|clip| !clip.spares(bounds));
        self.steps.push(Step::Lay { ink, area, part, clip });
    }

    /// The pixels that hold `bounds`; `None` where none of the image does.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "cut to the image before")]
    #[expect(clippy::cast_precision_loss, reason = "an image is narrower than 2^26")]
    fn part(&self, bounds: Rect) -> Option<Part> {
        let range = |low: f64, high: f64, most: usize| {
            let pixel = |v: f64| v.clamp(0.0, most as f64) as usize;
            pixel(low.floor())..pixel(high.ceil())
        };
        let part = Part {
            columns: range(bounds.x0, bounds.x1, self.size.0),
            rows: range(bounds.y0, bounds.y1, self.size.1),
        };
        (!part.is_empty()).then_some(part)
    }
}
