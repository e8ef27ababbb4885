//! Drawings for the tests of the formats: one with everything that a display list can hold, in the style of a
//! figure.

use std::sync::Arc;

use crate::drawing::{
    Cap, Clip, Color, Contour, Drawing, Group, Halo, Item, Paint, Path, Pattern, PatternKind, Point, Rect,
    Role, Segment, Shown, Stroke, Text,
};
use crate::typeset::{Style, typeset, wrap};

const fn paint(role: Role) -> Paint {
    let color = match role {
        Role::A => 0xA3_16_1F,
        Role::B => 0x00_85_6F,
        Role::Difference => 0x3A_2F_B0,
        Role::Now => 0xB3_5C_00,
        Role::Translation => 0x0B_5F_CC,
        Role::Overlap => 0xFF_E1_8C,
        Role::Ink => 0x1B_1F_24,
        Role::Muted => 0x5B_64_72,
        Role::Grid => 0xE6_E9_EE,
        Role::Background => 0xFF_FF_FF,
    };
    Paint::role(role, Color::hex(color))
}

fn path(contour: Contour, role: Role, width: f64) -> Path {
    let fill = Some(paint(role).with_opacity(0.14));
    Path {
        contour,
        fill,
        pattern: None,
        stroke: Some(Stroke::solid(paint(role), width)),
        shown: Shown::ALWAYS,
    }
}

fn dashed(contour: Contour, role: Role, dash: &[f64]) -> Item {
    Item::Path(Path::stroked(contour, Stroke { dash: dash.to_vec(), ..Stroke::solid(paint(role), 1.5) }))
}

fn label(markup: &str, x: f64, y: f64, role: Role) -> Item {
    let line = Arc::new(typeset(markup, Style::regular(16.0)).unwrap());
    let halo = Some(Halo::plain(paint(Role::Background), 2.5));
    Item::Text(Text { line, origin: Point::new(x, y), paint: paint(role), halo, shown: Shown::ALWAYS })
}

/// A page like figure 3, with an arc, a pattern, a clip and a see-through group besides.
pub(super) fn everything() -> Drawing {
    let mut shapes = Group::new("shapes");
    shapes.label = Some("shapes A & B".into());
    let corners =
        [(136.0, 259.0), (697.0, 259.0), (697.0, 399.0), (136.0, 399.0)].map(|(x, y)| Point::new(x, y));
    shapes.items.push(Item::Path(path(Contour::polygon(&corners), Role::A, 2.25)));
    let circle = Contour::Circle { center: Point::new(803.0, 118.0), radius: 70.3 };
    let dots = Some(Pattern { kind: PatternKind::Dots, paint: paint(Role::B).with_opacity(0.5) });
    shapes.items.push(Item::Path(Path { pattern: dots, ..path(circle, Role::B, 2.25) }));
    let mut items = vec![grid(), Item::Group(shapes), lines(), sector(), ghosts()];
    let mut labels = Group::new("labels");
    labels.items = vec![
        label("$A$", 172.0, 376.0, Role::A),
        label("clamped $V_x$", 520.0, 346.0, Role::A),
        label(r"distance $= \|D\| - r = \frac{3}{2}$", 730.0, 276.0, Role::Translation),
        label("$B_c$, $A'$", 704.0, 240.0, Role::Ink),
        label("Ærø Ωμέγα Жизнь", 40.0, 60.0, Role::Ink),
    ];
    items.push(Item::Group(labels));
    let caption = "$V$ runs from A's centre to B's. Cut down to the half-extents $h_x$ and $h_y$, its \
                   components $V_x$ and $V_y$ (red) lead to $B_c$, the point of A closest to B. \
                   $D = B - B_c$, and the distance is $\\|D\\| - r$.";
    for (i, line) in (0_u8..).zip(wrap(caption, Style::regular(14.0), 912.0).unwrap()) {
        let origin = Point::new(24.0, 498.0 + 20.0 * f64::from(i));
        items.push(Item::Text(Text {
            line: Arc::new(line),
            origin,
            paint: paint(Role::Ink),
            halo: None,
            shown: Shown::ALWAYS,
        }));
    }
    Drawing {
        width: 960.0,
        height: 540.0,
        id: "sample".into(),
        lang: None,
        title: "Circle against box".into(),
        is_titled: false,
        heading: None,
        desc: "A box A and a circle B <apart> & \"alone\".".into(),
        background: paint(Role::Background),
        ink: paint(Role::Ink).color,
        words: Vec::new(),
        fill_opacity: 0.14,
        dark: None,
        metadata: "{\"version\":1,\"hash\":\"00ff\"}".into(),
        hash: "00ff".into(),
        items,
        steps: Vec::new(),
        motion: Vec::new(),
        narrow: None,
    }
}

