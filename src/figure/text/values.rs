//! The values that text may name, each a row: where it is read, and what it means.

use crate::collision::Answer;
use crate::figure::context::Context;
use crate::figure::question::has_a_tolerance;
use crate::geometry::DVec2;
use crate::trace::Event;

use super::boxes::{angle_of_the_box, bounds, half, half_extents, middle};
use super::contacts::{self, deepest};
use super::directions::{d, hit_normal, normal, penetration};
use super::quantity::Quantity;
use super::step_values::{count, last_step, of_step, of_step_or_first};
use super::turns::turn;

/// A value that text may name.
pub(crate) struct Value {
    /// The name, as in `{=name}`.
    pub(crate) name: &'static str,
    /// What it is, for `tracefig list`.
    pub(crate) about: &'static str,
    /// Reads it; `None` where the query does not have it.
    pub(crate) of: fn(&Context) -> Option<Quantity>,
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

/// Every value, in the order in which an unknown one lists those that its query has.
pub(crate) static VALUES: &[Value] = &[
    Value {
        name: "separation",
        about: "signed separation at the panel's moment, world units",
        of: separation,
    },
    Value {
        name: "d",
        about: "distance or depth at the panel's moment, never negative: the d of labels",
        of: distance_or_depth,
    },
    Value { name: "depth", about: "penetration depth at the panel's moment, positive", of: depth },
    Value { name: "time", about: "time of first contact, else the panel's moment", of: time },
    Value {
        name: "moment",
        about: "the panel's moment, in each picture that plays",
        of: |c| Some(Quantity::exactly(c.time)),
    },
    Value {
        name: "closest.time",
        about: "when the bodies of a miss are closest",
        of: |c| Some(Quantity::exactly(c.closest()?.time)),
    },
    Value { name: "closest.separation", about: "the least separation of a miss, world units", of: least },
    Value {
        name: "n.x",
        about: "x of the unit normal from A to B at the panel's moment, in the panel's frame",
        of: |c| normal(c).map(|n| n.x).map(Quantity::exactly),
    },
    Value {
        name: "n.y",
        about: "y of the unit normal from A to B at the panel's moment, in the panel's frame",
        of: |c| normal(c).map(|n| n.y).map(Quantity::exactly),
    },
    Value {
        name: "hit.n.x",
        about: "x of the unit normal from A to B at the first contact, in the panel's frame",
        of: |c| hit_normal(c).map(|n| n.x).map(Quantity::exactly),
    },
    Value {
        name: "hit.n.y",
        about: "y of the unit normal from A to B at the first contact, in the panel's frame",
        of: |c| hit_normal(c).map(|n| n.y).map(Quantity::exactly),
    },
    Value { name: "bound", about: "time of the article's first step, or the motion bound", of: bound },
    Value { name: "iterations", about: "distance queries made", of: iterations },
    Value { name: "tolerance", about: "tolerance in force, world units", of: tolerance },
    Value { name: "last_step", about: "number of the last step, from 1", of: last_step },
    Value { name: "step.time", about: "moment of the panel's step", of: |c| of_step(c, |s| Some(s.time)) },
    Value { name: "step.next", about: "moment after the panel's step", of: |c| of_step(c, |s| s.next) },
    Value {
        name: "step.separation",
        about: "separation at the panel's step",
        of: |c| of_step(c, |s| Some(s.separation)),
    },
    Value {
        name: "step.bound",
        about: "fastest approach at the panel's step, else the first",
        of: |c| of_step_or_first(c, |s| Some(s.bound)),
    },
    Value {
        name: "step.moving",
        about: "what moving adds to that, v·n",
        of: |c| of_step_or_first(c, |s| Some(s.closing)),
    },
    Value {
        name: "step.turning",
        about: "what turning adds to that at most, r|ω| of both bodies",
        of: |c| of_step_or_first(c, |s| Some(s.bound - s.closing)),
    },
    told!(
        "centers",
        "distance of two circles' centres",
        Event::CirclesCompared { distance_squared, .. } => distance_squared.sqrt()
    ),
    told!("radii", "sum of two circles' radii", Event::CirclesCompared { radii: [p, q], .. } => p + q),
    Value {
        name: "N.x",
        about: "x of the article's N, in the panel's frame",
        of: |c| penetration(c, |[n, _]| n.x),
    },
    Value {
        name: "N.y",
        about: "y of the article's N, in the panel's frame",
        of: |c| penetration(c, |[n, _]| n.y),
    },
    told!("p", "the article's p, signed", Event::PenetrationMeasured { p, .. } => *p),
    Value {
        name: "P.x",
        about: "x of the penetration vector, in the panel's frame",
        of: |c| penetration(c, |[_, p]| p.x),
    },
    Value {
        name: "P.y",
        about: "y of the penetration vector, in the panel's frame",
        of: |c| penetration(c, |[_, p]| p.y),
    },
    told!("V.x", "x of V, in the box's frame", Event::Clamped { v, .. } => v.x),
    told!("V.y", "y of V, in the box's frame", Event::Clamped { v, .. } => v.y),
    told!("clamped.x", "x of V clamped to the half-extents", Event::Clamped { clamped, .. } => clamped.x),
    told!("clamped.y", "y of V clamped to the half-extents", Event::Clamped { clamped, .. } => clamped.y),
    told!("r", "radius of the circle, and of the box's corners", Event::Clamped { radius, .. } => *radius),
    Value { name: "box.angle", about: "angle of the box that clamps, degrees", of: angle_of_the_box },
    Value { name: "D", about: "length of D = B − B_c", of: |c| d(c, DVec2::length) },
    Value {
        name: "D.x",
        about: "x of D: B − B_c in the panel's frame, or the gap of two AABBs in the world's",
        of: |c| d(c, |d| d.x),
    },
    Value {
        name: "D.y",
        about: "y of D: B − B_c in the panel's frame, or the gap of two AABBs in the world's",
        of: |c| d(c, |d| d.y),
    },
    told!(
        "centers.x",
        "distance of two AABBs' centres in x",
        Event::ExtentsCompared { centers: [p, q], .. } => (q.x - p.x).abs()
    ),
    told!(
        "centers.y",
        "distance of two AABBs' centres in y",
        Event::ExtentsCompared { centers: [p, q], .. } => (q.y - p.y).abs()
    ),
    told!(
        "halves.x",
        "sum of two AABBs' half-extents in x",
        Event::ExtentsCompared { half_extents: [p, q], .. } => p.x + q.x
    ),
    told!(
        "halves.y",
        "sum of two AABBs' half-extents in y",
        Event::ExtentsCompared { half_extents: [p, q], .. } => p.y + q.y
    ),
    Value { name: "halves.a.x", about: "the first AABB's half-extent in x", of: |c| half(c, |[a, _]| a.x) },
    Value { name: "halves.b.x", about: "the second AABB's half-extent in x", of: |c| half(c, |[_, b]| b.x) },
    Value { name: "halves.a.y", about: "the first AABB's half-extent in y", of: |c| half(c, |[a, _]| a.y) },
    Value { name: "halves.b.y", about: "the second AABB's half-extent in y", of: |c| half(c, |[_, b]| b.y) },
    Value { name: "contacts", about: "how many points the contact has", of: contacts::count },
    Value {
        name: "d_1",
        about: "depth at the first contact along the reference edge: the d_1 of labels",
        of: |c| contacts::depth(c, 0),
    },
    Value { name: "d_2", about: "depth at the second contact", of: |c| contacts::depth(c, 1) },
    Value { name: "shallow", about: "depth at the shallower of two contacts", of: contacts::shallower },
    Value {
        name: "contact.a.x",
        about: "x of A's deepest contact, in the panel's frame",
        of: |c| deepest(c, |[a, _]| a.x),
    },
    Value {
        name: "contact.a.y",
        about: "y of A's deepest contact, in the panel's frame",
        of: |c| deepest(c, |[a, _]| a.y),
    },
    Value {
        name: "contact.b.x",
        about: "x of B's deepest contact, in the panel's frame",
        of: |c| deepest(c, |[_, b]| b.x),
    },
    Value {
        name: "contact.b.y",
        about: "y of B's deepest contact, in the panel's frame",
        of: |c| deepest(c, |[_, b]| b.y),
    },
    Value { name: "theta", about: "angle turned, degrees", of: |c| turn(c, |t| t.theta.to_degrees()) },
    Value { name: "theta.rad", about: "angle turned, radians", of: |c| turn(c, |t| t.theta) },
    Value {
        name: "radius",
        about: "distance of the farthest point from the body's origin",
        of: |c| turn(c, |t| t.radius),
    },
    Value { name: "L", about: "arc length θ r", of: |c| turn(c, |t| t.arc) },
    Value { name: "min.x", about: "smallest x of the bounds", of: |c| bounds(c, |[min, _]| min.x) },
    Value { name: "min.y", about: "smallest y of the bounds", of: |c| bounds(c, |[min, _]| min.y) },
    Value { name: "max.x", about: "largest x of the bounds", of: |c| bounds(c, |[_, max]| max.x) },
    Value { name: "max.y", about: "largest y of the bounds", of: |c| bounds(c, |[_, max]| max.y) },
    Value { name: "h.x", about: "half-extent in x", of: |c| half_extents(c).map(|h| Quantity::exactly(h.x)) },
    Value { name: "h.y", about: "half-extent in y", of: |c| half_extents(c).map(|h| Quantity::exactly(h.y)) },
    Value {
        name: "c.x",
        about: "x of the bounds' centre",
        of: |c| bounds(c, |[min, max]| middle(min.x, max.x)),
    },
    Value {
        name: "c.y",
        about: "y of the bounds' centre",
        of: |c| bounds(c, |[min, max]| middle(min.y, max.y)),
    },
];

/// Every value that a text may name, as in `{=time}`, with what it is; which of them an answer has depends on
/// the query.
///
/// ```
/// let time = tracefig::figure::values().find(|(name, _)| *name == "time").unwrap();
/// assert_eq!(time.1, "time of first contact, else the panel's moment");
/// ```
pub fn values() -> impl Iterator<Item = (&'static str, &'static str)> {
    VALUES.iter().map(|value| (value.name, value.about))
}

/// The value of a name; `None` where the query does not have it.
pub(crate) fn value_of(name: &str, context: &Context) -> Option<Quantity> {
    VALUES.iter().find(|value| value.name == name).and_then(|value| (value.of)(context))
}

/// The bounds of the separation at the panel's moment.
pub(super) fn separation(context: &Context) -> Option<Quantity> {
    let run = context.separation_at(context.time)?;
    Some(Quantity::separation(run.separation()?))
}

/// The bounds of the distance or depth at the panel's moment.
fn distance_or_depth(context: &Context) -> Option<Quantity> {
    let run = context.separation_at(context.time)?;
    Some(Quantity::distance_or_depth(run.separation()?))
}

/// The bounds of the depth; `None` for bodies that are apart.
fn depth(context: &Context) -> Option<Quantity> {
    let s = separation(context)?;
    (s.hi <= 0.0).then_some(s.negated())
}

/// The bounds of the time of first contact, or the panel's moment.
fn time(context: &Context) -> Option<Quantity> {
    match &context.run().answer {
        Answer::Impact(_) => context.hit_time().map(Quantity::within),
        Answer::MotionBound(_) => None,
        _ => Some(Quantity::exactly(context.time)),
    }
}

/// The bounds of the least separation of a miss.
fn least(context: &Context) -> Option<Quantity> {
    Some(Quantity::within(context.closest()?.bounds))
}

/// The article's first step `t = d / (v·n + r_A|ω_A| + r_B|ω_B|)`, as an advancement takes it, whichever
/// algorithm answered; for a motion bound the bound itself.
fn bound(context: &Context) -> Option<Quantity> {
    let run = context.run();
    match &run.answer {
        Answer::MotionBound(found) => Some(Quantity::at_most(found.bound)),
        Answer::Impact(_) => first_step(context).map(Quantity::exactly),
        _ => None,
    }
}

/// The time that the first step of an advancement proves free, beyond 1 where nothing touches until then;
/// `None` for bodies that touch at the start or do not approach.
fn first_step(context: &Context) -> Option<f64> {
    context
        .first_step()?
        .find_told(|event| match *event {
            Event::Advanced { separation, bound, next, .. } => Some((separation, bound, next)),
            _ => None,
        })
        .and_then(|(separation, bound, next)| {
            next.or_else(|| (separation > 0.0 && bound > 0.0).then(|| separation / bound))
        })
}

/// How many distances the advancement asked for.
fn iterations(context: &Context) -> Option<Quantity> {
    match &context.run().answer {
        Answer::Impact(impact) => Some(Quantity::exactly(count(impact.iterations))),
        _ => None,
    }
}

/// The tolerance of the answer, world units.
fn tolerance(context: &Context) -> Option<Quantity> {
    match &context.run().answer {
        Answer::Impact(impact) if has_a_tolerance(context.scene.query.kind) => {
            Some(Quantity::exactly(impact.tolerance))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::VALUES;
    use crate::figure::plan;
    use crate::figure::text::{in_words, rounded};
    use crate::scene::{Source, read};
    use crate::trace::Event;

    #[test]
    fn the_bound_of_a_round_body_is_the_first_step_that_the_algorithm_takes() {
        let text = r#"
            caption = "{=bound}"
          shapes.A = { kind = "capsule", points = [[-1, 0], [1, 0]], radius = 0.5, angular_velocity_deg = 90 }
            shapes.B = { kind = "circle", radius = 1, position = [4, 0], velocity = [-2, 0] }
            query = { kind = "time-of-impact", of = ["A", "B"], algorithm = "conservative-advancement" }
            panels = [{ space = "world", layers = ["shapes"] }]
        "#;
        let scene = read(&Source::new("round.toml", text)).unwrap();
        let plan = plan(&scene).unwrap();
        let run = plan.own_run();
        let mut steps = run.events().filter_map(|event| match event {
            Event::Advanced { next, .. } => *next,
            _ => None,
        });
        let first = steps.next().unwrap();
        assert_eq!(plan.caption.words, Some(in_words(&rounded(first, first))));
    }

    #[test]
    fn a_step_has_the_values_that_the_trace_tells_of_it() {
        const BODIES: &str = r#"
            shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [3, 1] }
            shapes.B = { kind = "circle", radius = 0.75, position = [4, 0.5], velocity = [-1, 0.5] }
        "#;
        for (kind, algorithm) in
            [("linear-sweep", "ray-clipping"), ("time-of-impact", "conservative-advancement")]
        {
            for (space, step) in [("world", 1), ("world", 2), ("configuration", 1), ("configuration", 2)] {
                let text = format!(
                    "{BODIES}\nquery = {{ kind = '{kind}', of = ['A', 'B'], algorithm = '{algorithm}' }}
                    panels = [{{ space = '{space}', step = {step}, layers = ['origin'] }}]"
                );
                let scene = read(&Source::new("steps.toml", &text)).unwrap();
                let plan = plan(&scene).unwrap();
                let context = plan.panels[0].context(&scene, &plan.runs);
                let value = |name| VALUES.iter().find(|v| v.name == name).and_then(|v| (v.of)(&context));
                let run = plan.own_run();
                let told = run.events().filter(|e| matches!(e, Event::Advanced { .. })).nth(step - 1);
                let Some(&Event::Advanced { at, separation, normal, closing_speed, bound, next, .. }) = told
                else {
                    panic!("{text}")
                };
                let expected = [
                    ("step.time", Some(at.time)),
                    ("step.separation", Some(separation)),
                    ("step.next", next),
                    ("step.bound", Some(bound)),
                    ("step.moving", Some(closing_speed)),
                    ("step.turning", Some(bound - closing_speed)),
                    ("separation", Some(separation)),
                    ("n.x", Some(normal.x)),
                    ("n.y", Some(normal.y)),
                ];
                for (name, expected) in expected {
                    let near = value(name).zip(expected).map(|(v, e)| (v.lo - e).abs().max((v.hi - e).abs()));
                    assert_eq!(value(name).is_some(), expected.is_some(), "{name}, {text}");
                    assert!(near.is_none_or(|off| off < 1e-12), "{name}: {:?}, {expected:?}", value(name));
                }
            }
        }
    }
}
