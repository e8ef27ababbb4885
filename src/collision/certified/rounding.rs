//! Every bound on rounding that is known before anything is computed, in one table, and the range in which they hold.
//!
//! A filter computes in doubles and trusts what is clear of such a bound; what is not clear is left to balls, which carry
//! their own radius. A bound is a number times a size, and with u = ε/2 = 2⁻⁵³ each addition, product, quotient and root
//! of doubles is within u of itself. Letters:
//!
//! ```text
//! ε    2⁻⁵², the distance from 1 to the next double
//! M    |c|₁ + reach_A + reach_B: no coordinate of the pair in A's frame is larger        Pair::magnitude
//! S    |p_B − p_A|₁ + |(v_B − v_A) t|₁ + reaches + ρ: the same as an algorithm has it    algorithm::view
//! Σ    |D₀|₁ + |V|₁ + 3/2 (reach_A + reach_B) + ρ, over the whole motion                 MovingPair
//! ρ    r_A + r_B
//! |x|₁ |x| + |y|, never below the length, never above √2 of it
//! ```
//!
//! | bound                | value  | times            | of what                                           |
//! |----------------------|--------|------------------|---------------------------------------------------|
//! | [`GAP_ERROR`]        | 32 ε   | M                | a gap along an edge's normal at one moment        |
//! | [`VIEW_GAP_ERROR`]   | 16 ε   | S                | a gap, or distance of vertices, in an algorithm   |
//! | [`CROSS_ERROR`]      | 12 ε   | \|xy'\| + \|yx'\|    | a cross product of two edges                      |
//! | [`DOT_ERROR`]        | 8 ε    | \|x\|₁ \|y\|₁        | a dot product of two vectors of a pair            |
//! | [`LEVEL_ERROR`]      | 16 ε   | \|edge\|₁          | whether an edge is level to a unit normal         |
//! | [`OFFSET_ERROR`]     | 64 ε   | \|v\|₁ (M + ρ)     | how far a vertex is off a ray's line              |
//! | [`PLACING_ERROR`]    | 32 ε²  | M                | a vertex of B ⊖ A in double-doubles               |
//! | [`LAST_ERROR`]       | 64 ε²  | M + ρ            | a distance of such a vertex, less ρ               |
//! | [`REST_ERROR`]       | 128 ε² | M + ρ, \|q\| \|v\|₁  | what is left of a gap that a ray closes           |
//! | [`MOVING_GAP_ERROR`] | 12 ε   | Σ                | a gap along an axis that turns                    |
//! | [`MISSED_ERROR`]     | 12 ε   | reach_A + reach_B | a support that rounding missed                   |
//! | [`DERIVATIVE_ERROR`] | 16 ε   | its terms        | a derivative of such a gap                        |
//! | [`ROOT_ERROR`]       | 16 ε   | itself           | the first root of a parabola                      |
//! | [`EXTREME_ERROR`]    | 4 ε    | \|p + v t\| + reach | a coordinate of a body in the world              |
//!
//! The bounds of a single cosine, sine, double-double or ball stand with them in [`crate::geometry`]. A test measures each
//! row against 320 bits: it fails where a bound is exceeded, and where it is ten times what was seen.

use std::ops::Range;

/// ε: the distance from 1 to the next double.
const E: f64 = f64::EPSILON;

/// Scenes whose size is in this range, 2^±200, are computed as they are; others are multiplied by a power of two first.
///
/// Products of four lengths, and what Dekker's product leaves out of them, are then far from overflow and underflow:
/// 2⁸⁰⁰ and 2⁻⁸⁰⁰⁻¹⁰⁶ of 2¹⁰²⁴ and 2⁻¹⁰²². With exponents ten times as large a product of two lengths is already 0 or
/// infinite.
pub(crate) const TAME: Range<f64> = f64::from_bits((1023 - 200) << 52)..f64::from_bits((1023 + 200) << 52);

/// A scaled number below 2⁻⁹⁶⁰ may have lost bits to underflow; its ball is widened by as much. The scene itself is scaled
/// to about 1, so that this is far below any rounding that is seen.
pub(crate) const LOSSY: f64 = f64::from_bits((1023 - 960) << 52);

/// Error of a gap along an edge's normal as [`super::distance::gaps`] computes it, times M. Lengths.
///
/// c is off by 2.5 ε (the difference ½, cosine and sine ½ each, products and sum); the normal by ½√2 ε, which all terms
/// share; its turn by 2 ε; three dot products by 1.5 ε each; the edge's offset by 2 ε; the last two sums by ½ ε each: 14 ε
/// together. A support that rounding missed lies, edge by edge, less than 6 ε of the edges' lengths below the true one;
/// such edges are all but parallel, so that they are two reaches long at most: 12 ε. Rounded up to a power of two.
pub(crate) const GAP_ERROR: f64 = 32.0 * E;

/// Error of a gap along an edge's normal, or of a distance of vertices, as an algorithm computes it, times S. Lengths.
///
/// The place of B's origin takes 4 roundings, a vertex turned there 3, a normal 3 and its turn 3, dot products of those 3,
/// the radii and the last differences 3; 19 of ½ ε or less each, rounded up. Supports are chosen by signs that are certain,
/// so that none is missed: that is why it is half of [`GAP_ERROR`].
pub(crate) const VIEW_GAP_ERROR: f64 = 16.0 * E;

