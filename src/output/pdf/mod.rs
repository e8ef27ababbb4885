//! PDF: a page of vector graphics, for papers and slides; in steps a page for each, that LaTeX includes by
//! its number; of several figures sheets of paper.
//!
//! A page pixel is ¾ of a point, as in CSS. Text is outlines: each glyph that occurs is a form that its
//! places refer to; over them lie [`letters`] that no one sees, which are found and copied. Opacities are
//! graphics states, groups with an opacity are forms ([`content`]). Objects, strings and the table that says
//! where each object begins are written by `pdf-writer`. There is no date and no random number in the file.
//! Source: *ISO 32000-1:2008, Document management – Portable document format 1.7*, sections 7 and 8.

mod content;
mod empty_font;
mod letters;

use std::borrow::Cow;
use std::collections::BTreeSet;

use flate2::{Compress, CompressError, Compression, FlushCompress, Status};
use pdf_writer::writers::{ExtGraphicsState, PageLabel, Resources};
use pdf_writer::{Finish, Name, Pdf, Rect, Ref, Settings, Str, TextStr};

use super::handout::{POINTS, Placed, Sheet};
use super::number::hundredths;
use super::{
    Binder, Bracket, Depends, Format, InSteps, Options, OutputError, Reader, Stamped, Writer, validity,
};
use crate::drawing::{Drawing, Step};
use content::{Content, Form, Opacity, State};

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "pdf",
    about: "vector page, its text found and copied; a page for each step, or sheets of several figures",
    media_type: "application/pdf",
    usual: false,
    in_the_dark: false,
    depends: Depends::Page,
    write: Writer::One(write),
    in_steps: Some(write_steps),
    in_motion: None,
    bind: Some(Binder::Sheets(write_sheets)),
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

/// The version of the format: 1.4 has opacities and languages, and what has a higher one is warned of by
/// LaTeX, which writes 1.5, and refused by some journals.
const VERSION: (u8, u8) = (1, 4);

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
    file(&[page_of(drawing)], &[drawing], &[]).map_err(|error| OutputError::encoder(&error))
}

/// Writes a page for each step, labelled with its title.
fn write_steps(drawing: &Drawing, _options: &Options, _: InSteps) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    let steps: Vec<Drawing> = (1..=drawing.steps.len()).map(|step| drawing.at_step(step)).collect();
    let pages: Vec<Sheet<'_>> = steps.iter().map(page_of).collect();
    file(&pages, &[drawing], &drawing.steps).map_err(|error| OutputError::encoder(&error))
}

fn write_sheets(sheets: &[Sheet<'_>]) -> Result<Vec<u8>, OutputError> {
    let drawings: Vec<&Drawing> = sheets.iter().flat_map(|s| &s.figures).map(|f| f.drawing).collect();
    file(sheets, &drawings, &[]).map_err(|error| OutputError::encoder(&error))
}

/// A figure on a page of its own.
fn page_of(drawing: &Drawing) -> Sheet<'_> {
    let size = [drawing.width, drawing.height].map(|length| length * POINTS);
    let figures = vec![Placed { drawing, at: [0.0; 2], scale: POINTS }];
    Sheet { size, figures, words: Vec::new() }
}

/// The whole file: the document, which says what `drawings` say, its pages, and what they draw and refer to.
/// Of several steps each page has the title of its own for a number.
fn file(sheets: &[Sheet<'_>], drawings: &[&Drawing], steps: &[Step]) -> Result<Vec<u8>, CompressError> {
    let content = Content::of(sheets);
    let mut free = Ref::new(1);
    let [catalog, tree, resources, info] = std::array::from_fn(|_| free.bump());
    let pages: Vec<[Ref; 2]> = sheets.iter().map(|_| [free.bump(), free.bump()]).collect();
    let forms: Vec<(Ref, &Form)> = content.forms.iter().map(|form| (free.bump(), form)).collect();
    let mut pdf = Pdf::with_settings(SETTINGS);
    pdf.set_version(VERSION.0, VERSION.1);
    write_catalog(&mut pdf, (catalog, tree), language(drawings), steps, &mut free);
    let count = i32::try_from(pages.len()).unwrap_or(i32::MAX);
    pdf.pages(tree).kids(pages.iter().map(|[page, _]| *page)).count(count);
    let mut packer = Packer::new();
    for ((sheet, [page, drawn]), operators) in sheets.iter().zip(&pages).zip(&content.pages) {
        let [width, height] = sheet.size.map(hundredths);
        let mut written = pdf.page(*page);
        written.parent(tree).media_box(Rect::new(0.0, 0.0, width, height)).contents(*drawn);
        written.pair(RESOURCES, resources);
        written.finish();
        let (bytes, filter) = packer.pack(operators)?;
        pdf.stream(*drawn, &bytes).pairs(filter);
    }
    let font = content.letters.write(&mut pdf, &mut free, &mut packer)?;
    let mut names = pdf.indirect(resources).start::<Resources>();
    write_names(&mut names, &forms, &content.states);
    names.fonts().pairs(font.map(|(name, font)| (Name(name.as_bytes()), font)));
    names.finish();
    write_information(&mut pdf, info, drawings);
    for (object, form) in forms {
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

/// Writes what the document is; of several steps each page has a title for its number.
fn write_catalog(pdf: &mut Pdf, (catalog, tree): (Ref, Ref), lang: &str, steps: &[Step], free: &mut Ref) {
    let titles: Vec<(Ref, &Step)> =
        steps.iter().filter(|_| steps.len() > 1).map(|step| (free.bump(), step)).collect();
    let mut document = pdf.catalog(catalog);
    document.pages(tree).lang(TextStr(lang));
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
}

/// The language of all drawings, or else ours.
fn language<'d>(drawings: &[&'d Drawing]) -> &'d str {
    let of = |drawing: &&'d Drawing| drawing.lang.as_deref().unwrap_or(Drawing::OWN_LANG);
    let first = drawings.first().map_or(Drawing::OWN_LANG, of);
    if drawings.iter().all(|drawing| of(drawing) == first) { first } else { Drawing::OWN_LANG }
}

/// Writes what the document says of itself: the words of its drawings, and the hash that all of them have.
fn write_information(pdf: &mut Pdf, object: Ref, drawings: &[&Drawing]) {
    let all = |of: fn(&Drawing) -> &str, between: &str| {
        drawings.iter().map(|drawing| of(drawing)).collect::<Vec<_>>().join(between)
    };
    let (title, subject) = (all(|drawing| &drawing.title, "; "), all(|drawing| &drawing.desc, "\n"));
    let mut information = pdf.document_info(object);
    information.title(TextStr(&title)).subject(TextStr(&subject)).creator(TextStr("tracefig"));
    if let Some(hash) = Drawing::hash_of_all(drawings) {
        information.pair(Name(HASH.as_bytes()), Str(hash.as_bytes()));
    }
}

/// Writes the names of the forms and of the graphics states.
fn write_names(resources: &mut Resources, forms: &[(Ref, &Form)], states: &BTreeSet<State>) {
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
            // A font draws by no operators.
            if entries.contains("/Length1 ") {
                objects.push((entries, String::new()));
                continue;
            }
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
        assert!(text.starts_with("%PDF-1.4") && text.ends_with("%%EOF"));
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
