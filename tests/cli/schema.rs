//! The schemas of `list` take every scene, project file and theme file that we take, and refuse what we refuse.
//!
//! Read here is the part of JSON Schema that ours uses; a keyword that is not known here fails the test.

#![expect(clippy::panic, clippy::expect_used, reason = "a test may panic wherever it is")]

use std::path::Path;

use serde_json::{Map, Value, json};

use crate::{run, tracefig};

/// The patterns of the schemas, of colours, with the numbers of digits that they take.
const COLORS: [(&str, &[usize]); 2] =
    [("^#[0-9A-Fa-f]{6}$", &[6]), ("^#([0-9A-Fa-f]{3}|[0-9A-Fa-f]{6})$", &[3, 6])];

fn schema(of: &str) -> Value {
    let ran = run(tracefig(Path::new(".")).args(["list", of]));
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    serde_json::from_str(&ran.out).unwrap()
}

/// What a value is refused for, each with its place.
fn faults(schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let schema = schema.as_object().unwrap_or_else(|| panic!("{at}: {schema} is no schema"));
    let told = |(keyword, rule): (&String, &Value)| {
        let inner = within(schema, keyword, rule, value, at);
        inner.unwrap_or_else(|| {
            let is_held = holds(keyword, rule, value);
            if is_held { Vec::new() } else { vec![format!("{at}: {keyword} {rule}, got {value}")] }
        })
    };
    schema.iter().flat_map(told).collect()
}

/// Faults of what a value holds; `None` where the keyword is about the value itself.
fn within(
    schema: &Map<String, Value>,
    keyword: &str,
    rule: &Value,
    value: &Value,
    at: &str,
) -> Option<Vec<String>> {
    let empty = Map::new();
    let properties = schema.get("properties").and_then(Value::as_object).unwrap_or(&empty);
    let entries = value.as_object().unwrap_or(&empty).iter();
    Some(match keyword {
        "properties" => entries
            .filter_map(|(key, inner)| Some(faults(rule.get(key)?, inner, &format!("{at}/{key}"))))
            .flatten()
            .collect(),
        "additionalProperties" => entries
            .filter(|(key, _)| !properties.contains_key(*key))
            .flat_map(|(key, inner)| match rule {
                Value::Bool(true) => Vec::new(),
                Value::Bool(false) => vec![format!("{at}/{key}: no such key")],
                rule => faults(rule, inner, &format!("{at}/{key}")),
            })
            .collect(),
        "items" => {
            let items = value.as_array().map_or(&[][..], Vec::as_slice).iter().enumerate();
            items.flat_map(|(i, inner)| faults(rule, inner, &format!("{at}/{i}"))).collect()
        }
        "if" => {
            let is_so = faults(rule, value, at).is_empty();
            let then = schema.get(if is_so { "then" } else { "else" });
            then.map_or_else(Vec::new, |then| faults(then, value, at))
        }
        "then" | "else" => Vec::new(),
        "allOf" => {
            let schemas = rule.as_array().expect("a list of schemas").iter();
            schemas.flat_map(|schema| faults(schema, value, at)).collect()
        }
        _ => return None,
    })
}

/// Whether a value is of a type that a schema names.
fn is_of_type(name: &Value, value: &Value) -> bool {
    match name.as_str().expect("a word") {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|x| x.fract() == 0.0),
        other => panic!("no type {other}"),
    }
}

/// Whether a text is as a pattern of the schemas wants it: of theme files, of markup, of languages, of
/// what is dragged, of colours.
fn fits(pattern: &str, text: &str) -> bool {
    if pattern == r"\.toml(#dark)?$" {
        return Path::new(text.trim_end_matches("#dark")).extension().is_some_and(|end| end == "toml");
    }
    if pattern.starts_with("^(?:[^$") {
        return is_markup(pattern, text);
    }
    if pattern.starts_with("^[A-Za-z]{2,3}(-") {
        return is_tag(text);
    }
    if let Some(grips) = pattern.strip_prefix(r"^[^.]*$|\.(").and_then(|rest| rest.split_once(')')) {
        return is_held(grips.0, text);
    }
    let (_, digits) = COLORS.iter().find(|(known, _)| *known == pattern).expect("a known pattern");
    text.strip_prefix('#')
        .is_some_and(|hex| digits.contains(&hex.len()) && hex.bytes().all(|b| b.is_ascii_hexdigit()))
}

