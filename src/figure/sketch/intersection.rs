//! What two convex outlines have in common, as an outline of its own.
//!
//! Its line is made of the pieces of each line that lie in the other: every piece is split where it crosses
//! the other outline, and what has its middle in that is kept. The common part is convex, and around a convex
//! outline the direction of the line turns one way only, so the kept pieces follow each other by the
//! direction of their middles.

use std::f64::consts::TAU;

use crate::geometry::{DVec2, sort_by};

use super::{Outline, Piece, angle_of, on_circle};

/// The most pairs of pieces of two outlines that are looked at: as many as the largest shapes of a scene have
/// that are rounded.
const MOST_PAIRS: usize = 1 << 27;

/// The share of a piece's length below which it is nothing but rounding: a thousandth of a pixel of a line
/// across the largest page.
const NOTHING: f64 = 1e-7;

/// A piece of an outline that knows where it begins.
#[derive(Clone, Copy, Debug)]
enum Span {
    /// A straight piece.
    Line(DVec2, DVec2),
    /// Part of a circle: centre, radius, and from where over what angle, radians counter-clockwise from +x.
    Arc(DVec2, f64, f64, f64),
}

/// What two outlines have in common.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Common {
    /// The line around it, counter-clockwise.
    pub(crate) whole: Outline,
    /// What of each of the two lines lies in the other outline, in pieces as long as can be.
    pub(crate) lines: [Vec<Outline>; 2],
}

/// What two convex closed outlines have in common, both counter-clockwise; `None` where that is nothing, one
/// is not convex, or they have more pieces than a reader could tell.
pub(crate) fn common(a: &Outline, b: &Outline) -> Option<Common> {
    let (in_a, in_b) = (Region::of(a)?, Region::of(b)?);
    if in_a.spans.len().saturating_mul(in_b.spans.len()) > MOST_PAIRS {
        return None;
    }
    let kept = [in_a.within(&in_b), in_b.within(&in_a)];
    // Where both lines run together the common part has one: twice around it, even-odd filling has nothing.
    let near = NOTHING * in_a.size;
    let alone = kept[1].iter().filter(|span| !kept[0].iter().any(|other| other.is_along(span, near)));
    let mut all: Vec<Span> = kept[0].iter().chain(alone).copied().collect();
    let turn = |span: &Span| span.direction().rem_euclid(TAU);
    sort_by(&mut all, |a, b| turn(a).total_cmp(&turn(b)));
    let whole = Outline { closed: true, ..joined(&all)? };
    Some(Common { whole, lines: kept.map(chains) })
}

/// A convex outline as an area.
struct Region {
    /// The pieces of its line.
    spans: Vec<Span>,
    /// Points along its line, the first again at the end.
    points: Vec<DVec2>,
    /// How far it reaches from corner to corner of its box.
    size: f64,
}

impl Region {
    /// The area in an outline; `None` where that is open, turns both ways or has no area.
    fn of(outline: &Outline) -> Option<Self> {
        let mut points = outline.sampled();
        let (lo, hi) = points.iter().fold((points[0], points[0]), |(lo, hi), &p| (lo.min(p), hi.max(p)));
        let size = (hi - lo).length();
        // Where an arc ends and a line begins, rounding leaves two points whose direction means nothing.
        points.dedup_by(|next, last| (*next - *last).length() <= NOTHING * size);
        let turns = |w: &[DVec2]| (w[1] - w[0]).perp_dot(w[2] - w[1]) >= -NOTHING * size * size;
        let around: Vec<DVec2> = points.iter().chain(points.get(1)).copied().collect();
        let is_convex = outline.closed && around.windows(3).all(turns);
        (is_convex && size > 0.0).then(|| Self { spans: spans(outline), points, size })
    }

    /// Whether a point lies in it or on its line.
    fn holds(&self, p: DVec2) -> bool {
        let left =
            |w: &[DVec2]| (w[1] - w[0]).perp_dot(p - w[0]) >= -NOTHING * (w[1] - w[0]).length_squared();
        self.points.windows(2).all(left)
    }

