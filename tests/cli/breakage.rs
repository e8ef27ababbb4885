//! What `check` says of files broken in every way that we could think of, and of those that are only other in
//! what nobody sees.

use std::fs;
use std::path::Path;

use crate::render::{drawn, names, set};
use crate::{Ran, folder_with, run, tracefig};

/// A way to break a folder with `s.toml`, `s.svg` and `s.png`.
struct Breakage {
    name: &'static str,
    /// What happens to the folder.
    done: fn(&Path),
    /// How the check ends.
    code: i32,
    /// What it says on standard output.
    says: &'static [&'static str],
}

/// Writes a file anew from its bytes.
fn change(folder: &Path, name: &str, to: impl FnOnce(Vec<u8>) -> Vec<u8>) {
    let path = folder.join(name);
    fs::write(&path, to(fs::read(&path).unwrap())).unwrap();
}

/// Writes the scene anew from its text.
fn scene(folder: &Path, to: impl FnOnce(String) -> String) {
    change(folder, "s.toml", |bytes| to(String::from_utf8(bytes).unwrap()).into_bytes());
}

const BREAKAGES: &[Breakage] = &[
    Breakage {
        name: "an empty SVG",
        done: |f| fs::write(f.join("s.svg"), "").unwrap(),
        code: 1,
        says: &["changed   s.svg\n          the file is empty\n", "1 identical, 1 changed"],
    },
    Breakage {
        name: "an empty PNG",
        done: |f| fs::write(f.join("s.png"), "").unwrap(),
        code: 1,
        says: &["changed   s.png\n          the file is empty\n"],
    },
    Breakage {
        name: "an SVG cut short",
        done: |f| change(f, "s.svg", |mut b| b.drain(..2500).collect()),
        code: 1,
        says: &["          the file is cut short after 2,500 bytes\n"],
    },
    Breakage {
        name: "a PNG cut short",
        done: |f| change(f, "s.png", |mut b| b.drain(..5000).collect()),
        code: 1,
        says: &["          the file is cut short after 5,000 bytes\n"],
    },
    Breakage {
        name: "an older PNG cut short",
        done: |f| {
            scene(f, |t| t.replace("radius = 2", "radius = 1.5"));
            change(f, "s.png", |mut b| b.drain(..5000).collect());
        },
        code: 1,
        says: &["stale     s.svg\n", "          the file is cut short after 5,000 bytes\n"],
    },
    Breakage {
        name: "a page in the place of a PNG",
        done: |f| fs::write(f.join("s.png"), "<html>not found</html>").unwrap(),
        code: 1,
        says: &["          the file is not a PNG\n"],
    },
    Breakage {
        name: "a pointer of Git LFS in the place of a PNG",
        done: |f| {
            let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 1234\n";
            fs::write(f.join("s.png"), pointer).unwrap();
        },
        code: 1,
        says: &["          a Git LFS pointer and not the picture: `git lfs pull` fetches it"],
    },
    Breakage {
        name: "marks of a conflict",
        done: |f| {
            change(f, "s.svg", |b| {
                String::from_utf8(b).unwrap().replacen("<desc", "<<<<<<< HEAD\n<desc", 1).into_bytes()
            });
        },
        code: 1,
        says: &["column 2: on disk `<<<<<<< HEAD`, now `<desc "],
    },
    Breakage {
        name: "an image of another scale",
        done: |f| {
            let half = ["render", "s.toml", "--format", "png", "--scale", "0.5"];
            assert_eq!(run(tracefig(f).args(half)).code, Some(0));
        },
        code: 1,
        says: &["stale     s.png\n          on disk 480 × ", " pixels, now 960 × "],
    },
    Breakage {
        name: "a PNG in the place of an SVG",
        done: |f| fs::rename(f.join("s.png"), f.join("s.svg")).unwrap(),
        code: 1,
        says: &["          the file is not an SVG\n"],
    },
    Breakage {
        name: "a PNG with wrong bytes in the middle",
        done: |f| {
            change(f, "s.png", |mut b| {
                b[4000..4040].fill(0x55);
                b
            });
        },
        code: 1,
        says: &["          the file can't be read as a PNG; it differs from byte 4,0"],
    },
    Breakage {
        name: "a folder in the place of an SVG",
        done: |f| {
            fs::remove_file(f.join("s.svg")).unwrap();
            fs::create_dir(f.join("s.svg")).unwrap();
        },
        code: 74,
        says: &["1 identical, 0 changed, 0 missing, 1 error\n"],
    },
    Breakage {
        name: "no SVG",
        done: |f| fs::remove_file(f.join("s.svg")).unwrap(),
        code: 1,
        says: &["missing   s.svg\n", "1 identical, 0 changed, 1 missing\n"],
    },
    Breakage {
        name: "a colour changed by hand",
        done: |f| {
            change(f, "s.svg", |b| String::from_utf8(b).unwrap().replace("#bc0d2a", "#b60d2a").into_bytes());
        },
        code: 1,
        says: &["changed   s.svg\n", "colour of a #b60d2a → #bc0d2a", "in the changed area: body-A"],
    },
    Breakage {
        name: "lines that end otherwise",
        done: |f| {
            change(f, "s.svg", |b| String::from_utf8(b).unwrap().replace('\n', "\r\n").into_bytes());
        },
        code: 1,
        says: &["changed   s.svg\n          the same text, but its lines end in CR LF", "`*.svg -text` in"],
    },
    Breakage {
        name: "a body that moved",
        done: |f| scene(f, |t| t.replace("position = [4, 0]", "position = [5, 0]")),
        code: 1,
        says: &["separation: 1.0 → 2.0", "0 identical, 0 changed, 2 stale"],
    },
    Breakage {
        name: "a scene that is none any more",
        done: |f| scene(f, |t| t.replace("radius = 2", "radius = -2")),
        code: 1,
        says: &["0 identical, 0 changed, 0 missing, 1 error\n"],
    },
    Breakage {
        name: "a scene of another name",
        done: |f| fs::rename(f.join("s.toml"), f.join("t.toml")).unwrap(),
        code: 1,
        says: &["missing   ./t.svg\n", "orphan    ./s.png\n", "orphan    ./s.svg\n"],
    },
    Breakage {
        name: "a comment in the scene",
        done: |f| scene(f, |t| format!("# drawn for the talk\n{t}")),
        code: 0,
        says: &["2 identical, 0 changed, 0 missing\n"],
    },
    Breakage {
        name: "a default that is written out",
        done: |f| scene(f, |t| t.replace("radius = 1", "radius = 1\nangle_deg = 0")),
        code: 0,
        says: &["2 identical, 0 changed, 0 missing\n"],
    },
    Breakage {
        name: "another version of tracefig that draws the same",
        done: |f| {
            change(f, "s.svg", |b| {
                let now = format!("\"version\":\"{}\"", env!("CARGO_PKG_VERSION"));
                let text = String::from_utf8(b).unwrap();
                assert!(text.contains(&now));
                text.replace(&now, "\"version\":\"0.0.1\"").into_bytes()
            });
        },
        code: 0,
        says: &["2 identical, 0 changed, 0 missing\n"],
    },
];