/// Whether a text says how many digits a value has, as the pattern of the schema has it.
fn is_format(text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    text.strip_prefix('.').is_some_and(|count| match count.strip_suffix('g') {
        Some(count) => digits(count) && count.bytes().any(|b| b != b'0'),
        None => digits(count),
    })
}

/// Whether a text is the tag of a language, as the pattern of the schema has it.
fn is_tag(text: &str) -> bool {
    let mut parts = text.split('-');
    parts.next().is_some_and(|p| (2..=3).contains(&p.len()) && p.bytes().all(|b| b.is_ascii_alphabetic()))
        && parts.all(|p| (1..=8).contains(&p.len()) && p.bytes().all(|b| b.is_ascii_alphanumeric()))
}

/// Whether a text is a name, with a grip behind a point or with what no grip is, as the pattern has it.
fn is_held(grips: &str, text: &str) -> bool {
    text.rsplit_once('.').is_none_or(|(_, grip)| {
        let is_word = !grip.is_empty() && grip.bytes().all(|b| b.is_ascii_lowercase());
        !is_word || grips.split('|').any(|known| known == grip)
    })
}

/// Whether a text is markup as the pattern of the schema has it, which names the roles and values.
fn is_markup(pattern: &str, text: &str) -> bool {
    let words = |after: &str| -> Vec<String> {
        let (_, rest) = pattern.split_once(after).expect("a list of words");
        rest.split(')').next().expect("its end").split('|').map(|word| word.replace('\\', "")).collect()
    };
    let (roles, values) = (words(r"\{(?:"), words(r"\{=(?:"));
    let mut rest = text;
    while let Some(at) = rest.find(['$', '{', '\\']) {
        let (found, after) = (&rest[at..=at], &rest[at + 1..]);
        rest = match found {
            "\\" => after.get(after.chars().next().map_or(0, char::len_utf8)..).unwrap_or(""),
            "$" => match after.split_once('$') {
                Some((_, after)) => after,
                None => return pattern.ends_with(")?$"),
            },
            _ => {
                let end = after.find(|c: char| !(c.is_ascii_alphanumeric() || "-=._".contains(c)));
                let (word, end) = end.map_or((after, ""), |end| (&after[..end], &after[end..=end]));
                let is_known = match word.strip_prefix('=') {
                    Some(value) => {
                        let ends = after.split_once('}').is_some_and(|(inner, _)| {
                            let format = inner.split_once(':').map(|(_, format)| format);
                            format.is_none_or(is_format)
                        });
                        ends && values.iter().any(|known| known == value)
                    }
                    None => end != "|" || word.is_empty() || roles.iter().any(|known| known == word),
                };
                if !is_known {
                    return false;
                }
                after
            }
        };
    }
    true
}

