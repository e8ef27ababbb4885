//! Which questions have a value, and by which algorithms, found by asking them all of some bodies.

use std::collections::{BTreeMap, BTreeSet};

use crate::collision::{ALGORITHMS, QUERIES};
use crate::figure::context::Context;
use crate::figure::play::Play;
use crate::figure::runs::Runs;
use crate::scene::{Scene, SceneQuery, Space, open_text};

use super::text::{value_of, values};

/// Bodies, of which each pair is asked: round, along the axes, and turned.
const BODIES: [&str; 3] = [
    "kind = 'circle', radius = 1",
    "kind = 'aabb', half_extents = [1, 0.7]",
    "kind = 'box', half_extents = [1, 0.7], angle_deg = 20",
];

/// Where the second body is, and how the first one goes: apart, overlapping, hitting, missing.
const CASES: [(&str, &str); 4] =
    [("3", "velocity = [0, 0]"), ("0.8", "velocity = [0, 0]"), ("3", "velocity = [4, 0]"), ("3", TURNING)];
/// A motion that turns; a body along the axes can't.
const TURNING: &str = "velocity = [0.1, 0], angular_velocity_deg = 40";

/// Places of questions and algorithms in their tables.
type Asked = BTreeSet<(usize, usize)>;

/// The questions that have each value of texts, as a clause, in the order of
/// [`values`](crate::figure::values).
///
/// ```
/// let questions = tracefig::figure::askers();
/// let arc = tracefig::figure::values().zip(&questions).find(|((name, _), _)| *name == "L").unwrap();
/// assert_eq!(arc.1, "`motion-bound`");
/// ```
#[must_use]
pub fn askers() -> Vec<String> {
    let (mut found, mut all): (BTreeMap<_, Asked>, Asked) = (BTreeMap::new(), Asked::new());
    for scene in pairs() {
        let (space, runs) = (Space::World, Runs::default());
        let context =
            Context { scene: &scene, space: &space, time: 0.0, step: None, play: Play::No, runs: &runs };
        // Of the first step, if there are any.
        let in_steps = Context { step: Some(1), ..context };
        for (who, asked) in questions(&scene) {
            all.insert(who);
            for (name, _) in values() {
                let has = |context: &Context| value_of(name, context).is_some();
                if context.where_asked(&asked, has) || in_steps.where_asked(&asked, has) {
                    found.entry(name).or_default().insert(who);
                }
            }
        }
    }
    let none = Asked::new();
    values().map(|(name, _)| clause(found.get(name).unwrap_or(&none), &all)).collect()
}

/// Pairs of bodies, as scenes.
fn pairs() -> impl Iterator<Item = Scene> {
    let all = BODIES.into_iter().flat_map(|a| BODIES.map(|b| (a, b)));
    all.flat_map(|(a, b)| CASES.map(|case| (a, b, case))).filter_map(|(a, b, (x, motion))| {
        let text = format!(
            "shapes.A = {{ {a}, {motion} }}\nshapes.B = {{ {b}, position = [{x}, 0.2] }}
            query = {{ kind = '{}', of = ['A', 'B'] }}",
            QUERIES.first()?.word
        );
        Some(open_text("values.toml", &text).ok()?.scene)
    })
}

/// The scene with each question, of one body and of both, by each algorithm that takes it.
fn questions(scene: &Scene) -> impl Iterator<Item = ((usize, usize), Scene)> {
    let all =
        (0..QUERIES.len()).flat_map(|q| (0..ALGORITHMS.len()).flat_map(move |a| [(q, a, 1), (q, a, 2)]));
    all.filter_map(|(q, a, count)| {
        let of = scene.query.of.get(..count)?.to_vec();
        let query =
            SceneQuery { kind: QUERIES[q].kind, algorithm: &ALGORITHMS[a], of, ..scene.query.clone() };
        let asked = Scene { query, ..scene.clone() };
        asked.query.algorithm.takes(&asked.query_of_bodies()).then_some(((q, a), asked))
    })
}

/// Questions in words, with their algorithms where those are not all that `could`.
fn clause(asked: &Asked, could: &Asked) -> String {
    if asked == could {
        return "any question".to_owned();
    }
    let of = |set: &Asked, question: usize| -> Vec<String> {
        let own = set.iter().filter(|who| who.0 == question);
        own.map(|who| format!("`{}`", ALGORITHMS[who.1].name)).collect()
    };
    let in_words = |(question, row): (usize, &crate::collision::Question)| {
        let by = of(asked, question);
        match by.len() {
            0 => None,
            count if count == of(could, question).len() => Some(format!("`{}`", row.word)),
            _ => Some(format!("`{}` by {}", row.word, by.join(" or "))),
        }
    };
    QUERIES.iter().enumerate().filter_map(in_words).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_is_of_the_questions_that_have_it() {
        let found = askers();
        let of = |name: &str| {
            let at = values().position(|(known, _)| known == name).unwrap();
            found[at].as_str()
        };
        assert!(found.iter().all(|clause| !clause.is_empty()), "{found:?}");
        for (name, questions) in [
            ("d", "any question"),
            ("min.x", "`bounds`"),
            ("hit.n.x", "`linear-sweep`, `time-of-impact`"),
            ("closest.time", "`linear-sweep`, `time-of-impact`"),
            ("radii", "`overlap` by `circles`, `separation` by `circles`"),
            ("D", "`overlap` by `extents` or `clamp`, `separation` by `extents` or `clamp`"),
            ("step.next", "`linear-sweep` by `ray-clipping`, `time-of-impact` by `conservative-advancement`"),
        ] {
            assert_eq!(of(name), questions, "{name}");
        }
    }
}
