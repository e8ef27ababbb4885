//! What is new in a simplex or polytope: the vertices that it has and the one before had not, and those that
//! it does without.

use super::phrases::BOTH;
use super::phrases::events::{HELD, SIMPLEX_ENDS, SIMPLEX_GROWS};
use super::phrases::steps::{ADD, AROUND, BEGIN_AT, BEGIN_WITH, DROP, NONE_BEYOND, NOTHING_NEW};
use super::words::Voice;
use crate::geometry::{DVec2, begun};
use crate::trace::Event;
use crate::trace::tongue::Phrase;

/// The vertices of a simplex or polytope; `None` of another event.
fn vertices(event: &Event) -> Option<&[DVec2]> {
    match event {
        Event::SimplexUpdated { vertices, .. } | Event::PolytopeExpanded { vertices, .. } => Some(vertices),
        _ => None,
    }
}

/// Whether two events are of one kind.
fn alike(a: &Event, b: &Event) -> bool {
    std::mem::discriminant(a) == std::mem::discriminant(b)
}

/// What a step is called that ends with a simplex or polytope, among the events `before` and `after` it:
/// "Begin at (9, 2)", "Add (5, 0), drop (9, 2)", "Add (1, 3): no vertex is beyond". `None` of another event.
#[must_use]
pub(crate) fn title(before: &[Event], event: &Event, after: &[Event], voice: Voice) -> Option<String> {
    let (voice, now) = (voice.in_short(), vertices(event)?);
    let last = before.iter().rev().find_map(vertices);
    let begins = !before.iter().any(|earlier| alike(earlier, event));
    let title = match (event, last) {
        (Event::PolytopeExpanded { .. }, _) if begins => voice.say(&AROUND, &[&now.len().to_string()]),
        (_, None) if now.len() == 1 => voice.say(&BEGIN_AT, &[&voice.point(now[0])]),
        (_, None) => voice.say(&BEGIN_WITH, &[&now.len().to_string()]),
        (_, Some(last)) => changed(last, now, voice),
    };
    let is_last = !after.iter().any(|later| vertices(later).is_some());
    let is_found = match event {
        Event::SimplexUpdated { closest, .. } => *closest != DVec2::ZERO,
        Event::PolytopeExpanded { beyond, .. } => *beyond <= 0.0,
        _ => false,
    };
    Some(if is_last && is_found { voice.say(&NONE_BEYOND, &[&title]) } else { title })
}

/// What a simplex says that knows what comes `after` it: the vertex that is found where it says to look, or
/// that there is none. `None` of another event, and of a simplex that holds the origin.
#[must_use]
pub(crate) fn sentence<'e>(
    event: &Event,
    mut after: impl Iterator<Item = &'e Event>,
    voice: Voice,
) -> Option<String> {
    let Event::SimplexUpdated { vertices: now, closest, direction } = event else { return None };
    if *closest == DVec2::ZERO {
        return None;
    }
    let next = after.find_map(|later| match later {
        Event::SimplexUpdated { vertices, .. } => Some(vertices),
        _ => None,
    });
    let [all, closest, way] = [voice.points(now), voice.point(*closest), voice.point(*direction)];
    let found = next.map(|next| next.iter().find(|p| !now.contains(p)));
    match found {
        Some(found) => Some(voice.say(&SIMPLEX_GROWS, &[&all, &closest, &way, &voice.point(*found?)])),
        None => Some(voice.say(&SIMPLEX_ENDS, &[&all, &closest, &way])),
    }
}

/// The simplex around the origin from which a search goes on with its first polytope, and what a reader is
/// told of it who has not seen it; `None` of another event.
#[must_use]
pub(crate) fn held<'e>(before: &'e [Event], event: &Event, voice: Voice) -> Option<(&'e Event, String)> {
    let is_polytope = |event: &Event| matches!(event, Event::PolytopeExpanded { .. });
    let last = before.iter().rev().find(|earlier| vertices(earlier).is_some())?;
    (is_polytope(event) && !is_polytope(last)).then(|| (last, voice.word(&HELD)))
}

/// What came and what went.
fn changed(last: &[DVec2], now: &[DVec2], voice: Voice) -> String {
    let lacks = |of: &[DVec2], all: &[DVec2]| -> Vec<String> {
        all.iter().filter(|p| !of.contains(p)).map(|&p| voice.point(p)).collect()
    };
    let said = |verb: &Phrase, points: Vec<String>| {
        let points = points.into_iter().reduce(|before, next| voice.say(&BOTH, &[&before, &next]));
        points.map(|points| voice.say(verb, &[&points]))
    };
    let parts: Vec<String> =
        said(&ADD, lacks(last, now)).into_iter().chain(said(&DROP, lacks(now, last))).collect();
    let text = parts.join(", ");
    if text.is_empty() { voice.word(&NOTHING_NEW) } else { begun(&text) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn simplex(vertices: &[[f64; 2]]) -> Event {
        let closest = DVec2::from(vertices[0]);
        Event::SimplexUpdated {
            vertices: vertices.iter().map(|&p| p.into()).collect(),
            closest,
            direction: -closest,
        }
    }

    #[test]
    fn a_title_says_what_came_and_what_went_and_where_the_search_ends() {
        let all = [
            simplex(&[[9.0, 2.0]]),
            simplex(&[[9.0, 2.0], [-1.0, 7.0]]),
            simplex(&[[-1.0, 7.0], [5.0, 0.0]]),
        ];
        let names = crate::geometry::Names::default();
        let voice = Voice::english(&names);
        let said = |k: usize| sentence(&all[k], all[k + 1..].iter(), voice).unwrap();
        assert!(said(0).ends_with("so look along (-9, -2): farthest there is (-1, 7)."), "{}", said(0));
        assert!(said(2).starts_with("The simplex is (-1, 7) and (5, 0); closest"), "{}", said(2));
        assert!(said(2).ends_with("nothing is farther along (1, -7): the search ends."), "{}", said(2));
        let titles: Vec<_> = (0..3).filter_map(|k| title(&all[..k], &all[k], &all[k + 1..], voice)).collect();
        assert_eq!(
            titles,
            ["Begin at (9, 2)", "Add (−1, 7)", "Add (5, 0), drop (9, 2): no vertex is beyond"]
        );
        assert_eq!(title(&[], &Event::Finished { outcome: "apart" }, &[], voice), None);
        // The last simplex of a search that goes on with a polytope holds the origin.
        let held = simplex(&[[0.0, 0.0]]);
        assert_eq!(title(&all[..1], &held, &[], voice).unwrap(), "Add (0, 0), drop (9, 2)");
    }
}
