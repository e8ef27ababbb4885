//! Why nothing touches before the bound of an advancement's first step: the most that the bodies can come
//! nearer over time, against the distance d that they have.
//!
//! ```text
//! t (v·n + r_A |ω_A| + r_B |ω_B|)             the most by the time t
//! ```
//!
//! At t = 1 the three lie on each other and are read off. Where their sum reaches d
//! lies the bound. How near the bodies come in fact is drawn under it, up to the hit. Source: Brian Mirtich,
//! *Impulse-based Dynamic Simulation of Rigid Body Systems*, 1996, 2.3.2.
//!
//! The chart fills its panel; its axes have scales of their own, so that it stands alone there.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, Marker, Outline, Pen, Rank, SMALL_MARKER, Size, Sketch, Wash, Weight,
};
use crate::figure::text::{Quantity, number, parts as written};
use crate::geometry::{DVec2, Enclosure, Side};
use crate::scene::When;
use crate::trace::{Event, phrase};

use super::chart::{Chart, separations};
use super::kinks;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Room around the chart, page pixels: left, right, below, above.
const ROOM: [f64; 4] = [62.0, 112.0, 36.0, 34.0];

/// The least distance of the bound and the hit along the axis of time for both to be written, page pixels.
const GAP: f64 = 48.0;

/// Opacity of what lies below the line of the fastest approach.
const FAINT: f64 = 0.07;

/// What one body's turning adds is not drawn where it is less than this part of the sum: no line is thinner.
const SEEN: f64 = 1e-3;

pub(super) const LAYER: Layer = Layer {
    name: "fastest-approach",
    in_words: phrase([
        "fastest-approach",
        "schnellste Annäherung",
        "approche la plus rapide",
        "acercamiento más rápido",
    ]),
    about: "the most that bodies can come nearer over time, by v·n and by turning, against their distance; \
            in a panel of its own",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "real",
            takes: Takes::Flag,
            default: "true",
            about: "how much nearer they come in fact, up to the hit",
        },
        OptionSpec {
            name: "kink",
            takes: Takes::Flag,
            default: "false",
            about: "marks the kinks of that curve, where another vertex becomes the nearest",
        },
    ],
    labels: &[
        LabelKey { key: "t", about: "the axis of time" },
        LabelKey { key: "nearer", about: "the axis of the distance closed" },
        LabelKey { key: "d", about: "the distance at the start" },
        LabelKey { key: "v.n", about: "what moving adds in a unit of time" },
        LabelKey { key: "r.A", about: "what turning of the first body adds" },
        LabelKey { key: "r.B", about: "what turning of the second body adds" },
        LabelKey { key: "unit", about: "the end of a unit of time" },
        LabelKey { key: "bound", about: "the time until which nothing can touch" },
        LabelKey { key: "left", about: "the distance that is left then in fact" },
        LabelKey { key: "hit", about: "the time of the hit" },
        LabelKey { key: "most", about: "the line of the fastest approach" },
        LabelKey { key: "sum", about: "the most in a unit of time" },
        LabelKey {
            key: "touch",
            about: "the end of that curve, with its time where the axis has no room for it",
        },
        LabelKey { key: "real", about: "the curve of how near they come in fact" },
        LabelKey { key: "kink", about: "the sharpest kink of that curve, with kink" },
    ],
    needs: "a first step of an advancement: a question for the first contact of bodies that are apart",
    fed: |context, options| match first(context) {
        Some(_) => kinks::fed(context, options, || apart(context, options)),
        None => Fed::by_the_answer(false, context.asks_for_a_hit()),
    },
    draw,
};

/// What the first step of an advancement knows.
#[derive(Clone, Copy)]
struct First {
    /// Distance of the bodies at t = 0.
    distance: f64,
    /// The closing speed v·n; negative where they move apart.
    closing: f64,
    /// The bound on the approach, `r_A |ω_A|` and `r_B |ω_B|` included.
    bound: f64,
    /// Until when nothing can touch, where the bound says it.
    until: Option<f64>,
}