    /// The pieces of its line that lie in another.
    fn within(&self, other: &Self) -> Vec<Span> {
        let mut kept = Vec::new();
        let near = NOTHING * self.size;
        let boxes: Vec<[DVec2; 2]> = other.spans.iter().map(|span| span.bounds(near)).collect();
        for span in &self.spans {
            let [lo, hi] = span.bounds(near);
            let reached = |[least, most]: &[DVec2; 2]| lo.cmple(*most).all() && least.cmple(hi).all();
            let by: Vec<&Span> = other
                .spans
                .iter()
                .zip(&boxes)
                .filter_map(|(by, there)| reached(there).then_some(by))
                .collect();
            let mut shares: Vec<f64> = by.iter().flat_map(|by| span.crossed(by)).collect();
            shares.extend(by.iter().flat_map(|by| span.met_by_ends(by, near)));
            shares.retain(|share| (NOTHING..=1.0 - NOTHING).contains(share));
            shares.extend([0.0, 1.0]);
            sort_by(&mut shares, f64::total_cmp);
            shares.dedup_by(|next, last| *next - *last < NOTHING);
            let parts = shares.windows(2).map(|w| span.part(w[0], w[1]));
            kept.extend(parts.filter(|part| other.holds(part.at(0.5))));
        }
        kept
    }
}

impl Span {
    /// The point at a share of it, from 0 to 1.
    fn at(&self, share: f64) -> DVec2 {
        match *self {
            Self::Line(p, q) => p + share * (q - p),
            Self::Arc(center, radius, start, sweep) => on_circle(center, radius, start + share * sweep),
        }
    }

    /// How far it is from end to end; of an arc, the radius.
    fn size(&self) -> f64 {
        match *self {
            Self::Line(p, q) => (q - p).length(),
            Self::Arc(_, radius, ..) => radius,
        }
    }

    /// The corners of a box in which it is, and all that is as near as `near`; of an arc, that of its circle.
    fn bounds(&self, near: f64) -> [DVec2; 2] {
        let (lo, hi) = match *self {
            Self::Line(p, q) => (p.min(q), p.max(q)),
            Self::Arc(center, radius, ..) => (center - radius, center + radius),
        };
        let room = DVec2::splat(near + NOTHING * (hi - lo).max_element());
        [lo - room, hi + room]
    }

    /// What of it lies between two shares.
    fn part(&self, from: f64, to: f64) -> Self {
        match *self {
            Self::Line(..) => Self::Line(self.at(from), self.at(to)),
            Self::Arc(center, radius, start, sweep) => {
                Self::Arc(center, radius, start + from * sweep, (to - from) * sweep)
            }
        }
    }

    /// The direction of the line in its middle, radians counter-clockwise from +x.
    fn direction(&self) -> f64 {
        match *self {
            Self::Line(p, q) => angle_of(q - p),
            Self::Arc(_, _, start, sweep) => start + 0.5 * sweep + 0.25 * TAU,
        }
    }

