//! The error of a case against 320 bits, as a share of the bound: a function a row.

use tracefig_reference::point::{self, Point};

use super::cases::Case;
use super::truth::{Truth, edges, exact, exact_point, exact_rotation, point, real, share_of, size};
use crate::collision::algorithm::extremes::Placing;
use crate::collision::algorithm::view::PairView;
use crate::collision::certified::distance::balls::BallPair;
use crate::collision::certified::distance::gaps::every_gap;
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::distance::refine::{along_edge, between, between_vertices};
use crate::collision::certified::impact::MovingPair;
use crate::collision::certified::impact::axis::Axis;
use crate::collision::certified::impact::filter::gap_series::Instant;
use crate::collision::certified::impact::gap::Precision;
use crate::collision::certified::impact::taylor::parabola_root;
use crate::collision::certified::rounding::{
    DERIVATIVE_ERROR, DOT_ERROR, LAST_ERROR, LEVEL_ERROR, MISSED_ERROR, OFFSET_ERROR, PLACING_ERROR,
    REST_ERROR, ROOT_ERROR, TURNED_DOT_ERROR,
};
use crate::collision::certified::sweep::filter::Line;
use crate::collision::certified::sweep::filter::crossed_edge::{Crossed, crossed};
use crate::collision::certified::sweep::heading::Heading;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{Ball, Body, DVec2, Dd, Rotation, Side};

pub(super) fn gap(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (Pair::at(&a, &b, t), Truth::of(&a, &b, t));
    let mut most = 0.0_f64;
    every_gap(&pair, |edge, gap| {
        most = most.max(share_of(real(gap), truth.gap(edge.source, edge.edge), pair.gap_error()));
    });
    most
}

pub(super) fn view_gap(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (PairView::at(&a, &b, t), Truth::of(&a, &b, t));
    let of = |(source, edge): (Side, usize)| {
        let vertex = pair.supports_of_edge(source, edge).0;
        let line = DifferenceEdge { source, edge, vertex }.project(&pair).line;
        share_of(real(line), truth.gap(source, edge), pair.gap_error())
    };
    edges(&a, &b).into_iter().map(of).fold(0.0, f64::max)
}

pub(super) fn cross(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (PairView::at(&a, &b, t), Truth::of(&a, &b, t));
    let mut most = 0.0_f64;
    for k in 0..a.shape.hull.edges.len() {
        for l in 0..b.shape.hull.edges.len() {
            let (d, e) = (pair.difference_edge(Side::A, k), pair.difference_edge(Side::B, l));
            let (p, q) = (d.x * e.y, d.y * e.x);
            let exact = -truth.edge(Side::A, k).cross(truth.edge(Side::B, l));
            most = most.max(share_of(real(p - q), exact, DOT_ERROR * size(d) * size(e)));
        }
    }
    most
}

/// The worst error of a dot product of an edge and a normal turned into its frame, over what `size_of` makes
/// of both.
pub(super) fn dots(case: &Case, size_of: fn(DVec2, DVec2) -> f64) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (Pair::at(&a, &b, t), Truth::of(&a, &b, t));
    let mut most = 0.0_f64;
    for (side, k) in edges(&a, &b) {
        let n = *pair.hull(side).normals[k];
        let n = if side == Side::A { pair.vector_to_b(n) } else { pair.vector_from_b(n) };
        for (l, &edge) in pair.hull(side.other()).edges.iter().enumerate() {
            let exact = truth.outward(side, k).dot(truth.edge(side.other(), l));
            most = most.max(share_of(real(n.dot(edge)), exact, size_of(n, edge)));
        }
    }
    most
}

pub(super) fn dot(case: &Case) -> f64 {
    dots(case, |n, edge| DOT_ERROR * size(n) * size(edge))
}

pub(super) fn level_dot(case: &Case) -> f64 {
    dots(case, |_, edge| LEVEL_ERROR * size(edge))
}

