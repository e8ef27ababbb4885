//! The outer tangents between a body and its ghost at the hit, or at the end of its way: the band that it
//! sweeps.
//!
//! The band of a translated body is the convex hull of both places. Of the hull of all core vertices, the
//! edges that lead from one place to the other are the tangents of the cores; moved out by the radius, those
//! of the bodies.

use crate::figure::context::Context;
use crate::figure::sketch::{Outline, Pen, Sketch, Wash, Weight};
use crate::geometry::{Body, DVec2, Side, sort_by};
use crate::scene::When;
use crate::trace::phrase;

use super::{Fed, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

/// Opacity of the band's fill: a quiet ground for the bodies on it.
const FAINT: f64 = 0.07;

pub(super) const LAYER: Layer = Layer {
    name: "sweep",
    in_words: phrase(["sweep", "überstrichenes Band", "bande balayée", "banda barrida"]),
    about: "the band that a body sweeps up to the hit, by its edges",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "all that move", about: "which bodies" },
        OptionSpec {
            name: "to",
            takes: Takes::Word(&[When::HIT, When::END]),
            default: "\"hit\"",
            about: "up to the hit, or all the way to t = 1",
        },
        OptionSpec { name: "fill", takes: Takes::Flag, default: "false", about: "a faint fill of the band" },
    ],
    labels: &[],
    needs: "a question for the first contact, and a body that goes straight, as the panel shows it",
    fed: |context, options| {
        let straight = !swept(context, options).is_empty();
        let why = ["seen from the panel's frame nothing goes straight", "no body goes straight"];
        match options.word("to", When::HIT) {
            _ if !straight => Fed::by_the_frame(false, context, why),
            When::END => Fed::by_the_scene(context.asks_for_a_hit()),
            _ => Fed::by_a_hit(context),
        }
    },
    draw,
};

/// The bodies that go straight as the panel shows it, so that the tangents bound what they sweep.
fn swept(context: &Context, options: &Options) -> Vec<Side> {
    let turns = |side: Side| context.body(side).is_none_or(Body::turns);
    let frame_turns = context.moving_frame().is_some_and(|frame| frame.turns());
    let moves =
        |&side: &Side| !frame_turns && !turns(side) && context.pose(side, 0.0) != context.pose(side, 1.0);
    options.of(&context.sides()).into_iter().filter(moves).collect()
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let to_the_end = options.word("to", When::HIT) == When::END;
    let Some(time) = (if to_the_end { Some(1.0) } else { context.hit().map(|(time, _)| time) }) else {
        return;
    };
    sketch.since((!to_the_end).then(|| context.answered()));
    for side in swept(context, options) {
        let (before, after) = (core(context, side, context.time), core(context, side, time));
        if before == after {
            continue;
        }
        let radius = context.body(side).map_or(0.0, |body| body.shape.radius);
        let (role, hull) = (options.role(side.into()), hull(&before, &after));
        sketch.part(part("sweep", side)).weight(Weight::Light);
        if options.flag("fill", false) {
            let band: Vec<DVec2> = hull.iter().skip(1).map(|&(p, _)| p).collect();
            sketch.area(&Outline::rounded(&band, radius), Some(Wash::faint(role, FAINT)), None);
        }
        for (p, q) in tangents(&hull, radius) {
            sketch.line(p, q, Pen::dimension(role));
        }
    }
}

/// The vertices of a body's core at a moment, in the world.
fn core(context: &Context, side: Side, time: f64) -> Vec<DVec2> {
    let Some(body) = context.body(side) else { return Vec::new() };
    body.shape.core.iter().filter_map(|&i| context.vertex(side, i, time)).collect()
}

/// The common hull of two sets of points, counter-clockwise from its leftmost point back to it, in their
/// units; with each point whether it is of the second set.
fn hull(before: &[DVec2], after: &[DVec2]) -> Vec<(DVec2, bool)> {
    let mut points: Vec<(DVec2, bool)> =
        before.iter().map(|&p| (p, false)).chain(after.iter().map(|&p| (p, true))).collect();
    sort_by(&mut points, |(p, _), (q, _)| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    let mut hull = half_hull(points.iter());
    hull.pop();
    hull.extend(half_hull(points.iter().rev()));
    hull
}

/// The edges of a common hull that lead from one of its two sets to the other, moved out by `radius`, in the
/// world.
fn tangents(hull: &[(DVec2, bool)], radius: f64) -> Vec<(DVec2, DVec2)> {
    let across = |w: &[(DVec2, bool)]| {
        let ((p, p_after), (q, q_after)) = (w[0], w[1]);
        let along = (q - p).normalize_or_zero();
        let out = DVec2::new(along.y, -along.x) * radius;
        (p_after != q_after).then_some((p + out, q + out))
    };
    hull.windows(2).filter_map(across).collect()
}

/// Half of a convex hull, counter-clockwise: from the first point to the last, turning left only.
fn half_hull<'p>(points: impl Iterator<Item = &'p (DVec2, bool)>) -> Vec<(DVec2, bool)> {
    let mut hull: Vec<(DVec2, bool)> = Vec::new();
    for &point in points {
        while let [.., (a, _), (b, _)] = hull.as_slice() {
            if (*b - *a).perp_dot(point.0 - *b) > 0.0 {
                break;
            }
            hull.pop();
        }
        hull.push(point);
    }
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_sweeps_a_band_as_wide_as_itself() {
        let lines = tangents(&hull(&[DVec2::ZERO], &[DVec2::new(4.0, 0.0)]), 1.0);
        let expected =
            [(DVec2::new(0.0, -1.0), DVec2::new(4.0, -1.0)), (DVec2::new(4.0, 1.0), DVec2::new(0.0, 1.0))];
        assert_eq!(lines, expected);
    }

    #[test]
    fn a_square_that_moves_along_its_diagonal_is_joined_at_its_other_vertices() {
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let moved = square.map(|p| p + DVec2::splat(3.0));
        let lines = tangents(&hull(&square, &moved), 0.0);
        assert_eq!(lines, [(DVec2::X, DVec2::new(4.0, 3.0)), (DVec2::new(3.0, 4.0), DVec2::Y)]);
    }
}
