//! What of a body a reader can take hold of, where a layer draws it: its place, its vertices, its angle, its
//! radius, the tip of its velocity.

use crate::figure::context::Context;
use crate::figure::handle::{Follows, Hold, LEAST, Setting, angle, is_wanted, vertex_key};
use crate::figure::sketch::Sketch;
use crate::geometry::shape::VertexKey;
use crate::geometry::{DVec2, Pose, Side};
use crate::scene::{Grip, Space};

use super::number_of;

/// How far beyond a body its angle is held, page pixels: far enough not to lie on its outline.
const OUT: f64 = 20.0;

/// The index of a body of the query.
fn index(context: &Context, side: Side) -> Option<usize> {
    context.scene.query.of.get(usize::from(side == Side::B)).copied()
}

/// Lets a body of the query be held, as it is drawn at the panel's moment.
pub(super) fn body(sketch: &mut Sketch, context: &Context, side: Side) {
    // What a moving frame shows does not follow a body's own numbers.
    let Some((index, pose)) = index(context, side).zip(context.pose(side, context.time)) else { return };
    if context.moving_frame().is_none() {
        hold(sketch, context, index, &pose);
    }
}

/// Lets a body be held that the query is not about.
pub(super) fn bystander(sketch: &mut Sketch, context: &Context, index: usize) {
    if let Some((_, body)) = context.scene.shapes.get(index)
        && context.moving_frame().is_none()
    {
        hold(sketch, context, index, &body.pose_at(context.time));
    }
}

/// Lets a body in its pose be held by what the scene lets be dragged.
fn hold(sketch: &mut Sketch, context: &Context, index: usize, pose: &Pose) {
    let Some((_, body)) = context.scene.shapes.get(index) else { return };
    let wanted = |grip| is_wanted(context.scene, index, grip);
    let least = f64::NEG_INFINITY;
    let held = |grip, at, value, follows| Hold { body: index, grip, vertex: 0, at, value, least, follows };
    // In its own frame a body rests, wherever it is.
    let own = *context.space == Space::Body(index);
    if wanted(Grip::Position) && !own {
        let value = Setting::Pair(body.position);
        let at = middle(&body.shape.vertices, pose);
        sketch.hold(held(Grip::Position, at, value, Follows::Plane([DVec2::X, DVec2::Y])));
    }
    if wanted(Grip::Angle) && !own {
        let (_, value, unit) = angle(body);
        let reach = body.shape.vertices.iter().map(|v| v.x).fold(0.0, f64::max) + body.shape.radius;
        let at = pose.point(DVec2::X * (reach + sketch.px(OUT)));
        sketch.hold(held(Grip::Angle, at, Setting::Number(value), Follows::Turn(pose.position, unit)));
    }
    if wanted(Grip::Radius)
        && let Some(&first) = body.shape.vertices.first()
    {
        let about = pose.point(first);
        let out =
            (about - pose.position).try_normalize().unwrap_or_else(|| DVec2::new(1.0, -1.0).normalize());
        let value = Setting::Number(body.shape.radius);
        let at = about + out * body.shape.radius;
        sketch.hold(Hold { least: LEAST, ..held(Grip::Radius, at, value, Follows::Reach(about)) });
    }
    if wanted(Grip::Vertices) {
        vertices(sketch, context, index, pose);
    }
}

/// Lets each vertex of a body be held.
fn vertices(sketch: &mut Sketch, context: &Context, index: usize, pose: &Pose) {
    let Some((_, body)) = context.scene.shapes.get(index) else { return };
    let key = vertex_key(body);
    let local = |v: DVec2| pose.inverse_point(pose.position + v);
    let [x, y] = [local(DVec2::X), local(DVec2::Y)];
    for (vertex, &v) in body.shape.vertices.iter().enumerate() {
        let (value, least, follows) = match (key, body.shape.half_extents) {
            (VertexKey::Each(_), _) => (v, f64::NEG_INFINITY, [x, y]),
            (VertexKey::Half(_), Some(half)) => (half, LEAST, [x * v.signum(), y * v.signum()]),
            _ => return,
        };
        let (grip, at, value) = (Grip::Vertices, pose.point(v), Setting::Pair(value));
        sketch.hold(Hold { body: index, grip, vertex, at, value, least, follows: Follows::Plane(follows) });
    }
}

/// Lets the tip of a velocity be held, of an arrow that is `scale` world units long for a unit of velocity.
pub(super) fn velocity(sketch: &mut Sketch, context: &Context, side: Side, (tip, scale): (DVec2, f64)) {
    let Some((index, body)) = index(context, side).zip(context.body(side)) else { return };
    // By the panel's moment the arrow's start has come along.
    let length = scale + context.time;
    if !is_wanted(context.scene, index, Grip::Velocity) || context.moving_frame().is_some() || length == 0.0 {
        return;
    }
    let follows = Follows::Plane([DVec2::X / length, DVec2::Y / length]);
    let (grip, value) = (Grip::Velocity, Setting::Pair(body.velocity));
    let least = f64::NEG_INFINITY;
    sketch.hold(Hold { body: index, grip, vertex: 0, at: tip, value, least, follows });
}

/// Where a body is held as a whole: the mean of its vertices, which is inside of it wherever its origin is.
fn middle(vertices: &[DVec2], pose: &Pose) -> DVec2 {
    pose.point(vertices.iter().sum::<DVec2>() / number_of(vertices.len().max(1)))
}
