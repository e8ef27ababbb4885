//! What of a trace is told: nothing that the algorithm does not do by itself, and in an exercise's key no
//! more rows than a reader follows.
//!
//! An algorithm by components records the edges of B ⊖ A for layers that draw them, and looks at none: its
//! story leaves them out, as JSON lines do not.

use super::phrases::events::{
    DEPTH_IS, DISTANCE_IS, EDGES, LARGEST_GAP, LEAST_DEEP, LEAST_OVERLAP, LESS_RADII, NEAREST, OUTLINE,
    WITH_RADII,
};
use super::phrases::moving::{MANY_AWAY, ONE_AWAY};
use super::{Voice, sentence_in};
use crate::geometry::DVec2;
use crate::trace::{Culling, Event, Goal, Trace};

/// Edges that a key tells each in a row of its own.
const FEW: usize = 6;
/// Vertices of B ⊖ A that a key lists.
const LISTED: usize = 12;

/// Whether an algorithm that looks at components told this, and at no edge of B ⊖ A.
pub(crate) fn is_by_component(event: &Event) -> bool {
    matches!(event, Event::Clamped { .. } | Event::ExtentsCompared { .. } | Event::CirclesCompared { .. })
}

/// Whether an event is about the edges of B ⊖ A, one by one.
fn is_of_edges(event: &Event) -> bool {
    matches!(
        event,
        Event::DifferenceEdgeFound { .. }
            | Event::DifferenceRounded { .. }
            | Event::EdgesMerged { .. }
            | Event::OriginProjected { .. }
            | Event::CandidateImproved { .. }
            | Event::SupportFound { .. }
    )
}

/// The events of a trace that are told, in their order.
pub(crate) fn told(trace: &Trace) -> impl Iterator<Item = &Event> {
    let is_by_components = trace.events.iter().any(is_by_component);
    trace.events.iter().filter(move |event| !(is_by_components && is_of_edges(event)))
}

/// A search of which the last thing told is no candidate that another one may better: that is what it found.
#[derive(Clone, Copy)]
pub(crate) enum Search {
    /// Axes were tested.
    Axes,
    /// Simplices came nearer to the origin, of bodies without their radii.
    Simplices,
    /// Edges were looked at, none of which follows.
    AllEdges,
    /// Another one.
    Edges,
}

impl Search {
    /// What kind of search told these events.
    pub(crate) fn of<'e>(events: impl IntoIterator<Item = &'e Event>) -> Self {
        let kind = |event: &Event| match event {
            Event::AxisTested { .. } => Some(Self::Axes),
            Event::SimplexUpdated { .. } | Event::PolytopeExpanded { .. } => Some(Self::Simplices),
            _ => None,
        };
        events.into_iter().find_map(kind).unwrap_or(Self::Edges)
    }

    /// This search at an event that these ones follow.
    pub(crate) fn at(self, after: &[Event]) -> Self {
        let goes_on = |event: &Event| {
            matches!(event, Event::DifferenceEdgeFound { .. } | Event::CandidateImproved { .. })
        };
        if matches!(self, Self::Edges) && !after.iter().any(goes_on) { Self::AllEdges } else { self }
    }

    /// What is told of the end of such a search; `None` of another event, or of a candidate like others.
    pub(crate) fn end(self, event: &Event, voice: Voice) -> Option<String> {
        let Event::CandidateImproved { goal, distance, foot, source: (side, feature) } = event else {
            return None;
        };
        let is_deep = *goal == Goal::LeastPenetrating;
        let (size, part, body) =
            (voice.length(distance.abs()), voice.part((*side, *feature)), voice.of(*side));
        match self {
            Self::Axes => {
                let phrase = if is_deep { &LEAST_OVERLAP } else { &LARGEST_GAP };
                Some(voice.say(phrase, &[&size, &part, &body]))
            }
            Self::Simplices | Self::AllEdges => {
                let at = voice.point(*foot);
                if voice.names.has_radius() {
                    let phrase = if is_deep { &WITH_RADII } else { &LESS_RADII };
                    return Some(voice.say(phrase, &[&size, &at, &part, &body]));
                }
                let phrase = if is_deep { &DEPTH_IS } else { &DISTANCE_IS };
                Some(voice.say(phrase, &[&size, &voice.difference(), &at, &part, &body]))
            }
            Self::Edges => None,
        }
    }
}

