//! The discrete pairs of the figures, with answers that were computed with 256 bits: what the algorithms must
//! find.

use crate::collision::tests::asking::{query, separation as ask};
use crate::collision::tests::bodies::{TILT, boxed, placed, polygon};
use crate::collision::{ALGORITHMS, QueryKind, Separation};
use crate::geometry::{Body, DVec2, Feature, Side};
use crate::trace::{Event, Trace};

/// The default and every algorithm that takes a pair, each with its answer.
fn all(a: &Body, b: &Body) -> Vec<(&'static str, Separation)> {
    let query = query(QueryKind::Separation, a, b);
    let takers = ALGORITHMS.iter().filter(|algorithm| algorithm.takes(&query));
    takers.map(|algorithm| (algorithm.name, ask(algorithm.name, a, b).0)).collect()
}

fn near(found: DVec2, expected: [f64; 2]) {
    assert!((found - DVec2::from(expected)).abs().max_element() < 4e-15, "{found:?} is not {expected:?}");
}

/// Every algorithm finds this separation, normal and witness points.
fn every(a: &Body, b: &Body, s: f64, n: [f64; 2], p_a: [f64; 2], p_b: [f64; 2]) {
    let answers = all(a, b);
    assert!(answers.len() >= 2);
    for (name, found) in answers {
        assert!((found.separation - s).abs() < 4e-15, "{name}: {found:?}");
        assert!(found.bounds.lo <= s && s <= found.bounds.hi, "{name}: {found:?}");
        near(*found.normal, n);
        near(found.points[0], p_a);
        near(found.points[1], p_b);
    }
}

/// The outline of B ⊖ A as the storyboard writes it: start of each edge, source and its index.
fn outline(a: &Body, b: &Body, expected: &[([f64; 2], Side, usize)]) {
    // The merge tells the edges in their order.
    let merged = edges(&ask("merge", a, b).1);
    let at_start = |e: &Told| (e.from - DVec2::from(expected[0].0)).abs().max_element() < 4e-15;
    let start = merged.iter().position(at_start).expect("the first vertex is there");
    assert_eq!(merged.len(), expected.len());
    for (k, &(from, source, edge)) in expected.iter().enumerate() {
        let found = &merged[(start + k) % merged.len()];
        near(found.from, from);
        assert_eq!((found.source, found.edge), (source, edge));
    }
    for (k, e) in merged.iter().enumerate() {
        assert_eq!(e.to, merged[(k + 1) % merged.len()].from);
    }
    // The article's loop finds the same edges, bit for bit, in its own order.
    let looped = edges(&ask("minkowski", a, b).1);
    assert_eq!(looped.len(), merged.len());
    assert!(looped.iter().all(|e| merged.contains(e)), "{looped:?} is not {merged:?}");
}

/// An edge of B ⊖ A as it was told: the body whose edge it is, that edge, the other body's vertex, start and
/// end.
#[derive(Debug, PartialEq)]
struct Told {
    source: Side,
    edge: usize,
    vertex: usize,
    from: DVec2,
    to: DVec2,
}

fn edges(trace: &Trace) -> Vec<Told> {
    let edge = |event: &Event| match *event {
        Event::DifferenceEdgeFound { source, edge, vertex, from, to, .. } => {
            Some(Told { source, edge, vertex, from, to })
        }
        _ => None,
    };
    trace.events.iter().filter_map(edge).collect()
}

use Side::{A, B};

#[test]
fn the_pair_of_figure_1_is_parted_by_two_and_a_half_along_four_fifths_three_fifths() {
    let a = polygon(&[[5., -1.], [2., 3.], [-3., 3.5], [-5., 0.], [-3., -3.5], [2., -4.]], 0.0);
    let b = polygon(&[[1.5, -0.5], [6., -2.], [8., 1.], [6., 3.5], [2.5, 3.]], 0.0);
    every(&a, &b, -2.5, [0.8, 0.6], [3.5, 1.0], [1.5, -0.5]);
    assert_eq!(ask("minkowski", &a, &b).0.features, [Feature::Edge(0), Feature::Vertex(0)]);
    let expected = [
        ([9., -5.5], B, 1),
        ([11., -2.5], A, 2),
        ([13., 1.], A, 3),
        ([11., 4.5], B, 2),
        ([9., 7.], A, 4),
        ([4., 7.5], B, 3),
        ([0.5, 7.], A, 5),
        ([-2.5, 4.], B, 4),
        ([-3.5, 0.5], A, 0),
        ([-0.5, -3.5], B, 0),
        ([4., -5.], A, 1),
    ];
    outline(&a, &b, &expected);
}

#[test]
fn the_circle_of_figure_3_is_one_and_a_half_from_the_vertex() {
    let a = boxed("aabb", 4., 1.);
    let b = placed(polygon(&[[0., 0.]], 1.0), 5.5, 3., 0.);
    every(&a, &b, 1.5, [0.6, 0.8], [4., 1.], [4.9, 2.2]);
    let (s, trace) = ask("clamp", &a, &b);
    assert_eq!(s.features, [Feature::Vertex(2), Feature::Vertex(0)]);
    let clamped = trace.events.iter().find_map(|e| match *e {
        Event::Clamped { body, v, clamped, closest, d, .. } => Some((body, v, clamped, closest, d)),
        _ => None,
    });
    let v = |x, y| DVec2::new(x, y);
    assert_eq!(clamped, Some((A, v(5.5, 3.), v(4., 1.), v(4., 1.), v(1.5, 2.))));
}

