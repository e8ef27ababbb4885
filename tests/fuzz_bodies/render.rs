//! What the fuzz target `render` holds of any text.

use tracefig::drawing::Drawing;
use tracefig::figure::{draw, plan};
use tracefig::output::{FORMATS, Options, OutputError, Writer};
use tracefig::scene::{Scene, open_text};

/// Dots of the largest image that is drawn; more would show nothing new and take their time.
const DOTS: f64 = 30_000.0;

/// Whatever is accepted as a figure is drawn in every format, twice the same.
pub(crate) fn holds(text: &str) {
    if let Ok(file) = open_text("fuzz", text) {
        scene_holds(&file.scene);
    }
}

/// A scene that is accepted as a figure is drawn in every format, twice the same.
pub(crate) fn scene_holds(scene: &Scene) {
    let Ok(plan) = plan(scene) else { return };
    let (first, again) = (draw(&plan, plan.theme, "fuzz").drawing, draw(&plan, plan.theme, "fuzz").drawing);
    let scale = (DOTS / (first.width * first.height)).sqrt();
    let options = Options { scale, ..Options::default() };
    for format in FORMATS {
        let bytes = encode(format.write, &first, &options);
        assert!(bytes == encode(format.write, &again, &options), "{} differs from run to run", format.name);
    }
}

fn encode(writer: Writer, drawing: &Drawing, options: &Options) -> Result<Vec<u8>, OutputError> {
    match writer {
        Writer::One(write) => write(drawing, options),
        Writer::Sequence(write) => write(&[drawing, drawing], options),
    }
}
