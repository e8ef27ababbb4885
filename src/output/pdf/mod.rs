//! PDF: a page of vector graphics, for papers and slides; in steps a page for each, that LaTeX includes by
//! its number.
//!
//! A page pixel is ¾ of a point, as in CSS. Text is outlines: each glyph that occurs is a form that its
//! places refer to. Opacities are graphics states, groups with an opacity are forms ([`content`]). Objects,
//! strings and the table that says where each object begins are written by `pdf-writer`. There is no date and
//! no random number in the file.
//! Source: *ISO 32000-1:2008, Document management – Portable document format 1.7*, sections 7 and 8.

mod content;

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use flate2::{Compress, CompressError, Compression, FlushCompress, Status};
use pdf_writer::writers::{ExtGraphicsState, PageLabel, Resources};
use pdf_writer::{Finish, Name, Pdf, Rect, Ref, Settings, Str, TextStr};

use super::number::hundredths;
use super::{Bracket, Depends, Format, InSteps, Options, OutputError, Reader, Stamped, Writer, validity};
use crate::drawing::{Drawing, Step};
use content::{Content, Form, Opacity, State};

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "pdf",
    about: "vector page, text as outlines; a page for each step",
    usual: false,
    depends: Depends::Page,
    write: Writer::One(write),
    in_steps: Some(write_steps),
    bracket: Bracket {
        begins: &[b"%PDF-".as_slice()],
        ends: &[b"%%EOF".as_slice(), b"%%EOF\n", b"%%EOF\r\n"],
    },
    // Its objects are compressed, so pages are compared byte by byte.
    read: Some(Reader { stamp, picture: None }),
    live: None,
};

/// Key of the document's information under which the scene's hash stands.
const HASH: &str = "tracefig";

/// Points a page pixel.
const POINTS: f64 = 0.75;

/// Spaces only where they separate.
const SETTINGS: Settings = Settings { pretty: false };

/// Key under which a page or a form says what it refers to by name.
const RESOURCES: Name = Name(b"Resources");

/// Key and value in a stream's dictionary.
type Entry = (Name<'static>, Name<'static>);

/// The hash, where a document has one: our information is never compressed.
fn stamp(bytes: &[u8]) -> Option<Stamped> {
    let begin = format!("/{HASH}(");
    let at = bytes.windows(begin.len()).position(|part| part == begin.as_bytes())? + begin.len();
    let end = at + bytes[at..].iter().position(|&byte| byte == b')')?;
    Some(Stamped::Hash(std::str::from_utf8(&bytes[at..end]).ok()?.to_owned()))
}

fn write(drawing: &Drawing, _options: &Options) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    file(drawing, &[Content::of(drawing)]).map_err(|error| OutputError::encoder(&error))
}

/// Writes a page for each step, labelled with its title.
fn write_steps(drawing: &Drawing, _options: &Options, _: InSteps) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    let pages = (1..=drawing.steps.len()).map(|step| Content::of(&drawing.at_step(step)));
    file(drawing, &pages.collect::<Vec<_>>()).map_err(|error| OutputError::encoder(&error))
}

/// A page among the objects of a file.
struct Sheet<'c> {
    /// The page itself.
    page: Ref,
    /// What it draws.
    drawn: Ref,
    /// What that refers to by name.
    resources: Ref,
    /// What it draws, in operators.
    content: &'c Content,
    /// The forms that it refers to, each with its object; glyphs are those of all pages.
    forms: Vec<(Ref, &'c Form)>,
}

