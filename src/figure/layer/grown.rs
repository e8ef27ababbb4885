//! B shrunk to a point while A grows by B's shape: what B ⊖ A looks like from where the bodies stand.
//!
//! With b the origin of B, the grown A is {b − x : x ∈ B ⊖ A} = A ⊕ (b − B): A swept by B turned through half
//! a turn about b. Copies of that on A's vertices span it. Seen the other way, b walks its outline where B,
//! moved and not turned, touches A; and b is as far from it as B from A.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::{Difference, Edge};
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, MARKER, Marker, Outline, Pen, Piece, Rank, Size, Sketch, Wash, Weight,
};
use crate::geometry::{DVec2, Side};
use crate::trace::phrase;

use super::closest::{Nearest, leg, nearest};
use super::difference::{difference, draw_edge};
use super::edge_cues::EdgeCues;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Opacity of the copy of B that touches A, and how many there are at most: one tells where b is then, and
/// readers took two for clutter.
const COPY: f64 = 0.8;
const COPIES: usize = 1;

pub(super) const LAYER: Layer = Layer {
    name: "grown",
    in_words: phrase(["grown", "vergrößerter Körper", "corps agrandi", "cuerpo agrandado"]),
    about: "B as a point, A grown by B's shape",
    shows: Shows::World,
    tells: Tells::Built,
    options: &[
        OptionSpec {
            name: "copies",
            takes: Takes::Flag,
            default: "true",
            about: "dotted copies of B on A's vertices",
        },
        OptionSpec {
            name: "around",
            takes: Takes::Flag,
            default: "false",
            about: "a faint copy of B moved around A, where it touches it, with the point in it",
        },
        OptionSpec {
            name: "distance",
            takes: Takes::Flag,
            default: "false",
            about: "how far the point is from the grown A",
        },
    ],
    labels: &[
        LabelKey { key: "A", about: "name of the first body" },
        LabelKey { key: "grown", about: "the grown A; only where a scene gives it a text" },
        LabelKey { key: "b", about: "the point that B shrinks to" },
        LabelKey { key: "copy", about: "what the dotted copies are" },
        LabelKey { key: "b'", about: "the point in the copy, with around" },
        LabelKey { key: "d", about: "distance or depth of the point, with distance" },
    ],
    needs: "two convex bodies",
    fed: |context, _| Fed::by_the_scene(difference(context, context.time).is_some()),
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let time = context.time;
    let Some(found) = difference(context, time) else { return };
    let (Some(b), Some(outline_a), Some(outline_b)) =
        (context.pose(Side::B, time), context.outline(Side::A, time), context.outline(Side::B, time))
    else {
        return;
    };
    let b = b.position;
    let turned = |p: DVec2| b - p;
    let grown = found.outline().turned_about(DVec2::ZERO).moved(b);
    let cues = EdgeCues::at(context, time);
    sketch.since(cues.whole).part("grown").area(&grown, Some(Wash::theme(Role::Difference)), None);
    for piece in &grown.pieces {
        if let Piece::Arc { center, radius, start, sweep } = *piece {
            sketch.arc(center, radius, start, sweep, Pen::outline(Role::Difference));
        }
    }
    if options.flag("copies", true) {
        copies(sketch.since(cues.first()), context, [&outline_a, &outline_b], b);
        // A lies on them, and has room for its name.
        sketch.hidden_under(&outline_a);
    }
    // On the page's own colour: its tint over that of the grown A would be a third one.
    sketch.since(None).part("body-A").area(&outline_a, Some(Wash::faint(Role::Background, 1.0)), None);
    sketch.area(&outline_a, Some(Wash::theme(Role::A)), Some(Pen::outline(Role::A)));
    let around = if options.flag("around", false) {
        around(sketch.since(cues.first()), context, &found, &outline_b, b)
    } else {
        Vec::new()
    };
    edges(sketch, &found, &cues, turned);
    sketch.since(cues.first()).part("around");
    for &place in &around {
        sketch.marker(place, Marker::Square, Role::B, MARKER);
    }
    if let (Some(&first), Some(letter)) = (around.first(), letter_of_b(context)) {
        sketch.label(Label::new("b'", letter, Anchor::point(first), Role::B).rank(Rank::Point));
    }
    sketch.since(None).part("ghost-B").area(&outline_b, None, Some(Pen::ghost(Role::B)));
    if options.flag("distance", false) {
        distance(sketch.since(context.separation_at(context.time).map(|run| run.end())), context, &found, b);
    }
    sketch.since(None).part("b").marker(b, Marker::Square, Role::B, LARGE_MARKER);
    let inside = Anchor::inside(&outline_a);
    sketch.label(Label::new("A", context.name(Side::A), inside, Role::A).rank(Rank::Name).size(Size::Name));
    name_grown(sketch, &grown, b);
    let name = || format!("origin of {}", context.named(Side::B).shortened());
    sketch.label(
        Label::new("b", letter_of_b(context).unwrap_or_else(name), Anchor::point(b), Role::B)
            .rank(Rank::Point),
    );
}

