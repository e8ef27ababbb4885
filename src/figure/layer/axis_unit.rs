//! What the numbers along an axis are counted in: the unit vector n on it, from its 0, where the shadow of
//! the panel's origin is; and the light that casts shadows on it.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Marker, Pen, Rank, SMALL_MARKER, Size, Sketch, Weight};
use crate::figure::text::{in_panel, number, terms};
use crate::geometry::{DVec2, Enclosure, Side};

use super::half_extents::beside;
use super::normal::unit_length;
use super::part;

/// Half the length of the mark of 0 on the axis, page pixels: past both intervals.
const ZERO: f64 = 11.0;

/// Half the length of the mark of each unit on the axis, page pixels: between both intervals.
const UNIT: f64 = 3.0;

/// The least that a unit is long for each to be marked, page pixels: marks that are nearer are a hatch.
const LEAST: f64 = 12.0;

/// A shadow that is shorter is a point, page pixels: a bar's ends would be one line across the axis.
const SHORT: f64 = 1.0;

/// The part of the panel's origin's place along an axis by which what is there may be off: both are sums of
/// two products, each rounded a few times.
const ROUNDED: f64 = 1e-12;

/// From where above the bodies to where the arrows of light reach, page pixels.
pub(super) const LIGHT: f64 = 38.0;
const CLEAR: f64 = 10.0;

/// The axis with its components in the frame of the panel, in LaTeX.
pub(super) fn written(context: &Context, n: DVec2) -> String {
    let n = in_panel(context, n);
    format!("n = ({}, {})", number(n.x), number(n.y))
}

/// Where along n the panel's origin is, and intervals of the world counted from there.
pub(super) fn from_origin(context: &Context, n: DVec2, intervals: [Enclosure; 2]) -> (f64, [Enclosure; 2]) {
    let origin = context.frame().map_or(0.0, |frame| frame.position.dot(n));
    let place = |x: f64| if (x - origin).abs() <= ROUNDED * origin.abs() { 0.0 } else { x - origin };
    (origin, intervals.map(|Enclosure { lo, hi }| Enclosure { lo: place(lo), hi: place(hi) }))
}

/// Draws n on the axis from its 0, where numbers are counted in its lengths.
pub(super) fn on_axis(sketch: &mut Sketch, (n, written): (DVec2, &str), at: impl Fn(f64, f64) -> DVec2) {
    let length = unit_length(sketch);
    let to_scale = if length == 1.0 { "" } else { " (not to scale)" };
    let (from, tip) = (at(0.0, 0.0), at(length, 0.0));
    sketch.part("normal").arrow(from, tip, Pen::vector(Role::Ink));
    let label = Label::new("axis", format!("${written}${to_scale}"), beside(from, tip, n), Role::Ink);
    sketch.label(label.rank(Rank::Measure));
}

/// Units from 0 within which they are marked: a panel is at most some thousands of page pixels wide, and a
/// unit is longer than [`LEAST`].
const FARTHEST: f64 = 1e4;

/// Marks each unit on the axis between two places, counted from 0, where they can be told apart.
pub(super) fn units(sketch: &mut Sketch, (first, last): (f64, f64), at: impl Fn(f64, f64) -> DVec2) {
    if sketch.on_page(1.0) < LEAST {
        return;
    }
    let half = sketch.px(UNIT);
    // Far beyond the panel nothing is marked: from 2⁵³ on k + 1 would be k, and there would be no end.
    let (first, last) = (first.max(-FARTHEST), last.min(FARTHEST));
    let each = std::iter::successors(Some(first.ceil()), |k| Some(k + 1.0)).take_while(|k| *k < last);
    let marks: Vec<_> = each.map(|k| (sketch.page(at(k, -half)), sketch.page(at(k, half)))).collect();
    sketch.part("units").quiet_lines(&marks, Pen::dimension(Role::Muted));
}

