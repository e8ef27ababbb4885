//! Scenes that a program makes of values, without a text; checked as those of a file are.

use crate::collision::QueryKind;
use crate::geometry::shape::{KINDS, Kind};
use crate::geometry::{Angle, Body, DVec2};

use super::body::{ANGLES, MATRIX, Read, SPINS, short_name, unturned, with_article};
use super::checked::check;
use super::fields::{BODY, Field, MADE_SHAPE};
use super::node::{Node, NodeValue};
use super::problem::{Problem, Problems};
use super::{Canvas, LayerSpec, Live, Panel, Scene, Space, Spanned, Value, Variant, question};

/// A value that stands in no text.
impl<T> From<T> for Spanned<T> {
    fn from(value: T) -> Self {
        Self { value, span: 0..0 }
    }
}

impl Scene {
    /// A question about bodies that have names, A first, with the best algorithm for their shapes; without
    /// panels, so that the figure shows what suits the answer. All else may be set afterwards: the figure's
    /// plan checks texts, panels, layers, labels, steps and the page. All that is wrong becomes one error by
    /// `map_err(Refused::from)`.
    ///
    /// Shapes are those of [`Shape::of_kind`](crate::geometry::Shape::of_kind) and its kin; lengths are in
    /// world units.
    ///
    /// # Errors
    /// All that a scene file of these bodies would be refused for: numbers that are infinite or beyond
    /// 1e300, names of more than 40 characters, a body that turns where the question is about none,
    /// shapes that no algorithm takes.
    ///
    /// ```
    /// use tracefig::collision::{Answer, QueryKind};
    /// use tracefig::geometry::{Angle, Body, DVec2, Shape, shape::FieldValue};
    /// use tracefig::scene::Scene;
    /// let ball = |x: f64, radius: f64| -> Result<Body, Box<dyn std::error::Error>> {
    ///     let shape = Shape::of_kind("circle", &[("radius", FieldValue::Number(radius))])?;
    ///     let (position, still) = (DVec2::new(x, 0.0), Angle::ZERO);
    ///     Ok(Body { shape, position, angle: still, velocity: DVec2::ZERO, spin: still })
    /// };
    /// let pair = [("ball", ball(0.0, 1.0)?), ("wheel", ball(4.0, 2.0)?)];
    /// let scene = Scene::asking(QueryKind::Separation, &pair).unwrap();
    /// let Answer::Separation(found) = tracefig::solve(&scene) else { unreachable!() };
    /// assert_eq!(found.separation, 1.0);
    ///
    /// let astray = [("ball", ball(f64::NAN, 1.0)?), ("wheel", ball(4.0, 2.0)?)];
    /// let problems = Scene::asking(QueryKind::Separation, &astray).unwrap_err();
    /// assert!(problems[0].fault.to_string().starts_with("`ball.position`: expected"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn asking(kind: QueryKind, bodies: &[(&str, Body)]) -> Result<Self, Vec<Problem>> {
        let mut problems = Problems::default();
        let read: Vec<Read> = bodies.iter().map(|(name, body)| judged(name, body, &mut problems)).collect();
        let names = bodies.iter().map(|(name, _)| text(name)).collect();
        let asked = table([("kind", text(kind.word())), ("of", list(names))]);
        let query = question::read(&asked, &read, &mut problems);
        let shapes: Option<Vec<_>> = read.into_iter().map(|r| r.body.map(|body| (r.name, body))).collect();
        match (query, shapes) {
            (Some(query), Some(shapes)) if problems.is_empty() => Ok(Self {
                title: None,
                alt: None,
                lang: None,
                headline: None,
                caption: None,
                shapes,
                query,
                panels: Vec::new(),
                labels: Vec::new(),
                canvas: Canvas::default(),
                live: Live::default(),
                steps: Vec::new(),
                exercise: None,
                variant: Variant::default(),
            }),
            _ => Err(problems.into_sorted()),
        }
    }
}

impl Panel {
    /// A panel of a space that shows these layers, in drawing order, at the query's own moment.
    ///
    /// ```
    /// use tracefig::scene::{LayerSpec, Panel, Space};
    /// let panel = Panel::showing(Space::World, vec![LayerSpec::named("shapes")]);
    /// assert_eq!((panel.layers.unwrap().len(), panel.title), (1, None));
    /// ```
    #[must_use]
    pub fn showing(space: Space, layers: Vec<LayerSpec>) -> Self {
        Self {
            title: None,
            caption: None,
            space,
            when: None,
            layers: Some(layers),
            view: None,
            inset: None,
            inset_at: None,
            columns: None,
            span: 0..0,
        }
    }
}

