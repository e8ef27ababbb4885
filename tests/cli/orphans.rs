//! What `check` calls an orphan, and may delete: never in doubt whether a figure has a scene.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use serde_json::json;

use crate::render::{drawn, names};
use crate::{Ran, run, run_on, tracefig};

/// A project of two scenes in a folder, one in a folder of it, drawn.
fn project(formats: &str, themes: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::create_dir_all(here.join("docs/scenes/de")).unwrap();
    says(here, &format!("scenes = ['docs/scenes']\nformats = [{formats}]\n{themes}"));
    for name in ["a", "b", "de/c"] {
        fs::write(here.join(format!("docs/scenes/{name}.toml")), drawn()).unwrap();
    }
    assert_eq!(run(tracefig(here).arg("render")).code, Some(0));
    folder
}

/// Writes what the project file says.
fn says(here: &Path, text: &str) {
    let project = format!("[render]\noutput = 'docs/img'\nscale = 0.25\n{text}\n");
    fs::write(here.join("tracefig.toml"), project).unwrap();
}

fn check(here: &Path, more: &[&str]) -> Ran {
    run(tracefig(here).arg("check").args(more))
}

/// The pictures that are there.
fn pictures(here: &Path) -> BTreeSet<String> {
    let mut all = names(&here.join("docs/img"));
    all.extend(names(&here.join("docs/img/de")).into_iter().map(|name| format!("de/{name}")));
    all.remove("de");
    all
}

/// The orphans that a check calls so, by name.
fn orphans(ran: &Ran) -> Vec<&str> {
    ran.out.lines().filter_map(|line| line.strip_prefix("orphan    docs/img/")).collect()
}

#[test]
fn nothing_is_an_orphan_where_a_scene_or_a_folder_can_not_be_read() {
    let folder = project("'svg'", "");
    let (here, all) = (folder.path(), pictures(folder.path()));
    // A folder that is not there, alone and beside one that is.
    for scenes in ["['docs/scene']", "['docs/scenes/de', 'docs/scene']"] {
        says(here, &format!("scenes = {scenes}\nformats = ['svg']"));
        for options in [&[][..], &["--prune"], &["--prune", "--accept"]] {
            let ran = check(here, options);
            assert_eq!((ran.code, orphans(&ran)), (Some(74), vec![]), "{}{}", ran.out, ran.err);
            assert!(
                ran.err.contains("can't read the scene: ") && ran.err.contains("docs/scene\n"),
                "{}",
                ran.err
            );
            assert!(ran.err.contains(" without a scene stay: not every scene or folder could be read\n"));
            assert!(pictures(here).is_superset(&all), "{options:?}");
        }
    }
}

#[cfg(unix)]
#[test]
fn a_folder_without_permission_is_an_error_and_its_figures_stay() {
    use std::os::unix::fs::PermissionsExt;
    let folder = project("'svg'", "");
    let here = folder.path();
    let allow = |mode| {
        let inner = here.join("docs/scenes/de");
        fs::set_permissions(inner, fs::Permissions::from_mode(mode)).unwrap();
    };
    allow(0);
    // Whoever may read everything finds nothing wrong.
    if here.join("docs/scenes/de").read_dir().is_err() {
        let ran = check(here, &["--prune"]);
        assert_eq!((ran.code, orphans(&ran)), (Some(74), vec![]), "{}{}", ran.out, ran.err);
        assert!(ran.err.contains("error: can't read the folder docs/scenes/de: "), "{}", ran.err);
        for command in ["render", "solve"] {
            let ran = run(tracefig(here).args([command, "--quiet"]));
            assert_eq!(ran.code, Some(74), "{command}: {}", ran.err);
            assert!(ran.err.contains("error: can't read the folder docs/scenes/de: "), "{}", ran.err);
        }
    }
    allow(0o755);
    assert_eq!(pictures(here).len(), 3);
}

