//! The AABB of a body, or of two together: its corners min and max, its centre, and the vertices that touch
//! its sides.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, MARKER, Marker, Outline, Pen, Rank, Sketch};
use crate::figure::text::Places;
use crate::geometry::{DVec2, Rotation, Side};
use crate::trace::step::bounds;
use crate::trace::{Event, SupportVertex, phrase};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Key, symbol and outward direction of the label at each side: left, bottom, right, top, as the event lists
/// them.
const SIDES: [(&str, &str, DVec2); 4] = [
    ("touching.left", r"x_{\min}", DVec2::NEG_X),
    ("touching.bottom", r"y_{\min}", DVec2::NEG_Y),
    ("touching.right", r"x_{\max}", DVec2::X),
    ("touching.top", r"y_{\max}", DVec2::Y),
];

/// Width of the box's line, page pixels.
const BOX: f64 = 1.75;

pub(super) const LAYER: Layer = Layer {
    name: "bounds",
    in_words: phrase(["bounds", "Bounding-Box", "boîte englobante", "caja envolvente"]),
    about: "the AABB with its corners and centre",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "corners",
            takes: Takes::Flag,
            default: "true",
            about: "marks min, max and the centre",
        },
        OptionSpec {
            name: "touching",
            takes: Takes::Flag,
            default: "true",
            about: "marks where the body touches the edges",
        },
    ],
    labels: &[
        LabelKey { key: "min", about: "corner of smallest coordinates" },
        LabelKey { key: "max", about: "corner of largest coordinates" },
        LabelKey { key: "c", about: "centre" },
        LabelKey { key: "touching.left", about: "where x is smallest" },
        LabelKey { key: "touching.bottom", about: "where y is smallest" },
        LabelKey { key: "touching.right", about: "where x is largest" },
        LabelKey { key: "touching.top", about: "where y is largest" },
    ],
    needs: "a query for bounds",
    fed: |context, _| {
        Fed::by_the_scene(context.run().events().any(|e| matches!(e, Event::BoundsFound { .. })))
    },
    draw,
};

/// A box that the algorithm found.
#[derive(Clone)]
struct Found {
    /// The body that it bounds; `None` for two together.
    of: Option<Side>,
    /// The corner of smallest coordinates, in the world.
    min: DVec2,
    /// The corner of largest coordinates, in the world.
    max: DVec2,
    /// The vertices that touch its left, lower, right and upper side.
    touching: [Vec<SupportVertex>; 4],
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let run = context.run();
    let found: Vec<Found> = run
        .told(|event| match event {
            Event::BoundsFound { of, min, max, touching } => {
                Some(Found { of: *of, min: *min, max: *max, touching: touching.clone() })
            }
            _ => None,
        })
        .collect();
    let Some((last, parts)) = found.split_last() else { return };
    let cue = context.cue(|event| matches!(event, Event::BoundsFound { .. }));
    let at = |part| cue.map(|cue| cue.part(part));
    sketch.since(at(bounds::BOX));
    for part in parts {
        let role = part.of.map_or(Role::Ink, Role::from);
        sketch.part("part-box").area(&rectangle(part), None, Some(Pen::dimension(role)));
    }
    let role = options.role(Role::Ink);
    // Lighter than the body's own outline, round which it is.
    sketch.part("box").area(&rectangle(last), None, Some(Pen::outline(role).width(BOX)));
    if last.min == last.max {
        return of_a_point(sketch, (last, context), role, options);
    }
    if options.flag("touching", true) {
        touching(sketch, last, context, cue);
    }
    if options.flag("corners", true) {
        corners(sketch.since(at(bounds::BOX)), (last, context), role, at(bounds::CENTER));
    }
}

/// The outline of a box.
fn rectangle(found: &Found) -> Outline {
    let (min, max) = (found.min, found.max);
    Outline::polygon(&[min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)])
}

/// Marks the box of a lone point, which has one corner alone.
fn of_a_point(sketch: &mut Sketch, (found, context): (&Found, &Context), role: Role, options: &Options) {
    sketch.part("min").marker(found.min, Marker::Disc, role, MARKER);
    if options.flag("corners", true) {
        let text = format!("min $=$ max $= {}$", place(context, found.min));
        sketch.label(Label::new("min", text, Anchor::point(found.min), role));
    }
}

