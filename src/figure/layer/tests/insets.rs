//! An inset shows its panel's detail at the enlarged place, and the panel's labels keep off it.

use crate::drawing::{Group, Item, Path, Rect};
use crate::figure::{Figure, Labelled, draw, draw_in_steps, plan};
use crate::geometry::DVec2;
use crate::scene::{Explain, open_text};

use super::paths;

/// Two boxes a small gap apart, and a panel of them.
fn scene(panel: &str) -> String {
    format!(
        "shapes.A = {{ kind = 'box', half_extents = [2, 2] }}
        shapes.B = {{ kind = 'box', half_extents = [2, 2], position = [4.1, 0.5] }}
        query = {{ kind = 'separation', of = ['A', 'B'] }}
        panels = [{{ view = [-4, -4, 8, 4], {panel},
            layers = ['shapes', 'separation', {{ layer = 'axes', ticks = true }},
                {{ layer = 'note', lines = ['a'], at = 'top' }}] }}]"
    )
}

fn drawn(panel: &str) -> Figure {
    let scene = open_text("inset", &scene(panel)).unwrap().scene;
    let plan = plan(&scene).unwrap_or_else(|problems| panic!("{panel}: {problems:?}"));
    draw(&plan, plan.theme, "inset")
}

/// The group of a name.
fn group<'d>(items: &'d [Item], name: &str) -> Option<&'d Group> {
    items.iter().find_map(|item| match item {
        Item::Group(own) if own.name == name => Some(own),
        Item::Group(own) => group(&own.items, name),
        _ => None,
    })
}

/// The box of a path on the page.
fn bounds(path: &Path) -> Rect {
    path.contour.bounds().unwrap()
}

#[test]
fn a_detail_is_drawn_again_and_larger_by_the_factor_that_is_written() {
    let figure = drawn("inset = [1.9, -0.2, 2.3, 0.2], inset_at = 'SW'");
    let (panel, inset) = (&figure.panels[0].frame, &figure.insets[0].frame);
    let factor = inset.scale / panel.scale;
    assert!((factor.round() - factor).abs() < 1e-12 && factor >= 5.0, "{factor}");
    let own = group(&figure.drawing.items, "inset").unwrap();
    assert_eq!(own.label.as_deref(), Some(format!("detail, enlarged {} times", factor.round()).as_str()));
    // In the corner asked for, within the panel; the middle of the detail in its middle.
    let (rect, cell) = (inset.panel, panel.panel);
    assert!(cell.union(rect) == cell);
    assert!(rect.center().x < cell.center().x && rect.center().y > cell.center().y);
    let middle = inset.page(DVec2::new(2.1, 0.0));
    assert!((middle - rect.center()).length() < 1e-9);
    // The frame in the panel is the detail's.
    let detail = bounds(paths(&figure.drawing.items, "detail")[0]);
    let corner = panel.page(DVec2::new(1.9, 0.2));
    assert!((detail.x0 - corner.x).abs() < 1e-9 && (detail.y0 - corner.y).abs() < 1e-9);
    assert!((detail.width() * factor - rect.width()).abs() < 1e-9);
    // Both show A's right edge at its place.
    let edges: Vec<Rect> = paths(&figure.drawing.items, "body-A").into_iter().map(bounds).collect();
    assert_eq!(edges.len(), 2);
    assert!((edges[0].x1 - panel.page(DVec2::X * 2.0).x).abs() < 1e-9);
    assert!((edges[1].x1 - inset.page(DVec2::X * 2.0).x).abs() < 1e-9);
    assert_eq!(group(&own.items, "layers").unwrap().clip, Some(rect.into()));
}

#[test]
fn what_lies_in_the_detail_is_named_in_the_inset_and_notes_are_in_the_panel_alone() {
    let figure = drawn("inset = [1.3, -0.2, 2.6, 0.7]");
    let keys = |labelled: &Labelled| labelled.placed.iter().map(|l| l.key).collect::<Vec<_>>();
    let (panel, inset) = (keys(&figure.panels[0]), keys(&figure.insets[0]));
    assert!(panel.contains(&"note") && !inset.contains(&"note"), "{panel:?} {inset:?}");
    let length = |keys: &[&str]| keys.iter().any(|key| matches!(*key, "d" | "distance"));
    assert!(length(&inset) && !length(&panel), "{panel:?} {inset:?}");
    let rect = figure.insets[0].frame.panel;
    let over = figure.panels[0].placed.iter().find(|label| label.bounds.intersection(rect).is_some());
    assert!(over.is_none(), "{over:?}");
    let within = rect.grown(1.5);
    assert!(figure.insets[0].placed.iter().all(|label| within.union(label.bounds) == within));
    assert_eq!(figure.faults(), []);
    assert!(group(&group(&figure.drawing.items, "inset").unwrap().items, "x-numbers").is_none());
    // Where the inset has no room for it, it stays in the panel.
    let narrow = drawn("inset = [1.98, -0.5, 2.12, 0.9]");
    assert!(length(&keys(&narrow.panels[0])) && !length(&keys(&narrow.insets[0])));
}

