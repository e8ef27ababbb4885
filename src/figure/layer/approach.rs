//! How near a miss came: both bodies at their closest, and how far apart they are then.
//!
//! In configuration space, where bodies that do not turn leave B ⊖ A as it is, the same is the way from the
//! origin's place on the ray to the nearest point of B ⊖ A.

use crate::drawing::Role;
use crate::figure::again::Nearest;
use crate::figure::context::{Approach, Context};
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Sketch};
use crate::figure::text::{Quantity, number};
use crate::geometry::{DVec2, Side};
use crate::scene::{Space, When};
use crate::trace::phrase;

use super::elsewhere;
use super::{Fed, LabelKey, Layer, ONE_OF_SEVERAL, Options, Shows, Tells, ghosts};

/// Why a panel of configuration space has no closest approach, where a body turns.
const ANOTHER_DIFFERENCE: &str = "the bodies turn, and B ⊖ A is another one at their closest";

pub(super) const LAYER: Layer = Layer {
    name: "approach",
    in_words: phrase(["approach", "größte Annäherung", "approche la plus proche", "máxima aproximación"]),
    about: "how near a miss came: the bodies at their closest, and their distance then",
    shows: Shows::Anywhere,
    tells: Tells::Found,
    options: &[],
    labels: &[
        LabelKey { key: "A'", about: "the first body then" },
        LabelKey { key: "B'", about: "the second body then" },
        LabelKey { key: "d", about: "the least distance, and when it is" },
    ],
    needs: "a question for the first contact",
    fed: |context, _| match context.closest() {
        Some(closest) if !can_be_seen(context, &closest) => Fed::not_here(ANOTHER_DIFFERENCE),
        closest => Fed::by_the_answer(closest.is_some(), context.asks_for_a_hit()),
    },
    draw,
};

/// Whether the panel shows the place where the bodies are closest: B ⊖ A must be the one of that moment.
fn can_be_seen(context: &Context, closest: &Approach) -> bool {
    *context.space != Space::Configuration || !context.turns() || context.time == closest.time
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(closest) = context.closest() else { return };
    sketch.since(context.known(&When::Closest));
    if *context.space == Space::Configuration {
        on_the_ray(sketch, context, options, &closest);
    } else {
        in_the_world(sketch, context, options, &closest);
    }
}

/// Draws the bodies that are elsewhere then, and the distance between their closest points.
fn in_the_world(sketch: &mut Sketch, context: &Context, options: &Options, closest: &Approach) {
    for side in context.sides() {
        if let Some(outline) = elsewhere::then(context, side, closest.time) {
            let then = number(closest.time);
            ghosts::elsewhere(sketch, context, options, (side, closest.time, &then), &outline);
        }
    }
    let [p, q] = closest.points;
    let role = options.role(Role::Translation);
    sketch.part("approach").dimension(p, q, 0.0, Pen::dimension(role).width(1.5));
    sketch.detail(&[p, q]).part("closest-points").marker(p, Marker::Disc, Side::A.into(), MARKER);
    sketch.part("closest-points").marker(q, Marker::Square, Side::B.into(), MARKER);
    sketch.label(label((context, closest), Anchor::middle(q, p), role));
}

/// Draws where on the ray the origin is then, and its distance from B ⊖ A.
fn on_the_ray(sketch: &mut Sketch, context: &Context, options: &Options, closest: &Approach) {
    let from = context.closing_velocity() * (closest.time - context.difference_time());
    let to = from + (closest.points[1] - closest.points[0]);
    let role = options.role(Role::Translation);
    sketch.part("approach").dimension(from, to, 0.0, Pen::dimension(role).width(1.5));
    sketch.detail(&[from, to]).part("then").marker(from, Marker::Disc, Role::Ink, LARGE_MARKER);
    sketch.label(label((context, closest), Anchor::middle(from, to), role));
}

