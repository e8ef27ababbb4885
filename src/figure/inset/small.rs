//! What is too small to be seen: of the lengths that a panel is about the largest that is shorter than its
//! own markers, enlarged where room is free.
//!
//! Bodies that an engine reports as touching are a hundredth of their size apart, or overlap by as much; on
//! the page that is less than the width of an outline.

use crate::drawing::{Offset, Point, Rect};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Cover, Detail, Sketched};
use crate::geometry::DVec2;

use super::{Inset, MARGIN, factors, hidden};

/// The length below which a detail is enlarged, page pixels: markers and ticks are 7 – 9 wide, so less than
/// half of that is left between those at its ends. At 16 what everyone sees was shown twice.
const SEEN: f64 = 12.0;
/// The length below which it stays enlarged from the frame before on, so that an inset does not come and go.
const STILL_SEEN: f64 = 17.0;
/// The least length of what is enlarged in its inset, page pixels: less is no wider than a line.
const LEAST: f64 = 8.0;
/// How far from its detail anything may come to lie by being enlarged, page pixels: half of how far a place
/// may be on a page. At twice a figure of a tiny gap between wide bodies is refused.
const FARTHEST: f64 = 5e5;
/// The least factor that is worth an inset.
const WORTH: f64 = 2.0;
/// The shares of its panel's width and height that an inset may take, the largest first.
const SHARES: [f64; 4] = [0.46, 0.4, 0.34, 0.29];
/// The most of its panel's width and of its height that an inset takes which would be too small otherwise.
const MOST_SHARE: f64 = 0.7;
/// The widest and the highest that an inset is, page pixels, and the narrowest and the lowest.
const LARGEST: [f64; 2] = [260.0, 190.0];
const SMALLEST: [f64; 2] = [124.0, 76.0];
/// What rounding may take off a length, page pixels.
const NEARLY: f64 = 1e-6;
/// The width of an inset that has room for a depth and its number, page pixels: a narrower one is taken only
/// where none so wide is free.
const ROOMY: f64 = 168.0;
/// The share of an inset that its detail takes: about it is what it belongs to.
const FILLED: f64 = 0.4;
/// Where an inset may stand, from its panel's middle: corners first, then between them, then within an area.
const PLACES: [[f64; 2]; 21] = [
    [1.0, -1.0],
    [-1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, -1.0],
    [0.0, 1.0],
    [0.5, -1.0],
    [-0.5, -1.0],
    [0.5, 1.0],
    [-0.5, 1.0],
    [1.0, 0.5],
    [1.0, -0.5],
    [-1.0, 0.5],
    [-1.0, -0.5],
    [0.5, 0.5],
    [0.5, -0.5],
    [-0.5, 0.5],
    [-0.5, -0.5],
    [0.0, 0.0],
];
/// How much of a line an inset may hide rather than stand away from the edges of its panel, page pixels.
const WITHIN: f64 = 40.0;
/// How much of a line an inset may hide, page pixels: what it takes to be recognised stays in view.
const HIDES: f64 = 60.0;
/// How much of a line an inset hides at most that does not hide its own detail, page pixels.
const ANYTHING: f64 = 1e9;
/// How much of a line an inset may hide to be as wide, or as high, as its panel, page pixels.
const LARGER: f64 = 200.0;
/// How much of a line an inset may hide rather than stand elsewhere than in the frame before, page pixels:
/// more than anywhere else, as one that jumps is lost.
const RESTS: f64 = 300.0;

/// The largest detail that is shorter than `seen`.
fn unseen(sketched: &Sketched, seen: f64) -> Option<&Detail> {
    let small = |detail: &&Detail| {
        let length = diagonal(&detail.rect);
        (LEAST / most(sketched, detail)..seen).contains(&length)
            && sketched.frame.panel.intersection(detail.rect).is_some()
    };
    let all = sketched.details.iter().filter(small);
    all.max_by(|a, b| diagonal(&a.rect).total_cmp(&diagonal(&b.rect)))
}

/// Whether something is too small to be seen, and no place is free for an inset of it, as wide as its panel
/// allows one to be.
pub(super) fn lacks_room(sketched: &Sketched) -> bool {
    let widest = (SHARES[0] * sketched.free.width()).min(ROOMY);
    let lacks = |found: &Detail| among(sketched, found, Wanted::default(), widest.max(SMALLEST[0])).is_none();
    unseen(sketched, SEEN).is_some_and(lacks)
}

/// Where an inset had better stand.
#[derive(Clone, Copy, Default)]
struct Wanted {
    /// Where it stood in the frame before of a figure that moves.
    before: Option<Rect>,
    /// The corner that the scene names, whatever it hides there but its detail.
    corner: Option<[f64; 2]>,
}

/// The inset of what is too small to be seen, in the `corner` that the scene names if it does; `None` where
/// nothing is, or where one would hide too much.
pub(super) fn enlarged(sketched: &Sketched, before: Option<Rect>, corner: Option<[f64; 2]>) -> Option<Inset> {
    let found = unseen(sketched, if before.is_some() { STILL_SEEN } else { SEEN })?;
    let wanted = Wanted { before, corner };
    among(sketched, found, wanted, ROOMY).or_else(|| among(sketched, found, wanted, SMALLEST[0]))
}

