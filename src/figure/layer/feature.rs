//! An edge or a vertex of a body, emphasised: by its number, or those that carry the closest points. In
//! configuration space the edges and vertices of B ⊖ A that come from it.

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::Difference;
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, Marker, Outline, Pen, Rank, Size, Sketch, angle_of,
};
use crate::geometry::{DVec2, Feature, Side, perp};
use crate::scene::Space;
use crate::trace::phrase;

use super::difference::{difference, origins};
use super::half_extents::ON_LINE;
use super::vertices::mean;
use super::{Fed, LabelKey, Layer, ONE_OF_SEVERAL, OptionSpec, Options, Shows, Takes, Tells, part};

/// Bodies that are nearer touch on the page, page pixels: the width of a line. What is outside of the one is
/// inside the other there, and a label says whose edge it is.
const UNSEEN: f64 = 2.25;

pub(super) const LAYER: Layer = Layer {
    name: "feature",
    in_words: phrase(["feature", "ein Merkmal", "un élément", "un elemento"]),
    about: "an edge or a vertex, emphasised; by default those that carry the closest points",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[
        OptionSpec {
            name: "of",
            takes: Takes::Bodies,
            default: "all of the query's",
            about: "of which body",
        },
        OptionSpec {
            name: "edge",
            takes: Takes::Counts,
            default: "that of the closest points",
            about: "edges by their numbers in the scene: edge i runs from vertex i",
        },
        OptionSpec {
            name: "vertex",
            takes: Takes::Counts,
            default: "that of the closest points",
            about: "vertices by their numbers in the scene, from 0",
        },
        OptionSpec {
            name: "text",
            takes: Takes::Lines,
            default: "\"edge 1\"",
            about: "its label, as markup",
        },
        OptionSpec {
            name: "arrow",
            takes: Takes::Flag,
            default: "false",
            about: "an edge as a vector, counter-clockwise about its body",
        },
    ],
    labels: &[
        LabelKey { key: "feature.A", about: "at an emphasised edge or vertex of A" },
        LabelKey { key: "feature.B", about: "at an emphasised edge or vertex of B" },
    ],
    needs: "a body with the `edge` or `vertex`; without them two convex bodies",
    fed: |context, options| Fed::by_the_scene(!marks(context, options).is_empty()),
    draw,
};

/// Something to emphasise.
struct Mark {
    /// The body that it is of.
    side: Side,
    /// What it is, numbered in the scene's order.
    feature: Feature,
    /// How it looks.
    form: Form,
    /// What it is called, as markup.
    text: String,
}

/// How something that is emphasised looks, in the panel's space.
enum Form {
    /// A straight line; outside is on its right.
    Line(DVec2, DVec2),
    /// The rounded end at a vertex: the arc, its middle, and the way out there.
    Round(Outline, DVec2, DVec2),
    /// A point, and the way out there.
    Point(DVec2, DVec2),
}

/// The features that the scene names, each with its body and, of the answer's, the way to the other body.
fn named(context: &Context, options: &Options) -> Vec<(Side, Feature, Option<DVec2>)> {
    let sides = options.of(&context.sides());
    let (edges, vertices) = (options.counts("edge"), options.counts("vertex"));
    if edges.is_none() && vertices.is_none() {
        let Some(found) = context.separation_seen(context.time) else { return Vec::new() };
        let n = *found.normal;
        let of = |side| match side {
            Side::A => (side, found.features[0], Some(n)),
            Side::B => (side, found.features[1], Some(-n)),
        };
        return sides.into_iter().map(of).collect();
    }
    let edges = edges.unwrap_or_default().iter().map(|&i| Feature::Edge(i));
    let all: Vec<Feature> =
        edges.chain(vertices.unwrap_or_default().iter().map(|&i| Feature::Vertex(i))).collect();
    sides.into_iter().flat_map(|side| all.iter().map(move |&feature| (side, feature, None))).collect()
}

/// All that is emphasised.
fn marks(context: &Context, options: &Options) -> Vec<Mark> {
    let named = named(context, options);
    if *context.space == Space::Configuration {
        return on_difference(context, &named);
    }
    let forms = |(side, feature, toward)| {
        let forms = match feature {
            Feature::Edge(i) => edge(context, side, i, toward),
            Feature::Vertex(i) => vertex(context, side, i).into_iter().collect(),
        };
        let text = words(feature);
        forms.into_iter().map(move |form| Mark { side, feature, form, text: text.clone() })
    };
    named.into_iter().flat_map(forms).collect()
}

