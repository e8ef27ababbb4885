//! No scene of a megabyte takes over 2 s or 500 MB, whatever it holds: it is drawn, or refused with its
//! reason.
//!
//! Time is the processor's, the least of several runs, and of a machine that [sorts](sorted) as fast as ours: a
//! busy or slow one has longer. Without optimization it says nothing: `cargo test --release --test hostile`,
//! with `TIMES` set to see what each takes.

#![cfg(target_os = "linux")]
#![expect(clippy::unwrap_used, clippy::expect_used, reason = "a test may panic wherever it is")]
#![expect(clippy::print_stdout, reason = "times, when they are asked for")]

mod hostile_figures;

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use hostile_figures::HOSTILE;

/// Seconds of processor time that a scene may take.
const SECONDS: f64 = 2.0;
/// How often what took longer is tried again.
const TRIES: usize = 3;
/// Memory that it may take, in kilobytes.
const KILOBYTES: u32 = 500_000;
/// Bytes of the largest of these scenes.
const LARGEST: usize = 1_000_100;

/// What is done with each.
const COMMANDS: &[&str] = &["render", "solve", "trace", "describe"];

/// Whether a scene is drawn, or gets an error of this code.
type Fate = Option<&'static str>;

const BOXES: &str = "[shapes.A]\nkind = 'box'\nhalf_extents = [1, 0.6]\nangle_deg = 30\n[shapes.B]\nkind = 'polygon'\n\
    vertices = [[-0.7, -0.5], [0.8, -0.3], [0.1, 0.9]]\nposition = [2.6, 0.8]\nvelocity = [0.5, 0]\n\
    [query]\nkind = 'separation'\nof = ['A', 'B']\n";

fn repeat(count: usize, piece: impl Fn(usize) -> String) -> String {
    (0..count).map(piece).collect()
}

fn list(count: usize, piece: impl Fn(usize) -> String) -> String {
    (0..count).map(piece).collect::<Vec<_>>().join(",")
}

fn panel(space: &str, layers: &str) -> String {
    format!("[[panels]]\nspace = '{space}'\nlayers = [{layers}]\n")
}

fn world(layers: &str) -> String {
    panel("world", layers)
}

/// A convex polygon of as many vertices as a shape may have, and its radius.
fn round(name: &str, x: f64, motion: &str) -> String {
    let vertices = list(4096, |k| {
        let angle = std::f64::consts::TAU * f64::from(u32::try_from(k).unwrap()) / 4096.0;
        format!("[{:.0},{:.0}]", RADIUS * libm::cos(angle), RADIUS * libm::sin(angle))
    });
    format!("[shapes.{name}]\nkind = 'polygon'\nvertices = [{vertices}]\nposition = [{x}, 0]\n{motion}\n")
}

const RADIUS: f64 = 16_777_216.0;

fn rounds(apart: f64, motion: [&str; 2], query: &str) -> String {
    let [a, b] = motion;
    round("A", 0.0, a) + &round("B", apart * RADIUS, b) + &format!("[query]\nof = ['A', 'B']\n{query}\n")
}

/// Four letters, other ones for each number.
fn word(i: usize) -> String {
    let letter = |k: u32| char::from(b'a' + u8::try_from(i / 26_usize.pow(k) % 26).unwrap());
    (0..4).map(letter).collect()
}

fn note(lines: &str) -> String {
    format!("{{ layer = 'note', lines = [{lines}] }}")
}

