//! `--motion`: which files a figure that plays becomes, and what they hold.

use std::fs;
use std::path::Path;

use crate::render::{names, set};
use crate::{CIRCLES, Ran, folder_with, run, tracefig};

/// Two discs that meet, at the hit.
const MEET: &str = "canvas = { width = 300 }\n\
    shapes.A = { kind = 'circle', radius = 1, velocity = [8, 0] }\n\
    shapes.B = { kind = 'circle', radius = 1, position = [6, 0] }\n\
    query = { kind = 'linear-sweep', of = ['A', 'B'] }\n\
    panels = [{ time = 'hit', view = [-2, -2, 8, 2], layers = ['shapes', 'contact'] }]\n";

fn render(folder: &Path, arguments: &[&str]) -> Ran {
    run(tracefig(folder).args(["render", "s.toml"]).args(arguments))
}

/// The times of the pictures of a GIF, in hundredths of a second.
fn delays(gif: &[u8]) -> Vec<u16> {
    // Extension, graphic control, four bytes, how the frame is left, two bytes of hundredths.
    let controls = gif.windows(7).filter(|part| part[..3] == [0x21, 0xF9, 4] && part[6] < 3);
    controls.map(|part| u16::from_le_bytes([part[4], part[5]])).collect()
}

#[test]
fn formats_that_play_are_the_default_and_of_others_each_picture_is_a_file() {
    let folder = folder_with("s.toml", MEET);
    let ran = render(folder.path(), &["--motion", "--frames", "3", "--scale", "1"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_eq!(ran.out, "s.motion.apng\ns.motion.gif\n");
    let few = ["--motion", "--frames", "3", "--scale", "1"];
    let ran = render(folder.path(), &[&few[..], &["--format", "svg", "-o", "a"]].concat());
    assert_eq!(ran.out, "a/s.frame-01.svg\na/s.frame-02.svg\na/s.frame-03.svg\n");
    let ran = render(folder.path(), &[&few[..], &["-o", "x.gif"]].concat());
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "x.gif\n"));
    let [named, own] = ["x.gif", "s.motion.gif"].map(|name| fs::read(folder.path().join(name)).unwrap());
    assert!(named == own, "the same bytes again");
    assert_eq!(names(folder.path()), set(&["a", "s.motion.apng", "s.motion.gif", "s.toml", "x.gif"]));
}

#[test]
fn the_last_picture_is_the_figure_and_stays() {
    let folder = folder_with("s.toml", MEET);
    let more = ["--motion", "--frames", "4", "--fps", "10", "--hold", "3", "--scale", "0.5"];
    assert_eq!(render(folder.path(), &[&more[..], &["-o", "x.gif"]].concat()).code, Some(0));
    assert_eq!(delays(&fs::read(folder.path().join("x.gif")).unwrap()), [10, 10, 10, 300]);
    assert_eq!(render(folder.path(), &["--format", "svg"]).code, Some(0));
    let frames = ["--motion", "--frames", "4", "--format", "svg"];
    assert_eq!(render(folder.path(), &frames).code, Some(0));
    let body = |name: &str| {
        let text = fs::read_to_string(folder.path().join(name)).unwrap();
        let id = text.split("aria-labelledby=\"").nth(1).unwrap().split('-').next().unwrap().to_owned();
        text.split_once("</metadata>").unwrap().1.replace(&id, "id")
    };
    assert!(body("s.frame-04.svg") == body("s.svg"));
    assert!(body("s.frame-01.svg") != body("s.svg"));
}

#[test]
fn an_option_that_gets_a_number_below_0_says_what_it_takes() {
    let folder = folder_with("s.toml", MEET);
    for (option, takes) in [("--hold", "above 0 and up to 600"), ("--scale", "above 0 and up to 8")] {
        let ran = render(folder.path(), &["--motion", option, "-1"]);
        assert_eq!(ran.code, Some(2));
        assert!(ran.err.contains(takes) && !ran.err.contains("-- -1"), "{}", ran.err);
    }
}

#[test]
fn what_does_not_play_is_drawn_still_with_a_note_and_beside_what_plays() {
    let folder = folder_with("s.toml", &format!("{CIRCLES}[canvas]\nwidth = 300\n"));
    fs::write(folder.path().join("m.toml"), MEET).unwrap();
    let ran = render(folder.path(), &["m.toml", "--motion", "--frames", "3", "--format", "gif"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "s.motion.gif\nm.motion.gif\n"));
    assert!(ran.err.contains("note[nothing-plays]") && ran.err.contains("no body moves"), "{}", ran.err);
    assert_eq!(delays(&fs::read(folder.path().join("s.motion.gif")).unwrap()), [200]);
}

#[test]
fn check_says_that_a_motion_is_the_same_and_when_it_is_another() {
    let folder = folder_with("s.toml", MEET);
    let few = ["--motion", "--frames", "3", "--scale", "0.5"];
    assert_eq!(render(folder.path(), &few).code, Some(0));
    let check = |more: &[&str]| run(tracefig(folder.path()).args(["check", "s.toml"]).args(few).args(more));
    assert!(check(&[]).out.ends_with("2 identical, 0 changed, 0 missing\n"));
    // Another time of each picture is another file, of other options; later pictures count as the first does.
    let stale = check(&["--fps", "5"]);
    assert_eq!(stale.code, Some(1), "{}", stale.out);
    assert!(stale.out.contains("2 stale") && stale.out.contains("differ from byte"), "{}", stale.out);
    let same = render(folder.path(), &[&few[..], &["--skip-unchanged"]].concat());
    assert_eq!((same.code, same.out.as_str()), (Some(0), ""));
}

#[test]
fn a_motion_is_no_figure_in_steps_and_has_pictures_within_limits() {
    let folder = folder_with("s.toml", MEET);
    for wrong in [
        &["--motion", "--steps"][..],
        &["--motion", "--live"],
        &["--motion", "--words"],
        &["--motion", "--fragments"],
        &["--steps", "--frames", "3"],
        &["--frames", "3"],
        &["--hold", "1"],
        &["--motion", "--frames", "1"],
        &["--motion", "--frames", "601"],
        &["--motion", "--fps", "51"],
        &["--motion", "--fps", "nan"],
    ] {
        assert_eq!(render(folder.path(), wrong).code, Some(2), "{wrong:?}");
    }
    let large = MEET.replace("width = 300", "width = 3000, height = 2000");
    fs::write(folder.path().join("s.toml"), large).unwrap();
    let ran = render(folder.path(), &["--motion", "--frames", "100", "--format", "gif"]);
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    assert!(ran.err.contains("100 pictures of that size are more than 2^30 dots: take fewer"), "{}", ran.err);
}
