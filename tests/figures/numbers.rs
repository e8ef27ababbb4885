//! A rounded pair that turns: every number that its figure says is the trace's.

use tracefig::collision::{Answer, Outcome};
use tracefig::figure::{draw, plan};
use tracefig::scene::{Scene, open_text};
use tracefig::trace::{Event, Trace};

use super::seen::Figure;

/// A capsule and a rounded box that move and turn, and texts that name values.
const PAIR: &str = r#"
[shapes.rod]
kind = "capsule"
points = [[-1.5, 0], [1, 0.25]]
radius = 0.5
angular_velocity_deg = 90
velocity = [1.5, 0]

[shapes.lid]
kind = "box"
half_extents = [0.75, 0.5]
radius = 0.25
position = [4, 0.5]
velocity = [-2, 0.25]
angular_velocity_deg = -45

[query]
kind = "time-of-impact"
of = ["rod", "lid"]
tolerance = 1e-6
ALGORITHM

[[panels]]
time = "start"
layers = [
  "shapes",
  "separation",
  { layer = "velocity", accent = "hit" },
  { layer = "note", lines = ["first {=bound}, touch {=time}", "apart {=separation}, $d = {=d}$"] },
]
"#;

/// A second panel, at the second step.
const STEP: &str = r#"
[[panels]]
step = 2
layers = ["shapes", "separation", { layer = "note", lines = ["at {=step.time}, then {=step.next}"] }]
"#;

/// The scene of the pair, by an algorithm or by the default one, and what its figure says.
fn drawn(algorithm: &str, panels: &str) -> (Scene, Figure) {
    let text = PAIR.replace("ALGORITHM", algorithm) + panels;
    let scene = open_text("pair.toml", &text).unwrap_or_else(|e| panic!("{e:?}")).scene;
    let plan = plan(&scene).unwrap_or_else(|e| panic!("{e:?}"));
    let figure = Figure::of(&draw(&plan, plan.theme, "pair").drawing);
    (scene, figure)
}

/// What the scene's own algorithm answers and tells.
fn told(scene: &Scene) -> (Answer, Vec<Event>) {
    let mut trace = Trace::default();
    let answer = (scene.query().algorithm.traced)(&scene.query_of_bodies(), &mut trace);
    (answer, trace.events)
}

/// Three digits, as a figure writes a plain number.
fn digits(x: f64) -> String {
    let decimals = if x >= 1.0 { 2 } else { 3 };
    format!("{x:.decimals$}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Time, separation and next time of every step.
fn steps(events: &[Event]) -> Vec<(f64, f64, Option<f64>)> {
    let step = |event: &Event| match *event {
        Event::Advanced { at, separation, next, .. } => Some((at.time, separation, next)),
        _ => None,
    };
    events.iter().filter_map(step).collect()
}

#[test]
fn labels_and_texts_of_a_rounded_turning_pair_say_the_numbers_of_the_trace() {
    let (scene, figure) = drawn("algorithm = \"conservative-advancement\"", STEP);
    let (answer, events) = told(&scene);
    let Answer::Impact(impact) = answer else { panic!("{answer:?}") };
    let Outcome::Hit { time, .. } = impact.outcome else { panic!("{impact:?}") };
    let steps = steps(&events);
    let [(_, start, Some(first)), (second_at, second, Some(third)), ..] = steps[..] else {
        panic!("{steps:?}")
    };
    let texts: Vec<&str> = figure.texts.iter().map(|(text, _)| text.as_str()).collect();
    let expected = [
        format!("first {}, touch {}", digits(first), digits(time.lo)),
        format!("apart {s}, $d = {s}$", s = digits(start)),
        format!("$d = {}$", digits(start)),
        format!("$t = {}$", digits(time.lo)),
        format!("at {}, then {}", digits(second_at), digits(third)),
        format!("$d = {}$", digits(second)),
    ];
    for line in &expected {
        assert!(texts.contains(&line.as_str()), "{line:?} is not among {texts:?}");
    }
}

#[test]
fn the_bound_is_that_of_the_advancement_whichever_algorithm_answers() {
    let (scene, _) = drawn("algorithm = \"conservative-advancement\"", "");
    let first = steps(&told(&scene).1)[0].2.unwrap();
    let (scene, figure) = drawn("", "");
    let (_, events) = told(&scene);
    assert!(steps(&events).is_empty(), "the default takes no such steps");
    let says = |(text, _): &(String, _)| text.starts_with(&format!("first {}, ", digits(first)));
    assert!(figure.texts.iter().any(says), "{first} is not among {:?}", figure.texts);
}
