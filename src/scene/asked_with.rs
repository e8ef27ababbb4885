//! A scene's question, asked otherwise: at another moment, by another algorithm; held to what a file may say.

use super::asked::{count, entries_of, list, node, number, text};
use super::body::Read;
use super::problem::{Problem, Problems};
use super::{Scene, SceneQuery, Value, question};

impl Scene {
    /// The scene with its question asked otherwise, by a key of `[query]`: `algorithm`, `time`, `tolerance`
    /// (world units) or `max_iterations`.
    ///
    /// # Errors
    /// What a scene file with this key would be refused for: a number out of its range, an algorithm that
    /// does not take the question.
    ///
    /// ```
    /// use tracefig::collision::QueryKind;
    /// use tracefig::geometry::{Body, DVec2, Shape};
    /// use tracefig::scene::{Refused, Scene, Value};
    /// let block = |x| Ok::<_, Box<dyn std::error::Error>>(Body::at_rest(
    ///     Shape::rectangle(DVec2::ONE)?,
    ///     DVec2::new(x, 0.0),
    /// ));
    /// let scene = Scene::asking(QueryKind::Separation, &[("A", block(0.0)?), ("B", block(4.0)?)])
    ///     .map_err(Refused::from)?;
    /// let by_gjk = scene.clone().asked_with("algorithm", &Value::Text("gjk".to_owned()));
    /// assert_eq!(by_gjk.map_err(Refused::from)?.query().algorithm.name, "gjk");
    /// let wrong = scene.asked_with("algorithm", &Value::Text("circles".to_owned())).unwrap_err();
    /// assert_eq!(wrong[0].fault.code(), "unsuited-algorithm");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn asked_with(self, key: &str, value: &Value) -> Result<Self, Vec<Problem>> {
        let mut problems = Problems::default();
        let read: Vec<Read> = self
            .shapes
            .iter()
            .map(|(name, body)| Read { name: name.clone(), body: Some(body.clone()) })
            .collect();
        let query = &self.query;
        let names = query.of.iter().filter_map(|&i| self.shapes.get(i)).map(|(name, _)| text(&name.value));
        let mut entries = vec![
            ("kind", text(query.kind.word())),
            ("of", list(names.collect())),
            ("algorithm", text(query.algorithm.name)),
            ("tolerance", number(query.tolerance)),
            ("max_iterations", number(count(query.max_iterations))),
        ];
        // Only questions about one moment have one.
        if query.time != 0.0 {
            entries.push(("time", number(query.time)));
        }
        entries.retain(|(known, _)| *known != key);
        entries.push((key, node(value)));
        match question::read(&entries_of(entries), &read, &mut problems) {
            Some(asked) if problems.is_empty() => {
                let expected = self.query.expected;
                Ok(Self { query: SceneQuery { expected, ..asked }, ..self })
            }
            _ => Err(problems.into_sorted()),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Value;
    use crate::scene::set::tests::made;

    #[test]
    fn a_question_is_asked_otherwise_as_a_file_would() {
        let made = made();
        let with = |key: &str, value: &Value| made.clone().asked_with(key, value);
        let later =
            with("time", &Value::Number(0.5)).unwrap().asked_with("tolerance", &Value::Number(1e-6)).unwrap();
        assert_eq!((later.query.time, later.query.tolerance), (0.5, 1e-6));
        assert_eq!(later.query.max_iterations, made.query.max_iterations);
        for (key, value) in [
            ("time", Value::Number(1.5)),
            ("tiem", Value::Number(0.5)),
            ("algorithm", Value::Number(1.0)),
            ("algorithm", Value::Text("circles".to_owned())),
            ("max_iterations", Value::Number(0.5)),
            ("of", Value::List(vec![Value::Text("A".to_owned()).into(), Value::Text("C".to_owned()).into()])),
        ] {
            assert_eq!(with(key, &value).err().map(|wrong| wrong.len()), Some(1), "{key}");
        }
    }
}
