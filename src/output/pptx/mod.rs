//! PPTX: a presentation, a slide for each figure or for each of its steps.
//!
//! Every slide holds its picture as SVG and as PNG ([`slide`]), on the colour of the figure's page, with a
//! title, an alternative text and notes that say what happens. There is no date and no random number in the
//! file; its hash stands in a part that is not packed. Masters and theme are files beside this one.
//! Source: ECMA-376-1:2016, *Office Open XML File Formats*, section 13.

mod parts;
mod slide;

use super::embedded::{image, mute};
use super::svg::{Sheet, document};
use super::xml::Xml;
use super::{
    Binder, Bracket, Depends, Format, IMAGE, INLINE, InSteps, Options, OutputError, Reader, Stamped, Writer,
    validity, zip,
};
use crate::drawing::{Drawing, Step};
use parts::{DECLARATION, Package, Relation, relations};
use slide::{SIZE, Slide, Title, hex};

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "pptx",
    about: "presentation: a slide a figure or a step, as SVG and PNG, with title, alt text and notes",
    media_type: "application/vnd.openxmlformats-officedocument.presentationml.presentation",
    usual: false,
    in_the_dark: false,
    depends: Depends::Packing,
    write: Writer::One(write),
    in_steps: Some(write_steps),
    in_motion: None,
    bind: Some(Binder::Slides(bound)),
    bracket: Bracket { begins: &[zip::BEGINS], ends: &[zip::ENDS] },
    // Its parts are packed, so files are compared byte by byte.
    read: Some(Reader { stamp, picture: None }),
    live: None,
};

/// What the kinds of the parts of a presentation begin with.
const PRESENTATION: &str = "application/vnd.openxmlformats-officedocument.presentationml";
/// The kind of a theme.
const THEME: &str = "application/vnd.openxmlformats-officedocument.theme+xml";
/// The kind of the part that says what a package is.
const CORE: &str = "application/vnd.openxmlformats-package.core-properties+xml";
/// The kind of relation to that part.
const CORE_RELATION: &str =
    "http://schemas.openxmlformats.org/package/2006/relationships/metadata/core-properties";
/// The element with the hash, and what it begins with.
const HASH: [&str; 2] = ["dc:identifier", "tracefig "];
/// The first number of a slide, as the format wants it.
const FIRST_SLIDE: usize = 256;
/// The relations of the presentation that come before those to slides: a master of slides, and one of notes.
const MASTERS: usize = 2;

/// The hash that a file says of itself.
fn stamp(bytes: &[u8]) -> Option<Stamped> {
    let [element, word] = HASH;
    let begin = format!("<{element}>{word}");
    let at = bytes.windows(begin.len()).position(|part| part == begin.as_bytes())? + begin.len();
    let end = at + bytes[at..].iter().position(|&byte| byte == b'<')?;
    Some(Stamped::Hash(std::str::from_utf8(&bytes[at..end]).ok()?.to_owned()))
}

fn write(drawing: &Drawing, options: &Options) -> Result<Vec<u8>, OutputError> {
    bound(&[drawing], &Options { steps: None, ..*options })
}

/// Writes a slide for each step.
fn write_steps(drawing: &Drawing, options: &Options, steps: InSteps) -> Result<Vec<u8>, OutputError> {
    bound(&[drawing], &Options { steps: Some(steps), ..*options })
}

/// Writes the slides of all drawings, one after the other.
fn bound(drawings: &[&Drawing], options: &Options) -> Result<Vec<u8>, OutputError> {
    drawings.iter().try_for_each(|drawing| validity::page(drawing))?;
    let slides: Vec<Slide<'_>> = drawings.iter().flat_map(|&drawing| slides(drawing, options)).collect();
    file(&slides, drawings, options)
}

/// The slides of a drawing: one for each step where that is asked for, else one for the figure.
fn slides<'d>(drawing: &'d Drawing, options: &Options) -> Vec<Slide<'d>> {
    if options.steps.is_none() || drawing.steps.is_empty() {
        return vec![Slide {
            drawing: mute(drawing).finished(),
            title: drawing.title.clone(),
            shown: Title::Unseen,
            alt: drawing.desc.clone(),
            notes: vec![&drawing.desc],
        }];
    }
    let whole = mute(drawing);
    let said = |Step { title, sentences }: &Step| {
        // One colon is enough.
        let end = if title.contains(':') { '.' } else { ':' };
        format!("{title}{end} {}", sentences.join(" "))
    };
    let of_step = |(number, step): (usize, &'d Step)| Slide {
        drawing: whole.at_step(number),
        // Several steps may be called the same, and slides are listed by their titles.
        title: format!("{number}. {}", step.title),
        shown: Title::Seen,
        alt: said(step),
        notes: step.sentences.iter().map(String::as_str).collect(),
    };
    (1..).zip(&drawing.steps).map(of_step).collect()
}

