//! No scene makes tracefig panic: random ones from the tables of kinds, queries, algorithms, layers and
//! options, and the scenes of `figures/`, both whole and broken, go all the way to SVG and PNG.
//!
//! `TRACEFIG_SCENES=100000 cargo test --release --test scenes no_panic -- --nocapture` runs as many as one
//! likes from `TRACEFIG_SEED` on and prints what became of them.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic wherever it is")]

use std::collections::BTreeMap;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};

use tracefig::collision::{ALGORITHMS, Bodies, Motion, QUERIES, Question, Shapes};
use tracefig::figure::layer::{LAYERS, Layer, Shows};
use tracefig::figure::theme::THEMES;
use tracefig::figure::{COMMON, Takes, draw, plan};
use tracefig::geometry::shape::{FieldType, KINDS, Kind};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Ink, answer_text, open_text, solve};
use tracefig_reference::random::Random;

/// Scenes of a usual run; few enough for a debug build.
const SCENES: u64 = 400;
/// One in so many scenes says what its question or its kind of shape refuses.
const SELDOM: usize = 12;
/// Dots of an image.
const DOTS: f64 = 10_000.0;

/// Bodies of a question, and panels of it that once panicked.
const ONCE: &[&str] = &[
    // Labels that show nothing.
    "[[panels]]\nlayers = ['shapes', 'separation']\n[labels]\nA = ' '\nd = '$$'\n",
    "[[panels]]\nlayers = ['shapes', 'separation']\n[labels]\nA = '$\\,$'\nB = '$\\text{}$'\n",
    "[[panels]]\nlayers = ['shapes', 'separation', { layer = 'note', lines = ['$\\frac{}{}$'] }]\n[labels]\nA = '\\t'\n",
    // Places that overflow, seen from a body that is turned.
    "[[panels]]\nspace = 'body'\nframe = 'C'\nlayers = ['origin', 'shapes']\n",
];

/// Lines of more dashes than can be counted, and one line more.
const DASHES: &str = "[shapes.A]\nkind = 'aabb'\nhalf_extents = [1, 1]\n\
                      [shapes.B]\nkind = 'circle'\nradius = 1\nposition = [1e90, 1e90]\n\
                      [query]\nkind = 'separation'\nof = ['A', 'B']\nalgorithm = 'clamp'\n\
                      [[panels]]\nview = [-6, -4, 9, 3]\nlayers = ['clamp']\n";

#[test]
fn dashes_without_number_are_more_than_a_figure_may_show() {
    assert_eq!(fate(DASHES), "answered, refused as a figure");
}

#[test]
fn what_once_panicked_does_not() {
    for panels in ONCE {
        let of = if panels.contains("'C'") { "'A', 'C'" } else { "'A', 'B'" };
        let other = if of.contains('C') {
            "[shapes.C]\nkind = 'polygon'\nvertices = [[0, 1], [1, 0], [0, 0]]\nposition = [1e300, -1e300]\nangle_deg = -17.5\n"
        } else {
            "[shapes.B]\nkind = 'circle'\nradius = 1\nposition = [3, 0]\n"
        };
        let text = format!(
            "[shapes.A]\nkind = 'circle'\nradius = 1\n{other}[query]\nkind = 'separation'\nof = [{of}]\n{panels}"
        );
        let reached = catch_unwind(AssertUnwindSafe(|| fate(&text)));
        assert!(reached.is_ok_and(|fate| fate != "refused as a scene"), "{text}");
    }
}

/// Numbers that break what is not careful.
const EXTREMES: &[&str] = &[
    "0",
    "-0.0",
    "1",
    "-1",
    "1e-300",
    "5e-324",
    "-5e-324",
    "2.2250738585072014e-308",
    "1e300",
    "-1e300",
    "1e301",
    "1e999",
    "nan",
    "inf",
    "-inf",
    "9007199254740993",
    "0.1",
    "1e9",
    "1e-9",
    "1e16",
    "360",
    "1e17",
    "0x7f",
    "1_000",
    "4096",
    "100",
    "\"1\"",
    "[]",
    "{}",
    "true",
    "1979-05-27",
];