/// Whether a value is as a keyword wants it.
fn holds(keyword: &str, rule: &Value, value: &Value) -> bool {
    let number = |compare: fn(&f64, &f64) -> bool| {
        value.as_f64().is_none_or(|x| compare(&x, &rule.as_f64().expect("a limit is a number")))
    };
    let length = |compare: fn(&u64, &u64) -> bool| {
        let limit = rule.as_u64().expect("a length is a whole number");
        value.as_array().is_none_or(|items| compare(&(items.len() as u64), &limit))
    };
    let fitting = || {
        let schemas = rule.as_array().expect("a list of schemas");
        schemas.iter().filter(|schema| faults(schema, value, "").is_empty()).count()
    };
    match keyword {
        "$schema" | "title" | "description" => rule.is_string(),
        "type" => match rule.as_array() {
            Some(types) => types.iter().any(|one| is_of_type(one, value)),
            None => is_of_type(rule, value),
        },
        "required" => {
            let keys = rule.as_array().expect("a list of keys");
            value.as_object().is_none_or(|o| keys.iter().all(|key| o.contains_key(key.as_str().unwrap())))
        }
        "enum" => rule.as_array().expect("a list of values").contains(value),
        "const" => rule == value,
        "minimum" => number(f64::ge),
        "exclusiveMinimum" => number(f64::gt),
        "maximum" => number(f64::le),
        "minItems" => length(u64::ge),
        "maxItems" => length(u64::le),
        "contains" => {
            let items = value.as_array();
            items.is_none_or(|items| items.iter().any(|item| faults(rule, item, "").is_empty()))
        }
        "anyOf" => fitting() > 0,
        "not" => !faults(rule, value, "").is_empty(),
        "uniqueItems" => {
            let items = value.as_array().map_or(&[][..], Vec::as_slice);
            items.iter().enumerate().all(|(i, item)| !items[..i].contains(item))
        }
        "pattern" => value.as_str().is_none_or(|text| fits(rule.as_str().expect("a text"), text)),
        other => panic!("the keyword {other} is not known to this test"),
    }
}

#[test]
fn the_schema_takes_every_committed_scene() {
    let schema = schema("schema");
    let figures = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut read = 0;
    for file in std::fs::read_dir(figures).unwrap().map(|file| file.unwrap().path()) {
        if file.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let scene: Value = toml::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
        let found = faults(&schema, &scene, "");
        assert!(found.is_empty(), "{}:\n{}", file.display(), found.join("\n"));
        read += 1;
    }
    assert!(read >= 19, "{read} scenes");
}

/// A scene that is right, with one value put in.
fn with(pointer: &str, put: Value) -> Value {
    let mut scene = json!({
        "title": "Two", "lang": "de", "canvas": { "width": 720, "height": "auto", "background": "#FFFFFF" },
        "shapes": {
            "A": { "kind": "circle", "radius": 1, "position": [0, 0] },
            "B": { "kind": "box", "half_extents": [1, 0.5], "position": [4, 0], "angle_deg": 3.5 },
        },
        "query": { "kind": "separation", "of": ["A", "B"], "time": 0.5 },
        "panels": [{ "space": "world", "layers": ["shapes", { "layer": "axes", "ticks": true }] }],
        "labels": { "A": { "text": "$A$", "at": "NE" }, "B": "$B$" },
    });
    if let Some((parent, key)) = pointer.rsplit_once('/') {
        let parent = scene.pointer_mut(parent).unwrap();
        match parent {
            Value::Array(items) => items[key.parse::<usize>().unwrap()] = put,
            Value::Object(entries) if put.is_null() => drop(entries.remove(key)),
            Value::Object(entries) => drop(entries.insert(key.to_owned(), put)),
            _ => panic!("{pointer}"),
        }
    }
    scene
}

/// What `render` says of a scene.
fn drawn(folder: &Path, scene: &Value) -> Option<i32> {
    std::fs::write(folder.join("s.json"), scene.to_string()).unwrap();
    run(tracefig(folder).args(["render", "s.json"])).code
}

#[test]
fn the_schema_takes_what_the_reader_takes() {
    let schema = schema("schema");
    let folder = tempfile::tempdir().unwrap();
    for (pointer, put) in [
        ("", Value::Null),
        ("/title", json!("{a|A} is {=separation:.2} off {b|$B \\ominus A$}, \\$ 3, {x} and \\{c| too")),
        ("/headline", json!("$\\frac{a}{b}$ {=n.x}")),
        ("/title", json!("a formula $x without an end")),
        ("/canvas/theme", json!("dark")),
        ("/exercise", json!({ "ask": ["separation"] })),
        ("/exercise", json!({ "ask": "separation", "hide": ["shapes", "A"] })),
        ("/headline", json!("{=separation:.3g} and {=separation:.0}")),
        ("/lang", json!("pt-BR")),
        ("/steps", json!([{ "skip": true }, { "title": "Then" }])),
    ] {
        let right = with(pointer, put);
        assert_eq!(
            (faults(&schema, &right, ""), drawn(folder.path(), &right)),
            (Vec::new(), Some(0)),
            "{pointer}"
        );
    }
}

