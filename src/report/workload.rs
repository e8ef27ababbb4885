//! Pairs of convex polygons with n vertices each, placed so that the answer has a wanted size.
//!
//! A polygon's vertices lie on an ellipse, at evenly spaced parameters shifted at random by at most two
//! fifths of a step, so that it is strictly convex for every n. A pair is placed by its support points: with
//! u a random direction, p the vertex of A farthest along u and q that of B farthest along −u, B is moved
//! until q = p + g u. While u lies in both normal cones, g is then the exact separation up to the rounding of
//! the placement; the exact answer to the doubles that result is computed elsewhere and committed (see
//! `answers.rs`).

use oorandom::Rand64;

use crate::collision::{Query, QueryKind};
use crate::geometry::{Angle, Body, DVec2, Shape};

use super::answers;

/// How many vertices a polygon has, workload by workload.
pub(super) const VERTICES: [usize; 6] = [4, 8, 16, 64, 256, 1024];

/// Cases in a workload: as many as a round asks before the clock is read.
pub(super) const CASES: usize = 16;

/// What the pair does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    /// The bodies are apart: the distance is asked.
    Separated,
    /// They are inside one another: the depth is asked.
    Overlapping,
    /// They move without turning: the first contact is asked.
    Sweeping,
    /// They move and turn: the first contact is asked.
    Turning,
}

/// How close to a decision the answer lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Difficulty {
    /// Round bodies with gaps of about half their size.
    Easy,
    /// Slivers (a hundred times as long as high) with gaps of 1e-9, grazes, and two full turns.
    Hard,
}

impl Class {
    /// Every class, in the order of the tables.
    pub const ALL: [Self; 4] = [Self::Separated, Self::Overlapping, Self::Sweeping, Self::Turning];

    /// The word in tables and file names.
    ///
    /// ```
    /// use tracefig::report::Class;
    /// assert_eq!(Class::Turning.name(), "turning");
    /// ```
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Separated => "separated",
            Self::Overlapping => "overlapping",
            Self::Sweeping => "sweeping",
            Self::Turning => "turning",
        }
    }

    /// The question that pairs of this class are asked.
    ///
    /// ```
    /// use tracefig::{collision::QueryKind, report::Class};
    /// assert_eq!(Class::Turning.query(), QueryKind::TimeOfImpact);
    /// ```
    #[must_use]
    pub fn query(self) -> QueryKind {
        match self {
            Self::Separated | Self::Overlapping => QueryKind::Separation,
            Self::Sweeping => QueryKind::LinearSweep,
            Self::Turning => QueryKind::TimeOfImpact,
        }
    }
}

impl Difficulty {
    /// Both difficulties, in the order of the tables.
    pub const ALL: [Self; 2] = [Self::Easy, Self::Hard];

    /// The word in tables and file names.
    ///
    /// ```
    /// use tracefig::report::Difficulty;
    /// assert_eq!(Difficulty::Hard.name(), "hard");
    /// ```
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Easy => "easy",
            Self::Hard => "hard",
        }
    }
}

/// A pair with its exact answer.
#[derive(Clone, Debug)]
pub struct Case {
    /// Body A.
    pub a: Body,
    /// Body B.
    pub b: Body,
    /// The exact signed separation, or the exact time of first contact, as an unevaluated sum hi + lo. None
    /// for a miss.
    pub exact: Option<[f64; 2]>,
    /// The size S of the case: the largest coordinate, extent or distance moved; errors are stated relative
    /// to it.
    pub scale: f64,
}

impl Case {
    /// The question of this case at t = 0, with a tolerance in world units.
    ///
    /// ```
    /// let workload = &tracefig::report::workloads()[0];
    /// let query = workload.cases[0].query(workload.class.query(), 1e-9);
    /// assert_eq!((query.a.shape.vertices.len(), query.tolerance), (workload.vertices, 1e-9));
    /// ```
    #[must_use]
    pub fn query(&self, kind: QueryKind, tolerance: f64) -> Query<'_> {
        Query { kind, a: &self.a, b: Some(&self.b), time: 0.0, tolerance, max_iterations: 100_000 }
    }
}

/// A family of cases.
#[derive(Clone, Debug)]
pub struct Workload {
    /// What the pairs do.
    pub class: Class,
    /// How hard they are.
    pub difficulty: Difficulty,
    /// Vertices of each polygon.
    pub vertices: usize,
    /// The pairs, each with its exact answer.
    pub cases: Vec<Case>,
}

impl Workload {
    /// The name of class, difficulty and number of vertices, such as `turning-hard-64`.
    ///
    /// ```
    /// assert_eq!(tracefig::report::workloads()[0].name(), "separated-easy-4");
    /// ```
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}-{}-{}", self.class.name(), self.difficulty.name(), self.vertices)
    }
}

/// Every workload, with its committed answers.
///
/// ```
/// let workloads = tracefig::report::workloads();
/// assert!(workloads.iter().all(|workload| workload.cases.len() == 16));
/// ```
#[must_use]
pub fn workloads() -> Vec<Workload> {
    let mut all = Vec::new();
    for class in Class::ALL {
        for difficulty in Difficulty::ALL {
            for vertices in VERTICES {
                all.push(workload(class, difficulty, vertices));
            }
        }
    }
    all
}

