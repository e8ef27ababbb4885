//! Linear sweep, directly: one ray against the edges of B ⊖ A that face it.
//!
//! Seen from A, B moves by −v, v = `v_A` − `v_B`; so A meets B when the ray r(t) = t v from the origin enters B ⊖ A. Along the
//! normal n of an edge (from A to B) let g be the gap of the cores at t = 0, and ρ = `r_A` + `r_B`. Then
//!
//! ```text
//! v·n > 0                                   the edge faces the ray; the others are skipped
//! t = (g − ρ) / (v·n)                       where the ray meets the edge's line, moved out by ρ
//! t = c / (v·p + √(ρ² |v|² − cross(v, p)²)),  c = |p|² − ρ²        where it meets the disc at a vertex p
//! ```
//!
//! A ray enters a convex polygon through the facing edge whose line it meets last. Where that is within the edge, it is the
//! answer; beyond its end only the disc at that vertex is left, and where ρ = 0 a ray that passes. Doubles find the edge
//! and mostly prove it ([`crate::collision::certified::sweep::filter`]); else balls decide every sign, so that a graze is a hit exactly if the signs
//! say so, and enclose t.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section Continuous; the line that is met last is Cyrus and
//! Beck, *Generalized two- and three-dimensional clipping*, 1978; the root without cancellation is Press et al.,
//! *Numerical Recipes*, 2007, section 5.6.

use crate::collision::Answer;
use crate::collision::Impact;
use crate::collision::Outcome;
use crate::collision::Query;
use crate::collision::algorithm::outline::{self, walk};
use crate::collision::algorithm::view::Relative;
use crate::collision::certified::distance::balls::{Fine, Vec2, Way, cross, dot, minus, reversed};
use crate::collision::certified::distance::gaps::pass;
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::sweep::Sweep;
use crate::collision::certified::sweep::filter::Met;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{Ball, Body, DVec2, Enclosure, Feature, Side};
use crate::trace::{Culling, Event, Tracer};

/// Its word in a scene file.
pub(crate) const NAME: &str = "ray-cast";

/// Answers a linear sweep.
pub(crate) fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let sweep = Sweep::new(query.a, query.b.unwrap_or(query.a));
    let outcome = sweep.first_contact();
    if tracer.listens() {
        tell(&sweep.pair, &sweep.entry(), &outcome, tracer);
    }
    tracer.record(|| Event::Finished { outcome: outcome.word() });
    Answer::Impact(Impact { outcome, tolerance: 0.0, iterations: 1 })
}

/// First contact of two bodies of which neither turns, by the ray alone.
pub(crate) fn first_contact(a: &Body, b: &Body) -> Outcome {
    Sweep::new(a, b).by_ray()
}

/// Whether, where and when the ray's line enters B ⊖ A.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Entry {
    /// There is no ray.
    Still,
    /// Never.
    Misses,
    /// Here, not before the first moment and not after the second; they may be negative or above 1.
    At(DifferenceFeature, Moment, Moment),
    /// As the first stage says.
    Quick(Met),
    /// The signs are not certain.
    Unsure,
}

/// A quotient that says when, kept apart so that equality with a double can be decided.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment {
    numerator: Ball,
    denominator: Ball,
}

/// The ray against B ⊖ A in balls, in A's frame and the units of `pair`.
pub(crate) struct Ray<'p, 's> {
    /// Both bodies at t = 0.
    pair: &'p Pair<'s>,
    /// v.
    v: Vec2,
}

impl<'p, 's> Ray<'p, 's> {
    pub(crate) fn new(pair: &'p Pair<'s>) -> Self {
        Self { pair, v: pair.closing_fine() }
    }

    /// v in doubles.
    fn direction(&self) -> DVec2 {
        DVec2::new(self.v[0].value.hi, self.v[1].value.hi)
    }

    /// Whether, where and when the ray's line enters B ⊖ A, certainly.
    #[cold]
    pub(crate) fn entry(&self) -> Entry {
        if dot(&self.v, &self.v).sign() == Some(0) {
            return Entry::Still;
        }
        let fine = Fine::new(self.pair);
        let Some(facing) = last_line(self.pair, self.direction()) else {
            return self.disc(&fine, [0, 0]);
        };
        let way = fine.measure(facing);
        let moment = self.line(&fine, &way);
        if !moment.denominator.is_positive() {
            return Entry::Unsure;
        }
        match self.place(&fine, &way, moment.value()) {
            Place::Over => Entry::At(DifferenceFeature::Edge(way.facing), moment, moment),
            Place::Beyond(vertex) => self.disc(&fine, vertex),
            Place::Unsure(vertex) => match self.disc(&fine, vertex) {
                // The edge's line bounds the time from below, the disc from above.
                Entry::At(piece, _, last) => Entry::At(piece, moment, last),
                other => other,
            },
        }
    }