impl LayerSpec {
    /// A layer by its name, without options.
    ///
    /// ```
    /// assert_eq!(tracefig::scene::LayerSpec::named("normal").name.value, "normal");
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self { name: name.to_owned().into(), options: Vec::new() }
    }

    /// The layer with one more option.
    ///
    /// ```
    /// use tracefig::scene::{LayerSpec, Value};
    /// let layer = LayerSpec::named("axes").with("ticks", Value::Bool(true));
    /// assert_eq!(layer.options[0].1.value, Value::Bool(true));
    /// ```
    #[must_use]
    pub fn with(mut self, key: &str, value: Value) -> Self {
        self.options.push((key.to_owned().into(), value.into()));
        self
    }
}

/// A body with its name; without the body where something about it is wrong, which has been noted.
fn judged(name: &str, body: &Body, p: &mut Problems) -> Read {
    let before = p.len();
    let spanned = Spanned::from(name.to_owned());
    short_name(&spanned, p);
    let rows: Vec<Field> = BODY.fields.iter().copied().chain(MADE_SHAPE).collect();
    let node = said(body);
    let checked = check(&node, name, &with_article(body.shape.kind), &rows, p);
    let kind = KINDS.iter().find(|kind: &&Kind| kind.name == body.shape.kind);
    if let (Some(table), Some(kind)) = (&checked, kind)
        && !kind.turns
    {
        unturned(kind, table, p);
    }
    let is_good = p.len() == before;
    p.of_body(before, name);
    Read { name: spanned, body: is_good.then(|| body.clone()) }
}

/// What a file would say of a body, and what its shape is made of.
fn said(body: &Body) -> Node {
    let shape = &body.shape;
    let turn = |angle: Angle, keys: [&'static str; 2]| match angle {
        Angle::Degrees(degrees) => (keys[0], number(degrees)),
        Angle::Radians(radians) => (keys[1], number(radians)),
    };
    table([
        ("kind", text(shape.kind)),
        ("position", pair(body.position)),
        ("velocity", pair(body.velocity)),
        turn(body.angle, ANGLES),
        turn(body.spin, SPINS),
        (MATRIX, pair(DVec2::new(shape.matrix.cos, shape.matrix.sin))),
        (MADE_SHAPE[0].name, list(shape.vertices.iter().copied().map(pair).collect())),
        (MADE_SHAPE[1].name, number(shape.radius)),
    ])
}

fn at_no_place(value: NodeValue) -> Node {
    Node { value, span: 0..0 }
}

pub(super) fn number(x: f64) -> Node {
    at_no_place(NodeValue::Number(x))
}

/// A count as a number of a file.
#[expect(
    clippy::cast_precision_loss,
    reason = "limits of counts are far below 2⁵³, and what is beyond is refused"
)]
pub(super) fn count(n: usize) -> f64 {
    n as f64
}

pub(super) fn text(text: &str) -> Node {
    at_no_place(NodeValue::Text(text.to_owned()))
}

pub(super) fn list(items: Vec<Node>) -> Node {
    at_no_place(NodeValue::List(items))
}

fn pair(p: DVec2) -> Node {
    list(vec![number(p.x), number(p.y)])
}

fn table<const N: usize>(entries: [(&str, Node); N]) -> Node {
    entries_of(entries.into())
}

/// A table of so many keys.
pub(super) fn entries_of(entries: Vec<(&str, Node)>) -> Node {
    let entries = entries.into_iter().map(|(key, node)| (key.to_owned().into(), node));
    at_no_place(NodeValue::Table(entries.collect()))
}

/// What a file would say of a value.
pub(super) fn node(value: &Value) -> Node {
    match value {
        Value::Bool(b) => at_no_place(NodeValue::Bool(*b)),
        Value::Number(x) => number(*x),
        Value::Text(words) => text(words),
        Value::List(items) => list(items.iter().map(|item| node(&item.value)).collect()),
    }
}

#[cfg(test)]
mod tests {
    use crate::collision::{Answer, QueryKind};
    use crate::geometry::shape::FieldValue;
    use crate::geometry::{Angle, Body, DVec2, Rotation, Shape};
    use crate::scene::{Scene, Source, read, solve};

    fn body(kind: &str, field: &str, value: FieldValue, x: f64) -> Body {
        let shape = Shape::of_kind(kind, &[(field, value)]).unwrap();
        let position = DVec2::new(x, 0.5);
        Body { shape, position, angle: Angle::ZERO, velocity: DVec2::ZERO, spin: Angle::ZERO }
    }

