//! Shapes as *core polygon + radius*; one kind a file, each a row in [`KINDS`].
//!
//! A row says which fields a scene may give and how they become a [`Shape`]; the scene reader, `tracefig
//! list` and the error messages all read this table.

mod aabb;
mod capsule;
mod circle;
mod convex;
mod feature;
mod matrix;
mod oriented_box;
mod outline;
mod polygon;
mod regular_polygon;
mod values;

use glam::DVec2;

pub use feature::Edges;

use values::{
    SWEEPING_RADIUS, finite, finite_point, half_extents_value, optional_radius, points_value, radius_value,
    switch_value, unusable, value,
};

#[cfg(test)]
use super::Feature;
use super::Hull;
use super::Rotation;

/// A shape in its body's frame, made by its constructors: what is set in one field alone, others do not know.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The word for it in a scene file.
    pub kind: &'static str,
    /// Vertices as written, in the file's order (a box's counter-clockwise from (−, −)); features are
    /// numbered by it.
    pub vertices: Vec<DVec2>,
    /// Radius of the disc that sweeps the core, in world units; 0 for sharp shapes.
    pub radius: f64,
    /// Half-extents of a box or AABB.
    pub half_extents: Option<DVec2>,
    /// How far the vertices of a regular polygon are from its middle, as the scene has it.
    pub circumradius: Option<f64>,
    /// Indices into `vertices` of the strictly convex core, counter-clockwise, duplicates and collinear
    /// vertices dropped. Empty for an `outline`, which is not convex.
    pub core: Vec<usize>,
    /// The core, multiplied by `matrix` and prepared for queries: `hull.vertices[k]` is that of
    /// `vertices[core[k]]`.
    pub hull: Hull,
    /// Which vertices the edges run between.
    pub edges: Edges,
    /// The matrix that multiplies core points before anything else is done with them: none, or a rotation by
    /// its cosine and sine as an engine has them, which need not be of length 1 exactly.
    pub matrix: Rotation<f64>,
}

/// What a field of a shape holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldType {
    /// A number, 0 or more.
    Length,
    /// A whole number in a closed range.
    Count {
        /// The smallest that is allowed.
        min: usize,
        /// The largest that is allowed.
        max: usize,
    },
    /// A pair of numbers.
    Point,
    /// A pair of numbers above 0.
    Extents,
    /// A list of pairs.
    Points {
        /// The least number of them.
        min: usize,
    },
    /// True or false.
    Switch,
}

/// A value read for a field.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldValue {
    /// A number.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// A pair of numbers.
    Point(DVec2),
    /// A list of pairs.
    Points(Vec<DVec2>),
    /// True or false.
    Switch(bool),
}

/// A field of a shape in a scene file.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its key.
    pub name: &'static str,
    /// What it holds.
    pub holds: FieldType,
    /// Whether a scene must give it.
    pub required: bool,
    /// One line for `tracefig list`, with its unit.
    pub about: &'static str,
}

/// Why values do not make a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeError {
    /// Stable word for programs, as `not-convex`; `tracefig list errors` prints all.
    pub code: &'static str,
    /// The field at fault.
    pub field: &'static str,
    /// The element of that field at fault, where there is one (a vertex index).
    pub element: Option<usize>,
    /// "expected X, got Y".
    pub message: String,
}

