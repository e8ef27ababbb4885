//! `tracefig mdbook`: books as mdBook 0.4 and 0.5 sent them, and pages of which something is wrong.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::{CIRCLES, Ran, folder_with, run, run_on, tracefig};

/// What mdBook sent for the book in `tests/data/book`, with `ROOT` for its folder.
const SENT: [(&str, &str); 2] =
    [("sections", include_str!("../data/book-0.4.json")), ("items", include_str!("../data/book-0.5.json"))];

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/book")
}

/// The command, in a folder; nothing is kept for a next build.
fn mdbook(folder: &Path) -> Command {
    let mut command = tracefig(folder);
    command.arg("mdbook");
    for name in ["XDG_CACHE_HOME", "HOME", "LOCALAPPDATA"] {
        command.env_remove(name);
    }
    command
}

/// The book that comes back.
pub(crate) fn came_back(ran: &Ran) -> Value {
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    serde_json::from_str(&ran.out).unwrap()
}

/// The texts of all pages below a list, in their order.
pub(crate) fn contents(list: &Value) -> Vec<String> {
    let mut found = Vec::new();
    for item in list.as_array().unwrap() {
        if let Some(chapter) = item.get("Chapter") {
            found.push(chapter["content"].as_str().unwrap().to_owned());
            found.extend(contents(&chapter["sub_items"]));
        }
    }
    found
}

/// A book with its texts emptied.
fn emptied(mut list: Value) -> Value {
    for item in list.as_array_mut().unwrap() {
        if let Some(chapter) = item.get_mut("Chapter") {
            chapter["content"] = Value::Null;
            chapter["sub_items"] = emptied(chapter["sub_items"].take());
        }
    }
    list
}

/// What comes of a page in a folder with two circles 1 apart, and the folder.
fn page(content: &str, renderer: &str) -> (Ran, TempDir) {
    let folder = folder_with("circles.toml", CIRCLES);
    (page_in(folder.path(), content, renderer, &json!({"book": {"src": ""}})), folder)
}

/// What comes of a page in a folder, in a book that says so.
pub(crate) fn page_in(folder: &Path, content: &str, renderer: &str, config: &Value) -> Ran {
    fs::write(folder.join("page.md"), content).unwrap();
    let chapter = json!({"name": "P", "content": content, "sub_items": [], "path": "page.md"});
    let context = json!({"root": folder, "renderer": renderer, "config": config});
    let mail = json!([context, {"items": [{"Chapter": chapter}]}]).to_string();
    run_on(&mut mdbook(folder), mail)
}

/// The text of a page that has become one.
fn drawn(content: &str, renderer: &str) -> String {
    let book = came_back(&page(content, renderer).0);
    contents(&book["items"]).remove(0)
}

/// What is said of a page that has become none.
fn refused(content: &str) -> String {
    let (ran, _folder) = page(content, "html");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{}", ran.err);
    ran.err
}

/// The ids of all elements of a page.
fn ids(page: &str) -> Vec<&str> {
    page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

#[test]
fn books_of_both_versions_come_back_with_their_figures() {
    let mut pages = Vec::new();
    for (list, sent) in SENT {
        let sent = sent.replace("ROOT", data().to_str().unwrap());
        let before: Value = serde_json::from_str(&sent).unwrap();
        let after = came_back(&run_on(&mut mdbook(&data()), &sent));
        assert_eq!(emptied(after[list].clone()), emptied(before[1][list].clone()));
        pages.push(contents(&after[list]));
        let figures: Vec<usize> = pages[0].iter().map(|page| page.matches("<figure ").count()).collect();
        assert_eq!(figures, [0, 3, 1, 0, 0]);
        let untouched = contents(&before[1][list]);
        for i in [0, 3, 4] {
            assert_eq!(pages[0][i], untouched[i]);
        }
    }
    assert_eq!(pages[0], pages[1]);
    let all = pages[0].concat();
    let ids = ids(&all);
    assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len(), "an id stands twice in the book");
    assert!(ids.len() > 40);
}

#[test]
fn nothing_is_written_beside_the_pages() {
    let (ran, folder) = page("{{#tracefig circles.toml}}\n", "html");
    came_back(&ran);
    let mut names: Vec<_> = folder.path().read_dir().unwrap().map(|e| e.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["circles.toml", "page.md"]);
}

