//! The values that text may name, each a row: where it is read, and what it means.

use crate::collision::{Answer, Outcome, QueryKind};
use crate::geometry::{DVec2, Side};
use crate::trace::Event;

use super::super::Context;

/// A number with its bounds; both ends are the same where the trace tells only a double.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Not above the exact value.
    pub lo: f64,
    /// Not below the exact value.
    pub hi: f64,
}

impl Quantity {
    fn exactly(value: f64) -> Self {
        Self { lo: value, hi: value }
    }
}

/// A value that text may name.
pub struct Value {
    /// As in `{=name}`.
    pub name: &'static str,
    /// One line for `tracefig list`.
    pub about: &'static str,
    /// Reads it; None where the query does not have it.
    pub of: fn(&Context) -> Option<Quantity>,
}

/// A row whose value is found in an event of the scene's own run.
macro_rules! told {
    ($name:literal, $about:literal, $pattern:pat => $value:expr) => {
        Value {
            name: $name,
            about: $about,
            of: |context| {
                context.run().find_told(|event| match event {
                    $pattern => Some(Quantity::exactly($value)),
                    _ => None,
                })
            },
        }
    };
}

/// Every value, in the order in which `tracefig list` prints them.
pub static VALUES: &[Value] = &[
    Value {
        name: "separation",
        about: "signed separation at the panel's moment, world units",
        of: separation,
    },
    Value { name: "depth", about: "penetration depth at the panel's moment, positive", of: depth },
    Value { name: "time", about: "time of first contact, else the panel's moment", of: time },
    Value {
        name: "n.x",
        about: "x of the unit normal from A to B",
        of: |c| normal(c).map(|n| n.x).map(Quantity::exactly),
    },
    Value {
        name: "n.y",
        about: "y of the unit normal from A to B",
        of: |c| normal(c).map(|n| n.y).map(Quantity::exactly),
    },
    Value { name: "bound", about: "time of the article's first step, or the motion bound", of: bound },
    Value { name: "iterations", about: "distance queries made", of: iterations },
    Value { name: "tolerance", about: "tolerance in force, world units", of: tolerance },
    Value { name: "last_step", about: "number of the last step, from 0", of: last_step },
    Value { name: "step.time", about: "moment of the panel's step", of: |c| step(c, |at, _, _| Some(at)) },
    Value { name: "step.next", about: "moment after the panel's step", of: |c| step(c, |_, _, next| next) },
    Value {
        name: "step.separation",
        about: "separation at the panel's step",
        of: |c| step(c, |_, s, _| Some(s)),
    },
    told!("centers", "distance of two circles' centres", Event::CirclesCompared { distance_squared, .. } => distance_squared.sqrt()),
    told!("radii", "sum of two circles' radii", Event::CirclesCompared { radii: [p, q], .. } => p + q),
    told!("p", "the article's p, signed", Event::PenetrationMeasured { p, .. } => *p),
    told!("P.x", "x of the penetration vector", Event::PenetrationMeasured { vector, .. } => vector.x),
    told!("P.y", "y of the penetration vector", Event::PenetrationMeasured { vector, .. } => vector.y),
    told!("V.x", "x of V, in the box's frame", Event::Clamped { v, .. } => v.x),
    told!("V.y", "y of V, in the box's frame", Event::Clamped { v, .. } => v.y),
    told!("clamped.x", "x of V clamped to the half-extents", Event::Clamped { clamped, .. } => clamped.x),
    told!("clamped.y", "y of V clamped to the half-extents", Event::Clamped { clamped, .. } => clamped.y),
    told!("r", "the circle's radius", Event::Clamped { radius, .. } => *radius),
    Value { name: "D", about: "length of D = B − B_c", of: |c| d(c, DVec2::length) },
    Value { name: "D.x", about: "x of D: B − B_c, or the gap of two AABBs", of: |c| d(c, |d| d.x) },
    Value { name: "D.y", about: "y of D: B − B_c, or the gap of two AABBs", of: |c| d(c, |d| d.y) },
    told!("theta", "angle turned, degrees", Event::MotionBounded { theta, .. } => theta.to_degrees()),
    told!("radius", "distance of the farthest point from the body's origin", Event::MotionBounded { radius, .. } => *radius),
    told!("L", "arc length θ r", Event::MotionBounded { arc, .. } => *arc),
    told!("min.x", "smallest x", Event::BoundsFound { min, .. } => min.x),
    told!("min.y", "smallest y", Event::BoundsFound { min, .. } => min.y),
    told!("max.x", "largest x", Event::BoundsFound { max, .. } => max.x),
    told!("max.y", "largest y", Event::BoundsFound { max, .. } => max.y),
    Value { name: "h.x", about: "half-extent in x", of: |c| half_extents(c).map(|h| Quantity::exactly(h.x)) },
    Value { name: "h.y", about: "half-extent in y", of: |c| half_extents(c).map(|h| Quantity::exactly(h.y)) },
    Value {
        name: "c.x",
        about: "x of the bounds' centre",
        of: |c| center(c).map(|p| Quantity::exactly(p.x)),
    },
    Value {
        name: "c.y",
        about: "y of the bounds' centre",
        of: |c| center(c).map(|p| Quantity::exactly(p.y)),
    },
];

