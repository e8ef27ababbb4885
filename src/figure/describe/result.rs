//! What came out, as a sentence.

use crate::collision::{Answer, Contact, Impact, MotionBound, Outcome, Overlap, Pair, Reason, Separation};
use crate::figure::again::Nearest;
use crate::figure::called::Called;
use crate::figure::difference::Difference;
use crate::figure::question::is_of_a_moment;
use crate::figure::runs::{Run, Runs};
use crate::figure::text::named;
use crate::figure::touching::{Touching, touching};
use crate::geometry::{Body, DVec2, Feature, Names, Side, begun, perp};
use crate::scene::Scene;
use crate::trace::Event;

use super::body_phrases::AND;
use super::number::Speech;
use super::off::compared;
use super::phrases::{
    APART, APART_ALONG, APART_BY_ROUNDING, AT_MOMENT, BOX, BY_ROUNDING, CLOSEST, CLOSEST_AGAIN,
    CLOSEST_FIRST, CLOSEST_WHILE, CONTACTS_0, CONTACTS_1, CONTACTS_2, DEEP, DEEP_BY_ROUNDING, ENDS_EARLY,
    HIT, HIT_ALONG, HIT_SOMEWHERE, MISS, NO_FARTHER, NO_FARTHER_BY, NO_NEARER, NO_NEARER_BY, NO_NEARER_THAN,
    NO_OVERLAP, NO_OVERLAP_ALONG, NO_OVERLAP_BY, OVERLAP, OVERLAP_AND, OVERLAP_FIRST, PUSH, PUSH_ANY,
    PUSH_OF_MANY, ROUNDING, STALLED, STAY, STEP_CAP, TITLED, TOLERANCE, TOUCH, TOUCH_FIRST, TOUCH_OF_MANY,
    UNDECIDED, UNRESOLVED, UNRESOLVED_DEEP, UNSAID,
};

/// How fast bodies must come nearer to be said to, in parts of how fast they pass each other: far above what
/// rounding leaves of bodies that go past each other side by side.
const NEARER: f64 = 1e-9;

/// How long bodies must be as near as anywhere to be said to, in parts of the motion: what three digits tell.
const A_WHILE: f64 = 1e-3;

/// Halvings by which the ends of that while are found: to 1e-12.
const HALVINGS: usize = 40;

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
    /// The language.
    speech: Speech,
}

impl<'r> Account<'r> {
    /// The result behind a title.
    pub(super) fn titled(&self, title: &str) -> String {
        self.speech.say(&TITLED, &[title, &self.result()])
    }

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
        Self {
            scene,
            run,
            near: other.and_then(Run::separation).copied(),
            ways: 0,
            speech: Speech::of(scene),
        }
    }

    /// The result as a sentence of its own: with a capital, but a name stays as the scene writes it.
    pub(crate) fn sentence(&self) -> String {
        self.sentence_of_bodies(&self.scene.names())
    }

    /// The result as a sentence about bodies of other names than the scene's.
    pub(crate) fn sentence_of_bodies(&self, names: &Names) -> String {
        sentence_of([names.of(Side::A), names.of(Side::B)], self)
    }

    /// The moment that the answer is of; `None` for the start, and for an answer about the motion.
    fn moment(&self) -> Option<f64> {
        Some(self.run.time).filter(|&time| is_of_a_moment(self.run.kind) && time != 0.0)
    }

    /// The sentence, and how far off what the scene expects is: in words, and as markup with the bodies'
    /// names as labels have them, a letter in italics.
    pub(crate) fn caption(&self, called: &Called) -> [String; 2] {
        let said = |[a, b]: [&str; 2]| self.sentence_and_off(&Names::new(a, Some(b)));
        let in_words = self.sentence_and_off(&called.names(self.scene));
        [in_words, named(Side::BOTH.map(|side| called.side(self.scene, side)), said)]
    }

    /// The sentence, and how far off what the scene expects is, about bodies of these names.
    pub(crate) fn sentence_and_off(&self, names: &Names) -> String {
        let off = compared(self.scene, self.run, names);
        [self.sentence_of_bodies(names), off].join(" ").trim_end().to_owned()
    }

    /// The result as a sentence that begins with a small letter.
    pub(super) fn result(&self) -> String {
        let names = self.scene.names();
        told_of([names.of(Side::A), names.of(Side::B)], self)
    }
}

