//! The gap along a turning axis at a moment, with four derivatives, in doubles: what the filter follows.
//!
//! With the letters of [`crate::collision::certified::impact::gap`], u = n·x and w = n·perp(x) for the
//! lowest vertex x of O:
//!
//! ```text
//! f    = n_w·D + u − h − ρ
//! f'   = ω perp(n_w)·D + n_w·V + Δω w                          ω = ω_R
//! f''  = −ω² n_w·D + 2ω perp(n_w)·V − Δω² u
//! f''' = −ω³ perp(n_w)·D − 3ω² n_w·V − Δω³ w
//! f⁗   = ω⁴ n_w·D − 4ω³ perp(n_w)·V + Δω⁴ u
//! ```
//!
//! The series says where the gap of this vertex is used up, to the fifth order; nothing is proved by it.
//! Between two moments a and b = a + L the gap is proved to stay open by its values there alone, whichever
//! vertex is lowest: if every `f_j''` ≤ K on the way, every `f_j`, and so the least of them, is at least
//!
//! ```text
//! g(τ) = g_a + (g_b − g_a) τ/L − ½ K τ (L − τ)                  0 ≤ τ ≤ L
//! ```
//!
//! The bound is useful even where `g_b` is almost 0, just before contact: as |f'| is the slope there, it
//! stays positive back to about τ = L − 2 |f'| / K.

use crate::collision::certified::impact::axis::Axis;
use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::certified::rounding::{DERIVATIVE_ERROR, MISSED_ERROR, TURNED_DOT_ERROR};
use crate::geometry::{DVec2, Hull, Rotation, Side, perp};

/// Both bodies at a moment: world axes, doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant {
    /// The moment, in [0, 1].
    pub(crate) t: f64,
    /// From the frames of A and B to the world.
    pub(crate) rotations: [Rotation<f64>; 2],
    /// From A's origin to B's: `c_B` − `c_A`.
    pub(crate) apart: DVec2,
}

/// The gap of an axis at a moment, with what its derivatives are made of. Lengths are in scaled units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TurnedGap {
    /// The moment, in [0, 1].
    pub(crate) t: f64,
    /// The gap f of the lowest vertex, within [`rounding`].
    pub(crate) value: f64,
    /// The lowest vertex, counted along O's core.
    pub(crate) lowest: usize,
    /// How far O's origin is from R's along the axis: `n_w·D`.
    offset: f64,
    /// How far across it: `perp(n_w)·D`.
    aside: f64,
    /// How fast O's origin moves along the axis, seen from R's: `n_w·V`.
    speed: f64,
    /// How fast across it: `perp(n_w)·V`.
    aside_speed: f64,
    /// How far the lowest vertex is from O's origin along the axis: u.
    along: f64,
    /// How far across it: w.
    across: f64,
    /// Bound on the distance of the origins: |D|₁.
    far: f64,
}

/// An axis that separates the bodies at a moment, with its gap there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OpenAxis {
    /// The axis, fixed in its owner's frame.
    pub(crate) axis: Axis,
    /// Its gap at that moment.
    pub(crate) gap: TurnedGap,
}

/// Newton steps on a series. Half and twice change which one or two pairs are decided.
const NEWTON: usize = 4;

/// A series is not worth a step below this part of its root: what it leaves out is more. A hundred times as
/// much or as little is not noticed.
const CLOSE_ENOUGH: f64 = 1e-7;

/// Factor that pays for the rounding of the bound K and of what is made of it: fewer than 64 operations, each
/// within ε/2; doubled.
const UP: f64 = 1.0 + 64.0 * f64::EPSILON;

/// Part of the error of a gap by which both ends of a span must be clear of it: covers what rounding makes of
/// the lowest point of g between them, of which the root's place matters to second order only. Half
/// decides no other pair, twice leaves two more of the random ones open and one of the hard ones.
const MARGIN: f64 = 0.25;

