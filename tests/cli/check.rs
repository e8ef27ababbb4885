//! `check`: every state a figure can be in, what moved in words, and the reports.

use std::fs;

use crate::hostile_figures::HOSTILE;
use crate::render::{drawn, names, set};
use crate::{folder_with, run, run_on, tracefig};

#[test]
fn check_tells_identical_stale_and_missing_and_accepts() {
    let folder = folder_with("s.toml", &drawn());
    let check = |arguments: &[&str]| {
        run(tracefig(folder.path()).args(["check", "s.toml", "-o", "drift"]).args(arguments))
    };
    let ran = check(&[]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (
            Some(1),
            "missing   s.svg\n          there is no such file yet\nmissing   s.png\n          there is no such file yet\nall of it: drift/index.html\n0 identical, 0 changed, 2 missing\n`tracefig check --accept` writes what is missing; give the same scenes and options\n"
        )
    );
    assert_eq!(names(folder.path()), set(&["drift", "s.toml"]));
    assert_eq!(check(&["--accept"]).code, Some(0));
    let ran = check(&[]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "2 identical, 0 changed, 0 missing\n"));

    fs::write(folder.path().join("s.toml"), drawn().replace("position = [4, 0]", "position = [5, 0]"))
        .unwrap();
    let ran = check(&[]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.out.contains("stale     s.svg\n          separation: 1.0 → 2.0\n"), "{}", ran.out);
    assert!(ran.out.contains("pixels beyond a tolerance of 0: "), "{}", ran.out);
    assert!(ran.out.contains("in the changed area: ") && ran.out.contains("body-B"), "{}", ran.out);
    assert!(
        ran.out.contains("\n0 identical, 0 changed, 2 stale, 0 missing\n`tracefig check --accept` writes"),
        "{}",
        ran.out
    );
    let triptych = fs::read(folder.path().join("drift/s.png")).unwrap();
    let width = u32::from_be_bytes(triptych[16..20].try_into().unwrap());
    assert!(width >= 3 * 1920, "{width}");
    let page = fs::read_to_string(folder.path().join("drift/index.html")).unwrap();
    assert!(page.contains("separation: 1.0 → 2.0") && page.contains("data:image/png;base64,"));
    assert!(!page.contains("<script"));
    let ran = check(&["--accept"]);
    assert_eq!(ran.code, Some(0));
    assert!(ran.out.ends_with("0 identical, 0 changed, 2 stale, 0 missing, accepted\n"), "{}", ran.out);
    assert_eq!(check(&[]).code, Some(0));
}

/// It was counted as stale and as an error, and a CI had two cases of one name.
#[cfg(unix)]
#[test]
fn a_file_that_can_not_be_accepted_is_one_finding() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder_with("tracefig.toml", "");
    let here = folder.path();
    fs::create_dir(here.join("docs")).unwrap();
    fs::write(here.join("docs/s.toml"), drawn()).unwrap();
    assert_eq!(run(tracefig(here).args(["render", "docs", "--format", "svg"])).code, Some(0));
    fs::write(here.join("docs/s.toml"), drawn().replace("position = [4, 0]", "position = [5, 0]")).unwrap();
    let allow = |mode| fs::set_permissions(here.join("docs"), fs::Permissions::from_mode(mode)).unwrap();
    allow(0o555);
    // Whoever may write everywhere has it accepted.
    let is_held = fs::write(here.join("docs/probe"), "").is_err();
    let ran = run(tracefig(here).args(["check", "docs", "--format", "svg", "--accept", "-o", "drift"]));
    allow(0o755);
    if is_held {
        assert_eq!(ran.code, Some(74), "{}{}", ran.out, ran.err);
        assert!(
            ran.out.contains("0 identical, 0 changed, 1 stale, 0 missing, 0 of 1 accepted\n"),
            "{}",
            ran.out
        );
        assert!(ran.out.contains("can't write docs/s.svg"), "{}", ran.out);
    }
}

