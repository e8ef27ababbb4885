//! The last resort where balls leave open whether bodies touch: polynomials without any rounding.
//!
//! Where both bodies are turned by quarter turns, or by matrices of doubles, all coordinates are sums of
//! products of the file's doubles, and so are these; their signs are certain ([`crate::geometry::Exact`]).
//! With e an edge of B ⊖ A, w the vertex that starts it, d a vertex of B ⊖ A and ρ = `r_A` + `r_B`:
//!
//! ```text
//! lower    s ≥ (e × w)/|e| − ρ            along the outward normal of an edge with its lowest vertex
//!          s = |d| − ρ                    if no edge at the vertices of d leads nearer
//! upper    s ≤ (e × w)/|e| − ρ            if the foot of the origin lies on the edge, and the cores are
//! apart
//!          s ≤ |d| − ρ                    of any two vertices
//!          s ≤ the greatest of the gaps   of all edges, if none is above 0, ρ = 0 and B ⊖ A has an inside
//! x − ρ y = (x² − ρ² y²) / (x + ρ y)      for x > 0, so that no root has to be exact
//! ```
//!
//! Bodies that touch exactly are so found to, whichever of them is called A.

use std::cmp::Ordering;

use crate::collision::certified::distance::gaps::every_gap;
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::distance::witnesses::Carrier;
use crate::collision::feature::DifferenceEdge;
use crate::geometry::{Body, Enclosure, Exact, Side};

/// A vector of exact numbers.
pub(crate) type Vec2 = [Exact; 2];

/// Edges that may be the nearest at most: more of them tie only where bodies are all but points.
const EDGES: usize = 64;

/// Error of a bound that is rounded at the end, relative to it: fewer than 16 operations.
const ROUNDED: f64 = 16.0 * f64::EPSILON;

/// Bounds of the separation of a pair whose nearest feature seems to be `carrier`, from exact arithmetic;
/// None where coordinates are not sums of products of doubles. World units.
#[cold]
pub(crate) fn bounds(pair: &Pair, carrier: &Carrier) -> Option<Enclosure> {
    let exact = ExactPair::of(pair)?;
    let (mut lo, mut hi) = (f64::NEG_INFINITY, f64::INFINITY);
    let vertices = match *carrier {
        Carrier::Vertex(vertices) => vertices,
        Carrier::Edge(facing) | Carrier::ParallelEdges(facing, _) => facing.start(),
    };
    let between = exact.between(vertices);
    let distance = exact.beyond(&dot(&between, &between), &Exact::new(1.0))?;
    hi = hi.min(distance.hi);
    if exact.is_nearest(vertices, &between)? {
        lo = lo.max(distance.lo);
    }
    let mut widest = f64::NEG_INFINITY;
    for facing in exact.candidates()? {
        let measured = exact.measure(facing)?;
        lo = lo.max(measured.gap.lo);
        if measured.holds_foot {
            hi = hi.min(measured.gap.hi);
        }
        widest = widest.max(measured.gap.hi);
    }
    if widest <= 0.0 && exact.radius.sign()?.is_eq() && exact.has_inside() {
        hi = hi.min(widest);
    }
    let unscale = pair.unscale();
    // A power of two changes no bit but of what is below all normal doubles.
    let (low, high) = (lo * unscale, hi * unscale);
    Some(Enclosure {
        lo: if low / unscale > lo { low.next_down() } else { low },
        hi: if high / unscale < hi { high.next_up() } else { high },
    })
}

/// A pair of which all coordinates are sums of products of doubles, in A's frame.
pub(crate) struct ExactPair<'p, 's> {
    /// The pair.
    pair: &'p Pair<'s>,
    /// B's origin.
    center: Vec2,
    /// Quarter turns of A in the world.
    frame: u8,
    /// Quarter turns of B.
    quarters: u8,
    /// Both radii together, ρ.
    pub(crate) radius: Exact,
}

/// An edge of B ⊖ A, exactly.
struct MeasuredEdge {
    /// Bounds of the gap along its normal, less ρ.
    gap: Enclosure,
    /// Whether the foot of the origin lies on it, and the cores are apart or touch.
    holds_foot: bool,
}