    /// The shares at which the line or circle that carries another piece crosses the one that carries this:
    /// they split it, so that too many do no harm.
    fn crossed(&self, by: &Self) -> Vec<f64> {
        match (*self, *by) {
            (Self::Line(p, q), Self::Line(r, s)) => {
                let (u, v) = (q - p, s - r);
                let across = u.perp_dot(v);
                let (share, other) = ((r - p).perp_dot(v) / across, (r - p).perp_dot(u) / across);
                Vec::from_iter(Some(share).filter(|_| (-NOTHING..=1.0 + NOTHING).contains(&other)))
            }
            (Self::Line(p, q), Self::Arc(center, radius, ..)) => {
                let (u, off) = (q - p, p - center);
                let (a, b, c) = (u.length_squared(), off.dot(u), off.length_squared() - radius * radius);
                let root = (b * b - a * c).sqrt();
                [(-b - root) / a, (-b + root) / a].into_iter().filter(|share| share.is_finite()).collect()
            }
            (Self::Arc(center, ..), Self::Line(p, q)) => {
                let by = Self::Line(p, q);
                by.crossed(self).into_iter().map(|share| self.share_of(by.at(share) - center)).collect()
            }
            (Self::Arc(center, radius, ..), Self::Arc(other, reach, ..)) => {
                let (u, apart) = (other - center, (other - center).length());
                let along = (apart * apart + radius * radius - reach * reach) / (2.0 * apart);
                let aside = (radius * radius - along * along).sqrt();
                let n = u / apart;
                let points = [aside, -aside].map(|aside| along * n + aside * n.perp());
                points.into_iter().filter(|p| p.is_finite()).map(|p| self.share_of(p)).collect()
            }
        }
    }

    /// The shares at which another piece begins and ends that runs along the line or circle that carries this
    /// one, as near as `near`: where that is left without a corner, nothing crosses.
    fn met_by_ends(&self, by: &Self, near: f64) -> Vec<f64> {
        let ends = [by.at(0.0), by.at(1.0)];
        match (*self, *by) {
            (Self::Line(p, q), Self::Line(..)) => {
                let u = q - p;
                let is_on = |r: &DVec2| u.perp_dot(r - p).abs() <= near * u.length();
                let share = |r: &DVec2| (r - p).dot(u) / u.length_squared();
                if ends.iter().all(is_on) { ends.iter().map(share).collect() } else { Vec::new() }
            }
            (Self::Arc(center, radius, ..), Self::Arc(other, reach, ..))
                if (other - center).length() <= near && (reach - radius).abs() <= near =>
            {
                ends.map(|end| self.share_of(end - center)).to_vec()
            }
            _ => Vec::new(),
        }
    }

    /// Whether it is another piece but for rounding, `near` at most: its ends and its middle are.
    fn is_along(&self, other: &Self, near: f64) -> bool {
        [0.0, 0.5, 1.0].iter().all(|&share| (self.at(share) - other.at(share)).length() <= near)
    }

    /// The share of an arc at which it looks in a direction from its centre; beyond 1 where it does not.
    fn share_of(&self, direction: DVec2) -> f64 {
        match *self {
            Self::Line(..) => 0.0,
            Self::Arc(_, _, start, sweep) => (angle_of(direction) - start).rem_euclid(TAU) / sweep,
        }
    }
}

/// The pieces of an outline, with the straight ones that it leaves unsaid.
fn spans(outline: &Outline) -> Vec<Span> {
    let (mut at, mut all) = (outline.start, Vec::new());
    for piece in &outline.pieces {
        match *piece {
            Piece::Line(p) => {
                all.push(Span::Line(at, p));
                at = p;
            }
            Piece::Arc { center, radius, start, sweep } => {
                let arc = Span::Arc(center, radius, start, sweep);
                all.push(Span::Line(at, arc.at(0.0)));
                all.push(arc);
                at = arc.at(1.0);
            }
        }
    }
    all.push(Span::Line(at, outline.start));
    let size = all.iter().map(Span::size).fold(0.0, f64::max);
    all.retain(|span| span.size() > NOTHING * size);
    all
}

/// An open outline along pieces, straight from each to the next; `None` where there is none.
fn joined(spans: &[Span]) -> Option<Outline> {
    let start = spans.first()?.at(0.0);
    let (mut at, mut pieces) = (start, Vec::new());
    for span in spans {
        match *span {
            Span::Line(p, q) => {
                pieces.extend((p != at).then_some(Piece::Line(p)));
                pieces.push(Piece::Line(q));
            }
            Span::Arc(center, radius, start, sweep) => {
                pieces.push(Piece::Arc { center, radius, start, sweep });
            }
        }
        at = span.at(1.0);
    }
    Some(Outline { start, pieces, closed: false })
}