#[test]
fn a_document_of_several_figures_is_compared_with_what_render_would_write() {
    let folder = folder_with("a.toml", &drawn());
    let here = folder.path();
    fs::write(here.join("b.toml"), drawn()).unwrap();
    for file in ["h.pdf", "h.pptx"] {
        let sheets = |more: &[&str]| {
            let usual = if file == "h.pdf" { &["--per-page", "1"][..] } else { &[] };
            [usual, more].concat().into_iter().map(str::to_owned).collect::<Vec<_>>()
        };
        let checked = |more: &[&str]| {
            run(tracefig(here)
                .args(["check", "a.toml", "b.toml", "--handout", file, "-o", "d"])
                .args(sheets(more)))
        };
        fs::write(here.join("b.toml"), drawn()).unwrap();
        let told = |more: &[&str], state: &str| {
            let ran = checked(more);
            assert_eq!(ran.code, Some(i32::from(state != "1 identical")), "{state}: {}{}", ran.out, ran.err);
            assert!(ran.out.contains(state), "{state}: {}", ran.out);
            ran.out
        };
        assert!(told(&[], "missing   ").contains(&format!("{file}\n          there is no such file yet")));
        let rendered = run(tracefig(here).args(["render", "a.toml", "b.toml", "-o", file]).args(sheets(&[])));
        assert_eq!(rendered.code, Some(0), "{}", rendered.err);
        told(&[], "1 identical");
        let whole = fs::read(here.join(file)).unwrap();
        fs::write(here.join(file), &whole[..whole.len() / 2]).unwrap();
        assert!(told(&[], "changed   ").contains("cut short"));
        assert_eq!(checked(&["--accept"]).code, Some(0));
        assert_eq!(fs::read(here.join(file)).unwrap(), whole);
        // The other figure moves, the paper is another one, or a scene is none.
        fs::write(here.join("b.toml"), drawn().replace("[4, 0]", "[5, 0]")).unwrap();
        told(&[], "stale     ");
        assert_eq!(checked(&["--accept"]).code, Some(0));
        told(&[], "1 identical");
        if file == "h.pdf" {
            told(&["--paper", "letter"], "stale     ");
        }
        fs::write(here.join("b.toml"), "shapes = 1").unwrap();
        let ran = checked(&["--json"]);
        assert_eq!(ran.code, Some(1));
        assert!(ran.out.contains("not all of its figures can be drawn"), "{}", ran.out);
        assert!(ran.err.contains("b.toml"), "{}", ran.err);
    }
    let refused = run(tracefig(here).args(["check", "a.toml", "--per-page", "2"]));
    assert_eq!(refused.code, Some(2), "sheets need a document");
}

#[test]
fn a_figure_changed_by_hand_is_shown_where() {
    let folder = folder_with("s.toml", &drawn());
    let run = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments));
    assert_eq!(run(&["render", "s.toml", "--format", "svg"]).code, Some(0));
    let path = folder.path().join("s.svg");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replacen("<circle", "<ellipse", 1)).unwrap();
    let ran = run(&["check", "s.toml", "--format", "svg"]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.out.starts_with("changed   s.svg\n          line "), "{}", ran.out);
    assert!(ran.out.contains("<ellipse") && ran.out.contains("<circle"), "{}", ran.out);
}

#[test]
fn a_pixel_changed_by_hand_is_found_and_tolerance_is_what_it_says() {
    let folder = folder_with("s.toml", &drawn());
    let run = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments));
    let small = ["--format", "png", "--scale", "0.5"];
    assert_eq!(run(&[&["render", "s.toml"][..], &small].concat()).code, Some(0));
    let path = folder.path().join("s.png");
    let mut decoder = png::Decoder::new(std::io::Cursor::new(fs::read(&path).unwrap()));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let channels = pixels.len() / (info.width * info.height) as usize;
    let at = channels * (10 * info.width as usize + 20);
    pixels[at] = pixels[at].wrapping_sub(5);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, info.width, info.height);
    encoder.set_color(info.color_type);
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    fs::write(&path, bytes).unwrap();

    let ran = run(&[&["check", "s.toml"][..], &small].concat());
    assert_eq!(ran.code, Some(1));
    assert!(
        ran.out.contains("1 pixel differs, by 5 of 255 levels at most, within x 20 – 21, y 10 – 11"),
        "{}",
        ran.out
    );
    assert!(ran.out.contains("a tolerance of 0: 1, 1: 1, 2: 1, 4: 1, 8: 0, 16: 0"), "{}", ran.out);
    assert_eq!(run(&[&["check", "s.toml", "--tolerance", "4"][..], &small].concat()).code, Some(1));
    assert_eq!(run(&[&["check", "s.toml", "--tolerance", "5"][..], &small].concat()).code, Some(0));
}

