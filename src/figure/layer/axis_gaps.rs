//! AABB against AABB, axis by axis: D = |`c_B` − `c_A`| − (`h_A` + `h_B`) laid out on tracks below (x) and to
//! the right (y).
//!
//! Where D ≥ 0 one track holds `h_A` | D | `h_B` end to end. Where D < 0 the half-extents overlap: they lie
//! on two lanes side by side, and D on a third, thin. Either stretch is a strip across both boxes, which
//! ends at the third lane; beside an axis with a gap, one that overlaps decides nothing, and its strip is
//! grey. The distance of the centres is the last.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Outline, Pen, Sketch, Wash, Weight};
use crate::figure::text::{Quantity, whole_and_parts};
use crate::geometry::{DVec2, Side};
use crate::trace::{Event, phrase};

use super::half_extents::{GUIDE, beside};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Distance of the tracks below from the boxes and from each other, page pixels: a label of 16 fits between.
const BELOW: f64 = 40.0;

/// Distance of the tracks to the right from the boxes, page pixels: clear of their outlines.
const BESIDE: f64 = 30.0;

/// How much of a panel's width the tracks to the right take at most: in a narrow panel they lie closer, and
/// the boxes keep their room.
const SHARE: f64 = 0.4;

/// From one lane to the next, page pixels: bars side by side, and not one.
const LANE: f64 = 26.0;

/// Opacity of the strip between boxes that are apart along an axis, or of what they share of it.
const LIT: f64 = 0.13;

/// Where the distance of the centres is measured to the right, as a part of the way to the first track:
/// beyond the label of D where the half-extents overlap, else beyond theirs.
const LAST: [f64; 2] = [6.1, 4.6];

pub(super) const LAYER: Layer = Layer {
    name: "axis-gaps",
    in_words: phrase([
        "axis-gaps",
        "Lücken entlang der Achsen",
        "écarts selon les axes",
        "huecos según los ejes",
    ]),
    about: "half-extents, centre distance and gap of two AABBs, axis by axis",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[OptionSpec {
        name: "axes",
        takes: Takes::Words(&["x", "y"]),
        default: "both",
        about: "which axes",
    }],
    labels: &[
        LabelKey { key: "h.A.x", about: "half the width of A" },
        LabelKey { key: "h.B.x", about: "half the width of B" },
        LabelKey { key: "D.x", about: "gap along x, negative where the boxes overlap" },
        LabelKey { key: "centers.x", about: "distance of the centres along x" },
        LabelKey { key: "h.A.y", about: "half the height of A" },
        LabelKey { key: "h.B.y", about: "half the height of B" },
        LabelKey { key: "D.y", about: "gap along y, negative where the boxes overlap" },
        LabelKey { key: "centers.y", about: "distance of the centres along y" },
    ],
    needs: "the algorithm \"extents\": two AABBs",
    fed: |context, _| Fed::by_the_scene(compared(context).is_some()),
    draw,
};

/// What the algorithm compared along one axis, in world units.
#[derive(Clone, Copy)]
struct Extents {
    /// The axis: `x` or `y`.
    name: char,
    /// Coordinates of the centres of A and B.
    centers: [f64; 2],
    /// Half-extents of A and B.
    half: [f64; 2],
    /// D, negative where the boxes overlap.
    gap: f64,
    /// Colour of D: muted where the boxes overlap along this axis and are apart along the other.
    role: Role,
}

/// A length on a track beside the boxes.
struct Bar {
    /// Key of its label.
    key: &'static str,
    /// Text of its label, markup.
    text: String,
    /// The coordinates that it lies between.
    ends: [f64; 2],
    /// How far from the boxes it lies, as a part of the way to the first track.
    track: f64,
    /// How it is drawn.
    pen: Pen,
    /// The colour of its label.
    role: Role,
    /// Where the label stands.
    beside: Beside,
}

/// Where the label of a bar stands.
#[derive(Clone, Copy, PartialEq)]
enum Beside {
    /// On the side of the boxes.
    Inward,
    /// On the side away from the boxes.
    Outward,
    /// Beyond the bar's first end.
    First,
    /// Beyond the bar's last end.
    Last,
    /// On the side away from the boxes, beside this part alone.
    Part([f64; 2]),
}

/// Where the tracks of an axis lie in the world.
struct Place {
    /// Where the tracks begin, across the axis.
    edge: f64,
    /// From one track to the next, across the axis.
    step: f64,
    /// The axis: `x` or `y`.
    axis: char,
}

impl Place {
    /// The track that a coordinate across the axis is on, as a part of the way to the first.
    fn track(&self, across: f64) -> f64 {
        (across - self.edge) / self.step
    }

