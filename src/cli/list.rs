//! `tracefig list`: what a scene may say, from the tables that read it.

use std::fmt::Write as _;
use std::io::{self, Write as _};

use clap::Args;
use clap::builder::PossibleValuesParser;
use tracefig::collision::{ALGORITHMS, AnswerField, QUERIES, QueryKind, Question};
use tracefig::drawing::Role;
use tracefig::figure;
use tracefig::figure::default_picture::{PICTURES, Picture};
use tracefig::figure::exercise::askables;
use tracefig::figure::layer::{LAYERS, LabelKey, Layer, Shows};
use tracefig::figure::theme::{THEMES, ThemeKey, keys};
use tracefig::figure::{COMMON, OptionSpec, Takes};
use tracefig::geometry::shape::{KINDS, SHAPE_ERRORS};
use tracefig::output::FORMATS;
use tracefig::scene::{
    ERRORS, Field, Holds, LINE_FIELDS, PROJECT_TABLES, TABLES, answer_fields, shape_rows, visible,
};
use tracefig::trace::{EVENTS, HEADER, VALUES};

use super::console::Console;
use super::inputs::find_here;
use super::manual::Manual;
use super::schema::SCHEMAS;
use super::unplanned::tell_unplanned;
use super::{Runs, Status};

/// A topic of `list`.
struct Topic {
    /// The word that asks for it.
    name: &'static str,
    /// A second word for it, shared with its neighbours.
    group: &'static str,
    /// What stands above it where several are printed.
    title: &'static str,
    /// Makes the lines: a word and what it means.
    rows: fn() -> Vec<(String, String)>,
}

/// Every topic, in the order in which they are printed.
static TOPICS: &[Topic] = &[
    Topic { name: "shapes", group: "kinds", title: "Kinds of shape, and their fields", rows: shapes },
    Topic { name: "queries", group: "kinds", title: "Kinds of query", rows: queries },
    Topic { name: "algorithms", group: "", title: "Algorithms, and what they answer", rows: algorithms },
    Topic {
        name: "fields",
        group: "",
        title: "Tables of a scene and of a project file, and their keys",
        rows: fields,
    },
    Topic { name: "layers", group: "", title: "Layers, and their options", rows: layers },
    Topic {
        name: "labels",
        group: "",
        title: "Keys of labels, and the layers that write them",
        rows: labels,
    },
    Topic {
        name: "pictures",
        group: "",
        title: "Pictures of answers, where a scene has no panels; the first that fits is drawn",
        rows: pictures,
    },
    Topic {
        name: "roles",
        group: "",
        title: "Roles: colours of a theme, and of words, as `{a|the box}`",
        rows: roles,
    },
    Topic { name: "values", group: "", title: "Values of an answer in texts, as `{=time:.3}`", rows: values },
    Topic {
        name: "answers",
        group: "",
        title: "Keys of answers, as `solve --json` writes them",
        rows: answers,
    },
    Topic {
        name: "events",
        group: "",
        title: "Events and their fields, as `trace --jsonl` writes them",
        rows: events,
    },
    Topic { name: "exercise", group: "", title: "Values that an exercise may ask for", rows: askable },
    Topic { name: "themes", group: "", title: "Themes", rows: themes },
    Topic {
        name: "theme-keys",
        group: "",
        title: "Tables of a theme file, and their keys",
        rows: theme_keys,
    },
    Topic { name: "formats", group: "", title: "Formats of files", rows: formats },
    Topic { name: "errors", group: "", title: "Codes of errors", rows: errors },
    Topic { name: SCENES, group: "", title: "Scenes of the project, or in figures/", rows: figures },
];

/// The topic that is of a project, and not of tracefig.
const SCENES: &str = "figures";

/// Every word that names topics, or a schema, which is printed only when asked for.
fn words() -> Vec<&'static str> {
    let mut words: Vec<_> = TOPICS.iter().flat_map(|t| [t.name, t.group]).filter(|w| !w.is_empty()).collect();
    words.extend(SCHEMAS.iter().map(|schema| schema.name));
    words.sort_unstable();
    words.dedup();
    words
}

/// Options of `list`.
#[derive(Args)]
pub(crate) struct List {
    /// What to list; none: everything but the schemas
    #[arg(value_parser = PossibleValuesParser::new(words()))]
    topic: Option<String>,
}

