//! What is told of bodies that move: rays, steps, swept axes, closest approaches, bounds on the
//! motion; and of what someone else answered.

use super::hand::Hand;
use super::phrases::moving::{
    AGREES, AT_TIME, BEGINS, BOUND, CLOSEST, CROSSED, ENDS, ENTERED, FACES_AWAY, INCOMPARABLE, MISSED,
    NORMAL_BY, OFF, OFF_BY, ON_TO, OUTCOME_BY, OVERLAP_STEP, PATH, PATHS, POINT_BY, RAY, RAY_AT,
    SEPARATION_BY, STEP, STOPS, SWEPT, THAN, TIME_BY, WITH_TURNING,
};
use super::words::Voice;
use crate::geometry::{DVec2, Feature, MOST_EPS, Side};
use crate::trace::{Culling, Moment, SupportVertex};

/// By how much of a unit answers differ that are the same but for rounding.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

pub(super) fn ray(
    voice: Voice,
    (side, feature): (Side, Feature),
    [from, to]: [DVec2; 2],
    outcome: Culling,
    time: Option<f64>,
) -> String {
    let came = match outcome {
        Culling::BackFacing => &FACES_AWAY,
        Culling::Missed => &MISSED,
        Culling::Hit => &ENTERED,
    };
    let at = if outcome == Culling::Missed { &CROSSED } else { &AT_TIME };
    let when = time.map_or_else(String::new, |t| voice.say(at, &[&voice.number(t)]));
    let (part, body) = (voice.part((side, feature)), voice.of(side));
    let (start, came) = (voice.point(from), voice.word(came));
    if from == to {
        return voice.say(&RAY_AT, &[&part, &body, &start, &came, &when]);
    }
    voice.say(&RAY, &[&part, &body, &start, &voice.point(to), &came, &when])
}

pub(super) fn advanced(
    voice: Voice,
    (step, at): (usize, &Moment),
    (separation, normal): (f64, DVec2),
    [closing, bound]: [f64; 2],
    next: Option<f64>,
) -> String {
    let on = next.map_or_else(|| voice.word(&STOPS), |t| voice.say(&ON_TO, &[&voice.number(t)]));
    let (apart, normal) = (voice.length(separation.abs()), voice.point(normal));
    if separation < 0.0 {
        return voice.say(&OVERLAP_STEP, &[&step.to_string(), &voice.moment(at), &apart, &normal, &on]);
    }
    let (speed, turning) = (voice.number(closing), with_turning(voice, [closing, bound]));
    let moment = voice.moment(at);
    voice.say(&STEP, &[&step.to_string(), &moment, &apart, &normal, &speed, &turning, &on])
}

/// The bound on how fast bodies come nearer; empty where they do not turn and no point is faster.
pub(super) fn with_turning(voice: Voice, [closing, bound]: [f64; 2]) -> String {
    if bound == closing { String::new() } else { voice.say(&WITH_TURNING, &[&voice.number(bound)]) }
}

pub(super) fn swept(voice: Voice, [from, to]: [f64; 2], owner: Side, normal: DVec2) -> String {
    let [from, to] = [from, to].map(|t| voice.number(t));
    voice.say(&SWEPT, &[&from, &to, &voice.point(normal), &voice.of(owner)])
}

pub(super) fn closest_approach(
    voice: Voice,
    at: &Moment,
    [separation, least]: [f64; 2],
    normal: DVec2,
) -> String {
    // At the ends of the motion nothing says that they do not come nearer before or after it.
    let ends = if at.time <= 0.0 {
        voice.word(&BEGINS)
    } else if at.time >= 1.0 {
        voice.word(&ENDS)
    } else {
        String::new()
    };
    let [reached, proved] = [separation, least].map(|x| voice.length(x));
    let than = if proved == reached { String::new() } else { voice.say(&THAN, &[&proved]) };
    let (moment, normal) = (voice.moment(at), voice.point(normal));
    voice.say(&CLOSEST, &[&voice.all(), &moment, &ends, &reached, &normal, &than])
}

/// How far someone else's answer is off: lengths in world units, and on a terminal in units of S ε.
pub(super) fn compared(
    voice: Voice,
    (size, outcome): (f64, Option<[&str; 2]>),
    [separation, time, normal]: [Option<f64>; 3],
    points: Option<[f64; 2]>,
) -> String {
    let (unit, is_full) = (size * f64::EPSILON, voice.hand == Hand::Terminal);
    let length = |x: f64| match voice.few(x) {
        told if is_full && unit > 0.0 && x.abs() <= MOST_EPS * unit => {
            format!("{told} ({} S eps)", voice.few(x / unit))
        }
        told => told,
    };
    let name = |side: Side| if is_full { voice.of(side) } else { voice.names.of(side).to_owned() };
    let point = |side: Side, x: f64| voice.say(&POINT_BY, &[&name(side), &length(x)]);
    let [a, b] = [points.map(|[a, _]| a), points.map(|[_, b]| b)];
    if outcome.is_none() && [separation, time, normal, a] == [None; 4] {
        return voice.word(&INCOMPARABLE);
    }
    // What another rounding of the same numbers gives is no news to who looks at a figure.
    let least = if is_full { 0.0 } else { ROUNDING };
    let told = |x: Option<f64>, unit: f64| x.filter(|x| x.abs() > least * unit);
    let words = |both: [&str; 2]| {
        let [theirs, ours] = both.map(|word| voice.outcome(word));
        voice.say(&OUTCOME_BY, &[theirs, ours])
    };
    let parts = [
        outcome.filter(|[theirs, ours]| theirs != ours).map(words),
        told(separation, size).map(|x| voice.say(&SEPARATION_BY, &[&length(x)])),
        told(time, 1.0).map(|x| voice.say(&TIME_BY, &[&voice.few(x)])),
        told(normal, 1.0).map(|x| voice.say(&NORMAL_BY, &[&voice.few(x)])),
        told(a, size).map(|x| point(Side::A, x)),
        told(b, size).map(|x| point(Side::B, x)),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    let all = parts.join(voice.tongue.between_phrases());
    match parts.is_empty() {
        true => voice.word(&AGREES),
        false if is_full => voice.say(&OFF, &[&voice.few(size), &all]),
        false => voice.say(&OFF_BY, &[&all]),
    }
}

pub(super) fn motion(
    voice: Voice,
    side: Side,
    farthest: &[SupportVertex],
    [radius, theta, arc, linear]: [f64; 4],
) -> String {
    let path = if voice.names.of(Side::B).is_empty() { &PATH } else { &PATHS };
    let path = voice.say(path, &[&voice.number(linear)]);
    let [radius, theta, arc] = [radius, theta, arc].map(|x| voice.number(x));
    voice.say(&BOUND, &[&voice.of(side), &theta, &radius, &voice.farthest(Some(side), farthest), &arc, &path])
}
