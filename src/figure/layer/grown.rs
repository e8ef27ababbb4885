//! B shrunk to a point while A grows by B's shape: what B ⊖ A looks like from where the bodies stand.
//!
//! With b the origin of B, the grown A is {b − x : x ∈ B ⊖ A} = A ⊕ (b − B): A swept by B turned through half
//! a turn about b. Copies of that on A's vertices span it.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, Marker, Outline, Pen, Piece, Rank, Size, Sketch, Wash, Weight,
};
use crate::geometry::{DVec2, Side};

use super::difference::{difference, edge_pen};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes};

pub(super) const LAYER: Layer = Layer {
    name: "grown",
    about: "B as a point, A grown by B's shape",
    shows: Shows::World,
    options: &[OptionSpec {
        name: "copies",
        takes: Takes::Flag,
        default: "true",
        about: "dotted copies of B on A's vertices",
    }],
    labels: &[
        LabelKey { key: "A", about: "name of the first body" },
        LabelKey { key: "b", about: "the point that B shrinks to" },
    ],
    needs: "two convex bodies",
    fed: |context, _| Fed::by_the_scene(difference(context, context.time).is_some()),
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let time = context.time;
    let Some(found) = difference(context, time) else { return };
    let (Some(b), Some(outline_a), Some(outline_b)) =
        (context.pose(Side::B, time), context.outline(Side::A, time), context.outline(Side::B, time))
    else {
        return;
    };
    let b = b.position;
    let turned = |p: DVec2| b - p;
    let grown = found.outline().turned_about(DVec2::ZERO).moved(b);
    sketch.part("grown").area(&grown, Some(Wash::theme(Role::Difference)), None);
    for piece in &grown.pieces {
        if let Piece::Arc { center, radius, start, sweep } = *piece {
            sketch.arc(center, radius, start, sweep, Pen::outline(Role::Difference));
        }
    }
    sketch.part("body-A").area(&outline_a, Some(Wash::theme(Role::A)), Some(Pen::outline(Role::A)));
    if options.flag("copies", true) {
        sketch.part("copies").weight(Weight::Light);
        for vertex in vertices(context) {
            let copy = outline_b.turned_about(b).moved(vertex - b);
            for run in runs_outside(&copy.sampled(), &outline_a.sampled()) {
                sketch.stroke(&Outline::polyline(&run), Pen::ghost(Role::B));
            }
        }
    }
    sketch.part("grown-edges");
    for edge in &found.edges {
        let (from, to) = found.drawn(edge);
        sketch.line(turned(from), turned(to), edge_pen(edge));
    }
    sketch.part("ghost-B").area(&outline_b, None, Some(Pen::ghost(Role::B)));
    sketch.part("b").marker(b, Marker::Square, Role::B, LARGE_MARKER);
    let inside = Anchor::inside(&outline_a);
    sketch.label(Label::new("A", context.name(Side::A), inside, Role::A).rank(Rank::Name).size(Size::Name));
    let name = context.named(Side::B);
    let text = if name.is_symbol() { format!("${}$", name.term().to_lowercase()) } else { name.primed(0) };
    sketch.label(Label::new("b", text, Anchor::point(b), Role::B).rank(Rank::Point));
}

/// The parts of a line that a convex area does not hide: A lies over the copies, and its name on no dots.
fn runs_outside(line: &[DVec2], area: &[DVec2]) -> Vec<Vec<DVec2>> {
    let (mut runs, mut run): (Vec<Vec<DVec2>>, Vec<DVec2>) =
        (Vec::new(), line.first().copied().into_iter().collect());
    for pair in line.windows(2) {
        let (p, d) = (pair[0], pair[1] - pair[0]);
        if let Some((from, to)) = within(p, d, area) {
            run.push(p + d * from);
            runs.push(std::mem::replace(&mut run, vec![p + d * to]));
        }
        run.push(pair[1]);
    }
    runs.push(run);
    runs.retain(|run| run.windows(2).any(|pair| pair[0] != pair[1]));
    runs
}

/// The part of the way from `p` along `d` that lies within a convex area, counter-clockwise, as parts of the
/// way; none where it is outside, or only touches.
fn within(p: DVec2, d: DVec2, area: &[DVec2]) -> Option<(f64, f64)> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for edge in area.windows(2) {
        let along = edge[1] - edge[0];
        let (off, rise) = (along.perp_dot(p - edge[0]), along.perp_dot(d));
        if rise == 0.0 && off <= 0.0 {
            return None;
        }
        let t = -off / rise;
        (from, to) = match rise {
            _ if rise > 0.0 => (from.max(t), to),
            _ if rise < 0.0 => (from, to.min(t)),
            _ => (from, to),
        };
    }
    (from < to).then_some((from, to))
}

/// The vertices of A's core, in the world.
fn vertices(context: &Context) -> Vec<DVec2> {
    let Some(body) = context.body(Side::A) else { return Vec::new() };
    body.shape.core.iter().filter_map(|&i| context.vertex(Side::A, i, context.time)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_hidden_where_it_runs_through_the_area_and_nowhere_else() {
        let square =
            [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (0.0, 0.0)].map(|(x, y)| DVec2::new(x, y));
        let p = DVec2::new;
        let runs = runs_outside(&[p(-1.0, 1.0), p(3.0, 1.0), p(3.0, 3.0)], &square);
        assert_eq!(runs, [vec![p(-1.0, 1.0), p(0.0, 1.0)], vec![p(2.0, 1.0), p(3.0, 1.0), p(3.0, 3.0)]]);
        assert!(runs_outside(&[p(0.5, 0.5), p(1.5, 1.0)], &square).is_empty());
        let beside = [p(-1.0, 0.0), p(3.0, 0.0), p(3.0, -1.0)];
        assert_eq!(runs_outside(&beside, &square), [beside.to_vec()], "along an edge");
    }
}
