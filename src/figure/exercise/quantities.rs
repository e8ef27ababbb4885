//! What an exercise may ask for: values of texts that are numbers of an answer, with the words of the
//! question.

use crate::collision::QueryKind;
use crate::figure::question::is_of_a_moment;

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

/// A value that can be asked for.
pub(crate) struct Askable {
    /// Its name among the values of texts.
    pub(crate) name: &'static str,
    /// How it is written before the blank, as LaTeX.
    pub(crate) symbol: &'static str,
    /// What is to be found, with `{}` for the bodies, `{a}` and `{b}` for each: "the depth of {}".
    pub(crate) what: &'static str,
    /// What it is measured in.
    pub(crate) measure: Measure,
    /// Whether its bounds are proved; else a double is told, rounded.
    pub(crate) is_proved: bool,
    /// The questions whose answers it is a part of.
    pub(crate) of: fn(QueryKind) -> bool,
}

/// Whether a question is for the first contact.
fn moves(kind: QueryKind) -> bool {
    !is_of_a_moment(kind) && kind != QueryKind::MotionBound
}

/// Whether a question is for a motion bound.
fn bounds_motion(kind: QueryKind) -> bool {
    kind == QueryKind::MotionBound
}

/// Whether a question is about two bodies.
fn is_of_two(kind: QueryKind) -> bool {
    !bounds_motion(kind) && kind != QueryKind::Bounds
}

/// Whether a question is for a box.
fn is_for_a_box(kind: QueryKind) -> bool {
    kind == QueryKind::Bounds
}

/// A row of the table.
const fn row(
    name: &'static str,
    symbol: &'static str,
    what: &'static str,
    measure: Measure,
    of: fn(QueryKind) -> bool,
) -> Askable {
    Askable { name, symbol, what, measure, is_proved: false, of }
}

/// A row whose bounds are proved.
const fn proved(mut row: Askable) -> Askable {
    row.is_proved = true;
    row
}

/// Every value that can be asked for.
pub(crate) static ASKABLE: &[Askable] = &[
    proved(row(
        "separation",
        "s",
        "the signed separation of {}, negative inside",
        Measure::Length,
        is_of_two,
    )),
    proved(row("d", "d", "how far {} are apart, or how deep they overlap", Measure::Length, is_of_two)),
    proved(row("depth", "d", "the depth by which {} overlap", Measure::Length, is_of_two)),
    row("n.x", "n_x", "the x component of the unit normal from {a} to {b}", Measure::Pure, is_of_two),
    row("n.y", "n_y", "the y component of the unit normal from {a} to {b}", Measure::Pure, is_of_two),
    proved(row("time", "t", "the time of the first contact of {}", Measure::Time, moves)),
    row("hit.n.x", "n_x", "the x component of the unit normal at the first contact", Measure::Pure, moves),
    row("hit.n.y", "n_y", "the y component of the unit normal at the first contact", Measure::Pure, moves),
    row("closest.time", "t", "the time at which {} are closest", Measure::Time, moves),
    proved(row("closest.separation", "s", "the least distance of {} on their way", Measure::Length, moves)),
    row("centers", "c", "the distance of the centres of {}", Measure::Length, is_of_two),
    row("radii", "r_1 + r_2", "the sum of the radii of {}", Measure::Length, is_of_two),
    row(
        "p",
        "p",
        "the distance of the centres of {} less the sum of their radii",
        Measure::Length,
        is_of_two,
    ),
    row("P.x", "P_x", "the x component of the penetration vector of {}", Measure::Length, is_of_two),
    row("P.y", "P_y", "the y component of the penetration vector of {}", Measure::Length, is_of_two),
    row("D", "D", "the distance from the clamped point to the circle's centre", Measure::Length, is_of_two),
    row("D.x", "D_x", "the x component of D", Measure::Length, is_of_two),
    row("D.y", "D_y", "the y component of D", Measure::Length, is_of_two),
    row("bound", "b", "how far any point of {} travels at most", Measure::Length, bounds_motion),
    row("L", "L", "the arc that the farthest point of {} travels", Measure::Length, bounds_motion),
    row("theta", r"\theta", "the angle by which {} turns", Measure::Degrees, bounds_motion),
    row("radius", "r", "how far the farthest point of {} is from its origin", Measure::Length, bounds_motion),
    row("min.x", r"x_{\mathrm{min}}", "the smallest x of {}", Measure::Length, is_for_a_box),
    row("min.y", r"y_{\mathrm{min}}", "the smallest y of {}", Measure::Length, is_for_a_box),
    row("max.x", r"x_{\mathrm{max}}", "the largest x of {}", Measure::Length, is_for_a_box),
    row("max.y", r"y_{\mathrm{max}}", "the largest y of {}", Measure::Length, is_for_a_box),
    row("h.x", "h_x", "half the width of the bounding box of {}", Measure::Length, is_for_a_box),
    row("h.y", "h_y", "half the height of the bounding box of {}", Measure::Length, is_for_a_box),
    row("c.x", "c_x", "the x of the centre of the bounding box of {}", Measure::Length, is_for_a_box),
    row("c.y", "c_y", "the y of the centre of the bounding box of {}", Measure::Length, is_for_a_box),
];

/// Every value that `[exercise]` may ask for, with what it is.
///
/// ```
/// let depth = tracefig::figure::exercise::askables().find(|(name, _)| *name == "depth").unwrap();
/// assert_eq!(depth.1, "the depth by which A and B overlap");
/// ```
pub fn askables() -> impl Iterator<Item = (&'static str, String)> {
    ASKABLE.iter().map(|row| (row.name, in_words(row.what, ["A and B", "A", "B"])))
}

/// What is to be found, of bodies that are called so: both, the first, the second.
pub(super) fn in_words(what: &str, [all, a, b]: [&str; 3]) -> String {
    what.replace("{}", all).replace("{a}", a).replace("{b}", b)
}

/// The value of a name that can be asked for in a kind of question.
pub(crate) fn askable(name: &str, kind: QueryKind) -> Option<&'static Askable> {
    ASKABLE.iter().find(|row| row.name == name && (row.of)(kind))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::values;

    #[test]
    fn every_row_is_a_value_of_texts() {
        for row in ASKABLE {
            assert!(values().any(|(name, _)| name == row.name), "{}", row.name);
        }
    }
}
