//! Whatever is done to a scene file, reading and answering it ends in an answer or in problems that point
//! into it.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::time::{Duration, Instant};

use arbitrary::Unstructured;
use tracefig::figure::{draw, plan};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Ink, Source, open_text, read, solve};

use crate::fuzz_bodies;

/// The scenes of the figures, as TOML.
fn figures() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/figures");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    paths.sort();
    assert!(paths.len() >= 8, "{paths:?}");
    paths.iter().map(|p| std::fs::read_to_string(p).unwrap()).collect()
}

/// Words that a hasty or hostile hand might put anywhere.
const PIECES: &[&str] = &[
    "",
    " ",
    "\n",
    "0",
    "-0.0",
    "1e300",
    "1e-300",
    "5e-324",
    "inf",
    "-nan",
    "1e999",
    "9007199254740993",
    "0x10",
    "true",
    "[]",
    "{}",
    "[[0, 0]]",
    "\"\"",
    "'''",
    "\"",
    "[",
    "]",
    "=",
    ",",
    ".",
    "#",
    "\u{0}",
    "\u{feff}",
    "δ",
    "\u{1b}[31m",
    "A",
    "B",
    "circle",
    "outline",
    "time-of-impact",
    "kind",
    "null",
    "1979-05-27",
    "$\\frac{1}",
    "{=time}",
];

/// A text with a few places cut, doubled or replaced.
fn broken(u: &mut Unstructured<'_>, text: &str) -> arbitrary::Result<String> {
    let mut chars: Vec<char> = text.chars().collect();
    for _ in 0..u.int_in_range(1..=4)? {
        let from = u.choose_index(chars.len() + 1)?;
        let length = u.int_in_range(0..=12)?.min(chars.len() - from);
        let piece: Vec<char> = match u.int_in_range(0..=3)? {
            0 => Vec::new(),
            1 => [&chars[from..from + length], &chars[from..from + length]].concat(),
            _ => u.choose(PIECES)?.chars().collect(),
        };
        chars.splice(from..from + length, piece);
    }
    Ok(chars.into_iter().collect())
}

#[test]
fn a_broken_scene_gives_an_answer_or_problems_in_its_text() {
    let figures = figures();
    arbtest::arbtest(|u| {
        let figure = u.choose_index(figures.len())?;
        let text = broken(u, &figures[figure])?;
        match open_text("s.toml", &text) {
            Ok(file) => {
                let _ = solve(&file.scene);
            }
            Err(refused) => {
                assert!(!refused.problems.is_empty());
                for problem in &refused.problems {
                    let place = problem.span.clone();
                    assert!(
                        place.start <= place.end && place.end <= refused.source.text.len(),
                        "{problem:?}"
                    );
                }
                let told = refused.render(Ink::Plain);
                assert!(!told.contains('\u{1b}'), "{told:?}");
            }
        }
        Ok(())
    })
    .budget_ms(3_000);
}

#[test]
fn a_broken_scene_is_drawn_or_told_what_is_wrong() {
    let figures = figures();
    arbtest::arbtest(|u| {
        let figure = u.choose_index(figures.len())?;
        let text = broken(u, &figures[figure])?;
        let Ok(file) = open_text("s.toml", &text) else { return Ok(()) };
        match plan(&file.scene) {
            Ok(plan) => {
                let drawing = draw(&plan, plan.theme, "fig").drawing;
                let svg = (format("svg").unwrap(), Options::default());
                let Writer::One(write) = svg.0.write else { panic!("an SVG is of one drawing") };
                // A page without room, or numbers beyond any page, may be refused.
                if let Ok(bytes) = write(&drawing, &svg.1) {
                    let svg = String::from_utf8(bytes).unwrap();
                    let parsed = roxmltree::Document::parse(&svg)
                        .unwrap_or_else(|e| panic!("{e} in the SVG of {text}"));
                    let elements = parsed.descendants().filter(roxmltree::Node::is_element);
                    assert!(elements.clone().all(|e| e.tag_name().name() != "script"));
                }
            }
            Err(problems) => {
                assert!(!problems.is_empty());
                for problem in problems {
                    assert!(problem.span.end <= file.source.text.len(), "{problem:?}");
                }
            }
        }
        Ok(())
    })
    .budget_ms(6_000);
}

