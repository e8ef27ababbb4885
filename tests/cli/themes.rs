//! Theme files: named on the command line and in scenes, and what of their colours is refused.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::fs;
use std::path::Path;

use crate::render::drawn;
use crate::{Ran, folder_with, run, run_on, tracefig};

/// Colours that people bring for two bodies: the pairs of matplotlib's default cycle, of Okabe and Ito, of
/// Tableau 10.
const PAIRS: [[&str; 2]; 7] = [
    ["#1f77b4", "#ff7f0e"],
    ["#1f77b4", "#d62728"],
    ["#0072B2", "#D55E00"],
    ["#E69F00", "#56B4E9"],
    ["#4E79A7", "#F28E2B"],
    ["#4E79A7", "#E15759"],
    ["#76B7B2", "#E15759"],
];

fn render(folder: &Path, arguments: &[&str]) -> Ran {
    run(tracefig(folder).arg("render").args(arguments))
}

fn svg(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap().to_lowercase()
}

/// The committed figures that use most roles.
fn figures() -> Vec<String> {
    ["01-penetration", "04-minkowski-difference", "05-linear-sweep", "06-advancement"]
        .map(|stem| format!("{}/figures/{stem}.toml", env!("CARGO_MANIFEST_DIR")))
        .into()
}

#[test]
fn the_palettes_that_people_bring_draw_every_figure() {
    let folder = tempfile::tempdir().unwrap();
    let scenes = figures();
    for page in ["#FFFFFF", "#12161C"] {
        for [a, b] in PAIRS {
            let theme = format!("[colors]\na = '{a}'\nb = '{b}'\nbackground = '{page}'\n");
            fs::write(folder.path().join("own.toml"), theme).unwrap();
            let mut arguments = vec!["--format", "svg", "-o", "out", "--theme", "own.toml"];
            arguments.extend(scenes.iter().map(String::as_str));
            let ran = render(folder.path(), &arguments);
            assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{a} {b} on {page}");
            let svg = svg(folder.path(), "out/01-penetration.svg");
            assert!(svg.contains(&a.to_lowercase()) && svg.contains(&b.to_lowercase()), "as given");
        }
    }
}

#[test]
fn only_colours_that_a_figure_uses_are_compared_and_the_nearest_that_pass_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let alike = "[colors]\na = '#ff7f0e'\nb = '#d62728'\ndifference = '#ff7f0e'\n";
    fs::write(folder.path().join("own.toml"), alike).unwrap();
    let own = |figure: &str, more: &[&str]| {
        let figure = format!("{}/figures/{figure}.toml", env!("CARGO_MANIFEST_DIR"));
        let usual = ["--format", "svg", "-o", ".", "--theme", "own.toml", figure.as_str()];
        render(folder.path(), &[&usual, more].concat())
    };
    assert_eq!(own("02-bounding-box", &[]).code, Some(0), "there is no B and no difference in it");
    let refused = own("01-penetration", &[]);
    assert_eq!(refused.code, Some(1));
    let lines: Vec<_> = refused.err.lines().collect();
    assert_eq!(lines.len(), 2, "{}", refused.err);
    let (said, near) = lines[0].split_once("; nearest that passes: ").unwrap();
    let short = "theme own.toml: a #FF7F0E is too near b #D62728 to readers without blue cones: ΔE2000 14.4, at least 20";
    assert!(said.ends_with(short), "{said}");
    // What is named passes, and nothing else was wrong.
    let color = near.split([' ', ',']).find(|word| word.starts_with('#')).unwrap();
    let mended = format!("[colors]\na = '{color}'\nb = '#d62728'\n");
    fs::write(folder.path().join("own.toml"), mended).unwrap();
    assert_eq!(own("01-penetration", &[]).err, "");
    fs::write(folder.path().join("own.toml"), alike).unwrap();
    let allowed = own("01-penetration", &["--allow-similar"]);
    assert_eq!(allowed.code, Some(0));
    assert!(allowed.err.starts_with("warning: ") && allowed.err.lines().count() == 1, "{}", allowed.err);
}

