//! What `solve` says of a scene: the answer, and what follows from it that no algorithm works out unasked.

use serde_json::Value;

use super::Scene;
use super::answer::{answer_json, lines, object};
use crate::collision::answer::Part;
use crate::collision::{Answer, ClosestApproach, Off, QueryKind, closest_approach};
use crate::geometry::Names;

/// The answer to a scene, how near a miss came, and how far off someone else's answer is.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// What was asked.
    pub kind: QueryKind,
    /// The algorithm's answer.
    pub answer: Answer,
    /// How near the bodies came, where the answer is a miss.
    pub closest: Option<ClosestApproach>,
    /// How far off what the scene expects is, where it says that.
    pub off: Option<Off>,
}

impl Solution {
    /// Answers a scene by its algorithm, in world units.
    ///
    /// ```
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 1\nvelocity = [8, 0]\n\
    ///     [shapes.B]\nkind = 'circle'\nradius = 1\nposition = [2, 3]\n\
    ///     [query]\nkind = 'linear-sweep'\nof = ['A', 'B']";
    /// let solution = tracefig::scene::Solution::of(&tracefig::scene::open_text("s.toml", text)?.scene);
    /// assert_eq!(solution.closest.unwrap().contact.separation, 1.0);
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        Self::told(scene, scene.query.algorithm.ask(&scene.query_of_bodies()))
    }

    /// What follows from an answer to the scene's question that is known.
    pub(crate) fn told(scene: &Scene, answer: Answer) -> Self {
        let query = scene.query_of_bodies();
        let closest = closest_approach(&query, &answer);
        let off = scene.query.expected.and_then(|theirs| theirs.off(&query, &answer, closest.as_ref()));
        Self { kind: query.kind, answer, closest, off }
    }

    /// The `result` of the format, as `solve --json` and `solve --jsonl` print it.
    ///
    /// ```
    /// use tracefig::scene::{Solution, open_text};
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'motion-bound'\nof = ['A']";
    /// let json = Solution::of(&open_text("s.toml", text)?.scene).json();
    /// assert_eq!(json.to_string(), r#"{"kind":"motion-bound","bound":0.0}"#);
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn json(&self) -> Value {
        let mut result = answer_json(self.kind, &self.answer);
        if let Value::Object(fields) = &mut result {
            let closest = self.closest.map(|closest| ("closest", closest.parts()));
            let off = self.off.map(|off| ("off", off.parts()));
            let more = [closest, off].into_iter().flatten();
            fields.extend(more.map(|(name, parts)| (name.to_owned(), object(parts))));
        }
        result
    }

    /// The kind of the query, with the outcome or the verdict where its answers have one: `separation`,
    /// `linear-sweep hit`, `overlap unknown`.
    ///
    /// ```
    /// use tracefig::scene::{Solution, open_text};
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'motion-bound'\nof = ['A']";
    /// assert_eq!(Solution::of(&open_text("s.toml", text)?.scene).outcome(), "motion-bound");
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn outcome(&self) -> String {
        let kind = self.kind.word();
        match self.answer.parts().first() {
            Some((_, Part::Word(word))) => format!("{kind} {word}"),
            Some((_, Part::Verdict(verdict))) => {
                format!("{kind} {}", verdict.map_or("unknown", |yes| if yes { "true" } else { "false" }))
            }
            _ => kind.to_owned(),
        }
    }

    /// A line for each part of it, for people; the name of the part first. World units; bodies are called
    /// `names`.
    ///
    /// ```
    /// use tracefig::scene::{Solution, open_text};
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'motion-bound'\nof = ['A']";
    /// let scene = open_text("s.toml", text)?.scene;
    /// let text = Solution::of(&scene).text(&scene.names());
    /// assert_eq!(text.split_whitespace().collect::<Vec<_>>(), ["bound", "0"]);
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn text(&self, names: &Names) -> String {
        lines(&self.json(), names)
    }
}
