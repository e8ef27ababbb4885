//! A live figure that lets something be dragged that it does not draw.

use crate::scene::{Drag, Grip, Scene, Spanned};

use super::draw::Figure;
use super::fault::{Fault, Problem};

/// A note on each thing that a scene lets be dragged of a body of which the layers draw nothing that can be:
/// where something of it is held, the rest may be meant for the numbers beside the picture.
///
/// ```
/// use tracefig::{figure::{draw, not_held, plan}, scene::{Source, read}};
/// let text = r#"
/// shapes.A = { kind = "box", half_extents = [1, 0.4], velocity = [1, 0.5] }
/// query = { kind = "bounds", of = ["A"] }
/// "#;
/// let notes = |drag: &str| {
///     let scene = read(&Source::new("s.toml", &format!("{text}\nlive.drag = {drag}"))).unwrap();
///     let plan = plan(&scene).unwrap();
///     not_held(&scene, &draw(&plan, plan.theme, "f"))
/// };
/// assert!(notes(r#"["A", "A.velocity"]"#).is_empty());
/// assert!(notes(r#"["A.velocity"]"#)[0].fault.to_string().contains("`A.velocity`"));
/// ```
#[must_use]
pub fn not_held(scene: &Scene, figure: &Figure) -> Vec<Problem> {
    let is_held = |drag: &Drag| figure.handles.iter().any(|handle| handle.body == drag.body);
    let lacking = scene.live.drag.iter().flatten().filter(|drag| !is_held(&drag.value));
    lacking.filter_map(|drag| noted(scene, drag)).collect()
}

/// The note on one.
fn noted(scene: &Scene, Spanned { value, span }: &Spanned<Drag>) -> Option<Problem> {
    let name = &scene.shapes.get(value.body)?.0.value;
    let what = match value.grip {
        Grip::Position => name.clone(),
        grip => format!("{name}.{}", grip.word()),
    };
    Some(Problem::new(Fault::NotHeld { what }, span.clone()))
}
