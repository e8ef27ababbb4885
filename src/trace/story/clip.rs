//! How an edge was clipped, in words.

use super::phrases::events::{CONTACT, CUT, FACED, NO_CONTACT, OVER};
use super::words::Voice;
use crate::geometry::{DVec2, Feature, Side};

/// The edges that face each other.
pub(super) fn faced(
    voice: Voice,
    body: Side,
    [reference, incident]: [Feature; 2],
    [from, to]: [DVec2; 2],
    normal: DVec2,
) -> String {
    let [reference, incident] = [(body, reference), (body.other(), incident)].map(|part| voice.part(part));
    let [from, to, normal] = [from, to, normal].map(|p| voice.point(p));
    let (own, other) = (voice.of(body), voice.of(body.other()));
    voice.say(&FACED, &[&reference, &own, &from, &to, &normal, &incident, &other])
}

/// What a plane cut off.
pub(super) fn cut(voice: Voice, plane: DVec2, end: DVec2, at: DVec2) -> String {
    voice.say(&CUT, &[&voice.point(plane), &voice.point(end), &voice.point(at)])
}

/// What became of an end.
pub(super) fn found(voice: Voice, [a, b]: [DVec2; 2], separation: f64, touches: bool) -> String {
    let places =
        voice.say(&OVER, &[&voice.point(a), &voice.of(Side::A), &voice.point(b), &voice.of(Side::B)]);
    if touches {
        voice.say(&CONTACT, &[&places, &voice.length(0.0_f64.max(-separation))])
    } else {
        voice.say(&NO_CONTACT, &[&places, &voice.length(separation)])
    }
}