/// The first step of an advancement from t = 0, whatever algorithm answers.
fn first(context: &Context) -> Option<First> {
    let first = context.first_step()?.find_told(|event| match *event {
        Event::Advanced { separation, closing_speed, bound, next, .. } => {
            Some(First { distance: separation, closing: closing_speed, bound, until: next })
        }
        _ => None,
    });
    first.filter(|first| first.distance > 0.0)
}

/// What is added to the approach in a unit of time.
struct Part {
    /// Key of its label.
    key: &'static str,
    /// What it is, in LaTeX.
    symbol: String,
    /// How much it is.
    value: f64,
    /// Its colour.
    role: Role,
}

/// v·n, `r_A |ω_A|` and `r_B |ω_B|`, those that are there: together the bound.
fn parts(context: &Context, first: &First) -> Vec<Part> {
    let arm = |side| {
        let body = context.body(side)?;
        let far = body.shape.vertices.iter().map(|v| v.length()).fold(0.0, f64::max);
        Some(far * body.spin.radians().abs())
    };
    let own = Side::BOTH.map(|side| arm(side).unwrap_or(0.0));
    let turning = first.bound - first.closing;
    let moving = Part { key: "v.n", symbol: r"v \cdot n".to_owned(), value: first.closing, role: Role::Ink };
    let mut parts = vec![moving];
    for (side, key) in [(Side::A, "r.A"), (Side::B, "r.B")] {
        let name = context.named(side);
        let symbol = format!(r"{}|{}|", name.below("r"), name.below(r"\omega"));
        let share = own[usize::from(side == Side::B)] / (own[0] + own[1]);
        let value = turning * share;
        if value > SEEN * first.bound.abs() {
            parts.push(Part { key, symbol, value, role: side.into() });
        }
    }
    parts
}

/// Whether the scene wants the curve of how near they come in fact.
fn is_real(options: &Options) -> bool {
    options.flag("real", true)
}

/// The separations of that curve, up to the hit.
fn apart(context: &Context, options: &Options) -> Vec<DVec2> {
    let until = context.hit_time().map_or(1.0, |hit| hit.lo);
    if is_real(options) { separations(context, until, &[]) } else { Vec::new() }
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(first) = first(context) else { return };
    let (hit, apart) = (context.hit_time(), apart(context, options));
    let real = is_real(options);
    let closed = |separation: f64| first.distance - separation;
    let nearer: Vec<DVec2> = apart.iter().map(|p| DVec2::new(p.x, closed(p.y))).collect();
    let parts = parts(context, &first);
    let values = [first.closing, first.bound, first.distance, 0.0].into_iter();
    let values = values.chain(nearer.iter().map(|p| p.y));
    let (least, most) = values.fold((0.0_f64, 0.0_f64), |(lo, hi), y| (lo.min(y), hi.max(y)));
    let chart = Chart::new(sketch, context, ROOM, (least, DVec2::new(1.0, most)));
    sketch.since(context.known(&When::Bound));
    wedges(sketch, &chart, &parts, &first);
    chart.axes(sketch.since(None), [("t", "$t$"), ("nearer", "distance closed by time $t$")]);
    level(sketch, context, &chart, &first);
    if real {
        fact(sketch.since(context.answered()), &chart, &nearer);
        if options.flag("kink", false) {
            kinks::mark(sketch, context, (&chart, closed), &apart);
        }
    }
    bound(sketch.since(context.known(&When::Bound)), &chart, &first, options.role(Role::Now));
    if real {
        left(sketch.since(context.answered()), context, &chart, &first);
    }
    if let (Some(hit), Some(end)) = (hit, nearer.last()) {
        touch(sketch.since(context.answered()), (&chart, *end), &first, hit);
    }
}