/// What was told, of bodies named `a` and `b`, the second one empty where there is none.
fn result_of([a, b]: [&str; 2], told: &Account) -> String {
    let speech = told.speech;
    match &told.run.answer {
        Answer::Bounds(bounds) => {
            let whose = if b.is_empty() { a.to_owned() } else { speech.say(&AND, &[a, b]) };
            speech.say(&BOX, &[&whose, &speech.point(bounds.min), &speech.point(bounds.max)])
        }
        Answer::Overlap(overlap) => verdict_in_words([a, b], overlap, told),
        Answer::Separation(s) => separation_in_words([a, b], s, (Side::B, told.ways), told),
        Answer::Contact(contact) => contact_in_words([a, b], contact, told),
        Answer::Impact(impact) => impact_in_words([a, b], impact, told),
        Answer::MotionBound(bound) => bound_in_words([a, b], *bound, told),
    }
}

/// How far any point goes of the body named `a`, or two of `a` and `b` together; with the shares of velocity
/// and turn where both have one.
fn bound_in_words([a, b]: [&str; 2], MotionBound { bound }: MotionBound, told: &Account) -> String {
    let speech = told.speech;
    let mut ways = told.run.told(|event| match event {
        Event::MotionBounded { linear, arc, .. } => Some((*linear, *arc)),
        _ => None,
    });
    let [linear, turns] = ways.by_ref().fold([0.0; 2], |[_, turns], (linear, arc)| [linear, turns + arc]);
    let shares = if linear > 0.0 && turns > 0.0 { speech.bound_of(bound, linear, turns) } else { None };
    let is_one = b.is_empty();
    match shares {
        Some([bound, linear, turns]) if is_one => speech.say(&NO_FARTHER_BY, &[a, &bound, &linear, &turns]),
        Some([bound, linear, turns]) => speech.say(&NO_NEARER_BY, &[a, b, &bound, &linear, &turns]),
        None if is_one => speech.say(&NO_FARTHER, &[a, &speech.at_most(bound)]),
        None => speech.say(&NO_NEARER, &[a, b, &speech.at_most(bound)]),
    }
}

/// Whether the bodies named `a` and `b` overlap; and where it is known, how far apart or how deep.
fn verdict_in_words([a, b]: [&str; 2], overlap: &Overlap, told: &Account) -> String {
    let speech = told.speech;
    match (overlap.overlap, told.near.as_ref()) {
        (None, _) => speech.say(&UNSAID, &[a, b]),
        (Some(true), Some(s)) => separation_in_words([a, b], s, (Side::B, told.ways), told),
        (Some(true), None) => speech.say(&OVERLAP, &[a, b]),
        // It is the axis that was found, and says no more.
        (Some(false), _) if overlap.separation_bounds.hi == f64::INFINITY => {
            let gap = overlap.separation_bounds.lo;
            speech.say(&NO_OVERLAP_ALONG, &[a, b, &speech.value(gap)])
        }
        (Some(false), Some(s)) if s.bounds.lo > 0.0 => {
            speech.say(&NO_OVERLAP_BY, &[a, b, &speech.number(s.bounds.lo, s.bounds.hi)])
        }
        (Some(false), _) => speech.say(&NO_OVERLAP, &[a, b]),
    }
}

/// How the bodies named `a` and `b` stand; the push that parts them is that of the body `pushed`, one of
/// so many.
fn separation_in_words([a, b]: [&str; 2], s: &Separation, pushed: (Side, usize), told: &Account) -> String {
    let (lo, hi, speech) = (s.bounds.lo, s.bounds.hi, told.speech);
    let rounding = told.scene.query_at(told.run.time).rounding();
    if lo > 0.0 && hi <= rounding {
        speech.say(&APART_BY_ROUNDING, &[a, b, &speech.number(lo, hi)])
    } else if hi < 0.0 && -lo <= rounding {
        speech.say(&DEEP_BY_ROUNDING, &[a, b, &speech.number(-hi, -lo)])
    } else if lo > 0.0 {
        let is_along = matches!(s.features, [Feature::Edge(_), Feature::Edge(_)]);
        let phrase = if is_along { &APART_ALONG } else { &APART };
        speech.say(phrase, &[a, b, &speech.number(lo, hi), &speech.vector(*s.normal)])
    } else if hi < 0.0 {
        speech.say(&OVERLAP_AND, &[a, b, &push([a, b], s, pushed, speech)])
    } else if s.ties > 1 {
        speech.say(&TOUCH_OF_MANY, &[a, b, &speech.vector(*s.normal)])
    } else {
        speech.say(&TOUCH, &[a, b])
    }
}

