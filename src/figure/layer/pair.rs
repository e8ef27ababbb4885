//! A vertex of A and a vertex of B, and the way from the one to the other: what makes a point of B ⊖ A. In
//! configuration space it is the same way, from the origin.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Rank, Size, Sketch, Weight};
use crate::geometry::{DVec2, Side};
use crate::scene::Space;
use crate::trace::phrase;

use super::coordinates::coordinates;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "pair",
    in_words: phrase(["pair", "ein Paar von Ecken", "une paire de sommets", "un par de vértices"]),
    about: "the way from a vertex of A to one of B, which from the origin leads to a point of B ⊖ A",
    shows: Shows::Anywhere,
    tells: Tells::Built,
    options: &[
        OptionSpec {
            name: "vertices",
            takes: Takes::Counts,
            default: "the first of both",
            about: "their numbers: A's, then B's",
        },
        OptionSpec {
            name: "names",
            takes: Takes::Lines,
            default: "by their numbers",
            about: "what A's vertex and B's are called, in LaTeX",
        },
        OptionSpec {
            name: "coordinates",
            takes: Takes::Flag,
            default: "false",
            about: "writes the coordinates of the points",
        },
        OptionSpec {
            name: "turned",
            takes: Takes::Flag,
            default: "false",
            about: "in the world: the way backwards from B's origin, and B moved along it, for \"grown\"",
        },
    ],
    labels: &[
        LabelKey { key: "pair.A", about: "the vertex of A" },
        LabelKey { key: "pair.B", about: "the vertex of B" },
        LabelKey { key: "pair", about: "the point of B ⊖ A" },
        LabelKey { key: "way", about: "the way in the world" },
        LabelKey { key: "back", about: "the way backwards, with turned" },
        LabelKey { key: "moved", about: "where B's vertex lies on A's, with turned" },
    ],
    needs: "two bodies with the vertices of `vertices`",
    fed: |context, options| Fed::by_the_scene(ends(context, options).is_some()),
    draw,
};

/// A vertex of a body: its number and where it is in the world.
#[derive(Clone, Copy)]
struct End {
    /// The number in the scene.
    index: usize,
    /// The place in the world at the panel's moment.
    at: DVec2,
}

/// The vertices that the scene wants, of A and of B.
fn ends(context: &Context, options: &Options) -> Option<[End; 2]> {
    let counts = options.counts("vertices").unwrap_or(&[]);
    let time = if *context.space == Space::Configuration { context.difference_time() } else { context.time };
    let end = |side, nth: usize| {
        let index = counts.get(nth).copied().unwrap_or(0);
        Some(End { index, at: context.vertex(side, index, time)? })
    };
    Some([end(Side::A, 0)?, end(Side::B, 1)?])
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some([a, b]) = ends(context, options) else { return };
    let role = options.role(Role::Difference);
    let given = options.words("names").unwrap_or(&[]);
    let named = |(nth, side, end): (usize, Side, End)| {
        given.get(nth).cloned().unwrap_or_else(|| context.named(side).point(end.index))
    };
    let [p, q] = [(0, Side::A, a), (1, Side::B, b)].map(named);
    let written = |sketch: &Sketch, name: String, at: DVec2| {
        let place = options.flag("coordinates", false).then(|| coordinates(sketch, context, at));
        place.map_or_else(|| format!("${name}$"), |place| format!("${name} =$ {place}"))
    };
    if *context.space == Space::Configuration {
        let to = b.at - a.at;
        way(sketch, (DVec2::ZERO, Marker::Origin.rim(MARKER)), to, role);
        sketch.marker(to, Marker::Diamond, role, MARKER);
        let text = written(sketch, format!("{q} - {p}"), to);
        let anchor = Anchor::point_toward(to, to);
        sketch.label(Label::new("pair", text, anchor, role).rank(Rank::Point));
        return;
    }
    if options.flag("turned", false) {
        let Some(pose) = context.pose(Side::B, context.time) else { return };
        let Some(outline) = context.outline(Side::B, context.time) else { return };
        let moved = outline.moved(a.at - b.at);
        sketch.part("moved").weight(Weight::Light).area(&moved, None, Some(Pen::ghost(Role::B)));
        let ends = (pose.position, MARKER);
        let to = pose.position - (b.at - a.at);
        way(sketch, ends, to, role);
        // Where B's origin is then.
        sketch.part("moved").marker(to, Marker::Square, Role::B, MARKER);
        let name = format!("{p} - {q}");
        // The way is no place: in a body's frame its numbers would be others.
        let is_world = context.frame().is_none();
        let text = if is_world { written(sketch, name, a.at - b.at) } else { format!("${name}$") };
        let back = Label::new("back", text, Anchor::middle(pose.position, to), role);
        sketch.label(back.rank(Rank::Point));
        sketch.part("moved").marker(a.at, Marker::Disc, Role::A, MARKER);
        let label = Label::new("moved", format!("${q}$ moved to ${p}$"), Anchor::inside(&moved), Role::B);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
        return;
    }
    way(sketch, (a.at, MARKER), b.at, role);
    let label = Label::new("way", format!("${q} - {p}$"), Anchor::middle(a.at, b.at), role);
    sketch.label(label.rank(Rank::Point));
    let ends = [
        ("pair.A", a.at, p, Role::A, Marker::Disc, a.at - b.at),
        ("pair.B", b.at, q, Role::B, Marker::Square, b.at - a.at),
    ];
    for (key, at, name, role, marker, out) in ends {
        sketch.part("pair").marker(at, marker, role, MARKER);
        let text = written(sketch, name, at);
        sketch.label(Label::new(key, text, Anchor::point_toward(at, out), role).rank(Rank::Point));
    }
}

