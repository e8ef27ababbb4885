//! The rules of halos on areas: their colour is mixed of the page's and the areas', also where a page sets
//! those.
//!
//! `color-mix` is newer than `var`: where a browser can't do it, a rule without it holds.

use std::collections::BTreeMap;

use super::super::number;
use crate::drawing::{Color, Dark, Halo, Paint, Role};

/// The browsers that mix colours.
const CAN_MIX: &str = "@supports (color:color-mix(in srgb,red,red)){";

/// The areas that halos of a drawing lie on, by the word for them in a class.
#[derive(Default)]
pub(super) struct Tints {
    /// The areas under each, the lowest first.
    areas: BTreeMap<String, Vec<Paint>>,
    /// The page's colour.
    page: Color,
    /// Opacity of the fills of areas, which a page may set.
    fill_opacity: f64,
}

/// The word for the areas under a halo in its class: each with its role, and with thousandths where its
/// opacity is not that of areas. None where it lies on none, or on one whose colour must not follow a page.
pub(super) fn word(halo: &Halo, fill_opacity: f64) -> Option<String> {
    let words = halo.areas.iter().map(|area| {
        let role = area.role?.name();
        let share = (area.opacity * 1000.0).round();
        Some(if area.opacity == fill_opacity { role.to_owned() } else { format!("{role}{share}") })
    });
    words.collect::<Option<Vec<_>>>().filter(|words| !words.is_empty()).map(|words| words.join("-"))
}

impl Tints {
    /// None yet, in a drawing whose page and areas are these.
    pub(super) fn on(page: Color, fill_opacity: f64) -> Self {
        Self { areas: BTreeMap::new(), page, fill_opacity }
    }

    /// Takes up what a halo lies on.
    pub(super) fn add(&mut self, halo: &Halo) {
        if let Some(word) = word(halo, self.fill_opacity) {
            self.areas.entry(word).or_insert_with(|| halo.areas.clone());
        }
    }

    /// Appends the rules for every browser, in the drawing's colours or in others.
    pub(super) fn plain(&self, sheet: &mut String, prefix: &str, dark: Option<&Dark>) {
        let (color, opacity) = self.colors(dark);
        for (word, areas) in &self.areas {
            let page = color(Role::Background, self.page);
            let mixed = areas.iter().fold(page, |under, area| {
                let paint = area.role.map_or(*area, |role| Paint { color: color(role, area.color), ..*area });
                paint.with_opacity(self.opacity_of(area, opacity)).over(under)
            });
            open(sheet, prefix, word);
            sheet.push_str("fill:");
            hex(sheet, mixed);
            sheet.push_str(";stroke:");
            hex(sheet, mixed);
            sheet.push('}');
        }
    }

    /// Appends the rules for browsers that mix colours, which follow the page.
    pub(super) fn mixed(&self, sheet: &mut String, prefix: &str, dark: Option<&Dark>) {
        if self.areas.is_empty() {
            return;
        }
        sheet.push_str(CAN_MIX);
        self.mixes(sheet, prefix, None);
        if dark.is_some() {
            sheet.push_str("@media (prefers-color-scheme:dark){");
            self.mixes(sheet, prefix, dark);
            sheet.push('}');
        }
        sheet.push('}');
    }

    /// Appends a rule for each, with colours to mix.
    fn mixes(&self, sheet: &mut String, prefix: &str, dark: Option<&Dark>) {
        let (color, opacity) = self.colors(dark);
        for (word, areas) in &self.areas {
            open(sheet, prefix, word);
            sheet.push_str("color:");
            for area in areas.iter().rev() {
                let Some(role) = area.role else { continue };
                sheet.push_str("color-mix(in srgb,");
                variable(sheet, role, color(role, area.color));
                sheet.push_str(" calc(100%*");
                let own = self.opacity_of(area, opacity);
                if area.opacity == self.fill_opacity {
                    sheet.push_str("var(--tracefig-fill-opacity,");
                    number::push(sheet, own);
                    sheet.push(')');
                } else {
                    number::push(sheet, own);
                }
                sheet.push_str("),");
            }
            variable(sheet, Role::Background, color(Role::Background, self.page));
            sheet.extend(areas.iter().map(|_| ')'));
            sheet.push_str(";fill:currentColor;stroke:currentColor}");
        }
    }

