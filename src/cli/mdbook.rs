//! `tracefig mdbook`: the scenes of a book's pages, drawn as mdBook builds it.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::PossibleValuesParser;
use tracefig::drift::fingerprint;
use tracefig::output::short_id;
use tracefig::scene::visible;

use super::book::colors::{Colors, of_the_house};
use super::book::figures::{Desk, Order, Served, Takes};
use super::book::kept::Kept;
use super::book::mail::Mail;
use super::book::markdown::{Place, What, places};
use super::book::places::line_in_file;
use super::book::runtime;
use super::console::Console;
use super::live::RUNTIME;
use super::manual::Manual;
use super::own_themes::OwnThemes;
use super::parallel::{in_order, threads};
use super::themes::theme_in;
use super::{Runs, Status};

/// The question whether a renderer is served.
const SUPPORTS: &str = "supports";
/// The renderer whose pages take elements; all others get images.
const PAGES: &str = "html";

/// Bytes of a book that are written at once: it has 60 KB a figure.
const AT_ONCE: usize = 1 << 18;

/// Options of `mdbook`.
#[derive(Args)]
pub(crate) struct Mdbook {
    /// What mdBook asks before it sends a book: whether a renderer is served; all are
    #[arg(value_parser = PossibleValuesParser::new([SUPPORTS]), requires = "renderer")]
    question: Option<String>,
    /// The renderer that it asks about
    renderer: Option<String>,
}

/// What of a page is ours.
struct Found {
    /// What messages call it.
    name: String,
    /// Its file.
    file: PathBuf,
    /// The places.
    places: Vec<Place>,
    /// Numbers of their lines in the file.
    lines: Vec<Option<usize>>,
}

impl Runs for Mdbook {
    const MANUAL: Manual = Manual {
        examples: &[
            ("tracefig mdbook supports html", "Say whether a renderer is served: exit status 0"),
            ("tracefig mdbook", "Read [context, book] as JSON, and write the book with its figures drawn"),
        ],
        files: &[
            ("book.toml", "`[preprocessor.tracefig]` makes mdBook run this command"),
            (
                RUNTIME,
                "what live figures need, written where `additional-js` of `[output.html]` has it; leave it \
                 out of what you keep",
            ),
            (
                "~/.cache/tracefig/books/",
                "figures of the last build of each book; may be deleted at any time",
            ),
        ],
        wrong: Some("a scene of the book is wrong, or what is asked of it"),
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        if self.question.is_some() {
            return Ok(Status::Done);
        }
        let mut sent = Vec::new();
        if let Err(error) = io::stdin().lock().read_to_end(&mut sent) {
            console.error(&format!("can't read standard input: {error}"));
            return Ok(Status::Io);
        }
        let mail = Mail::read(&sent).and_then(|mail| Ok((colors(&mail)?, mail)));
        let (colors, mut mail) = match mail {
            Ok(read) => read,
            Err(told) => {
                console.error(&told);
                return Ok(Status::Wrong);
            }
        };
        let status = draw_pages(&mut mail, &colors, console);
        if status == Status::Done {
            let mut out = BufWriter::with_capacity(AT_ONCE, &mut console.out);
            serde_json::to_writer(&mut out, &mail.book).map_err(io::Error::from)?;
            out.flush()?;
            drop(out);
            console.out.write_all(b"\n")?;
        }
        Ok(status)
    }
}

/// How figures look in a book: in its theme file, else in the theme of the house.
fn colors(mail: &Mail) -> Result<Colors, String> {
    let Some(file) = &mail.theme else { return Ok(Colors::of(of_the_house())) };
    let chosen = theme_in(&mail.root, file).map_err(|e| format!("the book's theme {file}: {e}"))?;
    Ok(Colors::of(chosen))
}