/// The inset of a detail that is at least so wide, page pixels, and hides least.
fn among(
    sketched: &Sketched,
    found: &Detail,
    Wanted { before, corner }: Wanted,
    narrowest: f64,
) -> Option<Inset> {
    let (frame, cell) = (&sketched.frame, &sketched.free);
    let [wide, high] = shares(cell);
    let shares = wide.iter().flat_map(|wide| high.map(|high| [*wide, high]));
    let most = most(sketched, found);
    let sizes = shares.filter_map(|share| {
        let found = sized(cell, (&found.rect, most), share);
        let (factor, size) = found.filter(|(_, size)| size[0] >= narrowest)?;
        Some((share, factor, size))
    });
    let places = sizes.flat_map(|(share, factor, size)| PLACES.map(|at| (share, factor, size, at)));
    let places = places.filter(|&(.., at)| corner.is_none_or(|corner| corner == at));
    let most_hidden = if corner.is_some() { ANYTHING } else { HIDES };
    let candidate = |(share, factor, size, at): ([f64; 2], f64, [f64; 2], [f64; 2])| {
        let rect = placed(cell, size, at);
        let detail = about(found.rect.center(), size.map(|edge| 0.5 * edge / factor));
        let hides = hidden(&rect, &detail, &sketched.obstacles);
        let rests = before.is_some_and(|before| (before.center() - rect.center()).length() < 1.0);
        let within = at.iter().all(|along| along.abs() < 1.0);
        let cost = hides - LARGER * (share[0] + share[1]) + if within { WITHIN } else { 0.0 }
            - if rests { RESTS } else { 0.0 };
        let most_hidden = most_hidden + if rests { RESTS } else { 0.0 };
        (hides <= most_hidden).then_some((cost, factor, rect, detail))
    };
    let best = places.filter_map(candidate).min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, factor, rect, detail) = best?;
    let middle = detail.center() - frame.middle;
    let center = frame.center + DVec2::new(middle.dx, -middle.dy) / frame.scale;
    let scale = frame.scale * factor;
    let frame = Frame { center, middle: rect.center(), scale, panel: rect, ..*frame };
    Some(Inset { frame, detail, factor, shown: found.shown })
}

/// How many times a detail may be enlarged, so that nothing that is drawn comes to lie too far from it.
fn most(sketched: &Sketched, detail: &Detail) -> f64 {
    let from = detail.rect.center();
    let far = |cover: &Cover| match *cover {
        Cover::Stroke { from: p, to: q, .. } => (p - from).length().max((q - from).length()),
        Cover::Marker { at, .. } | Cover::Head { at, .. } => (at - from).length(),
    };
    FARTHEST / sketched.obstacles.iter().map(|obstacle| far(&obstacle.cover)).fold(1.0, f64::max)
}

/// The shares of its panel's width and height that an inset may take: of a narrow or low panel also that by
/// which it is as large as it must be.
fn shares(cell: &Rect) -> [[f64; 5]; 2] {
    [(cell.width(), SMALLEST[0]), (cell.height(), SMALLEST[1])].map(|(room, smallest)| {
        let [first, second, third, last] = SHARES;
        let least = (smallest + NEARLY) / room;
        let more = if first < least && least <= MOST_SHARE { least } else { 0.0 };
        [first, second, third, last, more]
    })
}

/// From one end of a rectangle to the other.
fn diagonal(rect: &Rect) -> f64 {
    Offset::new(rect.width(), rect.height()).length()
}

/// How many times an inset of a share of its panel enlarges a detail, at `most`, and its width and height;
/// `None` where that is too small a panel, or too little.
fn sized(cell: &Rect, (detail, most): (&Rect, f64), share: [f64; 2]) -> Option<(f64, [f64; 2])> {
    let size = [cell.width(), cell.height()];
    let size = [0, 1].map(|k| (share[k] * size[k]).min(LARGEST[k]));
    if size[0] < SMALLEST[0] || size[1] < SMALLEST[1] {
        return None;
    }
    let room = FILLED * size[0].min(size[1]);
    let factor = *factors((room / diagonal(detail)).min(most)).first()?;
    (factor >= WORTH).then_some((factor, size))
}

/// The rectangle about a point with half a width and half a height.
fn about(middle: Point, [x, y]: [f64; 2]) -> Rect {
    Rect { x0: middle.x - x, y0: middle.y - y, x1: middle.x + x, y1: middle.y + y }
}

/// A rectangle of a width and a height at a place in its panel.
fn placed(cell: &Rect, size: [f64; 2], [right, down]: [f64; 2]) -> Rect {
    let half = size.map(|edge| 0.5 * edge);
    let x = right * (0.5 * cell.width() - MARGIN - half[0]);
    let y = down * (0.5 * cell.height() - MARGIN - half[1]);
    about(Point::new(cell.center().x + x, cell.center().y + y), half)
}
