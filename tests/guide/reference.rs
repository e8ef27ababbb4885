//! Pages written from the tables, by way of what `tracefig list` prints, with an example of each layer, shape
//! and question: a scene in a file, shown and drawn.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use tracefig::collision::{ALGORITHMS, QUERIES};
use tracefig::figure::layer::{LAYERS, Layer, Shows};
use tracefig::figure::theme::THEMES;
use tracefig::geometry::shape::KINDS;

use crate::{printed, src};

/// What stands at the end of every page.
const MADE: &str = "\n<!-- Written from the tables by `TRACEFIG_WRITE=1 cargo test --test guide`. -->\n";

/// A line of `tracefig list`.
struct Row {
    /// Whether it belongs to the line above that does not.
    is_inner: bool,
    /// The word.
    name: String,
    /// What it means.
    about: String,
}

/// The lines of a topic; one that goes on with what the one above says is added to it.
fn rows(topic: &str) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for line in printed(&["list", topic]).lines() {
        let (name, about) = line.trim_start().split_once("  ").unwrap_or((line.trim_start(), ""));
        match rows.last_mut() {
            Some(above) if line.starts_with("   ") => above.about.extend(["; ", line.trim_start()]),
            _ => rows.push(Row {
                is_inner: line.starts_with(' '),
                name: name.to_owned(),
                about: about.trim().to_owned(),
            }),
        }
    }
    rows
}

/// The lines below a word, up to the next that stands as far left.
fn below<'r>(rows: &'r [Row], name: &str) -> &'r [Row] {
    let start = rows.iter().position(|row| row.name == name && !row.is_inner).unwrap() + 1;
    let end = rows[start..].iter().position(|row| !row.is_inner).map_or(rows.len(), |n| start + n);
    &rows[start..end]
}

/// Words for a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('<', "&lt;").replace('*', "\\*")
}

/// A table of two columns.
fn table(heads: [&str; 2], rows: impl IntoIterator<Item = (String, String)>) -> String {
    let mut text = format!("| {} | {} |\n|---|---|\n", heads[0], heads[1]);
    for (name, about) in rows {
        let _ = writeln!(text, "| {} | {} |", cell(&name), cell(&about));
    }
    text
}

/// A word as code.
fn code(word: &str) -> String {
    format!("`{word}`")
}

/// A topic as a table, words as code.
fn topic(heads: [&str; 2], name: &str) -> String {
    table(heads, rows(name).into_iter().map(|row| (code(&row.name), row.about)))
}

/// The options among the lines of a layer: what each takes and what it is for.
fn options(rows: &[Row]) -> String {
    table(["option", "takes"], rows.iter().map(|row| (code(&row.name), row.about.clone())))
}

/// An example as a page asks for it.
fn example(folder: &str, name: &str) -> String {
    format!("{{{{#tracefig {folder}/{name}.toml source}}}}\n")
}

fn layer(layer: &Layer, rows: &[Row]) -> String {
    let mut text = format!("\n## {}\n\n{}. It needs {}.\n", layer.name, upper(layer.about), layer.needs);
    let options_of = below(rows, layer.name);
    if !options_of.is_empty() {
        let _ = write!(text, "\n{}", options(options_of));
    }
    if !layer.labels.is_empty() {
        let label = |l: &tracefig::figure::layer::LabelKey| format!("{} {}", code(l.key), cell(l.about));
        let labels: Vec<_> = layer.labels.iter().map(label).collect();
        let _ = write!(text, "\nLabels: {}.\n", labels.join("; "));
    }
    let _ = write!(text, "\n{}", example("layers", layer.name));
    text
}

