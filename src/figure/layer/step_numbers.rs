//! The numbers of the steps of a difference that is drawn at each of them, t₁, t₂, …: each at its own
//! outline, where no other one is.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::Difference;
use crate::figure::sketch::{Anchor, Label, Rank, Size, Sketch};
use crate::geometry::DVec2;
use crate::scene::When;

/// Distance, page pixels, below which numbers of iterations would touch: the earlier one is left out, as the
/// last never is.
const NUMBER_GAP: f64 = 14.0;

/// How far an edge that looks level rises over its length at most, page pixels.
const LEVEL: f64 = 1.0;

/// How far outside all other iterations a number's place is at least, page pixels: seen to be on one outline.
const CLEAR: f64 = 3.0;

/// Writes the number of each iteration below its lowest vertex, where that is outside of all others; else
/// where the outline is farthest outside of them. One that is nowhere outside has none, but for the last.
/// Where none is `numbered`, the outlines are all told of as things without a name.
pub(super) fn step_numbers(
    sketch: &mut Sketch,
    context: &Context,
    all: &[(usize, Difference)],
    numbered: bool,
) {
    let [gap, level, least] = [NUMBER_GAP, LEVEL, CLEAR].map(|px| sketch.px(px));
    let mut kept: Vec<(usize, DVec2, Anchor)> = Vec::new();
    for (i, (k, found)) in all.iter().enumerate().rev() {
        let others = || all.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, (_, other))| other);
        let clear = |p: DVec2| others().map(|other| other.outside(p)).fold(f64::INFINITY, f64::min);
        let points = found.outline().sampled();
        let below = lowest(&points, level).filter(|p| clear(*p) >= least).map(|p| (p, DVec2::NEG_Y));
        let farthest = || {
            let place = points.iter().copied().max_by(|p, q| clear(*p).total_cmp(&clear(*q)))?;
            Some((place, place - found.middle()))
        };
        let Some((place, out)) = below.or_else(farthest) else { continue };
        let anchor = Anchor::outline(&found.outline(), place, out);
        let apart = kept.iter().all(|(_, other, _)| other.distance(place) >= gap);
        if numbered && (kept.is_empty() || apart && clear(place) >= least) {
            kept.push((*k, place, anchor));
        } else {
            sketch.unnamed(anchor);
        }
    }
    for (k, _, anchor) in kept.into_iter().rev() {
        let label = Label::new("step", format!("$t_{{{k}}}$"), anchor, Role::Difference);
        sketch.since(context.known(&When::Step(k))).label(label.rank(Rank::Word).size(Size::Small));
    }
}

/// The lowest of some points; the middle of the lowest edge where that looks level. `level` is in units of
/// the space.
fn lowest(points: &[DVec2], level: f64) -> Option<DVec2> {
    let bottom = points.iter().copied().min_by(|p, q| p.y.total_cmp(&q.y))?;
    let same = points.iter().filter(|p| p.y - bottom.y <= level);
    let (lo, hi) = same.fold((bottom, bottom), |(lo, hi), &p| (lo.min(p), hi.max(p)));
    Some(0.5 * (lo + hi))
}

#[cfg(test)]
mod tests {
    use super::super::difference::{difference, thinned};
    use super::*;
    use crate::drawing::{Item, Point, Rect};
    use crate::figure::frame::Frame;

