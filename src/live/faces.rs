//! The glyphs that a page brings along, as its module has those alone that our own words and layers say.

use serde_json::{Map, Value};

use super::refusal::Refusal;
use crate::output::of_base64;
use crate::typeset::{PACKED, bring};

#[cfg(not(tracefig_page))]
pub use whole::more_glyphs;

#[cfg(not(tracefig_page))]
mod whole {
    use std::collections::BTreeSet;

    use serde_json::{Map, Value, json};

    use crate::figure::{draw, plan};
    use crate::output::base64;
    use crate::scene::{Scene, SceneFile};
    use crate::typeset::{Glyphs, beyond, said};

    use super::super::texts::foreign_texts;

    /// Every text of a value, keys of tables too.
    fn texts<'v>(value: &'v Value, found: &mut Vec<&'v str>) {
        match value {
            Value::String(text) => found.push(text),
            Value::Array(items) => items.iter().for_each(|item| texts(item, found)),
            Value::Object(entries) => entries.iter().for_each(|(key, value)| {
                found.push(key);
                texts(value, found);
            }),
            _ => {}
        }
    }

    /// The glyphs that [`Live::open`](crate::live::Live::open) must be given with a scene in the module of
    /// live pages, which has those alone that our own words and layers say in English: packed, by face;
    /// `None` where it needs no more.
    ///
    /// ```
    /// use tracefig::live::more_glyphs;
    /// let scene = |name: &str| {
    ///     let text = format!(
    ///         "shapes.\"{name}\" = {{ kind = 'circle', radius = 2 }}\n\
    ///          query = {{ kind = 'bounds', of = ['{name}'] }}"
    ///     );
    ///     tracefig::scene::open_text("s.toml", &text)
    /// };
    /// assert_eq!(more_glyphs(&scene("box")?), None);
    /// assert!(more_glyphs(&scene("Ж")?).unwrap()["words"].is_string());
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn more_glyphs(file: &SceneFile) -> Option<Value> {
        let brought = beyond(&needed(file)).into_iter();
        let faces: Map<String, Value> =
            brought.map(|(face, piece)| (face.to_owned(), json!(base64(&piece)))).collect();
        (!faces.is_empty()).then_some(Value::Object(faces))
    }

    /// All texts that are set to draw a scene.
    pub(super) fn drawn(scene: &Scene) -> BTreeSet<String> {
        said(|| {
            if let Ok(plan) = plan(scene) {
                let _ = draw(&plan, plan.theme, "f");
            }
        })
    }

    /// The glyphs that a scene and the texts of its language need, with those that its layers write of their
    /// options.
    pub(super) fn needed(file: &SceneFile) -> Glyphs {
        let (scene, foreign) = (file.json_value(), foreign_texts(file).unwrap_or_default());
        let drawn = drawn(&file.scene);
        let (mut own, mut ours) = (Vec::new(), Vec::new());
        texts(&scene, &mut own);
        texts(&foreign, &mut ours);
        let letters: BTreeSet<char> = ours.iter().flat_map(|text| text.chars()).collect();
        let set = drawn.iter().map(String::as_str);
        Glyphs::of(own.into_iter(), set, &letters.into_iter().collect::<String>())
    }
}