/// The shortest push that parts bodies that overlap, of the body `pushed`: B goes along the normal, A against
/// it. As far as doubles tell, so many `ways` are as short.
fn push([a, b]: [&str; 2], s: &Separation, (pushed, ways): (Side, usize), speech: Speech) -> String {
    let depth = speech.number(-s.bounds.hi, -s.bounds.lo);
    let (name, way) = if pushed == Side::B { (b, *s.normal) } else { (a, -*s.normal) };
    let way = speech.vector(way);
    let ties = usize::try_from(s.ties).unwrap_or(usize::MAX);
    match ties {
        0 => speech.say(&PUSH_ANY, &[name, &depth, &way]),
        _ if ties.max(ways) > 1 => {
            speech.say(&PUSH_OF_MANY, &[&ties.max(ways).to_string(), name, &depth, &way])
        }
        _ => speech.say(&PUSH, &[name, &depth, &way]),
    }
}

/// How the bodies named `a` and `b` stand, and how many points of contact they have. The body is pushed that
/// the reference edge faces, along the normal of that edge.
fn contact_in_words(names: [&str; 2], contact: &Contact, told: &Account) -> String {
    let reference = told.run.events().find_map(|event| match event {
        Event::EdgesFaced { body, .. } => Some(*body),
        _ => None,
    });
    let pushed = reference.map_or(Side::B, Side::other);
    let apart = separation_in_words(names, &contact.separation, (pushed, told.ways), told);
    let phrase = match contact.found().count() {
        0 => &CONTACTS_0,
        1 => &CONTACTS_1,
        _ => &CONTACTS_2,
    };
    told.speech.say(phrase, &[&apart])
}

/// The result of a query for the first contact of the bodies named `a` and `b`.
fn impact_in_words([a, b]: [&str; 2], impact: &Impact, told: &Account) -> String {
    let speech = told.speech;
    match &impact.outcome {
        Outcome::Hit { time, contact } => {
            let when = speech.number(time.lo, time.hi);
            let query = told.scene.query_at(0.0);
            match touching([query.a, query.b.unwrap_or(query.a)], *time, contact) {
                Touching::At(place) => speech.say(&HIT, &[a, b, &when, &speech.point(place)]),
                Touching::Along([from, to]) => {
                    speech.say(&HIT_ALONG, &[a, b, &when, &speech.point(from), &speech.point(to)])
                }
                Touching::Open => speech.say(&HIT_SOMEWHERE, &[a, b, &when]),
            }
        }
        Outcome::Miss => speech.say(&MISS, &[a, b, &closest_in_words(told)]),
        Outcome::Overlapping { contact } if contact.bounds.hi < 0.0 => {
            speech.say(&OVERLAP_FIRST, &[a, b, &push([a, b], contact, (Side::B, told.ways), speech)])
        }
        Outcome::Overlapping { .. } => speech.say(&TOUCH_FIRST, &[a, b]),
        Outcome::Unresolved { reason, free_until } => {
            let why = match reason {
                Reason::WithinRounding => &ROUNDING,
                Reason::WithinTolerance => &TOLERANCE,
                Reason::IterationLimit => &STEP_CAP,
                // No scene has numbers that are not finite.
                Reason::Stalled | Reason::NotFinite => &STALLED,
            };
            unresolved_in_words([a, b], *free_until, speech.0.word(why), told)
        }
    }
}

/// What is undecided of the bodies named `a` and `b`, which are apart until then, and why. Bodies that
/// overlap in the end have touched, whatever the search came to.
fn unresolved_in_words([a, b]: [&str; 2], free_until: f64, why: &str, told: &Account) -> String {
    let speech = told.speech;
    let until = speech.at_least(free_until);
    let overlap = told.near.filter(|end| end.bounds.hi < 0.0);
    let depth = overlap.map(|end| speech.number(-end.bounds.hi, -end.bounds.lo));
    match depth {
        Some(depth) if free_until > 0.0 => speech.say(&UNRESOLVED_DEEP, &[a, b, &until, &depth, why]),
        Some(depth) => speech.say(&DEEP, &[a, b, &depth, why]),
        None if free_until > 0.0 => speech.say(&UNRESOLVED, &[a, b, &until, why]),
        None => speech.say(&UNDECIDED, &[a, b, why]),
    }
}

