//! Every event in every language, with the same values in the same order.

use super::phrases::events::OUTCOMES;
use super::{Voice, all_phrases, growth, sentence_in, step, told};
use crate::geometry::{DVec2, Enclosure, Feature, Names, Side};
use crate::trace::tongue::{Tongue, unlike};
use crate::trace::{Culling, EVENTS, Event, Goal, Moment, SupportVertex};

/// Parts of an event, of which those with most have six.
const PARTS: usize = 6;

const P: DVec2 = DVec2::new(1.5, -2.0);
const Q: DVec2 = DVec2::new(3.0, 0.25);
const EDGE: (Side, Feature) = (Side::B, Feature::Edge(3));
const SPAN: Enclosure = Enclosure { lo: 0.5, hi: 2.5 };

fn vertices(count: usize) -> Vec<SupportVertex> {
    (0..count).map(|index| SupportVertex { index, point: P + 0.25 * Q }).collect()
}

/// Events of bodies that stand, of each kind and in each way that a sentence has.
fn of_standing() -> Vec<Event> {
    let at = Moment { time: 0.5, angle_a: 30.0, angle_b: -4.0 };
    let circles = |early_out| Event::CirclesCompared {
        centers: [P, Q],
        radii: [1.0, 2.5],
        distance_squared: 6.5,
        radii_squared: 12.25,
        early_out,
    };
    let bounds = |of| Event::BoundsFound { of, min: P, max: Q, touching: [1, 2, 1, 2].map(vertices) };
    let support = |count| Event::SupportFound { body: Side::B, direction: P, vertices: vertices(count) };
    let edge = |distance| Event::DifferenceEdgeFound {
        source: Side::A,
        edge: 2,
        vertex: 1,
        from: P,
        to: Q,
        normal: P,
        distance,
    };
    let merged = |other| Event::EdgesMerged { taken: Side::A, at: P, edge: Q, other };
    let rounded = |center| Event::DifferenceRounded { center, radius: 2.5 };
    let projected = |distance| Event::OriginProjected { foot: P, distance };
    let improved = |goal| Event::CandidateImproved { goal, distance: 2.5, foot: P, source: EDGE };
    let axis = |gap| Event::AxisTested { axis: P, source: EDGE, interval_a: SPAN, interval_b: SPAN, gap };
    let clamped =
        Event::Clamped { body: Side::A, v: P, half_extents: Q, clamped: Q, closest: P, d: Q, radius: 0.5 };
    vec![
        Event::Started { algorithm: "any", at },
        circles(true),
        circles(false),
        Event::PenetrationMeasured { p: -0.5, direction: P, vector: Q },
        bounds(None),
        bounds(Some(Side::B)),
        clamped,
        support(1),
        support(2),
        edge(0.5),
        edge(-0.5),
        merged(Some(P)),
        merged(None),
        rounded(Some(P)),
        rounded(None),
        projected(0.5),
        projected(-0.5),
        improved(Goal::LeastPositive),
        improved(Goal::LeastPenetrating),
        axis(0.5),
        axis(-0.5),
        Event::SeparatingAxisFound { normal: P, gap: 0.5 },
    ]
}

/// Events of searches and contacts.
fn of_searches() -> Vec<Event> {
    let simplex = |count, closest| Event::SimplexUpdated { vertices: vec![P; count], closest, direction: Q };
    let polytope = |beyond| Event::PolytopeExpanded {
        vertices: vec![P; 4],
        nearest: 0.5,
        edge: 1,
        normal: P,
        support: Q,
        beyond,
    };
    let faced = Event::EdgesFaced {
        body: Side::A,
        reference: Feature::Edge(1),
        incident: Feature::Vertex(2),
        from: P,
        to: Q,
        normal: P,
        ends: [P, Q],
    };
    let found = |touches| Event::ContactFound {
        points: [P, Q],
        separation: if touches { -0.5 } else { 0.5 },
        features: [Feature::Edge(0); 2],
        touches,
    };
    let finished = OUTCOMES.map(|[outcome, ..]| Event::Finished { outcome });
    let all = [
        simplex(1, P),
        simplex(2, Q),
        simplex(3, DVec2::ZERO),
        polytope(0.5),
        polytope(0.0),
        faced,
        Event::EdgeCut { plane: P, end: Q, at: P },
        found(true),
        found(false),
    ];
    all.into_iter().chain(finished).collect()
}

