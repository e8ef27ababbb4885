//! A pair is judged alike whichever body is called A: verdicts are equal, normals reversed, points and
//! features exchanged.
//!
//! Many of the pairs touch exactly, by construction in numbers of a few bits: there the separation is 0 both
//! ways round, and a rounding more or less would be seen.

#![expect(clippy::unwrap_used, clippy::expect_used, reason = "a test fails by panicking")]

use tracefig::collision::{Answer, ContactPoint, MovingPair, Outcome, Pair, QueryKind, Separation, Sweep};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Angle, Body, DVec2, Enclosure, Rotation, Shape};
use tracefig::trace::NoTrace;
use tracefig_reference::generate::Family;
use tracefig_reference::json::Json;
use tracefig_reference::random::Random;

use crate::asking::{of_kind, query, takers};
use crate::random_pairs::pairs;

/// Cosines and sines of few bits: near those of Pythagoras, as an engine has them, and quarter turns.
const MATRICES: [[f32; 2]; 7] =
    [[1.0, 0.0], [0.0, 1.0], [0.8, 0.6], [0.6001, -0.8], [-0.28, 0.9601], [0.999, 0.045], [0.1, -0.995]];

fn matrix(r: &mut Random) -> Rotation<f64> {
    let [cos, sin] = r.one_of(&MATRICES).map(f64::from);
    Rotation { cos, sin }
}

/// A point on quarters.
fn point(r: &mut Random) -> DVec2 {
    DVec2::new(r.quarter(-8, 8), r.quarter(-8, 8))
}

/// A convex polygon or a segment on quarters, of some radius, multiplied by a matrix.
fn shape(r: &mut Random, radius: f64) -> Shape {
    let matrix = matrix(r);
    loop {
        let count = if r.once_in(6) { 2 } else { 3 + r.below(5) };
        let points: Vec<DVec2> = (0..count).map(|_| point(r)).collect();
        let radius = ("radius", FieldValue::Number(radius));
        let drawn = if count == 2 {
            Shape::of_kind("capsule", &[("points", FieldValue::Points(points)), radius])
        } else {
            let hull = ("hull", FieldValue::Switch(true));
            Shape::of_kind("polygon", &[("vertices", FieldValue::Points(points)), radius, hull])
        };
        if let Ok(shape) = drawn
            && shape.hull.vertices.len() > 1
        {
            return shape.multiplied(matrix).unwrap();
        }
    }
}

/// The vertex of a core that is highest along a direction, multiplied.
fn highest(shape: &Shape, n: DVec2) -> DVec2 {
    let height = |v: &&DVec2| n.dot(**v);
    *shape.hull.vertices.iter().max_by(|p, q| height(p).total_cmp(&height(q))).unwrap()
}

/// A direction along which a core is highest in an edge, or in a vertex, and a place there; all exact.
fn face(r: &mut Random, shape: &Shape) -> (DVec2, DVec2) {
    let vertices = &shape.hull.vertices;
    let count = vertices.len();
    let k = r.below(count);
    let at = |k: usize| vertices[k % count];
    let out = |k: usize| {
        let e = at(k + 1) - at(k);
        DVec2::new(e.y, -e.x)
    };
    // A segment ends along itself.
    let beyond = || if count == 2 { at(k) - at(k + 1) } else { out(k) + out(k + count - 1) };
    if r.once_in(2) { (out(k), 0.5 * (at(k) + at(k + 1))) } else { (beyond(), at(k)) }
}

fn body(shape: Shape, position: DVec2) -> Body {
    Body { shape, position, angle: Angle::ZERO, velocity: DVec2::ZERO, spin: Angle::ZERO }
}

