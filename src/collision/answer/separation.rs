//! How far apart two bodies are, or how deep inside each other, with what witnesses it.

use crate::geometry::{DVec2, Enclosure, Feature, UnitVector};

use super::part::{Part, Parts};

/// Signed separation with its witnesses. `p_B` − `p_A` = s n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation {
    /// World units; the distance apart, or minus the penetration depth.
    pub separation: f64,
    /// Encloses the exact separation, world units.
    pub bounds: Enclosure,
    /// Unit vector in the world, from A to B, along which B moves apart.
    pub normal: UnitVector,
    /// Directions with the same depth or distance within the bounds; 0 where all tie.
    pub ties: u32,
    /// Witness points on A and B, in the world.
    pub points: [DVec2; 2],
    /// The features of A and B that carry the witness points, numbered in the file's order.
    pub features: [Feature; 2],
}

impl Separation {
    /// What is known of bodies of which nothing can be said.
    pub(in crate::collision) const UNKNOWN: Self = Self {
        separation: f64::NAN,
        bounds: Enclosure { lo: f64::NEG_INFINITY, hi: f64::INFINITY },
        normal: UnitVector::X,
        ties: 0,
        points: [DVec2::NAN; 2],
        features: [Feature::Vertex(0); 2],
    };

    /// Whether the bodies share a point, touching included; None where the bounds leave it open.
    pub(super) fn overlaps(&self) -> Option<bool> {
        if self.bounds.lo > 0.0 {
            Some(false)
        } else if self.bounds.hi <= 0.0 {
            Some(true)
        } else {
            None
        }
    }

    /// This separation, with the bodies called the other way round.
    pub(crate) fn swapped(self) -> Self {
        let ([p, q], [of_a, of_b]) = (self.points, self.features);
        Self { normal: -self.normal, points: [q, p], features: [of_b, of_a], ..self }
    }

    /// A word for how the pair stands, as events tell it.
    pub(crate) fn word(&self) -> &'static str {
        if self.separation > 0.0 {
            "apart"
        } else if self.separation < 0.0 {
            "overlapping"
        } else {
            "touching"
        }
    }

    pub(super) fn parts(&self) -> Parts {
        let [separation, bounds] = self.measures();
        let ties = ("ties", Part::Count(self.ties as usize));
        let [points, features] = self.witnesses();
        vec![separation, bounds, ("normal", Part::Point(*self.normal)), ties, points, features]
    }

    /// The signed distance and its bounds.
    pub(super) fn measures(&self) -> [(&'static str, Part); 2] {
        [("separation", Part::Number(self.separation)), ("separation_bounds", Part::Interval(self.bounds))]
    }

    /// The witness points and their features.
    pub(super) fn witnesses(&self) -> [(&'static str, Part); 2] {
        [("points", Part::Points(self.points)), ("features", Part::Features(self.features))]
    }
}
