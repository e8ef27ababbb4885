//! What is drawn of an axis of the separating-axis test.

use crate::figure::layer::tests::{labels, lines, paths, points};
use crate::figure::{draw, draw_in_steps, plan};
use crate::geometry::DVec2;
use crate::scene::open_text;
use crate::trace::Event;

/// Two polygons that overlap, on an axis along which each reaches past the other's far end or not.
fn scene(axis: usize) -> String {
    format!(
        r#"
        shapes.A = {{ kind = "polygon", vertices = [[-1, -0.6], [0.9, -0.8], [1.2, 0.5], [0, 1.1]] }}
        shapes.B = {{ kind = "polygon", vertices = [[-0.8, -0.5], [0.8, -0.6], [1, 0.3], [0.1, 0.9]],
            radius = 0.25, position = [1.3, 0.9], angle_deg = 10 }}
        query = {{ kind = "separation", of = ["A", "B"], algorithm = "separating-axes" }}
        panels = [{{ layers = [{{ layer = "projection", axis = {axis}, values = true }}] }}]
    "#
    )
}

#[test]
fn the_axis_reaches_the_shadow_of_the_origin_where_that_is_in_view() {
    for (from, reaches) in [(-3.0, true), (1.5, false)] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 1], position = [5, -1] }}
             shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [8, 0] }}
             query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }}
             panels = [{{ view = [{from}, -4, 12, 1],
                layers = [{{ layer = 'projection', axis = 2, values = true }}] }}]"
        );
        let scene = open_text("axes", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "axes");
        assert_eq!(labels(&figure).contains_key("zero"), reaches, "from {from}");
        // From A's shadow, at 4, to B's, at 9: at least, and 4 more to the origin's.
        let axis = lines(&figure, "axis")[0] / figure.panels[0].frame.scale;
        assert_eq!(axis > 9.0, reaches, "from {from}: {axis}");
    }
}

