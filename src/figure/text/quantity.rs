//! A number of the answer with its bounds, and how it is written: texts and labels say the same of it.

use crate::collision::Separation;
use crate::figure::context::Context;
use crate::geometry::Enclosure;
use crate::scene::Variant;

use super::digits::Digits;
use super::number::{USUAL, in_math};
use super::places::Places;

/// A number with its bounds; both are the same where the trace tells only a double.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quantity {
    /// Not above the exact value.
    pub(crate) lo: f64,
    /// Not below the exact value.
    pub(crate) hi: f64,
    /// Whether it bounds something from above, so that it is never rounded down.
    is_at_most: bool,
    /// The unit of the last digit of a coordinate, where nobody asks for digits.
    places: Option<Places>,
}

impl Quantity {
    /// A value that the trace tells as a double.
    pub(crate) fn exactly(value: f64) -> Self {
        Self { lo: value, hi: value, is_at_most: false, places: None }
    }

    /// A double that something is proved not to be more than.
    pub(crate) fn at_most(value: f64) -> Self {
        Self { is_at_most: true, ..Self::exactly(value) }
    }

    /// A coordinate, as fine as the bodies are large.
    pub(crate) fn place(x: f64, places: Places) -> Self {
        Self { places: Some(places), ..Self::exactly(x) }
    }

    /// A value that is told with its bounds.
    pub(crate) fn within(Enclosure { lo, hi }: Enclosure) -> Self {
        Self { lo, hi, is_at_most: false, places: None }
    }

    /// Minus this number.
    #[must_use]
    pub(crate) fn negated(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo, is_at_most: false, ..self }
    }

    /// The number in so many digits, and no more than its bounds share.
    #[must_use]
    pub(crate) fn written(self, digits: Digits) -> String {
        match self.places.filter(|_| digits == USUAL) {
            Some(places) => places.written(self.lo),
            None if self.is_at_most => digits.at_least(self.hi),
            None => digits.of(self.lo, self.hi),
        }
    }

    /// The signed separation: negative inside.
    pub(crate) fn separation(found: &Separation) -> Self {
        Self::within(found.bounds)
    }

    /// The letter d of every figure: the distance of bodies apart, the depth of bodies that overlap, and so
    /// never negative.
    pub(crate) fn distance_or_depth(found: &Separation) -> Self {
        match found.bounds {
            bounds if bounds.hi <= 0.0 => Self::within(bounds).negated(),
            bounds if bounds.lo >= 0.0 => Self::within(bounds),
            _ => Self::exactly(found.separation.abs()),
        }
    }

    /// Whether it may be rounding of numbers, which takes so much from 0, and is not 0.
    fn is_within(self, rounding: f64) -> bool {
        let most = self.lo.abs().max(self.hi.abs());
        most > 0.0 && most <= rounding
    }

    /// What stands after its letter as LaTeX: `= 0.5`; about 0 where it may be `rounding` of the numbers
    /// written, which a reader of those computes as 0.
    #[must_use]
    pub(crate) fn equals(self, rounding: f64) -> String {
        if self.is_within(rounding) { r"\approx 0".to_owned() } else { format!("= {}", self.latex()) }
    }

    /// The number as LaTeX, to three digits, or all it has where they are few.
    #[must_use]
    pub(crate) fn latex(self) -> String {
        in_math(&self.written(USUAL))
    }
}

/// The label of a distance or depth, as markup: it says which where the sign of the separation is negative,
/// as d has none. What may be `rounding` of the numbers written, world units, is about 0.
#[must_use]
pub(crate) fn distance_or_depth(found: &Separation, rounding: f64) -> String {
    let d = Quantity::distance_or_depth(found);
    let word = if found.bounds.hi < 0.0 && !d.is_within(rounding) { "depth " } else { "" };
    format!("{word}$d {}$", d.equals(rounding))
}

