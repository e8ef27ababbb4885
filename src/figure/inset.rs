//! An inset: a detail of a panel, drawn again and enlarged in one of the panel's corners.
//!
//! Its layers are the panel's, in a frame of its own; so lines, markers and letters are as large as anywhere,
//! and only places are farther apart. The corner that hides least is taken where the scene names none.
//! What is too small to be seen is found in [`small`].

mod small;

use crate::drawing::{Contour, Group, Item, Offset, Path, Point, Rect, Role, Shown, Stroke};
use crate::geometry::DVec2;
use crate::scene::{Detail, Panel};

use super::frame::Frame;
use super::placement::Labelled;
use super::sketch::{Anchor, Cover, Label, Obstacle, Rank, Request, Sketch, Sketched, Weight};
use super::theme::Theme;

/// The most that an inset takes of its panel's width and height: three quarters of it stay in view.
const SHARE: f64 = 0.5;
/// Room between an inset and the panel's edges, page pixels.
const MARGIN: f64 = 6.0;
/// Room between an inset and the detail that it shows, page pixels.
const APART: f64 = 12.0;
/// First digits of a factor, which is one of them times a power of ten.
const FACTORS: [f64; 9] = [1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
/// How many of the largest factors are tried.
const TRIED: usize = 3;
/// How much of a line an inset may hide rather than be nothing, page pixels.
const SMALLER: f64 = 160.0;
/// The largest power of ten of a factor.
const POWERS: i32 = 12;
/// How far a label may reach over the edge of an inset, page pixels: less than the room in its own box.
const SPILL: f64 = 1.0;
/// Width of the frames about the detail and the inset, and of the line between them, page pixels.
const THIN: f64 = 1.0;
/// From one line to the next of those by which labels keep off an inset, page pixels: no letter fits between.
const CLOSE: f64 = 6.0;
/// How much of a line an inset may hide for a marker or an arrowhead, page pixels: more than one of ours may
/// hide at all, as an arrow without its head is another line.
const POINT: f64 = 80.0;
/// How much less it counts to hide what is not the subject.
const BACKGROUND: f64 = 0.1;

/// The words for the corners in a scene, and where each lies from the panel's middle: x to the right, y down.
const CORNERS: [(&str, [f64; 2]); 4] =
    [("NE", [1.0, -1.0]), ("NW", [-1.0, -1.0]), ("SE", [1.0, 1.0]), ("SW", [-1.0, 1.0])];

/// An enlarged detail of a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Inset {
    /// Where its part of the space lies on the page.
    pub(crate) frame: Frame,
    /// The detail in the panel, on the page.
    detail: Rect,
    /// How many times it is enlarged.
    factor: f64,
    /// From which step of the figure on it is there.
    shown: Shown,
}

impl Inset {
    /// The inset that a panel asks for; `None` where it asks for none, or for one of so much of the panel
    /// that nothing could be enlarged. `before` is where it stood in the frame before of a figure that moves.
    pub(crate) fn of(panel: &Panel, sketched: &Sketched, before: Option<Rect>) -> Option<Self> {
        match asked(panel)? {
            Detail::Rectangle(_) if Self::is_beside(panel, sketched) => None,
            Detail::Rectangle(rectangle) => Self::of_rectangle(panel, rectangle, sketched),
            Detail::Small => small::enlarged(sketched, before, asked_corner(panel)),
        }
    }

    /// Whether a panel wants something enlarged for which it has no room.
    pub(crate) fn lacks_room(panel: &Panel, sketched: &Sketched) -> bool {
        asked(panel) == Some(Detail::Small) && small::lacks_room(sketched)
    }

    /// Whether all that a panel asks to enlarge lies beside what it shows.
    pub(crate) fn is_beside(panel: &Panel, sketched: &Sketched) -> bool {
        let Some(Detail::Rectangle(detail)) = asked(panel) else { return false };
        is_beside(detail, sketched.frame.visible())
    }

