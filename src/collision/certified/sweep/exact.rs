//! The last resort where balls leave a sweep open: separating axes and touches without any rounding.
//!
//! Where all coordinates are sums of products of doubles, as in
//! [`crate::collision::certified::distance::exact`], so is the gap along an axis that is made of them. With u
//! = `v_B` − `v_A`, n an axis from A to B, and i and j the vertices that support it, p = `w_j` − `v_i`:
//!
//! ```text
//! apart over [0, t]     n·p > ρ |n| and n·(p + t u) > ρ |n|       linear in time, so that it is between too
//! touch by t            s ≤ 0 at t; or the origin has crossed a chord of B ⊖ A; or has passed a vertex p
//!                       of it within ρ:  cross(u, p)² ≤ ρ² |u|²,  0 ≤ −u·p ≤ t |u|²
//! ```
//!
//! Bodies are apart all the while if an axis says so that is square to an edge that faces the other body at
//! the start or at the end, runs through two vertices then, or is square to the motion: the nearest points of
//! a path and a convex polygon lie on such features. The time of contact is halved from there on.

use std::cmp::Ordering;

use crate::collision::answer::Outcome;
use crate::collision::certified::distance::exact::{ExactPair, Vec2, cross, dot, plus};
use crate::collision::certified::distance::witnesses::Carrier;
use crate::collision::certified::distance::{Pair, proved, settle};
use crate::geometry::{Enclosure, Exact, Side};

/// Halvings of the time of contact: a guard, since they end at neighbouring doubles, the smallest of which
/// are 2⁻¹⁰⁷⁴ apart.
const HALVINGS: usize = 1100;

/// The outcome of a sweep of the pair, which is at t = 0, in whichever order of its bodies it can be told;
/// None where its coordinates are no sums of products of doubles, or too large or small for exact ones.
#[cold]
pub(crate) fn outcome(pair: &Pair) -> Option<Outcome> {
    in_order(pair).or_else(|| in_order(&Pair::refined_at(pair.b, pair.a, 0.0)).map(Outcome::swapped))
}

/// The outcome with A called A.
fn in_order(pair: &Pair) -> Option<Outcome> {
    let exact = ExactPair::of(pair)?;
    let ray = ExactRay { pair, u: exact.relative_velocity(), exact };
    let start = settle(pair, None);
    if start.bounds.hi <= 0.0 {
        return Some(Outcome::Overlapping { contact: start });
    }
    if start.bounds.lo <= 0.0 {
        return None;
    }
    if ray.is_free_until(1.0)? {
        return Some(Outcome::Miss);
    }
    let time = ray.halved(ray.touches_by()?)?;
    Some(Outcome::Hit { time, contact: settle(&pair.unturned_at(time.lo), None) })
}

/// A pair at t = 0 and how B moves from there, seen from A.
struct ExactRay<'p, 's> {
    /// The pair.
    pair: &'p Pair<'s>,
    /// The pair without rounding.
    exact: ExactPair<'p, 's>,
    /// B's velocity less A's: u.
    u: Vec2,
}

/// A quarter turn counter-clockwise.
fn left(v: &Vec2) -> Vec2 {
    [-&v[1], v[0].clone()]
}

/// A quarter turn clockwise.
fn right(v: &Vec2) -> Vec2 {
    [v[1].clone(), -&v[0]]
}

/// The vector times a double.
fn times(v: &Vec2, t: f64) -> Vec2 {
    let t = Exact::new(t);
    [&v[0] * &t, &v[1] * &t]
}

/// The first double at or after the quotient x / y of numbers of which y is above 0; None where that is
/// not in [0, 1].
fn first_double(x: &Exact, y: &Exact) -> Option<f64> {
    if x.sign()?.is_lt() || (x - y).sign()?.is_gt() {
        return None;
    }
    // Each is within 2 ε of itself, their quotient within 5.
    let mut t = x.rounded() / y.rounded() * (1.0 - 8.0 * f64::EPSILON);
    while (&(&Exact::new(t) * y) - x).sign()?.is_lt() {
        t = t.next_up();
    }
    Some(t)
}

