//! What a step of GJK has proved of the distance, as a bar along a line of distances below B ⊖ A: at least
//! that of the supporting line through w, at most the length of v.
//!
//! ```text
//! max over the steps so far of  w · v / ‖v‖   ≤   distance   ≤   ‖v‖
//! ```
//!
//! Both ends close in on the distance, and meet where the search stops. The line begins under O and has the
//! panel's own scale, so panels of one view can be compared. The distance is that of the cores: of bodies
//! with radii these come off.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Size, Sketch, Weight};
use crate::figure::text::{least, most, number};
use crate::geometry::DVec2;
use crate::trace::phrase;

use super::cores::radii_in_words;
use super::difference::difference;
use super::simplex::{has_simplexes, steps};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, number_of};

/// How far the line is below B ⊖ A and O, page pixels: below O's letter and what is measured there.
const BELOW: f64 = 58.0;
/// Half the length of the mark of 0, page pixels.
const TICK: f64 = 5.0;
/// How far the line reaches past the largest distance, page pixels.
const PAST: f64 = 16.0;
/// Width of the bar, page pixels.
const BAR: f64 = 5.0;
/// From one earlier bar to the next, page pixels, their width and opacity.
const EARLIER: (f64, f64, f64) = (9.0, 3.5, 0.4);
/// The most earlier bars: more would reach into what is measured above.
const MOST_EARLIER: usize = 5;
/// Half the height of the mark where both ends meet, page pixels.
const MET: f64 = 8.0;
/// How far outward an end's number is wished, in parts of how far below: both fit where the ends are near.
const ASIDE: f64 = 1.0;
/// The share of the distance at which both ends count as met: they are rounded a few times.
const CLOSED: f64 = 1e-9;

pub(super) const LAYER: Layer = Layer {
    name: "bracket",
    in_words: phrase(["bracket", "Schranken des Abstands", "bornes de la distance", "cotas de la distancia"]),
    about: "what a step of GJK proves of the distance: at least, at most, as a bar to the panel's scale",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "step",
            takes: Takes::Number,
            default: "the last",
            about: "up to which simplex, from 1",
        },
        OptionSpec {
            name: "earlier",
            takes: Takes::Flag,
            default: "false",
            about: "the bars of the steps before, faint, each above the next",
        },
    ],
    labels: &[
        LabelKey { key: "at-least", about: "the largest distance of a supporting line so far" },
        LabelKey { key: "at-most", about: "the length of v" },
        LabelKey { key: "met", about: "the distance, where both ends meet" },
        LabelKey { key: "scale", about: "what the line is of" },
    ],
    needs: "the algorithm \"gjk\", bodies apart, and no more steps than it took",
    fed: |context, options| {
        let [found, any] = [options, &Options::default()].map(|options| bracket(context, options).is_some());
        Fed::by_the_steps(found, any, has_simplexes(context))
    },
    draw,
};

/// What is proved of the distance.
struct Bracket {
    /// It is no less.
    least: f64,
    /// It is no more.
    most: f64,
    /// The most of all steps, to which the line reaches.
    widest: f64,
    /// The bars of the steps before, from the first.
    earlier: Vec<[f64; 2]>,
    /// With what it comes.
    cue: Option<Cue>,
}

