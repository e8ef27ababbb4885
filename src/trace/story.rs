//! A trace as a story: one sentence for each event, for people.
//!
//! Numbers are cut to six significant digits, points are `(x, y)`, bodies are A and B whatever the scene
//! calls them. A step of an advancement opens a paragraph.

use super::{Culling, Event, Goal, Moment, SupportVertex, Trace};
use crate::geometry::{DVec2, Enclosure, Feature, Side};

/// Significant digits of the numbers: a reader compares the first three, and a step of 1e-6 still shows.
const DIGITS: usize = 6;

/// The share of a point's larger coordinate below which the other one is what rounding left of a 0, and told
/// as 0: a thousand times what a few roundings leave. The JSON lines have every bit.
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
    // Every event has its own arm, so that a new one does not build without its sentence.
    match event {
        Event::Started { algorithm, at } => format!("{algorithm} looks at A and B at {}.", moment(at)),
        Event::CirclesCompared { radii, distance_squared, radii_squared, early_out, .. } => {
            circles(*radii, *distance_squared, *radii_squared, *early_out)
        }
        Event::PenetrationMeasured { p, direction, vector } => penetration(*p, *direction, *vector),
        Event::BoundsFound { of, min, max, touching } => bounds(*of, *min, *max, touching),
        Event::ExtentsCompared { centers, half_extents, gap } => extents(*centers, *half_extents, *gap),
        Event::Clamped { body, v, half_extents, clamped, closest, d, radius } => {
            let left = clamped_distance(*v, *clamped, *d, *radius);
            in_box(*body, [*v, *clamped, *half_extents], *closest, *d, &left)
        }
        Event::SupportFound { body, direction, vertices } => support(*body, *direction, vertices),
        Event::DifferenceEdgeFound { source, edge, vertex, from, to, distance, .. } => {
            difference_edge(*source, [*edge, *vertex], [*from, *to], *distance)
        }
        Event::DifferenceRounded { center, radius } => rounded(*center, *radius),
        Event::OriginProjected { foot, distance } => {
            format!("The origin projects to {} there, {}.", point(*foot), away(*distance))
        }
        Event::CandidateImproved { goal, distance, foot, source } => {
            candidate(*goal, *distance, *foot, *source)
        }
        Event::AxisTested { axis, source, interval_a, interval_b, gap } => {
            axis_tested(*axis, *source, [*interval_a, *interval_b], *gap)
        }
        Event::SeparatingAxisFound { normal, gap } => {
            format!("{} separates them by {}: no need to look further.", point(*normal), number(*gap))
        }
        Event::SimplexUpdated { vertices, closest, direction } => simplex(vertices, *closest, *direction),
        Event::PolytopeExpanded { vertices, nearest } => polytope(vertices, *nearest),
        Event::RayClipped { source, from, to, outcome, time } => ray(*source, [*from, *to], *outcome, *time),
        Event::Advanced { step, at, separation, normal, closing_speed, bound, next, .. } => {
            let apart = format!("{} apart along {}", number(*separation), point(*normal));
            advanced(*step, at, &apart, [*closing_speed, *bound], *next)
        }
        Event::AxisSwept { from, to, owner, normal } => swept([*from, *to], *owner, *normal),
        Event::MotionBounded { body, radius, theta, arc, linear, vertices } => {
            motion(*body, vertices, [*radius, *theta, *arc, *linear])
        }
        Event::Finished { outcome } => format!("Done: {outcome}."),
    }
}

/// The early-out of two circles: squares of distance and radii.
fn circles([r, q]: [f64; 2], distance_squared: f64, radii_squared: f64, early_out: bool) -> String {
    let than = if distance_squared < radii_squared { "<" } else { ">=" };
    let then = if early_out { "; that settles it, without a root" } else { "" };
    format!(
        "Centres and radii, squared: |A - B|^2 = {} {than} (r1 + r2)^2 = ({} + {})^2 = {}{then}.",
        number(distance_squared),
        number(r),
        number(q),
        number(radii_squared)
    )
}

fn penetration(p: f64, direction: DVec2, vector: DVec2) -> String {
    format!(
        "p = |A - B| - (r1 + r2) = {}, N = {} from B to A, P = N p = {}.",
        number(p),
        point(direction),
        point(vector)
    )
}

fn extents([a, b]: [DVec2; 2], [h, k]: [DVec2; 2], gap: DVec2) -> String {
    format!(
        "D = |c_B - c_A| - (h_A + h_B) = {} - ({} + {}) = {}.",
        point((b - a).abs()),
        point(h),
        point(k),
        point(gap)
    )
}

/// A circle's centre in the frame of a box: V, V clamped, the half-extents; then the world again.
fn in_box(body: Side, [v, clamped, h]: [DVec2; 3], closest: DVec2, d: DVec2, left: &str) -> String {
    format!(
        "In {}'s frame V = {}, clamped to {} by the half-extents {}; B_c = {}, D = {}, |D| - r = {left}.",
        name(body),
        point(v),
        point(clamped),
        point(h),
        point(closest),
        point(d)
    )
}