fn grid() -> Item {
    let mut grid = Group::new("grid");
    for i in 0..24_u8 {
        let x = 40.0 * f64::from(i);
        let line = Contour::line(Point::new(x, 44.0), Point::new(x, 476.0));
        grid.items.push(Item::Path(Path::stroked(line, Stroke::solid(paint(Role::Grid), 0.75))));
    }
    Item::Group(grid)
}

/// Vectors and construction lines.
fn lines() -> Item {
    let mut group = Group::new("clamp");
    let vector = Contour::line(Point::new(417.0, 329.0), Point::new(795.0, 123.0));
    group.items.push(Item::Path(Path::stroked(vector, Stroke::solid(paint(Role::Ink), 1.75))));
    let head = [(803.0, 118.0), (793.5, 119.5), (796.6, 125.2)].map(|(x, y)| Point::new(x, y));
    group.items.push(Item::Path(Path::filled(Contour::polygon(&head), paint(Role::Ink))));
    let up = Contour::line(Point::new(803.0, 329.0), Point::new(803.0, 118.0));
    group.items.push(dashed(up, Role::Muted, &[7.0, 4.0]));
    let across = Contour::line(Point::new(417.0, 118.0), Point::new(803.0, 118.0));
    group.items.push(dashed(across, Role::Muted, &[7.0, 4.0]));
    Item::Group(group)
}

/// A sector of 4 radians: an arc between two lines, hatched, cut by a clip.
fn sector() -> Item {
    let center = Point::new(150.0, 160.0);
    let arc = Segment::Arc { center, radius: 60.0, start: 0.5, sweep: 4.0 };
    let contour = Contour::Segments(vec![Segment::Move(center), arc, Segment::Close]);
    let hatch = Some(Pattern { kind: PatternKind::Hatch, paint: paint(Role::Difference).with_opacity(0.6) });
    let mut group = Group::new("difference");
    group.role = Some(Role::Difference);
    let clip = Rect { x0: 105.25, y0: 80.0, x1: 300.0, y1: 210.5 };
    group.clip = Some(Clip::rounded(clip, 20.0));
    group.items.push(Item::Path(Path { pattern: hatch, ..path(contour, Role::Difference, 3.0) }));
    Item::Group(group)
}

fn ghosts() -> Item {
    let mut all = Group::new("ghosts");
    for i in 0..3_u8 {
        let center = Point::new(300.0 + 40.0 * f64::from(i), 150.0);
        let mut ghost = Group::new("ghost");
        ghost.opacity = 0.3 + 0.2 * f64::from(i);
        let stroke =
            Stroke { dash: vec![0.01, 3.5], cap: Cap::Round, ..Stroke::solid(paint(Role::Now), 1.25) };
        let fill = Some(paint(Role::Now).with_opacity(0.14));
        let contour = Contour::Circle { center, radius: 45.0 };
        ghost.items.push(Item::Path(Path {
            contour,
            fill,
            pattern: None,
            stroke: Some(stroke),
            shown: Shown::ALWAYS,
        }));
        all.items.push(Item::Group(ghost));
    }
    Item::Group(all)
}
