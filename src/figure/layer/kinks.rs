//! When another vertex becomes the one that is nearest to the other body: the separation over time has a kink
//! there, where the bodies have edges that are parallel.

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Marker, Rank, SMALL_MARKER, Size, Sketch, Weight};
use crate::geometry::{DVec2, Feature, Side, sort_by};

use super::chart::Chart;
use super::{Fed, Options};
use crate::scene::NOTES;

/// How often the time between two samples is halved: to far below a pixel of any chart.
const HALVINGS: usize = 40;

/// Half of what is looked at around such a time to tell how sharp the kink is, in parts of a sample's time.
const AROUND: f64 = 0.25;

/// How much nearer a kink is looked at a second time, to tell it from a smooth bend.
const CLOSER: f64 = 1.0 / 256.0;

/// How much of its bend a kink has left there at least: one whose sides are straight all, a smooth bend
/// [`CLOSER`] of it.
const SHARP: f64 = 0.5;

/// How much less steep than the sharpest a kink may be to be marked: less is no kink to the eye.
const FAINTEST: f64 = 0.1;

/// Marks the kinks of a curve of separations over time, sampled at `points`, and names the sharpest: where
/// another vertex becomes the nearest. The chart has a value for each separation.
pub(super) fn mark(
    sketch: &mut Sketch,
    context: &Context,
    (chart, value): (&Chart, impl Fn(f64) -> f64),
    points: &[DVec2],
) {
    let all = turns(context, points);
    let Some(&(sharpest, most)) = all.iter().max_by(|(_, bend), (_, other)| bend.total_cmp(other)) else {
        return;
    };
    let place = |at: DVec2| chart.place(at.x, value(at.y));
    let marked: Vec<DVec2> =
        all.into_iter().filter(|(_, bend)| *bend >= FAINTEST * most).map(|(at, _)| place(at)).collect();
    sketch.part("kink").weight(Weight::Background);
    for &at in &marked {
        sketch.marker(at, Marker::Disc, Role::Ink, SMALL_MARKER);
    }
    // Away from where the curve goes on: separations fall, what is closed of them rises.
    let out = DVec2::new(1.0, if value(1.0) > value(0.0) { 1.0 } else { -1.0 });
    let anchor = Anchor::point_toward(place(sharpest), chart.vector(out));
    let lines = match marked.len() {
        1 => ["here another vertex", "becomes the nearest"],
        _ => ["at each dot another", "vertex becomes the nearest"],
    };
    let lines = lines.map(str::to_owned).to_vec();
    let label = Label { lines, ..Label::new("kink", "", anchor, Role::Ink) };
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Fed, but for kinks that a scene asks for and a curve of separations has not, sampled at `points`.
pub(super) fn fed(context: &Context, options: &Options, points: impl FnOnce() -> Vec<DVec2>) -> Fed {
    if NOTES && options.flag("kink", false) && turns(context, &points()).is_empty() {
        return Fed::Without { option: "kink", why: "the curve has none" };
    }
    Fed::Yes
}

/// The samples of a curve of separations over time with its kinks among them, which a line from sample to
/// sample would cut off.
pub(super) fn kept(context: &Context, points: &[DVec2]) -> Vec<DVec2> {
    let mut kept: Vec<DVec2> =
        points.iter().copied().chain(turns(context, points).into_iter().map(|(at, _)| at)).collect();
    sort_by(&mut kept, |p, q| p.x.total_cmp(&q.x));
    kept
}

/// The kinks of a curve of separations over time, sampled at `points`: each as its time and separation, and
/// how much steeper the curve is after it than before.
fn turns(context: &Context, points: &[DVec2]) -> Vec<(DVec2, f64)> {
    let query = context.scene.query_of_bodies();
    let Some(b) = query.b else { return Vec::new() };
    let at = |time: f64| context.runs.distances.at(query.a, b, time);
    let mut last: Option<(f64, (Side, usize))> = None;
    let mut found = Vec::new();
    for point in points {
        let Some(now) = nearest(&at(point.x)) else { continue };
        if let Some((before, vertex)) = last.filter(|&(_, vertex)| vertex != now) {
            let time = when(before, point.x, |time| nearest(&at(time)) == Some(vertex));
            let h = AROUND * (point.x - before);
            let here = at(time).separation;
            let bend = |h: f64| {
                let [s, t] = [time - h, time + h].map(|time| at(time).separation);
                (s - 2.0 * here + t).abs() / h
            };
            // What bends smoothly, as about a vertex, is the straighter the nearer one looks.
            let [closer, bend] = [CLOSER * h, h].map(bend);
            if closer >= SHARP * bend {
                found.push((DVec2::new(time, here), bend));
            }
        }
        last = Some((point.x, now));
    }
    found
}

/// The vertex that is nearest to an edge of the other body; `None` where two vertices are nearest, or two
/// edges.
fn nearest(answer: &Separation) -> Option<(Side, usize)> {
    match answer.features {
        [Feature::Vertex(k), Feature::Edge(_)] => Some((Side::A, k)),
        [Feature::Edge(_), Feature::Vertex(k)] => Some((Side::B, k)),
        _ => None,
    }
}

/// The time from which on something is no longer so, which is so at `from` and not at `to`.
fn when(from: f64, to: f64, is_so: impl Fn(f64) -> bool) -> f64 {
    let halve = |(from, to): (f64, f64), _| {
        let middle = 0.5 * (from + to);
        if is_so(middle) { (middle, to) } else { (from, middle) }
    };
    (0..HALVINGS).fold((from, to), halve).1
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    /// The marks of kinks of a box above the top of another one, which turns by so many degrees a unit of
    /// time, in two charts, whether they have words, and what is said in their place.
    fn kinks(spin: f64) -> (usize, bool, Vec<String>) {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [2, 0.5], position = [0, 6], angle_deg = -30,
                velocity = [0, -4], angular_velocity_deg = {spin} }}
            shapes.B = {{ kind = 'box', half_extents = [9, 1] }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement',
                tolerance = 0.1 }}
            panels = [{{ view = [0, 0, 4, 3], layers = [{{ layer = 'fastest-approach', kink = true }}] }},
                {{ view = [0, 0, 4, 3], layers = [{{ layer = 'graph', kink = true }}] }}]"
        );
        let scene = open_text("kinks", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "kinks");
        let notes = plan.warnings.iter().map(|note| note.fault.to_string()).collect();
        (paths(&figure.drawing.items, "kink").len(), labels(&figure).contains_key("kink"), notes)
    }

    #[test]
    fn a_box_that_turns_over_the_level_has_a_kink_there_and_one_that_does_not_turn_has_none() {
        assert_eq!(kinks(60.0), (2, true, Vec::new()));
        // And again as it stands upright.
        assert_eq!(kinks(180.0), (4, true, Vec::new()));
        let none = |layer| format!("`kink` of `{layer}` draws nothing: the curve has none");
        assert_eq!(kinks(0.0), (0, false, ["fastest-approach", "graph"].map(none).to_vec()));
    }

    #[test]
    fn a_vertex_that_goes_smoothly_from_an_edge_to_a_vertex_has_no_kink_there() {
        // Above the top of B first, then beside its upper right vertex, to which an edge of A comes nearest.
        let text = "shapes.A = { kind = 'polygon', vertices = [[0, -1], [1, 0], [0, 1], [-1, 0]],
                position = [-2, 4], velocity = [10, -2] }
            shapes.B = { kind = 'box', half_extents = [2, 1] }
            query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }
            panels = [{ view = [0, 0, 4, 3], layers = [{ layer = 'graph', kink = true }] }]";
        let scene = open_text("smooth", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "smooth");
        assert_eq!(paths(&figure.drawing.items, "kink").len(), 0);
    }
}
