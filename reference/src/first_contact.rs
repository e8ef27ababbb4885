//! When two moving bodies first come within a distance c: proved, by conservative subdivision in 320 bits.
//!
//! On an interval [m − h, m + h] the pair is farther apart than c if some axis, fixed in one of the bodies,
//! says so. With the axis n of the closest features at m, owned by body R, O the other, `D = c_O − c_R`,
//! `V = v_O − v_R`, `Δω = ω_O − ω_R`, and `p_j` the j-th vertex of O seen from its origin,
//!
//! ```text
//! f_j(m)    = n·(D + p_j) − max_R n·q − (r_A + r_B)                            ≤ s where j is least
//! f_j'(m)   = ω_R perp(n)·D + n·V + Δω n·perp(p_j)
//! f_j''(m)  = −ω_R² n·D + 2 ω_R perp(n)·V − Δω² n·p_j
//! |f_j'''|  ≤ M = |ω_R|³ (|D| + |V| h) + 3 ω_R² |V| + |Δω|³ |p_j|
//! ```
//!
//! so that min (f + f' x + ½ f'' x²) over |x| ≤ h, less ⅙ M h³, is a lower bound. Intervals that are not
//! proved are halved, the earlier half first, down to 2⁻¹¹⁰; a moment where s ≤ c ends the search from above.
//! No step of the solver's is used: neither its times nor its axes.

use crate::float::Real;
use crate::placement::{Placed, convex_core};
use crate::point::Point;
use crate::scene::{Angle, Body};
use crate::separation::{Exact, separation};

/// Two bodies in motion.
pub struct Motion {
    bodies: [Body; 2],
    cores: [Vec<usize>; 2],
    /// Angular velocities in radians.
    spins: [Real; 2],
    velocities: [Point; 2],
    /// Distance of each core's vertices from the body's origin.
    reaches: [Vec<Real>; 2],
    radii: Real,
}

/// What the search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Passage {
    /// Farther apart than c all the time.
    Clear,
    /// Farther apart than c until `after`; not at `by`.
    Below {
        /// Proved until here.
        after: Real,
        /// s ≤ c here.
        by: Real,
    },
    /// Proved until `after`; between it and `until`, 2⁻¹¹⁰ apart, s comes so near to c that subdivision does
    /// not tell.
    Unsettled {
        /// Proved until here.
        after: Real,
        /// End of the interval in doubt.
        until: Real,
    },
}

/// An axis fixed in a body.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// 0 for A, 1 for B.
    pub owner: usize,
    /// Unit vector in the owner's frame, from the owner to the other.
    pub normal: Point,
}

/// The shortest interval: t to 2⁻¹¹⁰.
#[must_use]
pub fn finest() -> Real {
    Real::power_of_two(-110)
}

impl Motion {
    /// The motion of a scene's two bodies. A disc about its body's origin looks the same however it turns,
    /// and is taken not to turn.
    #[must_use]
    pub fn of(bodies: &[Body]) -> Self {
        let each = [0, 1].map(|i| {
            let body = bodies[i].clone();
            if body.vertices == [[0.0, 0.0]] {
                Body { angle: Angle::default(), spin: Angle::default(), ..body }
            } else {
                body
            }
        });
        let cores = each.each_ref().map(|body| convex_core(&body.vertices));
        let reach = |i: usize| cores[i].iter().map(|k| each[i].vertex(*k).length()).collect();
        Self {
            spins: each.each_ref().map(|body| body.spin.in_radians()),
            velocities: each.each_ref().map(|body| Point::of(body.velocity)),
            reaches: [reach(0), reach(1)],
            radii: Real::from(each[0].radius) + Real::from(each[1].radius),
            cores,
            bodies: each,
        }
    }

    /// Both bodies at time t.
    #[must_use]
    pub fn pair(&self, t: Real) -> [Placed; 2] {
        [0, 1].map(|i| Placed::at(&self.bodies[i], &self.cores[i], t))
    }

    /// Exact separation at time t.
    #[must_use]
    pub fn separation(&self, t: Real) -> Exact {
        let pair = self.pair(t);
        separation(&pair[0], &pair[1])
    }