#[test]
fn a_figure_without_a_scene_is_an_orphan() {
    let folder = folder_with("a.toml", &drawn());
    fs::write(folder.path().join("b.toml"), drawn()).unwrap();
    let run = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments));
    assert_eq!(run(&["render", ".", "--format", "svg", "--theme", "light,dark"]).code, Some(0));
    assert_eq!(run(&["check", ".", "--format", "svg", "--theme", "light,dark"]).code, Some(0));
    fs::remove_file(folder.path().join("b.toml")).unwrap();
    // A picture of somebody else's is none of our business.
    fs::write(folder.path().join("logo.svg"), "<svg/>").unwrap();
    let check = ["check", ".", "--format", "svg", "--theme", "light,dark"];
    let ran = run(&check);
    assert_eq!(ran.code, Some(1));
    assert!(
        ran.out.contains("orphan    ./b.dark.svg\n") && ran.out.contains("orphan    ./b.light.svg\n"),
        "{}",
        ran.out
    );
    assert!(
        ran.out.contains("\n2 identical, 0 changed, 0 missing, 2 orphan\n`tracefig check --prune` deletes"),
        "{}",
        ran.out
    );
    // Nothing is deleted, so accepting does not make it good.
    assert_eq!(run(&[&check[..], &["--accept"]].concat()).code, Some(1));
}

#[test]
fn findings_are_written_for_machines() {
    let folder = folder_with("s.toml", &drawn());
    let options = ["--format", "svg", "--json", "--junit", "junit.xml", "--summary", "summary.md"];
    let ran = run(tracefig(folder.path()).args(["check", "s.toml"]).args(options));
    assert_eq!(ran.code, Some(1));
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!((json["missing"].as_u64(), json["files"][0]["file"].as_str()), (Some(1), Some("s.svg")));
    let junit = fs::read_to_string(folder.path().join("junit.xml")).unwrap();
    assert!(junit.contains("tests=\"1\" failures=\"1\""), "{junit}");
    let summary = fs::read_to_string(folder.path().join("summary.md")).unwrap();
    assert!(summary.starts_with("### Figures: 1 missing\n"), "{summary}");
}

#[test]
fn a_scene_that_can_not_be_drawn_fails_the_check() {
    let folder = folder_with("s.toml", "title = 1");
    let ran = run(tracefig(folder.path()).args(["check", "s.toml"]));
    assert_eq!(ran.code, Some(1));
    assert!(
        ran.err.contains("error[wrong-type]: `title`") && ran.out.contains("1 error"),
        "{}{}",
        ran.err,
        ran.out
    );
}

#[test]
fn an_svg_is_compared_by_what_it_shows() {
    let folder = folder_with("s.toml", &drawn());
    let run = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments));
    let svg = ["--format", "svg"];
    assert_eq!(run(&[&["render", "s.toml"][..], &svg].concat()).code, Some(0));
    let path = folder.path().join("s.svg");
    let text = fs::read_to_string(&path).unwrap();
    let redder = text.replace("#bc0d2a", "#b60d2a");
    assert_ne!(text, redder);
    fs::write(&path, redder).unwrap();
    let check = |more: &[&str]| run(&[&["check", "s.toml", "-o", "drift"][..], &svg, more].concat());
    let ran = check(&[]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.out.contains("colour of a #b60d2a → #bc0d2a"), "{}", ran.out);
    assert!(ran.out.contains(", 8: 0, 16: 0"), "{}", ran.out);
    assert!(ran.out.contains("drift/s.svg.png: on disk · difference · now"), "{}", ran.out);
    assert!(folder.path().join("drift/s.svg.png").exists());
    assert_eq!(check(&["--tolerance", "2"]).code, Some(1));
    assert_eq!(check(&["--tolerance", "8"]).code, Some(0));
}

