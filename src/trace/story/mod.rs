//! A trace as a story: one sentence for each event, for people.
//!
//! Numbers are cut to six significant digits, points are `(x, y)`, bodies have the names that the scene gives
//! them. A step of an advancement opens a paragraph.

mod clip;
pub(crate) mod growth;
mod motion;
pub(crate) mod step;
pub(crate) mod told;
mod words;

use super::{Event, Goal, Moment, SupportVertex, Trace};
use crate::geometry::{DVec2, Enclosure, Feature, Names, Side};

use motion::{advanced, closest_approach, compared, motion, ray, swept};
use words::{aside, away, interval, list, moment, number, part, point, points};

/// The whole trace, a line for each event, of bodies that are called `names`; of an algorithm by components
/// without the edges of B ⊖ A, at which it does not look.
///
/// ```
/// use tracefig::geometry::Names;
/// use tracefig::trace::{Event, Trace, Tracer, story};
/// let mut trace = Trace::default();
/// trace.record(|| Event::Finished { outcome: "touching" });
/// assert_eq!(story(&trace, &Names::default()), "Done: touching.\n");
/// ```
#[must_use]
pub fn story(trace: &Trace, names: &Names) -> String {
    let mut text = String::new();
    for (k, event) in told::told(trace).enumerate() {
        if k > 0 && matches!(event, Event::Started { .. }) {
            text.push('\n');
        }
        text.push_str(&sentence(event, names));
        text.push('\n');
    }
    text
}

/// One event in one sentence, of bodies that are called `names`.
///
/// ```
/// use tracefig::geometry::{DVec2, Names};
/// use tracefig::trace::{Event, sentence};
/// let event = Event::DifferenceRounded { center: Some(DVec2::new(3.0, 4.0)), radius: 2.0 };
/// let names = Names::new("bullet", Some("wall"));
/// assert_eq!(sentence(&event, &names), "wall - bullet is a disc of radius 2 around (3, 4).");
/// ```
#[must_use]
#[expect(clippy::too_many_lines, reason = "one arm an event, and nothing else")]
pub fn sentence(event: &Event, names: &Names) -> String {
    // Every event has its own arm, so that a new one does not build without its sentence.
    match event {
        Event::Started { algorithm, at } => {
            format!("{algorithm} looks at {} at {}.", names.all(), moment(at, names))
        }
        Event::CirclesCompared { radii, distance_squared, radii_squared, early_out, .. } => {
            circles(names, *radii, [*distance_squared, *radii_squared], *early_out)
        }
        Event::PenetrationMeasured { p, direction, vector } => penetration(names, *p, *direction, *vector),
        Event::BoundsFound { of, min, max, touching } => bounds(names, *of, [*min, *max], touching),
        Event::ExtentsCompared { centers, half_extents, gap } => {
            extents(names, *centers, *half_extents, *gap)
        }
        Event::Clamped { body, v, half_extents, clamped, closest, d, radius } => {
            let left = clamped_distance(*v, *clamped, *d, *radius);
            in_box(names, *body, [*v, *clamped, *half_extents], [*closest, *d], &left)
        }
        Event::SupportFound { body, direction, vertices } => {
            support(&names.quoted(*body), *direction, vertices)
        }
        Event::DifferenceEdgeFound { source, edge, vertex, from, to, distance, .. } => {
            difference_edge(names, *source, [*edge, *vertex], [*from, *to], *distance)
        }
        Event::EdgesMerged { taken, edge, other, .. } => merged(names, *taken, *edge, *other),
        Event::DifferenceRounded { center, radius } => rounded(names, *center, *radius),
        Event::OriginProjected { foot, distance } => {
            format!("The origin projects to {} there, {}.", point(*foot), away(*distance))
        }
        Event::CandidateImproved { goal, distance, foot, source } => {
            candidate(names, *goal, *distance, *foot, *source)
        }
        Event::AxisTested { axis, source, interval_a, interval_b, gap } => {
            axis_tested(names, *axis, *source, [*interval_a, *interval_b], *gap)
        }
        Event::SeparatingAxisFound { normal, gap } => {
            format!("{} separates them by {}: no need to look further.", point(*normal), number(*gap))
        }
        Event::SimplexUpdated { vertices, closest, direction } => simplex(vertices, *closest, *direction),
        Event::PolytopeExpanded { vertices, nearest, normal, support, beyond, .. } => {
            polytope(vertices, *nearest, [*normal, *support], *beyond)
        }
        Event::RayClipped { source, from, to, outcome, time } => {
            ray(names, *source, [*from, *to], *outcome, *time)
        }
        Event::Advanced { step, at, separation, normal, closing_speed, bound, next, .. } => {
            let apart = format!("{} apart along {}", number(*separation), point(*normal));
            advanced(*step, &moment(at, names), &apart, [*closing_speed, *bound], *next)
        }
        Event::AxisSwept { from, to, owner, normal } => swept([*from, *to], &names.quoted(*owner), *normal),
        Event::ClosestApproachFound { at, separation, bounds, normal, .. } => {
            let apart = format!("{} apart along {}", number(*separation), point(*normal));
            closest_approach(names, (at.time, &moment(at, names)), &apart, [*separation, bounds.lo])
        }
        Event::ExpectationCompared { size, separation, time, normal_deg, points } => {
            compared(names, *size, [*separation, *time, *normal_deg], *points)
        }
        Event::MotionBounded { body, radius, theta, arc, linear, vertices } => {
            motion(names, *body, vertices, [*radius, *theta, *arc, *linear])
        }
        Event::EdgesFaced { body, reference, incident, from, to, normal, .. } => {
            clip::faced(names, *body, [*reference, *incident], [*from, *to], *normal)
        }
        Event::EdgeCut { plane, end, at } => clip::cut(*plane, *end, *at),
        Event::ContactFound { points, separation, touches, .. } => {
            clip::found(names, *points, *separation, *touches)
        }
        Event::Finished { outcome } => format!("Done: {outcome}."),
    }
}

