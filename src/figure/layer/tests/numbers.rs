//! Every number of a label is that of its panel's moment: on random scenes, in panels of all moments, it is
//! what bodies restarted there give, found anew from their geometry or by another algorithm.

use std::collections::BTreeMap;

use tracefig_reference::random::Random;

use crate::collision::naive::{self, Claim};
use crate::collision::{ALGORITHMS, Answer, Outcome, Query, QueryKind, Separation, When as Asked};
use crate::figure::context::Context;
use crate::figure::layer::{LAYERS, Layer, ONE_OF_SEVERAL, Shows, is_chart};
use crate::figure::{plan, random_scenes};
use crate::geometry::{Body, DVec2, Side};
use crate::scene::{LayerSpec, Panel, Scene, Source, Space, Spanned, Value, When, read};
use crate::trace::Event;

use super::{labels_of, last_number, moments};

/// Scenes of a usual run.
const SCENES: u64 = 200;

/// A label's number has three digits: it is off by half of the last one, and by the tolerance of a hit. Where
/// its bounds hold the middle between two such numbers it has two.
fn is_said(number: f64, exact: f64) -> bool {
    let third = exact.abs() * libm::pow(10.0, 2.0 - libm::floor(libm::log10(exact.abs())));
    let between = (third - libm::floor(third) - 0.5).abs() < 1e-6;
    let part = if between { 0.051 } else { 0.0051 };
    (number - exact).abs() <= part * exact.abs() + 1e-9
}

/// Random scenes, and one for each algorithm.
fn scenes() -> impl Iterator<Item = Scene> {
    let each = moments::SCENES.iter().map(|(_, bodies)| format!("{bodies}\npanels = [{{}}]"));
    let texts = (0..SCENES).map(random_scenes::scene_text).chain(each);
    let read = |text: String| read(&Source::new("random", &text)).unwrap();
    (0..).zip(texts).map(move |(seed, text)| fed(at_all_moments(seed, read(text))))
}

/// A scene with a panel of every moment, each of every layer that can stand there.
fn at_all_moments(seed: u64, mut scene: Scene) -> Scene {
    let mut r = Random::new(seed);
    let discrete = seed < SCENES && scene.query.kind.question().when == Asked::AtAMoment;
    for (_, body) in &mut scene.shapes {
        if discrete {
            body.velocity = DVec2::new(r.quarter(-8, 8), r.quarter(-4, 4));
        }
    }
    let query = Query { kind: scene.query.kind, ..scene.query_at(0.0) };
    let fitting: Vec<_> = ALGORITHMS.iter().filter(|a| a.takes(&query)).collect();
    if seed < SCENES {
        scene.query.algorithm = r.one_of(&fitting);
    }
    let whens = [When::Start, When::End, When::Time(0.3), When::Hit, When::Step(2), When::Step(3)];
    let spaces = [Space::World, Space::Configuration, Space::Body(0)];
    let panel = |(i, when): (usize, &When)| {
        let space = if scene.query.of.len() > 1 { spaces[i % 3].clone() } else { Space::World };
        Panel {
            when: Some(spanned(*when, i)),
            layers: Some(every_layer(&space, i)),
            space,
            ..scene.panels[0].clone()
        }
    };
    let exists = |when: &&When| {
        let panel = Panel { when: Some(spanned(**when, 0)), layers: Some(vec![]), ..scene.panels[0].clone() };
        plan(&Scene { panels: vec![panel], ..scene.clone() }).is_ok()
    };
    let charts = LAYERS.iter().filter(|layer| is_chart(layer)).zip(whens.len()..);
    let alone = charts.map(|(layer, i)| Panel {
        layers: Some(vec![LayerSpec {
            name: spanned(layer.name.to_owned(), 100 * (i + 1)),
            options: vec![],
        }]),
        ..panel((0, &When::Start))
    });
    let alone: Vec<Panel> = alone.collect();
    scene.panels = whens.iter().filter(exists).enumerate().map(panel).chain(alone).collect();
    scene
}