/// Two bodies that touch exactly: an edge or a vertex of A and what of B is lowest there; of round bodies,
/// along a normal of 3-4-5.
fn touching(r: &mut Random) -> [Body; 2] {
    let (r_a, r_b) = if r.once_in(3) { (r.quarter(0, 4), r.quarter(1, 4)) } else { (0.0, 0.0) };
    let (a, b) = (shape(r, r_a), shape(r, r_b));
    let (n, place) = if r_a + r_b > 0.0 {
        let n = DVec2::new(0.6, 0.8) * r.one_of(&[1.0, -1.0]);
        (n, highest(&a, n))
    } else {
        face(r, &a)
    };
    let apart =
        if r_a + r_b > 0.0 { DVec2::new(3.0, 4.0) * n.x.signum() * ((r_a + r_b) / 5.0) } else { DVec2::ZERO };
    let position = point(r) * 16.0;
    let lowest = highest(&b, -n);
    [body(a, position), body(b, position + place + apart - lowest)]
}

/// Whether a separation by 3-4-5 is exact: a fifth of the radii is.
fn is_exact(pair: &[Body; 2]) -> bool {
    let radii = pair[0].shape.radius + pair[1].shape.radius;
    (radii * 4.0) % 5.0 == 0.0
}

fn touches(found: &Separation) -> bool {
    found.bounds == Enclosure { lo: 0.0, hi: 0.0 }
}

/// What a verdict says, of one who does not look at numbers.
fn word(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Unresolved { reason, .. } => format!("unresolved {}", reason.word()),
        other => other.word().to_owned(),
    }
}

fn assert_mirrored(name: &str, ab: &Separation, ba: &Separation) {
    assert_eq!(ab.bounds.hi <= 0.0, ba.bounds.hi <= 0.0, "{name}: {ab:?} {ba:?}");
    assert_eq!(ab.bounds.lo > 0.0, ba.bounds.lo > 0.0, "{name}: {ab:?} {ba:?}");
    assert!(ab.bounds.lo <= ba.bounds.hi && ba.bounds.lo <= ab.bounds.hi, "{name}: {ab:?} {ba:?}");
    if ab.ties == 1 && ba.ties == 1 {
        assert!((*ab.normal + *ba.normal).length() <= 1e-9, "{name}: {ab:?} {ba:?}");
        let off = [0, 1].map(|k| (ab.points[k] - ba.points[1 - k]).length());
        assert!(off.iter().all(|&off| off <= 1e-9), "{name}: {ab:?} {ba:?}");
        let features = [ba.features[1], ba.features[0]];
        assert_eq!(ab.features, features, "{name}: {ab:?} {ba:?}");
    }
}

#[test]
fn bodies_that_touch_exactly_are_found_to_both_ways_round() {
    let mut rounds = 0;
    for seed in 0..1_500 {
        let mut r = Random::new(seed);
        let pair = touching(&mut r);
        let [a, b] = &pair;
        let (ab, ba) = (Pair::at(a, b, 0.0).separation(), Pair::at(b, a, 0.0).separation());
        if is_exact(&pair) {
            assert!(touches(&ab) && touches(&ba), "{seed}: {ab:?} {ba:?} {pair:?}");
            rounds += 1;
        }
        assert_mirrored(&format!("{seed}"), &ab, &ba);
        for (x, y) in [(a, b), (b, a)] {
            let asked = query(QueryKind::Overlap, x, y);
            for algorithm in takers(&asked) {
                let Answer::Overlap(found) = (algorithm.quiet)(&asked, &mut NoTrace) else {
                    panic!("{seed}")
                };
                let wrong = is_exact(&pair) && found.overlap != Some(true);
                assert!(!wrong, "{seed}: {} {found:?} {pair:?}", algorithm.name);
            }
        }
    }
    assert!(rounds > 1_000, "{rounds}");
}

