//! Names are text: whatever a shape is called, every layer that writes names sets them as they are, and the
//! words of the figure hold them letter for letter.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use roxmltree::Document;
use serde_json::{Map, Value, json};
use tracefig::drawing::Item;
use tracefig::figure::layer::{LAYERS, Shows};
use tracefig::figure::{draw, plan};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Explain, Scene, Source, open_text, read};

/// Names that a formula, markup, XML or a value of a text would trip over, and ordinary ones.
const SETTABLE: [&str; 54] = [
    "crate_1",
    "the crate",
    "100%",
    "a_b_c",
    "A&B",
    "{x}",
    "$5",
    r"back\slash",
    "tile_2",
    "{=time}",
    "{a|b}",
    "{b|",
    "{=",
    "$x$",
    r"\$",
    r"a\$b\",
    r"\\",
    "^2",
    "10^",
    "x^2",
    "#1",
    "~",
    "A'",
    "B′′",
    "θ",
    "Γ",
    "é",
    "cafe\u{301}",
    "Ж",
    "ёлка",
    "Łódź",
    "Player′",
    "<b>",
    "\"quoted\"",
    "'",
    "}",
    "{",
    "`code`",
    "--",
    "−3°",
    "v_{A}",
    r"\text{x}",
    r"\frac{1}{2}",
    "]]>",
    "&amp;",
    "C++",
    "B ⊖ A",
    "x/y",
    "ground plane, static",
    "a  b",
    " x ",
    "the left crate with the longest of names",
    "[labels]",
    "A",
];

/// Names with a letter that the embedded fonts lack, and that letter.
const REPLACED: [(&str, char); 6] = [
    ("木箱", '木'),
    ("🎾", '🎾'),
    ("שלום", 'ש'),
    ("bell\u{7}", '\u{7}'),
    ("a\u{202e}b", '\u{202e}'),
    ("x\u{338}y", '\u{338}'),
];

/// Bodies and a question, for each way of drawing that writes names.
fn questions() -> [Value; 6] {
    let circle = json!({"kind": "circle", "radius": 1, "velocity": [4, 1]});
    let turning =
        json!({"kind": "box", "half_extents": [1, 0.5], "position": [4, 1], "angular_velocity_deg": 90});
    let [near, far] =
        [[1.5, 0.5], [4.0, 1.5]].map(|at| json!({"kind": "aabb", "half_extents": [1, 1], "position": at}));
    let ball = json!({"kind": "circle", "radius": 1});
    let moon = json!({"kind": "circle", "radius": 1, "position": [1.5, 0]});
    let asked = |a: &Value, b: &Value, query: Value| json!({"a": a, "b": b, "query": query});
    [
        asked(&circle, &turning, json!({"kind": "time-of-impact", "algorithm": "conservative-advancement"})),
        asked(&circle, &far, json!({"kind": "linear-sweep"})),
        asked(&near, &far, json!({"kind": "separation", "algorithm": "extents"})),
        asked(&ball, &far, json!({"kind": "separation", "algorithm": "clamp"})),
        asked(&ball, &moon, json!({"kind": "separation", "algorithm": "circles"})),
        asked(&near, &turning, json!({"kind": "separation", "algorithm": "minkowski"})),
    ]
}

/// Layers that stand alone in their panel.
const CHARTS: [&str; 2] = ["graph", "fastest-approach"];

/// A scene of a question with two names, and every layer in a panel of each space or in one of its own.
fn text(question: &Value, names: [&str; 2]) -> String {
    let mut shapes = Map::new();
    shapes.insert(names[0].to_owned(), question["a"].clone());
    shapes.insert(names[1].to_owned(), question["b"].clone());
    let mut query = question["query"].clone();
    query["of"] = json!(names);
    let layers = |space: Shows| {
        let fits = |shows: Shows| shows == Shows::Anywhere || shows == space;
        let named = LAYERS
            .iter()
            .filter(|l| fits(l.shows) && l.name != "note" && !CHARTS.contains(&l.name))
            .map(|l| json!(l.name));
        let mut layers: Vec<Value> = named.collect();
        layers.push(match space {
            Shows::Configuration => json!({"layer": "difference", "sources": true}),
            _ => json!({"layer": "radii", "as": "lengths"}),
        });
        layers
    };
    let panels = json!([
        {"space": "world", "layers": layers(Shows::World)},
        {"space": "configuration", "layers": layers(Shows::Configuration)},
        {"layers": [CHARTS[0]]},
        {"layers": [CHARTS[1]]},
    ]);
    json!({"shapes": shapes, "query": query, "panels": panels}).to_string()
}

