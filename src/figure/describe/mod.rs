//! Figures in words: a short text for `alt`, a long one for `desc` and for readers who do not see the picture.
//!
//! Both are generated from the scene, the answer and the trace: what is there, where it is, what was asked, the result
//! with its number, how many steps it took, and what each panel shows. Words only: formulas are read out as they would
//! be written in running text.

use std::fmt::Write;

use crate::collision::{Answer, Impact, Outcome, Reason};
use crate::figure::question::is_found_on_the_difference;
use crate::figure::runs::Run;
use crate::figure::text::{in_words, plain, rounded};
use crate::geometry::shape::KINDS;
use crate::geometry::{Body, DVec2};
use crate::scene::{Scene, Space, When};
use crate::trace::Event;

/// One sentence for `alt`: the title, and the result with its number.
#[must_use]
pub(crate) fn short(scene: &Scene, run: &Run) -> String {
    let result = result(scene, run);
    match &scene.title {
        Some(title) => format!("{}: {result}", plain(&title.value)),
        None => capitalized(&result),
    }
}

/// A paragraph for `desc`: the bodies, the question, the answer, the steps, the panels.
#[must_use]
pub(crate) fn long(scene: &Scene, run: &Run) -> String {
    let mut text = String::new();
    for &index in &scene.query.of {
        if let Some((name, body)) = scene.shapes.get(index) {
            let _ = write!(text, "{} ", body_in_words(&name.value, body));
        }
    }
    let _ = write!(text, "{} ", capitalized(&result(scene, run)));
    text.push_str(&steps(scene, run));
    text.push_str(&panels(scene));
    text.trim_end().to_owned()
}

fn name(scene: &Scene, which: usize) -> &str {
    scene.query.of.get(which).and_then(|&i| scene.shapes.get(i)).map_or("", |(name, _)| &name.value)
}

/// A number lying between two others, to three digits.
fn number(lo: f64, hi: f64) -> String {
    plain(&in_words(&rounded(lo, hi)))
}

fn value(v: f64) -> String {
    number(v, v)
}

/// A coordinate this much smaller than the other one is rounding, far below what three digits or an eye tell.
const NOTHING_BESIDE: f64 = 1e-12;

fn point(p: DVec2) -> String {
    let least = NOTHING_BESIDE * p.abs().max_element();
    let [x, y] = [p.x, p.y].map(|c| value(if c.abs() < least { 0.0 } else { c }));
    format!("({x}, {y})")
}

