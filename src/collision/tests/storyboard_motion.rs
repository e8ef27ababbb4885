//! The moving pairs of the figures, with answers that were computed with 256 bits: what the sweeps must find.

use crate::collision::tests::asking::impact as ask;
use crate::collision::tests::bodies::{boxed, moving, placed, polygon};
use crate::collision::{Impact, Outcome, Separation};
use crate::geometry::{Body, DVec2, Enclosure, Feature, Side};
use crate::trace::{Culling, Event, Trace};

fn hit(impact: &Impact) -> (Enclosure, Separation) {
    match impact.outcome {
        Outcome::Hit { time, contact } => (time, contact),
        other => panic!("{other:?}"),
    }
}

fn holds(time: Enclosure, t: f64, width: f64) {
    assert!(time.lo <= t && t <= time.hi, "{time:?} does not hold {t}");
    assert!(time.hi - time.lo <= width, "{time:?} is wider than {width}");
}

fn near(found: DVec2, expected: [f64; 2], within: f64) {
    assert!((found - DVec2::from(expected)).abs().max_element() < within, "{found:?} is not {expected:?}");
}

fn sweeping_pair() -> (Body, Body) {
    let a = polygon(&[[-1.5, -1.5], [-3.0, -0.5], [-4.0, -2.0], [-2.0, -3.5]], 0.0);
    let b = polygon(&[[0.0, 2.0], [3.0, -2.0], [5.0, 0.0], [5.0, 2.0], [2.5, 3.5]], 0.0);
    (moving(a, [6.0, 3.0], 0.0), b)
}

#[test]
fn figure_five_is_hit_at_half_time() {
    let (a, b) = sweeping_pair();
    for name in ["ray-cast", "ray-clipping", "swept-axis", "conservative-advancement"] {
        let (impact, _) = ask(name, &a, &b, 1e-12);
        let (time, contact) = hit(&impact);
        holds(time, 0.5, if name == "ray-cast" { 1e-16 } else { 1e-12 });
        near(*contact.normal, [0.8, 0.6], 1e-15);
        near(contact.points[0], [1.5, 0.0], 1e-11);
        near(contact.points[1], [1.5, 0.0], 1e-11);
    }
}

#[test]
fn the_linear_demo_skips_the_six_edges_that_face_away() {
    let a = moving(polygon(&[[0.0, 4.0], [3.0, 0.0], [4.5, 2.0], [3.0, 4.5]], 0.0), [-10.0, -5.0], 0.0);
    let b = polygon(&[[-2.5, 0.0], [-4.0, 1.5], [-5.5, 0.0], [-5.0, -2.5], [-3.0, -2.5]], 0.0);
    let (impact, trace) = ask("ray-cast", &a, &b, 0.0);
    let (time, contact) = hit(&impact);
    holds(time, 0.4, 1.2e-16);
    near(*contact.normal, [-0.8, -0.6], 1e-15);
    near(contact.points[1], [-2.5, 0.0], 1e-15);
    assert_eq!(impact.tolerance, 0.0);
    let mut told: Vec<_> = trace
        .events
        .iter()
        .filter_map(|e| match e {
            Event::RayClipped { source: (side, Feature::Edge(k)), outcome, .. } => {
                Some((*side == Side::B, *k, *outcome))
            }
            _ => None,
        })
        .collect();
    told.sort_by_key(|(b, k, _)| (*b, *k));
    let of = |outcome: Culling| {
        told.iter().filter(move |x| x.2 == outcome).map(|x| (x.0, x.1)).collect::<Vec<_>>()
    };
    assert_eq!(of(Culling::Hit), [(false, 0)]);
    assert_eq!(of(Culling::Missed), [(true, 0), (true, 4)]);
    assert_eq!(
        of(Culling::BackFacing),
        [(false, 1), (false, 2), (false, 3), (true, 1), (true, 2), (true, 3)]
    );
}

#[test]
fn of_two_edges_on_one_line_the_one_that_is_met_is_told() {
    let wall = placed(boxed("box", 0.5, 2.0), 2.0, 0.5, 0.0);
    let told = |x: f64, y: f64| {
        let car = moving(placed(boxed("box", 1.0, 0.5), x, y, 0.0), [8.0, 0.0], 0.0);
        let (_, trace) = ask("ray-cast", &car, &wall, 0.0);
        let met = trace.events.iter().filter_map(|event| match event {
            Event::RayClipped { source, outcome: Culling::Hit, .. } => Some(*source),
            _ => None,
        });
        met.collect::<Vec<_>>()
    };
    // B - A has the wall's edge from (5.5, 3 - y) down to (5.5, -1 - y), and from there the car's.
    let (wall, car) = ((Side::B, Feature::Edge(3)), (Side::A, Feature::Edge(1)));
    for (y, met) in [(0.0, wall), (2.9, wall), (-0.9, wall), (-1.0, wall), (-1.1, car), (-1.9, car)] {
        assert_eq!(told(-5.0, y), [met], "{y}");
        // Touching from the start; and inside from the start.
        assert_eq!((told(0.5, y), told(1.0, y)), (vec![met], vec![]), "{y}");
    }
}