/// An edge of a body: moved outward by the radius; both long edges of a capsule, or the one that looks
/// `toward` the other body.
fn edge(context: &Context, side: Side, i: usize, toward: Option<DVec2>) -> Vec<Form> {
    let Some(shape) = context.body(side).map(|body| &body.shape) else { return Vec::new() };
    let place = |k| context.vertex(side, k, context.time);
    let Some([p, q]) = shape.edge_ends(i).and_then(|[p, q]| Some([place(p)?, place(q)?])) else {
        return Vec::new();
    };
    let n = perp(q - p).normalize_or_zero();
    let both = [(n, q, p), (-n, p, q)];
    let all: Vec<DVec2> = shape.core.iter().filter_map(|&k| place(k)).collect();
    let inside = mean(&all) - p;
    let out = both.into_iter().filter(|(n, ..)| match (shape.core.len(), toward) {
        (0, _) => *n == both[1].0,
        (1..=2, Some(toward)) => n.dot(toward) > 0.0,
        (1..=2, None) => shape.radius > 0.0 || *n == both[0].0,
        _ => n.dot(inside) < 0.0,
    });
    out.map(|(n, from, to)| Form::Line(from + shape.radius * n, to + shape.radius * n)).collect()
}

/// A vertex of a body: the point itself, or the arc about it where the body is round.
fn vertex(context: &Context, side: Side, i: usize) -> Option<Form> {
    let shape = &context.body(side)?.shape;
    let place = |k: usize| context.vertex(side, k, context.time);
    let at = place(i)?;
    let all: Vec<DVec2> = (0..shape.vertices.len()).filter_map(place).collect();
    let out = (at - mean(&all)).normalize_or_zero();
    let count = shape.core.len();
    let Some(k) = shape.core.iter().position(|&k| k == i).filter(|_| shape.radius > 0.0) else {
        return Some(Form::Point(at, out));
    };
    if count == 1 {
        return Some(Form::Round(Outline::circle(at, shape.radius), at + shape.radius * DVec2::Y, DVec2::Y));
    }
    let [before, after] = [place(shape.core[(k + count - 1) % count])?, place(shape.core[(k + 1) % count])?];
    let start = angle_of(-perp(at - before));
    Some(arc(at, shape.radius, start, angle_of(-perp(after - at)) - start))
}

/// The edges of B ⊖ A that come from one of the edges, and its vertices that come from one of the vertices;
/// of the answer's features those that hold the point nearest to the origin.
fn on_difference(context: &Context, named: &[(Side, Feature, Option<DVec2>)]) -> Vec<Mark> {
    let time = context.difference_time();
    let Some(found) = difference(context, time) else { return Vec::new() };
    let of_answer = named.iter().any(|(.., toward)| toward.is_some());
    let has_edge = named.iter().any(|(_, feature, _)| matches!(feature, Feature::Edge(_)));
    let mut marks = Vec::new();
    for &(side, feature, _) in named {
        let Feature::Edge(i) = feature else { continue };
        for edge in found.edges.iter().filter(|e| e.source == side && e.index == i) {
            let (from, to) = found.drawn(edge);
            let text = format!("{} of {}", words(feature), context.name(side));
            marks.push(Mark { side, feature, form: Form::Line(from, to), text });
        }
    }
    if of_answer && has_edge {
        return marks;
    }
    let all: Vec<DVec2> = found.edges.iter().map(|e| e.from).collect();
    let middle = mean(&all);
    for origin in origins(context, &found, time) {
        let from = |&&(side, feature, _): &&(Side, Feature, Option<DVec2>)| {
            feature == Feature::Vertex(origin.of(side))
        };
        let fits = if of_answer { named.iter().all(|n| from(&n)) } else { named.iter().any(|n| from(&n)) };
        let Some(&(side, feature, _)) = named.iter().find(from).filter(|_| fits) else { continue };
        let out = (origin.at - middle).normalize_or_zero();
        let form = if found.radius > 0.0 { rounded(&found, origin.at) } else { Form::Point(origin.at, out) };
        let [a, b] = [(Side::A, origin.a), (Side::B, origin.b)].map(|(s, k)| context.named(s).point(k));
        marks.push(Mark { side, feature, form, text: format!("${b} - {a}$") });
    }
    marks
}

/// The arc of a round B ⊖ A about a vertex of its core: a whole circle where that is a point.
fn rounded(found: &Difference, at: DVec2) -> Form {
    let radius = found.radius;
    let Some(k) = found.edges.iter().position(|e| e.from == at) else {
        return Form::Round(Outline::circle(at, radius), at + radius * DVec2::Y, DVec2::Y);
    };
    let before = found.edges[(k + found.edges.len() - 1) % found.edges.len()].normal;
    let start = angle_of(before);
    arc(at, radius, start, angle_of(found.edges[k].normal) - start)
}

