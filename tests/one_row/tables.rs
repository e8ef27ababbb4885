//! The tables of the house, and where a row's name means something else.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use syn::visit::{self, Visit};

use tracefig::collision::{ALGORITHMS, QUERIES};

use super::sources::src;

/// A table whose rows are a file each.
pub(crate) struct Table {
    /// What a row is.
    pub(crate) what: &'static str,
    /// The folder of its files below `src/`.
    pub(crate) folder: &'static str,
    /// The constant that holds a row, one in each file; for commands there is none, and the table has the
    /// names.
    pub(crate) row: Option<&'static str>,
    /// The rows' names.
    pub(crate) names: Vec<String>,
    /// How a string of the source names a row.
    pub(crate) finds: fn(&str, &str) -> bool,
    /// Files where the same word says something else, with what it says there.
    pub(crate) other_meanings: &'static [(&'static str, &'static str, &'static str)],
}

/// The string is the name.
pub(crate) fn is_name(text: &str, name: &str) -> bool {
    text == name
}

/// The name is a word of the string: `"svg,png"` and `"image/png"` name formats too.
pub(crate) fn has_word(text: &str, name: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == name)
}

/// The names of a table's rows.
fn names(all: &mut dyn Iterator<Item = &'static str>) -> Vec<String> {
    all.map(str::to_owned).collect()
}

/// Every table of the house.
pub(crate) fn tables() -> Vec<Table> {
    [outer(), layers(), pictures(), algorithms(), naive()].into_iter().flatten().collect()
}

/// Words that are names of formats, where they mean something else.
const NO_FORMATS: &[(&str, &str, &str)] = &[
    ("svg", "output/page.rs", "the element inside a page"),
    ("html", "output/page.rs", "the element around a page"),
    ("html", "output/stepper", "the element around a page"),
    ("png", "output/mod.rs", "the option `--png`"),
    ("html", "cli/mdbook.rs", "the renderer of mdBook whose pages take elements"),
    ("html", "cli/book/mail.rs", "the renderer of mdBook whose pages load scripts"),
    ("html", "cli/book/runtime.rs", "the renderer of mdBook whose pages load scripts"),
    ("svg", "cli/book/colors.rs", "the element inside a page"),
    ("html", "output/live_page.rs", "the element that is a page"),
    ("html", "output/gallery.rs", "the element that is a page"),
    ("html", "output/moodle.rs", "what the texts of a question are marked up with"),
    ("html", "cli/reports.rs", "the page of findings, which is no figure"),
    ("html", "drift/report", "the page of findings, which is no figure"),
];

/// What a user adds from outside: formats, kinds, themes, commands.
fn outer() -> Vec<Table> {
    vec![
        Table {
            what: "format",
            folder: "output",
            row: Some("FORMAT"),
            names: names(&mut tracefig::output::FORMATS.iter().map(|f| f.name)),
            finds: has_word,
            other_meanings: NO_FORMATS,
        },
        Table {
            what: "shape kind",
            folder: "geometry/shape",
            row: Some("KIND"),
            names: names(&mut tracefig::geometry::shape::KINDS.iter().map(|k| k.name)),
            finds: is_name,
            other_meanings: &[
                ("circle", "output/svg", "the element of SVG"),
                ("box", "drift/measured.rs", "a rectangle of a report"),
                ("outline", "figure/theme/strokes.rs", "a kind of line"),
                ("box", "figure/layer/bounds.rs", "the part of a figure that is a bounding box"),
                ("aabb", "collision", "the shape that the article compares extents of"),
            ],
        },
        Table {
            what: "theme",
            folder: "figure/theme",
            row: Some("THEME"),
            names: names(&mut tracefig::figure::theme::THEMES.iter().map(|t| t.name)),
            finds: is_name,
            other_meanings: &[
                ("light", "output/page_colors.rs", "the colour scheme of a page"),
                ("light", "figure/layer/projection.rs", "what falls on the bodies and casts their shadows"),
                ("light", "figure/layer/axis_unit.rs", "what falls on the bodies and casts their shadows"),
                ("light", "figure/language.rs", "the word for what falls on the bodies"),
                ("dark", "output/page_colors.rs", "the colour scheme of a page"),
                ("auto", "scene/fields.rs", "a height of the page"),
                ("dark", "figure/theme/keys.rs", "the table of colours for readers whose system is dark"),
                ("dark", "figure/theme/user.rs", "the table of colours for readers whose system is dark"),
            ],
        },
        Table {
            what: "command",
            folder: "cli",
            row: None,
            names: commands(),
            finds: is_name,
            other_meanings: &[
                ("trace", "drift/moved.rs", "a key of the metadata"),
                ("describe", "report/files.rs", "`git describe`"),
                ("render", "scene", "a table of a project file"),
            ],
        },
    ]
}

