//! No output takes the place of an input, or of what is no regular file; and what is read is a regular file.

use std::fs;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

use crate::render::{drawn, names, set};
use crate::{Ran, folder_with, run, tracefig};

fn ran(folder: &Path, arguments: &[&str]) -> Ran {
    run(tracefig(folder).args(arguments))
}

/// A pipe into which nobody writes.
fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

#[test]
fn a_scene_that_is_named_as_its_figure_stays() {
    for format in ["svg", "png", "html", "pdf", "apng"] {
        let name = format!("s.{format}");
        let folder = folder_with(&name, &drawn());
        for command in [&["render"][..], &["check"], &["check", "--accept"]] {
            let ran = ran(folder.path(), &[command, &[name.as_str(), "--format", format]].concat());
            // A check was not to write anything.
            let end = if command[0] == "render" { "; nothing was written" } else { "" };
            let told = format!(
                "error: {name} is a scene of this run, and a figure would take its place: the name of a scene \
                 ends in .toml or .json{end}\n"
            );
            assert_eq!((ran.code, ran.err), (Some(1), told), "{command:?}");
        }
        assert_eq!(names(folder.path()), set(&[name.as_str()]));
        assert_eq!(fs::read_to_string(folder.path().join(&name)).unwrap(), drawn());
    }
    let folder = folder_with("s.svg", &drawn());
    fs::create_dir(folder.path().join("sub")).unwrap();
    for name in ["s.toml", "sub/s.toml"] {
        fs::write(folder.path().join(name), drawn()).unwrap();
    }
    symlink("s.svg", folder.path().join("b.toml")).unwrap();
    for arguments in [&["s.toml", "sub/../s.svg"][..], &["sub/s.toml", "b.toml", "-o", "sub/.."]] {
        let ran = ran(folder.path(), &[&["render"], arguments].concat());
        assert_eq!(ran.code, Some(1), "{}", ran.out);
    }
    assert_eq!(fs::read_to_string(folder.path().join("s.svg")).unwrap(), drawn());
    assert_eq!(ran(folder.path(), &["render", "s.svg", "--format", "png"]).out, "s.png\n");
}

#[test]
fn the_folder_of_the_figures_takes_no_pictures_of_differences() {
    let folder = folder_with("s.toml", &drawn());
    assert_eq!(ran(folder.path(), &["render", "s.toml"]).code, Some(0));
    fs::write(folder.path().join("s.toml"), drawn().replace("radius = 1", "radius = 1.5")).unwrap();
    fs::write(folder.path().join("index.html"), "mine").unwrap();
    let before = fs::read(folder.path().join("s.png")).unwrap();
    let ran_here = ran(folder.path(), &["check", "s.toml", "-o", "."]);
    assert_eq!(ran_here.code, Some(2));
    assert!(ran_here.err.starts_with("error: the figures lie in .: give another folder"), "{}", ran_here.err);
    // Another folder's page of somebody else stays too.
    fs::create_dir(folder.path().join("site")).unwrap();
    fs::write(folder.path().join("site/index.html"), "<!doctype html>\n<html>").unwrap();
    for _ in 0..2 {
        let there = ran(folder.path(), &["check", "s.toml", "-o", "site", "--junit", "j.xml"]);
        assert_eq!(there.code, Some(74));
        assert!(
            there.err.contains("can't write site/index.html: there is a page that no check wrote"),
            "{}",
            there.err
        );
        assert!(folder.path().join("j.xml").exists() && folder.path().join("site/s.png").exists());
    }
    assert_eq!(fs::read(folder.path().join("s.png")).unwrap(), before);
    assert_eq!(fs::read(folder.path().join("index.html")).unwrap(), b"mine");
    let again = [
        ran(folder.path(), &["check", "s.toml", "-o", "d"]),
        ran(folder.path(), &["check", "s.toml", "-o", "d"]),
    ];
    assert!(again.iter().all(|ran| ran.err.is_empty()), "a page of ours is written again");
}

