//! Every bound on rounding that is known before anything is computed, in one table, and the range in which
//! they hold.
//!
//! A filter computes in doubles and trusts what is clear of such a bound; what is not clear is left to balls,
//! which carry their own radius. A bound is a number times a size. Letters:
//!
//! ```text
//! ε     2⁻⁵², the distance from 1 to the next double
//! u     ε/2: a sum, product, quotient or root of doubles is within u of itself
//! M     |c|₁ + reach_A + reach_B: no coordinate of the pair in A's frame is larger         Pair::magnitude
//! S     |p_B − p_A|₁ + |(v_B − v_A) t|₁ + reach_A + reach_B + ρ: M + ρ for an algorithm    algorithm::view
//! Σ     |D₀|₁ + |V|₁ + 3/2 (reach_A + reach_B) + ρ, over the whole motion                  MovingPair
//! ρ     r_A + r_B
//! |x|₁  the 1-norm |x.x| + |x.y|: not below the length, not above √2 of it
//! ```
//!
//! | bound                | value  | times                | of what                                     |
//! |----------------------|--------|----------------------|---------------------------------------------|
//! | [`GAP_ERROR`]        | 16 ε   | M, S                 | a gap along an edge's normal at one moment  |
//! | [`DOT_ERROR`]        | 8 ε    | \|x\|₁ \|y\|₁        | a dot or cross product, one vector turned   |
//! | [`LEVEL_ERROR`]      | 12 ε   | \|edge\|₁            | whether an edge is level to a unit normal   |
//! | [`OFFSET_ERROR`]     | 13 ε   | \|v\|₁ (M + ρ)       | how far a vertex is off a ray's line        |
//! | [`PLACING_ERROR`]    | 32 ε²  | M                    | a vertex of B ⊖ A in double-doubles         |
//! | [`LAST_ERROR`]       | 64 ε²  | M + ρ                | the distance of such a vertex, less ρ       |
//! | [`REST_ERROR`]       | 128 ε² | M + ρ, \|q\| \|v\|₁  | what is left of a gap that a ray closes     |
//! | [`MOVING_GAP_ERROR`] | 12 ε   | Σ                    | a gap along an axis that turns              |
//! | [`MISSED_ERROR`]     | 12 ε   | both reaches         | a lowest vertex that rounding missed        |
//! | [`TURNED_DOT_ERROR`] | 16 ε   | \|x\|₁ \|y\|₁        | a dot product, one vector turned twice      |
//! | [`DERIVATIVE_ERROR`] | 16 ε   | its terms            | a derivative of a gap along such an axis    |
//! | [`ROOT_ERROR`]       | 16 ε   | itself               | the first root of a parabola                |
//! | [`EXTREME_ERROR`]    | 4 ε    | \|p + v t\| + reach  | a coordinate of a body in the world         |
//!
//! The bounds of one cosine, sine, normal, double-double or ball stand with these in [`crate::geometry`]. A
//! test measures every row against 320 bits. It fails where a bound is exceeded, and where it is ten times
//! what there is to bound.

use std::ops::Range;

/// ε: the distance from 1 to the next double.
const E: f64 = f64::EPSILON;

/// Sizes of scenes, 2^±200, that are computed as they are; others are multiplied by a power of two first.
///
/// Products of four lengths, and what Dekker's product leaves out of them, are then far from overflow and
/// underflow: 2⁸⁰⁰ and 2⁻⁸⁰⁰⁻¹⁰⁶ of 2¹⁰²⁴ and 2⁻¹⁰²². At the tenth power of either end a length itself is no
/// double any more.
pub(crate) const TAME: Range<f64> = f64::from_bits((1023 - 200) << 52)..f64::from_bits((1023 + 200) << 52);

/// 2⁻⁹⁶⁰: a scaled number below it may have lost bits to underflow, and its ball is widened by as much.
///
/// The scene itself is scaled to about 1, so that this is far below any rounding that is seen.
pub(crate) const LOSSY: f64 = f64::from_bits((1023 - 960) << 52);

/// Error of a gap along an edge's normal in doubles, times M; of a distance of vertices too. Lengths.
///
/// For an edge of A, n·c + (Rᵀn)·q − h, in parts of |c|, reach A and reach B:
///
/// ```text
/// c     its own rounding u, and ⅛ ε from cosine and sine                    0.7 ε |c|
/// n     ¼ ε a component, the same for all three terms                       0.4 ε (|c| + reach_A + reach_B)
/// Rᵀn   cosine and sine within 5/16 ε, two products and a sum, √2           1.7 ε reach_B
/// dots  two products and a sum each                                         ε (|c| + reach_A + reach_B)
/// sums  of the three                                                        ε (|c| + reach_A + reach_B)
/// q     a support that rounding missed, 3.5 ε of the edges passed           7 ε reach_B
/// ```
///
/// The edges passed are level but for rounding, and so no longer than two reaches together. Where a matrix
/// multiplies the cores, their vertices are rounded by 0.7 ε of each reach. The largest sum
/// is that of `reach_B`, below 12 ε; for an edge of B, c is turned as well, 1.7 ε |c| more. Rounded up to a
/// power of two. An algorithm chooses supports by signs that are certain and misses none.
pub(crate) const GAP_ERROR: f64 = 16.0 * E;

