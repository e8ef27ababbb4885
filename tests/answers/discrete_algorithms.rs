//! Every discrete algorithm on the same random pairs: they agree with each other and with a brute-force hull,
//! listening changes no bit, and the answer moves with the pair.

#![expect(clippy::panic, reason = "a test fails by panicking")]

use crate::asking::{of_kind, query, takers};
use crate::random_pairs::pairs;
use tracefig::collision::{ALGORITHMS, Algorithm, Answer, QUERIES, QueryKind, Separation, When};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Angle, Body, DVec2, Side};
use tracefig::trace::{Event, NoTrace, Trace};

/// Plain doubles: what the brute-force hull and the comparison of two answers may be off by, as a multiple of
/// the largest coordinate. About 50 ε; a wrong feature or a dropped edge is off by 1e-3 and more on these
/// pairs.
const ROUNDING: f64 = 1e-14;

fn separation(algorithm: &Algorithm, a: &Body, b: &Body) -> Separation {
    match (algorithm.quiet)(&query(QueryKind::Separation, a, b), &mut NoTrace) {
        Answer::Separation(s) => s,
        other => panic!("{other:?}"),
    }
}

fn vertices(body: &Body) -> Vec<DVec2> {
    body.shape.vertices.iter().map(|&v| body.pose_at(0.0).point(v)).collect()
}

/// Signed distance of the origin from the hull of all differences b − a (Andrew's monotone chain), less the
/// radii.
fn brute_force(a: &Body, b: &Body) -> f64 {
    let mut points: Vec<DVec2> =
        vertices(a).iter().flat_map(|&p| vertices(b).into_iter().map(move |q| q - p)).collect();
    points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for p in points {
            while let [.., u, v] = chain[..]
                && (v - u).perp_dot(p - v) <= 1e-12
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain
    };
    let mut hull = half(&mut points.iter().copied());
    hull.pop();
    hull.extend(half(&mut points.iter().rev().copied()));
    hull.pop();
    let radius = a.shape.radius + b.shape.radius;
    if hull.len() < 2 {
        return points[0].length() - radius;
    }
    let (mut inside, mut outside) = (f64::NEG_INFINITY, f64::INFINITY);
    for (k, &p) in hull.iter().enumerate() {
        let d = hull[(k + 1) % hull.len()] - p;
        inside = inside.max(d.perp_dot(p) / d.length());
        let t = (-p.dot(d) / d.length_squared()).clamp(0.0, 1.0);
        outside = outside.min((p + d * t).length());
    }
    (if inside >= 0.0 { outside } else { inside }) - radius
}

/// Every separation algorithm that takes the pair, with its name.
fn answers<'s>(a: &'s Body, b: &'s Body) -> Vec<(&'static str, Separation)> {
    let takers = takers(&query(QueryKind::Separation, a, b));
    takers.into_iter().map(|x| (x.name, separation(x, a, b))).collect()
}

/// The largest coordinate that rounding is measured against.
fn scale(a: &Body, b: &Body) -> f64 {
    let reach = |body: &Body| body.position.length() + body.shape.hull.reach + body.shape.radius;
    reach(a) + reach(b)
}

/// The depth (or distance) of the cores along a direction: never above the separation for a unit vector.
fn gap_along(a: &Body, b: &Body, n: DVec2) -> f64 {
    let of =
        |body: &Body, n: DVec2| vertices(body).iter().map(|p| p.dot(n)).fold(f64::NEG_INFINITY, f64::max);
    -of(b, -n) - of(a, n) - a.shape.radius - b.shape.radius
}

#[test]
fn every_algorithm_finds_what_the_hull_of_all_differences_says() {
    for (seed, a, b) in pairs(1500) {
        let (truth, slack) = (brute_force(&a, &b), ROUNDING * scale(&a, &b));
        let answers = answers(&a, &b);
        assert!(answers.len() >= 4, "{seed}");
        for (name, s) in answers {
            let context = || format!("seed {seed}, {name}: {s:?}, truth {truth}, {a:?} {b:?}");
            assert!((s.separation - truth).abs() <= slack, "{}", context());
            assert!(s.bounds.lo <= s.separation && s.separation <= s.bounds.hi, "{}", context());
            assert!(s.bounds.lo - slack <= truth && truth <= s.bounds.hi + slack, "{}", context());
        }
    }
}