/// The scene without the layers that it can't feed; a plan tells some of them at a time.
fn fed(mut scene: Scene) -> Scene {
    while let Err(problems) = plan(&scene).map(|_| ()) {
        for layers in scene.panels.iter_mut().filter_map(|panel| panel.layers.as_mut()) {
            layers.retain(|l| problems.iter().all(|p| p.span != l.name.span));
        }
    }
    scene
}

/// A value at a place of its own.
fn spanned<T>(value: T, place: usize) -> Spanned<T> {
    Spanned { value, span: place..place + 1 }
}

/// Every layer of a space, with all that it says in numbers.
fn every_layer(space: &Space, panel: usize) -> Vec<LayerSpec> {
    let configuration = *space == Space::Configuration;
    let fits = |shows: Shows| shows == Shows::Anywhere || (shows == Shows::Configuration) == configuration;
    let spec = |(i, name): (usize, &'static str)| {
        let place = 100 * (panel + 1) + i;
        let option = |key: &str, value| (spanned(key.to_owned(), place), spanned(value, place));
        let options = match name {
            "velocity" => vec![option("accent", Value::Text(When::HIT.to_owned()))],
            "arc" => vec![option("sector", Value::Bool(true)), option("nearer", Value::Number(0.0))],
            "frame" => vec![option("angle", Value::Bool(true))],
            _ => vec![],
        };
        LayerSpec { name: spanned(name.to_owned(), place), options }
    };
    let beside = |layer: &&Layer| fits(layer.shows) && !is_chart(layer);
    LAYERS.iter().filter(beside).map(|l| l.name).enumerate().map(spec).collect()
}

/// The pair's separation at a time, by the last algorithm that answers: figures use the first.
fn separation(scene: &Scene, time: f64) -> Separation {
    let query = Query { kind: QueryKind::Separation, ..scene.query_at(time) };
    let algorithm = ALGORITHMS.iter().rfind(|a| a.takes(&query)).unwrap();
    let Answer::Separation(found) = algorithm.ask(&query) else { panic!("a separation") };
    found
}

/// The smallest and largest coordinates of a body at a time.
fn extent(body: &Body, time: f64) -> (DVec2, DVec2) {
    let pose = body.pose_at(time);
    let points: Vec<DVec2> = body.shape.vertices.iter().map(|&v| pose.point(v)).collect();
    let all = |pick: fn(DVec2, DVec2) -> DVec2| points.iter().copied().reduce(pick).unwrap();
    (all(DVec2::min) - body.shape.radius, all(DVec2::max) + body.shape.radius)
}

