//! What someone else answered, and how far off that is.
//!
//! Another engine's numbers are held against the bounds of ours: within them nothing is off. Lengths are told
//! in world units and in units of S ε, which is what the rounding of the scene comes to; S is
//! [`scale_of`](crate::collision::size::scale_of) the pair.

use crate::collision::answer::{Part, Parts};
use crate::collision::certified::distance::Pair;
use crate::collision::size::scale_of;
use crate::collision::{Answer, ClosestApproach, Outcome, Query, Separation, Verdict};
use crate::geometry::{Body, DVec2, Enclosure, Feature, Pose, Side, UnitVector, perp};
use crate::trace::Event;

/// Gaps along directions that tie differ by no more than this times S, and directions that are one by no more
/// than this in radians: what doubles leave of them.
const TIED: f64 = 32.0 * f64::EPSILON;

/// What someone else answered, as far as it is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Expected {
    /// What came out.
    pub outcome: Option<Verdict>,
    /// Signed separation, world units; of a miss the least one.
    pub separation: Option<f64>,
    /// Time of the first contact, or of a miss's closest approach.
    pub time: Option<f64>,
    /// Unit vector from A to B.
    pub normal: Option<UnitVector>,
    /// Witness points on A and B, in the world.
    pub points: Option<[DVec2; 2]>,
}

/// How far off the answer of someone else is. None where that does not say it, where ours has nothing to hold
/// it against, or where several answers are as good.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Off {
    /// S of the pair, world units.
    pub size: f64,
    /// What came out there, and of ours.
    pub outcome: Option<[Verdict; 2]>,
    /// How far the separation is outside the bounds of ours: negative below them, world units.
    pub separation: Option<f64>,
    /// How far the time is outside the bounds of ours: negative before them.
    pub time: Option<f64>,
    /// Angle between the normals, in degrees.
    pub normal_deg: Option<f64>,
    /// Distance of the points on A and B from where such points may be, world units.
    pub points: Option<[f64; 2]>,
    /// What was held against ours.
    pub expected: Expected,
}

/// The numbers of an answer that others can be held against.
struct Ours {
    /// Bounds of the separation.
    separation: Option<Enclosure>,
    /// Bounds of the time.
    time: Option<Enclosure>,
    /// The pair at a moment, and that moment.
    contact: Option<(Separation, f64)>,
    /// How far points of the bodies get while the time may be any within its bounds, world units.
    moved: f64,
}

impl Expected {
    /// How far off it is from an answer to a query, of which `closest` is the closest approach where it is a
    /// miss; None for a query of one body.
    ///
    /// ```
    /// use tracefig::collision::{ALGORITHMS, Expected, Query, QueryKind};
    /// use tracefig::geometry::{Angle, Body, DVec2, Shape, shape::FieldValue};
    /// let disc = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
    /// let at = |x, y| Body {
    ///     shape: disc.clone(), position: DVec2::new(x, y), angle: Angle::ZERO,
    ///     velocity: DVec2::ZERO, spin: Angle::ZERO,
    /// };
    /// let (a, b) = (at(0.0, 0.0), at(3.0, 4.0));
    /// let kind = QueryKind::Separation;
    /// let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 100 };
    /// let answer = query.answer().unwrap();
    /// let theirs = Expected { separation: Some(3.25), ..Expected::default() };
    /// let off = theirs.off(&query, &answer, None).unwrap();
    /// // Ours is 3, within bounds of a few ulps.
    /// assert!((off.separation.unwrap() - 0.25).abs() < 1e-14);
    /// assert_eq!((off.time, off.size), (None, 2.0));
    /// ```
    #[must_use]
    pub fn off(&self, query: &Query, answer: &Answer, closest: Option<&ClosestApproach>) -> Option<Off> {
        let b = query.b?;
        let size = scale_of(query.a, b);
        let ours = Ours::of(query, answer, closest);
        let contact = ours.contact.as_ref();
        let outcome = self.outcome.zip(Verdict::of(answer)).map(<[Verdict; 2]>::from);
        // When bodies touch says nothing of when others are nearest.
        let is_other =
            outcome.is_some_and(|[theirs, ours]| (theirs == Verdict::Miss) != (ours == Verdict::Miss));
        Some(Off {
            size,
            outcome,
            separation: beyond(self.separation, ours.separation),
            time: beyond(self.time.filter(|_| !is_other), ours.time).map(|off| {
                match (self.time, &ours.separation) {
                    (Some(t), Some(least)) if closest.is_some() && is_as_near([query.a, b], t, least) => 0.0,
                    _ => off,
                }
            }),
            normal_deg: self.normal.zip(contact).map(|(n, c)| normal_off([query.a, b], n, c, size)),
            points: self
                .points
                .zip(contact)
                .and_then(|(points, c)| points_off([query.a, b], points, c, ours.moved)),
            expected: *self,
        })
    }
}