#[test]
fn the_normal_is_a_unit_vector_that_carries_the_separation() {
    for (seed, a, b) in pairs(1500) {
        let slack = ROUNDING * scale(&a, &b);
        for (name, s) in answers(&a, &b) {
            let context = || format!("seed {seed}, {name}: {s:?}, {a:?} {b:?}");
            assert!((s.normal.length() - 1.0).abs() <= ROUNDING, "{}", context());
            let carried = s.points[1] - s.points[0] - s.normal * s.separation;
            assert!(carried.length() <= 4.0 * slack, "{}", context());
            assert!((gap_along(&a, &b, *s.normal) - s.separation).abs() <= 4.0 * slack, "{}", context());
        }
    }
}

#[test]
fn listening_changes_no_bit() {
    for (seed, a, b) in pairs(800) {
        let of_a_moment = QUERIES.iter().filter(|q| q.when == When::AtAMoment).map(|q| q.kind);
        for kind in of_a_moment.chain([QueryKind::MotionBound]) {
            let query = query(kind, &a, &b);
            for algorithm in takers(&query) {
                let mut trace = Trace::default();
                let traced = (algorithm.traced)(&query, &mut trace);
                let quiet = (algorithm.quiet)(&query, &mut NoTrace);
                // The written form tells −0 from 0 and every bit of the rest.
                assert_eq!(format!("{traced:?}"), format!("{quiet:?}"), "seed {seed}, {}", algorithm.name);
                assert!(matches!(trace.events.first(), Some(Event::Started { .. })), "{}", algorithm.name);
            }
        }
    }
}

#[test]
fn overlap_says_what_separation_says() {
    for (seed, a, b) in pairs(1500) {
        for algorithm in takers(&query(QueryKind::Overlap, &a, &b)) {
            let Answer::Overlap(o) = (algorithm.quiet)(&query(QueryKind::Overlap, &a, &b), &mut NoTrace)
            else {
                panic!("{}", algorithm.name)
            };
            let (s, slack) = (separation(algorithm, &a, &b), ROUNDING * scale(&a, &b));
            let context = || format!("seed {seed}, {}: {o:?} {s:?}", algorithm.name);
            assert!(
                o.separation_bounds.lo <= s.bounds.hi && s.bounds.lo <= o.separation_bounds.hi,
                "{}",
                context()
            );
            assert!(
                o.overlap.is_none_or(|o| s.separation.abs() <= slack || o == (s.separation < 0.0)),
                "{}",
                context()
            );
            assert!(o.overlap.is_some() || s.separation.abs() <= slack, "{}", context());
        }
    }
}

/// An edge of B ⊖ A as an algorithm tells it: whether it is B's, its index, the other body's vertex, start
/// and end.
type Edge = (bool, usize, usize, [f64; 2], [f64; 2]);

fn edge(event: &Event) -> Option<Edge> {
    match *event {
        Event::DifferenceEdgeFound { source, edge, vertex, from, to, .. } => {
            Some((source == Side::B, edge, vertex, from.to_array(), to.to_array()))
        }
        _ => None,
    }
}

/// The edges of B ⊖ A that an algorithm tells, in the order in which it does.
fn edges(name: &str, a: &Body, b: &Body) -> Vec<Edge> {
    let Some(algorithm) = ALGORITHMS.iter().find(|x| x.name == name) else { panic!("no {name}") };
    let mut trace = Trace::default();
    (algorithm.traced)(&query(QueryKind::Separation, a, b), &mut trace);
    trace.events.iter().filter_map(edge).collect()
}

#[test]
fn both_builders_of_the_difference_find_the_same_edges() {
    for (seed, a, b) in pairs(1500) {
        let (mut looped, mut merged) = (edges("minkowski", &a, &b), edges("merge", &a, &b));
        let order = |p: &Edge, q: &Edge| p.partial_cmp(q).unwrap();
        looped.sort_by(order);
        merged.sort_by(order);
        assert_eq!(looped, merged, "seed {seed}: {a:?} {b:?}");
    }
}

#[test]
fn the_merge_tells_a_closed_convex_chain() {
    for (seed, a, b) in pairs(1500) {
        let edges = edges("merge", &a, &b);
        for (k, &(.., from, to)) in edges.iter().enumerate() {
            let (.., next, end) = edges[(k + 1) % edges.len()];
            assert_eq!(to, next, "seed {seed}: {a:?} {b:?}");
            let [from, to, end] = [from, to, end].map(DVec2::from);
            let turn = (to - from).perp_dot(end - to);
            assert!(turn >= -ROUNDING * scale(&a, &b), "seed {seed}: {turn:e}");
        }
    }
}

