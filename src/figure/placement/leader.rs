//! Leader lines: thin and short, from what a label belongs to, to where it stands.
//!
//! One is drawn where a label stands so far off that a reader has to be led, or as near to another thing that
//! it could name. It ends beside a marker, on a line, or in an area with a dot, in the part that is that
//! area's alone.

use crate::drawing::{Offset, Point, Rect};

use super::Candidate;
use super::rect::nearest_in;
use super::things::{Thing, Things};
use super::weights::Places;

/// Length of a leader line beyond which it is a fault, page pixels.
pub(super) const LONGEST: f64 = 40.0;
/// What moving a leader line adds to its length at most, page pixels: its ends are rounded.
const ROUNDING: f64 = 1e-6;
/// Length of a leader line below which it is not seen to be one, page pixels.
const SHORTEST: f64 = 5.0;
/// Length of a level leader line below which it reads as a minus before its letter, page pixels.
const MINUS: f64 = 12.0;
/// The rise of a unit below which a line is level.
const LEVEL: f64 = 0.35;

/// Shares of the way from the nearest point of a line to its middle that are tried for the end of a leader.
const SHARES: [f64; 3] = [0.75, 0.5, 0.25];

/// The least depth of the dot in an area, page pixels: beside its line, not on it.
const SHALLOW: f64 = 3.0;

/// A line from what a label belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Leader {
    /// The end at what it leads to, page pixels.
    pub(crate) from: Point,
    /// The end at the label, page pixels.
    pub(crate) to: Point,
    /// Whether it ends in an area, where a dot shows the end.
    pub(crate) dot: bool,
    /// Where it leaves what it leads to, page pixels.
    pub(super) border: Point,
}

impl Leader {
    /// The line moved as a whole.
    pub(super) fn shifted(self, by: Offset) -> Self {
        let Self { from, to, dot, border } = self;
        Self { from: from + by, to: to + by, dot, border: border + by }
    }

    /// The line to another box about the label's place, no shorter than it has to be.
    pub(super) fn until(self, rect: &Rect, w: &Places) -> Self {
        let near = nearest_in(rect, self.from);
        let u = (near - self.from).unit();
        u.map_or(self, |u| Self { to: near + u * -w.leader_room, ..self })
    }

    /// Whether it is longer than one may be.
    pub(super) fn is_long(&self) -> bool {
        self.length() > LONGEST + ROUNDING
    }

    /// How long it is, page pixels.
    pub(super) fn length(&self) -> f64 {
        (self.to - self.from).length()
    }
}

/// The leader line of a label in a box, however long; none for a note, and where none would be seen.
pub(super) fn leader(things: &Things, rect: &Rect, w: &Places) -> Option<Leader> {
    let own = things.own.as_ref()?;
    if own.is_area()
        && let Some(leader) = into(things, rect, w)
    {
        return Some(leader);
    }
    onto(own, rect, w)
}

/// The leader line of a label in a box to the line of what it belongs to.
pub(super) fn onto(own: &Thing, rect: &Rect, w: &Places) -> Option<Leader> {
    // The middle of a line where that is near enough, else as near to it as is: at an end other lines begin.
    let [middle, nearest] = [own.aim(rect.center()), own.nearest(rect.center())];
    let towards = |part: f64| straight(own, rect, nearest + (middle - nearest) * part, w);
    let is_near = |line: &Leader| line.length() <= LONGEST;
    let aimed = towards(1.0);
    if aimed.as_ref().is_none_or(is_near) || !own.has_ends() {
        let long = aimed.is_some_and(|line| !is_near(&line));
        return if long { towards(0.0) } else { aimed };
    }
    SHARES.into_iter().filter_map(towards).find(is_near).or_else(|| towards(0.0))
}

/// The leader line of a label off an end of a line to the middle of that; none where it would be too long, or
/// look like a part of it.
fn to_middle(own: &Thing, rect: &Rect, w: &Places) -> Option<Leader> {
    let line = straight(own, rect, own.aim(rect.center()), w)?;
    (line.length() <= LONGEST && !own.is_along(line.to - line.from)).then_some(line)
}

