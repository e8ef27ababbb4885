//! Methods that look right and are wrong on some pairs, to be held beside the answer that is proved.
//!
//! Each is what an implementer writes first, in doubles and without bounds: one method a file, one row in
//! [`METHODS`]. None answers a query; the layer of this name draws what it claims. What is wrong with a
//! method stands in its file, and a test there runs it on a pair where it is wrong.

mod bodies;
mod centre_ray;
mod centres;
mod clamped_centre;
mod deepest_vertex;
mod first_support;
mod first_vertex;
mod fixed_tolerance;
mod forgotten_spin;
mod largest_gap;
mod outline;
mod single_precision;
mod slop;
mod squared_gap;
mod two_frames;

use crate::collision::QueryKind;
use crate::geometry::{Body, DVec2};

/// A row in the table of naive methods.
#[derive(Clone, Copy, Debug)]
pub struct Naive {
    /// Its word in a scene file.
    pub name: &'static str,
    /// The questions that it claims to answer.
    pub kinds: &'static [QueryKind],
    /// What it claims of A and B at a moment, which those that look for a contact ignore; `None` of bodies
    /// that it can't take.
    pub claims: fn([&Body; 2], f64) -> Option<Claim>,
}

/// What a naive method says, with no bounds and no proof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Claim {
    /// How far A and B are apart, negative inside, along a unit vector from A to B.
    Separation(f64, DVec2),
    /// They meet at this time.
    Hit(f64),
    /// They do not meet, or not touch.
    Miss,
    /// They touch at this point of the world alone.
    Contact(DVec2),
    /// It divides by 0.
    Nothing,
}

/// Rows of the table.
const ROWS: [Naive; 13] = [
    largest_gap::NAIVE,
    centres::NAIVE,
    fixed_tolerance::NAIVE,
    clamped_centre::NAIVE,
    first_support::NAIVE,
    first_vertex::NAIVE,
    single_precision::NAIVE,
    squared_gap::NAIVE,
    slop::NAIVE,
    deepest_vertex::NAIVE,
    two_frames::NAIVE,
    centre_ray::NAIVE,
    forgotten_spin::NAIVE,
];

/// Every naive method.
///
/// ```
/// use tracefig::collision::naive::{Claim, METHODS};
/// use tracefig::geometry::{Angle, Body, DVec2, Shape, shape::FieldValue};
/// let half = FieldValue::Point(DVec2::ONE);
/// let body = |x, y| Body {
///     shape: Shape::of_kind("box", &[("half_extents", half.clone())]).unwrap(),
///     position: DVec2::new(x, y), angle: Angle::ZERO, velocity: DVec2::ZERO, spin: Angle::ZERO,
/// };
/// // The vertices are √2 apart, and the projections 1.
/// let claim = (METHODS[0].claims)([&body(0.0, 0.0), &body(3.0, 3.0)], 0.0);
/// assert_eq!(claim, Some(Claim::Separation(1.0, DVec2::X)));
/// ```
pub static METHODS: &[Naive] = &ROWS;

/// The words of the table, in its order.
pub(crate) static WORDS: [&str; ROWS.len()] = {
    let mut words = [""; ROWS.len()];
    let mut i = 0;
    while i < words.len() {
        words[i] = ROWS[i].name;
        i += 1;
    }
    words
};

/// The method of a name that claims to answer such a question; the first such one for an empty name.
pub(crate) fn method(name: &str, kind: QueryKind) -> Option<&'static Naive> {
    let fits = |it: &&Naive| it.kinds.contains(&kind) && (name.is_empty() || it.name == name);
    METHODS.iter().find(fits)
}
