//! Any text, read as a scene: accepted, or refused with problems that lie inside the text. Never a panic.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    if let Err(refused) = tracefig::scene::open_text("fuzz", text) {
        assert!(!refused.problems.is_empty(), "refused without a reason");
        for problem in &refused.problems {
            assert!(problem.span.end <= text.len(), "{problem:?} lies outside of the text");
        }
        let _ = refused.render(tracefig::scene::Ink::Plain);
    }
});
