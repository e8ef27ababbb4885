//! Live pages: what they hold, where they are, and how they find each other.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::fs;
use std::path::Path;

use serde_json::Value;
use tracefig::scene::open_text;

use crate::{Ran, run, tracefig};

const SCENE: &str = "title = 'Two <b>circles</b>'\nheadline = 'They are {a|apart}'\n[shapes.B]\nkind = 'circle'\n\
    radius = 1\nposition = [3, 0.5]\n[shapes.A]\nkind = 'circle'\nradius = 1 # first\n[query]\n\
    kind = 'separation'\nof = ['A', 'B']\n";

fn render(folder: &Path, arguments: &[&str]) -> Ran {
    run(tracefig(folder).arg("render").args(arguments))
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// What the page hands to the module.
fn request(page: &str) -> Value {
    let (_, rest) = page.split_once("<script type=\"application/json\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn a_live_page_holds_the_picture_byte_for_byte_and_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("two.toml"), SCENE).unwrap();
    for theme in ["light", "auto"] {
        assert_eq!(render(folder.path(), &["two.toml", "--format", "svg", "--theme", theme]).code, Some(0));
        let ran = render(folder.path(), &["two.toml", "--live", "-o", "two.html", "--theme", theme]);
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
        let page = read(folder.path(), "two.html");
        assert!(page.contains(&format!("<figure>{}</figure>", read(folder.path(), "two.svg").trim_end())));
        assert!(page.contains("<h1>Two &lt;b&gt;circles&lt;/b&gt;</h1>"));
        let request = request(&page);
        assert_eq!(request["theme"], theme);
        assert!(page.contains(&format!("id=\"{}-title\"", request["id"].as_str().unwrap())));
        let again = open_text("again", &request["scene"].to_string()).unwrap();
        assert_eq!(again.meaning, open_text("two.toml", SCENE).unwrap().meaning);
    }
    assert!(!folder.path().join("index.html").exists() && !folder.path().join("tracefig-live.js").exists());
}

#[test]
fn pages_of_a_folder_share_the_runtime_and_are_listed_those_first_that_say_what_is_moved() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("in/deep")).unwrap();
    fs::write(folder.path().join("in/one.toml"), SCENE).unwrap();
    let moved = format!("live.drag = ['A']\n{}", SCENE.replace("Two", "Moved"));
    fs::write(folder.path().join("in/deep/two & 3.toml"), moved).unwrap();
    fs::write(folder.path().join("in/broken.toml"), SCENE.replace("'B']", "'C']")).unwrap();
    let ran = render(folder.path(), &["in", "--format", "html", "--live=shared", "-o", "site"]);
    assert_eq!(ran.code, Some(1), "one of them is broken");
    let runtime = read(folder.path(), "site/tracefig-live.js");
    assert!(runtime.starts_with("globalThis.tracefigModule=\"H4sI"), "what gzip packed");
    let (one, two) = (read(folder.path(), "site/one.html"), read(folder.path(), "site/deep/two & 3.html"));
    assert!(one.contains("<script src=\"tracefig-live.js\">") && one.contains("href=\"index.html\""));
    assert!(two.contains("<script src=\"../tracefig-live.js\">") && two.contains("href=\"../index.html\""));
    assert!(one.len() < 60_000, "{} bytes", one.len());
    let index = read(folder.path(), "site/index.html");
    let places = ["deep/two%20%26%203.html", "<strong>Moved", "one.html", "one.svg"].map(|it| index.find(it));
    assert!(places.is_sorted() && places.iter().all(Option::is_some), "{index}");
    assert!(!index.contains("broken") && folder.path().join("site/one.svg").exists());
}

#[test]
fn an_entry_of_the_list_has_its_language_and_the_values_of_its_headline() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("in")).unwrap();
    fs::write(folder.path().join("in/one.toml"), SCENE).unwrap();
    let french = SCENE.replace("They are {a|apart}", "$d = {=separation}$").replace("Two <b>", "Deux <b>");
    fs::write(folder.path().join("in/two.toml"), format!("lang = 'fr'\n{french}")).unwrap();
    assert_eq!(
        render(folder.path(), &["in", "--format", "html", "--live=shared", "-o", "site"]).code,
        Some(0)
    );
    let index = read(folder.path(), "site/index.html");
    assert!(
        index.contains("<a lang=\"fr\" href=\"two.html\">") && index.contains("<span>They are apart</span>")
    );
    assert!(!index.contains("=separation") && index.contains("à une distance de 1,04"), "{index}");
}

#[test]
fn a_page_in_a_theme_of_ones_own_carries_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("own.toml"), "[colors]\na = '#0072B2'\nb = '#D55E00'\n").unwrap();
    let scene = format!("canvas.theme = 'own.toml'\n{SCENE}");
    fs::write(folder.path().join("two.toml"), scene).unwrap();
    assert_eq!(render(folder.path(), &["two.toml", "--live", "-o", "two.html"]).code, Some(0));
    let request = request(&read(folder.path(), "two.html"));
    assert_eq!(request["theme"]["file"]["colors"]["a"], "#0072B2");
}

#[test]
fn live_without_a_format_that_has_such_pages_is_told() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("two.toml"), SCENE).unwrap();
    let ran = render(folder.path(), &["two.toml", "--live"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(2), "error: `--live` needs `--format html`\n"));
    assert!(!folder.path().join("two.svg").exists());
    assert_eq!(render(folder.path(), &["two.toml", "--live=both", "-o", "two.html"]).code, Some(2));
}