#[test]
fn the_schema_refuses_what_the_reader_refuses() {
    let schema = schema("schema");
    let folder = tempfile::tempdir().unwrap();
    for (pointer, put) in [
        ("/shapes", Value::Null),
        ("/query", Value::Null),
        ("/tilte", json!("Two")),
        ("/title", json!(2)),
        ("/shapes/A/kind", json!("circel")),
        ("/shapes/A/radius", Value::Null),
        ("/shapes/A/half_extents", json!([1, 1])),
        ("/shapes/B/half_extents", json!([1, 1, 1])),
        ("/shapes/B/position", json!("here")),
        ("/shapes/B/angle_deg", json!(true)),
        ("/shapes/A/radius", json!(-1)),
        ("/shapes/B/half_extents", json!([0, 2])),
        ("/shapes/B", json!({ "kind": "polygon", "vertices": [[0, 0], [1, 0]] })),
        ("/shapes/B", json!({ "kind": "capsule", "radius": 1, "points": [[0, 0]] })),
        ("/query/of", json!(["A"])),
        ("/query/kind", json!("distance")),
        ("/query/of", json!([])),
        ("/query/of", json!(["A", "B", "A"])),
        ("/query/time", json!(1.5)),
        ("/query/max_iterations", json!(2.5)),
        ("/canvas/background", json!("#GGGGGG")),
        ("/canvas/width", json!("wide")),
        ("/canvas/height", json!("tall")),
        ("/panels", json!({})),
        ("/panels/0/layers/0", json!(7)),
        ("/panels/0/layers/1", json!({ "ticks": true })),
        ("/panels/0/layers/0", json!("shaeps")),
        ("/panels/0/layers/1", json!({ "layer": "axis" })),
        ("/panels/0/layers/1", json!({ "layer": "axes", "ticks": 1 })),
        ("/panels/0/layers/1", json!({ "layer": "axes", "step": 0 })),
        ("/panels/0/layers/1", json!({ "layer": "axes", "tick": true })),
        ("/panels/0/layers/1", json!({ "layer": "axes", "role": "red" })),
        ("/panels/0/layers/1", json!({ "layer": "point", "at": [1] })),
        ("/panels/0/view", json!([0, 0, 1])),
        ("/labels/A/at", json!("up")),
        ("/labels/A/text", json!("{c|A}")),
        ("/labels/B", json!("{=separatoin}")),
        ("/title", json!("{=depht:.2} apart")),
        ("/headline", json!("a formula $x without an end")),
        ("/panels/0/title", json!("{red|words}")),
        ("/canvas/theme", json!("drak")),
        ("/query/of", json!(["A", "A"])),
        ("/exercise", json!({ "ask": "dpth" })),
        ("/exercise", json!({ "ask": ["separation", "dpth"] })),
        ("/exercise", json!({ "ask": "separation", "hide": ["shaeps"] })),
        ("/title", json!("{=separation:.2q} apart")),
        ("/headline", json!("{=separation:2}")),
        ("/lang", json!("e")),
        ("/lang", json!("de_AT")),
        ("/shapes/B/angle_rad", json!(0.5)),
        ("/steps", json!([{ "skip": true, "title": "Nothing" }])),
    ] {
        let wrong = with(pointer, put.clone());
        assert_eq!(drawn(folder.path(), &wrong), Some(1), "{pointer} {put}");
        assert!(!faults(&schema, &wrong, "").is_empty(), "the schema takes {pointer} {put}");
    }
}

#[test]
fn a_wrong_word_is_one_fault_of_the_schema_at_its_place() {
    let schema = schema("schema");
    for (pointer, put, place, wrong) in [
        ("/shapes/A/kind", json!("circel"), "/shapes/A/kind: enum", "circel"),
        ("/shapes/A/radius", json!("one"), "/shapes/A/radius: type", "one"),
        ("/shapes/A/half_extents", json!([1, 1]), "/shapes/A/half_extents: no such key", ""),
        ("/panels/0/layers/0", json!("shaeps"), "/panels/0/layers/0: enum", "shaeps"),
        ("/panels/0/layers/1/layer", json!("axis"), "/panels/0/layers/1/layer: enum", "axis"),
        ("/panels/0/layers/1/ticks", json!(1), "/panels/0/layers/1/ticks: type", "1"),
    ] {
        let found = faults(&schema, &with(pointer, put), "");
        assert!(found.len() == 1 && found[0].starts_with(place), "{pointer}: {found:#?}");
        assert!(found[0].contains(wrong), "{pointer}: {found:#?}");
    }
}

