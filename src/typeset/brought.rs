//! The faces of live pages: packed, with the glyphs that our own words and layers say (`own.rs`).
//!
//! The module of live pages embeds these in the place of the whole ones. A glyph has the same number, outline
//! and width in both; a page brings the glyphs that its scene and its language say besides (`needed.rs`).

#[cfg(tracefig_page)]
use std::sync::OnceLock;

#[cfg(tracefig_page)]
use super::line::Face;

/// What the packed faces are called: that of words in both weights, and that of formulas.
pub(crate) const NAMES: [&str; 2] = ["words", "formulas"];

/// The packed faces, in the order of their names.
#[cfg(any(tracefig_page, test))]
pub(super) static FILES: [&[u8]; 2] =
    [include_bytes!("fonts/live-words.face"), include_bytes!("fonts/live-formulas.face")];

/// What a page brought of each, behind what was there.
#[cfg(tracefig_page)]
static BROUGHT: [OnceLock<Vec<u8>>; 2] = [OnceLock::new(), OnceLock::new()];

/// Sets also from a piece of a packed face that a page brings, if nothing was set from it so far.
#[cfg(tracefig_page)]
pub(crate) fn bring(place: usize, piece: &[u8]) {
    BROUGHT[place].get_or_init(|| [FILES[place], piece].concat());
}

/// Leaves the faces as they are: they are whole.
#[cfg(not(tracefig_page))]
pub(crate) fn bring(_: usize, _: &[u8]) {}

/// The packed face that has a face, with what a page brought.
#[cfg(tracefig_page)]
pub(super) fn file(face: Face) -> &'static [u8] {
    let place = usize::from(face == Face::Math);
    BROUGHT[place].get().map_or(FILES[place], Vec::as_slice)
}
