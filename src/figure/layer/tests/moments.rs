//! Every layer follows its panel's moment, and a body's panel moves with its body.
//!
//! A panel of the moment T shows what the bodies are at then, whoever asks: so it looks like the start of a
//! motion that begins there, from the same places with the same velocities. And what a layer shows of another
//! moment τ in the frame of a body is what that frame shows at τ, whatever its panel's own moment is.

use crate::drawing::{Contour, Group, Item, Path, Point, Segment};
use crate::figure::layer::{LAYERS, Shows};
use crate::figure::plan;
use crate::figure::sketch::Request;
use crate::geometry::{Angle, DVec2};
use crate::scene::{Scene, When, open_text};

use super::last_number;

/// How far apart a thing may be drawn, page pixels: the times of hits are those of searches to 1e-9.
const NEAR: f64 = 1e-3;

/// Scenes that feed every layer that has a moment, and the parts of a layer that tell of the way from t = 0,
/// which no later motion has.
pub(super) const SCENES: &[(&str, &str)] = &[
    (
        "turning",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [3, 1], angular_velocity_deg = 150 }
        shapes.B = { kind = "polygon", vertices = [[-1, -0.5], [1, -0.5], [0, 0.75]], radius = 0.25,
            position = [4, 1.2], velocity = [-1, 0.5], angular_velocity_deg = -60 }
        query = { kind = "time-of-impact", of = ["A", "B"], algorithm = "conservative-advancement",
            tolerance = 1e-10 }
    "#,
    ),
    (
        "moving",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [3, 1], angle_deg = 10 }
        shapes.B = { kind = "circle", radius = 0.75, position = [4, 0.5], velocity = [-1, 0.5] }
        query = { kind = "time-of-impact", of = ["A", "B"], algorithm = "conservative-advancement",
            tolerance = 1e-10 }
    "#,
    ),
    (
        "swept",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [3, 1], angle_deg = 10 }
        shapes.B = { kind = "circle", radius = 0.75, position = [4, 0.5], velocity = [-1, 0.5] }
        query = { kind = "linear-sweep", of = ["A", "B"], algorithm = "ray-clipping" }
    "#,
    ),
    (
        "circles",
        r#"
        shapes.A = { kind = "circle", radius = 1, velocity = [2, 0.25] }
        shapes.B = { kind = "circle", radius = 0.75, position = [1.5, 0.5], velocity = [-0.5, 1] }
        query = { kind = "separation", of = ["A", "B"], algorithm = "circles" }
    "#,
    ),
    (
        "clamped",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [1, 1], angular_velocity_deg = 80 }
        shapes.B = { kind = "circle", radius = 0.75, position = [4, 0.5], velocity = [-1, 0.5] }
        query = { kind = "separation", of = ["A", "B"], algorithm = "clamp" }
    "#,
    ),
    (
        "level",
        r#"
        shapes.A = { kind = "aabb", half_extents = [0.8, 0.5], velocity = [1, 1] }
        shapes.B = { kind = "aabb", half_extents = [0.5, 0.5], position = [3, 0.5], velocity = [-1, 0.5] }
        query = { kind = "separation", of = ["A", "B"], algorithm = "extents" }
    "#,
    ),
    (
        "axes",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [1, 1], angular_velocity_deg = 80 }
        shapes.B = { kind = "box", half_extents = [0.5, 0.5], position = [3, 0.5], velocity = [-1, 0.5] }
        query = { kind = "separation", of = ["A", "B"], algorithm = "separating-axes" }
    "#,
    ),
    (
        "edges",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [1, 1], angular_velocity_deg = 80 }
        shapes.B = { kind = "box", half_extents = [0.5, 0.5], position = [1, 0.5], velocity = [-1, 0.5] }
        query = { kind = "separation", of = ["A", "B"], algorithm = "minkowski" }
    "#,
    ),
    (
        "merged",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [1, 1], angular_velocity_deg = 80 }
        shapes.B = { kind = "box", half_extents = [0.5, 0.5], position = [3, 0.5], velocity = [-1, 0.5] }
        query = { kind = "separation", of = ["A", "B"], algorithm = "merge" }
    "#,
    ),
    (
        "clipped",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [1, 1], angular_velocity_deg = 80 }
        shapes.B = { kind = "box", half_extents = [0.5, 0.5], position = [1, 0.5], velocity = [-1, 0.5] }
        query = { kind = "contact", of = ["A", "B"] }
    "#,
    ),
    (
        "simplexes",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [1, 1], angular_velocity_deg = 80 }
        shapes.B = { kind = "box", half_extents = [0.5, 0.5], position = [3, 0.5], velocity = [-1, 0.5] }
        query = { kind = "separation", of = ["A", "B"], algorithm = "gjk" }
    "#,
    ),
    (
        "boxed",
        r#"
        shapes.A = { kind = "box", half_extents = [0.8, 0.5], velocity = [1, 1], angular_velocity_deg = 80 }
        query = { kind = "bounds", of = ["A"] }
    "#,
    ),
];