/// One workload, with its committed answers.
#[must_use]
pub(super) fn workload(class: Class, difficulty: Difficulty, vertices: usize) -> Workload {
    let mut made = Workload { class, difficulty, vertices, cases: Vec::new() };
    let name = made.name();
    let seed = name.bytes().fold(0_u128, |seed, byte| seed.wrapping_mul(257).wrapping_add(u128::from(byte)));
    let mut random = Rand64::new(seed);
    for index in 0..CASES {
        // An ellipse's vertices are always convex, so the table refuses none; a test counts them.
        let Some((a, b)) = pair(class, difficulty, vertices, &mut random) else { continue };
        let scale = scale(&a).max(scale(&b)).max((a.velocity - b.velocity).length());
        made.cases.push(Case { a, b, exact: answers::exact(&name, index), scale });
    }
    made
}

/// The largest coordinate of a body, of its vertices or of its place.
fn scale(body: &Body) -> f64 {
    let extent = body.shape.vertices.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
    extent.max(body.position.abs().max_element())
}

/// A number from `lo` to `hi`.
fn between(random: &mut Rand64, lo: f64, hi: f64) -> f64 {
    lo + (hi - lo) * random.rand_float()
}

/// A unit vector at an angle in radians.
fn direction(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// A pair of one class and difficulty.
fn pair(class: Class, difficulty: Difficulty, vertices: usize, random: &mut Rand64) -> Option<(Body, Body)> {
    let mut a = body(difficulty, vertices, random)?;
    let mut b = body(difficulty, vertices, random)?;
    let u = direction(between(random, 0.0, core::f64::consts::TAU));
    let gap = match (class, difficulty) {
        (Class::Overlapping, Difficulty::Easy) => -between(random, 0.05, 0.3),
        (Class::Overlapping, Difficulty::Hard) => -1e-9,
        (Class::Separated, Difficulty::Hard) => 1e-9,
        _ => between(random, 0.3, 0.8),
    };
    b.position = a.position + support(&a, u) + u * gap - support(&b, -u);
    match class {
        Class::Separated | Class::Overlapping => {}
        Class::Sweeping => sweep(&mut a, &mut b, u, gap, difficulty, random),
        Class::Turning => {
            sweep(&mut a, &mut b, u, gap, Difficulty::Easy, random);
            let turn = if difficulty == Difficulty::Hard { 720.0 } else { 90.0 };
            a.spin = Angle::Degrees(between(random, 0.5, 1.0) * turn);
            b.spin = Angle::Degrees(-between(random, 0.0, 0.5) * turn);
        }
    }
    Some((a, b))
}

/// Velocities with which A closes the gap at about half time; in hard cases it passes B's vertex within 1e-9.
fn sweep(a: &mut Body, b: &mut Body, u: DVec2, gap: f64, difficulty: Difficulty, random: &mut Rand64) {
    let across = crate::geometry::perp(u);
    match difficulty {
        Difficulty::Easy => {
            a.velocity = u * (gap * between(random, 1.5, 3.0)) + across * between(random, -0.2, 0.2);
            b.velocity = across * between(random, -0.2, 0.2);
        }
        Difficulty::Hard => {
            b.position += across * 3.0 - u * (gap + 1e-9);
            a.velocity = across * 6.0;
        }
    }
}

/// A body at a random place and angle, at rest.
fn body(difficulty: Difficulty, vertices: usize, random: &mut Rand64) -> Option<Body> {
    let height = match difficulty {
        Difficulty::Easy => between(random, 0.6, 1.0),
        Difficulty::Hard => 0.01,
    };
    Some(Body {
        shape: polygon(vertices, height, random)?,
        position: DVec2::new(between(random, -1.0, 1.0), between(random, -1.0, 1.0)),
        angle: Angle::Degrees(between(random, 0.0, 360.0)),
        velocity: DVec2::ZERO,
        spin: Angle::Degrees(0.0),
    })
}

/// A strictly convex polygon with its vertices on an ellipse of half-axes 1 and `height`.
fn polygon(count: usize, height: f64, random: &mut Rand64) -> Option<Shape> {
    #[expect(clippy::cast_precision_loss, reason = "at most 1,024 vertices")]
    let vertices: Vec<DVec2> = (0..count)
        .map(|i| {
            let jitter = between(random, -0.4, 0.4);
            let at = direction((i as f64 + jitter) / count as f64 * core::f64::consts::TAU);
            DVec2::new(at.x, at.y * height)
        })
        .collect();
    Shape::polygon(vertices).ok()
}

/// Vector from the body's origin to its vertex farthest along `u`.
fn support(body: &Body, u: DVec2) -> DVec2 {
    let pose = body.pose_at(0.0);
    body.shape
        .vertices
        .iter()
        .map(|v| pose.vector(*v))
        .fold(DVec2::ZERO, |best, v| if v.dot(u) > best.dot(u) { v } else { best })
}
