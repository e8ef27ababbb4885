//! Two bodies to their certified distance, without a scene and without a trace: `cargo run --example distance`.

#![expect(clippy::print_stdout, reason = "an example for the terminal")]

use tracefig::collision::{ALGORITHMS, Answer, Query, QueryKind};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Angle, Body, DVec2, Shape};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let half = FieldValue::Point(DVec2::new(1.0, 0.5));
    let at = |shape: Shape, x: f64, y: f64, degrees: f64| Body {
        shape,
        position: DVec2::new(x, y),
        angle: Angle::Degrees(degrees),
        velocity: DVec2::ZERO,
        spin: Angle::Degrees(0.0),
    };
    let crate_ = at(Shape::of_kind("box", &[("half_extents", half)])?, 0.0, 0.0, 30.0);
    let ball = at(Shape::of_kind("circle", &[("radius", FieldValue::Number(0.25))])?, 2.0, 1.0, 0.0);

    let (kind, tolerance, max_iterations) = (QueryKind::Separation, 0.0, 100);
    let query = Query { kind, a: &crate_, b: Some(&ball), time: 0.0, tolerance, max_iterations };
    let algorithm = ALGORITHMS.iter().find(|algorithm| algorithm.takes(&query)).ok_or("nobody answers it")?;
    if let Some(Answer::Separation(found)) = algorithm.answer(&query) {
        println!("{} says {} apart,", algorithm.name, found.separation);
        println!("proved between {} and {},", found.bounds.lo, found.bounds.hi);
        println!("along {} between {} and {}", *found.normal, found.points[0], found.points[1]);
    }
    Ok(())
}
