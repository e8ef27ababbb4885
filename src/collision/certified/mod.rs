//! What proves the numbers: bodies in, enclosures out; no query, no event.
//!
//! # The promise
//!
//! Every bound encloses the exact answer to the bodies as their doubles say them (angles in degrees or
//! radians, exactly), all rounding included; a verdict is given only where it holds for the exact reals. What
//! cannot be decided is said to be undecided, never guessed.
//!
//! # The three means
//!
//! ```text
//! filter      doubles guess the answer, and check it against a bound on all their rounding that is known
//!             beforehand (rounding/). It decides most questions, and only speed needs it: each room asks
//!             its filter/ in one line, and answers as truly without it
//! balls       double-doubles that carry a radius, within which the exact number surely is. A sign is certain
//!             where all numbers in the ball have it
//! polynomial  where a ball holds 0 and the question is whether the number is 0: the sign of a polynomial in
//!             the coordinates, which has no roots to round and is exact more often
//! ```
//!
//! # The rooms, and the doors to them
//!
//! [`distance`] proves the separation of a pair at one moment, [`sweep`] the first contact of bodies that do
//! not turn, [`impact`] that of bodies that do, [`approach`] how near bodies come that never touch, [`clip`]
//! the points of contact of bodies that do.
//! Algorithms come in by [`distance::certify`] and [`distance::Pair`], [`sweep::Sweep`],
//! [`impact::MovingPair`], [`approach::closest_approach`] and [`clip::clipped`]; the modules behind them are
//! this storey's own. Inside, `distance` uses none of the others, `clip` only that, `impact` a ray from
//! `sweep`, `sweep` the whole of `impact` where a ray is not enough, and `approach` the distances and the
//! axes that are followed through time.
//!
//! # The letters
//!
//! ```text
//! A, B        the two bodies; i a vertex of A, v_i, and j one of B, q_j in B's frame and w_j in A's
//! B ⊖ A       all differences w − v: the bodies overlap where it holds the origin
//! c, D        B's origin seen from A's, at a moment
//! n           the unit normal of an edge or a contact, from A to B (of an axis: from its owner to the other)
//! ρ           r_A + r_B, the radii of rounded bodies
//! g, f        a gap: of the cores along n at one moment; along an axis that turns, less ρ
//! s           the separation: positive apart, negative inside
//! v, ω, Δω    the closing velocity v_A − v_B of a ray; spins in radians, and their difference
//! ε, M, S, Σ  as in rounding/
//! ```

pub(crate) mod approach;
pub(crate) mod clip;
pub(crate) mod distance;
pub(crate) mod impact;
pub(crate) mod rounding;
pub(crate) mod sweep;
