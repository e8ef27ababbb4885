//! How far a body reaches from its origin, as a line to its farthest point.

use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch};
use crate::figure::text::number;
use crate::geometry::{Body, DVec2, Side};
use crate::scene::When;

use super::{Options, part};

/// How far a body reaches beside the line of its reach at least, page pixels, for that to be named in it: as
/// far as its letters and number.
const SLIM: f64 = 56.0;

/// Draws how far each body reaches from its origin, about which it turns; its core, where the question is for
/// the first contact, as in the bound on the approach: a disc is as near whichever way it is turned.
pub(super) fn reaches(sketch: &mut Sketch, context: &Context, options: &Options) {
    let turns = context.sides().iter().any(|&side| context.body(side).is_some_and(Body::turns));
    if turns && context.asks_for_a_hit() {
        // In steps it comes with the bound that it is for.
        sketch.since(context.known(&When::Bound));
    }
    for side in options.of(&context.sides()) {
        let (Some(body), Some(pose)) = (context.body(side), context.pose(side, context.time)) else {
            continue;
        };
        let far = body.shape.vertices.iter().max_by(|p, q| p.length().total_cmp(&q.length()));
        let Some(&far) = far else { continue };
        let out = far.try_normalize().unwrap_or(DVec2::X);
        let of_core = far != DVec2::ZERO && turns && context.asks_for_a_hit();
        let radius = if of_core { 0.0 } else { body.shape.radius };
        let (center, tip) = (pose.position, pose.point(far + out * radius));
        let role = options.role(side.into());
        // Without ticks: at a vertex they would stick out of the body as a head does.
        sketch.part(part("reach", side)).line(center, tip, Pen::dimension(role).width(1.5));
        let key = if side == Side::A { "r1" } else { "r2" };
        let text = format!("${} = {}$", context.named(side).below("r"), number(center.distance(tip)));
        let (along, points) = (tip - center, context.outline(side, context.time));
        let across = |p: DVec2| along.normalize_or_zero().perp_dot(p - center).abs();
        let wide =
            points.map_or(0.0, |outline| outline.sampled().into_iter().map(across).fold(0.0, f64::max));
        // In a slim body there is no room beside the line.
        let slim = sketch.on_page(wide) < sketch.fitted(SLIM);
        let anchor = if slim { Anchor::tip(center, tip) } else { Anchor::middle(center, tip) };
        sketch.label(Label::new(key, text, anchor, role));
    }
}
