//! Every wrong scene gets its message: code, file, line and column, the line itself, what was expected, what
//! is near.

use crate::{CIRCLES, folder_with, run, run_on, tracefig};

/// What `solve` says of a scene on standard error.
fn complaint(name: &str, text: &str) -> String {
    let folder = folder_with(name, text);
    let ran = run(tracefig(folder.path()).args(["solve", name]));
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    assert_eq!(ran.out, "");
    ran.err
}

/// [`CIRCLES`] with one text in the place of another.
fn changed(from: &str, to: &str) -> String {
    assert!(CIRCLES.contains(from), "{from}");
    CIRCLES.replacen(from, to, 1)
}

/// Asserts that the message of a changed scene begins with these lines.
#[track_caller]
fn says(from: &str, to: &str, expected: &str) {
    let got = complaint("s.toml", &changed(from, to));
    assert!(got.starts_with(expected.trim_start_matches('\n')), "expected {expected}\ngot\n{got}");
}

#[test]
fn an_unknown_key_suggests_the_nearest() {
    says(
        "radius = 2",
        "raduis = 2",
        "
error[missing-key]: a circle lacks `radius`: expected a number
 --> s.toml:5:1
  |
5 | [shapes.B]
  | ^^^^^^^^^^
  |
  = help: add `radius` there

error[unknown-key]: unknown key `raduis` in a circle
 --> s.toml:7:1
  |
7 | raduis = 2
  | ^^^^^^
  |
  = help: did you mean `radius`?
",
    );
}

#[test]
fn an_unknown_kind_suggests_the_nearest() {
    says(
        "kind = \"circle\"\nradius = 2",
        "kind = \"cirlce\"\nradius = 2",
        "
error[unknown-word]: unknown kind of shape `cirlce`
 --> s.toml:6:8
  |
6 | kind = \"cirlce\"
  |        ^^^^^^^^
  |
  = help: did you mean `circle`?
",
    );
}

#[test]
fn unknown_words_of_the_query_are_told() {
    says(
        "\"separation\"",
        "\"seperation\"",
        "error[unknown-word]: unknown kind of query `seperation`\n  --> s.toml:10:8\n",
    );
    let with = |line: &str| format!("of = [\"A\", \"B\"]\n{line}");
    says(
        "of = [\"A\", \"B\"]",
        &with("algorithm = \"circle\""),
        "error[unknown-word]: unknown algorithm `circle`\n  --> s.toml:12:13\n",
    );
    says(
        "of = [\"A\", \"B\"]",
        &with("algorithm = \"extents\""),
        "error[unsuited-algorithm]: the algorithm `extents` does not take this query: ",
    );
    says(
        "of = [\"A\", \"B\"]",
        &with("time = 1.5"),
        "error[out-of-range]: `time`: expected a number in [0, 1], got 1.5\n  --> s.toml:12:8\n",
    );
    says(
        "of = [\"A\", \"B\"]",
        &with("max_iterations = 2.5"),
        "error[out-of-range]: `max_iterations`: expected a whole number in [1, 100000], got 2.5\n",
    );
}

#[test]
fn wrong_types_say_what_was_expected() {
    says(
        "radius = 2",
        "radius = \"2\"",
        "error[wrong-type]: `radius`: expected a number, got the text \"2\"\n --> s.toml:7:10\n",
    );
    says(
        "position = [4, 0]",
        "position = [4, 0, 1]",
        "error[wrong-type]: `position`: expected two numbers [x, y], got a list of 3 values\n --> s.toml:8:12\n",
    );
    says(
        "title = \"Two circles\"",
        "title = 1",
        "error[wrong-type]: `title`: expected a text, got 1\n --> s.toml:1:9\n",
    );
    says(
        "[shapes.B]\nkind = \"circle\"\nradius = 2\nposition = [4, 0]",
        "[shapes]\nB = 3",
        "error[wrong-type]: `B`: expected a table, got 3\n",
    );
}

#[test]
fn numbers_that_are_not_finite_are_told() {
    says(
        "radius = 2",
        "radius = inf",
        "error[not-finite]: `radius`: expected a finite number, got inf\n --> s.toml:7:10\n",
    );
    says(
        "[4, 0]",
        "[4, -nan]",
        "error[not-finite]: `position`: expected a finite number, got nan\n --> s.toml:8:16\n",
    );
    says(
        "[4, 0]",
        "[4, 1e301]",
        "error[out-of-range]: `position`: expected a number within ±1e300, got 1e301\n",
    );
}

#[test]
fn shapes_that_are_not_what_they_say_are_told_at_the_vertex() {
    let polygon = |vertices: &str| format!("kind = \"polygon\"\nvertices = {vertices}\n");
    let circle = "kind = \"circle\"\nradius = 2\n";
    says(circle, &polygon("[[0, 0], [2, 0], [0.5, 0.5], [0, 2]]"), "error[not-convex]: `vertices`: ");
    says(circle, &polygon("[[0, 0], [2, 0]]"), "error[too-few-corners]: `vertices`: ");
    says(circle, &polygon("[[0, 0], [1, 1], [2, 2]]"), "error[degenerate]: `vertices`: ");
    says(
        circle,
        &polygon("[[0, 0], [1, 1], [2]]"),
        "error[wrong-type]: `vertices`: expected two numbers [x, y], got a list of one value\n --> s.toml:7:29\n",
    );
    says(
        "radius = 2",
        "radius = -2",
        "error[negative-radius]: `radius`: expected 0 or more, got -2\n --> s.toml:7:10\n",
    );
}

