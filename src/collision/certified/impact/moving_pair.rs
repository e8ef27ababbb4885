//! Two bodies in relative motion, seen from the frame of one of them.
//!
//! Let R be the body whose frame is looked from (the *owner*) and O the other. With D(t) = `c_O` − `c_R`,
//! V = `v_O` − `v_R`, and θ the angles, core vertex q of O is seen at
//!
//! ```text
//! x(t) = Rot(−θ_R) D(t) + Rot(θ_O − θ_R) q
//! ```
//!
//! while R's vertices stay the file's own numbers. Positions and velocities enter only as exact differences,
//! angles as exact sums, so that parallel bodies are seen exactly parallel, and nothing is lost far from the
//! world's origin. Everything is given twice: in doubles with one a priori bound on the error, and in balls.

use crate::collision::certified::distance::balls::rescaled;
use crate::collision::certified::distance::pair::fitting;
use crate::collision::certified::rounding::{MOVING_GAP_ERROR, TAME};
use crate::geometry::number::cos_sin;
use crate::geometry::{Angle, Ball, Body, DVec2, Dd, Hull, Rotation, Side, Turn, perp};

/// Two bodies in relative motion, ready to be asked for their first contact: cosines and sines at t = 0,
/// spins in radians, differences of positions and velocities.
///
/// Lengths in it are multiplied by a power of two where products would overflow or underflow.
#[derive(Clone, Debug)]
pub struct MovingPair<'q> {
    /// The two bodies: A, then B.
    pub(crate) bodies: [&'q Body; 2],
    /// Power of two by which all lengths here are multiplied.
    pub(crate) unit: f64,
    /// `p_B` − `p_A`, exactly.
    apart: [Dd; 2],
    /// `v_B` − `v_A`, exactly.
    velocity: [Dd; 2],
    /// Angle at t = 0 and spin of A and B; none for a body whose core is its own origin, which looks the same
    /// from everywhere: its frame is the world's.
    turning: [(Angle, Angle); 2],
    /// From the frames of A and B to the world, at t = 0.
    pub(crate) start: [Rotation<f64>; 2],
    /// Whether both are turned alike at all times.
    aligned: bool,
    /// Spins of A and B, in radians per unit of time.
    pub(crate) rate: [f64; 2],
    /// At least the distance of any core vertex of A, and of B, from its body's origin.
    pub(crate) reach: [f64; 2],
    /// `r_A` + `r_B`, exactly.
    pub(crate) radius: Dd,
    /// Bound on the error of any coordinate or dot product with a unit vector that is computed here in
    /// doubles.
    pub(crate) rounding: f64,
}

/// Where the other body is in the owner's frame at a moment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RelativePose<N> {
    /// From the owner's origin to the other body's, in the owner's frame: D.
    pub(crate) offset: [N; 2],
    /// From the other body's frame to the owner's, by `θ_O` − `θ_R`.
    pub(crate) rotation: Rotation<N>,
}

/// How the two bodies are turned at a moment, in doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rotations {
    /// From the owner's frame to the world.
    own: Rotation<f64>,
    /// From the other body's frame to the owner's.
    pub(crate) relative: Rotation<f64>,
}

impl<'q> MovingPair<'q> {
    /// The pair with its motions ready.
    ///
    /// ```
    /// use tracefig::collision::{MovingPair, Outcome};
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let half_extents = FieldValue::Point(DVec2::new(2.0, 0.5));
    /// let bar = Shape::of_kind("box", &[("half_extents", half_extents)]).unwrap();
    /// let at = |x, spin| Body {
    ///     shape: bar.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(90.0),
    ///     velocity: DVec2::ZERO, spin: Angle::Degrees(spin),
    /// };
    /// // The turning bar's far end meets the other bar's edge.
    /// let (a, b) = (at(0.0, 90.0), at(2.0, 0.0));
    /// let impact = MovingPair::new(&a, &b).first_contact(1e-12, 100);
    /// let Outcome::Hit { time, .. } = impact.outcome else { panic!() };
    /// assert!(time.lo > 0.0 && time.hi < 1.0 && time.hi - time.lo < 1e-11);
    /// ```
    #[must_use]
    pub fn new(a: &'q Body, b: &'q Body) -> Self {
        let unit = unit_of(a, b);
        let unit = if unit > 1.0 { fitting(a, b, unit) } else { unit };
        let exact = |to: DVec2, from: DVec2| {
            [Dd::difference(to.x * unit, from.x * unit), Dd::difference(to.y * unit, from.y * unit)]
        };
        let apart = exact(b.position, a.position);
        let velocity = exact(b.velocity, a.velocity);
        let reach = [a.shape.hull.reach * unit, b.shape.hull.reach * unit];
        let radius = Dd::sum(a.shape.radius * unit, b.shape.radius * unit);
        let turning = [turning(a), turning(b)];
        let one_norm = |v: &[Dd; 2]| v[0].hi.abs() + v[1].hi.abs();
        let sum = one_norm(&apart) + one_norm(&velocity) + 1.5 * (reach[0] + reach[1]) + radius.hi;
        Self {
            bodies: [a, b],
            unit,
            start: turning.map(|(angle, _)| cos_sin::cos_sin(angle, Angle::Degrees(0.0), 0.0)),
            aligned: turning[0].0.is(turning[1].0) && turning[0].1.is(turning[1].1),
            apart,
            velocity,
            turning,
            rate: [turning[0].1.radians(), turning[1].1.radians()],
            reach,
            radius,
            rounding: MOVING_GAP_ERROR * sum * (1.0 + MOVING_GAP_ERROR),
        }
    }