/// Pieces that a broken file may have anywhere.
const PIECES: &[&str] = &[
    "[",
    "]",
    "[[",
    "{",
    "}",
    "\"",
    "'",
    "=",
    ",",
    "#",
    "\n",
    "\0",
    "\u{feff}",
    "$",
    "\\",
    "δ",
    "\u{202e}",
    "[[panels]]\n",
    "[shapes.A]\n",
    "[labels]\n",
    "$\\frac{1}{0}$",
    "{=time}",
    "{a|the {=time} box} $x$",
    "{b|",
    "{=D.x}",
    "layers = []\n",
    "kind = 'circle'\n",
];

/// Mostly a number as on a figure.
fn number(r: &mut Random) -> String {
    if r.once_in(60) {
        return r.one_of(EXTREMES).to_owned();
    }
    format!("{}", r.quarter(-8, 8))
}

fn point(r: &mut Random) -> String {
    format!("[{}, {}]", number(r), number(r))
}

/// Mostly a kind that the question can be asked of.
fn kind<'k>(r: &mut Random, question: &Question) -> &'k Kind {
    let any = r.pick(KINDS);
    if any.name != "outline" || question.shapes == Shapes::Any || r.once_in(SELDOM) {
        return any;
    }
    kind(r, question)
}

fn shape(r: &mut Random, question: &Question, name: &str) -> String {
    let kind = kind(r, question);
    let mut text = format!("[shapes.{name}]\nkind = \"{}\"\n", kind.name);
    for field in kind.fields {
        if !field.required && r.once_in(2) {
            continue;
        }
        let value = match field.holds {
            FieldType::Length => number(r).trim_start_matches('-').to_owned(),
            FieldType::Count { min, .. } => (min + r.below(9)).to_string(),
            FieldType::Point | FieldType::Extents => point(r).replace('-', ""),
            FieldType::Points { .. } if kind.name == "capsule" => format!("[{}, {}]", point(r), point(r)),
            FieldType::Points { .. } => vertices(r),
            FieldType::Switch => ["true", "false"][r.below(2)].to_owned(),
        };
        writeln!(text, "{} = {value}", field.name).unwrap();
    }
    for (key, is_pair) in
        [("position", true), ("angle_deg", false), ("velocity", true), ("angular_velocity_deg", false)]
    {
        let turns = key.starts_with("angle") && kind.turns
            || key.starts_with("angular") && kind.turns && question.motion == Motion::Any;
        let suits = is_pair || turns || r.once_in(SELDOM);
        if suits && r.once_in(2) {
            let value = if is_pair { point(r) } else { number(r) };
            writeln!(text, "{key} = {value}").unwrap();
        }
    }
    text
}

/// Vertices on an ellipse, so that most polygons are convex.
fn vertices(r: &mut Random) -> String {
    let (n, height) = (3 + r.below(7), f64::from(u32::try_from(1 + r.below(4)).unwrap()));
    let vertex = |k: usize| {
        let angle = std::f64::consts::TAU * f64::from(u32::try_from(k).unwrap())
            / f64::from(u32::try_from(n).unwrap());
        format!("[{:.3}, {:.3}]", 2.0 * libm::cos(angle), height * libm::sin(angle))
    };
    format!("[{}]", (0..n).map(vertex).collect::<Vec<_>>().join(", "))
}

fn layer(r: &mut Random, layer: &Layer) -> String {
    let mut text = format!("{{ layer = \"{}\"", layer.name);
    for option in layer.options.iter().chain(COMMON) {
        if !r.once_in(3) {
            continue;
        }
        let value = match option.takes {
            Takes::Flag => r.pick(&["true", "false"]).to_string(),
            Takes::Number | Takes::Positive => number(r),
            Takes::Point => format!("[{}, {}]", number(r), number(r)),
            Takes::Counts => r.pick(&["0", "[0, 2]", "1", "[]", "[7, 1]"]).to_string(),
            Takes::Word(words) => format!("{:?}", r.pick(words)),
            Takes::Words(words) => format!("[{:?}, {:?}]", r.pick(words), r.pick(words)),
            Takes::Bodies => r.pick(&["[\"A\"]", "[\"B\", \"A\"]", "\"B\""]).to_string(),
            Takes::When(words) if r.once_in(2) => format!("{:?}", r.pick(words)),
            Takes::When(_) => r.pick(&["0", "0.5", "1", "1e-300"]).to_string(),
            Takes::Role => r.pick(&["\"a\"", "\"b\"", "\"now\"", "\"ink\""]).to_string(),
            Takes::Lines => r.pick(&["\"x\"", "[\"{=separation}\", \"$\\\\hat{n}$\"]", "\"\""]).to_string(),
        };
        write!(text, ", {} = {value}", option.name).unwrap();
    }
    text + " }"
}

