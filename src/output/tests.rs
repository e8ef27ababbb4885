//! The SVG and the PNG of one drawing say the same: resvg, which shares no code with our way from display
//! list to document, is the witness that the document says it. It is no witness of pixels, as its coverage is
//! tiny-skia's too: those are held against Chromium.

use super::samples::everything;
use super::svg::{Sheet, document};
use super::*;
use crate::drawing::{Color, Dark, Item, Point, Role, Text};

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sizes of test images")]
/// Pixels of a document by resvg.
fn witness(svg: &str, scale: f32) -> Vec<u8> {
    let tree = resvg::usvg::Tree::from_str(svg, &resvg::usvg::Options::default()).unwrap();
    let (w, h) = (tree.size().width() * scale, tree.size().height() * scale);
    let mut pixmap = resvg::tiny_skia::Pixmap::new(w.round() as u32, h.round() as u32).unwrap();
    resvg::render(&tree, resvg::tiny_skia::Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    pixmap.take()
}

#[expect(clippy::cast_precision_loss, reason = "sums over test images")]
/// Mean and largest difference of the channels.
fn difference(a: &[u8], b: &[u8]) -> (f64, u8) {
    assert_eq!(a.len(), b.len());
    let each = || a.iter().zip(b).map(|(x, y)| x.abs_diff(*y));
    let sum: u64 = each().map(u64::from).sum();
    (sum as f64 / a.len() as f64, each().max().unwrap_or(0))
}

/// Pictures for the eye, where the environment asks for them.
fn keep(name: &str, bytes: &[u8]) {
    if let Ok(folder) = std::env::var("TRACEFIG_KEEP") {
        std::fs::write(std::path::Path::new(&folder).join(name), bytes).unwrap();
    }
}

#[test]
fn svg_and_png_show_the_same() {
    let drawing = everything();
    let svg = document(&drawing, Sheet::Inside);
    keep("sample.svg", svg.as_bytes());
    let Writer::One(write) = pdf::FORMAT.write else { panic!("PDF takes one drawing") };
    keep("sample.pdf", &write(&drawing, &Options::default()).unwrap());
    let Writer::One(write) = png::FORMAT.write else { panic!("PNG takes one drawing") };
    keep("sample.png", &write(&drawing, &Options::default()).unwrap());
    for scale in [1.0_f32, 2.0] {
        let pixels = rasterize(&drawing, f64::from(scale)).unwrap();
        let (mean, most) = difference(&pixels.rgba, &witness(&svg, scale));
        println!("scale {scale}: mean {mean}, most {most}, {} bytes of SVG", svg.len());
        // Both take 4 × 4 samples a pixel, but we round places to the image and glyphs to eighths of a pixel,
        // and mix few levels: along an edge that differs by up to an eighth of the contrast, where edges meet
        // in a pixel by two eighths, and half a level of ours comes on top.
        assert!(mean < 0.4, "mean {mean} at {scale}");
        assert!(most < 100, "most {most} at {scale}");
    }
    assert!(svg.len() < 40_000, "{} bytes", svg.len());
}

#[test]
fn a_page_without_a_background_is_seen_through_and_reads_back_as_it_was() {
    let mut drawing = everything();
    drawing.background = drawing.background.with_opacity(0.0);
    let svg = document(&drawing, Sheet::Inside);
    for scale in [1.0_f32, 2.0] {
        let pixels = rasterize(&drawing, f64::from(scale)).unwrap();
        assert_eq!(pixels.rgba[..4], [0; 4], "a corner of the page");
        // The witness multiplies colours by their opacity.
        let weighted = |p: &[u8]| [p[0], p[1], p[2]].map(|c| u16::from(c) * u16::from(p[3]) / 255);
        let ours = pixels.rgba.chunks_exact(4).flat_map(|p| {
            let [r, g, b] = weighted(p).map(|c| u8::try_from(c).unwrap());
            [r, g, b, p[3]]
        });
        let (o, w) = (ours.collect::<Vec<_>>(), witness(&svg, scale));
        let (mean, most) = difference(&o, &w);
        assert!(mean < 0.4, "mean {mean} at {scale}");
        // Edges of halos are seen here; glyphs of halos are cached at coarser places than those of letters.
        assert!(most < 200, "most {most} at {scale}");
    }
    // Many colours become pixels, few a palette; a file says the same either way.
    for scale in [0.5, 2.0] {
        let options = Options { scale, ..Options::default() };
        let rows = |picture: &Picture| {
            let (mut rows, mut row, mut all) = (picture.rows(scale).unwrap(), Vec::new(), Vec::new());
            while rows.next_into(&mut row) {
                all.extend_from_slice(&row);
            }
            all.into_flattened()
        };
        let expected = rasterize(&drawing, scale).unwrap().rgba;
        for format in [png::FORMAT, apng::FORMAT] {
            let file = match format.write {
                Writer::One(write) => write(&drawing, &options).unwrap(),
                Writer::Sequence(write) => write(&[&drawing], &options).unwrap(),
            };
            let read = format.read.unwrap().picture.unwrap()(&file).unwrap();
            assert!(rows(&read) == expected, "{} at {scale}", format.name);
        }
    }
    let read = svg::FORMAT.read.unwrap().picture.unwrap()(svg.as_bytes()).unwrap();
    let Picture::Drawing { drawing: read, .. } = read else { panic!("an SVG is a drawing") };
    assert!(read.is_transparent());
}

#[test]
fn without_its_style_sheet_an_svg_has_the_same_pixels() {
    let mut drawing = everything();
    let colors = vec![(Role::A, Color::hex(0xFF_6B_57))];
    let words = vec![(Role::Translation, Color::hex(0xC0_D0_FF))];
    drawing.words.clone_from(&words);
    drawing.dark = Some(Dark { colors, ink: Color::hex(0xE8_EA_ED), words, fill_opacity: 0.2 });
    let (with, without) = (document(&drawing, Sheet::Inside), document(&drawing, Sheet::Absent));
    assert_ne!(with, without);
    let words = ".sample-words-translation{fill:var(--tracefig-words-translation,\
                 var(--tracefig-translation,#0b5fcc))}";
    assert!(with.contains(words) && with.contains(",#c0d0ff))}"), "words follow the page, and the dark");
    assert_eq!(witness(&with, 1.0), witness(&without, 1.0));
}

#[test]
fn an_svg_is_valid_names_itself_and_has_no_id_twice() {
    let drawing = everything();
    let svg = document(&drawing, Sheet::Inside);
    let parsed = roxmltree::Document::parse(&svg).unwrap();
    let root = parsed.root_element();
    assert_eq!(root.attribute("role"), Some("img"));
    let first = root.children().find(roxmltree::Node::is_element).unwrap();
    assert_eq!((first.tag_name().name(), first.text()), ("title", Some(drawing.title.as_str())));
    let mut ids = std::collections::BTreeSet::new();
    for node in parsed.descendants().filter(roxmltree::Node::is_element) {
        if let Some(id) = node.attribute("id") {
            assert!(id.starts_with("sample"), "{id}");
            assert!(ids.insert(id), "{id} twice");
        }
        assert!(!["script", "image", "foreignObject", "a"].contains(&node.tag_name().name()));
        for attribute in node.attributes() {
            assert!(!attribute.value().contains("var("), "var() outside the sheet");
            assert!(!attribute.value().contains("http"), "nothing from elsewhere");
        }
    }
    for reference in
        parsed.descendants().filter_map(|n| n.attribute(("http://www.w3.org/1999/xlink", "href")))
    {
        assert!(ids.contains(reference.trim_start_matches('#')), "{reference}");
    }
    for id in root.attribute("aria-labelledby").unwrap().split(' ') {
        assert!(ids.contains(id));
    }
}

#[test]
fn no_text_of_a_scene_becomes_markup() {
    let nasty = "</title><script>alert(1)</script>\"' onload=\"x";
    let mut drawing = everything();
    drawing.title = nasty.into();
    drawing.desc = nasty.into();
    drawing.metadata = nasty.into();
    drawing.id = nasty.into();
    if let Item::Group(group) = &mut drawing.items[0] {
        group.name = nasty.into();
        group.label = Some(nasty.into());
    }
    let svg = document(&drawing, Sheet::Inside);
    let parsed = roxmltree::Document::parse(&svg).unwrap();
    for node in parsed.descendants().filter(roxmltree::Node::is_element) {
        assert_ne!(node.tag_name().name(), "script");
        assert!(node.attributes().all(|a| !a.name().starts_with("on")));
    }
    assert!(parsed.descendants().any(|n| n.attribute("aria-label") == Some(nasty)), "kept as text");
}

#[test]
fn a_drawing_gives_the_same_bytes_again() {
    let (first, again) = (everything(), everything());
    for format in FORMATS {
        let bytes = |drawing| match format.write {
            Writer::One(write) => write(drawing, &Options::default()).unwrap(),
            Writer::Sequence(write) => write(&[drawing], &Options::default()).unwrap(),
        };
        assert!(bytes(&first) == bytes(&again), "{}", format.name);
    }
}

#[test]
fn too_many_pixels_are_refused_and_the_scale_that_fits_is_named() {
    let drawing = everything();
    let Err(OutputError::TooLarge { largest, .. }) = rasterize(&drawing, 12.0) else { panic!("drawn") };
    assert!((largest - 11.37).abs() < 0.01, "{largest}");
    assert!(960.0 * largest * 540.0 * largest <= MOST_PIXELS);
    assert!(matches!(rasterize(&drawing, 0.0001), Err(OutputError::Empty { .. })));
    assert!(matches!(rasterize(&drawing, f64::NAN), Err(OutputError::Empty { .. })));
}

#[test]
fn a_place_that_is_no_number_is_an_error_that_names_its_group() {
    let mut drawing = everything();
    let Item::Group(labels) = &mut drawing.items[5] else { panic!("labels are sixth") };
    let Item::Text(text) = &labels.items[0] else { panic!("a label") };
    labels.items.push(Item::Text(Text { origin: Point::new(f64::NAN, 0.0), ..text.clone() }));
    let error = rasterize(&drawing, 1.0).unwrap_err();
    assert_eq!(error, OutputError::NotFinite { outer: "labels".into(), group: "labels".into() });
}

#[test]
fn a_step_that_is_a_file_of_its_own_has_what_later_steps_take_away() {
    let mut whole = everything();
    let Item::Group(labels) = &mut whole.items[5] else { panic!("labels are sixth") };
    let Item::Text(text) = labels.items[0].clone() else { panic!("a label") };
    let shown = crate::drawing::Shown { since: 1, until: Some(3) };
    labels.items.push(Item::Text(Text { shown, origin: Point::new(300.0, 300.0), ..text }));
    let options = Options { scale: 0.5, ..Options::default() };
    for name in ["svg", "png", "pdf"] {
        let format = format(name).unwrap();
        let [first, last] = [1, 3].map(|step| format.encode(&whole.at_step(step), &options).unwrap());
        assert!(first != last, "{name}");
        assert!(format.encode(&whole, &options).unwrap() == last, "{name}: the file is the finished figure");
    }
}
