//! What came out of a query about two bodies, in a word that another engine has too.

use super::{Answer, Outcome};
use crate::geometry::Enclosure;

/// What came out, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Bodies that move touch, and not at the start.
    Hit,
    /// Bodies that move never touch.
    Miss,
    /// The bodies touch or overlap, those that move at the start.
    Overlapping,
    /// Bodies at a moment do not touch.
    Apart,
}

impl Verdict {
    /// Every one, in the order of their words in messages.
    pub const ALL: [Self; 4] = [Self::Hit, Self::Miss, Self::Overlapping, Self::Apart];

    /// Its word in scene files and stories.
    ///
    /// ```
    /// use tracefig::collision::Verdict;
    /// assert_eq!(Verdict::ALL.map(Verdict::word), ["hit", "miss", "overlapping", "apart"]);
    /// ```
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Hit => "hit",
            Self::Miss => "miss",
            Self::Overlapping => "overlapping",
            Self::Apart => "apart",
        }
    }

    /// Whether a question about all of a motion may come out so, and one about a moment.
    ///
    /// ```
    /// use tracefig::collision::Verdict;
    /// assert_eq!(Verdict::Overlapping.suits(), [true, true]);
    /// ```
    #[must_use]
    pub const fn suits(self) -> [bool; 2] {
        match self {
            Self::Hit | Self::Miss => [true, false],
            Self::Overlapping => [true, true],
            Self::Apart => [false, true],
        }
    }

    /// What came out of an answer; `None` where it is open, or the question has none.
    pub(crate) fn of(answer: &Answer) -> Option<Self> {
        let touch = |touch: bool| if touch { Self::Overlapping } else { Self::Apart };
        let of = |bounds: Enclosure| match bounds {
            Enclosure { hi, .. } if hi <= 0.0 => Some(Self::Overlapping),
            Enclosure { lo, .. } => Some(Self::Apart).filter(|_| lo > 0.0),
        };
        match answer {
            Answer::Overlap(found) => found.overlap.map(touch),
            Answer::Separation(found) => of(found.bounds),
            Answer::Contact(found) => of(found.separation.bounds),
            Answer::Impact(impact) => match impact.outcome {
                Outcome::Hit { .. } => Some(Self::Hit),
                Outcome::Miss => Some(Self::Miss),
                Outcome::Overlapping { .. } => Some(Self::Overlapping),
                Outcome::Unresolved { .. } => None,
            },
            Answer::Bounds(_) | Answer::MotionBound(_) => None,
        }
    }
}