    #[test]
    fn the_number_of_a_step_stands_at_its_own_outline_and_in_no_other() {
        let text =
            "shapes.A = { kind = 'regular-polygon', edges = 5, circumradius = 1.2, velocity = [3.2, 0.4],
                angular_velocity_deg = 120 }
            shapes.B = { kind = 'aabb', half_extents = [0.3, 1.5], position = [4, 0.5] }
            panels = [{ space = 'configuration', time = 0,
                layers = [{ layer = 'difference', at = 'steps', numbers = true }] }]
            query = { kind = 'time-of-impact', of = ['A', 'B'], tolerance = 0.01,
                algorithm = 'conservative-advancement' }";
        let scene = crate::scene::open_text("steps", text).unwrap().scene;
        let plan = crate::figure::plan(&scene).unwrap();
        let panel = &plan.panels[0];
        let context = panel.context(&scene, &plan.runs);
        let at = |(k, time)| Some((k, difference(&context, time)?));
        let steps: Vec<(usize, Difference)> = thinned(&context.steps()).into_iter().filter_map(at).collect();
        let sketched = panel.sketch(&context, plan.theme);
        let mut named = 0;
        for label in sketched.requests.iter().map(|request| &request.label).filter(|l| l.key == "step") {
            let Anchor::Outline { at, .. } = label.anchor else { panic!("{label:?}") };
            for (k, found) in &steps {
                let own = label.lines[0] == format!("$t_{{{k}}}$");
                assert_eq!(found.outside(at).abs() < 1e-9, own, "{label:?} and step {k}");
                assert!(own || found.outside(at) > 0.0, "{label:?} in step {k}");
            }
            named += 1;
        }
        assert!(named > 2, "{named}");
    }

    #[test]
    fn labels_of_one_key_come_each_with_its_own_step() {
        let text = "shapes.A = { kind = 'box', half_extents = [1.2, 0.06], position = [-2, 0],
                velocity = [2.5, 0.3], angular_velocity_deg = 120 }
            shapes.B = { kind = 'aabb', half_extents = [0.3, 1.2], position = [0.7, 0] }
            panels = [{ space = 'configuration', time = 0,
                layers = [{ layer = 'difference', at = 'steps', numbers = true }] }]
            query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }";
        let scene = crate::scene::open_text("steps", text).unwrap().scene;
        let plan = crate::figure::plan(&scene).unwrap();
        let figure = crate::figure::draw(&plan, plan.theme, "steps");
        let mut since = Vec::new();
        drawn(&figure.drawing.items, false, &mut since);
        since.dedup();
        // t₁ is there from the start; each of the others comes with its own outline.
        assert!(since.len() > 3 && since.windows(2).all(|pair| pair[0] < pair[1]), "{since:?}");
    }

    /// The steps with which the labels of steps come, in the order of the picture.
    fn drawn(items: &[Item], is_step: bool, since: &mut Vec<usize>) {
        for item in items {
            match item {
                Item::Group(group) => drawn(&group.items, is_step || group.name == "label-step", since),
                Item::Text(text) if is_step => since.push(text.shown.since),
                _ => {}
            }
        }
    }

    /// How far a point of the page is from a box.
    fn distance(bounds: &Rect, p: Point) -> f64 {
        let off = |lo: f64, hi: f64, x: f64| (lo - x).max(x - hi).max(0.0);
        libm::hypot(off(bounds.x0, bounds.x1, p.x), off(bounds.y0, bounds.y1, p.y))
    }

    /// How much farther a box on the page is from the nearest other outline than from a step's own, page
    /// pixels.
    fn margin(bounds: &Rect, frame: &Frame, steps: &[(usize, Difference)], own: usize) -> f64 {
        let from = |found: &Difference| {
            let points: Vec<_> = found.outline().sampled().iter().map(|&p| frame.page(p)).collect();
            let next = points.iter().cycle().skip(1);
            let pieces = points.iter().zip(next);
            let between = |(&p, &q)| (0..50).map(move |i| p + (q - p) * (f64::from(i) / 50.0));
            pieces.flat_map(between).map(|p| distance(bounds, p)).fold(f64::INFINITY, f64::min)
        };
        let (mut near, mut far) = (f64::INFINITY, f64::INFINITY);
        for (k, found) in steps {
            let least = if *k == own { &mut near } else { &mut far };
            *least = least.min(from(found));
        }
        far - near
    }

    #[test]
    fn the_number_of_a_step_is_nearest_to_its_own_outline_or_led_to_it() {
        let mut named = 0;
        for case in 0..24 {
            let (turn, height) = (40 + 25 * (case % 8), 0.3 * f64::from(case / 8));
            let text = format!(
                "shapes.A = {{ kind = 'capsule', points = [[-1.5, 0], [1.5, 0]], radius = 0.2,
                    velocity = [2.6, {height}], angular_velocity_deg = {turn} }}
                shapes.B = {{ kind = 'box', half_extents = [0.3, 2.5], position = [4, 0.5], angle_deg = 20 }}
                panels = [{{ space = 'configuration', time = 0,
                    layers = ['axes', {{ layer = 'difference', at = 'steps', numbers = true }}, 'origin'] }}]
                query = {{ kind = 'time-of-impact', of = ['A', 'B'], tolerance = 0.01,
                    algorithm = 'conservative-advancement' }}"
            );
            let scene = crate::scene::open_text("steps", &text).unwrap().scene;
            let plan = crate::figure::plan(&scene).unwrap();
            let context = plan.panels[0].context(&scene, &plan.runs);
            let at = |(k, time)| Some((k, difference(&context, time)?));
            let steps: Vec<(usize, Difference)> =
                thinned(&context.steps()).into_iter().filter_map(at).collect();
            let figure = crate::figure::draw(&plan, plan.theme, "steps");
            let panel = &figure.panels[0];
            let numbers = panel.placed.iter().filter(|placed| placed.key == "step");
            for placed in numbers {
                let markup = &placed.lines[0].1.markup;
                let own = markup.trim_start_matches("$t_{").trim_end_matches("}$").parse().unwrap();
                let margin = margin(&placed.bounds, &panel.frame, &steps, own);
                assert!(margin > 0.0 || placed.is_led(), "case {case}, {markup}: {margin} px");
                named += 1;
            }
        }
        assert!(named > 60, "{named}");
    }
}
