//! The two coordinate axes through the origin of the panel's space, as far as the panel shows.

use crate::figure::context::Context;
use crate::figure::sketch::{Pen, Sketch, Weight};
use crate::geometry::DVec2;

use super::{Fed, Layer, Options, Shows};

pub(super) const LAYER: Layer = Layer {
    name: "axes",
    about: "the coordinate axes of the panel's space, through its origin",
    shows: Shows::Anywhere,
    options: &[],
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
    let (lo, hi) = sketch.visible();
    let pen = Pen { role: options.role(Pen::axis().role), ..Pen::axis() };
    sketch.part("x-axis").weight(Weight::Background);
    sketch.line(at(lo.x, 0.0), at(hi.x, 0.0), pen);
    sketch.part("y-axis").weight(Weight::Background);
    sketch.line(at(0.0, lo.y), at(0.0, hi.y), pen);
}
