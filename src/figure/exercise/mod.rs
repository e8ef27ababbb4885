//! A scene as an exercise: a question without any trace of the answer, and the key to it.
//!
//! Three locks keep the answer out of a question. The [`variant`](variant::variant) leaves out what the
//! tables say: layers that tell of what an algorithm found ([`Tells`](super::layer::Tells)), panels at a
//! moment that only the answer knows, texts that name a value, headline and caption. Its runs are blind: no
//! algorithm answers behind it, so that nothing it draws, and not the length of its file, can depend on an
//! answer. And its file says nothing of itself but that it is a question.
//!
//! The key is the figure itself with the numbers, each with its bounds, and the sentences of the trace as the
//! way to them.

mod answers;
mod askable;
mod asked_of;
mod caption;
mod givens;
mod measure;
mod of_contacts;
mod phrases;
mod plan;
mod quantities;
mod search;
#[cfg(test)]
mod tests;
mod variant;

pub use answers::Asked;
pub use askable::askables;
pub(crate) use caption::{caption, spoken};
pub use plan::{answer_in_words, asked, solution, task, task_of, to_enter, way};
pub use search::{Found, TooFew, search};
pub use variant::variant;
