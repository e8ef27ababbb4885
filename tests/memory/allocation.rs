//! An untraced query allocates nothing, whoever answers it.

use crate::asking::{of_kind, query, takers};
use crate::random_pairs::pairs;
use tracefig::collision::{Query, QueryKind};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Angle, Body, DVec2};
use tracefig::trace::{NoTrace, Trace};

const KINDS: [QueryKind; 5] = [
    QueryKind::Separation,
    QueryKind::Overlap,
    QueryKind::Bounds,
    QueryKind::MotionBound,
    QueryKind::Contact,
];

/// Asks every algorithm that takes a query, untraced.
#[track_caller]
fn nothing_is_allocated(query: &Query, what: &str) {
    for algorithm in takers(query) {
        let used = allocation_counter::measure(|| {
            std::hint::black_box((algorithm.quiet)(query, &mut NoTrace));
        });
        assert_eq!(used.count_total, 0, "{what}, {}", algorithm.name);
    }
}

#[test]
fn an_untraced_query_allocates_nothing() {
    for (seed, a, b) in pairs(300) {
        for kind in KINDS {
            let query = query(kind, &a, &b);
            nothing_is_allocated(&query, &format!("seed {seed}"));
        }
    }
}

#[test]
fn a_moving_untraced_query_allocates_nothing() {
    for (seed, mut a, mut b) in pairs(60) {
        (a.velocity, b.velocity) = (DVec2::new(3.0, 1.0), DVec2::new(-1.0, 0.5));
        for kind in [QueryKind::LinearSweep, QueryKind::TimeOfImpact] {
            if kind == QueryKind::TimeOfImpact && a.shape.kind != "aabb" {
                a.spin = Angle::Degrees(45.0);
            }
            let query = query(kind, &a, &b);
            nothing_is_allocated(&query, &format!("seed {seed}"));
        }
    }
}

#[test]
fn a_thousand_vertices_allocate_nothing_either() {
    let vertices = |n: u32| {
        let vertex = |k: u32| {
            let angle = f64::from(k) * std::f64::consts::TAU / f64::from(n);
            DVec2::new(libm::cos(angle), libm::sin(angle))
        };
        FieldValue::Points((0..n).map(vertex).collect())
    };
    let body = |n: u32, x: f64| Body {
        shape: of_kind("polygon", &[("vertices", vertices(n))]),
        position: DVec2::new(x, 0.25),
        angle: Angle::Degrees(x),
        velocity: DVec2::ZERO,
        spin: Angle::Degrees(0.0),
    };
    let a = body(1024, 0.0);
    for x in [0.0, 0.5, 2.5] {
        let b = body(1000, x);
        let query = query(QueryKind::Separation, &a, &b);
        nothing_is_allocated(&query, &format!("at {x}"));
    }
}

#[test]
fn the_counter_counts() {
    let (_, a, b) = pairs(1).next().unwrap();
    let query = query(QueryKind::Separation, &a, &b);
    let algorithm = takers(&query)[0];
    let used = allocation_counter::measure(|| {
        std::hint::black_box((algorithm.traced)(&query, &mut Trace::default()));
    });
    assert!(used.count_total > 0);
}
