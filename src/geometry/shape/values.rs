//! Values of a shape's fields, checked: of the type that the field holds, finite, in range.

use glam::DVec2;

use super::{Field, FieldType, FieldValue, ShapeError};

/// Numbers beyond this are refused as `too-large`.
const LARGEST: f64 = 1e300;

/// A finite number that is not too large.
pub(super) fn finite(field: &'static str, element: Option<usize>, x: f64) -> Result<f64, ShapeError> {
    let (code, what) = if !x.is_finite() {
        ("not-finite", "a finite number")
    } else if x.abs() > LARGEST {
        ("too-large", "a number within ±1e300")
    } else {
        return Ok(x);
    };
    Err(ShapeError { code, field, element, message: format!("expected {what}, got {x}") })
}

/// Both coordinates finite and not too large.
pub(super) fn finite_point(
    field: &'static str,
    element: Option<usize>,
    p: DVec2,
) -> Result<DVec2, ShapeError> {
    Ok(DVec2::new(finite(field, element, p.x)?, finite(field, element, p.y)?))
}

/// The error of a field that is not there, or of another type.
pub(super) fn unusable(field: &'static str, value: Option<&FieldValue>, expected: &str) -> ShapeError {
    match value {
        None => ShapeError::new("missing-field", field, format!("expected {expected}, got nothing")),
        Some(FieldValue::Number(_)) => wrong_type(field, expected, "a number"),
        Some(FieldValue::Count(_)) => wrong_type(field, expected, "a whole number"),
        Some(FieldValue::Point(_)) => wrong_type(field, expected, "a pair of numbers"),
        Some(FieldValue::Points(_)) => wrong_type(field, expected, "a list of pairs"),
        Some(FieldValue::Switch(_)) => wrong_type(field, expected, "true or false"),
    }
}

/// The error of a field of another type.
pub(super) fn wrong_type(field: &'static str, expected: &str, got: &str) -> ShapeError {
    ShapeError::new("wrong-type", field, format!("expected {expected}, got {got}"))
}

/// The value of field `index`, where there is one.
pub(super) fn value(values: &[Option<FieldValue>], index: usize) -> Option<&FieldValue> {
    values.get(index).and_then(Option::as_ref)
}

/// A radius: finite and not negative.
pub(super) fn radius_value(found: Option<&FieldValue>) -> Result<f64, ShapeError> {
    let Some(FieldValue::Number(radius)) = found else {
        return Err(unusable("radius", found, "a number"));
    };
    let radius = finite("radius", None, *radius)?;
    if radius < 0.0 {
        return Err(ShapeError::new(
            "negative-radius",
            "radius",
            format!("expected 0 or more, got {radius}"),
        ));
    }
    // −0 is 0.
    Ok(radius + 0.0)
}

/// The field of a radius that need not be written: [`optional_radius`] reads it.
pub(super) const SWEEPING_RADIUS: Field = Field {
    name: "radius",
    holds: FieldType::Length,
    required: false,
    about: "radius of the disc that sweeps the core, world units; 0",
};

/// A radius that may be left out: then 0.
pub(super) fn optional_radius(found: Option<&FieldValue>) -> Result<f64, ShapeError> {
    if found.is_none() { Ok(0.0) } else { radius_value(found) }
}

/// A switch that may be left out: then it is off.
pub(super) fn switch_value(field: &'static str, found: Option<&FieldValue>) -> Result<bool, ShapeError> {
    match found {
        None => Ok(false),
        Some(FieldValue::Switch(on)) => Ok(*on),
        other => Err(unusable(field, other, "true or false")),
    }
}

/// A list of finite points.
pub(super) fn points_value(
    field: &'static str,
    found: Option<&FieldValue>,
) -> Result<Vec<DVec2>, ShapeError> {
    let Some(FieldValue::Points(points)) = found else {
        return Err(unusable(field, found, "a list of pairs of numbers"));
    };
    points.iter().enumerate().map(|(i, &p)| finite_point(field, Some(i), p)).collect()
}

/// Half-extents: finite and above 0. A box without width or height is an error; a capsule says it as a
/// segment.
pub(super) fn half_extents_value(found: Option<&FieldValue>) -> Result<DVec2, ShapeError> {
    let Some(FieldValue::Point(h)) = found else {
        return Err(unusable("half_extents", found, "a pair of numbers"));
    };
    let h = finite_point("half_extents", None, *h)?;
    for (i, x) in [h.x, h.y].into_iter().enumerate() {
        if x <= 0.0 {
            let code = if x < 0.0 { "negative-extent" } else { "degenerate" };
            return Err(ShapeError::at(code, "half_extents", i, format!("expected more than 0, got {x}")));
        }
    }
    Ok(h)
}
