//! The ray against B ⊖ A in balls: where it enters, decided by signs that are certain.
//!
//! Along the normal n of an edge (from A to B) let g be the gap of the cores at t = 0, p a vertex of B ⊖ A,
//! and ρ = `r_A` + `r_B`. Then
//!
//! ```text
//! v·n > 0                                   the edge faces the ray; the others are skipped
//! t = (g − ρ) / (v·n)                       where the ray meets the edge's line, moved out by ρ
//! t = c / (v·p + √(ρ² |v|² − cross(v, p)²)),  c = |p|² − ρ²        where it meets the disc at a vertex p
//! ```
//!
//! A ray enters a convex polygon through the facing edge whose line it meets last. Where that is within the
//! edge, it is the answer; beyond its end only the disc at that vertex is left, and where ρ = 0 a ray that
//! passes. Every sign is that of a ball, so that a graze is a hit exactly if the signs say so; a sign that
//! 106 bits do not tell is [`Entry::Unsure`].
//!
//! Source: the line that is met last is Cyrus and Beck, *Generalized two- and three-dimensional clipping*,
//! 1978; the root without cancellation is Press et al., *Numerical Recipes*, 2007, section 5.6.

use crate::collision::certified::distance::Pair;
use crate::collision::certified::distance::balls::{BallPair, Vec2, cross, dot, minus, reversed};
use crate::collision::certified::distance::gaps::pass;
use crate::collision::certified::sweep::ray::Entry;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{Ball, DVec2, Enclosure, Side};

/// Where the ray's line enters B ⊖ A, of a pair at t = 0.
#[cold]
pub(crate) fn entry(pair: &Pair) -> Entry {
    let v = pair.closing_in_balls();
    if dot(&v, &v).sign() == Some(0) {
        Entry::Still
    } else {
        Ray { pair, balls: BallPair::new(pair), v }.entry()
    }
}

/// A ray and B ⊖ A in balls, in A's frame and the units of `pair`.
struct Ray<'p, 's> {
    /// Both bodies at t = 0, in doubles.
    pair: &'p Pair<'s>,
    /// Both bodies at t = 0, in balls.
    balls: BallPair<'p, 's>,
    /// The closing velocity `v_A` − `v_B`, along which the ray runs; not 0.
    v: Vec2,
}

/// An edge of B ⊖ A and its line.
struct Line {
    /// The edge; its vertex is that which supports it along `normal`.
    facing: DifferenceEdge,
    /// The other body's edge that is parallel to it and faces it, if one is, or may be.
    partner: Option<usize>,
    /// From A to B, as long as the edge, which keeps it exact where the vertices are: of edges that a unit
    /// normal does not tell from parallel ones, the far end of one may be off the line of the other.
    normal: Vec2,
}

/// A time as a quotient of two balls, kept apart so that it can be told whether it is a double exactly.
#[derive(Clone, Copy, Debug)]
struct TimeQuotient {
    /// How far off a line or a disc is.
    numerator: Ball,
    /// How fast it comes nearer.
    denominator: Ball,
}

/// Where the ray meets the line of an edge of B ⊖ A.
enum MeetingPoint {
    /// On the edge.
    Within,
    /// Beyond the edge's end that is this vertex of B ⊖ A: [i, j].
    Beyond([usize; 2]),
    /// At that vertex, as far as 106 bits tell: on the edge or beyond its end.
    Undecided([usize; 2]),
}

impl TimeQuotient {
    /// The last double surely before the time, and the first surely not before it.
    fn doubles(self) -> Enclosure {
        let value = self.value();
        let nearest = value.value.to_f64();
        if (self.numerator - self.denominator.scale(nearest)).sign() == Some(0) {
            // Exactly this double.
            return Enclosure { lo: nearest.next_down(), hi: nearest };
        }
        value.enclosure()
    }

    fn value(self) -> Ball {
        self.numerator.over(self.denominator)
    }
}

