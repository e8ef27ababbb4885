//! The project file, folders in depth, and where figures go.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use crate::render::drawn;
use crate::{Ran, folder_with, run, run_on, tracefig};

/// A folder with files, each a path and a text.
fn tree(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

fn ran(folder: &Path, arguments: &[&str]) -> Ran {
    run(tracefig(folder).args(arguments))
}

/// Width and height of a PNG.
fn dots(png: &Path) -> [u32; 2] {
    let bytes = fs::read(png).unwrap();
    [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()))
}

#[test]
fn a_folder_is_searched_in_depth_and_what_is_no_scene_is_left_alone() {
    let scene = drawn();
    let folder = tree(&[
        ("docs/b.toml", &scene),
        ("docs/deep/er/a.toml", &scene),
        ("docs/package.json", "{\"name\": \"x\"}"),
        ("docs/tsconfig.json", "{ // comments\n}"),
        ("docs/brand.toml", "based_on = \"dark\"\n"),
        ("docs/tracefig.toml", ""),
        ("docs/.hidden/c.toml", &scene),
        ("docs/target/c.toml", &scene),
        ("docs/node_modules/c.toml", &scene),
        ("elsewhere/d.toml", &scene),
    ]);
    #[cfg(unix)]
    std::os::unix::fs::symlink("../elsewhere", folder.path().join("docs/link")).unwrap();
    let got = ran(folder.path(), &["render", "docs", "--format", "svg"]);
    assert_eq!(
        (got.code, got.err.as_str()),
        (Some(0), "note: docs/brand.toml, docs/package.json and docs/tsconfig.json are no scenes\n")
    );
    assert_eq!(got.out, "docs/b.svg\ndocs/deep/er/a.svg\n");
    // In another folder it is the same tree, so that no two scenes want one place.
    let got = ran(folder.path(), &["render", "docs", "--format", "svg", "-o", "out"]);
    assert_eq!(got.out, "out/b.svg\nout/deep/er/a.svg\n");
    // A scene with an error in it is a scene.
    fs::write(folder.path().join("docs/deep/bad.toml"), "[shapes.A]\nkind = 'circel'\n").unwrap();
    fs::write(folder.path().join("docs/deep/broken.toml"), "[shapes.A\n[query]\n").unwrap();
    let got = ran(folder.path(), &["check", "docs", "--format", "svg"]);
    assert_eq!(got.code, Some(1));
    assert!(got.out.ends_with("2 identical, 0 changed, 0 missing, 2 error\n"), "{}{}", got.out, got.err);
    let named = ran(folder.path(), &["render", "docs/tracefig.toml"]);
    assert_eq!(named.err, "error: docs/tracefig.toml is a project file and no scene\n");
}

#[test]
fn an_orphan_is_found_in_depth_and_in_the_output_folder_of_a_project() {
    let project = "[render]\nscenes = [\"docs\"]\noutput = \"img\"\nformats = [\"svg\"]\n";
    let folder =
        tree(&[("tracefig.toml", project), ("docs/a/x.toml", &drawn()), ("docs/b/y.toml", &drawn())]);
    let got = ran(folder.path(), &["render"]);
    assert_eq!((got.code, got.out.as_str(), got.err.as_str()), (Some(0), "img/a/x.svg\nimg/b/y.svg\n", ""));
    assert_eq!(ran(folder.path(), &["check"]).out, "2 identical, 0 changed, 0 missing\n");
    fs::remove_file(folder.path().join("docs/b/y.toml")).unwrap();
    assert!(ran(folder.path(), &["check"]).out.starts_with("orphan    img/b/y.svg\n"));
}

#[test]
fn the_project_is_found_upward_and_one_scene_has_one_place_from_wherever_it_is_drawn() {
    let project = "render = { scenes = ['docs'], output = 'img', formats = ['svg'] }\n";
    let folder = tree(&[("tracefig.toml", project), ("docs/a/x.toml", &drawn()), ("other.toml", &drawn())]);
    let a = folder.path().join("docs/a");
    assert_eq!(ran(folder.path(), &["render", "docs/a/x.toml"]).out, "img/a/x.svg\n");
    assert_eq!(ran(folder.path(), &["render", "docs/a"]).out, "img/a/x.svg\n");
    for arguments in [&["check"][..], &["check", "x.toml"], &["check", "."]] {
        let got = ran(&a, arguments);
        assert_eq!((got.code, got.err.as_str()), (Some(0), ""), "{}", got.out);
        assert_eq!(got.out, "1 identical, 0 changed, 0 missing\n");
    }
    // A scene that is in none of its folders, and one that comes from standard input.
    assert_eq!(ran(folder.path(), &["render", "other.toml"]).out, "img/other.svg\n");
    let piped = run_on(tracefig(&a).args(["render", "-"]), drawn());
    assert!(piped.out.starts_with("<svg"), "{}{}", piped.out, piped.err);
}

