//! Two bodies at one moment, seen from A's frame: what every certified query starts from.
//!
//! A's vertices are then the file's own doubles (or, where a matrix multiplies the core, what comes of it);
//! only B's are turned, by the exact difference of the angles, and moved, by the exact difference of the
//! positions. Boxes at the same angle stay exactly aligned, and nothing is lost when the pair is far from the
//! world's origin:
//!
//! ```text
//! w_j = c + R(β − α) q_j        c = R(−α) (p_B − p_A)        v_i = the file's vertex i of A
//! ```
//!
//! A core that is one point at its body's origin looks the same however it turns; its angle is then taken to
//! be whatever makes the rest exact.
//!
//! Coordinates here are multiplied by a power of two, [`Pair::scale`], where the scene is so small or large
//! that products of its numbers would leave the range of doubles (Dekker's product needs 2⁻⁹⁶⁹). The doubles
//! of this struct serve the filters, [`crate::collision::certified::distance::balls::BallPair`] the searches.

use crate::collision::certified::rounding::{GAP_ERROR, LOSSY, PLACING_ERROR, TAME};
use crate::geometry::{Ball, Body, DVec2, Dd, Hull, Pose, Rotation, Shape, Side, Turn, taming_power};

/// Where two bodies are at a moment, to place witness points by, in doubles: to a few ε of the pair's size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placement<'p, 's> {
    /// The bodies, turned as they are at that moment; the pair may be that of another one.
    pub(crate) pair: &'p Pair<'s>,
    /// The moment.
    time: f64,
    /// B's origin in A's frame then, scaled.
    center: DVec2,
}

/// Two bodies at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'s> {
    /// Body A.
    pub(crate) a: &'s Body,
    /// Body B.
    pub(crate) b: &'s Body,
    /// The moment.
    pub(crate) time: f64,
    /// Power of two by which the coordinates of this struct are multiplied; 1 for scenes from 1e-60 to 1e60.
    pub(crate) scale: f64,
    /// Whether the scene needs no scaling.
    tame: bool,
    /// Angle of A's frame in the world.
    pub(crate) frame: Turn,
    /// Angle of B in A's frame.
    pub(crate) turn: Turn,
    /// `p_B − p_A` in the world, scaled.
    pub(crate) apart: [Ball; 2],
    /// From A's frame to the world, with the tails of cosine and sine.
    pub(crate) frame_rotation: Rotation<Dd>,
    /// From B's frame to A's, with the tails of cosine and sine.
    pub(crate) b_rotation: Rotation<Dd>,
    /// B's origin in A's frame, c, with its tail; scaled.
    pub(crate) center_tailed: [Dd; 2],
    /// B's origin in A's frame, rounded to doubles; scaled.
    pub(crate) center: DVec2,
    /// Bound on the error of `center_tailed` and of a vertex turned by `b_rotation`, as vectors, together.
    pub(crate) placing_error: f64,
    /// Bound on the error of each of `frame_rotation`.
    frame_error: f64,
    /// Bound on the error of each of `b_rotation`.
    pub(crate) turn_error: f64,
    /// `r_A + r_B`, exactly, scaled.
    pub(crate) radius: Dd,
    /// |c| + both reaches: no coordinate difference of the pair is larger. Rounded up; scaled.
    pub(crate) magnitude: f64,
}