/// The whole file: the document, its pages, and what they draw and refer to.
fn file(drawing: &Drawing, contents: &[Content]) -> Result<Vec<u8>, CompressError> {
    let mut free = Ref::new(1);
    let [catalog, pages] = std::array::from_fn(|_| free.bump());
    let mut objects: Vec<[Ref; 3]> = contents.iter().map(|_| std::array::from_fn(|_| free.bump())).collect();
    let info = free.bump();
    let mut glyphs: BTreeMap<&str, Ref> = BTreeMap::new();
    let mut written: Vec<(Ref, &Form, Ref)> = Vec::new();
    let mut sheets = Vec::new();
    for (content, [page, drawn, resources]) in contents.iter().zip(objects.drain(..)) {
        let mut forms = Vec::new();
        for form in &content.forms {
            let known = glyphs.get(form.name.as_str()).copied().filter(|_| !form.is_group);
            let object = known.unwrap_or_else(|| free.bump());
            if known.is_none() {
                glyphs.insert(&form.name, object);
                written.push((object, form, resources));
            }
            forms.push((object, form));
        }
        sheets.push(Sheet { page, drawn, resources, content, forms });
    }
    let mut pdf = Pdf::with_settings(SETTINGS);
    write_catalog(&mut pdf, drawing, (catalog, pages), &sheets, &mut free);
    let mut packer = Packer::new();
    let [width, height] = [drawing.width, drawing.height].map(|length| hundredths(length * POINTS));
    for Sheet { page, drawn, resources, content, forms } in &sheets {
        let mut sheet = pdf.page(*page);
        sheet.parent(pages).media_box(Rect::new(0.0, 0.0, width, height)).contents(*drawn);
        sheet.pair(RESOURCES, *resources);
        sheet.finish();
        let (bytes, filter) = packer.pack(&content.page)?;
        pdf.stream(*drawn, &bytes).pairs(filter);
        write_resources(&mut pdf, *resources, forms, &content.states);
    }
    let mut information = pdf.document_info(info);
    information.title(TextStr(&drawing.title)).subject(TextStr(&drawing.desc)).creator(TextStr("tracefig"));
    if !drawing.hash.is_empty() {
        information.pair(Name(HASH.as_bytes()), Str(drawing.hash.as_bytes()));
    }
    information.finish();
    for (object, form, resources) in written {
        let (bytes, filter) = packer.pack(&form.content)?;
        let mut written = pdf.form_xobject(object, &bytes);
        let [x0, y0, x1, y1] = form.bounds;
        written.bbox(Rect::new(x0, y0, x1, y1)).pairs(filter);
        if form.is_group {
            written.group().transparency().isolated(true);
            written.pair(RESOURCES, resources);
        }
    }
    Ok(pdf.finish())
}

