//! The distance of bodies at each of the first steps of an advancement.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch, left_of};
use crate::geometry::DVec2;

use super::{Options, graph};

/// At how many steps the separation is drawn; the later ones are a blur at the contact.
const MOST: usize = 5;

/// How far lengths are moved from each other that would lie in one line, page pixels.
const BESIDE: f64 = 10.0;

/// The least length of a step's separation that is named, page pixels; shorter ones blur at the contact.
const NAMED: f64 = 10.0;

/// Draws the distance at each of the first steps, numbered as the layer "graph" does, as a part of a layer.
pub(super) fn draw(sketch: &mut Sketch, context: &Context, options: &Options, part: &'static str) {
    let role = options.role(Role::Translation);
    // Of bodies that come straight on each length lies in the one before: beside each other all are seen.
    let mut drawn: Vec<([DVec2; 2], f64)> = Vec::new();
    for (k, &time) in (1..=MOST).zip(&context.steps()) {
        let Some(answer) = context.separation_seen(time) else { continue };
        let [p, q] = answer.points;
        let covered = drawn.iter().filter(|(other, _)| runs_along(sketch, answer.points, *other));
        let offset = covered.map(|(_, offset)| offset + BESIDE).fold(0.0, f64::max);
        sketch.since(graph::looked(context, k)).part(part);
        sketch.dimension(p, q, offset, Pen::dimension(role).width(1.5));
        if sketch.on_page(p.distance(q)) >= sketch.fitted(NAMED) {
            let aside = left_of(p, q) * sketch.px(offset);
            let anchor = Anchor::middle(p + aside, q + aside);
            sketch.label(Label::new("s_k", format!("$s_{{{k}}}$"), anchor, role));
            drawn.push((answer.points, offset));
        }
    }
}

/// Whether most of a length lies along another one, page pixels apart.
fn runs_along(sketch: &Sketch, [p, q]: [DVec2; 2], [from, to]: [DVec2; 2]) -> bool {
    let (length, u) = (from.distance(to), (to - from).normalize_or_zero());
    let off = |x: DVec2| sketch.on_page((x - from).perp_dot(u).abs());
    let [near, far] = [p, q].map(|x| (x - from).dot(u));
    let shared = near.max(far).min(length) - near.min(far).max(0.0);
    off(p).max(off(q)) < BESIDE && shared > 0.5 * p.distance(q)
}