    /// The inset of a rectangle of the panel's space; `None` where it is too large to be enlarged.
    fn of_rectangle(panel: &Panel, [x0, y0, x1, y1]: [f64; 4], sketched: &Sketched) -> Option<Self> {
        let Sketched { frame, obstacles, free: cell, .. } = sketched;
        let (lo, hi) = (DVec2::new(x0, y0), DVec2::new(x1, y1));
        let detail = Rect::new(place(frame, lo), place(frame, hi));
        let room = (SHARE * cell.width() / detail.width()).min(SHARE * cell.height() / detail.height());
        if !(detail.width() > 0.0 && detail.height() > 0.0) {
            return None;
        }
        let corner = asked_corner(panel);
        let corners = CORNERS.iter().filter(|(_, at)| corner.is_none_or(|corner| corner == *at));
        let all = factors(room);
        let largest = all.first().copied()?;
        let places =
            corners.flat_map(|(_, corner)| all.iter().map(|&f| (f, enlarged(cell, &detail, *corner, f))));
        let cost =
            |&(f, rect): &(f64, Rect)| hidden(&rect, &detail, obstacles) + SMALLER * (1.0 - f / largest);
        let (factor, rect) = places.min_by(|a, b| cost(a).total_cmp(&cost(b)))?;
        let scale = frame.scale * factor;
        let frame = Frame { center: 0.5 * (lo + hi), middle: rect.center(), scale, panel: rect, ..*frame };
        Some(Self { frame, detail, factor, shown: Shown::ALWAYS })
    }

    /// Writes in the inset how many times it enlarges, as the language of the scene has numbers in formulas.
    pub(crate) fn write_factor(&self, sketch: &mut Sketch, in_latex: impl FnOnce(String) -> String) {
        let rect = self.frame.panel;
        let factor = in_latex(self.factor.to_string());
        let Some(words) = sketch.set(&format!(r"$\times\,{factor}$")) else { return };
        let [left, right] = [rect.x0 + MARGIN, rect.x1 - words.width - MARGIN];
        let [high, low] = [rect.y0 + words.ascent + MARGIN, rect.y1 - words.descent - MARGIN];
        // The first of those that hide least.
        let corners = [(right, low), (left, low), (right, high), (left, high)].map(|(x, y)| Point::new(x, y));
        let hides = |at: &Point| {
            let under = Rect::new(
                *at + Offset::new(0.0, -words.ascent),
                *at + Offset::new(words.width, words.descent),
            );
            covered(&under, sketch.obstacles())
        };
        let origin = corners.into_iter().min_by(|p, q| hides(p).total_cmp(&hides(q)));
        let Some(origin) = origin else { return };
        sketch.begin_layer("factor", true);
        sketch.write(&words, origin, Role::Muted);
    }

    /// Makes the inset's own labels keep off its frame.
    pub(crate) fn keep_off_the_frame(&self, sketched: &mut Sketched) {
        let rect = self.frame.panel;
        sketched.obstacles.extend(edges(&rect).map(|(from, to)| {
            let cover = Cover::Stroke { from, to, half: 0.5 * THIN };
            Obstacle { cover, weight: Weight::Normal, part: usize::MAX }
        }));
    }

    /// How many times it enlarges, for who does not see it.
    pub(crate) fn in_words(&self) -> String {
        format!("detail, enlarged {} times", self.factor)
    }

    /// Makes the panel's labels keep off the inset, the frame of its detail and the line between them. What
    /// lies within the detail and is `named` in the inset is named there alone.
    pub(crate) fn claim(&self, sketched: &mut Sketched, named: &[(&str, &Anchor)]) {
        let part = usize::MAX;
        let mut keep_off = |from, to| {
            let cover = Cover::Stroke { from, to, half: 0.5 * THIN };
            sketched.obstacles.push(Obstacle { cover, weight: Weight::Normal, part });
        };
        let rect = self.frame.panel;
        let mut y = rect.y0;
        while y < rect.y1 {
            keep_off(Point::new(rect.x0, y), Point::new(rect.x1, y));
            y += CLOSE;
        }
        for frame in [rect, self.detail] {
            for (from, to) in edges(&frame) {
                keep_off(from, to);
            }
        }
        let (from, to) = self.link();
        keep_off(from, to);
        let is_named = |label: &Label| named.contains(&(label.key, &label.anchor));
        let (frame, detail) = (sketched.frame, self.detail);
        // The origin and bodies keep their names: a reader looks for them in the panel.
        let is_there = |label: &Label| label.rank < Rank::Name && within(&detail, &frame, &label.anchor);
        sketched.requests.retain(|Request { label, .. }| !(is_there(label) && is_named(label)));
    }

