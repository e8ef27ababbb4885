//! The file that live figures of a book need: the script and the module, once for all pages.
//!
//! mdBook empties the folder of its pages before it writes, and copies what `additional-js` lists from the
//! book's own. So the file lies there, as the book says it, and each build brings it up to date: no page asks
//! for a module other than the one that drew its picture.

use std::path::{Path, PathBuf};

use tracefig::output::live_book_runtime;
use tracefig::scene::visible;

use super::super::Status;
use super::super::atomic_file::{Wait, write_whole};
use super::super::live::{MODULE, RUNTIME};
use super::super::regular::read_regular;

/// Writes the file where a book lists it among its scripts, unless it is there already.
///
/// # Errors
/// With the status, in a sentence: no script of the book has its name, or it can't be written.
pub(crate) fn bring(root: &Path, scripts: &[PathBuf]) -> Result<(), (Status, String)> {
    let Some(listed) = scripts.iter().find(|path| path.ends_with(RUNTIME)) else {
        let told = format!(
            "figures are to be live, and no page would load what they need\n\
             help: below `[output.html]` of book.toml write `additional-js = [\"{RUNTIME}\"]`"
        );
        return Err((Status::Wrong, told));
    };
    let (path, runtime) = (root.join(listed), live_book_runtime(MODULE));
    if read_regular(&path, runtime.len()).is_ok_and(|there| there == runtime.as_bytes()) {
        return Ok(());
    }
    write_whole(&path, runtime.as_bytes(), Wait::No)
        .map_err(|error| (Status::Io, format!("can't write {}: {error}", visible(&path.to_string_lossy()))))
}
