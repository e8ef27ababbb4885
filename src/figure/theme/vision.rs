//! How different two colours look, also to readers who do not see all of them.
//!
//! Colour blindness is simulated by the matrices of Machado, Oliveira, Fernandes, "A Physiologically-based Model for
//! Simulation of Color Vision Deficiency", IEEE TVCG 15(6), 2009, severity 1, on linear light. The difference is
//! CIEDE2000 (Sharma, Wu, Dalal, "The CIEDE2000 Color-Difference Formula", Color Research and Application 30(1), 2005).

use std::f64::consts::TAU;

use crate::drawing::Color;

use super::contrast::linear;

/// A reader's colour vision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vision {
    /// Of most.
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
    pub const ALL: [Self; 4] = [Self::Normal, Self::Protan, Self::Deutan, Self::Tritan];

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

/// The difference of two colours (ΔE2000) for the worst of the four visions.
#[must_use]
pub fn worst_difference(a: Color, b: Color) -> f64 {
    Vision::ALL.into_iter().map(|v| difference(a, b, v)).fold(f64::INFINITY, f64::min)
}

/// The difference of two colours (ΔE2000) as one vision sees them; 1 is just noticeable.
#[must_use]
pub fn difference(a: Color, b: Color, vision: Vision) -> f64 {
    delta_e(lab(a, vision), lab(b, vision))
}

/// CIELAB, D65.
fn lab(color: Color, vision: Vision) -> [f64; 3] {
    let [r, g, b] = linear(color);
    let seen = vision.matrix().map(|row| (row[0] * r + row[1] * g + row[2] * b).clamp(0.0, 1.0));
    let [r, g, b] = seen;
    let xyz = [
        (0.412_456_4 * r + 0.357_576_1 * g + 0.180_437_5 * b) / 0.950_47,
        0.212_672_9 * r + 0.715_152_2 * g + 0.072_175_0 * b,
        (0.019_333_9 * r + 0.119_192_0 * g + 0.950_304_1 * b) / 1.088_83,
    ];
    let f =
        xyz.map(|t| if t > 216.0 / 24389.0 { libm::cbrt(t) } else { (24389.0 / 27.0 * t + 16.0) / 116.0 });
    [116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])]
}

/// √(x⁷ / (x⁷ + 25⁷)).
fn chroma_share(x: f64) -> f64 {
    let seventh = libm::pow(x, 7.0);
    libm::sqrt(seventh / (seventh + libm::pow(25.0, 7.0)))
}

/// Mean hue and hue difference, radians; the paper's equations 10 and 14.
fn hues(h1: f64, h2: f64, grey: bool) -> (f64, f64) {
    if grey {
        return (h1 + h2, 0.0);
    }
    let (turn, sum) = (h2 - h1, h1 + h2);
    if turn.abs() <= 0.5 * TAU {
        return (0.5 * sum, turn);
    }
    let mean = if sum < TAU { 0.5 * (sum + TAU) } else { 0.5 * (sum - TAU) };
    (mean, if turn > 0.0 { turn - TAU } else { turn + TAU })
}

/// CIEDE2000, with the paper's letters.
fn delta_e(p: [f64; 3], q: [f64; 3]) -> f64 {
    let c_mean = 0.5 * (libm::hypot(p[1], p[2]) + libm::hypot(q[1], q[2]));
    let g = 0.5 * (1.0 - chroma_share(c_mean));
    let polar = |lab: [f64; 3]| {
        let a = (1.0 + g) * lab[1];
        let angle = libm::atan2(lab[2], a);
        (libm::hypot(a, lab[2]), if angle < 0.0 { angle + TAU } else { angle })
    };
    let ((c1, h1), (c2, h2)) = (polar(p), polar(q));
    let (h, dh) = hues(h1, h2, c1 * c2 == 0.0);
    let (l, c) = (0.5 * (p[0] + q[0]), 0.5 * (c1 + c2));
    let cos = |k: f64, degrees: f64| libm::cos(k * h + degrees.to_radians());
    let t =
        1.0 - 0.17 * cos(1.0, -30.0) + 0.24 * cos(2.0, 0.0) + 0.32 * cos(3.0, 6.0) - 0.20 * cos(4.0, -63.0);
    let bump = (h.to_degrees() - 275.0) / 25.0;
    let theta = 30.0_f64.to_radians() * libm::exp(-bump * bump);
    let l50 = (l - 50.0) * (l - 50.0);
    let dl = (q[0] - p[0]) / (1.0 + 0.015 * l50 / libm::sqrt(20.0 + l50));
    let dc = (c2 - c1) / (1.0 + 0.045 * c);
    let dh = 2.0 * libm::sqrt(c1 * c2) * libm::sin(0.5 * dh) / (1.0 + 0.015 * c * t);
    let rt = -libm::sin(2.0 * theta) * 2.0 * chroma_share(c);
    libm::sqrt(dl * dl + dc * dc + dh * dh + rt * dc * dh)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Role;
    use crate::figure::theme::contrast::{blend, contrast};
    use crate::figure::theme::{Side, THEMES, Theme};

    /// Every theme, and the dark side of those that have one.
    fn palettes() -> Vec<(String, Theme)> {
        let mut all: Vec<_> = THEMES.iter().map(|t| (t.name.to_owned(), t.clone())).collect();
        for theme in THEMES {
            if let Some(Side { colors, fill_opacity }) = theme.dark {
                all.push((format!("{}, dark", theme.name), Theme { colors, fill_opacity, ..theme.clone() }));
            }
        }
        all
    }

    const SHOWN: [Role; 5] = [Role::A, Role::B, Role::Difference, Role::Now, Role::Translation];

    #[test]
    fn the_formula_gives_the_published_differences() {
        // Sharma, Wu, Dalal 2005, table 1, rows 1, 7, 15, 17, 25.
        for (p, q, expected) in [
            ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
            ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
            ([50.0, -0.001, 2.49], [50.0, 0.0011, -2.49], 4.7461),
            ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
            ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
        ] {
            assert!(
                (delta_e(p, q) - expected).abs() < 1e-4,
                "{p:?} {q:?}: {} is not {expected}",
                delta_e(p, q)
            );
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
    fn every_text_colour_is_readable_on_the_page_and_ink_on_every_fill() {
        let mut bad = Vec::new();
        for (name, theme) in palettes() {
            let page = theme.color(Role::Background);
            for role in SHOWN.into_iter().chain([Role::Ink, Role::Muted]) {
                let ratio = contrast(theme.color(role), page);
                if ratio < 4.5 {
                    bad.push(format!("{name}: {role:?} on the page {ratio:.2}"));
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