/// Error of a dot product of two vectors of a pair, times the product of their 1-norms; of a cross product
/// too. No dimension.
///
/// Vertices, edges and normals are within 4 ε of theirs, of one of the two, as only one has been turned; the
/// products and the sum add 1.5 ε. Rounded up to a power of two. A component that cancels as it is turned has
/// this error of the whole vector, not of itself.
pub(crate) const DOT_ERROR: f64 = 8.0 * E;

/// Error of a dot product of an edge and a unit normal that was turned into its frame, times the edge's
/// 1-norm. No dimension.
///
/// √2 [`DOT_ERROR`], as no unit vector has a larger 1-norm. Rounded up.
pub(crate) const LEVEL_ERROR: f64 = 12.0 * E;

/// Error of the offset of a vertex of B ⊖ A from a ray's line, times |v|₁ (M + ρ). Lengths times speeds.
///
/// With u the ray's direction turned left, u·c + u·R q − u·v + ρ u·N, in parts of |v| |c|, |v| `reach_A` and
/// so on:
///
/// ```text
/// u     v in doubles, half an ulp                                           0.5 ε of all
/// c     as for GAP_ERROR                                                  0.7 ε |c|
/// Rᵀu   as there                                                            1.7 ε reach_B
/// dots  two products and a sum each                                         ε of all
/// sums  of the four                                                         1.5 ε of all
/// q, v  highest vertices that rounding missed                               7.3 ε reach_B, 4 ε reach_A
/// N     ¼ ε a component, turned, and times ρ                                2.5 ε ρ
/// ```
///
/// and where a matrix multiplies the cores, their vertices are rounded by 0.7 ε more. The largest sum is that
/// of `reach_B`, 13 ε.
pub(crate) const OFFSET_ERROR: f64 = 13.0 * E;

/// Error of a vertex of B ⊖ A in double-doubles besides that of cosine and sine, as a vector, times M.
/// Lengths.
///
/// Two products of vectors (each component 6 ε² of its 1-norm, √2 for the vector) and three sums of ε² each,
/// two more where a matrix multiplies the cores and their vertices have tails. Rounded up.
pub(crate) const PLACING_ERROR: f64 = 32.0 * E * E;

/// Error of the last dot product and the last sum of a distance in double-doubles, times M + ρ. Lengths.
///
/// The normal is within 7√2 ε², turned within 6√2 ε² more, the product within 6√2 ε², two sums within ε²
/// each; a length is within 8 ε². Rounded up.
pub(crate) const LAST_ERROR: f64 = 64.0 * E * E;

/// Error of the rest g − q k of a gap that a ray closes, times M + ρ, and times |q| |v|₁. Lengths.
///
/// A vertex 17 ε², its low half being below 3 ε M with seven sums; its product with the normal 21 ε², the
/// normal itself 7√2 ε², and turned 6√2 ε² more; the low half is then below 6 ε M and meets three sums, 9 ε².
/// Rounded up; k is as good.
pub(crate) const REST_ERROR: f64 = 128.0 * E * E;

/// Error of a gap f = n·D + n·x − h − ρ along an axis that turns, and of any coordinate of a moving pair,
/// times Σ. Lengths.
///
/// Cosine and sine are within 3 ε ([`crate::geometry::number::cos_sin`]), so that a turn is within 4.3 ε as
/// an operator, and a difference of two turns within 10 ε. D loses 2 ε of |D₀| + |V| on its way to doubles; a
/// turned vector 1.5 ε more, a dot product with n 1.5 ε more; h is that of an edge whose normal is rounded,
/// 3.5 ε of the reach; the three sums 1.5 ε of Σ. That is below 11 of |D₀|₁ + |V|₁ and below 16 of each
/// reach, of which a vertex that a matrix multiplies takes 0.7.
pub(crate) const MOVING_GAP_ERROR: f64 = 12.0 * E;

/// How much lower the lowest vertex may be than the one that doubles take for it, times `reach_A` +
/// `reach_B`. Lengths.
///
/// The edges that they do not tell from level ones are all but parallel, at most two reaches long together,
/// and level to 6 ε.
pub(crate) const MISSED_ERROR: f64 = 12.0 * E;

/// Error of a dot product of an edge and a direction that was turned twice by cosines within 3 ε, times the
/// product of their 1-norms. No dimension.
///
/// 12 ε for the direction, ½ ε for the edge and 1.5 ε for the products. Rounded up.
pub(crate) const TURNED_DOT_ERROR: f64 = 16.0 * E;

/// Error of a derivative of a gap along an axis that turns, times the sum of the magnitudes of its terms. No
/// dimension.
///
/// ω loses 2 ε in its conversion, Δω in its difference, and the products and turned vectors lose less than 8
/// ε more.
pub(crate) const DERIVATIVE_ERROR: f64 = 16.0 * E;

/// Error of the first root of a parabola a + b h + ½ q h², relative to a and to h. No dimension.
///
/// A computed root is the exact root of a parabola whose coefficients differ by at most 4 ε each. At a first
/// root |b h| ≤ 2a and ½ |q| h² ≤ a where b < 0 < q; there 16 ε of a pays for both. Where q < 0 the root is
/// simple with slope ≥ ½ |q| h, and 16 ε of h pays.
pub(crate) const ROOT_ERROR: f64 = 16.0 * E;

/// Error of a coordinate of a body in the world, times the sum of the magnitudes that make it. Lengths.
///
/// Cosine and sine ½ ε, their products ½, three sums ½ each; position + velocity · t one more. Rounded up to
/// a power of two.
pub(crate) const EXTREME_ERROR: f64 = 4.0 * E;

#[cfg(test)]
mod tests;