/// Draws from where light falls: arrows over the bodies towards the axis, from the `high`est of them at
/// `track`; the middle one, where there is a `gap`, through that to the axis.
pub(super) fn light(
    sketch: &mut Sketch,
    ([first, last], gap): ([f64; 2], Option<f64>),
    high: f64,
    at: impl Fn(f64, f64) -> DVec2,
) {
    let [from, to] = [LIGHT, CLEAR].map(|px| high - sketch.px(px));
    let middle = (gap.unwrap_or(0.5 * (first + last)), gap.map_or(to, |_| 0.0));
    let [left, right] = [1.0, 5.0].map(|sixths| (first + (last - first) * sixths / 6.0, to));
    for (along, to) in [left, middle, right] {
        let passes = to == 0.0;
        let role = if passes { Role::Translation } else { Role::Muted };
        sketch.part("light").weight(Weight::Light);
        sketch.arrow(at(along, from), at(along, to), Pen::vector(role));
    }
    let anchor = beside(at(left.0, from), at(left.0, to), at(1.0, 0.0) - at(0.0, 0.0));
    let label = Label::new("light", "light", anchor, Role::Muted);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Whether a place of the world is in the panel's view.
pub(super) fn sees(sketch: &Sketch, context: &Context, place: DVec2) -> bool {
    let (lo, hi) = sketch.visible();
    let place = context.in_space(place);
    lo.cmple(place).all() && hi.cmpge(place).all()
}

/// Writes where A ends and where B begins, each beyond the end of its own interval, `off` page pixels from
/// the axis on its side; their difference is `gap`.
pub(super) fn numbers(
    sketch: &mut Sketch,
    (measured, gap): ([f64; 2], f64),
    (n, down, off): (DVec2, DVec2, f64),
    at: impl Fn(f64, f64) -> DVec2,
) {
    let track = sketch.px(off);
    let ends = [("end.A", Side::A, n - down, -track), ("begin.B", Side::B, down - n, track)];
    let (texts, _) = terms(measured, gap);
    for (((key, side, beyond, out), along), text) in ends.into_iter().zip(measured).zip(texts) {
        let anchor = Anchor::point_toward(at(along, out), beyond);
        let label = Label::new(key, format!("${text}$"), anchor, side.into());
        sketch.label(label.rank(Rank::Measure).size(Size::Note));
    }
}

/// Draws the interval of a body, its shadow: a bar, and a mark where the shadow is a point, as that of a
/// segment along the light.
pub(super) fn shadow_of(sketch: &mut Sketch, body: Side, [lo, hi]: [DVec2; 2], role: Role) {
    sketch.part(part("interval", body)).bar(lo, hi, 0.0, Pen::highlighted(role));
    if sketch.on_page(lo.distance(hi)) < SHORT {
        let marker = if body == Side::A { Marker::Disc } else { Marker::Square };
        sketch.marker(lo, marker, role, SMALL_MARKER);
    }
}

/// Marks on the axis from where its numbers are counted, if that is in reach.
pub(super) fn zero(
    sketch: &mut Sketch,
    (first, last): (f64, f64),
    down: DVec2,
    at: impl Fn(f64, f64) -> DVec2,
) {
    if !(first..=last).contains(&0.0) {
        return;
    }
    let tick = sketch.px(ZERO);
    sketch.part("zero").line(at(0.0, -tick), at(0.0, tick), Pen::dimension(Role::Ink).width(1.5));
    let label = Label::new("zero", "$0$", Anchor::point_toward(at(0.0, tick), down), Role::Ink);
    sketch.label(label.rank(Rank::Measure).size(Size::Note));
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths, points};
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    #[test]
    fn light_falls_from_over_the_bodies_towards_their_shadows() {
        for light in [true, false] {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], position = [2, -1] }}
                 shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [8, 0] }}
                 query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }}
                 panels = [{{ view = [-1, -5, 12, 5],
                    layers = [{{ layer = 'projection', values = true, light = {light} }}] }}]"
            );
            let scene = open_text("light", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "light");
            assert_eq!(labels(&figure).contains_key("light"), light);
            let frame = &figure.panels[0].frame;
            // A shaft and its head for each of three.
            let arrows = paths(&figure.drawing.items, "light");
            assert_eq!(arrows.len(), if light { 6 } else { 0 });
            for shaft in arrows.iter().step_by(2) {
                let [from, to] = [points(shaft)[0], points(shaft)[1]];
                let [top, bottom] = [1.0, -2.0].map(|y| frame.page(DVec2::new(5.0, y)));
                assert!(from.x == to.x && from.y < to.y, "{from:?} to {to:?}");
                // Through the gap from 3 to 7 it falls past both bodies.
                let passes = (from.x - top.x).abs() < 1e-6;
                assert!(if passes { to.y > bottom.y } else { to.y < top.y }, "{from:?} to {to:?}, {top:?}");
            }
        }
    }
    #[test]
    fn the_shadow_of_a_segment_along_the_light_is_a_point_that_is_marked() {
        let marks = |end: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'capsule', points = [[-1, 0], {end}], radius = 0 }}
                 shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [0, 4] }}
                 query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }}
                 panels = [{{ layers = ['projection'] }}]"
            );
            let scene = open_text("shadow", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "shadow");
            paths(&figure.drawing.items, "interval-A").iter().filter(|path| path.fill.is_some()).count()
        };
        assert_eq!([marks("[1, 0]"), marks("[1, 0.5]")], [1, 0]);
    }
}
