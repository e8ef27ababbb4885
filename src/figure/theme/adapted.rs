//! The colours that a theme file leaves to the theme that it is based on, moved out of the way of those that
//! it gives.
//!
//! Who writes two blues for A and B means nothing against the arrows, which the house draws in a blue of its
//! own: that colour is ours to choose, and the nearest one that readers can tell from the two is taken.

use crate::drawing::{Color, Role, blend};

use super::contrast::contrast;
use super::fitness::{AREAS, LINE_CONTRAST, SPEAKING, TEXT_CONTRAST, apart};
use super::nearest::{nearest, readable};
use super::vision::worst_difference;
use super::{Side, index};

/// How much of a line of the grid is ink, on a page of the file's own: as in the themes of the house.
const GRID: f64 = 0.1;

/// The shares of an overlap's colour that are tried on a page of the file's own: at the last one it is as
/// faint as the areas of bodies.
const THINNED: [f64; 5] = [1.0, 0.8, 0.6, 0.4, 0.2];

/// A side whose given colours are as written, and the others told apart from them; its words are readable.
pub(super) fn adapted(mut side: Side, given: impl Fn(Role) -> bool) -> Side {
    let page = side.colors[index(Role::Background)];
    let mut settled: Vec<Role> = SPEAKING.into_iter().filter(|&role| given(role)).collect();
    // A side that gives nothing is as it was.
    let changed = !settled.is_empty() || given(Role::Background);
    for role in SPEAKING.into_iter().filter(|&role| changed && !given(role)) {
        let color = free(&side, role, &settled);
        side.colors[index(role)] = color;
        settled.push(role);
    }
    if given(Role::Background) && !given(Role::Grid) {
        side.colors[index(Role::Grid)] = blend(side.colors[index(Role::Ink)], GRID, page);
    }
    if given(Role::Background) && !given(Role::Overlap) {
        side.colors[index(Role::Overlap)] = overlap(&side);
    }
    side.words = side.colors;
    for role in SPEAKING {
        side.words[index(role)] = words(&side, role);
    }
    side
}

/// The colour of an overlap on a page of the file's own: as much of the theme's as ink can be read on.
fn overlap(side: &Side) -> Color {
    let (own, page) = (side.colors[index(Role::Overlap)], side.colors[index(Role::Background)]);
    let thinned = THINNED.map(|share| blend(own, share, page));
    let ink = words(side, Role::Ink);
    let is_read = |color: &Color| contrast(ink, *color) >= TEXT_CONTRAST;
    thinned.into_iter().find(is_read).unwrap_or(own)
}

/// The shade of a role's words: readable on the page, and ink on areas too where there is such a shade.
fn words(side: &Side, role: Role) -> Color {
    let (own, page) = (side.colors[index(role)], side.colors[index(Role::Background)]);
    let mut grounds = vec![page];
    if role == Role::Ink {
        grounds.extend(AREAS.map(|area| blend(side.colors[index(area)], side.fill_opacity, page)));
    }
    let shade = readable(own, &grounds, TEXT_CONTRAST).or_else(|| readable(own, &[page], TEXT_CONTRAST));
    shade.unwrap_or(own)
}

/// The nearest colour of a role that can be read on the page and told from the settled roles; where there is
/// none, one that can be seen; its own where neither is.
fn free(side: &Side, role: Role, settled: &[Role]) -> Color {
    let (own, page) = (side.colors[index(role)], side.colors[index(Role::Background)]);
    // Its words stand beside those of others, whose shade may be another one than their lines'.
    let others: Vec<(Color, f64)> = settled
        .iter()
        .flat_map(|&other| [side.colors[index(other)], words(side, other)].map(|c| (c, apart(role, other))))
        .collect();
    let alone = |color: Color| others.iter().all(|&(other, least)| worst_difference(color, other) >= least);
    let on_page = |least| move |color: Color| contrast(color, page) >= least;
    let found = |least| {
        let seen = on_page(least);
        nearest(own, |color| seen(color) && alone(color))
    };
    found(TEXT_CONTRAST).or_else(|| found(LINE_CONTRAST)).unwrap_or(own)
}
