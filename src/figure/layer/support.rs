//! The supporting vertices of the nearest edge, all of them: two where the bodies are exactly aligned.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::{Difference, Edge};
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Rank, SMALL_MARKER, Size, Sketch, Weight,
};
use crate::figure::text::number;
use crate::geometry::{DVec2, Feature, Side};
use crate::scene::{NOTES, Space};
use crate::trace::{Event, SupportVertex, phrase};

use super::cores::less_radii;
use super::difference::{difference, draw_edge};
use super::half_extents::ON_LINE;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

/// How much a direction that is the normal's may differ from it: both are unit vectors rounded a few times. A
/// hundred million times more is still a thousandth of a degree.
const SAME_DIRECTION: f64 = 1e-12;

/// The case in which there is no nearest edge.
const NO_EDGE: &str = "the bodies are closest at a vertex of each, so that no edge faces the other body";

pub(super) const LAYER: Layer = Layer {
    name: "support",
    in_words: phrase(["support", "Stützecken", "sommets d’appui", "vértices de soporte"]),
    about: "all supporting vertices of the nearest edge; in configuration space, where its two parts join",
    shows: Shows::Anywhere,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "vertices",
            takes: Takes::Flag,
            default: "true",
            about: "the vertices themselves, in the world where they are",
        },
        OptionSpec {
            name: "lengths",
            takes: Takes::Flag,
            default: "false",
            about: "where edges face each other, both with their lengths, here as parts of the nearest edge, \
                and the vertices whose difference joins them",
        },
        OptionSpec {
            name: "contacts",
            takes: Takes::Flag,
            default: "false",
            about: "where edges of bodies that overlap face each other, the ends of what they share once B \
                is pushed out",
        },
    ],
    labels: &[
        LabelKey { key: "a_1", about: "first supporting vertex, on A" },
        LabelKey { key: "a_2", about: "second supporting vertex, on A" },
        LabelKey { key: "b_1", about: "first supporting vertex, on B" },
        LabelKey { key: "b_2", about: "second supporting vertex, on B" },
        LabelKey { key: "joint", about: "where the parts of the nearest edge join, with lengths" },
        LabelKey { key: "end", about: "where the nearest edge begins and ends, with lengths" },
        LabelKey {
            key: "contact",
            about: "the ends of what the edges share, with contacts; without a text of their own",
        },
        LabelKey { key: "length.A", about: "length of A's facing edge, with lengths" },
        LabelKey { key: "length.B", about: "length of B's facing edge, with lengths" },
    ],
    needs: "two convex bodies with edges",
    fed,
    draw,
};

/// Two vertices that face each other, or nothing at all where the bodies' distance is not measured from an
/// edge, leave nothing to mark.
fn fed(context: &Context, options: &Options) -> Fed {
    let edges = |side| context.body(side).is_some_and(|body| body.shape.core.len() > 1);
    if context.separation_at(context.time).is_none() || !context.sides().into_iter().any(edges) {
        return Fed::Never;
    }
    let aligned = || difference(context, context.time).and_then(|found| found.aligned()).is_some();
    let is_joint = *context.space == Space::Configuration;
    match supports(context) {
        None => Fed::not_here(NO_EDGE),
        Some(_) if is_joint && !aligned() => Fed::not_here("no edges face each other"),
        Some(_) if NOTES && options.flag("lengths", false) && !aligned() => {
            Fed::Without { option: "lengths", why: "no edges face each other" }
        }
        Some(_) => Fed::Yes,
    }
}

/// The body and its vertices that support the nearest edge: a tie first, then B's.
fn supports(context: &Context) -> Option<(Side, Vec<SupportVertex>)> {
    let run = context.separation_at(context.time)?;
    let normal = run.separation()?.normal;
    let found = |count: usize, side: Side| {
        let toward = if side == Side::B { -normal } else { normal };
        run.find_told(|event| match event {
            Event::SupportFound { body, direction, vertices }
                if *body == side
                    && vertices.len() == count
                    && direction.distance(*toward) < SAME_DIRECTION =>
            {
                Some((side, vertices.clone()))
            }
            _ => None,
        })
    };
    found(2, Side::B)
        .or_else(|| found(2, Side::A))
        .or_else(|| found(1, Side::B))
        .or_else(|| found(1, Side::A))
        .or_else(|| answered(context))
}

