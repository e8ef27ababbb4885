//! Which events end a step of a figure, what a step is called, and the parts in which an event is shown.
//!
//! A step is a run of events after which the picture changes. One that only prepares what follows, as the
//! search for a vertex, belongs to the step of that. An event that tells several things one after the other
//! has a part for each, so that a figure can show them in that order.

use super::motion::with_turning;
use super::phrases::events::{EDGES, UNBUILT};
use super::phrases::steps as words;
use super::{Voice, sentence_in};
use crate::geometry::{DVec2, Feature, Side};
use crate::trace::tongue::Phrase;
use crate::trace::{Culling, Event, Goal, SupportVertex};

/// The part of the last [`Event::DifferenceEdgeFound`] with which the whole of B ⊖ A is known.
pub(crate) const WHOLE: usize = 1;

/// The parts of [`Event::BoundsFound`].
pub(crate) mod bounds {
    /// Vertices on the left; then those below, on the right and above, each a part.
    pub(crate) const TOUCHING: usize = 0;
    /// The box through them.
    pub(crate) const BOX: usize = 4;
    /// Its centre and half-extents.
    pub(crate) const CENTER: usize = 5;
}

/// The parts of [`Event::Clamped`].
pub(crate) mod clamped {
    /// V, from centre to centre.
    pub(crate) const WAY: usize = 0;
    /// What the half-extents leave of it.
    pub(crate) const CUT: usize = 1;
    /// The closest point, and D from there.
    pub(crate) const CLOSEST: usize = 2;
}

/// The parts of [`Event::MotionBounded`].
pub(crate) mod turned {
    /// The farthest vertex.
    pub(crate) const FARTHEST: usize = 0;
    /// The angle and the arc of that vertex.
    pub(crate) const ARC: usize = 1;
    /// The bound.
    pub(crate) const BOUND: usize = 2;
}

/// The parts of [`Event::Advanced`].
pub(crate) mod advanced {
    /// How far apart the bodies are.
    pub(crate) const APART: usize = 0;
    /// How far it is safe to go.
    pub(crate) const NEXT: usize = 1;
}

/// Whether a step of a figure ends with an event that it shows.
#[must_use]
pub(crate) fn ends_step(event: &Event) -> bool {
    // Every event has its own arm, so that a new one does not build without its row.
    match event {
        Event::Started { .. }
        | Event::CirclesCompared { .. }
        | Event::PenetrationMeasured { .. }
        | Event::BoundsFound { .. }
        | Event::ExtentsCompared { .. }
        | Event::Clamped { .. }
        | Event::DifferenceEdgeFound { .. }
        | Event::DifferenceRounded { .. }
        | Event::CandidateImproved { .. }
        | Event::AxisTested { .. }
        | Event::SimplexUpdated { .. }
        | Event::PolytopeExpanded { .. }
        | Event::RayClipped { .. }
        | Event::Advanced { .. }
        | Event::AxisSwept { .. }
        | Event::ClosestApproachFound { .. }
        | Event::ExpectationCompared { .. }
        | Event::MotionBounded { .. }
        | Event::EdgesFaced { .. }
        | Event::EdgeCut { .. }
        | Event::ContactFound { .. }
        | Event::Finished { .. } => true,
        Event::SupportFound { .. }
        | Event::EdgesMerged { .. }
        | Event::OriginProjected { .. }
        | Event::SeparatingAxisFound { .. } => false,
    }
}

/// What a step is called that shows how the bodies stand at a moment.
#[must_use]
pub(crate) fn title_at(time: f64, voice: Voice) -> String {
    voice.say(&words::AT, &[&voice.in_short().number(time)])
}