#[test]
fn a_figure_is_an_element_that_follows_the_book_unless_it_has_a_theme() {
    let text =
        drawn("{{#tracefig circles.toml}}\n\n{{#tracefig circles.toml theme=dark width=40%}}\n", "html");
    let figures: Vec<&str> = text.split("\n\n").map(str::trim).collect();
    assert!(figures[0].starts_with("<figure class=\"tracefig tracefig-book\"><style>"), "{text}");
    assert!(figures[0].contains(".navy .tracefig-book{--tracefig-a:#") && figures[0].ends_with("</figure>"));
    assert!(
        figures[1].starts_with("<figure class=\"tracefig\" style=\"width:40%\"><svg "),
        "one sheet a page"
    );
    assert!(figures[1].contains("#12161c") || figures[1].contains("#12161C"), "the dark page");
    assert_eq!(text.matches("<svg ").count(), 2);
    let width = |figure: &str| {
        figure.split("<svg ").nth(1).unwrap().split("width=\"").nth(1).unwrap()[..3].to_owned()
    };
    assert_eq!(width(figures[0]), "750", "as wide as the text of mdBook");
}

#[test]
fn other_renderers_get_images_with_their_words() {
    let text = drawn("Before\n\n{{#tracefig circles.toml alt=\"*A* [and] B\"}}\n", "epub");
    let image = text.strip_prefix("Before\n\n").unwrap();
    assert!(image.starts_with("![\\*A\\* \\[and\\] B](data:image/svg+xml;base64,"), "{image}");
    assert!(image.ends_with(")\n\n") && !text.contains('<'), "{image}");
}

#[test]
fn the_scene_stands_before_its_figure_where_that_is_asked_for() {
    let scene = "shapes.A = { kind = \"circle\", radius = 1 }\nquery = { kind = \"bounds\", of = [\"A\"] }";
    let inner = scene.replace('\n', "\n  ");
    let text = drawn(&format!("- one\n\n  ```tracefig source\n  {inner}\n  ```\n  two\n"), "html");
    let begin =
        format!("- one\n\n  ```toml\n  {inner}\n  ```\n\n  <figure class=\"tracefig tracefig-book\">");
    assert!(text.starts_with(&begin), "{text}");
    assert!(text.ends_with("</figure>\n\n  two\n"), "{}", &text[text.len() - 40..]);
}

#[test]
fn values_are_those_of_the_answer() {
    let text = drawn("It is {{=circles.toml separation:.2}}, `{{=circles.toml x}}`, \\{{=y z}}.\n", "html");
    assert_eq!(text, "It is 1.00, `{{=circles.toml x}}`, {{=y z}}.\n");
    let told = refused("One\n\nIt is {{=circles.toml sepration}}.\n");
    assert!(told.contains("unknown value `sepration`; did you mean `separation`?"), "{told}");
    assert!(told.contains("page.md:3"), "{told}");
}

#[test]
fn links_out_of_the_book_lead_to_where_its_code_is_shown() {
    let folder = folder_with("circles.toml", CIRCLES);
    let page = "See [`a.rs`](../../src/a.rs), [two](two.md) and `[b](../../b.rs)`.\n\n\
                {{#tracefig circles.toml}}\n\n| [c](../../c.rs#L7) |\n|---|\n| [d](https://d.org/../e) |\n";
    let built = |table: Value| {
        let config = json!({"book": {"src": ""}, "preprocessor": {"tracefig": table}});
        page_in(folder.path(), page, "html", &config)
    };
    let text = |ran: &Ran| contents(&came_back(ran)["items"]).remove(0);
    assert!(text(&built(json!({}))).contains("[`a.rs`](../../src/a.rs)"), "without the key they stay");
    let text = text(&built(json!({"code": "https://x.org/it/blob/main/docs/guide/"})));
    let at = "https://x.org/it/blob/main/";
    assert!(text.starts_with(&format!("See [`a.rs`]({at}src/a.rs), [two](two.md) and `[b](../../b.rs)`.")));
    assert!(text.ends_with(&format!("| [c]({at}c.rs#L7) |\n|---|\n| [d](https://d.org/../e) |\n")), "{text}");
    let ran = built(json!({"code": "https://x.org"}));
    assert_eq!(ran.code, Some(1));
    assert!(ran.err.contains("leads above `code`") && ran.err.contains("--> page.md:1"), "{}", ran.err);
}

#[test]
fn what_is_wrong_is_told_with_the_line_of_the_page() {
    let fence = "# One\n\n```tracefig\ntitle = \"x\"\n[shapes.A]\nkind = \"circel\"\n```\n";
    let told = refused(fence);
    assert!(told.contains("--> page.md:6:8") && told.contains("6 | kind = \"circel\""), "{told}");
    assert!(told.contains("asked for at page.md:3"), "{told}");
    let told = refused("a\n\n{{#tracefig no.toml}}\n\n{{#tracefig circles.toml wdth=3}}\n");
    assert!(told.contains("unreadable-file") && told.contains("asked for at page.md:3"), "{told}");
    assert!(
        told.contains("unknown attribute `wdth`") && told.contains("--> page.md:5"),
        "all at once: {told}"
    );
    assert!(refused("in {{#tracefig circles.toml}} a line\n").contains("a line of its own"));
}