/// What is proved by the step that the scene wants, else by the last; `None` for bodies that overlap.
fn bracket(context: &Context, options: &Options) -> Option<Bracket> {
    let steps = steps(context);
    let all: Option<Vec<([f64; 2], Option<Cue>)>> =
        steps.iter().map(|step| Some((step.bracket()?, step.cue))).collect();
    let all = all?;
    let count = match options.number("step") {
        Some(step) => (1..=all.len()).find(|&k| number_of(k) == step)?,
        None => all.len(),
    };
    let &(_, cue) = all[..count].last()?;
    let mut bars: Vec<[f64; 2]> = all[..count]
        .iter()
        .scan(0.0_f64, |so_far, &([least, most], _)| {
            *so_far = so_far.max(least).min(most);
            Some([*so_far, most])
        })
        .collect();
    let [least, most] = bars.pop()?;
    let widest = all.iter().map(|([_, most], _)| *most).fold(0.0, f64::max);
    Some(Bracket { least, most, widest, earlier: bars, cue })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(found) = bracket(context, options) else { return };
    let all = difference(context, context.difference_time());
    let points: Vec<DVec2> = all.iter().flat_map(|d| d.edges.iter().map(|edge| edge.from)).collect();
    // To the side on which B ⊖ A lies, where there is room.
    let way = if points.iter().map(|p| p.x).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
    let earlier = if options.flag("earlier", false) { found.earlier.as_slice() } else { &[] };
    let low = points.iter().map(|p| p.y).fold(0.0, f64::min) - sketch.px(BELOW);
    let at = |distance: f64| DVec2::new(way * distance, low);
    let end = at(found.widest + sketch.px(PAST));
    let up = DVec2::Y;
    sketch.since(None);
    sketch.part("distances").weight(Weight::Light);
    sketch.arrow(at(0.0), end, Pen::axis());
    let tick = up * sketch.px(TICK);
    sketch.line(at(0.0) - tick, at(0.0) + tick, Pen::axis());
    let of = if radii_in_words(context).is_empty() { "distance" } else { "distance of the cores" };
    let scale = Label::new("scale", of, Anchor::point_toward(at(0.0), DVec2::X * -way), Role::Muted);
    sketch.label(scale.rank(Rank::Word).size(Size::Note));
    sketch.since(found.cue);
    let role = options.role(Role::Translation);
    let faint = Pen::vector(role).width(EARLIER.1).opacity(EARLIER.2);
    for (row, bar) in earlier.iter().rev().take(MOST_EARLIER).enumerate() {
        let above = up * sketch.px(EARLIER.0 * (number_of(row) + 1.0) + 1.0);
        sketch.part("earlier").weight(Weight::Light).line(at(bar[0]) + above, at(bar[1]) + above, faint);
    }
    let below = |along: f64| DVec2::new(way * along, -1.0);
    if found.most - found.least <= CLOSED * found.most {
        let tick = up * sketch.px(MET);
        sketch.part("bracket").line(at(found.most) - tick, at(found.most) + tick, Pen::highlighted(role));
        let text = format!("distance $= {}$", number(found.most));
        let label = Label::new("met", text, Anchor::point_toward(at(found.most), below(0.0)), role);
        sketch.label(label.rank(Rank::Measure));
        return;
    }
    let pen = Pen::highlighted(role).width(BAR);
    sketch.part("bracket").bar(at(found.least), at(found.most), 0.0, pen);
    // What is written is a bound too.
    let (least, most) = (least(found.least), most(found.most));
    for (key, sign, written, distance, side) in
        [("at-least", r"\ge", least, found.least, -ASIDE), ("at-most", r"\le", most, found.most, ASIDE)]
    {
        let text = format!("${sign} {written}$");
        let label = Label::new(key, text, Anchor::point_toward(at(distance), below(side)), role);
        sketch.label(label.rank(Rank::Measure).size(Size::Note));
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, lines, paths, points};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    /// A scene of two triangles, B at a place, with the bar of a step.
    fn scene(place: &str, step: usize) -> String {
        format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-3, 0], [3, -2], [1, 2]] }}
            shapes.B = {{ kind = 'polygon', vertices = [[2, 5], [6, 2], [5, 5]], position = {place} }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
            panels = [{{ space = 'configuration',
                layers = ['difference', {{ layer = 'bracket', step = {step}, earlier = true }}] }}]"
        )
    }

    #[test]
    fn the_bar_holds_the_distance_shrinks_from_step_to_step_and_is_drawn_to_scale() {
        // The distance is 3: of O from 3x + 4y = 15.
        let mut last = [0.0, f64::INFINITY];
        for step in 1..=3 {
            let scene = open_text("gjk", &scene("[0, 0]", step)).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "gjk");
            let labels = labels(&figure);
            let [least, most] = [labels["at-least"].1, labels["at-most"].1];
            assert!(
                last[0] <= least && least < 3.0 && 3.0 < most && most < last[1],
                "{step}: {least}, {most}"
            );
            let drawn = lines(&figure, "bracket")[0] / figure.panels[0].frame.scale;
            assert!(drawn <= most - least && most - least < drawn + 0.021, "{step}: {drawn}");
            last = [least, most];
            // Of the steps before faint bars, each above the next and longer.
            let earlier = paths(&figure.drawing.items, "earlier").into_iter().map(points);
            let bars: Vec<[f64; 2]> = earlier.map(|p| [p[0].y, (p[1] - p[0]).dx]).collect();
            assert_eq!(bars.len(), step - 1);
            assert!(bars.windows(2).all(|w| w[1][0] < w[0][0] && w[1][1] > w[0][1]), "{bars:?}");
            assert!(bars.iter().all(|bar| bar[1] > lines(&figure, "bracket")[0]), "{bars:?}");
        }
        let scene = open_text("gjk", &scene("[0, 0]", 4)).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "gjk");
        assert_eq!(labels(&figure)["met"], ("distance $= 3$".to_owned(), 3.0));
    }

    #[test]
    fn bodies_that_overlap_have_no_bar_and_the_figure_says_why() {
        let scene = open_text("gjk", &scene("[-3, -3]", 1)).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "gjk");
        assert!(paths(&figure.drawing.items, "distances").is_empty());
        assert!(plan.warnings.iter().any(|w| w.fault.to_string().contains("overlap")), "{:?}", plan.warnings);
    }
}
