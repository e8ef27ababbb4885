//! `tracefig` as a plugin of Typst: pure functions from bytes to bytes, so that Typst may keep what they gave.

use tracefig::SceneFile;
use tracefig::figure::{Figure, draw, plan_in, theme};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Refused, open_text};
use wasm_minimal_protocol::{initiate_protocol, wasm_func};

initiate_protocol!();

/// A text from Typst.
fn text(bytes: &[u8]) -> Result<&str, String> {
    std::str::from_utf8(bytes).map_err(|error| error.to_string())
}

/// The figure of a scene in a theme; the error quotes the scene.
fn drawn(file: &SceneFile, theme: &str) -> Result<Figure, String> {
    let asked = file.scene.canvas.theme.as_ref().map(|theme| theme.value.as_str());
    let name = if theme.is_empty() { asked.unwrap_or(theme::THEMES[0].name) } else { theme };
    let known = || theme::THEMES.iter().map(|theme| theme.name).collect::<Vec<_>>().join(", ");
    let theme =
        theme::find(name).ok_or_else(|| format!("unknown theme {name:?}: expected one of {}", known()))?;
    let plan = plan_in(&file.scene, theme)
        .map_err(|problems| Refused { source: file.source.clone(), problems }.to_string())?;
    Ok(draw(&plan, plan.theme, "figure"))
}

/// A scene and a theme, or no theme for the scene's own, to JSON: `svg`, `alt`, and the page's `width`.
#[wasm_func]
pub fn render(scene: &[u8], theme: &[u8]) -> Result<Vec<u8>, String> {
    let file = open_text("scene", text(scene)?).map_err(|refused| refused.to_string())?;
    let drawing = drawn(&file, text(theme)?)?.drawing;
    let Some(Writer::One(write)) = format("svg").map(|format| format.write) else {
        return Err("no SVG in this build".to_owned());
    };
    let svg = write(&drawing, &Options::default()).map_err(|error| error.to_string())?;
    let svg = String::from_utf8(svg).map_err(|error| error.to_string())?;
    Ok(serde_json::json!({"svg": svg, "alt": drawing.title, "width": drawing.width}).to_string().into_bytes())
}

/// The answer to a scene, as JSON.
#[wasm_func]
pub fn solve(scene: &[u8]) -> Result<Vec<u8>, String> {
    let file = open_text("scene", text(scene)?).map_err(|refused| refused.to_string())?;
    Ok(tracefig::scene::Solution::of(&file.scene).json().to_string().into_bytes())
}
