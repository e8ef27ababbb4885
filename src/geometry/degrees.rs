//! Angles as they are written in files: degrees, exactly.

/// An angle in degrees, positive counter-clockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Degrees(pub f64);
