//! The scene file: what it may hold, how it is read, and what is wrong with it.

mod answer;
mod answer_fields;
mod asked;
mod asked_with;
mod body;
mod canvas;
mod checked;
pub(crate) mod codes;
mod elsewhere;
mod exercise;
mod expected;
mod explain;
mod fields;
#[cfg(not(tracefig_page))]
mod foreign;
mod holds;
mod house_panels;
mod json;
mod labels;
pub mod limits;
mod live;
mod meaning;
#[cfg(not(tracefig_page))]
mod meant;
mod message;
mod moment;
mod node;
mod open;
mod panels;
mod problem;
#[cfg(not(tracefig_page))]
mod project;
mod project_fields;
mod question;
mod read;
mod recognized;
mod remedy;
mod schema;
pub(crate) mod set;
mod solution;
mod source;
mod steps;
mod stream;
mod suggest;
#[cfg(not(tracefig_page))]
mod toml;
#[cfg(not(tracefig_page))]
mod toml_slips;
mod varied;
mod visible;

use std::ops::Range;

pub use answer::{answer_json, answer_text};
pub use answer_fields::{LINE_FIELDS, answer_fields};
pub use canvas::{Background, Canvas, Height};
pub use codes::{ERRORS, ErrorCode};
pub use exercise::{Exercise, Variant};
pub use explain::Explain;
pub use fields::{Field, TABLES, TableRows, shape_rows};
pub use holds::Holds;
#[cfg(test)]
pub(crate) use house_panels::as_json;
pub(crate) use labels::COMPASS;
pub use live::{Drag, Grip, Live};
pub(crate) use message::NOTES;
pub use message::{Ink, Severity, message};
pub use moment::When;
pub use open::{Refused, SceneFile, open, open_reader, open_text};
pub(crate) use panels::of_text as panels_of_text;
pub use problem::{Fault, Problem};
#[cfg(not(tracefig_page))]
pub use project::{CanvasDefaults, DeclaredHandout, PROJECT_FILE, Project, project};
pub use project_fields::{PROJECT_TABLES, STEP_FILES};
pub use read::read;
pub use recognized::is_scene;
pub use schema::{one_of, project_schema, schema};
pub use solution::Solution;
pub use source::{Place, Source, Syntax};
pub use steps::StepWords;
pub use stream::{
    Reply, jsonl_name, open_jsonl_line, refuse_jsonl_line, refuse_long_jsonl_line, refused_bytes,
    refused_length, solve, solve_jsonl_line,
};
pub use varied::{Numbers, Template};
pub use visible::visible;

use crate::collision::{Algorithm, Expected, Query, QueryKind};
use crate::geometry::{Body, Names};

/// A value with its place in the source.
#[derive(Clone, Debug, PartialEq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Where it stands, in bytes of the source text.
    pub span: Range<usize>,
}

/// A scene, checked.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Title of the figure, as markup; none stands over it where it is `None`.
    pub title: Option<Spanned<String>>,
    /// Short alternative text, as markup; without it one is made from title and answer.
    pub alt: Option<Spanned<String>>,
    /// Language that the texts are written in, as `de` or `pt-BR`.
    pub lang: Option<Spanned<String>>,
    /// What the figure claims, in a sentence above its panels, as markup.
    pub headline: Option<Spanned<String>>,
    /// Caption below the figure, as markup.
    pub caption: Option<Spanned<String>>,
    /// Bodies with their names, in file order: those of the query, and others as context.
    pub(crate) shapes: Vec<(Spanned<String>, Body)>,
    /// The question that the scene asks.
    pub(crate) query: SceneQuery,
    /// Panels in file order; none where the figure shows what suits the answer.
    pub panels: Vec<Panel>,
    /// Overrides of labels by key, in file order.
    pub labels: Vec<(Spanned<String>, LabelOverride)>,
    /// The page that the figure is drawn on.
    pub canvas: Canvas,
    /// What a reader may move where the figure is live.
    pub live: Live,
    /// What is said of the steps in which the figure comes about, in their order.
    pub steps: Vec<StepWords>,
    /// What makes it an exercise; `None` for other scenes.
    pub exercise: Option<Exercise>,
    /// Which variant of an exercise is drawn.
    pub variant: Variant,
}