#[test]
fn every_algorithm_but_gjk_tells_the_whole_difference_and_each_the_candidate_that_won() {
    for (seed, a, b) in pairs(600) {
        let merged = edges("merge", &a, &b).len();
        let points = a.shape.core.len() == 1 && b.shape.core.len() == 1;
        let is_round = points || a.shape.radius + b.shape.radius > 0.0;
        for algorithm in takers(&query(QueryKind::Separation, &a, &b)) {
            let mut trace = Trace::default();
            let Answer::Separation(s) = (algorithm.traced)(&query(QueryKind::Separation, &a, &b), &mut trace)
            else {
                panic!("{}", algorithm.name)
            };
            // GJK walks over B ⊖ A without building it.
            let builds = algorithm.name != "gjk";
            let told = trace.events.iter().filter_map(edge).count();
            assert_eq!(told, if builds { merged } else { 0 }, "seed {seed}, {}", algorithm.name);
            let round = trace.events.iter().any(|e| matches!(e, Event::DifferenceRounded { .. }));
            assert_eq!(round, builds && is_round, "seed {seed}, {}", algorithm.name);
            let best = trace.events.iter().rev().find_map(|e| match e {
                Event::CandidateImproved { distance, foot, .. } => Some((*distance, *foot)),
                _ => None,
            });
            let (distance, foot) = best.unwrap();
            let slack = ROUNDING * scale(&a, &b);
            assert!((distance - s.separation).abs() <= slack, "seed {seed}, {}", algorithm.name);
            let off = foot.length() - s.separation.abs();
            assert!(off.abs() <= slack, "seed {seed}, {}: {foot} {s:?}", algorithm.name);
        }
    }
}

#[test]
fn gjk_comes_closer_and_the_polytope_grows_until_the_depth_is_found() {
    let gjk = ALGORITHMS.iter().find(|x| x.name == "gjk").unwrap();
    let mut expanded = 0;
    for (seed, a, b) in pairs(1500) {
        let slack = ROUNDING * scale(&a, &b);
        let mut trace = Trace::default();
        (gjk.traced)(&query(QueryKind::Separation, &a, &b), &mut trace);
        let core = separation(gjk, &a, &b).separation + a.shape.radius + b.shape.radius;
        let (mut closest, mut nearest) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut grown = Vec::new();
        for event in &trace.events {
            match event {
                Event::SimplexUpdated { closest: v, .. } => {
                    assert!(v.length() < closest, "seed {seed}: {:?}", trace.events);
                    closest = v.length();
                }
                Event::PolytopeExpanded { nearest: d, .. } => {
                    assert!(*d >= nearest - slack, "seed {seed}: {:?}", trace.events);
                    nearest = *d;
                    grown.push(event);
                }
                _ => {}
            }
        }
        let found = if nearest == f64::NEG_INFINITY { closest } else { -nearest };
        assert!((found - core).abs() <= slack, "seed {seed}: {found} {core} {:?}", trace.events);
        expanded += u32::from(nearest > 0.0);
        crate::polytope::grows_by_what_it_tells(seed, &grown, slack);
    }
    assert!(expanded > 300, "{expanded}");
}

#[test]
fn the_largest_gap_of_all_axes_is_the_depth() {
    let axes = ALGORITHMS.iter().find(|x| x.name == "separating-axes").unwrap();
    for (seed, a, b) in pairs(1500) {
        let mut trace = Trace::default();
        (axes.traced)(&query(QueryKind::Separation, &a, &b), &mut trace);
        let s = separation(axes, &a, &b).separation;
        let gaps = trace.events.iter().filter_map(|e| match e {
            Event::AxisTested { gap, interval_a, interval_b, .. } => {
                assert!(
                    (interval_b.lo - interval_a.hi - gap).abs() <= ROUNDING * scale(&a, &b),
                    "seed {seed}"
                );
                Some(*gap)
            }
            _ => None,
        });
        let largest = gaps.fold(f64::NEG_INFINITY, f64::max);
        assert!((largest - s).abs() <= ROUNDING * scale(&a, &b), "seed {seed}: {largest} {s}");
    }
}

/// The separation that an event amounts to, by the formula of its algorithm.
fn amounts_to(event: &Event, radius: f64) -> Option<f64> {
    match event {
        Event::CirclesCompared { distance_squared, radii, .. } => {
            Some(distance_squared.sqrt() - (radii[0] + radii[1]))
        }
        Event::ExtentsCompared { gap, .. } => {
            let outside = gap.max(DVec2::ZERO).length();
            Some(if outside > 0.0 { outside } else { gap.max_element() })
        }
        Event::Clamped { v, clamped, d, radius, .. } => {
            Some(if v == clamped { -d.length() - radius } else { d.length() - radius })
        }
        Event::CandidateImproved { distance, .. } => Some(distance - radius),
        _ => None,
    }
}

