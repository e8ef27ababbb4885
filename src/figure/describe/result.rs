//! What came out, as a sentence.

use crate::collision::{Answer, Contact, Impact, MotionBound, Outcome, Overlap, Reason, Separation};
use crate::figure::called::Called;
use crate::figure::difference::Difference;
use crate::figure::question::is_of_a_moment;
use crate::figure::runs::{Run, Runs};
use crate::figure::text::named;
use crate::geometry::{Body, DVec2, Names, Side, perp};
use crate::scene::Scene;
use crate::trace::Event;

use super::number::{at_least, at_most, number, point, value};

/// How fast bodies must come nearer to be said to, in parts of how fast they pass each other: far above what
/// rounding leaves of bodies that go past each other side by side.
const NEARER: f64 = 1e-9;

/// A run, and what its sentence needs besides.
pub(crate) struct Account<'r> {
    /// The scene.
    scene: &'r Scene,
    /// The run.
    run: &'r Run,
    /// How the bodies stand at its moment where the answer is a bare verdict, and at the end of a motion of
    /// which it is undecided whether they touch.
    near: Option<Separation>,
    /// How many pushes are as short as the shortest, as far as doubles tell; 0 where that was not looked at.
    ways: usize,
}

impl<'r> Account<'r> {
    /// A run of a scene; a bare verdict is told with the separation that the figure has of that moment, and
    /// what is undecided with that of the end.
    pub(crate) fn of(scene: &'r Scene, runs: &Runs, run: &'r Run) -> Self {
        let found = match &run.answer {
            Answer::Overlap(_) => runs.separation(scene, run.time),
            Answer::Impact(impact) if matches!(impact.outcome, Outcome::Unresolved { .. }) => {
                runs.separation(scene, 1.0)
            }
            _ => None,
        };
        let told = Self::beside(scene, run, found.as_deref());
        let overlap = told.run.separation().or(told.near.as_ref()).is_some_and(|s| s.bounds.hi < 0.0);
        let difference = || Difference::of(runs.difference(scene, run.time)?.events());
        let ways = if overlap { difference().map_or(0, |found| found.ways_out()) } else { 0 };
        Self { ways, ..told }
    }

    /// A run of a scene, beside another one that answers with the separation at that moment.
    pub(crate) fn beside(scene: &'r Scene, run: &'r Run, other: Option<&Run>) -> Self {
        Self { scene, run, near: other.and_then(Run::separation).copied(), ways: 0 }
    }

    /// The result as a sentence of its own: with a capital, but a name stays as the scene writes it.
    pub(crate) fn sentence(&self) -> String {
        self.sentence_of_bodies(&self.scene.names())
    }

    /// The result as a sentence about bodies of other names than the scene's.
    pub(crate) fn sentence_of_bodies(&self, names: &Names) -> String {
        sentence_of([names.of(Side::A), names.of(Side::B)], self)
    }

    /// The moment that the answer is of, in words; `None` for the start, and for an answer about the motion.
    fn moment(&self) -> Option<String> {
        let is_later = is_of_a_moment(self.run.kind) && self.run.time != 0.0;
        is_later.then(|| format!("at t = {}", value(self.run.time)))
    }

    /// The sentence as markup, with the bodies' names as labels have them: a letter in italics.
    pub(crate) fn sentence_markup(&self, called: &Called) -> String {
        named(Side::BOTH.map(|side| called.side(self.scene, side)), |names| sentence_of(names, self))
    }

    /// The result as a sentence that begins with a small letter.
    pub(super) fn result(&self) -> String {
        let names = self.scene.names();
        let result = result_of([names.of(Side::A), names.of(Side::B)], self);
        self.moment().map_or(result.clone(), |moment| format!("{moment} {result}"))
    }
}