/// The early-out of two circles: squares of distance and radii.
fn circles(
    names: &Names,
    [r, q]: [f64; 2],
    [distance_squared, radii_squared]: [f64; 2],
    early_out: bool,
) -> String {
    let than = if distance_squared < radii_squared { "<" } else { ">=" };
    let then = if early_out { "; that settles it, without a root" } else { "" };
    format!(
        "Centres and radii, squared: {}^2 = {} {than} (r1 + r2)^2 = ({} + {})^2 = {}{then}.",
        centers_apart(names),
        number(distance_squared),
        number(r),
        number(q),
        number(radii_squared)
    )
}

/// The distance of two circles' centres, as the article writes it.
fn centers_apart(names: &Names) -> String {
    format!("|{} - {}|", names.quoted(Side::A), names.quoted(Side::B))
}

fn penetration(names: &Names, p: f64, direction: DVec2, vector: DVec2) -> String {
    format!(
        "p = {} - (r1 + r2) = {}, N = {} from {} to {}, P = N p = {}.",
        centers_apart(names),
        number(p),
        point(direction),
        names.quoted(Side::B),
        names.quoted(Side::A),
        point(vector)
    )
}

fn extents(names: &Names, [a, b]: [DVec2; 2], [h, k]: [DVec2; 2], gap: DVec2) -> String {
    let (first, second) = (names.quoted(Side::A), names.quoted(Side::B));
    format!(
        "D = |c_{second} - c_{first}| - (h_{first} + h_{second}) = {} - ({} + {}) = {}.",
        point((b - a).abs()),
        point(h),
        point(k),
        point(gap)
    )
}

