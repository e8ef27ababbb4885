//! `render`: files appear whole or not at all, named as promised, and one bad scene costs only itself.

use std::collections::BTreeSet;
use std::path::Path;

use crate::{CIRCLES, folder_with, run, run_on, tracefig};

/// [`CIRCLES`] with a panel.
pub(crate) fn drawn() -> String {
    format!("{CIRCLES}[[panels]]\nlayers = [\"shapes\"]\n")
}

pub(crate) fn names(folder: &Path) -> BTreeSet<String> {
    folder.read_dir().unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
}

pub(crate) fn set(names: &[&str]) -> BTreeSet<String> {
    names.iter().map(|&n| n.to_owned()).collect()
}

#[test]
fn a_scene_becomes_an_svg_and_a_png_beside_it() {
    let folder = folder_with("s.toml", &drawn());
    let ran = run(tracefig(folder.path()).args(["render", "s.toml"]));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_eq!(ran.out, "s.svg\ns.png\n");
    assert_eq!(names(folder.path()), set(&["s.png", "s.svg", "s.toml"]));
    let svg = std::fs::read_to_string(folder.path().join("s.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{svg}");
    let png = std::fs::read(folder.path().join("s.png")).unwrap();
    assert_eq!(
        (&png[..4], &png[16..20]),
        (&b"\x89PNG"[..], &[0, 0, 7, 128][..]),
        "twice as wide as the page"
    );
    let height: f64 =
        svg.split(" height=\"").nth(1).and_then(|s| s.split('"').next()).unwrap().parse().unwrap();
    let rows = u32::from_be_bytes(png[20..24].try_into().unwrap());
    assert_eq!(f64::from(rows), 2.0 * height, "the page ends where the drawing ends, in both");
}

#[test]
fn files_are_named_by_theme_when_several_are_asked_for() {
    let folder = folder_with("s.toml", &drawn());
    let render = |arguments: &[&str]| run(tracefig(folder.path()).arg("render").args(arguments));
    assert_eq!(render(&["s.toml", "--theme", "dark", "--format", "svg", "-o", "one"]).out, "one/s.svg\n");
    let two = ["s.toml", "--theme", "light,dark", "--format", "svg,svg", "-o", "a/b"];
    assert_eq!(render(&two).out, "a/b/s.light.svg\na/b/s.dark.svg\n");
    // The ids come from the file's name; all else is the theme's.
    let read = |path: &str| {
        let svg = std::fs::read_to_string(folder.path().join(path)).unwrap();
        let id = svg.split("aria-labelledby=\"").nth(1).unwrap().split('-').next().unwrap().to_owned();
        svg.replace(&id, "id")
    };
    assert!(read("one/s.svg") == read("a/b/s.dark.svg"));
    assert!(read("a/b/s.light.svg") != read("a/b/s.dark.svg"));
}

#[test]
fn two_scenes_of_one_name_are_an_error_before_anything_is_written() {
    let folder = folder_with("s.toml", &drawn());
    std::fs::create_dir(folder.path().join("sub")).unwrap();
    std::fs::write(folder.path().join("sub/s.toml"), drawn()).unwrap();
    let ran = run(tracefig(folder.path()).args(["render", "s.toml", "sub/s.toml", "-o", "out"]));
    assert_eq!(ran.code, Some(1));
    assert_eq!(ran.err, "error: s.toml and sub/s.toml would both become out/s.svg; nothing was written\n");
    assert_eq!(names(folder.path()), set(&["s.toml", "sub"]));
    assert_eq!(
        run(tracefig(folder.path()).args(["render", "s.toml", "sub/s.toml", "--format", "svg"])).code,
        Some(0)
    );
}

#[test]
fn without_scenes_all_of_figures_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let ran = run(tracefig(folder.path()).arg("render"));
    assert_eq!(ran.code, Some(1));
    assert!(
        ran.err.starts_with("error: no scene was given, and can't read the folder figures"),
        "{}",
        ran.err
    );
    std::fs::create_dir(folder.path().join("figures")).unwrap();
    for name in ["b.toml", "a.toml"] {
        std::fs::write(folder.path().join("figures").join(name), drawn()).unwrap();
    }
    let ran = run(tracefig(folder.path()).args(["render", "--format", "svg"]));
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "figures/a.svg\nfigures/b.svg\n"));
}

