//! The scene file: what it may hold, how it is read, and what is wrong with it.

mod answer;
mod body;
mod checked;
mod codes;
mod fields;
mod json;
mod labels;
pub mod limits;
mod message;
mod node;
mod open;
mod panels;
mod problem;
mod question;
mod read;
mod schema;
mod source;
mod stream;
mod suggest;
mod toml;

use std::ops::Range;

pub use answer::{answer_json, answer_text};
pub use codes::{ERRORS, ErrorCode};
pub use fields::{Field, Holds, TABLES, TableRows, shape_rows};
pub use message::{Ink, Severity, message};
pub use open::{Refused, SceneFile, open, open_reader, open_text};
pub use problem::{Fault, Problem};
pub use read::read;
pub use schema::schema;
pub use source::{Place, Source, Syntax};
pub use stream::{Reply, refuse_jsonl_line, solve, solve_jsonl_line};

use crate::collision::{Algorithm, Query, QueryKind};
use crate::geometry::Body;

/// A value and its bytes in the source.
#[derive(Clone, Debug, PartialEq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Its place: bytes of the source text (for JSON see `pointer` of the error).
    pub span: Range<usize>,
}

/// A scene, checked.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Title of the figure, markup.
    pub title: Option<Spanned<String>>,
    /// Caption, markup.
    pub caption: Option<Spanned<String>>,
    /// Bodies in file order.
    pub shapes: Vec<(Spanned<String>, Body)>,
    /// The question.
    pub query: SceneQuery,
    /// Panels in file order; may be empty.
    pub panels: Vec<Panel>,
    /// Overrides of labels by key, in file order.
    pub labels: Vec<(Spanned<String>, LabelOverride)>,
    /// The page.
    pub canvas: Canvas,
}

impl Scene {
    /// The question with its bodies, as an algorithm takes it.
    #[must_use]
    pub fn query_of_bodies(&self) -> Query<'_> {
        self.query_at(self.query.time)
    }

    /// The same question at another moment.
    #[must_use]
    pub fn query_at(&self, time: f64) -> Query<'_> {
        // The reader has checked that a query is of one or two shapes that exist.
        let body =
            |i: usize| self.query.of.get(i).and_then(|&shape| self.shapes.get(shape)).map(|(_, body)| body);
        let SceneQuery { kind, tolerance, max_iterations, .. } = self.query;
        Query { kind, a: body(0).unwrap_or(&self.shapes[0].1), b: body(1), time, tolerance, max_iterations }
    }
}

/// The question of a scene.
#[derive(Clone)]
pub struct SceneQuery {
    /// What is asked.
    pub kind: QueryKind,
    /// Indices into `shapes`: A, then B.
    pub of: Vec<usize>,
    /// As asked for, or the default of the pair.
    pub algorithm: &'static Algorithm,
    /// The moment, for bounds, overlap, separation.
    pub time: f64,
    /// World units.
    pub tolerance: f64,
    /// Step cap.
    pub max_iterations: usize,
    /// Where the table is.
    pub span: Range<usize>,
}

impl std::fmt::Debug for SceneQuery {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SceneQuery")
            .field("kind", &self.kind)
            .field("of", &self.of)
            .field("algorithm", &self.algorithm.name)
            .finish_non_exhaustive()
    }
}

/// Space that a panel shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Space {
    /// The world.
    World,
    /// B ⊖ A.
    Configuration,
    /// The frame of a body: index into `shapes`.
    Body(usize),
}

/// A moment as a panel or layer names it.
#[derive(Clone, Debug, PartialEq)]
pub enum When {
    /// A number in [0, 1].
    Time(f64),
    /// t = 0.
    Start,
    /// First contact.
    Hit,
    /// t = 1.
    End,
    /// The algorithm's step, from 1.
    Step(usize),
}

/// A panel.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Markup.
    pub title: Option<Spanned<String>>,
    /// What it shows.
    pub space: Space,
    /// Its moment, with its place; None: the query's own.
    pub when: Option<Spanned<When>>,
    /// In drawing order.
    pub layers: Vec<LayerSpec>,
    /// World rectangle that must be visible: x0, y0, x1, y1.
    pub view: Option<Spanned<[f64; 4]>>,
    /// Where the panel's table is.
    pub span: Range<usize>,
}

/// A layer as asked for; names and options are checked by the figure's table of layers.
#[derive(Clone, Debug)]
pub struct LayerSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Its options, in file order.
    pub options: Vec<(Spanned<String>, Spanned<Value>)>,
}

/// A value of an option.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// true or false.
    Bool(bool),
    /// Any finite number.
    Number(f64),
    /// A string.
    Text(String),
    /// A list.
    List(Vec<Spanned<Value>>),
}

/// What a scene says of a label.
#[derive(Clone, Debug, Default)]
pub struct LabelOverride {
    /// Markup instead of the default.
    pub text: Option<Spanned<String>>,
    /// Where it must stand.
    pub at: Option<Spanned<LabelPlace>>,
    /// Not drawn.
    pub hide: bool,
}

/// A pinned place of a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LabelPlace {
    /// One of the eight directions, from 0 = E counter-clockwise in steps of 45°.
    Compass(u8),
    /// Offset of the label's centre from its anchor, page pixels, x right, y down.
    Offset(f64, f64),
}

/// The page.
#[derive(Clone, Debug)]
pub struct Canvas {
    /// Page pixels, 960 unless given.
    pub width: f64,
    /// Page pixels, 540 unless given.
    pub height: f64,
    /// Name of a theme, checked by the figure's table of themes.
    pub theme: Option<Spanned<String>>,
}
