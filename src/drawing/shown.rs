//! A figure in steps: which of its items a step shows, and what a step says.
//!
//! An item is there from the step that made it to the one that took it away, if one did; all stand where they
//! stand in the finished figure, so nothing moves from step to step.

/// From which step on an item is shown, and from which on it is not; steps count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shown {
    /// The first step that shows it.
    pub since: usize,
    /// The step that takes it away; none for what stays in the finished figure.
    pub until: Option<usize>,
}

impl Shown {
    /// Shown by every step.
    pub const ALWAYS: Self = Self { since: 1, until: None };

    /// Whether a step shows it.
    ///
    /// ```
    /// use tracefig::drawing::Shown;
    /// let shown = Shown { since: 2, until: Some(4) };
    /// assert_eq!([1, 2, 3, 4].map(|step| shown.at(step)), [false, true, true, false]);
    /// ```
    #[must_use]
    pub fn at(self, step: usize) -> bool {
        self.since <= step && self.until.is_none_or(|until| step < until)
    }

    /// With numbers that stand for names in a list, of which there are `more` before now; 1 stands for none.
    pub(crate) fn after(self, more: usize) -> Self {
        let after = |number: usize| if number > 1 { number + more } else { number };
        Self { since: after(self.since), until: self.until.map(after) }
    }

    /// What holds both: from the earlier first step to the later end.
    pub(crate) fn union(self, other: Self) -> Self {
        let until = self.until.zip(other.until).map(|(a, b)| a.max(b));
        Self { since: self.since.min(other.since), until }
    }
}

impl Default for Shown {
    fn default() -> Self {
        Self::ALWAYS
    }
}

/// A step of a figure: a run of events after which the picture changes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Step {
    /// A few words, plain text.
    pub title: String,
    /// What happened, plain text; may be empty.
    pub sentences: Vec<String>,
}
