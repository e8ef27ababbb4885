//! Handles: what of a figure a reader can take hold of, where it is on the page, and which key of the scene
//! follows it.
//!
//! A layer declares a handle where it draws something that the scene says: a body's place, a vertex, the tip
//! of a velocity. How the value follows the pointer is linear or a turn or a reach, so that whoever drags
//! needs no geometry of the scene: with p the pointer and q the handle, both on the page,
//!
//! ```text
//! plane   value + M (p − q)
//! turn    value + u (∠(p − c) − ∠(q − c))        angles as the page's, y down
//! reach   value + u (p − q) · (q − c) / |q − c|
//! ```
//!
//! A frame later q is where the handle then is, so that what was only nearly linear comes right.

use serde_json::{Value, json};

use crate::drawing::Point;
use crate::geometry::shape::{KINDS, VertexKey};
use crate::geometry::{Angle, Body, DVec2};
use crate::scene::{Grip, Scene};

use super::frame::Frame;
use super::language::{Language, Row, rows};
use super::playhead::playhead;

/// Something on the page that can be dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// The body that it changes, by its index into [`Scene::shapes`].
    pub body: usize,
    /// What of the body it changes.
    pub grip: Grip,
    /// The number of the vertex, in the file's order; 0 for any other grip.
    pub vertex: usize,
    /// The panel that it stands in, from 0.
    pub panel: usize,
    /// Where it stands, page pixels.
    pub at: Point,
    /// What the scene says there, in its own units.
    pub value: Setting,
    /// The smallest and the largest value that lie within the panel, in the scene's units.
    pub range: [Setting; 2],
    /// How the value follows the pointer.
    pub pull: Pull,
}

/// A value that a handle sets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// A number, as an angle or a radius.
    Number(f64),
    /// Two numbers, as a place.
    Pair(DVec2),
}

/// How a value follows the pointer on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pull {
    /// By so much for a page pixel right, and for one down.
    Plane([DVec2; 2]),
    /// Turns with the pointer about a point.
    Turn {
        /// The point on the page that is turned about.
        about: Point,
        /// Units of the value for a radian of the page, whose angles go clockwise.
        unit: f64,
    },
    /// Grows with the distance from a point.
    Reach {
        /// The point on the page that it is measured from.
        about: Point,
        /// Units of the value for a page pixel.
        unit: f64,
    },
}

/// What a layer lets be dragged, in the world, before it is on a page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hold {
    /// The body, by its index.
    pub(crate) body: usize,
    /// What of it.
    pub(crate) grip: Grip,
    /// The number of the vertex; 0 for any other grip.
    pub(crate) vertex: usize,
    /// Where it is, in the world.
    pub(crate) at: DVec2,
    /// What the scene says.
    pub(crate) value: Setting,
    /// The least that it may be dragged to, for a length; else −∞.
    pub(crate) least: f64,
    /// How it follows.
    pub(crate) follows: Follows,
}

/// How a value follows a point of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Follows {
    /// By so much for a unit along x, and along y.
    Plane([DVec2; 2]),
    /// Turns about a point, by so many units a radian.
    Turn(DVec2, f64),
    /// Grows with the distance from a point.
    Reach(DVec2),
}

/// The nearest that a length comes to 0 by dragging, where a page pixel is more: a body of no size is none.
pub(crate) const LEAST: f64 = 0.01;

impl Hold {
    /// The handle on the page; `None` where it would stand outside of its panel.
    pub(crate) fn on_page(&self, frame: &Frame, panel: usize) -> Option<Handle> {
        let at = frame.page(self.at);
        let seen = frame.panel;
        let inside = (seen.x0..=seen.x1).contains(&at.x) && (seen.y0..=seen.y1).contains(&at.y);
        let pull = self.pull(frame);
        let range = self.range(frame, at, pull);
        let Self { body, grip, vertex, value, .. } = *self;
        inside.then_some(Handle { body, grip, vertex, panel, at, value, range, pull })
    }

    fn pull(&self, frame: &Frame) -> Pull {
        match self.follows {
            Follows::Plane([along_x, along_y]) => {
                let turned = |v: DVec2| frame.pose.map_or(v, |pose| pose.vector(v));
                let of = |v: DVec2| (along_x * v.x + along_y * v.y) / frame.scale;
                Pull::Plane([of(turned(DVec2::X)), of(turned(DVec2::NEG_Y))])
            }
            Follows::Turn(about, unit) => Pull::Turn { about: frame.page(about), unit: -unit },
            Follows::Reach(about) => Pull::Reach { about: frame.page(about), unit: 1.0 / frame.scale },
        }
    }

