//! Bodies for tests: those that a test asks for, and random ones, the same on every run.

use tracefig_reference::random::Random;

use crate::geometry::shape::FieldValue;
use crate::geometry::{Angle, Body, DVec2, Hull, Shape};

/// 3-4-5 in degrees: cos 0.8, sin 0.6.
pub(crate) const TILT: f64 = 36.869_897_645_844_02;

/// A counter-clockwise, strictly convex polygon (or a segment, or a point) with a radius.
pub(crate) fn polygon(vertices: &[[f64; 2]], radius: f64) -> Body {
    body(Shape {
        radius,
        core: (0..vertices.len()).collect(),
        hull: Hull::new(vertices.iter().copied().map(DVec2::from).collect()),
        ..Shape::bare(
            if vertices.len() == 1 { "circle" } else { "polygon" },
            vertices.iter().copied().map(DVec2::from).collect(),
        )
    })
}

/// A box (or `aabb`) about its origin.
pub(crate) fn boxed(kind: &'static str, x: f64, y: f64) -> Body {
    let vertices = [[-x, -y], [x, -y], [x, y], [-x, y]];
    let mut body = polygon(&vertices, 0.0);
    body.shape.kind = kind;
    body.shape.half_extents = Some(DVec2::new(x, y));
    body
}

/// The body elsewhere.
pub(crate) fn placed(mut body: Body, x: f64, y: f64, angle: f64) -> Body {
    body.position = DVec2::new(x, y);
    body.angle = Angle::Degrees(angle);
    body
}

/// A body of this shape that rests at the world's origin.
pub(crate) fn body(shape: Shape) -> Body {
    Body {
        shape,
        position: DVec2::ZERO,
        angle: Angle::Degrees(0.0),
        velocity: DVec2::ZERO,
        spin: Angle::Degrees(0.0),
    }
}

/// The body with velocities.
pub(crate) fn moving(mut body: Body, velocity: [f64; 2], spin: f64) -> Body {
    body.velocity = DVec2::from(velocity);
    body.spin = Angle::Degrees(spin);
    body
}

/// The vertices of a shape's file that are at these angles of an ellipse of half-axes x and y, in turns.
fn on_ellipse(turns: impl Iterator<Item = f64>, x: f64, y: f64) -> Vec<[f64; 2]> {
    let at = |turn: f64| turn * std::f64::consts::TAU;
    turns.map(at).map(|angle| [x * libm::cos(angle), y * libm::sin(angle)]).collect()
}

/// Random bodies.
pub(crate) struct Bodies(Random);

impl Bodies {
    /// The sequence of a seed.
    pub(crate) fn new(seed: u64) -> Self {
        Self(Random::new(seed))
    }

    /// A number in [0, 1).
    pub(crate) fn roll(&mut self) -> f64 {
        self.0.unit()
    }

    /// A number in [lo, hi).
    pub(crate) fn between(&mut self, lo: f64, hi: f64) -> f64 {
        self.0.between(lo, hi)
    }

    /// Two bodies that move and turn by at most `most` degrees: polygons of 1 to 6 vertices, some with a
    /// radius, 0.3 to 2 in size, within 4 of the origin, so that about one pair in three touches on its way.
    pub(crate) fn flying_pair(&mut self, most: f64) -> (Body, Body) {
        (self.flying(most), self.flying(most))
    }

    fn flying(&mut self, most: f64) -> Body {
        let count = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0][self.0.below(6)];
        let (x, y) = (self.between(0.3, 2.0), self.between(0.3, 2.0));
        let turns: Vec<f64> = up_to(count).map(|k| (k + 0.7 * self.roll()) / count).collect();
        let radius = if self.roll() < 0.4 { self.between(0.1, 0.6) } else { 0.0 };
        let angle = if self.roll() < 0.5 { 0.0 } else { self.between(-180.0, 180.0) };
        let (left, up) = (self.between(-4.0, 4.0), self.between(-4.0, 4.0));
        let body = placed(polygon(&on_ellipse(turns.into_iter(), x, y), radius), left, up, angle);
        let velocity = [self.between(-8.0, 8.0), self.between(-8.0, 8.0)];
        let spin = if self.roll() < 0.3 { 0.0 } else { self.between(-most, most) };
        moving(body, velocity, spin)
    }

    /// A sharp polygon of `count` vertices, 2 by 1 in size, somewhere in a square of 8.
    pub(crate) fn of_many_vertices(&mut self, count: u32) -> Body {
        let turns: Vec<f64> =
            (0..count).map(|k| (f64::from(k) + 0.7 * self.roll()) / f64::from(count)).collect();
        let body = polygon(&on_ellipse(turns.into_iter(), 2.0, 1.0), 0.0);
        placed(body, 8.0 * self.roll(), 8.0 * self.roll(), 360.0 * self.roll())
    }

    /// Two bodies at rest, of any convex kind: a polygon on an ellipse, a box, a capsule or a circle, rounded
    /// or not. Half of the angles are multiples of 30°: parallel and exact cases.
    pub(crate) fn resting_pair(&mut self) -> [Body; 2] {
        [(); 2].map(|()| {
            let (shape, position) = (self.shape(), self.point());
            let angle = self.between(-400.0, 400.0);
            let angle = if angle.abs() < 200.0 { (angle / 30.0).floor() * 30.0 } else { angle };
            placed(body(shape), position.x, position.y, angle)
        })
    }

    fn point(&mut self) -> DVec2 {
        DVec2::new(self.between(-2.0, 2.0), self.between(-2.0, 2.0))
    }

    fn shape(&mut self) -> Shape {
        let radius = if self.roll() < 0.5 { 0.0 } else { self.roll() };
        let radius = ("radius", FieldValue::Number(radius));
        let shape = match self.0.below(4) {
            0 => Shape::of_kind("circle", &[radius, ("center", FieldValue::Point(self.point()))]),
            1 => {
                let points = FieldValue::Points(vec![self.point(), self.point()]);
                Shape::of_kind("capsule", &[radius, ("points", points)])
            }
            2 => {
                let half = FieldValue::Point(self.point().abs() + DVec2::splat(0.01));
                Shape::of_kind("box", &[radius, ("half_extents", half)])
            }
            _ => {
                let count = self.between(3.0, 20.0).floor();
                let turns: Vec<f64> = up_to(count).map(|k| (k + self.between(-0.4, 0.4)) / count).collect();
                let vertices = on_ellipse(turns.into_iter(), 1.0, 0.6).into_iter().map(DVec2::from).collect();
                Shape::of_kind("polygon", &[radius, ("vertices", FieldValue::Points(vertices))])
            }
        };
        shape.expect("a shape")
    }
}

/// 0, 1, … below a whole number.
fn up_to(count: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(0.0), |k| Some(k + 1.0)).take_while(move |k| *k < count)
}
