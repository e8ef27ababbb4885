//! No text of a scene becomes a script or a reference to elsewhere in an SVG or HTML file: it is refused, or
//! it is text.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::path::Path;

use roxmltree::{Document, Node};

use crate::{run, tracefig};

/// Texts that would act if they were not text.
const HOSTILE: &[&str] = &[
    "<script>alert(1)</script>",
    "</title></desc></svg><script src='https://e.example/x.js'></script>",
    "]]><script>alert(1)</script><![CDATA[",
    "--><img src=x onerror=alert(1)><!--",
    "\" onload=\"alert(1)",
    "' onclick='alert(1)' x='",
    "</style><style>@import url(https://e.example/x.css);",
    "&lt;script&gt;&#60;script&#62;&xxe;",
    "<!ENTITY xxe SYSTEM 'file:///etc/passwd'>",
    "$\\href{javascript:alert(1)}{x}$",
    "$\\text{<script>alert(1)</script>}$",
    "javascript:alert(1)",
    "{=<script>}",
];

/// Scenes with a place for TEXT; those with `true` take any text there.
const FIELDS: &[(&str, &str, bool)] = &[
    ("title", "title = TEXT\nBODIES\nPANEL", true),
    ("caption", "caption = TEXT\nBODIES\nPANEL", true),
    ("panel", "BODIES\nPANEL\ntitle = TEXT", true),
    ("caption of a panel", "BODIES\nPANEL\ncaption = TEXT", true),
    ("note", "BODIES\n[[panels]]\nlayers = [{ layer = 'note', lines = [TEXT] }]", true),
    ("label", "BODIES\nPANEL\n[labels]\nA = TEXT", true),
    ("key of a label", "BODIES\nPANEL\n[labels]\nTEXT = 'x'", false),
    ("shape", "BODIES\n[shapes.TEXT]\nkind = 'circle'\nradius = 1\nPANEL", false),
    ("theme", "canvas.theme = TEXT\nBODIES\nPANEL", false),
];

const PANEL: &str = "[[panels]]\nlayers = ['shapes']\n";

const BODIES: &str = "[shapes.A]\nkind = 'circle'\nradius = 1\n[shapes.B]\nkind = 'circle'\nradius = 1\nposition = [3, 0]\n\
    [query]\nkind = 'separation'\nof = ['A', 'B']\n";

/// Elements that our SVGs are made of.
const ELEMENTS: &[&str] = &[
    "svg", "title", "desc", "metadata", "style", "defs", "g", "path", "circle", "ellipse", "rect", "line",
    "use", "clipPath", "pattern", "text", "tspan",
];

/// Elements of our HTML around the SVG.
const PAGE: &[&str] = &[
    "html",
    "head",
    "meta",
    "title",
    "style",
    "body",
    "main",
    "figure",
    "figcaption",
    "p",
    "details",
    "summary",
    "text",
    "tspan",
];

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// What of a style or an attribute leads elsewhere.
fn leads_away(text: &str) -> bool {
    let text = text.to_lowercase();
    text.contains("@import")
        || text.contains("javascript:")
        || text.split("url(").skip(1).any(|to| !to.starts_with('#'))
}

fn faults_of(node: Node<'_, '_>) -> Vec<String> {
    let name = node.tag_name().name();
    let mut faults = Vec::new();
    if !ELEMENTS.contains(&name) {
        faults.push(format!("an element {name}"));
    }
    if name == "style" && node.text().is_some_and(leads_away) {
        faults.push("a style that leads away".to_owned());
    }
    for attribute in node.attributes() {
        let (key, value) = (attribute.name(), attribute.value());
        // Words for a screen reader are text wherever they stand.
        let is_text = key.starts_with("aria-");
        if key.starts_with("on")
            || (key == "href" && !value.starts_with('#'))
            || (!is_text && leads_away(value))
        {
            faults.push(format!("{name} {key}={value}"));
        }
    }
    faults
}

fn faults_of_svg(text: &str) -> Vec<String> {
    match Document::parse(text) {
        Ok(document) => document.descendants().filter(Node::is_element).flat_map(faults_of).collect(),
        Err(error) => vec![error.to_string()],
    }
}