    /// The values at which the handle lies within the panel.
    fn range(&self, frame: &Frame, at: Point, pull: Pull) -> [Setting; 2] {
        let seen = frame.panel;
        // A pixel is no size either, in a world of bodies that are smaller.
        let least = self.least.min(1.0 / frame.scale);
        match (self.value, pull) {
            (Setting::Pair(value), Pull::Plane([right, down])) => {
                let vertices =
                    [(seen.x0, seen.y0), (seen.x1, seen.y0), (seen.x1, seen.y1), (seen.x0, seen.y1)];
                let values = vertices.map(|(x, y)| value + right * (x - at.x) + down * (y - at.y));
                let lo = values.into_iter().fold(value, DVec2::min).max(value.min(DVec2::splat(least)));
                [lo, values.into_iter().fold(value, DVec2::max)].map(Setting::Pair)
            }
            (Setting::Number(value), Pull::Turn { unit, .. }) => {
                let half = std::f64::consts::PI * unit.abs();
                [-half.max(-value), half.max(value)].map(Setting::Number)
            }
            (Setting::Number(value), Pull::Reach { unit, .. }) => {
                let most = 0.5 * seen.width().max(seen.height()) * unit;
                [least.min(value), most.max(value)].map(Setting::Number)
            }
            (value, _) => [value, value],
        }
    }
}

impl Handle {
    /// What it is, in words, as "vertex 2 of B"; in the scene's language, where we have it.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, scene::{Source, read}};
    /// let text = "live.drag = ['A.radius']\nshapes.A = { kind = 'circle', radius = 1 }\n\
    ///             query = { kind = 'bounds', of = ['A'] }\n[[panels]]\nlayers = ['shapes']";
    /// let scene = read(&Source::new("circle.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let handle = draw(&plan, plan.theme, "circle").handles[0];
    /// assert_eq!(handle.name(&scene), "radius of A");
    /// ```
    #[must_use]
    pub fn name(&self, scene: &Scene) -> String {
        self.named().name(scene)
    }

    fn named(&self) -> Named {
        Named { body: self.body, grip: self.grip, vertex: self.vertex }
    }

    fn json(&self, scene: &Scene) -> Value {
        let pull = match self.pull {
            Pull::Plane(m) => json!({ "plane": m.map(|v| [v.x, v.y]) }),
            Pull::Turn { about, unit } => json!({ "turn": [about.x, about.y], "unit": unit }),
            Pull::Reach { about, unit } => json!({ "reach": [about.x, about.y], "unit": unit }),
        };
        json!({
            "grip": self.grip.word(),
            "name": self.named().name(scene),
            "paths": [self.named().path(scene)],
            "value": self.value.json(),
            "range": self.range.map(Setting::json),
            "panel": self.panel,
            "vertex": self.vertex,
            "at": [self.at.x, self.at.y],
            "pull": pull,
        })
    }
}

/// What handles are called, as rows of a [`Language`].
pub(crate) static NAMES: &[Row] = &rows([
    ["position of *", "*", "Lage von *", "position de *", "posición de *"],
    ["half-extents of *", "*", "Halbmaße von *", "demi-étendues de *", "semiejes de *"],
    ["vertex * of *", "*, *", "Ecke * von *", "sommet * de *", "vértice * de *"],
    ["velocity of *", "*", "Geschwindigkeit von *", "vitesse de *", "velocidad de *"],
    ["angle of *", "*", "Winkel von *", "angle de *", "ángulo de *"],
    ["radius of *", "*", "Radius von *", "rayon de *", "radio de *"],
]);

/// What is changed, wherever it stands.
#[derive(Clone, Copy)]
struct Named {
    /// The body, by its index.
    body: usize,
    /// What of it.
    grip: Grip,
    /// The number of the vertex; 0 for any other grip.
    vertex: usize,
}

impl Named {
    fn name(self, scene: &Scene) -> String {
        let name = scene.shapes.get(self.body).map_or("", |(name, _)| name.value.as_str());
        let english = match self.grip {
            Grip::Position => format!("position of {name}"),
            Grip::Vertices if self.is_half(scene) => format!("half-extents of {name}"),
            Grip::Vertices => format!("vertex {} of {name}", self.vertex),
            Grip::Velocity => format!("velocity of {name}"),
            Grip::Angle => format!("angle of {name}"),
            Grip::Radius => format!("radius of {name}"),
        };
        Language::of(scene).of_rows(NAMES, &english)
    }