    /// The colours of the drawing, or those in the dark, with the opacity of areas.
    fn colors<'d>(&self, dark: Option<&'d Dark>) -> (impl Fn(Role, Color) -> Color + 'd, f64) {
        let color = move |role, light| {
            let other = dark.and_then(|dark| dark.colors.iter().find(|(r, _)| *r == role));
            other.map_or(light, |&(_, color)| color)
        };
        (color, dark.map_or(self.fill_opacity, |dark| dark.fill_opacity))
    }

    /// The opacity of an area where areas have this one.
    fn opacity_of(&self, area: &Paint, areas: f64) -> f64 {
        if area.opacity == self.fill_opacity { areas } else { area.opacity }
    }
}

/// Appends the class of a halo on areas.
pub(super) fn push_class(out: &mut String, prefix: &str, word: &str) {
    out.push_str(prefix);
    out.push_str("-under-");
    out.push_str(word);
}

/// Begins the rule of such a class.
fn open(sheet: &mut String, prefix: &str, word: &str) {
    sheet.push('.');
    push_class(sheet, prefix, word);
    sheet.push('{');
}

/// Appends the colour of a role, which a page may set.
fn variable(sheet: &mut String, role: Role, color: Color) {
    sheet.push_str("var(--tracefig-");
    sheet.push_str(role.name());
    sheet.push(',');
    hex(sheet, color);
    sheet.push(')');
}

/// Appends a colour as `#rrggbb`.
pub(super) fn hex(out: &mut String, color: Color) {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let mut bytes = *b"#rrggbb";
    for (place, channel) in bytes[1..].chunks_exact_mut(2).zip([color.r, color.g, color.b]) {
        place.copy_from_slice(&[DIGITS[usize::from(channel >> 4)], DIGITS[usize::from(channel & 15)]]);
    }
    out.push_str(std::str::from_utf8(&bytes).unwrap_or_default());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_mixes_the_areas_over_the_page_and_stands_for_each_kind_of_ground_once() {
        let a = Paint::role(Role::A, Color::hex(0xFF_00_00)).with_opacity(0.14);
        let b = Paint::role(Role::B, Color::hex(0x00_00_FF)).with_opacity(0.5);
        let page = Color::hex(0xFF_FF_FF);
        let halo = |areas: &[Paint]| Halo {
            areas: areas.to_vec(),
            ..Halo::plain(Paint::role(Role::Background, page), 2.5)
        };
        let mut tints = Tints::on(page, 0.14);
        for areas in [&[a][..], &[a], &[], &[a, b]] {
            tints.add(&halo(areas));
        }
        let mut plain = String::new();
        tints.plain(&mut plain, "x", None);
        assert_eq!(
            plain,
            ".x-under-a{fill:#ffdbdb;stroke:#ffdbdb}.x-under-a-b500{fill:#806eed;stroke:#806eed}"
        );
        let mut mixed = String::new();
        tints.mixed(&mut mixed, "x", None);
        let tint = "color-mix(in srgb,var(--tracefig-a,#ff0000) calc(100%*var(--tracefig-fill-opacity,.14)),\
                    var(--tracefig-background,#ffffff))";
        assert!(mixed.contains(&format!(".x-under-a{{color:{tint};")), "{mixed}");
        assert!(mixed.contains(&format!("var(--tracefig-b,#0000ff) calc(100%*.5),{tint})")), "{mixed}");
        assert_eq!(mixed.matches('{').count(), mixed.matches('}').count());
        let mut none = String::new();
        Tints::on(page, 0.14).mixed(&mut none, "x", None);
        assert!(none.is_empty());
    }
}