    /// Whether and when s first comes to c or below in [from, to].
    #[must_use]
    pub fn first_within(&self, c: Real, from: Real, to: Real) -> Passage {
        let mut by = None;
        if self.separation(from).separation <= c {
            return Passage::Below { after: from, by: from };
        }
        if self.separation(to).separation <= c {
            by = Some(to);
        }
        let mut open = vec![(from, to)];
        while let Some((a, b)) = open.pop() {
            let (middle, half) = ((a + b).scaled(-1), (b - a).scaled(-1));
            let fine = half.scaled(1) <= finest();
            let pair = self.pair(middle);
            let exact = separation(&pair[0], &pair[1]);
            if exact.separation <= c {
                by = Some(middle);
                open.clear();
                if fine {
                    return Passage::Below { after: a, by: middle };
                }
                open.push((a, middle));
            } else if !self.clear(&pair, &exact, c, half) {
                if fine {
                    return match by {
                        Some(by) if by == b => Passage::Below { after: a, by },
                        _ => Passage::Unsettled { after: a, until: b },
                    };
                }
                open.push((middle, b));
                open.push((a, middle));
            }
        }
        // Clear up to a moment at which s is c: that moment, as both are rounded, is the first.
        by.map_or(Passage::Clear, |by| Passage::Below { after: by, by })
    }

    /// Whether an axis of this moment proves s > c for `half` before and after it.
    fn clear(&self, pair: &[Placed; 2], exact: &Exact, c: Real, half: Real) -> bool {
        let ways = exact.ways.iter().filter(|way| way.separation > c);
        let mut normals: Vec<_> = ways.map(|way| (way.separation, way.normal)).collect();
        normals.sort_by_key(|(gap, _)| std::cmp::Reverse(*gap));
        normals.iter().take(2).any(|(_, n)| (0..2).any(|owner| self.lowest(pair, owner, *n, half, c) > c))
    }

    /// Lower bound of s over `half` before and after the moment of `pair`, along a world normal (from A to B)
    /// that turns with its owner. Vertices that are sure to stay above `enough` are not looked at closely.
    #[must_use]
    pub fn lowest(&self, pair: &[Placed; 2], owner: usize, normal: Point, half: Real, enough: Real) -> Real {
        let other = 1 - owner;
        let n = if owner == 0 { normal } else { normal.reversed() };
        let (spin, turn) = (self.spins[owner], self.spins[other] - self.spins[owner]);
        let d = pair[other].origin.minus(pair[owner].origin);
        let v = self.velocities[other].minus(self.velocities[owner]);
        let (distance, speed) = (d.length() + v.length() * half, v.length());
        let support =
            pair[owner].core_points().map(|p| p.minus(pair[owner].origin).dot(n)).max().unwrap_or(Real::ZERO);
        let base = n.dot(d) - support - self.radii;
        let slope = spin * n.perp().dot(d) + n.dot(v);
        let curve = (spin * n.perp().dot(v)).scaled(1) - spin.squared() * n.dot(d);
        let (spin_size, turn_size) = (spin.abs(), turn.abs());
        let third = spin_size.squared() * (spin_size * distance + speed * Real::from(3.0));
        let rate = spin_size * distance + speed;
        let mut least: Option<Real> = None;
        for (place, reach) in pair[other].core_points().zip(&self.reaches[other]) {
            let p = place.minus(pair[other].origin);
            let f = base + n.dot(p);
            let cannot_matter = f - (rate + turn_size * *reach) * half > enough && least.is_some();
            if cannot_matter {
                continue;
            }
            let f1 = slope + turn * n.dot(p.perp());
            let f2 = curve - turn.squared() * n.dot(p);
            let m = third + turn_size * turn_size.squared() * *reach;
            let bound = least_of_quadratic(f, f1, f2, half) - (m * half * half.squared()).over_int(6);
            least = Some(least.map_or(bound, |l: Real| l.min(bound)));
        }
        least.unwrap_or(base)
    }

    /// A's velocity less B's, of bodies that move relative to each other and of which neither turns.
    #[must_use]
    pub fn closing_velocity(&self) -> Option<Point> {
        let v = self.velocities[0].minus(self.velocities[1]);
        let turns = self.spins.iter().any(|spin| !spin.is_zero());
        (!turns && !v.dot(v).is_zero()).then_some(v)
    }

    /// −ds/dt just before t (just after it, at t = 0): the speed at which the pair closes.
    #[must_use]
    pub fn closing(&self, t: Real) -> Real {
        let step = Real::power_of_two(-100);
        let (from, to) = if t.signum() > 0 { (t - step, t) } else { (t, t + step) };
        (self.separation(from).separation - self.separation(to).separation).scaled(100)
    }

