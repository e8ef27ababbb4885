//! From a text to a [`Scene`]: one walk for TOML and JSON, all problems of the file at once.

use std::ops::Range;

use super::checked::{Checked, check, too_many};
use super::fields::ROOT;
use super::limits::MAX_SHAPES;
use super::node::{Node, NodeValue};
use super::problem::{Fault, Problem, Problems};
use super::source::Source;
use super::{Scene, Spanned, Variant, body, canvas, exercise, labels, live, panels, question, steps};

/// Reads a scene, checked: what comes back can be asked and drawn. Layers, their options, themes and the
/// values in texts are checked by the figure's plan.
///
/// # Errors
/// All problems of the text, in its order.
///
/// ```
/// use tracefig::scene::{Source, read};
/// let source = Source::new("empty.toml", "title = 'no shapes'");
/// let problems = read(&source).unwrap_err();
/// assert_eq!(problems[0].fault.to_string(), "the scene lacks `shapes`: expected a table of shapes by name");
/// ```
pub fn read(source: &Source) -> Result<Scene, Vec<Problem>> {
    from_tree(&source.tree()?)
}

/// Reads a scene from the tree of its values; the errors are those of [`read`].
pub(crate) fn from_tree(root: &Node) -> Result<Scene, Vec<Problem>> {
    let mut problems = Problems::default();
    let scene = scene(root, &mut problems);
    match scene {
        Some(scene) if problems.is_empty() => Ok(scene),
        _ => Err(problems.into_sorted()),
    }
}

fn scene(root: &Node, p: &mut Problems) -> Option<Scene> {
    let top = check(root, "scene", ROOT.place, ROOT.fields, p)?;
    let read = bodies(&top, p);
    let names: Vec<Spanned<String>> = read.iter().map(|r| r.name.clone()).collect();
    let query = top.get("query").and_then(|node| question::read(node, &read, p));
    let panels = panels::read(&top, &names, p);
    let labels = labels::read(&top, p);
    let canvas = canvas::read(&top, p);
    let live = live::read(&top, &read, p);
    let steps = steps::read(&top, p);
    let exercise = exercise::read(&top, p);
    let shapes: Option<Vec<_>> = read.into_iter().map(|r| r.body.map(|body| (r.name, body))).collect();
    Some(Scene {
        title: top.text("title"),
        alt: top.text("alt"),
        lang: language(&top, p),
        headline: top.text("headline"),
        caption: top.text("caption"),
        shapes: shapes?,
        query: query?,
        panels,
        labels,
        canvas,
        live,
        steps,
        exercise,
        variant: Variant::default(),
    })
}

fn bodies(top: &Checked<'_>, p: &mut Problems) -> Vec<body::Read> {
    let Some(node) = top.get("shapes") else { return Vec::new() };
    let entries = node.entries().unwrap_or_default();
    if node.entries().is_some_and(<[_]>::is_empty) {
        let (expected, got) = ("a table of at least one shape".to_owned(), "an empty one".to_owned());
        p.add(Fault::WrongType { key: "shapes".to_owned(), expected, got }, &node.span);
    }
    if let Some((key, _)) = entries.get(MAX_SHAPES) {
        too_many("`shapes`", MAX_SHAPES, "shapes", entries.len(), &key.span, p);
    }
    entries.iter().take(MAX_SHAPES).map(|(name, node)| body::read(name, node, p)).collect()
}

/// The language of the texts; what is no tag of one is told.
fn language(top: &Checked<'_>, p: &mut Problems) -> Option<Spanned<String>> {
    let lang = top.text("lang")?;
    if is_tag(&lang.value) {
        return Some(lang);
    }
    // As systems name what they speak.
    let tag = lang.value.split('.').next().unwrap_or_default().replace('_', "-");
    if is_tag(&tag) {
        let fault = Fault::UnknownWord { what: "language", got: lang.value, known: vec![tag] };
        p.add(fault, &lang.span);
        return None;
    }
    let expected = "the tag of a language, as \"de\" or \"pt-BR\"".to_owned();
    let got = format!("\"{}\"", lang.value);
    p.add(Fault::WrongType { key: "lang".to_owned(), expected, got }, &lang.span);
    None
}