/// Texts that are no scene, or no small one.
#[expect(clippy::too_many_lines, reason = "a table of scenes")]
fn texts() -> Vec<(&'static str, String, Fate)> {
    let million = 1_000_000;
    vec![
        ("lists in lists", format!("a = {}", "[".repeat(million)), Some("over-limit")),
        ("tables in tables", format!("a = {}", "{a=".repeat(million / 3)), Some("over-limit")),
        ("a dotted key", format!("{}a = 1", "a.".repeat(million / 2)), Some("over-limit")),
        ("JSON in JSON", format!("{{\"a\": {}", "[".repeat(million)), Some("syntax")),
        ("one long line", format!("{{\"title\": \"{}\"}}", "y".repeat(million)), Some("over-limit")),
        ("a comment", format!("#{}", "x".repeat(million)), Some("empty-file")),
        ("empty lines", "\n".repeat(million), Some("empty-file")),
        ("keys", repeat(100_000, |i| format!("k{i}=1\n")), Some("unknown-key")),
        ("the same key", "title=1\n".repeat(125_000), Some("duplicate-key")),
        (
            "shapes",
            repeat(20_000, |i| format!("[shapes.s{i}]\nkind='circle'\nradius=1\n")),
            Some("over-limit"),
        ),
        (
            "a million coordinates",
            format!("[shapes.A]\nkind='polygon'\nvertices=[{}]\n", "[1,2],".repeat(166_000)),
            Some("over-limit"),
        ),
        ("panels", BOXES.to_owned() + &"[[panels]]\nlayers=[]\n".repeat(45_000), Some("over-limit")),
        ("layers", BOXES.to_owned() + &world(&"'shapes',".repeat(90_000)), Some("over-limit")),
        (
            "layers of all panels",
            BOXES.to_owned() + &world(&"'shapes',".repeat(200)).repeat(32),
            Some("over-limit"),
        ),
        (
            "options",
            BOXES.to_owned()
                + &world(&list(200, |_| format!("{{layer='shapes',{}}}", list(400, |k| format!("k{k}=1"))))),
            Some("unknown-key"),
        ),
        (
            "values of an option",
            BOXES.to_owned() + &world(&format!("{{layer='shapes',of=[{}]}}", "'A',".repeat(200_000))),
            Some("over-limit"),
        ),
        (
            "labels of no layer",
            BOXES.to_owned()
                + &world("'shapes'")
                + "[labels]\n"
                + &repeat(1000, |i| format!("k{i}='{}'\n", "a".repeat(900))),
            Some("unknown-key"),
        ),
        (
            "formulas",
            BOXES.to_owned()
                + &world(&note(&list(280, |i| {
                    format!("'{}'", repeat(500, |k| format!("${}$ ", word(500 * i + k))))
                }))),
            Some("over-limit"),
        ),
        (
            "long notes",
            BOXES.to_owned() + &world(&note(&list(240, |_| format!("'{}'", "x".repeat(3900))))),
            Some("over-limit"),
        ),
        (
            "values in texts",
            BOXES.to_owned() + &world(&note(&list(230, |_| format!("'{}'", "{=separation}".repeat(300))))),
            Some("over-limit"),
        ),
        (
            "bad texts",
            BOXES.to_owned() + &repeat(30, |_| world(&note(&list(1000, |_| "'$\\nope$'".to_owned())))),
            Some("bad-markup"),
        ),
        ("defined in itself", captioned(&"\\def\\x{\\x\\x}\\x".repeat(30)), Some("bad-markup")),
        (
            "fractions in fractions",
            captioned(&format!("{}1{}", "\\frac{1}{".repeat(45), "}".repeat(45))),
            Some("bad-markup"),
        ),
        (
            "roots in roots",
            captioned(&format!("{}1{}", "\\sqrt{".repeat(70), "}".repeat(70))),
            Some("bad-markup"),
        ),
        (
            "braces in braces",
            captioned(&format!("{}1{}", "{".repeat(240), "}".repeat(240))),
            Some("bad-markup"),
        ),
        ("a wide matrix", captioned(&format!("\\begin{{matrix}}{}\\end{{matrix}}", "&".repeat(440))), None),
        ("a long word", format!("caption = '{}'\n{BOXES}{}", "a".repeat(3999), world("'shapes'")), None),
        (
            "long titles",
            BOXES.to_owned()
                + &repeat(32, |_| format!("[[panels]]\ntitle='{}'\nlayers=['shapes']\n", "t".repeat(3999))),
            None,
        ),
        (
            "a circle whose size no page has",
            "[shapes.A]\nkind = 'circle'\nradius = 1\nangular_velocity_deg = 1\n[shapes.B]\nkind = 'circle'\nradius = 1\n\
                position = [1000, -1e300]\nangle_deg = -17.5\n[query]\nkind = 'motion-bound'\nof = ['A']\n\
                [[panels]]\nspace = 'body'\nframe = 'B'\nlayers = ['shapes', 'spin']\n"
                .to_owned(),
            Some("off-page"),
        ),
        (
            "many labels",
            BOXES.to_owned() + &world(&"{layer='shapes',centers=true},".repeat(200)),
            Some("over-limit"),
        ),
        (
            "steps of many vertices",
            rounds(
                3.0,
                ["velocity = [1e7, 0]\nangular_velocity_deg = 3600", ""],
                "kind='time-of-impact'\nalgorithm='conservative-advancement'\ntolerance=0\nmax_iterations=100000",
            ) + &world("'shapes'"),
            Some("out-of-range"),
        ),
    ]
}