    /// Whether the axis proves s > c over [from, to], by halving; the least moment at which it does not,
    /// otherwise.
    ///
    /// # Errors
    /// A moment at which the axis does not show the pair apart.
    pub fn replay(&self, axis: Axis, c: Real, from: Real, to: Real) -> Result<(), Real> {
        let mut open = vec![(from, to)];
        while let Some((a, b)) = open.pop() {
            let (middle, half) = ((a + b).scaled(-1), (b - a).scaled(-1));
            let pair = self.pair(middle);
            let world = axis.normal.turned(pair[axis.owner].rotation).unit();
            let world = if axis.owner == 0 { world } else { world.reversed() };
            if self.lowest(&pair, axis.owner, world, half, c) > c {
                continue;
            }
            if half.scaled(1) <= finest() || self.lowest(&pair, axis.owner, world, Real::ZERO, c) <= c {
                return Err(middle);
            }
            open.push((middle, b));
            open.push((a, middle));
        }
        Ok(())
    }
}

/// Least value of f + f' x + ½ f'' x² over |x| ≤ h.
fn least_of_quadratic(f: Real, f1: Real, f2: Real, h: Real) -> Real {
    let tilt = f1.abs() * h;
    let end = f - tilt + (f2 * h.squared()).scaled(-1);
    // The minimum is inside only if the parabola opens upward and turns before the end.
    if f2.signum() > 0 && f1.abs() < f2 * h { f - f1.squared().over(f2).scaled(-1) } else { end }
}

#[cfg(test)]
mod tests {
    use super::{Motion, Passage, least_of_quadratic};
    use crate::float::Real;
    use crate::scene::{Kind, Scene};

    const HARD: &str = include_str!("../../tests/data/hard.jsonl");

    #[test]
    fn first_contacts_of_the_hard_cases_are_the_committed_ones() {
        let mut seen = 0;
        for line in HARD.lines() {
            let scene = Scene::parse(line).expect("valid");
            if scene.kind != Kind::TimeOfImpact {
                continue;
            }
            seen += 1;
            let expected = scene.expected.as_ref().expect("there");
            let passage = Motion::of(&scene.bodies).first_within(Real::ZERO, Real::ZERO, Real::one());
            let time = expected.text_at("time").and_then(Real::from_decimal);
            let near = |t: Real| time.is_some_and(|time| (t - time).abs() < Real::power_of_two(-80));
            let right = match (expected.text_at("outcome"), passage) {
                (Some("miss"), Passage::Clear) => true,
                (Some("hit"), Passage::Below { after, by }) => near(after) && near(by),
                (Some("touch"), Passage::Below { by, .. } | Passage::Unsettled { until: by, .. }) => near(by),
                _ => false,
            };
            assert!(right, "{}: {expected}, but {passage:?}", scene.id);
        }
        assert_eq!(seen, 13);
    }

    #[test]
    fn a_moment_at_which_s_is_c_to_the_last_bit_is_a_passage() {
        let point = r#""kind": "circle", "radius": 0, "center": [2, 0], "velocity": [2.5, 0]"#;
        let rod = r#""kind": "capsule", "points": [[3, 0], [2, 0]], "radius": 0, "position": [2, 0]"#;
        let turned = r#""angle_deg": -63.57155750302594"#;
        let text = format!(
            r#"{{"shapes": {{"A": {{{point}, {turned}}}, "B": {{{rod}, {turned}}}}},
                "query": {{"kind": "linear-sweep", "of": ["A", "B"], "algorithm": "ray-cast"}}}}"#
        );
        let motion = Motion::of(&Scene::parse(&text).expect("valid").bodies);
        // The point meets the rod's end at 0.8, and is this far from it at a moment that halving arrives at.
        let near = Real::from(64.0 * 3.0 * f64::EPSILON);
        let passage = motion.first_within(near, Real::ZERO, Real::one());
        let Passage::Below { after, by } = passage else { panic!("{passage:?}") };
        assert!(after <= by && by < Real::from(0.8), "{passage:?}");
    }

    #[test]
    fn a_parabola_is_least_at_its_vertex_or_an_end() {
        let least = |f, f1, f2, h| {
            let [f, f1, f2, h] = [f, f1, f2, h].map(Real::from);
            least_of_quadratic(f, f1, f2, h).to_f64()
        };
        assert_eq!(least(1.0, 2.0, 4.0, 1.0), 0.5);
        assert_eq!(least(1.0, -2.0, 4.0, 0.25), 0.625);
        assert_eq!(least(1.0, 2.0, -2.0, 1.0), -2.0);
    }
}