/// How near a miss came, as "; they come closest at t = 0.5, 2 apart"; empty where that was not told.
fn closest_in_words(told: &Account) -> String {
    let speech = told.speech;
    let found = told.run.events().find_map(|event| match event {
        Event::ClosestApproachFound { at, bounds, normal, points, .. } => {
            let closing = closing(told.scene, at.time, *normal, *points);
            let span = as_near(told.scene, at.time, bounds.hi);
            let is_rounding = bounds.hi <= told.scene.query_at(at.time).rounding();
            let rounding = if is_rounding { speech.say(&BY_ROUNDING, &[]) } else { String::new() };
            let often = told.run.often.of(told.scene, at.time, *bounds);
            Some((at.time, *bounds, closing, span, rounding, often))
        }
        _ => None,
    });
    let Some((time, bounds, closing, span, rounding, often)) = found else { return String::new() };
    let apart = speech.number(bounds.lo, bounds.hi);
    let query = told.scene.query_at(0.0);
    let rests = |b: &Body| query.a.velocity == b.velocity && query.a.spin.is_zero() && b.spin.is_zero();
    let how = if query.b.is_some_and(rests) || often == Nearest::Always {
        speech.say(&STAY, &[&apart])
    } else if often == Nearest::Again {
        speech.say(&CLOSEST_AGAIN, &[&speech.value(time), &apart])
    } else if often == Nearest::Unknown {
        let (reached, proved) = (speech.at_most(bounds.hi), speech.at_least(bounds.lo));
        speech.say(&NO_NEARER_THAN, &[&reached, &speech.value(time), &proved])
    } else if time >= 1.0 && closing > 0.0 {
        speech.say(&ENDS_EARLY, &[&speech.value(time), &apart])
    } else if time <= 0.0 && closing < 0.0 {
        speech.say(&CLOSEST_FIRST, &[&apart])
    } else if let Some([from, to]) = span {
        speech.say(&CLOSEST_WHILE, &[&speech.value(from), &speech.value(to), &apart])
    } else {
        speech.say(&CLOSEST, &[&speech.value(time), &apart])
    };
    how + &rounding
}

/// From when to when bodies that do not turn are as near as at `time`, as far as proofs tell; `None` where
/// that is one moment. Their distance is a convex function of time, so that it is level in one piece if at
/// all.
fn as_near(scene: &Scene, time: f64, distance: f64) -> Option<[f64; 2]> {
    let query = scene.query_at(0.0);
    let b = query.b.filter(|b| !b.turns() && !query.a.turns())?;
    let is_near = |t: f64| Pair::at(query.a, b, t).separation().bounds.lo <= distance;
    let ends = [0.0, 1.0].map(|end| {
        let (mut near, mut far) = (time, end);
        if is_near(end) {
            return end;
        }
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(near, far);
            if is_near(middle) { near = middle } else { far = middle }
        }
        near
    });
    (ends[1] - ends[0] > A_WHILE).then_some(ends)
}

/// How fast witness points that are carried with the bodies come nearer at `time`, world units per unit of
/// time; 0 where that is rounding.
pub(crate) fn closing(scene: &Scene, time: f64, normal: DVec2, [p, q]: [DVec2; 2]) -> f64 {
    let query = scene.query_at(time);
    let carried =
        |body: &Body, at: DVec2| body.velocity + perp(at - body.pose_at(time).position) * body.spin.radians();
    let passing = carried(query.a, p) - query.b.map_or(DVec2::ZERO, |b| carried(b, q));
    let closing = passing.dot(normal);
    if closing.abs() <= NEARER * passing.length() { 0.0 } else { closing }
}

/// The result with its moment, of bodies named so: it begins with a small letter, or a name.
fn told_of(names: [&str; 2], told: &Account) -> String {
    let text = result_of(names, told);
    match told.moment() {
        Some(moment) => told.speech.say(&AT_MOMENT, &[&told.speech.value(moment), &text]),
        None => text,
    }
}

/// The result as a sentence of its own, of bodies named so.
fn sentence_of(names: [&str; 2], told: &Account) -> String {
    let text = told_of(names, told);
    if text.starts_with(&format!("{} ", names[0])) {
        return text;
    }
    begun(&text)
}

#[cfg(test)]
mod tests;