#[test]
fn a_file_is_out_of_date_only_by_an_option_that_its_format_depends_on() {
    let folder = folder_with("s.toml", &drawn());
    let run = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments)).code;
    assert_eq!(run(&["render", "s.toml", "--format", "svg,png,pdf,html,apng", "--scale", "0.5"]), Some(0));
    let cases = [("svg", [0, 0]), ("html", [0, 0]), ("pdf", [0, 0]), ("apng", [1, 0]), ("png", [1, 1])];
    for (format, codes) in cases {
        let check = |options: &[&str]| run(&[&["check", "s.toml", "--format", format][..], options].concat());
        let with_other_options = [check(&["--scale", "0.25"]), check(&["--scale", "0.5", "--png", "small"])];
        assert_eq!(with_other_options, codes.map(Some), "{format}");
        assert_eq!(check(&["--scale", "0.5"]), Some(0), "{format}");
    }
}

#[test]
fn a_hostile_figure_is_a_finding_of_that_figure() {
    let mut wrong = Vec::new();
    for hostile in HOSTILE {
        let folder = tempfile::tempdir().unwrap();
        hostile.put(folder.path());
        let ran = run(tracefig(folder.path()).args(hostile.arguments()));
        let other_is_well = ran.out.contains("1 identical, 1 changed, 0 missing");
        if ran.code != Some(1) || !ran.out.contains(hostile.told) || !other_is_well || !ran.err.is_empty() {
            let said: String = format!("{}{}", ran.out, ran.err).chars().take(600).collect();
            wrong.push(format!("{}: {:?} {said}", hostile.name, ran.code));
        }
        if !["groups in groups", "a head of 60,000 × 60,000"].contains(&hostile.name) {
            continue;
        }
        // Accepted, it is a figure of ours again.
        let accept = run(tracefig(folder.path()).args(hostile.arguments()).arg("--accept"));
        let again = run(tracefig(folder.path()).args(hostile.arguments()));
        assert_eq!((accept.code, again.code), (Some(0), Some(0)), "{}", hostile.name);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn standard_input_has_no_figure_to_check() {
    let ran = run_on(tracefig(".".as_ref()).args(["check", "-", "--format", "svg"]), drawn());
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(
        ran.err.starts_with("error: `check` compares files, and a scene from standard input"),
        "{}",
        ran.err
    );
}

#[test]
fn a_scene_that_is_only_written_otherwise_is_not_stale() {
    let folder = folder_with("s.toml", &drawn());
    let run = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments));
    let svg = ["s.toml", "--format", "svg"];
    assert_eq!(run(&[&["render"][..], &svg].concat()).code, Some(0));
    let otherwise = [
        format!("# who drew this\n{}\n# the end\n", drawn()),
        drawn().replace("kind = \"circle\"\nradius = 1\n", "radius = 1.0\nkind = 'circle' # round\n"),
    ];
    for text in otherwise {
        assert_ne!(text, drawn());
        fs::write(folder.path().join("s.toml"), text).unwrap();
        let ran = run(&[&["check"][..], &svg].concat());
        assert_eq!((ran.code, ran.out.as_str()), (Some(0), "1 identical, 0 changed, 0 missing\n"));
        assert_eq!(run(&[&["render", "--skip-unchanged"][..], &svg].concat()).out, "", "nothing is drawn");
    }
    fs::write(folder.path().join("s.toml"), drawn().replace("Two circles", "2 circles")).unwrap();
    let ran = run(&[&["check"][..], &svg].concat());
    assert!(ran.code == Some(1) && ran.out.starts_with("stale     s.svg\n"), "{}", ran.out);
}

#[test]
fn what_cannot_be_read_is_no_wrong_figure() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("bytes.toml"), [0xff, 0xfe, 0x00]).unwrap();
    fs::write(folder.path().join("s.toml"), drawn()).unwrap();
    let ended = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments)).code;
    for (scene, code) in [("absent.toml", 74), ("bytes.toml", 1), ("s.toml", 1)] {
        assert_eq!(ended(&["check", scene]), Some(code), "{scene}");
        // The worst of several is told.
        assert_eq!(ended(&["check", scene, "away.toml"]), Some(74), "{scene}");
    }
}

#[test]
fn reports_have_the_place_of_what_is_wrong_with_a_scene() {
    let folder = folder_with("s.toml", &drawn().replacen("radius = ", "radius = ?", 1));
    let check = ["check", "s.toml", "--format", "svg", "--junit", "junit.xml", "--summary", "summary.md"];
    assert_eq!(run(tracefig(folder.path()).args(check)).code, Some(1));
    for report in ["junit.xml", "summary.md"] {
        let report = fs::read_to_string(folder.path().join(report)).unwrap();
        assert!(report.contains("error[syntax]") && report.contains("s.toml:4:10"), "{report}");
    }
}

