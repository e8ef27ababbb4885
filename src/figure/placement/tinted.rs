//! The halo of a text has the colour of what lies under it: on a filled body a pale rim looks like a sticker.
//!
//! A halo covers the lines that cross its text, and the see-through areas under the text's middle go on over
//! it: of a text across an area's edge the middle decides, as no one colour fits. Areas that are opaque are
//! marks; those of the page's colour hide what is below them. Where an area comes with a later step than the
//! text that it lies under, the text is there twice: until then with the halo of before.

use std::f64::consts::PI;

use crate::drawing::{Contour, Item, Paint, Path, Point, Rect, Role, Segment, Shown, Text};
use crate::geometry::sort_by;
use crate::typeset::UNITS_PER_EM;

use super::polyline::Polyline;

/// The turn of a piece of an arc at most, radians, 36 to a circle: its line is 2 px off on a circle of 500.
const PIECE: f64 = PI / 18.0;
/// How far the line of a piece is off its arc at most, page pixels: an inset enlarges circles to thousands.
const OFF: f64 = 2.0;
/// The most pieces of an arc: within a page none is longer that is seen.
const MOST_PIECES: f64 = 10_000.0;
/// The most areas that a halo shows through itself: five are a panel's ground, A, B, B ⊖ A and a sector.
const MOST_AREAS: usize = 5;
/// The most pairs of a text and a point of an area's line that are looked at: a hundred times a figure's.
/// Beyond, halos keep the page's colour.
const MOST_PAIRS: usize = 5_000_000;

/// A filled area that was drawn.
struct Area {
    /// Its line.
    line: Polyline,
    /// What its group is cut off at.
    clip: Option<Rect>,
    /// Its colour.
    paint: Paint,
    /// The steps that show it.
    shown: Shown,
}

/// Gives the halos of a drawing, in painting order, the colours of the areas that their texts lie on.
pub(crate) fn tint(items: &mut Vec<Item>) {
    let (texts, points) = items.iter().map(size).fold((0, 0), |all, one| (all.0 + one.0, all.1 + one.1));
    if texts.saturating_mul(points) <= MOST_PAIRS {
        walk(items, (None, 1.0), &mut Vec::new());
    }
}

/// Texts with a halo in an item, and points of its areas' lines.
fn size(item: &Item) -> (usize, usize) {
    match item {
        Item::Group(group) => {
            group.items.iter().map(size).fold((0, 0), |all, one| (all.0 + one.0, all.1 + one.1))
        }
        Item::Path(Path { fill: Some(_), contour: Contour::Segments(segments), .. }) => (0, segments.len()),
        Item::Path(_) => (0, 1),
        Item::Text(text) => (usize::from(text.halo.is_some()), 0),
    }
}

/// Goes through the items of a group of this clip and opacity, of which `areas` were drawn before.
fn walk(items: &mut Vec<Item>, (clip, opacity): (Option<Rect>, f64), areas: &mut Vec<Area>) {
    let mut before = Vec::new();
    for (index, item) in items.iter_mut().enumerate() {
        match item {
            Item::Group(group) => {
                let clip = match (clip, group.clip.map(|clip| clip.rect)) {
                    (Some(a), Some(b)) => Some(a.intersection(b).unwrap_or_default()),
                    (a, b) => a.or(b),
                };
                walk(&mut group.items, (clip, opacity * group.opacity), areas);
            }
            Item::Path(path) => areas.extend(area(path, clip, opacity)),
            Item::Text(text) => {
                let Some(middle) = ink(text).map(Rect::center) else { continue };
                if text.halo.as_ref().is_none_or(|halo| halo.paint.role != Some(Role::Background)) {
                    continue;
                }
                let below: Vec<&Area> = areas.iter().filter(|area| area.holds(middle)).collect();
                let later = below.iter().map(|area| area.shown.since).filter(|&since| {
                    since > text.shown.since && text.shown.until.is_none_or(|until| since < until)
                });
                let mut steps: Vec<usize> = later.collect();
                sort_by(&mut steps, usize::cmp);
                steps.dedup();
                for step in steps {
                    let mut early = text.clone();
                    early.shown.until = Some(step);
                    lay(&mut early, under(&below, step - 1));
                    before.push((index, Item::Text(early)));
                    text.shown.since = step;
                }
                let last = text.shown.until.map_or(usize::MAX, |until| until - 1);
                lay(text, under(&below, last));
            }
        }
    }
    for (index, early) in before.into_iter().rev() {
        items.insert(index, early);
    }
}

/// The area of a path, if it is one that can be seen under a text.
fn area(path: &Path, clip: Option<Rect>, opacity: f64) -> Option<Area> {
    // What a step takes away does not lie under what stays.
    let paint = path.fill.filter(|_| path.shown.until.is_none())?;
    let paint = paint.with_opacity(paint.opacity * opacity);
    let is_seen = paint.opacity > 0.0 && (paint.opacity < 1.0 || is_ground(paint.role));
    if !is_seen {
        return None;
    }
    let line = points(&path.contour).and_then(Polyline::closed)?;
    Some(Area { line, clip, paint, shown: path.shown })
}