fn capitalized(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn body_in_words(name: &str, body: &Body) -> String {
    let shape = &body.shape;
    let kind = KINDS.iter().find(|kind| kind.name == shape.kind);
    let mut text = format!("{name} is {}", kind.map_or(shape.kind, |kind| kind.in_words));
    if kind.is_some_and(|kind| kind.fields.iter().any(|field| field.name == "vertices")) {
        let _ = write!(text, " of {} corners", shape.vertices.len());
    }
    if let Some(h) = body.shape.half_extents {
        let _ = write!(text, " of {} by {}", value(2.0 * h.x), value(2.0 * h.y));
    }
    if body.shape.radius > 0.0 {
        let _ = write!(text, " of radius {}", value(body.shape.radius));
    }
    let _ = write!(text, " at {}", point(middle(body)));
    if body.angle.0 != 0.0 {
        let _ = write!(text, ", turned by {}°", value(body.angle.0));
    }
    if body.velocity != DVec2::ZERO {
        let _ = write!(text, ", moving by {}", point(body.velocity));
    }
    if body.spin.0 != 0.0 {
        let _ = write!(text, ", turning by {}°", value(body.spin.0));
    }
    text.push('.');
    text
}

/// The mean of a body's vertices at t = 0, which says where it is better than an origin outside it.
fn middle(body: &Body) -> DVec2 {
    #[expect(clippy::cast_precision_loss, reason = "a count of corners is far below 2^53")]
    let count = body.shape.vertices.len().max(1) as f64;
    body.pose_at(0.0).point(body.shape.vertices.iter().copied().sum::<DVec2>() / count)
}

/// The result as a sentence without a capital.
fn result(scene: &Scene, run: &Run) -> String {
    let (a, b) = (name(scene, 0), name(scene, 1));
    match &run.answer {
        Answer::Bounds(bounds) => format!(
            "the bounding box of {a}{} reaches from {} to {}.",
            if b.is_empty() { String::new() } else { format!(" and {b}") },
            point(bounds.min),
            point(bounds.max)
        ),
        Answer::Overlap(overlap) => match overlap.overlap {
            Some(true) => format!("{a} and {b} overlap."),
            Some(false) => format!("{a} and {b} do not overlap."),
            None => format!("rounding forbids to say whether {a} and {b} overlap."),
        },
        Answer::Separation(s) => {
            let (lo, hi) = (s.bounds.lo, s.bounds.hi);
            if lo > 0.0 {
                format!("{a} and {b} are {} apart along the normal {}.", number(lo, hi), point(*s.normal))
            } else if hi < 0.0 {
                let depth = number(-hi, -lo);
                format!(
                    "{a} and {b} overlap; the shortest push that parts them is {depth} along {}.",
                    point(*s.normal)
                )
            } else {
                format!("{a} and {b} touch.")
            }
        }
        Answer::Impact(impact) => impact_in_words(a, b, impact),
        Answer::MotionBound(found) => {
            let pair = if b.is_empty() { a.to_owned() } else { format!("{a} and {b}") };
            format!("no point of {pair} travels farther than {}.", value(found.bound))
        }
    }
}

fn impact_in_words(a: &str, b: &str, impact: &Impact) -> String {
    match &impact.outcome {
        Outcome::Hit { time, contact } => format!(
            "{a} first touches {b} at t = {}, at {}.",
            number(time.lo, time.hi),
            point((contact.points[0] + contact.points[1]) / 2.0)
        ),
        Outcome::Miss => format!("{a} and {b} do not touch."),
        Outcome::Overlapping { .. } => format!("{a} and {b} touch or overlap from the start."),
        Outcome::Unresolved { reason, free_until } => {
            let why = match reason {
                Reason::WithinRounding => "rounding forbids more",
                Reason::WithinTolerance => "they come within the tolerance",
                Reason::IterationLimit => "the step cap was reached",
                Reason::Stalled => "the steps no longer advanced",
            };
            format!(
                "{a} and {b} are apart until t = {}; whether they touch is undecided: {why}.",
                value(*free_until)
            )
        }
    }
}

/// How the answer was found.
fn steps(scene: &Scene, run: &Run) -> String {
    let algorithm = scene.query.algorithm.name;
    let advanced = run.events().filter(|e| matches!(e, Event::Advanced { .. })).count();
    let edges = run.events().filter(|e| matches!(e, Event::DifferenceEdgeFound { .. })).count();
    match (is_found_on_the_difference(run.kind), advanced, edges) {
        (_, 1, _) => format!("Found by {algorithm} in 1 step. "),
        (_, 2.., _) => format!("Found by {algorithm} in {advanced} steps. "),
        (true, _, 1..) => {
            format!("Found by {algorithm} among the {edges} edges of the Minkowski difference. ")
        }
        _ => format!("Found by {algorithm}. "),
    }
}

fn panels(scene: &Scene) -> String {
    let mut text = String::new();
    let many = scene.panels.len() > 1;
    for (i, panel) in scene.panels.iter().enumerate() {
        let space = match panel.space {
            Space::World => "the world".to_owned(),
            Space::Configuration => "configuration space".to_owned(),
            Space::Body(body) => {
                format!("the frame of {}", scene.shapes.get(body).map_or("", |(name, _)| &name.value))
            }
        };
        let title = panel.title.as_ref().map_or(String::new(), |t| format!(" ({})", plain(&t.value)));
        let which = if many { format!("Panel {}{title}", i + 1) } else { format!("The picture{title}") };
        let when = panel.when.as_ref().map_or(String::new(), |when| match when.value {
            When::Time(t) => format!(" at t = {}", value(t)),
            When::Start => " at the start".to_owned(),
            When::Hit => " at the first contact".to_owned(),
            When::End => " at the end".to_owned(),
            When::Step(k) => format!(" in step {k}"),
        });
        let layers: Vec<&str> = panel.layers.iter().map(|l| l.name.value.as_str()).collect();
        let _ = write!(text, "{which} shows {space}{when}: {}. ", layers.join(", "));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_that_is_rounding_reads_as_zero() {
        assert_eq!(point(DVec2::new(1.5, -1.12e-16)), "(1.5, 0)");
        assert_eq!(point(DVec2::new(1.5e-13, -1.12e-16)), "(1.5 × 10^−13, −1.12 × 10^−16)");
    }
}
