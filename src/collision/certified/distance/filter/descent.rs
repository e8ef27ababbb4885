//! A guess, in plain doubles, of the feature of B ⊖ A nearest the origin: what the filter starts from.
//!
//! The distance algorithm of Gilbert, Johnson and Keerthi (1988) in its smallest form: a simplex of one or
//! two vertices `w_j − v_i`, the closest point of it, the supporting vertex beyond. It ends on indices that
//! repeat, never on a tolerance, and on a triangle that holds the origin. Nothing that it says is trusted:
//! [`crate::collision::certified::distance::filter`] proves it or asks for more.

use crate::collision::certified::distance::filter::small;
use crate::collision::certified::distance::pair::Pair;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{DVec2, Hull, Rotation, Side};

/// What the bodies seem to be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Guess {
    /// Apart, with vertices that are clearly the closest.
    Closest([usize; 2]),
    /// Apart, with these closest features.
    Apart(DifferenceFeature),
    /// Cores of few vertices that are not clearly apart.
    Crossing,
    /// One inside the other: the origin is in this triangle of vertices of B ⊖ A.
    Overlapping([Vertex; 3]),
    /// The search came to no end.
    Unclear,
}

/// A vertex of B ⊖ A: its place, and the vertices i of A and j of B that make it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Vertex {
    /// Its place `w_j − v_i`, in doubles.
    pub(crate) p: DVec2,
    /// A's vertex, counted along its core.
    pub(crate) i: usize,
    /// B's vertex, counted along its core.
    pub(crate) j: usize,
}

/// More steps than any pair of ordinary bodies takes; a search that takes more is given up.
const STEPS: usize = 64;

/// The pair in the form that the search asks: seen from A.
pub(crate) struct SupportPair<'p> {
    /// A's core.
    pub(crate) a: &'p Hull,
    /// B's core.
    pub(crate) b: &'p Hull,
    /// B's origin in A's frame.
    pub(crate) center: DVec2,
    /// From B's frame to A's.
    pub(crate) rotation: Rotation<f64>,
}

impl<'p> SupportPair<'p> {
    /// The two cores.
    #[inline]
    pub(crate) fn of(pair: &Pair<'p>) -> Self {
        let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
        Self { a, b, center: pair.center, rotation: pair.b_rotation.rounded() }
    }

    /// The vertex of B ⊖ A lowest along `n`, searched from a vertex on.
    #[inline]
    pub(crate) fn lowest(&self, n: DVec2, from: (usize, usize)) -> Vertex {
        let i = self.a.highest(n, from.0);
        let j = self.b.highest(-self.rotation.undo(n), from.1);
        Vertex { p: self.center + self.rotation.apply(self.b.vertices[j]) - self.a.vertices[i], i, j }
    }
}

/// The feature of B ⊖ A nearest the origin, or that it is better looked for otherwise.
#[inline]
pub(crate) fn guess(pair: &Pair) -> Guess {
    let supports = SupportPair::of(pair);
    let first = supports.lowest(pair.center, ANYWHERE);
    if small::are_few(pair) {
        if first.p.dot(pair.center) <= 0.0 {
            return Guess::Crossing;
        }
        match small::walk(pair, [first.i, first.j]) {
            Some(DifferenceFeature::Vertex(vertices)) => return Guess::Closest(vertices),
            Some(edge) => return Guess::Apart(edge),
            None => {}
        }
    }
    descend(&supports, first)
}

/// No vertices to start from.
pub(crate) const ANYWHERE: (usize, usize) = (usize::MAX, usize::MAX);

/// The feature of B ⊖ A nearest the origin, looked for along a first direction and from vertices of A and B
/// on: by descent alone.
#[inline]
pub(crate) fn search(supports: &SupportPair, toward: DVec2, from: (usize, usize)) -> Guess {
    descend(supports, supports.lowest(toward, from))
}

/// From a vertex of B ⊖ A to the feature that is nearest the origin.
#[inline]
fn descend(supports: &SupportPair, mut x: Vertex) -> Guess {
    let (a, b) = (supports.a, supports.b);
    let mut steps = 0;
    'vertex: loop {
        let mut y = supports.lowest(x.p, (x.i, x.j));
        if (y.i, y.j) == (x.i, x.j) {
            return Guess::Apart(DifferenceFeature::Vertex([x.i, x.j]));
        }
        loop {
            steps += 1;
            if steps > STEPS {
                return Guess::Unclear;
            }
            // The closest point of the segment x y.
            let along = y.p - x.p;
            if x.p.dot(along) >= 0.0 {
                // Rounding led away from x: x it is.
                return Guess::Apart(DifferenceFeature::Vertex([x.i, x.j]));
            }
            if y.p.dot(along) <= 0.0 {
                x = y;
                continue 'vertex;
            }
            let across = DVec2::new(-along.y, along.x);
            let height = across.dot(x.p);
            let n = if height < 0.0 { -across } else { across };
            let z = supports.lowest(n, (y.i, y.j));
            if (z.i, z.j) == (x.i, x.j) || (z.i, z.j) == (y.i, y.j) || n.dot(z.p) >= height.abs() {
                return facing(a, b, x, y)
                    .map_or(Guess::Unclear, |facing| Guess::Apart(DifferenceFeature::Edge(facing)));
            }
            // On which side of the way x → z → y the origin is: outside x z, outside z y, or inside all
            // three.
            let side = if height < 0.0 { -1.0 } else { 1.0 };
            let outside_x = side * x.p.perp_dot(z.p) < 0.0;
            let outside_y = side * z.p.perp_dot(y.p) < 0.0;
            match (outside_x, outside_y) {
                (false, false) => return Guess::Overlapping([x, z, y]),
                (true, false) => y = z,
                (false, true) => x = z,
                (true, true) => {
                    if z.p.dot(x.p - z.p) < 0.0 {
                        y = z;
                    } else if z.p.dot(y.p - z.p) < 0.0 {
                        x = z;
                    } else {
                        x = z;
                        continue 'vertex;
                    }
                }
            }
            if x.p.dot(y.p - x.p) >= 0.0 {
                continue 'vertex;
            }
        }
    }
}

/// The edge of B ⊖ A from vertex x to vertex y, or back.
#[inline]
pub(crate) fn facing(a: &Hull, b: &Hull, x: Vertex, y: Vertex) -> Option<DifferenceEdge> {
    let edge = |hull: &Hull, from: usize, to: usize| {
        if hull.next(from) == to { Some(from) } else { (hull.next(to) == from).then_some(to) }
    };
    if x.i == y.i && x.j != y.j {
        edge(b, x.j, y.j).map(|edge| DifferenceEdge { source: Side::B, edge, vertex: x.i })
    } else {
        edge(a, x.i, y.i).map(|edge| DifferenceEdge { source: Side::A, edge, vertex: x.j })
    }
}
