//! Separation, bounds, normal, ties, witness points and features at one moment.
//!
//! The proof that an answer is right needs no search: a direction n whose gap of supports is s, features that
//! lie in those supports, points on the features, and `p_B − p_A = s n`. Each is measured here against the
//! exact s.

use super::{
    ERROR, NORMAL, POINTS, RELATIVE_ERROR, RELATIVE_FROM, RELATIVE_WIDTH, Report, Setting, UNRESOLVED, WIDTH,
    slack,
};
use crate::float::Real;
use crate::json::Json;
use crate::placement::Placed;
use crate::point::Point;
use crate::scene::EPSILON;
use crate::separation::{Exact, gap_along, parallel_sine, separation};

/// What an answer claims of a pair at one moment.
#[derive(Clone, Debug)]
pub struct Contact {
    /// Signed.
    pub separation: f64,
    /// Enclosing it.
    pub bounds: [f64; 2],
    /// From A to B.
    pub normal: [f64; 2],
    /// Printed for separations only.
    pub ties: Option<f64>,
    /// On A and on B.
    pub points: [[f64; 2]; 2],
    /// Vertex or edge of A and of B.
    pub features: [Feature; 2],
}

/// A feature by its index in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// A vertex.
    Vertex(usize),
    /// From vertex i to i + 1.
    Edge(usize),
}

impl Feature {
    /// Reads it from an object with a vertex or an edge; None for any other.
    #[must_use]
    pub fn read(json: &Json) -> Option<Self> {
        let whole =
            |x: f64| (0..1_000_000).find(|i: &u32| f64::from(*i) == x).and_then(|i| usize::try_from(i).ok());
        match (json.number_at("vertex"), json.number_at("edge")) {
            (Some(i), None) => whole(i).map(Self::Vertex),
            (None, Some(i)) => whole(i).map(Self::Edge),
            _ => None,
        }
    }
}

impl Contact {
    /// Reads it from a `result`; None where a field is missing or of a wrong type.
    #[must_use]
    pub fn read(result: &Json) -> Option<Self> {
        let (points, features) = (result.get("points")?, result.get("features")?);
        Some(Self {
            separation: result.number_at("separation")?,
            bounds: result.pair_at("separation_bounds")?,
            normal: result.pair_at("normal")?,
            ties: result.number_at("ties"),
            points: [points.pair_at("A")?, points.pair_at("B")?],
            features: [Feature::read(features.get("A")?)?, Feature::read(features.get("B")?)?],
        })
    }
}

/// Holds the claims of a contact against the pair; `counted` where the answer must have ties. Gives the exact
/// answer.
pub fn check_contact(
    report: &mut Report,
    setting: &Setting,
    pair: &[Placed; 2],
    result: &Json,
    counted: bool,
) -> Exact {
    let exact = separation(&pair[0], &pair[1]);
    let Some(contact) = Contact::read(result) else {
        report.fault("fields", format!("incomplete: {result}"));
        return exact;
    };
    check_value(report, setting, &exact, contact.separation, contact.bounds);
    if counted {
        check_ties(report, setting, &exact, &contact);
    }
    check_normal(report, setting, pair, &exact, &contact);
    check_witnesses(report, setting, pair, &contact);
    exact
}

/// The value, its bounds, and their limits.
pub(super) fn check_value(
    report: &mut Report,
    setting: &Setting,
    exact: &Exact,
    value: f64,
    [lo, hi]: [f64; 2],
) {
    let s = exact.separation;
    let slack = slack(setting.scale);
    if !(lo <= value && value <= hi) {
        report.fault("order", format!("{value:e} is not in [{lo:e}, {hi:e}]"));
    }
    if Real::from(lo) > s + slack || Real::from(hi) < s - slack {
        report.fault("bounds", format!("[{lo:e}, {hi:e}] does not hold {s}"));
    }
    // Of what is nearer 0 than the slack, the sign is rounding's.
    let wrong_sign = f64::from(s.signum()) * value < 0.0 && s.abs() > slack;
    if wrong_sign && (lo > 0.0 || hi < 0.0) {
        report.fault("sign", format!("{value:e} for {s}"));
    }
    let error = (Real::from(value) - s).abs();
    let width = Real::from(hi) - Real::from(lo);
    // How much of the bounds is needed: where this never exceeds a quarter, bounds cut to a quarter would go
    // unseen.
    let side = if Real::from(value) < s {
        Real::from(hi) - Real::from(value)
    } else {
        Real::from(value) - Real::from(lo)
    };
    if side.signum() > 0 {
        report.measures.push(("error / bound", error.over(side).to_f64()));
    }
    report.limit("error / εS", setting.units(error), ERROR);
    report.limit("width / εS", setting.units(width), WIDTH);
    if setting.units(s) > RELATIVE_FROM {
        let relative = |x: Real| if setting.units(x) == 0.0 { 0.0 } else { x.over(s.abs()).to_f64() };
        report.limit("error / |s|", relative(error), RELATIVE_ERROR);
        report.limit("width / |s|", relative(width), RELATIVE_WIDTH);
    }
}

