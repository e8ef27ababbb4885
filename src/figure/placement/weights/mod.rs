//! Every number that says where labels like to stand, by name.
//!
//! Costs and reluctances are in one unit: 1 is a slight preference, 10 a strong one, 60 and more a last
//! resort. Lengths are page pixels of the page as it is, and do not shrink with it.
//!
//! They were tuned by eye and by count on the committed figures, which must have no fault at all, and on the
//! random scenes of `tests/scenes/label_faults.rs`, whose names have 1 to 24 letters and which have one fault
//! in a hundred figures, as those are drawn that leave room for labels. Each doc says what a number alone
//! does at twice and at half: how many labels of the figures + of 200 random scenes move, and how many faults
//! there are more or fewer than the 17 that those scenes have as tuned, without more room. The figures have
//! 432 labels, the scenes 1,340. The survey in `tests.rs` counted them and can be run again, in three
//! minutes:
//!
//! ```text
//! TRACEFIG_SCENES=200 cargo test --release --lib placement::weights -- --nocapture
//! ```
//!
//! They were counted when `gap` and `area_room` were 5, `second_gap` 10 and `crowd_reach` 7, and `rim` and
//! what follows it later; as they are, and with room for labels, 1,000 scenes have 17 faults.
//!
//! No number makes a fault in a figure, at twice or at half. Those of resting (`comfort`, `worse`, `unrest`,
//! `inertia`) count only in figures that move, and were tuned on the drags of `rest/tests.rs`.
//!
//! Few numbers make faults: `spill` is part of what a fault is, and the others make some or leave some out,
//! and choose among places that the survey finds as good, where the eye decides.

mod costs;
mod places;
mod search;
#[cfg(test)]
mod tests;

pub(super) use costs::Costs;
pub(super) use places::Places;
pub(super) use search::Search;

/// All numbers of label placement.
#[derive(Clone, Debug)]
pub(super) struct Weights {
    /// Where a label may stand, and how little it likes to there.
    pub(super) places: Places,
    /// What a place costs for what lies there.
    pub(super) costs: Costs,
    /// How long the search for better places goes on.
    pub(super) search: Search,
}

impl Weights {
    /// The numbers for a figure that moves: there a label in trouble is offered a quarter of the places. At
    /// rest it is offered all.
    pub(super) fn moving(&self) -> Self {
        let nudge_step = 2.0 * self.search.nudge_step;
        Self { search: Search { nudge_step, ..self.search.clone() }, ..self.clone() }
    }
}

/// The numbers that figures are drawn with.
pub(super) static TUNED: Weights =
    Weights { places: Places::TUNED, costs: Costs::TUNED, search: Search::TUNED };

/// A struct of numbers, its tuned values, and the means to try others: name, value and doc of each stand in
/// one place.
macro_rules! numbers {
    ($(#[$about:meta])* $group:ident { $($(#[$doc:meta])* $name:ident: $kind:ty = $value:expr;)+ }) => {
        $(#[$about])*
        #[derive(Clone, Debug)]
        pub(in crate::figure::placement) struct $group {
            $($(#[$doc])* pub(in crate::figure::placement) $name: $kind,)+
        }

        impl $group {
            /// The values that figures are drawn with.
            pub(in crate::figure::placement) const TUNED: Self = Self { $($name: $value,)+ };

            /// Every number by name, with what multiplies it.
            #[cfg(test)]
            pub(super) const KNOBS: &[(&str, fn(&mut Self, f64))] = &[
                $((stringify!($name), |group, by| super::tests::Scale::scale(&mut group.$name, by)),)+
            ];
        }
    };
}
use numbers;