/// Bound on the error of [`TurnedGap::value`] as the least of all `f_j`.
///
/// `n_w` is within 5.8 ε, n in O's frame within 11.6 ε, its dot product with a vertex within 13.1 ε of the
/// reach; the rest as for [`MovingPair::rounding`], which allows 15. A vertex that rounding took for the
/// lowest may be 12 ε of O's reach too high: the edges that it does not tell from level ones are all but
/// parallel, at most two reaches long together, and level to 6 ε.
pub(crate) fn rounding(pair: &MovingPair) -> f64 {
    pair.rounding + MISSED_ERROR * (pair.reach[0] + pair.reach[1])
}

impl Instant {
    /// The pair at t = 0.
    #[inline]
    pub(crate) fn start(pair: &MovingPair) -> Self {
        Self { t: 0.0, rotations: pair.start, apart: pair.offset(Side::A, 0.0).0 }
    }

    /// The pair at `t`.
    #[inline]
    pub(crate) fn new(pair: &MovingPair, t: f64) -> Self {
        Self {
            t,
            rotations: [pair.rotation(Side::A, t), pair.rotation(Side::B, t)],
            apart: pair.offset(Side::A, t).0,
        }
    }
}

impl Axis {
    /// The gap at a moment, its lowest vertex looked for from `from` on; None where rounding leaves open
    /// which that is.
    #[inline]
    pub(crate) fn turned_gap(&self, pair: &MovingPair, at: &Instant, from: usize) -> Option<TurnedGap> {
        let (owner, other) = (self.owner, self.owner.other());
        let n = at.rotations[owner as usize].apply(self.n);
        let m = at.rotations[other as usize].undo(n);
        let (_, v) = pair.offset(owner, 0.0);
        let d = if owner == Side::A { at.apart } else { -at.apart };
        let hull = pair.hull(other);
        let lowest = lowest(hull, m, from)?;
        let q = hull.vertices[lowest];
        let (along, p) = (m.dot(q), perp(n));
        let offset = n.dot(d);
        Some(TurnedGap {
            t: at.t,
            value: offset + along - self.support - pair.radius.hi,
            lowest,
            offset,
            aside: p.dot(d),
            speed: n.dot(v),
            aside_speed: p.dot(v),
            along,
            across: m.dot(perp(q)),
            far: d.x.abs() + d.y.abs(),
        })
    }
}

impl TurnedGap {
    /// The coefficients cₖ of f(t + h) = Σ cₖ hᵏ up to h⁴.
    #[inline]
    pub(crate) fn series(&self, pair: &MovingPair, owner: Side) -> [f64; 5] {
        let w = pair.rate[owner as usize];
        let d = pair.rate[owner.other() as usize] - w;
        let (w2, d2) = (w * w, d * d);
        [
            self.value,
            self.slope(pair, owner),
            0.5 * (2.0 * w * self.aside_speed - w2 * self.offset - d2 * self.along),
            (-1.0 / 6.0) * (w2 * (w * self.aside + 3.0 * self.speed) + d2 * d * self.across),
            (1.0 / 24.0) * (w2 * w * (w * self.offset - 4.0 * self.aside_speed) + d2 * d2 * self.along),
        ]
    }

    /// The rate f' at which the gap changes.
    #[inline]
    pub(crate) fn slope(&self, pair: &MovingPair, owner: Side) -> f64 {
        let w = pair.rate[owner as usize];
        let spin = pair.rate[owner.other() as usize] - w;
        w * self.aside + self.speed + spin * self.across
    }

    /// Where the lowest vertex is along perp(n), seen from the owner's origin, and how fast that changes.
    #[inline]
    pub(crate) fn foot(&self, pair: &MovingPair, owner: Side) -> (f64, f64) {
        let w = pair.rate[owner as usize];
        let spin = pair.rate[owner.other() as usize] - w;
        (self.aside - self.across, self.aside_speed - w * self.offset + spin * self.along)
    }