/// At least the exact ties; at most the ways whose separation the bounds cannot tell from the answer.
fn check_ties(report: &mut Report, setting: &Setting, exact: &Exact, contact: &Contact) {
    let slack = slack(setting.scale);
    let Some(ties) = contact.ties else {
        report.fault("ties", "not printed".to_owned());
        return;
    };
    let count = |least: Real| exact.ways.iter().filter(|way| way.separation >= least).count();
    let mut fewest = count(exact.separation - slack);
    let [lo, hi] = contact.bounds.map(Real::from);
    let mut most = count(lo - (hi - lo).max(Real::from(setting.scale * EPSILON))).max(fewest);
    if exact.normal.is_none() {
        // Points that coincide: every direction ties. A point at the end of a segment: a half-turn of
        // directions.
        (fewest, most) = if exact.ways.is_empty() { (0, 0) } else { (0, 2) };
    } else if exact.core.abs() <= (hi - lo).scaled(1) + Real::from(UNRESOLVED * EPSILON * setting.scale) {
        // Cores that touch within the bounds: all directions between two edges tie there, or all directions
        // there are.
        (fewest, most) = (0, exact.edges.max(most));
    }
    let fits = (fewest..=most).any(|n| u32::try_from(n).is_ok_and(|n| f64::from(n) == ties));
    if !fits {
        report.fault("ties", format!("{ties} is not in {fewest} … {most}"));
    }
}

/// A unit vector whose gap of supports is the separation, near an admissible direction.
fn check_normal(
    report: &mut Report,
    setting: &Setting,
    pair: &[Placed; 2],
    exact: &Exact,
    contact: &Contact,
) {
    let printed = Point::of(contact.normal);
    let length = printed.length();
    report.limit("|n| − 1, in ε", (length - Real::one()).abs().over(Real::from(EPSILON)).to_f64(), 4.0);
    if length.is_zero() {
        return;
    }
    let unit = printed.unit();
    let loss = exact.separation - gap_along(&pair[0], &pair[1], unit);
    report.limit("loss along n / εS", setting.units(loss), POINTS);
    let width = Real::from(contact.bounds[1]) - Real::from(contact.bounds[0]);
    let least = exact.separation - width - slack(setting.scale);
    let mut near = exact
        .ways
        .iter()
        .filter(|way| way.separation >= least)
        .map(|way| way.normal.minus(unit).length())
        .min();
    if exact.normal.is_none() && exact.ways.is_empty() {
        near = Some(Real::ZERO);
    }
    let off = near.unwrap_or(Real::one()).to_f64();
    // The direction between two vertices a distance d apart is as good as their places: εS / d.
    let hangs = exact.core.signum() >= 0 || setting.units(exact.core) <= RELATIVE_FROM;
    let by_place = if hangs { POINTS / setting.units(exact.core).max(f64::MIN_POSITIVE) } else { 0.0 };
    report.measures.push(("off n", off));
    if off > NORMAL + by_place {
        report.fault("normal", format!("{:?} is {off:.3e} off", contact.normal));
    }
}