/// The supporting vertices by the features of the answer, of an algorithm that tells none: the vertex that an
/// edge of the other body faces, or both ends of B's edge where edges face each other.
fn answered(context: &Context) -> Option<(Side, Vec<SupportVertex>)> {
    let run = context.separation_at(context.time)?;
    if run.events().any(|event| matches!(event, Event::SupportFound { .. })) {
        return None;
    }
    let (side, indices) = match run.separation()?.features {
        [Feature::Edge(_), Feature::Edge(index)] => {
            (Side::B, context.body(Side::B)?.shape.edge_ends(index)?.to_vec())
        }
        [Feature::Edge(_), Feature::Vertex(index)] => (Side::B, vec![index]),
        [Feature::Vertex(index), Feature::Edge(_)] => (Side::A, vec![index]),
        [Feature::Vertex(_), Feature::Vertex(_)] => return None,
    };
    let vertex = |index| Some(SupportVertex { index, point: context.vertex(side, index, context.time)? });
    Some((side, indices.into_iter().filter_map(vertex).collect()))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let role = options.role(Role::Now);
    sketch.since(context.separation_at(context.time).map(|run| run.nearest()));
    let lengths = options.flag("lengths", false) && lengths(sketch, context);
    if *context.space == Space::Configuration {
        if let Some(joint) = difference(context, context.time).and_then(|found| found.joint()) {
            let joint = joint + context.estimate();
            sketch.part("support").marker(joint, Marker::Diamond, role, LARGE_MARKER);
            if lengths {
                name(sketch, context, role);
            }
        }
        return;
    }
    if options.flag("contacts", false) {
        contacts(sketch, context);
    }
    let Some((side, vertices)) = supports(context).filter(|_| options.flag("vertices", true)) else {
        return;
    };
    if let Some(found) = difference(context, context.time).filter(|_| lengths) {
        for vertex in ends(context, &found, side.other()).into_iter().flatten() {
            mark(sketch, context, options.role(vertex.side.into()), vertex, Anchor::point(vertex.point));
        }
    }
    if let ([p, q], false) = (vertices.as_slice(), lengths) {
        sketch.part("support").weight(Weight::Light).line(p.point, q.point, Pen::highlighted(role));
    }
    let middle = match vertices.as_slice() {
        [p, q] => 0.5 * (p.point + q.point),
        _ => vertices.first().map_or(DVec2::ZERO, |v| v.point),
    };
    for (&SupportVertex { point, index }, nth) in vertices.iter().zip(0..2) {
        let anchor = Anchor::point_toward(point, point - middle);
        let role = if lengths { options.role(side.into()) } else { role };
        mark(sketch, context, role, Marked { side, nth, index, point }, anchor);
    }
}