pub(super) fn offset(case: &Case) -> f64 {
    let Some(([a, b], _)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (Pair::refined_at(&a, &b, 0.0), Truth::of(&a, &b, 0.0));
    let Some(heading) = Heading::of(&pair) else { return 0.0 };
    let (v, left) = (truth.closing, truth.closing.perp());
    let bound = OFFSET_ERROR * (pair.magnitude + pair.radius.hi) * heading.speed;
    let at = |[i, j]: [usize; 2]| truth.core(Side::B)[j].minus(truth.core(Side::A)[i]).dot(left);
    match crossed(&pair, heading.direction()) {
        Crossed::Passed(past) => {
            let all = (0..3).flat_map(|i| (0..3).map(move |j| [i, j])).map(at).collect::<Vec<_>>();
            let (least, most) = all.iter().fold((all[0], all[0]), |(lo, hi), &x| (lo.min(x), hi.max(x)));
            share_of(real(past), least.max(-most) - truth.radius * v.length(), bound)
        }
        Crossed::Edge(found) => {
            let DifferenceEdge { source, edge, vertex } = found.edge;
            let outward = truth.outward(source, edge);
            let out = if source == Side::A { outward } else { outward.reversed() };
            let moved = truth.radius * out.reversed().dot(left);
            let next = (edge + 1) % 3;
            let ends = [edge, next].map(|k| at(DifferenceEdge { source, edge: k, vertex }.start()) + moved);
            share_of(real(found.inside), ends[0].min(-ends[1]), bound)
        }
        Crossed::Vertex(_) => 0.0,
    }
}

pub(super) fn placing(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let pair = Pair::refined_at(&a, &b, t);
    let (frame, relative) = (exact_rotation(pair.frame_rotation), exact_rotation(pair.b_rotation));
    let apart = exact_point(pair.apart.map(|x| x.value)).turned_back(frame);
    let mut most = 0.0_f64;
    for (i, &v) in a.shape.hull.vertices.iter().enumerate() {
        for (j, &q) in b.shape.hull.vertices.iter().enumerate() {
            let truth = apart.plus(point(q).turned(relative)).minus(point(v));
            let error = exact_point(between(&pair, [i, j])).minus(truth).length();
            most = most.max(error.over(real(PLACING_ERROR * pair.magnitude)).to_f64());
        }
    }
    most
}

/// The bound over the radius of a vertex in balls.
pub(super) fn placing_ball(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return f64::INFINITY };
    let pair = Pair::refined_at(&a, &b, t);
    let [x, y] = BallPair::new(&pair).between(0, 0);
    PLACING_ERROR * pair.magnitude / libm::hypot(x.radius, y.radius)
}

/// A normal of A's edge and a vertex of B ⊖ A in balls, and the bound over the radius of the gap that they
/// leave.
pub(super) fn last_ball(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return f64::INFINITY };
    let pair = Pair::refined_at(&a, &b, t);
    let d = between(&pair, [0, 0]).map(Ball::exact);
    let gap = dot_of(a.shape.hull.normal_in_balls(0), d) - Ball::exact(pair.radius);
    LAST_ERROR * (pair.magnitude + pair.radius.hi) / gap.radius
}

/// The rest of the gap of A's first edge in balls, from a vertex that is placed by balls without an error of
/// cosine and sine, and the bound over its radius.
pub(super) fn rest_ball(case: &Case) -> f64 {
    let Some(([a, b], _)) = case.bodies() else { return f64::INFINITY };
    let pair = Pair::refined_at(&a, &b, 0.0);
    let Some(heading) = Heading::of(&pair) else { return f64::INFINITY };
    let facing = DifferenceEdge { source: Side::A, edge: 0, vertex: 0 };
    let Some(found) = (Line { pair: &pair, heading: &heading }).rest(facing) else { return f64::INFINITY };
    let of = |r: Rotation<Dd>| Rotation { cos: Ball::exact(r.cos), sin: Ball::exact(r.sin) };
    let (v, q) = (a.shape.hull.vertices[0], b.shape.hull.vertices[0]);
    let turned = of(pair.b_rotation).apply([Ball::new(q.x), Ball::new(q.y)]);
    let [x, y] = pair.center_tailed.map(Ball::exact);
    let d = [x + turned[0] - Ball::new(v.x), y + turned[1] - Ball::new(v.y)];
    let n = a.shape.hull.normal_in_balls(0);
    let closing = dot_of(n, heading.v.map(Ball::exact));
    let rest = dot_of(n, d) - Ball::exact(pair.radius) - closing.scale(found.q);
    REST_ERROR * (pair.magnitude + pair.radius.hi + found.q.abs() * heading.speed) / rest.radius
}

