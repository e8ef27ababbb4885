//! Reserve that a label of a figure that moves keeps for the digits that its numbers have in other frames.
//!
//! A number that is written without zeros at its end, as 1.5 between 1.48 and 1.52, makes its label narrower
//! for one frame. A place that only the narrow label fits would be left in the next one, and taken again
//! soon; so a label seeks a place for the widest text that it had lately.

use crate::drawing::{Offset, Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::Anchor;

use super::{Placed, Sought};

/// For how many frames a label keeps room for its widest text: half a second where 60 are drawn in one. A
/// number of two decimals that grows by a hundredth a frame ends in a zero in each tenth.
const KEPT: u32 = 30;

/// The room that a label keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Reserve {
    /// The width of the widest text of its last frames, page pixels.
    width: f64,
    /// How many frames ago it had that.
    ago: u32,
}

impl Reserve {
    /// The room of a label that had some in the frame before.
    pub(super) fn of(sought: &Sought, before: Option<&Placed>) -> Self {
        let width = sought.width(0);
        let ago = |room: &Self| room.ago + 1;
        let kept = before.map(|label| label.standing.room);
        kept.filter(|room| room.width > width && ago(room) < KEPT)
            .map_or(Self { width, ago: 0 }, |room| Self { ago: ago(&room), ..room })
    }

    /// How much wider it is than a label, page pixels.
    pub(super) fn beyond(&self, sought: &Sought) -> f64 {
        (self.width - sought.width(0)).max(0.0)
    }
}

/// What a label's place is measured from, for a note the corner of its panel.
pub(super) fn origin(anchor: &Anchor, home: Point, frame: &Frame) -> Point {
    match anchor {
        Anchor::Corner(corner) => {
            let ((dx, dy), panel) = (corner.direction(), &frame.panel);
            panel.center() + Offset::new(0.5 * dx * panel.width(), 0.5 * dy * panel.height())
        }
        _ => home,
    }
}

/// A label's box for a text of another size, as a number has from frame to frame: the edges towards what it
/// names stay, and it grows to both sides where it stands above, below or on it.
pub(super) fn resized(bounds: &Rect, home: Point, (width, height): (f64, f64)) -> Rect {
    let (x0, x1) = spread((bounds.x0, bounds.x1), home.x, width);
    let (y0, y1) = spread((bounds.y0, bounds.y1), home.y, height);
    Rect { x0, y0, x1, y1 }
}

/// The ends of a stretch that gets another length and keeps its end towards `home`.
fn spread((lo, hi): (f64, f64), home: f64, length: f64) -> (f64, f64) {
    let more = length - (hi - lo);
    let share = if home <= lo {
        0.0
    } else if home >= hi {
        1.0
    } else {
        0.5
    };
    (lo - share * more, hi + (1.0 - share) * more)
}

#[cfg(test)]
mod tests {
    use super::super::rect::about;
    use super::*;

    #[test]
    fn a_box_keeps_its_edge_towards_what_it_names() {
        let (home, right) = (Point::new(0.0, 0.0), about(Point::new(40.0, 0.0), (20.0, 12.0)));
        let wider = resized(&right, home, (30.0, 12.0));
        assert_eq!((wider.x0, wider.x1, wider.y0), (30.0, 60.0, -6.0));
        assert_eq!(resized(&wider, home, (20.0, 12.0)), right, "and is what it was when its text is");
        let above = resized(&about(Point::new(0.0, -20.0), (20.0, 12.0)), home, (30.0, 14.0));
        assert_eq!((above.x0, above.x1, above.y0, above.y1), (-15.0, 15.0, -28.0, -14.0));
    }
}
