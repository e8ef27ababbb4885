//! Which events end a step of a figure, what a step is called, and the parts in which an event is shown.
//!
//! A step is a run of events after which the picture changes. One that only prepares what follows, as the
//! search for a vertex, belongs to the step of that. An event that tells several things one after the other
//! has a part for each, so that a figure can show them in that order.

use super::sentence;
use super::words::{number, part, point};
use crate::geometry::{DVec2, Names, Side};
use crate::trace::{Event, SupportVertex};

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
        | Event::RayClipped { .. }
        | Event::SeparatingAxisFound { .. } => false,
    }
}

/// What a step is called that shows how the bodies stand at a moment.
#[must_use]
pub(crate) fn title_at(time: f64) -> String {
    format!("At t = {}", number(time))
}

/// What a step is called that ends with a part of an event, of bodies that are called `names`.
#[must_use]
pub(crate) fn title(event: &Event, of: usize, names: &Names) -> String {
    let edge_of = |edge: usize, side: Side| format!("Edge {edge} of {}", names.quoted(side));
    match event {
        Event::Started { .. } => "The question".to_owned(),
        Event::CirclesCompared { .. } => "Centres and radii".to_owned(),
        Event::PenetrationMeasured { .. } => "The penetration".to_owned(),
        Event::BoundsFound { .. } => match of {
            bounds::BOX => "The box",
            bounds::CENTER => "Centre and half-extents",
            side => SIDES.get(side).map_or("The box", |(title, _)| title),
        }
        .to_owned(),
        Event::ExtentsCompared { .. } => "The extents".to_owned(),
        Event::Clamped { .. } => match of {
            clamped::WAY => "From centre to centre",
            clamped::CUT => "Cut to the half-extents",
            _ => "The closest point",
        }
        .to_owned(),
        Event::SupportFound { .. } => "The farthest vertex".to_owned(),
        Event::DifferenceEdgeFound { .. } | Event::DifferenceRounded { .. } if of == WHOLE => {
            super::difference(names)
        }
        Event::DifferenceEdgeFound { source, edge, .. } => edge_of(*edge, *source),
        Event::EdgesMerged { taken, .. } => format!("An edge of {}", names.quoted(*taken)),
        Event::DifferenceRounded { .. } => super::difference(names),
        Event::OriginProjected { .. } => "The nearest point".to_owned(),
        Event::CandidateImproved { .. } => "The least distance".to_owned(),
        Event::AxisTested { source: (side, feature), .. } => {
            format!("The normal of {} of {}", part(*feature), names.quoted(*side))
        }
        Event::SeparatingAxisFound { .. } => "A separating axis".to_owned(),
        Event::SimplexUpdated { vertices, closest, .. } => {
            let what = match vertices.len() {
                1 => "A vertex",
                2 => "An edge",
                _ => "A triangle",
            };
            if *closest == DVec2::ZERO {
                format!("{what} that holds the origin")
            } else {
                format!("{what}: at most {} away", number(closest.length()))
            }
        }
        Event::PolytopeExpanded { nearest, .. } => format!("A polytope: at least {} deep", number(*nearest)),
        Event::RayClipped { .. } => "The ray".to_owned(),
        Event::Advanced { step, .. } => match of {
            advanced::APART => format!("Step {step}: how far apart"),
            _ => format!("Step {step}: how far it is safe"),
        },
        Event::AxisSwept { .. } => "An axis that parts them".to_owned(),
        Event::ClosestApproachFound { .. } => "The closest approach".to_owned(),
        Event::ExpectationCompared { .. } => "What was expected".to_owned(),
        Event::MotionBounded { .. } => of_turn(of).to_owned(),
        Event::EdgesFaced { .. } => "The edges that face".to_owned(),
        Event::EdgeCut { .. } => "Cut off".to_owned(),
        Event::ContactFound { .. } => "A point of contact".to_owned(),
        Event::Finished { .. } => "The answer".to_owned(),
    }
}

/// What a step is called that ends with a part of a motion bound.
fn of_turn(of: usize) -> &'static str {
    match of {
        turned::FARTHEST => "The farthest vertex",
        turned::ARC => "Its arc",
        _ => "The bound",
    }
}

/// What a part of an event says in one sentence, of bodies that are called `names`.
#[must_use]
pub(crate) fn sentence_of_part(event: &Event, of: usize, names: &Names) -> String {
    match event {
        Event::BoundsFound { of: body, min, max, touching } => {
            let whose = body.map_or_else(|| names.all(), |side| names.quoted(side));
            bounds_part(&whose, of, [*min, *max], touching)
        }
        Event::Clamped { body, v, half_extents, clamped, closest, d, .. } => {
            let (own, other) = (names.quoted(*body), names.quoted(body.other()));
            match of {
                clamped::WAY => {
                    format!(
                        "V leads from the centre of {own} to that of {other}: {} in {own}'s frame.",
                        point(*v)
                    )
                }
                clamped::CUT => {
                    format!("The half-extents {} cut it down to {}.", point(*half_extents), point(*clamped))
                }
                _ => format!(
                    "That leads to {}, the point of {own} closest to {other}; from there D = {}.",
                    point(*closest),
                    point(*d)
                ),
            }
        }
        Event::MotionBounded { body, radius, theta, arc, vertices, .. } => {
            let own = names.quoted(*body);
            match of {
                turned::FARTHEST => {
                    format!(
                        "Farthest from the origin of {own}, by r = {}: {}.",
                        number(*radius),
                        first(vertices)
                    )
                }
                turned::ARC => format!("{own} turns by theta = {} rad.", number(*theta)),
                _ => format!("No point of {own} turns farther than L = theta r = {}.", number(*arc)),
            }
        }
        Event::Advanced { separation, normal, closing_speed, bound, next, .. } => match (of, next) {
            (advanced::APART, _) => {
                format!("They are {} apart along {}.", number(*separation), point(*normal))
            }
            (_, Some(next)) => {
                let turning = format!(", at most {} with the turning", number(*bound));
                let turning = if bound == closing_speed { "" } else { turning.as_str() };
                let (speed, next) = (number(*closing_speed), number(*next));
                format!("They close in at {speed}{turning}: nothing touches before t = {next}.")
            }
            (_, None) => "It stops here.".to_owned(),
        },
        _ => sentence(event, names),
    }
}

/// What the sides of a box are called: as a title, and in a sentence.
const SIDES: [(&str, &str); 4] =
    [("Leftmost", "leftmost"), ("Lowest", "lowest"), ("Rightmost", "rightmost"), ("Highest", "highest")];

/// A part of the search for the box of `whose`.
fn bounds_part(whose: &str, of: usize, [min, max]: [DVec2; 2], touching: &[Vec<SupportVertex>; 4]) -> String {
    match (SIDES.get(of), touching.get(of)) {
        (Some((_, word)), Some(vertices)) => format!("The {word} of {whose} is {}.", first(vertices)),
        _ if of == bounds::CENTER => format!(
            "Its centre is {}, its half-extents are {}.",
            point(0.5 * (min + max)),
            point(0.5 * (max - min))
        ),
        _ => format!("The box runs from {} to {}.", point(min), point(max)),
    }
}

/// The first of some vertices, and that there are more.
fn first(vertices: &[SupportVertex]) -> String {
    let Some(vertex) = vertices.first() else { return "no vertex".to_owned() };
    let tie = if vertices.len() > 1 { ", among others" } else { "" };
    format!("vertex {} at {}{tie}", vertex.index, point(vertex.point))
}