/// Points on the features, features in the supports along n, `p_B − p_A = s n`, and the middle of a common
/// span.
fn check_witnesses(report: &mut Report, setting: &Setting, pair: &[Placed; 2], contact: &Contact) {
    let n = Point::of(contact.normal).unit();
    let [p_a, p_b] = contact.points.map(Point::of);
    let gap = p_b.minus(p_a).minus(n.times(Real::from(contact.separation)));
    report.limit("p_B − p_A − s n / εS", setting.units(gap.length()), POINTS);
    let mut exactly_flat = Vec::new();
    for (body, (feature, (point, outward))) in
        pair.iter().zip(contact.features.iter().zip([(p_a, n), (p_b, n.reversed())]))
    {
        let Some(ends) = ends(body, *feature) else {
            report.fault("features", format!("{feature:?} does not exist"));
            return;
        };
        let far = body.core_points().map(|p| p.dot(outward)).max().unwrap_or(Real::ZERO);
        let below = ends.iter().map(|p| far - p.dot(outward)).max().unwrap_or(Real::ZERO);
        report.limit("feature below support / εS", setting.units(below), POINTS);
        let on_core = point.minus(outward.times(body.radius));
        report.limit("point off feature / εS", setting.units(distance_to(ends, on_core)), POINTS);
        exactly_flat.push(face(body, ends, outward));
    }
    if let [Some(a), Some(b)] = exactly_flat[..] {
        check_middle(report, setting, contact, &[a, b]);
    }
}

/// World ends of a feature; a vertex twice.
pub(super) fn ends(body: &Placed, feature: Feature) -> Option<[Point; 2]> {
    match feature {
        Feature::Vertex(i) => body.vertices.get(i).map(|p| [*p, *p]),
        Feature::Edge(i) => body.edge(i).map(|ends| ends.map(|i| body.vertices[i])),
    }
}

/// Distance of a point from a segment.
pub(super) fn distance_to([from, to]: [Point; 2], point: Point) -> Real {
    let (along, rest) = (to.minus(from), point.minus(from));
    let whole = along.dot(along);
    let t = rest.dot(along);
    if t.signum() <= 0 || whole.is_zero() {
        rest.length()
    } else if t >= whole {
        point.minus(to).length()
    } else {
        along.cross(rest).abs().over(whole.sqrt())
    }
}

/// The edge of the core that holds a feature's points and faces `outward`, as nearly as doubles can say; None
/// for a vertex.
fn face(body: &Placed, ends: [Point; 2], outward: Point) -> Option<[Point; 2]> {
    let core = &body.core;
    let count = core.len();
    let nearly = Real::from(4.0 * NORMAL);
    let edges = (0..if count < 2 { 0 } else { count })
        .map(|i| [core[i], core[(i + 1) % count]].map(|k| body.vertices[k]));
    edges.into_iter().find(|[from, to]| {
        let along = to.minus(*from);
        let facing = along.perp().reversed().dot(outward).signum() > 0;
        let square = along.dot(outward).abs() <= along.length() * nearly;
        let tiny = Real::power_of_two(-200) * along.length();
        facing && square && ends.iter().all(|p| distance_to([*from, *to], *p) <= tiny)
    })
}

/// Two exactly parallel faces: edge and edge, at the middle of their common span.
fn check_middle(report: &mut Report, setting: &Setting, contact: &Contact, faces: &[[Point; 2]; 2]) {
    let [a, b] = faces.each_ref().map(|[from, to]| to.minus(*from));
    if a.cross(b).abs() > a.length() * b.length() * parallel_sine() {
        return;
    }
    // Along the exact direction of the face, not the printed normal.
    let along = a.unit();
    let spans = faces.each_ref().map(|face| {
        let ends = face.map(|p| p.dot(along));
        [ends[0].min(ends[1]), ends[0].max(ends[1])]
    });
    let (from, to) = (spans[0][0].max(spans[1][0]), spans[0][1].min(spans[1][1]));
    let units = f64::from((to - from).signum()) * setting.units(to - from);
    if units < -POINTS {
        return;
    }
    let middle = (from + to).scaled(-1);
    let edges = contact.features.iter().all(|feature| matches!(feature, Feature::Edge(_)));
    if units > POINTS && !edges {
        report.fault("features", format!("{:?} of two parallel faces", contact.features));
    }
    // s n of rounded points: its part along the face is no more than the normal is off.
    let off = contact.points.map(|p| Point::of(p).dot(along) - middle);
    let worst = off.into_iter().map(Real::abs).max().unwrap_or(Real::ZERO);
    report.limit("off the middle / εS", setting.units(worst), 2.0 * POINTS);
}