    /// Leaves out notes, which the panel has already. Of what was too small to be seen only that is named
    /// which lies there: not what begins or ends outside, nor what the panel names outside of the detail.
    pub(crate) fn without_the_panels(&self, panel: &Panel, own: &Sketched, sketched: &mut Sketched) {
        let is_small = asked(panel) == Some(Detail::Small);
        let elsewhere = |key: &str| {
            let same = own.requests.iter().filter(|request| request.label.key == key);
            same.into_iter().any(|request| !within(&self.detail, &own.frame, &request.label.anchor))
        };
        sketched.requests.retain(|Request { label, .. }| {
            !matches!(label.anchor, Anchor::Corner(_))
                && (!is_small
                    || within(&self.frame.panel, &self.frame, &label.anchor) && !elsewhere(label.key))
        });
    }

    /// Leaves out labels that reach over the edge: of what begins outside of the detail, and is named in the
    /// panel.
    pub(crate) fn without_the_cut_off(&self, labelled: &mut Labelled) {
        let rect = self.frame.panel.grown(SPILL);
        labelled.placed.retain(|label| rect.union(label.bounds) == rect);
        labelled.dropped.clear();
    }

    /// What is drawn in the panel: a frame about the detail, and a line to the inset.
    pub(crate) fn marks(&self, theme: &Theme) -> Item {
        let mut group = Group::new("detail");
        let stroke = Stroke::solid(theme.paint(Role::Muted), THIN);
        let (from, to) = self.link();
        group.items.push(Item::Path(Path::stroked(framed(&self.detail), stroke.clone())));
        group.items.push(Item::Path(Path::stroked(Contour::line(from, to), stroke)));
        let mut marks = Item::Group(group);
        marks.for_each_shown(&|shown| *shown = self.shown);
        marks
    }

    /// The ground on which the inset is drawn, and its frame above all.
    pub(crate) fn ground(&self, theme: &Theme) -> [Item; 2] {
        let contour = framed(&self.frame.panel);
        let ground = Path::filled(contour.clone(), theme.paint(Role::Background));
        let frame = Path::stroked(contour, Stroke::solid(theme.paint(Role::Muted), THIN));
        [ground, frame].map(Item::Path)
    }

    /// Makes what the inset holds come no earlier than itself, and stay no longer: what came before comes
    /// with it. `is_before` says of two numbers of cues which comes first.
    pub(crate) fn comes(&self, item: &mut Item, is_before: &dyn Fn(usize, usize) -> bool) {
        item.for_each_shown(&|shown| {
            if is_before(shown.since, self.shown.since) {
                shown.since = self.shown.since;
            }
            if let Some(end) = self.shown.until {
                shown.until = Some(shown.until.filter(|&own| is_before(own, end)).unwrap_or(end));
            }
        });
    }

    /// The shortest line between a corner of the detail and one of the inset.
    fn link(&self) -> (Point, Point) {
        let corners = |r: &Rect| edges(r).map(|(from, _)| from);
        let all = corners(&self.detail).into_iter();
        let all = all.flat_map(|p| corners(&self.frame.panel).map(|q| (p, q)));
        let none = (self.detail.center(), self.frame.panel.center());
        all.min_by(|a, b| (a.1 - a.0).length().total_cmp(&(b.1 - b.0).length())).unwrap_or(none)
    }
}

/// What a panel asks to enlarge.
fn asked(panel: &Panel) -> Option<Detail> {
    panel.inset.as_ref().map(|inset| inset.value)
}

/// Whether a rectangle of a panel's space lies beside all between two points of it.
pub(super) fn is_beside([x0, y0, x1, y1]: [f64; 4], (lo, hi): (DVec2, DVec2)) -> bool {
    hi.x < x0 || lo.x > x1 || hi.y < y0 || lo.y > y1
}

/// Whether all of what a label belongs to lies within a rectangle of the page.
fn within(rect: &Rect, frame: &Frame, anchor: &Anchor) -> bool {
    let points = anchor.points();
    let seen = |p: &DVec2| Rect::new(frame.page(*p), frame.page(*p)).union(*rect) == *rect;
    !points.is_empty() && points.iter().all(seen)
}

/// Where a point of the panel's own space lies on the page: of a body's panel, in the body's frame.
fn place(frame: &Frame, p: DVec2) -> Point {
    Frame { pose: None, ..*frame }.page(p)
}

/// The largest round factors up to `most`, the largest first; none where nothing would be enlarged.
fn factors(most: f64) -> Vec<f64> {
    let powers = (0..=POWERS).scan(1.0, |power, _| {
        let this = *power;
        *power *= 10.0;
        Some(this)
    });
    let all = powers.flat_map(|power| FACTORS.map(|f| f * power));
    let mut fitting: Vec<f64> = all.take_while(|f| *f <= most).collect();
    fitting.reverse();
    fitting.truncate(TRIED);
    fitting
}