    /// Whether it sets how far a box reaches, which is one value for all its vertices.
    fn is_half(self, scene: &Scene) -> bool {
        let body = scene.shapes.get(self.body);
        body.is_some_and(|(_, body)| matches!(vertex_key(body), VertexKey::Half(_)))
    }

    /// The keys that lead from the top of the scene to the value, as `["shapes", "B", "position"]`.
    fn path(self, scene: &Scene) -> Value {
        let Some((name, body)) = scene.shapes.get(self.body) else { return Value::Null };
        let mut path = vec![json!("shapes"), json!(name.value)];
        match self.grip {
            Grip::Position | Grip::Velocity | Grip::Radius => path.push(json!(self.grip.word())),
            Grip::Angle => path.push(json!(angle(body).0)),
            Grip::Vertices => match vertex_key(body) {
                VertexKey::Each(key) => path.extend([json!(key), json!(self.vertex)]),
                VertexKey::Half(key) => path.push(json!(key)),
                VertexKey::None => return Value::Null,
            },
        }
        Value::Array(path)
    }
}

impl Setting {
    fn json(self) -> Value {
        match self {
            Self::Number(x) => json!(x),
            Self::Pair(v) => json!([v.x, v.y]),
        }
    }
}

/// Which key sets a body's vertices.
pub(crate) fn vertex_key(body: &Body) -> VertexKey {
    KINDS.iter().find(|kind| kind.name == body.shape.kind).map_or(VertexKey::None, |kind| kind.vertices)
}

/// The key that a body's angle stands under, the angle as written, and units for a radian.
pub(crate) fn angle(body: &Body) -> (&'static str, f64, f64) {
    match body.angle {
        Angle::Degrees(degrees) => ("angle_deg", degrees, 1f64.to_degrees()),
        Angle::Radians(radians) => ("angle_rad", radians, 1.0),
    }
}

/// What can be changed in a live figure, for the page around it: the handles, then the playhead where there
/// is one, each with its keys in the scene.
///
/// ```
/// use tracefig::{figure::{draw, handles_json, plan}, scene::{Source, read}};
/// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }\n\
///             [[panels]]\nlayers = ['shapes']\nview = [-2, -1, 2, 1]";
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let json = handles_json(&draw(&plan, plan.theme, "circle").handles, &scene);
/// assert_eq!(json[0]["paths"], serde_json::json!([["shapes", "A", "position"]]));
/// assert_eq!(json[0]["value"], serde_json::json!([0.0, 0.0]));
/// assert_eq!(json.as_array().map(Vec::len), Some(1));
/// ```
#[must_use]
pub fn handles_json(handles: &[Handle], scene: &Scene) -> Value {
    let undrawn = (0..scene.shapes.len()).flat_map(|body| NUMBERS.map(|grip| (body, grip)));
    let undrawn = undrawn.filter(|&(body, grip)| {
        is_wanted(scene, body, grip) && !handles.iter().any(|h| (h.body, h.grip) == (body, grip))
    });
    let undrawn = undrawn.filter_map(|(body, grip)| number(scene, body, grip));
    let drawn = handles.iter().map(|handle| handle.json(scene));
    drawn.chain(undrawn).chain(playhead(scene)).collect()
}

/// What can be changed by its numbers where no layer draws it.
const NUMBERS: [Grip; 4] = [Grip::Position, Grip::Velocity, Grip::Angle, Grip::Radius];

/// Whether a reader may change something of a body: by what the scene says, else bodies and velocities of the
/// query.
pub(crate) fn is_wanted(scene: &Scene, body: usize, grip: Grip) -> bool {
    match &scene.live.drag {
        Some(drag) => drag.iter().any(|drag| (drag.value.body, drag.value.grip) == (body, grip)),
        None => match grip {
            Grip::Position => scene.query.of.contains(&body),
            Grip::Velocity => scene.query.of.contains(&body) && scene.shapes[body].1.velocity != DVec2::ZERO,
            Grip::Vertices | Grip::Angle | Grip::Radius => false,
        },
    }
}

/// What is changed by its numbers alone.
fn number(scene: &Scene, body: usize, grip: Grip) -> Option<Value> {
    let (_, of) = scene.shapes.get(body)?;
    let value = match grip {
        Grip::Position => Setting::Pair(of.position),
        Grip::Velocity => Setting::Pair(of.velocity),
        Grip::Angle => Setting::Number(angle(of).1),
        Grip::Radius => Setting::Number(of.shape.radius),
        Grip::Vertices => return None,
    };
    let named = Named { body, grip, vertex: 0 };
    Some(json!({
        "grip": grip.word(), "name": named.name(scene), "paths": [named.path(scene)], "value": value.json(),
    }))
}