/// Draws what the pages ask for and puts it in its place.
fn draw_pages(mail: &mut Mail, colors: &Colors, console: &mut Console) -> Status {
    let takes = if mail.renderer == PAGES { Takes::Element } else { Takes::Image };
    let (root, src, renderer) = (mail.root.clone(), mail.src.clone(), mail.renderer.clone());
    let code = mail.code.clone();
    let mut pages = mail.pages();
    let wanted = |place: &Place| code.is_some() || !matches!(place.what, What::Link(_));
    let read: Vec<Found> =
        pages.iter().map(|page| read((&root, &src), &page.path, page.content, wanted)).collect();
    let orders = orders(&read);
    let kept = Kept::open(&root, &renderer);
    let desk = Desk {
        takes,
        colors,
        kept,
        own_themes: OwnThemes::default(),
        ink: console.ink(),
        code: code.as_deref(),
        src: &src,
    };
    let (mut status, mut any_live) = (Status::Done, false);
    let mut served = Vec::with_capacity(orders.len());
    let mut pictures = BTreeMap::new();
    let work = |(_, order): &(usize, Order)| desk.serve(order);
    let done: Result<(), ()> = in_order(&orders, threads(None), work, |(page, order), done| {
        let Served { text, messages, kept, is_live } = done.unwrap_or_default();
        pictures.extend(kept);
        any_live |= is_live;
        if text.is_some() {
            console.note(&messages);
        } else {
            status = status.max(if messages.is_empty() { Status::Bug } else { Status::Wrong });
            Console::message(&messages);
        }
        served.push((*page, order.place.range.clone(), text.unwrap_or_default()));
        Ok(())
    });
    debug_assert!(done.is_ok(), "nothing above fails");
    desk.kept.keep(&pictures);
    // From the end, so that what stands before keeps its place.
    for (page, range, text) in served.into_iter().rev() {
        let content = &mut *pages[page].content;
        *content = [&content[..range.start], &text, &content[range.end..]].concat();
    }
    if status != Status::Done || !any_live {
        return status;
    }
    runtime::bring(&root, &mail.scripts).map_or_else(
        |(status, told)| {
            console.error(&told);
            status
        },
        |()| Status::Done,
    )
}

/// What of a page is ours and wanted, and where it stands in the page's file.
fn read((root, src): (&Path, &Path), path: &Path, content: &str, wanted: impl Fn(&Place) -> bool) -> Found {
    let below = src.join(path);
    let file = root.join(&below);
    let places: Vec<Place> = places(content).into_iter().filter(wanted).collect();
    let text = if places.is_empty() { None } else { std::fs::read_to_string(&file).ok() };
    let lines = places.iter().map(|place| line_in_file(content, text.as_deref()?, place.line)).collect();
    Found { name: below.display().to_string(), file, places, lines }
}

/// What is to be done, by page. Ids are of the page and the place in it, and each is given once in the book,
/// as all pages become one to be printed.
fn orders(pages: &[Found]) -> Vec<(usize, Order<'_>)> {
    let (mut orders, mut given) = (Vec::new(), BTreeSet::new());
    for (i, page) in pages.iter().enumerate() {
        let mut with_sheet = true;
        for (n, (place, line)) in page.places.iter().zip(&page.lines).enumerate() {
            let is_figure = matches!(place.what, What::Scene { .. } | What::File { .. });
            let id = if is_figure { new_id(&page.name, n, &mut given) } else { String::new() };
            let first = with_sheet && is_figure;
            with_sheet &= !is_figure;
            let (name, file, line) = (page.name.as_str(), page.file.as_path(), *line);
            orders.push((i, Order { place, name, file, line, id, with_sheet: first }));
        }
    }
    orders
}

/// An id that was not given yet, by the page and the place's number in it.
fn new_id(page: &str, n: usize, given: &mut BTreeSet<String>) -> String {
    let id = |again: u32| {
        let hash = fingerprint(&visible(page), &format!("{n} {again}"));
        short_id(u128::from_str_radix(&hash, 16).unwrap_or(0))
    };
    let mut ids = (0..).map(id);
    ids.find(|id| given.insert(id.clone())).unwrap_or_default()
}