fn check(folder: &Path, more: &[&str]) -> Ran {
    // By the folder where the scene itself may be gone.
    let scene = if folder.join("s.toml").exists() { "s.toml" } else { "." };
    run(tracefig(folder).args(["check", scene, "--scale", "1", "-o", "drift"]).args(more))
}

#[test]
fn every_breakage_is_told_for_what_it_is_and_what_shows_nothing_is_none() {
    let mut wrong = Vec::new();
    for Breakage { name, done, code, says } in BREAKAGES {
        let folder = folder_with("s.toml", &drawn());
        assert_eq!(run(tracefig(folder.path()).args(["render", "s.toml", "--scale", "1"])).code, Some(0));
        done(folder.path());
        let ran = check(folder.path(), &[]);
        if ran.code != Some(*code) || !says.iter().all(|said| ran.out.contains(said)) {
            wrong.push(format!("{name}: {:?} {}{}", ran.code, ran.out, ran.err));
        }
        let page = "all of it: drift/index.html\n";
        if ran.out.contains(page) != (*code != 0)
            || folder.path().join("drift/index.html").exists() != (*code != 0)
        {
            wrong.push(format!("{name}: the page is there and named where something is wrong: {}", ran.out));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn an_orphan_is_deleted_where_that_is_wanted_and_nothing_else() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    assert_eq!(run(tracefig(here).args(["render", "s.toml", "--scale", "1"])).code, Some(0));
    fs::rename(here.join("s.svg"), here.join("gone.svg")).unwrap();
    fs::write(here.join("logo.svg"), "<svg/>").unwrap();
    let prune = |more: &[&str]| {
        run(tracefig(here).args(["check", ".", "--scale", "1", "-o", "drift", "--prune"]).args(more))
    };
    // What is missing is still wrong.
    assert_eq!(prune(&["--format", "svg"]).code, Some(1));
    fs::rename(here.join("s.png"), here.join("gone.png")).unwrap();
    let ran = prune(&["--accept"]);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    assert!(
        ran.out.contains("orphan    ./gone.png\n          it had no scene, and was deleted\n"),
        "{}",
        ran.out
    );
    assert_eq!(names(here), set(&["drift", "logo.svg", "s.png", "s.svg", "s.toml"]));
}

#[test]
fn what_an_earlier_check_left_is_taken_away_and_nothing_else() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    assert_eq!(run(tracefig(here).args(["render", "s.toml", "--scale", "1"])).code, Some(0));
    scene(here, |t| t.replace("position = [4, 0]", "position = [5, 0]"));
    assert_eq!(check(here, &[]).code, Some(1));
    let left = names(&here.join("drift"));
    assert_eq!(left, set(&["index.html", "s.png", "s.svg.png"]));
    fs::copy(here.join("s.png"), here.join("drift/theirs.png")).unwrap();
    fs::write(here.join("drift/notes.txt"), "mine").unwrap();
    // Pictures of differences are no figures without a scene either.
    assert!(!run(tracefig(here).args(["check", ".", "-o", "other"])).out.contains("orphan    ./drift/s."));
    assert_eq!(check(here, &["--accept"]).code, Some(0));
    assert_eq!(check(here, &[]).code, Some(0));
    assert_eq!(names(&here.join("drift")), set(&["notes.txt", "theirs.png"]));
}

#[test]
fn the_findings_for_programs_have_numbers() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    assert_eq!(run(tracefig(here).args(["render", "s.toml", "--scale", "1"])).code, Some(0));
    scene(here, |t| t.replace("position = [4, 0]", "position = [5, 0]"));
    let report: serde_json::Value = serde_json::from_str(&check(here, &["--json"]).out).unwrap();
    let numbers = &report["files"][1]["numbers"];
    assert_eq!(numbers["bytes"]["expected"], fs::metadata(here.join("s.png")).unwrap().len());
    let pixels = &numbers["pixels"];
    assert_eq!(pixels["beyond"]["0"], pixels["differ"]);
    assert!(pixels["differ"].as_u64().unwrap() > 1000 && pixels["worst"].as_u64().unwrap() > 100, "{pixels}");
    let corners: Vec<f64> = pixels["box"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    assert!(corners.len() == 4 && corners[0] < corners[2] && corners[1] < corners[3], "{pixels}");
    let elements = numbers["elements"].as_array().unwrap();
    let b = elements.iter().find(|element| element["name"] == "body-B").unwrap();
    assert_eq!(b["box"].as_array().unwrap().len(), 4);
}