fn captioned(formula: &str) -> String {
    format!("caption = '${formula}$'\n{BOXES}{}", world("'shapes'"))
}

/// Scenes that are drawn, or whose cost is known only from what their layers draw.
#[expect(clippy::too_many_lines, reason = "a table of scenes")]
fn figures() -> Vec<(&'static str, String, Fate)> {
    let configuration = |layers: &str| panel("configuration", layers);
    let both = world("'shapes', 'separation', 'normal'")
        + &configuration("'axes', 'difference', 'origin', 'closest', 'support'");
    let inside = |algorithm: &str| {
        rounds(1.0, ["", ""], &format!("kind='separation'\nalgorithm='{algorithm}'")) + &both
    };
    let spin = |algorithm: &str, degrees: &str, ghosts: &str| {
        format!(
            "[shapes.A]\nkind='box'\nhalf_extents=[1,0.1]\nangular_velocity_deg={degrees}\n[shapes.B]\nkind='capsule'\n\
            points=[[0,0],[1,1]]\nradius=0.1\nposition=[0,4]\nvelocity=[0,-3]\n[query]\nkind='time-of-impact'\nof=['A','B']\n\
            algorithm='{algorithm}'\ntolerance=0\nmax_iterations=100000\n{}",
            world(&format!("'shapes', {{ layer='ghosts', at='{ghosts}' }}, 'velocity'"))
        )
    };
    let near = |theme: &str, view: &str| {
        let panels = world("'shapes', 'separation', 'frame', { layer='ghosts', at='end' }")
            + &configuration("'difference', 'axes', 'origin'");
        format!(
            "canvas.theme = '{theme}'\n{BOXES}{}",
            panels.replace("layers", &format!("view = [0, 0, {view}, {view}]\nlayers"))
        )
    };
    let page = |theme: &str| {
        format!(
            "canvas = {{ width = 4096, height = 4096, theme = '{theme}' }}\n{}",
            BOXES.replace("[1, 0.6]", "[3, 3]")
        )
    };
    let moving = |layers: &str| {
        rounds(2.5, ["angular_velocity_deg = 36000", "velocity = [-2e7, 0]"], "kind='time-of-impact'")
            + &world(layers)
    };
    let mut all = vec![
        ("closest features of 8,192 vertices", inside("closest-features"), None),
        ("the article's difference of 8,192 vertices", inside("minkowski"), None),
        ("separating axes of 8,192 vertices", inside("separating-axes"), None),
        ("GJK with 8,192 vertices", inside("gjk"), None),
        (
            "a figure full of vertices",
            rounds(3.0, ["", ""], "kind='separation'") + &world("'shapes', 'separation'").repeat(4),
            None,
        ),
        (
            "copies on 4,096 vertices",
            rounds(3.0, ["", ""], "kind='separation'") + &world("'grown'"),
            Some("over-limit"),
        ),
        ("small copies on 4,096 vertices", small_copies(), None),
        (
            "shapes of 4,096 vertices",
            rounds(3.0, ["", ""], "kind='separation'") + &world(&"'shapes',".repeat(200)),
            Some("over-limit"),
        ),
        (
            "differences at many moments",
            rounds(3.0, ["velocity = [1, 0]", ""], "kind='separation'")
                + &configuration(&list(200, |i| format!("{{layer='difference',at=0.{i:03}}}"))),
            Some("over-limit"),
        ),
        (
            "shapes of 4,096 vertices that overlap",
            rounds(1.0, ["", ""], "kind='overlap'") + &world(&"'shapes',".repeat(14)),
            Some("over-limit"),
        ),
        (
            "shapes of 4,096 vertices that lie on each other",
            rounds(0.0, ["", ""], "kind='overlap'") + &world(&"'shapes',".repeat(200)),
            Some("over-limit"),
        ),
        (
            "ghosts of 4,096 vertices that overlap",
            rounds(1.0, ["velocity = [5e7, 0]", "velocity = [-3e7, 1e7]"], "kind='overlap'")
                + &world(&list(14, |i| format!("{{layer='ghosts',at=0.{i:02}}}"))),
            Some("over-limit"),
        ),
        ("turning shapes of 4,096 vertices", moving("'shapes', { layer='ghosts', at='hit' }"), None),
        (
            "a sweep of 4,096 vertices",
            rounds(3.0, ["", "velocity = [-4e7, 0]"], "kind='linear-sweep'")
                + &world("'shapes', 'ghosts', 'sweep', 'velocity'")
                + &configuration("'difference', 'ray', 'origin'"),
            None,
        ),
        ("an outline with 2,048 teeth", teeth(), Some("over-limit")),
        ("a large page", page("light") + &both, None),
        ("a large page of hatching", page("print") + &world("'shapes'"), None),
        ("large pages of hatching", page("print") + &world(&"'shapes',".repeat(9)), Some("over-limit")),
        ("sizes of 1e98", BOXES.replace("[1, 0.6]", "[1e98, 6e97]") + &world("'shapes', 'separation'"), None),
        ("sizes of 1e9", BOXES.replace("[1, 0.6]", "[1e9, 6e8]") + &both, None),
        (
            "sizes of 1e299",
            BOXES.replace("[1, 0.6]", "[1e299, 6e298]") + &world("'shapes', 'separation'"),
            Some("unsuited-shape"),
        ),
        (
            "sizes of 5e-324",
            BOXES.replace("[1, 0.6]", "[5e-324, 5e-324]") + &world("'shapes', 'separation'"),
            Some("unsuited-shape"),
        ),
    ];
    for degrees in ["1e10", "1e22"] {
        all.push(("turning without end", turning_without_end(degrees), None));
    }
    // Ten thousand turns a second take more steps of advancement than a trace may have.
    let too_fast = Some("unsuited-shape");
    for (degrees, axis, steps) in [
        ("36000", None, None),
        ("3.6e7", None, Some("over-limit")),
        ("1e90", None, None),
        ("1e300", too_fast, too_fast),
    ] {
        all.push(("spinning, swept axis", spin("swept-axis", degrees, "end"), axis));
        all.push(("spinning, advancement", spin("conservative-advancement", degrees, "steps"), steps));
    }
    all.extend(labels());
    // Dashes beyond the page count, as every viewer of the SVG walks them; from a little farther an edge has no place.
    let far_too_near = Some("over-limit");
    for (view, fate) in [
        ("1e-300", far_too_near),
        ("1e-9", far_too_near),
        ("2e-3", Some("off-page")),
        ("2e-2", None),
        ("1e9", None),
    ] {
        all.push(("seen in light", near("light", view), fate));
        all.push(("seen in print", near("print", view), fate));
    }
    all
}

