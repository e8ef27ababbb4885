//! Colours of an SVG: presentation attributes, and the style sheet that lets a page set them.
//!
//! A page sets `--tracefig-a: …` and so on; where it does not, the fallback in `var()` is the attribute's own
//! colour. The sheet stands in `@media` as renderers that can't do `var()` skip such blocks and keep the
//! attributes.

use std::collections::BTreeSet;

use super::super::number;
use super::super::xml::Xml;
use super::Document;
use super::tint::{self, Tints, hex};
use crate::drawing::{Cap, Color, Dark, Drawing, Halo, Item, Paint, Role, Stroke};
use crate::typeset::Glyph;

/// A property that takes a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Property {
    /// The colour of an area, and of glyphs that are as dark as their role's lines.
    Fill,
    /// The colour of glyphs where their role's own is too pale to read.
    Words,
    /// A fill as faint as the theme's areas, whose opacity a page may set too.
    Area,
    /// The colour of a line.
    Stroke,
    /// Fill and stroke in one colour.
    Halo,
}

impl Property {
    /// Whether a fill is a [`Property::Fill`] or a [`Property::Area`].
    pub(super) fn of_fill(paint: &Paint, fill_opacity: f64) -> Self {
        if paint.opacity < 1.0 && paint.opacity == fill_opacity { Self::Area } else { Self::Fill }
    }

    /// Whether the glyphs of a role are a [`Property::Fill`] or [`Property::Words`].
    pub(super) fn of_words(paint: &Paint, words: &[(Role, Color)]) -> Self {
        if words.iter().any(|&(role, _)| paint.role == Some(role)) { Self::Words } else { Self::Fill }
    }

    /// The word for it in a class; the most frequent ones are letters.
    fn class(self) -> &'static str {
        match self {
            Self::Fill => "f",
            Self::Words => "words",
            Self::Stroke => "s",
            Self::Area => "area",
            Self::Halo => "halo",
        }
    }
}

/// What a drawing uses of things that are written once, in order.
#[derive(Default)]
pub(super) struct Used {
    /// Glyphs with ink.
    pub(super) glyphs: BTreeSet<Glyph>,
    /// Which properties play which role, with the colour that the theme has for it.
    paints: BTreeSet<(Role, Property, [u8; 3])>,
    /// Opacity of the fills of areas.
    fill_opacity: f64,
    /// The roles whose words have a colour of their own, with that colour.
    words: Vec<(Role, Color)>,
    /// What halos lie on.
    tints: Tints,
}

impl Used {
    /// All that a drawing uses.
    pub(super) fn by(drawing: &Drawing) -> Self {
        let words = drawing.words.clone();
        let tints = Tints::on(drawing.background.color, drawing.fill_opacity);
        let mut used = Self { fill_opacity: drawing.fill_opacity, words, tints, ..Self::default() };
        used.paint(Property::Fill, Some(&drawing.background).filter(|_| !drawing.is_transparent()));
        used.items(&drawing.items);
        used
    }

    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.items(&group.items),
                Item::Path(path) => {
                    if let Some(fill) = &path.fill {
                        self.paint(Property::of_fill(fill, self.fill_opacity), Some(fill));
                    }
                    self.paint(Property::Stroke, path.stroke.as_ref().map(|s| &s.paint));
                    self.paint(Property::Stroke, path.pattern.as_ref().map(|p| &p.paint));
                }
                Item::Text(text) => {
                    let seen = Some(&text.paint).filter(|paint| paint.opacity > 0.0);
                    self.paint(Property::of_words(&text.paint, &self.words), seen);
                    if let Some(halo) = &text.halo {
                        self.tints.add(halo);
                        self.paint(Property::Halo, Some(&halo.paint).filter(|_| halo.areas.is_empty()));
                    }
                    let inked = text.line.glyphs.iter().map(|g| g.glyph);
                    self.glyphs.extend(inked.filter(|g| !g.outline().segments.is_empty()));
                }
            }
        }
    }

    fn paint(&mut self, property: Property, paint: Option<&Paint>) {
        if let Some(Paint { role: Some(role), color: Color { r, g, b }, .. }) = paint {
            self.paints.insert((*role, property, [*r, *g, *b]));
        }
    }
}