/// Layers and parts that show what was from t = 0 on, or the steps of the algorithm, which another motion
/// does not share.
const OF_THE_START: &[(&str, &str)] = &[
    ("tracks", "track-A"),
    ("tracks", "track-B"),
    ("tracks", "ghost-A"),
    ("tracks", "ghost-B"),
    ("tracks", "look"),
    ("ray", "ray"),
    ("ray", "until-hit"),
    ("advancement", ""),
    ("graph", ""),
    ("fastest-approach", ""),
];

/// Layers that show the hit too: where it is past, no later motion has it.
const OF_THE_HIT: &[&str] = &["ghosts", "contact", "sweep", "ray", "velocity", "tracks"];

/// Layers that a moment does not change: a constant of the scene, what its author wrote, or what is of
/// another moment.
const OF_NO_MOMENT: &[&str] = &["axes", "origin", "note", "approach", "expected", "naive"];

/// A layer as a scene asks for it.
fn asked(layer: &str) -> String {
    match layer {
        "point" => "{ layer = 'point', of = 'A', at = [0.5, 0.25], coordinates = true }".to_owned(),
        _ => format!("'{layer}'"),
    }
}

/// A path or a label of a panel: the layer, the part and the places; or the key, the text and nothing.
type Thing = (String, String, Vec<Point>);

/// What the first panel of a scene shows, thing by thing.
fn shown(scene: &Scene) -> Vec<Thing> {
    let plan = plan(scene).unwrap_or_else(|problems| panic!("{problems:#?}"));
    let panel = &plan.panels[0];
    let sketched = panel.sketch(&panel.context(scene, &plan.runs), plan.theme);
    let mut things = Vec::new();
    for layer in &sketched.layers {
        for part in layer.items.iter().filter_map(group) {
            let paths = part.items.iter().filter_map(path);
            things.extend(paths.map(|path| (layer.name.clone(), part.name.clone(), places(path))));
        }
    }
    let label = |request: &Request| {
        // What is of another moment says when that is.
        let lines = request.label.lines.iter().filter(|line| !line.starts_with("at $t = "));
        let text = lines.cloned().collect::<Vec<_>>().join("|");
        // What is left at a hit is a matter of roundings.
        let nothing = last_number(&text).abs() < f64::from(f32::EPSILON);
        // A body at another moment says when that is, which another beginning of the motion moves.
        let name = text.split("at $t = ").next().unwrap_or_default().to_owned();
        (request.label.key.to_owned(), if nothing { "nothing".to_owned() } else { name }, vec![])
    };
    things.extend(sketched.requests.iter().map(label));
    things
}

fn group(item: &Item) -> Option<&Group> {
    if let Item::Group(group) = item { Some(group) } else { None }
}

fn path(item: &Item) -> Option<&Path> {
    if let Item::Path(path) = item { Some(path) } else { None }
}

/// The places that say where a path lies, page pixels.
fn places(path: &Path) -> Vec<Point> {
    let end = |center: Point, radius: f64, angle: f64| {
        Point::new(center.x + radius * libm::cos(angle), center.y + radius * libm::sin(angle))
    };
    let Contour::Segments(segments) = &path.contour else {
        let Contour::Circle { center, radius } = path.contour else { return Vec::new() };
        return vec![center, Point::new(center.x + radius, center.y)];
    };
    let of = |segment: &Segment| match *segment {
        Segment::Move(p) | Segment::Line(p) => vec![p],
        Segment::Quad(p, q) => vec![p, q],
        Segment::Cubic(p, q, r) => vec![p, q, r],
        Segment::Arc { center, radius, start, sweep } => {
            vec![center, end(center, radius, start), end(center, radius, start + sweep)]
        }
        Segment::Close => vec![],
    };
    segments.iter().flat_map(of).collect()
}