    /// The point of a track at a coordinate.
    fn point(&self, along: f64, track: f64) -> DVec2 {
        let across = self.edge + self.step * track;
        if self.axis == 'x' { DVec2::new(along, across) } else { DVec2::new(across, along) }
    }
}

/// Centres, half-extents and D, in world units, as the algorithm compared them.
fn compared(context: &Context) -> Option<([DVec2; 2], [DVec2; 2], DVec2)> {
    context.run().find_told(|event| match *event {
        Event::ExtentsCompared { centers, half_extents, gap } => Some((centers, half_extents, gap)),
        _ => None,
    })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((c, h, gap)) = compared(context) else { return };
    sketch.since(context.cue(|event| matches!(event, Event::ExtentsCompared { .. })));
    let role = |d: f64| if d < 0.0 && gap.max_element() > 0.0 { Role::Muted } else { Role::Now };
    if options.shows("axes", "x", true) {
        let (centers, half) = ([c[0].x, c[1].x], [h[0].x, h[1].x]);
        let extents = Extents { name: 'x', centers, half, gap: gap.x, role: role(gap.x) };
        let bottom = (c[0].y - h[0].y).min(c[1].y - h[1].y);
        axis(
            sketch,
            (context, options),
            extents,
            &Place { edge: bottom, step: -sketch.px(BELOW), axis: 'x' },
            [0, 1].map(|k| [c[k].y, c[k].y - h[k].y]),
        );
    }
    if options.shows("axes", "y", true) {
        let (centers, half) = ([c[0].y, c[1].y], [h[0].y, h[1].y]);
        let extents = Extents { name: 'y', centers, half, gap: gap.y, role: role(gap.y) };
        let right = (c[0].x + h[0].x).max(c[1].x + h[1].x);
        let (lo, hi) = sketch.visible();
        let step = sketch.px(BESIDE).min(SHARE * (hi.x - lo.x) / LAST[0]);
        axis(
            sketch,
            (context, options),
            extents,
            &Place { edge: right, step, axis: 'y' },
            [0, 1].map(|k| [c[k].x, c[k].x + h[k].x]),
        );
    }
}

/// Draws the tracks of one axis; `across` are the other coordinates of each box's centre, and of its edge
/// towards the tracks.
fn axis(
    sketch: &mut Sketch,
    (context, options): (&Context, &Options),
    e: Extents,
    place: &Place,
    across: [[f64; 2]; 2],
) {
    let bars = bars(context, options, e);
    let forward = if e.centers[0] <= e.centers[1] { 1.0 } else { -1.0 };
    let facing = [e.centers[0] + forward * e.half[0], e.centers[1] - forward * e.half[1]];
    let part = format!("axis-{}", e.name);
    let is_lit = e.gap != 0.0;
    if is_lit {
        strip(sketch, (&e, facing), place, across);
    }
    let guide = Pen::extension().opacity(GUIDE);
    // The edges that face each other are those of the strip, if there is one.
    let guided = if is_lit { 1 } else { 2 };
    for body in [0, 1] {
        for along in [e.centers[body], facing[body]].into_iter().take(guided) {
            let reach = |b: &&Bar| b.ends.contains(&along);
            let last = bars.iter().filter(reach).map(|b| b.track).fold(1.0, f64::max);
            let other = 1 - body;
            let is_hidden = (along - e.centers[other]).abs() < e.half[other];
            let hidden = is_hidden.then(|| across[other].map(|x| place.track(x)));
            for [from, to] in beside_body([place.track(across[body][1]), last], hidden) {
                let [from, to] = [from, to].map(|track| place.point(along, track));
                sketch.part(&part).weight(Weight::Light).line(from, to, guide);
            }
        }
    }
    for bar in bars {
        let [p, q] = bar.ends.map(|end| place.point(end, bar.track));
        sketch.part(&part).bar(p, q, 0.0, bar.pen);
        // A part of its own, as a label beyond a bar's end must not lie on the bar.
        sketch.part("label");
        let out = place.point(0.0, 1.0) - place.point(0.0, 0.0);
        let anchor = match bar.beside {
            Beside::Inward => beside(p, q, -out),
            Beside::Outward => beside(p, q, out),
            Beside::First => Anchor::point_toward(p, p - q),
            Beside::Last => Anchor::point_toward(q, q - p),
            Beside::Part(ends) => {
                let [p, q] = ends.map(|end| place.point(end, bar.track));
                beside(p, q, out)
            }
        };
        sketch.label(Label::new(bar.key, bar.text, anchor, bar.role));
    }
}

/// The parts of a guide between two tracks that lie on no body, given the tracks of the body's centre and of
/// its edge towards the tracks: a hairline on a body would look like a part of it.
fn beside_body([from, to]: [f64; 2], body: Option<[f64; 2]>) -> Vec<[f64; 2]> {
    let Some([center, edge]) = body else { return vec![[from, to]] };
    let far = 2.0 * center - edge;
    [[from, far.min(to)], [edge.max(from), to]].into_iter().filter(|[from, to]| from < to).collect()
}