#[test]
fn an_inset_stands_where_it_hides_least_and_not_on_its_detail() {
    for (x, y) in [(1.9, 1.5), (-3.9, -3.5), (7.0, 3.0), (-3.9, 3.0)] {
        let figure = drawn(&format!("inset = [{x}, {y}, {}, {}]", x + 0.4, y + 0.4));
        let rect = figure.insets[0].frame.panel;
        let detail = bounds(paths(&figure.drawing.items, "detail")[0]);
        assert_eq!(rect.intersection(detail), None, "{x}, {y}");
    }
}

#[test]
fn each_word_for_a_corner_is_another_corner() {
    let corner = |word: &str| {
        let figure = drawn(&format!("inset = [1.9, -0.2, 2.3, 0.2], inset_at = '{word}'"));
        let (rect, cell) = (figure.insets[0].frame.panel.center(), figure.panels[0].frame.panel.center());
        (rect.x > cell.x, rect.y < cell.y)
    };
    assert_eq!(
        ["NE", "NW", "SE", "SW"].map(corner),
        [(true, true), (false, true), (true, false), (false, false)]
    );
}

#[test]
fn an_inset_of_too_much_or_in_no_corner_is_refused() {
    let codes = |panel: &str| -> Vec<&'static str> {
        match open_text("inset", &scene(panel)) {
            Err(problems) => problems.problems.iter().map(|p| p.fault.code()).collect(),
            Ok(file) => plan(&file.scene).map(|_| ()).unwrap_err().iter().map(|p| p.fault.code()).collect(),
        }
    };
    assert_eq!(codes("inset = [-4, -4, 8, 4]"), ["conflict"]);
    assert_eq!(codes("inset = [1, 1, 0, 2]"), ["out-of-range"]);
    assert_eq!(codes("inset = [1, 1, 2, 2], inset_at = 'N'"), ["unknown-word"]);
    assert_eq!(codes("inset_at = 'NE'"), ["conflict"]);
}

