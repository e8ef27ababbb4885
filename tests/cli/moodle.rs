//! `tracefig moodle`: files of questions as a question bank reads them.

use std::path::Path;

use roxmltree::{Document, Node};
use serde_json::Value;

use crate::{CIRCLES, folder_with, run, tracefig};

/// Two circles 1 apart whose every text tells of the answer, 1 m and the normal.
pub(crate) fn exercise() -> String {
    let told = "title = \"They are {=d} apart\"\nheadline = \"It is {=d}\"";
    let circles = CIRCLES.replace("title = \"Two circles\"", told);
    let exercise = "ask = [\"d\", \"n.x\"]\nlength_unit = \"m\"";
    format!("{circles}[exercise]\n{exercise}\n[labels]\nd = \"$d = {{=d}}$\"\n")
}

fn child<'a, 'i>(node: Node<'a, 'i>, names: &[&str]) -> Node<'a, 'i> {
    names.iter().fold(node, |node, name| node.children().find(|child| child.has_tag_name(*name)).unwrap())
}

fn text<'a>(node: Node<'a, '_>, names: &[&str]) -> &'a str {
    child(node, names).text().unwrap_or("")
}

fn number(node: Node<'_, '_>, names: &[&str]) -> f64 {
    text(node, names).parse().unwrap()
}

/// The questions of a file, after its categories were counted.
fn questions<'a, 'i>(document: &'a Document<'i>, categories: usize) -> Vec<Node<'a, 'i>> {
    let of = |kind: &str| {
        let all = document.root_element().children().filter(Node::is_element);
        all.filter(|node| node.attribute("type") == Some(kind)).collect::<Vec<_>>()
    };
    assert_eq!(of("category").len(), categories);
    let all = document.root_element().children().filter(Node::is_element).count();
    let numerical = of("numerical");
    assert_eq!(all, categories + numerical.len());
    numerical
}

#[test]
fn the_answer_of_a_file_is_that_of_solve_and_its_question_has_no_trace_of_it() {
    let folder = folder_with("s.toml", &exercise());
    let file = run(tracefig(folder.path()).args(["moodle", "s.toml"]));
    assert_eq!((file.code, file.err.as_str()), (Some(0), ""));
    let solved = run(tracefig(folder.path()).args(["solve", "--json", "s.toml"]));
    let solved: Value = serde_json::from_str(&solved.out).unwrap();
    let document = Document::parse(&file.out).unwrap();
    let [distance, normal] = questions(&document, 1)[..] else { panic!("{}", file.out) };
    for (question, bounds) in [
        (distance, &solved["result"]["separation_bounds"]),
        (normal, &serde_json::json!([solved["result"]["normal"][0], solved["result"]["normal"][0]])),
    ] {
        let (answer, tolerance) =
            (number(question, &["answer", "text"]), number(question, &["answer", "tolerance"]));
        let [lo, hi] = [0, 1].map(|i| bounds[i].as_f64().unwrap());
        assert!((answer - lo).abs() < 1e-14 && (answer - hi).abs() < 1e-14, "{answer} {lo} {hi}");
        // A number rounded to three digits is right, one of another third digit is wrong.
        assert!(answer.abs() == 1.0 && (0.005..0.006).contains(&tolerance), "{answer} {tolerance}");
        assert_eq!(text(question, &["showunits"]), "3");
    }
    for question in [distance, normal] {
        let asked = text(question, &["questiontext", "text"]);
        assert!(
            !asked.contains("It is") && !asked.contains("{=") && asked.contains("@@PLUGINFILE@@/figure.png")
        );
        assert_eq!(
            text(question, &["name", "text"]).split(": ").next(),
            Some("s"),
            "the title tells the answer"
        );
        let told = text(question, &["generalfeedback", "text"]);
        assert!(told.contains("Answer: ") && told.contains("<ol>") && !asked.contains("nswer"), "{told}");
    }
    assert!(
        text(distance, &["questiontext", "text"]).contains("apart, or how deep they overlap) in m, to three")
    );
    // Nothing of the text or the picture moves with what only the answer knows: the key's words and way.
    let told = exercise().replace("It is", "It surely is").replace("$d = ", "$D = ");
    let told = told.replace("[exercise]", "algorithm = \"gjk\"\n[exercise]");
    std::fs::write(folder.path().join("s.toml"), told).unwrap();
    let other = run(tracefig(folder.path()).args(["moodle", "s.toml"]));
    let other = Document::parse(&other.out).unwrap();
    let other = questions(&other, 1)[0];
    for part in ["text", "file"] {
        assert_eq!(text(other, &["questiontext", part]), text(distance, &["questiontext", part]));
    }
    let key = |question: Node<'_, '_>| text(question, &["generalfeedback", "file"]).to_owned();
    assert!(key(other) != key(distance), "the key shows them");
}