/// A way in which a scene is there and is not taken for one, and what is said.
type Doubt = (&'static str, fn(&Path), &'static str, &'static str);

const DOUBTS: &[Doubt] = &[
    ("emptied", |here| fs::write(here.join("a.toml"), "").unwrap(), "a.toml", "error[empty-file]"),
    (
        "of comments",
        |here| fs::write(here.join("a.toml"), "# to be done\n").unwrap(),
        "a.toml",
        "error[empty-file]",
    ),
    (
        "UTF-16",
        |here| {
            let bytes = drawn().encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>();
            fs::write(here.join("a.toml"), [&[0xff, 0xfe][..], &bytes].concat()).unwrap();
        },
        "a.toml",
        "= help: save it as UTF-8, not as UTF-16",
    ),
    (
        "both tables mistyped",
        |here| {
            let text = drawn().replace("[shapes", "[shpes").replace("[query]", "[qeury]");
            fs::write(here.join("a.toml"), text).unwrap();
        },
        "a.toml",
        "did you mean `shapes`",
    ),
    (
        "in capitals",
        |here| fs::rename(here.join("a.toml"), here.join("a.TOML")).unwrap(),
        "a.TOML",
        "names of scenes end in .toml or .json, in small letters",
    ),
    #[cfg(unix)]
    (
        "behind a link",
        |here| {
            fs::rename(here.join("de"), here.join("../elsewhere")).unwrap();
            std::os::unix::fs::symlink("../elsewhere", here.join("de")).unwrap();
        },
        "de/c.toml",
        "links to folders are not followed",
    ),
];

#[test]
fn a_figure_stays_where_a_file_of_its_name_lies_in_the_place_of_its_scene() {
    for (name, done, scene, told) in DOUBTS {
        let folder = project("'svg', 'png'", "");
        let (here, all) = (folder.path(), pictures(folder.path()));
        done(&here.join("docs/scenes"));
        for options in [&[][..], &["--prune", "--junit", "junit.xml"]] {
            let ran = check(here, options);
            assert_eq!((ran.code, orphans(&ran)), (Some(1), vec![]), "{name}: {}{}", ran.out, ran.err);
            let note = format!(" and 1 more stay, as their scene may be docs/scenes/{scene}\n");
            assert!(ran.err.contains(told) && ran.err.contains(&note), "{name}: {}", ran.err);
            assert_eq!(pictures(here), all, "{name}");
        }
        let junit = fs::read_to_string(here.join("junit.xml")).unwrap();
        assert!(
            junit.contains(&format!("name=\"docs/scenes/{scene}\"><failure message=\"error\">")),
            "{junit}"
        );
        // One that is gone is one, still.
        fs::remove_file(here.join("docs/scenes/b.toml")).unwrap();
        assert_eq!(orphans(&check(here, &["--prune"])), ["b.png", "b.svg"], "{name}");
        assert_eq!(pictures(here).len(), all.len() - 2, "{name}");
    }
}

#[test]
fn a_figure_of_a_line_is_no_orphan_as_it_never_had_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let circle = |x| json!({"kind": "circle", "radius": 1, "position": [x, 0]});
    let query = json!({"kind": "separation", "of": ["A", "B"]});
    let scene = json!({"id": 7, "shapes": {"A": circle(0), "B": circle(3)}, "query": query}).to_string();
    fs::write(here.join("a.json"), &scene).unwrap();
    for options in [&["svg,png"][..], &["png", "--steps"]] {
        let drawn = run_on(tracefig(here).args(["render", "--jsonl", "--format"]).args(options), &scene);
        assert_eq!(drawn.code, Some(0), "{}", drawn.err);
    }
    assert_eq!(run(tracefig(here).args(["render", ".", "--format", "svg"])).code, Some(0));
    let all = names(here);
    assert!(all.len() > 4, "{all:?}");
    let checked = check(here, &[".", "--prune", "--format", "svg"]);
    let found = (checked.code, checked.out.contains("orphan"), names(here));
    assert_eq!(found, (Some(0), false, all), "{}{}", checked.out, checked.err);
}

#[test]
fn what_a_project_file_asks_for_no_more_is_an_orphan() {
    let folder = project("'svg', 'png'", "themes = ['light', 'dark']");
    let here = folder.path();
    let says = |text: &str| says(here, &format!("scenes = ['docs/scenes']\n{text}"));
    assert_eq!(check(here, &[]).code, Some(0));
    says("formats = ['svg', 'png']\nthemes = ['light', 'print']");
    let render = run(tracefig(here).arg("render"));
    assert_eq!((render.code, pictures(here).len()), (Some(0), 18));
    let ran = check(here, &[]);
    assert_eq!((ran.code, orphans(&ran).len()), (Some(1), 6), "{}", ran.out);
    let said = "orphan    docs/img/a.dark.png\n          tracefig.toml names no theme `dark`: mend that, or \
                delete it by `--prune`\n";
    assert!(ran.out.contains(said), "{}", ran.out);
    assert!(
        ran.out.ends_with("`tracefig check --prune` deletes orphans; give the same scenes and options\n")
    );
    // A command line that asks for other themes or formats says nothing of those of the project.
    assert_eq!(orphans(&check(here, &["--theme", "light"])), [""; 0]);
    let ran = check(here, &["--prune"]);
    assert_eq!((ran.code, pictures(here).len()), (Some(0), 12), "{}", ran.out);
    assert!(ran.out.contains("tracefig.toml names no theme `dark`: it was deleted\n"), "{}", ran.out);

    says("formats = ['svg']\nthemes = ['light', 'print']");
    assert_eq!(orphans(&check(here, &["--format", "svg"])), [""; 0]);
    let ran = check(here, &["--prune"]);
    assert_eq!((ran.code, orphans(&ran).len()), (Some(0), 6), "{}", ran.out);
    assert!(ran.out.contains("tracefig.toml names no format `png`: it was deleted\n"), "{}", ran.out);

    // One theme is in no name, and of several each is.
    says("formats = ['svg']\nthemes = ['light']");
    assert_eq!(run(tracefig(here).arg("render")).code, Some(0));
    let ran = check(here, &[]);
    assert_eq!(orphans(&ran).len(), 6, "{}", ran.out);
    assert!(ran.out.contains("names one theme, and the names of its figures none"), "{}", ran.out);
    says("formats = ['svg']\nthemes = ['light', 'print']");
    let ran = check(here, &[]);
    assert_eq!(orphans(&ran), ["a.svg", "b.svg", "de/c.svg"], "{}", ran.out);
    assert!(ran.out.contains("names 2 themes, and the name of this figure none"), "{}", ran.out);
    // Whoever names neither is asked for nothing.
    says("");
    assert_eq!(orphans(&check(here, &[])), [""; 0]);
}

