//! A trace as a story: one sentence for each event, for people.
//!
//! Numbers are cut to six significant digits, places to thousandths where those are more, points are
//! `(x, y)`, bodies have the names that the scene gives them. A step of an advancement opens a paragraph.

mod clip;
#[cfg(test)]
mod every_event;
pub(crate) mod growth;
mod hand;
mod motion;
mod phrases;
mod place;
pub(crate) mod so_far;
pub(crate) mod step;
pub(crate) mod taken;
#[cfg(test)]
mod tests;
pub(crate) mod told;
mod words;

use std::cmp::Ordering;

use super::tongue::Phrase;
use super::{Event, Goal, SupportVertex, Trace};
use crate::geometry::{DVec2, Enclosure, Feature, Names, Side};

pub(crate) use hand::{Hand, TOLD, USUAL, WHOLE};
use motion::{advanced, closest_approach, compared, motion, ray, swept};
use phrases::events::{
    AXIS, AXIS_FROM, AXIS_INTO, BEHIND, BOTTOM, BOX, CLAMPED, CLAMPED_INSIDE, DIFFERENCE_EDGE,
    DIFFERENCE_EDGE_OF_CENTER, DISC, FINISHED, GAP, LEAST_PENETRATING, LEAST_POSITIVE, LEFT, MERGED,
    NO_FARTHER, NO_MORE, OUTCOMES, OVERLAP, PENETRATION, POLYTOPE, POLYTOPE_GROWN, PROJECTED, RIGHT, ROUNDED,
    SEPARATED, SETTLED, SIMPLEX, SIMPLEX_HOLDS, SPLITS, SQUARES, STARTED, SUPPORT, TIE, TOGETHER, TOP,
    TURNS_MORE, WAY_OUT, WITHOUT_RADII,
};
pub(crate) use place::place;
pub(crate) use words::{Voice, script};