#[test]
fn a_dash_writes_the_one_file_to_standard_output() {
    let folder = folder_with("s.toml", &drawn());
    let svg = run(tracefig(folder.path()).args(["render", "s.toml", "-o", "-", "--format", "svg"]));
    assert!(svg.code == Some(0) && svg.out.starts_with("<svg"), "{}", svg.err);
    let piped = run_on(tracefig(folder.path()).args(["render", "-", "--format", "svg"]), drawn());
    assert!(piped.code == Some(0) && piped.out.starts_with("<svg"), "{}", piped.err);
    // Where nobody says, it is the first of the usual formats.
    let usual = run(tracefig(folder.path()).args(["render", "s.toml", "-o", "-"]));
    assert_eq!((usual.code, usual.out), (Some(0), svg.out));
    let usual = run_on(tracefig(folder.path()).args(["render", "-"]), drawn());
    assert_eq!((usual.code, usual.out), (Some(0), piped.out));
    let two = run(tracefig(folder.path()).args(["render", "s.toml", "-o", "-", "--format", "svg,png"]));
    assert_eq!((two.code, two.out.as_str()), (Some(2), ""));
    assert_eq!(names(folder.path()), set(&["s.toml"]));
}

#[test]
fn one_bad_scene_costs_only_itself() {
    let folder = folder_with("b.toml", &drawn().replace("radius = 1", "radius = -1"));
    for name in ["a.toml", "c.toml"] {
        std::fs::write(folder.path().join(name), drawn()).unwrap();
    }
    let scenes = ["render", "--format", "svg", "a.toml", "b.toml", "missing.toml", "c.toml"];
    let ran = run(tracefig(folder.path()).args(scenes));
    assert_eq!((ran.code, ran.out.as_str()), (Some(74), "a.svg\nc.svg\n"));
    assert!(
        ran.err.contains("error[negative-radius]") && ran.err.contains("error[unreadable-file]"),
        "{}",
        ran.err
    );
    assert_eq!(names(folder.path()), set(&["a.svg", "a.toml", "b.toml", "c.svg", "c.toml"]));
}

#[test]
fn what_the_figure_can_not_show_is_told_at_its_line() {
    let says = |from: &str, to: &str, expected: &str| {
        let folder = folder_with("s.toml", &drawn().replace(from, to));
        let ran = run(tracefig(folder.path()).args(["render", "s.toml"]));
        assert_eq!(ran.code, Some(1), "{}", ran.err);
        assert!(ran.err.starts_with(expected), "{}", ran.err);
        assert_eq!(names(folder.path()), set(&["s.toml"]));
    };
    says("[\"shapes\"]", "[\"shapse\"]", "error[unknown-word]: unknown layer `shapse`\n  --> s.toml:13:11\n");
    says(
        "[\"shapes\"]",
        "[{ layer = \"shapes\", colour = 1 }]",
        "error[unknown-key]: unknown key `colour` in the layer `shapes`\n  --> s.toml:13:31\n",
    );
    says("title = \"Two circles\"", "caption = 'Two $\\frac{1'", "error[");
    says(
        "[\"shapes\"]",
        "[\"shapes\"]\n[canvas]\ntheme = \"drak\"",
        "error[unknown-word]: unknown theme `drak`\n  --> s.toml:15:9\n",
    );
    says("[\"shapes\"]", "[\"shapes\"]\n[labels]\nnobody = \"x\"", "error[");
    says(
        "[\"shapes\"]",
        "[\"shapes\"]\nview = [0, 0, 1e-9, 1e-9]",
        "error[off-page]: `body-A` has a place that is not on any page\n  --> s.toml:12:1\n",
    );
}

#[test]
fn a_folder_that_can_not_be_written_is_told() {
    let folder = folder_with("s.toml", &drawn());
    std::fs::write(folder.path().join("file"), "").unwrap();
    std::fs::create_dir_all(folder.path().join("out/s.svg")).unwrap();
    let ran = run(tracefig(folder.path()).args(["render", "s.toml", "-o", "file/out"]));
    assert_eq!(ran.code, Some(74));
    assert!(ran.err.starts_with("error: can't make the folder file/out: "), "{}", ran.err);
    let ran = run(tracefig(folder.path()).args(["render", "s.toml", "-o", "out"]));
    assert_eq!((ran.code, ran.out.as_str()), (Some(74), "out/s.png\n"));
    assert!(ran.err.starts_with("error: can't write out/s.svg: "), "{}", ran.err);
    assert_eq!(names(&folder.path().join("out")), set(&["s.png", "s.svg"]));
}

