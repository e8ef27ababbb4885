//! What someone else answered, beside our answer: both pairs of closest points, both normals, and the bodies
//! at the time that was expected.

use crate::collision::{Answer, Expected, Outcome, Separation, Verdict};
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Corner, Label, MARKER, Marker, Pen, Rank, Size, Sketch};
use crate::figure::text::{Quantity, number};
use crate::geometry::{DVec2, Side};
use crate::trace::phrase;

use super::elsewhere::then;
use super::ghosts::ghost;
use super::look_alike::point_alike;
use super::normal::unit_vector;
use super::{Fed, LabelKey, Layer, Options, Shows, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "expected",
    in_words: phrase(["expected", "erwartete Antwort", "réponse attendue", "respuesta esperada"]),
    about: "what someone else answered (`[query] expected`), and our normal and closest points beside it",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[],
    labels: &[
        LabelKey { key: "A'", about: "the first body at the time expected" },
        LabelKey { key: "B'", about: "the second body at the time expected" },
        LabelKey { key: "expected", about: "the outcome, the separation and the time expected" },
        LabelKey {
            key: "ours",
            about: "our separation, beside theirs, if no `separation` or `approach` says it",
        },
        LabelKey { key: "n", about: "our normal" },
        LabelKey { key: "n'", about: "the normal expected" },
    ],
    needs: "`expected` in `[query]`, and a panel in the world's frame",
    fed: |context, _| {
        let given = context.scene.query.expected.is_some() && context.moving_frame().is_none();
        Fed::by_the_scene(given)
    },
    draw,
};

/// By how much a line may be longer or shorter than the number beside it says, page pixels: the width of a
/// line, which nobody sees. Digits that another engine cut off are less.
const SEEN: f64 = 2.0;

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(theirs) = context.scene.query.expected else { return };
    let role = options.role(Role::Now);
    sketch.since(context.answered());
    let shown = bodies(sketch, context, options, &theirs);
    let ours = ours(context);
    if let Some(ours) = &ours {
        sketch.part("ours").line(ours.points[0], ours.points[1], Pen::dimension(Role::Translation));
        sketch.part("ours").marker(ours.points[0], Marker::Disc, Role::Translation, MARKER);
        sketch.part("ours").marker(ours.points[1], Marker::Square, Role::Translation, MARKER);
        // Both numbers stand on the picture, to be compared.
        let is_said = ["separation", super::approach::LAYER.name].iter().any(|layer| sketch.has_layer(layer));
        let own = distance(context, ours);
        let other = |s: f64| format!("= {}", number(s)) != own;
        if theirs.separation.is_some_and(other) && !is_said {
            let anchor = Anchor::Beside { from: ours.points[1], to: ours.points[0], offset: 0.0 };
            let text = format!("$s {own}$");
            sketch.label(Label::new("ours", text, anchor, Role::Translation));
        }
    }
    if let Some([p, q]) = theirs.points {
        sketch.part("expected").line(p, q, Pen::dimension(role));
        sketch.part("expected").marker(p, Marker::Disc, role, MARKER);
        sketch.part("expected").marker(q, Marker::Square, role, MARKER);
    }
    let from = theirs.points.map(|[p, _]| p).or(ours.map(|ours| ours.points[0]));
    if let (Some(n), Some(from)) = (theirs.normal, from) {
        let is_one = |ours: &&Separation| {
            point_alike(*ours.normal, *n) && sketch.on_page(ours.points[0].distance(from)) < SEEN
        };
        if let Some(ours) = ours.as_ref().filter(is_one) {
            normal(sketch, from, *ours.normal, ("n", "$n$, as expected", Role::Translation));
        } else {
            normal(sketch, from, *n, ("n'", "expected $n'$", role));
            if let Some(ours) = &ours {
                normal(sketch, ours.points[0], *ours.normal, ("n", "$n$", Role::Translation));
            }
        }
    }
    let mut lines: Vec<String> = theirs.outcome.map(outcome).into_iter().collect();
    if !shown {
        lines.extend(words(&theirs));
    }
    lines.extend(contradiction(sketch, &theirs));
    if lines.is_empty() {
        return;
    }
    let label = Label { lines, ..Label::new("expected", "", Anchor::Corner(Corner::TopLeft), role) };
    sketch.label(match theirs.points {
        Some([p, _]) => Label { anchor: Anchor::point(p), ..label },
        // It is of no place, least of all of our contact.
        None => label.rank(Rank::Note).size(Size::Note),
    });
}

/// The bodies at the time expected, where they are elsewhere then; whether any is.
fn bodies(sketch: &mut Sketch, context: &Context, options: &Options, theirs: &Expected) -> bool {
    // Where a question is about one moment, a time that a log has beside it is no answer.
    let is_asked = context.asks_for_a_hit();
    let time = theirs.time.filter(|time| is_asked && (0.0..=1.0).contains(time));
    let Some(time) = time else { return false };
    let mut shown = false;
    let mut separation = separation_in_words(theirs);
    for side in context.sides() {
        if let Some(outline) = then(context, side, time) {
            let mut lines = at_expected(context, side, time);
            lines.extend(separation.take());
            ghost(sketch, options, side, &outline, lines);
            shown = true;
        }
    }
    shown
}