/// The layers of each panel that a scene does not refuse.
fn kept(text: &str) -> Vec<Vec<bool>> {
    let scene = read(&Source::new("letters.json", text)).unwrap();
    let problems = plan(&scene).err().unwrap_or_default();
    let is_kept = |span: &std::ops::Range<usize>| problems.iter().all(|p| p.span != *span);
    scene.panels.iter().map(|p| p.layers.iter().flatten().map(|l| is_kept(&l.name.span)).collect()).collect()
}

/// The scene of a text with the layers of `kept` alone.
fn scene(text: &str, kept: &[Vec<bool>]) -> Scene {
    let mut scene = open_text("names.json", text).unwrap().scene;
    for (panel, kept) in scene.panels.iter_mut().zip(kept) {
        let mut kept = kept.iter();
        panel.layers.as_mut().unwrap().retain(|_| *kept.next().unwrap());
    }
    scene
}

/// A name as markup of words.
fn as_markup(name: &str) -> String {
    name.replace('$', r"\$")
}

/// The markup of the first line in the group of a name.
fn said(items: &[Item], group: &str) -> String {
    let found = items.iter().find_map(|item| match item {
        Item::Group(found) if found.name == group => found.items.first(),
        _ => None,
    });
    match found {
        Some(Item::Text(text)) => text.line.markup.clone(),
        _ => String::new(),
    }
}

#[test]
fn every_name_is_set_as_it_is_and_read_in_the_words_of_the_figure() {
    let Some(Writer::One(write)) = format("svg").map(|f| f.write) else { panic!("no SVG") };
    for (q, question) in questions().iter().enumerate() {
        let kept = kept(&text(question, ["A", "B"]));
        assert!(kept.iter().flatten().filter(|k| **k).count() > 8, "{question}");
        for (i, name) in SETTABLE.iter().enumerate() {
            let other = SETTABLE[(i + 1) % SETTABLE.len()];
            let text = text(question, [name, other]);
            let mut scene = scene(&text, &kept);
            // All texts are set in planning; places for them are sought in every seventh figure.
            let problems = plan(&scene).err();
            assert_eq!(problems, None, "{text}");
            if i % questions().len() != q {
                continue;
            }
            let mut bare = scene.clone();
            bare.panels.clear();
            let figure = plan(&bare).map(|plan| draw(&plan, plan.theme, "bare"));
            let captions = said(&figure.unwrap().drawing.items, "caption");
            // A letter stands as the symbol that it is in the figure.
            let symbol = |n: &str| format!("${}$", n.replace('″', "''").replace('′', "'"));
            let says = |n: &str| captions.contains(&as_markup(n)) || captions.contains(&symbol(n));
            assert!(says(name) && says(other), "{captions}");
            if i % 7 != 0 {
                scene.panels.truncate(1);
                scene.panels[0].layers.as_mut().unwrap().truncate(1);
            }
            let plan = plan(&scene).unwrap();
            let drawing = draw(&plan, plan.theme, "names").drawing;
            let svg = String::from_utf8(write(&drawing, &Options::default()).unwrap()).unwrap();
            let svg = Document::parse(&svg).unwrap_or_else(|e| panic!("{name}: {e}"));
            for element in ["title", "desc"] {
                let words =
                    svg.descendants().find(|n| n.has_tag_name(element)).and_then(|n| n.text()).unwrap();
                assert!(words.contains(name) && words.contains(other), "{element} of {name}: {words}");
            }
        }
    }
}

