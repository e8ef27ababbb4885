//! Construction lines end where they meet the line that they lie on: dashes over an outline look like dirt.
//!
//! A tangent of a polygon lies on one of its edges, the line that carries an edge on that edge. What lies
//! there is cut out of the dashed line; a line that it only crosses stays crossed. What a step takes away is
//! cut by nothing and cuts nothing, as it is not in the finished figure.

use crate::drawing::{Cap, Contour, Group, Item, Path, Point, Role, Segment, Stroke};
use crate::geometry::sort_by;

/// How far from a line a dashed one counts as lying on it, page pixels: as far as the strokes of a cased
/// edge. At half, one on a cased edge is left; at twice, lines that meet at some degrees lose what is beside
/// each other.
const ON: f64 = 1.8;
/// How long they must go together to be cut, page pixels: more than lines share that cross at 20°.
const TOGETHER: f64 = 15.0;
/// The least piece that is left of a dashed line, page pixels: two dashes and the gap between.
const LEFT: f64 = 18.0;
/// The most pairs of a dashed and an unbroken line that are looked at: a thousand times a figure's. Beyond,
/// dashes stay whole, as no reader could tell.
const MOST_PAIRS: usize = 20_000_000;

/// A straight line on the page.
#[derive(Clone, Copy)]
struct Straight {
    /// Where it begins.
    from: Point,
    /// Where it ends.
    to: Point,
}

/// Cuts out of every straight dashed line what lies on an unbroken one of these layers.
pub(super) fn end_at_lines(layers: &mut [Group]) {
    let (mut unbroken, mut dashed) = (Vec::new(), 0);
    for layer in layers.iter() {
        collect(&layer.items, &mut unbroken, &mut dashed);
    }
    if unbroken.len().saturating_mul(dashed) > MOST_PAIRS {
        return;
    }
    for layer in layers {
        cut_all(&mut layer.items, &unbroken);
    }
}

