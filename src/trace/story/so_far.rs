//! What a test of axes knows so far: the largest gap, or else the least overlap, among the axes before.
//!
//! An axis along which all of B lies behind A decides nothing: along an edge that faces the other way they
//! are apart.

use super::Voice;
use super::phrases::steps::{LESS_SO_FAR, MORE_SO_FAR, STILL_LARGEST, STILL_LEAST};
use crate::geometry::Enclosure;
use crate::trace::Event;

/// Whether B's interval along an axis lies behind A's, so that they are apart the other way round.
pub(crate) fn is_behind(a: Enclosure, b: Enclosure) -> bool {
    b.hi < a.lo
}

/// From where A ends to where B begins along a tested axis, negative where they overlap; `None` of another
/// event, and of an axis that decides nothing.
pub(crate) fn gap(event: &Event) -> Option<f64> {
    match event {
        Event::AxisTested { gap, interval_a, interval_b, .. } if !is_behind(*interval_a, *interval_b) => {
            Some(*gap)
        }
        _ => None,
    }
}

/// What an axis changes of what those `before` it told: whether it has the largest gap or the least overlap,
/// else which one has. `None` of another event, and where there is nothing to compare it with.
pub(crate) fn sentence(before: &[Event], event: &Event, voice: Voice) -> Option<String> {
    let Event::AxisTested { .. } = event else { return None };
    let gaps = before.iter().filter_map(|earlier| Some((earlier, gap(earlier)?)));
    // Of several the first.
    let (earlier, best) = gaps.reduce(|best, next| if next.1 > best.1 { next } else { best })?;
    match gap(event) {
        // That there is a gap at all has been told.
        Some(now) if now > 0.0 && best <= 0.0 => None,
        Some(now) if now > best => Some(voice.word(if now > 0.0 { &MORE_SO_FAR } else { &LESS_SO_FAR })),
        _ => {
            let Event::AxisTested { source: (side, feature), .. } = earlier else { return None };
            let phrase = if best > 0.0 { &STILL_LARGEST } else { &STILL_LEAST };
            let part = voice.part((*side, *feature));
            Some(voice.say(phrase, &[&voice.length(best.abs()), &part, &voice.of(*side)]))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, Feature, Names, Side};

    fn axis(edge: usize, [lo, hi]: [f64; 2]) -> Event {
        Event::AxisTested {
            axis: DVec2::X,
            source: (Side::A, Feature::Edge(edge)),
            interval_a: Enclosure { lo: 0.0, hi: 2.0 },
            interval_b: Enclosure { lo, hi },
            gap: lo - 2.0,
        }
    }

    #[test]
    fn an_axis_is_held_against_the_best_before_it() {
        let said = |spans: &[[f64; 2]]| {
            let all: Vec<Event> = spans.iter().enumerate().map(|(i, &span)| axis(i, span)).collect();
            let names = Names::new("crate", Some("wedge"));
            let voice = Voice::english(&names);
            (0..all.len()).map(|i| sentence(&all[..i], &all[i], voice)).collect::<Vec<_>>()
        };
        let text = |text: &str| Some(text.to_owned());
        let less = text("It is the least overlap so far.");
        let stays = text("The least overlap so far remains 0.5, by edge 1 of crate.");
        let (deep, shallow, behind) = ([0.5, 4.0], [1.5, 4.0], [-3.0, -1.0]);
        assert_eq!(said(&[deep, shallow, deep, shallow]), [None, less.clone(), stays.clone(), stays.clone()]);
        let other = text("The least overlap so far remains 0.5, by edge 2 of crate.");
        // One that faces away has no overlap that could be the least.
        assert_eq!(said(&[behind, deep, shallow, behind])[1..], [None, less, other]);
        let more = text("It is the largest gap so far.");
        let largest = text("The largest gap so far remains 2, by edge 2 of crate.");
        assert_eq!(said(&[deep, [3.0, 4.0], [4.0, 5.0], deep]), [None, None, more, largest]);
        assert_eq!(
            sentence(
                &[axis(0, deep)],
                &Event::Finished { outcome: "apart" },
                Voice::english(&Names::default())
            ),
            None
        );
    }
}