impl<'s> Pair<'s> {
    /// The pair at time `t`, any finite one: a scene's motion is that from 0 to 1.
    ///
    /// ```
    /// use tracefig::collision::Pair;
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::ONE))]).unwrap();
    /// let still = |x| Body {
    ///     shape: shape.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(30.0),
    ///     velocity: DVec2::ZERO, spin: Angle::Degrees(0.0),
    /// };
    /// let (a, b) = (still(0.0), still(4.0));
    /// let found = Pair::at(&a, &b, 0.0).separation();
    /// assert!(found.bounds.lo <= found.separation && found.bounds.hi - found.bounds.lo <= 1e-15);
    /// ```
    #[must_use]
    pub fn at(a: &'s Body, b: &'s Body, t: f64) -> Self {
        Self::placed(a, b, t, Turn::rotation_tailed)
    }

    /// The pair at time `t` as [`Self::refined`] leaves it, in one go.
    pub(crate) fn refined_at(a: &'s Body, b: &'s Body, t: f64) -> Self {
        Self::placed(a, b, t, refined)
    }

    /// The pair at time `t`, with rotations and the bound on their errors as `rotation` gives them.
    #[inline]
    fn placed(a: &'s Body, b: &'s Body, t: f64, rotation: impl Fn(&Turn) -> (Rotation<Dd>, f64)) -> Self {
        let rough = rough_distance(a, b, t)
            + (a.shape.hull.reach + b.shape.hull.reach)
            + (a.shape.radius + b.shape.radius);
        let tame = TAME.contains(&rough);
        let scale = if tame { 1.0 } else { fitting(a, b, taming_power(rough)) };
        let (frame, turn) = turns(a, b, t);
        let (frame_rotation, frame_error) = rotation(&frame);
        let (b_rotation, turn_error) = rotation(&turn);
        let radius = Dd::sum(a.shape.radius, b.shape.radius).scale_by_power_of_two(scale);
        let apart = apart_at(a, b, t, scale);
        let center_tailed = frame_rotation.undo([apart[0].value, apart[1].value]);
        let (magnitude, placing_error) = sizes(a, b, scale, &apart, [frame_error, turn_error]);
        Self {
            a,
            b,
            time: t,
            tame,
            scale,
            frame,
            turn,
            apart,
            frame_rotation,
            b_rotation,
            center_tailed,
            center: DVec2::new(center_tailed[0].hi, center_tailed[1].hi),
            placing_error,
            frame_error,
            turn_error,
            radius,
            magnitude,
        }
    }

    /// This pair moved to time `t`, where neither body turns: all fields are those of `t`.
    pub(crate) fn unturned_at(&self, t: f64) -> Self {
        let apart = apart_at(self.a, self.b, t, self.scale);
        let center_tailed = self.frame_rotation.undo([apart[0].value, apart[1].value]);
        let errors = [self.frame_error, self.turn_error];
        let (magnitude, placing_error) = sizes(self.a, self.b, self.scale, &apart, errors);
        let center = DVec2::new(center_tailed[0].hi, center_tailed[1].hi);
        Self { time: t, apart, center_tailed, center, magnitude, placing_error, ..*self }
    }

    /// Where the bodies are at this pair's moment.
    #[inline]
    pub(crate) fn placement(&self) -> Placement<'_, 's> {
        Placement { pair: self, time: self.time, center: self.center }
    }

    /// Where the bodies are at time `t`, where neither turns.
    #[inline]
    pub(crate) fn placement_at(&self, t: f64) -> Placement<'_, 's> {
        let seen = self.frame_rotation.rounded().undo(self.a.velocity - self.b.velocity);
        Placement { pair: self, time: t, center: self.center - seen * t }
    }

    /// `v_A − v_B` in A's frame, scaled.
    pub(crate) fn closing_in_balls(&self) -> [Ball; 2] {
        let speed = |from: f64, to: f64| scaled(Dd::difference(from, to), self.scale);
        let (x, y) =
            (speed(self.a.velocity.x, self.b.velocity.x), speed(self.a.velocity.y, self.b.velocity.y));
        self.frame.rotation_in_balls().undo([x, y])
    }

    /// [`Self::closing_in_balls`] of a pair that needs no scaling, in double-doubles, and the
    /// bound on its error as a vector; None where its products might leave the range of doubles, or it is 0.
    #[inline]
    pub(crate) fn closing_tailed(&self) -> Option<([Dd; 2], f64)> {
        let (of_a, of_b) = (self.a.velocity, self.b.velocity);
        let v = [Dd::difference(of_a.x, of_b.x), Dd::difference(of_a.y, of_b.y)];
        let size = v[0].hi.abs() + v[1].hi.abs();
        let error = 2.0 * self.frame_error * size + PLACING_ERROR * size;
        TAME.contains(&size).then(|| (self.frame_rotation.undo(v), error))
    }

    /// A body's prepared core.
    #[inline]
    pub(crate) fn hull(&self, side: Side) -> &'s Hull {
        &self.shape(side).hull
    }

    /// A body's shape.
    #[inline]
    pub(crate) fn shape(&self, side: Side) -> &'s Shape {
        match side {
            Side::A => &self.a.shape,
            Side::B => &self.b.shape,
        }
    }

    /// Whether the doubles of this struct can be trusted: the scene needs no scaling.
    #[inline]
    pub(crate) fn is_tame(&self) -> bool {
        self.tame
    }

    /// Whether a matrix multiplies either core, so that the doubles of its vertices have tails.
    #[inline]
    pub(crate) fn is_multiplied(&self) -> bool {
        self.a.shape.hull.is_multiplied() || self.b.shape.hull.is_multiplied()
    }

    /// 1 / scale, exactly: a product with it is a quotient by a power of two.
    #[inline]
    pub(crate) fn unscale(&self) -> f64 {
        if self.tame { 1.0 } else { 1.0 / self.scale }
    }

    /// Bound on the error of a gap in doubles.
    #[inline]
    pub(crate) fn gap_error(&self) -> f64 {
        if self.is_tame() { GAP_ERROR * self.magnitude } else { f64::INFINITY }
    }

    /// This pair with cosines and sines to twice the precision of a double.
    ///
    /// Worth its cost where the pair is asked more than once, or where it is near touching.
    ///
    /// ```
    /// use tracefig::collision::Pair;
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
    /// let moving = |x, v| Body {
    ///     shape: shape.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(0.0),
    ///     velocity: DVec2::new(v, 0.0), spin: Angle::Degrees(0.0),
    /// };
    /// let (a, b) = (moving(0.0, 4.0), moving(4.0, 0.0));
    /// let found = Pair::at(&a, &b, 0.25).refined().separation();
    /// assert_eq!(found.separation, 1.0);
    /// ```
    #[must_use]
    pub fn refined(mut self) -> Self {
        let (frame_rotation, frame_error) = refined(&self.frame);
        let (b_rotation, turn_error) = refined(&self.turn);
        let apart = [self.apart[0].value, self.apart[1].value];
        let distance = apart[0].hi.abs() + apart[1].hi.abs();
        self.center_tailed = frame_rotation.undo(apart);
        (self.frame_rotation, self.b_rotation) = (frame_rotation, b_rotation);
        (self.frame_error, self.turn_error) = (frame_error, turn_error);
        self.placing_error = 2.0 * (frame_error * distance + turn_error * self.magnitude)
            + PLACING_ERROR * self.magnitude
            + (self.apart[0].radius + self.apart[1].radius)
            + (self.a.shape.hull.error + self.b.shape.hull.error) * self.scale;
        self
    }

    /// A vector of A's frame, in the world.
    #[inline]
    pub(crate) fn world_vector(&self, v: DVec2) -> DVec2 {
        self.frame_rotation.rounded().apply(v)
    }

    /// A point of A's frame, scaled, in B's frame, unscaled.
    #[inline]
    pub(crate) fn local_to_b(&self, p: DVec2) -> DVec2 {
        self.vector_to_b(p - self.center) * self.unscale()
    }

    /// A vector of B's frame in A's frame.
    #[inline]
    pub(crate) fn vector_from_b(&self, v: DVec2) -> DVec2 {
        self.b_rotation.rounded().apply(v)
    }

    /// A vector of A's frame in B's frame.
    #[inline]
    pub(crate) fn vector_to_b(&self, v: DVec2) -> DVec2 {
        self.b_rotation.rounded().undo(v)
    }

    /// Where a body is, in the world.
    #[inline]
    pub(crate) fn pose(&self, side: Side) -> Pose {
        self.placement().pose(side)
    }
}

