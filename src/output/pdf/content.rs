//! A drawing as operators of PDF.
//!
//! Coordinates are turned over once a figure, so that everything below is in page pixels, y down. Whatever
//! changes the graphics state stands between `q` and `Q`. Clips and patterns are clipping paths.

use std::collections::BTreeSet;

use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content as Operators, Name};

use super::super::curves;
use super::super::handout::{Placed, Sheet};
use super::super::number::{hundredths, millionths};
use super::SETTINGS;
use super::letters::Letters;
use crate::drawing::{
    Cap, Clip, Color, Contour, Drawing, Group, Halo, Item, Paint, Path, Pattern, Point, Rect, Segment,
    Stroke, Text,
};
use crate::typeset::{Glyph, Rule, UNITS_PER_EM};

/// What pages draw, and what that refers to by name.
pub(super) struct Content {
    /// The operators of each page.
    pub(super) pages: Vec<Vec<u8>>,
    /// The glyphs that occur, then the groups with an opacity, inner ones first.
    pub(super) forms: Vec<Form>,
    /// The graphics states that occur.
    pub(super) states: BTreeSet<State>,
    /// The characters that can be found and copied.
    pub(super) letters: Letters,
}

/// Content that is drawn by its name.
pub(super) struct Form {
    /// Its name among the page's resources.
    pub(super) name: String,
    /// What it draws within: left, top, right, bottom, in its own coordinates.
    pub(super) bounds: [f32; 4],
    /// Its operators.
    pub(super) content: Vec<u8>,
    /// Whether it is drawn by itself and then laid onto the page as one, for an opacity of the whole.
    pub(super) is_group: bool,
}

/// A graphics state: an opacity of what is drawn from then on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct State {
    /// The opacity, in thousandths.
    thousandths: u16,
    /// What has it.
    pub(super) of: Opacity,
}

/// What an opacity is for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Opacity {
    /// Areas and lines, and so a form as a whole.
    All,
    /// Areas.
    Fills,
    /// Lines.
    Strokes,
}

impl State {
    /// The name among the page's resources.
    pub(super) fn name(self) -> String {
        let of = match self.of {
            Opacity::All => "",
            Opacity::Fills => "f",
            Opacity::Strokes => "s",
        };
        format!("G{}{of}", self.thousandths)
    }

    /// The opacity, from 0 to 1.
    pub(super) fn opacity(self) -> f32 {
        f32::from(self.thousandths) / 1000.0
    }
}

impl Content {
    /// All that sheets show.
    pub(super) fn of(sheets: &[Sheet<'_>]) -> Self {
        let mut painter = Painter::default();
        let mut pages = Vec::new();
        let mut reach = [0.0_f64; 2];
        for sheet in sheets {
            painter.operators.set_line_join(LineJoinStyle::RoundJoin);
            for figure in &sheet.figures {
                painter.aside(|painter| painter.figure(figure, sheet.size[1]));
                let Drawing { width, height, .. } = figure.drawing;
                reach = [reach[0].max(*width), reach[1].max(*height)];
            }
            painter.operators.transform([1.0, 0.0, 0.0, -1.0, 0.0, hundredths(sheet.size[1])]);
            sheet.words.iter().for_each(|words| painter.text(words));
            let page = std::mem::replace(&mut painter.operators, empty());
            pages.push(page.finish().into_vec());
        }
        let everywhere = [0.0, 0.0, hundredths(reach[0].ceil()), hundredths(reach[1].ceil())];
        let groups = painter.groups.into_iter().enumerate().map(|(i, content)| Form {
            name: group_name(i),
            bounds: everywhere,
            content,
            is_group: true,
        });
        let forms = painter.glyphs.into_iter().map(glyph_form).chain(groups).collect();
        Self { pages, forms, states: painter.states, letters: painter.letters }
    }
}

/// Content being written, and what it refers to so far.
struct Painter {
    /// The operators of the page, or of the innermost group that is open.
    operators: Operators,
    /// The graphics states that were used.
    states: BTreeSet<State>,
    /// The characters that were set.
    letters: Letters,
    /// The glyphs that were set, each a form of its own.
    glyphs: BTreeSet<Glyph>,
    /// The operators of each group with an opacity.
    groups: Vec<Vec<u8>>,
}

impl Default for Painter {
    fn default() -> Self {
        Self {
            operators: empty(),
            states: BTreeSet::new(),
            letters: Letters::default(),
            glyphs: BTreeSet::new(),
            groups: Vec::new(),
        }
    }
}

impl Painter {
    /// Writes something, and brings the graphics state back to what it was.
    fn aside(&mut self, write: impl FnOnce(&mut Self)) {
        self.operators.save_state();
        write(self);
        self.operators.restore_state();
    }

