//! Contrast of two colours as WCAG 2.2 defines it: (L₁ + 0.05) / (L₂ + 0.05) of their relative luminances.
//!
//! Source: Web Content Accessibility Guidelines 2.2, "relative luminance" and "contrast ratio". Text needs
//! 4.5 : 1. The guidelines round the weights of luminance to four digits; `palette` has them in seven, which
//! would move one printed ratio in 400, so the weights stand here.

use palette::{LinSrgb, Srgb};

use crate::drawing::Color;

/// The linear light of a colour, channels from 0 to 1.
pub(super) fn linear(Color { r, g, b }: Color) -> LinSrgb<f64> {
    Srgb::new(r, g, b).into_linear()
}

/// Relative luminance, from 0 (black) to 1 (white).
fn luminance(color: Color) -> f64 {
    let LinSrgb { red, green, blue, .. } = linear(color);
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// Contrast ratio, from 1 to 21, whichever of the two is lighter.
///
/// ```
/// use tracefig::{drawing::Color, figure::theme::contrast::contrast};
/// let (black, white) = (Color::hex(0), Color::hex(0xFFFFFF));
/// assert!((contrast(white, black) - 21.0).abs() < 1e-9);
/// assert_eq!(contrast(black, black), 1.0);
/// ```
#[must_use]
pub fn contrast(a: Color, b: Color) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}
