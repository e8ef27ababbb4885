//! The frame of a moving body: the world as that body sees it.
//!
//! A panel shows the world in the frame of F at the panel's moment T. What is at p at another time τ is seen
//! from F as it is then, and so is drawn where F, having come to its place at T, would have it:
//!
//! ```text
//! seen(p, τ) = F(T) · F(τ)⁻¹ p
//! ```
//!
//! F itself rests. Another body moves with the velocity that F sees (Landau, Lifshitz, *Mechanics*, 1976,
//! section 39), and turns by the difference of the spins; its way is straight only if F does not turn:
//!
//! ```text
//! v' = v − v_F − ω_F × (x − x_F)              ω' = ω − ω_F
//! ```

use crate::collision::Separation;
use crate::geometry::{Body, DVec2, Pose, Rotation, perp};

/// The frame of a body that moves or turns, at a panel's moment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MovingFrame<'b> {
    /// The body whose frame it is.
    body: &'b Body,
    /// The panel's moment T, in [0, 1].
    time: f64,
}

impl<'b> MovingFrame<'b> {
    /// The frame of a body at a panel's moment; `None` where the body rests and its frame is the world's.
    pub(crate) fn of(body: &'b Body, time: f64) -> Option<Self> {
        body.moves().then_some(Self { body, time })
    }

    /// Whether it turns, so that what goes straight in the world goes on a curve in it.
    pub(crate) fn turns(&self) -> bool {
        !self.body.spin.is_zero()
    }

    /// How fast it turns, radians per unit of time, whichever way.
    pub(crate) fn turning(&self) -> f64 {
        self.body.spin.radians().abs()
    }

    /// Where a body is at `time`, as seen.
    pub(crate) fn pose(&self, body: &Body, time: f64) -> Pose {
        // What rests in this frame is where it is at the panel's moment, to the bit.
        let beside = body.velocity == self.body.velocity && body.spin.is_zero() && !self.turns();
        if std::ptr::eq(body, self.body) || beside || time == self.time {
            return body.pose_at(self.time);
        }
        let pose = body.pose_at(time);
        let turn = self.turn_since(time);
        Pose { position: self.point(turn, pose.position, time), rotation: pose.rotation.then(turn) }
    }

    /// What was found at `time`, its points and its normal as seen.
    pub(crate) fn separation(&self, found: &Separation, time: f64) -> Separation {
        if time == self.time {
            return *found;
        }
        let turn = self.turn_since(time);
        Separation {
            points: found.points.map(|p| self.point(turn, p, time)),
            normal: found.normal.turned(turn),
            ..*found
        }
    }

    /// The rotation of the frame from `time` to the panel's moment.
    fn turn_since(&self, time: f64) -> Rotation<f64> {
        let [now, then] = [self.time, time].map(|t| self.body.pose_at(t).rotation);
        let turn = then.inverse().then(now);
        // A rotation of a file need not be of length 1; the way from one to another is.
        let length = libm::hypot(turn.cos, turn.sin);
        Rotation { cos: turn.cos / length, sin: turn.sin / length }
    }

    /// Where a point of the world at `time` is seen; `turn` is the frame's rotation since then.
    fn point(&self, turn: Rotation<f64>, p: DVec2, time: f64) -> DVec2 {
        let [now, then] = [self.time, time].map(|t| self.body.pose_at(t).position);
        now + turn.apply(p - then)
    }

    /// The velocity of a body's origin at the panel's moment, as seen; world units per unit of time.
    pub(crate) fn velocity(&self, body: &Body) -> DVec2 {
        let at = |body: &Body| body.pose_at(self.time).position;
        let carried = perp(at(body) - at(self.body)) * self.body.spin.radians();
        body.velocity - self.body.velocity - carried
    }

    /// The spin of a body, as seen; degrees per unit of time.
    pub(crate) fn spin(&self, body: &Body) -> f64 {
        body.spin.degrees() - self.body.spin.degrees()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::shape::FieldValue;
    use crate::geometry::{Angle, Shape};

    fn body(position: [f64; 2], velocity: [f64; 2], spin: f64) -> Body {
        Body {
            shape: Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap(),
            position: position.into(),
            angle: Angle::Degrees(20.0),
            velocity: velocity.into(),
            spin: Angle::Degrees(spin),
        }
    }

    #[test]
    fn what_moves_beside_the_frame_rests_in_it_and_the_frame_itself_too() {
        let (f, beside) = (body([0.0, 0.0], [3.0, -0.7], 0.0), body([0.1, 5.0], [3.0, -0.7], 0.0));
        let frame = MovingFrame::of(&f, 0.3).unwrap();
        for time in [0.0, 0.3, 0.77, 1.0] {
            assert_eq!(frame.pose(&beside, time), beside.pose_at(0.3));
            assert_eq!(frame.pose(&f, time), f.pose_at(0.3));
        }
        assert_eq!((frame.velocity(&beside), frame.velocity(&f)), (DVec2::ZERO, DVec2::ZERO));
        assert!(MovingFrame::of(&body([1.0, 2.0], [0.0, 0.0], 0.0), 0.3).is_none());
    }

    #[test]
    fn the_velocity_as_seen_is_the_rate_of_the_place_as_seen() {
        let (f, b) = (body([1.0, 0.5], [2.0, -1.0], 130.0), body([4.0, -2.0], [-3.0, 1.0], -40.0));
        let frame = MovingFrame::of(&f, 0.4).unwrap();
        let h = 1e-5;
        let [before, after] = [0.4 - h, 0.4 + h].map(|t| frame.pose(&b, t));
        let rate = (after.position - before.position) / (2.0 * h);
        assert!((rate - frame.velocity(&b)).length() < 1e-7, "{rate} {}", frame.velocity(&b));
        let turned = after.rotation.then(before.rotation.inverse());
        let spin = libm::asin(turned.sin).to_degrees() / (2.0 * h);
        assert!((spin - frame.spin(&b)).abs() < 1e-4, "{spin}");
    }
}
