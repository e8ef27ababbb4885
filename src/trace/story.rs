//! A trace as a story: one sentence for each event, for people.
//!
//! Numbers are cut to six significant digits, points are `(x, y)`, bodies are A and B whatever the scene calls them. A
//! step of an advancement opens a paragraph.

use super::{Culling, Event, Goal, Moment, SupportVertex, Trace};
use crate::geometry::{DVec2, Enclosure, Feature, Side};

/// Significant digits of the numbers.
const DIGITS: usize = 6;

/// A coordinate smaller than this part of its point's other coordinate is what rounding left of a 0: told as 0. The
/// JSON lines have every bit.
const NOTHING: f64 = 1e-12;

/// The whole trace, a line for each event.
///
/// ```
/// use tracefig::trace::{Event, Trace, Tracer, story};
/// let mut trace = Trace::default();
/// trace.record(|| Event::Finished { outcome: "touching" });
/// assert_eq!(story(&trace), "Done: touching.\n");
/// ```
#[must_use]
pub fn story(trace: &Trace) -> String {
    let mut text = String::new();
    for (k, event) in trace.events.iter().enumerate() {
        if k > 0 && matches!(event, Event::Started { .. }) {
            text.push('\n');
        }
        text.push_str(&sentence(event));
        text.push('\n');
    }
    text
}

/// One event in one sentence.
///
/// ```
/// use tracefig::geometry::DVec2;
/// use tracefig::trace::{Event, sentence};
/// let event = Event::OriginProjected { foot: DVec2::new(1.2, -1.6), distance: -2.0 };
/// assert_eq!(sentence(&event), "The origin projects to (1.2, -1.6) there, 2 inside.");
/// ```
#[must_use]
pub fn sentence(event: &Event) -> String {
    // Every event is named here, so that a new one does not build without its sentence.
    let told = match event {
        Event::Started { .. }
        | Event::CirclesCompared { .. }
        | Event::PenetrationMeasured { .. }
        | Event::BoundsFound { .. }
        | Event::ExtentsCompared { .. }
        | Event::Clamped { .. }
        | Event::SupportFound { .. }
        | Event::DifferenceEdgeFound { .. }
        | Event::DifferenceRounded { .. }
        | Event::OriginProjected { .. }
        | Event::CandidateImproved { .. } => discrete(event),
        Event::AxisTested { .. }
        | Event::SeparatingAxisFound { .. }
        | Event::SimplexUpdated { .. }
        | Event::PolytopeExpanded { .. } => iterated(event),
        Event::RayClipped { .. }
        | Event::Advanced { .. }
        | Event::AxisSwept { .. }
        | Event::MotionBounded { .. }
        | Event::Finished { .. } => continuous(event),
    };
    told.unwrap_or_default()
}