    fn crate_at(x: f64) -> Body {
        body("box", "half_extents", FieldValue::Point(DVec2::new(1.0, 0.5)), x)
    }

    fn codes(kind: QueryKind, bodies: &[(&str, Body)]) -> Vec<&'static str> {
        let wrong = Scene::asking(kind, bodies).err().unwrap_or_default();
        wrong.iter().map(|problem| problem.fault.code()).collect()
    }

    #[test]
    fn values_make_the_scene_that_a_text_makes() {
        let text =
            "shapes.A = { kind = 'box', half_extents = [1, 0.5], position = [0, 0.5], rotation = [0.8, 0.6] }
                    shapes.B = { kind = 'box', half_extents = [1, 0.5], position = [3, 0.5], angle_rad = 0.3 }
                    query = { kind = 'separation', of = ['A', 'B'] }";
        let told = read(&Source::new("s.toml", text)).unwrap();
        let (mut a, mut b) = (crate_at(0.0), crate_at(3.0));
        a.shape = a.shape.multiplied(Rotation { cos: 0.8, sin: 0.6 }).unwrap();
        b.angle = Angle::Radians(0.3);
        let made = Scene::asking(QueryKind::Separation, &[("A", a), ("B", b)]).unwrap();
        let bodies = |scene: &Scene| scene.shapes.iter().map(|(_, body)| body.clone()).collect::<Vec<_>>();
        assert_eq!(bodies(&told), bodies(&made));
        assert_eq!(told.query.algorithm.name, made.query.algorithm.name);
        assert_eq!(told.query.max_iterations, made.query.max_iterations);
        let [Answer::Separation(told), Answer::Separation(made)] = [solve(&told), solve(&made)] else {
            panic!("other answers")
        };
        assert_eq!((told.separation, told.bounds), (made.separation, made.bounds));
    }

    #[test]
    fn values_are_refused_where_a_text_is() {
        let kind = QueryKind::Separation;
        let of = |change: fn(&mut Body)| {
            let mut b = crate_at(3.0);
            change(&mut b);
            codes(kind, &[("A", crate_at(0.0)), ("B", b)])
        };
        assert_eq!(of(|_| {}), [""; 0]);
        assert_eq!(of(|b| b.position.x = f64::INFINITY).len(), 1);
        assert_eq!(of(|b| b.velocity.y = 1e301).len(), 1);
        assert_eq!(of(|b| b.angle = Angle::Radians(f64::NAN)).len(), 1);
        assert_eq!(of(|b| b.spin = Angle::Degrees(-1e301)).len(), 1);
        assert_eq!(of(|b| b.shape.vertices[2].y = f64::NAN).len(), 1);
        assert_eq!(of(|b| b.shape.radius = -1.0).len(), 1);
        assert_eq!(of(|b| b.shape.kind = "bxo"), ["unknown-word"]);
        let pair = |a: &'static str, b: &'static str| codes(kind, &[(a, crate_at(0.0)), (b, crate_at(3.0))]);
        assert_eq!(pair("A", "A"), ["conflict"]);
        assert_eq!(pair("A", "a name that is far too long to be written on it"), ["over-limit"]);
        assert_eq!(codes(kind, &[("A", crate_at(0.0))]), ["wrong-count"]);
        let mut turning = crate_at(3.0);
        turning.spin = Angle::Degrees(90.0);
        assert_eq!(codes(QueryKind::LinearSweep, &[("A", crate_at(0.0)), ("B", turning)]), ["turning-body"]);
        let mut fixed = body("aabb", "half_extents", FieldValue::Point(DVec2::ONE), 3.0);
        fixed.angle = Angle::Degrees(5.0);
        assert_eq!(codes(kind, &[("A", crate_at(0.0)), ("B", fixed)]), ["fixed-angle"]);
    }

    #[test]
    fn bodies_of_every_figure_may_be_asked_about_as_values() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
        let mut kinds = std::collections::BTreeSet::new();
        for file in std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()) {
            if file.extension().is_none_or(|extension| extension != "toml") {
                continue;
            }
            let told = crate::scene::open(&file).unwrap().scene;
            let of = told.query.of.iter().map(|&i| &told.shapes[i]);
            let bodies: Vec<(&str, Body)> = of.map(|(name, b)| (name.value.as_str(), b.clone())).collect();
            let made = Scene::asking(told.query.kind, &bodies).unwrap_or_else(|p| panic!("{file:?}: {p:?}"));
            assert_eq!(made.names().all(), told.names().all(), "{}", file.display());
            kinds.extend(bodies.iter().map(|(_, body)| body.shape.kind));
        }
        assert!(kinds.len() >= 5, "{kinds:?}");
    }
}
