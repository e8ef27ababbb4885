//! Texts of ours in the language of a page: its module has them in English alone.

use serde_json::Value;

use super::refusal::{self, Refusal};
use crate::figure;
use crate::trace::{all_phrases, bring_texts};

#[cfg(not(tracefig_page))]
pub use whole::foreign_texts;

/// Every row of every table of texts, in an order that is that of the module too.
fn rows() -> impl Iterator<Item = &'static [&'static str]> {
    let phrases = all_phrases().map(|row| &row[..]);
    phrases.chain(figure::all_texts()).chain(refusal::WORDS.iter().map(|row| &row[..]))
}

#[cfg(not(tracefig_page))]
mod whole {
    use serde_json::Value;

    use super::rows;
    use crate::figure::Language;
    use crate::scene::SceneFile;
    use crate::trace::of_language;

    /// The texts that [`Live::open`](crate::live::Live::open) must be given with a scene in the module of
    /// live pages, which has those in English alone; `None` where the scene is in English, or in a language
    /// that has no texts of ours.
    ///
    /// ```
    /// use tracefig::live::foreign_texts;
    /// let scene = |lang: &str| {
    ///     let text = format!(
    ///         "lang = '{lang}'\nshapes.A = {{ kind = 'circle', radius = 2 }}\n\
    ///          query = {{ kind = 'bounds', of = ['A'] }}"
    ///     );
    ///     tracefig::scene::open_text("s.toml", &text)
    /// };
    /// assert_eq!(foreign_texts(&scene("en")?), None);
    /// let german = foreign_texts(&scene("de-AT")?).unwrap();
    /// assert!(german.as_array().unwrap().contains(&"* und * berühren sich.".into()));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn foreign_texts(file: &SceneFile) -> Option<Value> {
        match Language::of(&file.scene).of_sentences() {
            0 => None,
            language => Some(rows().map(|row| of_language(row, language)).collect()),
        }
    }
}

/// Tells in the texts of a request, where this program has none of its own.
pub(super) fn bring_all(texts: Value) -> Result<(), Refusal> {
    let malformed = |got: &Value| Refusal::Malformed { expected: "a list of texts", got: got.to_string() };
    let Value::Array(texts) = texts else { return Err(malformed(&texts)) };
    if texts.len() != rows().count() {
        return Err(malformed(&texts.len().into()));
    }
    let texts = texts.into_iter().map(|text| match text {
        Value::String(text) => text,
        other => other.to_string(),
    });
    bring_texts(rows().zip(texts));
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{bring_all, rows};
    use crate::trace::of_language;

    #[test]
    fn no_row_stands_in_two_tables_and_each_has_all_languages() {
        let places: BTreeSet<_> = rows().map(<[_]>::as_ptr).collect();
        assert_eq!(places.len(), rows().count());
        for language in 1..=3 {
            let silent: Vec<_> = rows().filter(|row| of_language(row, language).is_empty()).collect();
            assert!(silent.is_empty(), "{silent:?}");
        }
        assert!(rows().all(|row| row.len() >= 4));
    }

    #[test]
    fn texts_that_are_not_of_every_row_are_refused() {
        for texts in [serde_json::json!(["ja"]), serde_json::json!("ja")] {
            let refused = bring_all(texts).unwrap_err().to_string();
            assert!(refused.starts_with("expected a list of texts"), "{refused}");
        }
    }
}