/// A circle's centre in the frame of a box: V, V clamped, the half-extents; then the world again.
fn in_box(
    names: &Names,
    body: Side,
    [v, clamped, h]: [DVec2; 3],
    [closest, d]: [DVec2; 2],
    left: &str,
) -> String {
    format!(
        "In {}'s frame V = {}, clamped to {} by the half-extents {}; {}_c = {}, D = {}, |D| - r = {left}.",
        names.quoted(body),
        point(v),
        point(clamped),
        point(h),
        names.quoted(body.other()),
        point(closest),
        point(d)
    )
}

fn support(body: &str, direction: DVec2, vertices: &[SupportVertex]) -> String {
    let tie = if vertices.len() > 1 { ", a tie" } else { "" };
    format!("Farthest along {} on {body}: {}{tie}.", point(direction), list(vertices))
}

fn difference_edge(
    names: &Names,
    source: Side,
    [edge, vertex]: [usize; 2],
    [from, to]: [DVec2; 2],
    distance: f64,
) -> String {
    format!(
        "Edge {edge} of {} with vertex {vertex} of {} is the edge {} to {} of {}; \
         the origin is {} its line.",
        names.quoted(source),
        names.quoted(source.other()),
        point(from),
        point(to),
        difference(names),
        aside(distance)
    )
}

/// The choice between the next edges of both bodies.
fn merged(names: &Names, taken: Side, edge: DVec2, other: Option<DVec2>) -> String {
    let (own, others) = (names.quoted(taken), names.quoted(taken.other()));
    let than = other.map_or_else(
        || format!("{others} has no more"),
        |other| format!("{others}'s next, {}, turns more", point(other)),
    );
    format!("Next the edge {} of {own}: {than}.", point(edge))
}

/// The Minkowski difference in plain text, as "B - A".
pub(crate) fn difference(names: &Names) -> String {
    format!("{} - {}", names.quoted(Side::B), names.quoted(Side::A))
}

fn rounded(names: &Names, center: Option<DVec2>, radius: f64) -> String {
    let (what, radius) = (difference(names), number(radius));
    match center {
        Some(center) => format!("{what} is a disc of radius {radius} around {}.", point(center)),
        None => format!("{what} is rounded by a radius of {radius}."),
    }
}

fn candidate(
    names: &Names,
    goal: Goal,
    distance: f64,
    foot: DVec2,
    (side, feature): (Side, Feature),
) -> String {
    let best = match goal {
        Goal::LeastPenetrating => "Least penetrating",
        Goal::LeastPositive => "Least positive",
    };
    let (distance, foot) = (number(distance), point(foot));
    format!("{best} so far: {distance} at {foot}, by {} of {}.", part(feature), names.quoted(side))
}

fn axis_tested(
    names: &Names,
    axis: DVec2,
    (side, feature): (Side, Feature),
    [a, b]: [Enclosure; 2],
    gap: f64,
) -> String {
    let (a, b) = (interval(a), interval(b));
    let between = if gap > 0.0 {
        format!("a gap of {}", number(gap))
    } else {
        let (first, second) = (names.quoted(Side::A), names.quoted(Side::B));
        format!("where {second} begins {} before {first} ends", number(-gap))
    };
    format!(
        "Along {}, the normal of {} of {}: {} spans {a}, {} spans {b}, {between}.",
        point(axis),
        part(feature),
        names.quoted(side),
        names.quoted(Side::A),
        names.quoted(Side::B)
    )
}

fn simplex(vertices: &[DVec2], closest: DVec2, direction: DVec2) -> String {
    format!(
        "The simplex is {}; closest to the origin is {}, so look along {}.",
        points(vertices),
        point(closest),
        point(direction)
    )
}

/// A step of EPA: the polytope, its nearest edge, and the vertex beyond that.
fn polytope(vertices: &[DVec2], nearest: f64, [normal, support]: [DVec2; 2], beyond: f64) -> String {
    let then = if beyond > 0.0 {
        format!("farthest there is {}, {} beyond it: it splits the edge", point(support), number(beyond))
    } else {
        "no vertex is beyond it: it is the way out".to_owned()
    };
    format!(
        "The polytope has {} vertices, {}; its nearest edge is {} from the origin along {}; {then}.",
        vertices.len(),
        points(vertices),
        number(nearest),
        point(normal)
    )
}

