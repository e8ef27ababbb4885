//! A point of the reader's choice, marked, with a text and its coordinates: in the panel's space, or in the
//! frame of a body that takes it along.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Rank, Sketch, Weight};
use crate::figure::text::Decimal;
use crate::geometry::{DVec2, Side};
use crate::scene::Space;
use crate::trace::phrase;

use super::coordinates::coordinates;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "point",
    in_words: phrase(["point", "ein Punkt", "un point", "un punto"]),
    about: "a marked point of your choice, with a text and its coordinates",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[
        OptionSpec {
            name: "at",
            takes: Takes::Point,
            default: "none",
            about: "where, in the world or in configuration space; with `of` in the body's frame",
        },
        OptionSpec {
            name: "of",
            takes: Takes::Bodies,
            default: "none",
            about: "the body that it is a point of, in the world",
        },
        OptionSpec {
            name: "from",
            takes: Takes::Point,
            default: "none",
            about: "where it came from, as `at` is given: an arrow from there",
        },
        OptionSpec {
            name: "text", takes: Takes::Lines, default: "none", about: "markup, `{=…}` for values"
        },
        OptionSpec {
            name: "coordinates",
            takes: Takes::Flag,
            default: "false",
            about: "its coordinates in the panel's space",
        },
    ],
    labels: &[LabelKey { key: "point", about: "text and coordinates of a point of your choice" }],
    needs: "a place `at`; in configuration space no `of`",
    fed: |context, options| Fed::by_the_scene(place(context, options, "at").is_some()),
    draw,
};

/// Where a point of the options is at the panel's moment, and the body that it is of.
fn place(context: &Context, options: &Options, name: &str) -> Option<(DVec2, Option<Side>)> {
    let at = options.point(name)?;
    let Some(&side) = options.of(&[]).first() else { return Some((at, None)) };
    if *context.space == Space::Configuration {
        return None;
    }
    Some((context.pose(side, context.time)?.point(at), Some(side)))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((at, side)) = place(context, options, "at") else { return };
    let role = options.role(side.map_or(Role::Ink, Role::from));
    let marker = if side == Some(Side::B) { Marker::Square } else { Marker::Disc };
    if let Some((from, _)) = place(context, options, "from") {
        sketch.part("way").weight(Weight::Light).arrow_to(from, at, MARKER, Pen::dimension(role));
    }
    sketch.part("point").marker(at, marker, role, MARKER);
    let given = options.words("text").map(<[String]>::to_vec);
    let is_given = given.is_some();
    let mut lines = given.unwrap_or_default();
    if options.flag("coordinates", false) {
        let place = coordinates(sketch, context, at);
        // In a text of the scene nobody else sees to it.
        let place = if is_given { Decimal::of(context.scene).in_formulas(&place) } else { place };
        match lines.last_mut() {
            Some(last) => *last = format!("{last} {place}"),
            None => lines.push(place),
        }
    }
    let label = Label::new("point", "", Anchor::point(at), role).rank(Rank::Point);
    sketch.label(if lines.is_empty() { label } else { Label { lines, is_given, ..label } });
}