impl Placement<'_, '_> {
    /// A point of B's frame, as in its file, in A's frame, scaled.
    #[inline]
    pub(crate) fn point_from_b(&self, q: DVec2) -> DVec2 {
        self.center + self.pair.vector_from_b(q * self.pair.scale)
    }

    /// A point of A's frame, scaled, in B's frame, as in its file.
    #[inline]
    pub(crate) fn point_to_b(&self, p: DVec2) -> DVec2 {
        self.pair.vector_to_b(p - self.center) * self.pair.unscale()
    }

    /// Where a body is, in the world.
    #[inline]
    pub(crate) fn pose(&self, side: Side) -> Pose {
        let (frame, at) =
            (self.pair.frame_rotation.rounded(), |body: &Body| body.position + body.velocity * self.time);
        match side {
            Side::A => Pose { position: at(self.pair.a), rotation: frame },
            Side::B => {
                Pose { position: at(self.pair.b), rotation: frame.then(self.pair.b_rotation.rounded()) }
            }
        }
    }
}

/// A rotation to twice the precision of a double, and the bound on the error of its cosine and sine.
fn refined(turn: &Turn) -> (Rotation<Dd>, f64) {
    let Rotation { cos, sin } = turn.rotation_in_balls();
    (Rotation { cos: cos.value, sin: sin.value }, cos.radius.max(sin.radius))
}

