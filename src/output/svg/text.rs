//! Text of an SVG: outlines written once, used where they stand.
//!
//! A line is a group of `<use>` elements in thousandths of an em, a group for each size. Where it has a halo,
//! the group is drawn twice: first stroked wide in the halo's colour, then, by reference, filled if its
//! letters are seen.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::super::number;
use super::style::{self, Property};
use super::{Document, contour};
use crate::drawing::{Halo, Point, Text};
use crate::typeset::{Face, Glyph, Line, PlacedGlyph, Rule, UNITS_PER_EM};

// At most one for each glyph of the embedded faces.
thread_local! { static PATHS: RefCell<BTreeMap<Glyph, Rc<str>>> = RefCell::default(); }

impl Document {
    /// The outlines of all glyphs that the drawing uses.
    pub(super) fn glyphs(&mut self, glyphs: &BTreeSet<Glyph>) {
        if glyphs.is_empty() {
            return;
        }
        self.xml.start("defs");
        for &glyph in glyphs {
            self.xml.start("path");
            let prefix = &self.prefix;
            self.xml.attribute_by("id", |out| push_glyph_id(out, prefix, glyph));
            self.xml.attribute_by("d", |out| out.push_str(&path_data(glyph)));
            self.xml.end();
        }
        self.xml.end();
    }

    pub(super) fn text(&mut self, text: &Text) {
        if text.line.glyphs.is_empty() && text.line.rules.is_empty() {
            return;
        }
        let Some(halo) = &text.halo else {
            self.xml.start("g");
            self.fill(text);
            self.line(&text.line, text.origin, None);
            self.xml.end();
            return;
        };
        let id = self.new_id("t");
        self.xml.start("g");
        style::halo_class(&mut self.xml, &self.prefix, halo, self.fill_opacity);
        style::paint(&mut self.xml, Property::Halo, &halo.paint);
        self.xml.start("g");
        self.xml.attribute("id", &id);
        self.line(&text.line, text.origin, Some(halo));
        self.xml.end();
        self.xml.end();
        if text.paint.opacity == 0.0 {
            return;
        }
        self.xml.start("use");
        self.xml.attribute_by("xlink:href", |out| {
            out.push('#');
            out.push_str(&id);
        });
        self.fill(text);
        self.xml.end();
    }

    fn fill(&mut self, text: &Text) {
        let property = Property::of_words(&text.paint, &self.words);
        style::class_attribute(&mut self.xml, &self.prefix, &[(property, text.paint.role)]);
        style::paint(&mut self.xml, Property::Fill, &text.paint);
    }

    /// Glyphs by size, then rules. Inside a scaled group a stroke's width is scaled too, so it is given
    /// there.
    fn line(&mut self, line: &Line, origin: Point, halo: Option<&Halo>) {
        for run in line.glyphs.chunk_by(|a, b| a.size == b.size) {
            let factor = run[0].size / UNITS_PER_EM;
            self.xml.start("g");
            self.xml.attribute_by("transform", |out| {
                out.push_str("translate(");
                number::push(out, origin.x);
                out.push(' ');
                number::push(out, origin.y);
                out.push_str(")scale(");
                number::push_factor(out, factor);
                out.push(')');
            });
            if let Some(halo) = halo {
                // In units, as the places of the glyphs are.
                self.xml.number("stroke-width", (2.0 * halo.width / factor).round());
            }
            for placed in run {
                self.glyph(placed, factor);
            }
            self.xml.end();
        }
        for rule in &line.rules {
            self.rule_element(rule, origin, halo);
        }
    }

    fn glyph(&mut self, placed: &PlacedGlyph, factor: f64) {
        if placed.glyph.outline().segments.is_empty() {
            return;
        }
        self.xml.start("use");
        let prefix = &self.prefix;
        self.xml.attribute_by("xlink:href", |out| {
            out.push('#');
            push_glyph_id(out, prefix, placed.glyph);
        });
        // A unit is a hundredth of a pixel or less, so whole units are what the eye can see.
        for (name, distance) in [("x", placed.x), ("y", placed.y)] {
            let units = (distance / factor).round();
            if units != 0.0 {
                self.xml.number(name, units);
            }
        }
        self.xml.end();
    }

    fn rule_element(&mut self, rule: &Rule, origin: Point, halo: Option<&Halo>) {
        self.xml.start("rect");
        self.xml.number("x", origin.x + rule.x);
        self.xml.number("y", origin.y + rule.y);
        self.xml.number("width", rule.width);
        self.xml.number("height", rule.height);
        if let Some(halo) = halo {
            self.xml.number("stroke-width", 2.0 * halo.width);
        }
        self.xml.end();
    }
}

/// The path data of a glyph's outline, written at the first call: a page has some eighty glyphs, which are
/// the same in every frame of a figure that moves.
fn path_data(glyph: Glyph) -> Rc<str> {
    PATHS.with_borrow_mut(|paths| {
        let path = paths.entry(glyph).or_insert_with(|| {
            let mut path = String::new();
            contour::outline(&mut path, glyph.outline());
            path.into()
        });
        Rc::clone(path)
    })
}

/// The id of a glyph's outline. The full stop keeps it apart from the ids of groups, which have none.
fn push_glyph_id(out: &mut String, prefix: &str, glyph: Glyph) {
    out.push_str(prefix);
    out.push('.');
    out.push(match glyph.face {
        Face::Regular => 'r',
        Face::Semibold => 's',
        Face::Math => 'm',
    });
    number::push(out, f64::from(glyph.id));
}
