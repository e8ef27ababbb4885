//! A shape with its pose and motion, as it will be written in a scene; and random ones.

use crate::float::Real;
use crate::json::Json;
use crate::placement::convex_core;
use crate::point::{Point, Rotation};
use crate::random::Random;

/// A shape as a scene writes it.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Radius, local center.
    Circle(f64, [f64; 2]),
    /// Half-extents.
    Aabb([f64; 2]),
    /// Half-extents, radius.
    Box([f64; 2], f64),
    /// Vertices, radius.
    Polygon(Vec<[f64; 2]>, f64),
    /// Two points, radius.
    Capsule([[f64; 2]; 2], f64),
    /// Vertices of a simple polygon.
    Outline(Vec<[f64; 2]>),
}

/// A body to be.
#[derive(Clone, Debug)]
pub struct Draft {
    /// Its shape.
    pub shape: Shape,
    /// World.
    pub position: [f64; 2],
    /// Degrees.
    pub angle: f64,
    /// World units a unit of time.
    pub velocity: [f64; 2],
    /// Degrees a unit of time.
    pub spin: f64,
}

impl Draft {
    /// At rest.
    #[must_use]
    pub fn still(shape: Shape, position: [f64; 2], angle: f64) -> Self {
        Self { shape, position, angle, velocity: [0.0, 0.0], spin: 0.0 }
    }

    /// Moving and turning.
    #[must_use]
    pub fn moving(self, velocity: [f64; 2], spin: f64) -> Self {
        Self { velocity, spin, ..self }
    }

    /// The body as a scene writes it; what is 0 is left out.
    #[must_use]
    pub fn json(&self) -> Json {
        let text = |word: &str| Json::Text(word.to_owned());
        let points = |list: &[[f64; 2]]| Json::List(list.iter().map(|p| Json::from_pair(*p)).collect());
        let mut json = match &self.shape {
            Shape::Circle(radius, center) => {
                let mut json = Json::object([("kind", text("circle")), ("radius", Json::Number(*radius))]);
                if *center != [0.0, 0.0] {
                    json.set("center", Json::from_pair(*center));
                }
                json
            }
            Shape::Aabb(half) => {
                Json::object([("kind", text("aabb")), ("half_extents", Json::from_pair(*half))])
            }
            Shape::Box(half, _) => {
                Json::object([("kind", text("box")), ("half_extents", Json::from_pair(*half))])
            }
            Shape::Polygon(list, _) => Json::object([("kind", text("polygon")), ("vertices", points(list))]),
            Shape::Capsule(ends, radius) => Json::object([
                ("kind", text("capsule")),
                ("points", points(ends)),
                ("radius", Json::Number(*radius)),
            ]),
            Shape::Outline(list) => Json::object([("kind", text("outline")), ("vertices", points(list))]),
        };
        if let Shape::Box(_, radius) | Shape::Polygon(_, radius) = &self.shape
            && *radius != 0.0
        {
            json.set("radius", Json::Number(*radius));
        }
        json.set("position", Json::from_pair(self.position));
        for (key, value) in [("angle_deg", self.angle), ("angular_velocity_deg", self.spin)] {
            if value != 0.0 && !matches!(self.shape, Shape::Aabb(_)) {
                json.set(key, Json::Number(value));
            }
        }
        if self.velocity != [0.0, 0.0] {
            json.set("velocity", Json::from_pair(self.velocity));
        }
        json
    }
}

impl Shape {
    /// Any convex kind, of about a size.
    pub fn any(random: &mut Random, size: f64) -> Self {
        let mut length = || size * random.between(0.2, 1.0);
        let half = [length(), length()];
        let small = 0.3 * length();
        match random.below(12) {
            0 | 1 => Self::Circle(half[0], [0.0, 0.0]),
            2 => Self::Circle(half[0], [random.between(-size, size), random.between(-size, size)]),
            3 => Self::Aabb(half),
            4 | 5 => Self::Box(half, 0.0),
            6 => Self::Box(half, small),
            7 => Self::capsule(random, size, small),
            8 => {
                let vertices = 3 + random.below(9);
                Self::polygon(random, vertices, half, small)
            }
            _ => {
                let vertices = 3 + random.below(9);
                Self::polygon(random, vertices, half, 0.0)
            }
        }
    }

    /// Any kind without radius, with an inside.
    pub fn sharp(random: &mut Random, size: f64) -> Self {
        let half = [size * random.between(0.2, 1.0), size * random.between(0.2, 1.0)];
        if random.once_in(2) {
            return Self::Box(half, 0.0);
        }
        let vertices = 3 + random.below(9);
        Self::polygon(random, vertices, half, 0.0)
    }

    /// A capsule of a core about as long as the size.
    pub fn capsule(random: &mut Random, size: f64, radius: f64) -> Self {
        let mut end = || [random.between(-size, size), random.between(-size, size)];
        let (from, mut to) = (end(), end());
        if from == to {
            to[0] += size;
        }
        Self::Capsule([from, to], radius)
    }

    /// A convex polygon with its vertices on an ellipse, either winding, starting anywhere. Its origin is
    /// inside.
    pub fn polygon(random: &mut Random, vertices: usize, half: [f64; 2], radius: f64) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "vertex counts are small")]
        let step = 360.0 / vertices as f64;
        let mut at = random.between(0.0, 360.0);
        let mut list: Vec<[f64; 2]> = Vec::with_capacity(vertices);
        let start = at;
        for k in 0..vertices {
            let turn = Rotation::of_degrees(Real::from(at));
            list.push([half[0] * turn.cos.to_f64(), half[1] * turn.sin.to_f64()]);
            #[expect(clippy::cast_precision_loss, reason = "vertex counts are small")]
            let next = start + step * (k + 1) as f64 + step * random.between(-0.3, 0.3);
            at = next;
        }
        if convex_core(&list).len() != vertices {
            return Self::Box(half, radius);
        }
        if random.once_in(2) {
            list.reverse();
        }
        Self::Polygon(list, radius)
    }
}

/// A box whose vertices are turned back by an angle and rounded, and turned by it again in the scene: its
/// edges are within an ulp or so of the axes, but not on them.
pub(super) fn turned_back(random: &mut Random, half: [f64; 2], position: [f64; 2]) -> Draft {
    let angle = random.between(-180.0, 180.0);
    let turn = Rotation::of_degrees(Real::from(angle));
    let [x, y] = half;
    let vertices = [[-x, -y], [x, -y], [x, y], [-x, y]].map(|vertex| {
        let local = Point::of(vertex).turned_back(turn);
        [local.x.to_f64(), local.y.to_f64()]
    });
    Draft::still(Shape::Polygon(vertices.to_vec(), 0.0), position, angle)
}

/// A vector of a length in a random direction.
pub(super) fn direction(random: &mut Random, length: f64) -> [f64; 2] {
    let turn = Rotation::of_degrees(Real::from(random.between(0.0, 360.0)));
    [length * turn.cos.to_f64(), length * turn.sin.to_f64()]
}

/// A point nudged by a vector, in doubles.
pub(super) fn nudged([x, y]: [f64; 2], by: Point) -> [f64; 2] {
    [(Real::from(x) + by.x).to_f64(), (Real::from(y) + by.y).to_f64()]
}

/// Both ways of a coin.
pub(super) fn sign(random: &mut Random) -> f64 {
    if random.once_in(2) { 1.0 } else { -1.0 }
}
