//! How an edge was clipped, in words.

use super::words::{number, part, point};
use crate::geometry::{DVec2, Feature, Names, Side};

/// The edges that face each other.
pub(super) fn faced(
    names: &Names,
    body: Side,
    [reference, incident]: [Feature; 2],
    [from, to]: [DVec2; 2],
    normal: DVec2,
) -> String {
    format!(
        "Reference: {} of {}, {} to {}, outward {}; {} of {} faces it.",
        part(reference),
        names.quoted(body),
        point(from),
        point(to),
        point(normal),
        part(incident),
        names.quoted(body.other())
    )
}

/// What a plane cut off.
pub(super) fn cut(plane: DVec2, end: DVec2, at: DVec2) -> String {
    format!("The plane at {} cuts off the end {}: it ends at {}.", point(plane), point(end), point(at))
}

/// What became of an end.
pub(super) fn found(names: &Names, [a, b]: [DVec2; 2], separation: f64, touches: bool) -> String {
    let places =
        format!("{} of {} over {} of {}", point(a), names.quoted(Side::A), point(b), names.quoted(Side::B));
    if touches {
        format!("Contact: {places}, {} deep.", number(0.0_f64.max(-separation)))
    } else {
        format!("No contact: {places}, {} apart.", number(separation))
    }
}
