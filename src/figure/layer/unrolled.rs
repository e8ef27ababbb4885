//! The arcs of a turn straightened: each stands upright where its point is on the way out from the origin, as
//! long as that is far, times the angle, so that all end on one line whose slope is the angle.

use crate::drawing::Role;
use crate::figure::sketch::{
    Anchor, Label, MARKER, Marker, Outline, Pen, Rank, SMALL_MARKER, Size, Sketch, Wash, Weight,
};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};

use super::Options;
use super::half_extents::ON_LINE;
use super::turn::{BELOW, FAN, SECTOR, Turn, rungs};

/// Draws every arc of the sector straight and upright, where its point is on the way out from the origin: as
/// long as that is far, times the angle, up to the longest. That one is named, and that of a nearer point.
pub(super) fn unrolled(sketch: &mut Sketch, options: &Options, t: &Turn, nearer: Option<f64>) {
    let out = |radius: f64| t.center + DVec2::X * radius;
    let up = |radius: f64| out(radius) + DVec2::Y * (radius * t.sweep.abs());
    let slice = Outline::polygon(&[t.center, out(t.radius), up(t.radius)]);
    sketch.part("sector").area(&slice, Some(Wash::faint(Role::Muted, SECTOR)), None);
    for end in [out(t.radius), up(t.radius)] {
        sketch.part("radii").weight(Weight::Light).line(t.center, end, Pen::construction());
    }
    if options.flag("fan", false) {
        sketch.part("fan").weight(Weight::Light);
        for radius in rungs(t, nearer) {
            sketch.line(out(radius), up(radius), Pen::dimension(t.side.into()).opacity(FAN));
        }
    }
    let anchor = Anchor::middle(out(0.0), up(t.radius));
    let slope = Label::new("slope", r"slope $\theta$: every arc ends here", anchor, Role::Muted);
    sketch.label(slope.rank(Rank::Word).size(Size::Note));
    let accent = options.role(Role::Now);
    let longest = (t.radius, ["p", "r", "L"], BELOW[1], Pen::highlighted(accent));
    let shorter = nearer.map(|radius| (radius, ["q", "r_q", "L_q"], BELOW[0], Pen::vector(t.side.into())));
    let marker = if t.side == Side::A { Marker::Disc } else { Marker::Square };
    for (radius, [before, r, l], below, pen) in std::iter::once(longest).chain(shorter) {
        let (from, to) = (out(radius), up(radius));
        sketch.part("arc").arrow(from, to, pen);
        sketch.part("extreme-point").marker(from, marker, t.side.into(), MARKER);
        let anchor = Anchor::point_toward(from, DVec2::X);
        sketch.label(Label::new(before, format!("${before}$"), anchor, Role::Ink).rank(Rank::Point));
        let offset = sketch.fitted(below);
        sketch.part("radius").dimension(t.center, from, -offset, Pen::dimension(Role::Ink));
        let text = format!("${r} = {}$", number(radius));
        let beside = Anchor::Beside { from, to: t.center, offset };
        sketch.label(Label::new(r, text, beside, Role::Ink));
        let length = number(radius * t.sweep.abs());
        let text = if l == "L" {
            format!(r"$L = \theta\,r = {length}$")
        } else {
            format!(r"$\theta\,r_q = {length}$")
        };
        let beside = Anchor::Beside { from: to, to: from, offset: ON_LINE };
        sketch.label(Label::new(l, text, beside, pen.role));
    }
    sketch.part("center").marker(t.center, Marker::Disc, Role::Ink, SMALL_MARKER);
}