#[test]
fn the_difference_of_figure_4_alternates_between_its_bodies() {
    let a = placed(boxed("box", 2., 1.), -1., -3., 0.);
    let b = placed(polygon(&[[1.5, 0.], [0., 2.], [-1.5, 0.], [0., -2.]], 0.0), 0.5, 3., 0.);
    every(&a, &b, 3.0, [0., 1.], [0.5, -2.], [0.5, 1.]);
    let expected = [
        ([-0.5, 3.], A, 2),
        ([3.5, 3.], B, 3),
        ([5., 5.], A, 3),
        ([5., 7.], B, 0),
        ([3.5, 9.], A, 0),
        ([-0.5, 9.], B, 1),
        ([-2., 7.], A, 1),
        ([-2., 5.], B, 2),
    ];
    outline(&a, &b, &expected);
}

#[test]
fn the_circles_overlap_by_one_and_a_half() {
    let a = polygon(&[[0., 0.]], 3.0);
    let b = placed(polygon(&[[0., 0.]], 2.5), 4., 0., 0.);
    every(&a, &b, -1.5, [1., 0.], [3., 0.], [1.5, 0.]);
    let (_, trace) = ask("circles", &a, &b);
    let measured =
        Event::PenetrationMeasured { p: -1.5, direction: DVec2::NEG_X, vector: DVec2::new(1.5, 0.) };
    assert!(trace.events.contains(&measured), "{trace:?}");
}

#[test]
fn one_gap_parts_the_boxes() {
    let a = placed(boxed("aabb", 4., 2.), -4., -0.5, 0.);
    let b = placed(boxed("aabb", 3., 1.5), 4., 2., 0.);
    every(&a, &b, 1.0, [1., 0.], [0., 1.], [1., 1.]);
    let (_, trace) = ask("extents", &a, &b);
    let gap = trace.events.iter().find_map(|e| match *e {
        Event::ExtentsCompared { gap, .. } => Some(gap),
        _ => None,
    });
    assert_eq!(gap, Some(DVec2::new(1., -1.)));
}

#[test]
fn the_tilted_box_keeps_x_and_cuts_y() {
    let a = placed(boxed("box", 3., 1.), 0., 0., TILT);
    let b = placed(polygon(&[[0., 0.]], 1.5), -0.5, 4., 0.);
    every(&a, &b, 1.0, [-0.6, 0.8], [1., 2.], [0.4, 2.8]);
    every(&b, &a, 1.0, [0.6, -0.8], [0.4, 2.8], [1., 2.]);
    assert_eq!(ask("clamp", &a, &b).0.features, [Feature::Edge(2), Feature::Vertex(0)]);
}

#[test]
fn aligned_boxes_have_two_supporting_vertices_and_meet_in_the_middle_of_their_common_span() {
    let a = placed(boxed("box", 3., 1.5), 0., 0., TILT);
    let b = placed(boxed("box", 2., 1.5), 1., 2., TILT);
    every(&a, &b, -2.0, [-0.6, 0.8], [0.3, 2.1], [1.5, 0.5]);
    let expected = [
        ([-1.2, -3.4], B, 0),
        ([2., -1.], A, 2),
        ([6.8, 2.6], B, 1),
        ([5., 5.], A, 3),
        ([3.2, 7.4], B, 2),
        ([0., 5.], A, 0),
        ([-4.8, 1.4], B, 3),
        ([-3., -1.], A, 1),
    ];
    outline(&a, &b, &expected);
    let (s, trace) = ask("minkowski", &a, &b);
    assert_eq!((s.features, s.ties), ([Feature::Edge(2), Feature::Edge(0)], 1));
    let supports: Vec<_> = trace
        .events
        .iter()
        .filter_map(|e| match e {
            Event::SupportFound { body: B, vertices, .. } => {
                Some(vertices.iter().map(|v| v.index).collect::<Vec<_>>())
            }
            _ => None,
        })
        .collect();
    assert_eq!(supports, [vec![2, 3], vec![3, 0], vec![0, 1], vec![1, 2]]);
}

#[test]
fn any_two_convex_polygons_have_such_a_difference() {
    let a = polygon(&[[2.5, 2.], [-1., 3.], [-4., 1.], [-3., -2.], [1., -2.5]], 0.0);
    let b = polygon(&[[0., 2.], [3., -2.], [5., 4.]], 0.0);
    every(&a, &b, -2.0, [0.8, 0.6], [2.5, 2.], [0.9, 0.8]);
    let expected = [
        ([4., -5.], A, 1),
        ([7., -3.], B, 1),
        ([9., 3.], A, 2),
        ([8., 6.], A, 3),
        ([4., 6.5], B, 2),
        ([-1., 4.5], A, 4),
        ([-2.5, 0.], B, 0),
        ([0.5, -4.], A, 0),
    ];
    outline(&a, &b, &expected);
}
