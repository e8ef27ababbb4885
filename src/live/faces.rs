//! The faces that a page brings along, as its module has cut ones.

use serde_json::{Map, Value};

use super::refusal::Refusal;
use crate::output::of_base64;
use crate::typeset::{Face, bring};

#[cfg(not(tracefig_page))]
pub use whole::whole_faces;

#[cfg(not(tracefig_page))]
mod whole {
    use serde_json::{Map, Value, json};

    use crate::output::base64;
    use crate::scene::SceneFile;
    use crate::typeset::beyond;

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

    /// The faces that [`Live::open`](crate::live::Live::open) must be given with a scene in the module of
    /// live pages, whose own are cut to what most figures set; `None` where it needs no more.
    ///
    /// ```
    /// use tracefig::live::whole_faces;
    /// let scene = |name: &str| {
    ///     let text = format!(
    ///         "shapes.\"{name}\" = {{ kind = 'circle', radius = 2 }}\n\
    ///          query = {{ kind = 'bounds', of = ['{name}'] }}"
    ///     );
    ///     tracefig::scene::open_text("s.toml", &text)
    /// };
    /// assert_eq!(whole_faces(&scene("A")?), None);
    /// assert!(whole_faces(&scene("Ж")?).unwrap()["regular"].is_string());
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn whole_faces(file: &SceneFile) -> Option<Value> {
        let scene = file.json_value();
        let mut found = Vec::new();
        texts(&scene, &mut found);
        let faces = beyond(found.into_iter()).into_iter();
        let faces: Map<String, Value> =
            faces.map(|(face, file)| (face.word().to_owned(), json!(base64(file)))).collect();
        (!faces.is_empty()).then_some(Value::Object(faces))
    }
}

/// Sets from the faces of a request, where this program has cut ones.
pub(super) fn bring_all(faces: &Map<String, Value>) -> Result<(), Refusal> {
    for (word, file) in faces {
        let face = Face::ALL.into_iter().find(|face| face.word() == word);
        let file = file.as_str().and_then(of_base64);
        let malformed = || Refusal::Malformed { expected: "faces in base64", got: format!("`{word}`") };
        let (face, file) = face.zip(file).ok_or_else(malformed)?;
        bring(face, file);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::whole_faces;
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::output::inline;
    use crate::scene::{PROJECT_FILE, SceneFile, open, open_text};
    use crate::typeset::{Face, Glyph, has};

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

    /// The glyphs of a picture, by the ids that it has them under: `m` for formulas and 12 is `id.m12`.
    fn glyphs(svg: &str) -> Vec<Glyph> {
        let places = svg.split("<use xlink:href=\"#").skip(1).filter_map(|rest| rest.split('"').next());
        let glyph = |id: &str| {
            let (_, glyph) = id.rsplit_once('.')?;
            let faces = [('r', Face::Regular), ('s', Face::Semibold), ('m', Face::Math)];
            let mut found = faces.into_iter().filter_map(|(letter, face)| {
                glyph.strip_prefix(letter)?.parse().ok().map(|id| Glyph { face, id })
            });
            found.next()
        };
        places.filter_map(glyph).collect()
    }

    #[test]
    fn most_figures_need_no_face_but_the_cut_ones() {
        for folder in ["figures", "guide/src/reference/layers"] {
            for file in scenes(folder) {
                assert_eq!(whole_faces(&file), None, "{}", file.source.name);
            }
        }
    }

    #[test]
    fn a_figure_that_sets_more_brings_the_faces_that_it_needs() {
        let needed = |caption: &str| {
            let text = format!(
                "caption = '{caption}'\nshapes.A = {{ kind = 'circle', radius = 2 }}\n\
                 query = {{ kind = 'bounds', of = ['A'] }}"
            );
            let faces = whole_faces(&open_text("s.toml", &text).unwrap());
            faces.map(|faces| faces.as_object().unwrap().keys().cloned().collect::<Vec<_>>().join(" "))
        };
        assert_eq!(needed("größer als $\\frac{1}{2}\\,\\|v_{AB}\\|$, où l’objet {a|A} s’arrête"), None);
        assert_eq!(needed("$\\mathfrak{A}$").as_deref(), Some("formulas"));
        assert_eq!(needed("Жук").as_deref(), Some("regular semibold"));
    }

    #[test]
    fn whatever_a_figure_says_in_any_language_wherever_its_bodies_are_is_in_the_cut_faces() {
        let mut count = 0;
        for file in scenes("figures") {
            for (lang, off, speed) in
                [("de", 0.0, 1.0), ("fr", 0.4, -1.0), ("es", 30.0, 1.0), ("en", -1.3, 3.0)]
            {
                let mut json = file.json_value();
                json["lang"] = lang.into();
                let mut scene = open_text("scene", &json.to_string()).unwrap().scene;
                let body = &mut scene.shapes[0].1;
                body.position += DVec2::new(off, 0.7 * off);
                body.velocity *= speed;
                let Ok(plan) = plan(&scene) else { continue };
                let svg = inline(&draw(&plan, plan.theme, "f").drawing.finished()).unwrap();
                for glyph in glyphs(&svg) {
                    count += 1;
                    assert!(has(glyph), "{}: {glyph:?} in {lang}", file.source.name);
                }
            }
        }
        assert!(count > 10_000, "{count}");
    }
}
