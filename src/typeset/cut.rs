//! The faces of live pages: cut to what most figures set, as they are most of what would be loaded.
//!
//! The module of live pages embeds these in the place of the whole ones; `fonts/cut_live.py` makes them, and
//! a glyph has the same number, outline and place in both. A page whose figure sets a glyph that they lack
//! brings the whole face along (`whole.rs`).

#[cfg(tracefig_page)]
use std::sync::OnceLock;

use super::line::Face;

/// The files of the cut faces, in the order of [`Face`].
static FILES: [&[u8]; 3] = [
    include_bytes!("fonts/live-sans-regular.ttf"),
    include_bytes!("fonts/live-sans-semibold.ttf"),
    include_bytes!("fonts/live-math.otf"),
];

/// The file of a cut face.
pub(super) fn file(face: Face) -> &'static [u8] {
    FILES[face as usize]
}

/// What a page brought, in the order of [`Face`].
#[cfg(tracefig_page)]
static BROUGHT: [OnceLock<Vec<u8>>; 3] = [OnceLock::new(), OnceLock::new(), OnceLock::new()];

/// Sets from a face that a page brings, if nothing was set from it so far.
#[cfg(tracefig_page)]
pub(crate) fn bring(face: Face, file: Vec<u8>) {
    BROUGHT[face as usize].get_or_init(|| file);
}

/// Leaves the faces as they are: they are whole.
#[cfg(not(tracefig_page))]
pub(crate) fn bring(_: Face, _: Vec<u8>) {}

/// The face that a page brought.
#[cfg(tracefig_page)]
pub(super) fn brought(face: Face) -> Option<&'static [u8]> {
    BROUGHT[face as usize].get().map(Vec::as_slice)
}