#[test]
fn a_report_takes_the_place_of_nothing_that_was_read() {
    let folder = folder_with("s.toml", &drawn());
    fs::write(folder.path().join("own.toml"), "based_on = \"dark\"\n").unwrap();
    let render = ["render", "s.toml", "--theme", "own.toml"];
    assert_eq!(ran(folder.path(), &render).code, Some(0));
    let before: Vec<_> =
        names(folder.path()).into_iter().map(|n| (fs::read(folder.path().join(&n)).unwrap(), n)).collect();
    for place in ["s.toml", "./s.svg", "s.png", "own.toml"] {
        for option in ["--junit", "--summary"] {
            let got = ran(folder.path(), &["check", "s.toml", "--theme", "own.toml", option, place]);
            assert_eq!(got.code, Some(2), "{option} {place}: {}", got.err);
            assert!(got.err.contains("of this run, and a report can't take its place"), "{}", got.err);
        }
    }
    for both in [
        &["--junit", "r", "--summary", "r"][..],
        &["--json", "--junit", "-"],
        &["--junit", "-", "--summary", "-"],
    ] {
        assert_eq!(ran(folder.path(), &[&["check", "s.toml"], both].concat()).code, Some(2), "{both:?}");
    }
    let after: Vec<_> =
        names(folder.path()).into_iter().map(|n| (fs::read(folder.path().join(&n)).unwrap(), n)).collect();
    assert!(before == after);
}

#[test]
fn a_report_goes_into_devices_and_pipes_and_to_standard_output() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    for place in ["-", "/dev/stdout"] {
        let junit = ran(here, &["check", "s.toml", "--format", "svg", "--junit", place]);
        assert!(
            junit.code == Some(1) && junit.out.starts_with("<?xml") && junit.out.ends_with("</testsuite>\n"),
            "{}",
            junit.out
        );
        let summary = ran(here, &["check", "s.toml", "--format", "svg", "--summary", place]);
        assert!(
            summary.out.starts_with("### Figures: 1 missing\n") && !summary.out.contains("1 missing\n0"),
            "{}",
            summary.out
        );
    }
    pipe(&here.join("pipe"));
    let script = "cat pipe > told & \"$0\" check s.toml --format svg --junit pipe --summary /dev/null; wait";
    let mut command = Command::new("sh");
    run(command.args(["-c", script]).arg(crate::TRACEFIG).current_dir(here));
    assert!(fs::read_to_string(here.join("told")).unwrap().ends_with("</testsuite>\n"));
    assert!(here.join("pipe").metadata().unwrap().file_type().is_fifo());
    assert!(Path::new("/dev/null").metadata().unwrap().file_type().is_char_device());
    symlink("told", here.join("link.xml")).unwrap();
    let linked = ran(here, &["check", "s.toml", "--junit", "link.xml"]);
    assert!(linked.err.contains("can't write link.xml: it is a link, not a regular file"), "{}", linked.err);
    assert!(!names(here).contains("-"));
}

#[test]
fn each_report_is_written_though_another_can_not_be() {
    let folder = folder_with("s.toml", &drawn());
    fs::write(folder.path().join("file"), "").unwrap();
    let places = ["--junit", "j.xml", "--summary", "s.md"];
    let got = ran(folder.path(), &[&["check", "s.toml", "-o", "file/x"], &places[..]].concat());
    assert_eq!(got.code, Some(74));
    assert!(got.err.contains("can't write file/x: "), "{}", got.err);
    assert!(folder.path().join("j.xml").exists() && folder.path().join("s.md").exists());
}