fn separation(context: &Context) -> Option<Quantity> {
    let run = context.separation_at(context.time)?;
    let bounds = run.separation()?.bounds;
    Some(Quantity { lo: bounds.lo, hi: bounds.hi })
}

fn depth(context: &Context) -> Option<Quantity> {
    let s = separation(context)?;
    (s.hi <= 0.0).then_some(Quantity { lo: -s.hi, hi: -s.lo })
}

fn time(context: &Context) -> Option<Quantity> {
    match &context.run().answer {
        Answer::Impact(impact) => match impact.outcome {
            Outcome::Hit { time, .. } => Some(Quantity { lo: time.lo, hi: time.hi }),
            Outcome::Overlapping { .. } => Some(Quantity::exactly(0.0)),
            Outcome::Miss | Outcome::Unresolved { .. } => None,
        },
        Answer::MotionBound(_) => None,
        _ => Some(Quantity::exactly(context.time)),
    }
}

fn normal(context: &Context) -> Option<DVec2> {
    let run = context.run();
    Some(*run.separation()?.normal)
}

/// The article's first step `t = d / (v·n + r_A|ω_A| + r_B|ω_B|)`, whichever algorithm answered; for a motion bound
/// the bound itself.
fn bound(context: &Context) -> Option<Quantity> {
    let run = context.run();
    match &run.answer {
        Answer::MotionBound(found) => Some(Quantity::exactly(found.bound)),
        Answer::Impact(_) => first_step(context).map(Quantity::exactly),
        _ => None,
    }
}

fn first_step(context: &Context) -> Option<f64> {
    let start = context.separation_at(0.0)?;
    let contact = start.separation()?;
    let (a, b) = (context.body(Side::A)?, context.body(Side::B)?);
    let turning = |body: &crate::geometry::Body| {
        let farthest = body.shape.vertices.iter().map(|v| v.length()).fold(0.0, f64::max) + body.shape.radius;
        farthest * body.spin.0.to_radians().abs()
    };
    let approach = (a.velocity - b.velocity).dot(*contact.normal) + turning(a) + turning(b);
    (approach > 0.0 && contact.separation > 0.0).then(|| contact.separation / approach)
}

fn iterations(context: &Context) -> Option<Quantity> {
    match &context.run().answer {
        Answer::Impact(impact) => Some(Quantity::exactly(count(impact.iterations))),
        _ => None,
    }
}

fn tolerance(context: &Context) -> Option<Quantity> {
    match &context.run().answer {
        Answer::Impact(impact) if context.scene.query.kind == QueryKind::TimeOfImpact => {
            Some(Quantity::exactly(impact.tolerance))
        }
        _ => None,
    }
}

fn last_step(context: &Context) -> Option<Quantity> {
    context.steps().len().checked_sub(1).map(|last| Quantity::exactly(count(last)))
}

#[expect(clippy::cast_precision_loss, reason = "a step cap is far below 2^53")]
fn count(n: usize) -> f64 {
    n as f64
}

fn step(context: &Context, pick: fn(f64, f64, Option<f64>) -> Option<f64>) -> Option<Quantity> {
    let wanted = context.step?;
    let run = context.run();
    let mut steps = run.told(|event| match event {
        Event::Advanced { at, separation, next, .. } => Some((at.time, *separation, *next)),
        _ => None,
    });
    let (at, separation, next) = steps.nth(wanted.checked_sub(1)?)?;
    pick(at, separation, next).map(Quantity::exactly)
}

fn d(context: &Context, pick: fn(DVec2) -> f64) -> Option<Quantity> {
    context.run().find_told(|event| match event {
        Event::Clamped { d, .. } => Some(Quantity::exactly(pick(*d))),
        Event::ExtentsCompared { gap, .. } => Some(Quantity::exactly(pick(*gap))),
        _ => None,
    })
}

fn half_extents(context: &Context) -> Option<DVec2> {
    context.run().find_told(|event| match event {
        Event::Clamped { half_extents, .. } => Some(*half_extents),
        Event::BoundsFound { min, max, .. } => Some((*max - *min) / 2.0),
        _ => None,
    })
}

fn center(context: &Context) -> Option<DVec2> {
    context.run().find_told(|event| match event {
        Event::BoundsFound { min, max, .. } => Some((*min + *max) / 2.0),
        _ => None,
    })
}