/// A kind of shape.
pub struct Kind {
    /// The word in a scene file.
    pub name: &'static str,
    /// One line for `tracefig list`.
    pub about: &'static str,
    /// What it is to a reader who does not see it, with its article: "a circle"; in English, German, French
    /// and Spanish.
    pub in_words: [&'static str; 4],
    /// The fields besides those of every body: where it is, how it is turned and how it moves.
    pub fields: &'static [Field],
    /// Values in the order of `fields` (None where left out) to a shape.
    pub build: fn(&[Option<FieldValue>]) -> Result<Shape, ShapeError>,
    /// Whether a pose may turn it (an AABB may not).
    pub turns: bool,
    /// Which key of a scene sets a vertex.
    pub(crate) vertices: VertexKey,
}

/// Which key of a scene sets a vertex of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum VertexKey {
    /// No key does.
    None,
    /// The list under this key has a point for each.
    Each(&'static str),
    /// The pair under this key is how far each is from the middle, along x and y.
    Half(&'static str),
}

/// Every kind of shape.
pub static KINDS: &[Kind] = &[
    circle::KIND,
    aabb::KIND,
    oriented_box::KIND,
    polygon::KIND,
    regular_polygon::KIND,
    capsule::KIND,
    outline::KIND,
];

/// Every code of a [`ShapeError`], with what it says.
pub static SHAPE_ERRORS: &[(&str, &str)] = &[
    ("missing-field", "a field that this kind of shape needs is not there"),
    ("wrong-type", "a field holds another type of value"),
    ("not-finite", "a number is infinite or not a number"),
    ("too-large", "a number of a shape is beyond ±1e300, where sums overflow"),
    ("negative-radius", "a radius is below 0"),
    ("negative-extent", "a half-extent is below 0"),
    ("degenerate", "a box without width or height, or vertices that all lie on one line"),
    ("wrong-count", "a capsule has other than two points, or a regular polygon too many edges"),
    ("too-few-corners", "a polygon has fewer than three distinct vertices"),
    ("not-convex", "a polygon turns back on itself or has a vertex that points inward"),
    ("not-simple", "an outline crosses or touches itself"),
    ("not-a-rotation", "a cosine and a sine whose squares do not add up to 1, to 1e-3"),
];

impl Shape {
    /// A shape of the kind `name` from `(field, value)` pairs, in its body's frame and world units;
    /// [`KINDS`] has the kinds and their fields.
    ///
    /// # Errors
    /// A [`ShapeError`] where a field is missing, unknown or the values do not make such a shape.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Shape, shape::FieldValue};
    /// let square = Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::ONE))]).unwrap();
    /// assert_eq!(square.vertices.len(), 4);
    /// let error = Shape::of_kind("circle", &[("radius", FieldValue::Number(-1.0))]).unwrap_err();
    /// assert_eq!(error.code, "negative-radius");
    /// let error = Shape::of_kind("circle", &[("raduis", FieldValue::Number(1.0))]).unwrap_err();
    /// assert!(error.to_string().contains("expected one of radius, center, got raduis"), "{error}");
    /// ```
    pub fn of_kind(name: &str, fields: &[(&str, FieldValue)]) -> Result<Self, ShapeError> {
        let Some(kind) = KINDS.iter().find(|kind| kind.name == name) else {
            return Err(ShapeError::new(
                "wrong-type",
                "kind",
                format!("expected a kind of shape, got {name}"),
            ));
        };
        let known = |key: &str| kind.fields.iter().any(|field| field.name == key);
        if let Some((key, _)) = fields.iter().find(|(key, _)| !known(key)) {
            let names: Vec<&str> = kind.fields.iter().map(|field| field.name).collect();
            let expected = format!("expected one of {}, got {key}", names.join(", "));
            return Err(ShapeError::new("wrong-type", "fields", expected));
        }
        let values: Vec<Option<FieldValue>> = kind
            .fields
            .iter()
            .map(|field| fields.iter().find(|(key, _)| *key == field.name).map(|(_, value)| value.clone()))
            .collect();
        (kind.build)(&values)
    }

    /// A shape of one or two vertices, or of vertices that are known to be convex and counter-clockwise.
    fn convex(kind: &'static str, vertices: Vec<DVec2>, radius: f64) -> Self {
        let core = (0..vertices.len()).collect();
        let hull = Hull::new(vertices.clone());
        Self { radius, core, hull, ..Self::bare(kind, vertices) }
    }

    /// A shape of sharp vertices without a core.
    pub(crate) fn bare(kind: &'static str, vertices: Vec<DVec2>) -> Self {
        Self {
            kind,
            vertices,
            radius: 0.0,
            half_extents: None,
            circumradius: None,
            core: Vec::new(),
            hull: Hull::default(),
            edges: Edges::OfFile,
            matrix: Rotation::NONE,
        }
    }
}

impl std::fmt::Display for ShapeError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "`{}`: {}", self.field, self.message)
    }
}

impl std::error::Error for ShapeError {}

impl ShapeError {
    /// An error without an element.
    fn new(code: &'static str, field: &'static str, message: String) -> Self {
        Self { code, field, element: None, message }
    }

    /// An error at an element.
    fn at(code: &'static str, field: &'static str, element: usize, message: String) -> Self {
        Self { code, field, element: Some(element), message }
    }
}