/// Naive methods.
fn naive() -> Vec<Table> {
    vec![Table {
        what: "naive method",
        folder: "collision/naive",
        row: Some("NAIVE"),
        names: names(&mut tracefig::collision::naive::METHODS.iter().map(|method| method.name)),
        finds: is_name,
        other_meanings: &[],
    }]
}

/// Where the name of a layer says something else.
const WORDS_OF_LAYERS: &[(&str, &str, &str)] = &[
    ("frame", "cli/in_time.rs", "a picture of a figure that plays"),
    ("separation", "figure/text/quantity.rs", "what an exercise asks for"),
    ("difference", "figure/layer/difference_name.rs", "the name of B ⊖ A"),
    ("difference", "figure/layer/unbuilt.rs", "the name of B ⊖ A"),
    ("shapes", "cli/list.rs", "a topic of `list`"),
    ("axes", "figure/theme/strokes.rs", "a kind of line"),
    ("grid", "figure/theme/strokes.rs", "a kind of line"),
    ("point", "figure/theme/type_sizes.rs", "a kind of text"),
    ("note", "figure/theme/type_sizes.rs", "a kind of text"),
    ("arc", "collision", "an algorithm"),
    ("bounds", "collision", "a kind of query"),
    ("clamp", "collision", "an algorithm"),
    ("normal", "collision/answer", "a part of an answer"),
    ("closest", "collision/answer", "a part of an answer"),
    ("separation", "collision", "a kind of query"),
    ("difference", "drawing/paint.rs", "a colour role"),
    ("translation", "drawing/paint.rs", "a colour role"),
    ("ray", "drift/moved.rs", "words for an event"),
    ("closest", "figure/layer/advancement.rs", "a label and a part of the drawing"),
    ("grid", "drawing/paint.rs", "a colour role"),
    ("point", "drift/visible.rs", "words for an element"),
    ("vertices", "drift/moved.rs", "a key of an event"),
    ("vertices", "figure/layer", "a part of the drawing"),
    ("vertices", "geometry/shape", "a key of a shape"),
    ("radii", "figure/layer/arc.rs", "a part of the drawing"),
    ("radii", "figure/layer/unrolled.rs", "a part of the drawing"),
    ("arc", "figure/layer/unrolled.rs", "a part of the drawing"),
    ("separation", "figure/layer/expected.rs", "a layer that writes our s, which stays away then"),
    ("separation", "scene/elsewhere.rs", "a part of an answer"),
    ("axes", "figure/layer/axis_gaps.rs", "an option"),
    ("contact", "figure/layer/normal.rs", "a word of an option"),
    ("contact", "figure/layer/support.rs", "a part of its marks"),
    ("normal", "figure/layer/axis_unit.rs", "a part of its marks"),
    ("grid", "figure/layer/axes.rs", "the layer whose lines lead to the numbers of ticks"),
    ("closest", "figure/layer/simplex.rs", "a label and a part of the drawing"),
    ("contact", "figure/layer/velocity.rs", "a word of an option"),
    ("contact", "collision/query/contact.rs", "a kind of query"),
    ("radii", "figure/exercise/quantities.rs", "a value"),
    ("radii", "figure/text/values.rs", "a value"),
    ("separation", "figure/exercise/quantities.rs", "a value"),
    ("velocity", "figure/exercise/search.rs", "a key of a shape"),
    ("separation", "figure/text/values.rs", "a value"),
    ("closest", "scene", "a part of an answer, a word for a moment"),
    ("expected", "drift/measured.rs", "what is on disk, in a report"),
    ("expected", "scene", "a key of a query and of the top of a scene"),
    ("normal", "scene/expected.rs", "a part of what is expected"),
    ("separation", "scene/expected.rs", "a part of what is expected"),
    ("normal", "scene/fields.rs", "a part of what is expected"),
    ("separation", "scene/fields.rs", "a part of what is expected"),
    ("frame", "scene", "a key of a panel"),
    ("shapes", "scene", "a table of a scene"),
    ("shapes", "figure/handle.rs", "a table of a scene"),
    ("velocity", "scene", "a key of a shape"),
    ("vertices", "scene/live.rs", "what of a body may be dragged"),
];