/// Draws the line of the fastest approach, and where a unit of time is over what is added, each part on the
/// one before, with its value.
fn wedges(sketch: &mut Sketch, chart: &Chart, parts: &[Part], first: &First) {
    let corner = chart.place(0.0, 0.0);
    let top = chart.place(1.0, first.bound);
    // One area: the seam between two would be taken for a curve.
    let most = Outline::polygon(&[corner, chart.place(1.0, 0.0), top]);
    sketch.part("wedge").weight(Weight::Background);
    sketch.area(&most, Some(Wash::faint(Role::Muted, FAINT)), None);
    let mut below = 0.0;
    let values: Vec<f64> = parts.iter().map(|part| part.value).collect();
    let (texts, sum) = written(&values, first.bound);
    for (part, text) in parts.iter().zip(texts) {
        let above = below + part.value;
        let [p, q] = [below, above].map(|y| chart.place(1.0, y));
        sketch.part("part").weight(Weight::Background).bar(p, q, 0.0, Pen::highlighted(part.role));
        let text = format!("${} = {text}$", part.symbol);
        let anchor = Anchor::point_toward(0.5 * (p + q), chart.vector(DVec2::X));
        sketch.label(Label::new(part.key, text, anchor, part.role));
        below = above;
    }
    let end = chart.place(1.0, 0.0);
    sketch.part("unit");
    chart.tick(sketch, 1.0, Role::Ink);
    let anchor = Anchor::point_toward(end, chart.vector(DVec2::NEG_Y));
    sketch.label(Label::new("unit", "$1$", anchor, Role::Ink));
    let anchor = Anchor::point_toward(top, chart.vector(DVec2::Y));
    sketch.part("sum").label(Label::new("sum", format!("${sum}$"), anchor, Role::Ink));
    sketch.part("most").weight(Weight::Background).line(corner, top, Pen::vector(Role::Ink));
    let label = Label::new("most", "at most", Anchor::middle(corner, top), Role::Ink);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Draws the distance of the start as a level that the approach has to reach.
fn level(sketch: &mut Sketch, context: &Context, chart: &Chart, first: &First) {
    let [from, to] = [0.0, 1.0].map(|time| chart.place(time, first.distance));
    sketch.since(context.first_step().and_then(|run| run.last_cue(|e| matches!(e, Event::Advanced { .. }))));
    let pen = Pen::dimension(Role::Translation).width(1.5);
    sketch.part("level").weight(Weight::Background).line(from, to, pen);
    let text = format!("$d = {}$", number(first.distance));
    let anchor = Anchor::point_toward(from, chart.vector(DVec2::NEG_X));
    sketch.label(Label::new("d", text, anchor, Role::Translation));
}

/// Draws how much nearer the bodies come in fact.
fn fact(sketch: &mut Sketch, chart: &Chart, nearer: &[DVec2]) {
    let curve: Vec<DVec2> = nearer.iter().map(|p| chart.place(p.x, p.y)).collect();
    let pen = Pen::dimension(Role::Ink).width(1.5);
    sketch.part("real").weight(Weight::Background).stroke(&Outline::polyline(&curve), pen);
    let Some(&at) = curve.get(curve.len() * 2 / 5) else { return };
    let anchor = Anchor::point_toward(at, chart.vector(DVec2::new(1.0, -1.0)));
    let label = Label::new("real", "in fact", anchor, Role::Ink);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Draws the time at which the most reaches the distance.
fn bound(sketch: &mut Sketch, chart: &Chart, first: &First, role: Role) {
    let Some(time) = first.until.filter(|time| *time <= 1.0) else { return };
    let (up, down) = (chart.place(time, first.distance), chart.place(time, 0.0));
    sketch.part("bound").weight(Weight::Background).line(up, down, Pen::dimension(role));
    chart.tick(sketch, time, role);
    sketch.marker(up, Marker::HollowDiamond, role, LARGE_MARKER);
    let anchor = Anchor::point_toward(down, chart.vector(DVec2::NEG_Y));
    sketch.label(Label::new("bound", format!("$t = {}$", number(time)), anchor, role));
}

/// Draws how much of the distance is left at the bound in fact, from the curve up to the level.
fn left(sketch: &mut Sketch, context: &Context, chart: &Chart, first: &First) {
    let Some(time) = first.until.filter(|time| *time <= 1.0) else { return };
    let Some(rest) = context.separation_at(time).and_then(|run| Some(run.separation()?.separation)) else {
        return;
    };
    let [up, down] = [0.0, rest].map(|below| chart.place(time, first.distance - below));
    if !sketch.is_legible((up - down).length()) {
        return;
    }
    sketch.part("left").weight(Weight::Background).line(up, down, Pen::highlighted(Role::Translation));
    let text = format!("${}$ left", number(rest));
    let anchor = Anchor::point_toward(0.5 * (up + down), chart.vector(DVec2::X));
    let label = Label::new("left", text, anchor, Role::Translation);
    sketch.label(label.rank(Rank::Measure).size(Size::Note));
}

/// Draws the end of the curve over the mark of the bound, beside which it may lie, and its time: on the axis,
/// or where the bound's stands too near, at the end of the curve.
fn touch(sketch: &mut Sketch, (chart, end): (&Chart, DVec2), first: &First, hit: Enclosure) {
    let time = Quantity::within(hit).latex();
    let bound = chart.along(sketch, first.until.unwrap_or(0.0));
    let on_axis = chart.along(sketch, hit.lo) - bound >= sketch.fitted(GAP);
    if on_axis {
        let [up, down] = [first.distance, 0.0].map(|y| chart.place(hit.lo, y));
        sketch.part("hit").weight(Weight::Background).line(up, down, Pen::extension());
        chart.tick(sketch, hit.lo, Role::Ink);
        let anchor = Anchor::point_toward(down, chart.vector(DVec2::NEG_Y));
        sketch.label(Label::new("hit", format!("${time}$"), anchor, Role::Ink));
    }
    let end = chart.place(end.x, end.y);
    sketch.part("touch").weight(Weight::Background).marker(end, Marker::Disc, Role::Ink, SMALL_MARKER);
    let lines = std::iter::once("touch".to_owned()).chain((!on_axis).then(|| format!("$t = {time}$")));
    let anchor = Anchor::point_toward(end, chart.vector(DVec2::new(1.0, -1.0)));
    let rank = if on_axis { Rank::Word } else { Rank::Measure };
    let label = Label::new("touch", "", anchor, Role::Ink);
    sketch.label(Label { lines: lines.collect(), ..label }.rank(rank).size(Size::Note));
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Item, Point};
    use crate::figure::layer::tests::{labels, paths, points};
    use crate::figure::{Figure, draw, plan};
    use crate::scene::open_text;

    /// A bar that turns towards a box 4 away at the speed `v`: 2 · 1.5 and √2 · 0.5 are added.
    fn chart(v: f64, algorithm: &str) -> Result<Figure, String> {
        let text = format!(
            "shapes.A = {{ kind = 'capsule', points = [[-2, 0], [1, 0]], radius = 0, velocity = [{v}, 1],
                angular_velocity_rad = 1.5 }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [6, 0],
                angular_velocity_rad = -0.5 }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = '{algorithm}' }}
            panels = [{{ view = [0, 0, 4, 3], layers = ['fastest-approach'] }}]"
        );
        let scene = open_text("chart", &text).unwrap().scene;
        let plan = plan(&scene).map_err(|problems| format!("{problems:?}"))?;
        Ok(draw(&plan, plan.theme, "chart"))
    }

    /// The points of the first path of a part.
    fn first_of(figure: &Figure, part: &str) -> Vec<Point> {
        points(paths(&figure.drawing.items, part)[0])
    }

    #[test]
    fn the_parts_add_up_and_the_bound_lies_where_they_reach_the_distance() {
        for algorithm in ["conservative-advancement", "swept-axis"] {
            let figure = chart(6.0, algorithm).unwrap();
            let said = labels(&figure);
            let sum = 6.0 + 3.0 + 0.5 * f64::sqrt(2.0);
            let numbers = [("v.n", 6.0), ("r.A", 3.0), ("r.B", 0.707), ("d", 4.0), ("bound", 0.412)];
            for (key, number) in numbers {
                assert_eq!(said[key].1, number, "{algorithm}: {key}");
            }
            let most = first_of(&figure, "most");
            let bars: Vec<_> = paths(&figure.drawing.items, "part").into_iter().map(points).collect();
            let height = |bar: &[Point]| (bar[0].y - bar[1].y).abs() / (most[0].y - most[1].y);
            // A bar is a line and its two ticks.
            let heights: Vec<f64> = bars.chunks(3).map(|bar| height(&bar[0])).collect();
            for (height, part) in heights.iter().zip([6.0, 3.0, 0.5 * f64::sqrt(2.0)]) {
                assert!((height - part / sum).abs() < 1e-9, "{heights:?}");
            }
            let bound = first_of(&figure, "bound");
            let level = first_of(&figure, "level");
            let share = (bound[0].x - most[0].x) / (most[1].x - most[0].x);
            assert!((share - 4.0 / sum).abs() < 1e-9 && (bound[0].y - level[0].y).abs() < 1e-9);
            let on_line = most[0].y + share * (most[1].y - most[0].y);
            assert!((on_line - level[0].y).abs() < 1e-6, "the line is at {on_line} there, not at {level:?}");
        }
    }

    #[test]
    fn the_bodies_never_come_nearer_than_at_most() {
        let figure = chart(6.0, "swept-axis").unwrap();
        let (most, real) = (first_of(&figure, "most"), first_of(&figure, "real"));
        assert!(real.len() > 10);
        for p in &real {
            let share = (p.x - most[0].x) / (most[1].x - most[0].x);
            let line = most[0].y + share * (most[1].y - most[0].y);
            // On the page y is down.
            assert!(p.y >= line - 1e-6, "{p:?} is above the line");
        }
        let (end, level) = (real[real.len() - 1], first_of(&figure, "level")[0]);
        assert!((end.y - level.y).abs() < 1e-3, "at the hit the whole distance is used up");
        let mark = paths(&figure.drawing.items, "touch")[0].contour.bounds().unwrap();
        assert!((0.5 * (mark.x0 + mark.x1) - end.x).abs() < 1e-9, "its end is marked");
    }

    #[test]
    fn the_touch_has_its_time_on_the_axis_or_where_the_bounds_stands_too_near_at_its_mark() {
        for (v, beside) in [(6.0, false), (60.0, true)] {
            let figure = chart(v, "swept-axis").unwrap();
            let said = labels(&figure);
            assert_eq!(said.contains_key("hit"), !beside, "{v}: {said:?}");
            let (words, time) = &said["touch"];
            assert_eq!(words.starts_with("touch $t ="), beside, "{words}");
            let parts: Vec<String> = figure.drawing.items.iter().flat_map(part_names).collect();
            let at = |part: &str| parts.iter().rposition(|name| name == part);
            assert!(at("touch") > at("bound"), "the mark of the touch is over that of the bound: {parts:?}");
            assert!(!beside || *time > said["bound"].1, "{time} {:?}", said["bound"]);
        }
    }

    /// The names of the groups in an item, in the order of drawing.
    fn part_names(item: &Item) -> Vec<String> {
        let Item::Group(group) = item else { return Vec::new() };
        std::iter::once(group.name.clone()).chain(group.items.iter().flat_map(part_names)).collect()
    }

    #[test]
    fn bodies_that_move_apart_take_from_what_turning_adds() {
        let figure = chart(-6.0, "conservative-advancement").unwrap();
        let said = labels(&figure);
        assert_eq!([said["v.n"].1, said["r.A"].1], [-6.0, 3.0]);
        assert!(!said.contains_key("bound"), "no time is proved free by a bound that is not positive");
    }
}
