//! What is far smaller or larger than the bodies can be seen all the same: bodies that are points, and marks
//! of a length of their own.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use tracefig::drawing::{Contour, Drawing, Group, Item, Point};
use tracefig::figure::{Figure, draw, plan};
use tracefig::geometry::DVec2;
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Source, read};

fn figure(text: &str) -> Figure {
    let scene = read(&Source::new("s.toml", text)).unwrap();
    let plan = plan(&scene).unwrap();
    draw(&plan, plan.theme, "s")
}

/// The boxes of what a part of the drawing paints.
fn painted(drawing: &Drawing, part: &str) -> Vec<(Point, f64)> {
    fn walk(items: &[Item], inside: bool, part: &str, found: &mut Vec<(Point, f64)>) {
        for item in items {
            match item {
                Item::Group(Group { name, items, .. }) => walk(items, inside || name == part, part, found),
                Item::Path(path) if inside => {
                    let reach = |c: &Contour| c.bounds().map(|b| (b.center(), b.width().max(b.height())));
                    found.extend(reach(&path.contour));
                }
                Item::Path(_) | Item::Text(_) => {}
            }
        }
    }
    let mut found = Vec::new();
    walk(&drawing.items, false, part, &mut found);
    found
}

/// Whether two points of the page look like one.
fn near(p: Point, q: Point) -> bool {
    libm::hypot(p.x - q.x, p.y - q.y) < 0.5
}

/// A scene of a pair with a body that is a point at [−2, 0], and another at [2, 0].
fn with_a_point(point: &str, other: &str, layers: &str) -> Figure {
    figure(&format!(
        "[shapes.A]\n{point}\nposition = [-2, 0]\n[shapes.B]\n{other}\nposition = [2, 0]\n\
         [query]\nkind = 'separation'\nof = ['A', 'B']\n{layers}"
    ))
}

#[test]
fn a_body_that_is_a_point_is_seen_as_a_marker() {
    let world = "[[panels]]\nlayers = ['shapes']";
    let block = "kind = 'box'\nhalf_extents = [1, 0.5]";
    for point in [
        "kind = 'circle'\nradius = 0",
        "kind = 'circle'\nradius = 1e-9",
        "kind = 'capsule'\npoints = [[0, 0], [0, 0]]\nradius = 0",
    ] {
        let figure = with_a_point(point, block, world);
        let at = figure.panels[0].frame.page(DVec2::new(-2.0, 0.0));
        let seen = painted(&figure.drawing, "body-A");
        let seen_at = |(p, size): &&(Point, f64)| near(*p, at) && (6.0..16.0).contains(size);
        assert_eq!(seen.iter().filter(seen_at).count(), 1, "{point}: {seen:?}");
        assert!(figure.faults().is_empty(), "{point}: {:?}", figure.faults());
    }
}

#[test]
fn a_body_that_is_a_segment_is_a_line_and_a_difference_of_points_a_diamond() {
    let figure = with_a_point(
        "kind = 'circle'\nradius = 0",
        "kind = 'capsule'\npoints = [[0, 0], [0, 1]]\nradius = 0",
        "[[panels]]\nlayers = ['shapes']",
    );
    let [(_, length), ..] = painted(&figure.drawing, "body-B")[..] else { panic!("a line") };
    assert!(length > 16.0);
    let points = with_a_point(
        "kind = 'circle'\nradius = 0",
        "kind = 'circle'\nradius = 0",
        "[[panels]]\nspace = 'configuration'\nlayers = ['difference', 'origin']",
    );
    let at = points.panels[0].frame.page(DVec2::new(4.0, 0.0));
    assert!(painted(&points.drawing, "difference").iter().any(|(p, _)| near(*p, at)));
}

/// Length of the drawn normal, page pixels, and its label, of a pair of bodies of a size.
fn normal(size: f64, options: &str) -> (f64, String) {
    let figure = figure(&format!(
        "[shapes.A]\nkind = 'circle'\nradius = {size}\n\
         [shapes.B]\nkind = 'circle'\nradius = {size}\nposition = [{}, 0]\n\
         [query]\nkind = 'separation'\nof = ['A', 'B']\n\
         [[panels]]\nlayers = ['shapes', {{ layer = 'normal' {options} }}]",
        4.0 * size
    ));
    let length = painted(&figure.drawing, "normal").iter().map(|&(_, size)| size).fold(0.0, f64::max);
    let label = figure.panels[0].placed.iter().find(|p| p.key == "n").unwrap();
    let words = painted_words(&figure.drawing, "label-n");
    assert!(label.bounds.width() > 0.0);
    (length, words)
}

/// The texts that a part of the drawing says.
fn painted_words(drawing: &Drawing, part: &str) -> String {
    fn walk(items: &[Item], inside: bool, part: &str, found: &mut String) {
        for item in items {
            match item {
                Item::Group(Group { name, items, .. }) => walk(items, inside || name == part, part, found),
                Item::Text(text) if inside => found.push_str(&text.line.markup),
                Item::Path(_) | Item::Text(_) => {}
            }
        }
    }
    let mut found = String::new();
    walk(&drawing.items, false, part, &mut found);
    found
}

#[test]
fn a_unit_normal_has_its_length_or_says_that_it_has_not() {
    let (length, says) = normal(2.0, "");
    assert!(says == "$n$" && length > 60.0, "{length}: {says}");
    for size in [1e-6, 0.01, 200.0, 1e6] {
        let (length, says) = normal(size, "");
        assert!(says == "$n$ (not to scale)" && (14.0..60.0).contains(&length), "{size}: {length} {says}");
    }
    let (_, says) = normal(200.0, ", length = 100");
    assert_eq!(says, "$100$ $n$", "a vector that is not one long says how long it is");
}

#[test]
fn a_tiny_gap_is_enlarged_as_far_as_a_page_reaches_and_no_line_runs_through_its_label() {
    let Some(Writer::One(write)) = format("svg").map(|f| f.write) else { panic!("SVG is a format") };
    for gap in [3e-2, 3e-3, 3e-4, 2e-4] {
        let figure = figure(&format!(
            "shapes.disc = {{ kind = 'circle', radius = 1, position = [0, {}] }}
            shapes.floor = {{ kind = 'aabb', half_extents = [6, 0.25], position = [0, -0.25] }}
            query = {{ kind = 'separation', of = ['disc', 'floor'] }}",
            1.0 + gap
        ));
        assert!(figure.faults().is_empty(), "{gap}: {:?}", figure.faults());
        let written = write(&figure.drawing, &Options::default());
        assert!(written.is_ok(), "{gap}: {:?}", written.err());
        let svg = String::from_utf8(written.unwrap()).unwrap();
        assert!(svg.contains("enlarged"), "{gap}: it is too small to be seen");
    }
}