#[test]
fn a_name_with_a_letter_that_no_font_has_is_another_one_on_the_picture_and_a_note_says_so() {
    for question in questions() {
        let kept = kept(&text(&question, ["A", "B"]));
        for (name, letter) in REPLACED {
            for (names, shown) in [([name, "B"], "A"), (["A", name], "B"), (["B", name], "C")] {
                let text = text(&question, names);
                let mut scene = scene(&text, &kept);
                assert_eq!(plan(&scene).err(), None, "{text}");
                scene.panels.truncate(1);
                scene.panels[0].layers.as_mut().unwrap().truncate(1);
                let plan = plan(&scene).unwrap();
                let warnings = draw(&plan, plan.theme, "names").warnings;
                let notes: Vec<_> = warnings.iter().filter(|p| p.fault.code() == "bad-name").collect();
                let [note] = notes[..] else { panic!("{notes:?}") };
                let message = note.fault.to_string();
                let says = [name, &format!(" {shown}:"), &format!("{letter:?}")];
                assert!(says.iter().all(|part| message.contains(part)), "{message}");
                let help = note.fault.help().unwrap();
                assert_eq!(help.contains("`A = "), names[0] == name, "{help}");
                assert_eq!(text[note.span.clone()], json!(name).to_string());
            }
        }
    }
}

#[test]
fn words_that_are_never_set_in_type_keep_a_name_that_no_font_has() {
    let scene = open_text("names.json", &text(&questions()[0], ["木箱", "B"])).unwrap().scene;
    let mut bare = scene;
    bare.panels.clear();
    let plan = plan(&bare).unwrap();
    let drawing = draw(&plan, plan.theme, "names").drawing;
    assert!(drawing.title.contains("木箱") && drawing.desc.contains("木箱 is a circle"), "{}", drawing.desc);
    assert!(said(&drawing.items, "caption").contains("$A$"), "{}", said(&drawing.items, "caption"));
    let steps: Vec<&String> = drawing.steps.iter().flat_map(|step| &step.sentences).collect();
    assert!(steps.iter().all(|text| !text.contains('木')) && steps[0].contains("A and B"), "{steps:?}");
}

#[test]
fn labels_that_are_made_of_a_name_follow_the_text_that_the_scene_gives_to_it() {
    for question in questions() {
        let plain = text(&question, ["crate_1", "B"]);
        let kept = kept(&plain);
        let mut named: Value = serde_json::from_str(&plain).unwrap();
        named["labels"] = json!({"A": "Kiste"});
        let scene = scene(&named.to_string(), &kept);
        let plan = plan(&scene).unwrap();
        let drawing = draw(&plan, plan.theme, "names").drawing;
        let mut all = Vec::new();
        texts(&drawing.items, &mut all);
        assert!(all.iter().any(|markup| markup == "Kiste") && all.len() > 5, "{all:?}");
        assert!(all.iter().all(|markup| !markup.contains("crate")), "{all:?}");
        assert!(drawing.title.contains("crate_1") || drawing.desc.contains("crate_1"));
    }
}

/// The markup of all lines.
fn texts(items: &[Item], all: &mut Vec<String>) {
    for item in items {
        match item {
            Item::Group(group) => texts(&group.items, all),
            Item::Text(text) => all.push(text.line.markup.clone()),
            Item::Path(_) => {}
        }
    }
}

#[test]
fn a_body_that_the_query_is_not_about_is_told_only_where_it_is_named() {
    let question = &questions()[5];
    let mut scene: Value = serde_json::from_str(&text(question, ["bullet", "wall"])).unwrap();
    scene["shapes"]["木箱"] = json!({"kind": "circle", "radius": 0.5, "position": [0, 2]});
    for (layers, told) in [(json!(["shapes"]), true), (json!([{"layer": "shapes", "context": false}]), false)]
    {
        scene["panels"] = json!([{"space": "world", "layers": layers}]);
        let text = scene.to_string();
        let scene = open_text("context.json", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let warnings = draw(&plan, plan.theme, "context").warnings;
        let notes = warnings.iter().filter(|problem| problem.fault.code() == "bad-name");
        let at: Vec<&str> = notes.map(|problem| &text[problem.span.clone()]).collect();
        assert_eq!(at == ["\"木箱\""], told, "{warnings:?}");
        assert_eq!(at.is_empty(), !told);
    }
}
