//! Attributes of an SVG of ours: colours and lines, passed on from a group to what it holds.

use roxmltree::Node;

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

/// The attribute of a name.
pub(super) fn attribute<'n>(node: Node<'n, '_>, name: &str) -> Option<&'n str> {
    node.attribute(name)
}

/// A number of a name.
pub(super) fn number(node: Node, name: &str) -> Option<f64> {
    node.attribute(name)?.parse().ok().filter(|v: &f64| v.is_finite())
}

/// What an element is painted with.
#[derive(Clone, Debug, Default)]
pub(super) struct Style {
    pub(super) fill: Option<Paint>,
    stroke: Option<Paint>,
    width: Option<f64>,
    cap: Cap,
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
            ("fill", ["-f-", "-area-", "-halo-"], &mut style.fill),
            ("stroke", ["-s-", "-halo-", "-halo-"], &mut style.stroke),
        ] {
            if let Some(color) = node.attribute(name) {
                let opacity = format!("{name}-opacity");
                let opacity =
                    if node.has_attribute(opacity.as_str()) { number(node, &opacity)? } else { 1.0 };
                let role = role(classes, &kinds);
                *slot =
                    if color == "none" { None } else { Some(Paint { role, color: hex(color)?, opacity }) };
            }
        }
        if node.has_attribute("stroke-width") {
            style.width = Some(number(node, "stroke-width")?);
        }
        if let Some(cap) = node.attribute("stroke-linecap") {
            style.cap = if cap == "round" { Cap::Round } else { return None };
        }
        if let Some(dash) = node.attribute("stroke-dasharray") {
            style.dash = dash.split(' ').map(|d| d.parse().ok()).collect::<Option<_>>()?;
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

fn hex(text: &str) -> Option<Color> {
    let digits = text.strip_prefix('#').filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit()))?;
    let digits = match digits.len() {
        3 => digits.chars().flat_map(|d| [d, d]).collect(),
        6 => digits.to_owned(),
        _ => return None,
    };
    u32::from_str_radix(&digits, 16).ok().map(Color::hex)
}
