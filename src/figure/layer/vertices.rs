//! The vertices of the bodies with their numbers, as answers name them, or with their coordinates. In
//! configuration space those of B ⊖ A: each is a vertex of B less a vertex of A.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::Difference;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Rank, SMALL_MARKER, Size, Sketch};
use crate::geometry::{DVec2, Side};
use crate::scene::Space;
use crate::trace::phrase;

use super::coordinates::coordinates;
use super::difference::{Origin, difference, origins};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

pub(super) const LAYER: Layer = Layer {
    name: "vertices",
    in_words: phrase(["vertices", "Ecken", "sommets", "vértices"]),
    about: "the vertices with their numbers or coordinates; in configuration space those of B ⊖ A",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[
        OptionSpec {
            name: "of",
            takes: Takes::Bodies,
            default: "all of the query's",
            about: "whose vertices",
        },
        OptionSpec {
            name: "only",
            takes: Takes::Counts,
            default: "all",
            about: "which vertices, by their numbers in the scene; of B ⊖ A those that come from them",
        },
        OptionSpec {
            name: "numbers",
            takes: Takes::Flag,
            default: "true, but false with `coordinates` and in configuration space",
            about: "their numbers, as answers name them; of B ⊖ A those of both",
        },
        OptionSpec {
            name: "coordinates",
            takes: Takes::Flag,
            default: "false, but true in configuration space",
            about: "their coordinates in the panel's space",
        },
    ],
    labels: &[
        LabelKey { key: "vertex.A", about: "number or coordinates of a vertex of A" },
        LabelKey { key: "vertex.B", about: "number or coordinates of a vertex of B" },
        LabelKey { key: "vertex", about: "numbers or coordinates of a vertex of B ⊖ A" },
    ],
    needs: "a body with the vertices of `only`; in configuration space two convex bodies",
    fed: |context, options| {
        let some = match context.space {
            Space::Configuration => !chosen(context, options).is_empty(),
            _ => options.of(&context.sides()).into_iter().any(|side| !own(context, options, side).is_empty()),
        };
        Fed::by_the_scene(some)
    },
    draw,
};

/// The chosen vertices of a body: their numbers, and where they are in the world.
fn own(context: &Context, options: &Options, side: Side) -> Vec<(usize, DVec2)> {
    let count = context.body(side).map_or(0, |body| body.shape.vertices.len());
    let wanted = |k: &usize| options.counts("only").is_none_or(|only| only.contains(k));
    let place = |k| Some((k, context.vertex(side, k, context.time)?));
    (0..count).filter(wanted).filter_map(place).collect()
}

/// The chosen vertices of B ⊖ A, with their neighbours' middle.
fn chosen(context: &Context, options: &Options) -> Vec<Origin> {
    let time = context.difference_time();
    let Some(found) = difference(context, time) else { return Vec::new() };
    let sides = options.of(&context.sides());
    let wanted = |origin: &Origin| {
        options.counts("only").is_none_or(|only| sides.iter().any(|&s| only.contains(&origin.of(s))))
    };
    origins(context, &found, time).into_iter().filter(wanted).collect()
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    if *context.space == Space::Configuration {
        let Some(found) = difference(context, context.difference_time()) else { return };
        return of_difference(sketch, context, options, &found);
    }
    let coordinated = options.flag("coordinates", false);
    let numbered = options.flag("numbers", !coordinated);
    for side in options.of(&context.sides()) {
        let role = options.role(side.into());
        let marker = if side == Side::A { Marker::Disc } else { Marker::Square };
        let middle = middle(context, side);
        // A few that are chosen are what the reader looks for; all of them are the outline's.
        let radius = if options.counts("only").is_some() { MARKER } else { SMALL_MARKER };
        for (k, p) in own(context, options, side) {
            sketch.part(part("vertex", side)).marker(p, marker, role, radius);
            let number = numbered.then(|| k.to_string());
            let key = if side == Side::A { "vertex.A" } else { "vertex.B" };
            label(
                sketch,
                (key, role),
                (p, middle),
                number,
                coordinated.then(|| coordinates(sketch, context, p)),
            );
        }
    }
}

/// Marks and labels the vertices of B ⊖ A.
fn of_difference(sketch: &mut Sketch, context: &Context, options: &Options, found: &Difference) {
    let coordinated = options.flag("coordinates", true);
    let numbered = options.flag("numbers", false);
    let role = options.role(Role::Difference);
    let all: Vec<DVec2> = found.edges.iter().map(|e| e.from).collect();
    let middle = mean(&all);
    let [a, b] = Side::BOTH.map(|side| context.named(side));
    for Origin { at, a: i, b: j } in chosen(context, options) {
        sketch.part("vertex").marker(at, Marker::Diamond, role, SMALL_MARKER);
        let number = numbered.then(|| format!("${} - {}$", b.point(j), a.point(i)));
        let place = coordinated.then(|| coordinates(sketch, context, at));
        label(sketch, ("vertex", role), (at, middle), number, place);
    }
}

/// Labels a vertex with what there is of it, away from the middle of its body.
fn label(
    sketch: &mut Sketch,
    (key, role): (&'static str, Role),
    (at, middle): (DVec2, DVec2),
    number: Option<String>,
    place: Option<String>,
) {
    let text = match (number, place) {
        (Some(number), Some(place)) => format!("{number}: {place}"),
        (number, place) => number.or(place).unwrap_or_default(),
    };
    let anchor = Anchor::Point { at, clear: SMALL_MARKER, toward: (at - middle).normalize_or_zero() };
    sketch.label(Label::new(key, text, anchor, role).rank(Rank::Word).size(Size::Small));
}

/// The middle of a body's vertices, in the world.
fn middle(context: &Context, side: Side) -> DVec2 {
    let count = context.body(side).map_or(0, |body| body.shape.vertices.len());
    let all: Vec<DVec2> = (0..count).filter_map(|k| context.vertex(side, k, context.time)).collect();
    mean(&all)
}

/// The mean of points; 0 of none.
pub(super) fn mean(points: &[DVec2]) -> DVec2 {
    let count = super::number_of(points.len()).max(1.0);
    points.iter().map(|&p| p / count).sum()
}