/// One body upon another, both turned by a cosine and a sine of 53 bits: what is upon it touches in an edge
/// or in a vertex, and exactly so, as its place is the cosine and the sine themselves.
fn stacked(r: &mut Random) -> [Body; 2] {
    let angle = r.between(-3.0, 3.0);
    let drift = 1.0 + r.between(-4e-4, 4e-4);
    let matrix = Rotation { cos: libm::cos(angle) * drift, sin: libm::sin(angle) * drift };
    let (below, above) = r.one_of(&[(0.25, 0.25), (0.5, 0.5), (0.25, 0.75), (1.25, 0.75), (1.0, 1.0)]);
    let half = |x: f64, y: f64| of_kind("box", &[("half_extents", FieldValue::Point(DVec2::new(x, y)))]);
    let (wide, narrow) = (r.quarter(2, 8), r.quarter(1, 8));
    let upper = if r.once_in(2) {
        half(narrow, above)
    } else {
        Shape::polygon(vec![DVec2::new(0.25, -above), DVec2::new(narrow, 1.75), DVec2::new(-1.0, 2.0)])
            .unwrap()
    };
    let [a, b] = [half(wide, below), upper].map(|shape| shape.multiplied(matrix).unwrap());
    let up = DVec2::new(-matrix.sin, matrix.cos) * (below + above);
    [body(a, DVec2::ZERO), body(b, up)]
}

#[test]
fn stacks_turned_by_any_cosine_and_sine_touch_both_ways_round() {
    for seed in 0..400 {
        let [a, b] = stacked(&mut Random::new(seed));
        let (ab, ba) = (Pair::at(&a, &b, 0.0).separation(), Pair::at(&b, &a, 0.0).separation());
        assert!(touches(&ab) && touches(&ba), "{seed}: {ab:?} {ba:?} {a:?} {b:?}");
        assert_mirrored(&format!("{seed}"), &ab, &ba);
        let contact = Sweep::new(&a, &b).first_contact();
        assert_eq!(word(&contact), "overlapping", "{seed}");
    }
}

#[test]
fn motions_from_touching_are_judged_alike_both_ways_round() {
    for seed in 0..400 {
        let mut r = Random::new(seed);
        let [mut a, mut b] = touching(&mut r);
        (a.velocity, b.velocity) = (point(&mut r), point(&mut r));
        // Half of the pairs touch at the start, half halfway.
        if r.once_in(2) {
            a.position -= 0.5 * a.velocity;
            b.position -= 0.5 * b.velocity;
        }
        let sweep = [Sweep::new(&a, &b), Sweep::new(&b, &a)].map(|sweep| sweep.first_contact());
        assert_eq!(word(&sweep[0]), word(&sweep[1]), "{seed}: {sweep:?} {a:?} {b:?}");
        let swept =
            [(&a, &b), (&b, &a)].map(|(a, b)| MovingPair::new(a, b).first_contact(1e-12, 1000).outcome);
        assert_eq!(word(&swept[0]), word(&swept[1]), "{seed}: {swept:?} {a:?} {b:?}");
        assert!(!matches!(sweep[0], Outcome::Unresolved { .. }), "{seed}: {sweep:?} {a:?} {b:?}");
    }
}

/// The scene with its bodies called the other way round, or with another kind of question.
fn changed(scene: &Json, change: impl FnOnce(&mut Json)) -> String {
    let mut scene = scene.clone();
    let mut query = scene.get("query").expect("a query").clone();
    change(&mut query);
    scene.set("query", query);
    scene.to_string()
}

fn answer(text: &str) -> Json {
    Json::parse(&tracefig::solve_jsonl_line(text, 1).line).unwrap().get("result").expect("a result").clone()
}

#[test]
fn every_kind_of_query_is_answered_alike_both_ways_round() {
    // Of 27,000 such pairs, only 1,047 of the first family needs both frames to be judged alike.
    for (family, count) in [(Family::Separation, 600), (Family::Impact, 210), (Family::Logged, 300)] {
        for i in (0..count).chain([1_047]) {
            let scene = family.case(9, i);
            let swapped = changed(&scene, |query| {
                let names = query.get("of").expect("names").list().iter().rev().cloned().collect();
                query.set("of", Json::List(names));
            });
            let (one, other) = (answer(&scene.to_string()), answer(&swapped));
            for key in ["outcome", "overlap", "reason", "min", "max", "ties"] {
                assert_eq!(one.get(key), other.get(key), "{key} of {scene}");
            }
        }
    }
}

