//! The two coordinate axes through the origin of the panel's space, as far as the panel shows; with `ticks`,
//! numbers at round steps along its lower and left edge, outside of what the picture is about.

use crate::drawing::{Point, Rect};
use crate::figure::context::Context;
use crate::figure::sketch::{Pen, Sketch, Weight, Words};
use crate::figure::text::Decimal;
use crate::geometry::DVec2;
use crate::trace::phrase;

use super::grid::{Mark, STEP, marks};
use super::ruler::Ruler;
use super::{Fed, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Length of the tick at a number, page pixels.
const TICK: f64 = 4.0;
/// Room between a tick and its number, and between the panel's edge and the number, page pixels.
const GAP: f64 = 2.0;
/// Room between two numbers of one axis, page pixels: at less, 1 and 2 read as 12.
const ROOM: f64 = 10.0;

pub(super) const LAYER: Layer = Layer {
    name: "axes",
    in_words: phrase(["axes", "Achsen", "axes", "ejes"]),
    about: "the coordinate axes of the panel's space, through its origin",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[
        OptionSpec {
            name: "ticks",
            takes: Takes::Flag,
            default: "false",
            about: "numbers at round steps, along the panel's lower and left edge",
        },
        OptionSpec { about: "from one tick to the next, units of the panel's space", ..STEP },
        OptionSpec {
            name: "lines",
            takes: Takes::Flag,
            default: "true",
            about: "false: the numbers alone, where a grid is enough",
        },
    ],
    labels: &[],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let at = |x, y| {
        let p = DVec2::new(x, y);
        context.frame().map_or(p, |frame| frame.point(p))
    };
    let pen = Pen { role: options.role(Pen::axis().role), ..Pen::axis() };
    let (mut lo, hi) = sketch.visible();
    let seen = lo.cmple(DVec2::ZERO) & hi.cmpge(DVec2::ZERO);
    if options.flag("ticks", false) && sketch.has_numbers() {
        // An axis that ran through a number would be its minus sign.
        let reach = ticks(sketch, context, options, pen);
        lo += reach / sketch.on_page(1.0);
        sketch.set_aside([reach.x, reach.y]);
    }
    if !(options.flag("lines", true) && sketch.has_axes()) {
        return;
    }
    sketch.part("x-axis").weight(Weight::Background);
    if seen.y {
        sketch.line(at(lo.x, 0.0), at(hi.x, 0.0), pen);
    }
    sketch.part("y-axis").weight(Weight::Background);
    if seen.x {
        sketch.line(at(0.0, lo.y), at(0.0, hi.y), pen);
    }
}

/// Writes the numbers, and says how far they reach from the panel's left and lower edge, page pixels.
fn ticks(sketch: &mut Sketch, context: &Context, options: &Options, pen: Pen) -> DVec2 {
    let [x, y] = marks(sketch, context, options);
    let panel = sketch.panel();
    let decimal = Decimal::of(context.scene);
    let scale = |ruler, marks| Scale { ruler, marks, decimal };
    let row = x.and_then(|(ruler, marks)| lower(sketch, pen, &scale(ruler, marks)));
    let column = y.and_then(|(ruler, marks)| left(sketch, pen, &scale(ruler, marks), row));
    let reach = |end: Option<f64>| end.map_or(0.0, |end| end + GAP);
    DVec2::new(reach(column.map(|c| c.x1 - panel.x0)), reach(row.map(|r| panel.y1 - r.y0)))
}

/// What the numbers of an axis are.
struct Scale {
    /// The values of the marks.
    ruler: Ruler,
    /// The marks in view.
    marks: Vec<Mark>,
    /// The sign between the whole and the rest of a number.
    decimal: Decimal,
}

/// A number at its place.
struct Number {
    /// The number, set in type.
    line: Words,
    /// Where its baseline begins on the page.
    origin: Point,
    /// Its mark on the page along the axis, page pixels; none for what all numbers share.
    mark: Option<f64>,
}

impl Number {
    /// Its box on the page, page pixels.
    fn bounds(&self) -> Rect {
        let (p, line) = (self.origin, &self.line);
        Rect { x0: p.x, y0: p.y - line.ascent, x1: p.x + line.width, y1: p.y + line.descent }
    }
}

/// Writes the numbers of the x-axis along the panel's lower edge, and says where.
fn lower(sketch: &mut Sketch, pen: Pen, scale: &Scale) -> Option<Rect> {
    let panel = sketch.panel();
    let lines = set(sketch, scale);
    let descent = lines.iter().map(|(_, line)| line.descent).fold(0.0, f64::max);
    let ascent = lines.iter().map(|(_, line)| line.ascent).fold(0.0, f64::max);
    let wide = lines.iter().map(|(_, line)| line.width).fold(0.0, f64::max);
    let baseline = panel.y1 - GAP - descent;
    let mut numbers = shared(sketch, scale, |line| Point::new(panel.x1 - line.width, baseline));
    for (mark, line) in thinned(lines, &scale.marks, wide + ROOM) {
        let origin = Point::new(mark.place - 0.5 * line.width, baseline);
        numbers.push(Number { line, origin, mark: Some(mark.place) });
    }
    let top = baseline - ascent - GAP;
    let tick = |x: f64| (Point::new(x, top), Point::new(x, top - TICK));
    write(sketch.part("x-numbers"), pen, numbers, None, tick)
}

/// Writes the numbers of the y-axis along the panel's left edge, but over the `row` of the x-axis, and says
/// where.
fn left(sketch: &mut Sketch, pen: Pen, scale: &Scale, row: Option<Rect>) -> Option<Rect> {
    let panel = sketch.panel();
    let lines = set(sketch, scale);
    let wide = lines.iter().map(|(_, line)| line.width).fold(0.0, f64::max);
    let high = lines.iter().map(|(_, line)| line.ascent + line.descent).fold(0.0, f64::max);
    let mut numbers = shared(sketch, scale, |line| Point::new(panel.x0 + GAP, panel.y0 + GAP + line.ascent));
    for (mark, line) in thinned(lines, &scale.marks, high + 0.6 * ROOM) {
        let y = mark.place + 0.5 * (line.ascent - line.descent);
        let origin = Point::new(panel.x0 + GAP + wide - line.width, y);
        numbers.push(Number { line, origin, mark: Some(mark.place) });
    }
    let from = panel.x0 + wide + 2.0 * GAP;
    let tick = |y: f64| (Point::new(from, y), Point::new(from + TICK, y));
    let row = row.map(|row| Rect { x0: panel.x0, x1: panel.x1, ..row });
    write(sketch.part("y-numbers"), pen, numbers, row, tick)
}

/// What all numbers share, at its place, where they share something.
fn shared(sketch: &Sketch, scale: &Scale, origin: impl Fn(&Words) -> Point) -> Vec<Number> {
    let line = scale.ruler.shared().text().and_then(|text| sketch.set(&scale.decimal.in_formulas(&text)));
    line.map(|line| Number { origin: origin(&line), line, mark: None }).into_iter().collect()
}

/// The numbers of marks, set in type.
fn set(sketch: &Sketch, Scale { ruler, marks, decimal }: &Scale) -> Vec<(usize, Words)> {
    let shared = ruler.shared();
    let text = |mark: &Mark| ruler.text(mark.value, shared).map(|text| decimal.in_number(text));
    let line = |(i, mark): (usize, &Mark)| Some((i, sketch.set(&text(mark)?)?));
    marks.iter().enumerate().filter_map(line).collect()
}

/// Numbers that stand `room` page pixels apart: all, or those of every second, fifth, tenth … mark, 0 among
/// them.
fn thinned(lines: Vec<(usize, Words)>, marks: &[Mark], room: f64) -> impl Iterator<Item = (Mark, Words)> {
    let gap =
        marks.windows(2).map(|pair| (pair[1].place - pair[0].place).abs()).fold(f64::INFINITY, f64::min);
    let every =
        std::iter::successors(Some(10.0), |e| Some(10.0 * e)).flat_map(|e| [0.1 * e, 0.2 * e, 0.5 * e]);
    let every = every.take(30).find(|e| e * gap >= room).unwrap_or(f64::INFINITY);
    let chosen = move |mark: &Mark| mark.number % every == 0.0;
    let marks = marks.to_vec();
    lines
        .into_iter()
        .filter_map(move |(i, line)| Some((*marks.get(i)?, line)))
        .filter(move |(m, _)| chosen(m))
}

/// Writes numbers that are whole in the panel and over nothing that is written, each with its tick, and says
/// where they stand.
fn write(
    sketch: &mut Sketch,
    pen: Pen,
    numbers: Vec<Number>,
    taken: Option<Rect>,
    tick: impl Fn(f64) -> (Point, Point),
) -> Option<Rect> {
    let panel = sketch.panel();
    let mut written: Vec<Rect> = Vec::new();
    let mut ticks = Vec::new();
    for number in numbers {
        let bounds = number.bounds();
        let free = |other: &Rect| bounds.grown(0.5 * ROOM).intersection(*other).is_none();
        if written.iter().chain(&taken).all(free) && panel.union(bounds) == panel {
            ticks.extend(number.mark.map(&tick));
            written.push(bounds);
            sketch.write(&number.line, number.origin, pen.role);
        }
    }
    // A line of the grid leads to its number already; the tick would be a dash beside it.
    if !sketch.has_layer("grid") {
        sketch.quiet_lines(&ticks, pen);
    }
    written.into_iter().reduce(Rect::union)
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn where_a_grid_leads_to_the_numbers_they_have_no_ticks() {
        for (before, ticks) in [("", 1), ("'grid', ", 0)] {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 4 }}
                query = {{ kind = 'bounds', of = ['A'] }}
                panels = [{{ layers = [{before}{{ layer = 'axes', ticks = true, lines = false }}] }}]"
            );
            let scene = open_text("axes", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let items = draw(&plan, plan.theme, "axes").drawing.items;
            // All ticks of an axis are one stroke, and letters are filled.
            let strokes = paths(&items, "x-numbers").into_iter().filter(|path| path.stroke.is_some());
            assert_eq!(strokes.count(), ticks, "{before}");
        }
    }

    #[test]
    fn an_axis_begins_beyond_the_numbers_on_a_page_of_any_size() {
        for width in [300, 500, 960] {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 2 }}
                query = {{ kind = 'bounds', of = ['A'] }}
                canvas = {{ width = {width}, height = {width} }}
                panels = [{{ layers = ['shapes', {{ layer = 'axes', ticks = true }}] }}]"
            );
            let scene = open_text("axes", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let items = draw(&plan, plan.theme, "axes").drawing.items;
            let begin = |part: &str| {
                let extents = paths(&items, part).into_iter().filter_map(|path| path.contour.bounds());
                extents.map(|extent| extent.x0).fold(f64::INFINITY, f64::min)
            };
            // With the ticks, which are beyond them too.
            assert!(begin("x-axis") > begin("y-numbers") - 1e-9, "{width}");
        }
    }

    #[test]
    fn without_lines_the_numbers_stay() {
        for (options, lines) in [("", 2), (", lines = false", 0)] {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 4 }}
                query = {{ kind = 'bounds', of = ['A'] }}
                panels = [{{ layers = [{{ layer = 'axes', ticks = true{options} }}] }}]"
            );
            let scene = open_text("axes", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let items = draw(&plan, plan.theme, "axes").drawing.items;
            let count = |part| paths(&items, part).len();
            assert_eq!(count("x-axis") + count("y-axis"), lines, "{options}");
            assert!(count("x-numbers") > 0 && count("y-numbers") > 0, "{options}");
        }
    }
}
