//! Shapes as *core polygon + radius*; one kind a file, each a row in [`KINDS`].
//!
//! A row says which fields a scene may give and how they become a [`Shape`]; the scene reader, `tracefig list` and
//! the error messages all read this table.

use glam::DVec2;

/// A shape in its body's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The word for it in a scene file.
    pub kind: &'static str,
    /// Vertices as written, in the file's order (a box's counter-clockwise from (−, −)); features are numbered by it.
    pub vertices: Vec<DVec2>,
    /// Radius of the disc that sweeps the core, in world units; 0 for sharp shapes.
    pub radius: f64,
    /// Half-extents of a box or AABB.
    pub half_extents: Option<DVec2>,
    /// Indices into `vertices` of the strictly convex core, counter-clockwise, duplicates and collinear corners
    /// dropped. Empty for an `outline`, which is not convex.
    pub core: Vec<usize>,
}

/// What a field of a shape holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldType {
    /// A number.
    Number,
    /// A pair of numbers.
    Point,
    /// A list of pairs.
    Points,
}

/// A value read for a field.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldValue {
    /// A number.
    Number(f64),
    /// A pair of numbers.
    Point(DVec2),
    /// A list of pairs.
    Points(Vec<DVec2>),
}

/// A field of a shape in a scene file.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its key.
    pub name: &'static str,
    /// What it holds.
    pub holds: FieldType,
    /// Whether a scene may leave it out.
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
    /// The fields besides `position`, `angle_deg`, `velocity`, `angular_velocity_deg`.
    pub fields: &'static [Field],
    /// Values in the order of `fields` (None where left out) to a shape.
    pub build: fn(&[Option<FieldValue>]) -> Result<Shape, ShapeError>,
    /// Whether a pose may turn it (an AABB may not).
    pub turns: bool,
}

/// Every kind of shape.
pub static KINDS: &[Kind] = &[];