/// Layers.
fn layers() -> Vec<Table> {
    vec![Table {
        what: "layer",
        folder: "figure/layer",
        row: Some("LAYER"),
        names: names(&mut tracefig::figure::layer::LAYERS.iter().map(|l| l.name)),
        finds: is_name,
        other_meanings: WORDS_OF_LAYERS,
    }]
}

/// Pictures of answers, where a scene has no panels.
fn pictures() -> Vec<Table> {
    vec![Table {
        what: "picture",
        folder: "figure/default_picture",
        row: Some("PICTURE"),
        names: names(&mut tracefig::figure::default_picture::PICTURES.iter().map(|p| p.name)),
        finds: is_name,
        other_meanings: &[],
    }]
}

/// Algorithms, and the questions that they answer.
fn algorithms() -> Vec<Table> {
    vec![
        Table {
            what: "algorithm",
            folder: "collision/algorithm",
            row: Some("ALGORITHM"),
            names: names(&mut ALGORITHMS.iter().map(|a| a.name)),
            finds: is_name,
            other_meanings: &[
                ("circles", "drift/moved.rs", "words for an event"),
                ("extents", "drift/moved.rs", "words for an event"),
                ("arc", "figure", "a layer"),
                ("clamp", "figure", "a layer"),
            ],
        },
        Table {
            what: "question",
            folder: "collision/query",
            row: Some("QUESTION"),
            names: names(&mut QUERIES.iter().map(|q| q.word)),
            finds: is_name,
            other_meanings: &[
                ("overlap", "drawing/paint.rs", "the colour of what two bodies share"),
                ("overlap", "collision/answer", "a part of an answer"),
                ("overlap", "figure/layer/shapes.rs", "what two bodies share"),
                ("separation", "collision/answer", "a part of an answer"),
                ("separation", "scene/elsewhere.rs", "a part of an answer"),
                ("bounds", "figure", "a layer"),
                ("separation", "figure", "a layer, its labels, a value of texts"),
                ("contact", "figure/layer/contact.rs", "a layer: the first contact of a motion"),
                ("contact", "figure/layer/normal.rs", "a word of an option"),
                ("contact", "figure/layer/support.rs", "a part of its marks"),
                ("contact", "figure/layer/velocity.rs", "a word of an option"),
                ("separation", "collision/expected.rs", "a part of how far off it is"),
                ("separation", "scene/expected.rs", "a part of what is expected"),
                ("separation", "scene/fields.rs", "a part of what is expected"),
            ],
        },
    ]
}

/// The names in the table of commands, as `row::<…>("NAME", …)`.
fn commands() -> Vec<String> {
    struct Rows(Vec<String>);
    impl<'ast> Visit<'ast> for Rows {
        fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
            if let syn::Expr::Path(path) = &*call.func
                && path.path.segments.last().is_some_and(|s| s.ident == "row")
                && let Some(syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(name), .. })) = call.args.first()
            {
                self.0.push(name.value());
            }
            visit::visit_expr_call(self, call);
        }
    }
    let mut rows = Rows(Vec::new());
    rows.visit_file(&syn::parse_file(&fs::read_to_string(src().join("cli/mod.rs")).unwrap()).unwrap());
    rows.0
}