#[test]
fn wrong_options_are_usage() {
    let folder = folder_with("s.toml", &drawn());
    for arguments in [&["--format", "doc"][..], &["--theme", "pink"], &["--scale", "0"], &["--scale", "nan"]]
    {
        let ran = run(tracefig(folder.path()).args(["render", "s.toml"]).args(arguments));
        assert_eq!(ran.code, Some(2), "{arguments:?}: {}", ran.err);
    }
    assert_eq!(names(folder.path()), set(&["s.toml"]));
}

#[test]
fn unchanged_scenes_can_be_left_alone() {
    let folder = folder_with("a.toml", &drawn());
    std::fs::write(folder.path().join("b.toml"), drawn()).unwrap();
    let render = |more: &[&str]| {
        run(tracefig(folder.path()).args(["render", ".", "--skip-unchanged", "--scale", "0.5"]).args(more))
            .out
    };
    assert_eq!(render(&[]), "./a.svg\n./a.png\n./b.svg\n./b.png\n");
    assert_eq!(render(&[]), "");
    std::fs::write(folder.path().join("b.toml"), drawn().replace("radius = 1", "radius = 1.5")).unwrap();
    assert_eq!(render(&[]), "./b.svg\n./b.png\n");
    std::fs::remove_file(folder.path().join("a.png")).unwrap();
    assert_eq!(render(&[]), "./a.svg\n./a.png\n");
    assert_eq!(render(&["--theme", "dark", "--format", "svg"]), "./a.svg\n./b.svg\n");
    assert_eq!(render(&["--png", "small", "--format", "png"]), "./a.png\n./b.png\n");
    let others = ["--format", "pdf,html,apng"];
    assert_eq!(render(&others), "./a.pdf\n./a.html\n./a.apng\n./b.pdf\n./b.html\n./b.apng\n");
    assert_eq!(render(&others), "");
    let all = ["check", ".", "--format", "svg,png,pdf,html,apng"];
    std::fs::remove_file(folder.path().join("b.toml")).unwrap();
    let out = run(tracefig(folder.path()).args(all)).out;
    assert_eq!(out.matches("orphan ").count(), 5, "{out}");
}

#[test]
fn partitions_share_the_scenes() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a", "b", "c", "d", "e"] {
        std::fs::write(folder.path().join(format!("{name}.toml")), drawn()).unwrap();
    }
    let render = |share: &str| {
        run(tracefig(folder.path()).args(["render", ".", "--format", "svg", "--partition", share]))
    };
    assert_eq!(render("1/3").out, "./a.svg\n./d.svg\n");
    assert_eq!(render("2/3").out, "./b.svg\n./e.svg\n");
    assert_eq!(render("3/3").out, "./c.svg\n");
    assert_eq!(render("4/3").code, Some(2));
}

#[test]
fn timings_name_the_stages() {
    let folder = folder_with("s.toml", &drawn());
    let ran = run(tracefig(folder.path()).args(["render", "s.toml", "--format", "svg", "--timings"]));
    let stages: Vec<_> = ran.err.lines().filter_map(|l| l.split_whitespace().next()).collect();
    assert_eq!(stages, ["read", "plan", "draw", "svg", "write", "all"], "{}", ran.err);
}

#[test]
fn auto_in_the_dark_is_the_dark_theme() {
    let folder = folder_with("s.toml", &drawn());
    let rules = |theme: &str, media: &str| {
        let render = ["render", "s.toml", "--format", "svg", "--theme", theme];
        assert_eq!(run(tracefig(folder.path()).args(render)).code, Some(0));
        let svg = std::fs::read_to_string(folder.path().join("s.svg")).unwrap();
        let rest = svg.split_once(media).unwrap().1.to_owned();
        rest.split_once("}}").unwrap().0.to_owned()
    };
    let dark = rules("dark", "@media all{");
    assert!(dark.contains("fill-opacity:var(--tracefig-fill-opacity,.24)"), "{dark}");
    assert_eq!(rules("auto", "@media (prefers-color-scheme:dark){"), dark);
    assert_eq!(rules("auto", "@media all{"), rules("light", "@media all{"));
}