fn panel(r: &mut Random) -> String {
    let mut text = String::new();
    let space = r.pick(&["\"world\"", "\"configuration\"", "\"body\"\nframe = \"A\""]);
    let other = if space.contains("conf") { Shows::World } else { Shows::Configuration };
    let layers: Vec<String> = (0..=r.below(5))
        .map(|_| {
            let any = r.once_in(SELDOM);
            let suited: Vec<&Layer> = LAYERS.iter().filter(|l| any || l.shows != other).collect();
            let chosen = r.pick(&suited);
            layer(r, chosen)
        })
        .collect();
    write!(
        text,
        "[[panels]]\nspace = {space}\nlayers = [\"{}\", {}]\n",
        if space.contains("conf") { "difference" } else { "shapes" },
        layers.join(", ")
    )
    .unwrap();
    if r.once_in(3) {
        writeln!(
            text,
            "{}",
            r.pick(&[
                "time = 0.5",
                "time = \"hit\"",
                "step = 2",
                "view = [-1, -1, 1e-3, 1]",
                "view = [-1e300, -1, 1e300, 1]"
            ])
        )
        .unwrap();
    }
    text
}

/// A scene from the tables, most likely one that can be drawn.
fn random_scene(r: &mut Random) -> String {
    let mut text = String::new();
    if r.once_in(2) {
        text += "title = \"T $x$\"\ncaption = \"From {=time} to $\\\\frac{1}{2}$, {=separation}\"\n";
    }
    let question = r.pick(QUERIES);
    let context = r.once_in(3);
    if context {
        let asked = r.pick(QUERIES);
        text += &shape(r, asked, "C");
    }
    for name in ["A", "B"] {
        text += &shape(r, question, name);
    }
    let single = question.bodies == Bodies::OneOrTwo && r.once_in(2);
    write!(
        text,
        "[query]\nkind = \"{}\"\nof = {}\n",
        question.word,
        if single { "[\"A\"]" } else { "[\"A\", \"B\"]" }
    )
    .unwrap();
    let suited: Vec<_> = ALGORITHMS.iter().filter(|a| a.kinds.contains(&question.kind)).collect();
    if r.once_in(2) && !suited.is_empty() {
        writeln!(text, "algorithm = \"{}\"", r.pick(&suited).name).unwrap();
    }
    if r.once_in(4) {
        writeln!(
            text,
            "max_iterations = {}\ntolerance = {}",
            1 + r.below(200),
            r.pick(&["0", "1e-3", "1e-12", "1e300"])
        )
        .unwrap();
    }
    // A scene without panels is drawn too.
    for _ in 0..r.below(4) {
        let panel = panel(r);
        let carried =
            if context && r.once_in(2) { panel.replace("frame = \"A\"", "frame = \"C\"") } else { panel };
        text += &carried;
    }
    if r.once_in(3) {
        let theme = r.pick(THEMES).name;
        write!(
            text,
            "[canvas]\nwidth = {}\nheight = {}\ntheme = \"{theme}\"\n",
            100 + r.below(900),
            100 + r.below(600)
        )
        .unwrap();
    }
    text
}

/// The text with layers that the scene can't feed, and options that don't fit, taken out, as a user would.
fn mended(text: &str) -> String {
    let mut text = text.to_owned();
    for _ in 0..12 {
        let Ok(file) = open_text("s.toml", &text) else { return text };
        let Err(problems) = plan(&file.scene).map(|_| ()) else { return text };
        let Some(first) = problems.first() else { return text };
        let span = first.span.clone();
        // Blanks keep the places; a layer's name becomes one that every scene can feed.
        let filler = match text.get(span.clone()) {
            Some(word) if word.starts_with('"') && word.len() >= 6 => {
                format!("\"axes\"{}", " ".repeat(word.len() - 6))
            }
            _ => return text,
        };
        text.replace_range(span, &filler);
    }
    text
}

