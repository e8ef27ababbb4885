//! The turn of a body's extreme point about its origin, which its arc and its straightened arcs are drawn of.

use crate::figure::sketch::on_circle;
use crate::geometry::{DVec2, Side};

/// How far below the lower radius a part of it is measured, and the whole of it, page pixels: a label of 16
/// fits between.
pub(super) const BELOW: [f64; 2] = [20.0, 66.0];

/// How far beside the way to p a point counts as lying on it, as a part of p's distance: unseen on a page.
pub(super) const ON_THE_WAY: f64 = 1e-3;

/// Opacity of the arcs of a fan.
pub(super) const FAN: f64 = 0.45;

/// Opacity of the sector's fill.
pub(super) const SECTOR: f64 = 0.06;

/// The turn of an extreme point about its body's origin.
pub(super) struct Turn {
    /// The body that turns.
    pub(super) side: Side,
    /// Its origin at the panel's moment, in the world, about which it turns.
    pub(super) center: DVec2,
    /// Distance of the extreme point from there, world units.
    pub(super) radius: f64,
    /// The extreme point's direction before, radians counter-clockwise from +x.
    pub(super) start: f64,
    /// How far it turns, radians, counter-clockwise where positive.
    pub(super) sweep: f64,
    /// Length of its arc, world units.
    pub(super) arc: f64,
    /// The other points that are as far, before the turn, in the world.
    pub(super) others: Vec<DVec2>,
}

impl Turn {
    /// The extreme point before the turn, in the world: out by the radius from its vertex.
    pub(super) fn before(&self) -> DVec2 {
        on_circle(self.center, self.radius, self.start)
    }

    /// The extreme point after the turn, in the world.
    pub(super) fn after(&self) -> DVec2 {
        on_circle(self.center, self.radius, self.start + self.sweep)
    }
}

/// The radii of a fan, but that which is drawn anyway: of the outer half of the way to p, clear of the angle.
pub(super) fn rungs(t: &Turn, drawn: Option<f64>) -> impl Iterator<Item = f64> {
    let radii = [0.5, 0.625, 0.75, 0.875].map(|share| share * t.radius);
    let is_drawn = move |radius: f64, whole: f64| {
        drawn.is_some_and(|drawn| (radius - drawn).abs() <= ON_THE_WAY * whole)
    };
    let whole = t.radius;
    radii.into_iter().filter(move |&radius| !is_drawn(radius, whole))
}
