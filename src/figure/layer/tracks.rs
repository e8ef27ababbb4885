//! The paths of the two points that touch, from t = 0 to the hit: rarely the points that are closest at the
//! start. Each is marked where it is at the panel's moment.

use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, Marker, Pen, Rank, Sketch};
use crate::geometry::{DVec2, Side};
use crate::scene::When;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

pub(super) const LAYER: Layer = Layer {
    name: "tracks",
    about: "paths of the two points that touch at the hit, from the start until then",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "ahead",
            takes: Takes::Flag,
            default: "false",
            about: "the way that is still ahead at the panel's moment, and no more",
        },
        OptionSpec {
            name: "from",
            takes: Takes::When(&[When::START, When::BOUND]),
            default: "start",
            about: "the moment from which on the way is drawn",
        },
    ],
    labels: &[
        LabelKey { key: "x1", about: "the point of A" },
        LabelKey { key: "x2", about: "the point of B" },
    ],
    needs: "a hit",
    fed: |context, _| Fed::by_a_hit(context),
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((time, contact)) = context.hit() else { return };
    let from = options.when("from").and_then(|when| context.moment(&when)).map_or(0.0, |m| m.time);
    let begin = if options.flag("ahead", false) { context.time } else { from }.min(time);
    sketch.since(context.answered());
    for (side, point, key, marker) in
        [(Side::A, contact.points[0], "x1", Marker::Disc), (Side::B, contact.points[1], "x2", Marker::Square)]
    {
        let (Some(then), Some(now)) = (context.pose(side, time), context.pose(side, context.time)) else {
            continue;
        };
        let local = then.inverse_point(point);
        let path = context.track(side, local, [begin, time]);
        let role = options.role(side.into());
        if path.first() != path.last() {
            sketch.part(part("track", side)).path_through_time(&path, Pen::path(role));
        }
        let place = now.point(local);
        sketch.part(part("track", side)).marker(place, marker, role, LARGE_MARKER);
        let away = path.first().zip(path.get(1)).map_or(DVec2::ZERO, |(&start, &next)| start - next);
        let anchor = Anchor::point_toward(place, away);
        let text = format!("${}$", context.numbered("x", side));
        sketch.label(Label::new(key, text, anchor, role).rank(Rank::Point));
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    /// How far the way of A's point runs on the page, of a box that meets another at t = 0.5.
    fn long(options: &str) -> f64 {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [8, 0],
                angular_velocity_deg = 60 }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [6, 0] }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'] }}
            panels = [{{ time = 'hit', view = [-2, -3, 8, 3], layers = [{{ layer = 'tracks'{options} }}] }}]"
        );
        let scene = open_text("tracks", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "tracks");
        paths(&figure.drawing.items, "track-A")[0].contour.bounds().unwrap().width()
    }

    #[test]
    fn from_the_bound_on_the_way_is_shorter_than_from_the_start() {
        let (whole, rest) = (long(""), long(", from = 'bound'"));
        assert!((whole - long(", from = 'start'")).abs() < 1e-9);
        assert!(rest > 1.0 && rest < 0.5 * whole, "{rest} of {whole}");
    }
}
