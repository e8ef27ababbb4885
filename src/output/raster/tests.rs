//! What the pixels of areas, lines and texts must be, from outside: black ink on white paper, as coverage.

use std::sync::Arc;

use super::rasterize;
use crate::drawing::{
    Cap, Clip, Color, Contour, Drawing, Group, Halo, Item, Paint, Path, Pattern, PatternKind, Point, Rect,
    Role, Segment, Shown, Stroke, Text,
};
use crate::output::samples::everything;
use crate::typeset::{Style, typeset};

const BLACK: Paint = Paint::role(Role::Ink, Color::hex(0));
const WHITE: Paint = Paint::role(Role::Background, Color::hex(0xFF_FF_FF));

/// A drawing as coverage: 0 is white, 1 is black.
struct Seen {
    width: usize,
    coverage: Vec<f64>,
}

impl Seen {
    fn of(items: Vec<Item>, (width, height): (f64, f64), scale: f64) -> Self {
        let ink = BLACK.color;
        let drawing = Drawing { width, height, background: WHITE, ink, items, ..everything() };
        let pixels = rasterize(&drawing, scale).unwrap();
        let dark = pixels.rgba.chunks_exact(4).map(|pixel| 1.0 - f64::from(pixel[0]) / 255.0);
        Self { width: pixels.width as usize, coverage: dark.collect() }
    }

    fn at(&self, x: usize, y: usize) -> f64 {
        self.coverage[y * self.width + x]
    }

    /// The whole area that is covered, in pixels.
    fn area(&self) -> f64 {
        self.coverage.iter().sum()
    }

    /// The farthest that a pixel is from the other's.
    fn farthest(&self, other: &Self) -> f64 {
        assert_eq!(self.coverage.len(), other.coverage.len());
        self.coverage.iter().zip(&other.coverage).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }
}