    /// A figure at its place on a sheet of this height; nothing of it lies beside its page.
    fn figure(&mut self, &Placed { drawing, at: [x, y], scale }: &Placed<'_>, height: f64) {
        let factor = millionths(scale);
        self.operators.transform([factor, 0.0, 0.0, -factor, hundredths(x), hundredths(height - y)]);
        let page = Rect { x0: 0.0, y0: 0.0, x1: drawing.width, y1: drawing.height };
        self.rect(page);
        self.operators.clip_nonzero().end_path();
        if !drawing.is_transparent() {
            self.aside(|painter| {
                painter.fill_paint(&drawing.background);
                painter.rect(page);
                painter.operators.fill_nonzero();
            });
        }
        self.items(&drawing.items);
    }

    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.aside(|painter| painter.group(group)),
                Item::Path(path) => self.path(path),
                Item::Text(text) => self.text(text),
            }
        }
    }

    fn group(&mut self, group: &Group) {
        if let Some(clip) = group.clip {
            self.around(clip);
            self.operators.clip_nonzero().end_path();
        }
        if group.opacity < 1.0 {
            let outside = std::mem::replace(&mut self.operators, empty());
            self.items(&group.items);
            let inside = std::mem::replace(&mut self.operators, outside);
            self.opacity(group.opacity, Opacity::All);
            self.operators.x_object(Name(group_name(self.groups.len()).as_bytes()));
            self.groups.push(inside.finish().into_vec());
        } else {
            self.items(&group.items);
        }
    }

    fn path(&mut self, path: &Path) {
        if let Some(fill) = &path.fill {
            self.aside(|painter| {
                painter.fill_paint(fill);
                painter.contour(&path.contour);
                painter.operators.fill_nonzero();
            });
        }
        if let Some(pattern) = &path.pattern
            && let Some(bounds) = path.contour.bounds()
        {
            self.aside(|painter| painter.pattern(pattern, &path.contour, bounds));
        }
        if let Some(stroke) = &path.stroke {
            self.aside(|painter| {
                painter.stroke_style(stroke);
                painter.contour(&path.contour);
                painter.operators.stroke();
            });
        }
    }

    /// Marks all over the bounds, of which those inside the contour are seen.
    fn pattern(&mut self, pattern: &Pattern, contour: &Contour, bounds: Rect) {
        self.contour(contour);
        self.operators.clip_nonzero().end_path();
        let (marks, stroke) = pattern.marks(bounds);
        self.stroke_style(&stroke);
        for (from, to) in marks {
            self.contour(&Contour::line(from, to));
        }
        self.operators.stroke();
    }

    /// The line around a clip.
    fn around(&mut self, clip: Clip) {
        match clip.radius {
            0.0 => self.rect(clip.rect),
            _ => self.contour(&clip.contour()),
        }
    }

    fn stroke_style(&mut self, stroke: &Stroke) {
        self.stroke_paint(&stroke.paint);
        self.operators.set_line_width(hundredths(stroke.width));
        if stroke.cap == Cap::Round {
            self.operators.set_line_cap(LineCapStyle::RoundCap);
        }
        if !stroke.dash.is_empty() {
            self.operators.set_dash_pattern(stroke.dash.iter().map(|&length| hundredths(length)), 0.0);
        }
    }

    fn text(&mut self, text: &Text) {
        if let Some(halo) = &text.halo {
            self.aside(|painter| painter.halo(text, halo));
        }
        self.aside(|painter| {
            painter.fill_paint(&text.paint);
            for placed in text.line.glyphs.iter().filter(|p| !p.glyph.outline().segments.is_empty()) {
                painter.glyphs.insert(placed.glyph);
                let em = millionths(placed.size / UNITS_PER_EM);
                let (x, y) = (text.origin.x + placed.x, text.origin.y + placed.y);
                painter.aside(|painter| {
                    painter.operators.transform([em, 0.0, 0.0, em, hundredths(x), hundredths(y)]);
                    painter.operators.x_object(Name(glyph_name(placed.glyph).as_bytes()));
                });
            }
            for rule in &text.line.rules {
                painter.rect(place(rule, text.origin));
                painter.operators.fill_nonzero();
            }
            for run in &text.line.runs {
                painter.letters.show(&mut painter.operators, run, text.origin);
            }
        });
    }

    /// The outlines of all glyphs, stroked wide: a form can't be stroked, so they are written out.
    fn halo(&mut self, text: &Text, halo: &Halo) {
        self.fill_paint(&halo.paint);
        self.stroke_paint(&halo.paint);
        self.operators.set_line_width(hundredths(2.0 * halo.width));
        for placed in &text.line.glyphs {
            let em = placed.size / UNITS_PER_EM;
            let (x, y) = (text.origin.x + placed.x, text.origin.y + placed.y);
            outline(&mut self.operators, placed.glyph, |p| Point::new(x + p.x * em, y + p.y * em));
        }
        for rule in &text.line.rules {
            self.rect(place(rule, text.origin));
        }
        self.operators.fill_nonzero_and_stroke();
    }

    fn fill_paint(&mut self, paint: &Paint) {
        let [r, g, b] = channels(paint.color);
        self.operators.set_fill_rgb(r, g, b);
        if paint.opacity < 1.0 {
            self.opacity(paint.opacity, Opacity::Fills);
        }
    }

    fn stroke_paint(&mut self, paint: &Paint) {
        let [r, g, b] = channels(paint.color);
        self.operators.set_stroke_rgb(r, g, b);
        if paint.opacity < 1.0 {
            self.opacity(paint.opacity, Opacity::Strokes);
        }
    }

    fn opacity(&mut self, opacity: f64, of: Opacity) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 1000")]
        let thousandths = (opacity.clamp(0.0, 1.0) * 1000.0).round() as u16;
        let state = State { thousandths, of };
        self.states.insert(state);
        self.operators.set_parameters(Name(state.name().as_bytes()));
    }

    fn contour(&mut self, contour: &Contour) {
        let mut at = Point::default();
        curves::pieces(contour, |segment| at = segment_to(&mut self.operators, at, segment));
    }

    fn rect(&mut self, rect: Rect) {
        let [x, y, width, height] = [rect.x0, rect.y0, rect.width(), rect.height()].map(hundredths);
        self.operators.rect(x, y, width, height);
    }
}