/// Whether a schema takes TOML, which must be as the program does.
fn is_taken(schema: &Value, toml: &str, code: Option<i32>) {
    let value: Value = toml::from_str(toml).unwrap();
    let found = faults(schema, &value, "");
    match code {
        Some(0) => assert!(found.is_empty(), "refused by the schema alone: {toml}\n{}", found.join("\n")),
        Some(1) => assert!(!found.is_empty(), "taken by the schema alone: {toml}"),
        other => panic!("{toml}: exit status {other:?}"),
    }
}

/// A circle's bounds.
const SCENE: &str = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";

#[test]
fn the_schema_of_project_files_is_what_the_reader_takes() {
    let schema = schema("project-schema");
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("s.toml"), SCENE).unwrap();
    std::fs::write(folder.path().join("own.toml"), "[colors]\na = '#9A1620'").unwrap();
    for (text, code) in [
        ("", 0),
        ("[render]\nscenes = ['s.toml']\nformats = ['svg', 'png']\nscale = 1\noutput = 'out'", 0),
        ("[render]\nthemes = ['dark', 'own.toml']\nsteps = 'files'", 0),
        ("[canvas]\nwidth = 500\nheight = 'auto'\ntheme = 'dark'\ntext = 14", 0),
        ("[render]\nscene = ['s.toml']", 1),
        ("[render]\nscenes = 's.toml'", 1),
        ("[render]\nscenes = []", 1),
        ("[render]\nformats = ['svgg']", 1),
        ("[render]\nformats = [1]", 1),
        ("[render]\nscale = 'big'", 1),
        ("[render]\nscale = -1", 1),
        ("[render]\nsteps = 'many'", 1),
        ("[canvas]\nwidht = 500", 1),
        ("[canvas]\nwidth = 'wide'", 1),
        ("scale = 2", 1),
    ] {
        std::fs::write(folder.path().join("tracefig.toml"), text).unwrap();
        let ran = run(tracefig(folder.path()).args(["render", "s.toml"]));
        assert_eq!(ran.code, Some(code), "{text}\n{}", ran.err);
        is_taken(&schema, text, ran.code);
    }
}

#[test]
fn the_schema_of_theme_files_is_what_the_reader_takes() {
    let schema = schema("theme-schema");
    let folder = tempfile::tempdir().unwrap();
    let own = folder.path().join("own.toml");
    std::fs::write(folder.path().join("s.toml"), format!("canvas.theme = 'own.toml'\n{SCENE}")).unwrap();
    for (text, code) in [
        ("", 0),
        ("based_on = 'dark'\nfill_opacity = 0.5", 0),
        ("[colors]\na = '#9A1620'\nink = '#123'\n[dark]\na = '#FFB0A0'", 0),
        ("[text]\nname = 20\n[stroke]\noutline = 3", 0),
        ("based_on = 'drak'", 1),
        ("fill_opacity = 1.5", 1),
        ("[colors]\nc = '#9A1620'", 1),
        ("[colors]\na = 'red'", 1),
        ("[dark]\na = '#12345'", 1),
        ("[text]\nname = 2", 1),
        ("[text]\nword = 20", 1),
        ("[stroke]\noutline = 'thick'", 1),
        ("[color]\na = '#9A1620'", 1),
    ] {
        std::fs::write(&own, text).unwrap();
        let ran = run(tracefig(folder.path()).args(["render", "s.toml", "--allow-similar"]));
        assert_eq!(ran.code, Some(code), "{text}\n{}", ran.err);
        is_taken(&schema, text, ran.code);
    }
}