/// Bodies in reach of each other, one of which turns so often that each axis lasts for next to nothing.
fn turning_without_end(degrees: &str) -> String {
    format!(
        "[shapes.A]\nkind='polygon'\nvertices=[[0,-3],[1,0],[0,1.5],[-1,0]]\nposition=[-7,-1]\nvelocity=[10,6]\n\
        angular_velocity_deg=180\n[shapes.B]\nkind='polygon'\nvertices=[[-2,-1.5],[1.5,-2],[2.5,0],[2,1.5],[-2,1.5]]\n\
        position=[7.5,-1.5]\nvelocity=[-10,6]\nangular_velocity_deg={degrees}\n[query]\nkind='time-of-impact'\n\
        of=['A','B']\nmax_iterations=100000\n{}",
        world("'shapes'")
    )
}

/// Scenes that ask much of the search for places of labels, and of arcs.
fn labels() -> Vec<(&'static str, String, Fate)> {
    let circles = |radius: &str| {
        format!(
            "[shapes.A]\nkind = 'circle'\nradius = 1\n[shapes.B]\nkind = 'circle'\nradius = {radius}\n\
             [query]\nkind = 'separation'\nof = ['A', 'B']\n"
        )
    };
    let seen = |view: &str, layers: &str| format!("[[panels]]\nview = {view}\nlayers = [{layers}]\n");
    let notes = |count| list(count, |i| note(&format!("'aaaa {i}'")));
    let many = "'shapes', 'separation', 'normal', 'radii', { layer = 'note', lines = ['a', 'b'] }";
    let arc = "[shapes.A]\nkind = 'box'\nhalf_extents = [4, 0.9]\nangular_velocity_deg = 1e9\n\
               [query]\nkind = 'motion-bound'\nof = ['A']\n";
    vec![
        ("a body larger than its view", circles("1e9") + &seen("[-5, -3, 5, 3]", "'shapes'"), None),
        ("thirty notes", circles("2") + &world(&notes(30)), None),
        ("a hundred notes", circles("2") + &world(&notes(100)), None),
        ("wide views", circles("2") + &seen("[-5, -3, 5, 1e300]", many).repeat(32), None),
        ("an arc of a billion degrees", arc.to_owned() + &world("{ layer = 'arc', sector = true }"), None),
    ]
}

