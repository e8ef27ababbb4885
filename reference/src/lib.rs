//! The independent witness of `tracefig`: answers to more than 200 bits, hard cases, and a checker of its
//! answers.
//!
//! It reads scenes as lines of JSON and answers as `tracefig solve --jsonl` prints them, and shares no code,
//! no arithmetic and no dependency with the solver. "Exact" means to 2⁻³⁰⁰ of the scene's scale, more than
//! 240 bits beyond a double; a claim that is wrong by less than [`check::slack`] is held to be right.

pub mod answer;
pub mod check;
pub mod closest;
pub mod first_contact;
pub mod float;
pub mod generate;
pub mod json;
pub mod placement;
pub mod point;
pub mod random;
pub mod scene;
pub mod separation;
pub mod tally;
