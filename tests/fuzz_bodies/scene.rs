//! What the fuzz target `scene` holds of any text.

use tracefig::scene::{Ink, open_text};

/// Any text is a scene, or is refused with problems that lie inside the text.
pub(crate) fn holds(text: &str) {
    let Err(refused) = open_text("fuzz", text) else { return };
    assert!(!refused.problems.is_empty(), "refused without a reason");
    for problem in &refused.problems {
        let (start, end) = (problem.span.start, problem.span.end);
        assert!(start <= end && end <= refused.source.text.len(), "{problem:?} lies outside of the text");
    }
    let told = refused.render(Ink::Plain);
    assert!(!told.contains('\u{1b}'), "{told:?} steers the terminal");
}
