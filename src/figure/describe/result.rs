//! What came out, as a sentence.

use crate::collision::{Answer, Impact, Outcome, Reason, Separation};
use crate::figure::runs::Run;
use crate::figure::text::named;
use crate::geometry::Side;
use crate::scene::Scene;
use crate::trace::Event;

use super::number::{number, point, value};

/// The result of `run` as a sentence that begins with a small letter.
pub(super) fn result(scene: &Scene, run: &Run) -> String {
    let names = scene.names();
    result_of([names.of(Side::A), names.of(Side::B)], run)
}

/// The result of `run` for bodies named `a` and `b`, the second one empty where there is none.
fn result_of([a, b]: [&str; 2], run: &Run) -> String {
    match &run.answer {
        Answer::Bounds(bounds) => format!(
            "the bounding box of {a}{} reaches from {} to {}.",
            if b.is_empty() { String::new() } else { format!(" and {b}") },
            point(bounds.min),
            point(bounds.max)
        ),
        Answer::Overlap(overlap) => match overlap.overlap {
            Some(true) => format!("{a} and {b} overlap."),
            Some(false) => format!("{a} and {b} do not overlap."),
            None => format!("rounding forbids to say whether {a} and {b} overlap."),
        },
        Answer::Separation(s) => separation_in_words([a, b], s),
        Answer::Contact(contact) => {
            let apart = separation_in_words([a, b], &contact.separation);
            match contact.found().count() {
                0 => apart,
                1 => format!("{apart} They touch at one point."),
                _ => format!("{apart} They touch at two points."),
            }
        }
        Answer::Impact(impact) => impact_in_words([a, b], impact, run),
        Answer::MotionBound(found) => {
            let pair = if b.is_empty() { a.to_owned() } else { format!("{a} and {b}") };
            format!("no point of {pair} travels farther than {}.", value(found.bound))
        }
    }
}

/// How the bodies named `a` and `b` stand.
fn separation_in_words([a, b]: [&str; 2], s: &Separation) -> String {
    let (lo, hi) = (s.bounds.lo, s.bounds.hi);
    if lo > 0.0 {
        format!("{a} and {b} are {} apart along the normal {}.", number(lo, hi), point(*s.normal))
    } else if hi < 0.0 {
        let depth = number(-hi, -lo);
        format!(
            "{a} and {b} overlap; the shortest push that parts them is {depth} along {}.",
            point(*s.normal)
        )
    } else {
        format!("{a} and {b} touch.")
    }
}

/// The result of a query for the first contact of the bodies named `a` and `b`.
fn impact_in_words([a, b]: [&str; 2], impact: &Impact, run: &Run) -> String {
    match &impact.outcome {
        Outcome::Hit { time, contact } => format!(
            "{a} first touches {b} at t = {}, at {}.",
            number(time.lo, time.hi),
            point((contact.points[0] + contact.points[1]) / 2.0)
        ),
        Outcome::Miss => format!("{a} and {b} do not touch{}.", closest_in_words(run)),
        Outcome::Overlapping { .. } => format!("{a} and {b} touch or overlap from the start."),
        Outcome::Unresolved { reason, free_until } => {
            let why = match reason {
                Reason::WithinRounding => "rounding forbids more",
                Reason::WithinTolerance => "they come within the tolerance",
                Reason::IterationLimit => "the step cap was reached",
                Reason::Stalled => "the steps no longer advanced",
            };
            format!(
                "{a} and {b} are apart until t = {}; whether they touch is undecided: {why}.",
                value(*free_until)
            )
        }
    }
}

/// How near a miss came, as "; they come closest at t = 0.5, 2 apart"; empty where that was not told.
fn closest_in_words(run: &Run) -> String {
    let told = run.events().find_map(|event| match event {
        Event::ClosestApproachFound { at, bounds, .. } => Some((at.time, bounds)),
        _ => None,
    });
    told.map_or_else(String::new, |(time, bounds)| {
        format!("; they come closest at t = {}, {} apart", value(time), number(bounds.lo, bounds.hi))
    })
}

/// The result of `run` as a sentence of its own: with a capital, but a name stays as the scene writes it.
pub(crate) fn sentence(scene: &Scene, run: &Run) -> String {
    let names = scene.names();
    sentence_of([names.of(Side::A), names.of(Side::B)], run)
}

/// The sentence as markup, with the bodies' names as labels have them: a letter in italics.
pub(crate) fn sentence_markup(scene: &Scene, run: &Run) -> String {
    let names = scene.names();
    named([names.of(Side::A), names.of(Side::B)], |names| sentence_of(names, run))
}

/// The result of `run` for bodies named `a` and `b` as a sentence of its own.
fn sentence_of(names: [&str; 2], run: &Run) -> String {
    let text = result_of(names, run);
    if text.starts_with(&format!("{} ", names[0])) {
        return text;
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::runs::Runs;
    use crate::scene::open_text;

    #[test]
    fn a_letter_is_in_italics_and_a_word_or_a_number_with_the_same_letters_is_not() {
        let said = |a: &str, b: &str| {
            let text = format!(
                "shapes.{a} = {{ kind = 'circle', radius = 1 }}
                shapes.{b} = {{ kind = 'circle', radius = 1, position = [4, 0] }}
                query = {{ kind = 'separation', of = ['{a}', '{b}'] }}"
            );
            let scene = open_text("sentence.toml", &text).unwrap().scene;
            let runs = Runs::default();
            let run = runs.own(&scene, 0.0);
            (sentence(&scene, &run), sentence_markup(&scene, &run))
        };
        let (words, markup) = said("A", "a");
        assert_eq!(words, "A and a are 2 apart along the normal (1, 0).");
        assert_eq!(markup, "$A$ and $a$ are 2 apart along the normal (1, 0).");
        assert_eq!(said("apart", "B").1, "apart and $B$ are 2 apart along the normal (1, 0).");
    }
}