impl<'p, 's> ExactPair<'p, 's> {
    /// The pair; None where its coordinates are no such sums.
    pub(crate) fn of(pair: &'p Pair<'s>) -> Option<Self> {
        let (frame, quarters) = (pair.frame.quarters()?, pair.turn.quarters()?);
        let coordinate = |of: fn(&Body) -> [f64; 2]| {
            let ([from, v], [to, w]) = (of(pair.a), of(pair.b));
            let scaled = |x: f64| Exact::scaled(x, pair.scale);
            let moved = &(&scaled(w) - &scaled(v)) * &Exact::new(pair.time);
            &(&scaled(to) - &scaled(from)) + &moved
        };
        let apart = [
            coordinate(|body| [body.position.x, body.velocity.x]),
            coordinate(|body| [body.position.y, body.velocity.y]),
        ];
        let scaled = |x: f64| Exact::scaled(x, pair.scale);
        let radius = &scaled(pair.a.shape.radius) + &scaled(pair.b.shape.radius);
        Some(Self { pair, center: turned(&apart, 4 - frame), frame, quarters, radius })
    }

    /// B's velocity less A's.
    pub(crate) fn relative_velocity(&self) -> Vec2 {
        let (a, b) = (self.pair.a.velocity, self.pair.b.velocity);
        let speed = |of_a: f64, of_b: f64| {
            &Exact::scaled(of_b, self.pair.scale) - &Exact::scaled(of_a, self.pair.scale)
        };
        turned(&[speed(a.x, b.x), speed(a.y, b.y)], 4 - self.frame)
    }

    /// A vertex of a core.
    fn vertex(&self, side: Side, k: usize) -> Vec2 {
        let shape = self.pair.shape(side);
        let written = shape.core.get(k).and_then(|&i| shape.vertices.get(i)).copied().unwrap_or_default();
        let [x, y] = written.to_array().map(|x| Exact::scaled(x, self.pair.scale));
        let local = if shape.is_as_written() {
            [x, y]
        } else {
            let (c, s) = (Exact::new(shape.matrix.cos), Exact::new(shape.matrix.sin));
            [&(&c * &x) - &(&s * &y), &(&s * &x) + &(&c * &y)]
        };
        match side {
            Side::A => local,
            Side::B => plus(&self.center, &turned(&local, self.quarters)),
        }
    }

    /// Edge k of a core, from its vertex to the next.
    pub(crate) fn edge(&self, side: Side, k: usize) -> Vec2 {
        minus(&self.vertex(side, self.pair.hull(side).next(k)), &self.vertex(side, k))
    }

    /// Vertex j of B less vertex i of A.
    pub(crate) fn between(&self, [i, j]: [usize; 2]) -> Vec2 {
        minus(&self.vertex(Side::B, j), &self.vertex(Side::A, i))
    }

    /// Whether B ⊖ A has an inside: a core has, or the cores are segments that are not parallel.
    fn has_inside(&self) -> bool {
        let [a, b] = [Side::A, Side::B].map(|side| self.pair.hull(side).vertices.len());
        let crossing = || cross(&self.edge(Side::A, 0), &self.edge(Side::B, 0)).sign();
        a > 2 || b > 2 || (a == 2 && b == 2 && crossing().is_some_and(Ordering::is_ne))
    }

    /// Whether no edge at these vertices leads nearer along the vector `d` between them: then they are the
    /// nearest points of the cores.
    fn is_nearest(&self, vertices: [usize; 2], d: &Vec2) -> Option<bool> {
        for (side, k) in [Side::A, Side::B].into_iter().zip(vertices) {
            let hull = self.pair.hull(side);
            if hull.edges.is_empty() {
                continue;
            }
            let ahead = dot(d, &self.edge(side, k)).sign()?;
            let behind = dot(d, &self.edge(side, hull.previous(k))).sign()?;
            let (ahead, behind) =
                if side == Side::B { (ahead, behind) } else { (ahead.reverse(), behind.reverse()) };
            if ahead.is_lt() || behind.is_gt() {
                return Some(false);
            }
        }
        Some(dot(d, d).sign()?.is_gt())
    }

    /// The edges of B ⊖ A whose gap may be the widest; None where there are too many.
    fn candidates(&self) -> Option<Vec<DifferenceEdge>> {
        let error = self.pair.gap_error();
        let mut top = f64::NEG_INFINITY;
        every_gap(self.pair, |_, gap| top = top.max(gap));
        let floor = if error.is_finite() { top - 2.0 * error } else { f64::NEG_INFINITY };
        let mut found = Vec::new();
        every_gap(self.pair, |facing, gap| {
            if gap >= floor && found.len() <= EDGES {
                found.push(facing);
            }
        });
        (found.len() <= EDGES).then_some(found)
    }

