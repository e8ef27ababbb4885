//! What the fuzz targets of `fuzz/` hold of any text or bytes; `tests/scenes/corpus.rs` holds it of the inputs
//! that fuzzing found.

pub(crate) mod check;
pub(crate) mod choices;
pub(crate) mod figure;
pub(crate) mod pair;
pub(crate) mod render;
pub(crate) mod scene;
pub(crate) mod solve;