#[test]
fn an_overlap_that_no_digits_prove_is_none_either_way_round() {
    let of = |names: &str| {
        answer(&format!(
            r#"{{"shapes": {{"A": {{"kind": "box", "position": [3.625, -2.875], "half_extents": [0.5, 0.125],
            "angle_deg": 30, "velocity": [-2.375, -3.25]}}, "B": {{"kind": "polygon", "position": [3.75, -0.375],
            "vertices": [[-2.5, 0.375], [2.875, -4.0], [3.0, 0.25], [2.125, 2.25], [-0.75, 1.375]],
            "angle_deg": 90}}}}, "query": {{"kind": "linear-sweep", "of": {names}}}}}"#
        ))
    };
    for names in [r#"["A", "B"]"#, r#"["B", "A"]"#] {
        let outcome = of(names).text_at("outcome").map(str::to_owned);
        assert_eq!(outcome.as_deref(), Some("unresolved"), "{names}");
    }
}

#[test]
fn a_body_that_reaches_farther_than_106_bits_leaves_no_false_depth() {
    // The core of B starts at the origin and runs at 4.8125 degrees under the box, however far it reaches.
    let depth = -2.410_373_346_131_498;
    for exponent in [10, 20, 30, 32, 35, 40, 64, 90] {
        let of = |names: &str| {
            let found = answer(&format!(
                r#"{{"shapes": {{"A": {{"kind": "box", "half_extents": [3.5, 1.5], "radius": 3.5, "position": [3.5, 3.5],
                "angle_deg": 1}}, "B": {{"kind": "capsule", "points": [[2.45e{exponent}, 0], [0, 0]], "radius": 0.375,
                "angle_deg": 4.8125}}}}, "query": {{"kind": "overlap", "of": {names}}}}}"#
            ));
            let bounds = found.get("separation_bounds").expect("bounds").list();
            [bounds[0].number().unwrap(), bounds[1].number().unwrap()]
        };
        for names in [r#"["A", "B"]"#, r#"["B", "A"]"#] {
            let [lo, hi] = of(names);
            assert!(lo <= depth && depth <= hi, "1e{exponent}, {names}: {lo} to {hi}");
        }
    }
}

#[test]
fn bodies_as_deep_in_each_other_as_their_radii_do_not_touch() {
    // The core of B starts in the middle of the box: each is as deep in the other as ρ, which squares alike.
    for exponent in [0, 15, 30, 45, 90] {
        for names in [r#"["A", "B"]"#, r#"["B", "A"]"#] {
            let found = answer(&format!(
                r#"{{"shapes": {{"A": {{"kind": "aabb", "half_extents": [0.5, 0.5]}}, "B": {{"kind": "capsule",
                "points": [[1e{exponent}, 0], [0, 0]], "radius": 0.5, "angle_deg": 0.0625}}}},
                "query": {{"kind": "separation", "of": {names}}}}}"#
            ));
            let bounds = found.get("separation_bounds").unwrap().list();
            let [lo, hi] = [&bounds[0], &bounds[1]].map(|end| end.number().unwrap());
            assert!(lo <= -1.0 && (-1.0..0.0).contains(&hi), "1e{exponent}, {names}: {lo} to {hi}");
        }
    }
}

/// What is asked of two bodies of the smallest sizes that doubles have.
fn told_of_tiny(a: &str, b: &str, kind: &str) -> Json {
    answer(&format!(
        r#"{{"shapes": {{"A": {{{a}}}, "B": {{{b}}}}}, "query": {{"kind": "{kind}", "of": ["A", "B"]}}}}"#
    ))
}