#[test]
fn an_aabb_does_not_turn() {
    let circle = "kind = \"circle\"\nradius = 2\n";
    let aabb = |line: &str| format!("kind = \"aabb\"\nhalf_extents = [1, 1]\n{line}\n");
    says(
        circle,
        &aabb("angle_deg = 30"),
        "error[fixed-angle]: `angle_deg`: an `aabb` does not turn: expected 0, got 30\n --> s.toml:8:13\n",
    );
    says(
        circle,
        &aabb("angular_velocity_deg = -1"),
        "error[fixed-angle]: `angular_velocity_deg`: an `aabb` does not turn: expected 0, got -1\n",
    );
    let folder = folder_with("s.toml", &changed(circle, &aabb("angle_deg = 0")));
    assert_eq!(run(tracefig(folder.path()).args(["solve", "s.toml"])).code, Some(0));
}

#[test]
fn a_query_of_shapes_that_are_not_there_is_told() {
    says(
        "[\"A\", \"B\"]",
        "[\"A\", \"C\"]",
        "
error[unknown-body]: the scene has no shape `C`
  --> s.toml:11:12
   |
11 | of = [\"A\", \"C\"]
   |            ^^^
   |
   = help: known are: `A`, `B`
",
    );
    says(
        "[\"A\", \"B\"]",
        "[\"A\"]",
        "error[wrong-count]: `of`: a `separation` query is of two shapes, got 1\n  --> s.toml:11:6\n",
    );
    says(
        "[\"A\", \"B\"]",
        "[\"A\", \"A\"]",
        "error[conflict]: `of`: expected different shapes, got `A` twice\n  --> s.toml:11:12\n",
    );
}

#[test]
fn a_sweep_of_a_turning_shape_is_told() {
    let scene = changed("\"separation\"", "\"linear-sweep\"")
        .replace("radius = 2", "radius = 2\ncenter = [1, 0]\nangular_velocity_deg = 90");
    let got = complaint("s.toml", &scene);
    assert!(
        got.starts_with(
            "error[turning-body]: a `linear-sweep` is of shapes that do not turn, but `B` does\n"
        ),
        "{got}"
    );
    assert!(got.contains("= help: ask for a `time-of-impact`"), "{got}");
}

#[test]
fn panels_and_labels_are_checked() {
    let panel = |text: &str| format!("{CIRCLES}[[panels]]\n{text}\n");
    let cases = [
        ("space = \"wolrd\"\nlayers = []", "error[unknown-word]: unknown space `wolrd`\n  --> s.toml:13:9\n"),
        (
            "space = \"body\"\nlayers = []",
            "error[missing-key]: a panel with `space = \"body\"` lacks `frame`: expected the name of a shape: \
             \"A\" or \"B\"\n",
        ),
        ("time = \"strat\"\nlayers = []", "error[unknown-word]: unknown moment `strat`\n  --> s.toml:13:8\n"),
        (
            "time = 0\nstep = 1\nlayers = []",
            "error[conflict]: a panel has a `time` or a `step`, not both\n  --> s.toml:14:8\n",
        ),
        (
            "view = [0, 0, 0, 1]\nlayers = []",
            "error[out-of-range]: `view`: expected x0 < x1 and y0 < y1, got [0, 0, 0, 1]\n",
        ),
        (
            "layers = [\"shapes\", 3]",
            "error[wrong-type]: `layers`: expected a layer, by name or as a table { layer = \"…\", … }, got 3\n  --> s.toml:13:21\n",
        ),
        (
            "layers = []\n[labels]\nA = { at = \"NX\" }",
            "error[unknown-word]: unknown direction `NX`\n  --> s.toml:15:12\n",
        ),
        (
            "layers = []\n[canvas]\nwidth = 1e9",
            "error[out-of-range]: `width`: expected a number in [100, 4096], got 1000000000\n",
        ),
    ];
    for (text, expected) in cases {
        let got = complaint("s.toml", &panel(text));
        assert!(got.starts_with(expected), "{text}: {got}");
    }
}

#[test]
fn every_problem_of_a_file_is_told_in_its_order() {
    let got = complaint("s.toml", &changed("radius = 1", "radus = 1").replace("radius = 2", "radius = true"));
    let codes: Vec<_> = got.lines().filter_map(|l| l.strip_prefix("error[")?.split(']').next()).collect();
    assert_eq!(codes, ["missing-key", "unknown-key", "wrong-type"], "{got}");
}

#[test]
fn broken_toml_is_told_at_its_place() {
    says("radius = 2", "radius = = 2", "error[syntax]: not TOML: ");
    let got = complaint("s.toml", &changed("radius = 2", "radius = = 2"));
    assert!(got.contains("--> s.toml:7:10") && got.contains("7 | radius = = 2"), "{got}");
    says(
        "radius = 2",
        "radius = 2\nradius = 3",
        "error[duplicate-key]: the key `radius` stands twice\n --> s.toml:8:1\n",
    );
}

#[test]
fn json_names_the_pointer() {
    let text = "{\n  \"shapes\": {\"A\": {\"kind\": \"circle\", \"radius\": -1}},\n  \"query\": {\"kind\": \"bounds\", \"of\": [\"A\"]}\n}\n";
    let got = complaint("s.json", text);
    assert!(
        got.starts_with("error[negative-radius]: `radius`: expected 0 or more, got -1\n --> s.json:2:48\n"),
        "{got}"
    );
    assert!(got.contains("= note: at /shapes/A/radius"), "{got}");
    let got = complaint("s.json", "{\"shapes\": {");
    assert!(got.starts_with("error[syntax]: not JSON: EOF while parsing"), "{got}");
}

#[test]
fn empty_and_missing_files_are_told() {
    assert!(
        complaint("s.toml", "\n# nothing\n")
            .starts_with("error[empty-file]: expected a scene, got an empty file\n --> s.toml:1:1\n")
    );
    let folder = tempfile::tempdir().unwrap();
    let ran = run(tracefig(folder.path()).args(["solve", "no/such.toml"]));
    assert_eq!(ran.code, Some(74));
    assert!(ran.err.starts_with("error[unreadable-file]: can't read the scene: No such file"), "{}", ran.err);
    assert!(ran.err.contains("--> no/such.toml"), "{}", ran.err);
}

#[test]
fn what_is_no_text_or_too_large_is_told() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("s.toml"), b"title = \"\xff\"").unwrap();
    let ran = run(tracefig(folder.path()).args(["solve", "s.toml"]));
    assert!(
        ran.err.starts_with("error[not-utf8]: expected UTF-8 text, got other bytes\n --> s.toml:1:10\n"),
        "{}",
        ran.err
    );
    let got = complaint("s.toml", &format!("title = \"{}\"", "x".repeat(5_000_000)));
    assert!(
        got.starts_with("error[over-limit]: the file: expected at most 4194304 bytes, got 5000010\n"),
        "{got}"
    );
    let piped = run_on(tracefig(folder.path()).args(["solve", "-"]), "#".repeat(5_000_000));
    let told = "error[over-limit]: the file: expected at most 4194304 bytes, got more\n --> <stdin>\n";
    assert_eq!(piped.err, told.to_owned() + "  = help: look whether it is the file that was meant\n");
    let got = complaint("s.toml", &changed("Two circles", &"x".repeat(4001)));
    assert!(
        got.starts_with("error[over-limit]: `title`: expected at most 4000 characters, got 4001\n"),
        "{got}"
    );
    let deep = complaint("s.json", &format!("{{\"title\": {}", "[".repeat(100_000)));
    assert!(deep.starts_with("error[syntax]"), "{deep}");
    let deep = complaint("s.toml", &format!("a{} = 1", ".a".repeat(100_000)));
    assert!(
        deep.starts_with("error[over-limit]: nesting: expected at most 16 levels, got 17\n --> s.toml:1:"),
        "{deep}"
    );
    assert!(deep.len() < 600, "{deep}");
}