/// What a step is called that ends with a part of an event.
#[must_use]
pub(crate) fn title(event: &Event, of: usize, voice: Voice) -> String {
    let voice = voice.in_short();
    voice.word(match event {
        Event::Started { .. } => &words::QUESTION,
        Event::CirclesCompared { .. } => &words::SQUARES,
        Event::PenetrationMeasured { .. } => &words::PENETRATION,
        Event::BoundsFound { .. } if of == bounds::CENTER => &words::CENTER,
        Event::BoundsFound { .. } => SIDES.get(of).map_or(&words::BOX, |(title, _)| title),
        Event::ExtentsCompared { .. } => &words::EXTENTS,
        Event::Clamped { .. } if of == clamped::WAY => &words::WAY,
        Event::Clamped { v, clamped, .. } if of == clamped::CUT && v == clamped => &words::WITHIN,
        Event::Clamped { .. } if of == clamped::CUT => &words::CLAMPED,
        Event::Clamped { .. } => &words::CLOSEST_POINT,
        Event::SupportFound { .. } => &words::FARTHEST,
        Event::DifferenceEdgeFound { source, edge, .. } if of != WHOLE => {
            return voice.say(&words::EDGE_OF, &[&edge.to_string(), &voice.of(*source)]);
        }
        Event::DifferenceEdgeFound { .. } | Event::DifferenceRounded { .. } => {
            return voice.difference();
        }
        Event::EdgesMerged { taken, .. } => return voice.say(&words::AN_EDGE_OF, &[&voice.of(*taken)]),
        Event::OriginProjected { .. } => &words::NEAREST_POINT,
        Event::CandidateImproved { goal: Goal::LeastPenetrating, .. } => &words::LEAST_DEPTH,
        Event::CandidateImproved { .. } => &words::LEAST,
        Event::AxisTested { source: (side, feature), .. } => {
            let phrase =
                if matches!(feature, Feature::Vertex(_)) { &words::AWAY_FROM } else { &words::NORMAL_OF };
            return voice.say(phrase, &[&voice.part((*side, *feature)), &voice.of(*side)]);
        }
        Event::SeparatingAxisFound { .. } => &words::SEPARATING,
        Event::SimplexUpdated { vertices, closest, .. } => {
            return of_simplex(vertices.len(), *closest, voice);
        }
        Event::PolytopeExpanded { nearest, .. } => {
            return voice.say(&words::AT_LEAST, &[&voice.length(*nearest)]);
        }
        Event::RayClipped { outcome: Culling::BackFacing, .. } => &words::AWAY,
        Event::RayClipped { source: (side, feature), .. } => {
            return voice.say(&words::RAY, &[&voice.part((*side, *feature)), &voice.of(*side)]);
        }
        Event::Advanced { step, .. } => {
            let what = if of == advanced::APART { &words::HOW_FAR } else { &words::HOW_SAFE };
            return voice.say(what, &[&step.to_string()]);
        }
        Event::AxisSwept { .. } => &words::SWEPT,
        Event::ClosestApproachFound { .. } => &words::CLOSEST,
        Event::ExpectationCompared { .. } => &words::EXPECTED,
        Event::MotionBounded { .. } if of == turned::FARTHEST => &words::FARTHEST,
        Event::MotionBounded { .. } if of == turned::ARC => &words::ARC,
        Event::MotionBounded { .. } => &words::BOUND,
        Event::EdgesFaced { .. } => &words::FACED,
        Event::EdgeCut { .. } => &words::CUT,
        Event::ContactFound { touches: false, .. } => &words::NO_CONTACT,
        Event::ContactFound { .. } => &words::CONTACT,
        Event::Finished { .. } => &words::ANSWER,
    })
}

/// What a step is called that ends with a simplex of so many vertices.
fn of_simplex(vertices: usize, closest: DVec2, voice: Voice) -> String {
    let what = voice.word(match vertices {
        1 => &words::A_VERTEX,
        2 => &words::AN_EDGE,
        _ => &words::A_TRIANGLE,
    });
    if closest == DVec2::ZERO {
        voice.say(&words::HOLDS, &[&what])
    } else {
        voice.say(&words::AT_MOST, &[&what, &voice.length(closest.length())])
    }
}