#[test]
fn a_theme_file_is_one_of_several_themes_and_a_wrong_one_is_told_with_its_line() {
    let folder = folder_with("s.toml", &drawn());
    fs::write(folder.path().join("slides.toml"), "based_on = \"dark\"\n[colors]\na = \"#FF6650\"\n").unwrap();
    fs::write(folder.path().join("wrong.toml"), "[colors]\nink = \"black\"\n").unwrap();
    let with = |theme: &str| render(folder.path(), &["s.toml", "--format", "svg", "--theme", theme]);
    assert_eq!(with("slides.toml,print").code, Some(0));
    assert!(svg(folder.path(), "s.slides.svg").contains("#ff6650"));
    // A wrong text is no fault of the command.
    for (text, at, parts) in [
        ("ink = \"black\"", "2:7", ["`colors.ink`: expected `#RRGGBB` or `#RGB`, got `black`", "ink = "]),
        ("backgruond = '#fff'", "2:1", ["unknown key `backgruond`", "= help: did you mean `background`?"]),
    ] {
        fs::write(folder.path().join("wrong.toml"), format!("[colors]\n{text}\n")).unwrap();
        let refused = with("wrong.toml");
        assert_eq!(refused.code, Some(1), "{}", refused.err);
        assert!(refused.err.contains(&format!("--> wrong.toml:{at}\n")), "{}", refused.err);
        assert!(parts.iter().all(|part| refused.err.contains(part)), "{}", refused.err);
        assert!(!refused.err.contains("--help"), "{}", refused.err);
    }
    assert_eq!([with("sepia").code, with("none.toml").code], [Some(2), Some(2)]);
}

#[test]
fn a_wrong_word_in_a_theme_of_a_project_is_told_with_its_line_there() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::write(here.join("tracefig.toml"), "[render]\nscenes = [\".\"]\nthemes = [\"brand.toml\"]\n").unwrap();
    for (text, said) in [
        ("[colors]\nbackgruond = \"#fff\"\n", "error[unknown-key]: unknown key `backgruond` in `[colors]`"),
        ("[text]\nname = 3\n", "error[out-of-range]: `text.name`: expected a number from 11 to 40, got 3"),
        ("\nbased_on = \"drak\"\n", "error[unknown-word]: unknown theme `drak`"),
        ("\ncolour = 1\n", "error[syntax]: unknown field `colour`"),
        ("\n[colors\n", "error[syntax]: "),
    ] {
        fs::write(here.join("brand.toml"), text).unwrap();
        let got = render(here, &[]);
        assert_eq!(got.code, Some(1), "{}", got.err);
        assert!(got.err.starts_with(said) && got.err.contains("--> brand.toml:2:"), "{}", got.err);
    }
    fs::write(here.join("brand.toml"), "[colors]\nbackgruond = \"#fff\"\n").unwrap();
    assert!(render(here, &[]).err.contains("did you mean `background`?"));
}