/// The leader line from a point of a thing; none where it would not be seen.
fn straight(own: &Thing, rect: &Rect, at: Point, w: &Places) -> Option<Leader> {
    let near = nearest_in(rect, at);
    let u = (near - at).unit()?;
    let clear = if own.clear() > 0.0 { own.clear() + w.leader_room } else { 0.0 };
    let (from, to) = (at + u * clear, near + u * -w.leader_room);
    let shortest = if u.dy.abs() < LEVEL { MINUS } else { SHORTEST };
    let seen = (to - from).dot(u) >= shortest;
    seen.then_some(Leader { from, to, dot: false, border: from })
}

/// The leader line into an area, to the nearest spot that is well inside of it and in no other one.
fn into(things: &Things, rect: &Rect, w: &Places) -> Option<Leader> {
    let own = things.own.as_ref()?;
    let best = things.remote(w).first().map(|&(_, room)| room).filter(|&room| room > 0.0)?;
    let depth = w.leader_depth.min(0.5 * best);
    // The remotest come first.
    let spots = things.remote(w).iter().take_while(|&&(_, room)| room >= depth).map(|&(p, _)| p);
    let far = spots.map(|p| ((nearest_in(rect, p) - p).square(), p));
    let (_, aim) = far.min_by(|(p, _), (q, _)| p.total_cmp(q))?;
    let near = nearest_in(rect, aim);
    let u = (near - aim).unit()?;
    // The spot may be deeper inside than it has to be.
    let border = own.line().crossing(aim, near).unwrap_or(aim);
    let to = near + u * -w.leader_room;
    // Of a label far off it reaches in only so far that the dot is seen to be inside.
    let depth = depth.min((LONGEST - (to - border).length()).max(SHALLOW));
    let shallow = border + u * -depth;
    let alone = |p: Point| !things.avoid().iter().any(|other| other.contains(p));
    let from = if (border - aim).length() > depth && alone(shallow) { shallow } else { aim };
    let seen = (to - border).dot(u) >= 0.5 * SHORTEST;
    seen.then_some(Leader { from, to, dot: true, border: border + u * w.leader_room })
}

/// The places that are on a page, those far from what their label belongs to with a leader line; those that
/// mislead, or stand off an end of a line, a second time with one.
pub(super) fn led(found: impl IntoIterator<Item = Candidate>, things: &Things, w: &Places) -> Vec<Candidate> {
    let on_page = |c: &Candidate| [c.rect.x0, c.rect.y0, c.rect.x1, c.rect.y1].iter().all(|v| v.is_finite());
    let mut all = Vec::new();
    for candidate in found.into_iter().filter(on_page) {
        let line = || leader(things, &candidate.rect, w).filter(|line| line.length() <= LONGEST);
        if is_far(things, &candidate.rect, w) {
            all.extend(line().map(|line| Candidate { leader: Some(line), ..candidate.clone() }));
            continue;
        }
        if let Some(own) = things.own.as_ref().filter(|own| !own.is_beside(&candidate.rect)) {
            let line = to_middle(own, &candidate.rect, w);
            all.extend(line.map(|line| Candidate { leader: Some(line), ..candidate.clone() }));
            all.push(Candidate { reluctance: candidate.reluctance + w.lead, ..candidate });
            continue;
        }
        let clearer = if things.misleads(&candidate) { line() } else { None };
        let reluctance = candidate.reluctance + w.lead;
        let clearer = clearer.map(|line| Candidate { leader: Some(line), reluctance, ..candidate.clone() });
        all.push(candidate);
        all.extend(clearer);
    }
    all
}

/// Whether a label that stands there is so far from what it belongs to that a reader has to be led.
pub(super) fn is_far(things: &Things, rect: &Rect, w: &Places) -> bool {
    things.own.as_ref().is_some_and(|own| own.is_farther(rect, w.led * w.far_gap))
}

#[cfg(test)]
mod tests {
    use super::super::rect::about;
    use super::super::things::Kind;
    use super::*;

    const W: &Places = &Places::TUNED;

    #[test]
    fn a_far_place_has_a_leader_of_at_most_forty_pixels() {
        let at = Point::new(0.0, 0.0);
        let panel = Rect { x0: -200.0, y0: -200.0, x1: 200.0, y1: 200.0 };
        let things = Things::among(&[], Thing::new(Kind::Point, vec![at], 4.5), &panel);
        let beside = |gap: f64| Candidate::new(about(at + Offset::new(19.5 + gap, 0.0), (30.0, 12.0)), 0.0);
        let places = led([5.0, 27.0, 38.0, 60.0].map(beside), &things, W);
        let far: Vec<_> = places.iter().filter_map(|c| c.leader).collect();
        assert_eq!((places.len(), far.len()), (3, 2), "what no leader reaches is no place");
        assert!(far.iter().all(|line| line.length() <= 40.0 && (line.from - at).length() > 4.5));
    }

