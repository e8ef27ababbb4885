//! A [`Query`] in, an [`Answer`] out, events on the way.
//!
//! Two storeys. `algorithm/` is the article: one algorithm a file, in doubles, and each step is told as an
//! event, which is what figures are drawn from. `certified/` below it proves the numbers: bodies in,
//! enclosures out, and it knows neither query nor event. An algorithm that has found which features face each
//! other, or when bodies meet, asks the storey below for the number, so that what is printed is true whoever
//! found it.
//!
//! ```text
//! query/       what can be asked: one kind of question a file, the table QUERIES
//! algorithm/   who answers it: one algorithm a file, the table ALGORITHMS
//! answer/      what comes back, and the names of its parts
//! expected.rs  what someone else answered, and how far off that is
//! naive/       what looks right and is wrong: one such method a file, the table METHODS; answers nothing
//! rounding.rs  what the rounding of a scene's numbers may make of a distance
//! size.rs      what the rounding of a pair is measured by
//! certified/   distance/  how far apart a pair is at one moment
//!              sweep/     when two bodies meet that do not turn: where a ray enters B ⊖ A
//!              impact/    when two bodies meet that turn: separating axes, contact after the last of them
//!              approach/  how near two bodies came that do not meet
//!              clip       where two bodies touch: an edge clipped against another
//! feature.rs   an edge or a vertex of B ⊖ A, which both storeys speak of
//! ```
//!
//! | who wants to | goes to |
//! |---|---|
//! | read an algorithm of the article | `algorithm/`, its name; README has the list |
//! | see why a sweep that misses does miss | `certified/sweep/`: `filter/` in doubles, else `balls.rs` |
//! | see why a contact is one, and when | `certified/impact/contact.rs` |
//! | see why a miss came no nearer | `certified/approach/` |
//! | see why a bound holds | `certified/rounding/`, a table of all |
//! | add an algorithm | a file in `algorithm/` and its row in [`ALGORITHMS`] |
//! | add a kind of question | a file in `query/` and its row in [`QUERIES`]; an algorithm that answers it |
//! | add a kind of answer | a variant of [`Answer`] and its parts, in `answer/` |
//! | tell something new | a variant of [`crate::trace::Event`], its sentence, and a layer that draws it |
//!
//! `tests/architecture/` holds the storeys apart, `tests/one_row/` that a file and a row are
//! enough.

mod algorithm;
pub(crate) mod answer;
mod certified;
mod expected;
mod feature;
pub mod naive;
mod query;
mod rounding;
mod size;
#[cfg(test)]
mod tests;

#[cfg(not(tracefig_page))]
pub use algorithm::Ready;
pub use algorithm::{ALGORITHMS, Algorithm, Stops, closest_approach};
pub use answer::{
    Answer, AnswerField, Bounds, ClosestApproach, Contact, ContactPoint, Impact, MotionBound, Outcome,
    Overlap, Reason, Separation, Verdict,
};
pub use certified::distance::Pair;
pub use certified::impact::MovingPair;
pub use certified::sweep::Sweep;
pub use expected::{Expected, Off};
pub use query::{Bodies, Motion, QUERIES, Query, QueryKind, Question, Shapes, When};
pub(crate) use size::{of_one_scale, scale_of};