/// Copies of a small polygon of 20 vertices on each of the 4,096 of another.
fn small_copies() -> String {
    let small = list(20, |k| {
        let angle = std::f64::consts::TAU * f64::from(u32::try_from(k).unwrap()) / 20.0;
        format!("[{:.0},{:.0}]", 0.05 * RADIUS * libm::cos(angle), 0.05 * RADIUS * libm::sin(angle))
    });
    let x = 3.0 * RADIUS;
    round("A", 0.0, "")
        + &format!("[shapes.B]\nkind = 'polygon'\nvertices = [{small}]\nposition = [{x}, 0]\n")
        + "[query]\nof = ['A', 'B']\nkind = 'separation'\n"
        + &world("'grown'")
}

fn teeth() -> String {
    let up = list(2048, |i| format!("[{i},{}]", i % 2 * 1000));
    let back = list(2048, |i| format!("[{},{}]", 2048 - i, -1000 - i32::try_from(i % 2).unwrap()));
    let outline =
        format!("[shapes.A]\nkind='outline'\nvertices=[{up},{back}]\n[query]\nkind='bounds'\nof=['A']\n");
    outline + &world("'shapes', 'bounds'").repeat(32)
}

/// Seconds that this machine takes to sort two million numbers.
fn sorted() -> f64 {
    let mut next = 1_u64;
    let mut numbers: Vec<u64> = (0..2_000_000)
        .map(|_| {
            next = next.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            next >> 16
        })
        .collect();
    let began = Instant::now();
    numbers.sort_unstable();
    assert!(std::hint::black_box(numbers).is_sorted());
    began.elapsed().as_secs_f64()
}

/// What [`sorted`] takes on the machine that the limit of time is for.
const SORTED: f64 = 0.025;

/// Runs a command as [`run_once`] until it is within the limit, and no more than a few times; its time is told
/// as of the machine that the limit is for, where this one is slower.
fn run(folder: &Path, arguments: &str) -> (Option<i32>, String, f64) {
    let mut best = run_once(folder, arguments);
    for _ in 0..TRIES {
        if best.2 <= SECONDS {
            break;
        }
        let slowness = (sorted() / SORTED).max(1.0);
        let (code, said, seconds) = run_once(folder, arguments);
        best = (code, said, best.2.min(seconds / slowness));
    }
    best
}

/// Runs a command under the limits of memory and, so that a hang ends, of time; what it said and how long it
/// took.
fn run_once(folder: &Path, arguments: &str) -> (Option<i32>, String, f64) {
    let script = format!(
        "ulimit -d {KILOBYTES}; ulimit -t {}; \"$0\" {arguments} >/dev/null; code=$?; times; exit $code",
        4.0 * SECONDS
    );
    let output = Command::new("sh")
        .args(["-c", &script])
        .arg(env!("CARGO_BIN_EXE_tracefig"))
        .current_dir(folder)
        .output()
        .unwrap();
    let times = String::from_utf8(output.stdout).unwrap();
    let children = times.lines().nth(1).expect("two lines of times");
    let seconds = |text: &str| -> f64 {
        let (minutes, seconds) = text.trim_end_matches('s').split_once('m').unwrap();
        60.0 * minutes.parse::<f64>().unwrap() + seconds.parse::<f64>().unwrap()
    };
    let taken = children.split_whitespace().map(seconds).sum();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned(), taken)
}

