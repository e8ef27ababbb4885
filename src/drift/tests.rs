//! Figures drifted on purpose, of each kind, and what is said of them.

use std::fs;

use super::*;
use crate::drawing::Drawing;
use crate::figure::{draw, plan, theme};
use crate::output::{Options, Pixels, Writer, format, rasterize};
use crate::scene::open_text;

const SCENE: &str = r#"
    title = "Two bodies"
    caption = "How far $A$ is from $B$."
    [shapes.A]
    kind = "box"
    half_extents = [1.0, 0.5]
    angle_deg = 20
    [shapes.B]
    kind = "polygon"
    vertices = [[2, 0], [4, -1], [4, 1]]
    [query]
    kind = "separation"
    of = ["A", "B"]
    algorithm = "minkowski"
    [[panels]]
    title = "World"
    space = "world"
    view = [-2, -2, 5, 2]
    layers = ["shapes", "separation", "normal"]
    [[panels]]
    title = "Configuration"
    space = "configuration"
    view = [-2, -2, 6, 2]
    layers = ["difference", "origin", "closest"]
"#;

fn svg_format() -> &'static Format {
    format("svg").unwrap()
}

fn written(drawing: &Drawing) -> Vec<u8> {
    let Writer::One(write) = svg_format().write else { panic!("SVG takes one drawing") };
    write(drawing, &Options::default()).unwrap()
}

fn drawn(scene: &str, theme_name: &str) -> (Drawing, Vec<u8>) {
    let scene = open_text("s.toml", scene).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let mut drawing = draw(&plan, theme::find(theme_name).unwrap(), "s").drawing;
    drawing.metadata = metadata("00", &facts(&plan));
    let bytes = written(&drawing);
    (drawing, bytes)
}

fn shown_by(svg: &[u8]) -> Option<Drawing> {
    match shows(svg_format(), svg).ok()? {
        Picture::Drawing { drawing, .. } => Some(*drawing),
        Picture::Image(_) => None,
    }
}

fn svg(scene: &str) -> Vec<u8> {
    drawn(scene, "light").1
}

#[test]
fn words_that_nobody_sees_are_compared_and_may_not_be_shown() {
    let new = String::from_utf8(svg(SCENE)).unwrap();
    let at = new.find("<text ").unwrap();
    let open = at + new[at..].find('>').unwrap();
    let (old, seen) = (
        format!("{}>Anything {}", &new[..open], &new[open + 1..]),
        format!("{} fill=\"red\"{}", &new[..open], &new[open..]),
    );
    let told = what_moved(svg_format(), old.as_bytes(), new.as_bytes());
    says(&told, "words that are found: reads `");
    says(&told, "was `Anything ");
    let rendered = Rendered { format: svg_format(), bytes: new.as_bytes(), scale: 1.0 };
    let State::Changed(change) = compare(Some(old.as_bytes()), rendered) else { panic!("other words") };
    assert!(change.pixels().is_none() && !change.is_within(255));
    let State::Changed(change) = compare(Some(seen.as_bytes()), rendered) else { panic!("words in ink") };
    assert!(matches!(change, Change::Line(_)), "{change:?}");
    assert_eq!(shown_by(new.replacen(" fill=\"none\"", " fill=\"red\"", 1).as_bytes()), None);
}

#[test]
fn what_no_pixel_shows_is_within_no_tolerance() {
    let new = String::from_utf8(svg(SCENE)).unwrap();
    let rendered = Rendered { format: svg_format(), bytes: new.as_bytes(), scale: 1.0 };
    let sheet = &new[new.find("<style>").unwrap()..new.find("</style>").unwrap()];
    let dashes = format!(" stroke-dasharray=\"{}\" stroke-width=\"", "1 ".repeat(9));
    for (there, instead) in [
        ("</style>", "</style><style>*{display:none}</style>"),
        ("<svg ", "<svg style=\"display:none\" "),
        ("<svg ", "<svg onload=\"alert(1)\" "),
        ("<svg ", "<svg lang=\"de\" "),
        ("<svg ", "<svg xml:lang=\"de\" "),
        ("stroke-linejoin=\"round\"", "stroke-linejoin=\"bevel\""),
        ("</defs>", "<script>alert(1)</script></defs>"),
        ("</defs>", "<path id=\"other\" d=\"M0 0\" style=\"fill:red\"/></defs>"),
        ("<title ", "<title onclick=\"alert(1)\" "),
        ("aria-label=\"", "aria-label=\"not "),
        (" stroke-width=\"", &dashes),
        (sheet, "<style>*{display:none}"),
    ] {
        let old = new.replacen(there, instead, 1);
        assert_ne!(old, new, "{there}");
        let State::Changed(change) = compare(Some(old.as_bytes()), rendered) else { panic!("{instead}") };
        assert!(!change.is_within(255), "{instead}: {change:?}");
    }
    let old = new.replacen("aria-label=\"", "aria-label=\"not ", 1);
    says(&what_moved(svg_format(), old.as_bytes(), new.as_bytes()), "words for a screen reader: reads `");
}