#[test]
fn a_motion_of_bodies_too_small_for_where_they_are_is_no_miss() {
    let disc = |x: &str| format!(r#""kind": "circle", "radius": 1e-300, "position": [{x}, 0]"#);
    let segment = |to: &str, x: &str, y: &str| {
        format!(r#""kind": "capsule", "points": [[0, 0], [{to}, 0]], "radius": 0, "position": [{x}, {y}]"#)
    };
    for (x, to, y) in [
        ("1e22", "5e-324", "0"),
        ("1e22", "1.25e-301", "2.5e-301"),
        ("1e10", "3.3333333333333334e-301", "3.3333333333333334e-301"),
        ("1e299", "3e-301", "3e-301"),
    ] {
        for kind in ["linear-sweep", "time-of-impact"] {
            let found = told_of_tiny(&disc(x), &segment(to, x, y), kind);
            let outcome = found.text_at("outcome").unwrap();
            assert!(["overlapping", "unresolved"].contains(&outcome), "{kind}, {x}, {to}: {found}");
        }
    }
}

#[test]
fn bounds_below_all_normal_doubles_enclose_what_they_are_of() {
    // By exact fractions 3.9e-325 apart, of which the doubles about are 0 and 5e-324; 5.62e-324 apart.
    let square = r#""kind": "polygon", "vertices": [[-1e-308, -1e-308], [1e-308, -1e-308], [1e-308, 1e-308], [-1e-308, 1e-308]],
        "rotation": [0.9974784255027771, 0.07097040116786957]"#;
    let capsule = r#""kind": "capsule", "points": [[-3.403954207897185e-309, 4.952357113361357e-309],
        [-4.77706968784332e-309, 1.94325923919678e-309]], "radius": 2.304072231054306e-309,
        "rotation": [0.2545774281024933, 0.9670524001121521], "position": [-8.64463819115325e-309, -4.240066869066287e-309]"#;
    let boxed = r#""kind": "box", "half_extents": [6.445869207382201e-308, 2.935420870780945e-308], "radius": 2.5135496258735653e-308,
        "rotation": [0.6409518718719482, 0.7675811052322388]"#;
    let other = r#""kind": "box", "half_extents": [4.598816037178039e-308, 9.321172237396239e-308],
        "rotation": [0.6368221044540405, -0.7710107564926147], "position": [-1.1578728943134599e-307, 4.3586924599348092e-308]"#;
    for (a, b, [least, most]) in [(square, capsule, [0.0, 5e-324]), (boxed, other, [5e-324, 1e-323])] {
        let found = told_of_tiny(a, b, "separation");
        let bounds = found.get("separation_bounds").unwrap().list();
        let [lo, hi] = [0, 1].map(|k| bounds[k].number().unwrap());
        assert!(lo <= least && most <= hi && hi < 1e-322, "{found}");
    }
}

#[test]
fn bodies_too_small_for_their_distance_are_as_far_as_they_are_both_ways_round() {
    // Beside 1e218 the products of the box's edges are below all doubles.
    for [half, radius] in [["8e-62", "0.5625"], ["8e-62", "0"], ["1e-9", "0.5"]] {
        for (names, up) in [(r#"["A", "B"]"#, -1.0), (r#"["B", "A"]"#, 1.0)] {
            let found = answer(&format!(
                r#"{{"shapes": {{"A": {{"kind": "aabb", "half_extents": [9.5e-14, {half}], "position": [6.0625, 1.03e218]}},
                "B": {{"kind": "regular-polygon", "edges": 7, "circumradius": 0.75, "radius": {radius},
                "position": [0.75, 0.75], "angle_deg": 0.75}}}}, "query": {{"kind": "separation", "of": {names}}}}}"#
            ));
            let numbers = |key: &str| -> Vec<f64> {
                found.get(key).unwrap().list().iter().map(|x| x.number().unwrap()).collect()
            };
            let (bounds, normal) = (numbers("separation_bounds"), numbers("normal"));
            assert!(bounds[0] <= 1.03e218 && 1.03e218 <= bounds[1] && bounds[0] > 1.02e218, "{bounds:?}");
            assert!((normal[1] - up).abs() < 1e-9, "{half}, {radius}, {names}: {normal:?}");
        }
    }
}

