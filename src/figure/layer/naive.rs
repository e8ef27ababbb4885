//! What a naive method claims, beside the answer that is proved: the bodies where it would have them touch.

use crate::collision::naive::{Claim, Naive, WORDS, method};
use crate::collision::{Answer, Outcome};
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Rank, Size, Sketch, Wash, Weight};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::trace::phrase;

use super::look_alike::point_alike;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

/// The option that names the method.
const METHOD: &str = "method";

/// Opacity of the fill of a body that is where a method says.
const FAINT: f64 = 0.08;

/// What a claim moves a body by without anyone seeing it, page pixels: less than the width of its outline.
const UNSEEN: f64 = 2.0;

pub(super) const LAYER: Layer = Layer {
    name: "naive",
    in_words: phrase(["naive", "naive Antwort", "réponse naïve", "respuesta ingenua"]),
    about: "what a method claims that looks right and is wrong on some pairs: bodies where it would have \
        them just touch, for a contact in time where it sees it, or at the end",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[OptionSpec {
        name: METHOD,
        takes: Takes::Word(&WORDS),
        default: "the first that takes the question",
        about: "the method: the largest gap between projections on edges' normals as the distance; the way \
            out along the line of the centres; a walk to the nearest point that ends when it gains less \
            than 10⁻⁶; a box's closest point by clamping, wherever the circle's centre is; B ⊖ A with one \
            supporting vertex an edge, or merged from the first vertices of both; positions in single \
            precision; the root of what the squares of two circles leave; no length below 0.005; the \
            deepest vertex as the one contact; a look at both frames alone; the ray of A's centre against a \
            B that was not grown; conservative advancement without the spin",
    }],
    labels: &[LabelKey { key: "naive", about: "what the method claims" }],
    needs: "a question that the method takes, bodies that it takes, and a panel in the world's frame",
    fed: |context, options| {
        let is_here = context.moving_frame().is_none();
        Fed::by_the_scene(is_here && claim(context, options).is_some())
    },
    draw,
};

/// The method of a panel with what it claims.
fn claim(context: &Context, options: &Options) -> Option<(&'static Naive, Claim)> {
    let method = method(options.word(METHOD, ""), context.scene.query.kind)?;
    let bodies = [context.body(Side::A)?, context.body(Side::B)?];
    Some((method, (method.claims)(bodies, context.time)?))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((method, claim)) = claim(context, options) else { return };
    sketch.since(context.answered());
    let right = is_right(context, &claim);
    let (said, at, by) = match claim {
        Claim::Separation(s, n) => (format!("$s = {}$", number(s)), context.time, Some(n * -s)),
        Claim::Hit(t) => (format!("hit at $t = {}$", number(t)), t, None),
        Claim::Miss => ("no hit".to_owned(), 1.0, None),
        Claim::Contact(at) => return contact(sketch, method, at, options.role(Role::Now)),
        Claim::Nothing => ("division by 0".to_owned(), context.time, None),
    };
    let role = options.role(Role::Now);
    let mut named = None;
    for side in context.sides() {
        let Some(outline) = context.outline(side, at) else { continue };
        // Parted or brought together by the claim, B would just touch A.
        let outline = by.filter(|_| side == Side::B).map_or(outline.clone(), |by| outline.moved(by));
        let is_elsewhere =
            by.is_some() && side == Side::B || context.pose(side, at) != context.pose(side, context.time);
        if is_elsewhere {
            let pen = Some(Pen::ghost(role));
            let wash = Some(Wash::faint(role, FAINT));
            sketch.part(part("claimed", side)).weight(Weight::Light).area(&outline, wash, pen);
        }
        if named.is_none() || is_elsewhere {
            named = Some(outline);
        }
    }
    let Some(outline) = named else { return };
    let unmoved = by.is_some_and(|by| by.length() < sketch.px(UNSEEN));
    let gap = context.separation_at(context.time).filter(|_| unmoved);
    let gap = gap.and_then(|run| run.separation().map(|s| s.points));
    // What moves nothing says so where it should have been.
    let anchor = gap.map_or_else(|| Anchor::inside(&outline), |[p, q]| Anchor::middle(p, q));
    label(sketch, method, (&said, right), anchor, role);
}

/// Draws the one point at which a method would have the bodies touch.
fn contact(sketch: &mut Sketch, method: &Naive, at: DVec2, role: Role) {
    sketch.part("claimed").marker(at, Marker::Diamond, role, MARKER);
    label(sketch, method, ("one point", false), Anchor::point(at), role);
}

/// Whether a claim is true of these bodies, as it is written: a method that is wrong of others may well be
/// right here, and a reader looks for an error that is none.
fn is_right(context: &Context, claim: &Claim) -> bool {
    let exact = || context.separation_at(context.time).and_then(|run| run.separation().copied());
    match claim {
        Claim::Separation(s, n) => exact()
            .is_some_and(|exact| number(exact.separation) == number(*s) && point_alike(*exact.normal, *n)),
        Claim::Hit(t) => context.hit_time().is_some_and(|hit| number(hit.lo) == number(*t)),
        Claim::Miss => {
            matches!(&context.run().answer, Answer::Impact(impact) if impact.outcome == Outcome::Miss)
        }
        Claim::Contact(_) | Claim::Nothing => false,
    }
}