/// Angle of A's frame in the world, and of B in it.
fn turns(a: &Body, b: &Body, t: f64) -> (Turn, Turn) {
    let fixed = |body: &Body| body.shape.hull.vertices.as_slice() == [DVec2::ZERO];
    match (fixed(a), fixed(b)) {
        (true, true) => (Turn::NONE, Turn::NONE),
        (true, false) => (Turn::NONE, Turn::at(b.angle, b.spin, t)),
        (false, true) => (Turn::at(a.angle, a.spin, t), Turn::NONE),
        (false, false) => {
            (Turn::at(a.angle, a.spin, t), Turn::between((a.angle, a.spin), (b.angle, b.spin), t))
        }
    }
}

/// A scale, or the largest power of two that does not carry positions out of the range of doubles.
pub(crate) fn fitting(a: &Body, b: &Body, scale: f64) -> f64 {
    let far = |body: &Body| body.position.abs().max(body.velocity.abs()).max_element();
    let (_, exponent) = libm::frexp(far(a).max(far(b)));
    // Sums of four of them stay below 2¹⁰²³.
    scale.min(libm::ldexp(1.0, (1020 - exponent).min(1020)))
}

/// About |`p_B − p_A`| at time t.
fn rough_distance(a: &Body, b: &Body, t: f64) -> f64 {
    let d = (b.position - a.position) + (b.velocity - a.velocity) * t;
    d.x.abs() + d.y.abs()
}

/// `p_B − p_A` at time t, exactly where double-doubles hold it, times `scale`.
#[inline]
fn apart_at(a: &Body, b: &Body, t: f64, scale: f64) -> [Ball; 2] {
    [
        apart(a.position.x, b.position.x, [a.velocity.x, b.velocity.x], t, scale),
        apart(a.position.y, b.position.y, [a.velocity.y, b.velocity.y], t, scale),
    ]
}

/// M and [`Pair::placing_error`] of bodies that are `apart`, by the bounds on both rotations.
#[inline]
fn sizes(
    a: &Body,
    b: &Body,
    scale: f64,
    apart: &[Ball; 2],
    [frame_error, turn_error]: [f64; 2],
) -> (f64, f64) {
    let reaches = (a.shape.hull.reach + b.shape.hull.reach) * scale;
    let distance = apart[0].value.hi.abs() + apart[1].value.hi.abs();
    let magnitude = (distance + reaches) * (1.0 + 8.0 * f64::EPSILON);
    // Of a vector, each component is off by at most the error of cosine or sine times its 1-norm.
    let placing_error = 2.0 * (frame_error * distance + turn_error * reaches)
        + PLACING_ERROR * magnitude
        + (apart[0].radius + apart[1].radius)
        + (a.shape.hull.error + b.shape.hull.error) * scale;
    (magnitude, placing_error)
}

/// A coordinate of `p_B − p_A` at time t, exactly where a double-double holds it, times `scale`.
fn apart(from: f64, to: f64, [v_from, v_to]: [f64; 2], t: f64, scale: f64) -> Ball {
    let start = scaled(Dd::difference(to, from), scale);
    let speed = Dd::difference(v_to, v_from);
    if t == 0.0 || speed == Dd::ZERO {
        return start;
    }
    start + scaled(speed, scale).scale(t)
}

/// x · scale for a power of two; widened where the product is so small that bits may be lost.
pub(crate) fn scaled(x: Dd, scale: f64) -> Ball {
    if scale == 1.0 {
        return Ball::exact(x);
    }
    let y = x.scale_by_power_of_two(scale);
    let lost = |y: f64, x: f64| scale < 1.0 && x != 0.0 && y.abs() < LOSSY;
    let radius = if lost(y.hi, x.hi) || lost(y.lo, x.lo) { LOSSY } else { 0.0 };
    Ball::within(y, radius)
}
