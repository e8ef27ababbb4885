//! What is said of the moment of something that is drawn at another one than the panel's.

use crate::figure::context::Context;
use crate::figure::text::{Quantity, number};

/// A moment as it is written: that of the first contact with no more digits than are proved.
pub(super) fn written(context: &Context, time: f64) -> String {
    let hit = context.hit_time().filter(|hit| hit.lo == time);
    hit.map_or_else(|| number(time), |hit| Quantity::within(hit).latex())
}

/// The line of a label that says a moment.
pub(super) fn at(context: &Context, time: f64) -> String {
    format!("at $t = {}$", written(context, time))
}

/// The line of a label that says the moment; none where it is the panel's own.
pub(super) fn other(context: &Context, time: f64) -> Option<String> {
    (time != context.time).then(|| at(context, time))
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn what_is_of_another_moment_says_which_and_is_square_to_nothing_that_is_not_drawn() {
        for (layers, spin, moment, square) in [
            ("", 0, true, true),
            ("", 90, true, false),
            ("{ layer = 'ghosts', at = 0.25 },", 90, true, true),
            ("at = 0,", 90, false, true),
        ] {
            let (ghosts, at) = if layers.starts_with("at") { ("", layers) } else { (layers, "at = 0.25,") };
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 0.5, position = [-3, 0], velocity = [4, 0] }}
                shapes.B = {{ kind = 'box', half_extents = [0.5, 1], angular_velocity_deg = {spin} }}
                query = {{ kind = 'time-of-impact', of = ['A', 'B'] }}
                panels = [{{ time = 'start', layers = ['shapes', {ghosts}
                    {{ {at} layer = 'separation' }}, {{ {at} layer = 'normal', from = 'edge' }}] }}]"
            );
            let scene = open_text("moment", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "moment");
            let labels = labels(&figure);
            let said = ["d", "n"].map(|key| labels[key].0.ends_with(" at $t = 0.25$"));
            assert_eq!(said, [moment; 2], "{text}: {labels:?}");
            let marks = paths(&figure.drawing.items, "right-angle").len();
            assert_eq!(marks, if square { 2 } else { 0 }, "{text}");
        }
    }
}