    /// K: at least any `f_j''` between two moments.
    ///
    /// The length of D is convex in time; `n_w`·D and perp(`n_w`)·V are their chords but for an eighth of L²
    /// times their second derivatives.
    #[inline]
    pub(crate) fn curvature(&self, later: &Self, pair: &MovingPair, owner: Side) -> f64 {
        let w = pair.rate[owner as usize];
        let (w1, w2) = (w.abs(), w * w);
        let spin = (pair.rate[0] - pair.rate[1]).abs()
            + DERIVATIVE_ERROR * (pair.rate[0].abs() + pair.rate[1].abs());
        let (length, far) = (later.t - self.t, self.far.max(later.far));
        let speed = self.speed.abs() + self.aside_speed.abs();
        let bend = 0.125 * length * length;
        let offset = self.offset.min(later.offset) - bend * (w2 * far + 2.0 * w1 * speed);
        let aside = (w * self.aside_speed).max(w * later.aside_speed) + bend * w2 * w1 * speed;
        let reach = pair.reach[owner.other() as usize];
        let rounding = DERIVATIVE_ERROR * (w2 * far + w1 * speed + spin * spin * reach);
        (2.0 * aside - w2 * offset + spin * spin * reach) + 4.0 * rounding
    }

    /// Whether the gap is proved open from this moment to a `later` one on the same axis, given the bound on
    /// their errors.
    ///
    /// Both values, less their error, must be positive by [`MARGIN`] of it.
    pub(crate) fn stays_open(&self, later: &Self, pair: &MovingPair, owner: Side, error: f64) -> bool {
        let (a, b) = (self.value - error, later.value - error);
        if !(a > MARGIN * error && b > MARGIN * error) {
            return false;
        }
        let length = later.t - self.t;
        let k = self.curvature(later, pair, owner).max(0.0) * UP;
        // g' at both ends.
        let (chord, half) = ((b - a) / length, 0.5 * k * length);
        if chord >= half || -chord >= half {
            return true;
        }
        let lowest = (half - chord) / k;
        a - 0.5 * k * lowest * lowest * UP > error
    }
}

/// The first root of a series in (0, `limit`], or None where none is seen; a guess.
#[inline]
pub(crate) fn first_root(c: &[f64; 5], limit: f64) -> Option<f64> {
    let value = |h: f64| c[0] + h * (c[1] + h * (c[2] + h * (c[3] + h * c[4])));
    let slope = |h: f64| c[1] + h * (2.0 * c[2] + h * (3.0 * c[3] + h * (4.0 * c[4])));
    let discriminant = c[1] * c[1] - 4.0 * c[0] * c[2];
    let root = 2.0 * c[0] / (discriminant.max(0.0).sqrt() - c[1]);
    let mut h = if discriminant >= 0.0 && root > 0.0 && root < limit { root } else { limit };
    if h >= limit && value(limit) > 0.0 {
        return None;
    }
    for _ in 0..NEWTON {
        let step = value(h) / slope(h);
        let next = h - step;
        if !(next > 0.0 && next <= limit) {
            break;
        }
        h = next;
        if step.abs() <= CLOSE_ENOUGH * h {
            break;
        }
    }
    Some(h)
}

/// The vertex that is lowest along `m`, looked for from `from` on; None where no edge next to it clearly
/// rises: it might then be the highest of a flat core.
#[inline]
fn lowest(hull: &Hull, m: DVec2, from: usize) -> Option<usize> {
    let count = hull.edges.len();
    if count < 3 {
        return Some(hull.highest(-m, from));
    }
    let mut k = from.min(count - 1);
    let slopes = |k: usize| (m.dot(hull.edges[k]), -m.dot(hull.edges[hull.previous(k)]));
    let (mut ahead, mut behind) = slopes(k);
    if ahead < 0.0 || behind < 0.0 {
        k = hull.highest(-m, k);
        (ahead, behind) = slopes(k);
    }
    let level = TURNED_DOT_ERROR * (m.x.abs() + m.y.abs()) * 2.0 * hull.reach;
    (ahead.max(behind) > level).then_some(k)
}