/// What the number of a label's line must be, by its layer and key; `None` for labels without a number.
fn expected(context: &Context, layer: &str, key: &str, line: &str) -> Option<f64> {
    let (scene, time) = (context.scene, context.time);
    let [a, b] = [Side::A, Side::B].map(|side| context.body(side));
    let first_box = || context.sides().into_iter().find_map(|s| context.body(s)?.shape.half_extents).unwrap();
    let half = |axis: fn(DVec2) -> f64| match scene.query.kind {
        QueryKind::Bounds => {
            let (min, max) = extent(a.unwrap(), time);
            axis(0.5 * (max - min))
        }
        _ => axis(first_box()),
    };
    let round = |s: Side| context.body(s).filter(|b| b.shape.radius > 0.0).map(|b| b.shape.radius);
    Some(match (layer, key) {
        ("separation" | "closest", "d") => separation(scene, time).separation.abs(),
        ("separation", "distance") if line.starts_with("depth") => -separation(scene, time).separation,
        ("separation", "p" | "distance") | ("advancement", "d") | ("separating-cone", "gap") => {
            separation(scene, time).separation
        }
        ("ghosts", "A'" | "B'") if line.contains("$t =") => until_hit(scene, 0.0),
        ("approach", "A'" | "B'") if line.contains("$t =") => context.closest().unwrap().time,
        ("approach", "d") if line.starts_with("$t") => context.closest().unwrap().time,
        ("approach", "d") => least(scene, context.closest().unwrap().time),
        ("half-extents", "h_x") => half(|h| h.x),
        ("half-extents", "h_y") => half(|h| h.y),
        ("bounds", "touching.left") => extent(a.unwrap(), time).0.x,
        ("bounds", "touching.right") => extent(a.unwrap(), time).1.x,
        ("bounds", "min" | "touching.bottom") => extent(a.unwrap(), time).0.y,
        ("bounds", "max" | "touching.top") => extent(a.unwrap(), time).1.y,
        ("radii", "r") => context.sides().into_iter().find_map(round).unwrap(),
        ("simplex", "r") => context.sides().into_iter().filter_map(round).sum(),
        ("radii", "r1") => a.unwrap().shape.radius,
        ("radii", "r2") => b.unwrap().shape.radius,
        ("axis-gaps", key) => return of_the_axes(key, [a, b], time),
        ("velocity", "t") if *context.space == Space::Configuration => {
            until_hit(scene, context.difference_time())
        }
        ("velocity", "t") => until_hit(scene, time),
        ("ray", "t") => until_hit(scene, 0.0),
        ("projection", "gap") => largest_gap(context),
        ("graph", "s_1") => separation(scene, 0.0).separation,
        ("fastest-approach", "touch") if !line.contains('=') => return None,
        ("fastest-approach", key) => return of_the_first_step(scene, key, [a, b]),
        ("naive", _) if line.contains('=') => return claimed(scene, [a, b], time),
        // EPA knows the cores only.
        ("polytope", "d") => core_depth(context),
        // GJK too.
        ("bracket", "met") => {
            separation(scene, time).separation + a.unwrap().shape.radius + b.unwrap().shape.radius
        }
        ("clipping", "d_1" | "d_2") => depth_of(context, usize::from(key == "d_2")),
        ("arc", key) => return of_the_arc(key, a.unwrap()),
        ("frame", "angle") => turned(a.unwrap(), time),
        _ => return None,
    })
}

/// What the first method that takes the question claims, where that is a number.
fn claimed(scene: &Scene, [a, b]: [Option<&Body>; 2], time: f64) -> Option<f64> {
    match (naive::method("", scene.query.kind)?.claims)([a?, b?], time)? {
        Claim::Separation(separation, _) => Some(separation),
        Claim::Hit(time) => Some(time),
        Claim::Miss | Claim::Contact(_) | Claim::Nothing => None,
    }
}

/// What the number of a label of an arc must be, from the body that turns.
fn of_the_arc(key: &str, body: &Body) -> Option<f64> {
    let turned = body.spin.radians().abs();
    Some(match key {
        "theta" => turned,
        "r" => reach(body),
        "L" => turned * reach(body),
        "r_q" => first_vertex(body),
        "L_q" => turned * first_vertex(body),
        _ => return None,
    })
}

/// What the number of a label of the gaps along the axes must be, from the extents of both bodies.
fn of_the_axes(key: &str, [a, b]: [Option<&Body>; 2], time: f64) -> Option<f64> {
    let (a, b) = (a?, b?);
    let halves = |body: &Body| 0.5 * (extent(body, time).1 - extent(body, time).0);
    let centers = (b.pose_at(time).position - a.pose_at(time).position).abs();
    let gap = centers - halves(a) - halves(b);
    Some(match key {
        "h.A.x" => halves(a).x,
        "h.A.y" => halves(a).y,
        "h.B.x" => halves(b).x,
        "h.B.y" => halves(b).y,
        "D.x" => gap.x,
        "D.y" => gap.y,
        "centers.x" => centers.x,
        "centers.y" => centers.y,
        _ => return None,
    })
}

