//! Why nothing came of a scene, where the others still do.

use tracefig::scene::{Ink, Refused};

use super::Status;

/// Why nothing came of a scene.
pub(crate) struct Failure {
    /// What kind of error it is.
    pub(crate) status: Status,
    /// The message of it.
    pub(crate) message: String,
}

impl Failure {
    /// Takes kind and message from a scene that is refused.
    pub(crate) fn of(refused: &Refused, ink: Ink) -> Self {
        Self { status: Status::of(refused), message: refused.render(ink) }
    }

    /// A scene that is not drawn for a reason that is said for several at once.
    pub(crate) const fn told() -> Self {
        Self { status: Status::Wrong, message: String::new() }
    }
}

impl From<String> for Failure {
    fn from(message: String) -> Self {
        Self { status: Status::Wrong, message }
    }
}
