//! A shape with its pose at t = 0 and its constant velocities over t in [0, 1].

use glam::DVec2;

use crate::geometry::Angle;
use crate::geometry::Rotation;
use crate::geometry::Shape;
use crate::geometry::Turn;

/// A shape, where it is at t = 0, and how it moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The shape, in the body's frame.
    pub shape: Shape,
    /// World position of the body's origin at t = 0, in world units.
    pub position: DVec2,
    /// Angle at t = 0.
    pub angle: Angle,
    /// World units per unit of time.
    pub velocity: DVec2,
    /// Angle per unit of time, about the body's origin.
    pub spin: Angle,
}

/// How far the squares of a cosine and a sine may be off 1 by rounding alone: 4 ε, twice what [`Turn`]
/// leaves.
const ROTATION: f64 = 4.0 * f64::EPSILON;

/// A rotation and a translation: body frame to world frame. In plain doubles, for drawing and for figures;
/// the certified queries work from the body itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// World position of the body's origin.
    pub position: DVec2,
    /// From the body's frame to the world's; with a shape's matrix, not of length 1 exactly.
    pub rotation: Rotation<f64>,
}

/// A quarter turn counter-clockwise: (−y, x).
///
/// ```
/// use tracefig::geometry::{DVec2, perp};
/// assert_eq!(perp(DVec2::new(1.0, 2.0)), DVec2::new(-2.0, 1.0));
/// ```
#[must_use]
pub fn perp(v: DVec2) -> DVec2 {
    DVec2::new(-v.y, v.x)
}

impl Pose {
    /// A point of the body's frame, in the world.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Pose, Rotation};
    /// let pose = Pose { position: DVec2::new(1.0, 2.0), rotation: Rotation { cos: 0.0, sin: 1.0 } };
    /// assert_eq!(pose.point(DVec2::X), DVec2::new(1.0, 3.0));
    /// ```
    #[must_use]
    pub fn point(&self, local: DVec2) -> DVec2 {
        self.position + self.vector(local)
    }

    /// A vector of the body's frame, in the world.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Pose, Rotation};
    /// let pose = Pose { position: DVec2::new(1.0, 2.0), rotation: Rotation { cos: 0.0, sin: 1.0 } };
    /// assert_eq!(pose.vector(DVec2::X), DVec2::Y);
    /// ```
    #[must_use]
    pub fn vector(&self, v: DVec2) -> DVec2 {
        self.rotation.apply(v)
    }

    /// A world point in the body's frame.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Pose, Rotation};
    /// let pose = Pose { position: DVec2::new(1.0, 2.0), rotation: Rotation { cos: 0.0, sin: 1.0 } };
    /// assert_eq!(pose.inverse_point(DVec2::new(1.0, 3.0)), DVec2::X);
    /// ```
    #[must_use]
    pub fn inverse_point(&self, world: DVec2) -> DVec2 {
        let local = self.rotation.undo(world - self.position);
        // A matrix that is no rotation makes vectors longer, on the way back as well.
        let Rotation { cos, sin } = self.rotation;
        let squared = cos * cos + sin * sin;
        if (squared - 1.0).abs() <= ROTATION { local } else { local / squared }
    }
}

impl Body {
    /// Where the body is marked, in its own frame: the centre of a circle, which may lie beside the body's
    /// origin; of any other body its origin.
    pub(crate) fn center(&self) -> DVec2 {
        match self.shape.vertices[..] {
            [center] => center,
            _ => DVec2::ZERO,
        }
    }

    /// Whether its place, its motion and its radius are finite numbers, as those of a page's scene are.
    #[inline]
    pub(crate) fn is_finite(&self) -> bool {
        if cfg!(tracefig_page) {
            return true;
        }
        let turns = [self.angle, self.spin].iter().all(|angle| angle.is_finite());
        self.position.is_finite() && self.velocity.is_finite() && turns && self.shape.radius.is_finite()
    }

    /// Whether queries about pairs take it: it is convex, and its numbers are finite.
    #[inline]
    pub(crate) fn can_touch(&self) -> bool {
        cfg!(tracefig_page) || !self.shape.core.is_empty() && self.is_finite()
    }

    /// Whether it has a velocity or a spin.
    #[inline]
    pub(crate) fn moves(&self) -> bool {
        self.velocity != DVec2::ZERO || !self.spin.is_zero()
    }

    /// Whether its motion turns it: a circle about its own centre is where it was, whatever its spin.
    #[inline]
    pub(crate) fn turns(&self) -> bool {
        !self.spin.is_zero() && self.shape.vertices != [DVec2::ZERO]
    }

    /// A body that does not move, unturned: its position is in world units. The other fields may be set.
    ///
    /// ```
    /// use tracefig::geometry::{Angle, Body, DVec2, Shape};
    /// let body = Body { angle: Angle::Degrees(30.0), ..Body::at_rest(Shape::circle(0.5)?, DVec2::X) };
    /// assert_eq!((body.position, body.velocity), (DVec2::X, DVec2::ZERO));
    /// # Ok::<(), tracefig::geometry::shape::ShapeError>(())
    /// ```
    #[must_use]
    pub fn at_rest(shape: Shape, position: DVec2) -> Self {
        Self { shape, position, angle: Angle::ZERO, velocity: DVec2::ZERO, spin: Angle::ZERO }
    }

    /// Where the body is at time `t`, in the world: what leads a vertex as written there, by the shape's
    /// matrix first. The angle is reduced exactly, so that any number of turns is good to an ulp.
    ///
    /// ```
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
    /// let body = Body {
    ///     shape, position: DVec2::new(1.0, 2.0), angle: Angle::Degrees(30.0),
    ///     velocity: DVec2::X, spin: Angle::Degrees(120.0),
    /// };
    /// let pose = body.pose_at(0.5);
    /// assert_eq!((pose.position, pose.rotation.cos), (DVec2::new(1.5, 2.0), 0.0));
    /// ```
    #[must_use]
    pub fn pose_at(&self, t: f64) -> Pose {
        let turn = Turn::at(self.angle, self.spin, t).rotation();
        let matrix = self.shape.matrix;
        let rotation = if self.shape.is_as_written() { turn } else { matrix.then(turn) };
        Pose { position: self.position + self.velocity * t, rotation }
    }

    /// The angle at time `t`, in degrees, rounded; with that of the shape's matrix.
    ///
    /// ```
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
    /// let body = Body {
    ///     shape, position: DVec2::new(1.0, 2.0), angle: Angle::Degrees(30.0),
    ///     velocity: DVec2::X, spin: Angle::Degrees(120.0),
    /// };
    /// assert_eq!(body.angle_at(0.5), 90.0);
    /// ```
    #[must_use]
    pub fn angle_at(&self, t: f64) -> f64 {
        let angle = self.angle.degrees() + self.spin.degrees() * t;
        let Rotation { cos, sin } = self.shape.matrix;
        if self.shape.is_as_written() { angle } else { angle + libm::atan2(sin, cos).to_degrees() }
    }
}
