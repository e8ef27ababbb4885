//! Attributes of an SVG of ours: colours and lines, passed on from a group to what it holds.
//!
//! [`super::super::style`] writes them. What one of the two knows and the other does not makes every figure
//! unreadable, which the round trip of all figures would show.

use roxmltree::Node;
use svgtypes::NumberListParser;

use crate::drawing::{Cap, Color, Paint, Role, Stroke};

/// Every attribute that our writer writes; another one means that somebody else wrote it.
const KNOWN: [&str; 27] = [
    "id",
    "class",
    "data-role",
    "role",
    "aria-label",
    "aria-labelledby",
    "width",
    "height",
    "viewBox",
    "x",
    "y",
    "cx",
    "cy",
    "r",
    "d",
    "href",
    "transform",
    "clip-path",
    "opacity",
    "fill",
    "fill-opacity",
    "stroke",
    "stroke-opacity",
    "stroke-width",
    "stroke-linecap",
    "stroke-linejoin",
    "stroke-dasharray",
];

/// Lengths of dashes and gaps of a line; ours have up to four. Every element that has them keeps its own.
const MOST_DASHES: usize = 8;

/// The attribute of that name as a finite number.
pub(super) fn number(node: Node, name: &str) -> Option<f64> {
    node.attribute(name)?.parse().ok().filter(|v: &f64| v.is_finite())
}

/// What an element is painted with.
#[derive(Clone, Debug, Default)]
pub(super) struct Style {
    /// The colour of areas; `None` where they are empty.
    pub(super) fill: Option<Paint>,
    /// The colour of lines; `None` where there are none.
    stroke: Option<Paint>,
    /// The width of lines in the element's units; 1 where nothing says it.
    width: Option<f64>,
    /// How lines end.
    cap: Cap,
    /// Lengths of dashes and gaps in the element's units; empty for a whole line.
    dash: Vec<f64>,
}

impl Style {
    /// The style of an element in one of this style; `None` where it has attributes that are none of ours.
    pub(super) fn inside(&self, node: Node) -> Option<Self> {
        if !node.attributes().all(|a| KNOWN.contains(&a.name())) {
            return None;
        }
        let mut style = self.clone();
        let classes = node.attribute("class").unwrap_or_default();
        for (name, kinds, slot) in [
            ("fill", &["-f-", "-area-", "-words-", "-halo-"][..], &mut style.fill),
            ("stroke", &["-s-", "-halo-"][..], &mut style.stroke),
        ] {
            if let Some(written) = node.attribute(name) {
                let opacity = format!("{name}-opacity");
                let opacity =
                    if node.has_attribute(opacity.as_str()) { number(node, &opacity)? } else { 1.0 };
                let role = role(classes, kinds);
                *slot = match written {
                    "none" => None,
                    _ => Some(Paint { role, color: color(written)?, opacity }),
                };
            }
        }
        if node.has_attribute("stroke-width") {
            style.width = Some(number(node, "stroke-width")?);
        }
        if let Some(cap) = node.attribute("stroke-linecap") {
            style.cap = if cap == "round" { Cap::Round } else { return None };
        }
        if let Some(dash) = node.attribute("stroke-dasharray") {
            let read: Result<Vec<f64>, _> = NumberListParser::from(dash).take(MOST_DASHES + 1).collect();
            style.dash = read.ok().filter(|lengths| lengths.len() <= MOST_DASHES)?;
        }
        Some(style)
    }

    /// The line of something that is drawn at a scale.
    pub(super) fn stroke(&self, scale: f64) -> Option<Stroke> {
        let dash = self.dash.iter().map(|d| d * scale).collect();
        Some(Stroke { paint: self.stroke?, width: self.width.unwrap_or(1.0) * scale, dash, cap: self.cap })
    }
}

/// The role that a class ends with, after one of these.
fn role(classes: &str, kinds: &[&str]) -> Option<Role> {
    let word =
        classes.split(' ').find_map(|class| kinds.iter().find_map(|kind| Some(class.split_once(kind)?.1)))?;
    Role::ALL.into_iter().find(|role| role.name() == word)
}

/// An opaque colour.
fn color(text: &str) -> Option<Color> {
    let svgtypes::Color { red, green, blue, alpha } = text.parse().ok()?;
    (alpha == u8::MAX).then_some(Color { r: red, g: green, b: blue })
}
