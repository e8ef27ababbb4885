//! Every label stands nearer to its own thing than to any other that it could name, or a line leads to it.
//!
//! The boxes of the bodies are measured here from the scene's own numbers, not by the rule that placed the
//! labels.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use tracefig::drawing::Rect;
use tracefig::figure::{Figure, draw, plan};
use tracefig::geometry::DVec2;
use tracefig::scene::{Source, read};

fn figure(text: &str) -> Figure {
    let scene = read(&Source::new("s.toml", text)).unwrap();
    let plan = plan(&scene).unwrap();
    draw(&plan, plan.theme, "s")
}

/// Distance of two boxes, page pixels; 0 where they touch.
fn distance(a: &Rect, b: &Rect) -> f64 {
    let gap = |lo: f64, hi: f64| (lo - hi).max(0.0);
    let dx = gap(a.x0, b.x1).max(gap(b.x0, a.x1));
    let dy = gap(a.y0, b.y1).max(gap(b.y0, a.y1));
    libm::hypot(dx, dy)
}

/// The part of the page that the world's box from `lo` to `hi` takes in a panel.
fn page_box(figure: &Figure, panel: usize, lo: [f64; 2], hi: [f64; 2]) -> Rect {
    let frame = &figure.panels[panel].frame;
    let (p, q) = (frame.page(DVec2::from_array(lo)), frame.page(DVec2::from_array(hi)));
    Rect { x0: p.x, y0: q.y, x1: q.x, y1: p.y }
}

/// A sweep of a box of half-extents [1, 1] that hits at t = 0.5, with its ghost one unit to the right.
fn sweep(mover: &str, other: &str, canvas: &str, panels: &str) -> String {
    format!(
        "{canvas}\n[shapes.\"{mover}\"]\nkind = 'box'\nhalf_extents = [1, 1]\nvelocity = [2, 0]\n\
         [shapes.\"{other}\"]\nkind = 'circle'\nradius = 1\nposition = [3, 0]\n\
         [query]\nkind = 'linear-sweep'\nof = [\"{mover}\", \"{other}\"]\n{panels}"
    )
}

#[test]
fn the_names_of_a_body_and_of_its_ghost_are_not_swapped() {
    let small = "canvas = { width = 480, height = 270 }";
    let world = "[[panels]]\nlayers = ['shapes', 'ghosts']\n";
    let more = "[[panels]]\nlayers = ['shapes', 'ghosts', 'velocity']\n";
    let space = "[[panels]]\nspace = 'configuration'\nlayers = ['difference', 'origin', 'ray']\n";
    for (mover, other, canvas, panels) in [
        ("Player", "Wall", "", world.to_owned()),
        ("Player", "Wall", "", format!("{more}{world}{space}")),
        ("the crate", "g", small, format!("{world}{space}")),
        ("A", "B", "", world.to_owned()),
        ("a very long name of it", "Wall", "", world.to_owned()),
    ] {
        let figure = figure(&sweep(mover, other, canvas, &panels));
        assert!(figure.faults().is_empty(), "{mover}: {:?}", figure.faults());
        let start = page_box(&figure, 0, [-1.0, -1.0], [1.0, 1.0]);
        let ghost = page_box(&figure, 0, [0.0, -1.0], [2.0, 1.0]);
        for (key, own, its) in [("A", start, ghost), ("A'", ghost, start)] {
            let label = figure.panels[0].placed.iter().find(|p| p.key == key).unwrap();
            let [near, far] = [own, its].map(|b| distance(&label.bounds, &b));
            assert!(near < far || label.is_led(), "{mover}, {key}: {near} {far}");
        }
    }
}

#[test]
fn a_name_outside_of_a_long_thin_body_touches_it() {
    for (points, radius) in
        [("[[-3, 0], [3, 0.2]]", 0.0), ("[[-3, 0], [3, 2]]", 0.05), ("[[0, -4], [0, 4]]", 0.0)]
    {
        let figure = figure(&format!(
            "[shapes.A]\nkind = 'circle'\nradius = 1\nposition = [-2, 0]\n\
             [shapes.blade]\nkind = 'capsule'\npoints = {points}\nradius = {radius}\nposition = [4, 0]\n\
             [query]\nkind = 'separation'\nof = ['A', 'blade']\n[[panels]]\nlayers = ['shapes']\n"
        ));
        assert!(figure.faults().is_empty());
        let panel = &figure.panels[0];
        let name = panel.placed.iter().find(|p| p.key == "B").unwrap();
        let ends: Vec<[f64; 2]> = serde_json::from_str(points).unwrap();
        let along = (0..=100).map(|i| {
            let [p, q] = [0, 1].map(|k| DVec2::from_array(ends[k]) + DVec2::new(4.0, 0.0));
            panel.frame.page(p + (q - p) * f64::from(i) / 100.0)
        });
        let near = along.map(|p| distance(&name.bounds, &Rect { x0: p.x, y0: p.y, x1: p.x, y1: p.y }));
        let near = near.fold(f64::INFINITY, f64::min);
        assert!(near < 12.0, "{points}: {near} px from it");
    }
}
