//! A guess, in plain doubles, of the feature of B ⊖ A nearest the origin: what the quick proof starts from.
//!
//! The distance algorithm of Gilbert, Johnson and Keerthi (1988) in its smallest form: a simplex of one or two corners
//! `w_j − v_i`, the closest point of it, the supporting corner beyond. It ends on indices that repeat, never on a
//! tolerance, and on a triangle that holds the origin. Nothing that it says is trusted: [`super::quick`] proves it or
//! asks for more.

use super::certify::Hint;
use super::few::{self, End};
use super::gaps::Facing;
use super::pair::Pair;
use crate::geometry::{DVec2, Hull, Side};

/// What the bodies seem to be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Guess {
    /// Apart, with corners that are clearly the closest.
    Closest([usize; 2]),
    /// Apart, with these closest features.
    Apart(Hint),
    /// Of few corners, and not clearly apart.
    Crossing,
    /// One inside the other: the origin is in this triangle of corners of B ⊖ A.
    Overlapping([Corner; 3]),
    /// The search came to no end.
    Unclear,
}

/// A corner of B ⊖ A: its place, and the corners i of A and j of B that make it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Corner {
    /// `w_j − v_i` in doubles.
    pub(super) p: DVec2,
    /// A's corner.
    pub(super) i: usize,
    /// B's corner.
    pub(super) j: usize,
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

impl<'p> Asked<'p> {
    /// The two cores.
    #[inline]
    pub(super) fn of(pair: &Pair<'p>) -> Self {
        let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
        Self { a, b, center: pair.center, turn: (pair.b_turn[0].hi, pair.b_turn[1].hi) }
    }

    /// The corner of B ⊖ A lowest along `n`, searched from a corner on.
    #[inline]
    pub(super) fn lowest(&self, n: DVec2, from: (usize, usize)) -> Corner {
        let (cos, sin) = self.turn;
        let i = self.a.highest(n, from.0);
        let down = DVec2::new(-(cos * n.x + sin * n.y), sin * n.x - cos * n.y);
        let j = self.b.highest(down, from.1);
        let q = self.b.corners[j];
        let turned = DVec2::new(cos * q.x - sin * q.y, sin * q.x + cos * q.y);
        Corner { p: self.center + turned - self.a.corners[i], i, j }
    }
}

/// The feature of B ⊖ A nearest the origin, or that it is better looked for otherwise.
#[inline]
pub(crate) fn guess(pair: &Pair) -> Guess {
    let asked = Asked::of(pair);
    let first = asked.lowest(pair.center, ANYWHERE);
    if few::are_few(pair) {
        if first.p.dot(pair.center) <= 0.0 {
            return Guess::Crossing;
        }
        match few::walk(pair, [first.i, first.j]) {
            End::Corners(corners) => return Guess::Closest(corners),
            End::Edge(facing) => return Guess::Apart(Hint::Edge(facing)),
            End::Unclear => {}
        }
    }
    descend(&asked, first)
}

/// No corners to start from.
pub(super) const ANYWHERE: (usize, usize) = (usize::MAX, usize::MAX);

/// The feature of B ⊖ A nearest the origin, looked for along a first direction and from corners of A and B on: by descent
/// alone.
#[inline]
pub(super) fn search(asked: &Asked, toward: DVec2, from: (usize, usize)) -> Guess {
    descend(asked, asked.lowest(toward, from))
}

/// From a corner of B ⊖ A to the feature that is nearest the origin.
#[inline]
fn descend(asked: &Asked, mut x: Corner) -> Guess {
    let (a, b) = (asked.a, asked.b);
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
            if (z.i, z.j) == (x.i, x.j) || (z.i, z.j) == (y.i, y.j) || n.dot(z.p) >= height.abs() {
                return facing(a, b, x, y).map_or(Guess::Unclear, |facing| Guess::Apart(Hint::Edge(facing)));
            }
            // On which side of the way x → z → y the origin is: outside x z, outside z y, or inside all three.
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
pub(super) fn facing(a: &Hull, b: &Hull, x: Corner, y: Corner) -> Option<Facing> {
    let edge = |hull: &Hull, from: usize, to: usize| {
        if hull.next(from) == to { Some(from) } else { (hull.next(to) == from).then_some(to) }
    };
    if x.i == y.i && x.j != y.j {
        edge(b, x.j, y.j).map(|edge| Facing { source: Side::B, edge, corner: x.i })
    } else {
        edge(a, x.i, y.i).map(|edge| Facing { source: Side::A, edge, corner: x.j })
    }
}
