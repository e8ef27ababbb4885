//! Contrast of two colours as WCAG 2.2 defines it: (L₁ + 0.05) / (L₂ + 0.05) of their relative luminances.
//!
//! Source: Web Content Accessibility Guidelines 2.2, "relative luminance" and "contrast ratio". Text needs 4.5 : 1.

use crate::drawing::Color;

/// Linear light of the three channels, from 0 to 1.
#[must_use]
pub fn linear(color: Color) -> [f64; 3] {
    [color.r, color.g, color.b].map(|c| {
        let c = f64::from(c) / 255.0;
        if c <= 0.040_45 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
    })
}

/// Relative luminance, from 0 (black) to 1 (white).
#[must_use]
pub fn luminance(color: Color) -> f64 {
    let [r, g, b] = linear(color);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Contrast ratio, from 1 to 21.
///
/// ```
/// use tracefig::{drawing::Color, figure::theme::contrast::contrast};
/// assert!((contrast(Color::hex(0xFFFFFF), Color::hex(0)) - 21.0).abs() < 1e-9);
/// ```
#[must_use]
pub fn contrast(a: Color, b: Color) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// `over` at `opacity` on `under`, blended in sRGB as every renderer of ours does.
#[must_use]
pub fn blend(over: Color, opacity: f64, under: Color) -> Color {
    let mix = |o: u8, u: u8| {
        let value = (opacity * f64::from(o) + (1.0 - opacity) * f64::from(u)).round().clamp(0.0, 255.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0 … 255")]
        let byte = value as u8;
        byte
    };
    Color { r: mix(over.r, under.r), g: mix(over.g, under.g), b: mix(over.b, under.b) }
}
