//! Handles: where they stand, and that what they set follows the pointer.

use std::f64::consts::PI;

use crate::drawing::{Offset, Point};
use crate::figure::{Handle, Pull, Setting, draw, handles_json, plan};
use crate::geometry::DVec2;
use crate::scene::{Grip, Scene, Source, read};

const BODIES: &str = "[shapes.A]\nkind = 'polygon'\nvertices = [[-1, -1], [2, -0.5], [0.5, 2]]\n\
    position = [1, 2]\nangle_deg = 30\nvelocity = [1, 0.5]\n\
    [shapes.B]\nkind = 'box'\nhalf_extents = [1, 0.5]\nposition = [5, 2]\nangle_rad = 0.5\nradius = 0.25\n\
    [shapes.wall]\nkind = 'circle'\nradius = 0.5\nposition = [3, -1]\n";

const ALL: &str = "live.drag = ['A', 'A.vertices', 'A.velocity', 'A.angle', 'B', 'B.vertices', 'B.angle', \
                   'B.radius', 'wall', 'wall.radius']\n";

/// A scene of one panel that shows the bodies and their velocities.
fn scene(top: &str, query: &str, panel: &str) -> Scene {
    let head = format!("{top}{BODIES}[query]\nkind = '{query}'\nof = ['A', 'B']\n");
    let text = format!("{head}[[panels]]\nview = [-4, -4, 9, 6]\n{panel}\n");
    read(&Source::new("test", &text)).unwrap_or_else(|e| panic!("{e:?}\n{text}"))
}

fn handles(scene: &Scene) -> Vec<Handle> {
    let plan = plan(scene).unwrap();
    draw(&plan, plan.theme, "t").handles
}

fn kinds(scene: &Scene) -> Vec<(usize, Grip)> {
    handles(scene).iter().map(|h| (h.body, h.grip)).collect()
}

const SHOWN: &str = "layers = ['shapes', { layer = 'velocity', scale = 0.5 }]";

/// The value that a handle has with the pointer there, as whoever drags computes it.
fn pulled(handle: &Handle, to: Point) -> Setting {
    let Offset { dx, dy } = to - handle.at;
    match (handle.value, handle.pull) {
        (Setting::Pair(value), Pull::Plane([right, down])) => Setting::Pair(value + right * dx + down * dy),
        (Setting::Number(value), Pull::Turn { about, unit }) => {
            let angle = |p: Point| libm::atan2(p.y - about.y, p.x - about.x);
            let turn = angle(to) - angle(handle.at);
            let turn = turn - 2.0 * PI * (turn / (2.0 * PI)).round();
            Setting::Number(value + unit * turn)
        }
        (Setting::Number(value), Pull::Reach { about, unit }) => {
            Setting::Number(value + unit * ((to - about).length() - (handle.at - about).length()))
        }
        other => panic!("{other:?}"),
    }
}

/// An offset, turned a little.
fn turned(Offset { dx, dy }: Offset) -> Offset {
    let (sin, cos) = (libm::sin(0.2), libm::cos(0.2));
    Offset::new(cos * dx - sin * dy, sin * dx + cos * dy)
}