/// What the number of a label of the fastest approach must be, from the bodies' velocities and radii.
fn of_the_first_step(scene: &Scene, key: &str, [a, b]: [Option<&Body>; 2]) -> Option<f64> {
    let (a, b, found) = (a?, b?, separation(scene, 0.0));
    let closing = (a.velocity - b.velocity).dot(*found.normal);
    Some(match key {
        "unit" => 1.0,
        "d" => found.separation,
        "hit" | "touch" => until_hit(scene, 0.0),
        "v.n" => closing,
        "sum" => closing + arm(a) + arm(b),
        "r.A" => arm(a),
        "r.B" => arm(b),
        "bound" => found.separation / (closing + arm(a) + arm(b)),
        _ => return None,
    })
}

/// How deep the cores of the pair are in one another, by the vertices of B ⊖ A that EPA's polytope has then.
fn core_depth(context: &Context) -> f64 {
    let last = |vertices: &[DVec2]| {
        let edges = vertices.iter().zip(vertices.iter().cycle().skip(1));
        edges.map(|(p, q)| p.perp_dot(*q).abs() / (*q - *p).length()).fold(f64::INFINITY, f64::min)
    };
    let run = context.run();
    let polytopes = run.events().filter_map(|event| match event {
        Event::PolytopeExpanded { vertices, .. } => Some(vertices),
        _ => None,
    });
    polytopes.last().map_or(f64::NAN, |vertices| last(vertices))
}

/// How far the two points of a contact are from each other.
fn depth_of(context: &Context, index: usize) -> f64 {
    let run = context.run();
    let mut depths = run.events().filter_map(|event| match event {
        Event::ContactFound { points: [a, b], touches: true, .. } => Some((*b - *a).length()),
        _ => None,
    });
    depths.nth(index).unwrap_or(f64::NAN)
}

/// The time from a moment to the hit, by the last algorithm that answers.
fn until_hit(scene: &Scene, now: f64) -> f64 {
    let query = scene.query_at(0.0);
    let algorithm = ALGORITHMS.iter().rfind(|a| a.takes(&query)).unwrap();
    let Answer::Impact(impact) = algorithm.ask(&query) else { panic!("an impact") };
    let Outcome::Hit { time, .. } = impact.outcome else { return 0.0 };
    time.lo - now
}

/// The separation at the time of the closest approach, which is the least of all that are looked at.
fn least(scene: &Scene, time: f64) -> f64 {
    let found = separation(scene, time).separation;
    let others = (0..=20).map(|i| separation(scene, f64::from(i) / 20.0).separation);
    let least = others.fold(f64::INFINITY, f64::min);
    assert!(found <= least + 1e-9, "{found} at {time}, but {least}");
    found
}

/// The distance of a body's farthest point from its origin.
fn reach(body: &Body) -> f64 {
    body.shape.vertices.iter().map(|v| v.length()).fold(0.0, f64::max) + body.shape.radius
}

/// How fast turning moves the farthest vertex of a body, r |ω|.
fn arm(body: &Body) -> f64 {
    (reach(body) - body.shape.radius) * body.spin.radians().abs()
}

/// The angle from the world's x axis to a body's own at a time, degrees.
fn turned(body: &Body, time: f64) -> f64 {
    let axis = body.pose_at(time).vector(DVec2::X);
    libm::atan2(axis.y, axis.x).to_degrees()
}

/// The distance of a body's first vertex from its origin.
fn first_vertex(body: &Body) -> f64 {
    body.shape.vertices[0].length() + body.shape.radius
}