/// The kind of a part of a presentation.
fn kind(name: &str) -> String {
    format!("{PRESENTATION}.{name}+xml")
}

/// The whole file.
fn file(slides: &[Slide<'_>], drawings: &[&Drawing], options: &Options) -> Result<Vec<u8>, OutputError> {
    let mut package = Package::default();
    package.plain("docProps/core.xml", CORE, &core(drawings))?;
    let whole = [("officeDocument", "ppt/presentation.xml"), (CORE_RELATION, "docProps/core.xml")];
    package.references("", &relations(whole))?;
    let names = (1..=slides.len()).map(|number| format!("slides/slide{number}.xml"));
    let masters = ["slideMaster", "notesMaster"].map(|name| (name, format!("{name}s/{name}1.xml")));
    let shown = relations(masters.into_iter().chain(names.map(|name| ("slide", name))));
    package.part("ppt/presentation.xml", &kind("presentation.main"), &presentation(&shown), &shown)?;
    masters_and_themes(&mut package, drawings)?;
    for (number, slide) in (1..).zip(slides) {
        let [dots, lines] = [IMAGE, INLINE].map(|format| format!("media/image{number}.{}", format.name));
        package.file(&format!("ppt/{dots}"), &image(&slide.drawing, options)?)?;
        package.file(&format!("ppt/{lines}"), document(&slide.drawing, Sheet::Absent).as_bytes())?;
        let name = format!("slides/slide{number}.xml");
        let notes = format!("notesSlides/notesSlide{number}.xml");
        let up = |name: &str| format!("../{name}");
        let of_slide = relations([
            ("image", up(&dots)),
            ("image", up(&lines)),
            ("slideLayout", up("slideLayouts/slideLayout1.xml")),
            ("notesSlide", up(&notes)),
        ]);
        let text = slide.part([&of_slide[0], &of_slide[1]]);
        package.part(&format!("ppt/{name}"), &kind("slide"), &text, &of_slide)?;
        let of_notes =
            relations([("notesMaster", up("notesMasters/notesMaster1.xml")), ("slide", up(&name))]);
        package.part(&format!("ppt/{notes}"), &kind("notesSlide"), &slide.notes_part(), &of_notes)?;
    }
    let relations = "application/vnd.openxmlformats-package.relationships+xml";
    let endings = [("rels", relations), (IMAGE.name, IMAGE.media_type), (INLINE.name, INLINE.media_type)];
    package.finish(&endings)
}

/// Adds what slides and notes look like. Notes are on white paper, whatever the theme.
fn masters_and_themes(package: &mut Package, drawings: &[&Drawing]) -> Result<(), OutputError> {
    let colors = drawings.first().map(|drawing| [drawing.ink, drawing.background.color].map(hex));
    let of_paper = ["000000", "FFFFFF"].map(str::to_owned);
    let theme =
        |[ink, page]: &[String; 2]| include_str!("theme.xml").replace("{ink}", ink).replace("{page}", page);
    let of_slides = theme(&colors.unwrap_or(of_paper.clone()));
    package.part("ppt/theme/theme1.xml", THEME, &of_slides, &[])?;
    package.part("ppt/theme/theme2.xml", THEME, &theme(&of_paper), &[])?;
    let themes = [1, 2].map(|number| ("theme", format!("../theme/theme{number}.xml")));
    let [of_slides, of_notes] = themes;
    let master = include_str!("slide_master.xml");
    let of_master = relations([("slideLayout", "../slideLayouts/slideLayout1.xml".to_owned()), of_slides]);
    package.part("ppt/slideMasters/slideMaster1.xml", &kind("slideMaster"), master, &of_master)?;
    let layout = include_str!("slide_layout.xml");
    let of_layout = relations([("slideMaster", "../slideMasters/slideMaster1.xml")]);
    package.part("ppt/slideLayouts/slideLayout1.xml", &kind("slideLayout"), layout, &of_layout)?;
    let (name, notes) = ("ppt/notesMasters/notesMaster1.xml", include_str!("notes_master.xml"));
    package.part(name, &kind("notesMaster"), notes, &relations([of_notes]))
}

/// What the presentation is: its masters and its slides.
fn presentation(all: &[Relation]) -> String {
    let mut xml = Xml::default();
    slide::root(&mut xml, "p:presentation");
    let (masters, slides) = all.split_at(MASTERS.min(all.len()));
    let lists = [("p:sldMasterIdLst", "p:sldMasterId"), ("p:notesMasterIdLst", "p:notesMasterId")];
    for ((list, entry), relation) in lists.into_iter().zip(masters) {
        xml.start(list);
        xml.start(entry);
        if list == lists[0].0 {
            // Above the numbers of slides; those of its layouts follow it.
            xml.attribute("id", "2147483648");
        }
        xml.attribute("r:id", &relation.id);
        xml.end();
        xml.end();
    }
    xml.start("p:sldIdLst");
    for (number, relation) in (FIRST_SLIDE..).zip(slides) {
        xml.start("p:sldId");
        xml.attribute("id", &number.to_string());
        xml.attribute("r:id", &relation.id);
        xml.end();
    }
    xml.end();
    // Sheets of notes are 7½ by 10 inches.
    for (name, [width, height]) in [("p:sldSz", SIZE), ("p:notesSz", [6_858_000, 9_144_000])] {
        xml.start(name);
        xml.attribute("cx", &width.to_string());
        xml.attribute("cy", &height.to_string());
        xml.end();
    }
    format!("{DECLARATION}{}", xml.finish())
}

/// What the file says of itself: the titles of its drawings, and the hash where it shows but one.
fn core(drawings: &[&Drawing]) -> String {
    let mut xml = Xml::default();
    xml.start("cp:coreProperties");
    let space = "http://schemas.openxmlformats.org/package/2006/metadata/core-properties";
    xml.attribute("xmlns:cp", space);
    xml.attribute("xmlns:dc", "http://purl.org/dc/elements/1.1/");
    let titles: Vec<&str> = drawings.iter().map(|drawing| drawing.title.as_str()).collect();
    for (name, text) in [("dc:title", titles.join("; ").as_str()), ("dc:creator", "tracefig")] {
        xml.start(name);
        xml.text(text);
        xml.end();
    }
    if let Some(hash) = Drawing::hash_of_all(drawings) {
        let [element, word] = HASH;
        xml.start(element);
        xml.text(&format!("{word}{hash}"));
        xml.end();
    }
    format!("{DECLARATION}{}", xml.finish())
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use roxmltree::Document;

    use super::super::samples::everything;
    use super::super::zip::unzipped;
    use super::*;
    use crate::drawing::{Color, Paint, Role};

    /// What the file of a drawing in two steps consists of.
    fn in_steps() -> BTreeMap<String, Vec<u8>> {
        let step =
            |title: &str| Step { title: title.into(), sentences: vec!["a < b".into(), "so & so".into()] };
        let drawing = Drawing { steps: vec![step("One"), step("Two")], hash: "0f".into(), ..everything() };
        let file = write_steps(&drawing, &Options::default(), InSteps::default()).unwrap();
        assert_eq!(stamp(&file), Some(Stamped::Hash("0f".into())));
        let files = unzipped(&file);
        let count = files.len();
        let files: BTreeMap<_, _> = files.into_iter().collect();
        assert_eq!(files.len(), count, "a name stands twice");
        files
    }

    fn text<'f>(files: &'f BTreeMap<String, Vec<u8>>, name: &str) -> &'f str {
        std::str::from_utf8(&files[name]).unwrap()
    }

    /// The paragraphs of a slide or of its notes.
    fn words(part: &str) -> Vec<String> {
        let part = Document::parse(part).unwrap();
        let texts = part.descendants().filter(|node| node.tag_name().name() == "t");
        texts.map(|node| node.text().unwrap_or("").to_owned()).collect()
    }

    #[test]
    fn every_reference_leads_to_a_part_and_every_part_has_a_kind() {
        let files = in_steps();
        let types = Document::parse(text(&files, "[Content_Types].xml")).unwrap();
        let all = |attribute: &str| -> BTreeSet<&str> {
            types.descendants().filter_map(|node| node.attribute(attribute)).collect()
        };
        let (endings, kinds) = (all("Extension"), all("PartName"));
        let mut led_to = BTreeSet::from(["[Content_Types].xml".to_owned()]);
        for (name, content) in files.iter().filter(|(name, _)| name.contains("_rels/")) {
            led_to.insert(name.clone());
            let part = name.replace("_rels/", "").replace(".rels", "");
            let of_part = Document::parse(std::str::from_utf8(content).unwrap()).unwrap();
            let mut ids = BTreeSet::new();
            for relation in of_part.descendants().filter(|node| node.has_attribute("Id")) {
                assert!(ids.insert(relation.attribute("Id").unwrap()), "{name}");
                let target = relation.attribute("Target").unwrap();
                let folder = part.rsplit_once('/').map_or("", |(folder, _)| folder);
                let target = match target.strip_prefix("../") {
                    Some(up) => format!("{}/{up}", folder.rsplit_once('/').unwrap().0),
                    None if folder.is_empty() => target.to_owned(),
                    None => format!("{folder}/{target}"),
                };
                assert!(files.contains_key(&target), "{name} leads to {target}");
                led_to.insert(target);
            }
            // What the part refers to by name is one of them.
            let Some(content) = files.get(&part) else { continue };
            let content = Document::parse(std::str::from_utf8(content).unwrap()).unwrap();
            for attribute in content.descendants().flat_map(|node| node.attributes()) {
                let is_reference =
                    attribute.namespace().is_some_and(|space| space.ends_with("relationships"));
                assert!(!is_reference || ids.contains(attribute.value()), "{part}: {}", attribute.value());
            }
        }
        for name in files.keys() {
            assert!(led_to.contains(name), "nothing leads to {name}");
            let ending = name.rsplit('.').next().unwrap();
            let known = endings.contains(ending) || kinds.contains(format!("/{name}").as_str());
            assert!(known || name == "[Content_Types].xml", "{name}");
        }
    }

    #[test]
    fn a_step_is_a_slide_with_its_title_and_its_sentences_for_notes() {
        let files = in_steps();
        for (number, title) in [(1, "1. One"), (2, "2. Two")] {
            let slide = text(&files, &format!("ppt/slides/slide{number}.xml"));
            assert_eq!(words(slide), [title]);
            assert!(
                slide.contains("<p:ph type=\"title\"/>") && slide.contains("<a:srgbClr val=\"FFFFFF\"/>")
            );
            assert!(slide.contains(&format!("descr=\"{}: a &lt; b so &amp; so\"", &title[3..])), "{slide}");
            let notes = text(&files, &format!("ppt/notesSlides/notesSlide{number}.xml"));
            assert_eq!(words(notes), ["a < b", "so & so"]);
            let svg = Document::parse(text(&files, &format!("ppt/media/image{number}.svg"))).unwrap();
            let has = |name: &str| svg.descendants().any(|node| node.tag_name().name() == name);
            assert!(has("title") && !has("metadata") && !has("style"), "it says nothing of itself");
            let png = &files[&format!("ppt/media/image{number}.png")];
            let reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
            assert!(reader.info().uncompressed_latin1_text.is_empty());
        }
    }

    #[test]
    fn a_figure_fills_its_slide_on_its_own_colour_and_is_listed_by_its_title() {
        let night = Paint::role(Role::Background, Color::hex(0x12_16_1C));
        let drawing = Drawing { background: night, width: 400.0, height: 400.0, ..everything() };
        let files: BTreeMap<_, _> =
            unzipped(&bound(&[&drawing, &drawing], &Options::default()).unwrap()).into_iter().collect();
        let slide = text(&files, "ppt/slides/slide2.xml");
        assert!(slide.contains("<a:srgbClr val=\"12161C\"/>"));
        assert_eq!(words(slide), [drawing.title.as_str()]);
        assert!(slide.contains("y=\"-762000\""), "the title is above the slide");
        assert!(slide.contains("<a:off x=\"2667000\" y=\"0\"/>"), "{slide}");
        assert!(slide.contains("<a:ext cx=\"6858000\" cy=\"6858000\"/>"), "{slide}");
        assert_eq!(words(text(&files, "ppt/notesSlides/notesSlide1.xml")), [drawing.desc.as_str()]);
        assert!(text(&files, "ppt/theme/theme1.xml").contains("<a:lt1><a:srgbClr val=\"12161C\"/></a:lt1>"));
        let seen_through = Drawing { background: night.with_opacity(0.0), ..drawing };
        let [slide] = &slides(&seen_through, &Options::default())[..] else { panic!("one slide") };
        let image = &relations([("image", "a"), ("image", "b")]);
        assert!(!slide.part([&image[0], &image[1]]).contains("<p:bg>"));
    }
}