/// Says where two panels differ.
fn assert_same(one: &[Thing], two: &[Thing], why: &str) {
    let names = |things: &[Thing]| -> Vec<(String, String)> {
        things.iter().map(|(layer, part, _)| (layer.clone(), part.clone())).collect()
    };
    assert_eq!(names(one), names(two), "{why}");
    for ((layer, part, p), (_, _, q)) in one.iter().zip(two) {
        assert_eq!(p.len(), q.len(), "{why}: {layer} {part}");
        let off = p.iter().zip(q).map(|(p, q)| (*p - *q).length()).fold(0.0, f64::max);
        assert!(off < NEAR, "{why}: {layer} {part} is {off} px elsewhere: {p:?} {q:?}");
    }
}

/// A scene with one panel of one layer, as `view` shows it.
fn scene(bodies: &str, panel: &str, layer: &str, view: [f64; 4]) -> Scene {
    let text = format!("{bodies}\npanels = [{{ {panel}, view = {view:?}, layers = [{layer}] }}]");
    open_text("moments", &text).unwrap_or_else(|_| panic!("{text}")).scene
}

/// The scene whose motion begins at a time of this one: the same bodies, from where they are then.
fn restarted(scene: &Scene, time: f64) -> Scene {
    let mut scene = scene.clone();
    for (_, body) in &mut scene.shapes {
        (body.position, body.angle) = (body.pose_at(time).position, Angle::Degrees(body.angle_at(time)));
    }
    scene.query.time = 0.0;
    for panel in &mut scene.panels {
        panel.when = None;
    }
    scene
}

/// Whether a layer can stand in such a panel and finds what it draws there.
fn is_fed(scene: &Scene) -> bool {
    plan(scene).is_ok_and(|plan| !plan.panels[0].layers.is_empty())
}

/// Without what tells of the start.
fn of_the_moment(things: Vec<Thing>, layer: &str) -> Vec<Thing> {
    let apart = |name: &str, part: &str| OF_THE_START.contains(&(name, part));
    let label = |things: &Thing| things.2.is_empty() && layer == "ray";
    things.into_iter().filter(|t| !apart(&t.0, &t.1) && !label(t)).collect()
}

#[test]
fn every_layer_shows_what_the_bodies_are_at_the_panels_moment() {
    const VIEW: [f64; 4] = [-3.0, -4.0, 9.0, 5.0];
    let mut followed: Vec<&str> = Vec::new();
    for (name, bodies) in SCENES {
        for layer in LAYERS.iter().filter(|l| !OF_NO_MOMENT.contains(&l.name)) {
            if OF_THE_START.contains(&(layer.name, "")) {
                continue;
            }
            let space = if layer.shows == Shows::Configuration { "configuration" } else { "world" };
            for when in ["time = 0.3", "time = 0.05", "time = 'hit'", "time = 'end'", "step = 2"] {
                let panel = format!("space = '{space}', {when}");
                let moving = scene(bodies, &panel, &asked(layer.name), VIEW);
                let Some(plan) = plan(&moving).ok().filter(|plan| plan.warnings.is_empty()) else { continue };
                let context = plan.panels[0].context(&moving, &plan.runs);
                let (time, against) = (context.time, context.estimate());
                let past = context.hit().is_some_and(|(hit, _)| hit < time);
                if past && OF_THE_HIT.contains(&layer.name) {
                    continue;
                }
                let mut then = restarted(&moving, time);
                // A sweep's step moves the estimate over a difference that rests.
                let shifted =
                    [VIEW[0] - against.x, VIEW[1] - against.y, VIEW[2] - against.x, VIEW[3] - against.y];
                let moves = space == "configuration" && layer.name != "velocity";
                then.panels[0].view.as_mut().unwrap().value = if moves { shifted } else { VIEW };
                // What is left of the motion may have no hit, or overlap from its start on.
                if !is_fed(&then) || layer.name == "velocity" && against != DVec2::ZERO {
                    continue;
                }
                let [now, then] = [&moving, &then].map(|scene| of_the_moment(shown(scene), layer.name));
                assert_same(&now, &then, &format!("{name}, {}, {when} = {time}", layer.name));
                followed.push(layer.name);
            }
        }
    }
    let never = LAYERS.iter().map(|l| l.name).filter(|l| !followed.contains(l));
    let mut others: Vec<&str> = OF_NO_MOMENT.to_vec();
    // The bound of a whole motion, and the steps of an algorithm.
    others.extend(["arc", "advancement", "graph", "fastest-approach", "enlarged"]);
    assert!(never.clone().all(|layer| others.contains(&layer)), "{:?}", never.collect::<Vec<_>>());
}

