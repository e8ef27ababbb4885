//! Any scene, all the way to bytes: whatever is accepted is drawn, twice the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use tracefig::figure::{draw, plan};
use tracefig::output::{FORMATS, Options, Writer};

fuzz_target!(|text: &str| {
    let Ok(file) = tracefig::scene::open_text("fuzz", text) else { return };
    let Ok(plan) = plan(&file.scene) else { return };
    let first = draw(&plan, plan.theme, "fuzz").drawing;
    let options = Options { scale: 0.25, ..Options::default() };
    for format in FORMATS {
        if let Writer::One(write) = format.write {
            let again = draw(&plan, plan.theme, "fuzz").drawing;
            assert!(write(&first, &options) == write(&again, &options), "{} differs from run to run", format.name);
        }
    }
});
