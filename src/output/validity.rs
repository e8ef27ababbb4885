//! What must hold of a drawing before a format begins: a page with pixels, and finite places.

use super::{MOST_PIXELS, Options, OutputError};
use crate::drawing::{Drawing, Item};

/// Farthest place from the page's corner, in page pixels.
///
/// Viewers that draw in single precision, of which there are many, lose sixteenths of a pixel beyond it: a
/// number of 24 bits. The largest page has 4,096.
const FARTHEST: f64 = 1e6;

/// Width and height of the image in pixels.
pub(super) fn image_size(drawing: &Drawing, options: &Options) -> Result<(u32, u32), OutputError> {
    page(drawing)?;
    let (width, height, scale) = (drawing.width, drawing.height, options.scale);
    let (w, h) = ((width * scale).round(), (height * scale).round());
    if !(scale > 0.0 && scale.is_finite() && w >= 1.0 && h >= 1.0) {
        return Err(OutputError::Empty { width, height, scale });
    }
    if w * h > MOST_PIXELS {
        // In hundredths, rounded down, and one less where the sides' own rounding makes that too large.
        let fits = |scale: f64| (width * scale).round() * (height * scale).round() <= MOST_PIXELS;
        let down = ((MOST_PIXELS / (width * height)).sqrt() * 100.0).floor();
        let largest = if fits(down / 100.0) { down / 100.0 } else { (down - 1.0) / 100.0 };
        return Err(OutputError::TooLarge { scale, largest });
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and 2^26")]
    Ok((w as u32, h as u32))
}

/// Refuses an empty page and places that are on no page.
pub(super) fn page(drawing: &Drawing) -> Result<(), OutputError> {
    let (width, height) = (drawing.width, drawing.height);
    if !(width > 0.0 && height > 0.0 && width < FARTHEST && height < FARTHEST) {
        return Err(OutputError::Empty { width, height, scale: 1.0 });
    }
    items(&drawing.items, &[])
}

/// Refuses a list with a place that is on no page; `groups` are the names of those that it is in.
fn items(all: &[Item], groups: &[&str]) -> Result<(), OutputError> {
    for item in all {
        if let Item::Group(inner) = item {
            items(&inner.items, &[groups, &[inner.name.as_str()]].concat())?;
        } else if let Some(r) = item.extent() {
            // A place that is not a number is in no range.
            let inside = |v: f64| v.abs() <= FARTHEST;
            if !(inside(r.x0) && inside(r.y0) && inside(r.x1) && inside(r.y1)) {
                let name = |group: Option<&&str>| (*group.unwrap_or(&"figure")).to_owned();
                let (outer, group) = (name(groups.first()), name(groups.last()));
                return Err(OutputError::NotFinite { outer, group });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::samples::everything;
    use super::*;

    #[test]
    fn the_largest_scale_that_is_named_fits_and_a_larger_one_does_not() {
        for (width, height, largest) in [(4096.0, 4096.0, 2.0), (4096.0, 4095.0, 2.0), (960.0, 540.0, 11.37)]
        {
            let drawing = Drawing { width, height, ..everything() };
            let size = |scale| image_size(&drawing, &Options { scale, ..Options::default() });
            assert_eq!(size(50.0), Err(OutputError::TooLarge { scale: 50.0, largest }));
            assert!(size(largest).is_ok() && size(largest + 0.01).is_err(), "{width} × {height}");
        }
    }
}
