//! Points of contact: the incident edge clipped to the reference edge, in 320 bits.
//!
//! Which edges face each other is taken from the answer and held to what they must be: no way out is shorter
//! than along the reference edge's normal, and no edge of the other body is more nearly against it than the
//! incident edge. The rest follows from them: the two ends of what the planes leave, which must be the
//! answer's points, each within its bounds.

use super::contact::{Contact, Feature, check_contact, check_value, distance_to, ends};
use super::{POINTS, Report, Setting, WIDTH, slack};
use crate::float::Real;
use crate::json::Json;
use crate::placement::Placed;
use crate::point::Point;
use crate::separation::{gap_along, separation};

/// How much more nearly against the normal another edge may be, as a part of 1.
fn as_near() -> Real {
    Real::power_of_two(-80)
}

/// An edge of a body with the body's number.
struct Owned {
    /// 0 for A, 1 for B.
    body: usize,
    /// Its ends, counter-clockwise, of the whole core edge.
    ends: [Point; 2],
}

impl Owned {
    /// Reads an edge of the answer: the core's edge that holds it and whose outward normal is most along
    /// `outward` of A's bodies, or against it for B's.
    fn read(json: &Json, pair: &[Placed; 2], normal: Point) -> Option<Self> {
        let body = match json.text_at("body")? {
            "A" => 0,
            "B" => 1,
            _ => return None,
        };
        let outward = if body == 0 { normal } else { normal.reversed() };
        let held = ends(&pair[body], Feature::read(json)?)?;
        let ends = core_edges(&pair[body])
            .filter(|edge| {
                let tiny = Real::power_of_two(-200) * edge[1].minus(edge[0]).length();
                held.iter().all(|p| distance_to(*edge, *p) <= tiny)
            })
            .max_by(|p, q| outwards(*p).dot(outward).cmp(&outwards(*q).dot(outward)))?;
        Some(Self { body, ends })
    }

    /// Its length.
    fn length(&self) -> Real {
        self.ends[1].minus(self.ends[0]).length()
    }
}

/// The edges of a core, counter-clockwise; a segment's there and back.
fn core_edges(body: &Placed) -> impl Iterator<Item = [Point; 2]> {
    let count = body.core.len();
    (0..if count < 2 { 0 } else { count })
        .map(move |i| [body.core[i], body.core[(i + 1) % count]].map(|k| body.vertices[k]))
}

/// The outward unit normal of an edge.
fn outwards([from, to]: [Point; 2]) -> Point {
    to.minus(from).perp().reversed().unit()
}

/// An end of what is left of the incident edge.
#[derive(Clone, Copy)]
struct End {
    /// Where it is on the core.
    at: Point,
    /// Its height over the reference edge.
    gap: Real,
    /// Its place along the reference edge.
    place: Real,
}

/// Holds a contact against the exact one.
pub(super) fn check_clipped(report: &mut Report, setting: &Setting, pair: &[Placed; 2], result: &Json) {
    let exact = separation(&pair[0], &pair[1]);
    let read = (
        result.number_at("separation"),
        result.pair_at("separation_bounds"),
        result.pair_at("normal"),
        result.get("contacts"),
    );
    let (Some(value), Some(bounds), Some(normal), Some(contacts)) = read else {
        report.fault("fields", format!("incomplete: {result}"));
        return;
    };
    check_value(report, setting, &exact, value, bounds);
    let normal = Point::of(normal).unit();
    let loss = exact.separation - gap_along(&pair[0], &pair[1], normal);
    report.limit("loss along n / εS", setting.units(loss), POINTS);
    let contacts: Option<Vec<Contact>> =
        contacts.list().iter().map(|json| read_point(json, result)).collect();
    let Some(contacts) = contacts else {
        report.fault("fields", format!("incomplete: {result}"));
        return;
    };
    if bounds[0] > 0.0 {
        if !contacts.is_empty() {
            report.fault("contacts", format!("{} of bodies apart", contacts.len()));
        }
        return;
    }
    match (result.get("reference"), result.get("incident")) {
        (Some(reference), Some(incident)) => {
            let edges = [reference, incident].map(|json| Owned::read(json, pair, normal));
            let [Some(reference), Some(incident)] = edges else {
                report.fault("edges", format!("{reference} and {incident}"));
                return;
            };
            check_edges(report, setting, pair, &exact.separation, [&reference, &incident]);
            check_ends(report, setting, pair, &contacts, [&reference, &incident]);
        }
        _ => check_vertices(report, setting, pair, &contacts, result),
    }
}

/// A point of the answer, with the normal of all.
fn read_point(json: &Json, result: &Json) -> Option<Contact> {
    let mut point = json.clone();
    point.set("normal", result.get("normal")?.clone());
    Contact::read(&point)
}

/// No shorter way out, and no edge that faces the reference edge more nearly.
fn check_edges(
    report: &mut Report,
    setting: &Setting,
    pair: &[Placed; 2],
    separation: &Real,
    [reference, incident]: [&Owned; 2],
) {
    if reference.body == incident.body {
        report.fault("edges", "both of one body".to_owned());
        return;
    }
    let outward = outwards(reference.ends);
    let along = if reference.body == 0 { outward } else { outward.reversed() };
    let loss = *separation - gap_along(&pair[0], &pair[1], along);
    report.limit("loss of the reference / εS", setting.units(loss), POINTS);
    let against = |edge: [Point; 2]| outwards(edge).dot(outward);
    let least = core_edges(&pair[incident.body]).map(against).min().unwrap_or(Real::ZERO);
    if against(incident.ends) > least + as_near() {
        report.fault("incident", format!("{} is not {least}", against(incident.ends)));
    }
}