/// Whether a figure is the key of an exercise that asks for one of these values.
fn asks(context: &Context, names: &[&str]) -> bool {
    let exercise = context.scene.exercise.as_ref().filter(|_| context.scene.variant == Variant::Key);
    exercise.is_some_and(|e| e.ask.iter().any(|name| names.contains(&name.value.as_str())))
}

/// The label of a distance or depth in the letter of an exercise that asks for it, as markup: the key of a
/// figure has no other. `None` where nobody asks.
#[must_use]
pub(crate) fn asked_distance(context: &Context, found: &Separation) -> Option<String> {
    let asked = |names: &[&str]| asks(context, names);
    if asked(&["p"]) || asked(&["d", "depth"]) == asked(&["separation"]) {
        // The algorithm's own letter, or both: then the label has its own.
        return None;
    }
    let signed = || format!("$s = {}$", Quantity::separation(found).latex());
    Some(if asked(&["separation"]) { signed() } else { distance_or_depth(found, 0.0) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Answer;

    #[test]
    fn d_is_never_negative_and_a_depth_is_called_one() {
        let scene = |x: f64| {
            let text = format!(
                "[shapes.A]\nkind = 'circle'\nradius = 1\n[shapes.B]\nkind = 'circle'\nradius = 1\n\
                 position = [{x}, 0]\n[query]\nkind = 'separation'\nof = ['A', 'B']"
            );
            crate::scene::open_text("s.toml", &text).unwrap().scene
        };
        for (x, expected) in [(1.5, "depth $d = 0.5$"), (2.5, "$d = 0.5$"), (2.0, "$d = 0$")] {
            let Answer::Separation(found) = crate::scene::solve(&scene(x)) else { panic!("a separation") };
            assert_eq!(distance_or_depth(&found, 0.0), expected);
        }
    }

    #[test]
    fn at_the_first_contact_d_is_0_and_not_what_rounding_left() {
        for algorithm in ["conservative-advancement", "swept-axis"] {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [2, 1], velocity = [3, 1] }}
                shapes.B = {{ kind = 'circle', radius = 1.3, position = [5.1, 1.7] }}
                query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = '{algorithm}' }}
                panels = [{{ time = 'hit', layers = ['shapes', 'separation'] }}]"
            );
            let scene = crate::scene::open_text("s.toml", &text).unwrap().scene;
            let plan = crate::figure::plan(&scene).unwrap();
            let hit = plan.panels[0].moment.time;
            let run = plan.runs.separation(&scene, hit).unwrap();
            let found = run.separation().unwrap();
            assert_eq!(
                (found.separation, distance_or_depth(found, 0.0).as_str()),
                (0.0, "$d = 0$"),
                "{algorithm}"
            );
            let apart = plan.runs.separation(&scene, 0.5 * hit).unwrap();
            assert!(apart.separation().unwrap().separation > 0.1, "before");
        }
    }

    #[test]
    fn the_key_of_an_exercise_has_the_letter_of_its_question() {
        for (ask, shows) in
            [("separation", "$s = -0.5$"), ("d", "depth $d = 0.5$"), ("['d', 'separation']", "$p = -0.5$")]
        {
            let ask = if ask.starts_with('[') { ask.to_owned() } else { format!("'{ask}'") };
            let text = format!(
                "exercise.ask = {ask}
                shapes.A = {{ kind = 'circle', radius = 1 }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [1.5, 0] }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'circles' }}
                panels = [{{ layers = ['shapes', 'separation'] }}]"
            );
            let scene = crate::scene::open_text("s.toml", &text).unwrap().scene;
            let key = crate::figure::exercise::variant(&scene, Variant::Key).unwrap();
            let plan = crate::figure::plan(&key).unwrap();
            let drawn = crate::figure::draw(&plan, plan.theme, "f");
            let label = drawn.panels[0].placed.iter().find(|placed| placed.key == "p").unwrap();
            let text: String = label.lines.iter().map(|(_, line)| line.markup.clone()).collect();
            assert_eq!(text, shows, "{ask}");
        }
    }
}
