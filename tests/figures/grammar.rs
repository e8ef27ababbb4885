//! The grammar of marks, held on the display list of every committed figure in every theme: what a stroke
//! looks like says what it means, so that nothing here asks for the name of a layer or part.

use std::path::Path as File;

use tracefig::drawing::{Cap, Contour, Item, Offset, Path, Point, Role, Segment};
use tracefig::figure::{Figure, draw, plan, theme};
use tracefig::geometry::DVec2;

use super::seen::{distance, dotted, edges};

/// Every theme with colours of its own.
const THEMES: [&str; 3] = ["light", "dark", "print"];

/// How far from an outline a dashed line counts as lying on it, page pixels, and how long it must.
const ON: (f64, f64) = (1.5, 16.0);

/// All paths of some items.
fn paths<'d>(items: &'d [Item], found: &mut Vec<&'d Path>) {
    for item in items {
        match item {
            Item::Group(group) => paths(&group.items, found),
            Item::Path(path) => found.push(path),
            Item::Text(_) => {}
        }
    }
}

/// The words of some items.
fn texts(items: &[Item], found: &mut Vec<String>) {
    for item in items {
        match item {
            Item::Group(group) => texts(&group.items, found),
            Item::Text(text) => found.push(text.line.markup.clone()),
            Item::Path(_) => {}
        }
    }
}

fn is_dashed(path: &Path) -> bool {
    path.stroke.as_ref().is_some_and(|s| !s.dash.is_empty() && s.cap == Cap::Butt)
}

fn is_dotted(path: &Path) -> bool {
    path.stroke.as_ref().is_some_and(|s| !s.dash.is_empty() && s.cap == Cap::Round)
}

/// The tip and direction of a filled head: a small triangle whose first vertex is farther from the others than
/// they are from each other.
fn head(path: &Path) -> Option<(Point, Offset)> {
    let Contour::Segments(segments) = &path.contour else { return None };
    let [Segment::Move(tip), Segment::Line(p), Segment::Line(q), ..] = segments[..] else { return None };
    let small = segments.len() <= 4 && distance(tip, p) < 20.0 && distance(p, q) < distance(tip, p);
    let middle = Point::new(0.5 * (p.x + q.x), 0.5 * (p.y + q.y));
    (path.fill.is_some() && path.stroke.is_none() && small).then_some((tip, tip - middle))
}

/// How far a dashed piece lies on an edge, page pixels.
fn together((p, q): (Point, Point), (a, b): (Point, Point)) -> f64 {
    let length = distance(p, q);
    let (ux, uy) = ((q.x - p.x) / length, (q.y - p.y) / length);
    let place = |x: Point| {
        let (dx, dy) = (x.x - p.x, x.y - p.y);
        (dx * ux + dy * uy, (dx * uy - dy * ux).abs())
    };
    let steps = 64;
    let near = |i: i32| {
        let t = f64::from(i) / f64::from(steps);
        let (along, off) = place(Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t));
        (0.0..=length).contains(&along) && off <= ON.0
    };
    let count = (0..=steps).filter(|&i| near(i)).count();
    distance(a, b) * f64::from(u32::try_from(count).unwrap_or(0)) / f64::from(steps + 1)
}

/// What breaks the grammar among the paths and texts of one panel.
fn broken(items: &[Item], origins: &[Point]) -> Vec<String> {
    let (mut all, mut words) = (Vec::new(), Vec::new());
    paths(items, &mut all);
    texts(items, &mut words);
    let mut wrong = Vec::new();
    dashes(&all, &mut wrong);
    if all.iter().any(|p| is_dotted(p)) {
        let says = |word: &String| {
            [
                "t =",
                "at $t_",
                "pushed out",
                "pushed to",
                "turned",
                "moved around",
                "$ moved",
                "moved:",
                "vertex moved",
                "before the turn",
            ]
            .iter()
            .any(|w| word.contains(w))
        };
        if !words.iter().any(says) {
            wrong.push(format!("dotted outlines, and no label says when or where: {words:?}"));
        }
        if all.iter().any(|p| is_dotted(p) && !dotted(p)) {
            wrong.push("a dotted outline is filled as a body that is there".to_owned());
        }
    }
    let heads: Vec<(Point, Offset)> = all.iter().filter_map(|p| head(p)).collect();
    for line in all.iter().filter(|p| p.stroke.is_some()).flat_map(|p| edges(p)) {
        let at = |end: Point, out: Offset| {
            let looks = |d: Offset| d.dx * out.dx + d.dy * out.dy > 0.999 * length(d) * length(out);
            heads.iter().any(|&(tip, d)| distance(tip, end) < 10.0 && looks(d))
        };
        if distance(line.0, line.1) > 24.0 && at(line.0, line.0 - line.1) && at(line.1, line.1 - line.0) {
            wrong.push(format!("two heads on the line {line:?}"));
        }
    }
    for center in rings(&all) {
        if origins.iter().all(|&origin| distance(center, origin) > 1e-6) {
            wrong.push(format!("the origin's mark at {center:?}, which is not the origin"));
        }
    }
    wrong
}

fn length(d: Offset) -> f64 {
    libm::hypot(d.dx, d.dy)
}

