//! Where two bodies touch: the edges that face each other, and one or two points with their depths.

use crate::geometry::{DVec2, Enclosure, Feature, Side};

use super::part::{Part, Parts};
use super::separation::Separation;

/// The contact of two bodies: what an engine calls a manifold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The pair as a query for its separation finds it; its normal is that of the contact.
    pub separation: Separation,
    /// The edge that the other body's edge is clipped against, with its body. None where the bodies are
    /// apart, and where two vertices face each other.
    pub reference: Option<(Side, Feature)>,
    /// The edge that is clipped, with its body; None as for the reference.
    pub incident: Option<(Side, Feature)>,
    /// The points, in the order in which they lie along the reference edge; none where the bodies are apart.
    pub points: [Option<ContactPoint>; 2],
}

/// One point of a contact, as a pair of points of A and B. `p_B` − `p_A` = s n, with the contact's normal n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// World units, minus the depth there.
    pub separation: f64,
    /// Encloses the exact one, world units; `lo` is not above 0.
    pub bounds: Enclosure,
    /// The points of A and B, in the world: one on the incident body's edge, the other on the reference edge.
    pub points: [DVec2; 2],
    /// What carries them: a vertex of the incident edge over the reference edge, or the incident edge over a
    /// vertex of the reference edge, where it was cut.
    pub features: [Feature; 2],
}

impl Contact {
    /// Its points, without places left empty.
    ///
    /// ```
    /// use tracefig::collision::{ALGORITHMS, Answer, Query, QueryKind};
    /// use tracefig::geometry::{Angle, Body, DVec2, Shape, shape::FieldValue};
    /// let square = Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::ONE))]).unwrap();
    /// let at = |x, y| Body {
    ///     shape: square.clone(), position: DVec2::new(x, y), angle: Angle::ZERO,
    ///     velocity: DVec2::ZERO, spin: Angle::ZERO,
    /// };
    /// let (a, b) = (at(0.0, 0.0), at(0.5, 1.75));
    /// let kind = QueryKind::Contact;
    /// let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 100 };
    /// let answer = query.answer().unwrap();
    /// let Answer::Contact(contact) = answer else { panic!() };
    /// // The upper square stands a quarter deep in the lower one, half a unit to the right.
    /// let points: Vec<_> = contact.found().map(|p| (p.points[1].x, p.separation)).collect();
    /// assert_eq!(points, [(1.0, -0.25), (-0.5, -0.25)]);
    /// ```
    pub fn found(&self) -> impl Iterator<Item = &ContactPoint> {
        self.points.iter().flatten()
    }

    pub(super) fn parts(&self) -> Parts {
        let mut parts = vec![("overlap", Part::Verdict(self.separation.overlaps()))];
        parts.extend(self.separation.measures());
        parts.push(("normal", Part::Point(*self.separation.normal)));
        parts.push(("ties", Part::Count(self.separation.ties as usize)));
        for (name, edge) in [("reference", self.reference), ("incident", self.incident)] {
            parts.extend(edge.map(|(side, feature)| (name, Part::Owned(side, feature))));
        }
        parts.push(("contacts", Part::Each(self.found().map(ContactPoint::parts).collect())));
        parts
    }
}

impl ContactPoint {
    fn parts(&self) -> Parts {
        vec![
            ("separation", Part::Number(self.separation)),
            ("separation_bounds", Part::Interval(self.bounds)),
            ("points", Part::Points(self.points)),
            ("features", Part::Features(self.features)),
        ]
    }
}