    /// When the ray meets the line of an edge, moved out by ρ; both sides of the quotient times the edge's length, which
    /// keeps them exact where the vertices are.
    fn line(&self, fine: &Fine, way: &Way) -> Moment {
        let DifferenceEdge { source, edge, vertex } = way.facing;
        let e = fine.side(source, edge);
        let (n, from) = match source {
            Side::A => ([e[1], -e[0]], fine.between(edge, vertex)),
            Side::B => ([-e[1], e[0]], fine.between(vertex, edge)),
        };
        let mut gap = dot(&n, &from);
        if self.pair.radius.hi > 0.0 {
            gap = gap - Ball::exact(self.pair.radius) * dot(&e, &e).sqrt();
        }
        if way.partner.is_some() {
            let down = if source == Side::A { n } else { reversed(&n) };
            gap = gap.widen(fine.drop_below(source.other(), vertex, &down));
        }
        Moment { numerator: gap, denominator: dot(&n, &self.v) }
    }

    /// Where the other body is along an edge at time `t`: its vertex, or its side that is parallel to the edge.
    fn place(&self, fine: &Fine, way: &Way, t: Ball) -> Place {
        let DifferenceEdge { source, edge, vertex } = way.facing;
        let other = self.pair.hull(source.other());
        let ends = way.partner.map_or([vertex; 2], |side| [side, other.next(side)]);
        let e = fine.side(source, edge);
        let along = |k: usize| match source {
            Side::A => dot(&minus(&fine.between(edge, k), &scaled(&self.v, t)), &e),
            Side::B => dot(&minus(&scaled(&self.v, t), &fine.between(k, edge)), &e),
        };
        let (p, q) = (along(ends[0]), along(ends[1]));
        let ((low, first), (high, last)) =
            if (p - q).value.hi <= 0.0 { ((p, ends[0]), (q, ends[1])) } else { ((q, ends[1]), (p, ends[0])) };
        let vertex = |end: usize, k: usize| a_then_b(source, end, k);
        let (start, end) = (vertex(edge, last), vertex(self.pair.hull(source).next(edge), first));
        match (high.sign(), (low - dot(&e, &e)).sign()) {
            (Some(-1), _) => Place::Beyond(start),
            (_, Some(1)) => Place::Beyond(end),
            (Some(_), Some(_)) => Place::Over,
            (None, _) => Place::Unsure(start),
            (_, None) => Place::Unsure(end),
        }
    }

    /// Where the ray meets the disc at a vertex of B ⊖ A.
    fn disc(&self, fine: &Fine, vertex: [usize; 2]) -> Entry {
        let (p, v) = (fine.between(vertex[0], vertex[1]), self.v);
        let (across, along, speed_squared) = (cross(&v, &p), dot(&v, &p), dot(&v, &v));
        let piece = DifferenceFeature::Vertex(vertex);
        let radius = Ball::exact(self.pair.radius);
        if self.pair.radius.hi == 0.0 {
            return match across.sign() {
                Some(0) => {
                    let moment = Moment { numerator: along, denominator: speed_squared };
                    Entry::At(piece, moment, moment)
                }
                Some(side) => self.passes(fine, vertex, side),
                None => Entry::Unsure,
            };
        }
        let discriminant = radius * radius * speed_squared - across * across;
        match discriminant.sign() {
            Some(0 | 1) => {
                let c = dot(&p, &p) - radius * radius;
                let last = Moment { numerator: c, denominator: along + discriminant.sqrt() };
                let first = if discriminant.sign() == Some(0) {
                    last
                } else {
                    self.tangent(fine, vertex, last).unwrap_or(last)
                };
                Entry::At(piece, first, last)
            }
            Some(_) => self.passes(fine, vertex, across.sign().unwrap_or(0)),
            None => Entry::Unsure,
        }
    }

    /// When the ray meets the tangent of B ⊖ A along the normal of a disc's entry: not later than B ⊖ A itself.
    fn tangent(&self, fine: &Fine, [i, j]: [usize; 2], entry: Moment) -> Option<Moment> {
        let (p, v, t) = (fine.between(i, j), self.direction(), entry.value().value.hi);
        let n = DVec2::new(p[0].value.hi - t * v.x, p[1].value.hi - t * v.y);
        let n = n / outline::length(n);
        if !n.is_finite() {
            return None;
        }
        let n = [Ball::new(n.x), Ball::new(n.y)];
        let drop = fine.drop_below(Side::B, j, &n) + fine.drop_below(Side::A, i, &reversed(&n));
        let gap = dot(&n, &p) - Ball::exact(self.pair.radius) * dot(&n, &n).sqrt();
        let closing = dot(&n, &self.v);
        closing.is_positive().then(|| Moment { numerator: gap.widen(drop), denominator: closing })
    }

