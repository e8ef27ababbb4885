//! `tracefig qti`: packages of items as a learning platform reads them.

use std::collections::BTreeMap;
use std::io::Read;
use std::path::Path;

use roxmltree::{Document, Node};
use serde_json::Value;

use crate::moodle::exercise;
use crate::{CIRCLES, folder_with, run, tracefig};

/// The files of an archive, by the headers before each of them.
fn files(archive: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let two = |at: usize| usize::from(u16::from_le_bytes([archive[at], archive[at + 1]]));
    let four = |at: usize| two(at) | two(at + 2) << 16;
    let (mut at, mut files) = (0, BTreeMap::new());
    while archive[at..].starts_with(b"PK\x03\x04") {
        let begin = at + 30 + two(at + 26) + two(at + 28);
        let name = String::from_utf8(archive[at + 30..at + 30 + two(at + 26)].to_vec()).unwrap();
        let bytes = &archive[begin..begin + four(at + 18)];
        let mut content = Vec::new();
        if two(at + 8) == 0 {
            content.extend(bytes);
        } else {
            flate2::read::DeflateDecoder::new(bytes).read_to_end(&mut content).unwrap();
        }
        assert_eq!(content.len(), four(at + 22), "{name}");
        assert!(files.insert(name, content).is_none(), "a name stands twice");
        at = begin + four(at + 18);
    }
    files
}

/// The files of the package of scenes.
fn package(folder: &Path, arguments: &[&str]) -> BTreeMap<String, Vec<u8>> {
    let out = folder.join("package.zip");
    let ran = run(tracefig(folder).arg("qti").args(arguments).arg("-o").arg(&out));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert!(ran.out.ends_with("package.zip\n"), "{}", ran.out);
    let bytes = std::fs::read(&out).unwrap();
    std::fs::remove_file(out).unwrap();
    files(&bytes)
}

fn text<'f>(files: &'f BTreeMap<String, Vec<u8>>, name: &str) -> &'f str {
    std::str::from_utf8(&files[name]).unwrap()
}

fn find<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Node<'a, 'i> {
    node.descendants().find(|node| node.tag_name().name() == name).unwrap()
}

/// The items of a package in the order of its manifest, which lists every other file once or more.
fn items(files: &BTreeMap<String, Vec<u8>>) -> Vec<&str> {
    let manifest = Document::parse(text(files, "imsmanifest.xml")).unwrap();
    let listed = |name: &str| {
        let all = manifest.descendants().filter(|node| node.tag_name().name() == name);
        all.map(|node| node.attribute("href").unwrap().to_owned()).collect::<Vec<_>>()
    };
    let mut all = listed("file");
    all.push("imsmanifest.xml".to_owned());
    all.sort();
    all.dedup();
    assert_eq!(all, files.keys().cloned().collect::<Vec<_>>());
    listed("resource").iter().map(|name| text(files, name)).collect()
}