/// The sentences of events that a reader works through: rows of many edges are gathered, and where nothing
/// turns the edges are told once.
pub(crate) fn way<'e>(events: impl Iterator<Item = &'e Event>, voice: Voice, turns: bool) -> Vec<String> {
    let events: Vec<&Event> = events.collect();
    let is_advancing = events.iter().any(|event| matches!(event, Event::Advanced { .. }));
    let search = Search::of(events.iter().copied());
    let said = |event: &Event| search.end(event, voice).unwrap_or_else(|| sentence_in(event, voice));
    let (mut all, mut rest, mut is_first) = (Vec::new(), &events[..], true);
    while let Some(&event) = rest.first() {
        let is_row: fn(&Event) -> bool = match event {
            Event::RayClipped { .. } => is_of_ray,
            Event::DifferenceEdgeFound { .. } | Event::CandidateImproved { .. } => is_of_search,
            _ => |_| false,
        };
        let count = rest.iter().take_while(|event| is_row(event)).count().max(1);
        let (rows, after) = rest.split_at(count);
        rest = after;
        let edges = rows.iter().filter(|event| !matches!(event, Event::CandidateImproved { .. })).count();
        if rows.len() == 1 || (edges <= FEW && !is_advancing) {
            all.extend(rows.iter().map(|event| said(event)));
        } else if is_of_ray(event) {
            all.extend(along_ray(rows, voice));
        } else {
            all.extend(outline(rows, voice).filter(|_| is_first || turns));
            all.extend(nearest(rows, voice));
            is_first = false;
        }
    }
    all
}

/// Whether an event is of a ray that meets an edge.
fn is_of_ray(event: &Event) -> bool {
    matches!(event, Event::RayClipped { .. })
}

/// Whether an event is of a search for the nearest edge.
fn is_of_search(event: &Event) -> bool {
    matches!(event, Event::DifferenceEdgeFound { .. } | Event::CandidateImproved { .. })
}

/// The edges of B ⊖ A in one sentence, as they follow each other; `None` without any.
fn outline(rows: &[&Event], voice: Voice) -> Option<String> {
    let edge = |event: &&Event| match event {
        Event::DifferenceEdgeFound { from, to, .. } => Some((*from, *to)),
        _ => None,
    };
    let edges: Vec<(DVec2, DVec2)> = rows.iter().filter_map(edge).collect();
    let (what, count) = (voice.difference(), edges.len());
    let mut at = edges.first()?.0;
    let mut vertices = Vec::new();
    while vertices.len() < count.min(LISTED) {
        vertices.push(at);
        // The end of an edge is the start of another one, to the bit.
        at = edges.iter().find(|(from, _)| *from == at).map_or(at, |&(_, to)| to);
    }
    let counted = count.to_string();
    Some(match count {
        1..=LISTED => voice.say(&OUTLINE, &[&what, &counted, &voice.points(&vertices)]),
        _ => voice.say(&EDGES, &[&what, &counted]),
    })
}

/// Which of the edges is nearest to the origin; `None` where none was found to be.
fn nearest(rows: &[&Event], voice: Voice) -> Option<String> {
    rows.iter().rev().find_map(|event| match event {
        Event::CandidateImproved { goal, distance, foot, source: (side, feature) } => {
            let phrase = match goal {
                Goal::LeastPositive => &NEAREST,
                Goal::LeastPenetrating => &LEAST_DEEP,
            };
            let (edge, body) = (voice.part((*side, *feature)), voice.of(*side));
            let (size, foot) = (voice.length(distance.abs()), voice.point(*foot));
            Some(voice.say(phrase, &[&edge, &body, &size, &foot]))
        }
        _ => None,
    })
}

/// Whether an event is of a ray that passes over an edge, which faces away.
pub(crate) fn is_away(event: &Event) -> bool {
    matches!(event, Event::RayClipped { outcome: Culling::BackFacing, .. })
}

/// How many edges a ray passes over; `None` where it passes over none.
pub(crate) fn skipped(away: usize, voice: Voice) -> Option<String> {
    match away {
        0 => None,
        1 => Some(voice.word(&ONE_AWAY)),
        _ => Some(voice.say(&MANY_AWAY, &[&away.to_string()])),
    }
}