/// Events of the algorithms that look at one moment.
#[expect(clippy::too_many_lines, reason = "one arm an event, read beside the vocabulary")]
fn discrete(event: &Event) -> Option<String> {
    Some(match event {
        Event::Started { algorithm, at } => format!("{algorithm} looks at A and B at {}.", moment(at)),
        Event::CirclesCompared { radii: [r, q], distance_squared, radii_squared, early_out, .. } => {
            let than = if distance_squared < radii_squared { "<" } else { ">=" };
            let then = if *early_out { "; that settles it, without a root" } else { "" };
            format!(
                "Centres and radii, squared: |A - B|^2 = {} {than} (r1 + r2)^2 = ({} + {})^2 = {}{then}.",
                number(*distance_squared),
                number(*r),
                number(*q),
                number(*radii_squared)
            )
        }
        Event::PenetrationMeasured { p, direction, vector } => format!(
            "p = |A - B| - (r1 + r2) = {}, N = {} from B to A, P = N p = {}.",
            number(*p),
            point(*direction),
            point(*vector)
        ),
        Event::BoundsFound { of, min, max, touching } => bounds(*of, *min, *max, touching),
        Event::ExtentsCompared { centers: [a, b], half_extents: [h, k], gap } => format!(
            "D = |c_B - c_A| - (h_A + h_B) = {} - ({} + {}) = {}.",
            point((*b - *a).abs()),
            point(*h),
            point(*k),
            point(*gap)
        ),
        Event::Clamped { body, v, half_extents, clamped, closest, d, radius } => format!(
            "In {}'s frame V = {}, clamped to {} by the half-extents {}; B_c = {}, D = {}, |D| - r = {}.",
            name(*body),
            point(*v),
            point(*clamped),
            point(*half_extents),
            point(*closest),
            point(*d),
            clamped_distance(*v, *clamped, *d, *radius)
        ),
        Event::SupportFound { body, direction, vertices } => {
            let tie = if vertices.len() > 1 { ", a tie" } else { "" };
            format!("Farthest along {} on {}: {}{tie}.", point(*direction), name(*body), list(vertices))
        }
        Event::DifferenceEdgeFound { source, edge, vertex, from, to, distance, .. } => format!(
            "Edge {edge} of {} with vertex {vertex} of {} is the edge {} to {} of B - A; the origin is {} its line.",
            name(*source),
            name(source.other()),
            point(*from),
            point(*to),
            aside(*distance)
        ),
        Event::DifferenceRounded { center: Some(c), radius } => {
            format!("B - A is a disc of radius {} around {}.", number(*radius), point(*c))
        }
        Event::DifferenceRounded { center: None, radius } => {
            format!("B - A is rounded by a radius of {}.", number(*radius))
        }
        Event::OriginProjected { foot, distance } => {
            format!("The origin projects to {} there, {}.", point(*foot), away(*distance))
        }
        Event::CandidateImproved { goal, distance, foot, source: (side, feature) } => format!(
            "{} so far: {} at {}, by {} of {}.",
            match goal {
                Goal::LeastPenetrating => "Least penetrating",
                Goal::LeastPositive => "Least positive",
            },
            number(*distance),
            point(*foot),
            part(*feature),
            name(*side)
        ),
        _ => return None,
    })
}

/// Events of the separating-axis test, of GJK and of EPA.
fn iterated(event: &Event) -> Option<String> {
    Some(match event {
        Event::AxisTested { axis, source: (side, feature), interval_a, interval_b, gap } => format!(
            "Along {}, the normal of {} of {}: A spans {}, B spans {}, {}.",
            point(*axis),
            part(*feature),
            name(*side),
            interval(*interval_a),
            interval(*interval_b),
            if *gap > 0.0 {
                format!("a gap of {}", number(*gap))
            } else {
                format!("overlap {}", number(-gap))
            }
        ),
        Event::SeparatingAxisFound { normal, gap } => {
            format!("{} separates them by {}: no need to look further.", point(*normal), number(*gap))
        }
        Event::SimplexUpdated { vertices, closest, direction } => format!(
            "The simplex is {}; closest to the origin is {}, so look along {}.",
            points(vertices),
            point(*closest),
            point(*direction)
        ),
        Event::PolytopeExpanded { vertices, nearest } => format!(
            "The polytope has {} vertices, {}; its nearest edge is {} from the origin.",
            vertices.len(),
            points(vertices),
            number(*nearest)
        ),
        _ => return None,
    })
}

/// Events of the algorithms that look at a motion, and the end.
fn continuous(event: &Event) -> Option<String> {
    Some(match event {
        Event::RayClipped { source: (side, feature), from, to, outcome, time } => format!(
            "The ray against {} of {}, {} to {}: {}{}.",
            part(*feature),
            name(*side),
            point(*from),
            point(*to),
            match outcome {
                Culling::BackFacing => "it faces away, skipped",
                Culling::Missed => "missed",
                Culling::Hit => "entered",
            },
            time.map_or_else(String::new, |t| format!(" at t = {}", number(t)))
        ),
        Event::Advanced { step, at, separation, normal, closing_speed, bound, next, .. } => format!(
            "Step {step}: at {} they are {} apart along {}, closing at {}, at most {} with the turning; {}.",
            moment(at),
            number(*separation),
            point(*normal),
            number(*closing_speed),
            number(*bound),
            next.map_or_else(|| "it stops here".to_owned(), |t| format!("on to t = {}", number(t)))
        ),
        Event::AxisSwept { from, to, owner, normal } => format!(
            "From t = {} to {} they stay apart along {}, which turns with {}.",
            number(*from),
            number(*to),
            point(*normal),
            name(*owner)
        ),
        Event::MotionBounded { body, radius, theta, arc, linear, vertices } => format!(
            "{} turns by {} rad; its farthest point is {} from its origin ({}), so L = {}; its path adds {}.",
            name(*body),
            number(*theta),
            number(*radius),
            list(vertices),
            number(*arc),
            number(*linear)
        ),
        Event::Finished { outcome } => format!("Done: {outcome}."),
        _ => return None,
    })
}