impl Ray<'_, '_> {
    /// The direction of the ray: v, rounded to doubles.
    fn direction(&self) -> DVec2 {
        DVec2::new(self.v[0].value.hi, self.v[1].value.hi)
    }

    /// Where the ray's line enters B ⊖ A.
    fn entry(&self) -> Entry {
        let Some(facing) = last_line(self.pair, self.direction()) else {
            return self.entry_by_disc(self.first_vertex());
        };
        match self.entry_by_line(facing) {
            Entry::Unsure => self.entry_by_any_line().unwrap_or(Entry::Unsure),
            entry => entry,
        }
    }

    /// Where the ray's line enters B ⊖ A, which is through an edge, the one whose line it meets last, or
    /// beyond an end of it.
    fn entry_by_line(&self, facing: DifferenceEdge) -> Entry {
        let line = self.line(facing);
        let when = self.meets_line(&line);
        if !when.denominator.is_positive() {
            return Entry::Unsure;
        }
        match self.meeting_point(&line, when.value()) {
            MeetingPoint::Within => entry_within(&line, when),
            MeetingPoint::Beyond(vertex) => self.entry_by_disc(vertex),
            MeetingPoint::Undecided(vertex) => match self.entry_by_disc(vertex) {
                Entry::At { feature, time, contact } => {
                    // The edge's line bounds the time from below, the disc from above.
                    let time = Enclosure { lo: when.doubles().lo, hi: time.hi };
                    Entry::At { feature, time, contact }
                }
                other => other,
            },
        }
    }

    /// Where the ray enters through whichever edge it meets.
    ///
    /// Which line is last doubles may not tell: of an edge that the ray runs all but along, or beside one
    /// much longer than all that is near. A ray that comes from outside of an edge's line and meets it on the
    /// edge enters there, whichever line is last.
    fn entry_by_any_line(&self) -> Option<Entry> {
        let mut edges = Vec::new();
        each_line(self.pair, self.direction(), |facing, _, _| edges.push(facing));
        edges.into_iter().find_map(|facing| {
            let line = self.line(facing);
            let when = self.meets_line(&line);
            let is_within = when.denominator.is_positive()
                && matches!(self.meeting_point(&line, when.value()), MeetingPoint::Within);
            is_within.then(|| entry_within(&line, when))
        })
    }

    /// The vertex of B ⊖ A that is first along the ray, in doubles: where no edge faces it, B ⊖ A is a point
    /// or a segment along the ray, which meets it there if at all.
    fn first_vertex(&self) -> [usize; 2] {
        let (pair, v) = (self.pair, self.direction());
        let seen = pair.b_rotation.rounded().undo(v);
        [pair.hull(Side::A).highest(v, usize::MAX), pair.hull(Side::B).highest(-seen, usize::MAX)]
    }

    /// An edge of B ⊖ A with its line, from a vertex of the other body that doubles take for its support.
    fn line(&self, mut facing: DifferenceEdge) -> Line {
        let normal = self.balls.across(facing);
        let partner = self.balls.support(&mut facing, &normal);
        Line { facing, partner, normal }
    }

    /// When the ray meets the line of an edge, moved out by ρ.
    ///
    /// Both parts of the quotient are times the edge's length.
    fn meets_line(&self, line: &Line) -> TimeQuotient {
        let n = &line.normal;
        let mut gap = self.balls.gap(line.facing, line.partner, n);
        if self.pair.radius.hi > 0.0 {
            gap = gap - Ball::exact(self.pair.radius) * dot(n, n).sqrt();
        }
        TimeQuotient { numerator: gap, denominator: dot(n, &self.v) }
    }