/// The edges that the ray is held against; those that face away are counted.
fn along_ray(rows: &[&Event], voice: Voice) -> Vec<String> {
    let away = rows.iter().filter(|event| is_away(event)).count();
    let met = rows.iter().filter(|event| !is_away(event)).map(|event| sentence_in(event, voice));
    skipped(away, voice).into_iter().chain(met).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Enclosure, Feature, Names, Side};
    use crate::trace::Tracer;
    use crate::trace::story::story;

    /// Edges of a convex polygon as the events that tell them.
    fn edges(vertices: &[DVec2]) -> Vec<Event> {
        let next = vertices.iter().cycle().skip(1);
        let edge = |(edge, (&from, &to)): (usize, (&DVec2, &DVec2))| Event::DifferenceEdgeFound {
            source: if edge % 2 == 0 { Side::A } else { Side::B },
            edge,
            vertex: 0,
            from,
            to,
            normal: DVec2::X,
            distance: 1.0,
        };
        vertices.iter().zip(next).enumerate().map(edge).collect()
    }

    fn octagon() -> Vec<DVec2> {
        [(2., -1.), (2., 1.), (1., 2.), (-1., 2.), (-2., 1.), (-2., -1.), (-1., -2.), (1., -2.)]
            .map(DVec2::from)
            .to_vec()
    }

    fn improved() -> Event {
        let source = (Side::A, Feature::Edge(3));
        Event::CandidateImproved { goal: Goal::LeastPositive, distance: 2.0, foot: DVec2::X, source }
    }

    #[test]
    fn a_few_edges_are_told_each_and_many_as_one_whole() {
        let names = Names::default();
        let few = edges(&octagon()[..4]);
        assert_eq!(way(few.iter(), Voice::english(&names), false).len(), 4);
        let mut many = edges(&octagon());
        many.reverse();
        many.push(improved());
        assert_eq!(
            way(many.iter(), Voice::english(&names), false),
            [
                "B ⊖ A has 8 edges, from vertex to vertex: (1, -2), (2, -1), (2, 1), (1, 2), (-1, 2), \
                 (-2, 1), (-2, -1) and (-1, -2).",
                "Nearest to the origin is edge 3 of A: 2 away, at (1, 0).",
            ]
        );
    }

    #[test]
    fn of_axes_the_largest_gap_decides() {
        let axis = Event::AxisTested {
            axis: DVec2::X,
            source: (Side::A, Feature::Edge(3)),
            interval_a: Enclosure { lo: 0.0, hi: 1.0 },
            interval_b: Enclosure { lo: 3.0, hi: 4.0 },
            gap: 2.0,
        };
        let names = Names::default();
        let told = way([&axis, &improved()].into_iter(), Voice::english(&names), false);
        assert_eq!(told[1], "The largest gap is the distance: 2, by edge 3 of A.");
        let deep = Event::CandidateImproved {
            goal: Goal::LeastPenetrating,
            distance: -0.5,
            foot: DVec2::X,
            source: (Side::B, Feature::Edge(0)),
        };
        let trace = Trace { events: vec![axis, deep], left_out: 0 };
        let told = story(&trace, &names);
        assert!(told.ends_with("The least overlap is the depth: 0.5, by edge 0 of B.\n"), "{told}");
    }

    #[test]
    fn where_nothing_turns_the_edges_are_told_once() {
        let mut search = edges(&octagon());
        search.push(improved());
        let step = Event::AxisSwept { from: 0.0, to: 1.0, owner: Side::A, normal: DVec2::X };
        let events: Vec<&Event> = search.iter().chain([&step]).chain(&search).collect();
        let names = Names::default();
        let count = |turns| {
            let told = way(events.iter().copied(), Voice::english(&names), turns);
            told.iter().filter(|sentence| sentence.contains("has 8 edges")).count()
        };
        assert_eq!([count(false), count(true)], [1, 2]);
    }

    #[test]
    fn a_story_by_components_has_no_edges_and_any_other_has_them() {
        let mut trace = Trace::default();
        for event in edges(&octagon()) {
            trace.record(|| event);
        }
        assert_eq!(story(&trace, &Names::default()).lines().count(), 8);
        let [centers, half_extents] = [[DVec2::ZERO, DVec2::splat(3.0)], [DVec2::ONE; 2]];
        trace.record(|| Event::ExtentsCompared { centers, half_extents, gap: DVec2::ONE });
        assert_eq!(story(&trace, &Names::default()).lines().count(), 1);
    }

    #[test]
    fn edges_that_face_away_from_the_ray_are_counted() {
        let clipped = |outcome| Event::RayClipped {
            source: (Side::B, Feature::Edge(0)),
            from: DVec2::X,
            to: DVec2::Y,
            outcome,
            time: None,
        };
        let mut rows: Vec<Event> = (0..7).map(|_| clipped(Culling::BackFacing)).collect();
        rows.push(clipped(Culling::Hit));
        let told = way(rows.iter(), Voice::english(&Names::default()), false);
        assert_eq!(told[0], "7 edges face away from the ray and are skipped.");
        assert!(told.len() == 2 && told[1].contains("entered"), "{told:?}");
    }
}