    /// An edge of B ⊖ A with its lowest vertex.
    fn measure(&self, facing: DifferenceEdge) -> Option<MeasuredEdge> {
        let DifferenceEdge { source, edge, mut vertex } = facing;
        let (other, e) = (source.other(), self.edge(source, edge));
        let outward = [e[1].clone(), -&e[0]];
        let hull = self.pair.hull(other);
        // Each step goes strictly down along the outward normal: at most once round.
        for _ in 0..hull.edges.len() {
            let back = hull.previous(vertex);
            if dot(&outward, &self.edge(other, vertex)).sign()?.is_lt() {
                vertex = hull.next(vertex);
            } else if dot(&outward, &self.edge(other, back)).sign()?.is_gt() {
                vertex = back;
            } else {
                break;
            }
        }
        let seen = |k: usize| minus(&self.vertex(other, k), &self.vertex(source, edge));
        let (along, height) = (|v: &Vec2| dot(v, &e), |v: &Vec2| dot(v, &outward));
        let (lowest, whole) = (seen(vertex), dot(&e, &e));
        // Of an edge that is level, all is above that is between its ends.
        let mut ends = [along(&lowest), along(&lowest)];
        for k in [hull.previous(vertex), hull.next(vertex)] {
            let v = seen(k);
            if !hull.edges.is_empty() && height(&minus(&v, &lowest)).sign()?.is_eq() {
                let at = along(&v);
                let is_lower = (&at - &ends[0]).sign()?.is_lt();
                ends[usize::from(!is_lower)] = at;
            }
        }
        let gap = height(&lowest);
        let on_edge = ends[1].sign()?.is_ge() && (&ends[0] - &whole).sign()?.is_le();
        let holds_foot = on_edge && gap.sign()?.is_ge();
        // gap/|e| − ρ, with both squared where they are not negative.
        let bounds = if gap.sign()?.is_lt() {
            let below = gap.rounded() / whole.rounded().sqrt() - self.radius.rounded();
            around(below)
        } else {
            self.beyond(&(&gap * &gap), &whole)?
        };
        Some(MeasuredEdge { gap: bounds, holds_foot })
    }

    /// Bounds of √(x / y) − ρ.
    fn beyond(&self, x: &Exact, y: &Exact) -> Option<Enclosure> {
        let difference = x - &(&(&self.radius * &self.radius) * y);
        let (x, y) = (x.rounded(), y.rounded());
        Some(match difference.sign()? {
            Ordering::Equal => Enclosure { lo: 0.0, hi: 0.0 },
            _ => around(difference.rounded() / (y * ((x / y).sqrt() + self.radius.rounded()))),
        })
    }
}

/// Bounds of a number that was rounded a few times, each to a part of itself.
fn around(x: f64) -> Enclosure {
    let error = x.abs() * ROUNDED + f64::MIN_POSITIVE;
    Enclosure { lo: x - error, hi: x + error }
}

/// x after so many quarter turns.
fn turned([x, y]: &Vec2, quarters: u8) -> Vec2 {
    match quarters & 3 {
        0 => [x.clone(), y.clone()],
        1 => [-y, x.clone()],
        2 => [-x, -y],
        _ => [y.clone(), -x],
    }
}

/// The sum x + y.
pub(crate) fn plus(x: &Vec2, y: &Vec2) -> Vec2 {
    [&x[0] + &y[0], &x[1] + &y[1]]
}

/// The difference x − y.
pub(crate) fn minus(x: &Vec2, y: &Vec2) -> Vec2 {
    [&x[0] - &y[0], &x[1] - &y[1]]
}

/// The dot product x · y.
pub(crate) fn dot(x: &Vec2, y: &Vec2) -> Exact {
    &(&x[0] * &y[0]) + &(&x[1] * &y[1])
}

/// The cross product x₁ y₂ − x₂ y₁.
pub(crate) fn cross(x: &Vec2, y: &Vec2) -> Exact {
    &(&x[0] * &y[1]) - &(&x[1] * &y[0])
}