/// Draws the strip between the edges that face each other, from the track of D to the far edge of the boxes.
fn strip(sketch: &mut Sketch, (e, facing): (&Extents, [f64; 2]), place: &Place, across: [[f64; 2]; 2]) {
    let far = across.map(|[center, edge]| place.track(2.0 * center - edge));
    let far = far[0].min(far[1]);
    let near = if e.gap < 0.0 { lane(e.name, 2.0) } else { 1.0 };
    let ends = [(facing[0], near), (facing[1], near), (facing[1], far), (facing[0], far)];
    let strip = Outline::polygon(&ends.map(|(along, track)| place.point(along, track)));
    sketch.part("lit").weight(Weight::Light).area(&strip, Some(Wash::faint(e.role, LIT)), None);
}

/// The track of a lane, `n` lanes after the first, as a part of the way to the first track.
fn lane(axis: char, n: f64) -> f64 {
    1.0 + n * LANE / if axis == 'x' { BELOW } else { BESIDE }
}

/// `h_A`, D, `h_B` and the distance of the centres along one axis, each with its track.
fn bars(context: &Context, options: &Options, e: Extents) -> Vec<Bar> {
    use Beside::{First, Inward, Last, Outward, Part};
    let forward = if e.centers[0] <= e.centers[1] { 1.0 } else { -1.0 };
    let [a, b] = e.centers;
    let facing = [a + forward * e.half[0], b - forward * e.half[1]];
    let name = e.name;
    let keys = if name == 'x' {
        ["h.A.x", "D.x", "h.B.x", "centers.x"]
    } else {
        ["h.A.y", "D.y", "h.B.y", "centers.y"]
    };
    let half = Side::BOTH.map(|side| Pen::highlighted(options.role(side.into())));
    let [h, k] = Side::BOTH.map(|side| format!("h_{{{},{name}}}", context.named(side).script()));
    let [c, d] = Side::BOTH.map(|side| context.named(side).below("c"));
    let symbols = [h, format!("D_{name}"), k, format!("|{d} - {c}|_{name}")];
    let lengths = [e.half[0], e.gap, e.half[1], (b - a).abs()];
    let ends = [[a, facing[0]], facing, [facing[1], b], [a, b]];
    let [second, third] = [1.0, 2.0].map(|n| lane(name, n));
    // Beside the stretch that they share stands D, so each half-extent is named beside the rest of it, or
    // where there is none beyond the end that the other one does not reach.
    let rest =
        |[from, to]: [f64; 2], beyond| if forward * (to - from) > 0.0 { Part([from, to]) } else { beyond };
    let own = [rest([a, facing[1]], Last), rest([facing[0], b], First)];
    let (tracks, places) = match (e.gap < 0.0, name) {
        (true, 'x') => ([1.0, third, second, third + 1.0], [First, Outward, Last, Outward]),
        (true, _) => ([1.0, third, second, LAST[0]], [own[0], Outward, own[1], Outward]),
        (false, 'x') => ([1.0, 1.0, 1.0, 2.0], [Inward, Inward, Inward, Outward]),
        (false, _) => ([1.0, 1.0, 1.0, LAST[1]], [Outward; 4]),
    };
    let between = if e.gap < 0.0 { Pen::dimension(e.role) } else { Pen::highlighted(e.role) };
    let pens = [half[0], between, half[1], Pen::dimension(Role::Ink)];
    let roles = [half[0].role, e.role, half[1].role, Role::Ink];
    let rounding = context.scene.query_at(context.time).rounding();
    // What the half-extents leave of the distance of the centres is D.
    let texts = whole_and_parts(lengths[3], &[lengths[0], lengths[2]], e.gap);
    let summed = [texts.get(1), None, texts.get(2), texts.first()];
    let written = |i: usize| match (summed[i], Quantity::exactly(lengths[i]).equals(rounding)) {
        (Some(text), equals) if equals.starts_with('=') => format!("= {text}"),
        (_, equals) => equals,
    };
    let bar = |i: usize| {
        let text = format!("${} {}$", symbols[i], written(i));
        let (pen, role, beside) = (pens[i], roles[i], places[i]);
        Bar { key: keys[i], text, ends: ends[i], track: tracks[i], pen, role, beside }
    };
    (0..keys.len()).map(bar).collect()
}

