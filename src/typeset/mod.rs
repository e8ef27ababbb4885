//! Words and `$…$` formulas to runs of glyphs with their extents.
