//! A guess, in plain doubles, of the feature of B ⊖ A nearest the origin: what the quick proof starts from.
//!
//! The distance algorithm of Gilbert, Johnson and Keerthi (1988) in its smallest form: a simplex of one or two corners
//! `w_j − v_i`, the closest point of it, the supporting corner beyond. It ends on indices that repeat, never on a
//! tolerance, and on a triangle that holds the origin. Nothing that it says is trusted: [`super::quick`] proves it or
//! asks for more.

use super::certify::Hint;
use super::gaps::Facing;
use super::pair::Pair;
use crate::geometry::{DVec2, Hull, Side};

/// What the bodies seem to be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Guess {
    /// Apart, with these closest features.
    Apart(Hint),
    /// One inside the other.
    Overlapping,
    /// The search came to no end.
    Unclear,
}

/// A corner of B ⊖ A: its place, and the corners i of A and j of B that make it.
#[derive(Clone, Copy)]
struct Corner {
    p: DVec2,
    i: usize,
    j: usize,
}

/// More steps than any pair of ordinary bodies takes; a search that takes more is given up.
const STEPS: usize = 64;

/// The pair in the form that the search asks: seen from A.
pub(super) struct Asked<'p> {
    /// A's core.
    pub(super) a: &'p Hull,
    /// B's core.
    pub(super) b: &'p Hull,
    /// B's origin.
    pub(super) center: DVec2,
    /// Cosine and sine of B's turn.
    pub(super) turn: (f64, f64),
}

impl Asked<'_> {
    /// The corner of B ⊖ A lowest along `n`, searched from a corner on.
    #[inline]
    fn lowest(&self, n: DVec2, from: (usize, usize)) -> Corner {
        let (cos, sin) = self.turn;
        let i = self.a.highest(n, from.0);
        let down = DVec2::new(-(cos * n.x + sin * n.y), sin * n.x - cos * n.y);
        let j = self.b.highest(down, from.1);
        let q = self.b.corners[j];
        let turned = DVec2::new(cos * q.x - sin * q.y, sin * q.x + cos * q.y);
        Corner { p: self.center + turned - self.a.corners[i], i, j }
    }
}

/// The feature of B ⊖ A nearest the origin.
#[inline]
pub(crate) fn guess(pair: &Pair) -> Guess {
    let turn = (pair.b_turn[0].hi, pair.b_turn[1].hi);
    let asked = Asked { a: pair.hull(Side::A), b: pair.hull(Side::B), center: pair.center, turn };
    search(&asked, pair.center, ANYWHERE)
}

/// No corners to start from.
pub(super) const ANYWHERE: (usize, usize) = (usize::MAX, usize::MAX);

/// The same, looked for along a first direction and from corners of A and B on.
#[inline]
pub(super) fn search(asked: &Asked, toward: DVec2, from: (usize, usize)) -> Guess {
    let (a, b) = (asked.a, asked.b);
    let mut x = asked.lowest(toward, from);
    let mut steps = 0;
    'corner: loop {
        let mut y = asked.lowest(x.p, (x.i, x.j));
        if (y.i, y.j) == (x.i, x.j) {
            return Guess::Apart(Hint::Corners([x.i, x.j]));
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
                return Guess::Apart(Hint::Corners([x.i, x.j]));
            }
            if y.p.dot(along) <= 0.0 {
                x = y;
                continue 'corner;
            }
            let across = DVec2::new(-along.y, along.x);
            let height = across.dot(x.p);
            let n = if height < 0.0 { -across } else { across };
            let z = asked.lowest(n, (y.i, y.j));
            if (z.i, z.j) == (x.i, x.j) || (z.i, z.j) == (y.i, y.j) {
                return facing(a, b, x, y);
            }
            let depth = n.dot(z.p);
            if depth >= height.abs() {
                return facing(a, b, x, y);
            }
            // On which side of the way x → z → y the origin is: outside x z, outside z y, or inside all three.
            let side = if height < 0.0 { -1.0 } else { 1.0 };
            let outside_x = side * x.p.perp_dot(z.p) < 0.0;
            let outside_y = side * z.p.perp_dot(y.p) < 0.0;
            match (outside_x, outside_y) {
                (false, false) => return Guess::Overlapping,
                (true, false) => y = z,
                (false, true) => x = z,
                (true, true) => {
                    if z.p.dot(x.p - z.p) < 0.0 {
                        y = z;
                    } else if z.p.dot(y.p - z.p) < 0.0 {
                        x = z;
                    } else {
                        x = z;
                        continue 'corner;
                    }
                }
            }
            if x.p.dot(y.p - x.p) >= 0.0 {
                continue 'corner;
            }
        }
    }
}

/// The edge of B ⊖ A from corner x to corner y, or back.
#[inline]
fn facing(a: &Hull, b: &Hull, x: Corner, y: Corner) -> Guess {
    let edge = |hull: &Hull, from: usize, to: usize| {
        if hull.next(from) == to { Some(from) } else { (hull.next(to) == from).then_some(to) }
    };
    let found = if x.j == y.j {
        edge(a, x.i, y.i).map(|edge| Facing { source: Side::A, edge, corner: x.j })
    } else if x.i == y.i {
        edge(b, x.j, y.j).map(|edge| Facing { source: Side::B, edge, corner: x.i })
    } else {
        edge(a, x.i, y.i).map(|edge| Facing { source: Side::A, edge, corner: x.j })
    };
    found.map_or(Guess::Unclear, |facing| Guess::Apart(Hint::Edge(facing)))
}