/// Sets also the glyphs of a request, where this program has some alone.
pub(super) fn bring_all(faces: &Map<String, Value>) -> Result<(), Refusal> {
    for (name, piece) in faces {
        let place = PACKED.iter().position(|known| known == name);
        let piece = piece.as_str().and_then(of_base64);
        let malformed = || Refusal::Malformed { expected: "glyphs in base64", got: format!("`{name}`") };
        let (place, piece) = place.zip(piece).ok_or_else(malformed)?;
        bring(place, &piece);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};
    use std::fs;
    use std::path::Path;

    use serde_json::json;
    use tracefig_reference::random::Random;

    use super::whole::{drawn, needed};
    use super::{bring_all, more_glyphs};
    use crate::figure::{LAYERS, Shows, Takes, plan};
    use crate::geometry::DVec2;
    use crate::output::of_base64;
    use crate::scene::{PROJECT_FILE, SceneFile, open, open_text};
    use crate::typeset::beyond;

    /// The scenes of a folder of this repository.
    fn scenes(folder: &str) -> Vec<SceneFile> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        let is_scene =
            |path: &Path| path.extension().is_some_and(|end| end == "toml") && !path.ends_with(PROJECT_FILE);
        paths.retain(|path| is_scene(path));
        paths.sort();
        paths.iter().map(|path| open(path).unwrap()).collect()
    }

    /// What the module lacks to set all that a scene says, as it is and with its bodies elsewhere: all texts
    /// that were set, seen in the end or not.
    fn lacking(file: &SceneFile, r: &mut Random) -> BTreeSet<String> {
        let needed = needed(file);
        let mut scene = file.scene.clone();
        for (_, body) in &mut scene.shapes {
            let mut far = || r.between(-1.0, 1.0) * [0.1, 1.0, 10.0][r.below(3)];
            body.position += DVec2::new(far(), far());
            body.velocity *= far();
        }
        let said = drawn(&file.scene).into_iter().chain(drawn(&scene)).collect::<BTreeSet<_>>();
        let lacks = |text: &String| {
            crate::typeset::lacking(&needed, text).map(|glyph| format!("{glyph} in `{text}`"))
        };
        said.iter().filter_map(lacks).collect()
    }

    #[test]
    fn whatever_a_figure_says_in_any_language_wherever_its_bodies_are_can_be_set_in_its_page() {
        let mut r = Random::new(25);
        for file in ["figures", "guide/src/reference/layers"].into_iter().flat_map(scenes) {
            for lang in ["en", "de", "fr", "es", "zh"] {
                let mut json = file.json_value();
                json["lang"] = lang.into();
                let lacking = lacking(&open_text("scene", &json.to_string()).unwrap(), &mut r);
                assert!(lacking.is_empty(), "{} in {lang}: {lacking:#?}", file.source.name);
            }
        }
    }

    /// Values of an option in TOML.
    fn values(takes: Takes) -> Vec<String> {
        let quoted = |words: &[&str]| words.iter().map(|word| format!("'{word}'")).collect();
        match takes {
            Takes::Flag => vec!["true".to_owned()],
            Takes::Number | Takes::Positive => ["0.25", "0.5", "1", "3"].map(str::to_owned).to_vec(),
            Takes::Counts => vec!["1".to_owned()],
            Takes::Word(words) | Takes::Words(words) | Takes::When(words) => quoted(words),
            Takes::Point | Takes::Bodies | Takes::Role | Takes::Lines => Vec::new(),
        }
    }

    #[test]
    fn a_page_brings_what_each_option_of_a_layer_makes_it_say() {
        let bodies = "shapes.A = { kind = 'polygon', vertices = [[-2, -1], [1, -2], [2, 1]],
                velocity = [6, 2], angular_velocity_deg = 40 }
            shapes.B = { kind = 'regular-polygon', edges = 5, circumradius = 1.5, radius = 0.2,
                position = [5, 2], velocity = [-1, 0] }";
        let questions = ["separation", "time-of-impact", "contact"];
        let (mut r, mut count) = (Random::new(26), 0);
        let options = LAYERS.iter().flat_map(|layer| layer.options.iter().map(move |option| (layer, option)));
        for (layer, option) in options {
            for (value, question) in values(option.takes).iter().flat_map(|v| questions.map(|q| (v, q))) {
                let space = if layer.shows == Shows::Configuration { "configuration" } else { "world" };
                let turns = matches!(question, "time-of-impact" | "contact");
                let bodies =
                    if turns { bodies.to_owned() } else { bodies.replace("angular_velocity_deg = 40", "") };
                let text = format!(
                    "{bodies}\nquery = {{ kind = '{question}', of = ['A', 'B'] }}
                    panels = [{{ space = '{space}', layers = [{{ layer = '{}', {} = {value} }}] }}]",
                    layer.name, option.name
                );
                let Ok(file) = open_text("s.toml", &text) else { continue };
                if plan(&file.scene).is_err() {
                    continue;
                }
                count += 1;
                let lacking = lacking(&file, &mut r);
                assert!(lacking.is_empty(), "{lacking:#?} of\n{text}");
            }
        }
        assert!(count > 300, "{count}");
    }

    /// How many bytes of each face a page brings with a caption.
    fn brought(caption: &str) -> BTreeMap<String, usize> {
        let text = format!(
            "caption = '{caption}'\nshapes.A = {{ kind = 'circle', radius = 2 }}\n\
             query = {{ kind = 'bounds', of = ['A'] }}"
        );
        let faces = more_glyphs(&open_text("s.toml", &text).unwrap()).unwrap_or_default();
        let faces = faces.as_object().cloned().unwrap_or_default().into_iter();
        faces.map(|(name, piece)| (name, of_base64(piece.as_str().unwrap()).unwrap().len())).collect()
    }

    #[test]
    fn a_page_brings_the_glyphs_that_the_module_lacks_and_no_others() {
        assert_eq!(brought("A is at $(1, -2.5)$, {a|the box}’s end: $t_1 \\le r_A$"), BTreeMap::new());
        let keys = |caption| brought(caption).into_keys().collect::<Vec<_>>().join(" ");
        assert_eq!(keys("größer"), "words");
        assert_eq!(keys("$\\mathfrak{A}$"), "formulas");
        assert_eq!(keys("Жук $\\to$"), "formulas words");
        let root = brought(r"$\sqrt{x}$")["formulas"];
        assert!(
            root < 300 && brought(r"$\sqrt{\frac{1}{x}}$")["formulas"] > root,
            "larger roots are tried in turn"
        );
    }

    #[test]
    fn figures_bring_little() {
        let sizes = |file: &SceneFile| beyond(&needed(file)).iter().map(|(_, piece)| piece.len()).sum();
        let mut brought: Vec<usize> = scenes("figures").iter().map(sizes).collect();
        brought.sort_unstable();
        // Most bring nothing, and one letter of formulas takes 110 to 260 bytes.
        assert!(brought[brought.len() / 2] < 260 && brought[brought.len() - 1] < 2000, "{brought:?}");
    }

    #[test]
    fn pieces_that_are_no_faces_are_refused() {
        for faces in [json!({ "words": "*" }), json!({ "regular": "AAAA" }), json!({ "words": 1 })] {
            assert!(bring_all(faces.as_object().unwrap()).is_err(), "{faces}");
        }
    }
}
