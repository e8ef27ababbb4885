//! The two coordinate axes through the origin of the panel's space, as far as the panel shows.

use crate::figure::context::Context;
use crate::figure::sketch::{Pen, Sketch, Weight};
use crate::geometry::DVec2;

use super::{Fed, Layer, Options, Shows};

pub(super) const LAYER: Layer = Layer {
    name: "axes",
    about: "the coordinate axes through the origin",
    shows: Shows::Anywhere,
    options: &[],
    labels: &[],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

fn draw(sketch: &mut Sketch, _context: &Context, options: &Options) {
    let (lo, hi) = sketch.visible();
    let pen = Pen { role: options.role(Pen::axis().role), ..Pen::axis() };
    sketch.part("x-axis").weight(Weight::Background);
    sketch.line(DVec2::new(lo.x, 0.0), DVec2::new(hi.x, 0.0), pen);
    sketch.part("y-axis").weight(Weight::Background);
    sketch.line(DVec2::new(0.0, lo.y), DVec2::new(0.0, hi.y), pen);
}
