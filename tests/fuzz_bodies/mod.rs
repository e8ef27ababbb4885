//! What the fuzz targets of `fuzz/` hold of any text; `tests/scenes/corpus.rs` holds it of the inputs that
//! fuzzing found.

pub(crate) mod render;
pub(crate) mod scene;
pub(crate) mod solve;