/// Sets what a handle is of, as a scene's keys would.
fn set(scene: &mut Scene, handle: &Handle, value: Setting) {
    use crate::geometry::{Angle, Shape, shape::FieldValue};
    let body = &mut scene.shapes[handle.body].1;
    match (handle.grip, value) {
        (Grip::Position, Setting::Pair(v)) => body.position = v,
        (Grip::Velocity, Setting::Pair(v)) => body.velocity = v,
        (Grip::Angle, Setting::Number(x)) => {
            body.angle = match body.angle {
                Angle::Degrees(_) => Angle::Degrees(x),
                Angle::Radians(_) => Angle::Radians(x),
            }
        }
        (Grip::Radius, Setting::Number(x)) => body.shape.radius = x,
        (Grip::Vertices, Setting::Pair(v)) if body.shape.half_extents.is_some() => {
            let fields = [("half_extents", FieldValue::Point(v)), ("radius", FieldValue::Number(0.25))];
            body.shape = Shape::of_kind(body.shape.kind, &fields).unwrap();
        }
        (Grip::Vertices, Setting::Pair(v)) => {
            let mut vertices = body.shape.vertices.clone();
            vertices[handle.vertex] = v;
            body.shape = Shape::polygon(vertices).unwrap();
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn bodies_and_velocities_of_the_query_are_held_where_a_layer_draws_them() {
    use Grip::{Position, Velocity};
    let usual = scene("", "separation", SHOWN);
    // B rests and has no arrow.
    assert_eq!(kinds(&usual), [(0, Position), (1, Position), (0, Velocity)]);
    assert_eq!(
        kinds(&scene("", "separation", "layers = [{ layer = 'shapes', of = ['B'] }]")),
        [(1, Position)]
    );
    assert_eq!(kinds(&scene("live.drag = []\n", "separation", SHOWN)), []);
    assert_eq!(kinds(&scene("live.drag = ['wall.radius']\n", "separation", SHOWN)), [(2, Grip::Radius)]);
}

#[test]
fn a_handle_goes_where_the_pointer_goes() {
    let frame = "space = 'body'\nframe = 'B'\n";
    for panel in [SHOWN.to_owned(), format!("time = 0.5\n{SHOWN}"), format!("{frame}{SHOWN}")] {
        let scene = scene(ALL, "separation", &panel);
        let all = handles(&scene);
        let least = if panel.starts_with("space") { 13 } else { 15 };
        assert_eq!(all.len(), least, "{panel}: {all:?}");
        for (i, handle) in all.iter().enumerate() {
            let off = match handle.pull {
                Pull::Plane(_) => Offset::new(6.0, -4.0),
                // Along the ring, and outward.
                Pull::Turn { about, .. } => turned(handle.at - about) - (handle.at - about),
                Pull::Reach { about, .. } => (handle.at - about) * 0.3,
            };
            let to = handle.at + off;
            let mut moved = scene.clone();
            set(&mut moved, handle, pulled(handle, to));
            let there = handles(&moved)[i].at;
            assert!((there - to).length() < 1e-9 * 960.0, "{panel}: {handle:?}\n{there:?} for {to:?}");
        }
    }
}

#[test]
fn a_value_lies_in_its_range_and_a_box_keeps_a_size() {
    let scene = scene(ALL, "separation", SHOWN);
    for handle in handles(&scene) {
        let within = |lo: f64, x: f64, hi: f64| lo <= x && x <= hi;
        let ok = match (handle.range[0], handle.value, handle.range[1]) {
            (Setting::Number(lo), Setting::Number(x), Setting::Number(hi)) => within(lo, x, hi) && lo < hi,
            (Setting::Pair(lo), Setting::Pair(v), Setting::Pair(hi)) => {
                within(lo.x, v.x, hi.x) && within(lo.y, v.y, hi.y) && lo.x < hi.x && lo.y < hi.y
            }
            _ => false,
        };
        assert!(ok, "{handle:?}");
        if (handle.body, handle.grip) == (1, Grip::Vertices) {
            assert_eq!(handle.range[0], Setting::Pair(DVec2::splat(0.01)));
        }
    }
}

#[test]
fn nothing_is_held_where_the_answer_gives_the_moment_or_the_frame_moves() {
    for panel in ["time = 'hit'\n", "time = 'closest'\n", "space = 'body'\nframe = 'A'\n"] {
        let scene = scene("", "time-of-impact", &format!("{panel}{SHOWN}"));
        assert_eq!(kinds(&scene), [], "{panel}");
    }
    let cut = "layers = [{ layer = 'velocity', cut = 'hit' }]";
    let mut cut = scene("", "time-of-impact", cut);
    // A miss is drawn whole.
    assert_eq!(kinds(&cut), [(0, Grip::Velocity)]);
    cut.shapes[0].1.velocity = DVec2::new(4.0, 0.0);
    assert_eq!(kinds(&cut), []);
}

#[test]
fn each_handle_names_its_key_in_the_scene() {
    let json = handles_json(&handles(&scene(ALL, "separation", SHOWN)), &scene(ALL, "separation", SHOWN));
    let path = |name: &str| {
        let found = json.as_array().unwrap().iter().find(|h| h["name"] == name);
        found.unwrap_or_else(|| panic!("{name} in {json}"))["paths"][0].to_string()
    };
    assert_eq!(path("vertex 2 of A"), r#"["shapes","A","vertices",2]"#);
    assert_eq!(path("half-extents of B"), r#"["shapes","B","half_extents"]"#);
    assert_eq!(path("angle of A"), r#"["shapes","A","angle_deg"]"#);
    assert_eq!(path("angle of B"), r#"["shapes","B","angle_rad"]"#);
    assert_eq!(path("radius of wall"), r#"["shapes","wall","radius"]"#);
    assert_eq!(path("time"), r#"["query","time"]"#);
}

#[test]
fn what_no_layer_draws_can_still_be_changed_by_its_numbers() {
    let scene = scene("", "separation", "space = 'configuration'\nlayers = ['axes', 'origin']");
    assert_eq!(kinds(&scene), []);
    let json = handles_json(&[], &scene);
    let names: Vec<_> = json.as_array().unwrap().iter().map(|h| h["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["position of A", "velocity of A", "position of B", "time"]);
    assert_eq!(
        (&json[0]["at"], &json[1]["value"]),
        (&serde_json::Value::Null, &serde_json::json!([1.0, 0.5]))
    );
}

#[test]
fn the_playhead_moves_panels_that_no_one_pinned() {
    let paths = |top: &str, query: &str, panel: &str| {
        let json = handles_json(&[], &scene(top, query, &format!("{panel}{SHOWN}")));
        let last = json.as_array().unwrap().last().filter(|h| h["grip"] == "time").cloned();
        last.map(|playhead| format!("{} {}", playhead["paths"], playhead["value"]))
    };
    assert_eq!(paths("", "separation", "").unwrap(), r#"[["query","time"]] 0.0"#);
    assert_eq!(paths("", "time-of-impact", "").unwrap(), r#"[["panels",0,"time"]] 0.0"#);
    assert_eq!(paths("", "time-of-impact", "time = 'end'\n"), None);
    assert_eq!(paths("live.time = false\n", "separation", ""), None);
    let pinned = paths("live.time = true\n", "time-of-impact", "time = 'end'\n");
    assert_eq!(pinned.unwrap(), r#"[["panels",0,"time"]] 1.0"#);
    assert_eq!(paths("live.time = true\n", "time-of-impact", "time = 'hit'\n"), None);
}
