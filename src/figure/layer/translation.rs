//! The minimum translation of B, −s n, as an arrow from its centre: it moves B until the bodies just touch.

use std::sync::Arc;

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::runs::Run;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch};
use crate::figure::touching::is_touch;
use crate::geometry::{Body, DVec2, Side};
use crate::trace::{Event, phrase};

use super::{Fed, LabelKey, Layer, Options, Shows, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "translation",
    in_words: phrase(["translation", "kürzester Schub", "poussée la plus courte", "empuje más corto"]),
    about: "the minimum translation of B from its centre",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[],
    labels: &[LabelKey { key: "P", about: "the minimum translation" }],
    needs: "a separation",
    fed: |context, _| Fed::by_the_scene(run(context).is_some()),
    draw,
};

/// The run that answers with the separation at the panel's moment.
fn run(context: &Context) -> Option<Arc<Run>> {
    context.separation_at(context.time).filter(|run| run.separation().is_some())
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let (Some(run), Some(pose)) = (run(context), context.pose(Side::B, context.time)) else { return };
    let Some(answer) = run.separation() else { return };
    sketch.since(run.end());
    let center = pose.point(context.body(Side::B).map_or(DVec2::ZERO, Body::center));
    let tip = center - answer.normal * answer.separation;
    let role = options.role(Role::Now);
    let of_circles = run.tells(|e| matches!(e, Event::PenetrationMeasured { .. }));
    let both = context.body(Side::A).zip(context.body(Side::B));
    let touches = both.is_some_and(|(a, b)| is_touch(answer, a, b));
    let text = if of_circles {
        "$P = N p$"
    } else if answer.separation > 0.0 && !touches {
        // Apart, B comes back along n; d is a length.
        r"$-d\,n$"
    } else {
        r"$d\,n$"
    };
    sketch.part("translation").arrow(center, tip, Pen::highlighted(role));
    sketch.label(Label::new("P", text, Anchor::middle(center, tip), role));
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{paths, points};
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    #[test]
    fn it_begins_at_the_centre_of_a_circle_wherever_its_origin_is() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            shapes.B = { kind = 'circle', radius = 1, center = [0.5, 0], position = [1, 0], angle_deg = 90 }
            query = { kind = 'separation', of = ['A', 'B'] }
            panels = [{ layers = ['shapes', 'translation'] }]";
        let scene = open_text("s", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "s");
        let line = points(paths(&figure.drawing.items, "translation")[0]);
        let begins = figure.panels[0].frame.page(DVec2::new(1.0, 0.5));
        assert!((line[0] - begins).length() < 1e-9, "{line:?}");
    }
}