fn support(body: Side, direction: DVec2, vertices: &[SupportVertex]) -> String {
    let tie = if vertices.len() > 1 { ", a tie" } else { "" };
    format!("Farthest along {} on {}: {}{tie}.", point(direction), name(body), list(vertices))
}

fn difference_edge(
    source: Side,
    [edge, vertex]: [usize; 2],
    [from, to]: [DVec2; 2],
    distance: f64,
) -> String {
    format!(
        "Edge {edge} of {} with vertex {vertex} of {} is the edge {} to {} of B - A; \
         the origin is {} its line.",
        name(source),
        name(source.other()),
        point(from),
        point(to),
        aside(distance)
    )
}

fn rounded(center: Option<DVec2>, radius: f64) -> String {
    match center {
        Some(center) => format!("B - A is a disc of radius {} around {}.", number(radius), point(center)),
        None => format!("B - A is rounded by a radius of {}.", number(radius)),
    }
}

fn candidate(goal: Goal, distance: f64, foot: DVec2, (side, feature): (Side, Feature)) -> String {
    let best = match goal {
        Goal::LeastPenetrating => "Least penetrating",
        Goal::LeastPositive => "Least positive",
    };
    let (distance, foot) = (number(distance), point(foot));
    format!("{best} so far: {distance} at {foot}, by {} of {}.", part(feature), name(side))
}

fn axis_tested(axis: DVec2, (side, feature): (Side, Feature), [a, b]: [Enclosure; 2], gap: f64) -> String {
    let (a, b) = (interval(a), interval(b));
    let between = if gap > 0.0 {
        format!("a gap of {}", number(gap))
    } else {
        format!("where B begins {} before A ends", number(-gap))
    };
    format!(
        "Along {}, the normal of {} of {}: A spans {a}, B spans {b}, {between}.",
        point(axis),
        part(feature),
        name(side)
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

fn polytope(vertices: &[DVec2], nearest: f64) -> String {
    format!(
        "The polytope has {} vertices, {}; its nearest edge is {} from the origin.",
        vertices.len(),
        points(vertices),
        number(nearest)
    )
}

fn ray(
    (side, feature): (Side, Feature),
    [from, to]: [DVec2; 2],
    outcome: Culling,
    time: Option<f64>,
) -> String {
    let came = match outcome {
        Culling::BackFacing => "it faces away, skipped",
        Culling::Missed => "missed",
        Culling::Hit => "entered",
    };
    let when = time.map_or_else(String::new, |t| format!(" at t = {}", number(t)));
    let what = format!("{} of {}, {} to {}", part(feature), name(side), point(from), point(to));
    format!("The ray against {what}: {came}{when}.")
}

fn advanced(step: usize, at: &Moment, apart: &str, [closing, bound]: [f64; 2], next: Option<f64>) -> String {
    let on = next.map_or_else(|| "it stops here".to_owned(), |t| format!("on to t = {}", number(t)));
    format!(
        "Step {step}: at {} they are {apart}, closing at {}, at most {} with the turning; {on}.",
        moment(at),
        number(closing),
        number(bound)
    )
}

fn swept([from, to]: [f64; 2], owner: Side, normal: DVec2) -> String {
    format!(
        "From t = {} to {} they stay apart along {}, which turns with {}.",
        number(from),
        number(to),
        point(normal),
        name(owner)
    )
}

fn motion(body: Side, farthest: &[SupportVertex], [radius, theta, arc, linear]: [f64; 4]) -> String {
    format!(
        "{} turns by {} rad; its farthest point is {} from its origin ({}), so L = {}; its path adds {}.",
        name(body),
        number(theta),
        number(radius),
        list(farthest),
        number(arc),
        number(linear)
    )
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

/// The distance of circle and box: ‖D‖ − r, or where the centre is inside the box −‖D‖ − r.
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

/// Vertices in words: "vertex 0 at (1, 2) and vertex 1 at (3, 4)".
fn list(vertices: &[SupportVertex]) -> String {
    let one = |v: &SupportVertex| format!("vertex {} at {}", v.index, point(v.point));
    vertices.iter().map(one).collect::<Vec<_>>().join(" and ")
}

/// Points, one after the other.
fn points(vertices: &[DVec2]) -> String {
    vertices.iter().map(|&p| point(p)).collect::<Vec<_>>().join(" ")
}

/// A distance from the boundary in words: "2 inside" or "2 away".
fn away(distance: f64) -> String {
    let size = number(distance.abs());
    if distance < 0.0 { format!("{size} inside") } else { format!("{size} away") }
}

/// A distance from a line in words: "2 inside" or "2 outside".
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

/// A number to [`DIGITS`] significant digits, without trailing zeros; with an exponent where it is very large
/// or small.
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
