//! How a file that `check` looks at differs from what is drawn now: in numbers, and in lines.

use tracefig::drawing::Rect;
use tracefig::drift::{Change, Measured, PixelDrift, elements_in, what_moved};
use tracefig::output::Format;

use super::encoded::Encoded;

/// How a file differs, in numbers.
pub(crate) fn measured(change: &Change, old: &[u8], encoded: &Encoded) -> Measured {
    let pixels = change.pixels().cloned();
    let elements = pixels.as_ref().and_then(|drift| drift.area).map_or_else(Vec::new, |area| {
        let [x0, y0, x1, y1] = area.map(|dots| f64::from(dots) / encoded.options.scale);
        elements_in(&encoded.drawing, Rect { x0, y0, x1, y1 })
    });
    Measured { bytes: [old.len(), encoded.bytes.len()], pixels, elements }
}

/// How a file differs, in lines.
pub(crate) fn details(
    change: &Change,
    (old, format): (&[u8], &Format),
    encoded: &Encoded,
    measured: &Measured,
) -> Vec<String> {
    let mut lines = what_moved(format, old, &encoded.bytes);
    lines.push(change.to_string());
    lines.extend(measured.pixels.as_ref().map(PixelDrift::under_tolerances));
    let names: Vec<&str> = measured.elements.iter().map(|element| element.name.as_str()).collect();
    if !names.is_empty() {
        lines.push(format!("in the changed area: {}", names.join(", ")));
    }
    lines
}
