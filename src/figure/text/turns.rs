//! What texts say of a turn: of two bodies that of the first which turns, as the layer `arc` draws it.

use crate::figure::context::Context;
use crate::trace::Event;

use super::quantity::Quantity;

/// The numbers of a turn.
#[derive(Clone, Copy)]
pub(super) struct Turn {
    /// The angle, radians.
    pub(super) theta: f64,
    /// Distance of the farthest point from the body's origin.
    pub(super) radius: f64,
    /// The length of its arc.
    pub(super) arc: f64,
}

/// What `pick` takes of the turn of the first body that turns; where none does, of the first body.
pub(super) fn turn(context: &Context, pick: fn(Turn) -> f64) -> Option<Quantity> {
    let first = |least: f64| {
        context.run().find_told(|event| match *event {
            Event::MotionBounded { theta, radius, arc, .. } if theta >= least => {
                Some(Turn { theta, radius, arc })
            }
            _ => None,
        })
    };
    let found = first(f64::MIN_POSITIVE).or_else(|| first(0.0))?;
    Some(Quantity::exactly(pick(found)))
}

#[cfg(test)]
mod tests {
    use crate::drawing::Item;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn of_two_bodies_the_one_that_turns_has_the_angle() {
        let said = |spins: [f64; 2]| {
            let [a, b] = spins.map(|spin| format!("angular_velocity_deg = {spin}"));
            let text = format!(
                "caption = '{{=theta}} {{=theta.rad:.2}} {{=radius}} {{=L:.2}}'
                 shapes.A = {{ kind = 'box', half_extents = [3, 4], velocity = [1, 0], {a} }}
                 shapes.B = {{ kind = 'box', half_extents = [0.6, 0.8], position = [9, 0], {b} }}
                 query = {{ kind = 'motion-bound', of = ['A', 'B'] }}
                 panels = [{{ layers = ['shapes'] }}]"
            );
            let scene = open_text("turns", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let drawing = draw(&plan, plan.theme, "turns").drawing;
            let caption = drawing.items.iter().find_map(|item| match item {
                Item::Group(group) if group.name == "caption" => group.label.clone(),
                _ => None,
            });
            caption.unwrap()
        };
        for (spins, expected) in [
            ([0.0, 90.0], "90 1.57 1 1.57"),
            ([-90.0, 30.0], "90 1.57 5 7.85"),
            ([0.0, 0.0], "0 0.00 5 0.00"),
        ] {
            assert_eq!(said(spins), expected);
        }
    }
}