/// Whether the opaque areas of a role are no marks but lie under others: the page, and where bodies overlap.
fn is_ground(role: Option<Role>) -> bool {
    matches!(role, Some(Role::Background | Role::Overlap))
}

/// Points along a contour of one piece without Bézier curves, of which our areas have none.
fn points(contour: &Contour) -> Option<Vec<Point>> {
    let segments = match contour {
        Contour::Circle { center, radius } => return Some(arc(*center, *radius, 0.0, 2.0 * PI)),
        Contour::Segments(segments) => segments,
    };
    let mut points = Vec::new();
    for (i, segment) in segments.iter().enumerate() {
        match *segment {
            Segment::Move(p) if i == 0 => points.push(p),
            Segment::Line(p) => points.push(p),
            Segment::Arc { center, radius, start, sweep } => points.extend(arc(center, radius, start, sweep)),
            Segment::Close => {}
            Segment::Move(_) | Segment::Quad(..) | Segment::Cubic(..) => return None,
        }
    }
    Some(points)
}

/// Points along an arc.
fn arc(center: Point, radius: f64, start: f64, sweep: f64) -> Vec<Point> {
    // A chord of a turn θ is r θ²/8 off.
    let piece = PIECE.min((8.0 * OFF / radius).sqrt());
    let share = (piece / sweep.abs()).max(1.0 / MOST_PIECES);
    let mut shares = vec![0.0];
    while let Some(&last) = shares.last().filter(|&&last| last < 1.0) {
        shares.push((last + share).min(1.0));
    }
    let at = |share: f64| start + sweep * share;
    let on =
        |angle: f64| Point::new(center.x + radius * libm::cos(angle), center.y + radius * libm::sin(angle));
    shares.into_iter().map(|share| on(at(share))).collect()
}

/// The box of a text's ink; none where it has none.
fn ink(text: &Text) -> Option<Rect> {
    let Point { x, y } = text.origin;
    let glyphs = text.line.glyphs.iter().map(|placed| {
        let unit = placed.size / UNITS_PER_EM;
        let [x0, y0, x1, y1] = placed.glyph.outline().bounds.map(|v| f64::from(v) * unit);
        Rect::new(
            Point::new(x + placed.x + x0, y + placed.y + y0),
            Point::new(x + placed.x + x1, y + placed.y + y1),
        )
    });
    glyphs.reduce(Rect::union)
}

/// What lies `below` a text in a step, the lowest first; nothing where that is too much.
fn under(below: &[&Area], step: usize) -> Vec<Paint> {
    let mut found = Vec::new();
    for area in below.iter().filter(|area| area.shown.since <= step) {
        if area.paint.opacity >= 1.0 {
            found.clear();
        }
        if area.paint.role == Some(Role::Background) {
            continue;
        }
        if found.len() < MOST_AREAS {
            found.push(area.paint);
        } else {
            return Vec::new();
        }
    }
    found
}

impl Area {
    /// Whether a point lies on it, as far as it is seen.
    fn holds(&self, p: Point) -> bool {
        self.clip.is_none_or(|clip| clip.contains(p)) && self.line.contains(p)
    }
}

