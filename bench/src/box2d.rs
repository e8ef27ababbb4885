//! `box2d-rust`, a port of Box2D v3: GJK, SAT with clipping, conservative advancement; f32, at most eight
//! vertices.

use box2d_rust::collision::Polygon;
use box2d_rust::distance::{
    DistanceInput, ShapeCastPairInput, ShapeProxy, SimplexCache, Sweep, ToiInput, ToiState, make_proxy,
    shape_cast, shape_distance, time_of_impact,
};
use box2d_rust::geometry::make_polygon;
use box2d_rust::hull::compute_hull;
use box2d_rust::manifold::collide_polygons;
use box2d_rust::math_functions::{inv_mul_transforms, make_rot};
use box2d_rust::{Transform, Vec2};
use tracefig::collision::QueryKind;
use tracefig::geometry::Body;
use tracefig::report::{Case, Contender, Outcome, Preparation, Prepared};

/// The library as a contender.
pub struct Box2d;

/// Its limit on the vertices of a polygon.
const VERTICES: usize = 8;

#[expect(clippy::cast_possible_truncation, reason = "the library computes in f32")]
fn vector(v: tracefig::geometry::DVec2) -> Vec2 {
    Vec2 { x: v.x as f32, y: v.y as f32 }
}

#[expect(clippy::cast_possible_truncation, reason = "the library computes in f32")]
fn transform(body: &Body) -> Transform {
    Transform { p: vector(body.position), q: make_rot(body.angle.radians() as f32) }
}

fn points(body: &Body) -> Vec<Vec2> {
    body.shape.core.iter().map(|&i| vector(body.shape.vertices[i])).collect()
}

fn polygon(body: &Body) -> Option<Polygon> {
    let hull = compute_hull(&points(body));
    (hull.count > 2).then(|| make_polygon(&hull, 0.0))
}

#[expect(clippy::cast_possible_truncation, reason = "the library computes in f32")]
fn sweep(body: &Body) -> Sweep {
    Sweep {
        local_center: Vec2 { x: 0.0, y: 0.0 },
        c1: vector(body.position),
        c2: vector(body.position + body.velocity),
        q1: make_rot(body.angle.radians() as f32),
        q2: make_rot((body.angle.degrees() + body.spin.degrees()).to_radians() as f32),
    }
}

fn first_contact(a: ShapeProxy, b: ShapeProxy, sweep_a: Sweep, sweep_b: Sweep) -> Outcome {
    let output = time_of_impact(&ToiInput { proxy_a: a, proxy_b: b, sweep_a, sweep_b, max_fraction: 1.0 });
    match output.state {
        ToiState::Hit => Outcome::Value(f64::from(output.fraction)),
        ToiState::Separated => Outcome::Miss,
        ToiState::Overlapped => Outcome::Value(0.0),
        ToiState::Unknown | ToiState::Failed => Outcome::Undecided,
    }
}

impl Contender for Box2d {
    fn name(&self) -> &'static str {
        "box2d-rust"
    }

    fn precision(&self) -> &'static str {
        "f32"
    }

    fn tolerances(&self, _: QueryKind) -> Vec<f64> {
        vec![0.0]
    }

    fn prepare<'c>(
        &'c self,
        case: &'c Case,
        kind: QueryKind,
        _: f64,
        preparation: Preparation,
    ) -> Option<Prepared<'c>> {
        if case.a.shape.core.len() > VERTICES || case.b.shape.core.len() > VERTICES {
            return None;
        }
        let scratch = preparation == Preparation::FromScene;
        let ready = inv_mul_transforms(transform(&case.a), transform(&case.b));
        let relative =
            move || if scratch { inv_mul_transforms(transform(&case.a), transform(&case.b)) } else { ready };
        let (a, b) = (make_proxy(&points(&case.a), 0.0), make_proxy(&points(&case.b), 0.0));
        let apart = case.exact.is_none_or(|[s, _]| s > 0.0);
        let ask: Box<dyn FnMut() -> Outcome> = match kind {
            QueryKind::Separation if apart => Box::new(move || {
                let input = DistanceInput { proxy_a: a, proxy_b: b, transform: relative(), use_radii: false };
                Outcome::Value(f64::from(shape_distance(&input, &mut SimplexCache::default(), None).distance))
            }),
            QueryKind::Separation => {
                let (a, b) = (polygon(&case.a)?, polygon(&case.b)?);
                Box::new(move || {
                    let manifold = collide_polygons(&a, &b, relative());
                    let count = usize::try_from(manifold.point_count).unwrap_or(0);
                    manifold.points[..count]
                        .iter()
                        .map(|point| f64::from(point.separation))
                        .reduce(f64::min)
                        .map_or(Outcome::Undecided, Outcome::Value)
                })
            }
            QueryKind::LinearSweep => {
                let frame = transform(&case.a).q;
                let v = vector(case.b.velocity - case.a.velocity);
                let translation_b =
                    Vec2 { x: frame.c * v.x + frame.s * v.y, y: frame.c * v.y - frame.s * v.x };
                Box::new(move || {
                    let output = shape_cast(&ShapeCastPairInput {
                        proxy_a: a,
                        proxy_b: b,
                        transform: relative(),
                        translation_b,
                        max_fraction: 1.0,
                        can_encroach: false,
                    });
                    if output.hit { Outcome::Value(f64::from(output.fraction)) } else { Outcome::Miss }
                })
            }
            // Its sweep interpolates between two rotations, so it can't say more than half a turn.
            QueryKind::TimeOfImpact if case.a.spin.degrees().abs().max(case.b.spin.degrees().abs()) <= 180.0 => {
                let ready = (sweep(&case.a), sweep(&case.b));
                Box::new(move || {
                    let (sa, sb) = if scratch { (sweep(&case.a), sweep(&case.b)) } else { ready };
                    first_contact(a, b, sa, sb)
                })
            }
            _ => return None,
        };
        Some(Prepared { ask, steps: None })
    }
}
