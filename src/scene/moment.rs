//! Moments as a scene names them: a number in [0, 1], a word, or a step of the algorithm.

/// A moment as a panel or layer names it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum When {
    /// A number in [0, 1].
    Time(f64),
    /// The start of the motion, t = 0.
    Start,
    /// The first contact, where the answer has one.
    Hit,
    /// The closest approach, where the answer is a miss.
    Closest,
    /// The time that the first step of an advancement proves free.
    Bound,
    /// The end of the motion, t = 1.
    End,
    /// A step of the algorithm, counted from 1.
    Step(usize),
}

impl When {
    /// The word of [`When::Start`].
    pub(crate) const START: &'static str = "start";
    /// The word of [`When::Hit`].
    pub(crate) const HIT: &'static str = "hit";
    /// The word of [`When::Closest`].
    pub(crate) const CLOSEST: &'static str = "closest";
    /// The word of [`When::Bound`].
    pub(crate) const BOUND: &'static str = "bound";
    /// The word of [`When::End`].
    pub(crate) const END: &'static str = "end";

    /// The moments that have a word, in the order in which messages list them.
    pub(crate) const WORDS: [(&'static str, Self); 5] = [
        (Self::START, Self::Start),
        (Self::HIT, Self::Hit),
        (Self::CLOSEST, Self::Closest),
        (Self::BOUND, Self::Bound),
        (Self::END, Self::End),
    ];

    /// The moment of a word; `None` for any other word.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(known, _)| *known == word).map(|&(_, when)| when)
    }
}
