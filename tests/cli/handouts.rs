//! `[[handout]]` of a project file: documents that a run of the whole project writes and compares; and
//! `--project`.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use crate::render::drawn;
use crate::{Ran, run, run_on, tracefig};

/// Two figures, an exercise apart from them, and a project file with a table of a handout.
fn project(handout: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in [
        ("docs/scenes/a.toml", drawn()),
        ("docs/scenes/b.toml", drawn()),
        ("class/c.toml", format!("{}\n[exercise]\nask = 'separation'\n", drawn())),
        ("tracefig.toml", with(handout)),
    ] {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

/// The project file with a table of a handout.
fn with(handout: &str) -> String {
    let render = "[render]\nscenes = ['docs/scenes']\noutput = 'img'\nformats = ['svg']\nsteps = 'one'\n";
    format!("{render}themes = ['light', 'dark']\n[[handout]]\n{handout}\n")
}

fn ran(folder: &Path, arguments: &[&str]) -> Ran {
    run(tracefig(folder).args(arguments))
}

/// How many sheets a PDF has.
fn sheets(pdf: &Path) -> usize {
    let bytes = fs::read(pdf).unwrap();
    bytes.windows(9).filter(|part| part == b"/MediaBox").count()
}

#[test]
fn a_handout_of_a_project_is_written_and_compared_with_its_figures() {
    let keys = "per_page = 1\npaper = 'letter'\nnumbers = false\nheading = 'Sheet 3'\nname_line = true";
    let folder = project(&format!("file = 'out/all.pdf'\n{keys}"));
    let here = folder.path();
    let rendered = ran(here, &["render"]);
    assert_eq!(rendered.code, Some(0), "{}", rendered.err);
    assert!(rendered.out.ends_with("out/all.pdf\n") && rendered.out.lines().count() == 5, "{}", rendered.out);
    // A sheet a scene: its first theme alone, finished, whatever the figures are drawn as.
    assert_eq!(sheets(&here.join("out/all.pdf")), 2);
    let sheets_as =
        ["--per-page", "1", "--paper", "letter", "--no-numbers", "--heading", "Sheet 3", "--name-line"];
    let options = [&["-o", "same.pdf"], &sheets_as[..]].concat();
    let own = ran(here, &[&["render", "docs/scenes", "--theme", "light"], &options[..]].concat());
    assert_eq!(own.code, Some(0), "the project asks for steps, which sheets do not have: {}", own.err);
    assert_eq!(fs::read(here.join("same.pdf")).unwrap(), fs::read(here.join("out/all.pdf")).unwrap());
    let options = [&["--handout", "same.pdf"], &sheets_as[..]].concat();
    let own = ran(here, &[&["check", "docs/scenes", "--theme", "light"], &options[..]].concat());
    assert_eq!((own.code, own.out.as_str()), (Some(0), "1 identical, 0 changed, 0 missing\n"), "{}", own.err);
    let usual = ran(here, &["render", "docs/scenes", "--theme", "light", "-o", "usual.pdf"]);
    assert_eq!((usual.code, sheets(&here.join("usual.pdf"))), (Some(0), 1), "{}", usual.err);
    let alone = ["render", "docs/scenes/a.toml", "--theme", "light", "-o", "alone.pdf"];
    let alone = ran(here, &[&alone[..], &["--per-page", "1"]].concat());
    assert_eq!((alone.code, sheets(&here.join("alone.pdf"))), (Some(0), 1), "{}", alone.err);
    let checked = ran(here, &["check"]);
    assert_eq!((checked.code, checked.out.as_str()), (Some(0), "5 identical, 0 changed, 0 missing\n"));
    // What moved in a figure moved on its sheet.
    let moved = drawn().replacen("position = [", "position = [0.5", 1);
    assert_ne!(moved, drawn());
    fs::write(here.join("docs/scenes/b.toml"), moved).unwrap();
    let checked = ran(here, &["check"]);
    assert_eq!(checked.code, Some(1));
    assert!(checked.out.contains("stale     out/all.pdf\n"), "{}", checked.out);
    assert_eq!(ran(here, &["check", "--accept"]).code, Some(0));
    assert_eq!(ran(here, &["check"]).code, Some(0));
    fs::remove_dir_all(here.join("out")).unwrap();
    let missing = ran(here, &["check"]);
    assert!(missing.code == Some(1) && missing.out.contains("missing   out/all.pdf\n"), "{}", missing.out);
}

#[test]
fn a_handout_is_left_alone_where_something_else_is_asked_for() {
    let folder = project("file = 'all.pdf'");
    let here = folder.path();
    for arguments in [
        &["render", "docs/scenes"][..],
        &["render", "--format", "png"],
        &["render", "--theme", "print"],
        &["render", "-o", "elsewhere"],
        &["render", "--motion"],
        &["render", "--partition", "1/2"],
    ] {
        assert_eq!(ran(here, arguments).code, Some(0), "{arguments:?}");
        assert!(!here.join("all.pdf").exists(), "{arguments:?}");
    }
    assert_eq!(ran(here, &["render"]).code, Some(0));
    assert!(here.join("all.pdf").exists());
}

#[test]
fn a_handout_has_scenes_variants_and_a_theme_of_its_own() {
    let of_class = "file = 'sheet.pdf'\nscenes = ['class']\nvariants = 'question'\nseeds = '1..3'\n";
    let folder = project(&format!("{of_class}per_page = 1\ntheme = 'print'"));
    let here = folder.path();
    let rendered = ran(here, &["render"]);
    assert_eq!(rendered.code, Some(0), "{}", rendered.err);
    assert_eq!(sheets(&here.join("sheet.pdf")), 3);
    let options = ["--variant", "question", "--seed", "1..3", "--per-page", "1", "--theme", "print"];
    let elsewhere = tempfile::tempdir().unwrap();
    fs::copy(here.join("class/c.toml"), elsewhere.path().join("c.toml")).unwrap();
    let own = ran(elsewhere.path(), &[&["render", "c.toml", "-o", "own.pdf"], &options[..]].concat());
    assert_eq!(own.code, Some(0), "{}", own.err);
    let [ours, own] =
        [here.join("sheet.pdf"), elsewhere.path().join("own.pdf")].map(|path| fs::read(path).unwrap());
    assert!(ours == own, "the same bytes as by options");
    // A presentation, even of one scene, is a document too.
    fs::write(here.join("tracefig.toml"), with("file = 'talk.pptx'\nscenes = ['class/c.toml']")).unwrap();
    assert_eq!(ran(here, &["render"]).code, Some(0));
    assert!(here.join("talk.pptx").exists());
    assert_eq!(ran(here, &["check"]).code, Some(0));
}

#[test]
fn what_is_wrong_with_a_handout_is_told_with_its_place() {
    let folder = project("");
    let here = folder.path();
    for (handout, said, place, help) in [
        ("per_page = 2", "a handout lacks `file`", "7:1", ""),
        ("file = 'all.svg'", "`file`: expected a name that ends in .pdf or .pptx, got `all.svg`", "8:8", ""),
        ("file = 'all.pdf'\nper_page = 99", "`per_page`: expected a whole number in [1, 36]", "9:12", ""),
        ("file = 'all.pdf'\npaper = 'a5'", "unknown paper `a5`", "9:9", "a4"),
        ("file = 'all.pptx'\npaper = 'a4'", "`paper` is of sheets, and pptx has none", "9:9", ""),
        ("file = 'all.pdf'\nvariants = ['keys']", "unknown variant `keys`", "9:13", "did you mean `key`?"),
        ("file = 'all.pdf'\nseeds = '3..1'", "`seeds`: expected a number from 1 to 1000", "9:9", ""),
        ("file = 'all.pdf'\nper_pag = 3", "unknown key `per_pag` in a handout", "9:1", "`per_page`"),
        ("file = 'all.pdf'\ntheme = 'drak'", "unknown theme `drak`", "9:9", "`dark`"),
        ("file = 'a.pdf'\n[[handout]]\nfile = './a.pdf'", "./a.pdf is another file of this", "10:8", ""),
    ] {
        fs::write(here.join("tracefig.toml"), with(handout)).unwrap();
        for command in ["render", "check"] {
            let got = ran(here, &[command]);
            assert_eq!((got.code, got.out.as_str()), (Some(1), ""), "{handout}: {}", got.err);
            for part in [said, &format!("tracefig.toml:{place}\n"), help] {
                assert!(got.err.contains(part), "{handout}: {part}: {}", got.err);
            }
        }
    }
    assert!(!here.join("img").exists(), "nothing was written");
}

#[test]
fn what_a_scene_warns_of_is_told_once_though_a_document_holds_it_too() {
    let folder = project("file = 'all.pdf'");
    let here = folder.path();
    // Pinned far from the panel.
    let clash = format!("{}\n[labels]\nA = {{ at = [900, 0] }}\n", drawn());
    fs::write(here.join("docs/scenes/a.toml"), &clash).unwrap();
    for command in ["render", "check"] {
        let got = ran(here, &[command]);
        assert_eq!(got.err.matches("over the edge").count(), 1, "{command}: {}", got.err);
    }
    // What is refused is told once, too.
    fs::write(here.join("docs/scenes/a.toml"), clash.replace("circle", "circel")).unwrap();
    let got = ran(here, &["render"]);
    assert_eq!(got.err.matches("did you mean").count(), 2, "of two shapes: {}", got.err);
    assert!(got.err.contains("all.pdf is not written without all its figures"), "{}", got.err);
}

#[test]
fn a_report_does_not_take_the_place_of_a_handout() {
    let folder = project("file = 'all.pdf'");
    let got = ran(folder.path(), &["check", "--junit", "all.pdf"]);
    assert!(got.code == Some(2) && got.err.contains("a handout of this project"), "{}", got.err);
}

#[test]
fn a_project_that_is_named_is_that_of_all_scenes_and_lines() {
    let folder = project("file = 'all.pdf'");
    let here = folder.path();
    fs::create_dir(here.join("work")).unwrap();
    let work = here.join("work");
    fs::write(work.join("wide.toml"), "canvas.width = 700\n[render]\nformats = ['svg']\noutput = 'lines'\n")
        .unwrap();
    let line = r#"{"id": "x", "shapes": {"A": {"kind": "circle", "radius": 1}}, "query": {"kind": "bounds", "of": ["A"]}}"#;
    let stream = |more: &[&str]| run_on(tracefig(&work).args(["render", "--jsonl"]).args(more), line);
    // Lines have no folder: the nearest project of the working directory, or the one that is named.
    let nearest = stream(&[]);
    assert_eq!((nearest.code, nearest.err.as_str()), (Some(0), ""));
    let at = |name: &str| here.canonicalize().unwrap().join("img").join(name).display().to_string();
    assert_eq!(nearest.out, format!("{}\n{}\n", at("x.light.steps.svg"), at("x.dark.steps.svg")));
    let named = stream(&["--project", "wide.toml"]);
    assert_eq!((named.code, named.out.as_str()), (Some(0), "lines/x.svg\n"), "{}", named.err);
    assert!(fs::read_to_string(work.join("lines/x.svg")).unwrap().contains("width=\"700\""));
    let scenes = run(tracefig(&work).args(["render", "--project", "../tracefig.toml"]));
    assert_eq!(scenes.code, Some(0), "{}", scenes.err);
    assert!(here.join("img/a.light.steps.svg").exists() && here.join("all.pdf").exists());
    let missing = stream(&["--project", "none.toml"]);
    assert_eq!((missing.code, missing.out.as_str()), (Some(74), ""), "{}", missing.err);
    assert!(missing.err.contains("can't read the project file `none.toml`"), "{}", missing.err);
    let scene = stream(&["--project", "../docs/scenes/a.toml"]);
    assert_eq!((scene.code, scene.out.as_str()), (Some(1), ""), "{}", scene.err);
    assert!(scene.err.contains("`../docs/scenes/a.toml` is a scene, and no project file"), "{}", scene.err);
}