/// The vertices of a box, counter-clockwise from (−, −).
fn box_of(kind: &'static str, h: DVec2, radius: f64) -> Shape {
    let vertices = vec![-h, DVec2::new(h.x, -h.y), h, DVec2::new(-h.x, h.y)];
    Shape { half_extents: Some(h), ..Shape::convex(kind, vertices, radius) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[(f64, f64)]) -> Result<Shape, ShapeError> {
        let points = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
        Shape::of_kind("polygon", &[("vertices", FieldValue::Points(points))])
    }

    #[test]
    fn collinear_and_duplicate_vertices_are_dropped_and_edges_keep_the_files_numbers() {
        let shape =
            polygon(&[(-1., -1.), (0., -1.), (1., -1.), (1., -1.), (1., 0.), (1., 1.), (-1., 1.), (-1., 0.)])
                .unwrap();
        assert_eq!(shape.core.len(), 4);
        let right = shape.hull.normals.iter().position(|n| n.x == 1.0).unwrap();
        assert_eq!(shape.edge_feature(right, DVec2::new(1.0, 0.25)), Feature::Edge(4));
        assert_eq!(shape.edge_feature(right, DVec2::new(1.0, -0.25)), Feature::Edge(3));
    }

    #[test]
    fn a_clockwise_polygon_keeps_its_files_numbers() {
        let shape = polygon(&[(0., 0.), (0., 1.), (1., 1.), (1., 0.)]).unwrap();
        let right = shape.hull.normals.iter().position(|n| n.x == 1.0).unwrap();
        assert_eq!(shape.edge_feature(right, DVec2::new(1.0, 0.5)), Feature::Edge(2));
        let bottom = shape.hull.normals.iter().position(|n| n.y == -1.0).unwrap();
        assert_eq!(shape.edge_feature(bottom, DVec2::new(0.5, 0.0)), Feature::Edge(3));
    }

    #[test]
    fn what_is_not_convex_is_refused_exactly() {
        let code = |points: &[(f64, f64)]| polygon(points).unwrap_err().code;
        assert_eq!(code(&[(0., 0.), (2., 0.), (1., 0.5), (1., 2.)]), "not-convex");
        assert_eq!(code(&[(0., 0.), (1., 0.)]), "too-few-corners");
        assert_eq!(code(&[(0., 0.), (1., 0.), (1., 0.), (0., 0.)]), "too-few-corners");
        assert_eq!(code(&[(0., 0.), (1., 0.), (2., 0.)]), "degenerate");
        assert_eq!(code(&[(0., 0.), (f64::NAN, 0.), (2., 0.)]), "not-finite");
        // A pentagram turns left at every vertex, twice round.
        assert_eq!(code(&[(0., 1.), (-0.6, -0.8), (0.95, 0.3), (-0.95, 0.3), (0.6, -0.8)]), "not-convex");
        // A spike that comes back on its own line.
        assert_eq!(code(&[(0., 0.), (2., 0.), (1., 0.), (1., 1.)]), "not-convex");
        // Convex by one ulp, and not convex by one.
        let bump = 1.0_f64.next_up();
        assert!(polygon(&[(0., 0.), (2., 0.), (2., 1.), (1., bump), (0., 1.)]).is_ok());
        assert_eq!(code(&[(0., 0.), (2., 0.), (2., 1.), (1., 1.0_f64.next_down()), (0., 1.)]), "not-convex");
    }

    #[test]
    fn denormal_vertices_are_judged_exactly() {
        let d = f64::from_bits(3);
        assert_eq!(polygon(&[(0., 0.), (d, 0.), (d, d), (0., d)]).unwrap().core.len(), 4);
        assert_eq!(polygon(&[(0., 0.), (d, d), (2. * d, 2. * d)]).unwrap_err().code, "degenerate");
    }

    #[test]
    fn a_box_without_width_is_degenerate_and_a_capsule_of_one_point_is_a_point() {
        let code = |x, y| {
            Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::new(x, y)))]).unwrap_err().code
        };
        assert_eq!((code(0.0, 1.0), code(1.0, -1.0)), ("degenerate", "negative-extent"));
        let points = FieldValue::Points(vec![DVec2::ONE, DVec2::ONE]);
        let capsule =
            Shape::of_kind("capsule", &[("points", points), ("radius", FieldValue::Number(0.5))]).unwrap();
        assert_eq!((capsule.hull.vertices.len(), capsule.vertices.len()), (1, 2));
    }

    #[test]
    fn every_kind_has_a_word_of_its_own_and_wants_a_field() {
        for (i, kind) in KINDS.iter().enumerate() {
            assert!(KINDS[..i].iter().all(|other| other.name != kind.name), "{} twice", kind.name);
            let nothing: Vec<_> = kind.fields.iter().map(|_| None).collect();
            assert_eq!((kind.build)(&nothing).unwrap_err().code, "missing-field", "{}", kind.name);
        }
    }

    #[test]
    fn every_code_is_in_the_table() {
        for code in
            ["negative-radius", "degenerate", "not-convex", "not-simple", "wrong-count", "missing-field"]
        {
            assert!(SHAPE_ERRORS.iter().any(|(listed, _)| *listed == code), "{code}");
        }
    }
}
