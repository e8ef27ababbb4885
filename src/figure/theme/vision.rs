//! How different two colours look, also to readers who do not see all of them.
//!
//! Colour blindness is simulated by the matrices of Machado, Oliveira, Fernandes, "A Physiologically-based
//! Model for Simulation of Color Vision Deficiency", IEEE TVCG 15(6), 2009, severity 1, on linear light. The
//! difference is CIEDE2000 (Sharma, Wu, Dalal, "The CIEDE2000 Color-Difference Formula", Color Research and
//! Application 30(1), 2005) in CIELAB under D65, both by the crate `palette`.

use palette::color_difference::Ciede2000;
use palette::convert::FromColorUnclamped;
use palette::white_point::D65;
use palette::{Lab, LinSrgb};

use crate::drawing::Color;

use super::contrast::linear;

/// A reader's colour vision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Vision {
    /// Trichromatic vision, as most readers have.
    Normal,
    /// Without red cones.
    Protan,
    /// Without green cones.
    Deutan,
    /// Without blue cones.
    Tritan,
}

impl Vision {
    /// All four.
    const ALL: [Self; 4] = [Self::Normal, Self::Protan, Self::Deutan, Self::Tritan];

    /// Machado 2009, table 1, severity 1.0.
    fn matrix(self) -> [[f64; 3]; 3] {
        match self {
            Self::Normal => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            Self::Protan => [
                [0.152_286, 1.052_583, -0.204_868],
                [0.114_503, 0.786_281, 0.099_216],
                [-0.003_882, -0.048_116, 1.051_998],
            ],
            Self::Deutan => [
                [0.367_322, 0.860_646, -0.227_968],
                [0.280_085, 0.672_501, 0.047_413],
                [-0.011_820, 0.042_940, 0.968_881],
            ],
            Self::Tritan => [
                [1.255_528, -0.076_749, -0.178_779],
                [-0.078_411, 0.930_809, 0.147_602],
                [0.004_733, 0.691_367, 0.303_900],
            ],
        }
    }
}

/// The difference of two colours (ΔE2000) for the reader to whom they look most alike; 1 is just noticeable.
///
/// ```
/// use tracefig::{drawing::Color, figure::theme::vision::worst_difference};
/// let [red, green, blue] = [0xC0_00_00, 0x00_80_00, 0x00_00_C0].map(Color::hex);
/// assert!(worst_difference(red, green) < 30.0 && worst_difference(red, blue) > 30.0);
/// ```
#[must_use]
pub fn worst_difference(a: Color, b: Color) -> f64 {
    Vision::ALL.into_iter().map(|v| seen(a, v).difference(seen(b, v))).fold(f64::INFINITY, f64::min)
}

/// To whom two colours look most alike, in words; `None` where that is everybody.
pub(super) fn most_alike_to(a: Color, b: Color) -> Option<&'static str> {
    let apart = |vision: &Vision| seen(a, *vision).difference(seen(b, *vision));
    match Vision::ALL.into_iter().min_by(|v, w| apart(v).total_cmp(&apart(w)))? {
        Vision::Normal => None,
        Vision::Protan => Some("to readers without red cones"),
        Vision::Deutan => Some("to readers without green cones"),
        Vision::Tritan => Some("to readers without blue cones"),
    }
}

