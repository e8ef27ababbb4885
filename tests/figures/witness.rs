//! The SVG of every figure says what its PNG shows: resvg draws the one and we the other. And a renderer that
//! ignores style sheets sees the same picture.
//!
//! What is witnessed is the document: that every path, colour, clip, pattern and glyph is in it, where it
//! belongs. The pixels are not, as resvg finds coverage by tiny-skia as we do; their witness is Chromium, in
//! `.ci/browser`.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic wherever it is")]

use std::path::PathBuf;

use tracefig::drawing::Drawing;
use tracefig::figure::theme::find;
use tracefig::figure::{draw, plan};
use tracefig::output::{Options, Writer, format, rasterize};

/// Mean difference of the channels, in levels of 255, over the whole page. We mix sixteen levels of coverage
/// and fewer where the contrast is low, resvg all, and our glyphs stand at eighths of a pixel. That is 0.06
/// to 0.17 in the light theme, and 0.12 to 0.60 in print, where hatching makes edges everywhere.
const MEAN: f64 = 1.0;

/// Share of the channels that may differ by more than [`FAR`] levels: single pixels where several edges meet.
/// The most is 5.5e-5; with glyphs at quarters of a pixel it is 2.04e-4.
const SHARE: f64 = 2e-4;

/// A difference that rounding does not explain at one edge: a quarter of the contrast.
const FAR: u8 = 64;

/// Page pixels to image pixels: the page's own size is the hardest, as every edge counts most there.
const SCALE: f32 = 1.0;

fn scenes() -> Vec<PathBuf> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut scenes: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    scenes.sort();
    scenes
}

fn written(drawing: &Drawing, name: &str) -> Vec<u8> {
    let Writer::One(write) = format(name).unwrap().write else { panic!("{name} takes one drawing") };
    write(drawing, &Options::default()).unwrap()
}

fn svg(drawing: &Drawing) -> String {
    String::from_utf8(written(drawing, "svg")).unwrap()
}

fn seen(svg: &str) -> Vec<u8> {
    let tree = resvg::usvg::Tree::from_str(svg, &resvg::usvg::Options::default()).unwrap();
    let size = tree.size().to_int_size();
    let mut pixmap = resvg::tiny_skia::Pixmap::new(size.width(), size.height()).unwrap();
    resvg::render(&tree, resvg::tiny_skia::Transform::from_scale(SCALE, SCALE), &mut pixmap.as_mut());
    pixmap.take()
}

/// The document without its style sheet.
fn without_sheet(svg: &str) -> String {
    let (start, end) = (svg.find("<style>").unwrap(), svg.find("</style>").unwrap());
    format!("{}{}", &svg[..start], &svg[end + "</style>".len()..])
}

/// A renderer that ignores style sheets sees the same picture.
fn compare_sheet(name: &str, drawing: &Drawing, faults: &mut Vec<String>) {
    let svg = svg(drawing);
    if seen(&without_sheet(&svg)) != seen(&svg) {
        faults.push(format!("{name}: the style sheet changes the picture"));
    }
}

fn compare(name: &str, drawing: &Drawing, faults: &mut Vec<String>) {
    let svg = svg(drawing);
    let theirs = seen(&svg);
    let ours = rasterize(drawing, f64::from(SCALE)).unwrap().rgba;
    assert_eq!(ours.len(), theirs.len(), "{name}");
    let differences = || ours.iter().zip(&theirs).map(|(a, b)| a.abs_diff(*b));
    let count = f64::from(u32::try_from(ours.len()).unwrap());
    let mean = differences().map(f64::from).sum::<f64>() / count;
    let far = differences().filter(|&d| d > FAR).map(|_| 1.0).sum::<f64>() / count;
    if mean > MEAN || far > SHARE {
        faults.push(format!("{name}: mean {mean}, share of far {far}"));
    }
}

#[test]
fn svg_and_png_of_every_figure_show_the_same() {
    let mut faults = Vec::new();
    for path in scenes() {
        let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
        let file =
            tracefig::scene::open(&path).unwrap_or_else(|refused| panic!("{stem}: {:?}", refused.problems));
        let plan = plan(&file.scene).unwrap();
        // Dark differs from light in colours alone; auto has the longest style sheet.
        for (theme, check) in
            [("light", compare as fn(&_, &_, &mut _)), ("print", compare), ("auto", compare_sheet)]
        {
            let figure = draw(&plan, find(theme).unwrap(), &stem);
            check(&format!("{stem} {theme}"), &figure.drawing, &mut faults);
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_figure_is_small() {
    for path in scenes() {
        let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
        // As committed, metadata and all.
        let svg = path.with_extension("svg").metadata().unwrap().len();
        // A third of it are outlines of letters; headline and coloured caption place some 500 of them.
        // Another twentieth is the text that is searched.
        // Six panels with a title each are the most that there are; a caption each adds a tenth.
        assert!(svg <= 88_000, "{stem}: {svg} bytes");
        // Demos have more edges than the article's figures.
        if !stem.starts_with('0') {
            continue;
        }
        let file =
            tracefig::scene::open(&path).unwrap_or_else(|refused| panic!("{stem}: {:?}", refused.problems));
        let plan = plan(&file.scene).unwrap();
        let drawing = draw(&plan, find("light").unwrap(), &stem).drawing;
        let png = written(&drawing, "png").len();
        // A grid, whose lines cross every row, is half of it; areas on a ground have more colours than a palette.
        assert!(png < 200_000, "{stem}: {png} bytes at 1920 × 1080");
    }
}
