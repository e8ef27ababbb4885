//! The question of a scene in words, with which a figure in steps begins.

use crate::collision::QueryKind;
use crate::scene::Scene;
use crate::trace::{Event, Voice, phrases};

use super::question::is_of_a_moment;

phrases! {
    /// For a box: the bodies.
    BOX: "Which axis-aligned box bounds *?",
        "Welche achsenparallele Box umschließt *?",
        "Quelle boîte alignée sur les axes englobe * ?",
        "¿Qué caja alineada con los ejes contiene *?";
    /// For a verdict.
    OVERLAP: "Do * overlap?", "Überlappen * sich?", "* se recouvrent-ils ?", "¿Se solapan *?";
    /// For the signed separation.
    SEPARATION: "How far apart are *, or how deep in each other?",
        "Wie weit sind * auseinander, oder wie tief ineinander?",
        "Quelle distance sépare *, ou de combien se recouvrent-ils ?",
        "¿A qué distancia están *, o cuánto se solapan?";
    /// For points of contact.
    CONTACT: "Where do * touch?", "Wo berühren sich *?", "Où * se touchent-ils ?", "¿Dónde se tocan *?";
    /// For the first contact.
    FIRST: "When do * first touch?",
        "Wann berühren sich * zuerst?",
        "Quand * se touchent-ils pour la première fois ?",
        "¿Cuándo se tocan * por primera vez?";
    /// For a bound on a motion.
    FARTHEST: "How far can a point of * move?",
        "Wie weit kann sich ein Punkt von * bewegen?",
        "De combien un point de * peut-il se déplacer ?",
        "¿Cuánto puede moverse un punto de *?";
    /// For one of two bodies.
    NEARER: "By how much can points of * come nearer to each other?",
        "Um wie viel können sich Punkte von * einander nähern?",
        "De combien des points de * peuvent-ils se rapprocher ?",
        "¿Cuánto pueden acercarse puntos de *?";
    /// Who answers: its name, and the moment where that is asked about.
    BY: "Algorithm: *.", "Algorithmus: *.", "Algorithme : *.", "Algoritmo: *.";
}

/// The question of a scene and the algorithm that an event names; of bodies that move with the moment, where
/// it is about one.
pub(super) fn sentences(scene: &Scene, event: &Event, voice: Voice) -> Vec<String> {
    let Event::Started { algorithm, at } = event else { return Vec::new() };
    let kind = scene.query.kind;
    let question = match kind {
        QueryKind::Bounds => &BOX,
        QueryKind::Overlap => &OVERLAP,
        QueryKind::Separation => &SEPARATION,
        QueryKind::Contact => &CONTACT,
        QueryKind::LinearSweep | QueryKind::TimeOfImpact => &FIRST,
        QueryKind::MotionBound if scene.query.of.len() > 1 => &NEARER,
        QueryKind::MotionBound => &FARTHEST,
    };
    let mut bodies = scene.query.of.iter().filter_map(|&i| scene.shapes.get(i));
    let is_of_many = at.time != 0.0 || bodies.any(|(_, body)| body.moves());
    let mut by = (*algorithm).to_owned();
    if is_of_many && is_of_a_moment(kind) {
        by = by + ", " + &voice.moment(at);
    }
    vec![voice.say(question, &[&voice.all()]), voice.say(&BY, &[&by])]
}

#[cfg(test)]
mod tests {
    use super::ALL;
    use crate::figure::{draw_in_steps, plan};
    use crate::scene::open_text;

    /// What the first step of a scene of two circles says.
    fn first(rest: &str) -> String {
        let text = format!(
            "shapes.ball = {{ kind = 'circle', radius = 1, velocity = [3, 0] }}
             shapes.wall = {{ kind = 'circle', radius = 2, position = [5, 0] }}\n{rest}"
        );
        let scene = open_text("s", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let steps = draw_in_steps(&plan, plan.theme, "s").drawing.steps;
        format!("{}: {}", steps[0].title, steps[0].sentences.join(" "))
    }

    #[test]
    fn a_figure_in_steps_begins_with_its_question() {
        let told = |rest: &str, expected: &str| assert_eq!(first(rest), expected);
        told(
            "query = { kind = 'linear-sweep', of = ['ball', 'wall'], algorithm = 'ray-cast' }",
            "The question: When do ball and wall first touch? Algorithm: ray-cast.",
        );
        told(
            "query = { kind = 'separation', of = ['ball', 'wall'], algorithm = 'circles', time = 0.5 }",
            "The question: How far apart are ball and wall, or how deep in each other? \
             Algorithm: circles, t = 0.5.",
        );
        told(
            "lang = 'de'\nquery = { kind = 'bounds', of = ['wall'] }",
            "Die Frage: Welche achsenparallele Box umschließt wall? Algorithmus: extremes.",
        );
    }

    #[test]
    fn every_phrase_has_as_many_stars_in_every_language() {
        assert_eq!(crate::trace::unlike(ALL.iter().copied()), [&[""; 4]; 0]);
    }
}
