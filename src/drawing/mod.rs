//! The display list: paths, glyph runs and groups with roles and accessible names, in page pixels, y down.

/// A page point in pixels, x right, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Right.
    pub x: f64,
    /// Down.
    pub y: f64,
}
