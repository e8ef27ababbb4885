//! The bare program: it replays our own display lists through tiny-skia, and writes the `png` crate's fastest
//! PNG and our SVG. It is the 1.0 that `tracefig render` is measured against.
//!
//! `bare SCENE…` makes the display lists before its clock starts, replays them, and prints the time of the
//! fastest replay of each stage. `bare --once DIR SCENE…` draws each once, writes the files into a folder,
//! and prints the processor time of that alone in milliseconds: what a program would need that knows nothing
//! else. `bare --dump SCENE…` prints the display lists as JSON, for the plotters of `bench/peers`.

mod canvas;
mod dump;

use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use tracefig::drawing::Drawing;
use tracefig::output::{Options, Writer, format};

/// Image pixels for a page pixel.
const SCALE: f64 = 2.0;
/// Replays; the fastest counts.
const REPLAYS: usize = 15;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["--dump", ref scenes @ ..] => drawings(scenes).map(|all| println!("{}", dump::json(&all))),
        ["--once", folder, ref scenes @ ..] => drawings(scenes).and_then(|all| once(Path::new(folder), &all)),
        ref scenes => drawings(scenes).map(|all| replay_all(&all)),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The display list of each scene, and its name.
fn drawings(scenes: &[&str]) -> Result<Vec<(String, Drawing)>, String> {
    scenes.iter().map(|path| drawing(path)).collect()
}

fn drawing(path: &str) -> Result<(String, Drawing), String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let file = tracefig::scene::open_text(path, &text).map_err(|_| format!("{path} is no scene"))?;
    let plan = tracefig::figure::plan(&file.scene).map_err(|_| format!("{path} can't be drawn"))?;
    let name = Path::new(path).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Ok((name, tracefig::figure::draw(&plan, plan.theme, "bare").drawing))
}

/// Draws and writes each figure once and prints the processor time in milliseconds.
fn once(folder: &Path, drawings: &[(String, Drawing)]) -> Result<(), String> {
    let before = processor_time()?;
    for (name, drawing) in drawings {
        let png = canvas::rasterize(drawing).as_ref().and_then(canvas::encode).ok_or("no image")?;
        let svg = ours(drawing, "svg").ok_or("no SVG")?;
        for (extension, bytes) in [("png", png), ("svg", svg)] {
            let path = folder.join(format!("{name}.{extension}"));
            std::fs::write(&path, bytes).map_err(|error| format!("{}: {error}", path.display()))?;
        }
    }
    println!("{:.3}", (processor_time()? - before).as_secs_f64() * 1e3);
    Ok(())
}

/// What this thread, the only one, has used so far; Linux counts it in nanoseconds.
fn processor_time() -> Result<Duration, String> {
    let path = "/proc/thread-self/schedstat";
    let text = std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let nanoseconds = text.split(' ').next().and_then(|word| word.parse().ok());
    nanoseconds.map(Duration::from_nanos).ok_or_else(|| format!("{path} is not as expected"))
}

fn replay_all(drawings: &[(String, Drawing)]) {
    let mut totals = [Duration::ZERO; 5];
    for (_, drawing) in drawings {
        let mut best = [Duration::MAX; 5];
        for _ in 0..REPLAYS {
            for (best, spent) in best.iter_mut().zip(replay(drawing)) {
                *best = (*best).min(spent);
            }
        }
        totals.iter_mut().zip(best).for_each(|(total, best)| *total += best);
    }
    let names =
        ["tiny-skia", "png crate, fastest", "our SVG", "our rasterizer and PNG", "our rasterizer alone"];
    for (name, total) in names.iter().zip(totals) {
        println!("{name}: {:.2} ms for {} figures", total.as_secs_f64() * 1e3, drawings.len());
    }
}

fn replay(drawing: &Drawing) -> [Duration; 5] {
    let mut clock = Instant::now();
    let mut lap = || std::mem::replace(&mut clock, Instant::now()).elapsed();
    let pixmap = canvas::rasterize(drawing);
    let raster = lap();
    let bytes = pixmap.as_ref().map(canvas::encode);
    let encoding = lap();
    let svg = ours(drawing, "svg");
    let svg_time = lap();
    let png = ours(drawing, "png");
    let png_time = lap();
    let pixels = tracefig::output::rasterize(drawing, SCALE).ok();
    let pixels_time = lap();
    std::hint::black_box((bytes, svg, png, pixels));
    [raster, encoding, svg_time, png_time, pixels_time]
}

/// One of our own formats.
fn ours(drawing: &Drawing, name: &str) -> Option<Vec<u8>> {
    match format(name).map(|f| f.write) {
        Some(Writer::One(write)) => write(drawing, &Options::default()).ok(),
        _ => None,
    }
}
