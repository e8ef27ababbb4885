//! Any simple polygon, concave ones too; for `bounds` only.

use glam::DVec2;

use super::convex::{orientation, tamer};
use super::{Field, FieldType, FieldValue, Kind, Shape, ShapeError, VertexKey, points_value, value};

/// The row of the table.
pub(super) const KIND: Kind = Kind {
    name: "outline",
    about: "any simple polygon, for bounds only",
    in_words: ["an object", "ein Gegenstand", "un objet", "un objeto"],
    fields: &[Field {
        name: "vertices",
        holds: FieldType::Points { min: 3 },
        required: true,
        about: "three vertices or more",
    }],
    build,
    turns: true,
    vertices: VertexKey::Each("vertices"),
};

/// Fields to a shape.
fn build(values: &[Option<FieldValue>]) -> Result<Shape, ShapeError> {
    let vertices = points_value("vertices", value(values, 0))?;
    if vertices.len() < 3 {
        let message = format!("expected three vertices or more, got {}", vertices.len());
        return Err(ShapeError::new("too-few-corners", "vertices", message));
    }
    let scale = tamer(&vertices);
    let tame: Vec<DVec2> = vertices.iter().map(|&v| v * scale).collect();
    if let Some(edge) = first_crossing(&tame) {
        let message = format!("expected edges that do not meet, got edge {edge} across another");
        return Err(ShapeError::at("not-simple", "vertices", edge, message));
    }
    Ok(Shape::bare("outline", vertices))
}

/// The first edge that meets another one elsewhere than at their common vertex.
fn first_crossing(vertices: &[DVec2]) -> Option<usize> {
    let n = vertices.len();
    let edge = |i: usize| (vertices[i], vertices[(i + 1) % n]);
    for i in 0..n {
        for j in i + 1..n {
            let ((p, q), (r, s)) = (edge(i), edge(j));
            let neighbours = j == i + 1 || (i == 0 && j + 1 == n);
            let bad = if neighbours {
                // Collinear neighbours may go on, but not come back over each other.
                let (tip, common, other) = if j == i + 1 { (p, q, s) } else { (q, p, r) };
                orientation(tip, common, other) == 0.0
                    && (within(tip, common, other) || within(other, common, tip))
            } else {
                meet((p, q), (r, s))
            };
            if bad {
                return Some(i);
            }
        }
    }
    None
}

/// Whether `x`, which is on the line of the segment, lies in its bounding box.
fn within(x: DVec2, from: DVec2, to: DVec2) -> bool {
    x.cmpge(from.min(to)).all() && x.cmple(from.max(to)).all()
}

/// Whether two segments have a common point; exact.
fn meet((p, q): (DVec2, DVec2), (r, s): (DVec2, DVec2)) -> bool {
    let (a, b) = (orientation(p, q, r), orientation(p, q, s));
    let (c, d) = (orientation(r, s, p), orientation(r, s, q));
    let crosses = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
    (crosses(a, b) && crosses(c, d))
        || (a == 0.0 && within(r, p, q))
        || (b == 0.0 && within(s, p, q))
        || (c == 0.0 && within(p, r, s))
        || (d == 0.0 && within(q, r, s))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_may_be_concave_but_not_cross_itself() {
        let outline = |points: &[(f64, f64)]| {
            let points = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
            Shape::of_kind("outline", &[("vertices", FieldValue::Points(points))])
        };
        assert!(outline(&[(0., 0.), (2., 0.), (1., 0.5), (1., 2.)]).is_ok());
        assert_eq!(outline(&[(0., 0.), (1., 1.), (1., 0.), (0., 1.)]).unwrap_err().code, "not-simple");
    }
}