#[test]
fn a_body_panel_shows_of_another_moment_what_it_shows_then() {
    const VIEW: [f64; 4] = [-7.0, -7.0, 7.0, 7.0];
    let bodies = SCENES[0].1;
    for frame in ["A", "B"] {
        let of = if frame == "A" { "B" } else { "A" };
        let panel = |when: &str| format!("space = 'body', frame = '{frame}', {when}");
        for at in [When::START, When::HIT, When::END] {
            let then = shown(&scene(
                bodies,
                &panel(&format!("time = '{at}'")),
                &format!("{{ layer = 'shapes', of = '{of}' }}"),
                VIEW,
            ));
            let ghost = format!("{{ layer = 'ghosts', at = '{at}', of = '{of}' }}");
            let ghost = shown(&scene(bodies, &panel("time = 0.3"), &ghost, VIEW));
            assert_same(
                &[("body".into(), String::new(), then[0].2.clone())],
                &[("body".into(), String::new(), ghost[0].2.clone())],
                &format!("{of} at {at} in the frame of {frame}"),
            );
            for layer in ["separation", "normal"] {
                let layer = format!("{{ layer = '{layer}', at = '{at}' }}");
                let [early, late] = ["time = 0.1", &format!("time = '{at}'")]
                    .map(|when| shown(&scene(bodies, &panel(when), &layer, VIEW)))
                    // The edge that it is against is only drawn then.
                    .map(|things| things.into_iter().filter(|t| t.1 != "right-angle").collect::<Vec<_>>());
                assert_same(&early, &late, &format!("{layer} in the frame of {frame}"));
            }
        }
        let [early, late] =
            ["time = 0.1", "time = 'hit'"].map(|w| shown(&scene(bodies, &panel(w), "'contact'", VIEW)));
        assert_same(&early, &late, &format!("the contact in the frame of {frame}"));
    }
}

#[test]
fn a_frame_that_goes_straight_shows_what_a_world_does_that_goes_with_it() {
    const VIEW: [f64; 4] = [-3.0, -4.0, 9.0, 5.0];
    for (name, bodies) in &SCENES[1..3] {
        for layer in
            LAYERS.iter().filter(|l| l.shows != Shows::Configuration && !OF_NO_MOMENT.contains(&l.name))
        {
            for when in ["time = 0.3", "time = 'hit'", "step = 2"] {
                let panel = format!("space = 'body', frame = 'A', {when}");
                let moving = scene(bodies, &panel, &asked(layer.name), VIEW);
                let mut resting = moving.clone();
                let v = resting.shapes[0].1.velocity;
                resting.shapes.iter_mut().for_each(|(_, body)| body.velocity -= v);
                if !(is_fed(&moving) && is_fed(&resting)) {
                    assert_eq!(is_fed(&moving), is_fed(&resting), "{name}, {}", layer.name);
                    continue;
                }
                let [one, two] = [&moving, &resting].map(|scene| {
                    let things = shown(scene);
                    // The symbol of a velocity says from where it is seen.
                    things.into_iter().filter(|t| !t.0.starts_with("v_")).collect::<Vec<_>>()
                });
                assert_same(&one, &two, &format!("{name}, {}, {when}", layer.name));
            }
        }
    }
}