#[cfg(test)]
mod tests {
    use super::{LANE, beside_body};
    use crate::drawing::Point;
    use crate::figure::layer::tests::{labels, paths, points};
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    #[test]
    fn a_guide_is_drawn_beside_a_body_and_not_on_it() {
        assert_eq!(beside_body([-3.0, 2.0], None), [[-3.0, 2.0]]);
        assert_eq!(beside_body([-3.0, 2.0], Some([-1.0, 0.0])), [[-3.0, -2.0], [0.0, 2.0]]);
        // A body that begins before the guide does leaves the part behind it alone.
        assert_eq!(beside_body([-1.0, 2.0], Some([-1.0, 0.0])), [[0.0, 2.0]]);
    }

    #[test]
    fn half_extents_that_reach_beyond_each_other_s_centres_are_named_at_their_own_bars() {
        let text = "shapes.A = { kind = 'aabb', half_extents = [3, 2] }
             shapes.B = { kind = 'aabb', half_extents = [1.5, 2.5], position = [3.8, 1.2] }
             query = { kind = 'overlap', of = ['A', 'B'], algorithm = 'extents' }
             panels = [{ layers = ['shapes', { layer = 'axis-gaps', axes = ['y'] }] }]";
        let scene = open_text("deep.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "deep");
        let lines = paths(&figure.drawing.items, "axis-y").into_iter().map(points);
        let bars: Vec<Vec<Point>> =
            lines.filter(|p| p.len() == 2 && p[0].x == p[1].x && (p[1] - p[0]).length() > 9.0).collect();
        // From the label to the middle of the bar that is its own, and of the other.
        let away = |key: &str, bar: &[Point]| {
            let label = figure.panels[0].placed.iter().find(|label| label.key == key).unwrap();
            let [p, q] = [bar[0], bar[1]];
            let y = label.bounds.center().y.clamp(p.y.min(q.y), p.y.max(q.y));
            (label.bounds.center() - Point::new(p.x, y)).length()
        };
        for (key, own, other) in [("h.A.y", &bars[0], &bars[2]), ("h.B.y", &bars[2], &bars[0])] {
            let (near, far) = (away(key, own), away(key, other));
            assert!(near < far, "{key}: {near} from its own, {far} from the other");
        }
    }

    #[test]
    fn half_extents_that_overlap_lie_side_by_side_and_what_is_negative_beside_them() {
        let text = "shapes.A = { kind = 'aabb', half_extents = [2, 1] }
             shapes.B = { kind = 'aabb', half_extents = [1, 2], position = [2.5, 4] }
             query = { kind = 'separation', of = ['A', 'B'], algorithm = 'extents' }
             panels = [{ layers = ['shapes', 'axis-gaps'] }]";
        let scene = open_text("marks.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        let labels = labels(&figure);
        assert_eq!((labels["D.x"].1, labels["D.y"].1), (-0.5, 1.0));
        let bars = |part| -> Vec<[Point; 2]> {
            let whole = paths(&figure.drawing.items, part).into_iter().map(points);
            whole.filter(|p| p.len() == 2 && (p[1] - p[0]).length() > 9.0).map(|p| [p[0], p[1]]).collect()
        };
        let level: Vec<[Point; 2]> = bars("axis-x").into_iter().filter(|[p, q]| p.y == q.y).collect();
        // Half of A, what is shared and half of B on lanes of their own, then the distance of the centres.
        let lanes: Vec<f64> = level.iter().map(|[p, _]| (p.y - level[0][0].y) / LANE).collect();
        assert!(lanes.len() == 4 && lanes[3] > 3.0, "{lanes:?}");
        assert!((lanes[1] - 2.0).abs() < 1e-9 && (lanes[2] - 1.0).abs() < 1e-9, "{lanes:?}");
        let frame = &figure.panels[0].frame;
        // Along y they are apart: from A's top, 1, to B's bottom, 2, over the width of both. What they share
        // of x decides nothing, and its strip is over both all the same.
        let strips = paths(&figure.drawing.items, "lit");
        assert_eq!(strips.len(), 2);
        let shared = points(strips[0]);
        // From 1.5 to 2 of x they share.
        for place in [[1.5, 6.0], [2.0, 6.0]].map(|p| frame.page(DVec2::from(p))) {
            assert!(shared.iter().any(|p| (*p - place).length() < 1e-6), "{place:?}: {shared:?}");
        }
        let strip = points(strips[1]);
        for place in [[-2.0, 1.0], [-2.0, 2.0]].map(|p| frame.page(DVec2::from(p))) {
            assert!(strip.iter().any(|p| (*p - place).length() < 1e-6), "{place:?}: {strip:?}");
        }
        let upright: Vec<f64> = bars("axis-y").iter().filter(|[p, q]| p.x == q.x).map(|[p, _]| p.x).collect();
        assert!(upright.len() == 4 && upright[0] == upright[1] && upright[1] == upright[2], "{upright:?}");
    }
}