#[test]
fn figures_of_one_name_in_two_folders_have_a_picture_each() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for name in ["a", "b"] {
        fs::create_dir(here.join(name)).unwrap();
        fs::write(here.join(name).join("x.toml"), drawn()).unwrap();
    }
    let formats = ["--format", "svg,png", "--scale", "0.5"];
    assert_eq!(ran(here, &[&["render", "a", "b"], &formats[..]].concat()).code, Some(0));
    for (name, radius) in [("a", "1.25"), ("b", "1.5")] {
        fs::write(
            here.join(name).join("x.toml"),
            drawn().replace("radius = 1", &format!("radius = {radius}")),
        )
        .unwrap();
    }
    let got = ran(here, &[&["check", "a", "b", "-o", "out", "--json"], &formats[..]].concat());
    let json: serde_json::Value = serde_json::from_str(&got.out).unwrap();
    let pictures: Vec<_> =
        json["files"].as_array().unwrap().iter().map(|f| f["picture"].as_str().unwrap()).collect();
    assert_eq!(pictures, ["out/x.svg.png", "out/x.png", "out/x.svg-2.png", "out/x-2.png"]);
    let read = |name: &str| fs::read(here.join(name)).unwrap();
    assert!(read("out/x.png") != read("out/x-2.png") && read("out/x.svg.png") != read("out/x.svg-2.png"));
}

#[test]
fn what_is_no_regular_file_is_neither_replaced_nor_followed() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::write(here.join("theirs"), "theirs").unwrap();
    let places: [&dyn Fn(&Path); 3] =
        [&|path| symlink("theirs", path).unwrap(), &|path| symlink("/dev/zero", path).unwrap(), &|path| {
            pipe(path);
        }];
    for make in places {
        make(&here.join("s.svg"));
        let kind = here.join("s.svg").symlink_metadata().unwrap().file_type();
        for command in [
            &["render", "s.toml"][..],
            &["render", "s.toml", "--skip-unchanged"],
            &["check", "s.toml", "--accept"],
        ] {
            let got = ran(here, &[command, &["--format", "svg"]].concat());
            assert_eq!(got.code, Some(74), "{command:?}");
            assert!(got.err.contains("s.svg: it is a"), "{command:?}: {}", got.err);
        }
        // Orphans are looked for among all files of the folder.
        symlink("s.svg", here.join("other.svg")).unwrap();
        assert_eq!(ran(here, &["check", ".", "--format", "png", "--accept"]).code, Some(0));
        assert_eq!(here.join("s.svg").symlink_metadata().unwrap().file_type(), kind);
        for name in ["s.svg", "other.svg"] {
            fs::remove_file(here.join(name)).unwrap();
        }
    }
    assert_eq!(fs::read(here.join("theirs")).unwrap(), b"theirs");
    symlink(".", here.join("linked")).unwrap();
    let got = ran(here, &["check", "s.toml", "-o", "linked"]);
    assert_eq!(got.code, Some(2));
    assert!(got.err.contains("linked is a link: end it in `/`"), "{}", got.err);
}

#[test]
fn pipes_and_devices_keep_nobody_waiting() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    pipe(&here.join("a.toml"));
    pipe(&here.join("own.toml"));
    symlink("/dev/zero", here.join("zero.toml")).unwrap();
    symlink("nowhere", here.join("gone.toml")).unwrap();
    let got = ran(here, &["render", ".", "--format", "svg"]);
    assert_eq!((got.code, got.out.as_str()), (Some(74), "./s.svg\n"));
    assert!(got.err.contains("--> ./gone.toml") && got.err.matches("error[").count() == 1, "{}", got.err);
    for theme in ["own.toml", "zero.toml"] {
        let got = ran(here, &["render", "s.toml", "--theme", theme]);
        assert_eq!(got.code, Some(2));
        assert!(got.err.contains("not a regular file"), "{}", got.err);
    }
    // A scene that was named may be a pipe, as of `tracefig solve <(…)`.
    let script = "cat s.toml > a.toml & exec \"$0\" solve a.toml";
    let got = run(Command::new("sh").args(["-c", script]).arg(crate::TRACEFIG).current_dir(here));
    assert!(got.code == Some(0) && got.out.starts_with("a.toml: "), "{}{}", got.out, got.err);
}