/// What a part of an event says in one sentence.
#[must_use]
pub(crate) fn sentence_of_part(event: &Event, of: usize, voice: Voice) -> String {
    match event {
        Event::BoundsFound { of: body, min, max, touching } => {
            let whose = body.map_or_else(|| voice.all(), |side| voice.of(side));
            bounds_part((*body, &whose), of, ([*min, *max], touching), voice)
        }
        Event::Clamped { body, v, half_extents, clamped, closest, d, .. } => {
            let (own, other) = (voice.of(*body), voice.of(body.other()));
            let point = |p: &DVec2| voice.point(*p);
            let is_inside = v == clamped;
            match of {
                clamped::WAY => voice.say(&words::LEADS, &[&own, &other, &point(v), &own]),
                clamped::CUT if is_inside => {
                    voice.say(&words::IS_WITHIN, &[&point(half_extents), &other, &own])
                }
                _ if is_inside => voice.say(&words::NEAREST_SIDE, &[&point(closest), &own, &point(d)]),
                clamped::CUT => voice.say(&words::CUT_DOWN, &[&point(half_extents), &point(clamped)]),
                _ => voice.say(&words::LEADS_TO, &[&point(closest), &own, &other, &point(d)]),
            }
        }
        Event::MotionBounded { body, radius, theta, arc, vertices, .. } => {
            let own = voice.of(*body);
            match of {
                turned::FARTHEST => {
                    let vertex = first(Some(*body), vertices, voice);
                    voice.say(&words::FARTHEST_BY, &[&own, &voice.number(*radius), &vertex])
                }
                _ if *theta == 0.0 => voice.say(&words::TURNS_NOT, &[&own]),
                turned::ARC => voice.say(&words::TURNS, &[&own, &voice.number(*theta)]),
                _ => voice.say(&words::NO_FARTHER, &[&own, &voice.at_most(*arc)]),
            }
        }
        Event::Advanced { at, separation, normal, closing_speed, bound, next, .. } => match (of, next) {
            (advanced::APART, _) => {
                let words = if *separation < 0.0 { &words::OVERLAP } else { &words::APART };
                voice.say(words, &[&voice.length(separation.abs()), &voice.point(*normal)])
            }
            (_, None) if *separation < 0.0 => voice.word(&words::STOPS),
            (_, Some(next)) if *closing_speed <= 0.0 => {
                voice.say(&words::TURN_IN, &[&voice.number(*bound), &voice.number(*next)])
            }
            (_, Some(next)) => {
                let (speed, turning) =
                    (voice.number(*closing_speed), with_turning(voice, [*closing_speed, *bound]));
                voice.say(&words::CLOSE_IN, &[&speed, &turning, &voice.number(*next)])
            }
            (_, None) if *bound <= 0.0 => voice.word(&words::NO_NEARER),
            (_, None) if at.time + separation / bound > 1.0 => {
                let past = at.time + separation / bound;
                voice.say(&words::PAST_THE_END, &[&voice.number(*bound), &voice.number(past)])
            }
            (_, None) => voice.word(&words::STOPS),
        },
        _ => sentence_in(event, voice),
    }
}

/// What B ⊖ A as a whole is told as, which is given where the algorithm has no need of it.
#[must_use]
pub(crate) fn sentence_of_difference(edges: usize, is_given: bool, voice: Voice) -> String {
    voice.say(if is_given { &UNBUILT } else { &EDGES }, &[&voice.difference(), &edges.to_string()])
}

/// Why an advancement to a tolerance ends with an event; `None` of one that goes on.
#[must_use]
pub(crate) fn end_of_advancement(event: &Event, tolerance: f64, voice: Voice) -> Option<String> {
    match event {
        Event::Advanced { next: None, separation, .. } if *separation <= tolerance => {
            Some(voice.say(&words::WITHIN_TOLERANCE, &[&voice.number(tolerance)]))
        }
        Event::Advanced { next: None, .. } => Some(sentence_of_part(event, advanced::NEXT, voice)),
        _ => None,
    }
}

/// What is said of steps of an advancement of which a figure shows none.
#[must_use]
pub(crate) fn left_out(count: usize, voice: Voice) -> String {
    voice.say(&words::LEFT_OUT, &[&count.to_string()])
}

/// What the sides of a box are called: as a title, and in a sentence.
static SIDES: [(&Phrase, &Phrase); 4] = [
    (&words::LEFTMOST, &words::IS_LEFTMOST),
    (&words::LOWEST, &words::IS_LOWEST),
    (&words::RIGHTMOST, &words::IS_RIGHTMOST),
    (&words::HIGHEST, &words::IS_HIGHEST),
];

/// A part of the search for the box of `whose`.
fn bounds_part(
    (side, whose): (Option<Side>, &str),
    of: usize,
    ([min, max], touching): ([DVec2; 2], &[Vec<SupportVertex>; 4]),
    voice: Voice,
) -> String {
    match (SIDES.get(of), touching.get(of)) {
        (Some((_, phrase)), Some(vertices)) => voice.say(phrase, &[whose, &first(side, vertices, voice)]),
        _ if of == bounds::CENTER => {
            let (center, half_extents) = (0.5 * (min + max), 0.5 * (max - min));
            voice.say(&words::CENTER_IS, &[&voice.point(center), &voice.point(half_extents)])
        }
        _ => voice.say(&words::BOX_RUNS, &[&voice.point(min), &voice.point(max)]),
    }
}

/// The first of some vertices, and that there are more.
fn first(side: Option<Side>, vertices: &[SupportVertex], voice: Voice) -> String {
    let Some(vertex) = vertices.first() else { return voice.word(&words::NO_VERTEX) };
    let told = voice.around(side, vertex);
    if vertices.len() > 1 { voice.say(&words::AMONG_OTHERS, &[&told]) } else { told }
}
