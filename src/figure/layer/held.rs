//! What of a body a reader can take hold of, where a layer draws it: its place, its vertices, its angle, its
//! radius, the tip of its velocity; and what of B ⊖ A follows from one of these.

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
    // Of a box the corner to which both half-extents lead comes first: keys that move it move them.
    let mut all: Vec<(usize, DVec2)> = body.shape.vertices.iter().copied().enumerate().collect();
    if let VertexKey::Half(_) = key {
        let first = all.iter().position(|(_, v)| v.signum() == DVec2::ONE).unwrap_or(0);
        all.rotate_left(first);
    }
    for (vertex, v) in all {
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

/// Lets B ⊖ A be held as a whole, at a point of it: it goes where B goes.
pub(super) fn difference(sketch: &mut Sketch, context: &Context, at: DVec2) {
    let Some((index, body)) = index(context, Side::B).zip(context.body(Side::B)) else { return };
    if !is_wanted(context.scene, index, Grip::Position) {
        return;
    }
    let (value, follows) = (Setting::Pair(body.position), Follows::Plane([DVec2::X, DVec2::Y]));
    let (grip, least) = (Grip::Position, f64::NEG_INFINITY);
    sketch.hold(Hold { body: index, grip, vertex: 0, at, value, least, follows });
}

/// Lets the tip of the relative velocity be held, of an arrow that is `scale` units long for a unit of it: A
/// follows, or B the other way where A rests.
pub(super) fn closing_velocity(sketch: &mut Sketch, context: &Context, (tip, scale): (DVec2, f64)) {
    let is_moving = |side| context.body(side).is_some_and(|body| body.velocity != DVec2::ZERO);
    let (side, sign) = if is_moving(Side::A) { (Side::A, 1.0) } else { (Side::B, -1.0) };
    let Some((index, body)) = index(context, side).zip(context.body(side)) else { return };
    if scale == 0.0 || !is_wanted(context.scene, index, Grip::Velocity) {
        return;
    }
    let unit = sign / scale;
    let (grip, value) = (Grip::Velocity, Setting::Pair(body.velocity));
    let (least, follows) = (f64::NEG_INFINITY, Follows::Plane([DVec2::X * unit, DVec2::Y * unit]));
    sketch.hold(Hold { body: index, grip, vertex: 0, at: tip, value, least, follows });
}

/// Where a body is held as a whole: the mean of its vertices, which is inside of it wherever its origin is.
fn middle(vertices: &[DVec2], pose: &Pose) -> DVec2 {
    pose.point(vertices.iter().sum::<DVec2>() / number_of(vertices.len().max(1)))
}

#[cfg(test)]
mod tests {
    use crate::drawing::Point;
    use crate::figure::{Handle, Pull, draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    /// The handles of two moving discs in configuration space, at a step of the sweep; `b` is where B is, `v`
    /// how A moves.
    fn handles(b: [f64; 2], v: [f64; 2], panel: &str) -> Vec<Handle> {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 3, velocity = {v:?} }}
            shapes.B = {{ kind = 'circle', radius = 3.25, position = {b:?} }}
            query = {{ kind = 'linear-sweep', of = ['A', 'B'], algorithm = 'ray-clipping', tolerance = 1e-9 }}
            panels = [{{ space = 'configuration', view = [-4, -4, 14, 12],
                layers = ['difference', 'velocity'], {panel} }}]"
        );
        let scene = open_text("s", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw(&plan, plan.theme, "f").handles
    }

    #[test]
    fn the_difference_and_the_relative_velocity_follow_the_pointer() {
        for panel in ["step = 1", "step = 2", "time = 'start'", "time = 0.25"] {
            let (b, v) = ([8.0, 6.0], [7.5, 0.0]);
            let before = handles(b, v, panel);
            assert_eq!(before.len(), 2, "{panel}: {before:?}");
            let by = DVec2::new(0.5, -0.25);
            let moved = [handles([8.5, 5.75], v, panel)[0], handles(b, [8.0, -0.25], panel)[1]];
            for (before, after) in before.iter().zip(moved) {
                let Pull::Plane([right, down]) = before.pull else { panic!("{before:?}") };
                let Point { x, y } = before.at;
                let followed = right * (after.at.x - x) + down * (after.at.y - y);
                assert!((followed - by).length() < 1e-9, "{panel}: {followed}");
            }
        }
        // The answer gives the moment, and what is dragged would move that too.
        assert_eq!(handles([8.0, 6.0], [7.5, 0.0], "time = 'hit'"), []);
    }

    #[test]
    fn what_the_world_shows_is_held_there() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            shapes.B = { kind = 'circle', radius = 1, position = [4, 0] }
            query = { kind = 'separation', of = ['A', 'B'] }
            panels = [{ space = 'configuration', layers = ['difference'] }, { layers = ['shapes'] }]";
        let scene = open_text("s", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let panels: Vec<usize> = draw(&plan, plan.theme, "f").handles.iter().map(|h| h.panel).collect();
        assert_eq!(panels, [1, 1]);
    }
}