impl Ours {
    fn of(query: &Query, answer: &Answer, closest: Option<&ClosestApproach>) -> Self {
        let at = |t: f64| Some(Enclosure { lo: t, hi: t });
        let of = |s: &Separation, time: Option<Enclosure>, moment: f64| Self {
            separation: Some(s.bounds),
            time,
            contact: Some((*s, moment)),
            moved: 0.0,
        };
        let nothing = Self { separation: None, time: None, contact: None, moved: 0.0 };
        let bodies = [query.a, query.b.unwrap_or(query.a)];
        let proved = || Pair::at(bodies[0], bodies[1], query.time).separation();
        match answer {
            // A verdict has bounds that suffice for it, and neither normal nor points; a separating axis has
            // no upper bound.
            Answer::Overlap(_) => of(&proved(), None, query.time),
            Answer::Separation(s) if s.bounds.hi == f64::INFINITY => of(&proved(), None, query.time),
            Answer::Separation(s) => of(s, None, query.time),
            Answer::Contact(contact) => of(&contact.separation, None, query.time),
            Answer::Impact(impact) => match &impact.outcome {
                // Ours is the last moment that is proved free; at the contact nothing is between them.
                Outcome::Hit { time, contact } => Self {
                    separation: Some(Enclosure { lo: contact.bounds.lo.min(0.0), ..contact.bounds }),
                    moved: contact.bounds.hi.max(0.0) + (time.hi - time.lo) * fastest(bodies),
                    ..of(contact, Some(*time), time.lo)
                },
                Outcome::Overlapping { contact } => of(contact, at(0.0), 0.0),
                Outcome::Miss => closest.map_or(nothing, |c| Self {
                    separation: Some(c.bounds),
                    ..of(&c.contact, at(c.time), c.time)
                }),
                Outcome::Unresolved { free_until, .. } => {
                    Self { time: Some(Enclosure { lo: *free_until, hi: 1.0 }), ..nothing }
                }
            },
            Answer::Bounds(_) | Answer::MotionBound(_) => nothing,
        }
    }
}

/// How fast a point of either body may move, in world units a unit of time.
fn fastest(bodies: [&Body; 2]) -> f64 {
    let speed = |body: &Body| {
        let reach = body.shape.vertices.iter().map(|v| v.length()).fold(0.0, f64::max) * body.shape.stretch();
        body.velocity.length() + body.spin.radians().abs() * (reach + body.shape.radius)
    };
    speed(bodies[0]).max(speed(bodies[1]))
}

/// Whether bodies are as near at a moment of the motion as the least separation, as far as its bounds tell.
fn is_as_near([a, b]: [&Body; 2], t: f64, least: &Enclosure) -> bool {
    (0.0..=1.0).contains(&t) && Pair::at(a, b, t).separation().bounds.lo <= least.hi
}

/// How far a number is outside of bounds; 0 within them.
fn beyond(x: Option<f64>, bounds: Option<Enclosure>) -> Option<f64> {
    let (x, Enclosure { lo, hi }) = (x?, bounds?);
    Some(if x > hi { x - hi } else { (x - lo).min(0.0) })
}

/// The angle between a normal and ours, in degrees. Where several tie it is that to the nearest: 0 where the
/// gap along it is the separation too, and else at most that to an edge's normal of which that holds.
fn normal_off(bodies: [&Body; 2], n: UnitVector, (ours, time): &(Separation, f64), size: f64) -> f64 {
    let angle = |m: DVec2| {
        let turned = libm::atan2(n.perp_dot(m).abs(), n.dot(m));
        // Two ways to the same unit vector differ by that.
        if turned <= TIED { 0.0 } else { turned.to_degrees() }
    };
    let own = angle(*ours.normal);
    if ours.ties == 1 {
        return own;
    }
    let [a, b] = bodies.map(|body| (body, body.pose_at(*time)));
    let between = b.1.position - a.1.position;
    // From the body's own origin: far out a product of places has too few digits.
    let far = |(body, pose): (&Body, Pose), n: DVec2| {
        let heights = body.shape.vertices.iter().map(|&v| n.dot(pose.vector(v)));
        heights.fold(f64::NEG_INFINITY, f64::max) + body.shape.radius
    };
    let ties = |n: DVec2| {
        let gap = n.dot(between) - far(b, -n) - far(a, n);
        (gap - ours.separation).abs() <= TIED * size
    };
    if ties(*n) {
        return 0.0;
    }
    let mut least = own;
    for ((body, pose), sign) in [(a, 1.0), (b, -1.0)] {
        let corners = &body.shape.vertices;
        for (p, q) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            if let Some(along) = pose.vector(*q - *p).try_normalize() {
                let out = -perp(along) * sign;
                if ties(out) {
                    least = least.min(angle(out));
                }
            }
        }
    }
    least
}