    /// Whether the line certainly passes B ⊖ A, of which the vertex near it is on the given side (1: left).
    fn passes(&self, fine: &Fine, [i, j]: [usize; 2], side: i8) -> Entry {
        let left = [-self.v[1], self.v[0]];
        let away = if side > 0 { left } else { reversed(&left) };
        let drop = fine.drop_below(Side::B, j, &away) + fine.drop_below(Side::A, i, &reversed(&away));
        let reach = Ball::exact(self.pair.radius) * dot(&self.v, &self.v).sqrt();
        let clear = dot(&away, &fine.between(i, j)) - reach - Ball::new(drop);
        if clear.is_positive() { Entry::Misses } else { Entry::Unsure }
    }
}

/// Records what became of each edge.
fn tell(at: &Pair, entry: &Entry, outcome: &Outcome, tracer: &mut impl Tracer) {
    let pair = Relative::at(at.a, at.b, 0.0);
    tracer.record(|| Event::Started { algorithm: NAME, at: pair.at });
    outline::record(&pair, tracer);
    let v = pair.local_vector(at.a.velocity - at.b.velocity);
    let met = match (entry, outcome) {
        (Entry::At(piece, ..) | Entry::Quick(Met::At(piece, ..)), Outcome::Hit { .. }) => Some(*piece),
        _ => None,
    };
    let radius = pair.radius();
    walk(&pair, |p| {
        let [from, to] = p.ends(&pair);
        let outward = p.outward(&pair);
        let facing = v.perp_dot(to - from) < 0.0;
        let hit = matches!(met, Some(DifferenceFeature::Edge(f)) if (f.source, f.edge) == (p.source, p.edge));
        let culling = match (facing, hit) {
            (false, _) => Culling::BackFacing,
            (true, true) => Culling::Hit,
            (true, false) => Culling::Missed,
        };
        tracer.record(|| Event::RayClipped {
            source: (p.source, Feature::Edge(pair.file_edge(p.source, p.edge))),
            from: pair.world_vector(from + outward * radius),
            to: pair.world_vector(to + outward * radius),
            outcome: culling,
            time: facing.then(|| (outward.dot(from) + radius) / outward.dot(v)),
        });
    });
    if let (Some(DifferenceFeature::Vertex([i, j])), Outcome::Hit { time, .. }) = (met, outcome) {
        let center = pair.world_vector(pair.vertex(Side::B, j) - pair.vertex(Side::A, i));
        let source = (Side::B, Feature::Vertex(pair.file_vertex(Side::B, j)));
        let time = Some(time.lo);
        tracer.record(|| Event::RayClipped { source, from: center, to: center, outcome: Culling::Hit, time });
    }
}

/// Where the other body's vertex is along an edge when the ray meets the edge's line.
enum Place {
    /// Over the edge.
    Over,
    /// Beyond the end that makes this vertex of B ⊖ A.
    Beyond([usize; 2]),
    /// At that vertex, as far as 106 bits tell.
    Unsure([usize; 2]),
}

impl Moment {
    /// The last double surely before it, and the first surely not before it.
    pub(crate) fn doubles(self) -> (f64, f64) {
        let value = self.value();
        let nearest = value.value.to_f64();
        // Exactly at a double?
        if (self.numerator - self.denominator.scale(nearest)).sign() == Some(0) {
            return (nearest.next_down(), nearest);
        }
        let Enclosure { lo, hi } = value.enclosure();
        (lo, hi)
    }

    fn value(self) -> Ball {
        self.numerator.over(self.denominator)
    }
}

/// The facing edge whose line the ray meets last, in doubles.
pub(crate) fn last_line(pair: &Pair, v: DVec2) -> Option<DifferenceEdge> {
    let (center, rotation) = (pair.center, pair.b_rotation.rounded());
    let radius = pair.radius.hi;
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let scale = pair.scale;
    let mut last: Option<(DifferenceEdge, f64)> = None;
    let mut visit = |facing: DifferenceEdge, gap: f64, closing: f64| {
        // Compared as fractions with positive denominators would overflow sooner than as quotients.
        let time = (gap * scale - radius) / closing;
        if closing > 0.0 && last.is_none_or(|(_, latest)| time > latest) {
            last = Some((facing, time));
        }
    };
    let c = center / scale;
    pass(a, b, (c, rotation), |edge, vertex, gap| {
        visit(DifferenceEdge { source: Side::A, edge, vertex }, gap, a.normals[edge].dot(v));
    });
    let seen = -rotation.undo(v);
    pass(b, a, (-rotation.undo(c), rotation.inverse()), |edge, vertex, gap| {
        visit(DifferenceEdge { source: Side::B, edge, vertex }, gap, b.normals[edge].dot(seen));
    });
    last.map(|(facing, _)| facing)
}

/// x · y.
fn scaled(x: &Vec2, y: Ball) -> Vec2 {
    [x[0] * y, x[1] * y]
}