#[test]
fn what_an_algorithm_tells_amounts_to_its_answer() {
    for (seed, a, b) in pairs(1500) {
        let cores = a.shape.radius + b.shape.radius;
        for name in ["circles", "extents", "clamp", "merge", "minkowski"] {
            let query = query(QueryKind::Separation, &a, &b);
            let Some(algorithm) = takers(&query).into_iter().find(|x| x.name == name) else { continue };
            let mut trace = Trace::default();
            (algorithm.traced)(&query, &mut trace);
            let told: Vec<f64> = trace
                .events
                .iter()
                .filter(|e| matches!(e, Event::CandidateImproved { .. }) == name.starts_with('m'))
                .filter_map(|e| amounts_to(e, cores))
                .collect();
            // The candidates of the cores come before the one of the round bodies, which has the radii off
            // already.
            let points = a.shape.core.len() == 1 && b.shape.core.len() == 1;
            let concluded = name.starts_with('m') && (cores > 0.0 || points);
            let found = if points && concluded {
                told[0] + cores
            } else {
                told[told.len() - 1 - usize::from(concluded)]
            };
            let s = separation(algorithm, &a, &b).separation;
            assert!((found - s).abs() <= ROUNDING * scale(&a, &b), "seed {seed}, {name}: {found} {s}");
        }
    }
}

/// Whether two answers may be those of one pair: bounds that meet and, where one direction wins, the same
/// normal.
fn same(s: &Separation, other: &Separation, normal: DVec2, slack: f64) -> bool {
    let meet = s.bounds.lo <= other.bounds.hi + slack && other.bounds.lo <= s.bounds.hi + slack;
    meet && (s.ties != 1 || s.separation.abs() < 1e-6 || (*other.normal - normal).length() < 1e-6)
}

#[test]
fn exchanging_the_bodies_turns_the_normal_around() {
    for (seed, a, b) in pairs(1500) {
        for algorithm in takers(&query(QueryKind::Separation, &a, &b)) {
            let (s, t) = (separation(algorithm, &a, &b), separation(algorithm, &b, &a));
            let context = format!("seed {seed}, {}: {s:?} {t:?}", algorithm.name);
            assert!(same(&s, &t, -*s.normal, ROUNDING * scale(&a, &b)), "{context}");
        }
    }
}

#[test]
fn a_rigid_motion_of_the_pair_turns_the_answer_with_it() {
    for (seed, a, b) in pairs(1500) {
        let angle = if a.shape.kind == "aabb" || b.shape.kind == "aabb" { 0.0 } else { 90.0 };
        let moved = |body: &Body| {
            let p = body.position;
            let turned = if angle == 0.0 { p } else { DVec2::new(-p.y, p.x) };
            let position = turned + DVec2::new(16.0, -8.0);
            Body { position, angle: Angle::Degrees(body.angle.degrees() + angle), ..body.clone() }
        };
        let (c, d) = (moved(&a), moved(&b));
        for algorithm in takers(&query(QueryKind::Separation, &a, &b)) {
            let (s, t) = (separation(algorithm, &a, &b), separation(algorithm, &c, &d));
            let normal = if angle == 0.0 { *s.normal } else { DVec2::new(-s.normal.y, s.normal.x) };
            let context = format!("seed {seed}, {}: {s:?} {t:?}", algorithm.name);
            assert!(same(&s, &t, normal, ROUNDING * scale(&c, &d)), "{context}");
        }
    }
}

#[test]
fn twice_the_pair_has_exactly_twice_the_separation() {
    let twice = |body: &Body| {
        let v = |p: DVec2| FieldValue::Point(p * 2.0);
        let s = &body.shape;
        let points = FieldValue::Points(s.vertices.iter().map(|&p| p * 2.0).collect());
        let radius = FieldValue::Number(s.radius * 2.0);
        let fields = match s.kind {
            "circle" => vec![("radius", radius)],
            "aabb" => vec![("half_extents", v(s.half_extents.unwrap()))],
            "box" => vec![("half_extents", v(s.half_extents.unwrap())), ("radius", radius)],
            "capsule" => vec![("points", points), ("radius", radius)],
            _ => vec![("vertices", points), ("radius", radius)],
        };
        Body { shape: of_kind(s.kind, &fields), position: body.position * 2.0, ..body.clone() }
    };
    for (seed, a, b) in pairs(800) {
        let (c, d) = (twice(&a), twice(&b));
        for algorithm in takers(&query(QueryKind::Separation, &a, &b)) {
            let (s, t) = (separation(algorithm, &a, &b), separation(algorithm, &c, &d));
            assert_eq!(s.separation * 2.0, t.separation, "seed {seed}, {}: {s:?} {t:?}", algorithm.name);
            assert_eq!(s.normal, t.normal, "seed {seed}, {}", algorithm.name);
        }
    }
}