#[test]
fn figures_that_other_options_drew_are_no_orphans_of_a_project() {
    let folder = project("'svg'", "");
    let here = folder.path();
    fs::write(here.join("docs/scenes/a.toml"), format!("{}\n[exercise]\nask = 'separation'\n", drawn()))
        .unwrap();
    let render = |more: &[&str]| run(tracefig(here).args(["render", "docs/scenes/a.toml"]).args(more));
    for options in [
        &["--format", "svg"][..],
        &["--steps", "--format", "svg,png,html"],
        &["--motion", "--format", "gif"],
        &["--variant", "question,key", "--format", "svg,pdf"],
        &["--variant", "question", "--seed", "1..2", "--format", "png"],
    ] {
        let ran = render(options);
        assert_eq!(ran.code, Some(0), "{options:?} {}", ran.err);
    }
    assert!(pictures(here).len() > 10);
    let ran = check(here, &[]);
    assert_eq!((ran.code, orphans(&ran)), (Some(0), vec![]), "{}{}", ran.out, ran.err);
}

#[test]
fn a_document_of_several_scenes_is_no_orphan() {
    let folder = project("'svg'", "");
    let here = folder.path();
    for name in ["handout.pdf", "talk.pptx"] {
        let file = format!("docs/img/{name}");
        let ran = run(tracefig(here).args(["render", "-o", &file]));
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        assert_eq!(check(here, &["--handout", &file]).code, Some(0), "{name}");
    }
    let ran = check(here, &["--prune"]);
    assert_eq!((ran.code, orphans(&ran)), (Some(0), vec![]), "{}{}", ran.out, ran.err);
    assert!(here.join("docs/img/handout.pdf").exists() && here.join("docs/img/talk.pptx").exists());
}

#[cfg(unix)]
#[test]
fn what_a_figure_of_a_scene_leads_to_is_no_orphan() {
    let folder = project("'svg'", "");
    let here = folder.path();
    fs::rename(here.join("docs/img/a.svg"), here.join("docs/img/kept.svg")).unwrap();
    std::os::unix::fs::symlink("kept.svg", here.join("docs/img/a.svg")).unwrap();
    let ran = check(here, &["--prune"]);
    assert_eq!((ran.code, orphans(&ran)), (Some(0), vec![]), "{}{}", ran.out, ran.err);
    assert!(here.join("docs/img/kept.svg").exists());
}

#[test]
fn what_a_run_drew_into_a_folder_below_its_scenes_is_no_orphan_of_a_search_above() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::create_dir_all(here.join("docs/de")).unwrap();
    for name in ["a", "de/b"] {
        fs::write(here.join(format!("docs/{name}.toml")), drawn()).unwrap();
    }
    let ran = run(tracefig(here).args(["render", "docs", "-o", "docs/img", "--format", "svg"]));
    assert_eq!((ran.code, pictures(here).len()), (Some(0), 2), "{}", ran.err);
    let ran = check(here, &["docs", "--prune", "--format", "svg"]);
    assert_eq!((orphans(&ran), pictures(here).len()), (vec![], 2), "{}", ran.out);
    // What no scene is called is one.
    fs::rename(here.join("docs/img/a.svg"), here.join("docs/img/c.svg")).unwrap();
    assert_eq!(orphans(&check(here, &["docs", "--format", "svg"])), ["c.svg"]);
}
