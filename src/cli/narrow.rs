//! The figure that a page in steps shows on a phone: its panels one above the other.

use tracefig::drawing::Drawing;
use tracefig::figure::draw_in_steps;
use tracefig::figure::theme::Theme;
use tracefig::scene::Scene;

use super::in_motion::planned;
use super::in_time::InTime;
use super::jobs::Planned;

/// Its width, page pixels: that of a small phone, on which letters are a little smaller then.
const WIDTH: f64 = 360.0;

/// A figure once more, for a narrow page; none where no page in steps is written, where the figure is as
/// narrow itself, and where no such picture can be made.
pub(crate) fn narrow(
    (scene, theme): (&Scene, &Theme),
    (drawing, in_time): (&Drawing, Option<InTime>),
    files: &[Planned],
) -> Option<Box<Drawing>> {
    let is_page = |planned: &Planned| planned.format.has_narrow_pages();
    let in_steps = in_time.filter(|in_time| matches!(in_time, InTime::Steps(_)))?;
    if drawing.width <= WIDTH
        || !files.iter().any(|planned| is_page(planned) && !in_steps.are_apart(planned.format))
    {
        return None;
    }
    let mut scene = scene.clone();
    (scene.canvas.width, scene.canvas.height, scene.canvas.columns) = (Some(WIDTH), None, None);
    let plan = planned(&scene, Some(theme), in_time).ok()?;
    let narrow = draw_in_steps(&plan, theme, &format!("{}-narrow", drawing.id)).drawing;
    (narrow.steps.len() == drawing.steps.len()).then(|| Box::new(narrow))
}