impl Runs for List {
    const MANUAL: Manual = Manual {
        examples: &[
            ("tracefig list", "Print all that a scene may say"),
            ("tracefig list schema > scene.schema.json", "Keep the JSON Schema of scenes for an editor"),
        ],
        files: &[],
        wrong: None,
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        let asked = SCHEMAS.iter().find(|schema| self.topic.as_deref() == Some(schema.name));
        if let Some(schema) = asked {
            writeln!(console.out, "{:#}", (schema.make)())?;
            return Ok(Status::Done);
        }
        // Asked for by itself, what can't be listed is told.
        if self.topic.as_deref() == Some(SCENES)
            && let Err(unplanned) = find_here(&[])
        {
            return Ok(tell_unplanned(&unplanned, console));
        }
        let is_wanted =
            |t: &&Topic| self.topic.as_deref().is_none_or(|word| word == t.name || word == t.group);
        let wanted: Vec<_> = TOPICS.iter().filter(is_wanted).collect();
        let titled = wanted.len() > 1;
        let mut text = String::new();
        for topic in &wanted {
            if titled {
                let gap = if text.is_empty() { "" } else { "\n" };
                let _ = writeln!(text, "{gap}{}", topic.title);
            }
            columns(&mut text, &(topic.rows)(), if titled { "  " } else { "" });
        }
        console.out.write_all(text.as_bytes())?;
        Ok(Status::Done)
    }
}