impl Document {
    /// The style sheet: one block for all, and one for readers whose system is dark where the drawing has
    /// such colours.
    pub(super) fn style(&mut self, used: &Used, dark: Option<&Dark>) {
        let mut sheet = String::from("@media all{");
        for &(role, property, [r, g, b]) in &used.paints {
            self.rule(&mut sheet, role, property, Color { r, g, b }, used.fill_opacity);
        }
        used.tints.plain(&mut sheet, &self.prefix, None);
        sheet.push('}');
        if let Some(dark) = dark {
            sheet.push_str("@media (prefers-color-scheme:dark){");
            for &(role, property, _) in &used.paints {
                let colors = if property == Property::Words { &dark.words } else { &dark.colors };
                if let Some(&(_, color)) = colors.iter().find(|(r, _)| *r == role) {
                    self.rule(&mut sheet, role, property, color, dark.fill_opacity);
                }
            }
            used.tints.plain(&mut sheet, &self.prefix, Some(dark));
            sheet.push('}');
        }
        used.tints.mixed(&mut sheet, &self.prefix, dark);
        self.xml.start("style");
        self.xml.text(&sheet);
        self.xml.end();
    }

    /// Appends the rule of a class.
    fn rule(&self, sheet: &mut String, role: Role, property: Property, color: Color, fill_opacity: f64) {
        sheet.push('.');
        class(sheet, &self.prefix, role, property);
        sheet.push('{');
        let names: &[&str] = match property {
            Property::Halo => &["fill", "stroke"],
            Property::Fill | Property::Area | Property::Words => &["fill"],
            Property::Stroke => &["stroke"],
        };
        // Words follow a page that sets their role's colour alone.
        let variables: &[&str] = if property == Property::Words { &["words-", ""] } else { &[""] };
        for (i, name) in names.iter().enumerate() {
            sheet.push_str(if i > 0 { ";" } else { "" });
            sheet.push_str(name);
            sheet.push(':');
            for variable in variables {
                sheet.push_str("var(--tracefig-");
                sheet.push_str(variable);
                sheet.push_str(role.name());
                sheet.push(',');
            }
            hex(sheet, color);
            sheet.extend(variables.iter().map(|_| ')'));
        }
        if property == Property::Area {
            sheet.push_str(";fill-opacity:var(--tracefig-fill-opacity,");
            number::push(sheet, fill_opacity);
            sheet.push(')');
        }
        sheet.push('}');
    }
}

/// Appends the class of a property that plays a role.
fn class(out: &mut String, prefix: &str, role: Role, property: Property) {
    out.push_str(prefix);
    out.push('-');
    out.push_str(property.class());
    out.push('-');
    out.push_str(role.name());
}

/// The class attribute of an element whose properties play these roles.
pub(super) fn class_attribute(xml: &mut Xml, prefix: &str, roles: &[(Property, Option<Role>)]) {
    if roles.iter().all(|(_, role)| role.is_none()) {
        return;
    }
    xml.attribute_by("class", |out| {
        let start = out.len();
        for &(property, role) in roles {
            let Some(role) = role else { continue };
            if out.len() > start {
                out.push(' ');
            }
            class(out, prefix, role, property);
        }
    });
}

/// The class attribute of a halo: that of the page's colour, or of the areas that it lies on.
pub(super) fn halo_class(xml: &mut Xml, prefix: &str, halo: &Halo, fill_opacity: f64) {
    match tint::word(halo, fill_opacity) {
        Some(word) => xml.attribute_by("class", |out| tint::push_class(out, prefix, &word)),
        None if halo.areas.is_empty() => {
            class_attribute(xml, prefix, &[(Property::Halo, halo.paint.role)]);
        }
        None => {}
    }
}

/// A colour attribute, and the opacity where it is not 1.
pub(super) fn paint(xml: &mut Xml, property: Property, paint: &Paint) {
    let names: &[(&str, &str)] = match property {
        Property::Fill | Property::Area | Property::Words => &[("fill", "fill-opacity")],
        Property::Stroke => &[("stroke", "stroke-opacity")],
        Property::Halo => &[("fill", "fill-opacity"), ("stroke", "stroke-opacity")],
    };
    for &(name, opacity) in names {
        xml.attribute_by(name, |out| short_hex(out, paint.color));
        if paint.opacity < 1.0 {
            xml.number(opacity, paint.opacity);
        }
    }
}

/// The attributes of a line.
pub(super) fn stroke(xml: &mut Xml, stroke: &Stroke) {
    paint(xml, Property::Stroke, &stroke.paint);
    xml.number("stroke-width", stroke.width);
    if stroke.cap == Cap::Round {
        xml.attribute("stroke-linecap", "round");
    }
    if !stroke.dash.is_empty() {
        xml.attribute_by("stroke-dasharray", |out| {
            for (i, &length) in stroke.dash.iter().enumerate() {
                if i > 0 {
                    out.push(' ');
                }
                number::push(out, length);
            }
        });
    }
}

/// Appends a colour as short as it can be said: `#fff` for `#ffffff`.
fn short_hex(out: &mut String, color: Color) {
    let start = out.len();
    hex(out, color);
    let digits: Vec<char> = out[start + 1..].chars().collect();
    if digits.chunks(2).all(|pair| pair[0] == pair[1]) {
        out.truncate(start + 1);
        out.extend(digits.iter().step_by(2));
    }
}
