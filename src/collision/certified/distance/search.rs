//! The certified answer: which edge or vertex of B ⊖ A is nearest the origin, and a proof of how far it is.
//!
//! 1. *Apart.* A hint (an edge or vertex of B ⊖ A that some algorithm found) is checked: along a direction n
//!    the gap of the supports is a lower bound of the distance, the witness points are an upper one. For the
//!    right feature the two are equal, up to the rounding of double-doubles, and the proof is done without
//!    looking at anything else.
//! 2. *Overlapping*, or no such luck. The depth is the least over *every* edge of B ⊖ A. Plain doubles with a
//!    bound sort out the edges that cannot be it ([`crate::collision::certified::distance::gaps`]); every
//!    edge within twice that bound of the best is measured again
//!    ([`crate::collision::certified::distance::balls`]), and ties are counted there. If the best gap turns
//!    out not to be negative, the bodies are apart and the closest point is reached by walking from that edge
//!    ([`crate::collision::certified::distance::boundary`]).
//!
//! Where the separation's ball holds 0, the sign of a polynomial decides, without square roots: c |c| − R²
//! |e|² for an edge e with c = e × d, and |d|² − R² for vertices d apart; only an exact 0 is called 0.

use crate::collision::certified::distance::balls::{
    BallPair, MeasuredEdge, Vec2, cross, dot, reversed, rounded,
};
use crate::collision::certified::distance::boundary::{self, Closest};
use crate::collision::certified::distance::gaps::every_gap;
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::distance::witnesses::{Carrier, Proved};
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{Ball, Side, UnitVector};

/// An edge is taken for the nearest feature only where the distance from it is known better than to this part
/// of it: the walk to it may have been lost among products that are below all doubles.
const LOOSE: f64 = f64::EPSILON;

/// What was found, in A's frame and scaled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    /// The nearest feature of B ⊖ A.
    pub(crate) contact: Contact,
    /// Signed distance of the cores.
    pub(crate) core: Ball,
    /// Directions that tie.
    pub(crate) ties: u32,
}

impl Found {
    /// Takes the distance for less sure.
    fn widened(self, by: f64) -> Self {
        Self { core: self.core.widen(by), ..self }
    }

    /// Whether hardly more is known than that the bodies are apart, if that.
    fn is_loose(&self) -> bool {
        self.core.radius >= LOOSE * self.core.value.hi
    }
}

/// The feature of B ⊖ A that carries a separation.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Contact {
    /// An edge, with the gap along its normal.
    Edge(MeasuredEdge),
    /// The vertex [i, j], and its place `w_j − v_i`.
    Vertex([usize; 2], Vec2),
}

/// The separation of a pair by balls; of directions that tie, the hinted one is taken.
#[cold]
pub(crate) fn proved(pair: &Pair, hint: Option<DifferenceFeature>) -> Proved {
    let balls = BallPair::new(pair);
    let found =
        hint.and_then(|hint| confirm(pair, &balls, hint)).unwrap_or_else(|| search(pair, &balls, hint));
    let separation = found.core - Ball::exact(pair.radius);
    let zero = separation.sign().is_none() && is_zero(pair, &balls, &found);
    rounded_off(pair, &balls, &found, if zero { Ball::ZERO } else { separation })
}

/// What was found, rounded to doubles; `separation` is the scaled ball of s.
fn rounded_off(pair: &Pair, balls: &BallPair, found: &Found, separation: Ball) -> Proved {
    let unscale = 1.0 / pair.scale;
    let bounds = separation.enclosure_scaled(unscale);
    let value = (separation.value.to_f64() * unscale).max(bounds.lo).min(bounds.hi);
    let carrier = match found.contact {
        Contact::Vertex(vertices, _) => Carrier::Vertex(vertices),
        Contact::Edge(MeasuredEdge { facing, partner: Some(partner), .. }) => {
            Carrier::ParallelEdges(facing, partner)
        }
        Contact::Edge(MeasuredEdge { facing, partner: None, .. }) => Carrier::Edge(facing),
    };
    let normal = normal_of(pair, balls, &found.contact);
    Proved { carrier, normal, core: found.core.value.hi, separation: value, bounds, ties: found.ties }
}

/// A hint that can be proved to be the nearest feature of bodies that are apart.
fn confirm(pair: &Pair, balls: &BallPair, hint: DifferenceFeature) -> Option<Found> {
    match hint {
        DifferenceFeature::Edge(facing) => {
            let measured = balls.measure(facing);
            if !measured.gap.is_positive() {
                return None;
            }
            let closest = boundary::closest(pair, balls, measured.facing)?;
            apart(pair, balls, closest).filter(|found| !found.is_loose())
        }
        DifferenceFeature::Vertex(vertices) => {
            let found = vertex(balls, vertices)?;
            let Contact::Vertex(_, p) = found.contact else { return None };
            // An edge square to p, or one that points nearer, leaves it to the search.
            let clear = |side: Side, k: usize, down: &Vec2| {
                let hull = pair.hull(side);
                hull.edges.is_empty()
                    || (dot(down, &balls.edge(side, k)).is_positive()
                        && dot(down, &balls.edge(side, hull.previous(k))).is_negative())
            };
            let proved = found.core.is_positive()
                && clear(Side::B, vertices[1], &p)
                && clear(Side::A, vertices[0], &reversed(&p));
            proved.then_some(found)
        }
    }
}