#[test]
fn themes_of_one_name_are_refused_and_those_of_a_file_have_scenes() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::create_dir(here.join("x")).unwrap();
    for name in ["own.v2.toml", "x/own.v2.toml", "x/light.toml"] {
        fs::write(here.join(name), format!("based_on = \"dark\"\n# {name}\n")).unwrap();
    }
    for themes in ["own.v2.toml,x/own.v2.toml", "light,x/light.toml"] {
        let got = ran(here, &["render", "s.toml", "--theme", themes]);
        assert_eq!(got.code, Some(2), "{themes}");
        assert!(got.err.starts_with("error: two themes are called `"), "{}", got.err);
    }
    assert_eq!(names(here), set(&["own.v2.toml", "s.toml", "x"]));
    fs::create_dir(here.join("f")).unwrap();
    fs::rename(here.join("s.toml"), here.join("f/s.toml")).unwrap();
    let themes = ["--theme", "own.v2.toml,dark", "--format", "svg"];
    assert_eq!(ran(here, &[&["render", "f"], &themes[..]].concat()).out, "f/s.own.v2.svg\nf/s.dark.svg\n");
    assert_eq!(
        ran(here, &[&["check", "f"], &themes[..]].concat()).out,
        "2 identical, 0 changed, 0 missing\n"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_name_that_is_no_text_is_kept_and_one_that_acts_is_shown() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let name = |bytes: &'static [u8]| here.join(OsStr::from_bytes(bytes));
    fs::write(name(b"\xff.toml"), drawn()).unwrap();
    fs::write(name(b"n\n\x1b[31m.toml"), drawn()).unwrap();
    let rendered = ran(here, &["render", ".", "--format", "svg"]);
    assert_eq!(rendered.out, "./n␊␛[31m.svg\n./\u{fffd}.svg\n");
    assert!(name(b"\xff.svg").exists() && name(b"n\n\x1b[31m.svg").exists());
    assert_eq!(ran(here, &["check", ".", "--format", "svg"]).out, "2 identical, 0 changed, 0 missing\n");
    fs::remove_file(name(b"n\n\x1b[31m.toml")).unwrap();
    let got = ran(here, &["check", ".", "--format", "svg", "--summary", "s.md", "--junit", "j.xml"]);
    assert!(got.out.contains("orphan    ./n␊␛[31m.svg\n"), "{}", got.out);
    let summary = fs::read_to_string(here.join("s.md")).unwrap();
    assert!(summary.contains("| `./n␊␛[31m.svg` | orphan |"), "{summary}");
    assert!(fs::read_to_string(here.join("j.xml")).unwrap().contains("name=\"./n␊␛[31m.svg\""));
}

#[test]
fn an_output_keeps_who_may_read_it() {
    let folder = folder_with("s.toml", &drawn());
    assert_eq!(ran(folder.path(), &["render", "s.toml"]).code, Some(0));
    let place = folder.path().join("s.svg");
    fs::set_permissions(&place, fs::Permissions::from_mode(0o600)).unwrap();
    assert_eq!(ran(folder.path(), &["render", "s.toml"]).code, Some(0));
    assert_eq!(place.metadata().unwrap().permissions().mode() & 0o777, 0o600);
}

#[test]
fn control_characters_of_a_scene_are_shown() {
    let folder = folder_with(
        "s.toml",
        &drawn()
            .replace("\"Two circles\"", "\"a\\u001B[2Jb\\nc\"")
            .replace("shapes.A", "shapes.\"A\\u001B\\n\"")
            .replace("\"A\"", "\"A\\u001B\\n\"")
            .replace("[\"shapes\"]", "[]"),
    );
    for command in ["describe", "solve", "trace"] {
        let got = ran(folder.path(), &[command, "s.toml"]);
        assert_eq!(got.code, Some(0), "{}", got.err);
        assert!(!got.out.contains('\u{1b}') && got.out.contains("A␛␊"), "{command}: {}", got.out);
    }
    let got = ran(folder.path(), &["describe", "s.toml"]);
    assert!(got.out.starts_with("a␛[2Jb c: "), "{}", got.out);
}