/// Adds two columns, the first as wide as its widest entry.
fn columns(text: &mut String, rows: &[(String, String)], indent: &str) {
    let width = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    for (name, about) in rows {
        let line = format!("{indent}{name:width$}  {about}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
}

fn field(field: &Field) -> (String, String) {
    let need = if field.required { "required; " } else { "" };
    (format!("  {}", field.name), format!("{need}{}: {}", field.holds.expected(), field.about))
}

fn shapes() -> Vec<(String, String)> {
    let common = |f: &Field| {
        TABLES.iter().any(|t| t.header == "[shapes.NAME]" && t.fields.iter().any(|b| b.name == f.name))
    };
    let mut rows = Vec::new();
    for kind in KINDS {
        rows.push((kind.name.to_owned(), kind.about.to_owned()));
        rows.extend(shape_rows(kind).iter().filter(|f| !common(f)).map(field));
    }
    rows
}

fn queries() -> Vec<(String, String)> {
    let names = |kind: QueryKind| {
        let fitting = ALGORITHMS.iter().filter(|a| a.kinds.contains(&kind)).map(|a| a.name);
        format!("by {}", fitting.collect::<Vec<_>>().join(", "))
    };
    let rows = |query: &Question| {
        [(query.word.to_owned(), query.about.to_owned()), (String::new(), names(query.kind))]
    };
    QUERIES.iter().flat_map(rows).collect()
}

fn algorithms() -> Vec<(String, String)> {
    let about = |a: &tracefig::collision::Algorithm| {
        let kinds: Vec<_> = a.kinds.iter().map(|k| k.word()).collect();
        format!("{} ({})", a.about, kinds.join(", "))
    };
    ALGORITHMS.iter().map(|a| (a.name.to_owned(), about(a))).collect()
}

fn fields() -> Vec<(String, String)> {
    let mut rows = Vec::new();
    for table in TABLES.iter().chain(&PROJECT_TABLES) {
        rows.push((table.header.to_owned(), String::new()));
        for row in table.fields {
            rows.push(field(row));
            if let Holds::Word { known, .. } = row.holds {
                rows.push((String::new(), format!("one of: {}", known().join(", "))));
            }
        }
    }
    rows
}

fn askable() -> Vec<(String, String)> {
    askables().map(|(name, what)| (name.to_owned(), what)).collect()
}

/// What an option takes, in words.
fn takes(takes: Takes) -> String {
    match takes {
        Takes::Flag => "true or false".to_owned(),
        Takes::Number => "a number".to_owned(),
        Takes::Positive => "a number above 0".to_owned(),
        Takes::Point => "[x, y]".to_owned(),
        Takes::Counts => "a whole number from 0, or a list of them".to_owned(),
        Takes::Word(words) => words.join(" | "),
        Takes::Words(words) => format!("some of {}", words.join(", ")),
        Takes::Bodies => "names of shapes".to_owned(),
        Takes::When(words) => format!("a time in [0, 1] | {}", words.join(" | ")),
        Takes::Role => "a colour role".to_owned(),
        Takes::Lines => "a text, or a list of texts".to_owned(),
    }
}

fn option(option: &OptionSpec) -> (String, String) {
    (
        format!("  {}", option.name),
        format!("{}: {}; default {}", takes(option.takes), option.about, option.default),
    )
}

fn layers() -> Vec<(String, String)> {
    let mut rows = vec![("(every layer)".to_owned(), String::new())];
    rows.extend(COMMON.iter().map(option));
    for layer in LAYERS {
        let of = if layer.shows == Shows::Configuration { " (configuration space)" } else { "" };
        rows.push((layer.name.to_owned(), format!("{}{of}; needs {}", layer.about, layer.needs)));
        rows.extend(layer.options.iter().map(option));
    }
    rows
}

fn labels() -> Vec<(String, String)> {
    let row = |layer: &Layer, label: &LabelKey| {
        (label.key.to_owned(), format!("{} (`{}`)", label.about, layer.name))
    };
    LAYERS.iter().flat_map(|layer| layer.labels.iter().map(move |label| row(layer, label))).collect()
}

fn pictures() -> Vec<(String, String)> {
    let row = |picture: &Picture| {
        let panels = picture.panels.trim().lines().map(|line| (String::new(), line.to_owned()));
        std::iter::once((picture.name.to_owned(), picture.about.to_owned())).chain(panels).collect::<Vec<_>>()
    };
    PICTURES.iter().flat_map(row).collect()
}

fn themes() -> Vec<(String, String)> {
    THEMES.iter().map(|t| (t.name.to_owned(), t.about.to_owned())).collect()
}

fn roles() -> Vec<(String, String)> {
    let of_words = |role| if Role::OF_WORDS.contains(&role) { "" } else { " (not for words)" };
    Role::ALL.map(|r| (r.name().to_owned(), format!("{}{}", r.about(), of_words(r)))).to_vec()
}

fn values() -> Vec<(String, String)> {
    let digits = [
        (":.3", "after a name: three digits after the point, no more than the bounds prove"),
        (":.3g", "after a name: three digits in all; without it as many"),
    ];
    let of =
        |((name, about), asked): ((&str, &str), String)| (name.to_owned(), format!("{about}; of {asked}"));
    let digits = digits.map(|(name, about)| (name.to_owned(), about.to_owned()));
    figure::values().zip(figure::askers()).map(of).chain(digits).collect()
}

/// Keys with what they hold, and below them those of what they hold.
fn answer_rows(within: &str, fields: &[AnswerField]) -> Vec<(String, String)> {
    let rows = |field: &AnswerField| {
        let path = format!("{within}{}", field.name);
        let when =
            if field.when.is_empty() { String::new() } else { format!("optional, of {}: ", field.when) };
        let inner = answer_rows(&format!("{path}."), field.inner);
        let own = (format!("  {path}"), format!("{when}{}", field.about));
        std::iter::once(own).chain(inner).collect::<Vec<_>>()
    };
    fields.iter().flat_map(rows).collect()
}

fn answers() -> Vec<(String, String)> {
    let mut rows = vec![("(the line)".to_owned(), String::new())];
    rows.extend(answer_rows("", &LINE_FIELDS));
    for query in QUERIES {
        rows.push((query.word.to_owned(), String::new()));
        rows.extend(answer_rows("", answer_fields(query.kind)));
    }
    rows
}

fn events() -> Vec<(String, String)> {
    let inner = |&(name, about): &(&str, &str)| (format!("  {name}"), about.to_owned());
    let mut rows = vec![("(the first line)".to_owned(), String::new())];
    rows.extend(HEADER.iter().map(inner));
    rows.push(("(forms of values)".to_owned(), String::new()));
    rows.extend(VALUES.iter().map(inner));
    for kind in EVENTS {
        rows.push((kind.name(), kind.about()));
        rows.extend(kind.fields.iter().map(|field| (format!("  {}", field.name), field.about())));
    }
    rows
}

fn theme_keys() -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let mut last = "";
    for ThemeKey { table, name, takes, about } in keys() {
        if table != last {
            rows.push((format!("[{table}]"), String::new()));
            last = table;
        }
        let indent = if table.is_empty() { "" } else { "  " };
        rows.push((format!("{indent}{name}"), format!("{takes}: {about}")));
    }
    rows
}

fn formats() -> Vec<(String, String)> {
    FORMATS.iter().map(|f| (f.name.to_owned(), f.about.to_owned())).collect()
}

fn errors() -> Vec<(String, String)> {
    let of_shapes = SHAPE_ERRORS.iter().filter(|(code, _)| ERRORS.iter().all(|e| e.code != *code)).copied();
    let all = ERRORS.iter().map(|e| (e.code, e.about)).chain(of_shapes);
    all.map(|(code, about)| (code.to_owned(), about.to_owned())).collect()
}

fn figures() -> Vec<(String, String)> {
    let Ok(found) = find_here(&[]) else { return Vec::new() };
    let title = |input: &super::inputs::Input| match input.open() {
        Ok(file) => file.scene.title.map_or(String::new(), |t| figure::plain(&t.value)),
        Err(refused) => format!("({} in it)", refused.problems.len()),
    };
    found
        .scenes
        .iter()
        .map(|scene| &scene.input)
        .map(|input| (input.shown(), visible(&title(input)).into_owned()))
        .collect()
}
