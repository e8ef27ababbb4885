//! The table of fields: what each table of a scene may hold.
//!
//! One row a key. The reader checks a table against its rows, messages list them, `tracefig list` prints
//! them. The fields of the kinds of shape are in [`crate::geometry::shape::KINDS`] and become rows here by
//! [`shape_rows`].

use crate::collision::{ALGORITHMS, QUERIES, Verdict};
use crate::geometry::shape::{FieldType, KINDS, Kind};

use super::Detail;
use super::holds::Holds;
use super::limits::{
    MAX_CANVAS, MAX_ITERATIONS, MAX_MARGIN, MAX_NUMBER, MAX_PANELS, MAX_TYPE, MIN_CANVAS, MIN_TYPE,
};

/// A key of a table in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// The key.
    pub name: &'static str,
    /// What it holds.
    pub holds: Holds,
    /// Whether it may not be left out.
    pub required: bool,
    /// One line, with unit and default.
    pub about: &'static str,
}

pub(super) const fn must(name: &'static str, holds: Holds, about: &'static str) -> Field {
    Field { name, holds, required: true, about }
}

pub(super) const fn may(name: &'static str, holds: Holds, about: &'static str) -> Field {
    Field { name, holds, required: false, about }
}

/// A table of a scene and its keys.
#[derive(Clone, Copy, Debug)]
pub struct TableRows {
    /// Where it stands, as `[query]`.
    pub header: &'static str,
    /// How messages call it, as "the query".
    pub place: &'static str,
    /// The keys that it may have.
    pub fields: &'static [Field],
}

/// What a key holds that takes any number.
pub(super) const ANY_NUMBER: Holds = Holds::Number { min: -MAX_NUMBER, max: MAX_NUMBER };

/// The top of a file.
pub(super) static ROOT: TableRows = TableRows {
    header: "(top)",
    place: "the scene",
    fields: &[
        may("title", Holds::Text, "title of the figure, for those who do not see it"),
        may("alt", Holds::Text, "short alternative text; default: the title and the answer"),
        may(
            "lang",
            Holds::Text,
            "language of the texts, as \"de\": numbers follow it, and words of ours in en, de, fr, es; \
             default: none",
        ),
        may("headline", Holds::Text, "the claim of the figure, a sentence above the panels"),
        may("caption", Holds::Text, "caption below the figure"),
        must(
            "shapes",
            Holds::Tables("shapes"),
            "the shapes by name: those of the query, and others as context",
        ),
        must("query", Holds::Table, "the question"),
        may(
            "panels",
            Holds::List("panels"),
            "what is drawn, from left to right; default: what suits the answer",
        ),
        may("labels", Holds::Tables("labels"), "texts and places of labels, by label key"),
        may("canvas", Holds::Table, "the page"),
        may("live", Holds::Table, "what a reader may move in a live figure"),
        may(
            "steps",
            Holds::List("steps"),
            "for `--steps`: which steps are shown as one or left out, and in what words",
        ),
        may("exercise", Holds::Table, "makes it an exercise: what is asked, and what the question hides"),
        may("id", Holds::Anything, "copied to the answer of `solve --jsonl`"),
        may("expected", Holds::Anything, "not read; a place for the known answer in suites of tests"),
    ],
};

/// What every shape may have besides the fields of its kind.
pub(super) static BODY: TableRows = TableRows {
    header: "[shapes.NAME]",
    place: "a shape",
    fields: &[
        must("kind", Holds::Word { what: "kind of shape", known: kind_words }, "the kind of shape"),
        may("position", Holds::Pair, "world position of the body's origin at t = 0; default [0, 0]"),
        may("angle_deg", ANY_NUMBER, "angle at t = 0, degrees counter-clockwise; default 0"),
        may("angle_rad", ANY_NUMBER, "the same in radians, instead of `angle_deg`"),
        may(
            "rotation",
            Holds::Pair,
            "[c, s] instead of an angle: the matrix ((c, −s), (s, c)) for all core points, as written",
        ),
        may("velocity", Holds::Pair, "world units per unit of time; default [0, 0]"),
        may(
            "angular_velocity_deg",
            ANY_NUMBER,
            "degrees per unit of time, about the body's origin; default 0",
        ),
        may("angular_velocity_rad", ANY_NUMBER, "the same in radians, instead of `angular_velocity_deg`"),
    ],
};

/// What a shape holds, whatever kind it is of, where a program made it.
pub(super) const MADE_SHAPE: [Field; 2] = [
    must("shape.vertices", Holds::Points, "its vertices, in its body's frame"),
    must("shape.radius", Holds::Number { min: 0.0, max: MAX_NUMBER }, "how far it reaches about them"),
];