impl ExactRay<'_, '_> {
    /// Whether an axis keeps the bodies apart over [0, t].
    fn is_free_until(&self, t: f64) -> Option<bool> {
        let mut axes = Vec::new();
        for moment in [t, 0.0] {
            let carrier = proved(&self.pair.unturned_at(moment), None).carrier;
            let vertices = match carrier {
                Carrier::Vertex(vertices) => vertices,
                Carrier::Edge(facing) | Carrier::ParallelEdges(facing, _) => facing.start(),
            };
            axes.extend(self.square_to_edges(&carrier, vertices).map(|n| (n, vertices)));
            axes.push((plus(&self.exact.between(vertices), &times(&self.u, moment)), vertices));
            axes.extend([left(&self.u), right(&self.u)].map(|n| (n, vertices)));
        }
        for (n, vertices) in axes {
            if self.separates(&n, vertices, t)? {
                return Some(true);
            }
        }
        Some(false)
    }

    /// Axes from A to B square to the edge that carries a separation, or to those at two vertices.
    fn square_to_edges(&self, carrier: &Carrier, [i, j]: [usize; 2]) -> impl Iterator<Item = Vec2> {
        let [a, b] = [Side::A, Side::B].map(|side| self.pair.hull(side));
        let edges = match *carrier {
            Carrier::Edge(facing) | Carrier::ParallelEdges(facing, _) => vec![(facing.source, facing.edge)],
            Carrier::Vertex(_) => [(Side::A, a, i), (Side::B, b, j)]
                .into_iter()
                .filter(|(_, hull, _)| !hull.edges.is_empty())
                .flat_map(|(side, hull, k)| [(side, k), (side, hull.previous(k))])
                .collect(),
        };
        edges.into_iter().map(|(side, k)| {
            let e = self.exact.edge(side, k);
            if side == Side::A { right(&e) } else { left(&e) }
        })
    }

    /// Whether the gap along `n` is open at 0 and at `t`; it is looked for from these vertices on.
    fn separates(&self, n: &Vec2, vertices: [usize; 2], t: f64) -> Option<bool> {
        let p = self.exact.between(self.supports(n, vertices)?);
        let reach = &(&self.exact.radius * &self.exact.radius) * &dot(n, n);
        let is_open = |p: &Vec2| -> Option<bool> {
            let gap = dot(n, p);
            Some(gap.sign()?.is_gt() && (&(&gap * &gap) - &reach).sign()?.is_gt())
        };
        Some(is_open(&p)? && is_open(&plus(&p, &times(&self.u, t)))?)
    }

    /// A's vertex that is highest along `n` and B's that is lowest, from these on.
    fn supports(&self, n: &Vec2, vertices: [usize; 2]) -> Option<[usize; 2]> {
        let mut found = vertices;
        for (side, k, ahead) in [(Side::A, 0, Ordering::Greater), (Side::B, 1, Ordering::Less)] {
            let hull = self.pair.hull(side);
            // Each step goes strictly along n: at most once round.
            for _ in 0..hull.edges.len() {
                let (here, back) = (found[k], hull.previous(found[k]));
                if dot(n, &self.exact.edge(side, here)).sign()? == ahead {
                    found[k] = hull.next(here);
                } else if dot(n, &self.exact.edge(side, back)).sign()? == ahead.reverse() {
                    found[k] = back;
                } else {
                    break;
                }
            }
        }
        Some(found)
    }

    /// A moment by which the bodies touch; None where that is not proved.
    fn touches_by(&self) -> Option<f64> {
        if self.touches_at(1.0) {
            return Some(1.0);
        }
        let [a, b] = [Side::A, Side::B].map(|side| self.pair.hull(side));
        let ends = [self.supports(&left(&self.u), [0, 0])?, self.supports(&right(&self.u), [0, 0])?];
        if let Some(t) = self.crosses_between(ends) {
            return Some(t);
        }
        for [i, j] in ends {
            // Of an edge along the motion either end may come first.
            for i in [i, a.next(i), a.previous(i)] {
                for j in [j, b.next(j), b.previous(j)] {
                    if let Some(t) = self.passes_within([i, j]) {
                        return Some(t);
                    }
                }
            }
        }
        None
    }

    /// When the origin crosses the chord of B ⊖ A between the vertices that are farthest to either side of
    /// its way, rounded up; None where that is not in [0, 1].
    fn crosses_between(&self, [p, q]: [[usize; 2]; 2]) -> Option<f64> {
        let (p, q) = (self.exact.between(p), self.exact.between(q));
        let [low, high] = [&p, &q].map(|x| cross(&self.u, x));
        let width = &high - &low;
        if low.sign()?.is_gt() || high.sign()?.is_lt() || width.sign()?.is_eq() {
            return None;
        }
        let along = &(&low * &dot(&self.u, &q)) - &(&high * &dot(&self.u, &p));
        first_double(&along, &(&width * &dot(&self.u, &self.u)))
    }