#[test]
fn one_bad_scene_does_not_stop_the_others() {
    let folder = folder_with("b.toml", &changed("radius = 1", "radius = -1"));
    for name in ["a.toml", "c.toml"] {
        std::fs::write(folder.path().join(name), CIRCLES).unwrap();
    }
    let ran = run(tracefig(folder.path()).args(["solve", "a.toml", "b.toml", "missing.toml", "c.toml"]));
    assert_eq!(ran.code, Some(74));
    assert_eq!(ran.out.matches(": separation of A and B").count(), 2, "{}", ran.out);
    assert_eq!(ran.err.matches("error[").count(), 2, "{}", ran.err);
}

#[test]
fn an_angle_in_two_units_names_both() {
    let angles = "radius = 2\nangle_deg = 30\nangle_rad = 0.5";
    let got = complaint("s.toml", &changed("radius = 2", angles));
    let expected = "error[conflict]: `angle_deg` and `angle_rad` both say how it is turned: expected one of \
                    them, got both\n --> s.toml:9:13\n";
    assert!(got.starts_with(expected), "{got}");
}

#[test]
fn two_ways_to_say_a_turn_are_not_said_to_say_the_same_and_a_shape_has_a_name() {
    let turned = changed("radius = 2", "radius = 2\nangle_deg = 30\nrotation = [1, 0]");
    let got = complaint("s.toml", &turned);
    assert!(got.contains("`angle_deg` and `rotation` both say how it is turned"), "{got}");
    let line = r#"{"shapes": {"A": {"kind": "circle", "radius": 1}, "": {"kind": "circle", "radius": 1}},
        "query": {"kind": "overlap", "of": ["A", ""]}}"#;
    let got = complaint("s.json", line);
    assert!(got.contains("expected a name of at least one letter, got \"\""), "{got}");
}
