//! What the panel's theme makes of roles, pens, washes and sizes.

use crate::drawing::{Cap, Paint, Pattern, Role, Stroke};

use super::{Dash, Pen, Sketch, Wash};

/// How opaque the area of B ⊖ A is against those of bodies: it is as large as both of them together, and at
/// the same opacity it would be what is seen first.
const LARGE: f64 = 0.75;

impl Sketch<'_> {
    /// The opaque paint of a role.
    pub(super) fn paint(&self, role: Role) -> Paint {
        self.theme.paint(role)
    }

    /// The paint of an area.
    pub(super) fn wash(&self, wash: Wash) -> Paint {
        let large = if wash.role == Role::Difference { LARGE } else { 1.0 };
        self.paint(wash.role).with_opacity(wash.opacity.unwrap_or(large * self.theme.fill_opacity))
    }

    /// The pattern over an area, where the theme has one for its role.
    pub(super) fn pattern(&self, wash: Wash) -> Option<Pattern> {
        let kind = self.theme.pattern(wash.role).filter(|_| wash.opacity.is_none())?;
        Some(Pattern { kind, paint: self.paint(wash.role).with_opacity(self.theme.pattern_opacity) })
    }

    /// The width of a pen's line in this theme, page pixels on the usual page.
    pub(super) fn width(&self, pen: Pen) -> f64 {
        pen.width * self.theme.strokes.factor(pen.kind)
    }

    /// The paint of a role's words.
    pub(super) fn word_paint(&self, role: Role) -> Paint {
        self.theme.word_paint(role)
    }

    /// The stroke of a pen, as wide as fits the page.
    pub(super) fn stroke_of(&self, pen: Pen) -> Stroke {
        let cap = if pen.round || pen.dash == Dash::Dotted { Cap::Round } else { Cap::Butt };
        let paint = self.paint(pen.role).with_opacity(pen.opacity);
        let width = self.width(pen);
        let dash = pen.dash.lengths(width).into_iter().map(|d| d * self.unit).collect();
        Stroke { paint, width: width * self.unit, dash, cap }
    }
}
