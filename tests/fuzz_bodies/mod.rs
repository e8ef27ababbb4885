//! What the fuzz targets of `fuzz/` hold of any text; `tests/corpus.rs` holds it of the inputs that fuzzing found.

#![allow(dead_code, reason = "each fuzz target uses one of them")]

use serde_json::Value;
use tracefig::drawing::Drawing;
use tracefig::figure::{draw, plan};
use tracefig::output::{FORMATS, Options, OutputError, Writer};
use tracefig::scene::{Ink, open_text};

/// Dots of the largest image that is drawn; more would show nothing new and take their time.
const DOTS: f64 = 30_000.0;

/// Any text is a scene, or is refused with problems that lie inside the text.
pub(crate) fn scene(text: &str) {
    let Err(refused) = open_text("fuzz", text) else { return };
    assert!(!refused.problems.is_empty(), "refused without a reason");
    for problem in &refused.problems {
        let (start, end) = (problem.span.start, problem.span.end);
        assert!(start <= end && end <= refused.source.text.len(), "{problem:?} lies outside of the text");
    }
    let told = refused.render(Ink::Plain);
    assert!(!told.contains('\u{1b}'), "{told:?} steers the terminal");
}

/// Any line to `solve --jsonl` gets one line of JSON: a result or an error, no `internal` one, with bounds in order.
pub(crate) fn solve(text: &str) {
    let line = text.replace(['\n', '\r'], " ");
    let reply = tracefig::solve_jsonl_line(&line, 1).line;
    assert!(!reply.contains('\n'), "{reply}");
    let json: Value = serde_json::from_str(&reply).unwrap_or_else(|e| panic!("{e}: {reply}"));
    assert!(json.get("result").is_some() != json.get("error").is_some(), "{reply}");
    assert_ne!(json.pointer("/error/code").and_then(Value::as_str), Some("internal"), "{reply}");
    let Some(result) = json.get("result").and_then(Value::as_object) else { return };
    for (name, bounds) in result.iter().filter(|(name, _)| name.ends_with("_bounds")) {
        let ends: Vec<f64> = bounds.as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
        assert!(matches!(ends[..], [low, high] if low <= high), "{name}: {reply}");
        let value = result.get(name.trim_end_matches("_bounds")).and_then(Value::as_f64);
        assert!(value.is_none_or(|v| ends[0] <= v && v <= ends[1]), "{name}: {reply}");
    }
}

/// Whatever is accepted as a figure is drawn in every format, twice the same.
pub(crate) fn render(text: &str) {
    let Ok(file) = open_text("fuzz", text) else { return };
    let Ok(plan) = plan(&file.scene) else { return };
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
