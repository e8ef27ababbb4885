//! The nearest point of B ⊖ A: how far the origin is from it, `p_B` − `p_A` = s n, where the bodies are
//! apart; where they overlap the minimum translation of B, −s n, which takes B ⊖ A along until that point is
//! at the origin. At a step of a sweep, where the estimate moves and not the difference, from the estimate.

use std::f64::consts::PI;

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::{Difference, Edge};
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Size, Sketch, Weight, angle_of};
use crate::figure::text::{asked_distance, distance_or_depth, number};
use crate::geometry::{DVec2, Side};
use crate::scene::NOTES;
use crate::trace::{Event, phrase};

use super::difference::difference;
use super::polytope::PUSHED;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, tied};

/// Radius of the arc of the half turn, page pixels: clear of the origin's ring.
const TURN: f64 = 26.0;

/// The least length that can be told from none, page pixels: half the width of an outline.
const UNSEEN: f64 = 1.0;

pub(super) const LAYER: Layer = Layer {
    name: "closest",
    in_words: phrase(["closest", "nächster Punkt", "point le plus proche", "punto más cercano"]),
    about: "distance of the origin, or a sweep's estimate, from B ⊖ A; inside, the minimum translation",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "rival",
            takes: Takes::Flag,
            default: "false",
            about: "of bodies that overlap, the next local minimum: a longer way to an edge, square to it",
        },
        OptionSpec {
            name: "pushed",
            takes: Takes::Flag,
            default: "false",
            about: "of bodies that overlap, the edge of B ⊖ A that is at O when B is pushed out, dotted",
        },
        OptionSpec {
            name: "turned",
            takes: Takes::Flag,
            default: "false",
            about: "A turned half round, dotted: where \"grown\", turned half round about its point, has it",
        },
        OptionSpec {
            name: "text",
            takes: Takes::Lines,
            default: "by the algorithm",
            about: "lines of the label in this panel",
        },
    ],
    labels: &[
        LabelKey { key: "d", about: "distance or depth" },
        LabelKey { key: "rival", about: "length of the next longer way out" },
        LabelKey { key: "pushed", about: "the nearest edge when B is pushed out" },
        LabelKey { key: "turned", about: "the first body turned half round, with turned" },
        LabelKey { key: "half-turn", about: "the half turn about O, with turned" },
    ],
    needs: "two convex bodies",
    fed: |context, options| nearest(context).map_or(Fed::Never, |found| beside(context, options, &found)),
    draw,
};

/// Whether all that a scene wants beside the way can be drawn.
fn beside(context: &Context, options: &Options, Nearest { foot, overlap, .. }: &Nearest) -> Fed {
    let wants = |option: &&'static str| options.flag(option, false);
    let without = |option, why| Fed::Without { option, why };
    if !NOTES {
        return Fed::Yes;
    }
    if let Some(option) = ["rival", "pushed"].into_iter().find(wants).filter(|_| !overlap) {
        return without(option, "the bodies do not overlap");
    }
    let (from, found) = (context.estimate(), difference(context, context.difference_time()));
    let lacks = |option| {
        wants(&option)
            && match (&found, option) {
                (Some(found), "rival") => longer_way(found, from, foot.length()).is_none(),
                (Some(found), _) => facing(found, from, *foot).is_none(),
                (None, _) => true,
            }
    };
    if lacks("rival") {
        return without("rival", "there is no longer way that is a local minimum");
    }
    if lacks("pushed") {
        return without("pushed", "the nearest point is on no edge");
    }
    Fed::Yes
}

/// How far a point of the outline may be from the edge that it lies on, in parts of its distance from the
/// origin: both are rounded a few times.
const SAME: f64 = 1e-9;

/// The nearest point of B ⊖ A.
pub(super) struct Nearest {
    /// From the origin, or the estimate, to that point.
    pub(super) foot: DVec2,
    /// What the label says of it.
    pub(super) text: String,
    /// Whether the bodies overlap, by a proved depth.
    pub(super) overlap: bool,
    /// How many ways out are as short, of bodies that overlap; 0 are all there are.
    pub(super) ties: u32,
}