/// What was told, of bodies named `a` and `b`, the second one empty where there is none.
fn result_of([a, b]: [&str; 2], told: &Account) -> String {
    match &told.run.answer {
        Answer::Bounds(bounds) => format!(
            "the bounding box of {a}{} reaches from {} to {}.",
            if b.is_empty() { String::new() } else { format!(" and {b}") },
            point(bounds.min),
            point(bounds.max)
        ),
        Answer::Overlap(overlap) => verdict_in_words([a, b], overlap, told),
        Answer::Separation(s) => separation_in_words([a, b], s, (Side::B, told.ways)),
        Answer::Contact(contact) => contact_in_words([a, b], contact, told),
        Answer::Impact(impact) => impact_in_words([a, b], impact, told),
        Answer::MotionBound(MotionBound { bound }) if b.is_empty() => {
            format!("no point of {a} travels farther than {}.", at_most(*bound))
        }
        Answer::MotionBound(MotionBound { bound }) => {
            format!(
                "no two points of {a} and {b} come nearer to each other by more than {}.",
                at_most(*bound)
            )
        }
    }
}

/// Whether the bodies named `a` and `b` overlap; and where it is known, how far apart or how deep.
fn verdict_in_words([a, b]: [&str; 2], overlap: &Overlap, told: &Account) -> String {
    let near = told.near.as_ref();
    match (overlap.overlap, near) {
        (None, _) => format!("rounding forbids to say whether {a} and {b} overlap."),
        (Some(true), Some(s)) => separation_in_words([a, b], s, (Side::B, told.ways)),
        (Some(true), None) => format!("{a} and {b} overlap."),
        (Some(false), Some(s)) if s.bounds.lo > 0.0 => {
            format!("{a} and {b} do not overlap: they are {} apart.", number(s.bounds.lo, s.bounds.hi))
        }
        (Some(false), _) => format!("{a} and {b} do not overlap."),
    }
}

/// How the bodies named `a` and `b` stand; the push that parts them is that of the body `pushed`, one of
/// so many.
fn separation_in_words([a, b]: [&str; 2], s: &Separation, pushed: (Side, usize)) -> String {
    let (lo, hi) = (s.bounds.lo, s.bounds.hi);
    if lo > 0.0 {
        format!("{a} and {b} are {} apart along the normal {}.", number(lo, hi), point(*s.normal))
    } else if hi < 0.0 {
        format!("{a} and {b} overlap; {}.", push([a, b], s, pushed))
    } else {
        format!("{a} and {b} touch.")
    }
}

/// The shortest push that parts bodies that overlap, of the body `pushed`: B goes along the normal, A against
/// it. As far as doubles tell, so many `ways` are as short.
fn push([a, b]: [&str; 2], s: &Separation, (pushed, ways): (Side, usize)) -> String {
    let depth = number(-s.bounds.hi, -s.bounds.lo);
    let (name, way) = if pushed == Side::B { (b, *s.normal) } else { (a, -*s.normal) };
    let along = if s.ties == 0 { "in any direction, as along" } else { "along" };
    let ties = usize::try_from(s.ties).unwrap_or(usize::MAX);
    let which = match if ties == 0 { 0 } else { ties.max(ways) } {
        0 | 1 => "the shortest push that parts them".to_owned(),
        ties => format!("one of the {ties} shortest pushes that part them"),
    };
    format!("{which} moves {name} by {depth} {along} {}", point(way))
}

/// How the bodies named `a` and `b` stand, and how many points of contact they have. The body is pushed that
/// the reference edge faces, along the normal of that edge.
fn contact_in_words(names: [&str; 2], contact: &Contact, told: &Account) -> String {
    let reference = told.run.events().find_map(|event| match event {
        Event::EdgesFaced { body, .. } => Some(*body),
        _ => None,
    });
    let pushed = reference.map_or(Side::B, Side::other);
    let apart = separation_in_words(names, &contact.separation, (pushed, told.ways));
    match contact.found().count() {
        0 => format!("{apart} There is no point of contact."),
        1 => format!("{apart} There is one point of contact."),
        _ => format!("{apart} There are two points of contact."),
    }
}