/// The one straight line of a dashed path; none for dots, which have round ends.
fn dashed_line(path: &Path) -> Option<Straight> {
    let stroke = path.stroke.as_ref()?;
    match &path.contour {
        Contour::Segments(segments) if !stroke.dash.is_empty() && stroke.cap == Cap::Butt => {
            match segments[..] {
                [Segment::Move(from), Segment::Line(to)] => Some(Straight { from, to }),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Finds the straight pieces of unbroken strokes, and counts dashed lines.
fn collect(items: &[Item], unbroken: &mut Vec<Straight>, dashed: &mut usize) {
    for item in items {
        match item {
            Item::Group(group) => collect(&group.items, unbroken, dashed),
            Item::Path(path) if path.shown.until.is_some() => {}
            Item::Path(path) if dashed_line(path).is_some() => *dashed += 1,
            Item::Path(path) if path.stroke.as_ref().is_some_and(|s| s.dash.is_empty() && !is_grid(s)) => {
                unbroken.extend(straight_pieces(&path.contour));
            }
            _ => {}
        }
    }
}

/// Whether a stroke is the grid's: it is fainter than dashes, which go on over it.
fn is_grid(stroke: &Stroke) -> bool {
    stroke.paint.role == Some(Role::Grid)
}

/// The straight pieces of a contour.
fn straight_pieces(contour: &Contour) -> Vec<Straight> {
    let Contour::Segments(segments) = contour else { return Vec::new() };
    let (mut pieces, mut start, mut at) = (Vec::new(), Point::default(), Point::default());
    for segment in segments {
        let line = match *segment {
            Segment::Move(p) => {
                (start, at) = (p, p);
                None
            }
            Segment::Line(p) => Some(p),
            Segment::Close => Some(start),
            Segment::Quad(_, p) | Segment::Cubic(_, _, p) => {
                at = p;
                None
            }
            Segment::Arc { center, radius, start, sweep } => {
                let end = start + sweep;
                at = Point::new(center.x + radius * libm::cos(end), center.y + radius * libm::sin(end));
                None
            }
        };
        if let Some(to) = line {
            pieces.push(Straight { from: at, to });
            at = to;
        }
    }
    pieces
}

/// Cuts the dashed lines among items.
fn cut_all(items: &mut Vec<Item>, unbroken: &[Straight]) {
    let mut kept = Vec::with_capacity(items.len());
    for item in items.drain(..) {
        match item {
            Item::Group(mut group) => {
                cut_all(&mut group.items, unbroken);
                kept.push(Item::Group(group));
            }
            Item::Path(path) => {
                match dashed_line(&path).filter(|_| path.shown.until.is_none()) {
                    Some(line) => kept.extend(pieces_of(line, unbroken).into_iter().map(|[from, to]| {
                        Item::Path(Path { contour: Contour::line(from, to), ..path.clone() })
                    })),
                    None => kept.push(Item::Path(path)),
                }
            }
            Item::Text(text) => kept.push(Item::Text(text)),
        }
    }
    *items = kept;
}

/// What is left of a dashed line beside what lies on unbroken ones; the line itself where nothing does.
fn pieces_of(line: Straight, unbroken: &[Straight]) -> Vec<[Point; 2]> {
    let whole = vec![[line.from, line.to]];
    let Some(u) = (line.to - line.from).unit() else { return whole };
    let length = (line.to - line.from).length();
    let mut covered: Vec<(f64, f64)> = unbroken.iter().filter_map(|other| together(line, *other)).collect();
    if covered.is_empty() {
        return whole;
    }
    sort_by(&mut covered, |a, b| a.0.total_cmp(&b.0));
    let (mut free, mut begin) = (Vec::new(), 0.0_f64);
    for (from, to) in covered.into_iter().chain([(length, length)]) {
        if from - begin >= LEFT {
            free.push([line.from + u * begin, line.from + u * from]);
        }
        begin = begin.max(to);
    }
    free
}

/// The stretch of a dashed line that lies on another line, as page pixels from its start; `None` where they
/// only cross, or are apart.
fn together(dashed: Straight, other: Straight) -> Option<(f64, f64)> {
    let u = (dashed.to - dashed.from).unit()?;
    let length = (dashed.to - dashed.from).length();
    let place = |p: Point| (u.dot(p - dashed.from), u.cross(p - dashed.from));
    let ((t0, off0), (t1, off1)) = (place(other.from), place(other.to));
    // The share of the other line that is near the dashed one's carrier.
    let (mut lo, mut hi) = (0.0_f64, 1.0_f64);
    if off0 == off1 {
        if off0.abs() > ON {
            return None;
        }
    } else {
        let [a, b] = [ON, -ON].map(|edge| (edge - off0) / (off1 - off0));
        (lo, hi) = (lo.max(a.min(b)), hi.min(a.max(b)));
    }
    let at = |share: f64| t0 + (t1 - t0) * share;
    let (from, to) = (at(lo).min(at(hi)).max(0.0), at(lo).max(at(hi)).min(length));
    (lo <= hi && to - from >= TOGETHER).then_some((from, to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Color, Paint};

    fn straight(from: (f64, f64), to: (f64, f64)) -> Straight {
        Straight { from: Point::new(from.0, from.1), to: Point::new(to.0, to.1) }
    }

    #[test]
    fn the_line_that_carries_an_edge_is_left_beyond_its_ends() {
        let carrier = straight((0.0, 0.0), (100.0, 0.0));
        let edge = straight((70.0, 1.0), (30.0, 1.0));
        let left = pieces_of(carrier, &[edge]);
        assert_eq!(left.len(), 2, "{left:?}");
        assert!((left[0][1].x - 30.0).abs() < 1e-9 && (left[1][0].x - 70.0).abs() < 1e-9, "{left:?}");
    }

    #[test]
    fn a_line_that_is_crossed_or_beside_stays_whole() {
        let line = straight((0.0, 0.0), (100.0, 0.0));
        for other in [straight((50.0, -50.0), (50.0, 50.0)), straight((0.0, 8.0), (100.0, 8.0))] {
            assert_eq!(pieces_of(line, &[other]), [[line.from, line.to]]);
        }
    }

    #[test]
    fn a_line_that_lies_on_another_whole_is_not_drawn() {
        let line = straight((20.0, 20.0), (80.0, 80.0));
        assert!(pieces_of(line, &[straight((0.0, 0.0), (100.0, 100.0))]).is_empty());
    }

    #[test]
    fn the_grid_cuts_nothing() {
        for (role, pieces) in [(Role::Grid, 1), (Role::A, 2)] {
            let line = |from: (f64, f64), to: (f64, f64), role: Role, dash: Vec<f64>| {
                let paint = Paint::role(role, Color::hex(0));
                let contour = Contour::line(Point::new(from.0, from.1), Point::new(to.0, to.1));
                Item::Path(Path::stroked(contour, Stroke { dash, ..Stroke::solid(paint, 1.5) }))
            };
            let mut layer = Group::new("layer");
            layer.items.push(line((50.0, -50.0), (50.0, 150.0), role, Vec::new()));
            layer.items.push(line((40.0, 0.0), (60.0, 100.0), Role::Muted, vec![7.0, 4.0]));
            let mut layers = [layer];
            end_at_lines(&mut layers);
            assert_eq!(layers[0].items.len(), 1 + pieces, "{role:?}");
        }
    }
}
