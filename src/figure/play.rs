//! What becomes of a panel in a figure that plays, which its layers may have to know.

/// What becomes of a panel in a figure that plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Play {
    /// The figure does not play.
    No,
    /// It stands still while others show a moment, in [0, 1].
    Stands(f64),
    /// It shows one moment after the other.
    Moves,
}

impl Play {
    /// The moment that others show while it stands still.
    pub(crate) fn stands_at(self) -> Option<f64> {
        if let Self::Stands(time) = self { Some(time) } else { None }
    }

    /// Whether it shows one moment after the other.
    pub(crate) fn moves(self) -> bool {
        self == Self::Moves
    }
}