    /// When a vertex of B ⊖ A is nearest the origin, rounded up; None where that is not in [0, 1], or not
    /// within ρ.
    fn passes_within(&self, vertices: [usize; 2]) -> Option<f64> {
        let p = self.exact.between(vertices);
        let (across, along, square) = (cross(&self.u, &p), -&dot(&self.u, &p), dot(&self.u, &self.u));
        let reach = &(&self.exact.radius * &self.exact.radius) * &square;
        if square.sign()?.is_eq() || (&(&across * &across) - &reach).sign()?.is_gt() {
            return None;
        }
        first_double(&along, &square)
    }

    /// Whether the bodies touch or overlap at `t`.
    fn touches_at(&self, t: f64) -> bool {
        settle(&self.pair.unturned_at(t), None).bounds.hi <= 0.0
    }

    /// The time of contact, given a moment by which the bodies touch: as narrow as the two proofs meet.
    fn halved(&self, by: f64) -> Option<Enclosure> {
        let (mut lo, mut hi) = (0.0, by);
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(lo, hi);
            if middle <= lo || middle >= hi {
                break;
            }
            if self.is_free_until(middle)? {
                lo = middle;
            } else if self.touches_at(middle) {
                hi = middle;
            } else {
                break;
            }
        }
        Some(Enclosure { lo, hi })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Sweep;
    use crate::collision::tests::bodies::{moving, placed, polygon};
    use crate::geometry::Body;
    use tracefig_reference::random::Random;

    /// The outcomes of a sweep in both orders.
    fn both_ways(a: &Body, b: &Body) -> [Outcome; 2] {
        [Sweep::new(a, b).first_contact(), Sweep::new(b, a).first_contact()]
    }

    #[test]
    fn discs_that_graze_in_tenths_touch_where_their_doubles_say_so() {
        let disc = |radius, x, y| placed(polygon(&[[0.0, 0.0]], radius), x, y, 0.0);
        // 3.6 − 1.6 and 1.2 + 0.8 are 2 of their doubles too.
        let (a, b) = (disc(1.2, -2.7, -1.6), moving(disc(0.8, 0.0, -3.6), [-5.4, 0.0], 0.0));
        for found in both_ways(&a, &b) {
            let Outcome::Hit { time, .. } = found else { panic!("{found:?}") };
            assert!(time.lo < 0.5 && 0.5 <= time.hi && time.hi - time.lo < 1e-16, "{time:?}");
        }
        let above =
            Body { position: b.position + crate::geometry::DVec2::new(0.0, -f64::EPSILON * 4.0), ..b };
        assert_eq!(both_ways(&a, &above), [Outcome::Miss, Outcome::Miss]);
    }

    #[test]
    fn corners_that_pass_corners_in_tenths_are_told_to_touch_or_to_miss() {
        let mut random = Random::new(23);
        let mut tenth = |lo: f64, hi: f64| (random.between(lo, hi) * 10.0).round() / 10.0;
        for _ in 0..300 {
            let mut square = || {
                let (x, y) = (tenth(0.1, 3.0), tenth(0.1, 3.0));
                (polygon(&[[-x, -y], [x, -y], [x, y], [-x, y]], 0.0), x, y)
            };
            let ((p, x, y), (q, w, h)) = (square(), square());
            let a = placed(p, tenth(-5.0, 5.0), tenth(-5.0, 5.0), 0.0);
            let u = [-tenth(1.0, 9.0), tenth(1.0, 9.0)];
            // At a half of the way B's lower right corner is at A's upper left one, but for rounding.
            let corner = [a.position.x - x - w, a.position.y + y + h];
            let across = [corner[0] - 0.5 * u[0], corner[1] + 0.5 * u[0]];
            let b = moving(placed(q, across[0], across[1], 0.0), [u[0], -u[0]], 0.0);
            for found in both_ways(&a, &b) {
                assert!(!matches!(found, Outcome::Unresolved { .. }), "{found:?}: {a:?} {b:?}");
            }
        }
    }
}