/// The arc about a vertex over the turn of its edges' normals, radians.
fn arc(at: DVec2, radius: f64, start: f64, turn: f64) -> Form {
    let turn = turn.rem_euclid(std::f64::consts::TAU);
    let way = DVec2::new(libm::cos(start + 0.5 * turn), libm::sin(start + 0.5 * turn));
    Form::Round(Outline::arc(at, radius, start, turn), at + radius * way, way)
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let role = options.role(Role::Now);
    let pen = Pen::highlighted(role);
    let arrow = options.flag("arrow", false);
    let mut labelled = Vec::new();
    let asked = options.counts("edge").is_some() || options.counts("vertex").is_some();
    let run = context.separation_at(context.time).filter(|_| !asked);
    let found = run.as_ref().and_then(|run| run.separation().copied());
    sketch.since(run.map(|run| run.nearest()));
    for Mark { side, feature, form, text } in marks(context, options) {
        sketch.part(part("feature", side));
        let anchor = match form {
            Form::Line(from, to) => {
                match (arrow, side) {
                    (true, Side::B) if *context.space == Space::Configuration => {
                        sketch.cased_arrow(from, to, pen)
                    }
                    (true, _) => sketch.arrow(from, to, pen),
                    (false, _) => sketch.line(from, to, pen),
                };
                Anchor::Beside { from: to, to: from, offset: ON_LINE }
            }
            Form::Round(outline, at, out) => {
                sketch.stroke(&outline, pen);
                Anchor::Point { at, clear: pen.width, toward: out }
            }
            Form::Point(at, out) => {
                let marker = match side {
                    _ if *context.space == Space::Configuration => Marker::Diamond,
                    Side::A => Marker::Disc,
                    Side::B => Marker::Square,
                };
                sketch.marker(at, marker, role, LARGE_MARKER);
                Anchor::Point { at, clear: LARGE_MARKER, toward: out }
            }
        };
        if labelled.contains(&(side, feature, text.clone())) {
            sketch.unnamed(anchor);
            continue;
        }
        labelled.push((side, feature, text.clone()));
        let touching = found.is_some_and(|found| sketch.on_page(found.separation.abs()) < UNSEEN);
        let is_named = touching && *context.space != Space::Configuration;
        let text = if is_named { format!("{text} of {}", context.name(side)) } else { text };
        let key = if side == Side::A { "feature.A" } else { "feature.B" };
        let mut lines = vec![text];
        let ties = found.is_some_and(|found| is_one_of_several(context, (side, feature), &found));
        lines.extend(ties.then(|| ONE_OF_SEVERAL.to_owned()));
        let label = Label { lines, ..Label::new(key, "", anchor, role) };
        let label = label.rank(Rank::Word).size(Size::Note);
        sketch.label(if let Some(text) = options.words("text") { label.given(text) } else { label });
    }
}

/// Whether another edge or vertex of the body would do as well where several normals are as good: a segment
/// has one edge, a point one vertex, and bodies that touch at a vertex do at no other.
fn is_one_of_several(context: &Context, (side, feature): (Side, Feature), found: &Separation) -> bool {
    let count = context.body(side).map_or(0, |body| body.shape.core.len());
    let has_more = match feature {
        Feature::Vertex(_) => count > 1 && found.bounds.hi < 0.0,
        Feature::Edge(_) => count > 2,
    };
    found.ties > 1 && has_more
}

/// What a feature is called: `edge 1`.
fn words(feature: Feature) -> String {
    match feature {
        Feature::Vertex(i) => format!("vertex {i}"),
        Feature::Edge(i) => format!("edge {i}"),
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::labels;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    /// What is said of the features of two bodies.
    fn said(a: &str, b: &str) -> [String; 2] {
        let text = format!(
            "shapes.A = {{ {a} }}\nshapes.B = {{ {b} }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}
            panels = [{{ layers = ['feature'] }}]"
        );
        let scene = open_text("feature", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let labels = labels(&draw(&plan, plan.theme, "feature"));
        ["feature.A", "feature.B"].map(|key| labels[key].0.clone())
    }

    #[test]
    fn the_edge_of_a_segment_and_the_vertex_of_a_point_are_the_only_ones() {
        let segment = "kind = 'capsule', points = [[-1, 0], [1, 0]], radius = 0";
        let labels = said(segment, "kind = 'circle', radius = 0");
        assert!(labels.iter().all(|label| !label.contains("several")), "{labels:?}");
        let boxed = "kind = 'box', half_extents = [1, 1]";
        let labels = said(boxed, boxed);
        assert!(labels.iter().all(|label| label.contains("several")), "{labels:?}");
    }

    #[test]
    fn where_two_edges_are_on_one_line_each_says_whose_it_is() {
        let boxed = "kind = 'box', half_extents = [1, 1]";
        let at = |x: f64| said(boxed, &format!("{boxed}, position = [{x}, 0.2]"));
        assert_eq!(at(2.0), ["edge 1 of $A$", "edge 3 of $B$"]);
        assert_eq!(at(2.5), ["edge 1", "edge 3"]);
    }
}