#[test]
fn a_layer_that_the_answer_lacks_is_a_note_and_under_strict_an_error() {
    let scene = "[shapes.A]\nkind = \"circle\"\nradius = 1\nvelocity = [-1, 0]\n[shapes.B]\nkind = \"circle\"\n\
                 radius = 1\nposition = [3, 0]\n[query]\nkind = \"linear-sweep\"\nof = [\"A\", \"B\"]\n\
                 [[panels]]\nlayers = [\"shapes\", \"contact\"]\n";
    let folder = folder_with("miss.toml", scene);
    let render = |more: &[&str]| {
        run(tracefig(folder.path()).args(["render", "miss.toml", "--format", "svg"]).args(more))
    };
    let ran = render(&[]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "miss.svg\n"));
    let told = "note[not-in-answer]: `contact` draws nothing: the answer is a miss\n  --> miss.toml:13:21";
    assert!(ran.err.starts_with(told), "{}", ran.err);
    let strict = render(&["--strict"]);
    assert_eq!((strict.code, strict.out.as_str()), (Some(1), ""));
    assert!(strict.err.starts_with("error[not-in-answer]: `contact` draws nothing"), "{}", strict.err);
}

#[test]
fn several_scenes_become_the_sheets_of_one_document() {
    let folder = folder_with("a.toml", &drawn());
    let here = folder.path();
    for name in ["b.toml", "c.toml"] {
        std::fs::write(here.join(name), drawn()).unwrap();
    }
    let render = |arguments: &[&str]| run(tracefig(here).arg("render").args(arguments));
    let ran = render(&["a.toml", "b.toml", "c.toml", "-o", "h.pdf", "--paper", "letter"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "h.pdf\n"), "{}", ran.err);
    let holds = |what: &[u8]| {
        std::fs::read(here.join("h.pdf")).unwrap().windows(what.len()).filter(|part| *part == what).count()
    };
    assert_eq!((holds(b"/Count 2"), holds(b"/MediaBox[0 0 612 792]")), (1, 2));
    // Where the tool is at hand: every figure's words are found, and the numbers of the sheets.
    if let Ok(read) = std::process::Command::new("pdftotext").args(["h.pdf", "-"]).current_dir(here).output()
    {
        let text = String::from_utf8(read.stdout).unwrap();
        let lines = |what: &str| text.lines().filter(|line| line.trim().replace(' ', "") == what).count();
        assert_eq!(["A", "B", "1/2", "2/2"].map(lines), [3, 3, 1, 1], "{text}");
        assert_eq!(["Figure1", "Figure2", "Figure3"].map(lines), [1; 3], "{text}");
    }
    let size = || std::fs::metadata(here.join("h.pdf")).unwrap().len();
    let numbered = size();
    assert_eq!(render(&["a.toml", "b.toml", "c.toml", "-o", "h.pdf", "--no-numbers"]).code, Some(0));
    assert!(size() < numbered, "{} {numbered}", size());
    let one = render(&["a.toml", "-o", "one.pdf", "--per-page", "4"]);
    assert_eq!(one.code, Some(0), "{}", one.err);
    assert!(one.err.contains("warning: letters of"), "{}", one.err);

    let kept = std::fs::read(here.join("h.pdf")).unwrap();
    std::fs::write(here.join("b.toml"), "shapes = 1").unwrap();
    let ran = render(&["a.toml", "b.toml", "-o", "h.pdf"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert!(ran.err.contains("h.pdf is not written without all its figures"), "{}", ran.err);
    assert_eq!(std::fs::read(here.join("h.pdf")).unwrap(), kept);
    for wrong in [&["a.toml", "c.toml", "-o", "x.svg"][..], &["a.toml", "--per-page", "2"]] {
        assert_eq!(render(wrong).code, Some(2), "{wrong:?}");
    }
}

#[test]
fn a_name_that_ends_as_pictures_do_is_no_folder() {
    let folder = folder_with("s.toml", &drawn());
    let render = |to: &str| run(tracefig(folder.path()).args(["render", "s.toml", "-o", to]));
    for to in ["x.bmp", "x.JPG", "sub/x.webp"] {
        let ran = render(to);
        assert_eq!(ran.code, Some(2), "{to}: {}", ran.out);
        assert!(
            ran.err.contains("no figure is written as .") && ran.err.contains(".svg, .png"),
            "{}",
            ran.err
        );
    }
    assert_eq!(names(folder.path()), set(&["s.toml"]));
    assert_eq!(render("X.PNG").out, "X.PNG\n");
    assert!(folder.path().join("X.PNG").is_file());
    // A folder that is there may be called anything.
    std::fs::create_dir(folder.path().join("old.bmp")).unwrap();
    assert_eq!(render("old.bmp").out, "old.bmp/s.svg\nold.bmp/s.png\n");
}