#[test]
fn the_answer_of_an_item_is_that_of_solve_and_its_body_has_no_trace_of_it() {
    let folder = folder_with("s.toml", &exercise());
    let files = package(folder.path(), &["s.toml"]);
    let solved = run(tracefig(folder.path()).args(["solve", "--json", "s.toml"]));
    let solved: Value = serde_json::from_str(&solved.out).unwrap();
    let [distance, normal] = items(&files)[..] else { panic!("two values are asked for") };
    for (item, exact) in
        [(distance, &solved["result"]["separation_bounds"][0]), (normal, &solved["result"]["normal"][0])]
    {
        let item = Document::parse(item).unwrap();
        let root = item.root_element();
        assert_eq!(root.tag_name().namespace(), Some("http://www.imsglobal.org/xsd/imsqti_v2p1"));
        let answer: f64 =
            find(root, "correctResponse").descendants().next_back().unwrap().text().unwrap().parse().unwrap();
        assert!((answer - exact.as_f64().unwrap()).abs() < 1e-14, "{answer} {exact}");
        let equal = find(root, "equal");
        assert_eq!(equal.attribute("toleranceMode"), Some("absolute"));
        let tolerance: f64 = equal.attribute("tolerance").unwrap().parse().unwrap();
        assert!(answer.abs() == 1.0 && (0.005..0.006).contains(&tolerance), "{answer} {tolerance}");
        let feedback = find(root, "modalFeedback");
        assert!(feedback.children().filter(Node::is_element).count() > 2);
        assert!(find(feedback, "p").text().unwrap().starts_with("Answer: "));
        assert_eq!(
            find(find(root, "itemBody"), "textEntryInteraction").attribute("responseIdentifier"),
            Some("RESPONSE")
        );
        for name in ["outcomeIdentifier", "identifier"] {
            let said = feedback.attribute(name).unwrap();
            let set = root.descendants().rfind(|node| node.tag_name().name() == "setOutcomeValue").unwrap();
            assert!(
                set.attribute("identifier") == Some(said) || find(set, "baseValue").text() == Some(said),
                "{said}"
            );
        }
    }
    // Nothing of what is asked moves with what only the answer knows: the key's words and way.
    let told = exercise().replace("It is", "It surely is").replace("$d = ", "$D = ");
    let told = told.replace("[exercise]", "algorithm = \"gjk\"\n[exercise]");
    std::fs::write(folder.path().join("s.toml"), told).unwrap();
    let other = package(folder.path(), &["s.toml"]);
    let asked = |item: &str| {
        let body = item.split_once("<itemBody>").unwrap().1.split_once("</itemBody>").unwrap().0.to_owned();
        assert!(!body.contains("nswer") && !body.contains("It is") && !body.contains("{="), "{body}");
        body
    };
    assert_eq!(asked(items(&other)[0]), asked(distance));
    let image = |item: &str, after: &str| {
        let at = item.split_once(after).unwrap().1.split_once("src=\"").unwrap().1;
        at.split_once('"').unwrap().0.to_owned()
    };
    let [question, key] = ["<itemBody>", "<modalFeedback"].map(|after| image(distance, after));
    assert!(question != key && image(items(&other)[0], "<modalFeedback") != key, "the key shows them");
    for name in [question, key] {
        let reader = png::Decoder::new(std::io::Cursor::new(&files[&name])).read_info().unwrap();
        assert!(reader.info().uncompressed_latin1_text.is_empty() && reader.info().utf8_text.is_empty());
    }
}

#[test]
fn variants_are_items_of_their_own_and_the_same_bytes_again() {
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("guide/exercises");
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str| {
        let out = folder.path().join(name);
        let scenes = ["qti", "circles.toml", "turned-box.toml", "--seed", "1..2", "-o"];
        assert_eq!(run(tracefig(&guide).args(scenes).arg(&out)).code, Some(0));
        std::fs::read(out).unwrap()
    };
    let archive = write("a.zip");
    assert!(archive == write("b.zip"));
    let files = files(&archive);
    let titles: Vec<_> = items(&files)
        .into_iter()
        .map(|item| Document::parse(item).unwrap().root_element().attribute("title").unwrap().to_owned())
        .collect();
    let box_of = "The bounding box of a turned box";
    assert_eq!(titles[..2], ["Two overlapping circles 01: depth", "Two overlapping circles 02: depth"]);
    assert_eq!(
        titles[2..],
        ["01: h.x", "01: h.y", "02: h.x", "02: h.y"].map(|end| format!("{box_of} {end}"))
    );
}

#[test]
fn what_is_no_exercise_is_refused_nothing_is_written_and_no_scene_is_replaced() {
    let folder = folder_with("plain.toml", CIRCLES);
    std::fs::write(folder.path().join("s.toml"), exercise()).unwrap();
    let qti = |arguments: &[&str]| run(tracefig(folder.path()).arg("qti").args(arguments));
    let ran = qti(&["s.toml", "plain.toml", "-o", "x.zip"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert!(ran.err.contains("plain.toml is no exercise"), "{}", ran.err);
    assert!(!folder.path().join("x.zip").exists());
    let ran = qti(&["s.toml", "-o", "s.toml"]);
    assert!(ran.code == Some(1) && ran.err.contains("s.toml is a scene of this run"), "{}", ran.err);
    assert_eq!(std::fs::read_to_string(folder.path().join("s.toml")).unwrap(), exercise());
    assert_eq!(qti(&["s.toml", "-o", "no/such/x.zip"]).code, Some(74));
    assert_eq!(qti(&["s.toml"]).code, Some(2));
}
