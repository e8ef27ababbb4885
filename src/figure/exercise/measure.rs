//! What the numbers of an exercise are measured in.

/// What a number is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    /// In units of length.
    Length,
    /// In units of time.
    Time,
    /// In degrees.
    Degrees,
    /// In nothing: a component of a unit vector.
    Pure,
}
