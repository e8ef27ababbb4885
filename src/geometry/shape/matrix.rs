//! The matrix that an engine turns a body by: cosine and sine as it has them, used as they are.
//!
//! An engine keeps q = (c, s) instead of an angle, rounded, and not of length 1 any more after some steps. It
//! multiplies every core point by it and leaves the radius alone; so does this:
//!
//! ```text
//! v → (c x − s y, s x + c y)        |v| → λ |v|        λ² = c² + s²
//! ```
//!
//! Angles between edges stay as they are, so that a convex core stays convex.

use std::fmt::Write;

use super::{Shape, ShapeError};
use crate::geometry::{DVec2, Hull, Rotation};

/// How far c² + s² may be off 1: above this it is no rotation that drifted, but a mistake.
const MOST_OFF: f64 = 1e-3;

impl Shape {
    /// The shape with its core multiplied by the matrix of a cosine and a sine, as an engine does; its radius
    /// stays.
    ///
    /// # Errors
    /// A [`ShapeError`] where c² + s² is off 1 by more than 1e-3.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Rotation, Shape};
    /// let triangle = Shape::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::Y])?;
    /// let turned = triangle.clone().multiplied(Rotation { cos: 0.0, sin: 1.0 })?;
    /// assert_eq!(turned.hull.vertices, [DVec2::ZERO, DVec2::Y, DVec2::NEG_X]);
    /// let error = triangle.multiplied(Rotation { cos: 1.0, sin: 0.1 }).unwrap_err();
    /// assert_eq!(error.code, "not-a-rotation");
    /// # Ok::<(), tracefig::geometry::shape::ShapeError>(())
    /// ```
    pub fn multiplied(mut self, matrix: Rotation<f64>) -> Result<Self, ShapeError> {
        let Rotation { cos, sin } = matrix;
        let off = (cos * cos + sin * sin) - 1.0;
        if off.is_nan() || off.abs() > MOST_OFF {
            let mut message = format!(
                "expected a cosine and a sine whose squares add up to 1, got {cos} and {sin}, which are off \
                 by {off:.3e}, more than {MOST_OFF:e}"
            );
            let length = libm::hypot(cos, sin);
            if length.is_normal() {
                let unit = [cos, sin].map(|x| (1e6 * x / length).round() / 1e6 + 0.0);
                // Writing to a text can't fail.
                let _ = write!(message, "; of length 1 they are {unit:?}");
            }
            return Err(ShapeError::new("not-a-rotation", "rotation", message));
        }
        if !self.hull.vertices.is_empty() {
            self.hull = Hull::multiplied(&self.hull.vertices, matrix);
        }
        self.matrix = matrix;
        Ok(self)
    }

    /// Whether no matrix multiplies the core.
    #[inline]
    pub(crate) fn is_as_written(&self) -> bool {
        self.matrix == Rotation::NONE
    }

    /// A vertex of the file, multiplied by the matrix, rounded.
    #[inline]
    pub(crate) fn multiplied_vertex(&self, i: usize) -> DVec2 {
        let vertex = self.vertices[i];
        if self.is_as_written() { vertex } else { self.matrix.apply(vertex) }
    }

    /// At least by how much the matrix makes a vector longer: 1 exactly where there is none.
    #[inline]
    pub(crate) fn stretch(&self) -> f64 {
        if self.is_as_written() {
            return 1.0;
        }
        let Rotation { cos, sin } = self.matrix;
        // Two products, a sum and a root: 1.5 ε.
        (cos * cos + sin * sin).sqrt() * (1.0 + 2.0 * f64::EPSILON)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Ball, Dd};
    use tracefig_reference::float::Real;
    use tracefig_reference::random::Random;

    /// A triangle of any size, and cosine and sine as an engine may have them.
    fn drawn(random: &mut Random) -> ([DVec2; 3], Rotation<f64>) {
        let size = random.magnitude(-30.0, 30.0) * random.one_of(&[1.0, 1e-250, 1e200]);
        let mut point = || DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)) * size;
        let vertices = [point(), point(), point()];
        let angle = random.between(-3.0, 3.0);
        let drift = 1.0 + random.between(-4e-4, 4e-4);
        (vertices, Rotation { cos: libm::cos(angle) * drift, sin: libm::sin(angle) * drift })
    }

    fn exact(x: Dd) -> Real {
        Real::from(x.hi) + Real::from(x.lo)
    }

    /// A vector multiplied by the matrix.
    fn truth(m: Rotation<f64>, [x, y]: [Real; 2]) -> [Real; 2] {
        let (c, s) = (Real::from(m.cos), Real::from(m.sin));
        [c * x - s * y, s * x + c * y]
    }

    fn holds(ball: [Ball; 2], truth: [Real; 2]) -> bool {
        ball.iter().zip(truth).all(|(x, t)| (t - exact(x.value)).abs() <= Real::from(x.radius))
    }

    #[test]
    fn what_is_kept_of_a_multiplied_core_encloses_it_at_any_size() {
        let mut random = Random::new(31);
        for _ in 0..3_000 {
            let (vertices, m) = drawn(&mut random);
            let Ok(shape) = Shape::polygon(vertices.to_vec()).and_then(|shape| shape.multiplied(m)) else {
                continue;
            };
            let at = |k: usize| shape.vertices[shape.core[k % 3]].to_array().map(Real::from);
            for k in 0..3 {
                let edge: [Real; 2] = std::array::from_fn(|i| at(k + 1)[i] - at(k)[i]);
                assert!(holds(shape.hull.vertex_in_balls(k), truth(m, at(k))), "{shape:?}");
                assert!(holds(shape.hull.edge_in_balls(k), truth(m, edge)), "{shape:?}");
                let [x, y] = truth(m, edge);
                let length = (x * x + y * y).sqrt();
                assert!(holds(shape.hull.normal_in_balls(k), [y.over(length), -x.over(length)]), "{shape:?}");
                let tail = shape.hull.vertex_tail(k);
                let [u, v] = truth(m, at(k));
                let off = [(u, shape.hull.vertices[k].x, tail.x), (v, shape.hull.vertices[k].y, tail.y)]
                    .map(|(t, hi, lo)| (t - Real::from(hi) - Real::from(lo)).abs());
                assert!(off[0] + off[1] <= Real::from(shape.hull.error), "{shape:?}");
                assert!((u * u + v * v).sqrt() <= Real::from(shape.hull.reach), "{shape:?}");
            }
        }
    }

    #[test]
    fn floats_of_32_bits_are_multiplied_exactly() {
        let m = Rotation { cos: f64::from(0.8_f32), sin: f64::from(0.6_f32) };
        let shape = Shape::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::new(f64::from(0.3_f32), 2.0)]).unwrap();
        let shape = shape.multiplied(m).unwrap();
        assert_eq!(shape.hull.error, 0.0);
        assert!(shape.hull.vertices[1] == DVec2::new(m.cos, m.sin));
    }

    #[test]
    fn what_is_no_rotation_says_how_far_it_is_off_and_what_would_be_one() {
        let triangle = Shape::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::Y]).unwrap();
        let of = |cos, sin| triangle.clone().multiplied(Rotation { cos, sin });
        assert!(of(1.0, 0.031).is_ok() && of(0.0, -0.9996).is_ok());
        let error = of(0.8, 0.61).unwrap_err();
        assert!(error.message.contains("off by 1.210e-2, more than 1e-3"), "{}", error.message);
        assert_eq!(of(f64::NAN, 0.0).unwrap_err().code, "not-a-rotation");
    }
}
