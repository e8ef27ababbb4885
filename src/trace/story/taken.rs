//! Which edge of B ⊖ A a merge takes: its place in the order of directions, which layers write on it, and
//! which edge of which body it is.

use super::Voice;
use super::phrases::steps::TAKEN;
use crate::trace::Event;

/// What a step is called that ends with an event of a merge, or with the edge that it found: "3: edge 0 of
/// B". `None` of another event.
pub(crate) fn title(events: &[Event], index: usize, voice: Voice) -> Option<String> {
    let is_choice = |event: &&Event| matches!(event, Event::EdgesMerged { .. });
    // A merge tells the edge right after it took that.
    let choice = (index.saturating_sub(1)..=index).rfind(|&i| is_choice(&&events[i]))?;
    let Some(Event::DifferenceEdgeFound { source, edge, .. }) = events.get(choice + 1) else { return None };
    let place = events[..=choice].iter().filter(is_choice).count();
    let voice = voice.in_short();
    Some(voice.say(&TAKEN, &[&place.to_string(), &edge.to_string(), &voice.of(*source)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, Names, Side};

    #[test]
    fn a_taken_edge_has_its_place_in_the_order_and_its_index_on_its_body() {
        let (at, edge) = (DVec2::ZERO, DVec2::X);
        let choice = |taken| Event::EdgesMerged { taken, at, edge, other: None };
        let found = |source, index| Event::DifferenceEdgeFound {
            source,
            edge: index,
            vertex: 0,
            from: at,
            to: edge,
            normal: DVec2::NEG_Y,
            distance: 1.0,
        };
        let projected = Event::OriginProjected { foot: at, distance: 0.0 };
        let events =
            [choice(Side::B), found(Side::B, 3), projected.clone(), choice(Side::A), found(Side::A, 0)];
        let names = Names::default();
        let titles: Vec<_> = (0..events.len()).map(|i| title(&events, i, Voice::english(&names))).collect();
        let [first, second] = ["1: edge 3 of B", "2: edge 0 of A"].map(|text| Some(text.to_owned()));
        assert_eq!(titles, [first.clone(), first, None, second.clone(), second]);
        assert_eq!(title(&[projected], 0, Voice::english(&names)), None);
    }
}