/// Every phrase of a story, in an order that stays.
pub(crate) fn all_phrases() -> impl Iterator<Item = &'static Phrase> {
    let files = [phrases::ALL, phrases::events::ALL, phrases::moving::ALL, phrases::steps::ALL];
    files.into_iter().flatten().copied().chain(&OUTCOMES)
}

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
    let (mut text, voice) = (String::new(), Voice::english(names));
    let search = told::Search::of(&trace.events);
    let all: Vec<&Event> = told::told(trace).collect();
    for (k, &event) in all.iter().enumerate() {
        if k > 0 && matches!(event, Event::Started { .. }) {
            text.push('\n');
        }
        let grown = || growth::sentence(event, all[k + 1..].iter().copied(), voice);
        let said = search.end(event, voice).or_else(grown);
        text.push_str(&said.unwrap_or_else(|| sentence_in(event, voice)));
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
/// assert_eq!(sentence(&event, &names), "wall ⊖ bullet is a disc of radius 2 around (3, 4).");
/// ```
#[must_use]
pub fn sentence(event: &Event, names: &Names) -> String {
    sentence_in(event, Voice::english(names))
}

/// One event in one sentence of a voice.
#[must_use]
#[expect(clippy::too_many_lines, reason = "one arm an event, and nothing else")]
pub(crate) fn sentence_in(event: &Event, voice: Voice) -> String {
    // Every event has its own arm, so that a new one does not build without its sentence.
    match event {
        Event::Started { algorithm, at } => {
            voice.say(&STARTED, &[algorithm, &voice.all(), &voice.moment(at)])
        }
        Event::CirclesCompared { radii, distance_squared, radii_squared, early_out, .. } => {
            circles(voice, *radii, [*distance_squared, *radii_squared], *early_out)
        }
        Event::PenetrationMeasured { p, direction, vector } => penetration(voice, *p, *direction, *vector),
        Event::BoundsFound { of, min, max, touching } => bounds(voice, *of, [*min, *max], touching),
        Event::ExtentsCompared { centers, half_extents, gap } => {
            extents(voice, *centers, *half_extents, *gap)
        }
        Event::Clamped { body, v, half_extents, clamped, closest, d, radius } => {
            let left = clamped_distance(*d, *radius, v == clamped);
            in_box(voice, *body, [*v, *clamped, *half_extents], [*closest, *d], left)
        }
        Event::SupportFound { body, direction, vertices } => support(voice, *body, *direction, vertices),
        Event::DifferenceEdgeFound { source, edge, vertex, from, to, distance, .. } => {
            difference_edge(voice, *source, [*edge, *vertex], [*from, *to], *distance)
        }
        Event::EdgesMerged { taken, edge, other, .. } => merged(voice, *taken, *edge, *other),
        Event::DifferenceRounded { center, radius } => rounded(voice, *center, *radius),
        Event::OriginProjected { foot, distance } => {
            voice.say(&PROJECTED, &[&voice.point(*foot), &voice.away(*distance)])
        }
        Event::CandidateImproved { goal, distance, foot, source } => {
            candidate(voice, *goal, *distance, *foot, *source)
        }
        Event::AxisTested { axis, source, interval_a, interval_b, gap } => {
            axis_tested(voice, *axis, *source, [*interval_a, *interval_b], *gap)
        }
        Event::SeparatingAxisFound { normal, gap } => {
            voice.say(&SEPARATED, &[&voice.point(*normal), &voice.length(*gap)])
        }
        Event::SimplexUpdated { vertices, closest, .. } if *closest == DVec2::ZERO => {
            voice.say(&SIMPLEX_HOLDS, &[&voice.points(vertices)])
        }
        Event::SimplexUpdated { vertices, closest, direction } => {
            voice.say(&SIMPLEX, &[&voice.points(vertices), &voice.point(*closest), &voice.point(*direction)])
        }
        Event::PolytopeExpanded { vertices, nearest, normal, support, beyond, .. } => {
            polytope(voice, vertices, *nearest, [*normal, *support], *beyond)
        }
        Event::RayClipped { source, from, to, outcome, time } => {
            ray(voice, *source, [*from, *to], *outcome, *time)
        }
        Event::Advanced { step, at, separation, normal, closing_speed, bound, next, .. } => {
            advanced(voice, (*step, at), (*separation, *normal), [*closing_speed, *bound], *next)
        }
        Event::AxisSwept { from, to, owner, normal } => swept(voice, [*from, *to], *owner, *normal),
        Event::ClosestApproachFound { at, separation, bounds, normal, .. } => {
            closest_approach(voice, at, [*separation, bounds.lo], *normal)
        }
        Event::ExpectationCompared { size, outcome, separation, time, normal_deg, points } => {
            compared(voice, (*size, *outcome), [*separation, *time, *normal_deg], *points)
        }
        Event::MotionBounded { body, radius, theta, arc, linear, vertices } => {
            motion(voice, *body, vertices, [*radius, *theta, *arc, *linear])
        }
        Event::EdgesFaced { body, reference, incident, from, to, normal, .. } => {
            clip::faced(voice, *body, [*reference, *incident], [*from, *to], *normal)
        }
        Event::EdgeCut { plane, end, at } => clip::cut(voice, *plane, *end, *at),
        Event::ContactFound { points, separation, touches, .. } => {
            clip::found(voice, *points, *separation, *touches)
        }
        Event::Finished { outcome } => voice.say(&FINISHED, &[voice.outcome(outcome)]),
    }
}

/// The early-out of two circles: squares of distance and radii.
fn circles(
    voice: Voice,
    radii: [f64; 2],
    [distance_squared, radii_squared]: [f64; 2],
    early_out: bool,
) -> String {
    let than = match distance_squared.total_cmp(&radii_squared) {
        Ordering::Less => "<",
        Ordering::Equal => "=",
        Ordering::Greater => ">",
    };
    let then = if early_out { voice.word(&SETTLED) } else { String::new() };
    let [r, q] = radii.map(|r| voice.number(r));
    let [distance, sum] = [distance_squared, radii_squared].map(|x| voice.number(x));
    let (apart, of_both) = (centers_apart(voice), sum_of_radii(voice));
    voice.say(&SQUARES, &[&apart, &distance, than, &of_both, &r, &q, &sum, &then])
}

/// The distance of two circles' centres, as the article writes it.
fn centers_apart(voice: Voice) -> String {
    format!("|{} {} {}|", voice.of(Side::A), voice.minus(), voice.of(Side::B))
}

/// The sum of two circles' radii in letters.
fn sum_of_radii(voice: Voice) -> String {
    let [a, b] = Side::BOTH.map(|side| voice.symbol("r", side));
    format!("({a} + {b})")
}

fn penetration(voice: Voice, p: f64, direction: DVec2, vector: DVec2) -> String {
    let (p, direction, vector) = (voice.number(p), voice.point(direction), voice.point(vector));
    let [a, b] = Side::BOTH.map(|side| voice.of(side));
    let (apart, sum) = (centers_apart(voice), sum_of_radii(voice));
    voice.say(&PENETRATION, &[&apart, voice.minus(), &sum, &p, &direction, &b, &a, &vector])
}

fn extents(voice: Voice, [a, b]: [DVec2; 2], [h, k]: [DVec2; 2], gap: DVec2) -> String {
    let [c, d] = Side::BOTH.map(|side| voice.symbol("c", side));
    let [p, q] = Side::BOTH.map(|side| voice.symbol("h", side));
    let [apart, first, second, gap] = [(b - a).abs(), h, k, gap].map(|v| voice.point(v));
    let minus = voice.minus();
    format!("D = |{d} {minus} {c}| {minus} ({p} + {q}) = {apart} {minus} ({first} + {second}) = {gap}.")
}

/// A circle's centre in the frame of a box: V, V clamped, the half-extents; then the world again.
fn in_box(
    voice: Voice,
    body: Side,
    in_frame: [DVec2; 3],
    in_world: [DVec2; 2],
    (is_inside, left): (bool, f64),
) -> String {
    let (own, less) = (voice.of(body), voice.minus());
    let sign = if is_inside { less } else { "" };
    let [v, clamped, h] = in_frame.map(|p| voice.point(p));
    let [closest, d] = in_world.map(|p| voice.point(p));
    if is_inside {
        return voice.say(&CLAMPED_INSIDE, &[&own, &v, &h, &closest, &d, sign, less, &voice.number(left)]);
    }
    voice.say(&CLAMPED, &[&own, &v, &clamped, &h, &closest, &d, sign, less, &voice.number(left)])
}

fn support(voice: Voice, body: Side, direction: DVec2, vertices: &[SupportVertex]) -> String {
    let tie = if vertices.len() > 1 { voice.word(&TIE) } else { String::new() };
    voice.say(&SUPPORT, &[&voice.point(direction), &voice.of(body), &voice.list(vertices), &tie])
}

fn difference_edge(
    voice: Voice,
    source: Side,
    indices: [usize; 2],
    ends: [DVec2; 2],
    distance: f64,
) -> String {
    let [edge, vertex] = indices.map(|i| i.to_string());
    let [from, to] = ends.map(|p| voice.point(p));
    let (own, other) = (voice.of(source), voice.of(source.other()));
    let whole = voice.difference();
    // It is that of the cores: the outline of a round pair lies beyond it.
    let what = if voice.names.has_radius() { voice.say(&WITHOUT_RADII, &[&whole]) } else { whole };
    let far = ends.iter().map(|p| p.length()).fold(0.0, f64::max);
    let aside = voice.aside(distance, far);
    if voice.names.is_of_circle(source.other()) {
        return voice.say(&DIFFERENCE_EDGE_OF_CENTER, &[&edge, &own, &other, &from, &to, &what, &aside]);
    }
    voice.say(&DIFFERENCE_EDGE, &[&edge, &own, &vertex, &other, &from, &to, &what, &aside])
}

/// The choice between the next edges of both bodies.
fn merged(voice: Voice, taken: Side, edge: DVec2, other: Option<DVec2>) -> String {
    let others = voice.of(taken.other());
    let than = match other {
        Some(other) => voice.say(&TURNS_MORE, &[&others, &voice.point(other)]),
        None => voice.say(&NO_MORE, &[&others]),
    };
    voice.say(&MERGED, &[&voice.point(edge), &voice.of(taken), &than])
}

fn rounded(voice: Voice, center: Option<DVec2>, radius: f64) -> String {
    let (what, radius) = (voice.difference(), voice.number(radius));
    match center {
        Some(center) => voice.say(&DISC, &[&what, &radius, &voice.point(center)]),
        None => voice.say(&ROUNDED, &[&what, &radius]),
    }
}

fn candidate(
    voice: Voice,
    goal: Goal,
    distance: f64,
    foot: DVec2,
    (side, feature): (Side, Feature),
) -> String {
    let best = match goal {
        Goal::LeastPenetrating => &LEAST_PENETRATING,
        Goal::LeastPositive => &LEAST_POSITIVE,
    };
    // How deep the origin is, or how far away: the phrase says which.
    let (distance, foot) = (voice.length(distance.abs()), voice.point(foot));
    voice.say(best, &[&distance, &foot, &voice.part((side, feature)), &voice.of(side)])
}

fn axis_tested(
    voice: Voice,
    axis: DVec2,
    (side, feature): (Side, Feature),
    intervals: [Enclosure; 2],
    gap: f64,
) -> String {
    let [first, second] = Side::BOTH.map(|side| voice.of(side));
    let [a, b] = intervals.map(|interval| voice.interval(interval));
    let between = if gap > 0.0 {
        voice.say(&GAP, &[&voice.length(gap)])
    } else if so_far::is_behind(intervals[0], intervals[1]) {
        voice.say(&BEHIND, &[&second, &first])
    } else {
        voice.say(&OVERLAP, &[&second, &voice.length(-gap), &first])
    };
    let (axis, part, of) = (voice.point(axis), voice.part((side, feature)), voice.of(side));
    let phrase = match (feature, side) {
        (Feature::Vertex(_), _) => &AXIS_FROM,
        (Feature::Edge(_), Side::A) => &AXIS,
        (Feature::Edge(_), Side::B) => &AXIS_INTO,
    };
    voice.say(phrase, &[&axis, &part, &of, &first, &a, &second, &b, &between])
}

/// Vertices of a polytope that are told: those of the simplex that it begins with. What is added later was
/// told as the vertex that splits an edge.
const FIRST: usize = 3;

/// A step of EPA: the polytope, its nearest edge, and the vertex beyond that.
fn polytope(
    voice: Voice,
    vertices: &[DVec2],
    nearest: f64,
    [normal, support]: [DVec2; 2],
    beyond: f64,
) -> String {
    let then = if beyond > 0.0 {
        voice.say(&SPLITS, &[&voice.point(support), &voice.length(beyond)])
    } else {
        voice.word(if nearest > 0.0 { &WAY_OUT } else { &NO_FARTHER })
    };
    let (count, points) = (vertices.len().to_string(), voice.points(vertices));
    let (nearest, normal) = (voice.length(nearest), voice.point(normal));
    if vertices.len() > FIRST {
        return voice.say(&POLYTOPE_GROWN, &[&count, &nearest, &normal, &then]);
    }
    voice.say(&POLYTOPE, &[&count, &points, &nearest, &normal, &then])
}

/// The sentence of a bounding box.
fn bounds(
    voice: Voice,
    of: Option<Side>,
    [min, max]: [DVec2; 2],
    touching: &[Vec<SupportVertex>; 4],
) -> String {
    let whose = of.map_or_else(|| voice.say(&TOGETHER, &[&voice.all()]), |side| voice.of(side));
    let mut text = voice.say(&BOX, &[&whose, &voice.point(min), &voice.point(max)]);
    let sides: [&Phrase; 4] = [&LEFT, &BOTTOM, &RIGHT, &TOP];
    for (side, vertices) in sides.into_iter().zip(touching) {
        if !vertices.is_empty() {
            text.push_str("; ");
            text.push_str(voice.tongue.word(side));
            text.push_str(": ");
            text.push_str(&voice.farthest(of, vertices));
        }
    }
    text.push('.');
    text
}

/// Whether the centre is inside, and the distance of circle and box: ‖D‖ − r, or −‖D‖ − r inside.
fn clamped_distance(d: DVec2, radius: f64, is_inside: bool) -> (bool, f64) {
    let length = libm::hypot(d.x, d.y);
    (is_inside, if is_inside { -length - radius } else { length - radius })
}