#[test]
fn what_one_order_proves_at_once_the_other_proves_too() {
    let verdict = |names: &str| {
        let found = answer(&format!(
            r#"{{"shapes": {{"A": {{"kind": "capsule", "points": [[2.4108255004517747e64, -3.25], [0, 1.0625]],
            "radius": 6.125}}, "B": {{"kind": "polygon", "radius": 1.8125, "hull": true, "vertices": [[6.1875, 0],
            [4.125, 4.125], [0, 6.1875], [-4.125, 4.125], [-6.1875, 0], [-4.125, -4.125]]}}}},
            "query": {{"kind": "overlap", "of": {names}, "max_iterations": 1}}}}"#
        ));
        found.get("overlap").unwrap().to_string()
    };
    assert_eq!(verdict(r#"["A", "B"]"#), verdict(r#"["B", "A"]"#));
}

#[test]
fn an_overlap_is_proved_both_ways_round_by_every_algorithm_however_far_one_body_reaches() {
    let near = [
        r#""kind": "capsule", "points": [[3.0625, 6.125], [0, 1.25]], "radius": 2.375, "position": [-1.25, 1]"#,
        r#""kind": "capsule", "points": [[2.375, 1.25], [2.375, 1]], "radius": 5.0625, "position": [1, 3.0625]"#,
        // What is near an edge's one end is lost beside its other end.
        r#""kind": "regular-polygon", "edges": 3, "circumradius": 3.5, "position": [1, 1.8], "angle_deg": 125"#,
        // Along the unit normal of what reaches far, both lower corners of the box seem level.
        r#""kind": "aabb", "half_extents": [1, 5.5], "position": [3.0625, 2.9]"#,
    ];
    let far = [
        r#""points": [[6.125e69, 0], [-1, 1]], "radius": 0"#,
        r#""points": [[1.3611294676837539e40, -1.3611294676837539e40], [6.125, 6.125]], "radius": 3.0625"#,
        r#""points": [[3.0625e80, 0], [5, 1.0625]], "radius": 2.75, "position": [-1, -1], "angle_deg": 1"#,
        r#""points": [[4.5, 6.125e69], [-0.6, -5.1]], "radius": 4.125, "position": [1, 6.125]"#,
    ];
    for ((near, far), algorithm) in near.into_iter().zip(far).flat_map(|pair| {
        ["closest-features", "gjk", "separating-axes", "merge", "minkowski"].map(|word| (pair, word))
    }) {
        for of in ["[\"A\", \"B\"]", "[\"B\", \"A\"]"] {
            let found = answer(&format!(
                r#"{{"shapes": {{"A": {{{near}}}, "B": {{"kind": "capsule", {far}}}}},
                "query": {{"kind": "overlap", "of": {of}, "algorithm": "{algorithm}"}}}}"#
            ));
            let verdict = found.get("overlap").unwrap().to_string();
            assert_eq!(verdict, "true", "{algorithm}, {of}: {near}, {far}");
        }
    }
}

#[test]
fn bodies_that_overlap_at_the_start_overlap_however_far_one_of_them_reaches() {
    // A half-plane, but for its length, whose lower side the box reaches over by 3.0625. Doubles see its end
    // as far from the box as its other end is long.
    for (far, moved) in [("1e80", "43e66"), ("1e40", "1e27"), ("1e30", "1e16"), ("1e9", "0")] {
        for (names, limit) in
            [("A", "B"), ("B", "A")].into_iter().flat_map(|names| [(names, 1), (names, 100)])
        {
            let found = answer(&format!(
                r#"{{"shapes": {{"A": {{"kind": "capsule", "radius": 9007199254740992, "position": [{moved}, 6.0625],
                "points": [[-{far}, 9007199254740992], [0, 9007199254740992]], "velocity": [0, -5.0625]}},
                "B": {{"kind": "aabb", "half_extents": [5.0625, 4.125], "position": [0, 5], "velocity": [5, 0]}}}},
                "query": {{"kind": "time-of-impact", "of": ["{}", "{}"], "max_iterations": {limit}}}}}"#,
                names.0, names.1
            ));
            let outcome = found.text_at("outcome").map(str::to_owned);
            assert_eq!(outcome.as_deref(), Some("overlapping"), "{far}, {names:?}, {limit}: {found}");
        }
    }
}