/// The label of a body at the time expected; below each other where the name is a word.
fn at_expected(context: &Context, side: Side, time: f64) -> Vec<String> {
    let name = context.named(side);
    let then = format!("expected at $t = {}$", number(time));
    if name.is_symbol() { vec![format!("{} {then}", name.primed(0))] } else { vec![name.primed(0), then] }
}

/// The pair of our answer: at its moment, at the first contact, or at the closest approach.
fn ours(context: &Context) -> Option<Separation> {
    let run = context.run();
    match &run.answer {
        Answer::Impact(impact) if impact.outcome == Outcome::Miss => {
            context.separation_at(context.closest()?.time)?.separation().copied()
        }
        Answer::Overlap(_) => context.separation_at(context.time)?.separation().copied(),
        _ => run.separation().copied(),
    }
}

/// What stands after the letter of our separation; at the first contact what that leaves of it.
fn distance(context: &Context, ours: &Separation) -> String {
    let touching = context.hit_time().and_then(|hit| context.separation_at(hit.lo));
    let found = touching.as_ref().and_then(|run| run.separation()).unwrap_or(ours);
    Quantity::separation(found).equals(context.scene.query_at(context.time).rounding())
}

/// Draws a normal with its name.
fn normal(sketch: &mut Sketch, from: DVec2, n: DVec2, (key, text, role): (&'static str, &str, Role)) {
    unit_vector(sketch, (from, n), None, Label::new(key, text, Anchor::point(from), role));
}

/// What is expected in lines of a label, where no body is shown at the time.
fn words(theirs: &Expected) -> Vec<String> {
    let time = theirs.time.map(|t| format!("expected $t = {}$", number(t)));
    separation_in_words(theirs).into_iter().chain(time).collect()
}

/// What is expected to come out, as a line of a label.
fn outcome(theirs: Verdict) -> String {
    format!("expected: {}", theirs.word())
}

/// How far the points expected are apart, where that is not what is expected of the separation.
fn contradiction(sketch: &Sketch, theirs: &Expected) -> Option<String> {
    let (separation, [p, q]) = (theirs.separation?, theirs.points?);
    let apart = p.distance(q);
    let is_seen = sketch.on_page((apart - separation.abs()).abs()) > SEEN;
    is_seen.then(|| format!("their points ${}$ apart", number(apart)))
}

/// The separation that is expected, as a line of a label.
fn separation_in_words(theirs: &Expected) -> Option<String> {
    theirs.separation.map(|s| format!("expected $s = {}$", number(s)))
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn a_normal_that_is_as_expected_is_drawn_once() {
        for (normal, keys) in
            [("[1, 0]", vec!["n"]), ("[0.99995, 0.01]", vec!["n"]), ("[0.6, 0.8]", vec!["n", "n'"])]
        {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1 }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0] }}
                query = {{ kind = 'separation', of = ['A', 'B'], expected = {{ normal = {normal} }} }}
                panels = [{{ layers = ['shapes', 'expected'] }}]"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            let labels = labels(&figure);
            let found: Vec<_> = ["n", "n'"].into_iter().filter(|key| labels.contains_key(key)).collect();
            assert_eq!(found, keys, "{normal}");
            assert_eq!(labels["n"].0.contains("as expected"), keys.len() == 1, "{labels:?}");
        }
    }

    #[test]
    fn both_answers_stand_side_by_side() {
        let text = |expected: &str| {
            format!(
                "[shapes.A]\nkind = 'circle'\nradius = 1\n[shapes.B]\nkind = 'circle'\nradius = 1\n\
                 position = [4, 0]\n[query]\nkind = 'separation'\nof = ['A', 'B']\n{expected}\n\
                 [[panels]]\nlayers = ['shapes', 'expected']"
            )
        };
        let given =
            "expected = { separation = 2.25, normal = [0, 1], points = { A = [1, 0.5], B = [3.25, 0.5] } }";
        let scene = open_text("s.toml", &text(given)).unwrap().scene;
        let plan_of = plan(&scene).unwrap();
        let figure = draw(&plan_of, plan_of.theme, "s");
        let labels = labels(&figure);
        assert!(labels.contains_key("n") && labels.contains_key("n'"), "{labels:?}");
        assert_eq!(labels["expected"].1, 2.25);
        assert_eq!(labels["ours"].1, 2.0);
        let counts = ["ours", "expected", "normal"].map(|part| paths(&figure.drawing.items, part).len());
        assert!(counts[0] >= 3 && counts[0] == counts[1] && counts[2] >= 2, "{counts:?}");
        let at = figure.panels[0].frame.page(crate::geometry::DVec2::new(1.0, 0.5));
        let label = figure.panels[0].placed.iter().find(|placed| placed.key == "expected").unwrap();
        assert!((label.bounds.center() - at).length() < 80.0, "it stands at the point that was expected");
        for list in ["'expected', 'separation'", "'separation', 'expected'"] {
            let text = text(given).replace("'shapes', 'expected'", list);
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let labels = self::labels(&draw(&plan, plan.theme, "s"));
            assert!(!labels.contains_key("ours"), "{list}: `separation` says it");
        }
        let silent = open_text("s.toml", &text("")).unwrap().scene;
        assert!(plan(&silent).is_err(), "nothing is expected");
    }

    #[test]
    fn our_separation_stands_beside_theirs_of_a_miss_and_of_a_hit() {
        for (y, spin, expected, more, says) in [
            (4.0, 0.0, "separation = 0.5", "", Some("$s = 2$")),
            (4.0, 0.0, "separation = 0.5", ", 'approach'", None),
            (4.0, 0.0, "time = 0.5", "", None),
            (0.25, 45.0, "separation = 0.5", "", Some("$s = 0$")),
        ] {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = [9, 0], position = [-4, 0],
                    angular_velocity_deg = {spin} }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [0, {y}] }}
                panels = [{{ layers = ['shapes', 'expected'{more}] }}]
                [query]\nkind = 'time-of-impact'\nof = ['A', 'B']\nexpected = {{ {expected} }}"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let labels = labels(&draw(&plan, plan.theme, "s"));
            let ours = labels.get("ours").map(|label| label.0.as_str());
            assert_eq!(ours, says, "{y}, {expected}{more}");
        }
    }

    #[test]
    fn points_that_are_not_as_far_apart_as_was_said_say_so() {
        for (separation, says) in
            [("0.35", true), ("1.05", false), ("1.0499", false), ("-1.05", false), ("-0.35", true)]
        {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1 }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0] }}
                panels = [{{ layers = ['shapes', 'expected'] }}]
                [query]\nkind = 'separation'\nof = ['A', 'B']
                expected = {{ separation = {separation}, points = {{ A = [1, 0.5], B = [2.05, 0.5] }} }}"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            let placed = figure.panels[0].placed.iter().flat_map(|label| &label.lines);
            let said = placed.filter(|(_, line)| line.markup == "their points $1.05$ apart").count();
            assert_eq!(said, usize::from(says), "{separation}");
        }
    }

    #[test]
    fn what_was_expected_of_an_overlap_is_drawn_beside_its_depth() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            shapes.B = { kind = 'circle', radius = 1, position = [1.5, 0] }
            panels = [{ layers = ['shapes', 'expected'] }]
            [query]\nkind = 'overlap'\nof = ['A', 'B']
            expected = { outcome = 'apart', normal = [0, 1], separation = 0.25 }";
        let scene = open_text("s.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let labels = labels(&draw(&plan, plan.theme, "s"));
        assert!(["n", "n'", "ours"].iter().all(|key| labels.contains_key(key)), "{labels:?}");
        assert!(labels["expected"].0.starts_with("expected: apart"), "{labels:?}");
    }

    #[test]
    fn what_was_expected_of_no_place_does_not_stand_at_our_contact() {
        for (given, says) in [
            ("separation = 0.01", "expected $s = 0.01$"),
            ("time = 0.8", "$A$ expected at $t = 0.8$"),
            ("time = 1.5", "expected $t = 1.5$"),
            ("separation = 0.01, time = 0.8", "$A$ expected at $t = 0.8$"),
        ] {
            let text = format!(
                "[shapes.A]\nkind = 'circle'\nradius = 1\nvelocity = [4, 0]\n[shapes.B]\nkind = 'circle'\n\
                 radius = 1\nposition = [4, 0]\n[query]\nkind = 'linear-sweep'\nof = ['A', 'B']\n\
                 expected = {{ {given} }}\n[[panels]]\nlayers = ['shapes', 'expected']"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            let panel = &figure.panels[0];
            let said = |placed: &&crate::figure::Placed| placed.lines[0].1.markup == says;
            let label = panel.placed.iter().find(said).unwrap_or_else(|| panic!("{given}: {panel:?}"));
            let contact = panel.frame.page(crate::geometry::DVec2::new(3.0, 0.0));
            let off = label.bounds.center() - contact;
            assert!(off.length() > 60.0, "{given}: {off:?}");
            // At the pose that it is about, where one is drawn.
            let beside = panel.placed.iter().filter(|label| label.key == "expected").count();
            assert_eq!(beside, usize::from(!says.starts_with("$A$")), "{given}");
            let separation = label.lines.iter().any(|(_, line)| line.markup == "expected $s = 0.01$");
            assert_eq!(separation, given.contains("separation"), "{given}");
        }
    }
}
