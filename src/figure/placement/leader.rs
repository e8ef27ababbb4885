//! Leader lines: thin and short, from what a label belongs to, to where it stands.
//!
//! One is drawn where a label stands so far off that a reader has to be led, or as near to another thing that
//! it could name. It ends beside a marker, on a line, or in an area with a dot, in the part that is that
//! area's alone.

use crate::drawing::{Point, Rect};

use super::rect::nearest_in;
use super::things::Things;
use super::weights::Places;

/// Length of a leader line beyond which it is a fault, page pixels.
pub(super) const LONGEST: f64 = 40.0;
/// Length of a leader line below which it is not seen to be one, page pixels.
const SHORTEST: f64 = 5.0;

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
    let at = own.nearest(rect.center());
    let near = nearest_in(rect, at);
    let u = (near - at).unit()?;
    let clear = if own.clear() > 0.0 { own.clear() + w.leader_room } else { 0.0 };
    let (from, to) = (at + u * clear, near + u * -w.leader_room);
    let seen = (to - from).dot(u) >= SHORTEST;
    seen.then_some(Leader { from, to, dot: false, border: from })
}

/// The leader line into an area, to the nearest spot that is well inside of it and in no other one.
fn into(things: &Things, rect: &Rect, w: &Places) -> Option<Leader> {
    let own = things.own.as_ref()?;
    let best = things.remote.first().map(|&(_, room)| room).filter(|&room| room > 0.0)?;
    let depth = w.leader_depth.min(0.5 * best);
    // The remotest come first.
    let spots = things.remote.iter().take_while(|&&(_, room)| room >= depth).map(|&(p, _)| p);
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
