//! The nearest colour that would do: searched in CIELAB, outward from the colour that does not.
//!
//! Steps of lightness and chroma cost what they are long, steps of hue twice that, as the blue of a brand
//! should stay a blue: with Δh the part of a step that turns the hue (ΔH² = Δa² + Δb² − ΔC²),
//!
//! ```text
//! cost² = ΔL² + ΔC² + 4 ΔH²
//! ```
//!
//! A lattice around the colour is walked in the order of its costs, and the way back from the first point
//! that does is halved until the next step would not do. The same search gives the same colour everywhere.

use palette::convert::FromColorUnclamped;
use palette::white_point::D65;
use palette::{Lab, LinSrgb, Srgb};

use crate::drawing::Color;
use crate::geometry::sort_by;

use super::contrast::{contrast, linear};

/// The mesh of the lattice in units of CIELAB, half of the least difference that two roles may have. At twice
/// the mesh narrow gaps between other colours are missed; at half of it a search takes eight times as long.
const MESH: f64 = 4.0;
/// How many meshes the lattice reaches to each side: further than from black to white.
const REACH: i8 = 26;
/// How often the way back is halved: a mesh in 32 parts, which no 8 bits of a channel show.
const HALVINGS: usize = 8;
/// What a step of hue costs, squared, against one of lightness.
const HUE: f64 = 4.0;
/// The step of lightness by which a readable shade is sought, of 100.
const LIGHTNESS: f64 = 0.5;

/// A colour in CIELAB under D65.
type Place = Lab<D65, f64>;

/// Where a colour lies.
fn place(color: Color) -> Place {
    Lab::from_color_unclamped(linear(color))
}

/// The colour at a place, to 8 bits a channel; `None` outside of what sRGB shows.
fn shown(place: Place) -> Option<Color> {
    let light = LinSrgb::<f64>::from_color_unclamped(place);
    // Half a step of 255 in the dark, so that colours of the gamut's own surface count.
    let slack = -1e-4..=1.0001;
    if ![light.red, light.green, light.blue].iter().all(|c| slack.contains(c)) {
        return None;
    }
    let clamped =
        LinSrgb::new(light.red.clamp(0.0, 1.0), light.green.clamp(0.0, 1.0), light.blue.clamp(0.0, 1.0));
    let Srgb { red, green, blue, .. } = Srgb::<f64>::from_linear(clamped).into_format::<u8>();
    Some(Color { r: red, g: green, b: blue })
}

/// What the way to a place costs, squared.
fn cost(from: Place, to: Place) -> f64 {
    let chroma = |p: Place| (p.a * p.a + p.b * p.b).sqrt();
    let (dl, da, db) = (to.l - from.l, to.a - from.a, to.b - from.b);
    let dc = chroma(to) - chroma(from);
    let dh = (da * da + db * db - dc * dc).max(0.0);
    dl * dl + dc * dc + HUE * dh
}

/// The nearest colour that passes; the colour itself where it does, `None` where none of the lattice does.
pub(super) fn nearest(color: Color, passes: impl Fn(Color) -> bool) -> Option<Color> {
    if passes(color) {
        return Some(color);
    }
    let from = place(color);
    let steps = || (-REACH..=REACH).map(|i| MESH * f64::from(i));
    let mut lattice: Vec<(f64, Place)> = steps()
        .flat_map(|dl| steps().map(move |da| (dl, da)))
        .flat_map(|(dl, da)| steps().map(move |db| Lab::new(from.l + dl, from.a + da, from.b + db)))
        .filter(|to| (0.0..=100.0).contains(&to.l))
        .map(|to| (cost(from, to), to))
        .collect();
    sort_by(&mut lattice, |(p, _), (q, _)| p.total_cmp(q));
    let (found, at) =
        lattice.into_iter().find_map(|(_, to)| Some((shown(to).filter(|&c| passes(c))?, to)))?;
    Some(nearer(from, at, found, passes))
}