#[test]
fn variants_and_scenes_stand_in_one_file() {
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("guide/exercises");
    let file = run(tracefig(&guide).args(["moodle", "circles.toml", "turned-box.toml", "--seed", "2,1..2"]));
    assert_eq!((file.code, file.err.as_str()), (Some(0), ""));
    let document = Document::parse(&file.out).unwrap();
    let all = questions(&document, 2);
    let names: Vec<_> = all.iter().map(|&question| text(question, &["name", "text"])).collect();
    let box_of = "The bounding box of a turned box";
    assert_eq!(names[..2], ["Two overlapping circles 01: depth", "Two overlapping circles 02: depth"]);
    assert_eq!(names[2..], ["01: h.x", "01: h.y", "02: h.x", "02: h.y"].map(|end| format!("{box_of} {end}")));
    let asked = |i: usize| text(all[i], &["questiontext", "text"]);
    assert!(asked(0) != asked(1) && asked(2).contains("half the width"));
    assert!(text(all[0], &["questiontext", "file"]) != text(all[1], &["questiontext", "file"]));
    // A number stands for one variant, whatever else is asked for.
    let alone = run(tracefig(&guide).args(["moodle", "circles.toml", "--seed", "2"]));
    let alone = Document::parse(&alone.out).unwrap();
    let alone = questions(&alone, 1)[0];
    assert_eq!(text(alone, &["answer", "text"]), text(all[1], &["answer", "text"]));
    assert_eq!(text(alone, &["questiontext", "text"]), asked(1));
}

#[test]
fn a_scene_without_variants_does_not_stop_the_others() {
    let folder = folder_with(
        "turning.toml",
        "exercise.ask = \"bound\"\n[shapes.A]\nkind = \"box\"\n\
        half_extents = [1, 0.5]\nangular_velocity_deg = 120\n[query]\nkind = \"motion-bound\"\nof = [\"A\"]\n",
    );
    std::fs::write(folder.path().join("s.toml"), exercise()).unwrap();
    let moodle =
        |scenes: &[&str]| run(tracefig(folder.path()).arg("moodle").args(scenes).args(["--seed", "1"]));
    let both = moodle(&["turning.toml", "s.toml"]);
    assert_eq!(both.code, Some(1));
    assert!(
        both.err.contains("turning.toml: 0 of 1 variants") && both.err.contains("a body turns"),
        "{}",
        both.err
    );
    let document = Document::parse(&both.out).unwrap();
    let [one, two] = questions(&document, 1)[..] else { panic!("{}", both.out) };
    // Each asks for its own number alone.
    let asked = [one, two].map(|question| text(question, &["questiontext", "text"]));
    assert!(asked[0].contains("how far") && !asked[1].contains("how far"), "{asked:?}");
    let none = moodle(&["turning.toml"]);
    assert_eq!((none.code, none.out.as_str()), (Some(1), ""));
}

#[test]
fn a_figure_of_a_file_is_a_whole_png_that_says_nothing_of_itself() {
    let folder = folder_with("s.toml", &exercise());
    let file = run(tracefig(folder.path()).args(["moodle", "s.toml"]));
    let document = Document::parse(&file.out).unwrap();
    let files: Vec<_> = document.descendants().filter(|node| node.has_tag_name("file")).collect();
    assert!(!files.is_empty(), "{}", file.out);
    for file in files {
        assert_eq!((file.attribute("path"), file.attribute("encoding")), (Some("/"), Some("base64")));
        let bytes = bytes_of(file.text().unwrap());
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        let mut rows = 0;
        while reader.next_row().unwrap().is_some() {
            rows += 1;
        }
        let info = reader.info();
        assert_eq!(rows, info.height);
        assert!(info.uncompressed_latin1_text.is_empty() && info.utf8_text.is_empty());
        assert!(info.compressed_latin1_text.is_empty());
    }
}

/// What a text in base64 says, by the definition.
fn bytes_of(text: &str) -> Vec<u8> {
    let letters: Vec<u8> = (b'A'..=b'Z').chain(b'a'..=b'z').chain(b'0'..=b'9').chain(*b"+/").collect();
    let value = |letter: u8| letters.iter().position(|&l| l == letter);
    let values: Vec<usize> = text.trim().bytes().filter_map(value).collect();
    let of_four = |four: &[usize]| {
        let all = four.iter().fold(0, |all, v| all << 6 | v) << (6 * (4 - four.len()));
        [16, 8, 0].map(|by| u8::try_from(all >> by & 0xFF).unwrap())[..four.len() - 1].to_vec()
    };
    values.chunks(4).flat_map(of_four).collect()
}

#[test]
fn what_is_no_exercise_or_has_no_answer_is_refused_and_nothing_is_written() {
    let folder = folder_with("plain.toml", CIRCLES);
    std::fs::write(folder.path().join("s.toml"), exercise()).unwrap();
    std::fs::write(folder.path().join("deep.toml"), exercise().replace("\"d\", ", "\"depth\", ")).unwrap();
    let moodle = |arguments: &[&str]| run(tracefig(folder.path()).arg("moodle").args(arguments));
    for arguments in [&["plain.toml"][..], &["s.toml", "plain.toml"], &["plain.toml", "--seed", "1..3"]] {
        let ran = moodle(arguments);
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{arguments:?}");
        assert!(ran.err.contains("plain.toml is no exercise: it lacks `[exercise]`"), "{}", ran.err);
    }
    let deep = moodle(&["deep.toml"]);
    assert!(deep.code == Some(1) && deep.out.is_empty(), "{}", deep.out);
    assert!(
        deep.err.contains("asks for `depth`") && deep.err.contains("the bodies are apart"),
        "{}",
        deep.err
    );
    assert_eq!(moodle(&["absent.toml"]).code, Some(74));
    assert_eq!(moodle(&[]).code, Some(2));
}