/// The place of an inset in a corner of its panel.
fn enlarged(cell: &Rect, detail: &Rect, [right, down]: [f64; 2], factor: f64) -> Rect {
    let half = [0.5 * factor * detail.width(), 0.5 * factor * detail.height()];
    let x = cell.center().x + right * (0.5 * cell.width() - MARGIN - half[0]);
    let y = cell.center().y + down * (0.5 * cell.height() - MARGIN - half[1]);
    Rect { x0: x - half[0], y0: y - half[1], x1: x + half[0], y1: y + half[1] }
}

/// The corner that a panel asks for, as [`CORNERS`] has it.
fn asked_corner(panel: &Panel) -> Option<[f64; 2]> {
    let asked = &panel.inset_at.as_ref()?.value;
    CORNERS.iter().find(|(word, _)| word == asked).map(|&(_, corner)| corner)
}

/// How much an inset would hide, in page pixels of line.
fn hidden(rect: &Rect, detail: &Rect, obstacles: &[Obstacle]) -> f64 {
    let over = rect.grown(APART).intersection(*detail).map_or(0.0, |_| f64::MAX / 4.0);
    over + covered(rect, obstacles)
}

/// How much of what is drawn lies in a rectangle, page pixels of lines.
fn covered(rect: &Rect, obstacles: &[Obstacle]) -> f64 {
    let cost = |obstacle: &Obstacle| {
        let weight = if obstacle.weight == Weight::Background { BACKGROUND } else { 1.0 };
        weight
            * match obstacle.cover {
                Cover::Stroke { from, to, .. } => inside(rect, from, to),
                Cover::Marker { at, .. } | Cover::Head { at, .. } => {
                    rect.intersection(Rect::new(at, at)).map_or(0.0, |_| POINT)
                }
            }
    };
    obstacles.iter().map(cost).sum()
}

/// How much of a line lies within a rectangle, page pixels.
fn inside(rect: &Rect, from: Point, to: Point) -> f64 {
    rect.shares_inside(from, to).map_or(0.0, |(enters, leaves)| (leaves - enters) * (to - from).length())
}

/// The edges of a rectangle, each from one vertex to the next.
fn edges(r: &Rect) -> [(Point, Point); 4] {
    let p = [(r.x0, r.y0), (r.x1, r.y0), (r.x1, r.y1), (r.x0, r.y1)].map(|(x, y)| Point::new(x, y));
    [(p[0], p[1]), (p[1], p[2]), (p[2], p[3]), (p[3], p[0])]
}

/// The line around a rectangle.
fn framed(r: &Rect) -> Contour {
    Contour::polygon(&edges(r).map(|(from, _)| from))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_round_and_as_large_as_fit() {
        assert_eq!([factors(1.4), factors(1.5)], [vec![], vec![1.5]]);
        assert_eq!([factors(9.9), factors(71.0)], [vec![8.0, 6.0, 5.0], vec![60.0, 50.0, 40.0]]);
    }

    #[test]
    fn the_part_of_a_line_within_a_rectangle_is_measured() {
        let rect = Rect { x0: 0.0, y0: 0.0, x1: 10.0, y1: 10.0 };
        let line = |x0, y0, x1, y1| inside(&rect, Point::new(x0, y0), Point::new(x1, y1));
        assert_eq!(line(-5.0, 5.0, 20.0, 5.0), 10.0);
        assert_eq!(line(2.0, 2.0, 5.0, 6.0), 5.0);
        assert_eq!(line(-5.0, 11.0, 20.0, 11.0), 0.0);
        assert_eq!(line(-5.0, -9.0, -1.0, 20.0), 0.0);
    }

    #[test]
    fn what_is_too_small_once_a_panel_is_drawn_smaller_is_enlarged() {
        let text = "lang = 'es'
            shapes.jugador_principal = { kind = 'capsule', points = [[0, -0.5], [0, 0.5]], radius = 0.35,
                position = [0.1, 0.3], velocity = [2, 0] }
            shapes.'muro de piedra' = { kind = 'box', half_extents = [0.5, 2], position = [0.8, 0] }
            query = { kind = 'time-of-impact', of = ['jugador_principal', 'muro de piedra'] }";
        let scene = crate::scene::open_text("wall", text).unwrap().scene;
        let plan = crate::figure::plan(&scene).unwrap();
        let figure = crate::figure::draw(&plan, plan.theme, "wall");
        assert_eq!(figure.insets.len(), 2, "{:?}", figure.warnings);
    }
}