#[test]
fn any_line_of_a_stream_gets_one_line_of_json() {
    let good = r#"{"id": "a", "shapes": {"A": {"kind": "box", "half_extents": [1, 2], "angle_deg": 30}, "B": {"kind": "polygon", "vertices": [[0, 0], [1, 0], [0, 1]], "position": [4, 0]}}, "query": {"kind": "separation", "of": ["A", "B"]}}"#;
    arbtest::arbtest(|u| {
        fuzz_bodies::solve::holds(&broken(u, good)?);
        Ok(())
    })
    .budget_ms(2_000);
}

/// Hostile texts of about a megabyte; each is refused, or answered, in this time even without optimization.
const PATIENCE: Duration = Duration::from_secs(10);

#[test]
fn no_hostile_text_takes_long() {
    let each =
        |count: usize, line: &dyn Fn(usize) -> String| (0..count).map(line).collect::<Vec<_>>().concat();
    let many = |piece: &str, bytes: usize| piece.repeat(bytes / piece.len());
    let polygon = |vertices: &str| {
        format!(
            "[shapes.A]\nkind = 'outline'\nvertices = [{vertices}]\n[query]\nkind = 'bounds'\nof = ['A']\n"
        )
    };
    let million = 1_000_000;
    let texts = [
        many("[", million),
        many("[[a]]\n", million),
        many("a.", million),
        format!("a = {}", many("[", million)),
        format!("a = {}", many("{a=", million)),
        format!("a = {{ {} = 1 }}", many("a.", million) + "a"),
        each(100_000, &|i| format!("k{i} = 1\n")),
        each(30_000, &|i| format!("[shapes.s{i}]\nkind = 'x'\n")),
        each(30_000, &|i| format!("[t{i}]\na.b.c.d = {i}\n")),
        polygon(&many("[0, 0], ", million)),
        polygon(&each(9_000, &|i| format!("[{i}, {}], ", (i * i) % 97))),
        format!("title = '{}'", many("\\def\\x{\\x\\x}", million)),
        many("\u{1b}[31m", million),
        format!("{{\"a\": {}", many("[", million)),
        format!("{{{}\"z\": 1}}", each(50_000, &|i| format!("\"k{i}\": [{i}], "))),
        format!("{{\"a\": {}1{}}}", many("{\"a\":", 500_000), many("}", 100_000)),
    ];
    for text in &texts {
        let start = Instant::now();
        let refused = open_text("s.toml", text).map(|file| solve(&file.scene));
        let told = refused.map_err(|r| r.render(Ink::Plain));
        if std::env::var_os("TIMES").is_some() {
            println!("{:?} {}", start.elapsed(), text.chars().take(40).collect::<String>());
        }
        let head: String = text.chars().take(40).collect();
        assert!(start.elapsed() < PATIENCE, "{head} took {:?}", start.elapsed());
        assert!(told.as_ref().is_ok() || told.as_ref().is_err_and(|t| t.len() < 40_000), "{head}: {told:?}");
    }
}

#[test]
fn the_same_scene_in_toml_and_json_is_the_same() {
    let toml = "[shapes.A]\nkind = 'circle'\nradius = 0.1\n[query]\nkind = 'bounds'\nof = ['A']\n[labels]\nA = { at = [1, 2], hide = true }\n[[panels]]\nlayers = ['shapes', { layer = 'note', lines = ['x', 'y'], offset = 3 }]\nstep = 2\n";
    let json = r#"{"shapes": {"A": {"kind": "circle", "radius": 0.1}}, "query": {"kind": "bounds", "of": ["A"]}, "labels": {"A": {"at": [1, 2], "hide": true}},
        "panels": [{"layers": ["shapes", {"layer": "note", "lines": ["x", "y"], "offset": 3}], "step": 2}]}"#;
    // Only the places differ; without them the two say the same.
    let without_places = |text: &str| {
        let scene = format!("{:?}", read(&Source::new("s", text)).unwrap());
        let mut plain = String::new();
        let mut rest = scene.as_str();
        while let Some(at) = rest.find("span: ") {
            plain.push_str(&rest[..at]);
            rest = rest[at + 6..].trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
        }
        plain + rest
    };
    assert_eq!(without_places(toml), without_places(json));
}
