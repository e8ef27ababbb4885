//! A scene as a line of JSON: its bodies as *core polygon + radius*, in the doubles of the file, and its
//! question.

use crate::float::Real;
use crate::json::Json;
use crate::point::{Point, Rotation, radians};

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// AABB of one or two bodies.
    Bounds,
    /// Do they overlap?
    Overlap,
    /// Signed separation.
    Separation,
    /// First contact without turning.
    LinearSweep,
    /// First contact.
    TimeOfImpact,
    /// How far a point of the body, or of two relative to each other, can move.
    MotionBound,
    /// Where two bodies touch, by an edge clipped against another.
    Contact,
}

impl Kind {
    /// All, with their words.
    pub const ALL: [(Kind, &'static str); 7] = [
        (Kind::Bounds, "bounds"),
        (Kind::Overlap, "overlap"),
        (Kind::Separation, "separation"),
        (Kind::LinearSweep, "linear-sweep"),
        (Kind::TimeOfImpact, "time-of-impact"),
        (Kind::MotionBound, "motion-bound"),
        (Kind::Contact, "contact"),
    ];

    /// Its word in a scene.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|(kind, _)| *kind == self).map_or("", |(_, word)| word)
    }
}

/// An angle as it is written: so many degrees and so many radians, exactly, of which a scene gives one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Angle {
    /// Degrees.
    pub degrees: f64,
    /// Radians.
    pub radians: f64,
}

impl Angle {
    /// As radians.
    #[must_use]
    pub fn in_radians(self) -> Real {
        radians(Real::from(self.degrees)) + Real::from(self.radians)
    }
}

/// A body: world units, t in [0, 1].
#[derive(Clone, Debug)]
pub struct Body {
    /// Vertices in the file's order, in the body's frame; features are numbered by it.
    pub vertices: Vec<[f64; 2]>,
    /// Whether the vertices close to a ring (a capsule's and a circle's do not).
    pub ring: bool,
    /// Whether the body is the convex hull of the vertices, whatever their order.
    pub hull: bool,
    /// The matrix ((c, −s), (s, c)) that the vertices are multiplied by before they are turned; its numbers
    /// are used as written.
    pub matrix: [f64; 2],
    /// Radius of the disc that sweeps the core.
    pub radius: f64,
    /// World place of the body's origin at t = 0.
    pub position: [f64; 2],
    /// Turn from the file's frame at t = 0.
    pub angle: Angle,
    /// World units a unit of time.
    pub velocity: [f64; 2],
    /// Turn a unit of time.
    pub spin: Angle,
}

/// A scene.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The id as written; null if left out.
    pub id: Json,
    /// The bodies of the query: A, then B.
    pub bodies: Vec<Body>,
    /// What is asked.
    pub kind: Kind,
    /// The moment of static questions.
    pub time: f64,
    /// The tolerance as written; the default of the file format is 1e-12.
    pub tolerance: f64,
    /// Whether the algorithm asked for stops by a count of steps, so that it may leave open what others
    /// decide.
    ///
    /// The names of those that do are written out where a scene is read: this package shares no code with the
    /// crate that it checks, not its table of algorithms either.
    pub iterates: bool,
    /// `expected`, where a line has it.
    pub expected: Option<Json>,
}

impl Scene {
    /// Reads a line.
    ///
    /// # Errors
    /// Says what is missing; generated scenes and the committed ones are well-formed.
    pub fn parse(line: &str) -> Result<Self, String> {
        let json = Json::parse(line)?;
        let query = json.get("query").ok_or("no query")?;
        let word = query.text_at("kind").ok_or("no kind")?;
        let kind = Kind::ALL.iter().find(|(_, w)| *w == word).map(|(kind, _)| *kind).ok_or("unknown kind")?;
        let names = match query.get("of") {
            Some(Json::Text(name)) => vec![name.as_str()],
            Some(of) => of.list().iter().filter_map(Json::text).collect(),
            None => return Err("no `of`".to_owned()),
        };
        let shapes = json.get("shapes").ok_or("no shapes")?;
        let bodies = names
            .iter()
            .map(|name| Body::read(shapes.get(name).ok_or(format!("no shape {name}"))?))
            .collect::<Result<Vec<_>, String>>()?;
        Ok(Self {
            id: json.get("id").cloned().unwrap_or(Json::Null),
            bodies,
            kind,
            time: query.number_at("time").unwrap_or(0.0),
            tolerance: query.number_at("tolerance").unwrap_or(1e-12),
            iterates: matches!(query.text_at("algorithm"), Some("conservative-advancement" | "ray-clipping")),
            expected: json.get("expected").cloned(),
        })
    }
}

