//! What texts say of boxes: corners, centre and half-extents.

use crate::figure::context::Context;
use crate::geometry::DVec2;
use crate::trace::Event;

use super::places::Places;
use super::quantity::Quantity;

/// Half-extents of the box or of the bounds.
pub(super) fn half_extents(context: &Context) -> Option<DVec2> {
    let of_the_box = context.run().find_told(|event| match event {
        Event::Clamped { half_extents, .. } => Some(*half_extents),
        _ => None,
    });
    of_the_box.or_else(|| corners(context).map(|[min, max]| (max - min) / 2.0))
}

/// The angle at the panel's moment of the box whose half-extents clamp.
pub(super) fn angle_of_the_box(context: &Context) -> Option<Quantity> {
    let side = context.run().find_told(|event| match event {
        Event::Clamped { body, .. } => Some(*body),
        _ => None,
    })?;
    context.body(side).map(|body| Quantity::exactly(body.angle_at(context.time)))
}

/// What `pick` takes of the half-extents of two AABBs.
pub(super) fn half(context: &Context, pick: fn([DVec2; 2]) -> f64) -> Option<Quantity> {
    let both = context.run().find_told(|event| match event {
        Event::ExtentsCompared { half_extents, .. } => Some(*half_extents),
        _ => None,
    })?;
    Some(Quantity::exactly(pick(both)))
}

/// What `pick` takes of the corners of the bounds.
pub(super) fn bounds(context: &Context, pick: fn([DVec2; 2]) -> f64) -> Option<Quantity> {
    let place = |x| Quantity::place(x, Places::of(context.scene));
    corners(context).map(pick).map(place)
}

/// The smallest and the largest corner of the bounds that answer: those found last, as the boxes of single
/// bodies come before their union.
fn corners(context: &Context) -> Option<[DVec2; 2]> {
    context.run().find_last_told(|event| match event {
        Event::BoundsFound { min, max, .. } => Some([*min, *max]),
        _ => None,
    })
}

/// What lies halfway between two numbers.
pub(super) fn middle(lo: f64, hi: f64) -> f64 {
    0.5 * (lo + hi)
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::figure::text::value_of;
    use crate::scene::open_text;

    /// What a value of two boxes at a distance is, by an algorithm.
    fn of(kind: &str, algorithm: &str, name: &str) -> Option<[f64; 2]> {
        let text = format!(
            "shapes.A = {{ kind = '{kind}', half_extents = [3, 2], {} }}
             shapes.B = {{ {}, position = [9, 2] }}
             query = {{ kind = 'separation', of = ['A', 'B'], algorithm = '{algorithm}' }}
             panels = [{{ space = 'world', layers = ['shapes'] }}]",
            if kind == "box" { "angle_deg = 30" } else { "position = [0, 0]" },
            if kind == "box" {
                "kind = 'circle', radius = 1"
            } else {
                "kind = 'aabb', half_extents = [1, 0.5]"
            },
        );
        let scene = open_text("boxes.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        value_of(name, &plan.panels[0].context(&scene, &plan.runs)).map(|q| [q.lo, q.hi])
    }

    #[test]
    fn each_box_has_its_half_extents_and_a_box_that_clamps_its_angle() {
        for (name, told) in [("a.x", 3.0), ("a.y", 2.0), ("b.x", 1.0), ("b.y", 0.5)] {
            assert_eq!(of("aabb", "extents", &format!("halves.{name}")), Some([told; 2]), "{name}");
        }
        assert_eq!(of("box", "clamp", "box.angle"), Some([30.0; 2]));
        assert_eq!(of("aabb", "extents", "box.angle"), None);
    }
}