#[test]
fn a_theme_sets_the_widths_of_lines_and_the_sizes_of_letters() {
    let folder = folder_with("s.toml", &drawn());
    let theme = "[stroke]\noutline = 4.5\n[text]\nname = 34\n";
    fs::write(folder.path().join("slides.toml"), theme).unwrap();
    // Beside a theme of the house, which keeps its own.
    let ran = render(folder.path(), &["s.toml", "--format", "svg", "--theme", "light,slides.toml"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    let [house, slides] = ["s.light.svg", "s.slides.svg"].map(|name| svg(folder.path(), name));
    assert!(house.contains("stroke-width=\"2.1\"") && slides.contains("stroke-width=\"4.5\""));
    assert!(!house.contains("stroke-width=\"4.5\"") && !slides.contains("stroke-width=\"2.1\""));
    assert!(house.contains("scale(.017)") && slides.contains("scale(.034)"), "{slides}");
}

#[test]
fn titles_captions_and_headlines_have_the_size_of_their_theme() {
    let words = "headline = \"One sentence\"\ncaption = \"Another sentence\"\n";
    let folder = folder_with("s.toml", &format!("{words}{}title = \"A title\"\n", drawn()));
    fs::write(folder.path().join("own.toml"), "[text]\ntitle = 21\ncaption = 22\nheadline = 33\n").unwrap();
    let height = |svg: &str| {
        let rest = svg.split_once(" height=\"").unwrap().1;
        rest.split_once('"').unwrap().0.parse::<f64>().unwrap()
    };
    let ran = render(folder.path(), &["s.toml", "--format", "svg", "--theme", "own.toml,light"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    let [own, house] = ["s.own.svg", "s.light.svg"].map(|name| svg(folder.path(), name));
    for (size, usual) in
        [("scale(.021)", "scale(.013)"), ("scale(.022)", "scale(.014)"), ("scale(.033)", "scale(.019)")]
    {
        assert!(own.contains(size) && !own.contains(usual), "{size}");
        assert!(house.contains(usual) && !house.contains(size), "{usual}");
    }
    assert!(height(&own) > height(&house) + 10.0, "the page grows with its words");
}

#[test]
fn a_scene_names_a_theme_file_of_its_own_folder() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::create_dir(here.join("docs")).unwrap();
    let named = |theme: &str| format!("canvas.theme = \"{theme}\"\n{}", drawn());
    fs::write(here.join("docs/brand.toml"), "[colors]\na = \"#ff6650\"\n").unwrap();
    fs::write(here.join("docs/s.toml"), named("brand.toml")).unwrap();
    let ran = render(here, &["docs/s.toml", "--format", "svg"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert!(svg(here, "docs/s.svg").contains("#ff6650"));
    let current = ["docs/s.toml", "--format", "svg", "--skip-unchanged"];
    assert_eq!(render(here, &current).out, "", "as it was");
    fs::write(here.join("docs/brand.toml"), "[colors]\na = \"#ff6651\"\n").unwrap();
    assert_eq!(render(here, &current).out, "docs/s.svg\n", "another theme, another figure");
    assert_eq!(run(tracefig(here).args(["describe", "docs/s.toml"])).code, Some(0));
    let check = ["check", "docs/s.toml", "--format", "svg", "--junit", "docs/brand.toml"];
    let kept = run(tracefig(here).args(check));
    assert!(kept.code == Some(2) && kept.err.contains("may be a scene or a theme"), "{}", kept.err);
    // A theme that was asked for is in place of the scene's own, which need not be there.
    fs::remove_file(here.join("docs/brand.toml")).unwrap();
    assert_eq!(render(here, &["docs/s.toml", "--format", "svg", "--theme", "dark"]).code, Some(0));
    let lost = render(here, &["docs/s.toml", "--format", "svg"]);
    assert_eq!(lost.code, Some(1));
    let told = "error[bad-theme]: the theme `brand.toml` can't be used: ";
    assert!(lost.err.starts_with(told) && lost.err.contains("--> docs/s.toml:1:16"), "{}", lost.err);
    // What is wrong in the file is shown there.
    fs::write(here.join("docs/brand.toml"), "[colors]\na = \"red\"\n").unwrap();
    for command in ["render", "describe"] {
        let wrong = run(tracefig(here).args([command, "docs/s.toml"]));
        let (quoted, named) =
            ("--> docs/brand.toml:2:5\n  |\n2 | a = \"red\"", "  named at docs/s.toml:1:16\n");
        assert_eq!(wrong.code, Some(1));
        assert!(wrong.err.contains(quoted) && wrong.err.ends_with(named), "{}", wrong.err);
    }
}

#[test]
fn the_dark_side_of_a_theme_file_is_a_theme_for_images() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    let colors = "[colors]\na = \"#0072B2\"\nb = \"#D55E00\"\n";
    fs::write(here.join("brand.toml"), format!("{colors}[dark]\na = \"#56B4E9\"\nb = \"#E69F00\"\n"))
        .unwrap();
    fs::write(here.join("plain.toml"), colors).unwrap();
    let both = ["s.toml", "--format", "svg", "--theme", "brand.toml,brand.toml#dark"];
    let ran = render(here, &both);
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "s.brand.svg\ns.brand-dark.svg\n"), "{}", ran.err);
    let dark = svg(here, "s.brand-dark.svg");
    assert!(dark.contains("#56b4e9") && !dark.contains("prefers-color-scheme"), "one side, for all readers");
    assert!(svg(here, "s.brand.svg").contains("prefers-color-scheme"));
    assert_eq!(run(tracefig(here).arg("check").args(both)).code, Some(0));
    // In a scene and in a project file alike.
    fs::write(here.join("own.toml"), format!("canvas.theme = \"brand.toml#dark\"\n{}", drawn())).unwrap();
    assert_eq!(render(here, &["own.toml", "--format", "svg"]).code, Some(0));
    assert!(svg(here, "own.svg").contains("#56b4e9"));
    let project =
        "[render]\nscenes = ['s.toml']\nthemes = ['brand.toml', 'brand.toml#dark']\nformats = ['svg']\n";
    fs::write(here.join("tracefig.toml"), project).unwrap();
    assert_eq!(run(tracefig(here).args(["check"])).code, Some(0));
    let several = render(here, &["s.toml", "-o", "-"]);
    let told = "tracefig.toml names 2 themes, `brand`, `brand-dark`: choose one by `--theme`\n";
    assert!(several.code == Some(2) && several.err.contains(told), "{}", several.err);
    let none = render(here, &["s.toml", "--theme", "plain.toml#dark"]);
    assert!(none.code == Some(2) && none.err.contains("plain.toml has no table `[dark]`"), "{}", none.err);
}

#[test]
fn a_theme_of_a_scene_is_a_file_by_a_path_from_there() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::write(here.join("brand.toml"), "[colors]\na = \"#ff6650\"\n").unwrap();
    let absolute = here.join("brand.toml").display().to_string();
    fs::create_dir(here.join("folder.toml")).unwrap();
    for (theme, why) in [
        (absolute.as_str(), "expected a path from the scene's own folder"),
        ("folder.toml", "it is a folder, not a regular file"),
        ("s.toml", "unknown field"),
    ] {
        fs::write(here.join("own.toml"), format!("canvas.theme = \"{theme}\"\n{}", drawn())).unwrap();
        let ran = render(here, &["own.toml", "--format", "svg"]);
        assert!(ran.code == Some(1) && ran.err.contains(why), "{theme}: {}", ran.err);
    }
    // A line of a stream names one of the working directory.
    let line = "{\"canvas\": {\"theme\": \"brand.toml\"}, \"query\": {\"kind\": \"bounds\", \"of\": [\"A\"]}, \
                \"shapes\": {\"A\": {\"kind\": \"circle\", \"radius\": 1}}}\n";
    let ran = run_on(tracefig(here).args(["render", "--jsonl", "--format", "svg"]), line);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert!(svg(here, "line-1.svg").contains("#ff6650"));
}

#[test]
fn what_several_scenes_say_of_a_theme_is_said_once() {
    let folder = tempfile::tempdir().unwrap();
    let alike = "[colors]\na = '#ff7f0e'\nb = '#d62728'\n";
    fs::write(folder.path().join("own.toml"), alike).unwrap();
    let names: Vec<_> = (0..7).map(|k| format!("scenes/s{k}.toml")).collect();
    fs::create_dir(folder.path().join("scenes")).unwrap();
    for name in &names {
        fs::write(folder.path().join(name), drawn()).unwrap();
    }
    let files: Vec<&str> = names.iter().map(String::as_str).collect();
    let ran = |more: &[&str]| {
        let usual = ["--format", "svg", "--theme", "own.toml"];
        render(folder.path(), &[&usual, more, &files[..]].concat())
    };
    let refused = ran(&[]);
    assert_eq!(refused.code, Some(1), "{}", refused.err);
    let said = "(7 scenes: scenes/s0.toml, scenes/s1.toml, scenes/s2.toml, scenes/s3.toml and 3 more)";
    let lines: Vec<_> = refused.err.lines().collect();
    assert!(
        lines[0].starts_with("error: theme own.toml: a #FF7F0E is too near b #D62728"),
        "{}",
        refused.err
    );
    assert!(lines[0].ends_with(said) && lines.len() == 2, "{}", refused.err);
    assert!(lines[1].starts_with("help: `--allow-similar`"), "{}", refused.err);
    for threads in ["1", "3"] {
        assert_eq!(ran(&["--threads", threads]).err, refused.err, "in any order of work");
    }
    let allowed = ran(&["--allow-similar"]);
    assert_eq!(allowed.code, Some(0));
    let lines: Vec<_> = allowed.err.lines().collect();
    assert!(lines.len() == 1 && lines[0].starts_with("warning: ") && lines[0].ends_with(said), "{lines:?}");
    let checked = run(tracefig(folder.path()).args(["check", "--json", "--theme", "own.toml", "scenes"]));
    assert_eq!(checked.code, Some(1));
    assert_eq!(checked.err, refused.err);
    assert_eq!(
        checked.out.matches("is too near b #D62728").count(),
        7,
        "each finding has its own: {}",
        checked.out
    );
}

#[test]
fn a_file_that_is_no_theme_is_said_once_for_all_scenes_that_name_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("own.toml"), "[colors]\nink = 'black'\n").unwrap();
    let scene = format!("{}\n[canvas]\ntheme = 'own.toml'\n", drawn());
    let write = |name: &str| fs::write(folder.path().join(name), &scene).unwrap();
    write("s0.toml");
    let alone = render(folder.path(), &["s0.toml"]);
    assert_eq!(alone.code, Some(1));
    assert!(alone.err.contains("s0.toml:") && alone.err.contains("got `black`"), "{}", alone.err);
    write("s1.toml");
    let both = render(folder.path(), &["s0.toml", "s1.toml"]);
    assert_eq!(both.code, Some(1));
    assert_eq!(both.err.matches("got `black`").count(), 1, "{}", both.err);
    assert!(both.err.contains("(2 scenes: s0.toml, s1.toml)"), "{}", both.err);
}

#[test]
fn a_dark_side_that_no_file_shows_refuses_none() {
    let folder = tempfile::tempdir().unwrap();
    let colors = "[colors]\na = '#7A1FA2'\nb = '#00897B'\n[dark]\na = '#CE93D8'\nb = '#4DB6AC'\n";
    fs::write(folder.path().join("own.toml"), colors).unwrap();
    let figure = &figures()[0];
    let code = |format: &str, theme: &str| {
        render(folder.path(), &[figure, "--theme", theme, "--format", format, "-o", "out"]).code
    };
    assert_eq!(["png", "pdf"].map(|format| code(format, "own.toml")), [Some(0); 2]);
    assert_eq!(["svg", "html"].map(|format| code(format, "own.toml")), [Some(1); 2]);
    assert_eq!(code("png", "own.toml#dark"), Some(1));
}
