//! The queries that `trace_cost` counts: `list` prints the algorithms, `NAME COUNT` asks one of them COUNT
//! times, over all pairs that it takes.

use std::hint::black_box;

use tracefig::collision::{ALGORITHMS, Algorithm, Query, QueryKind};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Body, DVec2, Angle, Shape};
use tracefig::trace::NoTrace;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let pairs = pairs();
    match &arguments[..] {
        [name, count] => {
            let algorithm = ALGORITHMS.iter().find(|x| x.name == name.as_str()).expect("a name from `list`");
            let queries = queries(algorithm, &pairs);
            let count: usize = count.parse().expect("a number");
            for query in queries.iter().cycle().take(count) {
                black_box((algorithm.quiet)(black_box(query), &mut NoTrace));
            }
        }
        _ => {
            let asked = ALGORITHMS.iter().filter(|x| !queries(x, &pairs).is_empty());
            asked.for_each(|x| println!("{}", x.name));
        }
    }
}

/// Every question that an algorithm takes, of every pair.
fn queries<'s>(algorithm: &Algorithm, pairs: &'s [(Body, Body)]) -> Vec<Query<'s>> {
    let query = |kind, (a, b): &'s (Body, Body)| {
        Query { kind, a, b: Some(b), time: 0.0, tolerance: 1e-9, max_iterations: 64 }
    };
    let all = algorithm.kinds.iter().flat_map(|&kind| pairs.iter().map(move |pair| query(kind, pair)));
    all.filter(|query| algorithm.takes(query)).collect()
}

/// Overlapping and apart: circles, AABBs, tilted boxes, circle and box, polygons of 5 and of 32 vertices.
fn pairs() -> Vec<(Body, Body)> {
    let number = FieldValue::Number;
    let circle = |r: f64| shape("circle", &[("radius", number(r))]);
    let aabb = |x: f64, y: f64| shape("aabb", &[("half_extents", FieldValue::Point(DVec2::new(x, y)))]);
    let boxed = |x: f64, y: f64| shape("box", &[("half_extents", FieldValue::Point(DVec2::new(x, y)))]);
    let round = |n: u32| {
        let vertex = |k: u32| {
            let angle = f64::from(k) * std::f64::consts::TAU / f64::from(n);
            DVec2::new(2.0 * libm::cos(angle), libm::sin(angle))
        };
        shape("polygon", &[("vertices", FieldValue::Points((0..n).map(vertex).collect()))])
    };
    let shapes = [
        (circle(3.0), circle(2.5), 0.0, 0.0),
        (aabb(4.0, 2.0), aabb(3.0, 1.5), 0.0, 0.0),
        (boxed(3.0, 1.0), circle(1.5), 30.0, 0.0),
        (boxed(3.0, 1.5), boxed(2.0, 1.5), 30.0, 75.0),
        (round(5), round(5), 10.0, 20.0),
        (round(32), round(32), 10.0, 20.0),
    ];
    let placed = |(a, b, of_a, of_b): &(Shape, Shape, f64, f64), x: f64| {
        (body(a, DVec2::ZERO, *of_a), body(b, DVec2::new(x, 0.75), *of_b))
    };
    shapes.iter().flat_map(|pair| [placed(pair, 1.5), placed(pair, 9.0)]).collect()
}

fn shape(kind: &str, fields: &[(&str, FieldValue)]) -> Shape {
    Shape::of_kind(kind, fields).expect("a valid shape")
}

fn body(shape: &Shape, position: DVec2, angle: f64) -> Body {
    let velocity = if position == DVec2::ZERO { DVec2::new(6.0, 0.5) } else { DVec2::ZERO };
    Body { shape: shape.clone(), position, angle: Angle::Degrees(angle), velocity, spin: Angle::Degrees(0.0) }
}