/// The last colour that passes on the way back from `at`, where `found` does, to `from`.
fn nearer(from: Place, at: Place, found: Color, passes: impl Fn(Color) -> bool) -> Color {
    let (mut bad, mut good, mut best) = (0.0, 1.0, found);
    for _ in 0..HALVINGS {
        let t = 0.5 * (bad + good);
        let on = |p: f64, q: f64| p + t * (q - p);
        let between = Lab::new(on(from.l, at.l), on(from.a, at.a), on(from.b, at.b));
        match shown(between).filter(|&c| passes(c)) {
            Some(color) => (good, best) = (t, color),
            None => bad = t,
        }
    }
    best
}

/// The colour, or its shade of the same hue that has a contrast of `least` against all of the grounds: darker
/// or lighter, whichever is nearer, and as colourful as sRGB lets it be. Up to 4.5 every single ground has
/// one; several may have none.
pub(super) fn readable(color: Color, grounds: &[Color], least: f64) -> Option<Color> {
    let passes = |shade: &Color| grounds.iter().all(|&ground| contrast(*shade, ground) >= least);
    if passes(&color) {
        return Some(color);
    }
    let from = place(color);
    let mut step = 0.0;
    while step < 100.0 {
        step += LIGHTNESS;
        let shades = [from.l - step, from.l + step].map(|l| l.clamp(0.0, 100.0));
        if let Some(shade) = shades.into_iter().filter_map(|l| vivid(from, l)).find(passes) {
            return Some(shade);
        }
    }
    None
}

/// The most colourful colour of this hue at another lightness, and no more colourful than `from`.
fn vivid(from: Place, l: f64) -> Option<Color> {
    let at = |share: f64| shown(Lab::new(l, share * from.a, share * from.b));
    let (mut inside, mut outside) = (0.0, 1.0);
    if let Some(all) = at(outside) {
        return Some(all);
    }
    for _ in 0..HALVINGS {
        let share = 0.5 * (inside + outside);
        if at(share).is_some() { inside = share } else { outside = share }
    }
    at(inside)
}

#[cfg(test)]
mod tests {
    use super::super::vision::worst_difference;
    use super::*;

    #[test]
    fn a_colour_that_passes_stays_and_one_that_does_not_moves_no_further_than_it_must() {
        let [blue, near] = [0x1F_77_B4, 0x0B_5F_CC].map(Color::hex);
        let passes = |c: Color| worst_difference(c, near) >= 9.0;
        assert_eq!(nearest(blue, |_| true), Some(blue));
        assert_eq!(nearest(blue, |_| false), None);
        let moved = nearest(blue, passes).unwrap();
        assert!(passes(moved) && worst_difference(moved, near) < 9.5, "{moved:?}");
        assert!(worst_difference(moved, blue) < 12.0, "{moved:?}");
    }

    #[test]
    fn every_colour_has_a_readable_shade_on_every_page_and_keeps_its_hue() {
        let hue = |c: Color| libm::atan2(place(c).b, place(c).a);
        for page in [0xFF_FF_FF, 0x12_16_1C, 0xFF_D5_00, 0x77_77_77, 0x00_2B_36].map(Color::hex) {
            for color in [0xE6_9F_00, 0x56_B4_E9, 0xF0_E4_42, 0x1F_77_B4, 0xFF_FF_FF, 0].map(Color::hex) {
                let shade = readable(color, &[page], 4.5).unwrap();
                assert!(contrast(shade, page) >= 4.5, "{color:?} on {page:?}: {shade:?}");
                if contrast(color, page) >= 4.5 {
                    assert_eq!(shade, color);
                }
                let lab = place(shade);
                if lab.a.abs() + lab.b.abs() > 10.0 {
                    assert!((hue(shade) - hue(color)).abs() < 0.05, "{color:?} on {page:?}: {shade:?}");
                }
            }
        }
    }

    #[test]
    fn a_pale_orange_is_darkened_and_not_greyed() {
        let white = Color::hex(0xFF_FF_FF);
        assert_eq!(readable(Color::hex(0xE6_9F_00), &[white], 4.5), Some(Color::hex(0x9E_6C_00)));
    }
}