/// The distances of points from where ours may be: a point, or where edges lie along each other all of the
/// part that they share, that of B across from that of A. None where several directions tie, each with
/// points of its own. Ours may have moved by `moved`.
fn points_off(
    bodies: [&Body; 2],
    points: [DVec2; 2],
    (ours, time): &(Separation, f64),
    moved: f64,
) -> Option<[f64; 2]> {
    if ours.ties != 1 {
        return None;
    }
    let along = perp(*ours.normal);
    let place = |side: Side, i: usize| {
        let body = bodies[side as usize];
        let count = body.shape.vertices.len().max(1);
        along.dot(body.pose_at(*time).point(*body.shape.vertices.get(i % count).unwrap_or(&DVec2::ZERO)))
    };
    let span = |side: Side, feature: Feature| match feature {
        Feature::Vertex(_) => None,
        Feature::Edge(i) => {
            let (p, q) = (place(side, i), place(side, i + 1));
            Some((p.min(q), p.max(q)))
        }
    };
    let shared = match (span(Side::A, ours.features[0]), span(Side::B, ours.features[1])) {
        (Some((p, q)), Some((r, s))) => Some((p.max(r), q.min(s))),
        _ => None,
    };
    // How far along the edges the points are from ours, as far as they share that: halfway between those of A
    // and B, so that neither is the one that the other is held against.
    let slid = |side: usize| match shared {
        Some((from, to)) if from <= to => {
            let own = along.dot(ours.points[side]);
            along.dot(points[side] - ours.points[side]).max(from - own).min(to - own)
        }
        _ => 0.0,
    };
    let slid = f64::midpoint(slid(0), slid(1));
    let off = |side: usize| ((points[side] - ours.points[side] - along * slid).length() - moved).max(0.0);
    Some([off(0), off(1)])
}

impl Off {
    /// The event that tells it, at the end of a trace.
    ///
    /// ```
    /// use tracefig::collision::{Expected, Off};
    /// use tracefig::trace::Event;
    /// let off = Off {
    ///     size: 4.0, outcome: None, separation: Some(0.25), time: None, normal_deg: None, points: None,
    ///     expected: Expected { separation: Some(1.25), ..Expected::default() },
    /// };
    /// assert!(matches!(off.event(), Event::ExpectationCompared { separation: Some(0.25), .. }));
    /// ```
    #[must_use]
    pub fn event(&self) -> Event {
        let Self { size, outcome, separation, time, normal_deg, points, .. } = *self;
        let outcome = outcome.map(|both| both.map(Verdict::word));
        Event::ExpectationCompared { size, outcome, separation, time, normal_deg, points }
    }

    /// Its parts, as `solve` writes them: of what was expected, and null where there is nothing to hold it
    /// against.
    pub(crate) fn parts(&self) -> Parts {
        let unit = self.size * f64::EPSILON;
        let part = |x: Option<f64>| x.map_or(Part::Verdict(None), Part::Number);
        let mut parts = vec![("size", Part::Number(self.size))];
        if self.expected.outcome.is_some() {
            parts.push(("same_outcome", Part::Verdict(self.outcome.map(|[theirs, ours]| theirs == ours))));
        }
        if self.expected.separation.is_some() {
            parts.push(("separation", part(self.separation)));
            parts.push(("separation_in_eps", part(self.separation.map(|s| s / unit))));
        }
        if self.expected.time.is_some() {
            parts.push(("time", part(self.time)));
        }
        if self.expected.normal.is_some() {
            parts.push(("normal_deg", part(self.normal_deg)));
        }
        if self.expected.points.is_some() {
            let pair = |points: Option<[f64; 2]>| points.map_or(Part::Verdict(None), Part::Lengths);
            parts.push(("points", pair(self.points)));
            parts.push(("points_in_eps", pair(self.points.map(|points| points.map(|x| x / unit)))));
        }
        parts
    }
}

#[cfg(test)]
mod tests;
