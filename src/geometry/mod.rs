//! Points, poses, shapes and their motion, in world units, y up.
//!
//! A body is a convex *core* (one, two or more vertices) swept by a disc of radius r, that moves with
//! constant velocities over t in [0, 1] and turns about its own origin.

mod body;
mod hull;
mod letters;
mod names;
pub(crate) mod number;
mod rotation;
pub mod shape;
mod sorting;
mod unit_vector;

pub use body::{Body, Pose, perp};
pub use glam::DVec2;
pub use hull::Hull;
pub(crate) use letters::{begun, small};
pub use names::Names;
pub use number::Angle;
pub(crate) use number::{
    Ball, Dd, Exact, MOST_EPS, Turn, combined, fast_two_sum, length, power_of_ten, read, taming_power,
    two_product, two_sum,
};
pub use rotation::Rotation;
pub use shape::Shape;
pub(crate) use sorting::{insert_in_order, sort_by, sorted};
pub use unit_vector::UnitVector;

use serde::Serialize;

/// A part of a body's boundary, numbered in the file's order of vertices; edge i runs from vertex i to i + 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Feature {
    /// A vertex, or the one point of a circle.
    Vertex(usize),
    /// The edge from vertex i to vertex i + 1.
    Edge(usize),
}

/// Which of the two bodies of a query.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
pub enum Side {
    /// The first body of the query.
    A,
    /// The second body of the query.
    B,
}

impl Side {
    /// Both bodies, in the order of the query.
    pub(crate) const BOTH: [Self; 2] = [Self::A, Self::B];

    /// The letter that stands for the body in answers and keys, whatever the scene calls it.
    pub(crate) const fn letter(self) -> &'static str {
        match self {
            Self::A => "A",
            Self::B => "B",
        }
    }

    /// The other body.
    ///
    /// ```
    /// assert_eq!(tracefig::geometry::Side::A.other(), tracefig::geometry::Side::B);
    /// ```
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::A => Self::B,
            Self::B => Self::A,
        }
    }
}

/// A closed interval that holds an exact value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Enclosure {
    /// Not above the exact value.
    pub lo: f64,
    /// Not below the exact value.
    pub hi: f64,
}
