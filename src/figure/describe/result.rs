//! What came out, as a sentence.

use crate::collision::{
    Answer, Contact, Impact, MotionBound, Outcome, Overlap, QueryKind, Reason, Separation,
};
use crate::figure::called::Called;
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
    /// How the bodies stand at its moment where the answer is a bare verdict.
    near: Option<Separation>,
}

impl<'r> Account<'r> {
    /// A run of a scene; a bare verdict is told with the separation that the figure has of that moment.
    pub(crate) fn of(scene: &'r Scene, runs: &Runs, run: &'r Run) -> Self {
        let is_bare = run.kind == QueryKind::Overlap;
        let found = if is_bare { runs.separation(scene, run.time) } else { None };
        Self::beside(scene, run, found.as_deref())
    }

    /// A run of a scene, beside another one that answers with the separation at that moment.
    pub(crate) fn beside(scene: &'r Scene, run: &'r Run, other: Option<&Run>) -> Self {
        Self { scene, run, near: other.and_then(Run::separation).copied() }
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
        Answer::Overlap(overlap) => verdict_in_words([a, b], overlap, told.near.as_ref()),
        Answer::Separation(s) => separation_in_words([a, b], s, Side::B),
        Answer::Contact(contact) => contact_in_words([a, b], contact, told.run),
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
fn verdict_in_words([a, b]: [&str; 2], overlap: &Overlap, near: Option<&Separation>) -> String {
    match (overlap.overlap, near) {
        (None, _) => format!("rounding forbids to say whether {a} and {b} overlap."),
        (Some(true), Some(s)) => separation_in_words([a, b], s, Side::B),
        (Some(true), None) => format!("{a} and {b} overlap."),
        (Some(false), Some(s)) if s.bounds.lo > 0.0 => {
            format!("{a} and {b} do not overlap: they are {} apart.", number(s.bounds.lo, s.bounds.hi))
        }
        (Some(false), _) => format!("{a} and {b} do not overlap."),
    }
}

/// How the bodies named `a` and `b` stand; the push that parts them is that of the body `pushed`.
fn separation_in_words([a, b]: [&str; 2], s: &Separation, pushed: Side) -> String {
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
/// it.
fn push([a, b]: [&str; 2], s: &Separation, pushed: Side) -> String {
    let depth = number(-s.bounds.hi, -s.bounds.lo);
    let (name, way) = if pushed == Side::B { (b, *s.normal) } else { (a, -*s.normal) };
    let along = if s.ties == 0 { "in any direction, as along" } else { "along" };
    format!("the shortest push that parts them moves {name} by {depth} {along} {}", point(way))
}

/// How the bodies named `a` and `b` stand, and how many points of contact they have. The body is pushed that
/// the reference edge faces, along the normal of that edge.
fn contact_in_words(names: [&str; 2], contact: &Contact, run: &Run) -> String {
    let reference = run.events().find_map(|event| match event {
        Event::EdgesFaced { body, .. } => Some(*body),
        _ => None,
    });
    let pushed = reference.map_or(Side::B, Side::other);
    let apart = separation_in_words(names, &contact.separation, pushed);
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
            format!("{a} and {b} overlap from the start; {}.", push([a, b], contact, Side::B))
        }
        Outcome::Overlapping { .. } => format!("{a} and {b} touch from the start."),
        Outcome::Unresolved { reason, free_until } => {
            let why = match reason {
                Reason::WithinRounding => "rounding forbids more",
                Reason::WithinTolerance => "they come within the tolerance",
                Reason::IterationLimit => "the step cap was reached",
                Reason::Stalled => "the steps no longer advanced",
            };
            format!(
                "{a} and {b} are apart until t = {}; whether they touch is undecided: {why}.",
                at_least(*free_until)
            )
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
mod tests {
    use super::*;
    use crate::figure::runs::Runs;
    use crate::scene::open_text;

    #[test]
    fn a_letter_is_in_italics_and_a_word_or_a_number_with_the_same_letters_is_not() {
        let said = |a: &str, b: &str| {
            let text = format!(
                "shapes.{a} = {{ kind = 'circle', radius = 1 }}
                shapes.{b} = {{ kind = 'circle', radius = 1, position = [4, 0] }}
                query = {{ kind = 'separation', of = ['{a}', '{b}'] }}"
            );
            let scene = open_text("sentence.toml", &text).unwrap().scene;
            let runs = Runs::default();
            let run = runs.own(&scene, 0.0);
            let told = Account::of(&scene, &runs, &run);
            (told.sentence(), told.sentence_markup(&runs.called))
        };
        let (words, markup) = said("A", "a");
        assert_eq!(words, "A and a are 2 apart along the normal (1, 0).");
        assert_eq!(markup, "$A$ and $a$ are 2 apart along the normal (1, 0).");
        assert_eq!(said("apart", "B").1, "apart and $B$ are 2 apart along the normal (1, 0).");
    }

    /// What is said of the bodies and the question of a scene.
    fn said(scene: &str) -> String {
        let scene = open_text("sentence.toml", scene).unwrap().scene;
        let runs = Runs::default();
        let run = runs.own(&scene, 0.0);
        Account::of(&scene, &runs, &run).sentence()
    }

    /// A box on the floor, 0.5 deep in it, in a question about both.
    fn on_the_floor(query: &str) -> String {
        format!(
            "shapes.crate = {{ kind = 'aabb', half_extents = [1, 1], position = [0, 0.5] }}
            shapes.floor = {{ kind = 'aabb', half_extents = [4, 1], position = [0, -1] }}
            query = {{ {query} }}"
        )
    }

    #[test]
    fn a_push_names_the_body_that_goes_and_where_to() {
        let pushed = |way: &str| format!("overlap; the shortest push that parts them moves {way}");
        let separation = said(&on_the_floor("kind = 'separation', of = ['crate', 'floor']"));
        assert_eq!(separation, format!("crate and floor {}.", pushed("floor by 0.5 along (0, −1)")));
        let overlap = said(&on_the_floor("kind = 'overlap', of = ['floor', 'crate']"));
        assert_eq!(overlap, format!("floor and crate {}.", pushed("crate by 0.5 along (0, 1)")));
        let swept = on_the_floor("kind = 'linear-sweep', of = ['floor', 'crate']");
        assert!(said(&swept).starts_with("floor and crate overlap from the start; "), "{}", said(&swept));
    }

    #[test]
    fn a_contact_pushes_the_body_that_the_reference_edge_faces_along_the_normal_that_is_drawn() {
        for of in ["'crate', 'floor'", "'floor', 'crate'"] {
            let text = on_the_floor(&format!("kind = 'contact', of = [{of}]"));
            let scene = open_text("contact.toml", &text).unwrap().scene;
            let runs = Runs::default();
            let run = runs.own(&scene, 0.0);
            let drawn = run.events().find_map(|event| match event {
                Event::EdgesFaced { body, normal, .. } => Some((*body, point(*normal))),
                _ => None,
            });
            let (reference, normal) = drawn.unwrap();
            let pushed = scene.names().of(reference.other()).to_owned();
            let said = Account::of(&scene, &runs, &run).sentence();
            assert!(said.contains(&format!("moves {pushed} by 0.5 along {normal}. ")), "{of}: {said}");
            assert!(said.ends_with("There are two points of contact."), "{said}");
        }
    }

    #[test]
    fn a_verdict_says_how_far_apart_and_touching_is_not_overlapping() {
        let beside = |x: f64| {
            said(&format!(
                "shapes.a = {{ kind = 'circle', radius = 1 }}
                shapes.b = {{ kind = 'circle', radius = 1, position = [{x}, 0] }}
                query = {{ kind = 'overlap', of = ['a', 'b'] }}"
            ))
        };
        assert_eq!(beside(4.0), "a and b do not overlap: they are 2 apart.");
        assert_eq!(beside(2.0), "a and b touch.");
    }

    #[test]
    fn concentric_circles_are_parted_in_any_direction() {
        let text = "shapes.a = { kind = 'circle', radius = 1 }
            shapes.b = { kind = 'circle', radius = 2 }
            query = { kind = 'separation', of = ['a', 'b'] }";
        assert!(said(text).ends_with(" moves b by 3 in any direction, as along (1, 0)."), "{}", said(text));
    }

    #[test]
    fn a_bound_is_said_no_smaller_than_it_is() {
        let text = "shapes.a = { kind = 'box', half_extents = [3, 1], angular_velocity_deg = 111 }
            query = { kind = 'motion-bound', of = ['a'] }";
        // √10 · 111° = 6.1263…
        assert_eq!(said(text), "No point of a travels farther than 6.13.");
    }

    #[test]
    fn a_motion_that_ends_while_the_bodies_come_nearer_is_said_to_end() {
        let passed = |velocity: &str| {
            said(&format!(
                "shapes.a = {{ kind = 'circle', radius = 1, velocity = {velocity} }}
                shapes.b = {{ kind = 'circle', radius = 1, position = [4, 3] }}
                query = {{ kind = 'linear-sweep', of = ['a', 'b'] }}"
            ))
        };
        let cases = [
            ("[1, 0]", "; the motion ends at t = 1 while they still come nearer, 2.24 apart."),
            ("[8, 0]", "; they come closest at t = 0.5, 1 apart."),
            ("[-8, 0]", "; they are closest at the start, 3 apart."),
        ];
        for (velocity, expected) in cases {
            let said = passed(velocity);
            assert_eq!(said, format!("a and b do not touch{expected}"), "{velocity}");
        }
    }

    #[test]
    fn bodies_that_go_alike_stay_as_they_are() {
        let text = "shapes.a = { kind = 'circle', radius = 1, velocity = [1, 2] }
            shapes.b = { kind = 'circle', radius = 1, position = [4, 3], velocity = [1, 2] }
            query = { kind = 'time-of-impact', of = ['a', 'b'] }";
        assert_eq!(said(text), "a and b do not touch; they stay 3 apart.");
    }

    #[test]
    fn a_later_moment_is_said_with_what_is_so_then() {
        let text = |kind: &str| {
            format!(
                "shapes.a = {{ kind = 'circle', radius = 1, velocity = [1, 0] }}
                shapes.b = {{ kind = 'circle', radius = 1, position = [4, 0] }}
                query = {{ kind = '{kind}', of = ['a', 'b'], time = 0.5 }}"
            )
        };
        let said = |kind: &str| {
            let scene = open_text("later.toml", &text(kind)).unwrap().scene;
            let runs = Runs::default();
            let run = runs.own(&scene, 0.5);
            let told = Account::of(&scene, &runs, &run);
            (told.sentence(), told.result())
        };
        let apart = "a and b are 1.5 apart along the normal (1, 0).";
        assert_eq!(said("separation"), (format!("At t = 0.5 {apart}"), format!("at t = 0.5 {apart}")));
        assert_eq!(said("overlap").0, "At t = 0.5 a and b do not overlap: they are 1.5 apart.");
    }

    #[test]
    fn the_bound_of_two_bodies_is_of_their_ways_together() {
        let text = "shapes.a = { kind = 'circle', radius = 1, velocity = [3, 0] }
            shapes.b = { kind = 'circle', radius = 1, position = [4, 3], velocity = [-2, 0] }
            query = { kind = 'motion-bound', of = ['a', 'b'] }";
        assert_eq!(said(text), "No two points of a and b come nearer to each other by more than 5.");
    }
}