/// The question.
pub(super) static QUERY: TableRows = TableRows {
    header: "[query]",
    place: "the query",
    fields: &[
        must("kind", Holds::Word { what: "kind of query", known: query_words }, "what is asked"),
        must("of", Holds::Names, "names of the shapes: the first is A, the second B"),
        may(
            "algorithm",
            Holds::Word { what: "algorithm", known: algorithm_words },
            "default: the best for the pair",
        ),
        may(
            "time",
            Holds::Number { min: 0.0, max: 1.0 },
            "the moment, for bounds, overlap, separation; default 0",
        ),
        may("tolerance", Holds::Number { min: 0.0, max: MAX_NUMBER }, "world units; default 1e-12"),
        may("max_iterations", Holds::Count { min: 1, max: MAX_ITERATIONS }, "step cap; default 20000"),
        may(
            "expected",
            Holds::Table,
            "what someone else answered: `solve` and `trace` say how far off it is",
        ),
    ],
};

/// What someone else answered.
pub(super) static EXPECTED: TableRows = TableRows {
    header: "[query.expected]",
    place: "what is expected",
    fields: &[
        may(
            "outcome",
            Holds::Word { what: "outcome", known: outcome_words },
            "what came out: of bodies that move \"hit\", \"miss\" or \"overlapping\" (at the start), of \
             others \"overlapping\" (touching too) or \"apart\"",
        ),
        may("separation", ANY_NUMBER, "signed, world units; of a miss the least one"),
        may("time", ANY_NUMBER, "of the first contact, or of a miss's closest approach"),
        may("normal", Holds::Pair, "from A to B, of any length"),
        may("points", Holds::Table, "witness points of A and of B: { A = [x, y], B = [x, y] }"),
    ],
};

/// The witness points that someone else answered.
pub(super) static EXPECTED_POINTS: TableRows = TableRows {
    header: "[query.expected.points]",
    place: "the points expected",
    fields: &[must("A", Holds::Pair, "on A, in the world"), must("B", Holds::Pair, "on B, in the world")],
};

/// A panel.
pub(super) static PANEL: TableRows = TableRows {
    header: "[[panels]]",
    place: "a panel",
    fields: &[
        may("title", Holds::Text, "title above the panel"),
        may("caption", Holds::Text, "text below the panel, as wide as that"),
        may("space", Holds::Word { what: "space", known: space_words }, "what it shows; default \"world\""),
        may(
            "frame",
            Holds::Text,
            "the shape in whose frame it is drawn, and with which it moves, for space = \"body\"",
        ),
        may("time", Holds::Moment, "its moment; default: the query's"),
        may(
            "step",
            Holds::Count { min: 1, max: MAX_ITERATIONS },
            "its moment as the algorithm's step, from 1",
        ),
        may("layers", Holds::Layers, "what is drawn, in this order; default: what suits the answer"),
        may(
            "view",
            Holds::Rectangle,
            "world rectangle that must be visible: [x0, y0, x1, y1]; default: a fit",
        ),
        may(
            "inset",
            Holds::RectangleOr(Detail::SMALL),
            "a detail, drawn again and enlarged: [x0, y0, x1, y1]; or \"small\": what is too small to be \
             seen, if anything is",
        ),
        may(
            "inset_at",
            Holds::Word { what: "corner", known: corner_words },
            "the inset's corner; default: where it hides least",
        ),
        may(
            "columns",
            Holds::Count { min: 1, max: MAX_PANELS },
            "how many of the page's columns it is wide, of no more than there are; default 1",
        ),
    ],
};

/// A label written as a table.
pub(super) static LABEL: TableRows = TableRows {
    header: "[labels]",
    place: "a label",
    fields: &[
        may("text", Holds::Text, "text instead of the default"),
        may(
            "at",
            Holds::LabelPlace,
            "pins it: \"NE\", unless over the panel's edge, or an offset [dx, dy] in pixels, y down",
        ),
        may("hide", Holds::Switch, "true: it is not drawn"),
    ],
};

/// The page.
pub(super) static CANVAS: TableRows = TableRows {
    header: "[canvas]",
    place: "the canvas",
    fields: &[
        may("width", Holds::Number { min: MIN_CANVAS, max: MAX_CANVAS }, "page pixels; default 960"),
        may(
            "height",
            Holds::NumberOr { min: MIN_CANVAS, max: MAX_CANVAS, word: "auto" },
            "page pixels; default \"auto\": the page ends where the drawing ends",
        ),
        may(
            "margin",
            Holds::Number { min: 0.0, max: MAX_MARGIN },
            "around the drawing, page pixels; default 24, less on small pages",
        ),
        may(
            "background",
            Holds::ColorOr("transparent"),
            "instead of the theme's; on none, the theme's is still around letters",
        ),
        may(
            "text",
            Holds::Number { min: MIN_TYPE, max: MAX_TYPE },
            "size of the caption, page pixels; all letters grow with it; default 14",
        ),
        may(
            "columns",
            Holds::Count { min: 1, max: MAX_PANELS },
            "panels side by side; default: as many as can be read",
        ),
        may(
            "theme",
            Holds::Text,
            "name of the theme, or a theme file from the scene's folder; default \"light\"",
        ),
    ],
};

