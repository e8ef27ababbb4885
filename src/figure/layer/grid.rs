//! A quiet grid at round steps of the panel's space, so that places and lengths can be read off.

use crate::drawing::{Point, Role};
use crate::figure::context::Context;
use crate::figure::sketch::{Pen, Sketch};
use crate::geometry::DVec2;
use crate::trace::phrase;

use super::ruler::Ruler;
use super::{Fed, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// The step of marks, as grid and axes have it.
pub(super) const STEP: OptionSpec = OptionSpec {
    name: "step",
    takes: Takes::Positive,
    default: "1, 2 or 5 times a power of ten",
    about: "from one to the next, units of the panel's space",
};

pub(super) const LAYER: Layer = Layer {
    name: "grid",
    in_words: phrase(["grid", "Gitter", "quadrillage", "cuadrícula"]),
    about: "a quiet grid at round steps of the panel's space, beneath all other layers",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[STEP],
    labels: &[],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

/// The marks of a panel along x and along y, each with its place on the page: its x, its y.
pub(super) fn marks(
    sketch: &Sketch,
    context: &Context,
    options: &Options,
) -> [Option<(Ruler, Vec<Mark>)>; 2] {
    let (lo, hi) = sketch.visible();
    let step = options.number(STEP.name);
    let page = |p: DVec2| sketch.page(context.frame().map_or(p, |frame| frame.point(p)));
    let along = |range, place: &dyn Fn(f64) -> f64| {
        let ruler = Ruler::of(range, step, sketch.px(1.0))?;
        let marks = ruler.marks().map(|(number, value)| Mark { number, value, place: place(value) });
        Some((ruler, marks.filter(|mark| mark.place.is_finite()).collect()))
    };
    [
        along([lo.x, hi.x], &|x| page(DVec2::new(x, lo.y)).x),
        along([lo.y, hi.y], &|y| page(DVec2::new(lo.x, y)).y),
    ]
}

/// A mark of an axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    /// How many steps it is from 0.
    pub(super) number: f64,
    /// Its coordinate, in units of the panel's space.
    pub(super) value: f64,
    /// Where it lies on the page along its axis, page pixels.
    pub(super) place: f64,
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let panel = sketch.panel();
    let pen = Pen::grid(options.role(Role::Grid));
    let [x, y] = marks(sketch, context, options);
    let upright = |m: &Mark| (Point::new(m.place, panel.y0), Point::new(m.place, panel.y1));
    let level = |m: &Mark| (Point::new(panel.x0, m.place), Point::new(panel.x1, m.place));
    let lines = |marks: Option<(Ruler, Vec<Mark>)>, line: &dyn Fn(&Mark) -> (Point, Point)| {
        marks.map_or_else(Vec::new, |(_, marks)| marks.iter().map(line).collect())
    };
    let (upright, level): (Vec<_>, Vec<_>) = (lines(x, &upright), lines(y, &level));
    sketch.part("upright").quiet_lines(&upright, pen);
    sketch.part("level").quiet_lines(&level, pen);
}

/// Whether a layer lies beneath all others of its panel, wherever it is listed.
pub(in crate::figure) fn lies_beneath(layer: &Layer) -> bool {
    layer.name == LAYER.name
}

#[cfg(test)]
mod tests {
    use crate::drawing::Item;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn the_grid_lies_beneath_all_else_wherever_it_is_listed() {
        let drawn = |layers: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 4 }}
                query = {{ kind = 'bounds', of = ['A'] }}
                panels = [{{ layers = [{layers}] }}]"
            );
            let scene = open_text("grid", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            draw(&plan, plan.theme, "grid").drawing.items
        };
        let first: Vec<Item> = drawn("'grid', { layer = 'axes', ticks = true }, 'shapes'");
        assert_eq!(drawn("{ layer = 'axes', ticks = true }, 'shapes', 'grid'"), first);
    }
}