/// Writes what the document is, and its pages; of several each has the title of its step for a number.
fn write_catalog(
    pdf: &mut Pdf,
    drawing: &Drawing,
    (catalog, pages): (Ref, Ref),
    sheets: &[Sheet<'_>],
    free: &mut Ref,
) {
    let lang = drawing.lang.as_deref().unwrap_or(Drawing::OWN_LANG);
    let titles: Vec<(Ref, &Step)> =
        drawing.steps.iter().filter(|_| sheets.len() > 1).map(|step| (free.bump(), step)).collect();
    let mut document = pdf.catalog(catalog);
    document.pages(pages).lang(TextStr(lang));
    if !titles.is_empty() {
        let mut labels = document.page_labels();
        let mut numbers = labels.nums();
        for (page, (object, _)) in (0..).zip(&titles) {
            numbers.insert(page, *object);
        }
    }
    document.finish();
    for (object, step) in &titles {
        pdf.indirect(*object).start::<PageLabel>().prefix(TextStr(&step.title));
    }
    let count = i32::try_from(sheets.len()).unwrap_or(i32::MAX);
    pdf.pages(pages).kids(sheets.iter().map(|sheet| sheet.page)).count(count);
}

/// Writes the names of the forms and of the graphics states.
fn write_resources(pdf: &mut Pdf, object: Ref, forms: &[(Ref, &Form)], states: &BTreeSet<State>) {
    let mut resources = pdf.indirect(object).start::<Resources>();
    resources.x_objects().pairs(forms.iter().map(|(object, form)| (Name(form.name.as_bytes()), *object)));
    let mut dictionaries = resources.ext_g_states();
    for state in states {
        let name = state.name();
        let mut dictionary = dictionaries.insert(Name(name.as_bytes())).start::<ExtGraphicsState>();
        if state.of != Opacity::Strokes {
            dictionary.non_stroking_alpha(state.opacity());
        }
        if state.of != Opacity::Fills {
            dictionary.stroking_alpha(state.opacity());
        }
    }
}

/// Packs streams, one after the other: to begin anew is cheaper than to make another for each glyph.
struct Packer(Compress);

impl Packer {
    fn new() -> Self {
        Self(Compress::new(Compression::default(), true))
    }

    /// The bytes of a stream, packed where that is shorter, and what its dictionary then says of them.
    fn pack<'c>(&mut self, content: &'c [u8]) -> Result<(Cow<'c, [u8]>, Option<Entry>), CompressError> {
        let (key, value) = (Name(b"Filter"), Name(b"FlateDecode"));
        let most = content.len().saturating_sub(key.0.len() + value.0.len() + "//".len());
        let mut packed = Vec::with_capacity(most);
        self.0.reset();
        // The packer fills the room there is and does not ask for more.
        let status = self.0.compress_vec(content, &mut packed, FlushCompress::Finish)?;
        let shorter = status == Status::StreamEnd && packed.len() < most;
        Ok(if shorter { (packed.into(), Some((key, value))) } else { (content.into(), None) })
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::super::samples::everything;
    use super::*;

    fn sample() -> Vec<u8> {
        write(&everything(), &Options::default()).unwrap()
    }

    fn place(bytes: &[u8], what: &[u8]) -> Option<usize> {
        bytes.windows(what.len()).position(|window| window == what)
    }

    /// Each object without its stream, and the operators of the stream.
    fn objects(file: &[u8]) -> Vec<(String, String)> {
        let text = |bytes: &[u8]| std::str::from_utf8(bytes).unwrap().to_owned();
        let (mut rest, mut objects) = (&file[place(file, b"1 0 obj").unwrap()..], Vec::new());
        while let Some(end) = place(rest, b"endobj") {
            let (object, later) = rest.split_at(end);
            rest = &later["endobj".len()..];
            let Some(start) = place(object, b"\nstream\n") else {
                objects.push((text(object), String::new()));
                continue;
            };
            let entries = text(&object[..start]);
            let length: usize = after(&entries, "/Length ").parse().unwrap();
            let stream = &object[start + "\nstream\n".len()..][..length];
            let mut operators = String::new();
            if entries.contains("/Filter/FlateDecode") {
                flate2::read::ZlibDecoder::new(stream).read_to_string(&mut operators).unwrap();
            } else {
                operators = text(stream);
            }
            // A name or an array needs no space before it.
            let operators = operators.replace('/', " /").replace('[', " [ ").replace(']', " ] ");
            objects.push((entries, operators));
        }
        objects
    }

    /// The word after a key.
    fn after<'t>(text: &'t str, key: &str) -> &'t str {
        let rest = &text[text.find(key).unwrap() + key.len()..];
        rest.split(['/', ' ', '>', '\n']).next().unwrap()
    }

    #[test]
    fn states_are_kept_and_brought_back_in_pairs_and_every_name_is_known() {
        let objects = objects(&sample());
        let resources = objects.iter().find(|(entries, _)| entries.contains("/XObject<<")).unwrap();
        let (mut drawn, mut set) = (0, 0);
        for (entries, operators) in &objects {
            let words: Vec<&str> = operators.split_whitespace().collect();
            let count = |word| words.iter().filter(|w| **w == word).count();
            assert_eq!(count("q"), count("Q"), "{entries}");
            for pair in words.windows(2) {
                match pair[1] {
                    "Do" => drawn += 1,
                    "gs" => set += 1,
                    _ => continue,
                }
                assert!(
                    ["<<", " "].iter().any(|end| resources.0.contains(&format!("{}{end}", pair[0]))),
                    "{pair:?}"
                );
            }
        }
        assert!(drawn > 100 && set > 10, "{drawn} forms and {set} states");
    }

    #[test]
    fn a_drawing_with_nothing_in_it_is_a_page() {
        let mut group = crate::drawing::Group::new("empty");
        group.opacity = 0.5;
        let items = vec![crate::drawing::Item::Group(group)];
        let objects = objects(&write(&Drawing { items, ..everything() }, &Options::default()).unwrap());
        let (form, operators) = objects.last().unwrap();
        assert!(
            form.contains("/Subtype/Form") && form.contains("/Length 0") && operators.is_empty(),
            "{form}"
        );
    }

    #[test]
    fn operators_have_plain_numbers_and_are_packed() {
        let file = sample();
        let objects = objects(&file);
        let mut plain = 0;
        for (entries, operators) in &objects {
            plain += operators.len();
            for word in operators.split_whitespace().filter(|word| word.parse::<f64>().is_ok()) {
                assert!(
                    word.bytes().all(|b| b.is_ascii_digit() || b == b'-' || b == b'.'),
                    "{word} in {entries}"
                );
            }
        }
        assert!(file.len() < plain / 2, "{} of {plain}", file.len());
    }

    #[test]
    fn the_table_says_where_each_object_begins() {
        let file = sample();
        let ascii = |b: &u8| if b.is_ascii() { char::from(*b) } else { '?' };
        let text: String = file.iter().map(ascii).collect();
        assert!(text.starts_with("%PDF-1.7") && text.ends_with("%%EOF"));
        let start: usize = text.lines().rev().nth(1).unwrap().parse().unwrap();
        let table = text[start..].lines().skip(3);
        let entries: Vec<&str> =
            table.take_while(|line| line.ends_with(" n") || line.ends_with(" n ")).collect();
        assert_eq!(entries.len(), objects(&file).len());
        for (number, entry) in (1..).zip(entries) {
            let offset: usize = entry[..10].parse().unwrap();
            assert!(text[offset..].starts_with(&format!("{number} 0 obj")));
        }
    }

    #[test]
    fn title_and_description_are_the_drawings_whatever_is_in_them() {
        let drawing = Drawing { title: "(a) \\ é".into(), desc: "a) /b".into(), ..everything() };
        let file = write(&drawing, &Options::default()).unwrap();
        let objects = objects(&file);
        let (information, _) = objects.iter().find(|(entries, _)| entries.contains("/Title")).unwrap();
        assert!(information.contains("<FEFF0028006100290020005C002000E9>"), "{information}");
        assert!(information.contains(r"(a\) /b)"), "{information}");
    }
}