/// Draws the way from a point, and the room that its marker takes, to another.
fn way(sketch: &mut Sketch, (from, clear): (DVec2, f64), to: DVec2, role: Role) {
    let out = (to - from).normalize_or_zero() * sketch.px(clear).min(from.distance(to));
    sketch.part("pair").weight(Weight::Light).arrow_to(from + out, to, MARKER, Pen::vector(role));
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, lines};
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    /// A figure of two boxes with the way from a vertex of the one to a vertex of the other.
    fn said(space: &str, options: &str) -> Result<(Vec<(String, String)>, f64), String> {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 2] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [5, 3] }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'minkowski' }}
            panels = [{{ space = '{space}', view = [-2, -3, 9, 7],
                layers = [{{ layer = 'pair', coordinates = true, {options} }}] }}]"
        );
        let scene = open_text("pair", &text).unwrap().scene;
        let plan = plan(&scene).map_err(|problems| format!("{problems:?}"))?;
        let figure = draw(&plan, plan.theme, "pair");
        let texts = labels(&figure).into_iter().map(|(key, (text, _))| (key.to_owned(), text)).collect();
        let frame = &figure.panels[0].frame;
        let px = (frame.page(DVec2::X) - frame.page(DVec2::ZERO)).length();
        Ok((texts, lines(&figure, "pair")[0] / px))
    }

    #[test]
    fn the_way_is_the_same_in_the_world_and_from_the_origin() {
        // From (-1, -2) to (6, 4): 7 and 6.
        let both = "vertices = [0, 2]";
        let (world, long) = said("world", both).unwrap();
        let texts: Vec<&str> = world.iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(texts, ["$a_0 =$ $(-1, -2)$", "$b_2 =$ $(6, 4)$", "$b_2 - a_0$"]);
        let (named, _) = said("world", "vertices = [0, 2], names = ['p', 'q']").unwrap();
        assert_eq!([&*named[0].1, &*named[1].1], ["$p =$ $(-1, -2)$", "$q =$ $(6, 4)$"]);
        let (turned, _) = said("world", "vertices = [0, 2], turned = true").unwrap();
        assert!(turned.contains(&("back".to_owned(), "$a_0 - b_2 =$ $(-7, -6)$".to_owned())), "{turned:?}");
        let (configuration, _) = said("configuration", both).unwrap();
        assert_eq!(configuration[0].1, "$b_2 - a_0 =$ $(7, 6)$");
        assert!(long < 85.0_f64.sqrt() && long > 8.0, "{long}");
    }

    #[test]
    fn vertices_that_are_not_there_are_refused() {
        assert!(said("world", "vertices = [4, 0]").is_err());
        assert!(said("configuration", "vertices = [0, 7]").is_err());
    }
}