pub(super) fn dot_of(x: [Ball; 2], y: [Ball; 2]) -> Ball {
    x[0] * y[0] + x[1] * y[1]
}

pub(super) fn last(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (Pair::refined_at(&a, &b, t), Truth::of(&a, &b, t));
    let bound = LAST_ERROR * (pair.magnitude + pair.radius.hi);
    let mut most = 0.0_f64;
    for edge in 0..a.shape.hull.edges.len() {
        for vertex in 0..b.shape.hull.vertices.len() {
            let d = exact_point(between(&pair, [edge, vertex]));
            let along = along_edge(&pair, DifferenceEdge { source: Side::A, edge, vertex });
            let exact_gap = truth.outward(Side::A, edge).dot(d) - exact(pair.radius);
            most = most.max(share_of(exact(along.core - pair.radius), exact_gap, bound));
            if let Some(apart) = between_vertices(&pair, [edge, vertex]) {
                most = most.max(share_of(
                    exact(apart.core - pair.radius),
                    d.length() - exact(pair.radius),
                    bound,
                ));
            }
        }
    }
    most
}

pub(super) fn rest(case: &Case) -> f64 {
    let Some(([a, b], _)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (Pair::refined_at(&a, &b, 0.0), Truth::of(&a, &b, 0.0));
    let Some(heading) = Heading::of(&pair) else { return 0.0 };
    let (frame, relative) = (exact_rotation(pair.frame_rotation), exact_rotation(pair.b_rotation));
    let apart = exact_point(pair.apart.map(|x| x.value)).turned_back(frame);
    let v = exact_point(heading.v);
    let line = Line { pair: &pair, heading: &heading };
    let mut most = 0.0_f64;
    for (source, edge) in edges(&a, &b) {
        for vertex in 0..3 {
            let facing = DifferenceEdge { source, edge, vertex };
            let Some(found) = line.rest(facing) else { continue };
            let [i, j] = facing.start();
            let (x, q) = (a.shape.hull.vertices[i], b.shape.hull.vertices[j]);
            let d = apart.plus(point(q).turned(relative)).minus(point(x));
            // The edge's own normal, turned as the pair has it.
            let outward = match source {
                Side::A => truth.outward(source, edge),
                Side::B => {
                    truth.outward(source, edge).turned_back(truth.relative).turned(relative).reversed()
                }
            };
            let exact_rest = outward.dot(d) - exact(pair.radius) - real(found.q) * outward.dot(v);
            let bound = REST_ERROR * (pair.magnitude + pair.radius.hi + found.q.abs() * heading.speed);
            most = most.max(share_of(real(found.left), exact_rest, bound));
        }
    }
    most
}

pub(super) fn moving_gap(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (MovingPair::new(&a, &b), Truth::of(&a, &b, t));
    let of = |(source, edge): (Side, usize)| {
        let near = DifferenceFeature::Edge(DifferenceEdge { source, edge, vertex: 0 });
        let Some(axis) = Axis::through(&pair, near, t) else { return 0.0 };
        let gap = axis.gap(&pair, t, Precision::Doubles, &mut 0).least + pair.rounding;
        share_of(real(gap), truth.gap(source, edge) - truth.radius, pair.rounding)
    };
    edges(&a, &b).into_iter().map(of).fold(0.0, f64::max)
}

pub(super) fn missed(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (MovingPair::new(&a, &b), Truth::of(&a, &b, t));
    let bound = MISSED_ERROR * (pair.reach[0] + pair.reach[1]);
    let at = Instant::new(&pair, t);
    let of = |(source, edge): (Side, usize)| {
        let near = DifferenceFeature::Edge(DifferenceEdge { source, edge, vertex: 0 });
        let Some(axis) = Axis::through(&pair, near, t) else { return 0.0 };
        let Some(gap) = axis.turned_gap(&pair, &at, 0) else { return 0.0 };
        share_of(truth.height(source, edge, gap.lowest), truth.gap(source, edge), bound)
    };
    edges(&a, &b).into_iter().map(of).fold(0.0, f64::max)
}

pub(super) fn turned_dot(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (MovingPair::new(&a, &b), Truth::of(&a, &b, t));
    let mut most = 0.0_f64;
    for (side, k) in edges(&a, &b) {
        let world = pair.rotation(side, t).apply(*pair.hull(side).normals[k]);
        let n = pair.rotation(side.other(), t).undo(world);
        for (l, &edge) in pair.hull(side.other()).edges.iter().enumerate() {
            let exact = truth.outward(side, k).dot(truth.edge(side.other(), l));
            most = most.max(share_of(real(n.dot(edge)), exact, TURNED_DOT_ERROR * size(n) * size(edge)));
        }
    }
    most
}

pub(super) fn derivative(case: &Case) -> f64 {
    let Some(([a, b], t)) = case.bodies() else { return 0.0 };
    let (pair, truth) = (MovingPair::new(&a, &b), Truth::of(&a, &b, t));
    let rate = |side: Side| point::radians(real([&a, &b][side as usize].spin.degrees()));
    let of = |(source, edge): (Side, usize)| {
        let other = source.other();
        let near = DifferenceFeature::Edge(DifferenceEdge { source, edge, vertex: 0 });
        let Some(axis) = Axis::through(&pair, near, t) else { return 0.0 };
        let mut lowest = 0;
        let gap = axis.gap(&pair, t, Precision::Doubles, &mut lowest);
        // In A's frame: n, the other body's vertex and both origins, and the velocity V of O's origin.
        let n = truth.outward(source, edge);
        let origin = {
            let at = |body: &Body| point(body.position).plus(point(body.velocity).times(real(t)));
            at(&b).minus(at(&a)).turned_back(truth.frame)
        };
        let (d, v) = match source {
            Side::A => (origin, truth.closing.reversed()),
            Side::B => (origin.reversed(), truth.closing),
        };
        let own_origin = if source == Side::A { Point::ZERO } else { origin };
        let x = truth.core(other)[lowest].minus(own_origin).minus(d);
        let exact_slope =
            rate(source) * n.perp().dot(d) + n.dot(v) + (rate(other) - rate(source)) * n.dot(x.perp());
        let view = pair.offset(source, t);
        let rotation = pair.rotation(source, t);
        let (d1, v1) = (size(rotation.undo(view.0)), size(rotation.undo(view.1)));
        let (w, rates) = (pair.rate[source as usize].abs(), pair.rate[0].abs() + pair.rate[1].abs());
        let allowed = DERIVATIVE_ERROR * (w * d1 + v1 + 2.0 * rates * pair.reach[other as usize]);
        share_of(real(gap.slope + allowed), exact_slope, allowed)
    };
    edges(&a, &b).into_iter().map(of).fold(0.0, f64::max)
}

/// How much of what the allowance takes off the root was needed.
pub(super) fn root(case: &Case) -> f64 {
    let [a, b, q, ..] = case.motion;
    let (bare, safe) = (parabola_root(a, b, q, 0.0), parabola_root(a, b, q, ROOT_ERROR));
    let discriminant = real(b) * real(b) - real(2.0) * real(a) * real(q);
    if a <= 0.0 || !bare.is_finite() || bare <= safe || discriminant.signum() < 0 {
        return 0.0;
    }
    let (root, b) = (discriminant.sqrt(), real(b));
    let exact =
        if b.signum() <= 0 { (real(2.0) * real(a)).over(root - b) } else { -(b + root).over(real(q)) };
    (real(bare) - exact).over(real(bare) - real(safe)).to_f64()
}

pub(super) fn extreme(case: &Case) -> f64 {
    let Some(([a, _], t)) = case.bodies() else { return 0.0 };
    let placing = Placing::new(&a, t);
    let rotation = point::Rotation::of_degrees(real(a.angle.degrees()) + real(a.spin.degrees()) * real(t));
    let at = point(a.position).plus(point(a.velocity).times(real(t)));
    let mut most = 0.0_f64;
    for &v in &a.shape.vertices {
        let (found, exact) = (placing.pose.point(v), at.plus(point(v).turned(rotation)));
        most = most.max(share_of(real(found.x), exact.x, placing.error));
        most = most.max(share_of(real(found.y), exact.y, placing.error));
    }
    most
}