/// From the origin at the panel's moment to the nearest point of B ⊖ A then: the last, so the best, candidate
/// of the algorithm; for round bodies, whose radius candidates leave out, the answer's. And its label.
pub(super) fn nearest(context: &Context) -> Option<Nearest> {
    let run = context.separation_at(context.time)?;
    let answer = *run.separation()?;
    let candidate = run.events().filter(|e| matches!(e, Event::CandidateImproved { .. })).last();
    if let Some(candidate) = candidate {
        run.tells(|event| std::ptr::eq(event, candidate));
    }
    let foot = match candidate {
        Some(Event::CandidateImproved { foot, distance, .. }) if *distance == answer.separation => *foot,
        _ => answer.normal * answer.separation,
    };
    let text = asked_distance(context, &answer)
        .unwrap_or_else(|| distance_or_depth(&answer, context.scene.query_at(context.time).rounding()));
    let overlap = answer.bounds.hi < 0.0;
    Some(Nearest { foot, text, overlap, ties: if overlap { answer.ties } else { 1 } })
}

/// What is said beside the length of bodies that seem to touch on the page, where they are known not to.
pub(super) fn unseen(sketch: &Sketch, context: &Context, answer: &Separation) -> Option<String> {
    let rounding = context.scene.query_at(context.time).rounding();
    let touches = answer.bounds.lo <= rounding && -rounding <= answer.bounds.hi;
    let is_seen = sketch.on_page(answer.separation.abs()) >= UNSEEN;
    (!touches && !is_seen).then(|| "(too small to be seen)".to_owned())
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(Nearest { foot, text, overlap, ties }) = nearest(context) else { return };
    let role = options.role(Role::Translation);
    let run = context.separation_at(context.time);
    sketch.since(run.as_ref().map(|run| run.end()));
    let from = context.estimate();
    let to = from + foot;
    right_angle(sketch, context, from, foot);
    if options.flag("turned", false) {
        half_turned(sketch, context, foot);
    }
    sketch.part("closest");
    if overlap {
        if options.flag("rival", false) {
            rival(sketch.since(run.as_ref().map(|run| run.end())), context, from, foot.length());
        }
        sketch.since(run.map(|run| run.end()));
        if options.flag("pushed", false) {
            pushed(sketch, context, from, foot);
        }
        sketch.part("closest").arrow(to, from, Pen::vector(role));
    } else {
        sketch.dimension(from, to, 0.0, Pen::dimension(role).width(1.5));
    }
    sketch.detail(&[from, to]);
    let answer = context.separation_at(context.time).and_then(|run| run.separation().copied());
    let said = answer.and_then(|answer| unseen(sketch, context, &answer));
    let lines = std::iter::once(text).chain(said).chain(tied(ties)).collect();
    let label = Label { lines, ..Label::new("d", "", Anchor::middle(from, to), role) };
    sketch.label(match options.words("text") {
        Some(lines) => label.given(lines),
        None => label,
    });
}