/// A sentence with a capital letter, where it begins with a small one.
fn upper(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

fn layers(shows: Shows, title: &str, lead: &str) -> String {
    let rows = rows("layers");
    let mut text = format!("# {title}\n\n{lead}\n");
    if shows == Shows::Anywhere {
        let common = options(below(&rows, "(every layer)"));
        let _ = write!(text, "\nEvery layer has these options besides its own:\n\n{common}");
    }
    text.extend(LAYERS.iter().filter(|l| l.shows == shows).map(|l| layer(l, &rows)));
    text
}

fn shapes() -> String {
    let (rows, fields) = (rows("shapes"), rows("fields"));
    let mut text =
        "# Shapes\n\nA body is a table `[shapes.NAME]` with a `kind`. What every kind has:\n\n".to_owned();
    text += &options(below(&fields, "[shapes.NAME]"));
    for kind in KINDS {
        let own = options(below(&rows, kind.name));
        let _ = write!(
            text,
            "\n## {}\n\n{}.\n\n{own}\n{}",
            kind.name,
            upper(kind.about),
            example("shapes", kind.name)
        );
    }
    text
}

fn queries() -> String {
    let mut text =
        "# Questions\n\n`[query]` asks one of these of one body or two. Without panels, as here, the \
                    figure is what suits the answer.\n"
            .to_owned();
    for query in QUERIES {
        let by: Vec<_> =
            ALGORITHMS.iter().filter(|a| a.kinds.contains(&query.kind)).map(|a| code(a.name)).collect();
        let word = query.word;
        let _ = write!(
            text,
            "\n## {word}\n\n{}. Algorithms: {}; the first is the default where it \
                       takes the shapes.\n\n{}",
            upper(query.about),
            by.join(", "),
            example("queries", word)
        );
    }
    text
}

fn algorithms() -> String {
    let mut text =
        "# Algorithms\n\n`algorithm` in `[query]` names one. Each is one file that opens with its idea.\n\n\
                    | algorithm | what it does |\n|---|---|\n"
            .to_owned();
    for row in rows("algorithms") {
        let file = format!("src/collision/algorithm/{}.rs", row.name.replace('-', "_"));
        let _ = writeln!(text, "| [`{}`](../../../{file}) | {} |", row.name, cell(&row.about));
    }
    text
}

fn texts() -> String {
    let roles = topic(["role", "colour of"], "roles");
    let labels = topic(["key", "what it says, and of which layer"], "labels");
    format!(
        "# Texts\n\nTitles, headlines, captions and labels are plain text with `$…$` for formulas.\n\n\
         ## Values\n\n`{{=name}}` is a number of the answer, with no more digits than its bounds prove.\n\n{}\n\
         ## Roles\n\n`{{a|the box}}` are words in the colour of a role.\n\n{roles}\n\
         ## Labels\n\n`[labels]` rewords, pins or hides a label by its key.\n\n{labels}",
        topic(["value", "meaning"], "values")
    )
}

fn themes() -> String {
    let mut text = "# Themes\n\nA scene names one in `[canvas]`, and so does `--theme`.\n".to_owned();
    for theme in THEMES {
        let picture = match theme.dark {
            Some(_) => String::new(),
            None => format!("\n{{{{#tracefig queries/separation.toml theme={}}}}}\n", theme.name),
        };
        let _ = write!(text, "\n## {}\n\n{}.\n{picture}", theme.name, upper(theme.about));
    }
    text + "\n## Theme files\n\nA file of your own has these tables and keys.\n\n"
        + &topic(["key", "meaning"], "theme-keys")
}

fn fields() -> String {
    let mut text =
        "# Tables and keys\n\nWhat a scene may say, and a project file `tracefig.toml`.\n".to_owned();
    let rows = rows("fields");
    for row in rows.iter().filter(|row| !row.is_inner) {
        let keys = options(below(&rows, &row.name)).replace("| option |", "| key |");
        let _ = write!(text, "\n## {}\n\n{keys}", code(&row.name));
    }
    text
}

fn pictures() -> String {
    let mut text =
        "# Pictures of answers\n\nWhere a scene has no panels, the first of these that fits its answer \
                    is drawn. Each can be pasted into a scene and changed.\n"
            .to_owned();
    let panels = |picture: &tracefig::figure::default_picture::Picture| picture.panels.trim().to_owned();
    for picture in tracefig::figure::default_picture::PICTURES {
        let (about, panels) = (upper(picture.about), panels(picture));
        let _ = write!(text, "\n## {}\n\n{about}.\n\n```toml\n{panels}\n```\n", picture.name);
    }
    text
}

fn errors() -> String {
    let formats = topic(["format", "file"], "formats");
    let codes = topic(["code", "meaning"], "errors");
    format!(
        "# Formats and errors\n\n## Formats\n\n{formats}\n## Codes of errors\n\nThey are in the answers of \
             `solve --jsonl`, and stay.\n\n{codes}"
    )
}

/// A topic whose lines stand below heads that say something themselves or nothing.
fn headed(title: &str, lead: &str, name: &str) -> String {
    let mut text = format!("# {title}\n\n{lead}\n");
    let rows = rows(name);
    for row in rows.iter().filter(|row| !row.is_inner) {
        let about = if row.about.is_empty() { String::new() } else { format!("{}\n\n", cell(&row.about)) };
        let keys = options(below(&rows, &row.name)).replace("| option | takes |", "| key | holds |");
        let _ = write!(text, "\n## {}\n\n{about}{keys}", row.name);
    }
    text
}

fn commands() -> String {
    let help = printed(&["--help"]);
    let list = help.split_once("\nCommands:\n").unwrap().1.split("\n\n").next().unwrap();
    let mut text = "# Commands\n".to_owned();
    for name in list.lines().filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help")
    {
        let page = printed(&[name, "--help"]);
        let page: Vec<&str> = page.trim_end().lines().map(str::trim_end).collect();
        let _ = write!(text, "\n## {name}\n\n```text\n{}\n```\n", page.join("\n"));
    }
    text
}

/// Every page of the reference, by the name of its file.
fn all() -> [(&'static str, String); 13] {
    let world = layers(
        Shows::World,
        "Layers of the world",
        "They stand in panels whose `space` is \"world\" or \"body\".",
    );
    let configuration =
        "They stand in panels whose `space` is \"configuration\": B ⊖ A, seen from the origin O.";
    let configuration = layers(Shows::Configuration, "Layers of configuration space", configuration);
    let anywhere = "A panel is a list of `layers`, drawn in its order: names, or tables with options. These \
                    stand in any panel.";
    let anywhere = layers(Shows::Anywhere, "Layers of any panel", anywhere);
    [
        ("fields", fields()),
        ("shapes", shapes()),
        ("queries", queries()),
        ("algorithms", algorithms()),
        ("layers", anywhere),
        ("layers-world", world),
        ("layers-configuration", configuration),
        ("pictures", pictures()),
        ("values", texts()),
        ("themes", themes()),
        (
            "answers",
            headed("Answers", "What `solve --json` and `solve --jsonl` write, key by key.", "answers"),
        ),
        ("events", headed("Events", "What `trace --jsonl` writes: an event a line.", "events")),
        ("formats-and-errors", errors()),
    ]
}

fn folder() -> PathBuf {
    src().join("reference")
}

/// The names of a folder's files with an ending, without it.
fn stems(folder: &Path, ending: &str) -> BTreeSet<String> {
    let files = folder.read_dir().unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|e| e == ending));
    files.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect()
}