#[test]
fn the_least_overlap_so_far_stays_until_one_is_less_and_others_go_with_the_next() {
    let text = "shapes.A = { kind = 'box', half_extents = [1, 2] }
        shapes.B = { kind = 'polygon', vertices = [[-2.5, -0.5], [4, -1], [4, 4]], position = [0.9, 0.5] }
        query = { kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }
        panels = [{ layers = ['shapes', 'projection'] }]";
    let scene = open_text("axes", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let drawing = draw_in_steps(&plan, plan.theme, "axes").drawing;
    let gaps: Vec<f64> = plan.own_run().events().filter_map(crate::trace::so_far::gap).collect();
    let axes: Vec<usize> =
        (1..=drawing.steps.len()).map(|k| paths(&drawing.at_step(k).items, "edge").len() / 2).collect();
    let least = |tested: usize| gaps[..tested].iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // An edge has two paths. The best of all those that were tested, and the last one where that is another.
    let shown = |k: usize| if k == 0 { 0 } else { 1 + usize::from(gaps[k - 1] < least(k)) };
    let expected: Vec<usize> = (0..=gaps.len()).map(shown).chain([1]).collect();
    assert_eq!(axes, expected, "{gaps:?}");
    assert!(expected.contains(&2), "{gaps:?}");
    let is_less = |k: &usize| drawing.steps[*k].sentences.concat().ends_with("least overlap so far.");
    let less: Vec<usize> = (0..drawing.steps.len()).filter(is_less).collect();
    let falls: Vec<usize> = (2..=gaps.len()).filter(|&k| least(k) > least(k - 1)).collect();
    assert_eq!(less, falls, "{gaps:?}");
    assert!(!falls.is_empty(), "{gaps:?}");
}

#[test]
fn the_number_is_the_drawn_length_and_a_gap_only_where_the_intervals_are_apart() {
    for axis in 1..=8 {
        let scene = open_text("axes", &scene(axis)).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let tested = |e: &Event| match *e {
            Event::AxisTested { interval_a, interval_b, gap, .. } => Some((interval_a, interval_b, gap)),
            _ => None,
        };
        let (a, b, gap) = plan.own_run().events().filter_map(tested).nth(axis - 1).unwrap();
        assert!((gap - (b.lo - a.hi)).abs() < 1e-14 * 4.0, "axis {axis}: {gap}, {a:?} to {b:?}");
        let figure = draw(&plan, plan.theme, "axes");
        let mut labels = labels(&figure);
        for (key, end) in [("end.A", a.hi), ("begin.B", b.lo)] {
            assert!((labels[key].1 - end).abs() < 0.006, "axis {axis}: {:?} is not {end}", labels[key]);
        }
        // n stands on the axis, from 0, and one long.
        assert!(labels["axis"].0.starts_with("$n = ("), "{:?}", labels["axis"]);
        assert!((lines(&figure, "normal")[0] / figure.panels[0].frame.scale - 1.0).abs() < 0.5);
        assert_eq!(labels["zero"].1, 0.0, "both intervals hold 0, or lie beside it");
        let (label, number) = labels.remove("gap").unwrap();
        assert_eq!(label.starts_with("gap"), a.hi < b.lo, "axis {axis}: {label}");
        assert_eq!(label.contains("faces away"), b.hi < a.lo, "axis {axis}: {label}");
        let shared = a.hi.min(b.hi) - a.lo.max(b.lo);
        assert_eq!(label.starts_with("overlap"), shared > 0.0 && shared == -(b.lo - a.hi), "axis {axis}");
        let drawn = lines(&figure, "gap")[0] / figure.panels[0].frame.scale;
        assert!((drawn - number).abs() < 0.005 && (drawn - gap.abs()).abs() < 1e-9, "{label}: {drawn}");
    }
}

#[test]
fn what_both_shadows_share_is_lit_and_no_more() {
    for axis in 1..=8 {
        let scene = open_text("axes", &scene(axis)).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "axes");
        let tested = |e: &Event| match *e {
            Event::AxisTested { axis, interval_a, interval_b, .. } => Some((axis, interval_a, interval_b)),
            _ => None,
        };
        let (n, a, b) = plan.own_run().events().filter_map(tested).nth(axis - 1).unwrap();
        let shared = a.hi.min(b.hi) - a.lo.max(b.lo);
        let frame = figure.panels[0].frame;
        let n = (frame.page(n) - frame.page(DVec2::ZERO)) * (1.0 / frame.scale);
        for path in paths(&figure.drawing.items, "lit") {
            let along: Vec<f64> = points(path).iter().map(|p| p.x * n.dx + p.y * n.dy).collect();
            let [lo, hi] = [
                along.iter().copied().fold(f64::INFINITY, f64::min),
                along.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ];
            let is_gap = a.hi < b.lo;
            let wanted = if is_gap { b.lo - a.hi } else { shared };
            assert!(
                ((hi - lo) / frame.scale - wanted).abs() < 1e-9,
                "axis {axis}: {}",
                (hi - lo) / frame.scale
            );
        }
    }
}

#[test]
fn joined_the_two_intervals_and_the_gap_lie_end_to_end_on_the_axis() {
    let text = "shapes.A = { kind = 'box', half_extents = [1, 1] }
        shapes.B = { kind = 'box', half_extents = [1, 1], position = [5, 0] }
        query = { kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }
        panels = [{ view = [-2, -4, 7, 2], layers = [{layer = 'projection', axis = 2, joined = true}] }]";
    let scene = open_text("axes", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "axes");
    let ends = |part| paths(&figure.drawing.items, part)[0].contour.bounds().unwrap();
    let [a, gap, b] = ["interval-A", "gap", "interval-B"].map(ends);
    let off = [a.x1 - gap.x0, gap.x1 - b.x0, a.y0 - gap.y0, gap.y0 - b.y0];
    assert!(off.iter().all(|off| off.abs() < 1e-9), "{off:?}");
}
