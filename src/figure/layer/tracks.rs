//! The paths of the two points that touch, from t = 0 to the hit: rarely the points that are closest at the
//! start.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Dash, LARGE_MARKER, Label, Marker, Outline, Pen, Rank, Sketch};
use crate::geometry::{DVec2, Side};

use super::{Fed, LabelKey, Layer, Options, Shows, part};

/// How many pieces a path is drawn in: a full turn in as many chords is 0.3 px from a path of 200 px radius.
const PIECES: u32 = 64;

pub(super) const LAYER: Layer = Layer {
    name: "tracks",
    about: "paths of the two points that touch at the hit",
    shows: Shows::World,
    options: &[],
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
    for (side, point, key, text, marker) in [
        (Side::A, contact.points[0], "x1", "$x_1$", Marker::Disc),
        (Side::B, contact.points[1], "x2", "$x_2$", Marker::Square),
    ] {
        let path = path(context, side, point, time);
        let role = options.role(side.into());
        if path.first() != path.last() {
            let pen = Pen::ghost(role).width(1.75).dash(Dash::Dotted);
            sketch.part(part("track", side)).area(&Outline::polyline(&path), None, Some(pen));
        }
        if let (Some(&start), Some(&next)) = (path.first(), path.get(1)) {
            sketch.part(part("track", side)).marker(start, marker, role, LARGE_MARKER);
            let anchor = Anchor::point_toward(start, start - next);
            sketch.label(Label::new(key, text, anchor, Role::Ink).rank(Rank::Point));
        }
    }
}

/// Where the point of a body that is at `point` at the hit is from t = 0 until `time`, in the world.
fn path(context: &Context, side: Side, point: DVec2, time: f64) -> Vec<DVec2> {
    let Some(local) = context.pose(side, time).map(|pose| pose.inverse_point(point)) else {
        return Vec::new();
    };
    let at =
        |i: u32| context.pose(side, time * f64::from(i) / f64::from(PIECES)).map(|pose| pose.point(local));
    (0..=PIECES).filter_map(at).collect()
}
