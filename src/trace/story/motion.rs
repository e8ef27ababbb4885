//! What is told of bodies that move: rays, steps, swept axes, closest approaches, bounds on the
//! motion; and of what someone else answered.

use super::words::{list, number, part, point};
use crate::geometry::{DVec2, Feature, Names, Side};
use crate::trace::{Culling, SupportVertex};

pub(super) fn ray(
    names: &Names,
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
    let what = format!("{} of {}, {} to {}", part(feature), names.quoted(side), point(from), point(to));
    format!("The ray against {what}: {came}{when}.")
}

pub(super) fn advanced(
    step: usize,
    at: &str,
    apart: &str,
    [closing, bound]: [f64; 2],
    next: Option<f64>,
) -> String {
    let on = next.map_or_else(|| "it stops here".to_owned(), |t| format!("on to t = {}", number(t)));
    // Of bodies that do not turn no point is faster.
    let turning = format!(", at most {} with the turning", number(bound));
    let turning = if bound == closing { "" } else { turning.as_str() };
    format!("Step {step}: at {at} they are {apart}, closing at {}{turning}; {on}.", number(closing))
}

pub(super) fn swept([from, to]: [f64; 2], owner: &str, normal: DVec2) -> String {
    format!(
        "From t = {} to {} they stay apart along {}, a direction in the frame of {owner}.",
        number(from),
        number(to),
        point(normal)
    )
}

pub(super) fn closest_approach(
    names: &Names,
    (time, when): (f64, &str),
    apart: &str,
    [separation, least]: [f64; 2],
) -> String {
    // At the ends of the motion nothing says that they do not come nearer before or after it.
    let ends = if time <= 0.0 {
        ", where the motion begins"
    } else if time >= 1.0 {
        ", where the motion ends"
    } else {
        ""
    };
    let (reached, proved) = (number(separation), number(least));
    let than = if proved == reached { String::new() } else { format!(" than {proved}") };
    format!("{} come closest at {when}{ends}: {apart}, and never less{than}.", names.all())
}

/// How far someone else's answer is off: lengths in world units and in units of S ε.
pub(super) fn compared(
    names: &Names,
    size: f64,
    [separation, time, normal]: [Option<f64>; 3],
    points: Option<[f64; 2]>,
) -> String {
    let unit = size * f64::EPSILON;
    let length = |x: f64| match number(x) {
        told if unit > 0.0 => format!("{told} ({} S eps)", number(x / unit)),
        told => told,
    };
    let point = |side: Side, x: f64| format!("the point on {} by {}", names.quoted(side), length(x));
    let parts = [
        separation.map(|x| format!("the separation by {}", length(x))),
        time.map(|x| format!("the time by {}", number(x))),
        normal.map(|x| format!("the normal by {} deg", number(x))),
        points.map(|[a, _]| point(Side::A, a)),
        points.map(|[_, b]| point(Side::B, b)),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    if parts.is_empty() {
        return "Nothing of what was expected can be held against this answer.".to_owned();
    }
    format!("What was expected is off, with S = {}: {}.", number(size), parts.join(", "))
}

pub(super) fn motion(
    names: &Names,
    side: Side,
    farthest: &[SupportVertex],
    [radius, theta, arc, linear]: [f64; 4],
) -> String {
    let path = if names.of(Side::B).is_empty() {
        format!("its path adds {}", number(linear))
    } else {
        format!("the way that the two pass each other adds {}, once", number(linear))
    };
    format!(
        "{} turns by {} rad; its farthest point is {} from its origin ({}), so L = {}; {path}.",
        names.quoted(side),
        number(theta),
        number(radius),
        list(farthest),
        number(arc),
    )
}