/// Whether a text is the tag of a language, as "de" or "pt-BR"; none begins with more than three letters.
fn is_tag(text: &str) -> bool {
    let mut parts = text.split('-');
    let first = parts.next().unwrap_or("");
    (2..=3).contains(&first.len())
        && first.bytes().all(|b| b.is_ascii_alphabetic())
        && parts.all(|part| (1..=8).contains(&part.len()) && part.bytes().all(|b| b.is_ascii_alphanumeric()))
}

/// Where the `id` of a scene stands, which is copied to the answer whatever JSON it is; `None` without one.
pub(crate) fn id_span(root: &Node) -> Option<Range<usize>> {
    root.get("id").filter(|id| id.value != NodeValue::Other("null")).map(|id| id.span.clone())
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_scene_of_no_shapes_is_told_what_it_lacks() {
        for text in [
            "[shapes]\n[query]\nkind = 'separation'\nof = ['A', 'B']",
            "shapes = {}\nquery = { kind = 'bounds', of = ['A'] }",
            "{\"shapes\": {}, \"query\": {\"kind\": \"bounds\", \"of\": [\"A\"]}}",
        ] {
            let refused = crate::scene::open_text("s", text).unwrap_err();
            let told: Vec<String> = refused.problems.iter().map(|p| p.fault.to_string()).collect();
            assert_eq!(
                told,
                ["`shapes`: expected a table of at least one shape, got an empty one"],
                "{text}"
            );
        }
    }

    use crate::scene::{open_text, solve_jsonl_line};

    #[test]
    fn a_language_as_systems_name_it_is_understood() {
        let told = |lang: &str| {
            let refused = open_text("s.toml", &format!("lang = '{lang}'")).unwrap_err();
            refused.problems.iter().find(|p| p.fault.code() == "unknown-word")?.fault.help()
        };
        for lang in ["de_DE", "de_DE.UTF-8"] {
            assert!(told(lang).unwrap().contains("`de-DE`"), "{lang}");
        }
        assert_eq!(told("german!"), None);
        // No language has a tag of more than three letters: what it would be is for nobody to guess.
        let word = |lang: &str| open_text("s.toml", &format!("lang = '{lang}'")).unwrap_err();
        let is_told = |lang: &str| word(lang).problems.iter().any(|p| p.fault.code() == "wrong-type");
        let told = ["German", "klingon", "en", "gsw", "pt-BR", "zh-Hant"].map(is_told);
        assert_eq!(told, [true, true, false, false, false, false]);
    }

    #[test]
    fn a_line_of_a_stream_that_is_no_scene_says_so_in_the_words_of_its_language() {
        let blank = solve_jsonl_line("  ", 2).line;
        assert!(blank.contains("a blank line; each line of a stream is a scene as JSON"), "{blank}");
        let nan = solve_jsonl_line(r#"{"shapes": {"A": {"kind": "circle", "radius": NaN}}}"#, 3).line;
        assert!(nan.contains("JSON has no NaN"), "{nan}");
    }

    #[test]
    fn a_table_with_the_brackets_of_another_says_which_it_has() {
        let help = |text: &str| {
            let refused = open_text("s.toml", text).unwrap_err();
            refused.problems.iter().filter_map(|p| p.fault.help()).collect::<Vec<_>>().join(" | ")
        };
        assert!(help("[steps]\ntitle = 'x'").contains("[[steps]]"));
        assert!(help("[[query]]\nkind = 'x'").contains("there is one alone: [query]"));
        assert!(help("title = 'x'").contains("shapes.A = {"));
        // Nothing is said of shapes that no table has.
        let told = help("[shape.A]\nkind = 'circle'\n[query]\nkind = 'bounds'\nof = ['A']");
        assert!(told.contains("did you mean `shapes`?") && !told.contains("known are"), "{told}");
    }
}