fn points(places: &[(f64, f64)]) -> Vec<Point> {
    places.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

/// Closed polygons that are one contour.
fn polygons(all: &[&[(f64, f64)]]) -> Contour {
    let mut segments = Vec::new();
    for polygon in all {
        let Contour::Segments(more) = Contour::polygon(&points(polygon)) else { continue };
        segments.extend(more);
    }
    Contour::Segments(segments)
}

fn filled(contour: Contour) -> Vec<Item> {
    vec![Item::Path(Path::filled(contour, BLACK))]
}

/// Polygons filled, on a page of 8 by 6.
fn covered(all: &[&[(f64, f64)]]) -> Seen {
    Seen::of(filled(polygons(all)), (8.0, 6.0), 1.0)
}

fn line(contour: Contour, width: f64, dash: &[f64], cap: Cap) -> Seen {
    let stroke = Stroke { dash: dash.to_vec(), cap, ..Stroke::solid(BLACK, width) };
    Seen::of(vec![Item::Path(Path::stroked(contour, stroke))], (100.0, 100.0), 1.0)
}

fn text(markup: &str, origin: (f64, f64), halo: Option<Halo>) -> Item {
    let line = Arc::new(typeset(markup, Style::regular(40.0)).unwrap());
    Item::Text(Text {
        line,
        origin: Point::new(origin.0, origin.1),
        paint: BLACK,
        halo,
        shown: Shown::ALWAYS,
    })
}

/// How much of each pixel is inside, by 16 by 16 samples.
fn sampled((width, height): (usize, usize), inside: impl Fn(f64, f64) -> bool) -> Seen {
    let place = |pixel: usize, sample: u32| {
        f64::from(u32::try_from(pixel).unwrap()) + (f64::from(sample) + 0.5) / 16.0
    };
    let hits = |x, y| {
        let samples = (0..16).flat_map(|j| (0..16).map(move |i| (i, j)));
        samples.filter(|&(i, j)| inside(place(x, i), place(y, j))).count()
    };
    let each = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let coverage = each.map(|(x, y)| f64::from(u32::try_from(hits(x, y)).unwrap()) / 256.0).collect();
    Seen { width, coverage }
}

#[test]
fn a_rectangle_covers_its_area_with_halves_at_half_pixels() {
    let seen = covered(&[&[(1.5, 1.0), (4.0, 1.0), (4.0, 2.5), (1.5, 2.5)]]);
    let near = |x, y, expected: f64| assert!((seen.at(x, y) - expected).abs() < 0.01, "{x} {y}");
    near(1, 1, 0.5);
    near(2, 1, 1.0);
    near(3, 1, 1.0);
    near(1, 2, 0.25);
    near(3, 2, 0.5);
    assert!((seen.area() - 3.75).abs() < 0.02, "nothing else is covered: {}", seen.area());
}

#[test]
fn the_sum_of_coverages_is_the_area_in_either_winding() {
    let triangle = [(0.3, 0.2), (7.7, 1.9), (2.1, 5.8)];
    let area = 0.5 * ((7.4 * 5.6) - (1.8 * 1.7));
    let seen = covered(&[&triangle]);
    assert!((seen.area() - area).abs() < 0.3, "{}", seen.area());
    let reversed: Vec<_> = triangle.into_iter().rev().collect();
    assert!(seen.farthest(&covered(&[&reversed])) < 0.001);
}

#[test]
fn what_lies_outside_the_image_is_cut() {
    let everything = covered(&[&[(-1e6, -1e6), (1e6, -1e6), (1e6, 1e6), (-1e6, 1e6)]]);
    assert_eq!(everything.area(), 48.0);
    assert_eq!(covered(&[&[(9.0, 1.0), (20.0, 1.0), (20.0, 3.0)]]).area(), 0.0);
    assert_eq!(covered(&[&[(-9.0, 1.0), (-2.0, 1.0), (-2.0, 3.0)]]).area(), 0.0);
    let half = covered(&[&[(4.0, -50.0), (4.0, 50.0), (-300.0, 0.0)]]);
    assert!((half.area() - 24.0).abs() < 0.5, "{}", half.area());
}

#[test]
fn areas_of_one_winding_do_not_add_up_beyond_one() {
    let one = [(1.0, 1.0), (5.0, 1.0), (5.0, 3.0), (1.0, 3.0)];
    let other = [(3.0, 1.0), (7.0, 1.0), (7.0, 3.0), (3.0, 3.0)];
    assert_eq!(covered(&[&one, &other]).area(), 12.0);
}

#[test]
fn contours_of_opposite_winding_that_share_an_edge_leave_no_seam() {
    let left = [(1.0, 1.0), (3.5, 1.0), (3.5, 5.0), (1.0, 5.0)];
    let right = [(3.5, 1.0), (3.5, 5.0), (6.0, 5.0), (6.0, 1.0)];
    let seen = covered(&[&left, &right]);
    for y in 1..5 {
        assert!(seen.at(3, y) > 0.99, "the pixel in which they meet is {} black", seen.at(3, y));
    }
}

#[test]
fn an_edge_run_through_twice_counts_once() {
    let half = [(1.0, 1.0), (3.5, 1.0), (3.5, 5.0), (1.0, 5.0)];
    let seen = covered(&[&half, &half]);
    assert!((seen.at(3, 2) - 0.5).abs() < 0.01, "{}", seen.at(3, 2));
}

#[test]
fn a_line_after_a_close_begins_where_the_closed_piece_began() {
    let mut segments = vec![Segment::Move(Point::new(20.0, 50.0)), Segment::Line(Point::new(20.0, 20.0))];
    segments.extend([Segment::Close, Segment::Line(Point::new(80.0, 50.0))]);
    let seen = line(Contour::Segments(segments), 4.0, &[], Cap::Butt);
    assert!(seen.at(50, 50) > 0.99, "{}", seen.at(50, 50));
}

#[test]
fn bands_change_nothing() {
    let outline = [(3.0, -20.0), (990.0, 40.5), (700.25, 93.0), (-40.0, 61.0)];
    let drawn = |width| Seen::of(filled(polygons(&[&outline])), (width, 100.0), 1.0);
    // Wide images have bands of fewer rows. A place is rounded to 1/256 of a pixel, which may move a sample.
    let (narrow, wide) = (drawn(1000.0), drawn(40_000.0));
    for y in 0..100 {
        for x in 0..1000 {
            assert!((narrow.at(x, y) - wide.at(x, y)).abs() < 0.07, "{x} {y}");
        }
    }
}

#[test]
fn a_line_has_its_length_times_its_width_and_round_ends_a_disc_more() {
    let contour = || Contour::line(Point::new(10.0, 10.0), Point::new(70.0, 55.0));
    let butt = line(contour(), 4.0, &[], Cap::Butt).area();
    assert!((butt - 300.0).abs() < 2.0, "{butt}");
    let round = line(contour(), 8.0, &[], Cap::Round).area();
    assert!((round - (600.0 + std::f64::consts::PI * 16.0)).abs() < 4.0, "{round}");
}

#[test]
fn a_closed_line_is_a_ring_in_either_winding() {
    let square = [(20.0, 20.0), (80.0, 20.0), (80.0, 80.0), (20.0, 80.0)];
    // Four sides of 60 × 6, less the corners' doubles, with quarter discs for the outer corners.
    let expected = 4.0 * 60.0 * 6.0 - 4.0 * 9.0 + std::f64::consts::PI * 9.0;
    for corners in [square.to_vec(), square.into_iter().rev().collect()] {
        let ring = line(polygons(&[&corners]), 6.0, &[], Cap::Butt).area();
        assert!((ring - expected).abs() < 2.0, "{ring} for {expected}");
    }
}

#[test]
fn a_sharp_corner_is_round_outside_and_has_no_hole_inside() {
    let contour = Contour::polyline(&points(&[(20.0, 80.0), (50.0, 20.0), (60.0, 80.0)]));
    let seen = line(contour, 10.0, &[], Cap::Butt);
    for y in [20, 24, 17] {
        assert!(seen.at(50, y) > 0.99, "{y}: {}", seen.at(50, y));
    }
    assert_eq!(seen.at(50, 13), 0.0, "no spike");
}

#[test]
fn a_small_ring_with_a_wide_line_is_a_ring() {
    let ring = Contour::Circle { center: Point::new(50.3, 49.8), radius: 15.0 };
    let seen = line(ring, 14.0, &[], Cap::Butt);
    let exact = sampled((100, 100), |x, y| (8.0..=22.0).contains(&libm::hypot(x - 50.3, y - 49.8)));
    // A level of coverage, and what 4 × 4 samples miss along a slanted edge.
    assert!(seen.farthest(&exact) < 0.2, "{}", seen.farthest(&exact));
    assert!((seen.area() - exact.area()).abs() < 3.0, "{} for {}", seen.area(), exact.area());
}

#[test]
fn dashes_cover_their_share_and_dots_are_dashes_without_length() {
    let contour = || Contour::polyline(&points(&[(5.0, 50.0), (50.0, 50.0), (95.0, 50.0)]));
    let dashed = line(contour(), 2.0, &[7.0, 3.0], Cap::Butt);
    assert!((dashed.area() - 2.0 * 63.0).abs() < 1.0, "{}", dashed.area());
    let gaps = (5..95).filter(|&x| dashed.at(x, 50) < 0.01).count();
    assert_eq!(gaps, 27, "nine gaps of three pixels");
    let dotted = line(contour(), 4.0, &[0.0, 10.0], Cap::Round);
    let expected = 9.0 * std::f64::consts::PI * 4.0;
    assert!((dotted.area() - expected).abs() < 4.0, "{} for {expected}", dotted.area());
    let solid = line(contour(), 2.0, &[0.0, 0.0], Cap::Butt);
    assert!((solid.area() - 180.0).abs() < 1.0, "dashes that lead nowhere are none: {}", solid.area());
}

#[test]
fn dots_around_a_circle_stand_where_its_length_puts_them() {
    // As the dots of a figure at twice its size.
    let (radius, turn) = (90.0, std::f64::consts::TAU / 40.0);
    let ring = Contour::Circle { center: Point::new(100.0, 100.0), radius };
    let stroke =
        Stroke { dash: vec![0.02, radius * turn - 0.02], cap: Cap::Round, ..Stroke::solid(BLACK, 4.0) };
    let seen = Seen::of(vec![Item::Path(Path::stroked(ring, stroke))], (200.0, 200.0), 1.0);
    for dot in 0..40 {
        let (sin, cos) = libm::sincos(f64::from(dot) * turn);
        let (mut ink, mut ahead) = (0.0, 0.0);
        for (i, covered) in seen.coverage.iter().enumerate() {
            let from =
                |i: usize, place: f64| f64::from(u32::try_from(i).unwrap()) + 0.5 - 100.0 - radius * place;
            let (dx, dy) = (from(i % 200, cos), from(i / 200, sin));
            if dx.abs().max(dy.abs()) < 4.0 {
                ink += covered;
                ahead += covered * (dy * cos - dx * sin);
            }
        }
        assert!((ahead / ink).abs() < 0.15, "dot {dot} is {} px ahead", ahead / ink);
    }
}

#[test]
fn a_thin_line_of_little_contrast_is_seen_in_every_row() {
    // As the grid of a figure: 0.75 page pixels in light grey on white.
    let grid = Stroke::solid(Paint::role(Role::Grid, Color::hex(0xE6_E9_EE)), 0.75);
    let contour = Contour::line(Point::new(100.0, 0.0), Point::new(228.0, 1024.0));
    for scale in [0.25, 0.5, 1.0, 2.0] {
        let path = Path::stroked(contour.clone(), grid.clone());
        let seen = Seen::of(vec![Item::Path(path)], (300.0, 1024.0), scale);
        let rows: Vec<f64> = seen.coverage.chunks_exact(seen.width).map(|row| row.iter().sum()).collect();
        assert!(rows.iter().all(|&row| row > 0.0), "a row without the line at {scale}");
        let length = libm::hypot(128.0, 1024.0) * scale;
        let expected = length * 0.75 * scale * 25.0 / 255.0;
        assert!((0.6..1.6).contains(&(seen.area() / expected)), "{} of {expected} at {scale}", seen.area());
    }
}

#[test]
fn small_dots_have_their_share_of_ink() {
    // As the dotted outlines and the dots of patterns, at a quarter of their size.
    for (width, gap) in [(1.25, 3.5), (2.2, 7.0)] {
        let contour = Contour::line(Point::new(20.0, 40.0), Point::new(20.0 + 100.0 * gap, 47.0));
        let stroke = Stroke { dash: vec![0.01, gap - 0.01], cap: Cap::Round, ..Stroke::solid(BLACK, width) };
        let path = Path::stroked(contour, stroke);
        let seen = Seen::of(vec![Item::Path(path)], (800.0, 80.0), 0.25);
        let expected = 100.0 * std::f64::consts::FRAC_PI_4 * width * width / 16.0;
        assert!((0.8..1.2).contains(&(seen.area() / expected)), "{} for {expected}", seen.area());
    }
}

#[test]
fn a_pattern_stays_inside_its_area_and_covers_its_share() {
    let hatch = Pattern { kind: PatternKind::Hatch, paint: BLACK };
    let contour = polygons(&[&[(20.0, 20.0), (80.5, 20.0), (80.5, 300.0), (20.0, 300.0)]]);
    let path = Path { contour, fill: None, pattern: Some(hatch), stroke: None, shown: Shown::ALWAYS };
    let seen = Seen::of(vec![Item::Path(path)], (1000.0, 320.0), 1.0);
    let inside = (20..80).map(|x| (20..300).map(|y| seen.at(x, y)).sum::<f64>()).sum::<f64>();
    let border = (20..300).map(|y| seen.at(80, y)).sum::<f64>();
    assert!((seen.area() - inside - border).abs() < 1e-9, "ink outside of the area");
    // Lines of 1 px that are 7 px apart.
    assert!((inside / (60.0 * 280.0 / 7.0) - 1.0).abs() < 0.05, "{inside}");
    assert!(border < 0.6 * 280.0 / 7.0 * std::f64::consts::SQRT_2, "{border}");
}

#[test]
fn a_clip_cuts_whatever_is_in_it_at_parts_of_pixels() {
    let mut group = Group::new("clipped");
    group.clip = Some(Rect { x0: 10.25, y0: 10.5, x1: 60.5, y1: 60.0 }.into());
    group.items = filled(polygons(&[&[(0.0, 0.0), (90.0, 0.0), (90.0, 90.0), (0.0, 90.0)]]));
    let seen = Seen::of(vec![Item::Group(group)], (100.0, 100.0), 1.0);
    let near = |x, y, expected: f64| assert!((seen.at(x, y) - expected).abs() < 0.01, "{}", seen.at(x, y));
    near(10, 30, 0.75);
    near(30, 10, 0.5);
    near(10, 10, 0.375);
    near(60, 59, 0.5);
    assert!((seen.area() - 50.25 * 49.5).abs() < 0.5, "{}", seen.area());
}

#[test]
fn a_clip_with_round_corners_leaves_what_a_contour_with_them_covers() {
    let rect = Rect { x0: 10.25, y0: 10.5, x1: 60.5, y1: 61.75 };
    let mut group = Group::new("clipped");
    let clip = *group.clip.insert(Clip::rounded(rect, 12.3));
    group.items = filled(polygons(&[&[(0.0, 0.0), (90.0, 0.0), (90.0, 90.0), (0.0, 90.0)]]));
    for scale in [1.0, 2.0] {
        let cut = Seen::of(vec![Item::Group(group.clone())], (100.0, 100.0), scale);
        let drawn = Seen::of(filled(clip.contour()), (100.0, 100.0), scale);
        let off = cut.coverage.iter().zip(&drawn.coverage).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // A contour is filled by a quarter of a row at a time, a clip by an eighth.
        assert!(off < 0.13, "at {scale}: {off}");
        assert!((cut.area() / drawn.area() - 1.0).abs() < 0.002, "{} {}", cut.area(), drawn.area());
    }
}

/// Letters whose ink leaves the box of their line: `j` to the left, the hat upward and to the right.
const OVERHANGING: [&str; 2] = ["j", r"$\hat{A}$"];

#[test]
fn all_ink_of_a_text_is_as_see_through_as_its_group() {
    for markup in OVERHANGING {
        let halo = Some(Halo::plain(Paint::role(Role::Muted, Color::hex(0x40_40_40)), 2.5));
        let mut group = Group::new("ghost");
        group.opacity = 0.5;
        group.items = vec![text(markup, (50.0, 60.0), halo)];
        let seen = Seen::of(vec![Item::Group(group)], (100.0, 100.0), 1.0);
        let most = seen.coverage.iter().copied().fold(0.0, f64::max);
        assert!(most < 0.51, "{markup} has pixels {most} black");
        assert!(seen.area() > 20.0, "{markup} is there");
    }
}

#[test]
fn no_ink_of_a_text_leaves_its_clip() {
    for markup in OVERHANGING {
        let whole = Seen::of(vec![text(markup, (50.0, 60.0), None)], (100.0, 100.0), 1.0);
        let Item::Text(label) = text(markup, (50.0, 60.0), None) else { continue };
        let clip = label.bounds();
        let mut group = Group::new("panel");
        group.clip = Some(clip.into());
        group.items = vec![Item::Text(label)];
        let cut = Seen::of(vec![Item::Group(group)], (100.0, 100.0), 1.0);
        let mut outside = 0.0;
        for (i, covered) in cut.coverage.iter().enumerate() {
            let place = |v: usize| f64::from(u32::try_from(v).unwrap());
            let (x, y) = (place(i % 100), place(i / 100));
            if x + 1.0 <= clip.x0 || x >= clip.x1 || y + 1.0 <= clip.y0 || y >= clip.y1 {
                outside += covered;
            }
        }
        assert_eq!(outside, 0.0, "{markup}");
        assert!(cut.area() < whole.area(), "{markup} has ink outside of its box");
    }
}

#[test]
fn a_halo_is_the_ink_and_what_lies_within_reach() {
    let halo = Some(Halo::plain(BLACK, 5.0));
    let seen = Seen::of(vec![text("l", (50.0, 60.0), halo)], (100.0, 100.0), 1.0);
    let plain = Seen::of(vec![text("l", (50.0, 60.0), None)], (100.0, 100.0), 1.0);
    // The letter is an upright bar of area w h, so the halo adds 2 · 5 (w + h) and a disc.
    let height = (0..100).map(|y| (0..100).map(|x| plain.at(x, y)).fold(0.0, f64::max)).sum::<f64>();
    let width = plain.area() / height;
    let expected = plain.area() + 10.0 * (width + height) + std::f64::consts::PI * 25.0;
    assert!((seen.area() / expected - 1.0).abs() < 0.02, "{} for {expected}", seen.area());
    for y in 0..100 {
        for x in 0..100 {
            assert!(seen.at(x, y) + 0.01 >= plain.at(x, y), "{x} {y} is less covered with the halo");
        }
    }
}