#[test]
fn a_flag_beats_the_project_and_the_nearest_project_all_others() {
    let outer =
        "[render]\nformats = ['png']\nscale = 0.5\nthemes = ['dark']\n[canvas]\nwidth = 800\nheight = 400\n";
    let inner = "[canvas]\nwidth = 700\nheight = 400\n";
    let folder = tree(&[
        ("tracefig.toml", outer),
        ("x.toml", &drawn()),
        ("own.toml", &format!("{}[canvas]\nwidth = 640\n", drawn())),
        ("in/tracefig.toml", inner),
        ("in/y.toml", &drawn()),
    ]);
    let here = folder.path();
    assert_eq!(ran(here, &["render", "x.toml", "own.toml"]).out, "x.png\nown.png\n");
    assert_eq!((dots(&here.join("x.png")), dots(&here.join("own.png"))), ([400, 200], [320, 200]));
    // Nothing of the outer one holds where another is nearer.
    assert_eq!(ran(here, &["render", "in/y.toml"]).out, "in/y.svg\nin/y.png\n");
    assert_eq!(dots(&here.join("in/y.png")), [1400, 800]);
    let flags = ["render", "x.toml", "--scale", "1", "--format", "png,svg", "--theme", "light", "-o", "out"];
    assert_eq!(ran(here, &flags).out, "out/x.png\nout/x.svg\n");
    assert_eq!(dots(&here.join("out/x.png")), [800, 400]);
    let light = ran(here, &["render", "x.toml", "-o", "-", "--format", "svg", "--theme", "light"]).out;
    let dark = ran(here, &["render", "x.toml", "-o", "-", "--format", "svg"]).out;
    assert!(light.contains("fill=\"#fff\"") && !dark.contains("fill=\"#fff\""));
    // What the project says of the page is what the scene means: another page is another figure.
    assert_eq!(ran(here, &["check", "x.toml"]).code, Some(0));
    fs::write(here.join("tracefig.toml"), outer.replace("width = 800", "width = 810")).unwrap();
    assert!(ran(here, &["check", "x.toml"]).out.starts_with("stale     x.png\n"));
    assert_eq!(ran(here, &["render", "x.toml", "--skip-unchanged"]).out, "x.png\n");
}

#[test]
fn what_is_wrong_with_a_project_file_is_told_at_its_line() {
    let cases = [
        (
            "[render]\nscenes = ['.']\nfromats = ['svg']\n",
            "unknown key `fromats` in `[render]`",
            "3:1",
            "`formats`",
        ),
        ("[render]\nformats = ['svg', 'pgn']\n", "unknown format `pgn`", "2:19", "`png`"),
        ("[render]\nthemes = ['drak']\n", "unknown theme `drak`", "2:11", "`dark`"),
        ("[render]\nthemes = ['no.toml']\n", "the theme `no.toml`: ", "2:11", ""),
        ("[render]\nscale = 0\n", "`scale`: expected a number above 0 and up to 8, got 0", "2:9", ""),
        ("[render]\nscale = 9\n", "`scale`: expected a number in [0, 8], got 9", "2:9", ""),
        ("[canvas]\nwidth = 3\n", "`width`: expected a number in ", "2:9", ""),
        ("[canvas]\ntheme = 'drak'\n", "unknown theme `drak`", "2:9", "`dark`"),
        ("[render\n", "not TOML: ", "1:8", ""),
    ];
    for (text, said, place, help) in cases {
        let folder = tree(&[("tracefig.toml", text), ("s.toml", &drawn())]);
        for command in ["render", "check"] {
            let got = ran(folder.path(), &[command, "s.toml"]);
            assert_eq!((got.code, got.out.as_str()), (Some(1), ""), "{text}: {}", got.err);
            for part in [said, &format!("tracefig.toml:{place}\n"), help] {
                assert!(got.err.contains(part), "{part}: {}", got.err);
            }
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "nothing was written");
    }
}