/// What a reader may do with a live figure.
pub(super) static LIVE: TableRows = TableRows {
    header: "[live]",
    place: "`[live]`",
    fields: &[
        may("drag", Holds::Drags, "what may be moved; default: bodies and velocities that a layer draws"),
        may(
            "snap",
            Holds::Number { min: 0.0, max: MAX_NUMBER },
            "the step that places and lengths snap to, world units; 0 for none; default 0.25",
        ),
        may("steps", Holds::Switch, "buttons that lead through the algorithm's steps; default true"),
        may("time", Holds::Switch, "a playhead; default: where a panel's moment is not pinned"),
    ],
};

/// What a scene says of steps that follow one another.
pub(super) static STEP: TableRows = TableRows {
    header: "[[steps]]",
    place: "a step",
    fields: &[
        may(
            "until",
            Holds::Count { min: 1, max: MAX_ITERATIONS },
            "the last of its steps, numbered from 1 as they are without `[[steps]]`; default: the next",
        ),
        may("title", Holds::Text, "what it is called, plain text; default: as the last of its steps"),
        may("text", Holds::Text, "what it says, plain text; default: the sentences of its steps"),
        may("skip", Holds::Switch, "its marks come with the step after it, without words; default false"),
    ],
};

/// What makes a scene an exercise.
pub(super) static EXERCISE: TableRows = TableRows {
    header: "[exercise]",
    place: "the exercise",
    fields: &[
        must("ask", Holds::Texts("what is asked"), "names of values, as `depth`; `list values` has them"),
        may(
            "hide",
            Holds::Texts("what is hidden"),
            "layers and labels that the question leaves out besides those that show the answer",
        ),
        may("task", Holds::Text, "what is to be done, in the place of our sentence"),
        may("length_unit", Holds::Text, "unit of lengths; default \"units\""),
        may("time_unit", Holds::Text, "unit of times; default none: t runs from 0 to 1"),
    ],
};

/// Every table of a scene but the fields of the kinds of shape.
pub static TABLES: [&TableRows; 11] =
    [&ROOT, &BODY, &QUERY, &EXPECTED, &EXPECTED_POINTS, &PANEL, &LABEL, &CANVAS, &LIVE, &STEP, &EXERCISE];

/// All the rows of a kind of shape: first those of every shape, then its own.
///
/// ```
/// use tracefig::{geometry::shape::KINDS, scene::shape_rows};
/// let circle = KINDS.iter().find(|kind| kind.name == "circle").unwrap();
/// let keys: Vec<_> = shape_rows(circle).iter().map(|row| row.name).collect();
/// assert_eq!((keys[0], keys.contains(&"radius")), ("kind", true));
/// ```
#[must_use]
pub fn shape_rows(kind: &Kind) -> Vec<Field> {
    let own = kind.fields.iter().map(|f| Field {
        name: f.name,
        holds: match f.holds {
            FieldType::Length => ANY_NUMBER,
            FieldType::Count { min, max } => Holds::Count { min, max },
            FieldType::Point | FieldType::Extents => Holds::Pair,
            FieldType::Points { .. } => Holds::Points,
            FieldType::Switch => Holds::Switch,
        },
        required: f.required,
        about: f.about,
    });
    BODY.fields.iter().copied().chain(own).collect()
}

fn kind_words() -> Vec<String> {
    KINDS.iter().map(|k| k.name.to_owned()).collect()
}

fn query_words() -> Vec<String> {
    QUERIES.iter().map(|q| q.word.to_owned()).collect()
}

fn algorithm_words() -> Vec<String> {
    ALGORITHMS.iter().map(|a| a.name.to_owned()).collect()
}

fn outcome_words() -> Vec<String> {
    Verdict::ALL.map(|verdict| verdict.word().to_owned()).to_vec()
}

fn corner_words() -> Vec<String> {
    ["NE", "NW", "SE", "SW"].map(str::to_owned).to_vec()
}

fn space_words() -> Vec<String> {
    ["world", "configuration", "body"].map(str::to_owned).to_vec()
}
