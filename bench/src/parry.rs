//! `parry2d-f64`: GJK, EPA, GJK ray cast, and its non-linear shape cast.

use parry2d_f64::math::{Pose, Vector};
use parry2d_f64::query::details::{
    cast_shapes_support_map_support_map, contact_support_map_support_map, distance_support_map_support_map,
};
use parry2d_f64::query::{NonlinearRigidMotion, ShapeCastOptions, cast_shapes_nonlinear};
use parry2d_f64::shape::ConvexPolygon;
use tracefig::collision::QueryKind;
use tracefig::geometry::Body;
use tracefig::report::{Case, Contender, Outcome, Preparation, Prepared};

/// The library as a contender.
pub struct Parry;

fn vector(v: tracefig::geometry::DVec2) -> Vector {
    Vector::new(v.x, v.y)
}

fn polygon(body: &Body) -> Option<ConvexPolygon> {
    let points = body.shape.core.iter().map(|&i| vector(body.shape.vertices[i])).collect();
    ConvexPolygon::from_convex_polyline_unmodified(points)
}

fn pose(body: &Body) -> Pose {
    Pose::new(vector(body.position), body.angle.radians())
}

fn motion(body: &Body) -> NonlinearRigidMotion {
    NonlinearRigidMotion::new(pose(body), Vector::ZERO, vector(body.velocity), body.spin.radians())
}

impl Contender for Parry {
    fn name(&self) -> &'static str {
        "parry2d-f64"
    }

    fn precision(&self) -> &'static str {
        "f64"
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
        let (a, b) = (polygon(&case.a)?, polygon(&case.b)?);
        let scratch = preparation == Preparation::FromScene;
        let ready = pose(&case.a).inv_mul(&pose(&case.b));
        let relative = move || if scratch { pose(&case.a).inv_mul(&pose(&case.b)) } else { ready };
        let apart = case.exact.is_none_or(|[s, _]| s > 0.0);
        let ask: Box<dyn FnMut() -> Outcome> = match kind {
            QueryKind::Separation if apart => {
                Box::new(move || Outcome::Value(distance_support_map_support_map(&relative(), &a, &b)))
            }
            QueryKind::Separation => Box::new(move || {
                contact_support_map_support_map(&relative(), &a, &b, f64::MAX)
                    .map_or(Outcome::Undecided, |contact| Outcome::Value(contact.dist))
            }),
            QueryKind::LinearSweep => {
                let options = ShapeCastOptions { max_time_of_impact: 1.0, ..ShapeCastOptions::default() };
                let velocity = pose(&case.a).rotation.inverse() * vector(case.b.velocity - case.a.velocity);
                Box::new(move || {
                    cast_shapes_support_map_support_map(&relative(), velocity, &a, &b, options)
                        .map_or(Outcome::Miss, |hit| Outcome::Value(hit.time_of_impact))
                })
            }
            QueryKind::TimeOfImpact => {
                let ready = (motion(&case.a), motion(&case.b));
                Box::new(move || {
                    let (ma, mb) = if scratch { (motion(&case.a), motion(&case.b)) } else { ready };
                    match cast_shapes_nonlinear(&ma, &a, &mb, &b, 0.0, 1.0, true) {
                        Ok(Some(hit)) => Outcome::Value(hit.time_of_impact),
                        Ok(None) => Outcome::Miss,
                        Err(_) => Outcome::Undecided,
                    }
                })
            }
            _ => return None,
        };
        Some(Prepared { ask, steps: None })
    }
}