/// Writes what a method claims where it would have a body, or a point, and whether that is right.
fn label(sketch: &mut Sketch, method: &Naive, (said, right): (&str, bool), anchor: Anchor, role: Role) {
    let mut lines = vec![format!("{}:", method.name.replace('-', " ")), said.to_owned()];
    lines.extend(right.then(|| "right here".to_owned()));
    let label = Label { lines, ..Label::new("naive", "", anchor, role) };
    sketch.label(label.rank(Rank::Name).size(Size::Note));
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{Figure, draw, plan};
    use crate::scene::open_text;

    fn figure(a: &str, b: &str, query: &str, layer: &str) -> Option<Figure> {
        let text = format!(
            "shapes.A = {{ {a} }}\nshapes.B = {{ {b} }}\nquery = {{ kind = '{query}', of = ['A', 'B'] }}\n\
             [[panels]]\ntime = 'start'\nlayers = ['shapes', {layer}]"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).ok()?;
        Some(draw(&plan, plan.theme, "s"))
    }

    const BOX: &str = "kind = 'box', half_extents = [1, 1]";
    const BALL: &str = "kind = 'circle', radius = 0.8, position = [1.7, 1.7]";

    #[test]
    fn a_claim_stands_at_the_body_that_it_would_move() {
        let figure = figure(BOX, BALL, "separation", "'naive'").unwrap();
        let (text, _) = &labels(&figure)["naive"];
        assert!(text.contains("largest gap") && text.contains("-0.1"), "{text}");
        assert_eq!(paths(&figure.drawing.items, "claimed-B").len(), 1);
        assert!(paths(&figure.drawing.items, "claimed-A").is_empty());
    }

    #[test]
    fn a_method_that_is_right_of_these_bodies_says_so() {
        let right = |b: &str, method: &str| {
            let layer = format!("{{ layer = 'naive', method = '{method}' }}");
            labels(&figure(BOX, b, "separation", &layer).unwrap())["naive"].0.contains("right here")
        };
        assert!(!right(BALL, "largest-gap"), "at a corner it takes an edge");
        assert!(right("kind = 'circle', radius = 0.8, position = [3, 0.5]", "largest-gap"));
        let moving = |b: &str| {
            let bullet = "kind = 'circle', radius = 0.2, position = [-3, 0], velocity = [6, 0]";
            labels(&figure(bullet, b, "linear-sweep", "'naive'").unwrap())["naive"].0.clone()
        };
        assert!(!moving("kind = 'aabb', half_extents = [0.1, 1]").contains("right here"));
        assert!(moving("kind = 'aabb', half_extents = [0.1, 1], position = [0, 9]").contains("right here"));
    }

    #[test]
    fn a_claim_that_moves_nothing_stands_at_the_gap() {
        let far = |x: f64| format!("{BOX}, position = [{x}, 0]");
        let method = "{ layer = 'naive', method = 'single-precision' }";
        let drawn = figure(&far(16_777_216.0), &far(16_777_218.7), "separation", method).unwrap();
        assert_eq!(labels(&drawn)["naive"].1, 0.0);
        assert_eq!(paths(&drawn.drawing.items, "claimed-B").len(), 1, "where B is");
        let at = drawn.panels[0].frame.page(crate::geometry::DVec2::new(16_777_217.35, 0.0));
        let label = drawn.panels[0].placed.iter().find(|placed| placed.key == "naive").unwrap();
        let off = label.bounds.center() - at;
        assert!(off.length() < 0.5 * drawn.panels[0].frame.scale, "{off:?}");
    }

    #[test]
    fn a_flight_through_a_wall_ends_behind_it() {
        let bullet = "kind = 'circle', radius = 0.2, position = [-3, 0], velocity = [6, 0]";
        let wall = "kind = 'aabb', half_extents = [0.1, 1]";
        let drawn = figure(bullet, wall, "linear-sweep", "'naive'").unwrap();
        assert!(labels(&drawn)["naive"].0.contains("no hit"));
        assert_eq!(paths(&drawn.drawing.items, "claimed-A").len(), 1);
        assert!(figure(bullet, wall, "linear-sweep", "{ layer = 'naive', method = 'centres' }").is_none());
    }

    #[test]
    fn one_contact_is_a_point_and_moves_no_body() {
        let on_it = "kind = 'box', half_extents = [1, 1], position = [0.5, 1.75]";
        let method = "{ layer = 'naive', method = 'deepest-vertex' }";
        let drawn = figure(BOX, on_it, "contact", method).unwrap();
        assert!(labels(&drawn)["naive"].0.contains("one point"));
        assert!(paths(&drawn.drawing.items, "claimed-B").is_empty());
        assert_eq!(paths(&drawn.drawing.items, "claimed").len(), 1);
    }

    #[test]
    fn bodies_with_one_centre_have_no_way_along_it() {
        let drawn = figure(BOX, BOX, "separation", "{ layer = 'naive', method = 'centres' }").unwrap();
        assert!(labels(&drawn)["naive"].0.contains("division by 0"));
        let discs = figure(BALL, BALL, "separation", "'naive'");
        assert!(discs.is_none(), "two discs have no edge");
    }
}