/// The sentence of a bounding box.
fn bounds(
    names: &Names,
    of: Option<Side>,
    [min, max]: [DVec2; 2],
    touching: &[Vec<SupportVertex>; 4],
) -> String {
    let whose = of.map_or_else(|| format!("{} together", names.all()), |side| names.quoted(side));
    let mut text = format!("The box of {whose} runs from {} to {}", point(min), point(max));
    for (side, vertices) in ["left", "bottom", "right", "top"].into_iter().zip(touching) {
        if !vertices.is_empty() {
            text.push_str("; ");
            text.push_str(side);
            text.push_str(": ");
            text.push_str(&list(vertices));
        }
    }
    text.push('.');
    text
}

/// The distance of circle and box: ‖D‖ − r, or where the centre is inside the box −‖D‖ − r.
fn clamped_distance(v: DVec2, clamped: DVec2, d: DVec2, radius: f64) -> String {
    let length = libm::hypot(d.x, d.y);
    number(if v == clamped { -length - radius } else { length - radius })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tie_is_told_with_both_vertices() {
        let at = |index, x, y| SupportVertex { index, point: DVec2::new(x, y) };
        let event = Event::SupportFound {
            body: Side::B,
            direction: DVec2::new(0.6, -0.8),
            vertices: vec![at(0, 0.3, -0.4), at(1, 3.5, 2.0)],
        };
        let expected =
            "Farthest along (0.6, -0.8) on B: vertex 0 at (0.3, -0.4) and vertex 1 at (3.5, 2), a tie.";
        assert_eq!(sentence(&event, &Names::default()), expected);
    }

    #[test]
    fn bodies_have_the_names_of_the_scene_in_words_and_in_formulas() {
        let names = Names::new("bullet", Some("the wall"));
        let at = Moment { time: 0.5, angle_a: 0.0, angle_b: 90.0 };
        let compared = Event::ExtentsCompared {
            centers: [DVec2::ZERO, DVec2::splat(3.0)],
            half_extents: [DVec2::ONE; 2],
            gap: DVec2::ONE,
        };
        let overlapping = Event::AxisTested {
            axis: DVec2::X,
            source: (Side::B, Feature::Edge(3)),
            interval_a: Enclosure { lo: 0.0, hi: 2.0 },
            interval_b: Enclosure { lo: 1.5, hi: 4.0 },
            gap: -0.5,
        };
        let told = [
            (
                overlapping,
                "Along (1, 0), the normal of edge 3 of \"the wall\": bullet spans 0 to 2, \"the wall\" spans \
                 1.5 to 4, where \"the wall\" begins 0.5 before bullet ends.",
            ),
            (
                Event::Started { algorithm: "any", at },
                "any looks at bullet and \"the wall\" at t = 0.5 \
                 (bullet at 0 deg, \"the wall\" at 90 deg).",
            ),
            (
                compared,
                "D = |c_\"the wall\" - c_bullet| - (h_bullet + h_\"the wall\") \
                 = (3, 3) - ((1, 1) + (1, 1)) = (1, 1).",
            ),
        ];
        for (event, expected) in told {
            assert_eq!(sentence(&event, &names), expected);
        }
    }

    #[test]
    fn a_query_about_one_body_does_not_speak_of_another() {
        let at = Moment { time: 0.0, angle_a: 30.0, angle_b: 0.0 };
        let event = Event::Started { algorithm: "any", at };
        let told = sentence(&event, &Names::new("crate_1", None));
        assert_eq!(told, "any looks at crate_1 at t = 0 (crate_1 at 30 deg).");
    }
}