/// Names the grown A, if the scene does, where its outline is farthest from B's point `b`: there is room.
fn name_grown(sketch: &mut Sketch, grown: &Outline, b: DVec2) {
    let far = |p: &&DVec2, q: &&DVec2| p.distance(b).total_cmp(&q.distance(b));
    let outline = grown.sampled();
    let Some(&at) = outline.iter().max_by(far) else { return };
    let anchor = Anchor::point_toward(at, at - b);
    sketch.label(Label::new("grown", "", anchor, Role::Difference).rank(Rank::Word).size(Size::Note));
}

/// Whether all of an outline lies within a convex one, which then hides it.
fn is_within(inner: &Outline, outer: &Outline) -> bool {
    let outer = outer.sampled();
    let edges = || outer.iter().zip(outer.iter().cycle().skip(1));
    inner.sampled().iter().all(|&p| edges().all(|(&from, &to)| (to - from).perp_dot(p - from) >= 0.0))
}

/// Draws B turned about its point `b`, with that at every vertex of A: what A is grown by. A copy that A
/// hides has no label.
fn copies(sketch: &mut Sketch, context: &Context, [outline_a, outline_b]: [&Outline; 2], b: DVec2) {
    sketch.part("copies").weight(Weight::Light);
    let mut last = None;
    for vertex in vertices(context) {
        if sketch.is_full() {
            break;
        }
        let copy = outline_b.turned_about(b).moved(vertex - b);
        sketch.area(&copy, None, Some(Pen::ghost(Role::B)));
        last = Some(copy);
    }
    if let Some(copy) = last.filter(|copy| !is_within(copy, outline_a)) {
        let name = context.named(Side::B);
        let text = match letter_of_b(context) {
            Some(letter) => format!("{} turned about {letter}", name.shortened()),
            None => format!("{} turned about its origin", name.shortened()),
        };
        let label = Label::new("copy", text, Anchor::inside(&copy), Role::B);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// Draws the edges of B ⊖ A where they are once it is turned.
fn edges(sketch: &mut Sketch, found: &Difference, cues: &EdgeCues, turned: impl Fn(DVec2) -> DVec2) {
    sketch.part("grown-edges");
    for edge in &found.edges {
        let (from, to) = found.drawn(edge);
        draw_edge(
            sketch.since(cues.of(edge)),
            edge.source,
            (turned(from), turned(to)),
            Pen::outline(edge.source.into()),
        );
    }
}

/// Draws B where it touches A with a vertex on the middle of each edge, faintly, and gives the places of its
/// point then, which are on the grown outline: where it crosses neither the outline's edges that are B's nor
/// the way to the nearest point, if there are such places.
fn around(
    sketch: &mut Sketch,
    context: &Context,
    found: &Difference,
    outline_b: &Outline,
    b: DVec2,
) -> Vec<DVec2> {
    let turned = |edge: &Edge| {
        let (from, to) = found.drawn(edge);
        (b - from, b - to)
    };
    let (of_a, of_b): (Vec<&Edge>, Vec<&Edge>) = found.edges.iter().partition(|edge| edge.source == Side::A);
    let mut taken: Vec<(DVec2, DVec2)> = of_b.into_iter().map(turned).collect();
    taken.extend(nearest(context).map(|nearest| (b, b - nearest.foot)));
    let middles: Vec<DVec2> = of_a.into_iter().map(turned).map(|(from, to)| 0.5 * (from + to)).collect();
    let clear = |place: &DVec2| {
        let copy = outline_b.moved(*place - b).sampled();
        let pieces = || copy.iter().zip(copy.iter().cycle().skip(1));
        !pieces().any(|(&p, &q)| taken.iter().any(|&line| cross((p, q), line)))
    };
    let free: Vec<DVec2> = middles.iter().copied().filter(clear).collect();
    let places = if free.is_empty() { middles } else { free };
    // Those that are far from B itself and from each other, and no more than leave A to be seen.
    let places = spread(&places, b);
    sketch.part("copies").weight(Weight::Light);
    for &place in &places {
        sketch.area(&outline_b.moved(place - b), None, Some(Pen::ghost(Role::B).opacity(COPY)));
    }
    if let Some(&last) = places.first() {
        let text = format!("{} moved around {}", context.name(Side::B), context.name(Side::A));
        let label = Label::new("copy", text, Anchor::inside(&outline_b.moved(last - b)), Role::B);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    places
}

/// Some of the places, each as far as can be from `b` and from those before it.
fn spread(places: &[DVec2], b: DVec2) -> Vec<DVec2> {
    let mut taken = vec![b];
    for _ in 0..COPIES.min(places.len()) {
        let room = |p: &DVec2| taken.iter().map(|q| q.distance(*p)).fold(f64::INFINITY, f64::min);
        let widest = places.iter().copied().max_by(|p, q| room(p).total_cmp(&room(q)));
        taken.extend(widest);
    }
    taken.split_off(1)
}

/// Whether two straight pieces cross, each with both ends off the other's line.
fn cross((p, q): (DVec2, DVec2), (r, s): (DVec2, DVec2)) -> bool {
    let apart = |from: DVec2, to: DVec2, a: DVec2, b: DVec2| {
        (to - from).perp_dot(a - from) * (to - from).perp_dot(b - from) < 0.0
    };
    apart(p, q, r, s) && apart(r, s, p, q)
}

/// Draws the way from B's point to the nearest point of the grown A: a length, or, from within, the minimum
/// translation of B.
fn distance(sketch: &mut Sketch, context: &Context, found: &Difference, b: DVec2) {
    let Some(Nearest { foot, text, overlap, .. }) = nearest(context) else { return };
    let (to, role) = (b - foot, Role::Translation);
    if let Some(leg) = leg(found, DVec2::ZERO, foot) {
        sketch.part("right-angle").right_angle(to, -leg, foot);
    }
    sketch.part("distance");
    if overlap {
        sketch.arrow(b, to, Pen::vector(role));
    } else {
        sketch.dimension(b, to, 0.0, Pen::dimension(role).width(1.5));
    }
    sketch.label(Label::new("d", text, Anchor::middle(b, to), role));
}

/// The letter of the point that B shrinks to, its origin: the small one of a name that is a letter.
fn letter_of_b(context: &Context) -> Option<String> {
    let name = context.named(Side::B);
    name.is_symbol().then(|| format!("${}$", name.small()))
}

/// The vertices of A's core, in the world.
fn vertices(context: &Context) -> Vec<DVec2> {
    let Some(body) = context.body(Side::A) else { return Vec::new() };
    body.shape.core.iter().filter_map(|&i| context.vertex(Side::A, i, context.time)).collect()
}