    /// Where along an edge of B ⊖ A the ray is at time `t`: of a parallel edge of the other body, all counts
    /// that is over the edge.
    fn meeting_point(&self, line: &Line, t: Ball) -> MeetingPoint {
        let DifferenceEdge { source, edge, vertex } = line.facing;
        let (own, other) = (self.pair.hull(source), self.pair.hull(source.other()));
        let ends = line.partner.map_or([vertex; 2], |parallel| [parallel, other.next(parallel)]);
        let e = self.balls.edge(source, edge);
        let run = scaled(&self.v, t);
        let along = |k: usize| match source {
            Side::A => dot(&minus(&self.balls.between(edge, k), &run), &e),
            Side::B => dot(&minus(&run, &self.balls.between(k, edge)), &e),
        };
        // Which end is lower is asked of the parallel edge: beside a long run it is lost in rounding.
        let falls = |k: usize| dot(&self.balls.edge(source.other(), k), &e).value.hi < 0.0;
        let [first, last] = if line.partner.is_some_and(falls) { [ends[1], ends[0]] } else { ends };
        let (low, high) = (along(first), along(last));
        let (start, end) = (a_then_b(source, edge, last), a_then_b(source, own.next(edge), first));
        match (high.sign(), (low - dot(&e, &e)).sign()) {
            (Some(-1), _) => MeetingPoint::Beyond(start),
            (_, Some(1)) => MeetingPoint::Beyond(end),
            (Some(_), Some(_)) => MeetingPoint::Within,
            (None, _) => MeetingPoint::Undecided(start),
            (_, None) => MeetingPoint::Undecided(end),
        }
    }

    /// Where the ray enters, if that is at the disc at a vertex of B ⊖ A or nowhere.
    fn entry_by_disc(&self, vertex: [usize; 2]) -> Entry {
        let (p, v) = (self.balls.between(vertex[0], vertex[1]), self.v);
        let (across, along, speed_squared) = (cross(&v, &p), dot(&v, &p), dot(&v, &v));
        let feature = DifferenceFeature::Vertex(vertex);
        let radius = Ball::exact(self.pair.radius);
        if self.pair.radius.hi == 0.0 {
            return match across.sign() {
                Some(0) => {
                    // Nothing of B ⊖ A is before what is first along the ray, and the vertex is part of it.
                    let first = along - Ball::new(self.drop_along(vertex));
                    let [from, to] = [first, along]
                        .map(|numerator| TimeQuotient { numerator, denominator: speed_squared }.doubles());
                    let time = Enclosure { lo: from.lo, hi: to.hi };
                    Entry::At { feature, time, contact: None }
                }
                Some(side) => self.passes(vertex, side),
                None => Entry::Unsure,
            };
        }
        let discriminant = radius * radius * speed_squared - across * across;
        match discriminant.sign() {
            // It only touches the disc: where B ⊖ A reaches beyond, it has entered elsewhere.
            Some(0) if self.drop_aside(vertex, across.sign().unwrap_or(0)).1 > 0.0 => Entry::Unsure,
            Some(touches @ (0 | 1)) => {
                let c = dot(&p, &p) - radius * radius;
                let last = TimeQuotient { numerator: c, denominator: along + discriminant.sqrt() };
                let first =
                    if touches == 0 { last } else { self.meets_tangent(vertex, across, discriminant) };
                let time = Enclosure { lo: first.doubles().lo, hi: last.doubles().hi };
                Entry::At { feature, time, contact: None }
            }
            Some(_) => self.passes(vertex, across.sign().unwrap_or(0)),
            None => Entry::Unsure,
        }
    }

    /// When the ray meets the tangent of B ⊖ A at the point of a disc through which it enters: not later than
    /// it meets B ⊖ A itself.
    ///
    /// The disc's normal there is v √(discriminant) + (−`v_y`, `v_x`) `across`, as the ray is
    /// √(discriminant) / |v| before the foot of the center: a sum whose part along the ray stays right in a
    /// graze.
    fn meets_tangent(&self, [i, j]: [usize; 2], across: Ball, discriminant: Ball) -> TimeQuotient {
        let (p, v, root) = (self.balls.between(i, j), self.v, discriminant.sqrt());
        let n = [v[0] * root - v[1] * across, v[1] * root + v[0] * across].map(|x| Ball::exact(x.value));
        let drop = self.balls.drop_below(Side::B, j, &n) + self.balls.drop_below(Side::A, i, &reversed(&n));
        let gap = dot(&n, &p) - Ball::exact(self.pair.radius) * dot(&n, &n).sqrt();
        TimeQuotient { numerator: gap.widen(drop), denominator: dot(&n, &v) }
    }

