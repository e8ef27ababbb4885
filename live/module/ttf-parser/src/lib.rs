//! The reader of faces as it is, under the name that it is asked for by, without the tables that none of our
//! three faces has: outlines that vary, layout as Apple does it, names of glyphs.
//!
//! Whoever asks for one of them asks for all, as the setter of formulas does, and the compiler can't know that
//! no face brings them: 40 kB.

pub use reader::*;