/// The contacts of a pair, the deepest first; None where several edges are as deep.
fn contacts(a: &Body, b: &Body) -> Option<Vec<ContactPoint>> {
    let asked = query(QueryKind::Contact, a, b);
    let clip = takers(&asked).into_iter().next()?;
    let Answer::Contact(found) = (clip.quiet)(&asked, &mut NoTrace) else { return None };
    let mut points: Vec<ContactPoint> = found.found().copied().collect();
    points.sort_by(|p, q| p.separation.total_cmp(&q.separation));
    (found.separation.ties == 1).then_some(points)
}

#[test]
fn a_pair_touches_at_the_same_points_whichever_body_is_called_a() {
    let mut met = [0; 3];
    for (seed, a, b) in pairs(3000) {
        let (Some(one), Some(other)) = (contacts(&a, &b), contacts(&b, &a)) else { continue };
        met[one.len()] += 1;
        assert_eq!(one.len(), other.len(), "seed {seed}: {one:?} {other:?}");
        for (p, q) in one.iter().zip(&other) {
            let overlap = p.bounds.lo <= q.bounds.hi && q.bounds.lo <= p.bounds.hi;
            assert!(overlap, "seed {seed}: {p:?} {q:?}");
            let apart = (p.separation - q.separation).abs();
            let same = one.len() == 2 && (one[0].separation - one[1].separation).abs() < 1e-9;
            let near = |p: DVec2, q: DVec2| (p - q).length() < 1e-9 || same;
            assert!(apart < 1e-9 && near(p.points[0], q.points[1]), "seed {seed}: {p:?} {q:?}");
        }
    }
    assert!(met.iter().all(|&n| n > 50), "{met:?}");
}

/// A rounded triangle some 1e150 above a segment: the product of an edge of each is below all doubles beside
/// the square of the distance.
#[test]
fn what_is_far_away_does_not_overlap_where_a_walk_along_the_difference_is_lost() {
    let points = |all: &[[f64; 2]]| FieldValue::Points(all.iter().copied().map(DVec2::from).collect());
    let corners = points(&[[-20.25, 0.0], [-13.5, -13.5], [0.0, -20.25]]);
    let radius = ("radius", FieldValue::Number(2.375));
    let triangle = Shape::of_kind("polygon", &[("vertices", corners), radius]).unwrap();
    let ends = points(&[[6.75, 0.0], [0.0, 0.0]]);
    let segment =
        Shape::of_kind("capsule", &[("points", ends), ("radius", FieldValue::Number(0.0))]).unwrap();
    for away in [1e20, 1e60, 1e100, 1e140, 1e145, 1e150, 1e152] {
        for degrees in [0.0, -2.125, 90.0, 180.0] {
            let far = DVec2::new(-1.125, away);
            let a = Body { angle: Angle::Degrees(degrees), ..body(triangle.clone(), far) };
            let b = body(segment.clone(), DVec2::ZERO);
            for pair in [Pair::at(&a, &b, 0.0), Pair::at(&b, &a, 0.0)] {
                let Enclosure { lo, hi } = pair.separation().bounds;
                assert!(lo > 0.999 * away && hi < 1.001 * away, "{away:e}, {degrees}: {lo:e} {hi:e}");
            }
        }
    }
}