/// The answer's points are the ends of what the planes leave.
fn check_ends(
    report: &mut Report,
    setting: &Setting,
    pair: &[Placed; 2],
    contacts: &[Contact],
    [reference, incident]: [&Owned; 2],
) {
    let Some(mut left) = clipped(reference.ends, incident.ends) else {
        if contacts.is_empty() {
            report.fault("contacts", "none of bodies that touch".to_owned());
        }
        return;
    };
    left.sort_by_key(|end| end.place);
    // Of two points over one place of the reference edge either may be told first.
    let beside = (left[1].place - left[0].place) <= slack(setting.scale) * reference.length();
    let radii = pair[0].radius + pair[1].radius;
    let slack = slack(setting.scale);
    let holds = |contact: &Contact, end: &End| {
        let s = end.gap - radii;
        Real::from(contact.bounds[0]) <= s + slack && s - slack <= Real::from(contact.bounds[1])
    };
    if beside && contacts.len() == 2 && !contacts.iter().zip(&left).all(|(contact, end)| holds(contact, end))
    {
        left.reverse();
    }
    let deep: Vec<&End> = match contacts.len() {
        1 => left.iter().filter(|end| holds(&contacts[0], end)).take(1).collect(),
        _ => left.iter().collect(),
    };
    if deep.len() != contacts.len() {
        let gaps = left.map(|end| (end.gap - radii).to_string()).join(" and ");
        report.fault("contacts", format!("{} for {gaps}", contacts.len()));
        return;
    }
    let missed = |end: &&End| !deep.iter().any(|d| d.place == end.place) && (end.gap - radii).signum() < 0;
    if let Some(end) = left.iter().find(missed) {
        report.fault("contacts", format!("none for {}", end.gap - radii));
    }
    for (contact, end) in contacts.iter().zip(deep) {
        if !holds(contact, end) {
            let bounds = contact.bounds;
            report.fault("contact bounds", format!("{bounds:?} do not hold {}", end.gap - radii));
        }
        check_point(report, setting, pair, contact, end, reference);
    }
}

/// One point: its number, its places and what carries it.
fn check_point(
    report: &mut Report,
    setting: &Setting,
    pair: &[Placed; 2],
    contact: &Contact,
    end: &End,
    reference: &Owned,
) {
    let (own, other) = (reference.body, 1 - reference.body);
    let outward = outwards(reference.ends);
    let [lo, hi] = contact.bounds;
    if !(lo <= contact.separation && contact.separation <= hi) {
        report.fault("order", format!("{:e} is not in {:?}", contact.separation, contact.bounds));
    }
    report.limit("contact width / εS", setting.units(Real::from(hi) - Real::from(lo)), WIDTH);
    let incident = end.at.minus(outward.times(pair[other].radius));
    let foot = end.at.minus(outward.times(end.gap));
    let surface = foot.plus(outward.times(pair[own].radius));
    for (body, place, core) in [(other, incident, end.at), (own, surface, foot)] {
        let off = Point::of(contact.points[body]).minus(place).length();
        report.limit("contact point / εS", setting.units(off), 2.0 * POINTS);
        let Some(ends) = ends(&pair[body], contact.features[body]) else {
            report.fault("features", format!("{:?} does not exist", contact.features[body]));
            return;
        };
        report.limit("contact off feature / εS", setting.units(distance_to(ends, core)), POINTS);
    }
}

/// What the planes through the ends of the reference edge leave of the incident edge; None for nothing.
fn clipped(reference: [Point; 2], incident: [Point; 2]) -> Option<[End; 2]> {
    let [p, q] = reference;
    let (along, outward) = (q.minus(p), outwards(reference));
    let whole = along.dot(along);
    let end = |at: Point| End { at, gap: outward.dot(at.minus(p)), place: along.dot(at.minus(p)) };
    let cut = |this: Point, that: Point| {
        let (x, y) = (along.dot(this.minus(p)), along.dot(that.minus(p)));
        let bound = if x.signum() < 0 {
            Real::ZERO
        } else if x > whole {
            whole
        } else {
            return Some(end(this));
        };
        // The other end on the far side of the plane.
        let crosses = if x.signum() < 0 { y.signum() >= 0 } else { y <= whole };
        crosses.then(|| end(this.plus(that.minus(this).times((bound - x).over(y - x)))))
    };
    Some([cut(incident[0], incident[1])?, cut(incident[1], incident[0])?])
}

/// Nothing was clipped: one point, which is the separation's own.
fn check_vertices(
    report: &mut Report,
    setting: &Setting,
    pair: &[Placed; 2],
    contacts: &[Contact],
    result: &Json,
) {
    let point = result.get("contacts").and_then(|list| list.list().first());
    let (1, Some(point)) = (contacts.len(), point) else {
        report.fault("contacts", format!("{} of two vertices", contacts.len()));
        return;
    };
    let mut point = point.clone();
    if let Some(normal) = result.get("normal") {
        point.set("normal", normal.clone());
    }
    check_contact(report, setting, pair, &point, false);
}