/// The default picture of two bodies at a distance, on a page of a width.
fn apart(gap: f64, query: &str, width: u32) -> Figure {
    let text = format!(
        "shapes.crate = {{ kind = 'box', half_extents = [1, 1], position = [0.3, {}] }}
        shapes.floor = {{ kind = 'aabb', half_extents = [4, 0.5] }}
        query = {{ kind = '{query}', of = ['crate', 'floor'] }}
        canvas.width = {width}",
        1.5 + gap
    );
    let scene = open_text("apart", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    draw_in_steps(&plan, plan.theme, "apart")
}

#[test]
fn a_length_too_short_to_be_seen_is_enlarged_in_every_panel_and_a_longer_one_in_none() {
    for (gap, query) in [(0.02, "separation"), (-0.02, "separation"), (0.001, "overlap"), (-0.02, "contact")]
    {
        for width in [700, 960, 1800] {
            let figure = apart(gap, query, width);
            // The first panel of points of contact shows no depth.
            let wanted = if query == "contact" { 1 } else { 2 };
            assert_eq!(figure.insets.len(), wanted, "{gap} {query} {width}");
            let own = &figure.panels[figure.panels.len() - wanted..];
            for (inset, panel) in figure.insets.iter().zip(own) {
                let length = gap.abs() * inset.frame.scale;
                // Where the inset has no room for its words, the panel has them.
                let keys: Vec<_> = inset.placed.iter().chain(&panel.placed).map(|label| label.key).collect();
                assert!(length > 10.0 && length < 90.0, "{gap} {query} {width}: {length} px");
                assert!(keys.iter().any(|key| key.starts_with('d')), "{gap} {query} {width}: {keys:?}");
            }
        }
    }
    assert!(apart(0.5, "separation", 960).insets.is_empty());
    assert!(apart(-0.5, "contact", 960).insets.is_empty());
    assert!(apart(0.0, "separation", 960).insets.is_empty());
}

#[test]
fn a_panel_without_room_for_an_inset_reaches_higher_and_is_no_emptier_for_it() {
    let figure = apart(-0.02, "contact", 960);
    let (panel, inset) = (figure.panels[1].frame.panel, figure.insets[0].frame.panel);
    let over = figure.panels[1].placed.iter().find(|label| label.bounds.intersection(inset).is_some());
    assert!(over.is_none() && panel.union(inset) == panel, "{over:?}");
}

#[test]
fn an_inset_of_a_small_length_comes_with_the_answer() {
    let figure = apart(0.02, "separation", 960);
    let painted = |step: usize| {
        let drawing = figure.drawing.at_step(step);
        ["inset", "detail"].map(|name| {
            group(&drawing.items, name)
                .is_some_and(|own| !paths(&[Item::Group(own.clone())], name).is_empty())
        })
    };
    assert_eq!(painted(1), [false, false]);
    assert_eq!(painted(figure.drawing.steps.len()), [true, true]);
}

/// Whether anything of an item is drawn.
fn is_seen(item: &Item) -> bool {
    match item {
        Item::Group(group) => group.items.iter().any(is_seen),
        Item::Path(_) | Item::Text(_) => true,
    }
}

#[test]
fn nothing_in_an_inset_is_seen_without_it() {
    let shapes = [
        "kind = 'box', half_extents = [1, 1], position = [0.3, 1.48]",
        "kind = 'polygon', vertices = [[-1, 0.48], [1, 0.49], [0, 3]]",
    ];
    for (query, shape) in ["contact", "separation", "overlap"].iter().flat_map(|q| shapes.map(|s| (q, s))) {
        let text = format!(
            "shapes.crate = {{ {shape} }}
            shapes.floor = {{ kind = 'aabb', half_extents = [4, 0.5] }}
            query = {{ kind = '{query}', of = ['crate', 'floor'] }}"
        );
        let scene = open_text("steps", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawing = draw_in_steps(&plan, plan.theme, "steps").drawing;
        let count = drawing.steps.len();
        let insets = (1..=count).filter_map(|step| {
            let items = drawing.at_step(step).items;
            let own = group(&items, "inset")?.clone();
            Some((step, own.items.iter().any(is_seen), own.items.iter().any(|i| matches!(i, Item::Path(_)))))
        });
        let insets: Vec<_> = insets.collect();
        assert!(insets.iter().any(|(_, _, is_there)| *is_there), "{query} {shape}");
        for (step, holds, is_there) in insets {
            assert!(is_there || !holds, "{query} {shape}: step {step} of {count}");
        }
    }
}

#[test]
fn the_word_for_what_is_small_is_read_and_no_other() {
    let codes = |panel: &str| match open_text("inset", &scene(panel)) {
        Err(problems) => problems.problems.iter().map(|p| p.fault.to_string()).collect::<Vec<_>>(),
        Ok(file) => plan(&file.scene)
            .map_or_else(|problems| problems.iter().map(|p| p.fault.to_string()).collect(), |_| Vec::new()),
    };
    assert_eq!(codes("inset = 'small'"), [""; 0]);
    let wrong = codes("inset = 'tiny'");
    assert_eq!(
        wrong,
        ["`inset`: expected four numbers [x0, y0, x1, y1], or \"small\", got the text \"tiny\""]
    );
}

/// The default picture of the contact of two shapes.
fn contact(a: &str, b: &str) -> Figure {
    let text = format!(
        "shapes.A = {{ kind = 'regular-polygon', {a} }}\nshapes.B = {{ kind = 'regular-polygon', {b} }}
        query = {{ kind = 'contact', of = ['A', 'B'] }}"
    );
    let scene = open_text("contact", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    draw(&plan, plan.theme, "contact")
}

#[test]
fn contacts_that_lie_on_one_spot_are_enlarged() {
    let b = "edges = 60, circumradius = 1.1, radius = 0.2, position = [1.9, 1.7], angle_deg = 2.5";
    let figure = contact("edges = 200, circumradius = 2", b);
    let named: Vec<_> = figure.insets.iter().flat_map(|inset| inset.placed.iter().map(|l| l.key)).collect();
    assert!(named.contains(&"c_1") && named.contains(&"c_2"), "{named:?}");
}

#[test]
fn a_body_that_the_mark_of_its_contact_covers_is_seen_in_an_inset() {
    for kind in ["linear-sweep", "time-of-impact"] {
        for (radius, insets) in [(0.5, 1), (30.0, 0)] {
            let text = format!(
                "shapes.train = {{ kind = 'box', half_extents = [100, 20], position = [-160, 0],
                    velocity = [80, 5] }}
                shapes.egg = {{ kind = 'circle', radius = {radius}, position = [10, 8] }}
                query = {{ kind = '{kind}', of = ['train', 'egg'] }}"
            );
            let scene = crate::scene::open_text("s.toml", &text).unwrap().scene;
            let plan = crate::figure::plan(&scene).unwrap();
            let figure = crate::figure::draw(&plan, plan.theme, "s");
            assert_eq!(figure.insets.len(), insets, "{kind}, {radius}");
        }
    }
}

#[test]
fn a_corner_that_is_named_holds_for_what_is_small_and_hides_no_numbers() {
    for (at, [right, down]) in [("NE", [1.0, -1.0]), ("NW", [-1.0, -1.0]), ("SW", [-1.0, 1.0])] {
        let figure = drawn(&format!("inset = 'small', inset_at = '{at}'"));
        let (cell, rect) = (figure.panels[0].frame.panel, figure.insets[0].frame.panel);
        let off = rect.center() - cell.center();
        assert!(right * off.dx > 0.0 && down * off.dy > 0.0, "{at}: {off:?}");
        // The rows of numbers: letters of 12, and a gap on both sides.
        let apart = [rect.x0 - cell.x0, cell.y1 - rect.y1];
        assert!(apart[0] > 20.0 && apart[1] > 16.0, "{at}: {apart:?}");
    }
}
