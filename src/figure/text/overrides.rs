//! What a scene says of a label in `[labels]`: by the label's key, or by the name of a shape.
//!
//! The labels of the query's bodies have the keys A and B whatever the scene calls them, and A' and B'
//! elsewhere. `[labels] bullet = …` means the same label, unless some layer has a label of that very key.

use crate::geometry::Side;
use crate::scene::{LabelOverride, Scene, Spanned};

/// The keys of the labels that bear a body's name: where it is, and elsewhere.
const NAMED: [(Side, [&str; 2]); 2] = [(Side::A, ["A", "A'"]), (Side::B, ["B", "B'"])];

/// Whether some layer has a label of a key.
pub(crate) type IsKey = fn(&str) -> bool;

/// The key of the label that a word of `[labels]` means: the word itself, or the key of the body that is
/// called so.
#[must_use]
pub(crate) fn label_key<'k>(scene: &Scene, word: &'k str, is_key: IsKey) -> &'k str {
    if is_key(word) {
        return word;
    }
    let names = scene.names();
    let stands = NAMED.iter().find_map(|&(side, [here, elsewhere])| {
        let rest = word.strip_prefix(names.of(side))?;
        match rest {
            "" => Some(here),
            "'" | "′" => Some(elsewhere),
            _ => None,
        }
    });
    stands.unwrap_or(word)
}

/// What a scene says of a label; by its key rather than by a name.
pub(crate) fn overridden<'s>(
    scene: &'s Scene,
    key: &str,
    is_key: IsKey,
) -> Option<&'s (Spanned<String>, LabelOverride)> {
    let by_key = scene.labels.iter().find(|(word, _)| word.value == key);
    by_key.or_else(|| scene.labels.iter().find(|(word, _)| label_key(scene, &word.value, is_key) == key))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    #[test]
    fn a_name_means_its_body_unless_it_is_the_key_of_a_label() {
        let text = r#"
            shapes.d = { kind = "circle", radius = 1 }
            shapes.bullet = { kind = "circle", radius = 1, position = [4, 0] }
            query = { kind = "separation", of = ["d", "bullet"] }
            labels = { "bullet′" = "x", bullet = "y", d = "z" }
        "#;
        let scene = open_text("s.toml", text).unwrap().scene;
        let is_key = |key: &str| ["A", "B", "A'", "B'", "d"].contains(&key);
        let meant = |word| label_key(&scene, word, is_key);
        assert_eq!(
            ["bullet", "bullet'", "bullet′", "d", "d'", "bull"].map(meant),
            ["B", "B'", "B'", "d", "A'", "bull"]
        );
        let said = |key| overridden(&scene, key, is_key).map(|(word, _)| word.value.as_str());
        assert_eq!(["A", "B", "B'", "d"].map(said), [None, Some("bullet"), Some("bullet′"), Some("d")]);
    }
}