fn faults_of_html(text: &str) -> Vec<String> {
    let (from, to) = (text.find("<svg").unwrap(), text.rfind("</svg>").unwrap() + "</svg>".len());
    let mut faults = faults_of_svg(&text[from..to]);
    let around = format!("{}{}", &text[..from], &text[to..]);
    for tag in around.split('<').skip(1) {
        let tag = &tag[..tag.find('>').unwrap_or(tag.len())];
        let name = tag.trim_start_matches('/').split(char::is_whitespace).next().unwrap();
        let is_ours = PAGE.contains(&name) || tag == "!DOCTYPE html";
        if !is_ours || tag.contains(" on") || tag.contains("href") || tag.contains("src=") {
            faults.push(format!("<{tag}>"));
        }
    }
    faults
}

/// The files that were drawn of a scene, and what is wrong with them.
fn draw(folder: &Path, file: &str) -> (usize, Vec<String>) {
    let ran = run(tracefig(folder).args([
        "render",
        "--format",
        "svg,html",
        "--theme",
        "light,auto",
        "-o",
        "out",
        "--",
        file,
    ]));
    let mut faults = Vec::new();
    if !matches!(ran.code, Some(0 | 1)) {
        faults.push(ran.err);
    }
    let mut drawn = 0;
    for entry in std::fs::read_dir(folder.join("out")).into_iter().flatten() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let is_html = path.extension().is_some_and(|e| e == "html");
        faults.extend(if is_html { faults_of_html(&text) } else { faults_of_svg(&text) });
        drawn += 1;
        std::fs::remove_file(path).unwrap();
    }
    (drawn, faults)
}

#[test]
fn no_text_of_a_scene_becomes_a_script_or_leads_elsewhere() {
    let folder = tempfile::tempdir().unwrap();
    let mut wrong = Vec::new();
    let mut drawn_of = vec![0; FIELDS.len()];
    for text in HOSTILE {
        for (&(field, scene, _), drawn) in FIELDS.iter().zip(&mut drawn_of) {
            let scene =
                scene.replace("BODIES", BODIES).replace("PANEL", PANEL).replace("TEXT", &quoted(text));
            std::fs::write(folder.path().join("s.toml"), scene).unwrap();
            let (files, faults) = draw(folder.path(), "s.toml");
            *drawn += files;
            wrong.extend(faults.into_iter().map(|fault| format!("{field} {text}: {fault}")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Where any text may stand, these were drawn, so that something was looked at.
    for (&(field, _, takes_any), drawn) in FIELDS.iter().zip(drawn_of) {
        assert!(!takes_any || drawn > 20, "{field}: {drawn} files");
    }
}

#[test]
fn no_name_of_a_file_becomes_a_script_or_leads_elsewhere() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["x\" onload=\"alert(1).toml", "<script>alert(1).toml", "a&b';.toml", "--><img src=x.toml"] {
        std::fs::write(folder.path().join(name), format!("{BODIES}{PANEL}")).unwrap();
        let (drawn, faults) = draw(folder.path(), name);
        assert_eq!((drawn, faults), (4, Vec::new()), "{name}");
    }
}

#[test]
fn a_script_would_be_seen() {
    let svg = |inside: &str| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:x='http://www.w3.org/1999/xlink'>{inside}</svg>"
        )
    };
    for bad in [
        "<script/>",
        "<g onload='a()'/>",
        "<use x:href='https://e.example/#a'/>",
        "<path fill='url(https://e.example)'/>",
        "<style>@import 'x';</style>",
        "<foreignObject/>",
    ] {
        assert_eq!(faults_of_svg(&svg(bad)).len(), 1, "{bad}");
        assert_eq!(faults_of_html(&format!("<html>{}</html>", svg(bad))).len(), 1, "{bad}");
    }
    assert_eq!(faults_of_html(&format!("<p onclick='a()'>{}<script>", svg(""))).len(), 2);
    assert!(faults_of_svg(&svg("<use x:href='#a'/><path fill='url(#b)'/>")).is_empty());
}