#[test]
fn themes_of_a_project_may_be_files_and_lie_beside_it() {
    let project = "[render]\nthemes = ['light', 'brand/night.toml']\nformats = ['svg']\n";
    let folder = tree(&[
        ("tracefig.toml", project),
        ("brand/night.toml", "based_on = \"dark\"\n"),
        ("figures/s.toml", &drawn()),
    ]);
    let got = ran(&folder.path().join("brand"), &["render"]);
    assert_eq!((got.code, got.err.as_str()), (Some(0), ""));
    let here = folder.path();
    assert!(here.join("figures/s.light.svg").exists() && here.join("figures/s.night.svg").exists());
    assert_eq!(ran(here, &["check"]).out, "2 identical, 0 changed, 0 missing\n");
    // A theme file for the page of scenes that name none lies beside the project, too.
    fs::write(here.join("tracefig.toml"), "canvas.theme = 'brand/night.toml'").unwrap();
    let night = fs::read_to_string(here.join("figures/s.night.svg")).unwrap();
    let own = ran(here, &["render", "figures/s.toml", "-o", "-"]).out;
    let background = |svg: &str| svg.split("f-background\" fill=\"").nth(1).unwrap()[..4].to_owned();
    assert_eq!(background(&own), background(&night));
    fs::write(here.join("tracefig.toml"), project).unwrap();
    // With other themes those of the project are no orphans.
    assert_eq!(ran(here, &["render", "--theme", "print"]).out, "figures/s.svg\n");
    assert_eq!(ran(here, &["check", "--theme", "print"]).out, "1 identical, 0 changed, 0 missing\n");
    let taken = ran(here, &["check", "--junit", "tracefig.toml"]);
    assert!(taken.code == Some(2) && taken.err.contains("is the project file of this run"), "{}", taken.err);
}

#[test]
fn one_file_may_be_named_and_its_end_says_the_format() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::write(here.join("t.toml"), drawn()).unwrap();
    let got = ran(here, &["render", "s.toml", "-o", "out/picture.svg"]);
    assert_eq!((got.code, got.out.as_str()), (Some(0), "out/picture.svg\n"));
    let piped = run_on(tracefig(here).args(["render", "-", "-o", "p.png", "--scale", "0.5"]), drawn());
    assert_eq!((piped.code, piped.out.as_str()), (Some(0), "p.png\n"));
    assert_eq!(ran(here, &["render", "s.toml", "-o", "p.pdf", "--format", "pdf"]).out, "p.pdf\n");
    for wrong in [
        &["s.toml", "-o", "x.svg", "--format", "png"][..],
        &["s.toml", "-o", "x.svg", "--format", "svg,png"],
        &["s.toml", "t.toml", "-o", "x.svg"],
        &[".", "-o", "x.svg"],
        &["s.toml", "-o", "x.svg", "--theme", "light,dark"],
        &["--jsonl", "-o", "x.svg"],
    ] {
        let got = ran(here, &[&["render"], wrong].concat());
        assert_eq!((got.code, got.out.as_str()), (Some(2), ""), "{wrong:?}: {}", got.err);
    }
    assert!(!here.join("x.svg").exists());
    // A folder of such a name stays one.
    fs::create_dir(here.join("y.svg")).unwrap();
    assert_eq!(ran(here, &["render", "s.toml", "-o", "y.svg", "--format", "svg"]).out, "y.svg/s.svg\n");
}

#[test]
fn a_project_file_that_is_too_long_is_not_read_in_part() {
    let long = format!("[render]\noutput = 'img'\n{}nothing = 1\n", "#\n".repeat(2 << 20));
    let folder = tree(&[("tracefig.toml", &long), ("figures/x.toml", &drawn())]);
    let got = ran(folder.path(), &["render"]);
    assert_eq!(got.code, Some(74), "{}", got.err);
    assert!(got.err.contains("expected at most 4194304 bytes"), "{}", got.err);
}

#[test]
fn scenes_of_a_project_that_is_wrong_are_not_listed_as_none() {
    let folder = tree(&[("tracefig.toml", "[rendr]\n"), ("figures/x.toml", &drawn())]);
    let got = ran(folder.path(), &["list", "figures"]);
    assert_eq!((got.code, got.out.as_str()), (Some(1), ""), "{}", got.err);
    assert!(got.err.contains("rendr"), "{}", got.err);
}