/// What a changed scene makes `check` say of its SVG.
fn said(changed: &str) -> Vec<String> {
    what_moved(svg_format(), &svg(SCENE), &svg(changed))
}

fn says(lines: &[String], what: &str) {
    assert!(lines.iter().any(|line| line.contains(what)), "{what}: {lines:#?}");
}

/// Mean difference of two drawings' channels, in levels of 255, over the pixels that are not as the page.
fn levels_apart(a: &Drawing, b: &Drawing, scale: f64) -> f64 {
    let (a, b) = (rasterize(a, scale).unwrap(), rasterize(b, scale).unwrap());
    let pixels = |image: &Pixels| image.rgba.chunks_exact(4).map(<[u8]>::to_vec).collect::<Vec<_>>();
    let (a, b) = (pixels(&a), pixels(&b));
    let page = a[0].clone();
    let drawn: Vec<_> = a.iter().zip(&b).filter(|(a, b)| **a != page || **b != page).collect();
    let apart =
        |(a, b): &(&Vec<u8>, &Vec<u8>)| a.iter().zip(*b).map(|(a, b)| u64::from(a.abs_diff(*b))).sum::<u64>();
    #[expect(clippy::cast_precision_loss, reason = "a sum over an image")]
    let mean = drawn.iter().map(apart).sum::<u64>() as f64 / (4 * drawn.len()) as f64;
    mean
}

#[test]
fn every_figure_of_every_theme_is_read_again_as_what_it_shows() {
    let mut figures: Vec<_> = fs::read_dir("figures").unwrap().map(|e| e.unwrap().path()).collect();
    figures.retain(|path| path.extension().is_some_and(|e| e == "toml"));
    assert!(figures.len() > 15, "{figures:?}");
    for path in figures {
        let scene = fs::read_to_string(&path).unwrap();
        for theme in theme::THEMES {
            let (drawing, bytes) = drawn(&scene, theme.name);
            let place = format!("{} in {}", path.display(), theme.name);
            let again = shown_by(&bytes).unwrap_or_else(|| panic!("{place} is read"));
            assert_eq!((&again.title, &again.desc), (&drawing.title, &drawing.desc), "{place}");
            // Coordinates are rounded to hundredths, so pixels along edges differ by some levels: an edge
            // near a row of the rasterizer's samples goes to its other side, a quarter of a pixel. Most edges
            // are those of letters: 0.5 to 1 of what is drawn, 2.7 where much of it is dots.
            let mean = levels_apart(&drawing, &again, 1.0);
            assert!(mean < 3.0, "{place}: {mean}");
            // Once texts are outlines, names those of ids and widths of halos rounded, another round loses
            // nothing.
            let round = |drawing: &Drawing| shown_by(&written(drawing)).unwrap();
            let twice = round(&again);
            assert_eq!(seen(&twice, &round(&twice)), Vec::<String>::new(), "{place}");
        }
    }
}

#[test]
fn a_moved_vertex_is_said_in_numbers_and_as_seen() {
    let lines = said(&SCENE.replace("[2, 0], [4, -1]", "[2.5, 0], [4, -1]"));
    says(&lines, "separation: ");
    says(&lines, "difference edge 2 of B: to (");
    says(&lines, "body-B in panel-1: 1 of 3 points moved, by ");
    assert!(lines.iter().all(|line| !line.contains("body-A")), "{lines:#?}");
}

#[test]
fn a_moved_body_is_moved_as_a_whole() {
    let lines = said(&SCENE.replace("[[2, 0], [4, -1], [4, 1]]", "[[2.5, 0], [4.5, -1], [4.5, 1]]"));
    says(&lines, "body-B in panel-1: moved by (");
}

#[test]
fn another_caption_and_title_are_quoted() {
    let lines = said(&SCENE.replace("How far", "How near").replace("Two bodies", "Two shapes"));
    says(&lines, "title: reads `Two shapes");
    says(&lines, "caption: reads `How near A is from B.`, was `How far A is from B.`");
    assert!(lines.iter().all(|line| !line.contains("body-")), "{lines:#?}");
}

#[test]
fn another_theme_is_a_line_a_colour() {
    let lines = what_moved(svg_format(), &svg(SCENE), &drawn(SCENE, "dark").1);
    says(&lines, "page: colour of background #ffffff → #12161c");
    says(&lines, "colour of a #bc0d2a → #ff6b57");
    says(&lines, "fill opacity 0.2 → 0.24");
    says(&lines, "label-A in panel-1: colour of a tint #eac8d0 → #4f3031");
    says(&lines, "style sheet");
}

#[test]
fn a_background_that_comes_or_goes_is_said() {
    let clear = svg(&SCENE.replace("[query]", "[canvas]\nbackground = \"transparent\"\n[query]"));
    let gone = what_moved(svg_format(), &svg(SCENE), &clear);
    says(&gone, "page: no background any more");
    says(&what_moved(svg_format(), &clear, &svg(SCENE)), "page: a background, where there was none");
    assert!(gone.iter().all(|line| !line.contains("label-") && !line.contains("body-A:")), "{gone:#?}");
}

