//! Pages whose links lead somewhere, whose scenes are drawn and whose list is whole.

use std::collections::BTreeSet;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use serde_json::{Value, json};
use tracefig::live::Live;

use crate::{src, tracefig};

/// The Markdown files of a folder and of those in it.
fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            pages(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "md") {
            found.push(path);
        }
    }
}

/// Every page with its text, by path.
pub(crate) fn all() -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    pages(&src(), &mut found);
    found.sort();
    found.into_iter().map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect()
}

/// A page's text without its fenced blocks, and those: what their fences say, and their texts.
fn parted(text: &str) -> (String, Vec<(String, String)>) {
    let (mut prose, mut blocks, mut open) = (String::new(), Vec::new(), None::<(String, String)>);
    for line in text.lines() {
        match (line.trim_start().strip_prefix("```"), &mut open) {
            (Some(info), None) => open = Some((info.to_owned(), String::new())),
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (None, Some((_, block))) => block.extend([line, "\n"]),
            (None, None) => prose.extend([line, "\n"]),
        }
    }
    (prose, blocks)
}

/// The anchors of a page: its headings as mdBook names them.
fn anchors(text: &str) -> BTreeSet<String> {
    let (prose, _) = parted(text);
    let anchor = |heading: &str| {
        let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
    };
    prose.lines().filter(|l| l.starts_with('#')).map(|l| anchor(l.trim_start_matches('#'))).collect()
}

#[test]
fn every_link_leads_to_a_file_and_every_anchor_to_a_heading() {
    let (mut astray, mut links) = (Vec::new(), 0);
    for (path, text) in all() {
        let (prose, _) = parted(&text);
        for part in prose.split("](").skip(1) {
            let target = part.split(')').next().unwrap();
            if target.contains("://") {
                continue;
            }
            links += 1;
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let file = if file.is_empty() { path.clone() } else { path.with_file_name("").join(file) };
            let is_there = file.exists()
                && (anchor.is_empty() || anchors(&fs::read_to_string(&file).unwrap()).contains(anchor));
            if !is_there {
                astray.push(format!("{}: {target}", path.display()));
            }
        }
    }
    assert!(astray.is_empty(), "not there:\n{}", astray.join("\n"));
    assert!(links >= 40, "{links} links");
}

#[test]
fn the_summary_lists_every_page_once() {
    let summary = fs::read_to_string(src().join("SUMMARY.md")).unwrap();
    let mut listed: Vec<PathBuf> =
        summary.split("](").skip(1).map(|part| src().join(part.split(')').next().unwrap())).collect();
    listed.sort();
    let there: Vec<PathBuf> =
        all().into_iter().map(|(path, _)| path).filter(|path| !path.ends_with("SUMMARY.md")).collect();
    assert_eq!(listed, there);
}

/// The texts of pages as the preprocessor leaves them, with more in its table.
pub(crate) fn built(pages: &[(PathBuf, String)], more: (&str, &str)) -> Vec<String> {
    let page = |(path, text): &(PathBuf, String)| {
        let path = path.strip_prefix(src()).unwrap();
        json!({"Chapter": {"content": text, "sub_items": [], "path": path}})
    };
    let items: Vec<Value> = pages.iter().map(page).collect();
    let config = fs::read_to_string(src().with_file_name("book.toml")).unwrap();
    let mut config: Value = toml::from_str(&config).unwrap();
    config["preprocessor"]["tracefig"][more.0] = json!(more.1);
    let context = json!({"root": src().parent().unwrap(), "renderer": "html", "config": config});
    let mut command = tracefig();
    command.arg("mdbook").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut running = command.spawn().unwrap();
    let mut stdin = running.stdin.take().unwrap();
    let mail = json!([context, {"items": items}]).to_string();
    let writing = std::thread::spawn(move || stdin.write_all(mail.as_bytes()).unwrap());
    let ran = running.wait_with_output().unwrap();
    writing.join().unwrap();
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    let book: Value = serde_json::from_slice(&ran.stdout).unwrap();
    let text = |item: &Value| item["Chapter"]["content"].as_str().unwrap().to_owned();
    book["items"].as_array().unwrap().iter().map(text).collect()
}

#[test]
fn links_to_code_of_a_published_guide_lead_to_files_of_the_repository() {
    let code = "https://example.org/it/blob/main/";
    let linked: Vec<(PathBuf, String)> =
        all().into_iter().map(|(path, text)| (path, text.replace("{{#tracefig", "{{#include"))).collect();
    let texts = built(&linked, ("code", &format!("{code}guide")));
    let (mut led, root) = (0, src().join("../.."));
    for (text, (path, _)) in texts.iter().zip(&linked) {
        let (prose, _) = parted(text);
        for target in prose.split("](").skip(1).map(|part| part.split(')').next().unwrap()) {
            if let Some(file) = target.strip_prefix(code) {
                assert!(root.join(file).exists(), "{}: {target}", path.display());
                led += 1;
            }
            let below = path.strip_prefix(src()).unwrap().components().count();
            assert!(!target.starts_with(&"../".repeat(below)), "{}: {target}", path.display());
        }
    }
    assert!(led >= 30, "{led} links to code");
}

#[test]
fn the_guide_is_drawn_whole() {
    let pages = all();
    let texts = built(&pages, ("", ""));
    let asked: usize = pages
        .iter()
        .map(|(_, text)| {
            let (prose, blocks) = parted(text);
            let fenced = blocks.iter().filter(|(info, _)| info.starts_with("tracefig"));
            // An exercise is a question and a key.
            prose.matches("\n{{#tracefig ").count() + prose.matches(" exercise}}").count() + fenced.count()
        })
        .sum();
    let drawn: usize = texts.iter().map(|text| text.matches("<figure class=\"tracefig").count()).sum();
    assert_eq!(drawn, asked);
    assert!(drawn >= 60, "{drawn} figures");
    let live: usize = texts.iter().map(|text| same_live(text)).sum();
    assert!(live >= 24, "{live} live figures");
}

/// How many live figures a page has; each must draw the picture that stands there.
fn same_live(text: &str) -> usize {
    let parts = text.split("<div class=\"tracefig-live\">").skip(1);
    let same = |part: &str| {
        let (figure, rest) = part.split_once("<script type=\"application/json\">").unwrap();
        let request = rest.split_once("</script>").unwrap().0;
        let frame = Live::open(request).unwrap().draw().unwrap();
        assert!(figure.ends_with(&format!("{}</figure>", frame.svg)), "{}", &request[..200]);
    };
    parts.map(same).count()
}

#[test]
fn every_author_that_a_chapter_cites_is_among_the_sources() {
    let sources = fs::read_to_string(src().join("sources.md")).unwrap();
    let (mut missing, mut cited) = (Vec::new(), 0);
    for (path, text) in all().into_iter().filter(|(path, _)| !path.ends_with("sources.md")) {
        let (prose, _) = parted(&text);
        let words: Vec<&str> = prose.split_whitespace().collect();
        for pair in words.windows(2) {
            let year: String = pair[1].chars().take_while(char::is_ascii_digit).collect();
            let is_year = year.len() == 4 && (year.starts_with("19") || year.starts_with("20"));
            let name: String = pair[0].chars().filter(|c| c.is_alphabetic()).collect();
            if is_year && name.starts_with(char::is_uppercase) {
                cited += 1;
                if !sources.contains(&format!("{name} {year}**")) {
                    missing.push(format!("{}: {name} {year}", path.display()));
                }
            }
        }
    }
    assert!(missing.is_empty(), "no source:\n{}", missing.join("\n"));
    assert!(cited >= 12, "{cited} citations");
}