/// Outlines along those pieces that follow each other; a closed one where all do.
fn chains(mut spans: Vec<Span>) -> Vec<Outline> {
    let follows = |last: &Span, next: &Span| {
        let ends = [last, next].map(|span| span.at(0.0).abs().max(span.at(1.0).abs()).max_element());
        (next.at(0.0) - last.at(1.0)).length() <= NOTHING * (ends[0] + ends[1])
    };
    let count = spans.len();
    let broken = (0..count).find(|&i| !follows(&spans[(i + count - 1) % count], &spans[i]));
    spans.rotate_left(broken.unwrap_or(0));
    let chains = spans.chunk_by(follows).filter_map(joined);
    chains.map(|chain| Outline { closed: broken.is_none(), ..chain }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, half: f64) -> Outline {
        let at = |u: f64, v: f64| DVec2::new(x + u * half, y + v * half);
        Outline::polygon(&[at(-1., -1.), at(1., -1.), at(1., 1.), at(-1., 1.)])
    }

    /// The area in an outline, by its points.
    fn area(outline: &Outline) -> f64 {
        outline.sampled().windows(2).map(|w| 0.5 * w[0].perp_dot(w[1])).sum()
    }

    fn shared(a: &Outline, b: &Outline) -> f64 {
        common(a, b).map_or(0.0, |common| area(&common.whole))
    }

    #[test]
    fn two_squares_share_a_rectangle_whose_sides_are_theirs() {
        let (a, b) = (square(0., 0., 2.), square(3., 1., 2.));
        let common = common(&a, &b).unwrap();
        assert!((area(&common.whole) - 3.0).abs() < 1e-9, "{common:?}");
        assert_eq!(common.lines.map(|lines| lines.len()), [1, 1]);
    }

    #[test]
    fn outlines_of_as_many_vertices_as_a_scene_may_have_share_what_circles_do() {
        let corners = |x: f64, count: u32| -> Vec<DVec2> {
            let at = |i: u32| on_circle(DVec2::new(x, 0.0), 1.0, TAU * f64::from(i) / f64::from(count));
            (0..count).map(at).collect()
        };
        let [a, b] = [(0.0, 4096), (1.0, 4095)].map(|(x, count)| Outline::polygon(&corners(x, count)));
        let lens = 2.0 * libm::acos(0.5) - 0.75_f64.sqrt();
        assert!((shared(&a, &b) - lens).abs() < 1e-4, "{}", shared(&a, &b));
    }

    #[test]
    fn circles_share_a_lens_of_two_arcs() {
        let (a, b) = (Outline::circle(DVec2::ZERO, 3.0), Outline::circle(DVec2::new(5.0, 0.0), 4.0));
        let lens = common(&a, &b).unwrap().whole;
        // Chords of 5° stand for the arcs of two segments, 9 acos(18/30) + 16 acos(32/40) − 12 together.
        let exact = 9.0 * libm::acos(0.6) + 16.0 * libm::acos(0.8) - 12.0;
        assert!((area(&lens) - exact).abs() < 0.03, "{}", area(&lens));
        assert!(lens.pieces.iter().all(|piece| matches!(piece, Piece::Arc { .. })));
    }

    #[test]
    fn a_circle_and_a_capsule_share_as_much_however_that_is_turned() {
        for step in 0..48 {
            let turn = f64::from(step) * TAU / 48.0;
            let at = |x: f64| DVec2::new(0.75, 0.5) + on_circle(DVec2::ZERO, x, turn);
            let capsule = Outline::rounded(&[at(-1.0), at(1.1)], 1.25);
            let circle = Outline::circle(DVec2::new(-1.25, -0.5), 2.0);
            let [in_a, in_b] = [&circle, &capsule].map(|outline| Region::of(outline).unwrap());
            let in_lens = Region::of(&common(&circle, &capsule).unwrap().whole).unwrap();
            let grid = (0..40).flat_map(|i| (0..40).map(move |j| [i, j]));
            let wrong = grid.filter(|&[i, j]| {
                let p = DVec2::new(-3.0 + 0.151 * f64::from(i), -2.5 + 0.149 * f64::from(j));
                in_lens.holds(p) != (in_a.holds(p) && in_b.holds(p))
            });
            // Chords stand for arcs, which end elsewhere in the lens: a point or two lie between them.
            assert!(wrong.count() <= 2, "turned by {turn}");
        }
    }

    #[test]
    fn what_lies_in_another_is_shared_whole_and_what_touches_shares_nothing() {
        let disc = Outline::circle(DVec2::new(0.5, 0.25), 1.0);
        assert!((shared(&disc, &square(0., 0., 4.)) - area(&disc)).abs() < 1e-9);
        assert!((shared(&square(0., 0., 4.), &square(0., 0., 4.)) - 64.0).abs() < 1e-6);
        assert!(shared(&square(0., 0., 1.), &square(2., 0., 1.)).abs() < 1e-9);
        assert!(common(&disc, &square(9., 0., 1.)).is_none());
    }

    #[test]
    fn rounded_and_sharp_bodies_share_what_points_in_both_say() {
        let capsule = Outline::rounded(&[DVec2::new(-2., -1.), DVec2::new(2., 1.)], 1.25);
        let (a, b) = (square(1., 1., 1.5), common(&capsule, &square(1., 1., 1.5)).unwrap().whole);
        let (in_a, in_capsule) = (Region::of(&a).unwrap(), Region::of(&capsule).unwrap());
        let in_b = Region::of(&b).unwrap();
        for i in 0..40 {
            for j in 0..40 {
                let p = DVec2::new(-3.0 + 0.151 * f64::from(i), -2.5 + 0.149 * f64::from(j));
                assert_eq!(in_b.holds(p), in_a.holds(p) && in_capsule.holds(p), "{p}");
            }
        }
    }

    #[test]
    fn two_lines_that_run_together_go_around_the_common_part_once() {
        let around = |a: &Outline, b: &Outline| {
            let whole = common(a, b).unwrap().whole.sampled();
            whole.windows(2).map(|w| (w[1] - w[0]).length()).sum::<f64>()
        };
        let disc = Outline::circle(DVec2::new(0.5, 0.25), 1.0);
        let box_ = square(1., 2., 3.);
        let capsule = Outline::rounded(&[DVec2::new(0.5, 0.25), DVec2::new(3., 1.)], 1.0);
        let rounded = Outline::rounded(&[DVec2::new(-0.3, 0.25), DVec2::new(0.7, 0.25)], 0.35);
        let plank = Outline::polygon(&[(-2., -0.1), (2., -0.1), (2., 0.6), (-2., 0.6)].map(DVec2::from));
        // A disc in the end of a capsule, a box flush with a longer one, a capsule between two lines.
        let pairs = [(&disc, &disc, TAU), (&box_, &box_, 24.0), (&disc, &capsule, TAU)];
        let long = 2.0 + TAU * 0.35;
        for (a, b, length) in pairs.into_iter().chain([(&rounded, &plank, long), (&capsule, &capsule, 0.0)]) {
            let length = if length > 0.0 { length } else { TAU + 2.0 * DVec2::new(2.5, 0.75).length() };
            for found in [around(a, b), around(b, a)] {
                // Chords stand for arcs.
                assert!((found - length).abs() < 2e-3 * length, "{found}, not {length}");
            }
        }
    }

    #[test]
    fn a_concave_outline_has_no_common_part_here() {
        let arrow = [(0., 0.), (4., 0.), (1., 1.), (0., 4.)].map(|(x, y)| DVec2::new(x, y));
        assert!(common(&Outline::polygon(&arrow), &square(0., 0., 4.)).is_none());
    }
}