#[test]
fn another_layer_is_new_and_gone() {
    let more = SCENE
        .replace("\"normal\"]", "\"normal\", \"velocity\"]")
        .replace("half_extents", "velocity = [1, 0]\nhalf_extents");
    says(&said(&more), "velocity");
    let lines = what_moved(svg_format(), &svg(&more), &svg(SCENE));
    assert!(lines.iter().any(|l| l.contains("velocity") && l.ends_with(": gone")), "{lines:#?}");
}

#[test]
fn a_colour_changed_by_hand_has_its_levels() {
    let new = svg(SCENE);
    // So little darker that no pixel's contrast passes one at which its levels of coverage become others.
    let old = String::from_utf8(new.clone()).unwrap().replace("=\"#bc0d2a\"", "=\"#b90d2a\"");
    let rendered = Rendered { format: svg_format(), bytes: &new, scale: 1.0 };
    let State::Changed(change) = compare(Some(old.as_bytes()), rendered) else { panic!("changed") };
    let drift = change.pixels().unwrap();
    assert_eq!((drift.worst, change.is_within(2), change.is_within(3)), (3, false, true));
    says(&what_moved(svg_format(), old.as_bytes(), &new), "colour of a #b90d2a → #bc0d2a");
    assert!(triptych(svg_format(), old.as_bytes(), &new, 1.0).is_some());
}

#[test]
fn what_no_eye_sees_is_within_a_tolerance_and_what_is_not_ours_within_none() {
    let new = svg(SCENE);
    let text = String::from_utf8(new.clone()).unwrap();
    let change = |old: &str| {
        let rendered = Rendered { format: svg_format(), bytes: &new, scale: 1.0 };
        match compare(Some(old.as_bytes()), rendered) {
            State::Changed(change) => change,
            other => panic!("{other:?}"),
        }
    };
    let unseen = change(&text.replacen("\"trace\":[", "\"trace\": [", 1));
    assert!(matches!(unseen, Change::Picture { pixels: None, .. }), "{unseen}");
    assert!(!unseen.is_within(0) && unseen.is_within(1), "{unseen}");
    assert!(!change(&text.replacen("Two bodies", "Two cats", 1)).is_within(255), "words are not pixels");
    assert!(!change(&text.replacen("@media all", "@media print", 1)).is_within(255), "nor are rules");
    assert!(triptych(svg_format(), text.replacen('[', " [", 1).as_bytes(), &new, 1.0).is_none());
    for edited in [
        text.replacen("<path", "<path style=\"display:none\"", 1),
        text.replacen("<circle", "<ellipse", 1),
        text.replacen("</svg>", "<script/></svg>", 1),
    ] {
        let edited = change(&edited);
        assert!(matches!(edited, Change::Line(_)) && !edited.is_within(255), "{edited}");
    }
}

/// An animation of drawings.
fn played(drawings: &[&Drawing]) -> Vec<u8> {
    let Writer::Sequence(write) = format("apng").unwrap().write else { panic!("APNG takes drawings") };
    write(drawings, &Options { scale: 0.5, ..Options::default() }).unwrap()
}

#[test]
fn every_picture_of_an_animation_is_compared() {
    let (a, _) = drawn(SCENE, "light");
    let (b, _) = drawn(&SCENE.replace("[2, 0], [4, -1]", "[2.5, 0], [4, -1]"), "light");
    let change = |old: &[&Drawing], new: &[&Drawing]| {
        let (old, new) = (played(old), played(new));
        let now = Rendered { format: format("apng").unwrap(), bytes: &new, scale: 0.5 };
        match compare_and_show(Some(&old), now) {
            (State::Changed(change), triptych) => (change, triptych.is_some()),
            other => panic!("{other:?}"),
        }
    };
    let (Change::Pixels(drift), true) = change(&[&a, &a, &a, &b], &[&a, &b, &b, &b]) else { panic!("seen") };
    assert_eq!(drift.pictures, Some(PictureDrift { differ: 2, first: 2, of: 4, play_alike: true }));
    assert!(drift.to_string().ends_with("; in 2 of 4 pictures, number 2 is the first"), "{drift}");
    assert!(drift.is_within(255) && !drift.is_within(drift.worst - 1));
    // What differs in the first picture alone is half of what differs in the first and the last one.
    let (Change::Pixels(first), true) = change(&[&a, &a, &a], &[&b, &a, &a]) else { panic!("seen") };
    let (Change::Pixels(both), true) = change(&[&a, &a, &a], &[&b, &a, &b]) else { panic!("seen") };
    assert_eq!((2 * first.changed, first.area), (both.changed, both.area));
    // More pictures are no matter of tolerance, whether the first ones differ or not.
    let (Change::Pixels(longer), true) = change(&[&a, &a], &[&b, &a, &a]) else { panic!("seen") };
    assert!(!longer.is_within(255) && longer.to_string().ends_with("they are not played alike"), "{longer}");
    assert!(matches!(change(&[&a, &a], &[&a, &a, &a]), (Change::Bytes { .. }, false)));
}