fn hold(scenes: Vec<(&'static str, String, Fate)>) {
    let folder = tempfile::tempdir().unwrap();
    let mut wrong = String::new();
    for (name, text, fate) in scenes {
        assert!(text.len() <= LARGEST, "{name} has {} bytes", text.len());
        std::fs::write(folder.path().join("s.toml"), &text).unwrap();
        for &command in COMMANDS {
            let (code, said, seconds) = run(folder.path(), &format!("{command} s.toml"));
            if std::env::var_os("TIMES").is_some() {
                println!("{seconds:6.2} s  {command} {name}");
            }
            let as_told = match fate {
                // A place that is on no page is told by `render` alone.
                None => {
                    code == Some(0)
                        || (code == Some(1) && said.contains("has a place that is not on any page"))
                }
                Some(error) => {
                    command != "render" || (code == Some(1) && said.contains(&format!("error[{error}]")))
                }
            };
            let fine =
                as_told && seconds <= SECONDS && !said.contains("this is a bug") && said.len() < 40_000;
            if !fine || !matches!(code, Some(0 | 1)) {
                let head: String = said.chars().take(300).collect();
                writeln!(wrong, "{command} {name}: {code:?}, {seconds:.2} s, {head}").unwrap();
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "a time without optimization says nothing; it is run in release")]
fn no_text_of_a_megabyte_takes_2_seconds_or_500_megabytes() {
    hold(texts());
}

#[test]
#[cfg_attr(debug_assertions, ignore = "a time without optimization says nothing; it is run in release")]
fn no_figure_of_a_megabyte_takes_2_seconds_or_500_megabytes() {
    hold(figures());
}

/// What `check` of a folder takes.
fn hold_check(folder: &Path, name: &str, arguments: &str, told: &str) -> Result<(), String> {
    let (code, said, seconds) = run(folder, &format!("{arguments} --junit found"));
    if std::env::var_os("TIMES").is_some() {
        println!("{seconds:6.2} s  check {name}");
    }
    let found = std::fs::read_to_string(folder.join("found")).unwrap_or_default();
    if code == Some(1) && seconds <= SECONDS && found.contains(told) {
        return Ok(());
    }
    Err(format!("check {name}: {code:?}, {seconds:.2} s, {said} {found}\n"))
}

#[test]
#[cfg_attr(debug_assertions, ignore = "a time without optimization says nothing; it is run in release")]
fn no_figure_on_disk_takes_check_2_seconds_or_500_megabytes() {
    let mut wrong = String::new();
    for hostile in HOSTILE {
        let folder = tempfile::tempdir().unwrap();
        hostile.put(folder.path());
        let arguments = hostile.arguments().join(" ").replace("--scale 1", "");
        wrong.extend(hold_check(folder.path(), hostile.name, &arguments, hostile.told).err());
    }
    // Also a figure of ours, as large as one may be, that has changed.
    for format in ["svg", "png"] {
        let folder = tempfile::tempdir().unwrap();
        let scene = |radius: &str| {
            let page = "canvas = { width = 4096, height = 4096 }\n";
            page.to_owned() + hostile_figures::SCENE.replace("radius = 1", radius).as_str()
        };
        std::fs::write(folder.path().join("s.toml"), scene("radius = 1")).unwrap();
        run(folder.path(), &format!("render s.toml --format {format}"));
        std::fs::write(folder.path().join("s.toml"), scene("radius = 1.5")).unwrap();
        let arguments = format!("check s.toml --format {format}");
        wrong.extend(hold_check(folder.path(), "a large page", &arguments, "pixels differ").err());
    }
    assert!(wrong.is_empty(), "{wrong}");
}