    /// Whether the bodies are so small beside where they are that no scale fits both: products of their sizes
    /// underflow.
    pub(crate) fn is_lost(&self) -> bool {
        let size = self.reach[0].max(self.reach[1]).max(self.radius.hi);
        let far = [self.apart, self.velocity].into_iter().flatten().map(|x| x.hi.abs()).fold(size, f64::max);
        far > 0.0 && far < TAME.start
    }

    /// The sum of all lengths of the pair, rounded up; scaled. At least its S.
    pub(crate) fn size(&self) -> f64 {
        self.rounding / MOVING_GAP_ERROR
    }

    /// This pair with `by`, scaled, added to the sum of its radii, as nearly as a double-double holds it.
    pub(crate) fn grown(&self, by: f64) -> Self {
        let rounding = (self.rounding + MOVING_GAP_ERROR * by) * (1.0 + MOVING_GAP_ERROR);
        Self { radius: self.radius.add_f64(by), rounding, ..self.clone() }
    }

    /// A core, in file units.
    #[inline]
    pub(crate) fn hull(&self, side: Side) -> &'q Hull {
        &self.bodies[side as usize].shape.hull
    }

    /// Vertex k of a core in its body's frame.
    #[inline]
    pub(crate) fn vertex(&self, side: Side, k: usize) -> DVec2 {
        self.hull(side).vertices.get(k).map_or(DVec2::ZERO, |&v| v * self.unit)
    }

    /// Vertex k of a core in its body's frame, all that is known of it.
    pub(crate) fn vertex_in_balls(&self, side: Side, k: usize) -> [Ball; 2] {
        if self.hull(side).vertices.is_empty() {
            return [Ball::ZERO; 2];
        }
        self.hull(side).vertex_in_balls(k).map(|x| rescaled(x, self.unit))
    }

    /// Every vertex of a core in its body's frame, in order.
    #[inline]
    pub(crate) fn vertices(&self, side: Side) -> impl Iterator<Item = DVec2> {
        let unit = self.unit;
        self.hull(side).vertices.iter().map(move |&v| v * unit)
    }

    /// Whether neither body turns.
    pub(crate) fn is_linear(&self) -> bool {
        self.turning.iter().all(|(_, spin)| spin.is_zero())
    }

    /// Whether a body's frame is turned like the world's at all times.
    pub(crate) fn is_never_turned(&self, side: Side) -> bool {
        let (angle, spin) = self.turning[side as usize];
        angle.is_zero() && spin.is_zero()
    }

    /// The body that turns more slowly: A where they turn alike.
    pub(crate) fn slower_turning(&self) -> Side {
        if self.rate[0].abs() <= self.rate[1].abs() { Side::A } else { Side::B }
    }

    /// D(t) and V from `owner` to the other body, in doubles, world axes.
    #[inline]
    pub(crate) fn offset(&self, owner: Side, t: f64) -> (DVec2, DVec2) {
        let v = DVec2::new(self.velocity[0].hi, self.velocity[1].hi);
        let d = DVec2::new(self.apart[0].hi, self.apart[1].hi) + v * t;
        if owner == Side::A { (d, v) } else { (-d, -v) }
    }

    /// From a body's frame to the world at `t`.
    #[inline]
    pub(crate) fn rotation(&self, side: Side, t: f64) -> Rotation<f64> {
        let (angle, spin) = self.turning[side as usize];
        if spin.is_zero() { self.start[side as usize] } else { cos_sin::cos_sin(angle, spin, t) }
    }

    /// How the bodies are turned at `t`.
    #[inline]
    pub(crate) fn rotations(&self, owner: Side, t: f64) -> Rotations {
        let own = self.rotation(owner, t);
        let relative = if self.aligned {
            Rotation::<f64>::NONE
        } else {
            self.rotation(owner.other(), t).then(own.inverse())
        };
        Rotations { own, relative }
    }

    /// Where the other body is in `owner`'s frame at `t`, in doubles.
    #[inline]
    pub(crate) fn relative_pose(&self, owner: Side, t: f64, rotations: &Rotations) -> RelativePose<f64> {
        let d = rotations.seen_by_owner(self.offset(owner, t).0);
        RelativePose { offset: [d.x, d.y], rotation: rotations.relative }
    }

    /// How fast `owner` sees vertex q of the other core move, in doubles.
    ///
    /// x' = Rot(−`θ_R`) V − `ω_R` perp(x) + `ω_O` perp(Rot(`θ_O` − `θ_R`) q)
    pub(crate) fn velocity_of(
        &self,
        owner: Side,
        q: DVec2,
        (rotations, pose): (&Rotations, &RelativePose<f64>),
    ) -> DVec2 {
        let (_, v) = self.offset(owner, 0.0);
        let turned = pose.rotation.apply(q);
        rotations.seen_by_owner(v) - perp(pose.point(q)) * self.rate[owner as usize]
            + perp(turned) * self.rate[owner.other() as usize]
    }

    /// Where the other body is in `owner`'s frame at `t`, in balls.
    pub(crate) fn relative_pose_in_balls(&self, owner: Side, t: f64) -> RelativePose<Ball> {
        let (angle, spin) = self.turning[owner as usize];
        let at = |k: usize| {
            let d = Ball::exact(self.apart[k]) + Ball::exact(self.velocity[k]).scale(t);
            if owner == Side::A { d } else { -d }
        };
        let offset = Turn::at(angle, spin, t).rotation_in_balls().undo([at(0), at(1)]);
        let between = Turn::between(self.turning[owner as usize], self.turning[owner.other() as usize], t);
        RelativePose { offset, rotation: between.rotation_in_balls() }
    }

    /// Bound on the speed at which any point of the other core moves, seen from `owner`'s frame, at any time
    /// in [0, 1].
    pub(crate) fn speed(&self, owner: Side) -> f64 {
        let (r, o) = (owner as usize, owner.other() as usize);
        let norm = |v: &[Dd; 2]| v[0].hi.abs() + v[1].hi.abs();
        let (d, v) = (norm(&self.apart) + norm(&self.velocity), norm(&self.velocity));
        let speed = v + self.rate[r].abs() * (d + self.reach[o]) + self.rate[o].abs() * self.reach[o];
        speed * (1.0 + MOVING_GAP_ERROR)
    }

    /// Bound on the second derivative of a gap of an axis of `owner`, at any time in [0, 1].
    pub(crate) fn acceleration(&self, owner: Side) -> f64 {
        let (w, o) = (self.rate[owner as usize].abs(), self.rate[owner.other() as usize].abs());
        let norm = |v: &[Dd; 2]| v[0].hi.abs() + v[1].hi.abs();
        let v = norm(&self.velocity);
        let spin = w + o;
        let sum =
            w * w * (norm(&self.apart) + v) + 2.0 * w * v + spin * spin * self.reach[owner.other() as usize];
        sum * (1.0 + MOVING_GAP_ERROR)
    }
}