impl Body {
    pub(crate) fn read(json: &Json) -> Result<Self, String> {
        let radius = json.number_at("radius").unwrap_or(0.0);
        let points = |key: &str| -> Result<Vec<[f64; 2]>, String> {
            let list = json.get(key).ok_or(format!("no {key}"))?.list();
            list.iter().map(|p| p.pair().ok_or(format!("{key} holds no pair"))).collect()
        };
        let (vertices, ring) = match json.text_at("kind") {
            Some("circle") => (vec![json.pair_at("center").unwrap_or([0.0, 0.0])], false),
            Some("aabb" | "box") => {
                let [x, y] = json.pair_at("half_extents").ok_or("no half_extents")?;
                (vec![[-x, -y], [x, -y], [x, y], [-x, y]], true)
            }
            Some("polygon" | "outline") => (points("vertices")?, true),
            Some("regular-polygon") => {
                let count = json.number_at("edges").ok_or("no edges")?;
                let count = count.to_string().parse().map_err(|_| "edges that can't be counted")?;
                (regular(count, json.number_at("circumradius").ok_or("no circumradius")?), true)
            }
            Some("capsule") => (points("points")?, false),
            _ => return Err("unknown kind of shape".to_owned()),
        };
        let angle = |degrees: &str, radians: &str| Angle {
            degrees: json.number_at(degrees).unwrap_or(0.0),
            radians: json.number_at(radians).unwrap_or(0.0),
        };
        Ok(Self {
            vertices,
            ring,
            hull: json.get("hull") == Some(&Json::Bool(true)),
            matrix: json.pair_at("rotation").unwrap_or([1.0, 0.0]),
            radius,
            position: json.pair_at("position").unwrap_or([0.0, 0.0]),
            angle: angle("angle_deg", "angle_rad"),
            velocity: json.pair_at("velocity").unwrap_or([0.0, 0.0]),
            spin: angle("angular_velocity_deg", "angular_velocity_rad"),
        })
    }

    /// Vertex `k` multiplied by the matrix.
    #[must_use]
    pub fn vertex(&self, k: usize) -> Point {
        let [cos, sin] = self.matrix.map(Real::from);
        Point::of(self.vertices[k]).turned(Rotation { cos, sin })
    }

    /// Every vertex multiplied by the matrix, in the file's order.
    pub fn multiplied(&self) -> impl Iterator<Item = Point> {
        (0..self.vertices.len()).map(|k| self.vertex(k))
    }

    /// Number of edges: of a ring as many as vertices, of a capsule one, of a circle none.
    #[must_use]
    pub fn edges(&self) -> usize {
        if self.ring { self.vertices.len() } else { self.vertices.len() - 1 }
    }
}

/// The vertices of a regular polygon, counter-clockwise from the left end of its lowest edge, which is level:
/// each coordinate rounded to the nearest double.
fn regular(count: u32, circumradius: f64) -> Vec<[f64; 2]> {
    let vertex = |k: u32| {
        let halves = Real::from(180.0) * Real::from(2.0 * f64::from(k) - 1.0);
        let Rotation { cos, sin } = Rotation::of_degrees(halves.over_int(u64::from(count)));
        [sin, -cos].map(|x| (x * Real::from(circumradius)).to_f64())
    };
    (0..count).map(vertex).collect()
}

/// ε of doubles.
pub const EPSILON: f64 = f64::EPSILON;

/// S: the largest coordinate (of a body's origin, or of one seen from the other), extent (from the body's
/// origin, with the radius) or distance moved (of one body as the other sees it, or along an arc).
#[must_use]
pub fn scale(bodies: &[Body], moving: bool) -> f64 {
    let largest = |[x, y]: [f64; 2]| x.abs().max(y.abs());
    let mut s = 0.0_f64;
    for body in bodies {
        let reach = body.vertices.iter().map(|v| largest(*v)).fold(0.0, f64::max);
        let arm = body.vertices.iter().map(|[x, y]| (x * x + y * y).sqrt()).fold(reach, f64::max);
        s = s.max(reach + body.radius).max(largest(body.position));
        if moving {
            s = s.max(largest(body.velocity)).max(body.spin.in_radians().abs().to_f64() * arm);
        }
    }
    if let [a, b] = bodies {
        let apart = |p: [f64; 2], q: [f64; 2]| largest([q[0] - p[0], q[1] - p[1]]);
        s = s.max(apart(a.position, b.position));
        if moving {
            s = s.max(apart(a.velocity, b.velocity));
        }
    }
    s
}