/// Marks the ends of what facing edges share once B is pushed out.
fn contacts(sketch: &mut Sketch, context: &Context) {
    for end in shared(context).into_iter().flatten() {
        sketch.part("contact").marker(end, Marker::Disc, Role::Ink, MARKER);
        let label = Label::new("contact", "", Anchor::point(end), Role::Ink);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// The ends of what the facing edges of bodies that overlap share once B is pushed out, on A's edge.
fn shared(context: &Context) -> Option<[DVec2; 2]> {
    let (run, found) = (context.separation_at(context.time)?, difference(context, context.time)?);
    let answer = run.separation().filter(|answer| answer.bounds.hi < 0.0)?;
    let [a, b] = [Side::A, Side::B].map(|side| ends(context, &found, side).map(|ends| ends.map(|v| v.point)));
    let (a, b) = (a?, b?.map(|end| end - answer.normal * answer.separation));
    let along = a[1] - a[0];
    let share = |p: DVec2| (p - a[0]).dot(along) / along.length_squared();
    let [from, to] = [f64::min, f64::max].map(|of| of(share(b[0]), share(b[1])).clamp(0.0, 1.0));
    (from < to).then(|| [from, to].map(|share| a[0] + along * share))
}

/// A vertex that is marked and named.
#[derive(Clone, Copy)]
struct Marked {
    /// The body that it is of.
    side: Side,
    /// Whether it is the first or the second on the edge that faces the other body, from 0.
    nth: usize,
    /// Its number in the scene.
    index: usize,
    /// Its place in the world.
    point: DVec2,
}

/// Marks a vertex and names it.
fn mark(sketch: &mut Sketch, context: &Context, role: Role, vertex: Marked, anchor: Anchor) {
    let Marked { side, nth, index, point } = vertex;
    let (marker, keys) = match side {
        Side::A => (Marker::HollowDisc, ["a_1", "a_2"]),
        Side::B => (Marker::HollowSquare, ["b_1", "b_2"]),
    };
    sketch.part("support").marker(point, marker, role, LARGE_MARKER);
    let text = format!("${}$", context.named(side).point(index));
    sketch.label(Label::new(keys[nth.min(1)], text, anchor, role).rank(Rank::Point));
}

/// Names where the parts of the nearest edge join, and its ends, by the vertices whose differences they are.
fn name(sketch: &mut Sketch, context: &Context, role: Role) {
    let Some(found) = difference(context, context.time) else { return };
    let Some([first, second]) = found.aligned() else { return };
    let (Some(a), Some(b)) = (ends(context, &found, Side::A), ends(context, &found, Side::B)) else { return };
    let gap = |[p, q]: &[Marked; 2], place: DVec2| (q.point - p.point).distance(place);
    // Of a round B ⊖ A only the joint has a name: it is the radii off from the difference of the vertices.
    let radii = less_radii(context);
    let beyond = [first.from, second.to].into_iter().filter(|_| radii.is_empty());
    let beyond = beyond.map(|end| ("end", end, Role::Difference));
    for (key, place, role) in [("joint", first.to, role)].into_iter().chain(beyond) {
        let pairs = a.into_iter().flat_map(|p| b.map(|q| [p, q]));
        let nearest = pairs.min_by(|one, other| gap(one, place).total_cmp(&gap(other, place)));
        let Some([p, q]) = nearest.map(|[p, q]| [q, p].map(|v| context.named(v.side).point(v.index))) else {
            continue;
        };
        let at = place + first.normal * found.radius + context.estimate();
        if key == "end" {
            sketch.marker(at, Marker::Diamond, role, SMALL_MARKER);
        }
        let text = format!("${p} - {q}{radii}$");
        sketch.label(Label::new(key, text, Anchor::point(at), role).rank(Rank::Point));
    }
}

/// The ends of a body's facing edge, numbered. `None` where no edges face each other.
fn ends(context: &Context, found: &Difference, side: Side) -> Option<[Marked; 2]> {
    let edge = found.aligned()?.into_iter().find(|edge| edge.source == side)?;
    let [i, j] = context.body(side)?.shape.edge_ends(edge.index)?;
    // A tie of supporting vertices is told in the order of their numbers.
    let ends = [i.min(j), i.max(j)];
    let [i, j] = ends;
    let [p, q] = ends.map(|k| context.vertex(side, k, context.time));
    Some([(0, i, p?), (1, j, q?)].map(|(nth, index, point)| Marked { side, nth, index, point }))
}

/// Draws the edges that face each other, one of each body, with their lengths: in the world where they are,
/// in configuration space as the parts of the nearest edge. Whether there are such edges.
fn lengths(sketch: &mut Sketch, context: &Context) -> bool {
    let found = difference(context, context.time);
    let Some((found, aligned)) = found.and_then(|found| found.aligned().map(|both| (found, both))) else {
        return false;
    };
    for edge in aligned {
        let (side, role) = (edge.source, Role::from(edge.source));
        let length = number(edge.from.distance(edge.to));
        let key = if side == Side::A { "length.A" } else { "length.B" };
        let here = *context.space == Space::Configuration;
        let Some((from, to)) = (if here { Some(found.drawn(&edge)) } else { on_body(context, &edge) }) else {
            continue;
        };
        sketch.part(part("length", side));
        let lines = if here {
            draw_edge(sketch, side, (from, to), Pen::highlighted(role));
            // B − A takes A's edges with the minus.
            let turned = if side == Side::A { ", reversed" } else { "" };
            vec![format!("edge of {}{turned}", context.named(side).primed(0)), format!("${length}$ long")]
        } else {
            sketch.line(from, to, Pen::highlighted(role));
            vec![format!("${length}$ long")]
        };
        // Outside is on the right of from → to, and on the left of to → from.
        let anchor = Anchor::Beside { from: to, to: from, offset: ON_LINE };
        let label = Label { lines, ..Label::new(key, "", anchor, role) };
        sketch.label(label.rank(Rank::Measure).size(Size::Note));
    }
    true
}

/// The edge of a body that an edge of B ⊖ A comes from, counter-clockwise, moved outward by the radius.
fn on_body(context: &Context, edge: &Edge) -> Option<(DVec2, DVec2)> {
    let shape = &context.body(edge.source)?.shape;
    let out = if edge.source == Side::A { -edge.normal } else { edge.normal } * shape.radius;
    let [from, to] = shape.edge_ends(edge.index)?;
    let place = |k| context.vertex(edge.source, k, context.time).map(|p| p + out);
    Some((place(from)?, place(to)?))
}

#[cfg(test)]
mod tests {
    use crate::drawing::Contour;
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    /// The keys of the labels of `support` in a scene that is answered by an algorithm.
    fn supported(algorithm: &str) -> Vec<&'static str> {
        let text = format!(
            "shapes.T = {{ kind = 'polygon', vertices = [[0, 0], [2, 0.3], [0.8, 1.8]] }}
            shapes.R = {{ kind = 'box', half_extents = [0.7, 0.5], position = [2.9, 1.4], angle_deg = 20 }}
            query = {{ kind = 'separation', of = ['T', 'R'], algorithm = '{algorithm}' }}
            panels = [{{ layers = ['shapes', 'support'] }}]"
        );
        let scene = open_text("support", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        assert!(plan.warnings.is_empty(), "{algorithm}: {:?}", plan.warnings);
        let mut keys: Vec<_> =
            draw(&plan, plan.theme, "support").panels[0].placed.iter().map(|l| l.key).collect();
        keys.retain(|key| key.contains('_'));
        keys.sort_unstable();
        keys
    }

    #[test]
    fn lengths_of_edges_that_do_not_face_each_other_are_told_to_be_none() {
        let text = "shapes.A = { kind = 'box', half_extents = [1, 1] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [3, 0], angle_deg = 30 }
            query = { kind = 'separation', of = ['A', 'B'] }
            panels = [{ layers = ['shapes', { layer = 'support', lengths = true }] }]";
        let scene = open_text("support", text).unwrap().scene;
        let told: Vec<String> = plan(&scene).unwrap().warnings.iter().map(|w| w.fault.to_string()).collect();
        assert_eq!(told, ["`lengths` of `support` draws nothing: no edges face each other"]);
    }

    #[test]
    fn the_joint_of_round_bodies_is_on_the_outline_and_the_radii_off_from_the_vertices() {
        // B's lower edge lies 1.2 above A's upper one, without radii; the joint is at x = 2 − 1.5.
        for (radii, y, text) in [
            ([0.0, 0.0], 1.2, "$b_1 - a_2$"),
            ([0.25, 0.0], 0.95, r"$b_1 - a_2 - r_1\,n$"),
            ([0.25, 0.5], 0.45, r"$b_1 - a_2 - (r_1 + r_2)\,n$"),
        ] {
            let text_of = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1.5, 0.5], radius = {} }}
                shapes.B = {{ kind = 'box', half_extents = [1, 0.5], radius = {}, position = [1, 2.2] }}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration', layers = [{{ layer = 'support', lengths = true }}] }}]",
                radii[0], radii[1]
            );
            let scene = open_text("joint", &text_of).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "joint");
            let labels = labels(&figure);
            assert_eq!(labels["joint"].0, text, "{radii:?}");
            let marks = paths(&figure.drawing.items, "support");
            let at = marks[0].contour.bounds().unwrap().center();
            let frame = &figure.panels[0].frame;
            let off = at - frame.page(DVec2::new(0.5, y));
            assert!(off.length() < 0.5, "{radii:?}: {off:?}");
        }
    }

    #[test]
    fn contacts_are_the_ends_of_what_facing_edges_share_once_one_is_pushed_out() {
        let text = "shapes.A = { kind = 'box', half_extents = [4, 2] }
            shapes.B = { kind = 'box', half_extents = [2, 1], position = [3, 2] }
            query = { kind = 'separation', of = ['A', 'B'], algorithm = 'minkowski' }
            panels = [{ layers = ['shapes', { layer = 'support', contacts = true }] }]";
        let scene = open_text("support", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "support");
        let frame = &figure.panels[0].frame; // B, from 1 to 5, goes up to A's top edge, which ends at 4.
        let [one, two] = paths(&figure.drawing.items, "contact")[..] else { panic!("two discs") };
        for (disc, x) in [(one, 4.0), (two, 1.0)] {
            let Contour::Circle { center, .. } = &disc.contour else { panic!("a disc") };
            assert!((*center - frame.page(DVec2::new(x, 2.0))).length() < 1e-6, "{center:?} is not at {x}");
        }
    }

    #[test]
    fn a_vertex_is_called_by_its_number_in_the_scene() {
        let text = "shapes.A = { kind = 'box', half_extents = [4, 2] }
            shapes.tip = { kind = 'polygon', vertices = [[-1, 2], [1, 2], [0, 0]], position = [0, 3] }
            query = { kind = 'separation', of = ['A', 'tip'] }
            panels = [{ layers = ['shapes', 'support'] }]";
        let scene = open_text("support", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "support");
        let label = figure.panels[0].placed.iter().find(|label| label.key == "b_1").unwrap();
        let written = &label.lines[0].1.markup;
        assert!(written.contains(",2}"), "{written}");
    }

    #[test]
    fn a_vertex_that_faces_an_edge_is_marked_whichever_algorithm_found_it() {
        for algorithm in ["merge", "minkowski", "gjk", "closest-features"] {
            assert_eq!(supported(algorithm), ["b_1"], "{algorithm}");
        }
    }
}
