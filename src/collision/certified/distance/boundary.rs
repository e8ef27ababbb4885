//! The point of B ⊖ A that is closest to an origin outside it, by walking along its boundary.
//!
//! Along the part of a convex boundary that the origin sees, the distance falls to one minimum and rises
//! again. From an edge that the origin sees, step to the neighbour as long as the foot of the origin lies
//! beyond the edge's end. The boundary is never built: after the vertex `w_j − v_i` comes either B's edge j
//! or A's edge i reversed, whichever turns off less (de Berg, Cheong, van Kreveld, Overmars, *Computational
//! Geometry*, 2008, §13.3). The gaps in doubles start the walk where it found the minimum, so that it mostly
//! ends where it begins.

use crate::collision::certified::distance::balls::{BallPair, Vec2, cross, dot, reversed, rounded};
use crate::collision::certified::distance::pair::Pair;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{Ball, Side, UnitVector};

/// Where B ⊖ A comes closest to the origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Closest {
    /// The edge that holds the foot of the origin, or the vertex.
    pub(crate) feature: DifferenceFeature,
    /// Bound on how far the foot is past the edge's end, where 106 bits do not tell; else 0.
    pub(crate) beyond: f64,
}

impl Closest {
    /// The vertex [i, j] of B ⊖ A.
    fn vertex(vertex: [usize; 2]) -> Self {
        Self { feature: DifferenceFeature::Vertex(vertex), beyond: 0.0 }
    }
}

/// An edge of B ⊖ A at a vertex of it.
struct Step {
    /// Which edge of B ⊖ A.
    facing: DifferenceEdge,
    /// The edge as a vector, away from the vertex.
    along: Vec2,
    /// The vertex at the other end: [i, j].
    end: [usize; 2],
}

/// Which way round B ⊖ A.
#[derive(Clone, Copy)]
enum Winding {
    /// Along the edges as they run: the next edge starts where this one ends.
    CounterClockwise,
    /// Against its edges.
    Clockwise,
}

/// The closest feature, from an edge of B ⊖ A that the origin sees or is on; None where it is not found.
pub(crate) fn closest(pair: &Pair, balls: &BallPair, start: DifferenceEdge) -> Option<Closest> {
    let vertex = start.start();
    let count = pair.hull(Side::A).edges.len() + pair.hull(Side::B).edges.len();
    let at = balls.between(vertex[0], vertex[1]);
    let mut doubtful = None;
    for winding in [Winding::CounterClockwise, Winding::Clockwise] {
        let Some(step) = step(pair, balls, vertex, winding) else { return Some(Closest::vertex(vertex)) };
        let slope = dot(&at, &step.along);
        match slope.sign() {
            Some(-1) => return descend(pair, balls, step, winding, count),
            Some(1) => {}
            _ => doubtful = doubtful.or(Some(edge(&step, slope))),
        }
    }
    Some(doubtful.unwrap_or(Closest::vertex(vertex)))
}

/// The normal at a vertex of B ⊖ A that is nearest the origin, from A to B in A's frame: along its place `p`
/// where that is certainly between the normals of the vertex's two edges, else the normal of an edge.
///
/// None where B ⊖ A is a point whose place 106 bits don't tell from the origin.
#[cold]
pub(crate) fn normal_at(pair: &Pair, balls: &BallPair, vertex: [usize; 2], p: &Vec2) -> Option<UnitVector> {
    for winding in [Winding::CounterClockwise, Winding::Clockwise] {
        let Some(step) = step(pair, balls, vertex, winding) else {
            let is_off = p.iter().any(|x| x.sign().is_some_and(|sign| sign != 0));
            return if is_off { UnitVector::along(rounded(p)) } else { None };
        };
        if !dot(p, &step.along).is_positive() {
            let normal = balls.normal(step.facing.source, step.facing.edge);
            return Some(UnitVector::normalized(rounded(&normal)));
        }
    }
    UnitVector::along(rounded(p))
}

/// Walks on as long as the distance falls; `step` is an edge along which it falls at first.
fn descend(pair: &Pair, balls: &BallPair, mut step: Step, winding: Winding, count: usize) -> Option<Closest> {
    // Not farther than once round.
    for _ in 0..=count {
        let at = balls.between(step.end[0], step.end[1]);
        let slope = dot(&at, &step.along);
        if !slope.is_negative() {
            return Some(edge(&step, slope));
        }
        let vertex = step.end;
        step = self::step(pair, balls, vertex, winding)?;
        let slope = dot(&at, &step.along);
        if slope.is_positive() {
            return Some(Closest::vertex(vertex));
        }
        if !slope.is_negative() {
            return Some(edge(&step, slope));
        }
    }
    None
}

/// The foot inside this edge; `slope` at one of its ends says how near to that end.
fn edge(step: &Step, slope: Ball) -> Closest {
    let doubtful = slope.sign().is_none_or(|sign| sign == 0);
    let along = rounded(&step.along);
    // |along| is within 2ε of this; 1 − 2⁻²⁰ covers it.
    let length = (along.x * along.x + along.y * along.y).sqrt() * (1.0 - f64::EPSILON.sqrt());
    let beyond = if !doubtful || slope.magnitude() == 0.0 { 0.0 } else { slope.magnitude() / length };
    Closest { feature: DifferenceFeature::Edge(step.facing), beyond }
}

/// The edge of B ⊖ A after (or before) the vertex `w_j − v_i`; None where it is a point.
fn step(pair: &Pair, balls: &BallPair, [i, j]: [usize; 2], winding: Winding) -> Option<Step> {
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let (k, l) = match winding {
        Winding::CounterClockwise => (i, j),
        Winding::Clockwise => (a.previous(i), b.previous(j)),
    };
    // As they run in B ⊖ A: A's edges are reversed there.
    let along_a = (!a.edges.is_empty()).then(|| reversed(&balls.edge(Side::A, k)));
    let along_b = (!b.edges.is_empty()).then(|| balls.edge(Side::B, l));
    let of_a = match (along_a, along_b) {
        (None, None) => return None,
        (Some(_), None) => true,
        (None, Some(_)) => false,
        (Some(x), Some(y)) => {
            let turn = cross(&y, &x);
            match (winding, turn.sign()) {
                (Winding::CounterClockwise, Some(1)) => false,
                (Winding::CounterClockwise, Some(-1)) | (Winding::Clockwise, Some(1)) => true,
                (Winding::Clockwise, Some(-1)) => false,
                // Parallel and the same way: one line, A's part last. Parallel and opposite: one core is a
                // segment, and the other's boundary already follows it; where both are, the vertex is inside
                // one line, A's part ahead of it.
                (Winding::CounterClockwise, _) => dot(&x, &y).is_negative() && b.edges.len() == 2,
                (Winding::Clockwise, _) => {
                    !dot(&x, &y).is_negative() || (b.edges.len() == 2 && a.edges.len() > 2)
                }
            }
        }
    };
    let (along, facing) = if of_a {
        (along_a?, DifferenceEdge { source: Side::A, edge: k, vertex: j })
    } else {
        (along_b?, DifferenceEdge { source: Side::B, edge: l, vertex: i })
    };
    let (along, end) = match (winding, of_a) {
        (Winding::CounterClockwise, true) => (along, [a.next(i), j]),
        (Winding::CounterClockwise, false) => (along, [i, b.next(j)]),
        (Winding::Clockwise, true) => (reversed(&along), [k, j]),
        (Winding::Clockwise, false) => (reversed(&along), [i, l]),
    };
    Some(Step { facing, along, end })
}