    #[test]
    fn a_leader_that_is_moved_is_as_long_as_before() {
        let (from, step) = (Point::new(0.1, 0.2), Offset::new(0.3, 0.7));
        let line = Leader { from, to: from + Offset::new(LONGEST, 0.0), dot: true, border: from };
        let far = (0..100).fold(line, |line, _| line.shifted(step));
        assert!(!line.is_long() && !far.is_long(), "{}", far.length() - LONGEST);
    }

    #[test]
    fn a_leader_to_a_short_line_ends_on_the_line_and_at_neither_end_of_it() {
        let panel = Rect { x0: -200.0, y0: -200.0, x1: 200.0, y1: 200.0 };
        for kind in [Kind::Length, Kind::Line] {
            let ends = vec![Point::new(0.0, 0.0), Point::new(20.0, 0.0)];
            let things = Things::among(&[], Thing::new(kind, ends, 0.0), &panel);
            let line = leader(&things, &about(Point::new(60.0, -20.0), (30.0, 12.0)), W).unwrap();
            assert!(line.from.x > 4.0 && line.from.x < 16.0, "{kind:?}: {line:?}");
        }
    }

    #[test]
    fn a_leader_that_reaches_no_middle_ends_beside_the_end_of_a_line() {
        let panel = Rect { x0: -200.0, y0: -200.0, x1: 200.0, y1: 200.0 };
        let ends = vec![Point::new(0.0, 0.0), Point::new(160.0, 0.0)];
        let things = Things::among(&[], Thing::new(Kind::Length, ends, 0.0), &panel);
        // Its nearest corner is 20 px left of the line's end and 20 below it.
        let line = leader(&things, &about(Point::new(-50.0, 32.0), (60.0, 24.0)), W).unwrap();
        assert!(line.length() <= LONGEST && line.from.x > 8.0, "{line:?}");
    }

    #[test]
    fn a_place_off_an_end_of_a_line_is_led_to_its_middle_or_is_worse() {
        let panel = Rect { x0: -200.0, y0: -200.0, x1: 200.0, y1: 200.0 };
        let ends = vec![Point::new(0.0, 0.0), Point::new(20.0, 0.0)];
        let things = Things::among(&[], Thing::new(Kind::Length, ends, 0.0), &panel);
        let offered = |x: f64, y: f64| {
            let places = led([Candidate::new(about(Point::new(x, y), (30.0, 12.0)), 0.0)], &things, W);
            places.iter().map(|c| (c.leader.is_some(), c.reluctance)).collect::<Vec<_>>()
        };
        assert_eq!(offered(10.0, -12.0), [(false, 0.0)], "above it");
        assert_eq!(offered(40.0, -14.0), [(true, 0.0), (false, W.lead)], "off its end");
        assert_eq!(offered(40.0, 0.0), [(false, W.lead)], "in line with it, where no leader would be seen");
    }

    #[test]
    fn a_place_that_misleads_is_offered_again_with_a_leader_to_its_own_area() {
        let square = |x: f64| {
            let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
            let points = points.map(|(dx, dy)| Point::new(x + 80.0 * dx, 80.0 * dy));
            Thing::new(Kind::Area, points.to_vec(), 0.0).unwrap()
        };
        let panel = Rect { x0: -200.0, y0: -200.0, x1: 200.0, y1: 200.0 };
        let all = [square(0.0), square(40.0)];
        let things = Things::among(&all, Some(square(40.0)), &panel);
        // Above the middle of both.
        let rect = about(Point::new(60.0, -12.0), (60.0, 12.0));
        let [plain, clear] = &led(vec![Candidate::new(rect, 0.0)], &things, W)[..] else {
            panic!("two places")
        };
        let line = clear.leader.unwrap();
        assert!(plain.leader.is_none() && line.dot && line.length() < 40.0);
        assert!(line.from.x > 80.0 && line.from.x < 120.0, "in the part that is its alone: {line:?}");
    }
}