/// The coordinates of a point of the world in the panel's space, in LaTeX.
fn place(context: &Context, p: DVec2) -> String {
    let places = Places::of(context.scene);
    let [x, y] = context.in_space(p).to_array().map(|value| places.latex(value));
    format!("({x}, {y})")
}

/// Marks the vertices that touch each side; the first of each is named, with its coordinate that is smallest
/// or largest: in a frame that is turned neither is.
fn touching(sketch: &mut Sketch, found: &Found, context: &Context, cue: Option<Cue>) {
    let is_turned = context.frame().is_some_and(|frame| frame.rotation != Rotation::NONE);
    let places = Places::of(context.scene);
    let role = found.of.map_or(Role::Ink, Role::from);
    let marker = if found.of == Some(Side::B) { Marker::Square } else { Marker::Disc };
    for (i, (vertices, (key, symbol, outward))) in found.touching.iter().zip(SIDES).enumerate() {
        sketch.since(cue.map(|cue| cue.part(bounds::TOUCHING + i)));
        // A round body touches a radius out from its vertex.
        let touch = |vertex: &SupportVertex| {
            let edge = if outward.x + outward.y < 0.0 { found.min } else { found.max };
            if outward.x == 0.0 {
                DVec2::new(vertex.point.x, edge.y)
            } else {
                DVec2::new(edge.x, vertex.point.y)
            }
        };
        for vertex in vertices {
            sketch.part("touching").marker(touch(vertex), marker, role, LARGE_MARKER);
        }
        if let Some(first) = vertices.first() {
            let anchor = Anchor::point_toward(touch(first), outward);
            let value = context.in_space(touch(first)).dot(outward.abs());
            let text = if is_turned {
                format!("${symbol}$")
            } else {
                format!("${symbol} = {}$", places.latex(value))
            };
            sketch.label(Label::new(key, text, anchor, Role::Ink).rank(Rank::Point));
        }
    }
}

/// Marks and names the corners min and max and the centre.
fn corners(sketch: &mut Sketch, (found, context): (&Found, &Context), role: Role, middle: Option<Cue>) {
    let center = 0.5 * (found.min + found.max);
    for (key, point) in [("min", found.min), ("max", found.max)] {
        sketch.part(key).marker(point, Marker::Disc, role, MARKER);
        let text = format!("{key} $= {}$", place(context, point));
        let anchor = Anchor::point_toward(point, point - center);
        sketch.label(Label::new(key, text, anchor, role));
    }
    sketch.since(middle).part("center").marker(center, Marker::Cross, role, MARKER);
    sketch.label(Label::new("c", "$c$", Anchor::point(center), role).rank(Rank::Point));
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Contour, Point};
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    #[test]
    fn a_lone_point_stands_in_the_middle_with_one_label() {
        let text = "shapes.A = { kind = 'circle', radius = 0, position = [123456, -98765] }
            query = { kind = 'bounds', of = ['A'] }";
        let scene = open_text("bounds", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "bounds");
        let panel = &figure.panels[0];
        let off = panel.frame.page(DVec2::new(123_456.0, -98_765.0)) - panel.frame.panel.center();
        assert!(off.length() < 1.0, "{off:?}");
        let keys: Vec<_> = panel.placed.iter().map(|label| label.key).collect();
        assert_eq!(keys, ["A", "min"]);
    }

    #[test]
    fn a_round_body_is_marked_where_it_touches_the_box() {
        let text = "shapes.A = { kind = 'capsule', points = [[-1, 0], [1, 0.5]], radius = 0.5 }
            query = { kind = 'bounds', of = ['A'] }\npanels = [{ layers = ['bounds'] }]";
        let scene = open_text("bounds", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "bounds");
        let center = |contour: &Contour| match contour {
            Contour::Circle { center, .. } => *center,
            Contour::Segments(_) => panic!("a disc"),
        };
        let marked = paths(&figure.drawing.items, "touching").into_iter().map(|path| center(&path.contour));
        let marked: Vec<Point> = marked.collect();
        let expected = [[-1.5, 0.0], [-1.0, -0.5], [1.5, 0.5], [1.0, 1.0]].map(DVec2::from);
        for place in expected.map(|p| figure.panels[0].frame.page(p)) {
            assert!(marked.iter().any(|p| (*p - place).length() < 1e-6), "{place:?}: {marked:?}");
        }
    }
}