/// The text broken at a few places: numbers replaced by extremes, lines dropped, doubled or moved, bytes
/// flipped, brackets nested.
fn broken(r: &mut Random, text: &str) -> String {
    let mut text = text.to_owned();
    for _ in 0..=r.below(4) {
        match r.below(6) {
            0 | 1 => replace_number(r, &mut text),
            2 => {
                let mut lines: Vec<&str> = text.lines().collect();
                if !lines.is_empty() {
                    let (from, to) = (r.below(lines.len()), r.below(lines.len()));
                    match r.below(3) {
                        0 => drop(lines.remove(from)),
                        1 => lines.insert(to, lines[from]),
                        _ => lines.swap(from, to),
                    }
                }
                text = lines.join("\n");
            }
            3 => {
                let mut bytes = text.into_bytes();
                if !bytes.is_empty() {
                    let at = r.below(bytes.len());
                    bytes[at] ^= 1 << r.below(8);
                }
                text = String::from_utf8_lossy(&bytes).into_owned();
            }
            4 => {
                let depth = 1 + r.below(40);
                let value = format!("{}1{}", "[".repeat(depth), "]".repeat(depth));
                text = text.replacen('1', &value, 1);
            }
            _ => {
                let mut at = r.below(text.len() + 1);
                while !text.is_char_boundary(at) {
                    at -= 1;
                }
                let piece: &&str = r.pick(PIECES);
                text.insert_str(at, piece);
            }
        }
    }
    text
}

fn replace_number(r: &mut Random, text: &mut String) {
    let is_part = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let starts: Vec<usize> = text
        .char_indices()
        .filter(|&(i, c)| is_part(c) && !text[..i].ends_with(is_part))
        .map(|(i, _)| i)
        .collect();
    if starts.is_empty() {
        return;
    }
    let start = *r.pick(&starts);
    let end = start + text[start..].find(|c| !is_part(c)).unwrap_or(text.len() - start);
    let extreme: &&str = r.pick(EXTREMES);
    text.replace_range(start..end, extreme);
}

/// Reads, answers, lays out and draws; what became of it.
fn fate(text: &str) -> &'static str {
    let file = match open_text("s.toml", text) {
        Ok(file) => file,
        Err(refused) => {
            assert!(!refused.render(Ink::Plain).is_empty());
            return "refused as a scene";
        }
    };
    let answer = solve(&file.scene);
    assert!(!answer_text(file.scene.query().kind, &answer, &file.scene.names()).is_empty());
    let Ok(plan) = plan(&file.scene) else { return "answered, refused as a figure" };
    let drawing = draw(&plan, plan.theme, "s").drawing;
    let options =
        Options { scale: libm::sqrt(DOTS / (drawing.width * drawing.height)), ..Options::default() };
    for name in ["svg", "png"] {
        let Some(Writer::One(write)) = format(name).map(|f| f.write) else {
            panic!("{name} is of one drawing")
        };
        if write(&drawing, &options).is_err() {
            return "answered, refused as a file";
        }
    }
    "drawn"
}

#[test]
fn no_scene_whole_or_broken_makes_a_panic() {
    let read =
        |key: &str, default: u64| std::env::var(key).ok().and_then(|n| n.parse().ok()).unwrap_or(default);
    let (scenes, first) = (read("TRACEFIG_SCENES", SCENES), read("TRACEFIG_SEED", 2026));
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/figures");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    paths.sort();
    let figures: Vec<String> = paths.iter().map(|p| std::fs::read_to_string(p).unwrap()).collect();
    let mut fates: BTreeMap<&str, u64> = BTreeMap::new();
    let mut panicked = Vec::new();
    for seed in first..first + scenes {
        let mut r = Random::new(seed);
        let text = match r.below(4) {
            0 => random_scene(&mut r),
            1 => mended(&random_scene(&mut r)),
            2 => {
                let text = mended(&random_scene(&mut r));
                broken(&mut r, &text)
            }
            _ => {
                let figure = r.pick(&figures).clone();
                broken(&mut r, &figure)
            }
        };
        match catch_unwind(AssertUnwindSafe(|| fate(&text))) {
            Ok(fate) => *fates.entry(fate).or_default() += 1,
            Err(_) => panicked.push((seed, text)),
        }
    }
    println!("{scenes} scenes from seed {first}: {fates:?}, {} panics", panicked.len());
    assert!(
        panicked.is_empty(),
        "{} panics, the first of seed {}:\n{}",
        panicked.len(),
        panicked[0].0,
        panicked[0].1
    );
    // Else the scenes were not worth the name.
    for fate in ["drawn", "refused as a scene", "answered, refused as a figure"] {
        assert!(fates.get(fate).is_some_and(|&n| n >= scenes / 20), "{fates:?}");
    }
}
