//! How a figure differs in numbers, for programs that read a report.

use serde_json::{Map, Value, json};

use super::{Element, PixelDrift, TOLERANCES};

/// The numbers of a finding.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measured {
    /// Bytes of the file on disk and of the one that its scene gives now.
    pub bytes: [usize; 2],
    /// How the pixels differ, where both are pictures and do.
    pub pixels: Option<PixelDrift>,
    /// The named elements in the changed area.
    pub elements: Vec<Element>,
}

impl Measured {
    /// The numbers as JSON, as [`super::report::json`] has them. Boxes are left, top, right, bottom: of
    /// pixels in dots of the image, of elements in page pixels.
    ///
    /// ```
    /// use tracefig::drift::Measured;
    /// let measured = Measured { bytes: [10, 12], ..Measured::default() };
    /// assert_eq!(measured.json()["bytes"]["actual"], 12);
    /// assert!(measured.json()["pixels"].is_null());
    /// ```
    #[must_use]
    pub fn json(&self) -> Value {
        let pixels = self.pixels.as_ref().map(|drift| {
            let (expected, actual) = (drift.expected_size, drift.actual_size);
            let counts = TOLERANCES.iter().zip(drift.beyond).map(|(t, n)| (t.to_string(), json!(n)));
            json!({
                "expected": [expected.0, expected.1],
                "actual": [actual.0, actual.1],
                "differ": drift.changed,
                "worst": drift.worst,
                "beyond": counts.collect::<Map<_, _>>(),
                "box": drift.area,
            })
        });
        let elements = self.elements.iter().map(|element| {
            let extent = element.extent;
            let rounded = [extent.x0, extent.y0, extent.x1, extent.y1].map(|v| (v * 100.0).round() / 100.0);
            json!({ "name": element.name, "box": rounded })
        });
        json!({
            "bytes": { "expected": self.bytes[0], "actual": self.bytes[1] },
            "pixels": pixels,
            "elements": elements.collect::<Vec<_>>(),
        })
    }
}