#[test]
fn figure_six_steps_as_computed_by_hand() {
    let a = moving(polygon(&[[0.0, 0.0]], 3.0), [7.5, 0.0], 0.0);
    let b = placed(polygon(&[[0.0, 0.0]], 3.25), 8.0, 6.0, 0.0);
    let (impact, trace) = ask("ray-clipping", &a, &b, 1e-9);
    let (time, contact) = hit(&impact);
    holds(time, 5.0 / 6.0, 1e-9);
    near(*contact.normal, [0.28, 0.96], 1e-8);
    let expected = [
        (0.0, 3.75, [3.0, 2.25], [0.8, 0.6]),
        (0.625, 0.603_660, [4.979_260, 0.528_471], [0.483_318, 0.875_445]),
        (0.791_532, 0.094_925, [5.967_362, 0.089_765], [0.325_222, 0.945_638]),
        (0.830_449, 0.006_092, [6.230_093, 0.005_842], [0.283_185, 0.959_065]),
    ];
    let steps: Vec<_> = trace.events.iter().filter(|e| matches!(e, Event::Advanced { .. })).collect();
    assert_eq!(steps.len(), 7, "six steps and the last look");
    for (event, (t, s, p, n)) in steps.iter().zip(expected) {
        let Event::Advanced { at, separation, closest, normal, .. } = event else { unreachable!() };
        assert!((at.time - t).abs() < 1e-6 && (separation - s).abs() < 1e-6, "{event:?}");
        near(*closest, p, 1e-6);
        near(*normal, n, 1e-6);
    }
    let (direct, _) = ask("ray-cast", &a, &b, 0.0);
    holds(hit(&direct).0, 5.0 / 6.0, 2.3e-16);
}

#[test]
fn figure_seven_is_hit_after_a_quarter_turn_of_both() {
    let a = polygon(&[[0.0, -3.0], [1.0, 0.0], [0.0, 1.5], [-1.0, 0.0]], 0.0);
    let b = polygon(&[[-2.0, -1.5], [1.5, -2.0], [2.5, 0.0], [2.0, 1.5], [-2.0, 1.5]], 0.0);
    let a = moving(placed(a, -7.0, -1.0, 0.0), [10.0, 6.0], 180.0);
    let b = moving(placed(b, 7.5, -1.5, 0.0), [-10.0, 6.0], 180.0);
    let (impact, _) = ask("swept-axis", &a, &b, 0.0);
    let (time, contact) = hit(&impact);
    holds(time, 0.5, 1e-14);
    near(*contact.normal, [1.0, 0.0], 1e-13);
    near(contact.points[0], [1.0, 2.0], 1e-12);
    let (impact, trace) = ask("conservative-advancement", &a, &b, 0.01);
    holds(hit(&impact).0, 0.5, 0.01);
    let expected = [
        0.0, 0.308_487, 0.402_999, 0.452_324, 0.478_422, 0.490_619, 0.495_993, 0.498_302, 0.499_283,
        0.499_697,
    ];
    let times: Vec<f64> = times(&trace);
    assert_eq!(times.len(), expected.len());
    assert!(times.iter().zip(expected).all(|(t, e)| (t - e).abs() < 1e-6), "{times:?}");
}

fn times(trace: &Trace) -> Vec<f64> {
    let time = |e: &Event| if let Event::Advanced { at, .. } = e { Some(at.time) } else { None };
    trace.events.iter().filter_map(time).collect()
}

#[test]
fn the_angular_demo_takes_five_steps() {
    let a = moving(placed(boxed("box", 1.2, 0.5), -3.5, -2.0, 0.0), [8.0, 4.0], 180.0);
    let b = polygon(&[[1.0, -0.5], [3.0, -3.0], [4.5, 0.0], [3.0, 2.0]], 0.0);
    let (impact, trace) = ask("conservative-advancement", &a, &b, 0.02);
    assert_eq!((impact.tolerance, impact.iterations), (0.02, 6));
    let (time, _) = hit(&impact);
    assert!(time.lo < 0.5 && 0.5 <= time.hi && time.hi - time.lo < 0.01, "{time:?}");
    let expected = [
        (0.0, 3.448_188, 8.816_220, 12.900_301),
        (0.267_295, 1.195_162, 7.522_709, 11.606_784),
        (0.370_266, 0.904_392, 5.759_173, 9.843_243),
        (0.462_146, 0.338_520, 7.468_930, 11.553_000),
        (0.491_447, 0.080_731, 7.889_649, 11.973_718),
    ];
    let steps: Vec<_> = trace.events.iter().filter(|e| matches!(e, Event::Advanced { .. })).collect();
    for (event, (t, s, v, w)) in steps.iter().zip(expected) {
        let Event::Advanced { at, separation, closing_speed, bound, next, .. } = event else {
            unreachable!()
        };
        // The storyboard's speeds are from normals of six digits.
        let near = |x: f64, y: f64| (x - y).abs() < 1e-5;
        assert!(
            near(at.time, t) && near(*separation, s) && near(*closing_speed, v) && near(*bound, w),
            "{event:?}"
        );
        assert!(next.is_some());
    }
    let Some(Event::Advanced { separation, next: None, .. }) = steps.last() else {
        panic!("the last look stops")
    };
    assert!((separation - 0.017_277).abs() < 1e-6);
    holds(hit(&ask("swept-axis", &a, &b, 0.0).0).0, 0.5, 1e-14);
}

#[test]
fn a_predicted_frame_touches_at_seven_tenths() {
    let a = moving(placed(polygon(&[[0.0, 0.0]], 1.0), -1.5, 2.5, 0.0), [4.0, -3.0], 0.0);
    let b = polygon(&[[0.0, -3.0], [4.0, -3.5], [6.0, 0.0], [4.5, 3.0]], 0.0);
    for name in ["ray-cast", "swept-axis"] {
        let (time, contact) = hit(&ask(name, &a, &b, 0.0).0);
        holds(time, 0.7, 1e-14);
        near(contact.points[0], [2.1, -0.2], 1e-14);
        near(*contact.normal, [0.8, -0.6], 1e-14);
    }
}