/// Dashes that are no thin grey construction, or lie on an outline.
fn dashes(all: &[&Path], wrong: &mut Vec<String>) {
    let outline = |p: &&&Path| {
        let stroke = p.stroke.as_ref().filter(|s| s.dash.is_empty());
        stroke.is_some_and(|s| matches!(s.paint.role, Some(Role::A | Role::B | Role::Difference)))
    };
    let outlines: Vec<(Point, Point)> = all.iter().filter(outline).flat_map(|p| edges(p)).collect();
    for path in all.iter().filter(|p| is_dashed(p)) {
        let Some(stroke) = &path.stroke else { continue };
        if stroke.paint.role != Some(Role::Muted) || stroke.width > 1.5 || path.fill.is_some() {
            wrong.push(format!("dashes that are no construction: {stroke:?}"));
        }
        for piece in edges(path) {
            if let Some(edge) = outlines.iter().find(|edge| together(piece, **edge) >= ON.1) {
                wrong.push(format!("dashes {piece:?} over the outline {edge:?}"));
            }
        }
    }
}

/// Where a disc stands in a ring.
fn rings(all: &[&Path]) -> Vec<Point> {
    let circle = |p: &&Path| match p.contour {
        Contour::Circle { center, radius } => Some((center, radius)),
        Contour::Segments(_) => None,
    };
    let hollow = all.iter().filter(|p| p.fill.is_some_and(|f| f.role == Some(Role::Background)));
    let full: Vec<(Point, f64)> = all.iter().filter(|p| p.stroke.is_none()).filter_map(circle).collect();
    hollow
        .filter(|p| p.stroke.is_some())
        .filter_map(circle)
        .filter(|(c, r)| full.iter().any(|(d, s)| distance(*c, *d) < 1e-6 && s < r))
        .map(|(c, _)| c)
        .collect()
}

/// A committed figure in a theme.
fn drawn(stem: &str, name: &str) -> Figure {
    let path = File::new(env!("CARGO_MANIFEST_DIR")).join("figures").join(format!("{stem}.toml"));
    let file = tracefig::open(&path).unwrap_or_else(|e| panic!("{stem}: {e:?}"));
    let plan = plan(&file.scene).unwrap_or_else(|e| panic!("{stem}: {e:?}"));
    draw(&plan, theme::find(name).unwrap_or_else(|| panic!("{name}")), stem)
}

/// What breaks the grammar in a figure, panel by panel.
fn faults(figure: &Figure) -> Vec<String> {
    let groups = figure.drawing.items.iter().filter_map(|item| match item {
        Item::Group(group) if group.name.starts_with("panel-") => Some(&group.items),
        _ => None,
    });
    let enlarged: Vec<Point> = figure.insets.iter().map(|inset| inset.frame.page(DVec2::ZERO)).collect();
    let origins = figure.panels.iter().map(|panel| panel.frame.page(DVec2::ZERO));
    let origins = origins.map(|origin| [&enlarged[..], &[origin]].concat());
    groups.zip(origins).flat_map(|(items, origins)| broken(items, &origins)).collect()
}

/// The names of the committed scenes.
fn stems() -> Vec<String> {
    let folder = File::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut stems: Vec<String> = std::fs::read_dir(folder)
        .unwrap_or_else(|e| panic!("{e}"))
        .filter_map(|entry| entry.ok()?.file_name().to_str()?.strip_suffix(".toml").map(str::to_owned))
        .collect();
    stems.sort();
    assert!(stems.len() >= 19, "{stems:?}");
    stems
}

#[test]
fn every_figure_keeps_the_grammar_in_every_theme() {
    let mut wrong = Vec::new();
    for stem in &stems() {
        for theme in THEMES {
            let found = faults(&drawn(stem, theme));
            wrong.extend(found.into_iter().map(|fault| format!("{stem}, {theme}: {fault}")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_letters_of_bodies_and_of_the_origin_are_in_italics_wherever_they_stand() {
    let mut upright = Vec::new();
    for stem in stems() {
        let mut all = Vec::new();
        texts(&drawn(&stem, "light").drawing.items, &mut all);
        upright
            .extend(all.iter().filter(|text| has_upright_letter(text)).map(|text| format!("{stem}: {text}")));
    }
    assert!(upright.is_empty(), "{}", upright.join("\n"));
    // An article, too, would be read as a body.
    assert!(has_upright_letter("A ray enters") && has_upright_letter("{b|B}’s $n$"));
    assert!(!has_upright_letter("{b|$B$}’s edge of $A$, AABB"));
}

/// Whether a markup has A, B or O as a word outside its formulas.
fn has_upright_letter(markup: &str) -> bool {
    let words = |text: &str| text.split(|c: char| !c.is_alphanumeric()).any(|w| ["A", "B", "O"].contains(&w));
    markup.split('$').step_by(2).any(words)
}

#[test]
fn dashes_on_an_outline_and_a_second_head_are_found() {
    let mut figure = drawn("demo-polygons", "light");
    assert!(faults(&figure).is_empty());
    let outline = |path: &mut Path| {
        let Some(stroke) = &mut path.stroke else { return };
        if stroke.dash.is_empty() && stroke.paint.role == Some(Role::A) {
            let copy = Path { fill: None, ..path.clone() };
            let mut dashed = copy;
            if let Some(stroke) = &mut dashed.stroke {
                (stroke.dash, stroke.width) = (vec![7.0, 4.0], 1.0);
                stroke.paint.role = Some(Role::Muted);
            }
            *path = dashed;
        }
    };
    let before = figure.drawing.items.clone();
    each(&mut figure.drawing.items, &mut |path| outline(path));
    for (group, clean) in figure.drawing.items.iter_mut().zip(before) {
        if let (Item::Group(group), Item::Group(clean)) = (group, clean) {
            group.items.extend(clean.items);
        }
    }
    assert!(faults(&figure).iter().any(|fault| fault.contains("over the outline")));
}

/// Changes every path of some items.
fn each(items: &mut [Item], change: &mut impl FnMut(&mut Path)) {
    for item in items {
        match item {
            Item::Group(group) => each(&mut group.items, change),
            Item::Path(path) => change(path),
            Item::Text(_) => {}
        }
    }
}
