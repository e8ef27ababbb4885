//! Pieces of outlines, cut where they cross each other.

use std::f64::consts::TAU;

use crate::geometry::{DVec2, sorted};

use super::{Outline, Piece, angle_of, on_circle};

/// The share of a piece's length below which it is nothing but rounding: a thousandth of a pixel of a line
/// across the largest page.
pub(super) const NOTHING: f64 = 1e-7;

/// A piece of an outline that knows where it begins.
#[derive(Clone, Copy, Debug)]
pub(super) enum Span {
    /// A straight piece.
    Line(DVec2, DVec2),
    /// Part of a circle: centre, radius, and from where over what angle, radians counter-clockwise from +x.
    Arc(DVec2, f64, f64, f64),
}

/// Pieces, from left to right by their boxes.
pub(super) struct Near<'s> {
    /// The pieces and their boxes, the one that begins leftmost first.
    pieces: Vec<([DVec2; 2], &'s Span)>,
    /// The width of the widest box.
    widest: f64,
    /// How far from each other pieces are taken for touching.
    slack: f64,
}

impl<'s> Near<'s> {
    /// Pieces in this order.
    pub(super) fn of(spans: &'s [Span], slack: f64) -> Self {
        let boxes: Vec<[DVec2; 2]> = spans.iter().map(|span| span.bounds(slack)).collect();
        let order = sorted(boxes.len(), &|i, j| boxes[i][0].x.total_cmp(&boxes[j][0].x));
        let widest = boxes.iter().map(|[lo, hi]| hi.x - lo.x).fold(0.0, f64::max);
        Self { pieces: order.into_iter().map(|i| (boxes[i], &spans[i])).collect(), widest, slack }
    }

    /// Pieces whose boxes reach that of a piece; `looked` counts those that are held against it.
    pub(super) fn to(&self, span: &Span, looked: &mut usize) -> Vec<&'s Span> {
        let [lo, hi] = span.bounds(self.slack);
        let [from, to] =
            [lo.x - self.widest, hi.x].map(|x| self.pieces.partition_point(|([least, _], _)| least.x < x));
        *looked += to - from;
        let reached =
            |([least, most], _): &&([DVec2; 2], &Span)| lo.cmple(*most).all() && least.cmple(hi).all();
        self.pieces[from..to].iter().filter(reached).map(|&(_, span)| span).collect()
    }
}

impl Span {
    /// The point at a share of it, from 0 to 1.
    pub(super) fn at(&self, share: f64) -> DVec2 {
        match *self {
            Self::Line(p, q) => p + share * (q - p),
            Self::Arc(center, radius, start, sweep) => on_circle(center, radius, start + share * sweep),
        }
    }

    /// How far it is from end to end; of an arc, the radius.
    pub(super) fn size(&self) -> f64 {
        match *self {
            Self::Line(p, q) => (q - p).length(),
            Self::Arc(_, radius, ..) => radius,
        }
    }

    /// The corners of a box in which it is, and all that is as near as `near`: that of its ends, with as much
    /// around it as half of an arc is long.
    pub(super) fn bounds(&self, near: f64) -> [DVec2; 2] {
        let (p, q) = (self.at(0.0), self.at(1.0));
        let (lo, hi) = (p.min(q), p.max(q));
        let bulge = match *self {
            Self::Line(..) => 0.0,
            Self::Arc(_, radius, _, sweep) => 0.5 * radius * sweep.abs(),
        };
        let room = DVec2::splat(near + bulge + NOTHING * (hi - lo).max_element());
        [lo - room, hi + room]
    }

    /// What of it lies between two shares.
    pub(super) fn part(&self, from: f64, to: f64) -> Self {
        match *self {
            Self::Line(..) => Self::Line(self.at(from), self.at(to)),
            Self::Arc(center, radius, start, sweep) => {
                Self::Arc(center, radius, start + from * sweep, (to - from) * sweep)
            }
        }
    }

    /// The direction of the line in its middle, radians counter-clockwise from +x.
    pub(super) fn direction(&self) -> f64 {
        match *self {
            Self::Line(p, q) => angle_of(q - p),
            Self::Arc(_, _, start, sweep) => start + 0.5 * sweep + 0.25 * TAU,
        }
    }

    /// The shares at which the line or circle that carries another piece crosses the one that carries this:
    /// they split it, so that too many do no harm.
    pub(super) fn crossed(&self, by: &Self) -> Vec<f64> {
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
    pub(super) fn met_by_ends(&self, by: &Self, near: f64) -> Vec<f64> {
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
    pub(super) fn is_along(&self, other: &Self, near: f64) -> bool {
        [0.0, 0.5, 1.0].iter().all(|&share| (self.at(share) - other.at(share)).length() <= near)
    }

    /// The share of an arc at which it looks in a direction from its centre; beyond 1 where it does not.
    pub(super) fn share_of(&self, direction: DVec2) -> f64 {
        match *self {
            Self::Line(..) => 0.0,
            Self::Arc(_, _, start, sweep) => (angle_of(direction) - start).rem_euclid(TAU) / sweep,
        }
    }
}

/// The pieces of an outline, with the straight ones that it leaves unsaid.
pub(super) fn spans(outline: &Outline) -> Vec<Span> {
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
