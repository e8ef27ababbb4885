//! A [`Query`] in, an [`Answer`] out, events on the way.
//!
//! Two storeys: [`algorithm`] does what the article does, one algorithm a file, and tells every step; [`certified`] below it
//! proves the numbers, and knows neither query nor event.

mod algorithm;
pub(crate) mod answer;
mod certified;
mod feature;
mod query;
#[cfg(test)]
mod tests;

pub use algorithm::{ALGORITHMS, Algorithm, Ready, Stops};
pub use answer::{Answer, Bounds, Impact, MotionBound, Outcome, Overlap, Reason, Separation};
pub use certified::distance::pair::Pair;
pub use certified::impact::MovingPair;
pub use certified::sweep::Sweep;
pub use query::{Bodies, Motion, QUERIES, Query, QueryKind, Question, Shapes, When};