impl Scene {
    /// The question with its bodies, at the query's own time, as an algorithm takes it.
    ///
    /// ```
    /// let query = "[query]\nkind = 'bounds'\nof = ['A']\ntime = 0.5";
    /// let text = format!("[shapes.A]\nkind = 'circle'\nradius = 2\n{query}");
    /// let scene = tracefig::scene::open_text("s.toml", &text)?.scene;
    /// let query = scene.query_of_bodies();
    /// assert_eq!((query.a.shape.radius, query.b, query.time), (2.0, None, 0.5));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn query_of_bodies(&self) -> Query<'_> {
        self.query_at(self.query.time)
    }

    /// Bodies with their names, in file order: those of the query, and others as context. They and the query
    /// were checked together, and stay as they are.
    ///
    /// ```
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
    /// let scene = tracefig::scene::open_text("s.toml", text)?.scene;
    /// let (name, body) = &scene.shapes()[0];
    /// assert_eq!((name.value.as_str(), body.shape.radius), ("A", 2.0));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn shapes(&self) -> &[(Spanned<String>, Body)] {
        &self.shapes
    }

    /// The question that the scene asks, with the algorithm that answers it; [`Scene::asked_with`] asks it
    /// otherwise.
    ///
    /// ```
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
    /// let scene = tracefig::scene::open_text("s.toml", text)?.scene;
    /// assert_eq!((scene.query().algorithm.name, scene.query().time), ("extremes", 0.0));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn query(&self) -> &SceneQuery {
        &self.query
    }

    /// What the bodies of the query are called.
    ///
    /// ```
    /// let query = "[query]\nkind = 'bounds'\nof = ['crate_1']";
    /// let text = format!("[shapes.crate_1]\nkind = 'circle'\nradius = 2\n{query}");
    /// assert_eq!(tracefig::scene::open_text("s.toml", &text)?.scene.names().all(), "crate_1");
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn names(&self) -> Names {
        let name = |i: usize| self.query.of.get(i).and_then(|&shape| self.shapes.get(shape));
        let [a, b] = [0, 1].map(|i| name(i).map(|(name, _)| visible(&name.value)));
        self.known(Names::new(&a.unwrap_or_default(), b.as_deref()))
    }

    /// Names of the query's bodies with what is known of those: which are circles of a size, and whether one
    /// has a radius.
    pub(crate) fn known(&self, names: Names) -> Names {
        let body = |i: usize| self.query.of.get(i).and_then(|&shape| self.shapes.get(shape));
        let shapes = [0, 1].map(|i| body(i).map(|(_, body)| &body.shape));
        let is_round = shapes.map(|shape| shape.is_some_and(|shape| shape.radius > 0.0));
        let is_point = shapes.map(|shape| shape.is_some_and(|shape| shape.vertices.len() == 1));
        names.of_circles([0, 1].map(|i| is_round[i] && is_point[i])).of_rounds([0, 1].map(|i| is_round[i]))
    }

    /// The question with its bodies at another moment: `time` counts from 0, the start of the motion, to 1,
    /// its end. Poses and answer are in the world's frame and units.
    pub(crate) fn query_at(&self, time: f64) -> Query<'_> {
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
    /// What is asked of the bodies.
    pub kind: QueryKind,
    /// Indices into [`Scene::shapes`]: A, then B.
    pub of: Vec<usize>,
    /// The algorithm that the scene names, or the best for its shapes.
    pub algorithm: &'static Algorithm,
    /// The moment in [0, 1] that bounds, overlap and separation are asked at; else 0.
    pub time: f64,
    /// How close counts as contact, in world units, for algorithms that iterate.
    pub tolerance: f64,
    /// Steps after which an algorithm gives up and says so.
    pub max_iterations: usize,
    /// What someone else answered, where the scene says it.
    pub expected: Option<Expected>,
    /// Where the table `[query]` is, in bytes of the source.
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

/// The space that a panel shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Space {
    /// The world, y up.
    World,
    /// Configuration space: B ⊖ A = {b − a}, in which A against B is the origin against one shape.
    Configuration,
    /// The frame of a body, by its index into [`Scene::shapes`].
    Body(usize),
}

/// One of the pictures that stand side by side in a figure.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The title above it, as markup.
    pub title: Option<Spanned<String>>,
    /// What leads through it, below it, as markup.
    pub caption: Option<Spanned<String>>,
    /// The space that it shows.
    pub space: Space,
    /// The moment that it shows; `None` is the query's own.
    pub when: Option<Spanned<When>>,
    /// The layers in drawing order; `None` shows those that suit the answer.
    pub layers: Option<Vec<LayerSpec>>,
    /// A rectangle of its space that must be visible, x0, y0, x1, y1 in world units; `None` fits what is
    /// drawn.
    pub view: Option<Spanned<[f64; 4]>>,
    /// What is drawn again, enlarged, in a corner.
    pub inset: Option<Spanned<Detail>>,
    /// The corner of the enlargement, as "NE"; `None` takes the one where it hides least.
    pub inset_at: Option<Spanned<String>>,
    /// The columns of the page that it is wide, from 1; `None` is one.
    pub columns: Option<usize>,
    /// Where the panel's table is, in bytes of the source.
    pub span: Range<usize>,
}

/// What an inset of a panel enlarges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Detail {
    /// A rectangle of the panel's space: x0, y0, x1, y1 in world units.
    Rectangle([f64; 4]),
    /// A length of the answer that is too small to be seen in the panel, if there is one.
    Small,
}

impl Detail {
    /// The word for [`Detail::Small`] in a scene.
    pub const SMALL: &'static str = "small";
}

/// A layer as asked for; names and options are checked by the figure's table of layers.
#[derive(Clone, Debug)]
pub struct LayerSpec {
    /// The word for the layer, which may be none that exists.
    pub name: Spanned<String>,
    /// Options by key, in file order.
    pub options: Vec<(Spanned<String>, Spanned<Value>)>,
}

/// A value of an option.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A flag: `true` or `false`.
    Bool(bool),
    /// Any finite number.
    Number(f64),
    /// Any text.
    Text(String),
    /// Values in order.
    List(Vec<Spanned<Value>>),
}

/// What a scene says of a label.
#[derive(Clone, Debug, Default)]
pub struct LabelOverride {
    /// Markup in the place of the usual text.
    pub text: Option<Spanned<String>>,
    /// Where it must stand; `None` lets it find a place.
    pub at: Option<Spanned<LabelPlace>>,
    /// Whether it is left out.
    pub hide: bool,
}

/// A pinned place of a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LabelPlace {
    /// One of the eight directions of the compass, from 0 = E counter-clockwise in steps of 45°.
    Compass(u8),
    /// Offset of the label's centre from its anchor, page pixels, x right, y down.
    Offset(f64, f64),
}