/// The largest way from where A ends to where B begins, along the axes that were tested, by the vertices.
fn largest_gap(context: &Context) -> f64 {
    let reach = |side: Side, n: DVec2| {
        let body = context.body(side).unwrap();
        let pose = body.pose_at(context.time);
        let far = body.shape.vertices.iter().map(|&v| pose.point(v).dot(n)).fold(f64::NEG_INFINITY, f64::max);
        far + body.shape.radius
    };
    let run = context.run();
    let axes =
        run.events().filter_map(|e| if let Event::AxisTested { axis, .. } = e { Some(*axis) } else { None });
    axes.map(|n| -reach(Side::B, -n) - reach(Side::A, n)).fold(f64::NEG_INFINITY, f64::max).abs()
}

#[test]
fn every_number_of_a_label_is_that_of_its_panels_moment() {
    let mut said: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for (seed, scene) in scenes().enumerate() {
        let plan = plan(&scene).unwrap();
        for (index, panel) in plan.panels.iter().enumerate() {
            let context = panel.context(&scene, &plan.runs);
            let all = labels_of(panel.sketch(&context, plan.theme), panel);
            // What is said in brackets of a number has none, nor that it ties.
            let says_more = |text: &str| text.starts_with('(') || text == ONE_OF_SEVERAL;
            for (layer, key, text) in all.into_iter().filter(|(.., text)| !says_more(text)) {
                let number = last_number(&text);
                match expected(&context, layer, key, &text) {
                    Some(exact) => {
                        let moment = panel.moment;
                        assert!(
                            is_said(number, exact),
                            "scene {seed}, panel {index}, {moment:?}: {layer} says {text}, not {exact}"
                        );
                        *said.entry((layer, key)).or_default() += 1;
                    }
                    None => assert!(number.is_nan() || is_a_name(&text), "{layer}, {key}: who says {text}?"),
                }
            }
        }
    }
    assert!(said.len() >= 20 && said.values().all(|&n| n >= 2), "{said:?}");
}

/// Whether a label's numbers are only those of its symbol, as in `$x_1$`.
fn is_a_name(text: &str) -> bool {
    !text.contains('=')
}

#[test]
fn clamped_vectors_are_written_in_the_frame_of_their_panel() {
    let text = "shapes.A = { kind = 'box', half_extents = [3, 2], angle_deg = 90 }
        shapes.B = { kind = 'circle', radius = 1, position = [-5, 6] }
        query = { kind = 'separation', of = ['A', 'B'], algorithm = 'clamp' }
        panels = [{ layers = [{ layer = 'clamp', show = ['V', 'D'], values = true }] },
            { space = 'body', frame = 'A', layers = [{ layer = 'clamp', values = true }] }]";
    let scene = crate::scene::open_text("s.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let written = plan.panels.iter().map(|panel| {
        let labels = labels_of(panel.sketch(&panel.context(&scene, &plan.runs), plan.theme), panel);
        ["V", "D"].map(|key| labels.iter().find(|label| label.1 == key).unwrap().2.clone())
    });
    let expected = [["$V = (-5, 6)$", "$D = (-3, 3)$"], ["$V = (6, 5)$", "$D = (3, 3)$"]];
    assert!(written.eq(expected.map(|pair| pair.map(str::to_owned))));
}

#[test]
fn a_component_that_clamping_leaves_as_it_is_leaves_nothing_of_d() {
    let text = "shapes.A = { kind = 'circle', radius = 0.5, position = [2.1, 1.4] }
        shapes.B = { kind = 'box', half_extents = [1.2, 0.7], angle_deg = 30, position = [0.2, 0.1] }
        query = { kind = 'separation', of = ['A', 'B'], algorithm = 'clamp' }
        panels = [{ space = 'body', frame = 'B', layers = [{ layer = 'clamp', values = true }] }]";
    let scene = crate::scene::open_text("s.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let panel = &plan.panels[0];
    let labels = labels_of(panel.sketch(&panel.context(&scene, &plan.runs), plan.theme), panel);
    let written = labels.iter().find(|label| label.1 == "D").unwrap().2.clone();
    assert_eq!(written, "$D = (1.10, 0)$");
}