/// The closest feature of bodies that are apart, measured.
fn apart(pair: &Pair, balls: &BallPair, closest: Closest) -> Option<Found> {
    match closest.feature {
        DifferenceFeature::Edge(facing) => {
            let (facing, measured) = toward(pair, balls, facing);
            // Where another vertex supports the edge, the foot is known to be on no edge of B ⊖ A.
            let beyond = if measured.facing == facing { closest.beyond } else { f64::INFINITY };
            let core = measured.gap.widen(beyond.min(farther(balls, facing, measured.gap)));
            let found = Found { contact: Contact::Edge(measured), core, ties: 1 };
            let start = if found.is_loose() { vertex(balls, facing.start()) } else { None };
            Some(start.filter(|start| start.core.radius < core.radius).unwrap_or(found))
        }
        DifferenceFeature::Vertex(vertices) => vertex(balls, vertices),
    }
}

/// An edge of B ⊖ A that is closest to the origin, measured. A segment's two edges are one line: around two
/// parallel ones the walk may have come by the one that faces away.
fn toward(pair: &Pair, balls: &BallPair, facing: DifferenceEdge) -> (DifferenceEdge, MeasuredEdge) {
    let measured = balls.measure(facing);
    let hull = pair.hull(facing.source);
    if hull.vertices.len() > 2 || !measured.gap.is_negative() {
        return (facing, measured);
    }
    let other = DifferenceEdge { edge: hull.next(facing.edge), ..facing };
    let behind = balls.measure(other);
    // Of segments that cross or meet neither edge faces it: the nearer one stays.
    if (measured.gap - behind.gap).is_negative() { (other, behind) } else { (facing, measured) }
}

/// Bound on how much farther B ⊖ A is than the gap along an edge of it: the edge's ends are points of B ⊖ A.
///
/// Where bodies are so far apart that nothing of an edge's length is left beside the distance, this is all
/// that is known of where the foot of the origin lies on it.
fn farther(balls: &BallPair, edge: DifferenceEdge, gap: Ball) -> f64 {
    let beyond = |[i, j]: [usize; 2]| {
        let end = balls.between(i, j);
        (dot(&end, &end).sqrt() - gap).magnitude()
    };
    beyond(edge.start()).min(beyond(balls.end(edge)))
}

/// Vertex i of A against vertex j of B: |`w_j − v_i`|, less what the supports along it may lie nearer.
fn vertex(balls: &BallPair, [i, j]: [usize; 2]) -> Option<Found> {
    let p = balls.between(i, j);
    let length = dot(&p, &p).sqrt();
    let drop = balls.drop_below(Side::B, j, &p) + balls.drop_below(Side::A, i, &reversed(&p));
    let least = length.value.hi * (1.0 - f64::EPSILON) - length.radius;
    let core = if drop == 0.0 {
        length
    } else if least > 0.0 {
        length.widen(drop / least)
    } else {
        return None;
    };
    Some(Found { contact: Contact::Vertex([i, j], p), core, ties: 1 })
}

/// Every edge of B ⊖ A, then the walk if the origin is outside.
fn search(pair: &Pair, balls: &BallPair, hint: Option<DifferenceFeature>) -> Found {
    let Some((best, ties)) = widest_edge(pair, balls, hint) else { return points(balls) };
    let through = Found { contact: Contact::Edge(best), core: best.gap, ties };
    if best.gap.is_negative() {
        return through;
    }
    let outside = boundary::closest(pair, balls, best.facing).and_then(|closest| apart(pair, balls, closest));
    let beyond = outside.map(|found| (found, found.core - best.gap));
    match beyond {
        // On the line of an edge but off its end, or properly outside.
        Some((found, beyond)) if beyond.is_positive() => found,
        // No distance is less than a gap: a walk that says so was lost among products below all doubles.
        Some((found, beyond)) if best.gap.is_positive() && !beyond.is_negative() => found,
        // Outside or not: a gap is then no bound of how far away the nearest point is.
        Some((_, beyond)) if !best.gap.is_positive() => through.widened(beyond.magnitude()),
        _ => through.widened(farther(balls, best.facing, best.gap)),
    }
}

/// Two points.
fn points(balls: &BallPair) -> Found {
    let p = balls.between(0, 0);
    let core = dot(&p, &p).sqrt();
    let ties = u32::from(core.is_positive());
    Found { contact: Contact::Vertex([0, 0], p), core, ties }
}