/// Events of bodies that move.
fn of_moving() -> Vec<Event> {
    let ray = |outcome, time| Event::RayClipped { source: EDGE, from: P, to: Q, outcome, time };
    let advanced = |bound, next| Event::Advanced {
        step: 3,
        at: Moment { time: 0.25, angle_a: 0.0, angle_b: 0.0 },
        separation: 1.5,
        normal: P,
        points: [P, Q],
        closest: P,
        estimate: Q,
        closing_speed: 2.0,
        bound,
        next,
    };
    let closest = |time| Event::ClosestApproachFound {
        at: Moment { time, angle_a: 0.0, angle_b: 0.0 },
        separation: 1.5,
        bounds: Enclosure { lo: time + 0.25, hi: 2.5 },
        normal: P,
        points: [P, Q],
    };
    let expected = |some: Option<f64>| Event::ExpectationCompared {
        size: 2.0,
        outcome: some.map(|_| ["miss", "hit"]),
        separation: some,
        time: some,
        normal_deg: some,
        points: some.map(|x| [x, 2.0 * x]),
    };
    let turned = Event::MotionBounded {
        body: Side::A,
        radius: 2.5,
        theta: 0.5,
        arc: 1.25,
        linear: 3.0,
        vertices: vertices(2),
    };
    vec![
        ray(Culling::BackFacing, None),
        ray(Culling::Missed, None),
        ray(Culling::Hit, Some(0.5)),
        advanced(2.0, None),
        advanced(2.5, Some(0.75)),
        Event::AxisSwept { from: 0.0, to: 0.5, owner: Side::B, normal: P },
        closest(0.0),
        closest(0.5),
        closest(1.0),
        expected(None),
        expected(Some(0.5)),
        turned,
    ]
}

fn all() -> Vec<Event> {
    [of_standing(), of_searches(), of_moving()].concat()
}

/// The numbers and names of a text, in their order.
fn values(text: &str) -> Vec<&str> {
    let words = text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '.' | '-' | '_')));
    let words = words.map(|word| word.trim_end_matches('.'));
    words.filter(|word| word.starts_with("it_") || word.contains(|c: char| c.is_ascii_digit())).collect()
}

/// Every text that a voice says.
fn said(voice: Voice) -> Vec<String> {
    let events = all();
    let mut texts: Vec<String> = events.iter().map(|event| sentence_in(event, voice)).collect();
    for event in &events {
        for part in 0..PARTS {
            texts.push(step::title(event, part, voice));
            texts.push(step::sentence_of_part(event, part, voice));
        }
    }
    texts.push(step::title_at(0.5, voice));
    texts.extend([false, true].map(|is_given| step::sentence_of_difference(7, is_given, voice)));
    for k in 0..events.len() {
        texts.extend(growth::title(&events[..k], &events[k], &events[k + 1..], voice));
        texts.extend(growth::title(&[], &events[k], &events[k + 1..], voice));
    }
    let row = |event: usize| (0..8).map(move |_| event);
    let edge = events.iter().position(|event| matches!(event, Event::DifferenceEdgeFound { .. })).unwrap();
    let ray = events.iter().position(|event| matches!(event, Event::RayClipped { .. })).unwrap();
    for rows in [row(edge).chain([edge + 8]).collect::<Vec<_>>(), vec![ray; 7]] {
        texts.extend(told::way(rows.iter().map(|&k| &events[k]), voice, true));
    }
    texts
}

#[test]
fn the_events_here_are_of_every_kind_but_those_that_are_formulas() {
    let kinds: Vec<String> = all().iter().map(|event| format!("{event:?} ")).collect();
    let lacks = |name: &&str| !kinds.iter().any(|kind| kind.starts_with(&format!("{name} ")));
    let lacking: Vec<&str> = EVENTS.iter().map(|kind| kind.variant).filter(lacks).collect();
    assert_eq!(lacking, ["ExtentsCompared"]);
}

#[test]
fn each_is_told_in_every_language_with_its_values_and_in_words_of_its_own() {
    let names = Names::new("it_a", Some("it_b"));
    let english = said(Voice::english(&names));
    for column in 1..4 {
        let told = said(Voice { tongue: Tongue::new(column, false), ..Voice::english(&names) });
        assert_eq!(told.len(), english.len());
        for (ours, theirs) in english.iter().zip(&told) {
            assert_eq!(values(ours), values(theirs), "{ours}\n{theirs}");
            let is_formula = ours.starts_with("p = ") || ours == "it_b ⊖ it_a";
            let is_alike = ["La question", "La pénétration"].contains(&theirs.as_str());
            assert!(ours != theirs || is_formula || is_alike, "{ours}");
            assert!(!theirs.contains('*'), "{theirs}");
        }
    }
}

#[test]
fn phrases_have_as_many_values_in_every_language() {
    assert_eq!(unlike(all_phrases()), [&[""; 4]; 0]);
}

#[test]
fn a_sentence_in_german_has_commas_and_semicolons() {
    let names = Names::new("A", Some("B"));
    let german = Voice { tongue: Tongue::new(1, true), ..Voice::english(&names) };
    let cut = Event::EdgeCut { plane: P, end: Q, at: P };
    assert_eq!(
        sentence_in(&cut, german),
        "Die Ebene bei (1,5; -2) schneidet das Ende (3; 0,25) ab: Die Kante endet nun bei (1,5; -2)."
    );
}
