//! What two convex outlines have in common, as an outline of its own.
//!
//! Its line is made of the pieces of each line that lie in the other: every piece is split where it crosses
//! the other outline, and what lies in that is kept. The common part is convex, and around a convex
//! outline the direction of the line turns one way only, so the kept pieces follow each other by the
//! direction of their middles.

use std::f64::consts::TAU;

use crate::geometry::{DVec2, sort_by};

use super::span::{NOTHING, Near, Span, spans};
use super::{Outline, Piece};

/// The most pairs of pieces that are looked at for all regions of a panel: those of the largest shapes of a
/// scene four times where all are as wide as the body, some 0.1 s, and hundreds of times where all are short.
const MOST_PAIRS: usize = 1 << 27;

/// How far an arc bulges beyond its chords at most, as a part of its outline's size.
const CHORD: f64 = 1e-3;

/// What two outlines have in common.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Common {
    /// The line around it, counter-clockwise.
    pub(crate) whole: Outline,
    /// What of each of the two lines lies in the other outline, in pieces as long as can be.
    pub(crate) lines: [Vec<Outline>; 2],
}

/// What two convex closed outlines have in common, both counter-clockwise; `None` where that is nothing, one
/// is not convex, or too much was `looked` at for it: pairs of pieces, which are counted up.
pub(crate) fn common(a: &Outline, b: &Outline, looked: &mut usize) -> Option<Common> {
    let (in_a, in_b) = (Region::of(a)?, Region::of(b)?);
    let kept = [in_a.within(&in_b, looked)?, in_b.within(&in_a, looked)?];
    // Where both lines run together the common part has one: twice around it, even-odd filling has nothing.
    let near = NOTHING * in_a.size;
    let found = Near::of(&kept[0], near);
    let is_new = |span: &&Span| !found.to(span, looked).iter().any(|other| other.is_along(span, near));
    let alone = kept[1].iter().filter(is_new);
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
        self.is_near(p, 0.0)
    }

    /// Whether a point lies in it, or beyond the lines along its chords by no more than a length.
    fn is_near(&self, p: DVec2, off: f64) -> bool {
        let left = |w: &[DVec2]| {
            let way = w[1] - w[0];
            way.perp_dot(p - w[0]) >= -NOTHING * way.length_squared() - off * way.length()
        };
        self.points.windows(2).all(left)
    }

    /// Whether a piece of another line lies in it that its own does not cross: its middle does. Beside it the
    /// middle may be where it touches; then what is next to the middle is far off.
    fn holds_piece(&self, span: &Span) -> bool {
        self.holds(span.at(0.5)) && self.is_near(span.at(0.375), CHORD * self.size)
    }

    /// The pieces of its line that lie in another; `None` where too many pairs were `looked` at.
    fn within(&self, other: &Self, looked: &mut usize) -> Option<Vec<Span>> {
        let (mut kept, mut is_in) = (Vec::new(), None);
        let near = NOTHING * self.size;
        let crossing = Near::of(&other.spans, near);
        for span in &self.spans {
            let by = crossing.to(span, looked);
            if by.is_empty() {
                // Nothing crosses here: it goes on as before.
                let here = *is_in.get_or_insert_with(|| other.holds_piece(span));
                kept.extend(here.then_some(*span));
                continue;
            }
            *looked += other.points.len();
            if *looked > MOST_PAIRS {
                return None;
            }
            let mut shares: Vec<f64> = by.iter().flat_map(|by| span.crossed(by)).collect();
            shares.extend(by.iter().flat_map(|by| span.met_by_ends(by, near)));
            shares.retain(|share| (NOTHING..=1.0 - NOTHING).contains(share));
            shares.extend([0.0, 1.0]);
            sort_by(&mut shares, f64::total_cmp);
            shares.dedup_by(|next, last| *next - *last < NOTHING);
            for ends in shares.windows(2) {
                let part = span.part(ends[0], ends[1]);
                let here = other.holds_piece(&part);
                kept.extend(here.then_some(part));
                is_in = Some(here);
            }
        }
        Some(kept)
    }
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
    use crate::figure::sketch::on_circle;

    fn square(x: f64, y: f64, half: f64) -> Outline {
        let at = |u: f64, v: f64| DVec2::new(x + u * half, y + v * half);
        Outline::polygon(&[at(-1., -1.), at(1., -1.), at(1., 1.), at(-1., 1.)])
    }

    /// The area in an outline, by its points.
    fn area(outline: &Outline) -> f64 {
        outline.sampled().windows(2).map(|w| 0.5 * w[0].perp_dot(w[1])).sum()
    }

    fn of(a: &Outline, b: &Outline) -> Option<Common> {
        common(a, b, &mut 0)
    }

    fn shared(a: &Outline, b: &Outline) -> f64 {
        of(a, b).map_or(0.0, |common| area(&common.whole))
    }

    #[test]
    fn two_squares_share_a_rectangle_whose_sides_are_theirs() {
        let (a, b) = (square(0., 0., 2.), square(3., 1., 2.));
        let common = of(&a, &b).unwrap();
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
        let lens = of(&a, &b).unwrap().whole;
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
            let in_lens = Region::of(&of(&circle, &capsule).unwrap().whole).unwrap();
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
    fn a_circle_that_touches_with_the_middle_of_its_line_shares_nothing() {
        for (r, s) in [(1.1, 0.9), (0.7, 0.6), (1.0, 1.0), (0.1, 0.2), (1.3, 0.4)] {
            let right = Outline::circle(DVec2::new(r + s, 0.0), s);
            let disc = Outline::circle(DVec2::ZERO, r);
            for left in [disc, square(0.0, 0.0, r)] {
                let both = [shared(&left, &right), shared(&right, &left)];
                assert!(both.iter().all(|area| area.abs() < 1e-6), "{r} and {s}: {both:?}");
            }
        }
    }

    #[test]
    fn what_lies_in_another_is_shared_whole_and_what_touches_shares_nothing() {
        let disc = Outline::circle(DVec2::new(0.5, 0.25), 1.0);
        assert!((shared(&disc, &square(0., 0., 4.)) - area(&disc)).abs() < 1e-9);
        assert!((shared(&square(0., 0., 4.), &square(0., 0., 4.)) - 64.0).abs() < 1e-6);
        assert!(shared(&square(0., 0., 1.), &square(2., 0., 1.)).abs() < 1e-9);
        assert!(of(&disc, &square(9., 0., 1.)).is_none());
    }

    #[test]
    fn rounded_and_sharp_bodies_share_what_points_in_both_say() {
        let capsule = Outline::rounded(&[DVec2::new(-2., -1.), DVec2::new(2., 1.)], 1.25);
        let (a, b) = (square(1., 1., 1.5), of(&capsule, &square(1., 1., 1.5)).unwrap().whole);
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
            let whole = of(a, b).unwrap().whole.sampled();
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
        assert!(of(&Outline::polygon(&arrow), &square(0., 0., 4.)).is_none());
    }
}
