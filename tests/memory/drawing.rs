//! A PNG is made a band of rows at a time: the image itself is never in memory.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use tracefig::drawing::Drawing;
use tracefig::figure::{draw, plan};
use tracefig::output::{Options, Writer, format};

fn drawing(name: &str) -> Drawing {
    let path = format!("{}/figures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let file = tracefig::scene::open_text(name, &text).unwrap_or_else(|_| unreachable!("a committed scene"));
    let plan = plan(&file.scene).unwrap();
    draw(&plan, plan.theme, name).drawing
}

/// The most that was allocated at one time while the PNG was made, the file included.
fn most_bytes(drawing: &Drawing, scale: f64) -> u64 {
    let Writer::One(write) = format("png").unwrap().write else { unreachable!("PNG takes one drawing") };
    let options = Options { scale, ..Options::default() };
    allocation_counter::measure(|| drop(std::hint::black_box(write(drawing, &options)))).bytes_max
}

#[test]
fn a_png_takes_less_memory_than_half_its_pixels_and_the_larger_the_less() {
    for name in ["07-conservative-bound", "demo-angular-sweep"] {
        let drawing = drawing(name);
        // Outlines of glyphs are built once a process.
        most_bytes(&drawing, 1.0);
        for (scale, part) in [(2.0, 2), (4.0, 5)] {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a positive size")]
            let pixels = (4.0 * drawing.width * scale * drawing.height * scale) as u64;
            let used = most_bytes(&drawing, scale);
            println!("{name} at {scale}: {used} bytes for {pixels} of pixels");
            assert!(used < pixels / part, "{name} at {scale}: {used} of {pixels}");
        }
    }
}
