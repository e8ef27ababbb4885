//! `--steps`: which files a figure in steps becomes, and what they hold.

use std::fs;
use std::path::Path;

use crate::render::{names, set};
use crate::{CIRCLES, Ran, folder_with, run, tracefig};

/// A scene that comes about in three steps: the bodies, the closest points, the distance.
fn scene() -> String {
    format!(
        "{CIRCLES}[[panels]]\nlayers = [\"shapes\", {{ layer = \"separation\", points = true }}]\n\
         [canvas]\nwidth = 300\n"
    )
}

fn render(folder: &Path, arguments: &[&str]) -> Ran {
    run(tracefig(folder).args(["render", "s.toml"]).args(arguments))
}

#[test]
fn a_format_that_holds_steps_has_one_file_and_another_a_file_a_step() {
    let folder = folder_with("s.toml", &scene());
    let ran = render(folder.path(), &["--steps", "--format", "svg,png"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_eq!(ran.out, "s.steps.svg\ns.step-01.png\ns.step-02.png\ns.step-03.png\n");
    let ran =
        render(folder.path(), &["--steps=files", "--format", "svg", "--theme", "light,dark", "-o", "a"]);
    let files = ran.out.lines().collect::<Vec<_>>();
    assert_eq!((files.len(), files[0], files[5]), (6, "a/s.light.step-01.svg", "a/s.dark.step-03.svg"));
    assert_eq!(
        names(folder.path()),
        set(&["a", "s.step-01.png", "s.step-02.png", "s.step-03.png", "s.steps.svg", "s.toml"])
    );
}

#[test]
fn the_last_step_shows_the_figure_and_the_first_one_less() {
    let folder = folder_with("s.toml", &scene());
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(render(folder.path(), &["--format", "svg"]).code, Some(0));
    assert_eq!(render(folder.path(), &["--steps=files", "--format", "svg"]).code, Some(0));
    let body = |name: &str| {
        let text = read(name);
        let id = text.split("aria-labelledby=\"").nth(1).unwrap().split('-').next().unwrap().to_owned();
        text.split_once("</metadata>").unwrap().1.replace(&id, "id")
    };
    assert!(body("s.step-03.svg") == body("s.svg"));
    assert!(body("s.step-01.svg").len() < body("s.svg").len());
}

#[test]
fn a_picture_of_reveal_has_fragments_that_count_from_0() {
    let folder = folder_with("s.toml", &scene());
    let ran = render(folder.path(), &["--steps", "--fragments", "--format", "svg", "-o", "-"]);
    for index in 0..2 {
        let fragment = format!("class=\"fragment\" data-fragment-index=\"{index}\"");
        assert!(ran.out.contains(&format!("<g data-step=\"{}\" {fragment}>", index + 2)), "{}", ran.out);
    }
    assert!(!ran.out.contains("data-fragment-index=\"2\""));
}

#[test]
fn a_pdf_has_a_page_a_step_with_its_title_and_a_gif_holds_as_long_as_asked() {
    let folder = folder_with("s.toml", &scene());
    let ran = render(folder.path(), &["--steps", "--hold", "0.5", "--format", "pdf,gif,apng,html"]);
    assert_eq!((ran.code, ran.out.lines().count()), (Some(0), 4), "{}", ran.err);
    let pdf = fs::read(folder.path().join("s.steps.pdf")).unwrap();
    let pdf = String::from_utf8_lossy(&pdf);
    assert!(pdf.contains("/Count 3") && pdf.contains("/PageLabels"), "{pdf}");
    assert!(pdf.contains("/P(The question)") && pdf.contains("/P(The answer)"), "{pdf}");
    let gif = fs::read(folder.path().join("s.steps.gif")).unwrap();
    // Extension, graphic control, four bytes, how the frame is left, hundredths of a second.
    let delays: Vec<u8> =
        gif.windows(6).filter(|part| part[..3] == [0x21, 0xF9, 4]).map(|part| part[4]).collect();
    assert_eq!(delays, [50, 50, 50]);
    let page = fs::read_to_string(folder.path().join("s.steps.html")).unwrap();
    assert_eq!(page.matches("type=\"radio\"").count(), 3);
    assert!(page.contains("default-src 'none'") && page.contains("script-src 'sha256-"));
}

#[test]
fn what_each_step_says_stands_below_it_where_asked() {
    let folder = folder_with("s.toml", &scene());
    let pictures = |arguments: &[&str]| -> Vec<String> {
        let ran = render(folder.path(), &[&["--steps=files", "--format", "svg"], arguments].concat());
        assert_eq!((ran.code, ran.out.lines().count()), (Some(0), 3), "{}", ran.err);
        let read = |k: usize| fs::read_to_string(folder.path().join(format!("s.step-0{k}.svg"))).unwrap();
        (1..=3).map(read).collect()
    };
    let height = |svg: &String| svg.split_once(" height=\"").unwrap().1.split_once('"').unwrap().0.to_owned();
    let (told, bare) = (pictures(&["--words"]), pictures(&[]));
    for (k, (told, bare)) in (1..).zip(told.iter().zip(&bare)) {
        let said = |number: usize| told.contains(&format!(">{number} / 3 · "));
        assert!((1..=3).all(|number| said(number) == (number == k)), "{k}");
        assert!(!bare.contains(" / 3 · ") && height(told) != height(bare), "{k}");
    }
    assert!(told.iter().all(|svg| height(svg) == height(&told[0])), "nothing moves");
    let ran = render(folder.path(), &["--words"]);
    assert_eq!(ran.code, Some(2), "only of steps");
}

#[test]
fn a_presentation_has_a_slide_a_step_of_every_scene_and_the_same_bytes_again() {
    let folder = folder_with("s.toml", &scene());
    fs::write(folder.path().join("t.toml"), scene()).unwrap();
    // The directory of the archive names every file once more.
    let slides = |name: &str| {
        let bytes = fs::read(folder.path().join(name)).unwrap();
        let named = bytes.windows(16).filter(|part| part.starts_with(b"ppt/slides/slide")).count();
        (named / 2, bytes)
    };
    for (arguments, name, count) in [
        (&["t.toml", "--steps", "-o", "deck.pptx"][..], "deck.pptx", 6),
        (&["t.toml", "-o", "two.pptx"], "two.pptx", 2),
        (&["--steps", "-o", "alone.pptx"], "alone.pptx", 3),
        (&["--format", "pptx", "--theme", "dark"], "s.pptx", 1),
    ] {
        let ran = render(folder.path(), arguments);
        assert_eq!((ran.code, ran.out.as_str()), (Some(0), format!("{name}\n").as_str()), "{}", ran.err);
        let (slides_of, bytes) = slides(name);
        assert_eq!(slides_of, count, "{name}");
        assert_eq!(render(folder.path(), arguments).code, Some(0));
        assert!(slides(name).1 == bytes, "{name}");
    }
    // It says of itself what it is of.
    let current = render(folder.path(), &["--format", "pptx", "--theme", "dark", "--skip-unchanged"]);
    assert_eq!((current.code, current.out.as_str()), (Some(0), ""), "{}", current.err);
    for wrong in [&["t.toml", "-o", "x.pptx", "--per-page", "2"][..], &["t.toml", "-o", "x.pdf", "--steps"]] {
        assert_eq!(render(folder.path(), wrong).code, Some(2), "{wrong:?}");
    }
}

#[test]
fn check_compares_and_accepts_every_file_of_the_steps() {
    let folder = folder_with("s.toml", &scene());
    let check = |more: &[&str]| {
        let usual = ["check", "s.toml", "--steps", "--format", "svg,png,gif"];
        run(tracefig(folder.path()).args(usual).args(more))
    };
    assert!(check(&[]).out.contains("\n0 identical, 0 changed, 5 missing\n"));
    assert_eq!(check(&["--accept"]).code, Some(0));
    assert!(check(&[]).out.ends_with("5 identical, 0 changed, 0 missing\n"));
    fs::copy(folder.path().join("s.step-01.png"), folder.path().join("s.step-02.png")).unwrap();
    let ran = check(&[]);
    assert_eq!(ran.code, Some(1), "{}", ran.out);
    assert!(ran.out.contains("s.step-02.png") && ran.out.contains("4 identical"), "{}", ran.out);
}

#[test]
fn a_project_may_want_steps_and_a_word_that_is_none_is_told_with_its_line() {
    let folder = folder_with("s.toml", &scene());
    let project = |text: &str| fs::write(folder.path().join("tracefig.toml"), text).unwrap();
    project("[render]\nscenes = ['s.toml']\nformats = ['svg']\nsteps = 'files'\n");
    let ran = run(tracefig(folder.path()).arg("render"));
    assert_eq!(ran.out, "s.step-01.svg\ns.step-02.svg\ns.step-03.svg\n", "{}", ran.err);
    assert_eq!(render(folder.path(), &["--steps=one"]).out, "s.steps.svg\n");
    project("[render]\nsteps = 'file'\n");
    let ran = run(tracefig(folder.path()).args(["render", "s.toml"]));
    assert_eq!(ran.code, Some(1));
    assert!(ran.err.contains("tracefig.toml:2") && ran.err.contains("`files`"), "{}", ran.err);
}

#[test]
fn steps_of_many_files_do_not_fit_standard_output() {
    let folder = folder_with("s.toml", &scene());
    for steps in ["--steps", "--steps=files"] {
        let ran = render(folder.path(), &[steps, "--format", "png", "-o", "-"]);
        assert_eq!(ran.code, Some(2), "{}", ran.err);
    }
    for wrong in [&["--steps=two"][..], &["--hold", "2"], &["--steps", "--hold", "0"], &["--fragments"]] {
        assert_eq!(render(folder.path(), wrong).code, Some(2), "{wrong:?}");
    }
}

#[test]
fn an_svg_with_all_steps_is_hardly_larger_than_the_figure() {
    let figures = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let folder = tempfile::tempdir().unwrap();
    let command = ["render", "--steps", "--format", "svg", "-o", "out"];
    let ran = run(tracefig(folder.path()).args(command).arg(&figures));
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    for name in ran.out.lines() {
        let stem = Path::new(name).file_name().unwrap().to_str().unwrap().replace(".steps.svg", ".svg");
        let size = |path: &Path| fs::metadata(path).unwrap().len();
        let (figure, steps) = (size(&figures.join(stem)), size(&folder.path().join(name)));
        assert!(10 * steps <= 11 * figure, "{name}: {figure} bytes, in steps {steps}");
    }
    assert!(ran.out.lines().count() >= 20, "{}", ran.out);
}

#[test]
fn steps_of_a_scene_are_told_in_its_words_whatever_letters_they_have() {
    let words = "[[steps]]\nuntil = 2\ntitle = 'Near <é (1'\ntext = 'Both & \"apart\".'\n[canvas]";
    let folder = folder_with("s.toml", &scene().replace("[canvas]", words));
    let ran = render(folder.path(), &["--steps", "--format", "html,pdf"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    let page = fs::read_to_string(folder.path().join("s.steps.html")).unwrap();
    assert_eq!(page.matches("type=\"radio\"").count(), 2);
    assert!(page.contains("Near &lt;é (1") && page.contains("Both &amp; ") && !page.contains("Near <"));
    let pdf = fs::read(folder.path().join("s.steps.pdf")).unwrap();
    let pdf = String::from_utf8_lossy(&pdf);
    assert!(pdf.contains("/Count 2") && !pdf.contains("/P(Near <"), "{pdf}");
}

#[test]
fn what_is_wrong_with_the_steps_of_a_scene_is_told_with_its_line() {
    let told = [
        ("until = 2\n[[steps]]\nuntil = 2", 3, "from step 2"),
        ("untill = 2", 1, "`until`"),
        ("until = 0", 1, "`until`"),
        ("skip = true\ntext = 'no'", 2, "`skip`"),
    ];
    for (words, line, wanted) in told {
        let scene = scene().replace("[canvas]", &format!("[[steps]]\n{words}\n[canvas]"));
        let before = scene.lines().position(|line| line == "[[steps]]").unwrap() + 1;
        let folder = folder_with("s.toml", &scene);
        let ran = render(folder.path(), &["--steps"]);
        assert_eq!(ran.code, Some(1), "{words}");
        let place = format!("s.toml:{}:", before + line);
        assert!(ran.err.contains(&place) && ran.err.contains(wanted), "{}", ran.err);
    }
}