    /// How much farther back along the ray B ⊖ A may reach than a vertex of it, times |v|: 0 where that is
    /// certainly the first.
    fn drop_along(&self, [i, j]: [usize; 2]) -> f64 {
        self.balls.drop_below(Side::B, j, &self.v) + self.balls.drop_below(Side::A, i, &reversed(&self.v))
    }

    /// The direction from the ray's line to a vertex of B ⊖ A that is on the given side of it (1: left), as
    /// long as v, and how much farther the other way B ⊖ A may reach than that vertex, times |v|.
    fn drop_aside(&self, [i, j]: [usize; 2], side: i8) -> (Vec2, f64) {
        let left = [-self.v[1], self.v[0]];
        let away = if side > 0 { left } else { reversed(&left) };
        let drop =
            self.balls.drop_below(Side::B, j, &away) + self.balls.drop_below(Side::A, i, &reversed(&away));
        (away, drop)
    }

    /// Whether the line certainly passes B ⊖ A, of which the vertex nearest to the line is on the given side
    /// of it (1: left).
    fn passes(&self, [i, j]: [usize; 2], side: i8) -> Entry {
        let (away, drop) = self.drop_aside([i, j], side);
        let reach = Ball::exact(self.pair.radius) * dot(&self.v, &self.v).sqrt();
        let clear = dot(&away, &self.balls.between(i, j)) - reach - Ball::new(drop);
        if clear.is_positive() { Entry::Misses } else { Entry::Unsure }
    }
}

/// An entry through an edge, on it.
fn entry_within(line: &Line, when: TimeQuotient) -> Entry {
    Entry::At { feature: DifferenceFeature::Edge(line.facing), time: when.doubles(), contact: None }
}

/// The edge of B ⊖ A facing a ray along v whose line, moved out by ρ, the ray meets last; in doubles.
pub(crate) fn last_line(pair: &Pair, v: DVec2) -> Option<DifferenceEdge> {
    let mut last: Option<(DifferenceEdge, f64)> = None;
    each_line(pair, v, |facing, gap, closing| {
        // Compared as fractions with positive denominators would overflow sooner than as quotients.
        let time = gap / closing;
        if closing > 0.0 && last.is_none_or(|(_, latest)| time > latest) {
            last = Some((facing, time));
        }
    });
    last.map(|(facing, _)| facing)
}

/// Visits every edge of B ⊖ A with how far its line, moved out by ρ, is from the origin, and how fast a ray
/// along v comes nearer to it; in doubles.
fn each_line(pair: &Pair, v: DVec2, mut visit: impl FnMut(DifferenceEdge, f64, f64)) {
    let (center, rotation) = (pair.center, pair.b_rotation.rounded());
    let (scale, radius) = (pair.scale, pair.radius.hi);
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let c = center / scale;
    pass(a, b, (c, rotation), |edge, vertex, gap| {
        let facing = DifferenceEdge { source: Side::A, edge, vertex };
        visit(facing, gap * scale - radius, a.normals[edge].dot(v));
    });
    let seen = -rotation.undo(v);
    pass(b, a, (-rotation.undo(c), rotation.inverse()), |edge, vertex, gap| {
        let facing = DifferenceEdge { source: Side::B, edge, vertex };
        visit(facing, gap * scale - radius, b.normals[edge].dot(seen));
    });
}

/// A vector times a number.
fn scaled(x: &Vec2, y: Ball) -> Vec2 {
    [x[0] * y, x[1] * y]
}