/// Draws A as it lies in B ⊖ A where that is the grown A turned half round about B's origin: x is at b − x;
/// and about O, where b is then, the half turn of the way to the nearest point.
fn half_turned(sketch: &mut Sketch, context: &Context, foot: DVec2) {
    let (Some(b), Some(outline)) =
        (context.pose(Side::B, context.time), context.outline(Side::A, context.time))
    else {
        return;
    };
    let turned = outline.turned_about(DVec2::ZERO).moved(b.position);
    sketch.part("turned").weight(Weight::Light).area(&turned, None, Some(Pen::ghost(Role::A)));
    let text = format!("{} turned", context.name(Side::A));
    let label = Label::new("turned", text, Anchor::inside(&turned), Role::A);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
    let (radius, start) = (sketch.px(TURN), angle_of(-foot));
    sketch.part("half-turn").weight(Weight::Light);
    sketch.arc_arrow(DVec2::ZERO, radius, start, PI, Pen::dimension(Role::Ink));
    let arc = Anchor::Arc { center: DVec2::ZERO, radius, start, sweep: PI };
    let label = Label::new("half-turn", "half a turn", arc, Role::Ink);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Draws the nearest edge of B ⊖ A moved by the minimum translation of B, dotted: through O. All of B ⊖ A
/// goes along, and its outline there would be a second picture; where an arc is nearest there is no edge.
fn pushed(sketch: &mut Sketch, context: &Context, from: DVec2, foot: DVec2) {
    let found = difference(context, context.difference_time());
    let Some((p, q)) = found.and_then(|found| facing(&found, from, foot)) else { return };
    let (p, q, role) = (p - foot, q - foot, Role::Difference);
    sketch.part("pushed").weight(Weight::Light).line(p, q, Pen::ghost(role));
    let label = Label::new("pushed", PUSHED, Anchor::middle(from, q), role);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// A way out of B ⊖ A from a point inside it, square to an edge.
pub(super) struct WayOut {
    /// The edge of B ⊖ A.
    pub(super) edge: Edge,
    /// How long the way is, in world units.
    pub(super) length: f64,
}

/// The next way out of B ⊖ A that is longer than `least`, from a point inside it: a local minimum of the way
/// to its boundary, as its end is the foot within an edge: from one on a vertex the next edge comes nearer. A
/// line of another edge may be nearer, with its foot beyond the edge.
pub(super) fn longer_way(found: &Difference, from: DVec2, least: f64) -> Option<WayOut> {
    let way = |edge: &Edge| {
        let (p, q) = found.drawn(edge);
        let (length, along) = ((p - from).dot(edge.normal), q - p);
        let share = (from + edge.normal * length - p).dot(along) / along.length_squared();
        let longer = length > least * (1.0 + SAME) && (SAME..1.0 - SAME).contains(&share);
        longer.then_some(WayOut { edge: *edge, length })
    };
    found.edges.iter().filter_map(way).min_by(|a, b| a.length.total_cmp(&b.length))
}

/// What is said of a longer way out.
pub(super) fn longer(length: f64) -> String {
    format!("${}$, longer", number(length))
}

/// Draws the next longer way from inside B ⊖ A square to one of its edges, with its length.
fn rival(sketch: &mut Sketch, context: &Context, from: DVec2, least: f64) {
    let Some(found) = difference(context, context.difference_time()) else { return };
    let Some(WayOut { edge, length }) = longer_way(&found, from, least) else { return };
    let way = edge.normal * length;
    let to = from + way;
    sketch.part("right-angle").right_angle(to, edge.to - edge.from, -way);
    sketch.part("rival").dimension(from, to, 0.0, Pen::dimension(Role::Muted));
    let anchor = Anchor::middle(from, to);
    sketch.label(Label::new("rival", longer(length), anchor, Role::Muted).size(Size::Note));
}

/// Marks the right angle at the nearest point, where that is on an edge that the way there is square to; at a
/// vertex it need be square to none.
fn right_angle(sketch: &mut Sketch, context: &Context, from: DVec2, foot: DVec2) {
    let found = difference(context, context.difference_time());
    if let Some(leg) = found.and_then(|found| leg(&found, from, foot)) {
        sketch.part("right-angle").right_angle(from + foot, leg, -foot);
    }
}

/// The edge of B ⊖ A that the way `foot` ends on and is square to; `None` where it is to none.
fn facing(found: &Difference, from: DVec2, foot: DVec2) -> Option<(DVec2, DVec2)> {
    let (to, size) = (from + foot, foot.length());
    found.edges.iter().map(|edge| found.drawn(edge)).find(|(p, q)| {
        let along = *q - *p;
        let share = (to - *p).dot(along) / along.length_squared();
        let off = (to - *p).perp_dot(along).abs() / along.length();
        let square = along.dot(foot).abs() <= SAME * size * along.length();
        square && (0.0..=1.0).contains(&share) && off <= SAME * size
    })
}

/// From the end of the way `foot` along the edge of B ⊖ A that it is square to; `None` where it is to none.
pub(super) fn leg(found: &Difference, from: DVec2, foot: DVec2) -> Option<DVec2> {
    let to = from + foot;
    let (p, q) = facing(found, from, foot)?;
    Some(if to.distance_squared(p) > to.distance_squared(q) { p - to } else { q - to })
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Contour, Path, Segment};
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    #[test]
    fn of_two_edges_that_face_each_other_one_right_angle_is_marked() {
        let text = "shapes.A = { kind = 'box', half_extents = [2, 1] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [0.5, 1.5] }
            query = { kind = 'separation', of = ['A', 'B'] }
            panels = [{ layers = ['separation'] },
                { space = 'configuration', layers = [{ layer = 'closest', text = 'out' }] }]";
        let scene = open_text("marks.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        assert_eq!(paths(&figure.drawing.items, "right-angle").len(), 2, "one in either panel");
        // The label of the last panel, where the scene gives it a text.
        assert_eq!(labels(&figure)["d"].0, "out");
    }

    #[test]
    fn a_rival_and_a_pushed_edge_that_are_not_there_are_told() {
        let told = |bodies: &str, option: &str| {
            let text = format!(
                "{bodies}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration', layers = ['difference',
                    {{ layer = 'closest', {option} = true }}] }}]"
            );
            let scene = open_text("told.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let drawn = paths(&draw(&plan, plan.theme, "told").drawing.items, option).len();
            let notes = plan.warnings.iter().map(|note| note.fault.to_string()).collect::<String>();
            assert_eq!(notes.is_empty(), drawn > 0, "{notes}");
            notes
        };
        let circles = "shapes.A = { kind = 'circle', radius = 2 }
            shapes.B = { kind = 'circle', radius = 1, position = [1, 0.5] }";
        let boxes = "shapes.A = { kind = 'box', half_extents = [2, 1] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [0.5, 1.5] }";
        let apart = boxes.replace("1.5]", "2.5]");
        // Straight down it is 0.35, on a vertex, and beside that less.
        let at_a_vertex =
            "shapes.A = { kind = 'polygon', vertices = [[-1.5, 0], [0, -0.5], [1.5, 0], [0, 0.5]] }
            shapes.B = { kind = 'polygon', vertices = [[-0.8, -0.6], [0.9, -0.6], [0.9, 0.2], [-0.2, 1.1]],
                position = [0.8, 0.75] }";
        assert_eq!(told(at_a_vertex, "rival"), "");
        for (option, why) in [
            ("rival", "there is no longer way that is a local minimum"),
            ("pushed", "the nearest point is on no edge"),
        ] {
            let begin = format!("`{option}` of `closest` draws nothing: ");
            assert_eq!(told(circles, option), format!("{begin}{why}"));
            assert_eq!(told(&apart, option), format!("{begin}the bodies do not overlap"));
            assert_eq!(told(boxes, option), "");
        }
    }

    #[test]
    fn an_arrow_ends_at_the_origin_itself_whose_ring_opens_for_it() {
        let text = "shapes.A = { kind = 'box', half_extents = [2, 1] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [0.5, 1.5] }
            query = { kind = 'separation', of = ['A', 'B'] }
            panels = [{ space = 'configuration', layers = ['difference', 'closest', 'origin'] }]";
        let scene = open_text("marks.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "marks");
        let o = figure.panels[0].frame.page(DVec2::ZERO);
        let arrow = paths(&figure.drawing.items, "closest");
        let tip = |path: &&&Path| matches!(&path.contour, Contour::Segments(s) if s[0] == Segment::Move(o));
        assert_eq!(arrow.iter().filter(tip).count(), 1, "a head whose point is O: {arrow:?}");
        let origin = paths(&figure.drawing.items, "origin");
        let rings = origin.iter().filter(|path| path.stroke.is_some());
        let whole = |path: &&&Path| matches!(path.contour, Contour::Circle { .. });
        assert_eq!(rings.clone().count(), 1);
        assert_eq!(rings.filter(whole).count(), 0, "the ring is open");
    }
}
