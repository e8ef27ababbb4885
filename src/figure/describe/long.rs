//! The long text: a paragraph.

use std::fmt::Write;

use crate::figure::question::is_found_on_the_difference;
use crate::figure::runs::Run;
use crate::figure::text::plain;
use crate::geometry::Body;
use crate::scene::{Panel, Scene, Space, Spanned, When};
use crate::trace::Event;
use crate::trace::told::is_by_component;

use super::body::{body_in_words, kind_in_words};
use super::number::value;
use super::result::Account;

/// A paragraph for `desc`: the bodies, the question, the answer, the steps, the panels.
pub(crate) fn long((scene, run): (&Scene, &Run), told: &Account, panels: &[&Panel]) -> String {
    let mut text = String::new();
    for &index in &scene.query.of {
        if let Some((name, body)) = scene.shapes.get(index) {
            let _ = write!(text, "{} ", body_in_words(&name.value, body));
        }
    }
    text.push_str(&bystanders(scene));
    let _ = write!(text, "{} ", told.sentence());
    text.push_str(&steps(scene, run));
    text.push_str(&shown(scene, panels));
    text.trim_end().to_owned()
}

/// The bodies that the query is not about, by name and kind; empty where there are none.
fn bystanders(scene: &Scene) -> String {
    let others = scene.shapes.iter().enumerate().filter(|(i, _)| !scene.query.of.contains(i));
    let named = |(_, (name, body)): (usize, &(Spanned<String>, Body))| {
        format!("{} ({})", name.value, kind_in_words(body))
    };
    let all: Vec<String> = others.map(named).collect();
    if all.is_empty() { String::new() } else { format!("Beside, and asked nothing: {}. ", all.join(", ")) }
}

/// How the answer was found: the algorithm, and how many steps or edges it took.
fn steps(scene: &Scene, run: &Run) -> String {
    let algorithm = scene.query.algorithm.name;
    let advanced = run.events().filter(|e| matches!(e, Event::Advanced { .. })).count();
    let grown = run
        .events()
        .filter(|e| matches!(e, Event::SimplexUpdated { .. } | Event::PolytopeExpanded { .. }))
        .count();
    let edges = run.events().filter(|e| matches!(e, Event::DifferenceEdgeFound { .. })).count();
    match (is_found_on_the_difference(run.kind), advanced + grown, edges) {
        (_, 1, _) => format!("Found by {algorithm} in 1 step. "),
        (_, steps @ 2.., _) => format!("Found by {algorithm} in {steps} steps. "),
        (true, _, 1..) if !run.events().any(is_by_component) => {
            format!("Found by {algorithm} among the {edges} edges of the Minkowski difference. ")
        }
        _ => format!("Found by {algorithm}. "),
    }
}

/// What each panel shows: its space, its moment, its layers by name.
pub(crate) fn shown(scene: &Scene, panels: &[&Panel]) -> String {
    let mut text = String::new();
    let many = panels.len() > 1;
    for (i, panel) in panels.iter().enumerate() {
        let title = panel.title.as_ref().map_or(String::new(), |t| format!(" ({})", plain(&t.value)));
        let which = if many { format!("Panel {}{title}", i + 1) } else { format!("The picture{title}") };
        let layers: Vec<&str> = panel.layers.iter().flatten().map(|l| l.name.value.as_str()).collect();
        if layers.is_empty() {
            let _ = write!(text, "{which} shows nothing. ");
            continue;
        }
        let _ = write!(text, "{which} shows {}{}: {}", space(scene, panel), when(panel), layers.join(", "));
        text.push_str(if panel.inset.is_some() { "; with a detail enlarged. " } else { ". " });
    }
    text
}

/// What a panel shows, as "the world".
fn space(scene: &Scene, panel: &Panel) -> String {
    match panel.space {
        Space::World => "the world".to_owned(),
        Space::Configuration => "configuration space".to_owned(),
        Space::Body(body) => {
            let (name, turned) = scene.shapes.get(body).map_or(("", false), |(name, body)| {
                (&name.value, body.angle_at(0.0) != 0.0 || !body.spin.is_zero())
            });
            // The answer has told of directions before.
            let whose = if turned { " (the answer's directions are the world's)" } else { "" };
            format!("the frame of {name}{whose}")
        }
    }
}

/// A panel's moment, as " at the start"; empty where the scene names none.
fn when(panel: &Panel) -> String {
    panel.when.as_ref().map_or(String::new(), |when| match when.value {
        When::Time(t) => format!(" at t = {}", value(t)),
        When::Start => " at the start".to_owned(),
        When::Hit => " at the first contact".to_owned(),
        When::Closest => " at the closest approach".to_owned(),
        When::Bound => " at the bound of the first step".to_owned(),
        When::End => " at the end".to_owned(),
        When::Step(k) => format!(" in step {k}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::runs::Runs;
    use crate::scene::open_text;

    /// The paragraph of a scene.
    fn told(text: &str) -> String {
        let scene = open_text("long.toml", text).unwrap().scene;
        let runs = Runs::default();
        let run = runs.own(&scene, 0.0);
        long((&scene, &run), &Account::of(&scene, &runs, &run), &[])
    }

    #[test]
    fn an_algorithm_by_components_looks_at_no_edges() {
        let told = told(
            "shapes.a = { kind = 'aabb', half_extents = [1, 1] }
            shapes.b = { kind = 'aabb', half_extents = [1, 1], position = [3, 0] }
            query = { kind = 'separation', of = ['a', 'b'], algorithm = 'extents' }",
        );
        assert!(told.ends_with("Found by extents."), "{told}");
    }
}