#[test]
fn the_page_of_a_project_is_that_of_its_figures_in_a_book() {
    let folder = folder_with("circles.toml", CIRCLES);
    fs::write(folder.path().join("tracefig.toml"), "canvas.width = 500").unwrap();
    let chapter = json!({"content": "{{#tracefig circles.toml}}\n", "sub_items": [], "path": "page.md"});
    let context = json!({"root": folder.path(), "renderer": "html", "config": {"book": {"src": ""}}});
    let mail = json!([context, {"sections": [{"Chapter": chapter}]}]).to_string();
    let book = came_back(&run_on(&mut mdbook(folder.path()), mail));
    assert!(contents(&book["sections"])[0].contains(" width=\"500\""));
}

#[test]
fn every_renderer_is_served_and_what_is_no_book_is_refused() {
    let here = Path::new(".");
    for renderer in ["html", "epub", "anything"] {
        assert_eq!(run(tracefig(here).args(["mdbook", "supports", renderer])).code, Some(0));
    }
    assert_eq!(run(tracefig(here).args(["mdbook", "supports"])).code, Some(2));
    let ran = run_on(tracefig(here).arg("mdbook"), "{}");
    assert_eq!(ran.code, Some(1));
    assert!(ran.err.contains("expected `[context, book]` from mdBook"), "{}", ran.err);
}

#[test]
fn a_book_that_is_built_again_has_the_same_figures_from_what_was_kept() {
    let folder = folder_with("circles.toml", CIRCLES);
    let cache = tempfile::tempdir().unwrap();
    let chapter = json!({"content": "{{#tracefig circles.toml}}\n", "sub_items": [], "path": "page.md"});
    let context = json!({"root": folder.path(), "renderer": "html", "config": {"book": {"src": ""}}});
    let mail = json!([context, {"items": [{"Chapter": chapter}]}]).to_string();
    let built = || run_on(mdbook(folder.path()).env("XDG_CACHE_HOME", cache.path()), &mail);
    let books = cache.path().join("tracefig/books");
    let kept = || {
        let files: Vec<PathBuf> = books.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
        assert_eq!(files.len(), 1, "{files:?}");
        files[0].clone()
    };
    let first = built();
    came_back(&first);
    let text = fs::read_to_string(kept()).unwrap();
    assert_eq!(built().out, first.out);
    assert_eq!(fs::read_to_string(kept()).unwrap(), text);
    fs::write(kept(), text.replace("#bc0d2a", "#bc0d2b").replace("#BC0D2A", "#BC0D2B")).unwrap();
    assert_ne!(built().out, first.out, "what was kept is taken");
    fs::write(folder.path().join("circles.toml"), CIRCLES.replace("radius = 2", "radius = 1.5")).unwrap();
    assert!(!built().out.contains("3161e") && !built().out.contains("3161E"), "another scene is drawn anew");
    fs::write(kept(), "broken").unwrap();
    let last = built();
    assert!(came_back(&last).to_string().contains("<svg "));
    assert_ne!(last.out, first.out);
}

#[test]
fn a_warning_is_told_by_every_build_of_the_place_where_the_scene_is_now() {
    let folder = folder_with("empty.toml", "");
    let cache = tempfile::tempdir().unwrap();
    let built = |above: &str| {
        let scene = format!("{CIRCLES}[labels]\nA = {{ text = \"far\", at = [900, 0] }}\n");
        let content = format!("{above}```tracefig\n{scene}```\n");
        fs::write(folder.path().join("page.md"), &content).unwrap();
        let chapter = json!({"content": content, "sub_items": [], "path": "page.md"});
        let context = json!({"root": folder.path(), "renderer": "html", "config": {"book": {"src": ""}}});
        let mail = json!([context, {"items": [{"Chapter": chapter}]}]).to_string();
        run_on(mdbook(folder.path()).env("XDG_CACHE_HOME", cache.path()), &mail)
    };
    let (first, again, below) = (built(""), built(""), built("A line.\n\n"));
    assert!(first.code == Some(0) && first.err.starts_with("warning["), "{}", first.err);
    assert_eq!((&again.out, &again.err), (&first.out, &first.err));
    let line = |ran: &Ran| {
        let (_, rest) = ran.err.split_once("page.md:").unwrap();
        rest.split(':').next().unwrap().parse::<usize>().unwrap()
    };
    assert_eq!(line(&below), line(&first) + 2);
    // The picture with its warning was kept: what lies there is taken.
    let books = cache.path().join("tracefig/books");
    let kept = books.read_dir().unwrap().next().unwrap().unwrap().path();
    let text = fs::read_to_string(&kept).unwrap();
    assert!(text.contains("warning[") && text.contains("#bc0d2a"));
    fs::write(&kept, text.replace("#bc0d2a", "#bc0d2b")).unwrap();
    let taken = built("A line.\n\n");
    assert!(taken.out.contains("#bc0d2b") && taken.err == below.err);
}
