//! Pairs of bodies as lists of numbers, which a search can change one by one.

use tracefig_reference::random::Random;

use crate::geometry::{Angle, Body, DVec2, Rotation, Shape, shape::FieldValue};

/// The numbers that a pair is made of.
#[derive(Clone)]
pub(super) struct Case {
    /// Core vertices of A, then of B, as x and y.
    pub(super) vertices: [Vec<f64>; 2],
    /// Positions, velocities, angles, spins, radii, and the moment.
    pub(super) motion: [f64; 15],
}

/// Triangles about 1 in size that move and turn towards each other.
pub(super) fn triangles(random: &mut Random) -> Case {
    let mut triangle = || {
        let start = random.between(0.0, std::f64::consts::TAU);
        let vertices = (0..3).map(|k| {
            let angle = start + f64::from(k) * std::f64::consts::TAU / 3.0 + random.between(-0.9, 0.9);
            DVec2::new(libm::cos(angle), libm::sin(angle)) * random.between(0.3, 1.0)
        });
        vertices.flat_map(|v| [v.x, v.y]).collect()
    };
    let vertices = [triangle(), triangle()];
    let mut near = |size: f64| random.between(-size, size);
    let (p, q, v, w) =
        ([near(1.0), near(1.0)], [near(2.0), near(2.0)], [near(2.0), near(2.0)], [near(2.0), near(2.0)]);
    let (angles, spins) = ([near(180.0), near(180.0)], [near(90.0), near(90.0)]);
    let (radii, t) = ([near(0.5).abs(), near(0.5).abs()], near(1.0).abs());
    let motion = [
        p[0], p[1], q[0], q[1], v[0], v[1], w[0], w[1], angles[0], angles[1], spins[0], spins[1], radii[0],
        radii[1], t,
    ];
    Case { vertices, motion }
}

/// A long edge of A square to the world's y axis but for last bits, and over it a chain of edges of B that is
/// nearly straight: which of its vertices is lowest, rounding hides.
pub(super) fn level(random: &mut Random) -> Case {
    let mut case = triangles(random);
    let (one, two) = (random.between(-180.0, 180.0), random.between(-180.0, 180.0));
    let turned = |degrees: f64, points: &[[f64; 2]]| {
        let back = Rotation { cos: libm::cos(degrees.to_radians()), sin: libm::sin(degrees.to_radians()) };
        points.iter().map(|p| back.undo(DVec2::new(p[0], p[1]))).flat_map(|v| [v.x, v.y]).collect::<Vec<_>>()
    };
    let mut sag = |size: f64| random.between(0.1, 1.0) * size * f64::EPSILON;
    case.vertices = [
        turned(one, &[[-0.03, 0.0], [0.0, -0.03], [0.03, 0.0]]),
        turned(two, &[[-1.0, 0.0], [0.0, -sag(4.0)], [1.0, 0.0], [0.2, 1.0]]),
    ];
    case.motion[8..12].copy_from_slice(&[one, two, 0.0, 0.0]);
    case
}

impl Case {
    /// Moves one number, by a lot or by a few last bits.
    pub(super) fn change(&mut self, random: &mut Random) {
        let [a, b] = self.vertices.each_ref().map(Vec::len);
        let k = random.below(a + b + self.motion.len());
        let x = if k < a {
            &mut self.vertices[0][k]
        } else if k < a + b {
            &mut self.vertices[1][k - a]
        } else {
            &mut self.motion[k - a - b]
        };
        *x += *x * random.between(-1.0, 1.0) * libm::exp2(-random.between(1.0, 53.0));
    }

    /// This pair with all lengths multiplied by a power of two.
    pub(super) fn scaled(mut self, factor: f64) -> Self {
        let lengths = [0, 1, 2, 3, 4, 5, 6, 7, 12, 13];
        for x in self.vertices.iter_mut().flatten() {
            *x *= factor;
        }
        for k in lengths {
            self.motion[k] *= factor;
        }
        self
    }

    /// The two bodies and the moment; None where the numbers make no convex cores.
    pub(super) fn bodies(&self) -> Option<([Body; 2], f64)> {
        let m = &self.motion;
        let body = |k: usize| {
            let points = self.vertices[k].chunks_exact(2).map(|p| DVec2::new(p[0], p[1])).collect();
            let fields =
                [("vertices", FieldValue::Points(points)), ("radius", FieldValue::Number(m[12 + k].abs()))];
            Some(Body {
                shape: Shape::of_kind("polygon", &fields).ok()?,
                position: DVec2::new(m[2 * k], m[2 * k + 1]),
                velocity: DVec2::new(m[4 + 2 * k], m[5 + 2 * k]),
                angle: Angle::Degrees(m[8 + k]),
                spin: Angle::Degrees(m[10 + k]),
            })
        };
        Some(([body(0)?, body(1)?], m[14].abs().min(1.0)))
    }
}

/// A parabola whose minimum is so near 0 that its roots are nearly one: a, b and q are the first three
/// numbers of the motion.
pub(super) fn parabolas(random: &mut Random) -> Case {
    let mut case = triangles(random);
    let (a, q) = (random.between(0.1, 2.0), random.between(0.1, 2.0));
    let b = -(2.0 * a * q).sqrt() * (1.0 + libm::exp10(random.between(-14.0, -2.0)));
    case.motion[..3].copy_from_slice(&[a, b, q]);
    case
}