fn empty() -> Operators {
    Operators::with_settings(SETTINGS)
}

/// Red, green and blue, from 0 to 1.
fn channels(Color { r, g, b }: Color) -> [f32; 3] {
    [r, g, b].map(|channel| millionths(f64::from(channel) / 255.0))
}

fn place(rule: &Rule, origin: Point) -> Rect {
    let (x0, y0) = (origin.x + rule.x, origin.y + rule.y);
    Rect { x0, y0, x1: x0 + rule.width, y1: y0 + rule.height }
}

fn group_name(number: usize) -> String {
    format!("X{number}")
}

fn glyph_name(glyph: Glyph) -> String {
    format!("{:?}{}", glyph.face, glyph.id)
}

/// A glyph, in the units of its font.
fn glyph_form(glyph: Glyph) -> Form {
    let mut operators = empty();
    outline(&mut operators, glyph, |p| p);
    operators.fill_nonzero();
    let content = operators.finish().into_vec();
    Form { name: glyph_name(glyph), bounds: glyph.outline().bounds, content, is_group: false }
}

/// Appends the outline of a glyph, its points mapped.
fn outline(operators: &mut Operators, glyph: Glyph, map: impl Fn(Point) -> Point) {
    let mut at = Point::default();
    curves::glyph(glyph.outline(), map, |segment| at = segment_to(operators, at, segment));
}

/// Appends a segment that begins at a point, and gives where it ends.
///
/// A quadratic curve becomes the cubic one that it is: PDF has no other.
fn segment_to(operators: &mut Operators, from: Point, segment: Segment) -> Point {
    let [x, y] = [|p: Point| hundredths(p.x), |p: Point| hundredths(p.y)];
    let toward =
        |c: Point, p: Point| Point::new(p.x + 2.0 / 3.0 * (c.x - p.x), p.y + 2.0 / 3.0 * (c.y - p.y));
    match segment {
        Segment::Move(p) => operators.move_to(x(p), y(p)),
        Segment::Line(p) => operators.line_to(x(p), y(p)),
        Segment::Quad(c, p) => {
            return segment_to(operators, from, Segment::Cubic(toward(c, from), toward(c, p), p));
        }
        Segment::Cubic(c, d, p) => operators.cubic_to(x(c), y(c), x(d), y(d), x(p), y(p)),
        Segment::Close => operators.close_path(),
        // Arcs have become cubic curves.
        Segment::Arc { .. } => operators,
    };
    curves::end(&segment).unwrap_or(from)
}