/// The least distance, and when it is, or one of the moments; bodies that move as one have it at all times.
fn label((context, closest): (&Context, &Approach), anchor: Anchor, role: Role) -> Label {
    let rounding = context.scene.query_at(closest.time).rounding();
    let d = Quantity::exactly(closest.separation).equals(rounding);
    let mut lines = vec![format!("$d {d}$")];
    let often = context.run().often.of(context.scene, closest.time, closest.bounds);
    let is_moving = context.turns() || context.closing_velocity() != DVec2::ZERO;
    if is_moving && often != Nearest::Always {
        lines.push(format!("$t = {}$", number(closest.time)));
    }
    lines.extend((often == Nearest::Again).then(|| ONE_OF_SEVERAL.to_owned()));
    Label { lines, ..Label::new("d", "", anchor, role) }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, lines};
    use crate::figure::{Figure, draw, plan};
    use crate::scene::open_text;

    /// A square that passes over another one by a unit, at 8 a unit of time; `query` and `panel` go on.
    fn passing(query: &str, height: f64, panel: &str) -> Figure {
        let text = format!(
            "[shapes.A]\nkind = 'box'\nhalf_extents = [1, 1]\nposition = [-6, {height}]\nvelocity = [8, 0]\n\
             [shapes.B]\nkind = 'box'\nhalf_extents = [1, 1]\n{query}\nof = ['A', 'B']\n[[panels]]\n{panel}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw(&plan, plan.theme, "s")
    }

    const SWEEP: &str = "[query]\nkind = 'linear-sweep'";
    const TURNING: &str = "angular_velocity_deg = 90\n[query]\nkind = 'time-of-impact'";

    #[test]
    fn the_line_is_as_long_as_the_label_says_and_as_the_answer_is() {
        for panel in [
            "layers = ['approach']",
            "time = 'closest'\nlayers = ['approach']",
            "time = 1\nlayers = ['approach']",
        ] {
            let figure = passing(SWEEP, 3.0, panel);
            let scale = figure.panels[0].frame.scale;
            let lengths = lines(&figure, "approach");
            assert!(lengths.iter().any(|length| (length / scale - 1.0).abs() < 1e-9), "{panel}: {lengths:?}");
            let (text, time) = &labels(&figure)["d"];
            // B's left edge is reached by A's right one.
            assert!(text.starts_with("$d = 1$") && *time == 0.5, "{panel}: {text}");
            let ghosts = figure.panels[0].placed.iter().filter(|label| label.key == "A'").count();
            assert_eq!(ghosts, usize::from(!panel.contains("closest")), "{panel}");
        }
        let figure = passing(SWEEP, 3.0, "space = 'configuration'\nlayers = ['approach']");
        assert!(labels(&figure)["d"].0.starts_with("$d = 1$"));
    }

    #[test]
    fn a_distance_that_stays_has_no_time() {
        let together = "velocity = [8, 0]\n[query]\nkind = 'linear-sweep'";
        for panel in ["layers = ['approach']", "space = 'configuration'\nlayers = ['approach']"] {
            let figure = passing(together, 3.0, panel);
            let label = figure.panels[0].placed.iter().find(|label| label.key == "d").unwrap();
            assert_eq!(label.lines.len(), 1, "{panel}");
        }
    }

    #[test]
    fn a_hit_and_another_difference_leave_nothing_to_draw_and_say_so() {
        let notes = |figure: &Figure| figure.warnings.iter().map(|w| w.fault.to_string()).collect::<Vec<_>>();
        let hit = passing(SWEEP, 1.5, "layers = ['approach']");
        assert_eq!(notes(&hit), ["`approach` draws nothing: the answer is a hit"]);
        let turning = passing(TURNING, 4.0, "space = 'configuration'\nlayers = ['approach']");
        let [note] = &notes(&turning)[..] else { panic!("{:?}", notes(&turning)) };
        assert!(note.contains("the bodies turn"), "{note}");
        let then = passing(TURNING, 4.0, "space = 'configuration'\ntime = 'closest'\nlayers = ['approach']");
        assert!(labels(&then).contains_key("d"), "{:?}", notes(&then));
    }
}