/// The result of a query for the first contact of the bodies named `a` and `b`.
fn impact_in_words([a, b]: [&str; 2], impact: &Impact, told: &Account) -> String {
    match &impact.outcome {
        Outcome::Hit { time, contact } => format!(
            "{a} first touches {b} at t = {}, at {}.",
            number(time.lo, time.hi),
            point((contact.points[0] + contact.points[1]) / 2.0)
        ),
        Outcome::Miss => format!("{a} and {b} do not touch{}.", closest_in_words(told)),
        Outcome::Overlapping { contact } if contact.bounds.hi < 0.0 => {
            format!("{a} and {b} overlap from the start; {}.", push([a, b], contact, (Side::B, told.ways)))
        }
        Outcome::Overlapping { .. } => format!("{a} and {b} touch from the start."),
        Outcome::Unresolved { reason, free_until } => {
            let why = match reason {
                Reason::WithinRounding => "rounding forbids more",
                Reason::WithinTolerance => "they come within the tolerance",
                Reason::IterationLimit => "the step cap was reached",
                Reason::Stalled => "the steps no longer advanced",
            };
            let apart = format!("are apart until t = {}", at_least(*free_until));
            // Bodies that overlap in the end have touched, whatever the search came to.
            let overlap = told.near.filter(|end| end.bounds.hi < 0.0);
            let depth = overlap.map(|end| number(-end.bounds.hi, -end.bounds.lo));
            match depth {
                Some(depth) if *free_until > 0.0 => format!(
                    "{a} and {b} {apart} and overlap by {depth} at t = 1; when they first touch is \
                     undecided: {why}."
                ),
                Some(depth) => format!(
                    "{a} and {b} overlap by {depth} at t = 1; when they first touch is undecided: {why}."
                ),
                None if *free_until > 0.0 => {
                    format!("{a} and {b} {apart}; whether they touch is undecided: {why}.")
                }
                None => format!("whether {a} and {b} touch is undecided: {why}."),
            }
        }
    }
}

/// How near a miss came, as "; they come closest at t = 0.5, 2 apart"; empty where that was not told.
fn closest_in_words(told: &Account) -> String {
    let found = told.run.events().find_map(|event| match event {
        Event::ClosestApproachFound { at, bounds, normal, points, .. } => {
            Some((at.time, number(bounds.lo, bounds.hi), closing(told.scene, at.time, *normal, *points)))
        }
        _ => None,
    });
    let Some((time, apart, closing)) = found else { return String::new() };
    let query = told.scene.query_at(0.0);
    let rests = |b: &Body| query.a.velocity == b.velocity && query.a.spin.is_zero() && b.spin.is_zero();
    if query.b.is_some_and(rests) {
        format!("; they stay {apart} apart")
    } else if time >= 1.0 && closing > 0.0 {
        format!("; the motion ends at t = {} while they still come nearer, {apart} apart", value(time))
    } else if time <= 0.0 && closing < 0.0 {
        format!("; they are closest at the start, {apart} apart")
    } else {
        format!("; they come closest at t = {}, {apart} apart", value(time))
    }
}

/// How fast witness points that are carried with the bodies come nearer at `time`, world units per unit of
/// time; 0 where that is rounding.
fn closing(scene: &Scene, time: f64, normal: DVec2, [p, q]: [DVec2; 2]) -> f64 {
    let query = scene.query_at(time);
    let carried =
        |body: &Body, at: DVec2| body.velocity + perp(at - body.pose_at(time).position) * body.spin.radians();
    let passing = carried(query.a, p) - query.b.map_or(DVec2::ZERO, |b| carried(b, q));
    let closing = passing.dot(normal);
    if closing.abs() <= NEARER * passing.length() { 0.0 } else { closing }
}

/// The result as a sentence of its own, of bodies named so.
fn sentence_of(names: [&str; 2], told: &Account) -> String {
    let text = result_of(names, told);
    if let Some(moment) = told.moment() {
        return format!("{}{} {text}", moment[..1].to_uppercase(), &moment[1..]);
    }
    if text.starts_with(&format!("{} ", names[0])) {
        return text;
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests;
