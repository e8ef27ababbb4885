//! What the pages of a book share whose figures are live.
//!
//! A book has a layout, a theme and keys of its own: its figures become live as they come near the window,
//! bring the look of their controls, and keep the keys that turn pages for themselves while they are held.

use super::base64::base64;
use super::live_page::STYLE;

/// The script of live figures in a book, as one.
const SCRIPT: &str = concat!(
    "const WORDS = ",
    include_str!("../../live/words.json"),
    include_str!("../../live/values.js"),
    include_str!("../../live/picture.js"),
    include_str!("../../live/edited.js"),
    include_str!("../../live/live.js"),
    include_str!("../../live/controls.js"),
    include_str!("../../live/book.js"),
);
/// How live figures stand in the pages of a book.
const BOOK: &str = include_str!("../../live/book.css");

/// The file that the pages of a book share: the script with the module, which is packed by gzip, and the look
/// of the controls.
///
/// ```
/// let runtime = tracefig::output::live_book_runtime(b"module");
/// assert!(runtime.contains("globalThis.tracefigModule=\"bW9kdWxl\";"));
/// assert!(runtime.contains("const LOOK = \".tracefig-live{"));
/// ```
#[must_use]
pub fn live_book_runtime(module: &[u8]) -> String {
    let look = serde_json::Value::from([STYLE, BOOK].concat());
    let module = base64(module);
    format!("\"use strict\";{{\nglobalThis.tracefigModule=\"{module}\";\nconst LOOK = {look};\n{SCRIPT}}}\n")
}