impl Rotations {
    /// A world vector in the owner's frame.
    #[inline]
    pub(crate) fn seen_by_owner(&self, v: DVec2) -> DVec2 {
        self.own.undo(v)
    }
}

impl RelativePose<f64> {
    /// A point of the other body, in the owner's frame.
    pub(crate) fn point(&self, q: DVec2) -> DVec2 {
        DVec2::from(self.offset) + self.rotation.apply(q)
    }
}

impl RelativePose<Ball> {
    /// A point of the other body, in the owner's frame.
    pub(crate) fn point(&self, q: [Ball; 2]) -> [Ball; 2] {
        let [x, y] = self.rotation.apply(q);
        [self.offset[0] + x, self.offset[1] + y]
    }
}

/// Angle and spin, none for a body whose core is its own origin.
fn turning(body: &Body) -> (Angle, Angle) {
    if body.shape.hull.reach == 0.0 { UNTURNED } else { (body.angle, body.spin) }
}

/// The world's own frame.
const UNTURNED: (Angle, Angle) = (Angle::ZERO, Angle::ZERO);

/// A power of two that brings the largest length of a pair near 1; 1 where that is harmless as it is.
fn unit_of(a: &Body, b: &Body) -> f64 {
    let largest = |v: DVec2| v.x.abs().max(v.y.abs());
    let extent = |body: &Body| body.shape.hull.reach.max(body.shape.radius);
    let apart =
        largest(b.position * 0.5 - a.position * 0.5).max(largest(b.velocity * 0.5 - a.velocity * 0.5));
    let size = extent(a).max(extent(b)).max(2.0 * apart);
    if TAME.contains(&size) || size == 0.0 {
        return 1.0;
    }
    let (_, exponent) = libm::frexp(size.min(f64::MAX));
    libm::ldexp(1.0, (-exponent).clamp(-1020, 1020))
}
