//! Pairs that are known to break collision code, and what is true of them to more than 200 bits.

use tracefig_reference::check::slack;
use tracefig_reference::first_contact::{Motion, Passage, finest};
use tracefig_reference::float::Real;
use tracefig_reference::generate::Family;
use tracefig_reference::scene::{self, Kind, Scene, scale};

use crate::collision::Outcome;
use crate::geometry::shape::FieldValue;
use crate::geometry::{Angle, Body, DVec2, Enclosure, Rotation, Shape};

/// A pair with a witness.
pub(crate) struct HardPair {
    /// The generator's word for it, to be found again by.
    pub(crate) name: String,
    /// Body A.
    pub(crate) a: Body,
    /// Body B.
    pub(crate) b: Body,
    /// Whether the question is a linear sweep: neither body turns.
    pub(crate) is_linear: bool,
    /// The moment that a question about one is about.
    pub(crate) time: f64,
    motion: Motion,
    /// What may be taken for 0.
    slack: Real,
}

/// The first moving pairs of a seed: grazes, touches at the very end, parallel edges, points and segments,
/// many turns, sizes near the ends of the range of doubles.
pub(crate) fn hard_pairs(seed: u64, count: u64) -> impl Iterator<Item = HardPair> {
    scenes(Family::Impact, seed, count).map(|scene| HardPair::of(&scene, true))
}

/// The first pairs of a seed that are asked for their separation at one moment.
pub(crate) fn hard_resting_pairs(seed: u64, count: u64) -> impl Iterator<Item = HardPair> {
    let asked = scenes(Family::Separation, seed, count).filter(|scene| scene.kind == Kind::Separation);
    asked.map(|scene| HardPair::of(&scene, false))
}

fn scenes(family: Family, seed: u64, count: u64) -> impl Iterator<Item = Scene> {
    (0..count).map(move |i| Scene::parse(&family.case(seed, i).to_string()).expect("a scene"))
}

fn body(of: &scene::Body) -> Body {
    let points: Vec<DVec2> = of.vertices.iter().copied().map(DVec2::from).collect();
    let radius = ("radius", FieldValue::Number(of.radius));
    let shape = match points[..] {
        [center] => Shape::of_kind("circle", &[("center", FieldValue::Point(center)), radius]),
        _ if of.ring => Shape::of_kind("polygon", &[("vertices", FieldValue::Points(points)), radius]),
        _ => Shape::of_kind("capsule", &[("points", FieldValue::Points(points)), radius]),
    };
    let [cos, sin] = of.matrix;
    Body {
        shape: shape.and_then(|shape| shape.multiplied(Rotation { cos, sin })).expect("a shape"),
        position: DVec2::from(of.position),
        angle: angle(of.angle),
        velocity: DVec2::from(of.velocity),
        spin: angle(of.spin),
    }
}

fn angle(of: scene::Angle) -> Angle {
    if of.radians == 0.0 { Angle::Degrees(of.degrees) } else { Angle::Radians(of.radians) }
}

impl HardPair {
    fn of(scene: &Scene, moving: bool) -> Self {
        let bodies = &scene.bodies;
        Self {
            name: format!("{}", scene.id),
            a: body(&bodies[0]),
            b: body(&bodies[1]),
            is_linear: scene.kind == Kind::LinearSweep,
            time: scene.time,
            motion: Motion::of(bodies),
            slack: slack(scale(bodies, moving)),
        }
    }

    /// Whether bounds hold the separation at the moment asked about.
    pub(crate) fn is_enclosed_by(&self, bounds: Enclosure) -> bool {
        let exact = self.motion.separation(Real::from(self.time)).separation;
        Real::from(bounds.lo) - self.slack <= exact && exact <= Real::from(bounds.hi) + self.slack
    }

    /// Whether an outcome is true: free where it says so, in contact where it says so.
    pub(crate) fn bears_out(&self, outcome: &Outcome) -> bool {
        let starts_apart = self.motion.separation(Real::ZERO).separation > self.slack;
        match *outcome {
            Outcome::Miss => self.passage(0.0, 1.0) == Passage::Clear,
            Outcome::Overlapping { .. } => !starts_apart,
            Outcome::Unresolved { free_until, .. } => self.is_free_until(free_until),
            Outcome::Hit { time, .. } => {
                starts_apart
                    && self.is_free_until(time.lo)
                    && self.passage(time.lo, time.hi) != Passage::Clear
            }
        }
    }

    fn passage(&self, from: f64, to: f64) -> Passage {
        self.motion.first_within(self.slack, Real::from(from), Real::from(to))
    }

    /// Free before `t`; a touch at `t` itself is free before.
    fn is_free_until(&self, t: f64) -> bool {
        match self.passage(0.0, t) {
            Passage::Clear => true,
            Passage::Below { after, .. } | Passage::Unsettled { after, .. } => {
                after >= Real::from(t) - finest().scaled(20)
            }
        }
    }
}

/// The moment until which an outcome says that the bodies are free, and the one by which they touch.
pub(crate) fn span(outcome: &Outcome) -> (f64, f64) {
    match *outcome {
        Outcome::Hit { time, .. } => (time.lo, time.hi),
        Outcome::Miss => (1.0, f64::INFINITY),
        Outcome::Overlapping { .. } => (0.0, 0.0),
        Outcome::Unresolved { free_until, .. } => (free_until, f64::INFINITY),
    }
}