#[test]
fn the_reference_is_what_the_tables_say() {
    let mut pages: Vec<(&str, String)> = all().into();
    pages.push(("commands", commands()));
    let mut stale = Vec::new();
    for (name, text) in &pages {
        let file = folder().join(name).with_extension("md");
        let text = format!("{}{MADE}", text.trim_end().to_owned() + "\n");
        if std::env::var_os("TRACEFIG_WRITE").is_some() {
            fs::write(&file, text).unwrap();
        } else if fs::read_to_string(&file).ok().as_ref() != Some(&text) {
            stale.push(*name);
        }
    }
    assert!(stale.is_empty(), "TRACEFIG_WRITE=1 cargo test --test guide writes {stale:?}");
    let names: BTreeSet<String> = pages.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(stems(&folder(), "md"), names);
}

#[test]
fn every_layer_shape_and_question_has_an_example_that_shows_it() {
    let tables: [(&str, Vec<&str>); 3] = [
        ("layers", LAYERS.iter().map(|l| l.name).collect()),
        ("shapes", KINDS.iter().map(|k| k.name).collect()),
        ("queries", QUERIES.iter().map(|q| q.word).collect()),
    ];
    for (table, names) in tables {
        let folder = folder().join(table);
        let mut files = stems(&folder, "toml");
        files.remove("tracefig");
        assert_eq!(
            files,
            names.iter().map(|&n| n.to_owned()).collect(),
            "guide/src/reference/{table}/NAME.toml"
        );
        for name in names {
            let text = fs::read_to_string(folder.join(name).with_extension("toml")).unwrap();
            assert!(text.contains(&format!("\"{name}\"")), "{table}/{name}.toml does not show it");
        }
    }
}