/// The sentence of a bounding box.
fn bounds(of: Option<Side>, min: DVec2, max: DVec2, touching: &[Vec<SupportVertex>; 4]) -> String {
    let whose = of.map_or("A and B together", name);
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

/// ‖D‖ − r, or where the centre is inside the box −‖D‖ − r.
fn clamped_distance(v: DVec2, clamped: DVec2, d: DVec2, radius: f64) -> String {
    let length = libm::hypot(d.x, d.y);
    number(if v == clamped { -length - radius } else { length - radius })
}

/// A moment, with the angles where a body is turned.
fn moment(at: &Moment) -> String {
    let time = format!("t = {}", number(at.time));
    if at.angle_a == 0.0 && at.angle_b == 0.0 {
        return time;
    }
    format!("{time} (A at {} deg, B at {} deg)", number(at.angle_a), number(at.angle_b))
}

/// "vertex 0 at (1, 2) and vertex 1 at (3, 4)".
fn list(vertices: &[SupportVertex]) -> String {
    let one = |v: &SupportVertex| format!("vertex {} at {}", v.index, point(v.point));
    vertices.iter().map(one).collect::<Vec<_>>().join(" and ")
}

/// Points, listed.
fn points(vertices: &[DVec2]) -> String {
    vertices.iter().map(|&p| point(p)).collect::<Vec<_>>().join(" ")
}

/// "2 inside" or "2 away".
fn away(distance: f64) -> String {
    let size = number(distance.abs());
    if distance < 0.0 { format!("{size} inside") } else { format!("{size} away") }
}

/// "2 inside" or "2 outside" of a line.
fn aside(distance: f64) -> String {
    let size = number(distance.abs());
    if distance < 0.0 { format!("{size} inside") } else { format!("{size} outside") }
}

fn interval(x: Enclosure) -> String {
    format!("{} to {}", number(x.lo), number(x.hi))
}

fn name(side: Side) -> &'static str {
    match side {
        Side::A => "A",
        Side::B => "B",
    }
}

fn part(feature: Feature) -> String {
    match feature {
        Feature::Vertex(i) => format!("vertex {i}"),
        Feature::Edge(i) => format!("edge {i}"),
    }
}

fn point(p: DVec2) -> String {
    let size = p.abs().max_element();
    let shown = |x: f64| number(if x.abs() < NOTHING * size { 0.0 } else { x });
    format!("({}, {})", shown(p.x), shown(p.y))
}

/// A number to [`DIGITS`] significant digits, without trailing zeros; with an exponent where it is very large or small.
fn number(x: f64) -> String {
    let written = format!("{:.*e}", DIGITS - 1, x);
    let Ok(rounded) = written.parse::<f64>() else { return written };
    if rounded == 0.0 {
        return "0".to_owned();
    }
    if (1e-4..1e7).contains(&rounded.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_six_digits_and_no_zeros() {
        let cases = [
            (1.0 / 3.0, "0.333333"),
            (-0.0, "0"),
            (2.5, "2.5"),
            (1e-9, "1e-9"),
            (123_456_789.0, "1.23457e8"),
        ];
        for (x, expected) in cases {
            assert_eq!(number(x), expected);
        }
    }

    #[test]
    fn what_rounding_left_of_a_zero_is_told_as_zero() {
        assert_eq!(point(DVec2::new(4.4e-16, 5.0)), "(0, 5)");
        assert_eq!(point(DVec2::new(4e-16, 5e-16)), "(4e-16, 5e-16)");
    }

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
        assert_eq!(sentence(&event), expected);
    }
}
