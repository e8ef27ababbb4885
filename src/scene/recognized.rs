//! Whether a file that lies in a folder is a scene at all: others have the same endings.

use super::fields::ROOT;
use super::source::Source;

/// Whether a text is a scene, right or wrong: it has one of the tables that a scene must have. A text that
/// can't be parsed is one where the words for all of them are in it.
///
/// ```
/// use tracefig::scene::is_scene;
/// assert!(is_scene("[shapes.A]\nkind = 'circel'") && is_scene("{\"shapes\": {}, \"query\": "));
/// assert!(!is_scene("[package]\nname = 'x'") && !is_scene("{ // a comment\n}") && !is_scene(""));
/// ```
#[must_use]
pub fn is_scene(text: &str) -> bool {
    let mut tables = ROOT.fields.iter().filter(|row| row.required);
    match Source::new("", text.strip_prefix('\u{feff}').unwrap_or(text)).tree() {
        Ok(root) => tables.any(|row| root.get(row.name).is_some()),
        Err(_) => tables.all(|row| text.contains(row.name)),
    }
}