/// The edge with the largest gap, and how many directions tie with it; None where B ⊖ A has no edges.
///
/// Of edges that tie the hinted one is taken, else the first. Parallel edges of A and B are one direction,
/// counted for A.
fn widest_edge(
    pair: &Pair,
    balls: &BallPair,
    hint: Option<DifferenceFeature>,
) -> Option<(MeasuredEdge, u32)> {
    let error = pair.gap_error();
    let mut top = f64::NEG_INFINITY;
    every_gap(pair, |_, gap| top = top.max(gap));
    let floor = if error.is_finite() { top - 2.0 * error } else { f64::NEG_INFINITY };
    let mut best: Option<MeasuredEdge> = None;
    let (mut ties, mut highest) = (0, f64::NEG_INFINITY);
    every_gap(pair, |facing, gap| {
        if gap < floor {
            return;
        }
        let measured = balls.measure(facing);
        let counts = u32::from(facing.source == Side::A || measured.partner.is_none());
        let Some(leader) = best else {
            (best, ties) = (Some(measured), counts);
            highest = measured.gap.radius;
            return;
        };
        match (measured.gap - leader.gap).sign() {
            Some(1) => {
                // What could not be told from the old leader may be above the new one too.
                let rise = (measured.gap.value - leader.gap.value).hi * (1.0 - 2.0 * f64::EPSILON);
                let above = (highest - rise).next_up();
                best = Some(measured);
                if above <= measured.gap.radius {
                    (ties, highest) = (counts, measured.gap.radius);
                } else {
                    highest = above;
                }
            }
            Some(-1) => {}
            _ => {
                ties += counts;
                // How far this one may be above the leader's centre.
                highest = highest.max((measured.gap.value - leader.gap.value).hi.abs() + measured.gap.radius);
                if [measured.facing, facing].map(DifferenceFeature::Edge).map(Some).contains(&hint) {
                    // The hinted edge leads from here on. The old leader's centre is within `highest` of
                    // its own, so that nothing is farther above it than twice that.
                    best = Some(measured);
                    highest *= 2.0;
                }
            }
        }
    });
    best.map(|measured| {
        let gap = if highest > measured.gap.radius {
            measured.gap.widen(highest - measured.gap.radius)
        } else {
            measured.gap
        };
        (MeasuredEdge { gap, ..measured }, ties.max(1))
    })
}

/// Whether the separation is exactly 0: by the sign of a polynomial, and a proof that the contact is the
/// nearest feature.
fn is_zero(pair: &Pair, balls: &BallPair, found: &Found) -> bool {
    let radius = Ball::exact(pair.radius);
    let squared = |x: Ball| x * x;
    match found.contact {
        Contact::Vertex([i, j], p) => {
            (dot(&p, &p) - squared(radius)).sign() == Some(0)
                && balls.drop_below(Side::B, j, &p) == 0.0
                && balls.drop_below(Side::A, i, &reversed(&p)) == 0.0
        }
        Contact::Edge(measured) => {
            let DifferenceEdge { source, edge, .. } = measured.facing;
            let along = balls.edge(source, edge);
            let [i, j] = measured.facing.start();
            let area = cross(&along, &balls.between(i, j));
            let gap = if source == Side::A { -area } else { area };
            // Where the cores are ρ deep in each other the squares are the same as where they are ρ apart.
            let is_as_far = if radius == Ball::ZERO {
                gap.sign() == Some(0)
            } else {
                gap.is_positive() && (squared(gap) - squared(radius) * dot(&along, &along)).sign() == Some(0)
            };
            is_as_far && holds_foot(pair, balls, &measured)
        }
    }
}

/// Whether the line of an edge of B ⊖ A supports it, and the foot of the origin on that line is certainly a
/// point of the edge.
fn holds_foot(pair: &Pair, balls: &BallPair, measured: &MeasuredEdge) -> bool {
    let DifferenceEdge { source, edge, vertex } = measured.facing;
    let along = balls.edge(source, edge);
    let other = source.other();
    let down = if source == Side::A { measured.normal } else { reversed(&measured.normal) };
    if measured.partner.is_some() && balls.drop_below(other, vertex, &down) > 0.0 {
        return false;
    }
    // Of parallel edges both ends of the partner are on the line.
    let ends = measured.partner.map_or([vertex; 2], |k| [k, pair.hull(other).next(k)]);
    let slopes = [edge, pair.hull(source).next(edge)].map(|k| {
        ends.map(|l| {
            let [i, j] = if source == Side::A { [k, l] } else { [l, k] };
            dot(&along, &balls.between(i, j)).sign()
        })
    });
    let mut slopes = slopes.iter().flatten();
    slopes.clone().any(|slope| slope.is_some_and(|sign| sign <= 0))
        && slopes.any(|slope| slope.is_some_and(|sign| sign >= 0))
}

/// The doubles nearest to the normal of a contact, from A to B in A's frame; None where points coincide.
fn normal_of(pair: &Pair, balls: &BallPair, contact: &Contact) -> Option<UnitVector> {
    match contact {
        Contact::Edge(measured) => Some(UnitVector::normalized(rounded(&measured.normal))),
        Contact::Vertex(vertices, p) => {
            let length = dot(p, p).sqrt();
            if length.radius < LOOSE * length.value.hi {
                return Some(UnitVector::normalized(rounded(&[p[0].over(length), p[1].over(length)])));
            }
            // So near that rounding may turn p out of the directions between the vertex's edges.
            boundary::normal_at(pair, balls, *vertices, p)
        }
    }
}
