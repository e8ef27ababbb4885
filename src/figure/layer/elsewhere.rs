//! Where a body is at another moment, as its panel shows it.

use crate::figure::context::Context;
use crate::figure::sketch::Outline;
use crate::geometry::Side;

use super::spin::seen;

/// The outline of a body at another moment; `None` where it is as it is now. By whole turns it has come back.
pub(super) fn then(context: &Context, side: Side, time: f64) -> Option<Outline> {
    let has_turned = || time != context.time && seen(context, side).is_some();
    let is_elsewhere = context.pose(side, time) != context.pose(side, context.time) || has_turned();
    context.outline(side, time).filter(|_| is_elsewhere)
}

/// Whether a body is elsewhere at some moment.
pub(super) fn moves(context: &Context, side: Side) -> bool {
    context.pose(side, 0.0) != context.pose(side, 1.0) || seen(context, side).is_some()
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::paths;
    use crate::figure::{Figure, draw, plan};
    use crate::scene::open_text;

    /// A blade that turns by so many degrees below a block that comes down on it, or past it.
    fn drawn(degrees: f64, keys: &str) -> Figure {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 0.5], angular_velocity_deg = {degrees} }}
             shapes.B = {{ kind = 'box', half_extents = [0.5, 0.5], position = [0, 2] }}
             query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }}
             {keys}"
        );
        let scene = open_text("turn", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw(&plan, plan.theme, "turn")
    }

    #[test]
    fn a_body_that_turns_by_whole_turns_is_no_body_at_rest() {
        let ghosts = |degrees| paths(&drawn(degrees, "").drawing.items, "ghost-A").len();
        let few = ghosts(359.0);
        assert!(few > 2 && ghosts(360.0) == few && ghosts(-720.0) > 2, "{few}");
        let keys = "panels = [{ layers = ['shapes', { layer = 'ghosts', at = 'end' }] }]";
        for degrees in [180, 360, 720] {
            let figure = drawn(f64::from(degrees), keys);
            let said: Vec<String> = figure.panels[0]
                .placed
                .iter()
                .flat_map(|label| label.lines.iter().map(|(_, line)| line.markup.clone()))
                .collect();
            assert!(said.contains(&"looks the same".to_owned()), "{said:?}");
            assert!(said.contains(&format!("turned ${degrees}°$")), "{said:?}");
        }
    }
}