/// Error of a cross product of two edges, of which one may be turned, times the sum of the magnitudes of its two
/// products. Without a dimension.
///
/// Each component of an edge carries at most 4 roundings (a difference, two products, a sum) and two cosines within ½ ε,
/// and the cross product adds 2.
pub(crate) const CROSS_ERROR: f64 = 12.0 * E;

/// Error of a dot product of two vectors of a pair, times the product of their 1-norms. Without a dimension.
///
/// Vertices, edges and normals are within 4 ε of theirs, of one of the two, as only one has been turned; the products and
/// the sum add 1.5 ε. Rounded up to a power of two.
pub(crate) const DOT_ERROR: f64 = 8.0 * E;

/// Error of a dot product of an edge and a unit normal that was turned into its frame, times the edge's 1-norm. Without a
/// dimension.
///
/// [`DOT_ERROR`] with √2 for the normal's 1-norm, rounded up; of a normal that was turned twice by cosines within 3 ε
/// (12 ε, with ½ ε for the edge and 1.5 ε for the products) as well.
pub(crate) const LEVEL_ERROR: f64 = 16.0 * E;

/// Error of the offset of a vertex of B ⊖ A from a ray's line, times |v|₁ (M + ρ). Lengths times speeds.
///
/// The centre is off by 2.5 ε, v and its turn by 4 ε, products and sums by 6 ε, ρ |v| by 4 ε; a vertex that rounding takes
/// for the highest is 6 ε of the edges' lengths below it, 2 reaches at most: 29 ε; √2 for norms. Rounded up.
pub(crate) const OFFSET_ERROR: f64 = 64.0 * E;

/// Error of a vertex of B ⊖ A in double-doubles besides that of cosine and sine, as a vector, times M. Lengths.
///
/// Two products of vectors (each component 6 ε² of its 1-norm, √2 for the vector) and three sums of ε² each. Rounded up.
pub(crate) const PLACING_ERROR: f64 = 32.0 * E * E;

/// Error of the last dot product and the last sum of a distance in double-doubles, times M + ρ. Lengths.
///
/// The normal is within 7 ε² √2, the product 6 ε² √2, two sums; a length is within 5 ε². Rounded up.
pub(crate) const LAST_ERROR: f64 = 64.0 * E * E;

/// Error of the rest g − q k of a gap that a ray closes, times M + ρ, and times |q| |v|₁. Lengths.
///
/// A vertex 17 ε², its low half being below 3 ε M with seven sums; its product with the normal 21 ε², the normal itself
/// 7√2 ε², and turned 6√2 ε² more; the low half is then below 6 ε M and meets three sums, 9 ε². Rounded up; k is as good.
pub(crate) const REST_ERROR: f64 = 128.0 * E * E;

/// Error of a gap f = n·D + n·x − h − ρ along an axis that turns, and of any coordinate of a moving pair, times Σ. Lengths.
///
/// Cosine and sine are within 3 ε ([`crate::geometry::number::cos_sin`]), so that a turn is within 4.3 ε as an operator,
/// and a difference of two turns within 10 ε. D loses 2 ε of |D₀| + |V| on its way to doubles; a turned vector 1.5 ε more,
/// a dot product with n 1.5 ε more; h is that of an edge whose normal is rounded, 3.5 ε of the reach; the three sums 1.5 ε
/// of Σ. That is below 11 of |D₀|₁ + |V|₁ and below 15 of each reach.
pub(crate) const MOVING_GAP_ERROR: f64 = 12.0 * E;

/// How much lower the lowest vertex may be than the one that doubles take for it, times `reach_A` + `reach_B`. Lengths.
///
/// The edges that they do not tell from level ones are all but parallel, at most two reaches long together, and level to
/// 6 ε.
pub(crate) const MISSED_ERROR: f64 = 12.0 * E;

/// Error of a derivative of such a gap, times the sum of the magnitudes of its terms. Without a dimension.
///
/// ω loses 2 ε in its conversion, Δω in its difference, and the products and turned vectors lose less than 8 ε more.
pub(crate) const DERIVATIVE_ERROR: f64 = 16.0 * E;

/// Error of the first root of a parabola a + b h + ½ q h², relative to a and to h. Without a dimension.
///
/// A computed root is the exact root of a parabola whose coefficients differ by at most 4 ε each. At a first root
/// |b h| ≤ 2a and ½ |q| h² ≤ a where b < 0 < q; there 16 ε of a pays for both. Where q < 0 the root is simple with slope
/// ≥ ½ |q| h, and 16 ε of h pays.
pub(crate) const ROOT_ERROR: f64 = 16.0 * E;

/// Error of a coordinate of a body in the world, times the sum of the magnitudes that make it. Lengths.
///
/// Cosine and sine ½ ε, their products ½, three sums ½ each; position + velocity · t one more. Rounded up to a power of
/// two.
pub(crate) const EXTREME_ERROR: f64 = 4.0 * E;