/// A colour as one vision sees it.
fn seen(color: Color, vision: Vision) -> Lab<D65, f64> {
    let LinSrgb { red, green, blue, .. } = linear(color);
    let [red, green, blue] =
        vision.matrix().map(|row| (row[0] * red + row[1] * green + row[2] * blue).clamp(0.0, 1.0));
    Lab::from_color_unclamped(LinSrgb::new(red, green, blue))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Role, blend};
    use crate::figure::theme::contrast::contrast;
    use crate::figure::theme::{Side, THEMES, Theme};

    /// Every theme, and the dark side of those that have one.
    fn palettes() -> Vec<(String, Theme)> {
        let mut all: Vec<_> = THEMES.iter().map(|t| (t.name.to_owned(), t.clone())).collect();
        for theme in THEMES {
            if let Some(Side { colors, words, fill_opacity }) = theme.dark {
                let dark = Theme { colors, words, fill_opacity, ..theme.clone() };
                all.push((format!("{}, dark", theme.name), dark));
            }
        }
        all
    }

    const SHOWN: [Role; 5] = [Role::A, Role::B, Role::Difference, Role::Now, Role::Translation];

    #[test]
    fn the_formula_gives_the_published_differences() {
        // Sharma, Wu, Dalal 2005, table 1, rows 1, 7, 15, 17, 25.
        for ([l1, a1, b1], [l2, a2, b2], expected) in [
            ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
            ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
            ([50.0, -0.001, 2.49], [50.0, 0.0011, -2.49], 4.7461),
            ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
            ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
        ] {
            let lab = |l, a, b| Lab::<D65, f64>::new(l, a, b);
            let got = lab(l1, a1, b1).difference(lab(l2, a2, b2));
            assert!((got - expected).abs() < 1e-4, "{got} is not {expected}");
        }
    }

    #[test]
    fn every_theme_tells_a_from_b_and_other_roles_apart_for_every_vision() {
        let mut bad = Vec::new();
        for (name, theme) in palettes() {
            for (i, &p) in SHOWN.iter().enumerate() {
                for &q in &SHOWN[..i] {
                    let limit = if (p, q) == (Role::B, Role::A) { 20.0 } else { 9.0 };
                    let worst = worst_difference(theme.color(p), theme.color(q));
                    if worst < limit {
                        bad.push(format!("{name}: {p:?} {q:?} {worst:.1} < {limit}"));
                    }
                }
            }
        }
        assert!(bad.is_empty(), "{bad:#?}");
    }

    #[test]
    fn where_bodies_overlap_is_a_colour_of_its_own_in_every_theme_for_every_vision() {
        for (name, theme) in palettes() {
            let (page, own) = (theme.color(Role::Background), theme.color(Role::Overlap));
            for role in [Role::A, Role::B, Role::Difference] {
                let fill = blend(theme.color(role), theme.fill_opacity, page);
                // Their outlines lie between; two tints over each other are 4 from B's in print.
                let worst = worst_difference(fill, own);
                assert!(worst >= 6.0, "{name}: {role:?} {worst:.1}");
            }
            assert!(contrast(theme.color(Role::Ink), own) >= 4.5, "{name}");
        }
        // In grey only lightness tells them apart: that of A's and B's areas in print is 93 and 94 of 100.
        let print = THEMES.iter().find(|theme| theme.name == "print").unwrap();
        let lightness = |color| seen(color, Vision::Normal).l;
        let fill = |role| blend(print.color(role), print.fill_opacity, print.color(Role::Background));
        for role in [Role::A, Role::B] {
            assert!(lightness(fill(role)) - lightness(print.color(Role::Overlap)) > 6.0, "{role:?}");
        }
    }

    /// The least contrast of words on bodies and on the difference: that of large text (WCAG 2.2).
    const ON_FILL: f64 = 3.0;

    #[test]
    fn every_text_colour_is_readable_on_the_page_and_ink_on_every_fill() {
        let mut bad = Vec::new();
        for (name, theme) in palettes() {
            let page = theme.color(Role::Background);
            for role in SHOWN.into_iter().chain([Role::Ink, Role::Muted]) {
                let ratio = contrast(theme.color(role), page);
                if ratio < 4.5 || contrast(theme.word_color(role), page) < ratio {
                    bad.push(format!("{name}: {role:?} on the page {ratio:.2}"));
                }
                for area in [Role::A, Role::B, Role::Difference] {
                    let fill = blend(theme.color(area), theme.fill_opacity, page);
                    let ratio = contrast(theme.word_color(role), fill);
                    if ratio < ON_FILL {
                        bad.push(format!("{name}: {role:?} on {area:?} {ratio:.2}"));
                    }
                }
            }
            for role in SHOWN {
                let fill = blend(theme.color(role), theme.fill_opacity, page);
                let ratio = contrast(theme.color(Role::Ink), fill);
                if ratio < 4.5 {
                    bad.push(format!("{name}: ink on {role:?} {ratio:.2}"));
                }
            }
        }
        assert!(bad.is_empty(), "{bad:#?}");
    }
}