#[test]
fn two_scenes_of_one_name_are_a_finding_and_the_others_are_checked() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::write(here.join("t.toml"), drawn()).unwrap();
    let ran = |arguments: &[&str]| run(tracefig(here).args(arguments));
    assert_eq!(ran(&["render", ".", "--format", "svg,png", "--scale", "0.25"]).code, Some(0));
    fs::copy(here.join("s.toml"), here.join("s.json")).unwrap();
    fs::remove_file(here.join("t.svg")).unwrap();
    let before = names(here);
    let check = ["check", ".", "--scale", "0.25", "-o", "drift", "--prune", "--junit", "junit.xml"];
    let got = ran(&check);
    assert_eq!(got.code, Some(1));
    assert!(got.out.starts_with("missing   ./t.svg\n"), "{}", got.out);
    assert!(got.out.contains("\n1 identical, 0 changed, 1 missing, 2 error\n"), "{}", got.out);
    let said =
        "error: ./s.json and ./s.toml would both become ./s.svg, and 1 more file: rename one of the scenes\n";
    assert_eq!(got.err, said);
    let junit = fs::read_to_string(here.join("junit.xml")).unwrap();
    for name in ["./s.svg", "./s.png"] {
        let said =
            format!("name=\"{name}\"><failure message=\"error\">./s.json and ./s.toml would both become");
        assert!(junit.contains(&said), "{junit}");
    }
    let mut after = names(here);
    assert!(after.remove("drift") && after.remove("junit.xml"));
    assert_eq!(after, before);
    // A figure that would take the place of its scene is told without a word of writing.
    fs::write(here.join("u.json"), drawn()).unwrap();
    fs::remove_file(here.join("s.json")).unwrap();
    assert!(!ran(&["check", "."]).err.contains("written"));
}

#[cfg(target_os = "linux")]
#[test]
fn nothing_is_accepted_or_named_that_could_not_be_written() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    let ran = |more: &[&str]| run(tracefig(here).args(["check", "s.toml", "--scale", "0.25"]).args(more));
    assert_eq!(ran(&["--accept"]).code, Some(0));
    assert!(ran(&["--accept"]).out.ends_with("2 identical, 0 changed, 0 missing\n"), "nothing to accept");
    fs::write(here.join("s.toml"), drawn().replace("position = [4, 0]", "position = [5, 0]")).unwrap();
    // A write past the limit fails, as on a full disk, once the signal is ignored.
    let script = "trap '' XFSZ; ulimit -f 1; exec \"$0\" check s.toml --scale 0.25 --accept -o drift";
    let got = run(std::process::Command::new("sh").args(["-c", script, crate::TRACEFIG]).current_dir(here));
    assert_eq!(got.code, Some(74));
    assert!(got.out.contains(", 0 of 2 accepted\n"), "{}", got.out);
    assert!(!got.out.contains("on disk · difference · now") && !got.out.contains("all of it"), "{}", got.out);
    assert!(
        !got.err.contains(".part") && got.err.contains("can't write s.svg: File too large"),
        "{}",
        got.err
    );
    assert_eq!(names(here), set(&["drift", "s.png", "s.svg", "s.toml", "target"]));
}

#[test]
fn a_page_that_is_not_there_is_not_named() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    let check = |more: &[&str]| run(tracefig(here).args(["check", "s.toml", "--scale", "0.25"]).args(more));
    assert_eq!(check(&["--accept"]).code, Some(0));
    fs::write(here.join("s.toml"), drawn().replace("position = [4, 0]", "position = [5, 0]")).unwrap();
    // A file in the place of the folder.
    fs::write(here.join("drift"), "mine").unwrap();
    let got = check(&["-o", "drift"]);
    assert_eq!(got.code, Some(74));
    assert!(!got.out.contains("drift/s.png: on disk") && !got.out.contains("all of it"), "{}", got.out);
    // A folder in the place of a figure.
    fs::remove_file(here.join("s.png")).unwrap();
    fs::create_dir_all(here.join("s.png/x")).unwrap();
    let got = check(&["--accept"]);
    assert_eq!(got.code, Some(74));
    assert!(got.out.contains("1 stale, 0 missing, 1 error, accepted\n"), "{}", got.out);
}