/// Lays areas over the halo of a text.
fn lay(text: &mut Text, areas: Vec<Paint>) {
    let Some(halo) = &mut text.halo else { return };
    halo.paint.color = areas.iter().fold(halo.paint.color, |under, area| area.over(under));
    halo.areas = areas;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Color, Halo};
    use crate::figure::theme::THEMES;
    use crate::figure::{Figure, draw, plan};
    use crate::scene::open_text;

    /// Two boxes, the names pinned, drawn in a theme.
    fn drawn(labels: &str, theme: usize) -> Figure {
        let text = format!(
            "shapes.A = {{ kind = 'aabb', half_extents = [3, 2] }}
            shapes.B = {{ kind = 'circle', radius = 2, position = [2, 1] }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}
            panels = [{{ view = [-4, -3, 5, 4], layers = ['shapes'] }}]
            {labels}"
        );
        let scene = open_text("halo", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw(&plan, &THEMES[theme], "halo")
    }

    /// The halo of the label of a key.
    fn halo(items: &[Item], key: &str) -> Option<Halo> {
        items.iter().find_map(|item| match item {
            Item::Group(group) if group.name == format!("label-{key}") => {
                group.items.iter().find_map(|item| match item {
                    Item::Text(text) => text.halo.clone(),
                    _ => None,
                })
            }
            Item::Group(group) => halo(&group.items, key),
            _ => None,
        })
    }

    #[test]
    fn an_arc_of_any_radius_has_an_end() {
        for radius in [1e9, 1e300, f64::INFINITY] {
            let points = arc(Point::new(0.0, 0.0), radius, 0.0, 2.0 * PI).len();
            assert!((1000..=10_002).contains(&points), "{radius}: {points}");
        }
    }

    #[test]
    fn a_point_just_within_a_large_arc_lies_on_its_area() {
        for radius in [10.0, 500.0, 1e4, 1e6] {
            let circle = Path::filled(
                Contour::Circle { center: Point::new(0.0, 0.0), radius },
                Paint::role(Role::Overlap, Color::hex(0)),
            );
            let area = area(&circle, None, 1.0).unwrap();
            let at =
                |angle: f64| Point::new((radius - 4.0) * libm::cos(angle), (radius - 4.0) * libm::sin(angle));
            assert!((0..100).all(|k| area.holds(at(0.0628 * f64::from(k) + 0.01))), "{radius}");
        }
    }

    #[test]
    fn a_halo_knows_nothing_of_an_area_that_comes_later() {
        let text = "shapes.A = { kind = 'aabb', half_extents = [1, 1] }
            shapes.B = { kind = 'aabb', half_extents = [1, 1], position = [0.5, 0.25] }
            query = { kind = 'separation', of = ['A', 'B'], algorithm = 'minkowski' }
            panels = [{ space = 'configuration', layers = ['difference', 'origin'] }]";
        let scene = open_text("halo", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawing = crate::figure::draw_in_steps(&plan, plan.theme, "halo").drawing;
        let (page, last) = (plan.theme.color(Role::Background), drawing.steps.len());
        let of_step = |step: usize| halo(&drawing.at_step(step).items, "O").unwrap().paint.color;
        assert_eq!(of_step(1), page);
        assert_ne!(of_step(last), page, "O lies on B ⊖ A");
        assert_eq!(drawing.at_step(last), draw(&plan, plan.theme, "halo").drawing);
    }

    #[test]
    fn a_halo_has_the_colours_of_the_areas_that_its_text_lies_on_in_every_theme() {
        for (i, theme) in THEMES.iter().enumerate() {
            let figure = drawn("labels.A = { at = [-100, 50] }\nlabels.B = { at = [-20, 20] }", i);
            let [a, b] = ["A", "B"].map(|key| halo(&figure.drawing.items, key).unwrap());
            let page = theme.color(Role::Background);
            let fill = |role| theme.paint(role).with_opacity(theme.fill_opacity);
            assert_eq!(a.areas, [fill(Role::A)], "{}", theme.name);
            assert_eq!(a.paint.color, fill(Role::A).over(page), "{}", theme.name);
            assert_eq!(b.areas, [theme.paint(Role::Overlap)], "{}: where A and B overlap", theme.name);
            assert_eq!(b.paint.color, theme.color(Role::Overlap), "{}", theme.name);
        }
    }

    #[test]
    fn across_the_line_of_an_area_the_middle_of_the_text_decides() {
        let mut seen = [false; 2];
        for x in (-400..-60).step_by(20) {
            let name = format!("labels.A = {{ text = 'a long name', at = [{x}, 40] }}");
            let figure = drawn(&name, 0);
            let panel = &figure.panels[0];
            let edge = panel.frame.page(crate::geometry::DVec2::new(-3.0, 0.0)).x;
            let label = panel.placed.iter().find(|label| label.key == "A").unwrap();
            let from_edge = label.bounds.center().x - edge;
            // The middle of the ink is some px from that of the label's box.
            if from_edge.abs() > 4.0 {
                let halo = halo(&figure.drawing.items, "A").unwrap();
                assert_eq!(halo.areas.len(), usize::from(from_edge > 0.0), "{from_edge}");
                assert_eq!(halo.paint.color == Color::hex(0xFF_FF_FF), from_edge < 0.0, "{from_edge}");
                seen[usize::from(from_edge > 0.0)] = true;
            }
        }
        assert_eq!(seen, [true; 2]);
    }

    #[test]
    fn what_covers_the_page_again_takes_away_what_is_below() {
        let square = |fill: Paint| {
            let at = |x, y| Point::new(x, y);
            let corners = [at(0.0, 0.0), at(90.0, 0.0), at(90.0, 90.0), at(0.0, 90.0)];
            area(&Path::filled(Contour::polygon(&corners), fill), None, 1.0)
        };
        let tint = Paint::role(Role::A, Color::hex(0)).with_opacity(0.5);
        let page = Paint::role(Role::Background, Color::hex(0xFF_FF_FF));
        let areas: Vec<Area> = [tint, page, tint].into_iter().filter_map(square).collect();
        let below: Vec<&Area> = areas.iter().collect();
        assert_eq!(under(&below[..1], 1), [tint]);
        assert_eq!(under(&below[..2], 1), []);
        assert_eq!(under(&below, 1), [tint]);
        let late = Area { shown: Shown { since: 3, until: None }, ..square(tint).unwrap() };
        assert_eq!(under(&[&late], 2), [], "it is not there yet");
        assert_eq!(under(&[&late], 3), [tint]);
    }
}
