//! Live figures of a book: what stands in its pages, and what these load.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use tempfile::TempDir;
use tracefig::live::Live;

use crate::mdbook::{came_back, contents, page_in};
use crate::{CIRCLES, Ran, folder_with};

const RUNTIME: &str = "js/tracefig-live.js";

/// A folder with two circles and one for scripts.
fn folder() -> TempDir {
    let folder = folder_with("circles.toml", CIRCLES);
    fs::create_dir(folder.path().join("js")).unwrap();
    folder
}

/// What comes of a page of a book that loads the runtime.
fn page(folder: &Path, content: &str, renderer: &str) -> Ran {
    let config = json!({"book": {"src": ""}, "output": {"html": {"additional-js": ["a.js", RUNTIME]}}});
    page_in(folder, content, renderer, &config)
}

/// The text of that page.
fn drawn(folder: &Path, content: &str, renderer: &str) -> String {
    contents(&came_back(&page(folder, content, renderer))["items"]).remove(0)
}

#[test]
fn the_module_draws_the_picture_that_stands_in_the_page() {
    let folder = folder();
    let own = "[colors]\na = '#0072B2'\nb = '#B35900'\n";
    fs::write(folder.path().join("own.toml"), own).unwrap();
    let named = format!("canvas = {{ theme = 'own.toml', width = 500 }}\n{CIRCLES}");
    fs::write(folder.path().join("named.toml"), named).unwrap();
    let asked = [
        "circles.toml live",
        "circles.toml live alt=\"Two *of* <them> $x$\" width=60%",
        "circles.toml theme=dark live",
        "circles.toml live theme=auto",
        "circles.toml live theme=own.toml",
        "named.toml live",
    ];
    let text: String = asked.map(|it| format!("{{{{#tracefig {it}}}}}\n\n")).concat();
    let page = drawn(folder.path(), &text, "html");
    assert!(!page.contains("$x$"), "a formula for another preprocessor");
    let mut live = 0;
    for part in page.split("<div class=\"tracefig-live\">").skip(1) {
        let (figure, rest) = part.split_once("<script type=\"application/json\">").unwrap();
        let (request, rest) = rest.split_once("</script></div>").unwrap();
        assert!(!figure.contains('\n') && !request.contains(['\n', '<', '$']) && rest.trim().is_empty());
        let frame = Live::open(request).unwrap().draw().unwrap();
        assert!(figure.ends_with(&format!("{}</figure>", frame.svg)), "{}", asked[live]);
        live += 1;
    }
    assert_eq!(live, asked.len());
    assert_eq!(page.matches("<style>.tracefig{").count(), 1);
}

#[test]
fn what_live_figures_need_is_written_once_where_the_book_lists_it_and_kept_up_to_date() {
    let folder = folder();
    let file = folder.path().join(RUNTIME);
    let build = |text: &str, renderer: &str| drawn(folder.path(), text, renderer);
    build("{{#tracefig circles.toml}}\n", "html");
    let image = build("{{#tracefig circles.toml live}}\n", "epub");
    assert!(image.starts_with("![") && !image.contains("script"), "{image}");
    assert!(!file.exists(), "no page is live");
    build("{{#tracefig circles.toml live}}\n", "html");
    let runtime = fs::read_to_string(&file).unwrap();
    assert!(runtime.contains("tracefigModule=\"H4sI"), "what gzip packed");
    let written = fs::metadata(&file).unwrap().modified().unwrap();
    build("{{#tracefig circles.toml live}}\n", "html");
    assert_eq!(fs::metadata(&file).unwrap().modified().unwrap(), written);
    for other in ["of another tracefig", &format!("{runtime} ")] {
        fs::write(&file, other).unwrap();
        build("{{#tracefig circles.toml live}}\n", "html");
        assert!(fs::read_to_string(&file).unwrap() == runtime, "stale");
    }
    let mut names: Vec<_> = folder.path().read_dir().unwrap().map(|e| e.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["circles.toml", "js", "page.md"]);
}

#[test]
fn a_book_whose_pages_would_not_load_it_is_told() {
    let folder = folder();
    let config: Value = json!({"book": {"src": ""}, "output": {"html": {"additional-js": ["other.js"]}}});
    let ran = page_in(folder.path(), "{{#tracefig circles.toml live}}\n", "html", &config);
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert!(ran.err.contains("additional-js = [\"tracefig-live.js\"]"), "{}", ran.err);
    fs::remove_dir(folder.path().join("js")).unwrap();
    let ran = page(folder.path(), "{{#tracefig circles.toml live}}\n", "html");
    assert_eq!((ran.code, ran.out.as_str()), (Some(74), ""));
    assert!(ran.err.contains("can't write") && ran.err.contains("tracefig-live.js"), "{}", ran.err);
}
